//! States of a closed loop with noise and dispersed parameters, by the emitted scalar code.

use std::ops::Range;

use nsv_codegen::lower::Programs;
use nsv_spec::model::{Model, NoiseModel};

use crate::draw::Draw;
use crate::emitted::{Function, Module};
use crate::lanes::scalar;
use crate::layout::{Layout, results};

/// Runs that states are taken from.
const RUNS: u64 = 4;

/// States that are kept of a run, evenly over its time.
const KEPT: usize = 1000;

/// Steps of Euler's method in each step of the scenario's plant: that method is good for slower motions than the scenario's.
const EULER: u32 = 4;

/// A function with room for its results.
pub struct Scalar {
    places: Vec<(String, Range<usize>)>,
    evaluate: fn(&Layout, &[f64], &mut [f64]),
    results: Vec<f64>,
}

impl Scalar {
    /// An emitted function, whose results stand at these places.
    pub fn new<F: Function>(places: Vec<(String, Range<usize>)>) -> Self {
        let size = places.last().map_or(0, |(_, entries)| entries.end);
        Scalar { places, evaluate: scalar::<F>, results: vec![0.0; size] }
    }

    /// Computes the results of a point.
    pub fn run(&mut self, layout: &Layout, point: &[f64]) {
        (self.evaluate)(layout, point, &mut self.results);
    }

    /// A result of the last point.
    pub fn result(&self, name: &str) -> Option<&[f64]> {
        let (_, entries) = self.places.iter().find(|(known, _)| known == name)?;
        Some(&self.results[entries.clone()])
    }

    /// All results of the last point.
    pub fn all(&self) -> &[f64] {
        &self.results
    }
}

/// The closed loop of a module.
struct Loop<'a> {
    model: &'a Model,
    layout: &'a Layout,
    control: Scalar,
    plant: Scalar,
    draw: Draw,
}

impl Loop<'_> {
    /// Moves time, plant and controller of a point from one sample to the next.
    fn advance(&mut self, sample: usize, sample_time: f64, point: &mut [f64]) {
        let layout = self.layout;
        self.control.run(layout, point);
        point[layout.u_sat.clone()].copy_from_slice(self.control.result("u_sat").expect("every law has it"));
        let steps = self.model.scenario.substeps * EULER;
        let h = sample_time / f64::from(steps);
        let held = self.model.scenario.noise == NoiseModel::Sampled;
        let channels = self.plant.result("diffusion").map_or(0, |entries| entries.len() / layout.x.len());
        let mut xi: Vec<f64> = (0..channels).map(|_| self.draw.normal()).collect();
        for step in 0..steps {
            point[0] = sample as f64 * sample_time + f64::from(step) * h;
            self.plant.run(layout, point);
            if !held {
                xi.fill_with(|| self.draw.normal() / h.sqrt());
            }
            for (row, entry) in layout.x.clone().enumerate() {
                let drift = self.plant.result("drift").expect("every plant has it")[row];
                let diffusion = self.plant.result("diffusion").unwrap_or(&[]);
                let shake: f64 = diffusion.iter().skip(row * channels).zip(&xi).map(|(entry, xi)| entry * xi).sum();
                point[entry] += h * (drift + shake);
            }
        }
        point[0] = (sample + 1) as f64 * sample_time;
        let states = layout.state.len();
        let next = &self.control.all()[self.control.all().len() - states..];
        point[layout.state.clone()].copy_from_slice(next);
    }
}

/// Points of some runs of the closed loop, one after another.
pub fn flights<M: Module>(model: &Model, programs: &Programs, layout: &Layout, seed: u64) -> Vec<f64> {
    let mut kept = Vec::new();
    let mut initial = Scalar::new::<M::Initial>(results(&programs.initial, &M::Initial::results()));
    for run in 0..RUNS {
        let mut closed = Loop {
            model,
            layout,
            control: Scalar::new::<M::Control>(results(&programs.control, &M::Control::results())),
            plant: Scalar::new::<M::Plant>(results(&programs.plant, &M::Plant::results())),
            draw: Draw::new(seed, u64::MAX - run),
        };
        let mut point = vec![0.0; layout.size()];
        point[layout.x.clone()].copy_from_slice(M::INITIAL_STATE);
        for (name, at) in M::PARAMS.iter().cycle().zip(layout.params.start..layout.plant.end) {
            let parameter = model.parameters.iter().find(|parameter| parameter.name == *name).expect("the model has it");
            point[at] = parameter.value * (0.95 + 0.1 * closed.draw.uniform());
        }
        initial.run(layout, &point);
        point[layout.state.clone()].copy_from_slice(initial.all());
        let samples = (model.scenario.horizon / M::SAMPLE_TIME).round() as usize;
        let every = samples.div_ceil(KEPT);
        for sample in 0..samples {
            let before = point.clone();
            closed.advance(sample, M::SAMPLE_TIME, &mut point);
            assert!(point.iter().all(|entry| entry.is_finite()), "{} run {run} stays finite, {point:?}", M::NAME);
            if sample % every == 0 {
                kept.extend_from_slice(&before[..layout.u_sat.start]);
                kept.extend_from_slice(&point[layout.u_sat.clone()]);
            }
        }
    }
    kept
}
