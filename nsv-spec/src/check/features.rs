//! Guarantees that a block has the gains that its features need, and no others.

use super::Context;
use crate::diagnostic::{Diagnostic, Rule, Span};
use crate::model::VirtualDerivative;
use crate::spec::{ControllerBlock, Disturbance, Named};

/// A gain, and whether the block needs it.
struct Need {
    key: &'static str,
    needed: bool,
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
        let inner = at + 1 < spec.blocks.len();
        let filtered = spec
            .controller
            .virtual_derivative
            .is_none_or(|choice| choice.value == VirtualDerivative::Filter);
        let disturbed = plant.disturbance.is_some();
        let bounded = matches!(
            plant.disturbance.as_ref().map(|written| &written.value),
            Some(Disturbance::Bounded(_))
        );
        let noisy = plant.noise.is_some();
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
                inner && filtered,
                "in every block but the last, with `virtual_derivative: filter`",
                None,
            ),
            need("eta_1", disturbed, observed, disturbance),
            need("eta_2", inner, chain, None),
            need("eta_3", inner, chain, None),
            need(
                "eta_noise",
                noisy && disturbed,
                "in a block with noise and a disturbance",
                match (noisy, disturbed) {
                    (true, _) => disturbance,
                    (_, true) => noise,
                    _ => Some("both `noise` and a `disturbance`"),
                },
            ),
            need("observer", disturbed, observed, disturbance),
            need(
                "error_bound",
                own.network.is_some() && !bounded,
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
                (true, None) => {
                    let message = format!("`{}` is missing in block `{}`", need.key, block.value);
                    let help = format!("add `{}: ..`; it is needed {}", need.key, need.when);
                    let fault = Diagnostic::error(Rule::E0118, block.span, message).with_help(help);
                    let feature = self.feature(at, &gains.value, need.key);
                    self.faults.push(match feature {
                        Some(place) => fault.with_related(place, "this needs it"),
                        None => fault,
                    });
                }
                (false, Some(&span)) => {
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
