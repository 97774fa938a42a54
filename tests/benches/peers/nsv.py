"""nsv's side: the emitted module, called as a user's program would call it, in strict or in fast arithmetic.

`step` advances a closed loop in place by the functions of the law and of the plant, with their own types. What depends on parameters alone
is computed once, when an input is packed, as `Controller::new` does; what depends on time in every step. Ensembles call the sampled
controller in the runtime's lanes, with values of time for as many steps at once as there are lanes. What packs the flat arrays of the
workload into the emitted types is made here from the names in the compiler's text form, and is not timed.
"""

import re
from pathlib import Path
from string import Template

from build import Built, cargo
from workload import ROOT, Workload, compiler

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
nsv-runtime = {{ path = "{root}/runtime", features = ["std"] }}

[profile.release]
opt-level = 3
codegen-units = 1
lto = "fat"
panic = "abort"

[workspace]
"""
FUNCTION = re.compile(r"^pub fn (\w+)<T: Real>\(([^)]*)\)", re.MULTILINE)
ABSENT = "core::marker::PhantomData"


class Functions:
    """The public functions of an emitted file, with the names of their arguments; a program need not have all pieces."""

    def __init__(self, path: Path) -> None:
        self.file = path.stem
        self.arguments = {name: re.findall(r"\b_?(\w+): ", text) for name, text in FUNCTION.findall(path.read_text())}

    def call(self, name: str, **values: str) -> str:
        """A call with values by the names of arguments."""
        return f"{self.file}::{name}({', '.join(values[argument] for argument in self.arguments[name])})"

    def prepared(self) -> tuple[str, str]:
        """Type and value of what parameters give."""
        known = "prepare" in self.arguments
        return (f"{self.file}::Prepared<T>", self.call("prepare", params="params")) if known else (f"{ABSENT}<T>", ABSENT)

    def clock(self) -> str:
        """Statement that computes what depends on time."""
        return f"let clock = {self.call('clock', t='t', params='params', prepared='prepared')};" if "clock" in self.arguments else ""

    def ahead(self, common: set[str]) -> tuple[str, str, str]:
        """Type and first value of what is computed for several steps at once, and the statement that gives it for one of them: the values
        of a clock that needs nothing but `common`."""
        if not set(self.arguments.get("clock", ["absent"])) <= common:
            return f"{ABSENT}<T>", ABSENT, self.clock()
        return f"Ahead<{self.file}::Clock<T>>", "Ahead::new(time)", "let clock = ahead.at(step, time);"


def pieces(work: Workload, module: Path) -> dict[str, str]:
    """What pieces.rs.in leaves open."""
    width = work.outputs["u_sat"][1][0]
    law, plant = Functions(module / "controller.rs"), Functions(module / "plant.rs")
    blocks = [f"Vector([{', '.join(f'x[{i * width + j}]' for j in range(width))}])" for i in range(work.blocks)]
    values = {"state": "state", "params": "params", "prepared": "prepared", "clock": "&clock", "x": "x", "u_sat": "u_sat"}
    measured = {f"x{i + 1}": block for i, block in enumerate(blocks)}
    (law_prepared, prepare_law), (plant_prepared, prepare_plant) = law.prepared(), plant.prepared()
    # As in the emitted simulator: the controller's parameters are those of the design in every run.
    law_ahead, new_law_ahead, sample_clock = law.ahead({"t", "params"})
    plant_ahead, new_plant_ahead, rate_clock = plant.ahead({"t"})
    shared = "ahead" in sample_clock
    sampled = ["t", *["&clock"] * shared, *blocks]
    return {
        "law_prepared": law_prepared, "prepare_law": prepare_law, "plant_prepared": plant_prepared, "prepare_plant": prepare_plant,
        "law_ahead": law_ahead, "new_law_ahead": new_law_ahead, "plant_ahead": plant_ahead, "new_plant_ahead": new_plant_ahead,
        "law_clock": law.clock(),
        "law": law.call("law" if "law" in law.arguments else "control", t="t", **values | measured),
        "sample_clock": sample_clock if shared else "",
        "sample": f"step{'_at' if shared else ''}({', '.join(sampled)})",
        "plant_clock": plant.clock(), "rate_clock": rate_clock,
        "rate": plant.call("dynamics" if "dynamics" in plant.arguments else "plant", t="t", **values),
    }  # fmt: skip


def source(work: Workload) -> dict[str, str]:
    """What lib.rs.in leaves open."""
    states, channels = work.inputs["x"][1][0], work.inputs["dw"][1][0]
    rows = []
    for i in range(states):
        terms = [f"rate.diffusion[({i}, {j})] * dw[{j}]" for j in work.noisy[i]]
        rows.append(" + ".join([f"        (x[{i}] + rate.drift[{i}] * dt)", *terms]) + ",")
    results = ["output.u_sat" if name == "u_sat" else f"input.{name.replace('next.', 'state.')}" for name in work.outputs]
    sizes = {"states": states, "channels": channels, "width": work.outputs["u_sat"][1][0], "size": work.size, "results": len(work.results)}
    return {name: str(size) for name, size in sizes.items()} | {
        "loads": "\n".join(f"    input.{name}.load(&mut from);" for name in work.inputs),
        "stores": "\n".join(f"    {name}.store(&mut to);" for name in results),
        "nominals": "\n".join(f"    input.{name}.store(&mut to);" for name in work.inputs),
        "rows": "\n".join(rows),
    }


def build(work: Workload, folder: Path, math: str) -> Built:
    """Emits the module and compiles the library for this processor."""
    compiler("generate", f"specs/{work.spec}.yaml", "--math", math, "--out", str(folder / "src"))
    words = {"spec": work.spec, "normals": "normals_fused" if math == "fast" else "normals"} | source(work) | pieces(work, folder / "src" / work.spec)
    sources = {path.stem: Template(path.read_text()).substitute(words) for path in CRATE.glob("*.in")}
    sources |= {path.name: path.read_text() for path in CRATE.glob("*.rs")}
    return Built(cargo(folder, MANIFEST.format(spec=work.spec.replace("_", "-"), root=ROOT), sources, "libnsv_bench.so"))
