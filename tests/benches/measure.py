"""One measurement of a step in a fresh process: `python measure.py REQUEST`, a JSON object; prints one JSON line.

Whatever has machine code to call is timed by the loop of measure.c. heyoka and JAX are called from Python, by loops of their own. The
results of all inputs are written for the comparison.
"""

import ctypes
import importlib
import json
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np

from workload import Workload, workload

CALLS, BATCHES, COLD = 400, 60, 61
POINTER = ctypes.c_void_p
BATCH = 264


def aligned(size: int) -> np.ndarray:
    """Bytes that start a cache line."""
    block = np.zeros(size + 64, dtype=np.uint8)
    start = -block.ctypes.data % 64
    return block[start : start + size]


class Step:
    """Machine code `step(in, out)` on the flat arrays, or on its own packing of them."""

    def __init__(self, path: str, inputs: np.ndarray, results: int) -> None:
        self.inputs, self.results, self.packs = inputs, results, False
        if path.endswith(".py"):
            sys.path.insert(0, str(Path(path).parent))
            self.function = POINTER(importlib.import_module(Path(path).stem).step.address)
        else:
            self.code = ctypes.CDLL(path)
            self.function = ctypes.cast(self.code.step, POINTER)
            self.packs = hasattr(self.code, "pack")
        self.call = ctypes.CFUNCTYPE(None, POINTER, POINTER)(self.function.value)
        self.size = self.code.in_size() if self.packs else 64 * -(-inputs.shape[1] // 8)
        self.given = aligned(self.size * len(inputs))
        self.out = aligned(self.code.out_size() if self.packs else 8 * results)
        for k, row in enumerate(inputs):
            if self.packs:
                self.code.pack(POINTER(row.ctypes.data), POINTER(self.given.ctypes.data + k * self.size))
            else:
                ctypes.memmove(self.given.ctypes.data + k * self.size, row.ctypes.data, row.nbytes)

    def values(self) -> np.ndarray:
        """The results of each input."""
        found = np.zeros((len(self.inputs), self.results))
        for k, row in enumerate(found):
            self.call(self.given.ctypes.data + k * self.size, self.out.ctypes.data)
            if self.packs:
                self.code.unpack(POINTER(self.out.ctypes.data), POINTER(row.ctypes.data))
            else:
                ctypes.memmove(row.ctypes.data, self.out.ctypes.data, row.nbytes)
        return found


def measure_code(loop: ctypes.CDLL, step: Step) -> dict[str, float]:
    """Ticks of warm and cold calls."""
    given, out = (POINTER(array.ctypes.data) for array in (step.given, step.out))
    arguments = [step.function, given, ctypes.c_size_t(step.size), len(step.inputs), out]
    warm, cold = np.zeros(BATCHES), np.zeros(COLD)
    loop.measure_warm(*arguments, CALLS, BATCHES, POINTER(warm.ctypes.data))
    loop.measure_cold(*arguments, COLD, POINTER(cold.ctypes.data))
    return {"warm": float(np.median(warm)), "least": float(warm.min()), "cold": float(np.median(cold))}


def measure_python(loop: ctypes.CDLL, call: Callable[[], object], steps: int, calls: int) -> dict[str, float]:
    """Ticks per step of a call that does some steps."""
    warm = []
    for _ in range(calls + 3):
        start = loop.ticks()
        call()
        warm.append((loop.ticks() - start) / steps)
    return {"warm": float(np.median(warm[3:])), "least": min(warm[3:])}


def measure_heyoka(loop: ctypes.CDLL, work: Workload, inputs: np.ndarray) -> tuple[np.ndarray, dict[str, float]]:
    """Results and ticks of a compiled function on a batch of inputs."""
    from peers import heyoka

    function = heyoka.compiled(work)
    given = np.ascontiguousarray(np.resize(inputs, (BATCH, inputs.shape[1])).T)
    out = np.zeros((len(work.results), BATCH))
    times = measure_python(loop, lambda: function(given, outputs=out), BATCH, BATCHES)
    return np.ascontiguousarray(out[:, : len(inputs)].T), times


def measure_jax(loop: ctypes.CDLL, work: Workload, inputs: np.ndarray) -> tuple[np.ndarray, dict[str, float]]:
    """Results and ticks of a function compiled by jit."""
    from peers import jax as peer

    law = peer.law(work)
    import jax

    function = jax.jit(law)
    given = [jax.numpy.array(row) for row in inputs]
    values = np.array([function(row) for row in given])
    times = measure_python(loop, lambda: [function(row).block_until_ready() for row in given], len(given), BATCHES)
    return values, times


def main() -> None:
    """Measures what the request names."""
    request = json.loads(sys.argv[1])
    inputs = np.load(request["inputs"])
    loop = ctypes.CDLL(request["loop"])
    loop.cycles_per_tick.restype = ctypes.c_double
    loop.ticks.restype = ctypes.c_uint64
    before = loop.cycles_per_tick()
    if request["kind"] in ("heyoka", "jax"):
        work = workload(request["spec"], Path(request["programs"]).read_text())
        measure = measure_heyoka if request["kind"] == "heyoka" else measure_jax
        values, times = measure(loop, work, inputs)
    else:
        step = Step(request["path"], inputs, request["results"])
        values = step.values()
        times = measure_code(loop, step)
    np.save(request["values"], values)
    ratio = max(before, loop.cycles_per_tick())
    print(json.dumps({name: ticks * ratio for name, ticks in times.items()} | {"cycles_per_tick": ratio}))


if __name__ == "__main__":
    main()
