//! Guarantees that every lookup table has a finite value at each combination of increasing points.

mod file;
mod inline;

use std::sync::Arc;

use super::Context;
use super::constants::text;
use super::csv::Cell;
use super::scope::Dependence;
use crate::diagnostic::{Diagnostic, Rule, Span, counted, quoted};
use crate::expr::arena::TableId;
use crate::expr::{Signature, Symbol};
use crate::interpolation::Interpolant;
use crate::model::Table;
use crate::spec::{self, Read, Word};
use crate::unit::{Dimension, Unit};

/// Most arguments of a table.
pub(crate) const MAX_AXES: usize = 3;
/// Most points of an axis.
pub(crate) const MAX_POINTS: usize = 1000;
/// Most values of a table.
pub(crate) const MAX_VALUES: usize = 100_000;

/// Numbers of a table as they are written: points of each axis, values with the last axis fastest.
struct Written<'a> {
    points: Vec<Vec<Cell<'a>>>,
    values: Vec<Cell<'a>>,
}

impl Context<'_> {
    /// Takes over every table.
    pub(super) fn check_tables(&mut self) {
        let spec = self.spec;
        for (at, declared) in spec.tables.iter().enumerate() {
            let name = &declared.name.value;
            let before = self.faults.len();
            let table = self.table(&declared.name, &declared.value);
            self.name_file(before, &declared.value);
            let id = TableId(u32::try_from(at).expect("invariant: fewer than 2^32 tables"));
            for axis in &declared.value.axes {
                let unit = axis.value.unit.iter().flatten().next();
                let unit = unit.map_or(axis.name.span, |unit| unit.span);
                let argument = format!("{name}.{}", axis.name.value);
                self.names.declare(&argument, unit, "axis");
            }
            match &table {
                Some(table) => {
                    let signature = Signature {
                        arguments: table.arguments.clone(),
                        value: table.dimension,
                    };
                    let symbol = Symbol::Table(id, Arc::new(signature));
                    self.names.define(name, symbol, Dependence::default());
                }
                None => self.names.refuse(name),
            }
            self.names.tables.push(table);
        }
    }

    /// Faults in a data file, those from number `before` on, show where the specification names it.
    fn name_file(&mut self, before: usize, declared: &spec::Table) {
        let Some(Ok(file)) = &declared.file else {
            return;
        };
        let found = self.faults.split_off(before);
        self.faults
            .extend(found.into_iter().map(|fault| match fault.span {
                Some(span) if span.file != file.span.file => {
                    fault.with_related(file.span, "the file is named here")
                }
                _ => fault,
            }));
    }

    fn table(&mut self, name: &Word, declared: &spec::Table) -> Option<Table> {
        if !declared.axes.complete {
            return None;
        }
        if !(1..=MAX_AXES).contains(&declared.axes.len()) {
            let message = format!(
                "table `{}` has {}",
                name.value,
                counted(declared.axes.len(), "axis")
            );
            let help = format!("a table has 1 to {MAX_AXES} axes");
            self.fault(Rule::E0324, name.span, message, help);
            return None;
        }
        let units: Vec<Option<Option<Unit>>> = declared
            .axes
            .iter()
            .map(|axis| self.optional_unit(axis.value.unit.as_ref()))
            .collect();
        let unit = self.optional_unit(declared.unit.as_ref());
        let written = match (&declared.values, &declared.file) {
            (Some(Ok(values)), None) => self.inline_table(declared, values),
            (None, Some(Ok(file))) => self.table_file(name, declared, file),
            _ => None,
        };
        let (units, unit, written) = (
            units.into_iter().collect::<Option<Vec<_>>>()?,
            unit?,
            written?,
        );
        let dimension =
            |unit: &Option<Unit>| unit.as_ref().map_or(Dimension::ONE, |unit| unit.dimension);
        let names = declared.axes.iter().map(|axis| axis.name.value.clone());
        let arguments: Vec<_> = names.zip(units.iter().map(dimension)).collect();
        let dimension = dimension(&unit);
        self.check_slopes(name, &arguments, dimension)?;
        let (degree, extrapolation) = (
            declared.interpolation.ok()??.value,
            declared.extrapolation.ok()??.value,
        );
        let mut axes = Vec::new();
        for ((axis, unit), written) in declared.axes.iter().zip(&units).zip(&written.points) {
            let fewest = degree.fewest_points();
            axes.push(self.points(&axis.name, unit.as_ref(), written, fewest));
        }
        let values = self.numbers_in(&written.values, unit.as_ref());
        let axes: Vec<Vec<f64>> = axes.into_iter().collect::<Option<_>>()?;
        let interpolant = Interpolant::new(degree, extrapolation, &axes, values?);
        if !interpolant.is_finite() {
            let message = format!("table `{}` is not finite between its points", name.value);
            let help = "look for a value with a wrong exponent, or for points of an axis that nearly coincide";
            self.fault(Rule::E0603, name.span, message, help);
            return None;
        }
        Some(Table {
            name: name.value.clone(),
            arguments,
            dimension,
            interpolant,
            doc: text(declared.source.as_ref()),
            span: name.span,
        })
    }

    /// Outer `None` after a fault.
    fn optional_unit(&mut self, unit: Option<&Read<Word>>) -> Option<Option<Unit>> {
        match unit {
            Some(unit) => self.unit(unit).map(Some),
            None => Some(None),
        }
    }

    /// The slopes by every argument have a dimension.
    fn check_slopes(
        &mut self,
        name: &Word,
        arguments: &[(String, Dimension)],
        value: Dimension,
    ) -> Option<()> {
        let dimensions = arguments.iter().map(|(_, dimension)| *dimension);
        let slope = |by| value.checked_div(by).is_some();
        if dimensions.into_iter().all(slope) {
            return Some(());
        }
        let message = format!(
            "slope of table `{}` has an exponent out of range",
            name.value
        );
        self.fault(
            Rule::E0406,
            name.span,
            message,
            "exponents of units go from -63 to 63",
        );
        None
    }

    /// The points of an axis: enough of them, increasing.
    fn points(
        &mut self,
        axis: &Word,
        unit: Option<&Unit>,
        written: &[Cell<'_>],
        fewest: usize,
    ) -> Option<Vec<f64>> {
        if !(fewest..=MAX_POINTS).contains(&written.len()) {
            let message = format!(
                "axis `{}` has {}, expected {fewest} to {MAX_POINTS}",
                axis.value,
                counted(written.len(), "value")
            );
            let help = "linear interpolation takes 2 points on each axis, cubic 4";
            self.fault(Rule::E0324, axis.span, message, help);
            return None;
        }
        let points = self.numbers_in(written, unit)?;
        let Some(at) = (1..points.len()).find(|&at| points[at] <= points[at - 1]) else {
            return Some(points);
        };
        let (before, cell) = (&written[at - 1], &written[at]);
        let message = format!(
            "axis `{}` goes from {} to {}, expected increasing values",
            axis.value, before.text, cell.text
        );
        let fault = Diagnostic::error(Rule::E0320, cell.span, message)
            .with_related(before.span, "the value before it");
        self.faults
            .push(fault.with_help("put the values in order, each once"));
        None
    }

    /// Plain numbers in a unit; the first that is none is reported.
    fn numbers_in(&mut self, cells: &[Cell<'_>], unit: Option<&Unit>) -> Option<Vec<f64>> {
        let mut numbers = Vec::new();
        for cell in cells {
            let Some(number) = number(cell.text, unit) else {
                self.no_number(cell);
                return None;
            };
            numbers.push(number);
        }
        Some(numbers)
    }

    fn no_number(&mut self, cell: &Cell<'_>) {
        let found = match cell.text {
            "" => "nothing".to_owned(),
            text => quoted(text),
        };
        let help = "tables hold plain numbers, as in `-1.5e-3`; their unit stands under `unit`";
        self.fault(
            Rule::E0322,
            cell.span,
            format!("found {found}, expected a number"),
            help,
        );
    }

    fn table_shape(&mut self, span: Span, message: String, help: &str) {
        self.fault(Rule::E0321, span, message, help);
    }
}

/// A finite number, rounded once.
fn number(text: &str, unit: Option<&Unit>) -> Option<f64> {
    let (digits, negative) = match text.strip_prefix('-') {
        Some(digits) => (digits, true),
        None => (text.strip_prefix('+').unwrap_or(text), false),
    };
    // No `inf`, `nan` or second sign.
    let plain = digits.starts_with(|c: char| c.is_ascii_digit() || c == '.');
    let value = match unit {
        _ if !plain || !digits.contains(|c: char| c.is_ascii_digit()) => None,
        Some(unit) => unit.si(digits),
        None => digits.parse().ok().filter(|value: &f64| value.is_finite()),
    }?;
    Some(if negative { 0.0 - value } else { value })
}
