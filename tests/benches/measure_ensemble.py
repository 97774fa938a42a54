"""One measurement of an ensemble in a fresh process: `python measure_ensemble.py REQUEST`, a JSON object; prints the samples as one JSON line.

The time is the process's own on one core, so that other work on the machine does not count. Before it, the runs without noise and one
ensemble with noise are written for the comparison.
"""

import ctypes
import importlib
import json
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

from measure import BATCH, POINTER, Step
from workload import Workload, workload

SECONDS = 1.0
# start, runs, steps, seed, scale, finals
Ensemble = Callable[[np.ndarray, int, int, int, float, np.ndarray], object]


class Layout(ctypes.Structure):
    """As in ensemble.c."""

    _fields_ = [(name, ctypes.c_size_t) for name in "inputs results states carried noise channels".split()] + [
        (name, ctypes.c_double) for name in ("dt", "scale")
    ]


def address(array: np.ndarray) -> ctypes.c_void_p:
    """Of the first entry."""
    return POINTER(array.ctypes.data)


def by_step(work: Workload, path: str, harness: str) -> Ensemble:
    """The loops of ensemble.c around a step."""
    loops = ctypes.CDLL(harness)

    def ensemble(start: np.ndarray, runs: int, steps: int, seed: int, scale: float, finals: np.ndarray) -> None:
        step = Step(path, start[None, :], len(work.results))
        begin = step.given.copy()
        noise, (channels, _) = work.inputs["dw"]
        sizes = (work.size, len(work.results), work.inputs["x"][1][0], work.outputs["u_sat"][0], noise, channels)
        layout = Layout(*sizes, work.dt, scale)
        carry, unpack = (step.code.carry, step.code.unpack) if step.packs else (None, None)
        loops.ensemble(
            step.function, carry, ctypes.byref(layout), address(begin), address(step.given), ctypes.c_size_t(step.size), address(step.out),
            unpack, ctypes.c_size_t(runs), ctypes.c_size_t(steps), ctypes.c_uint64(seed), address(finals),
        )  # fmt: skip

    return ensemble


def by_nsv(path: str, lanes: int) -> Ensemble:
    """The emitted code in the runtime's lanes."""
    code = ctypes.CDLL(path)
    code.ensemble.restype = ctypes.c_bool

    def ensemble(start: np.ndarray, runs: int, steps: int, seed: int, scale: float, finals: np.ndarray) -> None:
        sizes = (ctypes.c_uint64(seed), ctypes.c_size_t(runs), ctypes.c_uint64(steps), ctypes.c_double(scale), ctypes.c_size_t(lanes))
        assert code.ensemble(*sizes, address(finals)), f"the processor has no {lanes} lanes"

    return ensemble


def by_lanes(path: str) -> Ensemble:
    """The list of operations in eight lanes of C."""
    code = ctypes.CDLL(path)

    def ensemble(start: np.ndarray, runs: int, steps: int, seed: int, scale: float, finals: np.ndarray) -> None:
        sizes = (ctypes.c_size_t(runs), ctypes.c_size_t(steps), ctypes.c_uint64(seed), ctypes.c_double(scale))
        code.ensemble(address(start), *sizes, address(finals))

    return ensemble


def by_numba(path: str) -> Ensemble:
    """Loops compiled by numba."""
    sys.path.insert(0, str(Path(path).parent))
    return importlib.import_module(f"{Path(path).stem}_ensemble").ensemble


def by_heyoka(work: Workload) -> Ensemble:
    """Batches in a loop of Python."""
    from peers import heyoka

    function = heyoka.compiled(work)
    return lambda *arguments: heyoka.ensemble(work, function, *arguments, BATCH)


def by_jax(work: Workload) -> Ensemble:
    """vmap and scan."""
    from peers import jax

    simulate = {}

    def ensemble(start: np.ndarray, runs: int, steps: int, seed: int, scale: float, finals: np.ndarray) -> None:
        if (runs, steps) not in simulate:
            simulate[runs, steps] = jax.ensemble(work, runs, steps)
        finals[:] = simulate[runs, steps](start, seed, scale)

    return ensemble


def made(request: dict) -> Ensemble:
    """The ensemble of a request."""
    kind, path = request["kind"], request["path"]
    if kind.startswith("nsv"):
        return by_nsv(path, int(kind.split()[1]))
    if kind == "lanes":
        return by_lanes(path)
    if kind == "module":
        return by_numba(path)
    work = workload(request["spec"], Path(request["programs"]).read_text())
    if kind == "library":
        return by_step(work, path, request["harness"])
    return by_heyoka(work) if kind == "heyoka" else by_jax(work)


def main() -> None:
    """Measures what the request names."""
    request = json.loads(sys.argv[1])
    ensemble, start = made(request), np.load(request["start"])
    runs, steps, scale, states = (request[name] for name in ("runs", "steps", "scale", "states"))
    quiet, noisy = np.zeros((runs, states)), np.zeros((runs, states))
    ensemble(start, runs, steps, 1, 0.0, quiet)
    ensemble(start, runs, steps, 2, scale, noisy)
    np.savez(request["values"], quiet=quiet, noisy=noisy)
    rates: list[float] = []
    begin = time.process_time()
    while time.process_time() - begin < SECONDS or len(rates) < 3:
        before = time.process_time()
        ensemble(start, runs, steps, 3 + len(rates), scale, noisy)
        rates.append(runs * steps / (time.process_time() - before))
    print(json.dumps({"rate": [round(rate) for rate in rates]}))


if __name__ == "__main__":
    main()
