//! The law and the plant against the reference implementation in `tests/reference`, which was written from the equations alone.
//!
//! Each point states how far double precision may be from the exact value of each quantity: eight times what the quantity moves when the
//! inputs move by their last bit, and at least 1e-13 of its largest entry (1e-10 for LV). Errors that cancel, such as e at zero
//! error, are thus judged by the numbers they come from.

use std::collections::BTreeMap;

use nsv_codegen::ir::eval::eval;
use nsv_codegen::ir::{Program, Values};
use nsv_spec::model::Model;
use nsv_tests::points::{Point, names, points};
use nsv_tests::specification::{compiled, named};

fn outputs(program: &Program, values: &Values, context: &str) -> Values {
    eval(program, values).unwrap_or_else(|error| panic!("{context}: {error}"))
}

fn design(model: &Model) -> BTreeMap<String, f64> {
    model
        .parameters
        .iter()
        .map(|parameter| (parameter.name.clone(), parameter.design_value))
        .collect()
}

fn largest(values: &[f64]) -> f64 {
    values
        .iter()
        .fold(0.0, |most: f64, value| most.max(value.abs()))
}

/// Panics unless each entry is as expected.
fn check(context: &str, found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len(), "{context}");
    for (found, expected) in found.iter().zip(expected) {
        let error = (found - expected).abs();
        assert!(
            error <= tolerance,
            "{context}: {found:e}, expected {expected:e} within {tolerance:e}, off by {error:e}"
        );
    }
}

/// Every quantity that the point names.
fn check_law(model: &Model, quantities: &Program, point: &Point) {
    let found = outputs(
        quantities,
        &point.values(model, &design(model)),
        &point.label,
    );
    for (name, expected) in &point.expected {
        let context = format!("{}, {}: {name}", model.name, point.label);
        let found = found
            .get(name)
            .unwrap_or_else(|| panic!("{context} is computed"));
        check(&context, found, expected, point.tolerance[name]);
    }
}

/// Drift and covariance of the packed plant state under dispersed parameters.
fn check_plant(model: &Model, plant: &Program, point: &Point) {
    let mut values = point.values(model, &point.params);
    values.extend(
        point
            .params
            .iter()
            .map(|(name, value)| (format!("params.{name}"), vec![*value])),
    );
    let found = outputs(plant, &values, &point.label);
    let context = format!("{}, {}", model.name, point.label);
    let whole = 1e-12 * largest(&point.drift);
    let tolerance = point.drift_tolerance.clone();
    let tolerance = tolerance.unwrap_or_else(|| vec![whole; point.drift.len()]);
    assert_eq!(
        (found["drift"].len(), tolerance.len()),
        (point.drift.len(), point.drift.len()),
        "{context}"
    );
    for (at, tolerance) in tolerance.into_iter().enumerate() {
        let context = format!("{context}: drift of state {at}");
        let entry = at..=at;
        check(
            &context,
            &found["drift"][entry.clone()],
            &point.drift[entry],
            tolerance.min(whole),
        );
    }
    let n = point.drift.len();
    let diffusion: &[f64] = found.get("diffusion").map_or(&[], |diffusion| diffusion);
    let columns = diffusion.len() / n;
    let entry = |at: usize| {
        (0..columns)
            .map(|j| diffusion[at / n * columns + j] * diffusion[at % n * columns + j])
            .sum()
    };
    let covariance: Vec<f64> = (0..n * n).map(entry).collect();
    check(
        &format!("{context}: covariance"),
        &covariance,
        &point.covariance,
        1e-13 * largest(&point.covariance),
    );
}

#[test]
fn every_quantity_is_that_of_the_reference() {
    let names = names();
    assert!(names.len() >= 6, "{names:?}");
    for name in names {
        let (model, programs) = compiled(&named(&name));
        let points = points(&name);
        assert!(points.len() >= 30, "{name}");
        for point in points {
            check_law(&model, &programs.quantities, &point);
            check_plant(&model, &programs.plant, &point);
        }
    }
}
