//! Every emitted function computes what its program means, bit for bit: before optimisation, after each exact pass, and compiled.

use std::collections::BTreeMap;

use nsv_codegen::ir::eval::Evaluator;
use nsv_codegen::ir::{Program, Values};
use nsv_codegen::lower::Programs;
use nsv_codegen::opt::{Kind, LAST, PASSES, optimise};
use nsv_runtime::noise::Noise;
use nsv_spec::model::Model;
use nsv_tests::compiled::{Emitted, Module, modules};
use nsv_tests::points::{packed_leaves, points};
use nsv_tests::specification::{compiled, named};

/// Relative sizes of the changes of a point: in its last digits, within its surroundings, and out of any flight.
const SPREADS: [f64; 5] = [1e-15, 1e-6, 0.01, 0.3, 1e3];

/// Values put in place of an entry.
const EXTREME: [f64; 8] = [0.0, -0.0, 1e-300, -5e-324, 1e-9, -1e6, 1e100, 1e300];

/// A function of a module with its program at each stage of optimisation.
struct Function<'p> {
    context: String,
    stages: Vec<(String, Evaluator<'p>)>,
    compiled: Emitted,
}

impl Function<'_> {
    /// Panics unless every stage and the compiled code give the same bits.
    fn check(&mut self, values: &Values, stages: usize) -> Values {
        let compiled = (self.compiled)(values);
        for (stage, evaluator) in self.stages.iter_mut().take(stages) {
            evaluator.run(values).unwrap();
            let evaluated = evaluator.outputs();
            assert!(
                evaluated.keys().eq(compiled.keys()),
                "{}: {:?} {:?}",
                self.context,
                evaluated.keys(),
                compiled.keys()
            );
            for (name, evaluated) in &evaluated {
                let same = evaluated
                    .iter()
                    .zip(&compiled[name])
                    .all(|(a, b)| a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan()));
                assert!(
                    same,
                    "{}, {stage}: {name} is {:?} compiled, {evaluated:?} evaluated, at {values:?}",
                    self.context, compiled[name]
                );
            }
        }
        compiled
    }
}

/// The program before optimisation, optimised, and after each exact pass that changes it.
fn stages(program: &Program) -> Vec<(String, Program)> {
    let mut stages = vec![
        ("lowered".to_owned(), program.clone()),
        ("optimised".to_owned(), optimise(program.clone())),
    ];
    let mut present = program.clone();
    for round in 1..=2 {
        let passes = PASSES.iter().chain(&LAST);
        for pass in passes.filter(|pass| pass.kind == Kind::Exact) {
            let next = (pass.run)(present.clone());
            if next != present {
                stages.push((format!("{}, round {round}", pass.name), next.clone()));
            }
            present = next;
        }
    }
    stages
}

fn programs_of(programs: &Programs) -> BTreeMap<&str, Vec<(String, Program)>> {
    let all = [
        &programs.initial,
        &programs.control,
        &programs.plant,
        &programs.lyapunov,
    ];
    all.map(|program| (program.name.as_str(), stages(program)))
        .into()
}

/// Calls `test` with every function of the module.
fn with_functions(
    module: &Module,
    test: impl FnOnce(&Model, &mut BTreeMap<&'static str, Function<'_>>),
) {
    let (model, programs) = compiled(&named(module.name));
    let staged = programs_of(&programs);
    assert!(
        staged["control"].len() > 2,
        "some pass finds something to do"
    );
    let function = |(name, compiled)| {
        let stages = staged[name]
            .iter()
            .map(|(stage, program)| (stage.clone(), Evaluator::new(program)))
            .collect();
        (
            name,
            Function {
                context: format!("{}::{name}", module.name),
                stages,
                compiled,
            },
        )
    };
    test(&model, &mut module.functions.map(function).into());
}

/// The points of the reference and their surroundings: no error at all, errors at the bound and beyond it, saturation, phi at its floor.
#[test]
fn compiled_code_and_every_pass_keep_the_bits() {
    for module in modules() {
        with_functions(&module, |model, functions| {
            for (index, point) in (0..).zip(points(module.name)) {
                let values = point.values(model, &point.params);
                for function in functions.values_mut() {
                    function.check(&values, usize::MAX);
                    for variant in 0..12 {
                        function.check(&changed(&values, index, variant), 2);
                    }
                }
            }
        });
    }
}

/// The values, each moved, some of them to an extreme.
fn changed(values: &Values, seed: u64, variant: u64) -> Values {
    let draw = Noise::<f64>::process(seed, variant);
    let spread = SPREADS[variant as usize % SPREADS.len()];
    let extreme = variant.is_multiple_of(3);
    let change = |(channel, (name, data)): (u32, (&String, &Vec<f64>))| {
        let entry = |(step, value): (u64, &f64)| {
            if extreme && draw.uniform(step, 2 * channel) < 0.02 {
                return EXTREME
                    [(draw.uniform(step, 2 * channel + 1) * EXTREME.len() as f64) as usize];
            }
            value * (1.0 + spread * draw.normal(step, 2 * channel + 1))
        };
        (name.clone(), (1..).zip(data).map(entry).collect())
    };
    (0..).zip(values).map(change).collect()
}

/// Programs and compiled code side by side through a closed loop, each sample from the last one's states.
#[test]
fn a_flight_is_the_same_interpreted_and_compiled() {
    for module in modules() {
        with_functions(&module, |model, functions| {
            let mut point = points(module.name)
                .into_iter()
                .find(|point| point.label == "initial state of the scenario")
                .unwrap();
            let dt = model.controller.sample_time;
            let mut run =
                |name: &str, values: &Values| functions.get_mut(name).unwrap().check(values, 2);
            let states = run("initial", &point.values(model, &point.params));
            point.inputs.extend(states);
            for sample in 0..500 {
                point
                    .inputs
                    .insert("t".into(), vec![f64::from(sample) * dt]);
                let mut values = point.values(model, &point.params);
                let law = run("control", &values);
                values.insert("u_sat".into(), law["u_sat"].clone());
                run("lyapunov", &values);
                let rates = &run("plant", &values)["drift"];
                let mut moved = values["x"].iter().zip(rates).map(|(x, rate)| x + dt * rate);
                for leaf in packed_leaves(model.blocks.len()) {
                    for entry in point.inputs.get_mut(&leaf).into_iter().flatten() {
                        *entry = moved.next().unwrap();
                    }
                }
                let next = law.into_iter().filter_map(|(name, value)| {
                    Some((name.strip_prefix("next.")?.to_owned(), value))
                });
                point.inputs.extend(next);
            }
        });
    }
}
