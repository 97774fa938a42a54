//! Guarantees that every constant is a finite number or array of one dimension, whatever the order of declaration.

use std::collections::{BTreeMap, BTreeSet};

use super::Context;
use super::cycles::order;
use super::formula::Parsed;
use super::numbers::Numbers;
use super::scope::Dependence;
use crate::diagnostic::{Applicability, Base, Diagnostic, Rule};
use crate::expr::Symbol;
use crate::expr::arena::{ConstantId, Shape, Type};
use crate::model::Constant;
use crate::spec::{Code, Formula, Named, Read, Word};
use crate::unit::{Dimension, Unit, parse_unit};

impl Context<'_> {
    /// Computes every constant.
    pub(super) fn check_constants(&mut self) {
        let spec = self.spec;
        let parsed: Vec<Option<Parsed>> = spec
            .constants
            .iter()
            .map(|constant| self.parse_formula(&constant.value.value))
            .collect();
        let sorted = self.sort(&spec.constants, &self.names_used(&parsed), "constant");
        self.constants = vec![None; spec.constants.len()];
        for at in sorted {
            let Named {
                name,
                value: declared,
            } = &spec.constants[at];
            let numbers = parsed[at]
                .as_ref()
                .and_then(|parsed| self.numbers_of(parsed));
            let constant = numbers.and_then(|numbers| {
                self.constant(name, &declared.value, declared.unit.as_ref(), numbers)
            });
            let Some((shape, constant)) = constant else {
                self.names.refuse(&name.value);
                continue;
            };
            let id = ConstantId(u32::try_from(at).expect("invariant: fewer than 2^32 constants"));
            let symbol = Symbol::Constant(id, Type::uniform(shape, constant.dimension));
            self.names
                .define(&name.value, symbol, Dependence::default());
            self.constants[at] = Some(Constant {
                doc: text(declared.source.as_ref()),
                ..constant
            });
        }
    }

    fn constant(
        &mut self,
        name: &Word,
        written: &Formula,
        unit: Option<&Read<Word>>,
        numbers: Numbers,
    ) -> Option<(Shape, Constant)> {
        let numbers = match unit {
            Some(unit) => self.in_unit(written, numbers, unit)?,
            None => numbers,
        };
        let dimension = numbers.dimensions[0];
        if numbers.dimensions.iter().any(|other| *other != dimension) {
            let help = "declare one constant for each unit";
            self.fault(
                Rule::E0606,
                numbers.span,
                format!("constant `{}` has entries of different units", name.value),
                help,
            );
            return None;
        }
        let (value, scalar) = (numbers.matrix(), numbers.shape == Shape::Scalar);
        Some((
            numbers.shape,
            Constant {
                name: name.value.clone(),
                value,
                scalar,
                dimension,
                doc: String::new(),
                span: name.span,
            },
        ))
    }

    /// Bare numbers in the unit that is given beside them.
    fn in_unit(
        &mut self,
        written: &Formula,
        numbers: Numbers,
        unit: &Read<Word>,
    ) -> Option<Numbers> {
        let parsed = self.unit(unit)?;
        let unit = unit.as_ref().ok()?;
        if let Some(found) = numbers
            .dimensions
            .iter()
            .find(|&&found| found != Dimension::ONE)
        {
            let message = format!(
                "value has a unit of its own ({found}) beside `unit: {}`",
                unit.value
            );
            let fault = Diagnostic::error(Rule::E0606, numbers.span, message)
                .with_related(unit.span, "and it is given here")
                .with_help("give the unit in one place");
            let same = bare_number(written, &unit.value);
            self.faults.push(match same {
                Some(number) => fault.with_suggestion(numbers.span, number, Applicability::Certain),
                None => fault,
            });
            return None;
        }
        let mut codes = Vec::new();
        leaves(written, &mut codes);
        let exact = codes.len() == numbers.values.len();
        let convert = |(at, value): (usize, &f64)| {
            convert(codes.get(at).filter(|_| exact).copied(), *value, &parsed)
        };
        let values: Vec<f64> = numbers.values.iter().enumerate().map(convert).collect();
        if values.iter().any(|value| !value.is_finite()) {
            self.fault(
                Rule::E0603,
                numbers.span,
                "value is not finite in SI",
                "look for a wrong exponent",
            );
            return None;
        }
        Some(Numbers {
            dimensions: vec![parsed.dimension; values.len()],
            values,
            ..numbers
        })
    }

    /// A unit given under its own key.
    pub(super) fn unit(&mut self, unit: &Read<Word>) -> Option<Unit> {
        let unit = unit.as_ref().ok()?;
        match parse_unit(&unit.value) {
            Ok(unit) => Some(unit),
            Err(error) => {
                let exact = unit.value.len() == (unit.span.end - unit.span.start) as usize;
                let base = match exact {
                    true => Base::verbatim(unit.span),
                    false => Base::whole(unit.span),
                };
                self.faults.push(error.diagnostic(&base));
                None
            }
        }
    }

    /// Names that each of several formulas uses.
    pub(super) fn names_used(&self, parsed: &[Option<Parsed>]) -> Vec<Vec<String>> {
        let names = |parsed: &Option<Parsed>| {
            let used = parsed.iter().flat_map(|parsed| self.names.used(parsed));
            used.map(|(name, _)| name.to_owned()).collect()
        };
        parsed.iter().map(names).collect()
    }

    /// The order in which to compute declarations; circles are reported and left out with all that hangs on them.
    pub(super) fn sort<T>(
        &mut self,
        declared: &[Named<T>],
        used: &[Vec<String>],
        noun: &str,
    ) -> Vec<usize> {
        let index: BTreeMap<&str, usize> = declared
            .iter()
            .enumerate()
            .rev()
            .map(|(at, item)| (item.name.value.as_str(), at))
            .collect();
        let at = |name: &String| index.get(name.as_str()).copied();
        let uses: Vec<BTreeSet<usize>> = used
            .iter()
            .map(|names| names.iter().filter_map(at).collect())
            .collect();
        for (item, names) in declared.iter().zip(used) {
            self.names.defined_by(&item.name.value, names.clone());
        }
        let order = order(&uses);
        for &at in &order.unsorted {
            self.names.refuse(&declared[at].name.value);
        }
        for circle in &order.circles {
            let names: Vec<&str> = circle
                .iter()
                .chain(&circle[..1])
                .map(|&at| declared[at].name.value.as_str())
                .collect();
            let message = format!(
                "{noun} `{}` depends on itself: {}",
                names[0],
                names.join(" -> ")
            );
            let mut fault = Diagnostic::error(Rule::E0117, declared[circle[0]].name.span, message);
            for &at in &circle[1..] {
                fault = fault.with_related(
                    declared[at].name.span,
                    format!("`{}` is declared here", declared[at].name.value),
                );
            }
            self.faults.push(
                fault.with_help("break the circle: at least one of them must not use the next"),
            );
        }
        order.sorted
    }
}

/// A bare number in a unit, rounded once if its digits are known.
pub(super) fn convert(code: Option<&Code>, value: f64, unit: &Unit) -> f64 {
    let digits = code
        .and_then(|code| Some(code.text.as_ref().ok()?.trim()))
        .filter(|text| text.parse::<f64>().is_ok_and(|parsed| parsed == value));
    digits
        .and_then(|digits| unit.si(digits))
        .unwrap_or(value * unit.scale)
}

fn leaves<'a>(formula: &'a Formula, all: &mut Vec<&'a Code>) {
    match formula {
        Formula::Code(code) => all.push(code),
        Formula::List(items, _) => items.iter().for_each(|item| leaves(item, all)),
    }
}

/// A text that may be missing.
pub(super) fn text(word: Option<&Word>) -> String {
    word.map(|word| word.value.clone()).unwrap_or_default()
}

/// The number of a quantity such as `5 m`, if its unit is the one given.
fn bare_number(written: &Formula, unit: &str) -> Option<String> {
    let Formula::Code(code) = written else {
        return None;
    };
    let text = code.text.as_ref().ok()?;
    let number = text.trim_end().strip_suffix(unit)?.trim_end();
    let exact = code.base.holds(0..text.len());
    (exact && number.parse::<f64>().is_ok()).then(|| number.to_owned())
}
