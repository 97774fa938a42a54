//! The closed loop of `specs/nsv_attitude.yaml` as a good engineer would write it with nalgebra, and its interface for the benchmarks.
//!
//! What is constant is folded when it is compiled: the Mach number, and the sums of polynomials at zero deflection.

mod adaptive;
mod aero;
mod controller;
mod plant;
mod vehicle;

use std::slice::Iter;

use controller::State;
use nalgebra::{SMatrix, SVector};
use plant::PlantState;
use vehicle::Scales;

pub type Vector3 = nalgebra::Vector3<f64>;
pub type Matrix3 = nalgebra::Matrix3<f64>;
pub type Pair = nalgebra::Vector2<f64>;
pub type Weights = SMatrix<f64, 19, 3>;
pub type Basis = SVector<f64, 19>;

/// Seconds between samples.
pub const DT: f64 = 0.002;

#[repr(C, align(64))]
pub struct Input {
    t: f64,
    plant: PlantState,
    state: State,
    design: Scales,
    truth: Scales,
    noise: plant::Noise,
}

#[repr(C, align(64))]
pub struct Output {
    plant: PlantState,
    state: State,
    u_sat: Vector3,
}

/// The next `N` numbers.
fn take<const N: usize>(from: &mut Iter<'_, f64>) -> [f64; N] {
    std::array::from_fn(|_| *from.next().unwrap())
}

fn vector<const N: usize>(from: &mut Iter<'_, f64>) -> SVector<f64, N> {
    take(from).into()
}

fn weights(from: &mut Iter<'_, f64>) -> Weights {
    Weights::from_row_slice(&take::<57>(from))
}

fn pairs(from: &mut Iter<'_, f64>) -> [Pair; 3] {
    std::array::from_fn(|_| vector(from))
}

/// Lift, side force, roll, pitch, drag, yaw: the order in which the compiler first needs them.
fn scales(from: &mut Iter<'_, f64>) -> Scales {
    let [lift, side, roll, pitch, _drag, yaw] = take(from);
    Scales { lift, side, roll, pitch, yaw }
}

#[unsafe(no_mangle)]
pub extern "C" fn in_size() -> usize {
    size_of::<Input>()
}

#[unsafe(no_mangle)]
pub extern "C" fn out_size() -> usize {
    size_of::<Output>()
}

/// # Safety
/// `flat` holds the inputs of the workload, `to` has space for an input.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pack(flat: *const f64, to: *mut Input) {
    let from = &mut unsafe { std::slice::from_raw_parts(flat, 169) }.iter();
    let input = Input {
        t: take::<1>(from)[0],
        plant: PlantState { attitude: vector(from), rates: vector(from), exosystems: pairs(from) },
        state: State {
            zeta1: vector(from),
            zeta2: vector(from),
            w1: weights(from),
            th1: vector(from),
            h1: vector(from),
            w2: weights(from),
            th2: pairs(from),
            eps2: take::<1>(from)[0],
            sigma2: take::<1>(from)[0],
            phi2: take::<1>(from)[0],
        },
        design: scales(from),
        truth: scales(from),
        noise: plant::Noise { surfaces: vector(from), exosystems: pairs(from) },
    };
    unsafe { to.write(input) }
}

/// # Safety
/// `output` is one, `flat` has space for the results of the workload.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn unpack(_input: *const Input, output: *const Output, flat: *mut f64) {
    let Output { plant, state, u_sat } = unsafe { &*output };
    let mut values: Vec<f64> = Vec::new();
    values.extend(plant.attitude.iter().chain(&plant.rates));
    values.extend(plant.exosystems.iter().flatten());
    values.extend(state.zeta1.iter().chain(&state.zeta2));
    values.extend(state.w1.transpose().iter());
    values.extend(state.th1.iter().chain(&state.h1));
    values.extend(state.w2.transpose().iter());
    values.extend(state.th2.iter().flatten());
    values.extend([state.eps2, state.sigma2, state.phi2]);
    values.extend(u_sat.iter());
    unsafe { flat.copy_from_nonoverlapping(values.as_ptr(), values.len()) }
}

/// Makes the result of a step the input of the next one.
///
/// # Safety
/// `output` is one or null, `dw` holds nine increments.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carry(output: *const Output, input: &mut Input, t: f64, dw: *const f64) {
    if let Some(output) = unsafe { output.as_ref() } {
        input.plant = output.plant;
        input.state = output.state;
    }
    let from = &mut unsafe { std::slice::from_raw_parts(dw, 9) }.iter();
    input.t = t;
    input.noise = plant::Noise { surfaces: vector(from), exosystems: pairs(from) };
}

/// One sample of the controller, and one Euler-Maruyama step of the plant.
#[unsafe(no_mangle)]
pub extern "C" fn step(input: &Input, output: &mut Output) {
    let Input { t, plant, state, design, truth, noise } = input;
    let (u_sat, next) = controller::step(*t, &plant.attitude, &plant.rates, state, design);
    output.plant = plant::step(*t, plant, &u_sat, truth, noise);
    output.state = next;
    output.u_sat = u_sat;
}
