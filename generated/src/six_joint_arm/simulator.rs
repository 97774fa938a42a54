// SHA-256 of the text below: 477684764e556c1d7e07c697a6b71f6ff6c0fafdb93440163506e34676ca8063
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! `six_joint_arm`: closed loop of controller and plant.
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
pub const HORIZON: f64 = 10.0;

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
    prepared: plant::Prepared<T>,
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
    fn x1(&self) -> Vector<T, 6> {
        Vector([self.x[0], self.x[1], self.x[2], self.x[3], self.x[4], self.x[5]])
    }

    /// State of block 2.
    #[inline(always)]
    fn x2(&self) -> Vector<T, 6> {
        Vector([self.x[6], self.x[7], self.x[8], self.x[9], self.x[10], self.x[11]])
    }
}

impl ClosedLoop for Simulator<f64> {
    const NAME: &'static str = "six_joint_arm";
    const SAMPLE_TIME: f64 = SAMPLE_TIME;
    const OUTPUTS: &'static [&'static str] = &["q1", "q2", "q3", "q4", "q5", "q6"];
    const INPUTS: &'static [&'static str] = &["u1", "u2", "u3", "u4", "u5", "u6"];
    const SIGNALS: &'static [&'static str] = &[
        "t",
        "x1.q1",
        "x1.q2",
        "x1.q3",
        "x1.q4",
        "x1.q5",
        "x1.q6",
        "error.q1",
        "error.q2",
        "error.q3",
        "error.q4",
        "error.q5",
        "error.q6",
        "e1.q1",
        "e1.q2",
        "e1.q3",
        "e1.q4",
        "e1.q5",
        "e1.q6",
        "k1",
        "ratio1",
        "alpha1.v1",
        "alpha1.v2",
        "alpha1.v3",
        "alpha1.v4",
        "alpha1.v5",
        "alpha1.v6",
        "h1.v1",
        "h1.v2",
        "h1.v3",
        "h1.v4",
        "h1.v5",
        "h1.v6",
        "x2.v1",
        "x2.v2",
        "x2.v3",
        "x2.v4",
        "x2.v5",
        "x2.v6",
        "e2.v1",
        "e2.v2",
        "e2.v3",
        "e2.v4",
        "e2.v5",
        "e2.v6",
        "d2.v1",
        "d2.v2",
        "d2.v3",
        "d2.v4",
        "d2.v5",
        "d2.v6",
        "D_hat2.v1",
        "D_hat2.v2",
        "D_hat2.v3",
        "D_hat2.v4",
        "D_hat2.v5",
        "D_hat2.v6",
        "y_r.q1",
        "y_r.q2",
        "y_r.q3",
        "y_r.q4",
        "y_r.q5",
        "y_r.q6",
        "u.u1",
        "u.u2",
        "u.u3",
        "u.u4",
        "u.u5",
        "u.u6",
        "u_sat.u1",
        "u_sat.u2",
        "u_sat.u3",
        "u_sat.u4",
        "u_sat.u5",
        "u_sat.u6",
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
        controller
            .reset(
                T::zero(),
                Vector([x[0], x[1], x[2], x[3], x[4], x[5]]),
                Vector([x[6], x[7], x[8], x[9], x[10], x[11]]),
            );
        let state = *controller.state();
        Self {
            prepared: plant::prepare(&truth),
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
        self.output = self.controller.step_at(t, &clock, self.x1(), self.x2());
    }

    #[inline(always)]
    fn advance(&mut self) {
        let plant = Plant {
            params: self.truth,
            prepared: self.prepared,
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
        let rate = plant::plant(t, self.x, law.u_sat, &self.truth);
        let lyapunov = if T::IS_SCALAR {
            lyapunov::lyapunov(
                t,
                x1,
                x2,
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
            x1[1],
            x1[2],
            x1[3],
            x1[4],
            x1[5],
            (x1 - law.y_r)[0],
            (x1 - law.y_r)[1],
            (x1 - law.y_r)[2],
            (x1 - law.y_r)[3],
            (x1 - law.y_r)[4],
            (x1 - law.y_r)[5],
            law.e1[0],
            law.e1[1],
            law.e1[2],
            law.e1[3],
            law.e1[4],
            law.e1[5],
            law.k1,
            (x1 - law.y_r).sum_squares().sqrt() / law.k1,
            law.alpha1[0],
            law.alpha1[1],
            law.alpha1[2],
            law.alpha1[3],
            law.alpha1[4],
            law.alpha1[5],
            self.state.h1[0],
            self.state.h1[1],
            self.state.h1[2],
            self.state.h1[3],
            self.state.h1[4],
            self.state.h1[5],
            x2[0],
            x2[1],
            x2[2],
            x2[3],
            x2[4],
            x2[5],
            law.e2[0],
            law.e2[1],
            law.e2[2],
            law.e2[3],
            law.e2[4],
            law.e2[5],
            rate.d2[0],
            rate.d2[1],
            rate.d2[2],
            rate.d2[3],
            rate.d2[4],
            rate.d2[5],
            law.D_hat2[0],
            law.D_hat2[1],
            law.D_hat2[2],
            law.D_hat2[3],
            law.D_hat2[4],
            law.D_hat2[5],
            law.y_r[0],
            law.y_r[1],
            law.y_r[2],
            law.y_r[3],
            law.y_r[4],
            law.y_r[5],
            law.u[0],
            law.u[1],
            law.u[2],
            law.u[3],
            law.u[4],
            law.u[5],
            law.u_sat[0],
            law.u_sat[1],
            law.u_sat[2],
            law.u_sat[3],
            law.u_sat[4],
            law.u_sat[5],
            lyapunov.V,
            lyapunov.LV,
        ];
        row.copy_from_slice(&values);
    }

    #[inline(always)]
    fn constraint_ratio(&self) -> T {
        (self.x1() - self.output.y_r).sum_squares().sqrt() / self.output.k1
    }

    #[inline(always)]
    fn tracking_error(&self, error: &mut [T]) {
        error.copy_from_slice(&(self.x1() - self.output.y_r).0);
    }

    #[inline(always)]
    fn saturated(&self, saturated: &mut [T::Mask]) {
        saturated
            .copy_from_slice(
                &[
                    self.output.u[0].ne(self.output.u_sat[0]),
                    self.output.u[1].ne(self.output.u_sat[1]),
                    self.output.u[2].ne(self.output.u_sat[2]),
                    self.output.u[3].ne(self.output.u_sat[3]),
                    self.output.u[4].ne(self.output.u_sat[4]),
                    self.output.u[5].ne(self.output.u_sat[5]),
                ],
            );
    }

    #[inline(always)]
    fn is_finite(&self) -> T::Mask {
        self.output.valid.and(self.x.is_finite())
    }
}
