"""The peers by name: how each is built, and by which loop its steps and its ensembles are called."""

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

from build import Built
from peers import casadi, heyoka, jax, lanes, nalgebra, nsv, numba, plain_c, symforce
from workload import Workload


@dataclass(frozen=True)
class Peer:
    """A name, how it is built, the kind of loop that calls its step (None if it has none), and those of its ensembles by their labels."""

    name: str
    build: Callable[[Workload, Path], Built]
    step: str | None = None
    ensembles: dict[str, str] = field(default_factory=dict)
    note: str = ""


SUBJECT = "nsv"
FAST = "nsv, --math fast"
BASELINE = "CasADi C, gcc -O3"
WIDTHS = {"8 lanes": "nsv 8", "4 lanes": "nsv 4", "scalar": "nsv 1"}


def contestant(name: str, math: str, note: str) -> Peer:
    """The emitted code in one arithmetic; its ensembles have a label for each width of lanes."""
    labels = {f"{name}, {width}": kind for width, kind in WIDTHS.items()}
    return Peer(name, partial(nsv.build, math=math), "library", labels, note)


# The rows that every other is compared with, as they are named in the report.
SUBJECTS = [SUBJECT, FAST]

PEERS = [
    contestant(
        SUBJECT, "strict",
        "the emitted module, rustc -C target-cpu=native; every bit is that of the equations. In ensembles the sampled controller with its "
        "guards, and the runtime's noise",
    ),
    contestant(FAST, "fast", "the same in fast arithmetic: roundings can differ"),
    Peer(BASELINE, partial(casadi.build, flags="gcc -O3"), "library", {BASELINE: "library"}, "-march=native"),
    Peer(
        "CasADi C, clang fast-math", partial(casadi.build, flags="clang fast-math"), "library", {"CasADi C, clang fast-math": "library"},
        "-O3 -march=native",
    ),
    Peer("C from the graph, gcc -O3", partial(plain_c.build, flags="gcc -O3"), "library", {}, "-march=native; one statement per operation"),
    Peer("C from the graph, clang fast-math", partial(plain_c.build, flags="clang fast-math"), "library", {}, "-O3 -march=native"),
    Peer("SymForce, g++ -O3", partial(symforce.build, flags="g++ -O3"), "library", {}, "-march=native"),
    Peer(
        "SymForce, clang++ fast-math", partial(symforce.build, flags="clang++ fast-math"), "library",
        {"SymForce, clang++ fast-math": "library"}, "-O3 -march=native",
    ),
    Peer(
        "Rust by hand, nalgebra", nalgebra.build, "library", {"Rust by hand, nalgebra": "library"},
        "rustc -C target-cpu=native; constants folded, matrix structure used",
    ),
    Peer("numba", partial(numba.build, fastmath=False), "module"),
    Peer("numba fastmath", partial(numba.build, fastmath=True), "module", {"numba fastmath": "module"}),
    Peer("heyoka batch", heyoka.build, "heyoka", {"heyoka batch": "heyoka"}, "fast_math, 264 inputs per call, called from Python"),
    Peer("JAX", jax.build, "jax", {"JAX vmap, scan": "jax"}, "a step by jit is called from Python, which is most of its time"),
    Peer(
        "C, 8 lanes, libmvec", lanes.build, None, {"C, 8 lanes, libmvec": "lanes"},
        "CasADi's list of operations in GCC vectors of eight doubles with glibc's vector functions, written for this comparison",
    ),
]  # fmt: skip
