"""numba: the law as straight-line Python, compiled with and without fastmath: to a C callback, and with the loops of an ensemble around
it. The code is cached between processes. Divisions are numpy's: one by zero is no error, since the law chooses another value there."""

from importlib.util import find_spec
from pathlib import Path

from build import Built, Missing, write
from reference import python_source
from workload import Workload

MODULE = """from math import *
from numba import cfunc, types

pointer = types.CPointer(types.float64)


@cfunc(types.void(pointer, pointer), cache=True, fastmath={fastmath}, error_model="numpy")
def step(x, y):
    {body}
"""

ENSEMBLE = """from math import *
import numpy as np
from numba import njit


@njit(cache=True, fastmath={fastmath}, error_model="numpy", inline="never")
def step(x, y):
    {body}


@njit(cache=True, fastmath={fastmath}, error_model="numpy")
def loops(start, runs, steps, draw, scale, finals):
    x, y = start.copy(), np.empty({results})
    for run in range(runs):
        x[:] = start
        for k in range(steps):
            x[0] = k * {dt!r}
            for j in range({channels}):
                x[{noise} + j] = scale * draw.standard_normal()
            step(x, y)
            x[1 : 1 + {carried}] = y[:{carried}]
        finals[run] = y[:{states}]


def ensemble(start, runs, steps, seed, scale, finals):
    loops(start, runs, steps, np.random.default_rng(seed), scale, finals)
"""


def build(work: Workload, folder: Path, fastmath: bool) -> Built:
    """Writes the module; it is compiled where it is first imported."""
    if find_spec("numba") is None:
        raise Missing("numba is not installed")
    body = "\n    ".join(python_source(work.graph, work.results))
    module = folder / f"numba_{'fast' if fastmath else 'strict'}.py"
    write(module, MODULE.format(fastmath=fastmath, body=body))
    noise, (channels, _) = work.inputs["dw"]
    shape = {"states": work.inputs["x"][1][0], "carried": work.outputs["u_sat"][0], "noise": noise, "channels": channels}
    text = ENSEMBLE.format(fastmath=fastmath, body=body, dt=work.dt, results=len(work.results), **shape)
    write(module.with_name(f"{module.stem}_ensemble.py"), text)
    return Built(module)
