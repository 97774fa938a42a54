//! A closed loop whose controller and plant are programs, interpreted: what a specification does before any code is emitted.

use nsv_codegen::ir::Values;
use nsv_codegen::ir::eval::Evaluator;
use nsv_codegen::lower::Programs;
use nsv_codegen::opt::optimise;
use nsv_runtime::noise::Noise;
use nsv_spec::model::{Model, NoiseModel};

/// What a run showed.
#[derive(Clone, Debug)]
pub struct Run {
    /// Largest `||y - y_r|| / k_1`; 0 without a constraint.
    pub ratio: f64,
    /// Root mean square of `y - y_r` after the settling time, over channels and samples.
    pub rms: f64,
    /// Whether every control was finite.
    pub finite: bool,
}

/// Simulates the scenario of a specification with nominal parameters; without a seed, without noise. Fourth-order Runge-Kutta, or
/// Euler-Maruyama with Wiener noise.
pub fn run(model: &Model, programs: &Programs, seed: Option<u64>) -> Run {
    let (initial, control, plant) = (
        optimise(programs.initial.clone()),
        optimise(programs.control.clone()),
        optimise(programs.plant.clone()),
    );
    let mut plant = Plant {
        model,
        program: Evaluator::new(&plant),
        noise: seed.map(|seed| Noise::process(seed, 0)),
    };
    let mut control = Evaluator::new(&control);
    let dt = model.controller.sample_time;
    let samples = (model.scenario.horizon / dt).round() as u64;
    let mut x = initial_state(model);
    let mut values = parameters(model);
    measure(model, &mut values, 0.0, &x);
    let start = nsv_codegen::ir::eval::eval(&initial, &values).unwrap();
    values.extend(
        start
            .into_iter()
            .map(|(name, value)| (format!("state.{name}"), value)),
    );
    let (mut ratio, mut squares, mut count, mut finite) = (0.0_f64, 0.0, 0, true);
    for sample in 0..=samples {
        let t = sample as f64 * dt;
        measure(model, &mut values, t, &x);
        control.run(&values).unwrap();
        let outputs = control.outputs();
        let norm = |values: &[f64]| libm::sqrt(values.iter().map(|value| value * value).sum());
        if let Some(k) = outputs.get("k1") {
            let error = x.iter().zip(&outputs["y_r"]).map(|(y, y_r)| y - y_r);
            ratio = ratio.max(norm(&error.collect::<Vec<f64>>()) / k[0]);
        }
        if t >= model.scenario.settle {
            let errors = x
                .iter()
                .zip(&outputs["y_r"])
                .map(|(y, y_r)| (y - y_r) * (y - y_r));
            squares += errors.sum::<f64>();
            count += model.inputs.len();
        }
        finite &= outputs["u"].iter().all(|value| value.is_finite());
        if !finite {
            break;
        }
        plant.advance(sample, t, &mut x, &outputs["u_sat"]);
        values.extend(outputs.into_iter().filter_map(|(name, value)| {
            Some((format!("state.{}", name.strip_prefix("next.")?), value))
        }));
    }
    Run {
        ratio,
        rms: libm::sqrt(squares / count as f64),
        finite,
    }
}

/// Packed initial state of the plant.
fn initial_state(model: &Model) -> Vec<f64> {
    use nsv_spec::model::Disturbance::Exosystem;
    let states = model
        .blocks
        .iter()
        .flat_map(|block| block.states.iter().map(|state| state.initial));
    let exosystems = model
        .blocks
        .iter()
        .flat_map(|block| match &block.disturbance {
            Exosystem(systems) => systems
                .iter()
                .flat_map(|system| system.initial.clone())
                .collect(),
            _ => Vec::new(),
        });
    states.chain(exosystems).collect()
}

/// Design parameters.
fn parameters(model: &Model) -> Values {
    model
        .parameters
        .iter()
        .map(|parameter| {
            (
                format!("params.{}", parameter.name),
                vec![parameter.design_value],
            )
        })
        .collect()
}

/// Sets time and measurements.
fn measure(model: &Model, values: &mut Values, t: f64, x: &[f64]) {
    values.insert("t".into(), vec![t]);
    for (i, measured) in (1..=model.blocks.len()).zip(x.chunks(model.inputs.len())) {
        values.insert(format!("x{i}"), measured.to_vec());
    }
}

struct Plant<'m, 'p> {
    model: &'m Model,
    program: Evaluator<'p>,
    noise: Option<Noise>,
}

impl Plant<'_, '_> {
    /// Moves the state over a sample.
    fn advance(&mut self, sample: u64, t: f64, x: &mut Vec<f64>, u_sat: &[f64]) {
        let substeps = self.model.scenario.substeps;
        let h = self.model.controller.sample_time / f64::from(substeps);
        for substep in 0..substeps {
            let t = t + f64::from(substep) * h;
            let step = sample * u64::from(substeps) + u64::from(substep);
            *x = match (self.model.scenario.noise, self.noise) {
                (NoiseModel::Wiener, Some(noise)) => {
                    self.euler_maruyama(t, x, u_sat, h, |channel| {
                        libm::sqrt(h) * noise.normal(step, channel)
                    })
                }
                (NoiseModel::Sampled, Some(noise)) => {
                    self.runge_kutta(t, x, u_sat, h, |channel| noise.normal(sample, channel))
                }
                (_, None) => self.runge_kutta(t, x, u_sat, h, |_| 0.0),
            };
        }
    }

    fn euler_maruyama(
        &mut self,
        t: f64,
        x: &[f64],
        u_sat: &[f64],
        h: f64,
        increment: impl Fn(u32) -> f64,
    ) -> Vec<f64> {
        let drift = self.rates(t, x, u_sat, |_| 0.0);
        let both = self.rates(t, x, u_sat, increment);
        x.iter()
            .zip(drift.iter().zip(both))
            .map(|(x, (drift, both))| x + h * drift + (both - drift))
            .collect()
    }

    fn runge_kutta(
        &mut self,
        t: f64,
        x: &[f64],
        u_sat: &[f64],
        h: f64,
        xi: impl Fn(u32) -> f64,
    ) -> Vec<f64> {
        let moved = |rates: &[f64], h: f64| {
            x.iter()
                .zip(rates)
                .map(|(x, rate)| x + h * rate)
                .collect::<Vec<f64>>()
        };
        let k1 = self.rates(t, x, u_sat, &xi);
        let k2 = self.rates(t + h / 2.0, &moved(&k1, h / 2.0), u_sat, &xi);
        let k3 = self.rates(t + h / 2.0, &moved(&k2, h / 2.0), u_sat, &xi);
        let k4 = self.rates(t + h, &moved(&k3, h), u_sat, &xi);
        (0..x.len())
            .map(|at| x[at] + h / 6.0 * (k1[at] + 2.0 * (k2[at] + k3[at]) + k4[at]))
            .collect()
    }

    /// Drift plus diffusion times `xi`.
    fn rates(&mut self, t: f64, x: &[f64], u_sat: &[f64], xi: impl Fn(u32) -> f64) -> Vec<f64> {
        let model = self.model;
        let mut values: Values = model
            .parameters
            .iter()
            .map(|parameter| (format!("params.{}", parameter.name), vec![parameter.value]))
            .collect();
        values.extend([
            ("t".into(), vec![t]),
            ("x".into(), x.to_vec()),
            ("u_sat".into(), u_sat.to_vec()),
        ]);
        self.program.run(&values).unwrap();
        let outputs = self.program.outputs();
        let mut rates = outputs["drift"].clone();
        if let Some(diffusion) = outputs.get("diffusion") {
            for (rate, row) in rates
                .iter_mut()
                .zip(diffusion.chunks(diffusion.len() / x.len()))
            {
                *rate += row
                    .iter()
                    .zip(0..)
                    .map(|(entry, channel)| entry * xi(channel))
                    .sum::<f64>();
            }
        }
        rates
    }
}
