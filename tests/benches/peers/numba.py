"""numba: the law as straight-line Python, compiled to a C callback with and without fastmath. The code is cached between processes."""

from importlib.util import find_spec
from pathlib import Path

from build import Built, Missing, write
from reference import python_source
from workload import Workload

MODULE = """from math import *
from numba import cfunc, types

pointer = types.CPointer(types.float64)


@cfunc(types.void(pointer, pointer), cache=True, fastmath={fastmath})
def step(x, y):
    {body}
"""


def build(work: Workload, folder: Path, fastmath: bool) -> Built:
    """Writes the module; it is compiled where it is first imported."""
    if find_spec("numba") is None:
        raise Missing("numba is not installed")
    body = "\n    ".join(python_source(work.graph, work.results))
    module = folder / f"numba_{work.spec}_{'fast' if fastmath else 'strict'}.py"
    write(module, MODULE.format(fastmath=fastmath, body=body))
    return Built(module)
