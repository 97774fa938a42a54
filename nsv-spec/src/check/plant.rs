//! Guarantees that F_i and G_i have the shapes and units of the chain: F_i a state per second, G_i a state per second for each
//! unit of the next state or input.

use super::Context;
use crate::diagnostic::{Rule, Span};
use crate::expr::Expected;
use crate::expr::arena::{ExprId, Shape};
use crate::model::{self, Disturbance, Noise};
use crate::spec::{Named, Word};
use crate::unit::Dimension;

pub(super) const SECOND: Dimension = Dimension::new(0, 0, 1, 0);

/// The plant's side of a block; `None` for what has a fault.
pub(super) struct PlantBlock {
    pub(super) drift: Option<ExprId>,
    pub(super) gain: Option<ExprId>,
    pub(super) disturbance: Option<Disturbance>,
    pub(super) noise: Option<Option<Noise>>,
}

impl Context<'_> {
    /// Checks F, G, d and H of a block.
    pub(super) fn check_plant_block(
        &mut self,
        at: usize,
        inputs: Option<&[model::Input]>,
    ) -> PlantBlock {
        let spec = self.spec;
        let Named {
            name,
            value: written,
        } = &spec.blocks[at];
        let own = self.channel_dimensions(at, inputs);
        let next = self.channel_dimensions(at + 1, inputs);
        let rates = (own.as_ref()).and_then(|own| self.ratios(own, &[SECOND], name.span));
        let what = |term: &str| format!("{term} of block `{}`", name.value);
        let (drift_of, gain_of) = (what("drift"), what("gain"));
        let reasons = self.rate_reasons(at);
        let columns = self.column_reasons(at + 1, inputs);
        let expected = rates.as_deref().map(|rates| Expected {
            what: &drift_of,
            shape: Shape::Vector(rates.len()),
            dimensions: rates,
            reasons: &reasons,
            columns: &[],
        });
        let drift = self.formula(&written.drift, expected.as_ref());
        if let Some((_, parsed)) = &drift {
            self.check_feedback(parsed, "drift", at);
        }
        let channels = rates.as_ref().zip(next.as_ref());
        let gains = channels.and_then(|(rates, next)| self.ratios(rates, next, name.span));
        let expected = channels
            .zip(gains.as_deref())
            .map(|((rates, next), gains)| Expected {
                what: &gain_of,
                shape: Shape::Matrix(rates.len(), next.len()),
                dimensions: gains,
                reasons: &reasons,
                columns: &columns,
            });
        let gain = self.formula(&written.gain, expected.as_ref());
        if let Some((_, parsed)) = &gain {
            self.check_feedback(parsed, "gain", at);
        }
        let disturbance = self.disturbance(
            written.disturbance.as_ref(),
            rates.as_deref(),
            &reasons,
            &what("disturbance"),
        );
        let noise = match &written.noise {
            Some(noise) => self.noise(at, noise, own.as_deref()).map(Some),
            None => Some(None),
        };
        PlantBlock {
            drift: drift.map(|(id, _)| id),
            gain: gain.map(|(id, _)| id),
            disturbance,
            noise,
        }
    }

    /// Why each row of F and G is in a state's unit per second.
    fn rate_reasons(&self, at: usize) -> Vec<(Span, String)> {
        let states = self.states[at].iter().flatten();
        let written = self.spec.blocks[at].value.states.iter();
        states
            .zip(written)
            .map(|(state, written)| rate_reason(&written.name, state.dimension))
            .collect()
    }

    /// What each column of G turns into those rates: the states of a block, or the inputs for the index after the last.
    fn column_reasons(&self, block: usize, inputs: Option<&[model::Input]>) -> Vec<(Span, String)> {
        let reason = |noun: &str, name: &str, dimension: Dimension, span| {
            (span, format!("{noun} `{name}` is {}", dimension.in_words()))
        };
        match (self.states.get(block), inputs) {
            (Some(states), _) => {
                let written = self.spec.blocks[block].value.states.iter();
                let states = states.iter().flatten().zip(written);
                states
                    .map(|(state, written)| {
                        reason("state", &state.name, state.dimension, written.name.span)
                    })
                    .collect()
            }
            (None, Some(inputs)) => {
                let written = self.spec.inputs.iter();
                let inputs = inputs.iter().zip(written);
                inputs
                    .map(|(input, written)| {
                        reason("input", &input.name, input.dimension, written.name.span)
                    })
                    .collect()
            }
            (None, None) => Vec::new(),
        }
    }

    /// Dimensions of the states of a block, or of the inputs for the index after the last; `None` where some are not known.
    fn channel_dimensions(
        &self,
        block: usize,
        inputs: Option<&[model::Input]>,
    ) -> Option<Vec<Dimension>> {
        let width = self.width?;
        let dimensions: Vec<Dimension> = match self.states.get(block) {
            Some(states) => (states.as_ref()?.iter())
                .map(|state| state.dimension)
                .collect(),
            None => inputs?.iter().map(|input| input.dimension).collect(),
        };
        (dimensions.len() == width).then_some(dimensions)
    }

    /// Every quotient of an entry of `above` by one of `below`, row by row.
    pub(super) fn ratios(
        &mut self,
        above: &[Dimension],
        below: &[Dimension],
        span: Span,
    ) -> Option<Vec<Dimension>> {
        let ratios: Option<Vec<Dimension>> = above
            .iter()
            .flat_map(|a| below.iter().map(|b| a.checked_div(*b)))
            .collect();
        if ratios.is_none() {
            self.fault(
                Rule::E0606,
                span,
                "unit of a state has an exponent out of range",
                "choose simpler units",
            );
        }
        ratios
    }
}

/// What the dimension of a function of time follows from.
pub(super) fn state_reason(state: &Word, dimension: Dimension) -> (Span, String) {
    let reason = format!("state `{}` is {}", state.value, dimension.in_words());
    (state.span, reason)
}

/// What the dimension of a state's rate follows from.
pub(super) fn rate_reason(state: &Word, dimension: Dimension) -> (Span, String) {
    let reason = format!(
        "state `{}` is {}, its rate is that per second",
        state.value,
        dimension.in_words()
    );
    (state.span, reason)
}
