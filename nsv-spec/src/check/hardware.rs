//! Guarantees that actuators and sensors have numbers in the units of what they move and measure, and that faults come in order.

use super::Context;
use super::dispersion::Dispersed;
use super::plant::SECOND;
use crate::diagnostic::{Rule, Span, rounded};
use crate::model::{Actuator, Effect, Fault, Scenario, Sensor};
use crate::spec::{self, Bias, Code, Unreadable};
use crate::unit::Dimension;

/// Most plant steps of a delay.
pub(super) const MAX_DELAY: f64 = 1000.0;
/// How far from a whole number of plant steps roundings may leave a delay.
const ROUNDING: f64 = 1e-6;

impl Context<'_> {
    /// How the command of an input reaches the plant.
    pub(super) fn actuator(
        &mut self,
        written: &spec::Actuator,
        input: &str,
        dimension: Dimension,
    ) -> Option<Actuator> {
        let of = |term: &str| format!("{term} of input `{input}`");
        let quantum = self.size(written.quantum.as_ref(), &of("quantum"), dimension);
        let delay = self.size(written.delay.as_ref(), &of("delay"), SECOND);
        let lag = self.size(written.lag.as_ref(), &of("lag"), SECOND);
        let rate_limit = match &written.rate_limit {
            None => Some(None),
            Some(code) => (self.rate_limit(code, &of("rate limit"), dimension)).map(Some),
        };
        let faults = self.faults_of(&written.faults, input, dimension);
        Some(Actuator {
            delay: delay?,
            quantum: quantum?,
            lag: lag?,
            rate_limit: rate_limit?,
            faults: faults?,
        })
    }

    /// A number from 0 that may be left out.
    fn size(&mut self, code: Option<&Code>, what: &str, dimension: Dimension) -> Option<f64> {
        let Some(code) = code else {
            return Some(0.0);
        };
        let value = self.quantity(code, what, dimension)?;
        self.not_negative(value, code.base.span, what)?;
        Some(value)
    }

    fn rate_limit(&mut self, code: &Code, what: &str, dimension: Dimension) -> Option<f64> {
        let value = self.quantity(code, what, dimension.checked_div(SECOND)?)?;
        self.positive(value, code.base.span, what)?;
        Some(value)
    }

    fn faults_of(
        &mut self,
        written: &[spec::Fault],
        input: &str,
        dimension: Dimension,
    ) -> Option<Vec<Fault>> {
        let mut faults = Vec::new();
        let mut last = 0.0;
        for fault in written {
            let what = format!("time of a fault of input `{input}`");
            let at = self.quantity(&fault.at, &what, SECOND)?;
            if at < last {
                let message = format!("{what} is {at} s, expected at least {last} s");
                self.fault(
                    Rule::E0602,
                    fault.at.base.span,
                    message,
                    "write faults in order of time",
                );
                return None;
            }
            last = at;
            let effect = match &fault.effect {
                spec::Effect::Effectiveness(code) => {
                    let what = format!("effectiveness of input `{input}`");
                    Effect::Effectiveness(self.probability(code, &what)?)
                }
                spec::Effect::Stuck(None) => Effect::Stuck(None),
                spec::Effect::Stuck(Some(code)) => {
                    let what = format!("position of input `{input}`");
                    Effect::Stuck(Some(self.quantity(code, &what, dimension)?))
                }
            };
            faults.push(Fault { at, effect });
        }
        Some(faults)
    }

    /// How a state is measured.
    pub(super) fn sensor(
        &mut self,
        written: &spec::Sensor,
        state: &str,
        dimension: Dimension,
    ) -> Option<Sensor> {
        let of = |term: &str| format!("{term} of the sensor of `{state}`");
        let what = of("bias");
        let bias = match &written.bias {
            None => Some((0.0, None)),
            Some(Err(Unreadable)) => None,
            Some(Ok(Bias::Fixed(code))) => {
                (self.quantity(code, &what, dimension)).map(|bias| (bias, None))
            }
            Some(Ok(Bias::Drawn(dispersion))) => {
                let of = Dispersed {
                    what: &what,
                    dimension,
                    unit: None,
                };
                let drawn = self.dispersion(dispersion, &of);
                drawn.map(|drawn| (drawn.nominal(), Some(drawn)))
            }
        };
        let noise = self.size(written.noise.as_ref(), &of("noise"), dimension);
        let quantum = self.size(written.quantum.as_ref(), &of("quantum"), dimension);
        let dropout = match &written.dropout {
            None => Some(0.0),
            Some(code) => self.probability(code, &of("dropout")),
        };
        let (bias, drawn_bias) = bias?;
        Some(Sensor {
            bias,
            drawn_bias,
            noise: noise?,
            quantum: quantum?,
            dropout: dropout?,
        })
    }

    /// Delays are whole numbers of plant steps.
    pub(super) fn check_delays(&mut self, sample_time: f64, scenario: &Scenario) {
        let step = sample_time / f64::from(scenario.substeps);
        let inputs: Vec<(f64, Span, String)> = (self.spec.inputs.iter())
            .zip(self.inputs.iter().flatten())
            .filter_map(|(written, input)| {
                let code = written.value.actuator.as_ref()?.delay.as_ref()?;
                let delay = input.actuator.as_ref()?.delay;
                Some((delay / step, code.base.span, input.name.clone()))
            })
            .collect();
        for (steps, span, input) in inputs {
            let whole = steps.round();
            if (steps - whole).abs() > ROUNDING || whole > MAX_DELAY {
                let message = format!(
                    "delay of input `{input}` is {} plant steps, expected a whole number up to {MAX_DELAY}",
                    rounded(steps)
                );
                let nearest = whole.min(MAX_DELAY) * step;
                let help = format!(
                    "a plant step takes {} s, the sample time divided by `substeps`: the nearest delay is {} s",
                    rounded(step),
                    rounded(nearest)
                );
                self.fault(Rule::E0613, span, message, help);
            }
        }
    }
}
