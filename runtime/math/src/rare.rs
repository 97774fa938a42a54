//! Arguments that the branch-free text of a function does not cover.

use crate::real::{Mask, Real};

/// More lanes than any type has.
const MOST_LANES: usize = 16;

/// `f` of the argument in the lanes of `rare`, `usual` in the others. No lane's value depends on another lane. The usual path costs one
/// branch.
#[inline(always)]
pub fn replaced<T: Real>(rare: T::Mask, usual: T, x: T, f: fn(f64) -> f64) -> T {
    if !rare.any() {
        return usual;
    }
    if T::LANES == 1 {
        return T::from_f64(replace_one(x.to_f64(), f));
    }
    let (mut arguments, mut values) = ([0.0; MOST_LANES], [0.0; MOST_LANES]);
    for lane in 0..T::LANES {
        arguments[lane] = x.lane(lane);
        values[lane] = usual.lane(lane);
    }
    replace(
        rare.to_bits(),
        &arguments[..T::LANES],
        &mut values[..T::LANES],
        f,
    );
    T::from_lanes(|lane| values[lane])
}

#[cold]
#[inline(never)]
fn replace_one(x: f64, f: fn(f64) -> f64) -> f64 {
    f(x)
}

#[cold]
#[inline(never)]
fn replace(rare: u32, arguments: &[f64], values: &mut [f64], f: fn(f64) -> f64) {
    for (lane, (&x, value)) in arguments.iter().zip(values).enumerate() {
        if rare >> lane & 1 == 1 {
            *value = f(x);
        }
    }
}
