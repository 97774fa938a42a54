//! Every program and every emitted function against CasADi's own evaluation, `tests/casadi_values`, at points that
//! `tests/reference/casadi_values.py` chose: surroundings of the reference's points, no error, errors near the constraint, saturation.
//!
//! CasADi sums, factors and rounds in another order. An output may differ by [`RELATIVE`] of its largest entry; where terms
//! cancel, by [`MARGIN`] times what the last bits of the inputs and constants were seen to do to it.

#![allow(
    clippy::unwrap_used,
    reason = "a test fails by panicking, in its helpers as well"
)]

use std::collections::BTreeMap;
use std::fs;

use nsv_codegen::ir::Values;
use nsv_codegen::ir::eval::eval;
use nsv_codegen::lower::Programs;
use nsv_codegen::opt::optimise;
use nsv_tests::compiled::{Module, modules};
use nsv_tests::points::packed_leaves;
use nsv_tests::specification::{compiled, named, repository};
use serde_json::Value;

/// Error of an output that is always allowed, of its largest entry.
const RELATIVE: f64 = 1e-12;

/// The change of inputs and constants by their last bits was seen in six trials; each operation of a program rounds as well.
const MARGIN: f64 = 4.0;

/// A way to compute a program's outputs.
type Way<'w> = (&'static str, Box<dyn Fn(&Values) -> Values + 'w>);

/// Largest errors seen.
#[derive(Default)]
struct Worst {
    /// Of the largest entry of the output, where rounding alone is allowed less.
    relative: f64,
    /// Of what is allowed.
    allowed: f64,
    /// Where the latter is.
    context: String,
}

/// An object of lists of numbers.
fn values(value: &Value) -> Values {
    let entries = |list: &Value| {
        list.as_array()
            .unwrap()
            .iter()
            .map(|entry| entry.as_f64().unwrap())
            .collect()
    };
    value
        .as_object()
        .unwrap()
        .iter()
        .map(|(name, list)| (name.clone(), entries(list)))
        .collect()
}

/// The inputs of a program at a state: an emitted function has controller states under `state.` and the plant's state packed, and the
/// plant has its own parameters.
fn inputs(program: &str, state: &Values) -> Values {
    let mut inputs = state.clone();
    inputs.extend(
        state
            .iter()
            .map(|(name, value)| (format!("state.{name}"), value.clone())),
    );
    let packed = packed_leaves(9).filter_map(|leaf| state.get(&leaf));
    inputs.insert("x".into(), packed.flatten().copied().collect());
    if program == "plant" {
        let own = state.iter().filter_map(|(name, value)| {
            Some((
                format!("params.{}", name.strip_prefix("plant.")?),
                value.clone(),
            ))
        });
        inputs.extend(own);
    }
    inputs
}

fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, |most, value| {
        if value.abs() <= most {
            most
        } else {
            value.abs()
        }
    })
}

/// Panics unless the outputs are those of the point.
fn check(context: &str, [outputs, rounding]: [&Value; 2], found: &Values, worst: &mut Worst) {
    let expected = values(outputs);
    assert!(
        found.keys().eq(expected.keys()),
        "{context}: {:?}, expected {:?}",
        found.keys(),
        expected.keys()
    );
    for (name, expected) in &expected {
        let context = format!("{context}: {name}");
        assert_eq!(found[name].len(), expected.len(), "{context}");
        let size = largest(expected.iter().copied());
        let floor = MARGIN
            * rounding
                .get(name)
                .map_or(0.0, |change| change.as_f64().unwrap());
        let error = largest(
            found[name]
                .iter()
                .zip(expected)
                .map(|(found, expected)| found - expected),
        );
        let allowed = RELATIVE * size + floor;
        assert!(
            error <= allowed,
            "{context} is off by {error:e} of {size:e}, allowed {allowed:e}"
        );
        if floor <= RELATIVE * size && error > worst.relative * size {
            worst.relative = error / size;
        }
        if error / allowed > worst.allowed {
            (worst.allowed, worst.context) = (error / allowed, context);
        }
    }
}

/// The program interpreted, interpreted after optimisation, and compiled if it is emitted.
fn ways<'w>(module: &Module, programs: &'w Programs) -> BTreeMap<&'w str, Vec<Way<'w>>> {
    let all = [
        &programs.initial,
        &programs.control,
        &programs.plant,
        &programs.lyapunov,
        &programs.quantities,
    ];
    let ways = all.map(|program| {
        let optimised = optimise(program.clone());
        let mut ways: Vec<Way<'w>> = vec![
            (
                "lowered",
                Box::new(move |values| eval(program, values).unwrap()),
            ),
            (
                "optimised",
                Box::new(move |values| eval(&optimised, values).unwrap()),
            ),
        ];
        if let Some((_, function)) = module
            .functions
            .iter()
            .find(|(name, _)| *name == program.name)
        {
            ways.push(("compiled", Box::new(*function)));
        }
        (program.name.as_str(), ways)
    });
    ways.into()
}

#[test]
fn every_output_of_every_program_is_what_casadi_computes() {
    for module in modules() {
        let text = fs::read_to_string(repository(&format!(
            "tests/casadi_values/{}.json",
            module.name
        )))
        .unwrap();
        let document: Value = serde_json::from_str(&text).unwrap();
        let (_, programs) = compiled(&named(module.name));
        let ways = ways(&module, &programs);
        assert_eq!(
            ways.values()
                .flatten()
                .filter(|(way, _)| *way == "compiled")
                .count(),
            4,
            "four functions are emitted"
        );
        let points = document["points"].as_array().unwrap();
        assert!(points.len() >= 25, "{}", module.name);
        for (program, ways) in &ways {
            let mut worst = Worst::default();
            for point in points {
                let inputs = inputs(program, &values(&point["inputs"]));
                let expected = [&point["outputs"][program], &point["rounding"][program]];
                for (way, compute) in ways {
                    let context = format!("{}::{program}, {way}, {}", module.name, point["label"]);
                    check(&context, expected, &compute(&inputs), &mut worst);
                }
            }
            let Worst {
                relative,
                allowed,
                context,
            } = worst;
            println!(
                "{}::{program}: {relative:.1e} of the largest entry; {allowed:.1e} of what is allowed at {context}",
                module.name
            );
        }
    }
}
