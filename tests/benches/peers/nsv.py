"""nsv's side: the emitted code of `generated/`, called as a user's program would call it.

`step` calls the functions `control` and `plant` with their own types; ensembles call the sampled controller in the runtime's lanes. What
packs the flat arrays of the workload into the emitted types is made here from the names in the compiler's text form, and is not timed.
"""

from pathlib import Path
from string import Template

from build import Built, cargo
from workload import ROOT, Workload

CRATE = Path(__file__).parent / "nsv_crate"

MANIFEST = """[package]
name = "nsv-bench-{spec}"
version = "0.0.0"
edition = "2024"
publish = false

[lib]
name = "nsv_bench"
crate-type = ["cdylib"]

[dependencies]
nsv-generated = {{ path = "{root}/generated", features = ["std"] }}
nsv-runtime = {{ path = "{root}/runtime", features = ["std"] }}

[profile.release]
opt-level = 3
codegen-units = 1
lto = "fat"
panic = "abort"

[workspace]
"""


def source(work: Workload) -> str:
    """The library's text."""
    states, channels = work.inputs["x"][1][0], work.inputs["dw"][1][0]
    width = work.outputs["u_sat"][1][0]
    blocks = [", ".join(f"x[{j}]" for j in range(i, i + width)) for i in range(0, work.blocks * width, width)]
    rows = []
    for i in range(states):
        terms = [f"rate.diffusion[({i}, {j})] * dw[{j}]" for j in work.noisy[i]]
        rows.append(" + ".join([f"        (x[{i}] + rate.drift[{i}] * dt)", *terms]) + ",")
    return Template((CRATE / "lib.rs.in").read_text()).substitute(
        spec=work.spec, states=states, channels=channels, width=width, size=work.size, results=len(work.results),
        loads="\n".join(f"    input.{name}.load(&mut from);" for name in work.inputs),
        stores="\n".join(f"    output.{name}.store(&mut to);" for name in work.outputs),
        nominals="\n".join(f"    input.{name}.store(&mut to);" for name in work.inputs),
        blocks=", ".join(f"Vector([{block}])" for block in blocks), rows="\n".join(rows),
    )  # fmt: skip


def build(work: Workload, folder: Path) -> Built:
    """Compiles the library for this processor."""
    sources = {"lib.rs": source(work)} | {path.name: path.read_text() for path in CRATE.glob("*.rs")}
    return Built(cargo(folder, MANIFEST.format(spec=work.spec.replace("_", "-"), root=ROOT), sources, "libnsv_bench.so"))
