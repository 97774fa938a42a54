"""CasADi: C code of one function with common subexpressions shared, compiled by gcc or by clang with -ffast-math."""

import os
from pathlib import Path

from build import Built, Missing, compiled
from graph import BINARY
from workload import Workload

FLAGS = {
    "gcc -O3": ["gcc", "-O3", "-march=native"],
    "clang fast-math": ["clang", "-O3", "-ffast-math", "-march=native"],
}

WRAPPER = """
void step(const double *in, double *out) {
  const double *arguments[1] = {in};
  double *results[1] = {out};
  law(arguments, results, 0, 0, 0);
}
"""


def function(work: Workload):
    """The law as a function of the flat input."""
    try:
        import casadi as ca
    except ImportError as error:
        raise Missing("casadi is not installed") from error
    names = {"ln": "log", "and": "logic_and", "or": "logic_or", "not": "logic_not", "abs": "fabs", "min": "fmin", "max": "fmax"}
    functions = {name: getattr(ca, names.get(name, name), None) for name in [*BINARY, *names, "sqrt", "exp", "sin", "cos", "tan"]}
    functions |= {name: getattr(ca, name) for name in "asin acos atan sinh cosh tanh sign atan2".split()}
    functions |= {"add": ca.plus, "sub": ca.minus, "mul": ca.times, "div": ca.rdivide, "pow": ca.power, "neg": lambda a: -a}
    functions |= {"select": ca.if_else, "const": ca.SX}
    symbol = ca.SX.sym("in", work.size)
    results = work.graph.evaluate(work.results, ca.vertsplit(symbol), functions)
    return ca.Function("law", [symbol], [ca.vertcat(*results)], {"cse": True})


def build(work: Workload, folder: Path, flags: str) -> Built:
    """Generates and compiles."""
    law, folder = function(work), folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    start = Path.cwd()
    os.chdir(folder)  # CasADi writes to the working directory only
    try:
        law.generate("law.c")
    finally:
        os.chdir(start)
    return Built(compiled(folder, (folder / "law.c").read_text() + WRAPPER, "step.c", FLAGS[flags]))
