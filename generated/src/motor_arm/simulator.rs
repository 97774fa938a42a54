// SHA-256 of the text below: cf3e62ffe7ef4cef0609aa9ba69910f8999bb72f0a735356252db8dcd74598fb
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 eaec085705702921007be8e6ce482fe8ff0bdc8ba32b44e358ef4f3b85103df7

//! `motor_arm`: closed loop of controller and plant.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::controller::{Controller, Output, SAMPLE_TIME, State};
use super::lyapunov;
use super::params::Params;
use super::plant;
use super::plant::{INITIAL_STATE, NOISE_CHANNELS, Plant, STATES};
use nsv_runtime::closed_loop::{ClosedLoop, Options};
use nsv_runtime::linear::Vector;
use nsv_runtime::noise::Noise;
use nsv_runtime::real::Real;
use nsv_runtime::sde;
use nsv_runtime::sde::Scheme;
use nsv_runtime::status::Status;

/// Length of a run, s.
pub const HORIZON: f64 = 10.0;

/// Plant steps per sample.
pub const SUBSTEPS: u32 = 4;

/// Length of a plant step, s.
pub const SUBSTEP: f64 = SAMPLE_TIME / SUBSTEPS as f64;

/// One run of controller and plant.
#[derive(Clone, Debug)]
pub struct Simulator {
    controller: Controller<f64>,
    truth: Params<f64>,
    x: Vector<f64, STATES>,
    state: State<f64>,
    output: Output<f64>,
    sample: u64,
    noise: Option<Noise>,
}

impl Simulator {
    /// Time of the sample, s.
    pub fn time(&self) -> f64 {
        self.sample as f64 * SAMPLE_TIME
    }

    /// The plant's parameters in this run.
    pub fn params(&self) -> &Params<f64> {
        &self.truth
    }

    /// The plant's state.
    pub fn state(&self) -> &Vector<f64, STATES> {
        &self.x
    }

    /// Output of the controller at the sample.
    pub fn output(&self) -> &Output<f64> {
        &self.output
    }

    /// State of block 1.
    fn x1(&self) -> Vector<f64, 1> {
        Vector([self.x[0]])
    }

    /// State of block 2.
    fn x2(&self) -> Vector<f64, 1> {
        Vector([self.x[1]])
    }

    /// State of block 3.
    fn x3(&self) -> Vector<f64, 1> {
        Vector([self.x[2]])
    }

    /// Exosystem states of block 2.
    fn w2(&self) -> Vector<f64, 1> {
        Vector([self.x[3]])
    }

    /// Standard normal draws of all channels; zeros in a run without noise.
    fn draw(&self, step: u64) -> Vector<f64, NOISE_CHANNELS> {
        match &self.noise {
            Some(noise) => Vector([noise.normal(step, 0), noise.normal(step, 1)]),
            None => Vector::zero(),
        }
    }
}

impl ClosedLoop for Simulator {
    const NAME: &'static str = "motor_arm";
    const SAMPLE_TIME: f64 = SAMPLE_TIME;
    const OUTPUTS: &'static [&'static str] = &["angle"];
    const INPUTS: &'static [&'static str] = &["voltage"];
    const SIGNALS: &'static [&'static str] = &[
        "t",
        "x1.angle",
        "e1.angle",
        "k1",
        "ratio1",
        "alpha1.rate",
        "h1.rate",
        "x2.rate",
        "e2.rate",
        "alpha2.amps",
        "h2.amps",
        "d2.rate",
        "D_hat2.rate",
        "x3.amps",
        "e3.amps",
        "d3.amps",
        "D_hat3.amps",
        "y_r.angle",
        "u.voltage",
        "u_sat.voltage",
        "V",
        "LV",
    ];

    fn new(options: &Options) -> Self {
        let truth = if options.dispersion {
            Params::dispersed(&Noise::dispersion(options.seed, options.run))
        } else {
            Params::plant()
        };
        let x = Vector(INITIAL_STATE);
        let mut controller = Controller::new(Params::design());
        controller.reset(0.0, Vector([x[0]]), Vector([x[1]]), Vector([x[2]]));
        let state = *controller.state();
        let output = controller
            .clone()
            .step(0.0, Vector([x[0]]), Vector([x[1]]), Vector([x[2]]));
        let process = Noise::process(options.seed, options.run);
        Self {
            controller,
            truth,
            x,
            state,
            output,
            sample: 0,
            noise: options.noise.then_some(process),
        }
    }

    fn control(&mut self) -> Status {
        self.state = *self.controller.state();
        self.output = self.controller.step(self.time(), self.x1(), self.x2(), self.x3());
        self.output.status
    }

    fn advance(&mut self) {
        let plant = Plant {
            params: self.truth,
            u_sat: self.output.u_sat,
        };
        for substep in 0..SUBSTEPS {
            let t = self.time() + f64::from(substep) * SUBSTEP;
            let step = self.sample * u64::from(SUBSTEPS) + u64::from(substep);
            let dw = self.draw(step) * Real::sqrt(SUBSTEP);
            self.x = sde::step(Scheme::Platen, &plant, t, &self.x, SUBSTEP, &dw);
        }
        self.sample += 1;
    }

    fn telemetry(&self, row: &mut [f64]) {
        let (t, law) = (self.time(), &self.output);
        let x1 = self.x1();
        let x2 = self.x2();
        let x3 = self.x3();
        let rate = plant::plant(t, self.x, law.u_sat, &self.truth);
        let lyapunov = lyapunov::lyapunov(
            t,
            x1,
            x2,
            x3,
            self.w2(),
            &self.state,
            self.controller.params(),
            &self.truth,
        );
        let values = [
            t,
            x1[0],
            law.e1[0],
            law.k1,
            Real::sqrt(law.e1.sum_squares()) / law.k1,
            law.alpha1[0],
            self.state.h1[0],
            x2[0],
            law.e2[0],
            law.alpha2[0],
            self.state.h2[0],
            rate.d2[0],
            law.D_hat2[0],
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
        for (entry, value) in row.iter_mut().zip(values) {
            *entry = value;
        }
    }

    fn constraint_ratio(&self) -> f64 {
        Real::sqrt(self.output.e1.sum_squares()) / self.output.k1
    }

    fn tracking_error(&self, error: &mut [f64]) {
        for (entry, value) in error.iter_mut().zip((self.x1() - self.output.y_r).0) {
            *entry = value;
        }
    }

    fn saturated(&self, saturated: &mut [bool]) {
        for (entry, (u, u_sat)) in saturated
            .iter_mut()
            .zip(self.output.u.0.into_iter().zip(self.output.u_sat.0))
        {
            *entry = u != u_sat;
        }
    }

    fn is_finite(&self) -> bool {
        let valid = !self.output.status.contains(Status::NON_FINITE_INPUT);
        valid && self.x.is_finite() && self.controller.state().is_finite()
    }
}
