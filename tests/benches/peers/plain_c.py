"""C as plain as it gets: one statement per operation of the graph, compiled with the same flags as CasADi's code."""

from pathlib import Path

from build import Built, compiled
from peers.casadi import FLAGS
from reference import python_source
from workload import Workload

HEAD = """#include <iso646.h>
#include <math.h>
#define abs fabs
static inline double min(double a, double b) { return a < b ? a : b; }
static inline double max(double a, double b) { return a > b ? a : b; }
static inline double sign(double a) { return a > 0 ? 1 : a < 0 ? -1 : a; }

void step(const double *restrict x, double *restrict y) {
"""


def build(work: Workload, folder: Path, flags: str) -> Built:
    """Prints and compiles."""
    lines = python_source(work.graph, work.results, select="({c} ? {a} : {b})")
    body = "".join(f"  {'const double ' if line.startswith('v') else ''}{line};\n" for line in lines)
    return Built(compiled(folder, HEAD + body + "}\n", "step.c", FLAGS[flags]))
