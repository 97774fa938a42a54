//! Guarantees that every parameter has a finite nominal, design and dispersed value in one dimension.

use super::Context;
use super::constants::{convert, text};
use super::dispersion::Dispersed;
use super::scope::Dependence;
use crate::diagnostic::{Diagnostic, Rule};
use crate::expr::Symbol;
use crate::expr::arena::{ParameterId, Type};
use crate::model::Parameter;
use crate::spec::{self, Code, Word};
use crate::suggest::{beside, nearest};
use crate::unit::{Dimension, Unit};

impl Context<'_> {
    /// Computes every parameter.
    pub(super) fn check_parameters(&mut self) {
        let spec = self.spec;
        for (at, declared) in spec.parameters.iter().enumerate() {
            let parameter = self.parameter(&declared.name, &declared.value);
            match &parameter {
                Some(parameter) => {
                    let id = ParameterId(
                        u32::try_from(at).expect("invariant: fewer than 2^32 parameters"),
                    );
                    let symbol = Symbol::Parameter(id, Type::scalar(parameter.dimension));
                    self.names
                        .define(&declared.name.value, symbol, Dependence::default());
                }
                None => self.names.refuse(&declared.name.value),
            }
            self.parameters.push(parameter);
        }
        self.check_correlations();
        self.check_design_values();
    }

    fn parameter(&mut self, name: &Word, declared: &spec::Parameter) -> Option<Parameter> {
        let unit = match &declared.unit {
            Some(unit) => Some(self.unit(unit)?),
            None => None,
        };
        let what = format!("parameter `{}`", name.value);
        let (value, dimension) = self.value_in(&declared.value, unit.as_ref(), &what)?;
        let dispersion = match &declared.dispersion {
            Some(dispersion) => {
                let of = Dispersed {
                    what: &what,
                    dimension,
                    unit: unit.as_ref(),
                };
                // A fault in it takes nothing from what is known of the parameter.
                (dispersion.as_ref().ok()).and_then(|one| self.dispersion(one, &of))
            }
            None => None,
        };
        let doc = text(declared.source.as_ref());
        Some(Parameter {
            name: name.value.clone(),
            value,
            design_value: value,
            dimension,
            dispersion,
            doc,
            span: name.span,
        })
    }

    /// A scalar with a unit of its own, or in the unit that is given beside it.
    pub(super) fn value_in(
        &mut self,
        code: &Code,
        unit: Option<&Unit>,
        what: &str,
    ) -> Option<(f64, Dimension)> {
        let (value, dimension) = self.scalar(code, what)?;
        match unit {
            Some(unit) if dimension == Dimension::ONE => {
                Some((convert(Some(code), value, unit), unit.dimension))
            }
            Some(unit) if dimension != unit.dimension => {
                self.unit_mismatch(
                    code.base.span,
                    what,
                    dimension,
                    unit.dimension,
                    "give the unit in one place",
                );
                None
            }
            _ => Some((value, dimension)),
        }
    }

    /// Values that the controller is designed with.
    fn check_design_values(&mut self) {
        let spec = self.spec;
        for design in &spec.controller.parameters {
            let name = &design.name.value;
            let Some(at) = spec
                .parameters
                .iter()
                .position(|parameter| parameter.name.value == *name)
            else {
                let given = |name: &&String| {
                    let mut given = spec.controller.parameters.iter();
                    given.any(|design| design.name.value == **name)
                };
                let known = || spec.parameters.iter().map(|one| &one.name.value);
                if !spec.parameters.complete {
                    continue;
                }
                let message = format!("unknown parameter `{name}`");
                let fault = Diagnostic::error(Rule::E0116, design.name.span, message);
                let meant = nearest(name, known().filter(|name| !given(name)));
                let declare = "declare it under `parameters`";
                let otherwise = || beside(name, known().filter(given), declare);
                self.faults
                    .push(fault.did_you_mean(design.name.span, name, meant, otherwise));
                continue;
            };
            let Some(dimension) = self.parameters[at]
                .as_ref()
                .map(|parameter| parameter.dimension)
            else {
                continue;
            };
            let value = self.quantity(
                &design.value,
                &format!("design value of `{name}`"),
                dimension,
            );
            if let (Some(value), Some(parameter)) = (value, &mut self.parameters[at]) {
                parameter.design_value = value;
            }
        }
    }
}
