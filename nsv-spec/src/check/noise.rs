//! Guarantees that H_i Sigma_i is a state per second (sampled noise) or per root second (Wiener noise).

use super::Context;
use super::plant::SECOND;
use super::scope::Place;
use crate::diagnostic::{Applicability, Rule, Span, Suggestion};
use crate::expr::Expected;
use crate::expr::arena::{ExprId, Shape, Type};
use crate::model::{Noise, NoiseModel, Scheme};
use crate::spec::{self, Located};
use crate::unit::Dimension;

impl Context<'_> {
    /// Diffusion of a block.
    pub(super) fn noise(
        &mut self,
        at: usize,
        written: &Located<spec::Noise>,
        own: Option<&[Dimension]>,
    ) -> Option<Noise> {
        let spec::Noise {
            effectiveness,
            intensity,
        } = &written.value;
        let block = &self.spec.blocks[at].name;
        let what = format!("noise effectiveness of block `{}`", block.value);
        let sigma = self.numbers_for(
            intensity,
            &format!("noise intensity of block `{}`", block.value),
        );
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
        let (own, model) = (own?, self.noise_model()?);
        let reason = self.noise_reason(model);
        let rates = self.ratios(own, &[unit_of(model)?], block.span)?;
        let dimensions = self.ratios(&rates, &sigma.dimensions, block.span)?;
        let before = self.faults.len();
        let checked = self.expect(
            id,
            &parsed,
            &Expected {
                what: &what,
                shape: Shape::Matrix(own.len(), channels),
                dimensions: &dimensions,
                reasons: &vec![reason; own.len()],
                columns: &[],
            },
        );
        let Some(effectiveness) = checked else {
            if self.fits_other_model(id, model, own, &sigma.dimensions, &dimensions) {
                self.suggest_other_model(before, model, &dimensions);
            }
            return None;
        };
        Some(Noise {
            effectiveness,
            intensity: sigma.values,
        })
    }

    fn noise_model(&self) -> Option<NoiseModel> {
        let written = self.spec.scenario.noise.ok()?;
        Some(written.map_or(NoiseModel::Sampled, |noise| noise.value))
    }

    /// The place that says which noise it is, and what follows for its unit.
    fn noise_reason(&self, model: NoiseModel) -> (Span, String) {
        let scenario = &self.spec.scenario;
        let noise = scenario.noise.ok().flatten();
        let span = noise.map_or(scenario.horizon.base.span, |noise| noise.span);
        let (word, per) = match model {
            NoiseModel::Wiener => ("wiener", "per sqrt(s)"),
            NoiseModel::Sampled => ("sampled", "per second"),
        };
        (
            span,
            format!("{word} noise: effectiveness times intensity has the unit of a state {per}"),
        )
    }

    /// Whether the other kind of noise takes the units that are written.
    fn fits_other_model(
        &self,
        effectiveness: ExprId,
        model: NoiseModel,
        own: &[Dimension],
        sigma: &[Dimension],
        expected: &[Dimension],
    ) -> bool {
        let Type::Real { dimensions, .. } = self.arena.ty(effectiveness) else {
            return false;
        };
        let other = |(at, found): (usize, &Dimension)| {
            let state = own.get(at / sigma.len())?;
            let rate = state.checked_div(unit_of(other(model))?)?;
            let wanted = rate.checked_div(sigma[at % sigma.len()])?;
            Some(found.agree(wanted).is_some())
        };
        dimensions.len() == expected.len()
            && dimensions
                .iter()
                .enumerate()
                .all(|pair| other(pair) == Some(true))
    }

    /// The faults from number `before` on, mended by the kind of noise whose units they have.
    fn suggest_other_model(&mut self, before: usize, model: NoiseModel, wanted: &[Dimension]) {
        let scenario = &self.spec.scenario;
        let (noise, scheme) = (
            scenario.noise.ok().flatten(),
            scenario.scheme.ok().flatten(),
        );
        let (word, amplitude) = match model {
            NoiseModel::Sampled => ("wiener", "the amplitude of sampled noise"),
            NoiseModel::Wiener => ("sampled", "the intensity of wiener noise"),
        };
        // Runge-Kutta cannot integrate Wiener noise.
        let runge_kutta = scheme
            .filter(|scheme| scheme.value == Scheme::RungeKutta4 && model == NoiseModel::Sampled);
        let write = match (noise, runge_kutta) {
            (_, Some(_)) => "write `noise: wiener` with `scheme: euler_maruyama`".to_owned(),
            (Some(_), None) => format!("write `noise: {word}`"),
            (None, None) => format!("add `noise: {word}` to `scenario`"),
        };
        let unit = match wanted {
            [first, rest @ ..] if rest.iter().all(|other| other == first) => first.in_words(),
            _ => "in the expected unit".to_owned(),
        };
        for fault in &mut self.faults[before..] {
            if fault.rule != Rule::E0407 {
                continue;
            }
            fault.help = Some(format!(
                "{write}, which takes this unit; or give {amplitude}, {unit}"
            ));
            if let (Some(noise), None) = (noise, runge_kutta) {
                fault.suggestion = Some(Suggestion {
                    span: noise.span,
                    replacement: word.to_owned(),
                    applicability: Applicability::Possible,
                });
            }
        }
    }
}

/// What the noise is a state per: a held draw is a rate, a Wiener process has unit sqrt(s).
fn unit_of(model: NoiseModel) -> Option<Dimension> {
    match model {
        NoiseModel::Wiener => SECOND.checked_sqrt(),
        NoiseModel::Sampled => Some(SECOND),
    }
}

fn other(model: NoiseModel) -> NoiseModel {
    match model {
        NoiseModel::Wiener => NoiseModel::Sampled,
        NoiseModel::Sampled => NoiseModel::Wiener,
    }
}
