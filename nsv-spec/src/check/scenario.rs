//! Guarantees that a scenario ends in reasonable time, and that its scheme can integrate its noise.

use super::Context;
use super::plant::SECOND;
use crate::diagnostic::{Rule, Span, rounded};
use crate::model::{MAX_RUNS, MAX_STEPS, NoiseModel, Scenario, Scheme};
use crate::spec::{self, Located};

pub(super) const MAX_SUBSTEPS: u64 = 1000;
/// Sample times outside this range are slips of a unit, s.
const SAMPLE_TIMES: (f64, f64) = (1e-6, 10.0);

impl Context<'_> {
    /// The controller's sample time.
    pub(super) fn sample_time(&mut self) -> Option<f64> {
        let code = &self.spec.controller.sample_time;
        let value = self.quantity(code, "sample time", SECOND)?;
        let (least, largest) = SAMPLE_TIMES;
        if (least..=largest).contains(&value) {
            return Some(value);
        }
        self.fault(
            Rule::E0602,
            code.base.span,
            format!("sample time is {value} s, expected {least} s to {largest} s"),
            "it is the time from one step of the controller to the next, mostly some milliseconds: `2 ms`",
        );
        None
    }

    /// The length of a run, at least one sample.
    pub(super) fn horizon(&mut self) -> Option<f64> {
        let code = &self.spec.scenario.horizon;
        let value = self.quantity(code, "horizon", SECOND)?;
        self.positive(value, code.base.span, "horizon")?;
        Some(value)
    }

    /// Checks the scenario, given the sample time and the horizon, if they are right.
    pub(super) fn scenario(
        &mut self,
        sample_time: Option<f64>,
        horizon: Option<f64>,
    ) -> Option<Scenario> {
        let written = &self.spec.scenario;
        let substeps = self.count_or(
            written.substeps,
            4,
            (1, MAX_SUBSTEPS),
            "substeps",
            "plant steps per sample",
        );
        let seed = self.count_or(written.seed, 1, (0, u64::MAX), "seed", "any number will do");
        let runs = self.count_or(written.runs, 1, (1, MAX_RUNS), "runs", "a single run");
        let settle = match &written.settle {
            Some(code) => self.settle(code, horizon),
            None => {
                self.default(
                    "scenario.settle".into(),
                    "0 s",
                    "rms values over the whole run",
                );
                Some(0.0)
            }
        };
        let chosen = self.scheme();
        let (substeps, span) = (substeps?, written.horizon.base.span);
        let (sample_time, horizon) = (sample_time?, horizon?);
        let steps = horizon / sample_time * substeps as f64;
        if horizon < sample_time {
            self.fault(
                Rule::E0602,
                span,
                format!("horizon {horizon} s is shorter than the sample time {sample_time} s"),
                "simulate at least one sample",
            );
            return None;
        }
        if steps > MAX_STEPS {
            self.fault(
                Rule::E0602,
                span,
                format!("a run has {steps:.1e} steps, expected at most {MAX_STEPS:.0e}"),
                format!(
                    "with this sample time the horizon may be {} s at most",
                    rounded(MAX_STEPS * sample_time / substeps as f64)
                ),
            );
            return None;
        }
        let (scheme, noise) = chosen?;
        let substeps = u32::try_from(substeps).expect("invariant: substeps are capped");
        Some(Scenario {
            horizon,
            substeps,
            scheme,
            noise,
            seed: seed?,
            runs: runs?,
            settle: settle?,
        })
    }

    fn settle(&mut self, code: &spec::Code, horizon: Option<f64>) -> Option<f64> {
        let value = self.quantity(code, "settle", SECOND)?;
        let horizon = horizon?;
        if (0.0..horizon).contains(&value) {
            return Some(value);
        }
        let message =
            format!("settle is {value} s, expected 0 s up to less than the horizon {horizon} s");
        self.fault(
            Rule::E0602,
            code.base.span,
            message,
            "it is the start of the window for rms values and settled ratios",
        );
        None
    }

    /// Scheme and noise model; Runge-Kutta is for functions of time, which Wiener increments are not.
    fn scheme(&mut self) -> Option<(Scheme, NoiseModel)> {
        let written = &self.spec.scenario;
        let (scheme, noise) = (written.scheme.ok()?, written.noise.ok()?);
        let noise = noise.map(|noise| noise.value).unwrap_or_else(|| {
            self.default(
                "scenario.noise".into(),
                "sampled",
                "one draw for each sample, as in the paper's simulation",
            );
            NoiseModel::Sampled
        });
        let chosen = match (scheme, noise) {
            (Some(scheme), _) => scheme.value,
            (None, NoiseModel::Sampled) => {
                self.default("scenario.scheme".into(), "rk4", "noise is sampled");
                Scheme::RungeKutta4
            }
            (None, NoiseModel::Wiener) => {
                self.default(
                    "scenario.scheme".into(),
                    "euler_maruyama",
                    "converges for every Wiener noise",
                );
                Scheme::EulerMaruyama
            }
        };
        if let (
            Some(Located {
                value: Scheme::RungeKutta4,
                span,
            }),
            NoiseModel::Wiener,
        ) = (scheme, noise)
        {
            let help = "write `scheme: euler_maruyama` or `platen`, or `noise: sampled`";
            self.fault(
                Rule::E0610,
                span,
                "scheme rk4 cannot integrate wiener noise",
                help,
            );
        }
        Some((chosen, noise))
    }

    fn count_or(
        &mut self,
        written: Option<Located<u64>>,
        otherwise: u64,
        range: (u64, u64),
        key: &str,
        reason: &str,
    ) -> Option<u64> {
        match written {
            Some(Located { value, span }) => self.in_range(value, range, span, key),
            None => {
                self.default(format!("scenario.{key}"), &otherwise.to_string(), reason);
                Some(otherwise)
            }
        }
    }

    fn in_range(
        &mut self,
        value: u64,
        (least, largest): (u64, u64),
        span: Span,
        key: &str,
    ) -> Option<u64> {
        if (least..=largest).contains(&value) {
            return Some(value);
        }
        self.fault(
            Rule::E0602,
            span,
            format!("`{key}` is {value}, expected {least} to {largest}"),
            match key {
                "substeps" => "it is the number of plant steps per sample: 1 to 4 mostly suffice",
                _ => "choose a number in this range",
            },
        );
        None
    }
}
