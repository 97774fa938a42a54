//! Arguments that the branch-free text of a function does not cover.

use crate::real::{MOST_LANES, Mask, Real};

/// `f` of the arguments in the lanes of `rare`, `usual` in the others. No lane's value depends on another lane. The usual path costs one
/// branch.
#[inline(always)]
pub fn replaced<T: Real, const N: usize>(
    rare: T::Mask,
    usual: T,
    arguments: [T; N],
    f: fn([f64; N]) -> f64,
) -> T {
    if !rare.any() {
        return usual;
    }
    if T::LANES == 1 {
        return T::from_f64(replace_one(arguments.map(T::to_f64), f));
    }
    const { assert!(T::LANES <= MOST_LANES) };
    let (mut lanes, mut values) = ([[0.0; N]; MOST_LANES], [0.0; MOST_LANES]);
    for lane in 0..T::LANES {
        lanes[lane] = arguments.map(|argument| argument.lane(lane));
        values[lane] = usual.lane(lane);
    }
    replace(rare.to_bits(), &lanes[..T::LANES], &mut values, f);
    T::from_lanes(|lane| values[lane])
}

#[cold]
#[inline(never)]
fn replace_one<const N: usize>(arguments: [f64; N], f: fn([f64; N]) -> f64) -> f64 {
    f(arguments)
}

#[cold]
#[inline(never)]
fn replace<const N: usize>(
    rare: u32,
    lanes: &[[f64; N]],
    values: &mut [f64],
    f: fn([f64; N]) -> f64,
) {
    for (lane, (&arguments, value)) in lanes.iter().zip(values).enumerate() {
        if rare >> lane & 1 == 1 {
            *value = f(arguments);
        }
    }
}
