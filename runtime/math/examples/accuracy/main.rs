//! Largest errors of the elementary functions, against the correctly rounded ones of CORE-MATH, as a Markdown table.
//!
//! `cargo run --release -p nsv-math --example accuracy` samples for some seconds;
//! `cargo run --release -p nsv-math --example accuracy -- --exhaustive` tries every single-precision argument of the functions of one
//! argument and 10^8 other arguments of each function, on all cores, in an hour or so.
//!
//! In single precision the error is that of the result against the exact value. In double precision it is the distance from the correctly
//! rounded result in places; the exact value is at most half a place further away.

mod arguments;
mod error;

use std::env;
use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

use arguments::Arguments;
use error::Worst;
use nsv_math::real::Real;

/// Arguments that one thread takes at a time.
const BLOCK: u64 = 1 << 16;

/// A function of one argument: ours and the correctly rounded one, in both precisions.
struct Function {
    name: &'static str,
    single: [fn(f32) -> f32; 2],
    double: [fn(f64) -> f64; 2],
}

/// A function of two arguments.
struct Function2 {
    name: &'static str,
    single: [fn(f32, f32) -> f32; 2],
    double: [fn(f64, f64) -> f64; 2],
}

macro_rules! functions {
    ($kind:ident: $($ours:ident $single:ident $double:ident),*) => {
        [$($kind {
            name: stringify!($ours),
            single: [Real::$ours, core_math::$single],
            double: [Real::$ours, core_math::$double],
        }),*]
    };
}

fn main() {
    let exhaustive = env::args().any(|argument| argument == "--exhaustive");
    let (stride, samples) = if exhaustive {
        (1, 100_000_000)
    } else {
        (4099, 400_000)
    };
    println!(
        "| function | single: arguments | ulp | at | double: arguments | places | at | not nearest |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    let functions = functions!(Function: sin sinf sin, cos cosf cos, tan tanf tan, exp expf exp, ln logf log, sinh sinhf sinh, cosh coshf cosh,
        tanh tanhf tanh, asin asinf asin, acos acosf acos, atan atanf atan);
    for function in functions {
        let count = (1 << 32) / stride;
        let single = worst(count, |worst, range| {
            for index in range {
                let x = f32::from_bits((index * stride) as u32);
                let results = function.single.map(|f| f(x));
                worst.single([x.into()], results, || function.double[1](x.into()));
            }
        });
        let double = worst(samples, |worst, range| {
            for x in Arguments::of(range) {
                worst.double([x], function.double.map(|f| f(x)));
            }
        });
        print(function.name, count, &single, samples, &double);
    }
    for function in functions!(Function2: atan2 atan2f atan2, pow powf pow) {
        let single = worst(samples, |worst, range| {
            for [x, y] in Arguments::of(range).pairs(function.name == "pow") {
                let (x, y) = (x as f32, y as f32);
                let results = function.single.map(|f| f(x, y));
                let exact = || function.double[1](x.into(), y.into());
                worst.single([x.into(), y.into()], results, exact);
            }
        });
        let double = worst(samples, |worst, range| {
            for [x, y] in Arguments::of(range).pairs(function.name == "pow") {
                worst.double([x, y], function.double.map(|f| f(x, y)));
            }
        });
        print(function.name, samples, &single, samples, &double);
    }
}

/// The worst of `count` arguments, tried in blocks by every core.
fn worst<const N: usize>(count: u64, block: impl Fn(&mut Worst<N>, Range<u64>) + Sync) -> Worst<N> {
    let next = AtomicU64::new(0);
    let work = || {
        let mut worst = Worst::new();
        loop {
            let start = next.fetch_add(BLOCK, Ordering::Relaxed);
            if start >= count {
                return worst;
            }
            block(&mut worst, start..count.min(start + BLOCK));
        }
    };
    let cores = thread::available_parallelism().map_or(1, usize::from);
    thread::scope(|scope| {
        let threads: Vec<_> = (0..cores).map(|_| scope.spawn(work)).collect();
        let found = threads
            .into_iter()
            .map(|thread| thread.join().expect("no panic"));
        found.reduce(worse).expect("a core")
    })
}

/// Of two, the worse.
fn worse<const N: usize>(a: Worst<N>, b: Worst<N>) -> Worst<N> {
    let missed = a.missed + b.missed;
    let worse = if b.error > a.error { b } else { a };
    Worst { missed, ..worse }
}

fn print<const N: usize>(
    name: &str,
    singles: u64,
    single: &Worst<N>,
    doubles: u64,
    double: &Worst<N>,
) {
    println!(
        "| {name} | {singles} | {:.3} | {} | {doubles} | {} | {} | {:.1} % |",
        single.error,
        single.place(),
        double.error,
        double.place(),
        100.0 * double.missed as f64 / doubles as f64
    );
}
