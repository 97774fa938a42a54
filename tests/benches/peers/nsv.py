"""nsv's side: the emitted code of `generated/`, called as a user's program would call it.

The functions `control` and `plant` are called with their own types; what packs the flat arrays of the workload into these types is made
here from the names in the compiler's text form, and is not timed.
"""

from pathlib import Path

from build import Built, cargo
from workload import ROOT, Workload

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

SOURCE = """#![allow(non_snake_case, unused_mut)]
use core::mem::size_of;
use core::slice;
use nsv_generated::{spec}::controller::{{self, State}};
use nsv_generated::{spec}::params::Params;
use nsv_generated::{spec}::plant;
use nsv_runtime::linear::{{Matrix, Vector}};

/// Numbers of a value, row by row.
trait Flat {{
    fn load(&mut self, from: &mut slice::Iter<'_, f64>);
    fn store(&self, to: &mut slice::IterMut<'_, f64>);
}}
impl Flat for f64 {{
    fn load(&mut self, from: &mut slice::Iter<'_, f64>) {{ *self = *from.next().unwrap(); }}
    fn store(&self, to: &mut slice::IterMut<'_, f64>) {{ *to.next().unwrap() = *self; }}
}}
impl<const N: usize> Flat for Vector<f64, N> {{
    fn load(&mut self, from: &mut slice::Iter<'_, f64>) {{ for i in 0..N {{ self[i].load(from); }} }}
    fn store(&self, to: &mut slice::IterMut<'_, f64>) {{ for i in 0..N {{ self[i].store(to); }} }}
}}
impl<const R: usize, const C: usize> Flat for Matrix<f64, R, C> {{
    fn load(&mut self, from: &mut slice::Iter<'_, f64>) {{ for i in 0..R {{ for j in 0..C {{ self[(i, j)].load(from); }} }} }}
    fn store(&self, to: &mut slice::IterMut<'_, f64>) {{ for i in 0..R {{ for j in 0..C {{ self[(i, j)].store(to); }} }} }}
}}

#[repr(C, align(64))]
pub struct Input {{
    t: f64,
    x: Vector<f64, {states}>,
    state: State<f64>,
    params: Params<f64>,
    plant: Params<f64>,
    dw: Vector<f64, {noise}>,
}}

#[repr(C, align(64))]
pub struct Output {{
    x: Vector<f64, {states}>,
    next: State<f64>,
    u_sat: Vector<f64, {width}>,
}}

#[unsafe(no_mangle)]
pub extern "C" fn in_size() -> usize {{ size_of::<Input>() }}
#[unsafe(no_mangle)]
pub extern "C" fn out_size() -> usize {{ size_of::<Output>() }}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn pack(flat: *const f64, to: *mut Input) {{
    let mut from = unsafe {{ slice::from_raw_parts(flat, {size}) }}.iter();
    let mut input = start();
{loads}
    unsafe {{ to.write(input) }}
}}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn unpack(output: *const Output, flat: *mut f64) {{
    let output = unsafe {{ &*output }};
    let mut to = unsafe {{ slice::from_raw_parts_mut(flat, {results}) }}.iter_mut();
{stores}
}}

/// Initial plant state and nominal parameters.
fn start() -> Input {{
    Input {{
        t: 0.0,
        x: Vector(plant::INITIAL_STATE),
        state: State::zero(),
        params: Params::design(),
        plant: Params::plant(),
        dw: Vector::zero(),
    }}
}}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn nominal(flat: *mut f64) {{
    let input = start();
    let mut to = unsafe {{ slice::from_raw_parts_mut(flat, {size}) }}.iter_mut();
{nominals}
}}

#[unsafe(no_mangle)]
pub extern "C" fn step(input: &Input, output: &mut Output) {{
    let (t, x, dt) = (input.t, input.x, controller::SAMPLE_TIME);
    let law = controller::control(t, {blocks}, &input.state, &input.params);
    let rate = plant::plant(t, x, law.u_sat, &input.plant);
    output.x = (x + rate.drift * dt){diffusion};
    output.next = law.next;
    output.u_sat = law.u_sat;
}}
"""


def source(work: Workload) -> str:
    """The library's text."""
    states, noise = work.inputs["x"][1][0], work.inputs["dw"][1][0]
    width = work.outputs["u_sat"][1][0]
    block = lambda i: "Vector([" + ", ".join(f"x[{j}]" for j in range(i * width, (i + 1) * width)) + "])"  # noqa: E731
    return SOURCE.format(
        spec=work.spec, states=states, noise=noise, width=width, size=work.size, results=len(work.results),
        loads="\n".join(f"    input.{name}.load(&mut from);" for name in work.inputs),
        stores="\n".join(f"    output.{name}.store(&mut to);" for name in work.outputs),
        nominals="\n".join(f"    input.{name}.store(&mut to);" for name in work.inputs),
        blocks=", ".join(block(i) for i in range(work.blocks)),
        diffusion=" + rate.diffusion * input.dw" if noise else "",
    )  # fmt: skip


def build(work: Workload, folder: Path) -> Built:
    """Compiles the library for this processor."""
    manifest = MANIFEST.format(spec=work.spec.replace("_", "-"), root=ROOT)
    return Built(cargo(folder, manifest, {"lib.rs": source(work)}, "libnsv_bench.so"))
