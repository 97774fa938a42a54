//! Points of the reference implementation, `tests/points/*.json`: states of the closed loop and what the law must give there.

use std::collections::BTreeMap;
use std::fs;

use nsv_codegen::ir::Values;
use nsv_spec::model::Model;
use serde_json::Value;

use crate::specification::repository;

/// A state of the closed loop with all that follows from it.
#[derive(Clone, Debug)]
pub struct Point {
    /// What is special about it.
    pub label: String,
    /// Whether a constraint is violated: the barrier is clamped and V means nothing.
    pub clamped: bool,
    /// Time, states, controller states and exosystem states.
    pub inputs: Values,
    /// Quantities of the law with nominal parameters.
    pub expected: Values,
    /// Largest error of any entry of each quantity in double precision.
    pub tolerance: BTreeMap<String, f64>,
    /// Dispersed parameters of the plant.
    pub params: BTreeMap<String, f64>,
    /// Rates of the packed plant state with these parameters.
    pub drift: Vec<f64>,
    /// Largest error of each of these rates in double precision, where what is flown has further states: their units differ.
    pub drift_tolerance: Option<Vec<f64>>,
    /// Covariance rate of the packed plant state with these parameters.
    pub covariance: Vec<f64>,
}

/// Names of the specifications that have points.
pub fn names() -> Vec<String> {
    let entries = repository("tests/points")
        .read_dir()
        .unwrap()
        .map(|entry| entry.unwrap().path());
    let mut names: Vec<String> = entries
        .map(|path| path.file_stem().unwrap().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

/// The points of a specification.
pub fn points(name: &str) -> Vec<Point> {
    let text = fs::read_to_string(repository(&format!("tests/points/{name}.json"))).unwrap();
    let document: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(document["spec"], name);
    document["points"]
        .as_array()
        .unwrap()
        .iter()
        .map(point)
        .collect()
}

impl Point {
    /// Inputs of a program at this point: of the law's quantities, or of an emitted function, which has controller states under
    /// `state.` and the plant's state packed. Design parameters are nominal, the plant's are `plant`.
    pub fn values(&self, model: &Model, plant: &BTreeMap<String, f64>) -> Values {
        let mut values = self.inputs.clone();
        values.extend(
            self.inputs
                .iter()
                .map(|(name, data)| (format!("state.{name}"), data.clone())),
        );
        for parameter in &model.parameters {
            values.insert(
                format!("params.{}", parameter.name),
                vec![parameter.design_value],
            );
            values.insert(
                format!("plant.{}", parameter.name),
                vec![plant[&parameter.name]],
            );
        }
        let packed = packed_leaves(model.blocks.len());
        let packed = packed.filter_map(|leaf| self.inputs.get(&leaf));
        values.insert("x".into(), packed.flatten().copied().collect());
        values.insert("u_sat".into(), self.expected["u_sat"].clone());
        values
    }
}

/// What a plant's state is packed of, as far as it has it: states of the blocks, further states of what is flown, exosystems.
pub fn packed_leaves(blocks: usize) -> impl Iterator<Item = String> {
    let of_blocks = move |leaf: char| (1..=blocks).map(move |i| format!("{leaf}{i}"));
    of_blocks('x')
        .chain(["truth".to_owned()])
        .chain(of_blocks('w'))
}

fn point(value: &Value) -> Point {
    let plant = &value["plant"];
    Point {
        label: value["label"].as_str().unwrap().to_owned(),
        clamped: value
            .get("clamped")
            .is_some_and(|clamped| clamped.as_bool().unwrap()),
        inputs: object(&value["inputs"], flat),
        expected: object(&value["expected"], flat),
        tolerance: object(&value["tolerance"], number),
        params: object(&plant["params"], number),
        drift: flat(&plant["drift"]),
        drift_tolerance: plant.get("tolerance").map(flat),
        covariance: flat(&plant["covariance"]),
    }
}

fn object<T>(value: &Value, entry: fn(&Value) -> T) -> BTreeMap<String, T> {
    value
        .as_object()
        .unwrap()
        .iter()
        .map(|(name, value)| (name.clone(), entry(value)))
        .collect()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

/// Entries of nested lists, row by row.
fn flat(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(items) => items.iter().flat_map(flat).collect(),
        _ => vec![number(value)],
    }
}
