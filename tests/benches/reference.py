"""The reference: the law in Python, evaluated on states of a real closed loop, which are the inputs of every measurement."""

import ctypes
import math
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from graph import BINARY, UNARY, Graph
from scalarise import scalarise
from workload import Workload

INFIX = {
    "add": "+", "sub": "-", "mul": "*", "div": "/", "lt": "<", "le": "<=", "gt": ">", "ge": ">=", "eq": "==", "ne": "!=",
    "and": "and", "or": "or",
}  # fmt: skip


def python_source(
    graph: Graph, results: list[int], select: str = "({a} if {c} else {b})", quotient: str = "{a} / {b}"
) -> list[str]:
    """Straight-line statements in Python from `x[i]` to `y[i]`."""
    name, lines = {}, []
    for node in graph.live(results):
        op, *operands = graph.entries[node]
        if op == "const":
            name[node] = f"({operands[0]!r})"
            continue
        name[node] = f"v{node}"
        a, b, c = [*(name[o] for o in operands if op != "input"), "", "", ""][:3]
        if op == "input":
            text = f"x[{operands[0]}]"
        elif op == "div":
            text = quotient.format(a=a, b=b)
        elif op in INFIX:
            text = f"{a} {INFIX[op]} {b}"
        elif op == "select":
            text = select.format(c=a, a=b, b=c)
        else:
            text = {"neg": f"-{a}", "not": f"not {a}", "ln": f"log({a})"}.get(op) or f"{op}({', '.join([a, b][: len(operands)])})"
        lines.append(f"v{node} = {text}")
    return lines + [f"y[{i}] = {name[node]}" for i, node in enumerate(results)]


def law(work: Workload):
    """The step as a Python function of the flat input."""
    lines = python_source(work.graph, work.results, quotient="quotient({a}, {b})")
    text = f"def law(x):\n y = [0.0] * {len(work.results)}\n " + "\n ".join(lines) + "\n return y\n"
    names = {name: getattr(math, name) for name in dir(math)} | {"abs": abs, "sign": UNARY["sign"], "quotient": BINARY["div"]}
    names |= {name: BINARY[name] for name in ("min", "max")}
    exec(text, names)
    return names["law"]


def start(work: Workload, library: Path) -> np.ndarray:
    """The flat input at time 0: nominal values of the emitted code, controller states by the program `initial`."""
    flat = np.zeros(work.size)
    ctypes.CDLL(str(library)).nominal(ctypes.c_void_p(flat.ctypes.data))
    graph, x = Graph(), flat[work.slice("x")]
    width = work.initial.inputs["x1"][0]
    given = {}
    for name in work.initial.inputs:
        if name in work.inputs:
            values = flat[work.slice(name)]
        else:
            at = (int(name[1:]) - 1) * width
            values = x[at : at + width]
        given[name] = [graph.const(value) for value in values]
    for name, values in scalarise(work.initial, graph, given).items():
        flat[work.slice(f"state.{name}")] = [graph.value(value) for value in values]
    return flat


def noise_scale(work: Workload) -> float:
    """Deviation of the plant's increments: a draw that is held, or a Wiener process."""
    return work.dt if work.sampled_noise else math.sqrt(work.dt)


def samples(work: Workload, flat: np.ndarray, steps: int, scale: float, seed: int) -> Iterator[tuple[np.ndarray, list[float]]]:
    """Inputs and results of the samples of a closed loop."""
    step, draw, flat = law(work), np.random.default_rng(seed), flat.copy()
    first, carried, (channels, _) = work.inputs["x"][0], work.outputs["u_sat"][0], work.inputs["dw"][1]
    for k in range(steps):
        flat[0] = k * work.dt
        flat[work.slice("dw")] = scale * draw.standard_normal(channels)
        results = step(flat.tolist())
        yield flat, results
        flat[first : first + carried] = results[:carried]


def simulate(work: Workload, flat: np.ndarray, steps: int) -> list[float]:
    """The plant's state after steps without noise."""
    *_, (_, results) = samples(work, flat, steps, 0.0, 0)
    return results[: work.inputs["x"][1][0]]


def record(work: Workload, library: Path, count: int, steps: int = 4000, seed: int = 1) -> tuple[np.ndarray, np.ndarray]:
    """Inputs and results at `count` samples spread over a closed loop with noise."""
    chosen = set(np.linspace(steps // 20, steps - 1, count).astype(int).tolist())
    loop = samples(work, start(work, library), steps, noise_scale(work), seed)
    kept = [(flat.copy(), results) for k, (flat, results) in enumerate(loop) if k in chosen]
    inputs, results = (np.array(part) for part in zip(*kept, strict=True))
    assert np.isfinite(results).all(), "the closed loop stays finite"
    return inputs, results
