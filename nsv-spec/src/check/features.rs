//! Guarantees that a block has the gains that its features need, and no others.

use super::Context;
use crate::diagnostic::{Diagnostic, Rule, Span};
use crate::model::VirtualDerivative;
use crate::spec::{Code, Disturbance, Formula};

/// A gain, where it is written if it is, and whether the block needs it.
struct Need {
    key: &'static str,
    given: Option<Span>,
    needed: bool,
    /// When it is needed.
    when: &'static str,
}

impl Context<'_> {
    /// Checks the presence of every optional gain of a block.
    pub(super) fn check_features(
        &mut self,
        at: usize,
        gains: &crate::spec::Named<crate::spec::ControllerBlock>,
    ) {
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
        let own = &gains.value;
        let code = |code: &Option<Code>| code.as_ref().map(|code| code.base.span);
        let formula = |formula: &Option<Formula>| formula.as_ref().map(Formula::span);
        let need = |key, given, needed, when| Need {
            key,
            given,
            needed,
            when,
        };
        let chain = "in every block but the last";
        let needs = [
            need(
                "filter",
                formula(&own.filter),
                inner && filtered,
                "in every block but the last, with `virtual_derivative: filter`",
            ),
            need(
                "eta_1",
                code(&own.eta_1),
                disturbed,
                "in a block with a disturbance",
            ),
            need("eta_2", code(&own.eta_2), inner, chain),
            need("eta_3", code(&own.eta_3), inner, chain),
            need(
                "eta_noise",
                code(&own.eta_noise),
                noisy && disturbed,
                "in a block with noise and an observer",
            ),
            need(
                "observer",
                formula(&own.observer),
                disturbed,
                "in a block with a disturbance",
            ),
            need(
                "error_bound",
                own.error_bound.as_ref().map(|bound| bound.span),
                own.network.is_some() && !bounded,
                "in a block with a network and no `bounded` disturbance",
            ),
            need(
                "noise_bound",
                own.noise_bound.as_ref().map(|bound| bound.span),
                noisy,
                "in a block with noise",
            ),
        ];
        let missing: Vec<&Need> = needs
            .iter()
            .filter(|need| need.needed && need.given.is_none())
            .collect();
        for need in missing {
            let message = format!("`{}` is missing in block `{}`", need.key, gains.name.value);
            let fault = Diagnostic::error(Rule::E0118, gains.name.span, message);
            self.faults
                .push(fault.with_help(format!("`{}` is needed {}", need.key, need.when)));
        }
        for need in needs.iter().filter(|need| !need.needed) {
            let Some(span) = need.given else { continue };
            let message = format!("`{}` has no use in block `{}`", need.key, gains.name.value);
            self.fault(
                Rule::E0119,
                span,
                message,
                format!("remove it; it is used {} only", need.when),
            );
        }
    }
}
