//! The programs of a law: what each emitted function is given and returns.

use super::frame::needed;
use super::{Frame, program};
use crate::derive::law::Law;
use crate::derive::symbol::{Symbol, Term, name};
use crate::derive::truth::TRUTH;
use crate::ir::{Program, Shape};
use crate::opt::simplify;

/// All programs of a specification.
#[derive(Clone, Debug)]
pub struct Programs {
    /// Controller states at the first sample.
    pub initial: Program,
    /// Control law and next controller states.
    pub control: Program,
    /// True plant: packed drift and diffusion, disturbances.
    pub plant: Program,
    /// V and LV along the true closed loop.
    pub lyapunov: Program,
    /// Every quantity of the continuous-time law, V and LV.
    pub quantities: Program,
}

impl Programs {
    /// Lowers a law. Couplings that are absent are no operations.
    pub fn new(law: &Law) -> Self {
        Self {
            initial: simplify(initial(law)),
            control: simplify(control(law)),
            plant: simplify(plant(law)),
            lyapunov: simplify(lyapunov(law)),
            quantities: simplify(quantities(law)),
        }
    }

    /// All of them.
    pub fn all(&self) -> [&Program; 5] {
        [
            &self.initial,
            &self.control,
            &self.plant,
            &self.lyapunov,
            &self.quantities,
        ]
    }
}

fn leaf(law: &Law, quantity: &str, input: String) -> (String, String, Shape) {
    let shape = law
        .leaf_shape(quantity)
        .unwrap_or_else(|| panic!("invariant: `{quantity}` is a leaf"));
    (quantity.to_string(), input, shape)
}

/// `t, x1, .., xn`.
fn measurements(law: &Law) -> Vec<(String, String, Shape)> {
    let states = (1..=law.order()).map(|i| format!("x{i}"));
    std::iter::once("t".to_string())
        .chain(states)
        .map(|quantity| leaf(law, &quantity, quantity.clone()))
        .collect()
}

/// `w<i>` of the blocks with an exosystem.
fn exosystems(law: &Law) -> Vec<(String, String, Shape)> {
    let blocks = (1..=law.order())
        .map(|i| format!("w{i}"))
        .filter(|quantity| law.leaves.contains_key(quantity));
    blocks
        .map(|quantity| leaf(law, &quantity, quantity.clone()))
        .collect()
}

fn states(law: &Law, prefix: &str) -> Vec<(String, String, Shape)> {
    law.states
        .iter()
        .map(|state| leaf(law, &state.name, format!("{prefix}{}", state.name)))
        .collect()
}

fn same_names(quantities: Vec<String>) -> Vec<(String, String)> {
    quantities
        .into_iter()
        .map(|quantity| (quantity.clone(), quantity))
        .collect()
}

fn initial(law: &Law) -> Program {
    let replaced = law
        .states
        .iter()
        .map(|state| (state.name.clone(), state.initial.clone()))
        .collect();
    let outputs = same_names(law.states.iter().map(|state| state.name.clone()).collect());
    program(
        law,
        "initial",
        &Frame {
            inputs: measurements(law),
            replaced,
            outputs,
            plant_prefix: "params.",
        },
    )
}

fn control(law: &Law) -> Program {
    let mut inputs = measurements(law);
    inputs.extend(states(law, "state."));
    let mut telemetry = vec![
        "u".to_string(),
        "u_sat".to_string(),
        "violated".to_string(),
        "y_r".to_string(),
    ];
    for i in 1..=law.order() {
        telemetry.extend(
            ["e", "k", "alpha", "D_hat"]
                .iter()
                .map(|base| format!("{base}{i}")),
        );
    }
    telemetry.retain(|quantity| law.contains(quantity));
    let mut outputs = same_names(telemetry);
    outputs.extend(law.states.iter().map(|state| {
        (
            format!("next.{}", state.name),
            format!("{}_next", state.name),
        )
    }));
    program(
        law,
        "control",
        &Frame {
            inputs,
            outputs,
            plant_prefix: "plant.",
            ..Frame::default()
        },
    )
}

fn plant(law: &Law) -> Program {
    let mut replaced = std::collections::BTreeMap::new();
    let mut first = 0;
    let blocks = (1..=law.order()).map(|i| (format!("x{i}"), law.width()));
    let further = (law.truth_states() > 0).then(|| (TRUTH.to_string(), law.truth_states()));
    let exosystems = exosystems(law)
        .into_iter()
        .map(|(quantity, _, shape)| (quantity, crate::ir::build::size(shape)));
    for (quantity, length) in blocks.chain(further).chain(exosystems) {
        replaced.insert(
            quantity,
            Symbol::from(Term::Slice(name("x"), first, length)),
        );
        first += length;
    }
    let mut inputs = vec![
        leaf(law, "t", "t".into()),
        ("x".into(), "x".into(), Shape::Vector(first)),
    ];
    inputs.push(("u_sat".into(), "u_sat".into(), Shape::Vector(law.width())));
    let mut outputs = vec!["drift".to_string(), "diffusion".to_string()];
    outputs.extend((1..=law.order()).map(|i| format!("d{i}")));
    outputs.retain(|quantity| law.contains(quantity));
    program(
        law,
        "plant",
        &Frame {
            inputs,
            replaced,
            outputs: same_names(outputs),
            plant_prefix: "params.",
        },
    )
}

fn lyapunov(law: &Law) -> Program {
    let mut inputs = measurements(law);
    inputs.extend(exosystems(law));
    inputs.extend(states(law, "state."));
    let outputs = same_names(vec!["V".into(), "LV".into()]);
    program(
        law,
        "lyapunov",
        &Frame {
            inputs,
            outputs,
            plant_prefix: "plant.",
            ..Frame::default()
        },
    )
}

/// Every quantity of the law in the order of its equations: all that the control, the errors, the rates of the states and V depend on.
/// Of what the chain rule makes for LV, LV alone.
fn quantities(law: &Law) -> Program {
    let mut inputs = measurements(law);
    inputs.extend(exosystems(law));
    inputs.extend(states(law, ""));
    let mut ends: Vec<String> = ["u_sat", "V"].map(String::from).into();
    for i in 1..=law.order() {
        ends.extend(["E", "c", "d"].map(|base| format!("{base}{i}")));
        ends.extend([format!("k{i}_dot"), format!("h{i}_dot")]);
    }
    ends.extend(law.states.iter().map(|state| format!("{}_dot", state.name)));
    ends.retain(|quantity| law.contains(quantity));
    let mut frame = Frame {
        inputs,
        outputs: same_names(ends),
        plant_prefix: "plant.",
        ..Frame::default()
    };
    let needed = needed(law, &frame);
    let names = law.equations().iter().map(|equation| &equation.name);
    let shown = names.filter(|name| needed.contains(*name) || *name == "LV");
    frame.outputs = same_names(shown.cloned().collect());
    program(law, "quantities", &frame)
}
