//! Every partial derivative that a specification uses, as decoded from its committed export, against differences of its own formula.
//!
//! An answer gives the rates of a formula along jets x(s) = x + x' s + x'' s^2/2: the first rate is the slope of the formula along
//! them, the second the slope of the first.

use std::collections::BTreeMap;

use nsv_codegen::casadi::{Error, Job, Provider, Question};
use nsv_codegen::derive::{Partials, derive};
use nsv_codegen::ir::build::size;
use nsv_codegen::ir::eval::Evaluator;
use nsv_codegen::ir::{Program, Values};
use nsv_runtime::noise::Noise;
use nsv_tests::specification::{model, provider, specifications};

/// Draws of the inputs of each formula.
const DRAWS: u64 = 8;

/// What derivation asked, and what it was told: formula, job and answer by key.
#[derive(Default)]
struct Record(BTreeMap<String, (Program, Job, Program)>);

/// Passes questions on and records them.
struct Recorder<'a> {
    provider: Provider<'static>,
    record: &'a mut Record,
}

impl Partials for Recorder<'_> {
    fn partials(&mut self, formula: &Program, job: &Job) -> Result<Program, Error> {
        let answer = self.provider.partials(formula, job)?;
        let key = Question::new(formula, job).key().to_string();
        self.record
            .0
            .insert(key, (formula.clone(), job.clone(), answer.clone()));
        Ok(answer)
    }
}

/// All questions of the specifications in a folder.
fn recorded(folder: &str) -> Record {
    let mut record = Record::default();
    for path in specifications(folder) {
        let mut recorder = Recorder {
            provider: provider(&path),
            record: &mut record,
        };
        derive(&model(&path), &mut recorder)
            .unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    }
    record
}

/// Name of the k-th rate of an input or output.
fn rate(name: &str, k: usize) -> String {
    if k == 0 {
        name.to_owned()
    } else {
        format!("{name}.rate{k}")
    }
}

/// Inputs in (0.3, 1.2), where roots, logarithms and the tangent of the barrier are smooth, and rates in (-1, 1).
fn point(answer: &Program, draw: &Noise) -> Values {
    let inputs = (0..).zip(&answer.inputs).map(|(channel, input)| {
        let entry = |step: usize| {
            let uniform = draw.uniform(step as u64, channel);
            if input.name.contains(".rate") {
                2.0 * uniform - 1.0
            } else {
                0.3 + 0.9 * uniform
            }
        };
        (
            input.name.clone(),
            (0..size(input.shape)).map(entry).collect(),
        )
    });
    inputs.collect()
}

/// The jets of the varying inputs after `s`, all orders: each is the derivative of the one before.
fn along(inputs: &Values, varying: &[String], order: usize, s: f64) -> Values {
    let mut moved = inputs.clone();
    for name in varying {
        for k in 0..order {
            let above = (k + 1..=order).scan(1.0, |power, j| {
                *power *= s / (j - k) as f64;
                Some((*power, &inputs[&rate(name, j)]))
            });
            let entries = moved.get_mut(&rate(name, k)).unwrap();
            above.for_each(|(power, rates)| {
                entries
                    .iter_mut()
                    .zip(rates)
                    .for_each(|(entry, rate)| *entry += power * rate)
            });
        }
    }
    moved
}

/// Derivative at 0 by central differences of order eight.
fn difference(step: f64, mut value: impl FnMut(f64) -> Vec<f64>) -> Vec<f64> {
    const WEIGHTS: [f64; 4] = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
    let mut slopes = vec![0.0; value(0.0).len()];
    for (weight, n) in WEIGHTS.iter().zip(1..) {
        let (ahead, behind) = (value(f64::from(n) * step), value(-f64::from(n) * step));
        for (slope, (ahead, behind)) in slopes.iter_mut().zip(ahead.iter().zip(behind)) {
            *slope += weight * (ahead - behind) / step;
        }
    }
    slopes
}

/// Slopes of an output along the jets, each with its uncertainty: differences by two steps, which part where a formula has a kink.
fn slopes(
    below: &mut Evaluator<'_>,
    output: &str,
    moved: impl Fn(f64) -> Values,
) -> Vec<(f64, f64)> {
    let [coarse, fine] = [2e-3, 1e-3].map(|step| {
        difference(step, |s| {
            below.run(&moved(s)).unwrap();
            below.outputs().remove(output).unwrap()
        })
    });
    coarse
        .into_iter()
        .zip(fine)
        .map(|(coarse, fine)| (coarse, (coarse - fine).abs()))
        .collect()
}

/// Panics unless each order's rate is the slope of the one below; returns how many draws were in the formula's domain, off its kinks.
fn check(key: &str, formula: &Program, job: &Job, answer: &Program) -> u32 {
    let Job::Rates { order, varying } = job else {
        panic!("derivation asks for rates, found {job:?}")
    };
    let (mut below, mut above) = (Evaluator::new(formula), Evaluator::new(answer));
    let mut drawn = 0;
    'draws: for run in 0..DRAWS {
        let inputs = point(answer, &Noise::process(3, run));
        above.run(&inputs).unwrap();
        let rates = above.outputs();
        for (output, k) in formula
            .outputs
            .iter()
            .flat_map(|(output, _)| (1..=*order).map(move |k| (output, k)))
        {
            let evaluator = if k == 1 { &mut below } else { &mut above };
            let slopes = slopes(evaluator, &rate(output, k - 1), |s| {
                along(&inputs, varying, *order, s)
            });
            let found = &rates[&rate(output, k)];
            assert_eq!(found.len(), slopes.len(), "{key}");
            for (found, (slope, uncertainty)) in found.iter().zip(slopes) {
                let tolerance = 1e-8 * (1.0 + slope.abs());
                if !slope.is_finite() || uncertainty > tolerance {
                    continue 'draws;
                }
                let error = (found - slope).abs();
                assert!(
                    error <= tolerance,
                    "{key}: {} is {found}, by differences {slope}\n{formula}",
                    rate(output, k)
                );
            }
        }
        drawn += 1;
    }
    drawn
}

fn check_folder(folder: &str, least: usize) {
    let Record(record) = recorded(folder);
    assert!(record.len() >= least, "{} questions", record.len());
    for (key, (formula, job, answer)) in &record {
        assert!(
            check(key, formula, job, answer) >= 3,
            "{key} is defined where it is tested\n{formula}"
        );
    }
}

#[test]
fn exports_of_the_specifications_are_derivatives() {
    check_folder("specs", 40);
}

#[test]
fn exports_of_the_test_specifications_are_derivatives() {
    check_folder("tests/specs", 20);
}
