// SHA-256 of the text below: 412d5664042c9af667ae8451317e6abcd9fb17a5807ca6664c69bb9741bd544f
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! `underwater_vehicle`: closed loop of controller and plant.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::controller;
use super::controller::{Controller, Output, SAMPLE_TIME, State};
use super::lyapunov;
use super::params::Params;
use super::plant;
use super::plant::{INITIAL_STATE, NOISE_CHANNELS, Plant, STATES};
use nsv_runtime::ahead::Ahead;
use nsv_runtime::closed_loop::{ClosedLoop, Options, Runs};
use nsv_runtime::linear::Vector;
use nsv_runtime::noise::Noise;
use nsv_runtime::real::{Mask, Real};
use nsv_runtime::sde;
use nsv_runtime::sde::Scheme;

/// Length of a run, s.
pub const HORIZON: f64 = 40.0;

/// Plant steps per sample.
pub const SUBSTEPS: u32 = 4;

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
    plant_clock: Ahead<plant::Clock<T>>,
    noise: Option<Noise<T>>,
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

    /// Exosystem states of block 2.
    #[inline(always)]
    fn w2(&self) -> Vector<T, 12> {
        Vector([
            self.x[12],
            self.x[13],
            self.x[14],
            self.x[15],
            self.x[16],
            self.x[17],
            self.x[18],
            self.x[19],
            self.x[20],
            self.x[21],
            self.x[22],
            self.x[23],
        ])
    }

    /// Standard normal draws of all channels; zeros in a run without noise.
    #[inline(always)]
    fn draw(&self, step: u64) -> Vector<T, NOISE_CHANNELS> {
        match &self.noise {
            Some(noise) => noise.normals(step),
            None => Vector::zero(),
        }
    }
}

impl ClosedLoop for Simulator<f64> {
    const NAME: &'static str = "underwater_vehicle";
    const SAMPLE_TIME: f64 = SAMPLE_TIME;
    const OUTPUTS: &'static [&'static str] = &[
        "north",
        "east",
        "down",
        "phi",
        "theta",
        "psi",
    ];
    const INPUTS: &'static [&'static str] = &["F_x", "F_y", "F_z", "M_x", "M_y", "M_z"];
    const SIGNALS: &'static [&'static str] = &[
        "t",
        "x1.north",
        "x1.east",
        "x1.down",
        "x1.phi",
        "x1.theta",
        "x1.psi",
        "error.north",
        "error.east",
        "error.down",
        "error.phi",
        "error.theta",
        "error.psi",
        "e1.north",
        "e1.east",
        "e1.down",
        "e1.phi",
        "e1.theta",
        "e1.psi",
        "k1",
        "ratio1",
        "alpha1.surge",
        "alpha1.sway",
        "alpha1.heave",
        "alpha1.p",
        "alpha1.q",
        "alpha1.r",
        "h1.surge",
        "h1.sway",
        "h1.heave",
        "h1.p",
        "h1.q",
        "h1.r",
        "d1.north",
        "d1.east",
        "d1.down",
        "d1.phi",
        "d1.theta",
        "d1.psi",
        "D_hat1.north",
        "D_hat1.east",
        "D_hat1.down",
        "D_hat1.phi",
        "D_hat1.theta",
        "D_hat1.psi",
        "x2.surge",
        "x2.sway",
        "x2.heave",
        "x2.p",
        "x2.q",
        "x2.r",
        "e2.surge",
        "e2.sway",
        "e2.heave",
        "e2.p",
        "e2.q",
        "e2.r",
        "d2.surge",
        "d2.sway",
        "d2.heave",
        "d2.p",
        "d2.q",
        "d2.r",
        "D_hat2.surge",
        "D_hat2.sway",
        "D_hat2.heave",
        "D_hat2.p",
        "D_hat2.q",
        "D_hat2.r",
        "y_r.north",
        "y_r.east",
        "y_r.down",
        "y_r.phi",
        "y_r.theta",
        "y_r.psi",
        "u.F_x",
        "u.F_y",
        "u.F_z",
        "u.M_x",
        "u.M_y",
        "u.M_z",
        "u_sat.F_x",
        "u_sat.F_y",
        "u_sat.F_z",
        "u_sat.M_x",
        "u_sat.M_y",
        "u_sat.M_z",
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
        let process = Noise::process(options.seed, options.run);
        Self {
            prepared: plant::prepare(&truth),
            controller,
            truth,
            x,
            state,
            output: Output::zero(),
            sample: 0,
            clock: Ahead::new(sample_time),
            plant_clock: Ahead::new(step_time),
            noise: options.noise.then_some(process),
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

    /// Platen's scheme: no state changes the diffusion, so that its correction is 0 and the scheme
    /// of Euler and Maruyama is of strong order 1 too.
    #[inline(always)]
    fn advance(&mut self) {
        let plant = Plant {
            params: self.truth,
            prepared: self.prepared,
            u_sat: self.output.u_sat,
        };
        for substep in 0..SUBSTEPS {
            let step = self.sample * u64::from(SUBSTEPS) + u64::from(substep);
            let at = self.plant_clock.at(step, step_time);
            let dw = self.draw(step) * T::from_f64(SUBSTEP).sqrt();
            self.x = sde::step(
                Scheme::EulerMaruyama,
                &plant,
                [&at; 3],
                &self.x,
                SUBSTEP,
                &dw,
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
                self.w2(),
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
            rate.d1[0],
            rate.d1[1],
            rate.d1[2],
            rate.d1[3],
            rate.d1[4],
            rate.d1[5],
            law.D_hat1[0],
            law.D_hat1[1],
            law.D_hat1[2],
            law.D_hat1[3],
            law.D_hat1[4],
            law.D_hat1[5],
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
