//! Guarantees that a block has the gains that its features need, and no others.

use super::Context;
use crate::diagnostic::{Diagnostic, Rule, Span};
use crate::model::VirtualDerivative;
use crate::spec::{ControllerBlock, Disturbance, Named, Read, Unreadable};

/// A gain, and whether the block needs it.
struct Need {
    key: &'static str,
    needed: Read<bool>,
    /// When it is needed.
    when: &'static str,
    /// What would make it needed, where the block could have that.
    with: Option<&'static str>,
}

impl Context<'_> {
    /// What each optional gain of a block is needed for.
    fn needs(&self, at: usize, own: &ControllerBlock) -> [Need; 8] {
        let spec = self.spec;
        let plant = &spec.blocks[at].value;
        let inner = is_given(at + 1 < spec.blocks.len(), spec.blocks.complete);
        let filtered = (spec.controller.virtual_derivative)
            .map(|choice| choice.is_none_or(|choice| choice.value == VirtualDerivative::Filter));
        let (disturbed, bounded) = match plant.disturbance.as_ref().map(|given| &given.value) {
            Some(Ok(disturbance)) => (Ok(true), Ok(matches!(disturbance, Disturbance::Bounded(_)))),
            Some(Err(Unreadable)) => (Err(Unreadable), Err(Unreadable)),
            None => (
                is_given(false, plant.complete),
                is_given(false, plant.complete),
            ),
        };
        let noisy = is_given(plant.noise.is_some(), plant.complete);
        let networked = is_given(own.network.is_some(), own.complete);
        let need = |key, needed, when, with| Need {
            key,
            needed,
            when,
            with,
        };
        let chain = "in every block but the last";
        let observed = "in a block with a disturbance";
        let disturbance = Some("a `disturbance`, to which `eta_1` and `observer` belong");
        let noise = Some("`noise`, to which `noise_bound` belongs");
        [
            need(
                "filter",
                both(inner, filtered),
                "in every block but the last, with `virtual_derivative: filter`",
                None,
            ),
            need("eta_1", disturbed, observed, disturbance),
            need("eta_2", inner, chain, None),
            need("eta_3", inner, chain, None),
            need(
                "eta_noise",
                both(noisy, disturbed),
                "in a block with noise and a disturbance",
                match (noisy, disturbed) {
                    (Ok(true), _) => disturbance,
                    (_, Ok(true)) => noise,
                    _ => Some("both `noise` and a `disturbance`"),
                },
            ),
            need("observer", disturbed, observed, disturbance),
            need(
                "error_bound",
                both(networked, bounded.map(|bounded| !bounded)),
                "in a block with a network and no `bounded` disturbance",
                None,
            ),
            need("noise_bound", noisy, "in a block with noise", noise),
        ]
    }

    /// Where the feature is given that needs a gain.
    fn feature(&self, at: usize, own: &ControllerBlock, key: &str) -> Option<Span> {
        let plant = &self.spec.blocks[at].value;
        match key {
            "eta_1" | "observer" => plant.disturbance.as_ref().map(|given| given.span),
            "eta_noise" | "noise_bound" => plant.noise.as_ref().map(|given| given.span),
            "error_bound" => own.network.as_ref().map(|given| given.span),
            _ => None,
        }
    }

    /// Checks the presence of every optional gain of a block.
    pub(super) fn check_features(&mut self, at: usize, gains: &Named<ControllerBlock>) {
        let block = &gains.name;
        let given = &gains.value.keys;
        for need in self.needs(at, &gains.value) {
            match (need.needed, given.get(need.key)) {
                (Ok(true), None) if gains.value.complete => {
                    let message = format!("`{}` is missing in block `{}`", need.key, block.value);
                    let help = format!("add `{}: ..`; it is needed {}", need.key, need.when);
                    let fault = Diagnostic::error(Rule::E0118, block.span, message).with_help(help);
                    let feature = self.feature(at, &gains.value, need.key);
                    self.faults.push(match feature {
                        Some(place) => fault.with_related(place, "this needs it"),
                        None => fault,
                    });
                }
                (Ok(false), Some(&span)) => {
                    self.supersede(span);
                    let message = format!("`{}` has no use in block `{}`", need.key, block.value);
                    let help = match need.with {
                        Some(with) => format!(
                            "remove it, or give block `{}` of the plant {with}",
                            block.value
                        ),
                        None => format!("remove it; it is used {} only", need.when),
                    };
                    self.fault(Rule::E0119, span, message, help);
                }
                _ => {}
            }
        }
    }
}

/// Whether something is given: what is not may be under a key that could not be read.
fn is_given(given: bool, complete: bool) -> Read<bool> {
    match given || complete {
        true => Ok(given),
        false => Err(Unreadable),
    }
}

/// Whether both hold, if that can be told.
fn both(one: Read<bool>, other: Read<bool>) -> Read<bool> {
    match (one, other) {
        (Ok(false), _) | (_, Ok(false)) => Ok(false),
        (one, other) => one.and(other),
    }
}
