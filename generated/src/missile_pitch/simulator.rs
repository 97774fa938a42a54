// SHA-256 of the text below: 19b4a8c6328b66f3048d54c300912d99949d62212a984a5ecb69f30688a1d3d4
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! `missile_pitch`: closed loop of controller and plant.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::controller;
use super::controller::{Controller, Output, SAMPLE_TIME, State};
use super::params::Params;
use super::plant;
use super::plant::{INITIAL_STATE, Plant, STATES};
use nsv_runtime::actuator::Actuator;
use nsv_runtime::ahead::{Ahead, Stages};
use nsv_runtime::closed_loop::{ClosedLoop, Options, Runs};
use nsv_runtime::linear::Vector;
use nsv_runtime::noise::Noise;
use nsv_runtime::real::{Mask, Real};
use nsv_runtime::sde;
use nsv_runtime::sde::Scheme;
use nsv_runtime::sensor::{Draws, Sensor};

/// Length of a run, s.
pub const HORIZON: f64 = 5.0;

/// Plant steps per sample.
pub const SUBSTEPS: u32 = 2;

/// Length of a plant step, s.
pub const SUBSTEP: f64 = SAMPLE_TIME / SUBSTEPS as f64;

/// Actuators of `delta`, after their delays.
const ACTUATORS: [Actuator; 1] = [
    Actuator {
        quantum: 0.0,
        approach: 0.09971330538047685,
        travel: 0.005235987755982989,
        faults: &[],
    },
];

/// Sensors of `alpha`, `q`.
const SENSORS: [Sensor; 2] = [
    Sensor {
        noise: 0.00034906585039886593,
        quantum: 0.0,
        dropout: 0.0,
    },
    Sensor {
        noise: 0.0008726646259971648,
        quantum: 0.0,
        dropout: 0.0,
    },
];

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
    position: Vector<T, 1>,
    u_act: Vector<T, 1>,
    bias: Vector<T, 2>,
    y: Vector<T, 2>,
    errors: Option<Noise<T>>,
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

    /// Measured state of block 1.
    #[inline(always)]
    fn y1(&self) -> Vector<T, 1> {
        Vector([self.y[0]])
    }

    /// State of block 2.
    #[inline(always)]
    fn x2(&self) -> Vector<T, 1> {
        Vector([self.x[1]])
    }

    /// Measured state of block 2.
    #[inline(always)]
    fn y2(&self) -> Vector<T, 1> {
        Vector([self.y[1]])
    }

    /// What the actuators make of the command over the plant step that starts at time `t`.
    #[inline(always)]
    fn actuate(&mut self, t: f64) -> Vector<T, 1> {
        let command = self.output.u_sat;
        self.position[0] = ACTUATORS[0].step(t, command[0], self.position[0]);
        self.u_act = Vector([ACTUATORS[0].effect(t, self.position[0])]);
        self.u_act
    }

    /// What the sensors make of the state at the sample.
    #[inline(always)]
    fn measure(&mut self) {
        let draws = Draws::of_all::<2>(&self.errors, self.sample);
        self.y = Vector([
            SENSORS[0].measure(self.x[0], self.bias[0], draws[0], self.y[0]),
            SENSORS[1].measure(self.x[1], self.bias[1], draws[1], self.y[1]),
        ]);
    }
}

impl ClosedLoop for Simulator<f64> {
    const NAME: &'static str = "missile_pitch";
    const SAMPLE_TIME: f64 = SAMPLE_TIME;
    const OUTPUTS: &'static [&'static str] = &["alpha"];
    const INPUTS: &'static [&'static str] = &["delta"];
    const SIGNALS: &'static [&'static str] = &[
        "t",
        "x1.alpha",
        "error.alpha",
        "e1.alpha",
        "k1",
        "ratio1",
        "alpha1.q",
        "h1.q",
        "d1.alpha",
        "D_hat1.alpha",
        "x2.q",
        "e2.q",
        "d2.q",
        "D_hat2.q",
        "y_r.alpha",
        "u.delta",
        "u_sat.delta",
        "y.alpha",
        "y.q",
        "u_act.delta",
        "truth.mach_now",
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
        let x = if options.dispersion {
            plant::dispersed_state(&Noise::dispersion(options.seed, options.run))
        } else {
            Vector::from_f64(INITIAL_STATE)
        };
        let controller = Controller::new(Params::design());
        let state = *controller.state();
        let mut runs = Self {
            controller,
            truth,
            x,
            state,
            output: Output::zero(),
            sample: 0,
            clock: Ahead::new(sample_time),
            plant_clock: Stages::new(step_time, SUBSTEP),
            position: Vector([T::from_f64(0.0)]),
            u_act: Vector([T::from_f64(0.0)]),
            bias: if options.dispersion {
                let noise = Noise::dispersion(options.seed, options.run);
                Vector([
                    T::from_f64(0.0)
                        + T::from_f64(0.0008726646259971648) * noise.normal(0, 6),
                    T::from_f64(0.0),
                ])
            } else {
                Vector([T::from_f64(0.0), T::from_f64(0.0)])
            },
            y: Vector([x[0], x[1]]),
            errors: options.noise.then_some(Noise::sensor(options.seed, options.run)),
        };
        runs.measure();
        runs.controller.reset(T::zero(), Vector([runs.y[0]]), Vector([runs.y[1]]));
        runs
    }

    #[inline(always)]
    fn observe(&mut self) {
        self.state = *self.controller.state();
    }

    #[inline(always)]
    fn control(&mut self) {
        let t = T::from_f64(self.time());
        self.measure();
        let clock = self.clock.at(self.sample, sample_time);
        self.output = self.controller.step_at(t, &clock, self.y1(), self.y2());
    }

    #[inline(always)]
    fn advance(&mut self) {
        for substep in 0..SUBSTEPS {
            let step = self.sample * u64::from(SUBSTEPS) + u64::from(substep);
            let plant = Plant {
                params: self.truth,
                u_sat: self.actuate(step_time(step)),
            };
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
        let values = [
            t,
            x1[0],
            (x1 - law.y_r)[0],
            law.e1[0],
            law.k1,
            (x1 - law.y_r).sum_squares().sqrt() / law.k1,
            law.alpha1[0],
            self.state.h1[0],
            rate.d1[0],
            law.D_hat1[0],
            x2[0],
            law.e2[0],
            rate.d2[0],
            law.D_hat2[0],
            law.y_r[0],
            law.u[0],
            law.u_sat[0],
            self.y[0],
            self.y[1],
            self.u_act[0],
            self.x[2],
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
        saturated.copy_from_slice(&[self.output.u[0].ne(self.output.u_sat[0])]);
    }

    #[inline(always)]
    fn is_finite(&self) -> T::Mask {
        self.output.valid.and(self.x.is_finite())
    }
}
