"""One measurement of a step in a fresh process: `python measure.py REQUEST`, a JSON object; prints the samples as one JSON line.

Whatever has machine code to call is timed by the loop of measure.c. heyoka and JAX are called from Python, by loops of their own. The
results of all inputs are written for the comparison.
"""

import atexit
import ctypes
import importlib
import json
import os
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

import numpy as np

from workload import Workload, workload

CALLS, PARTS, BATCHES, COLD = 80, 5, 60, 61
POINTER = ctypes.c_void_p
BATCH = 264


def aligned(size: int) -> np.ndarray:
    """Bytes that start a cache line."""
    block = np.zeros(size + 64, dtype=np.uint8)
    start = -block.ctypes.data % 64
    return block[start : start + size]


def copied(path: str) -> str:
    """A copy of a library, which stands in memory of its own: from some pages the cold call of a small function takes more than twice as long."""
    with tempfile.NamedTemporaryFile(suffix=".so", delete=False) as copy:
        copy.write(Path(path).read_bytes())
    atexit.register(os.unlink, copy.name)
    return copy.name


class Inputs(ctypes.Structure):
    """As in measure.c."""

    _fields_ = [("given", POINTER), ("first", POINTER), ("size", ctypes.c_size_t), ("count", ctypes.c_int)]


class Step:
    """Machine code `step(in, out)` on the flat arrays, or on its own packing of them; it may change what it is given."""

    def __init__(self, path: str, inputs: np.ndarray, results: int) -> None:
        self.inputs, self.results, self.packs = inputs, results, False
        if path.endswith(".py"):
            sys.path.insert(0, str(Path(path).parent))
            self.function = POINTER(importlib.import_module(Path(path).stem).step.address)
        else:
            self.code = ctypes.CDLL(copied(path))
            self.function = ctypes.cast(self.code.step, POINTER)
            self.packs = hasattr(self.code, "pack")
        self.call = ctypes.CFUNCTYPE(None, POINTER, POINTER)(self.function.value)
        self.size = self.code.in_size() if self.packs else 64 * -(-inputs.shape[1] // 8)
        self.given, self.first = (aligned(self.size * len(inputs)) for _ in range(2))
        self.out = aligned(self.code.out_size() if self.packs else 8 * results)
        for k, row in enumerate(inputs):
            if self.packs:
                self.code.pack(POINTER(row.ctypes.data), POINTER(self.first.ctypes.data + k * self.size))
            else:
                ctypes.memmove(self.first.ctypes.data + k * self.size, row.ctypes.data, row.nbytes)
        self.given[:] = self.first

    def read(self, given: int, to: np.ndarray) -> None:
        """The results of a call, from what it was given, where it has advanced that, and from its output."""
        if self.packs:
            self.code.unpack(POINTER(given), POINTER(self.out.ctypes.data), POINTER(to.ctypes.data))
        else:
            ctypes.memmove(to.ctypes.data, self.out.ctypes.data, to.nbytes)

    def values(self) -> np.ndarray:
        """The results of one call with each input."""
        found = np.zeros((len(self.inputs), self.results))
        self.given[:] = self.first
        for k, row in enumerate(found):
            given = self.given.ctypes.data + k * self.size
            self.call(given, self.out.ctypes.data)
            self.read(given, row)
        return found

    def finite(self) -> bool:
        """Whether what the calls have left is finite, so that no call was slow or fast by its numbers."""
        row = np.zeros(self.results)
        left = []
        for k in range(len(self.inputs)):
            self.read(self.given.ctypes.data + k * self.size, row)
            left.append(bool(np.isfinite(row).all()))
        return all(left)


def measure_code(loop: ctypes.CDLL, step: Step) -> dict[str, np.ndarray]:
    """Ticks per call: of each warm batch, and of each cold call."""
    given, first, out = (POINTER(array.ctypes.data) for array in (step.given, step.first, step.out))
    inputs = Inputs(given, first, step.size, len(step.inputs))
    warm, cold = np.zeros(BATCHES), np.zeros(COLD)
    loop.measure_warm(step.function, ctypes.byref(inputs), out, CALLS, PARTS, BATCHES, POINTER(warm.ctypes.data))
    assert step.finite(), "the states stay finite between two restorations"
    loop.measure_cold(step.function, ctypes.byref(inputs), out, COLD, POINTER(cold.ctypes.data))
    return {"warm": warm, "cold": cold}


def measure_python(loop: ctypes.CDLL, call: Callable[[], object], steps: int, calls: int) -> dict[str, np.ndarray]:
    """Ticks per step of each call that does some steps."""
    warm = []
    for _ in range(calls + 3):
        start = loop.ticks()
        call()
        warm.append((loop.ticks() - start) / steps)
    return {"warm": np.array(warm[3:])}


def measure_heyoka(loop: ctypes.CDLL, work: Workload, inputs: np.ndarray) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """Results and ticks of a compiled function on a batch of inputs."""
    from peers import heyoka

    function = heyoka.compiled(work)
    given = np.ascontiguousarray(np.resize(inputs, (BATCH, inputs.shape[1])).T)
    out = np.zeros((len(work.results), BATCH))
    times = measure_python(loop, lambda: function(given, outputs=out), BATCH, BATCHES)
    return np.ascontiguousarray(out[:, : len(inputs)].T), times


def measure_jax(loop: ctypes.CDLL, work: Workload, inputs: np.ndarray) -> tuple[np.ndarray, dict[str, np.ndarray]]:
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
    print(json.dumps({name: (ticks * ratio).round(1).tolist() for name, ticks in times.items()}))


if __name__ == "__main__":
    main()
