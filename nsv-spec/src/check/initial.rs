//! Guarantees that the closed loop can start: finite dynamics, invertible gains, and an error inside its constraint.

use super::Context;
use super::linear::reciprocal_condition;
use crate::diagnostic::{Rule, Span};
use crate::expr::arena::ExprId;
use crate::model::{Matrix, Model};

/// Smallest reciprocal condition of an invertible gain.
const SINGULAR: f64 = 1e-10;

/// Where expressions are evaluated.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point {
    pub(super) time: f64,
    /// Whether parameters have their design values rather than the plant's.
    pub(super) design: bool,
}

impl Point {
    /// A time, with the plant's parameters.
    pub(super) fn at(time: f64) -> Self {
        Point {
            time,
            design: false,
        }
    }
}

impl Context<'_> {
    /// Checks the model at its initial state, with the plant's and with the controller's parameters.
    pub(super) fn check_initial(&mut self, model: &Model) {
        for design in [false, true] {
            let before = self.faults.len();
            let point = Point { time: 0.0, design };
            for at in 0..model.blocks.len() {
                self.check_initial_block(model, at, &point);
            }
            self.check_initial_error(model, &point);
            let differ = model
                .parameters
                .iter()
                .any(|parameter| parameter.value != parameter.design_value);
            if !differ || self.faults.len() > before {
                break;
            }
        }
        self.check_initial_truth(model);
        self.check_signal_values(model);
    }

    /// Rates of the flown plant at the initial state, with the plant's parameters and the inputs at their safe values.
    fn check_initial_truth(&mut self, model: &Model) {
        let spec = self.spec;
        let (Some(truth), Some(written)) = (&model.truth, &spec.truth) else {
            return;
        };
        let own = (model.blocks.iter().flat_map(|block| &block.states))
            .zip(truth.replaced.iter().flatten())
            .filter_map(|(state, rate)| Some((state, (*rate)?)));
        let further = truth.states.iter().zip(truth.rates.iter().copied());
        for (state, rate) in own.chain(further) {
            let written = &written.value.rates;
            let span = (written.iter().find(|rate| rate.name.value == state.name))
                .map_or(spec.name.span, |rate| rate.value.span());
            let what = format!("rate of `{}` at the initial state", state.name);
            self.finite(rate, span, &what, &Point::at(0.0));
        }
    }

    fn check_initial_block(&mut self, model: &Model, at: usize, point: &Point) {
        let spec = self.spec;
        let (block, written) = (&model.blocks[at], &spec.blocks[at].value);
        let name = &block.name;
        self.finite(
            block.drift,
            written.drift.span(),
            &format!("drift of block `{name}` at the initial state"),
            point,
        );
        if let (Some(noise), Some(written)) = (&block.noise, &written.noise) {
            let span = written.value.effectiveness.span();
            self.finite(
                noise.effectiveness,
                span,
                &format!("noise effectiveness of block `{name}` at the initial state"),
                point,
            );
        }
        let span = written.gain.span();
        let Some(data) = self.finite(
            block.gain,
            span,
            &format!("gain of block `{name}` at the initial state"),
            point,
        ) else {
            return;
        };
        let width = block.states.len();
        let condition = reciprocal_condition(&Matrix {
            rows: width,
            cols: width,
            data,
        });
        if condition.is_nan() || condition < SINGULAR {
            let message = format!(
                "gain of block `{name}` is singular at the initial state (reciprocal condition {condition:.1e})"
            );
            self.fault(
                Rule::E0704,
                span,
                message,
                "every channel of the next block or input must act, each in its own direction",
            );
        }
    }

    /// The values of an expression, if all are finite.
    fn finite(&mut self, id: ExprId, span: Span, what: &str, point: &Point) -> Option<Vec<f64>> {
        let values = self.evaluate(id, point);
        let Some(at) = values.iter().position(|value| !value.is_finite()) else {
            return Some(values);
        };
        let entry = if values.len() == 1 {
            String::new()
        } else {
            format!("entry {} of ", at + 1)
        };
        let message = format!("{entry}{what} is {}, expected a finite number", values[at]);
        self.fault(
            Rule::E0706,
            span,
            message,
            "look for a division by zero, a root or logarithm of a negative number, or a table with `extrapolation: error`",
        );
        None
    }

    /// ||e_1(0)|| < k_1(0) with e_1(0) = x_1(0) - y_r(0).
    fn check_initial_error(&mut self, model: &Model, point: &Point) {
        let spec = self.spec;
        let reference_span = spec.reference.span;
        let Some(reference) = self.finite(
            model.reference,
            reference_span,
            "reference at t = 0 s",
            point,
        ) else {
            return;
        };
        let output = &model.blocks[0];
        let Some(constraint) = output.constraint else {
            return;
        };
        let bound = self.evaluate(constraint, point)[0];
        let squares = output
            .states
            .iter()
            .zip(&reference)
            .map(|(state, reference)| (state.initial - reference) * (state.initial - reference));
        let error = libm::sqrt(squares.sum());
        if error >= bound {
            let (unit, factor) = &output.states[0].display;
            let span = spec
                .controller
                .blocks
                .value
                .iter()
                .find(|gains| gains.name.value == output.name);
            let span = span
                .and_then(|gains| gains.value.constraint.as_ref())
                .map_or(reference_span, |formula| formula.span());
            let message = format!(
                "initial error of block `{}` violates its constraint: ||e(0)|| = {:.4} {unit}, expected less than k(0) = {:.4} {unit}",
                output.name,
                error / factor,
                bound / factor
            );
            self.fault(
                Rule::E0705,
                span,
                message,
                "start nearer to the reference, or widen the constraint",
            );
        }
    }

    /// The reference and bounded disturbances are finite over the horizon.
    fn check_signal_values(&mut self, model: &Model) {
        let horizon = model.scenario.horizon;
        let mut signals = vec![(
            model.reference,
            self.spec.reference.span,
            "reference".to_owned(),
        )];
        for (block, written) in model.blocks.iter().zip(&self.spec.blocks) {
            if let (crate::model::Disturbance::Bounded(id), Some(written)) =
                (&block.disturbance, &written.value.disturbance)
            {
                signals.push((
                    *id,
                    written.span,
                    format!("disturbance of block `{}`", block.name),
                ));
            }
        }
        let times = self.sample_times(horizon);
        for (id, span, what) in signals {
            for &t in &times[1..] {
                if self
                    .finite(id, span, &format!("{what} at t = {t} s"), &Point::at(t))
                    .is_none()
                {
                    break;
                }
            }
        }
    }
}
