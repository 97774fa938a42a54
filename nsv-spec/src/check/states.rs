//! Guarantees that every state and input has a finite value in a unit, and every limit is positive.

use super::Context;
use super::dispersion::Dispersed;
use super::numbers::in_unit;
use super::scope::Dependence;
use crate::diagnostic::{Diagnostic, Rule};
use crate::expr::Symbol;
use crate::model;
use crate::spec::{self, Named, Word};
use crate::unit::Dimension;

impl Context<'_> {
    /// Computes initial values and display units of all states and gives their names a meaning.
    pub(super) fn check_states(&mut self) {
        let spec = self.spec;
        for (at, block) in spec.blocks.iter().enumerate() {
            let mut states = Vec::new();
            for (channel, Named { name, value }) in block.value.states.iter().enumerate() {
                let state = self.state(name, value);
                match &state {
                    Some(state) => {
                        let symbol = Symbol::State {
                            block: at,
                            channel,
                            dimension: state.dimension,
                        };
                        self.names.define(
                            &name.value,
                            symbol,
                            Dependence {
                                block: Some(at),
                                ..Dependence::default()
                            },
                        );
                    }
                    None => self.names.refuse(&name.value),
                }
                states.push(state);
            }
            self.states.push(states.into_iter().collect());
        }
        let truth = spec.truth.iter().flat_map(|truth| &truth.value.states);
        for (at, Named { name, value }) in truth.enumerate() {
            let state = self.state(name, value);
            match &state {
                Some(state) => self.names.define(
                    &name.value,
                    Symbol::Truth(at, state.dimension),
                    Dependence::TRUTH,
                ),
                None => self.names.refuse(&name.value),
            }
            self.truth_states.push(state);
        }
    }

    fn state(&mut self, name: &Word, written: &spec::State) -> Option<model::State> {
        let what = format!("initial value of `{}`", name.value);
        let unit = match &written.unit {
            Some(unit) => Some(self.unit(unit)?),
            None => None,
        };
        let (initial, dimension) = self.value_in(&written.initial, unit.as_ref(), &what)?;
        let of = Dispersed {
            what: &what,
            dimension,
            unit: unit.as_ref(),
        };
        // A fault in these takes nothing from what is known of the state.
        let dispersion = written.dispersion.as_ref();
        let dispersion = dispersion.and_then(|one| self.dispersion(one.as_ref().ok()?, &of));
        let sensor = written.sensor.as_ref();
        let sensor = sensor.and_then(|one| self.sensor(one, &name.value, dimension));
        let display = match unit {
            Some(unit) => (unit.text, unit.scale),
            None => self.display(&written.initial, dimension),
        };
        Some(model::State {
            name: name.value.clone(),
            initial,
            dimension,
            display,
            dispersion,
            sensor,
        })
    }

    /// The unit in which a quantity is written, or SI.
    fn display(&mut self, code: &spec::Code, dimension: Dimension) -> (String, f64) {
        let parsed = code.parsed();
        let unit = parsed
            .as_ref()
            .and_then(|expr| expr.as_literal())
            .and_then(|(_, unit)| unit);
        unit.map_or_else(
            || (dimension.to_string(), 1.0),
            |unit| (unit.text.clone(), unit.scale),
        )
    }

    /// Checks limits and safe values of the inputs.
    pub(super) fn check_inputs(&mut self) -> Option<Vec<model::Input>> {
        let spec = self.spec;
        let inputs: Vec<Option<model::Input>> = spec
            .inputs
            .iter()
            .map(|input| self.input(&input.name, &input.value))
            .collect();
        match spec.truth {
            Some(_) => self.name_inputs(&inputs),
            None if spec.complete => self.forbid_inputs(),
            None => {}
        }
        inputs.into_iter().collect()
    }

    /// Without a flown plant of its own, no expression uses an input by name.
    fn forbid_inputs(&mut self) {
        let Some(last) = self.spec.blocks.last() else {
            return;
        };
        let why = format!(
            "leave it out: inputs act through `gain` of the last block, `{}`, which multiplies them",
            last.name.value
        );
        for input in &self.spec.inputs {
            self.names.forbid(&input.name.value, why.as_str());
        }
    }

    /// Rates of the flown plant use the inputs by name.
    fn name_inputs(&mut self, inputs: &[Option<model::Input>]) {
        for (at, (written, input)) in self.spec.inputs.iter().zip(inputs).enumerate() {
            let name = &written.name.value;
            match input {
                Some(input) => {
                    let symbol = Symbol::Input(at, input.dimension);
                    self.names.define(name, symbol, Dependence::TRUTH);
                }
                None => self.names.refuse(name),
            }
        }
    }

    fn input(&mut self, name: &Word, written: &spec::Input) -> Option<model::Input> {
        let what = format!("limit of input `{}`", name.value);
        let (limit, dimension) = self.scalar(&written.limit, &what)?;
        let span = written.limit.base.span;
        // A fault from here on takes nothing from what is known of the input.
        let sound = self.positive(limit, span, &what).is_some();
        let safe = match &written.safe {
            Some(code) => {
                let what = format!("safe value of input `{}`", name.value);
                self.quantity(code, &what, dimension).unwrap_or_default()
            }
            None => {
                self.default(
                    format!("plant.inputs.{}.safe", name.value),
                    "0",
                    "output when a measurement is not finite",
                );
                0.0
            }
        };
        if sound && safe.abs() > limit {
            let most = in_unit(limit, dimension);
            let message = format!(
                "safe value of input `{}` is {}, beyond its limit {most}",
                name.value,
                in_unit(safe, dimension)
            );
            let place = written.safe.as_ref().map_or(span, |code| code.base.span);
            let fault = Diagnostic::error(Rule::E0602, place, message)
                .with_related(span, "the limit")
                .with_help(format!("choose a value from -{most} to {most}"));
            self.faults.push(fault);
        }
        let actuator = written.actuator.as_ref();
        let actuator = actuator.and_then(|one| self.actuator(one, &name.value, dimension));
        Some(model::Input {
            actuator,
            name: name.value.clone(),
            limit,
            safe,
            dimension,
            display: self.display(&written.limit, dimension),
        })
    }
}
