//! Guarantees that H_i Sigma_i is a state per second (sampled noise) or per root second (Wiener noise).

use super::Context;
use super::plant::SECOND;
use super::scope::Place;
use crate::diagnostic::Rule;
use crate::expr::Expected;
use crate::expr::arena::Shape;
use crate::model::Noise;
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
        let shape = Shape::Matrix(own.len(), channels);
        let rates = self.ratios(own, &[SECOND], block.span)?;
        let densities = self.ratios(own, &[SECOND.checked_sqrt()?], block.span)?;
        // One scaling fits all entries: the noise is either a rate, or a density of white noise.
        let sampled = self.ratios(&rates, &sigma.dimensions, block.span)?;
        let white = self.ratios(&densities, &sigma.dimensions, block.span)?;
        let is_white = crate::expr::expect(
            &self.arena,
            id,
            parsed.span(),
            &Expected {
                what: &what,
                shape,
                dimensions: &white,
                reasons: &[],
                columns: &[],
            },
        )
        .is_ok();
        let dimensions = if is_white { &white } else { &sampled };
        let effectiveness = self.expect(
            id,
            parsed.span(),
            &Expected {
                what: &what,
                shape,
                dimensions,
                reasons: &[],
                columns: &[],
            },
        )?;
        Some(Noise {
            effectiveness,
            intensity: sigma.values,
        })
    }
}
