//! Largest errors of the elementary functions, against the correctly rounded ones of CORE-MATH, as a Markdown table.
//!
//! `cargo run --release -p nsv-math --features std --example accuracy` samples for some seconds; with `-- --exhaustive` it tries every
//! single-precision argument of the functions of one argument, and 10^8 other arguments of each function, on all cores, in an hour or so.
//! Names of functions restrict it to those.
//!
//! In single precision the error is that of the result against the exact value. In double precision it is the distance from the correctly
//! rounded result in places; the exact value is at most half a place further away. Single precision runs in the widest lanes, which give the
//! bits of the scalar.

mod arguments;
mod error;

use std::env;
use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

use arguments::Arguments;
use error::Worst;
use nsv_math::lanes::{self, Kernel, Width};
use nsv_math::real::Real;

/// Arguments that one thread takes at a time.
const BLOCK: u64 = 1 << 16;

/// A function of one argument.
struct Function {
    name: &'static str,
    /// Ours at consecutive representations: the first, and the stride.
    singles: fn(Range<u64>, u64) -> Vec<f32>,
    nearest_single: fn(f32) -> f32,
    double: [fn(f64) -> f64; 2],
}

/// A function of two arguments: ours and the correctly rounded one.
struct Function2 {
    name: &'static str,
    single: [fn(f32, f32) -> f32; 2],
    double: [fn(f64, f64) -> f64; 2],
}

/// The single with the representation `index stride`.
fn single(index: u64, stride: u64) -> f32 {
    f32::from_bits((index * stride) as u32)
}

macro_rules! functions {
    ($($ours:ident $single:ident $double:ident),*) => {
        [$({
            struct Block(Range<u64>, u64);
            impl Kernel for Block {
                type Output = Vec<f32>;

                #[inline(always)]
                fn run<T: Real>(self) -> Vec<f32> {
                    let Block(range, stride) = self;
                    let mut results = Vec::with_capacity((range.end - range.start) as usize + T::LANES);
                    for start in range.step_by(T::LANES) {
                        let result = T::from_lanes(|lane| single(start + lane as u64, stride).into()).$ours();
                        results.extend((0..T::LANES).map(|lane| result.lane(lane) as f32));
                    }
                    results
                }
            }
            Function {
                name: stringify!($ours),
                singles: |range, stride| lanes::run_single(Width::widest(), Block(range, stride)).expect("the widest is there"),
                nearest_single: core_math::$single,
                double: [Real::$ours, core_math::$double],
            }
        }),*]
    };
}

fn main() {
    let (options, names): (Vec<String>, Vec<String>) = env::args()
        .skip(1)
        .partition(|argument| argument.starts_with('-'));
    let exhaustive = options.iter().any(|option| option == "--exhaustive");
    let (stride, samples) = if exhaustive {
        (1, 100_000_000)
    } else {
        (4099, 400_000)
    };
    let wanted = |name: &str| names.is_empty() || names.iter().any(|wanted| wanted == name);
    println!(
        "| function | single: arguments | ulp | at | double: arguments | places | at | not nearest |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    let functions = functions!(exp expf exp, tanh tanhf tanh, ln logf log, sinh sinhf sinh, cosh coshf cosh, asin asinf asin, acos acosf acos,
        atan atanf atan, sin sinf sin, cos cosf cos, tan tanf tan);
    for function in functions.iter().filter(|function| wanted(function.name)) {
        one_argument(function, stride, samples);
    }
    let functions = [
        Function2 {
            name: "atan2",
            single: [Real::atan2, core_math::atan2f],
            double: [Real::atan2, core_math::atan2],
        },
        Function2 {
            name: "pow",
            single: [Real::pow, core_math::powf],
            double: [Real::pow, core_math::pow],
        },
    ];
    for function in functions.iter().filter(|function| wanted(function.name)) {
        two_arguments(function, samples);
    }
}

fn one_argument(function: &Function, stride: u64, samples: u64) {
    let count = (1 << 32) / stride;
    let singles = worst(count, |worst, range| {
        let results = (function.singles)(range.clone(), stride);
        for (index, ours) in range.zip(results) {
            let x = single(index, stride);
            let nearest = (function.nearest_single)(x);
            worst.single([x.into()], [ours, nearest], || function.double[1](x.into()));
        }
    });
    let doubles = worst(samples, |worst, range| {
        for x in Arguments::of(range) {
            worst.double([x], function.double.map(|f| f(x)));
        }
    });
    print(function.name, count, &singles, samples, &doubles);
}

fn two_arguments(function: &Function2, samples: u64) {
    let power = function.name == "pow";
    let singles = worst(samples, |worst, range| {
        for [x, y] in Arguments::of(range).pairs(power) {
            let (x, y) = (x as f32, y as f32);
            let exact = || function.double[1](x.into(), y.into());
            worst.single(
                [x.into(), y.into()],
                function.single.map(|f| f(x, y)),
                exact,
            );
        }
    });
    let doubles = worst(samples, |worst, range| {
        for [x, y] in Arguments::of(range).pairs(power) {
            worst.double([x, y], function.double.map(|f| f(x, y)));
        }
    });
    print(function.name, samples, &singles, samples, &doubles);
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
