//! `nsv-instructions`: prints the generated modules. `nsv-instructions MODULE LANES SAMPLES`: runs the closed loop of one.
//!
//! Each sample is the controller's step and the plant's step of the module's own scheme with noise, as the ensemble engine calls them.

use std::env;
use std::hint::black_box;
use std::marker::PhantomData;
use std::process::ExitCode;

use nsv_runtime::closed_loop::{ClosedLoop, Options, Runs};
use nsv_runtime::lanes::{self, Kernel, Width};
use nsv_runtime::real::{Mask, Real};

include!(concat!(env!("OUT_DIR"), "/modules.rs"));

/// Runs of one closed loop in lanes, and whether all of them stay finite.
struct Loop<L> {
    samples: u64,
    closed_loop: PhantomData<L>,
}

impl<L: ClosedLoop> Kernel for Loop<L> {
    type Output = bool;

    #[inline(always)]
    fn run<T: Real>(self) -> bool {
        let mut runs = L::Runs::<T>::new(&Options {
            seed: 1,
            run: 0,
            noise: true,
            // Unknown to the compiler, so that the program has all parts of a run.
            dispersion: black_box(false),
        });
        for _ in 0..self.samples {
            runs.control();
            runs.advance();
        }
        black_box(&runs).is_finite().all()
    }
}

fn run<L: ClosedLoop>(width: Width, samples: u64) -> bool {
    let closed_loop = PhantomData;
    lanes::run(
        width,
        Loop::<L> {
            samples,
            closed_loop,
        },
    )
    .unwrap_or(false)
}

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [module, lanes, samples] = arguments.as_slice() else {
        println!("{}", MODULES.join("\n"));
        return ExitCode::SUCCESS;
    };
    let width = Width::ALL
        .into_iter()
        .find(|width| width.lanes().to_string() == *lanes);
    let done = width
        .zip(samples.parse().ok())
        .is_some_and(|(width, samples)| measure(module, width, samples));
    ExitCode::from(u8::from(!done))
}
