"""The peers by name: how each is built, and how it is called."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from build import Built
from peers import casadi, heyoka, jax, nalgebra, nsv, numba, symforce
from workload import Workload


@dataclass(frozen=True)
class Peer:
    """A name, how it is built, and which loop calls it: that in C by a pointer, or one in Python."""

    name: str
    build: Callable[[Workload, Path], Built]
    loop: str = "library"
    note: str = ""


BASELINE = "CasADi C, gcc -O3"

STEP = [
    Peer("nsv", nsv.build, note="`control` and `plant` of the emitted module, rustc -C target-cpu=native"),
    Peer(BASELINE, partial(casadi.build, flags="gcc -O3"), note="-march=native"),
    Peer("CasADi C, clang fast-math", partial(casadi.build, flags="clang fast-math"), note="-O3 -march=native"),
    Peer("SymForce, g++ -O3", partial(symforce.build, flags="g++ -O3"), note="-march=native"),
    Peer("SymForce, clang++ fast-math", partial(symforce.build, flags="clang++ fast-math"), note="-O3 -march=native"),
    Peer("Rust by hand, nalgebra", nalgebra.build, note="rustc -C target-cpu=native"),
    Peer("numba", partial(numba.build, fastmath=False), "module"),
    Peer("numba fastmath", partial(numba.build, fastmath=True), "module"),
    Peer("heyoka batch", heyoka.build, "heyoka", "264 inputs per call, called from Python"),
    Peer("JAX jit", jax.build, "jax", "called from Python, which is most of its time"),
]
