// SHA-256 of the text below: 3093551578de59b84dbd72283cbe2f71aba22a3c727a3a6306eb9048d5f057ae
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! `chaotic_jerk`: closed loop of controller and plant.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::controller;
use super::controller::{Controller, Output, SAMPLE_TIME, State};
use super::lyapunov;
use super::params::Params;
use super::plant;
use super::plant::{INITIAL_STATE, Plant, STATES};
use nsv_runtime::ahead::{Ahead, Stages};
use nsv_runtime::closed_loop::{ClosedLoop, Options, Runs};
use nsv_runtime::linear::Vector;
use nsv_runtime::noise::Noise;
use nsv_runtime::real::{Mask, Real};
use nsv_runtime::sde;
use nsv_runtime::sde::Scheme;

/// Length of a run, s.
pub const HORIZON: f64 = 30.0;

/// Plant steps per sample.
pub const SUBSTEPS: u32 = 2;

/// Length of a plant step, s.
pub const SUBSTEP: f64 = SAMPLE_TIME / SUBSTEPS as f64;

/// Time of a sample, s.
#[inline(always)]
fn sample_time(sample: u64) -> f64 {
    sample as f64 * SAMPLE_TIME
}

/// Time of a step of the plant, s.
#[inline(always)]
fn step_time(step: u64) -> f64 {
    let (sample, substep) = (step / u64::from(SUBSTEPS), step % u64::from(SUBSTEPS));
    sample_time(sample) + substep as f64 * SUBSTEP
}

/// Runs of controller and plant, one in each lane.
#[derive(Clone, Debug)]
pub struct Simulator<T: Real = f64> {
    controller: Controller<T>,
    truth: Params<T>,
    x: Vector<T, STATES>,
    state: State<T>,
    output: Output<T>,
    sample: u64,
    clock: Ahead<controller::Clock<T>>,
    plant_clock: Stages<plant::Clock<T>>,
}

impl<T: Real> Simulator<T> {
    /// Time of the sample, s.
    #[inline(always)]
    pub fn time(&self) -> f64 {
        sample_time(self.sample)
    }

    /// The plant's parameters in this run.
    #[inline(always)]
    pub fn params(&self) -> &Params<T> {
        &self.truth
    }

    /// The plant's state.
    #[inline(always)]
    pub fn state(&self) -> &Vector<T, STATES> {
        &self.x
    }

    /// Output of the controller at the sample.
    #[inline(always)]
    pub fn output(&self) -> &Output<T> {
        &self.output
    }

    /// State of block 1.
    #[inline(always)]
    fn x1(&self) -> Vector<T, 1> {
        Vector([self.x[0]])
    }

    /// State of block 2.
    #[inline(always)]
    fn x2(&self) -> Vector<T, 1> {
        Vector([self.x[1]])
    }

    /// State of block 3.
    #[inline(always)]
    fn x3(&self) -> Vector<T, 1> {
        Vector([self.x[2]])
    }
}

impl ClosedLoop for Simulator<f64> {
    const NAME: &'static str = "chaotic_jerk";
    const SAMPLE_TIME: f64 = SAMPLE_TIME;
    const OUTPUTS: &'static [&'static str] = &["x"];
    const INPUTS: &'static [&'static str] = &["force"];
    const SIGNALS: &'static [&'static str] = &[
        "t",
        "x1.x",
        "error.x",
        "e1.x",
        "alpha1.v",
        "x2.v",
        "e2.v",
        "alpha2.w",
        "x3.w",
        "e3.w",
        "d3.w",
        "D_hat3.w",
        "y_r.x",
        "u.force",
        "u_sat.force",
        "V",
        "LV",
    ];
    type Runs<T: Real> = Simulator<T>;
}
impl<T: Real> Runs<T> for Simulator<T> {
    #[inline(always)]
    fn new(options: &Options) -> Self {
        let truth = if options.dispersion {
            Params::dispersed(&Noise::dispersion(options.seed, options.run))
        } else {
            Params::plant()
        };
        let x = Vector::from_f64(INITIAL_STATE);
        let mut controller = Controller::new(Params::design());
        controller.reset(T::zero(), Vector([x[0]]), Vector([x[1]]), Vector([x[2]]));
        let state = *controller.state();
        Self {
            controller,
            truth,
            x,
            state,
            output: Output::zero(),
            sample: 0,
            clock: Ahead::new(sample_time),
            plant_clock: Stages::new(step_time, SUBSTEP),
        }
    }

    #[inline(always)]
    fn observe(&mut self) {
        self.state = *self.controller.state();
    }

    #[inline(always)]
    fn control(&mut self) {
        let t = T::from_f64(self.time());
        let clock = self.clock.at(self.sample, sample_time);
        self.output = self
            .controller
            .step_at(t, &clock, self.x1(), self.x2(), self.x3());
    }

    #[inline(always)]
    fn advance(&mut self) {
        let plant = Plant {
            params: self.truth,
            u_sat: self.output.u_sat,
        };
        for substep in 0..SUBSTEPS {
            let step = self.sample * u64::from(SUBSTEPS) + u64::from(substep);
            let at = self.plant_clock.at(step, step_time, SUBSTEP);
            self.x = sde::step(
                Scheme::RungeKutta4,
                &plant,
                at.each_ref(),
                &self.x,
                SUBSTEP,
                &Vector([]),
            );
        }
        self.sample += 1;
    }

    #[inline(always)]
    fn telemetry(&self, row: &mut [T]) {
        let (t, law) = (T::from_f64(self.time()), &self.output);
        let x1 = self.x1();
        let x2 = self.x2();
        let x3 = self.x3();
        let rate = plant::plant(t, self.x, law.u_sat, &self.truth);
        let lyapunov = if T::IS_SCALAR {
            lyapunov::lyapunov(
                t,
                x1,
                x2,
                x3,
                &self.state,
                self.controller.params(),
                &self.truth,
            )
        } else {
            lyapunov::LyapunovOutputs {
                V: T::from_f64(f64::NAN),
                LV: T::from_f64(f64::NAN),
            }
        };
        let values = [
            t,
            x1[0],
            (x1 - law.y_r)[0],
            law.e1[0],
            law.alpha1[0],
            x2[0],
            law.e2[0],
            law.alpha2[0],
            x3[0],
            law.e3[0],
            rate.d3[0],
            law.D_hat3[0],
            law.y_r[0],
            law.u[0],
            law.u_sat[0],
            lyapunov.V,
            lyapunov.LV,
        ];
        row.copy_from_slice(&values);
    }

    #[inline(always)]
    fn constraint_ratio(&self) -> T {
        T::from_f64(f64::NAN)
    }

    #[inline(always)]
    fn tracking_error(&self, error: &mut [T]) {
        error.copy_from_slice(&(self.x1() - self.output.y_r).0);
    }

    #[inline(always)]
    fn saturated(&self, saturated: &mut [T::Mask]) {
        saturated.copy_from_slice(&[self.output.u[0].ne(self.output.u_sat[0])]);
    }

    #[inline(always)]
    fn is_finite(&self) -> T::Mask {
        self.output.valid.and(self.x.is_finite())
    }
}
