//! Guarantees that the closed loop can start: finite dynamics, invertible gains, and an error inside its constraint.

use super::Context;
use super::linear::reciprocal_condition;
use crate::diagnostic::{Diagnostic, Rule, Span};
use crate::expr::arena::{ExprId, Shape};
use crate::model::{Disturbance, Matrix, Model};
use crate::spec::{self, Formula};

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

impl<'a> Context<'a> {
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
            let mut rates = written.value.rates.iter();
            let written = rates.find(|rate| rate.name.value == state.name);
            let written = written.expect("invariant: the rate was made of what is written");
            let what = format!("rate of `{}`", state.name);
            self.finite(rate, &[&written.value], &[what], &Point::at(0.0));
        }
    }

    fn check_initial_block(&mut self, model: &Model, at: usize, point: &Point) {
        let spec = self.spec;
        let (block, written) = (&model.blocks[at], &spec.blocks[at].value);
        let name = &block.name;
        let of = |term: &str| [format!("{term} of block `{name}`")];
        self.finite(block.drift, &[&written.drift], &of("drift"), point);
        if let (Some(noise), Some(written)) = (&block.noise, &written.noise) {
            let written = &written.value.effectiveness;
            let what = of("noise effectiveness");
            self.finite(noise.effectiveness, &[written], &what, point);
        }
        let Some(data) = self.finite(block.gain, &[&written.gain], &of("gain"), point) else {
            return;
        };
        let width = block.states.len();
        let condition = reciprocal_condition(&Matrix {
            rows: width,
            cols: width,
            data,
        });
        if condition.is_nan() || condition < SINGULAR {
            let (message, help) = match width {
                1 => (
                    format!("gain of block `{name}` is 0 at the start"),
                    "the next state or input must act on the block",
                ),
                _ => (
                    format!(
                        "gain of block `{name}` is singular at the start: its channels do not act in {width} directions"
                    ),
                    "every channel of the next block or input must act, each in its own direction",
                ),
            };
            self.fault(Rule::E0704, written.gain.span(), message, help);
        }
    }

    /// The values of an expression, if all are finite. `what` it is decides the message, `written` the place.
    fn finite(
        &mut self,
        id: ExprId,
        written: &[&Formula],
        what: &[String],
        point: &Point,
    ) -> Option<Vec<f64>> {
        let values = self.evaluate(id, point);
        let Some(at) = values.iter().position(|value| !value.is_finite()) else {
            return Some(values);
        };
        let when = match point.time {
            0.0 => "at the start".to_owned(),
            time => format!("at t = {time} s"),
        };
        let what = match (what, values.len()) {
            ([one], 1) => one.clone(),
            ([whole], _) => format!("entry {} of {whole}", at + 1),
            (each, _) => each[at].clone(),
        };
        let (formula, part) = match written {
            [whole] => (*whole, Some(at)),
            each => (each[at], None),
        };
        let message = format!("{what} is {} {when}, expected a finite number", values[at]);
        let before = self.faults.len();
        let parsed = self.parse_formula(formula);
        self.faults.truncate(before);
        let mut fault = Diagnostic::error(Rule::E0706, formula.span(), message).with_help(
            "look for a division by zero, a root or logarithm of a negative number, or a table with `extrapolation: error`",
        );
        if let Some(parsed) = parsed {
            let shape = self.arena.shape(id).unwrap_or(Shape::Scalar);
            if let Some(part) = part {
                fault.span = parsed.places(shape).get(part).copied().or(fault.span);
            }
            fault = self.with_operation(fault, &parsed, Some(*point));
        }
        self.faults.push(fault);
        None
    }

    /// Whether no fault of a value that is not finite lies in some formulas.
    fn finite_so_far(&self, written: &[&Formula]) -> bool {
        let inside = |place: Span| {
            written.iter().any(|formula| {
                let whole = formula.span();
                whole.file == place.file && whole.start <= place.start && place.end <= whole.end
            })
        };
        let mut reported = self.faults.iter().filter(|fault| fault.rule == Rule::E0706);
        !reported.any(|fault| fault.span.is_some_and(inside))
    }

    /// The reference of each output as it is written, and what it is called.
    fn references(&self, model: &Model) -> (Vec<&'a Formula>, Vec<String>) {
        let spec = self.spec;
        let outputs = model.blocks[0].states.iter();
        let given = outputs.map(|state| {
            let mut signals = spec.reference.iter();
            let signal = signals.find(|signal| signal.name.value == state.name);
            let signal = signal.expect("invariant: every output has a reference");
            (&signal.value, format!("reference of `{}`", state.name))
        });
        given.unzip()
    }

    /// ||e_1(0)|| < k_1(0) with e_1(0) = x_1(0) - y_r(0).
    fn check_initial_error(&mut self, model: &Model, point: &Point) {
        let spec = self.spec;
        let reference_span = spec.reference.span;
        let (written, what) = self.references(model);
        let Some(reference) = self.finite(model.reference, &written, &what, point) else {
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
            let shown = |value: f64| output.states[0].shown(value);
            let span = spec
                .controller
                .blocks
                .iter()
                .find(|gains| gains.name.value == output.name);
            let span = span
                .and_then(|gains| gains.value.constraint.as_ref())
                .map_or(reference_span, |formula| formula.span());
            let message = format!(
                "initial error of block `{}` violates its constraint: ||e(0)|| = {}, expected less than k(0) = {}",
                output.name,
                shown(error),
                shown(bound)
            );
            let mut fault = Diagnostic::error(Rule::E0705, span, message)
                .with_help("start nearer to the reference, or widen the constraint");
            if let ([state], [declared], [signal]) = (
                output.states.as_slice(),
                &*spec.blocks[0].value.states,
                written.as_slice(),
            ) {
                let start = format!("`{}` is {} at the start", state.name, shown(state.initial));
                let end = format!("its reference is {} there", shown(reference[0]));
                fault = fault
                    .with_related(declared.name.span, start)
                    .with_related(signal.span(), end);
            }
            self.faults.push(fault);
        }
    }

    /// The reference and bounded disturbances are finite over the horizon.
    fn check_signal_values(&mut self, model: &Model) {
        let (written, what) = self.references(model);
        let mut signals = vec![(model.reference, written, what)];
        for (block, written) in model.blocks.iter().zip(&self.spec.blocks) {
            let written = written.value.disturbance.as_ref();
            if let (Disturbance::Bounded(id), Some(Ok(spec::Disturbance::Bounded(formula)))) =
                (&block.disturbance, written.map(|written| &written.value))
            {
                let what = format!("disturbance of block `{}`", block.name);
                signals.push((*id, vec![formula], vec![what]));
            }
        }
        let times = self.sample_times(model.scenario.horizon);
        for (id, written, what) in signals {
            // What is not finite at the start has been reported.
            let times = match self.finite_so_far(&written) {
                true => &times[1..],
                false => &[],
            };
            for &t in times {
                let point = Point::at(t);
                if self.finite(id, &written, &what, &point).is_none() {
                    break;
                }
            }
        }
    }
}
