"""heyoka: a compiled function of its symbolic expressions, which evaluates whole batches of inputs in SIMD lanes."""

from importlib.util import find_spec
from pathlib import Path

from build import Built, Missing
from workload import Workload


def compiled(work: Workload):
    """The step as a compiled function of arrays `[size, count]`."""
    import heyoka as hy

    names = "sqrt exp sin cos tan asin acos atan sinh cosh tanh atan2 select lt gt eq".split()
    functions = {name: getattr(hy, name) for name in names}
    functions |= {"ln": hy.log, "le": hy.lte, "ge": hy.gte, "ne": hy.neq}
    functions |= {"neg": lambda a: -a, "abs": lambda a: hy.select(hy.lt(a, 0.0), -a, a)}
    functions |= {"and": lambda a, b: hy.logical_and([a, b]), "or": lambda a, b: hy.logical_or([a, b]), "pow": lambda a, b: a**b}
    functions |= {"add": lambda a, b: a + b, "sub": lambda a, b: a - b, "mul": lambda a, b: a * b, "div": lambda a, b: a / b}
    functions |= {"min": lambda a, b: hy.select(hy.lt(a, b), a, b), "max": lambda a, b: hy.select(hy.gt(a, b), a, b)}
    functions |= {"not": lambda a: 1.0 - a, "const": hy.expression}
    symbols = hy.make_vars(*(f"x{i}" for i in range(work.size)))
    results = work.graph.evaluate(work.results, symbols, functions)
    return hy.cfunc(results, vars=symbols, fast_math=True)


def ensemble(work: Workload, function, start, runs: int, steps: int, seed: int, scale: float, finals, batch: int) -> None:
    """Batches of runs, whose noise is numpy's."""
    import numpy as np

    draw = np.random.default_rng(seed)
    carried, (noise, _), states = work.outputs["u_sat"][0], work.inputs["dw"], work.inputs["x"][1][0]
    x, y = np.empty((work.size, batch)), np.empty((len(work.results), batch))
    for run in range(0, runs, batch):
        x[:] = start[:, None]
        for k in range(steps):
            x[0] = k * work.dt
            draw.standard_normal(out=x[noise:])
            x[noise:] *= scale
            function(x, outputs=y)
            x[1 : 1 + carried] = y[:carried]
        finals[run : run + batch] = y[:states].T[: runs - run]


def build(work: Workload, folder: Path) -> Built:
    """It is compiled where it is measured."""
    if find_spec("heyoka") is None:
        raise Missing("heyoka is not installed")
    return Built(folder)
