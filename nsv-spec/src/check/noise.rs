//! Guarantees that H_i Sigma_i is a state per second (sampled noise) or per root second (Wiener noise).

use super::Context;
use super::plant::SECOND;
use super::scope::Place;
use crate::diagnostic::{Rule, Span};
use crate::expr::Expected;
use crate::expr::arena::Shape;
use crate::model::{Noise, NoiseModel};
use crate::spec::{self, Located};
use crate::unit::Dimension;

impl Context<'_> {
    /// Diffusion of a block.
    pub(super) fn noise(
        &mut self,
        at: usize,
        written: &Located<spec::Noise>,
        own: &[Dimension],
    ) -> Option<Noise> {
        let spec::Noise {
            effectiveness,
            intensity,
        } = &written.value;
        let block = &self.spec.blocks[at].name;
        let what = format!("noise effectiveness of block `{}`", block.value);
        let sigma = self.numbers(intensity);
        let parsed = self.parse_formula(effectiveness)?;
        let id = self.elaborate(&parsed, Place::Model)?;
        self.check_feedback(&parsed, "noise effectiveness", at);
        let sigma = sigma?;
        let channels = sigma.values.len();
        if let Some(value) = sigma.values.iter().find(|value| **value < 0.0) {
            self.fault(
                Rule::E0601,
                sigma.span,
                format!(
                    "noise intensity of block `{}` is {value}, expected at least 0",
                    block.value
                ),
                "write the standard deviation",
            );
            return None;
        }
        let (per, reason) = self.noise_model();
        let rates = self.ratios(own, &[per?], block.span)?;
        let dimensions = self.ratios(&rates, &sigma.dimensions, block.span)?;
        let effectiveness = self.expect(
            id,
            parsed.span(),
            &Expected {
                what: &what,
                shape: Shape::Matrix(own.len(), channels),
                dimensions: &dimensions,
                reasons: &vec![reason; own.len()],
                columns: &[],
            },
        )?;
        Some(Noise {
            effectiveness,
            intensity: sigma.values,
        })
    }

    /// What the noise is a state per: a held draw is a rate, a Wiener process has unit sqrt(s); and the place that says which.
    fn noise_model(&self) -> (Option<Dimension>, (Span, String)) {
        let written = self.spec.scenario.noise;
        let span = written.map_or(self.spec.scenario.horizon.base.span, |noise| noise.span);
        match written.map(|noise| noise.value) {
            Some(NoiseModel::Wiener) => (
                SECOND.checked_sqrt(),
                (
                    span,
                    "wiener noise: effectiveness times intensity is a state per sqrt(s)".to_owned(),
                ),
            ),
            _ => (
                Some(SECOND),
                (
                    span,
                    "sampled noise: effectiveness times intensity is a state per second".to_owned(),
                ),
            ),
        }
    }
}
