"""Rust written by hand with nalgebra, for the flagship alone: the crate in `nalgebra/`."""

from pathlib import Path

from build import Built, Missing, cargo_at
from workload import Workload

CRATE = Path(__file__).parent / "nalgebra"


def build(work: Workload, folder: Path) -> Built:
    """Compiles the crate for this processor."""
    if work.spec != "nsv_attitude":
        raise Missing("written by hand for nsv_attitude only")
    return Built(cargo_at(CRATE, folder / "target", "libnsv_bench.so"))
