//! Nanoseconds per value of every elementary function: scalar ours, the `libm` crate and the platform's, and ours in lanes.
//!
//! `cargo run --release -p nsv-math --example timing --features std`
//!
//! Each figure is the smallest of many rounds over 1024 arguments that are independent of each other; the columns take turns in each
//! round, so that what else the machine does touches all alike.

use std::hint::black_box;
use std::time::Instant;

use nsv_math::lanes::{self, Kernel, Width};
use nsv_math::real::Real;

const COUNT: usize = 1024;
const ROUNDS: usize = 400;

/// A function in all its implementations.
struct Row {
    name: &'static str,
    lowest: f64,
    highest: f64,
    libm: fn(f64) -> f64,
    platform: fn(f64) -> f64,
    ours: fn(Width, &[f64]) -> Option<f64>,
}

/// A function of one argument.
trait Function {
    fn value<T: Real>(x: T) -> T;
}

/// Sum of a function's values.
struct Sum<'a, F>(&'a [f64], std::marker::PhantomData<F>);

impl<F: Function> Kernel for Sum<'_, F> {
    type Output = f64;

    #[inline(always)]
    fn run<T: Real>(self) -> f64 {
        let mut sum = T::zero();
        for chunk in self.0.chunks_exact(T::LANES) {
            sum = sum + F::value(T::from_lanes(|i| chunk[i]));
        }
        (0..T::LANES).map(|i| sum.lane(i)).sum()
    }
}

fn ours<F: Function>(width: Width, arguments: &[f64]) -> Option<f64> {
    lanes::run(width, Sum(arguments, std::marker::PhantomData::<F>))
}

/// Rows of functions: name, range of arguments, ours, libm's, the platform's.
macro_rules! rows {
    ($($name:literal $lowest:literal..$highest:literal, |$x:ident| $ours:expr, $libm:expr, $platform:expr;)*) => {
        [$({
            struct It;
            impl Function for It {
                #[inline(always)]
                fn value<T: Real>($x: T) -> T {
                    $ours
                }
            }
            Row { name: $name, lowest: $lowest, highest: $highest, libm: $libm, platform: $platform, ours: ours::<It> }
        }),*]
    };
}

fn main() {
    let rows = rows! {
        "sin" -10.0..10.0, |x| x.sin(), libm::sin, f64::sin;
        "cos" -10.0..10.0, |x| x.cos(), libm::cos, f64::cos;
        "sin_cos" -10.0..10.0, |x| { let (s, c) = x.sin_cos(); s + c }, |x| { let (s, c) = libm::sincos(x); s + c }, |x| { let (s, c) = x.sin_cos(); s + c };
        "tan" -10.0..10.0, |x| x.tan(), libm::tan, f64::tan;
        "exp" -20.0..20.0, |x| x.exp(), libm::exp, f64::exp;
        "ln" 1e-3..1e3, |x| x.ln(), libm::log, f64::ln;
        "sinh" -10.0..10.0, |x| x.sinh(), libm::sinh, f64::sinh;
        "cosh" -10.0..10.0, |x| x.cosh(), libm::cosh, f64::cosh;
        "tanh" -3.0..3.0, |x| x.tanh(), libm::tanh, f64::tanh;
        "asin" -1.0..1.0, |x| x.asin(), libm::asin, f64::asin;
        "acos" -1.0..1.0, |x| x.acos(), libm::acos, f64::acos;
        "atan" -5.0..5.0, |x| x.atan(), libm::atan, f64::atan;
        "atan2(x, 1.7)" -5.0..5.0, |x| x.atan2(T::from_f64(1.7)), |x| libm::atan2(x, 1.7), |x| x.atan2(1.7);
        "pow(x, 1.7)" 0.1..10.0, |x| x.pow(T::from_f64(1.7)), |x| libm::pow(x, 1.7), |x| x.powf(1.7);
    };
    let widths = || Width::ALL.into_iter().filter(|width| width.is_available());
    let lanes: String = widths()
        .skip(1)
        .map(|width| format!(" {} lanes |", width.lanes()))
        .collect();
    println!("| ns per value | libm | platform | ours, scalar |{lanes}");
    println!("|---|---|---|---|{}", "---|".repeat(widths().count() - 1));
    for row in rows {
        print_row(&row, &widths().collect::<Vec<_>>());
    }
}

fn print_row(row: &Row, widths: &[Width]) {
    let span = row.highest - row.lowest;
    // The golden ratio's multiples fill the range evenly and in no order that a branch predictor could learn.
    let arguments: Vec<f64> = (0..COUNT)
        .map(|i| row.lowest + span * (i as f64 * 0.618_033_988_749_895).fract())
        .collect();
    let mut best = vec![f64::INFINITY; 2 + widths.len()];
    for _ in 0..ROUNDS {
        for (column, best) in best.iter_mut().enumerate() {
            let start = Instant::now();
            let arguments = black_box(&arguments[..]);
            black_box(match column {
                0 => Some(arguments.iter().map(|&x| (row.libm)(x)).sum()),
                1 => Some(arguments.iter().map(|&x| (row.platform)(x)).sum()),
                _ => (row.ours)(widths[column - 2], arguments),
            });
            *best = best.min(start.elapsed().as_nanos() as f64 / COUNT as f64);
        }
    }
    let figures: String = best.iter().map(|ns| format!(" {ns:.2} |")).collect();
    println!("| {} |{figures}", row.name);
}
