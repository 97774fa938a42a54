//! Reads constants, parameters and polynomial data.

use super::fields::Reader;
use crate::diagnostic::{Rule, Span};
use crate::spec::{Constant, Function, Parameter, PolynomialGroup, Read, Terms, Unreadable};
use crate::vocabulary::{CONSTANT, FUNCTION, PARAMETER, POLYNOMIAL};
use crate::yaml::{Kind, Node};

/// Largest exponent in polynomial data.
pub(crate) const MAX_EXPONENT: u32 = 32;

impl Reader {
    pub(super) fn constant(&mut self, node: &Node) -> Constant {
        if !matches!(node.kind, Kind::Map(_)) {
            return Constant {
                value: self.formula_of(node),
                unit: None,
                source: None,
            };
        }
        let fields = self.fields(node, &CONSTANT);
        Constant {
            value: self.formula(&fields, "value"),
            unit: self.text(&fields, "unit"),
            source: self.note(&fields, "source"),
        }
    }

    pub(super) fn parameter(&mut self, node: &Node) -> Parameter {
        if !matches!(node.kind, Kind::Map(_)) {
            return Parameter {
                value: self.code_of(node),
                unit: None,
                dispersion: None,
                source: None,
            };
        }
        let fields = self.fields(node, &PARAMETER);
        Parameter {
            value: self.code(&fields, "value"),
            unit: self.text(&fields, "unit"),
            dispersion: self.dispersion(&fields),
            source: self.note(&fields, "source"),
        }
    }

    pub(super) fn function(&mut self, node: &Node) -> Function {
        let fields = self.fields(node, &FUNCTION);
        // For people who read the specification: a call leaves no trace of it in the code.
        self.note(&fields, "source");
        let arguments = self.items(&fields, "arguments", "a list of names");
        Function {
            arguments: self.words(arguments),
            value: self.code(&fields, "value"),
        }
    }

    pub(super) fn polynomial_group(&mut self, node: &Node) -> PolynomialGroup {
        let fields = self.fields(node, &POLYNOMIAL);
        let arguments = self.items(&fields, "arguments", "a list of names");
        let arguments = self.words(arguments);
        let count = arguments.as_ref().map(Vec::len);
        PolynomialGroup {
            source: self.note(&fields, "source"),
            parts: self.map(&fields, "parts", |reader, node| {
                reader.terms(node, count.map_err(|&unreadable| unreadable)?)
            }),
            arguments,
        }
    }

    fn terms(&mut self, node: &Node, arguments: usize) -> Read<Terms> {
        let Kind::Seq(items) = &node.kind else {
            return self.no_terms(node);
        };
        if items.is_empty() {
            return self.no_terms(node);
        }
        let terms = items.iter().map(|item| self.term(item, arguments));
        let terms: Vec<Option<(f64, Vec<u32>)>> = terms.collect();
        let terms: Option<Terms> = terms.into_iter().collect();
        terms.ok_or(Unreadable)
    }

    fn no_terms(&mut self, node: &Node) -> Read<Terms> {
        let help = "write `[[coefficient, exponent, ..], ..]`";
        self.kind(node, "a list of terms", help);
        Err(Unreadable)
    }

    fn term(&mut self, node: &Node, arguments: usize) -> Option<(f64, Vec<u32>)> {
        let help = "a term is the coefficient, then the exponent of each argument";
        let Kind::Seq(items) = &node.kind else {
            self.kind(node, "a term", help);
            return None;
        };
        if items.len() != arguments + 1 {
            let message = format!(
                "found a term of {}, expected a coefficient and {arguments} exponents",
                items.len()
            );
            self.fault(Rule::E0107, node.span, message, help);
            return None;
        }
        let coefficient = self.coefficient(&items[0]);
        let exponents: Vec<u32> = items[1..]
            .iter()
            .filter_map(|item| self.exponent(item))
            .collect();
        (exponents.len() == arguments).then_some((coefficient?, exponents))
    }

    fn coefficient(&mut self, node: &Node) -> Option<f64> {
        let value = digits(node).and_then(|text| text.parse::<f64>().ok());
        match value {
            Some(value) if value.is_finite() => Some(value),
            Some(_) => self.refuse(
                node.span,
                format!("found {}, expected a finite coefficient", node.describe()),
            ),
            None => self.refuse(
                node.span,
                format!("found {}, expected a number", node.describe()),
            ),
        }
    }

    fn exponent(&mut self, node: &Node) -> Option<u32> {
        let value = digits(node)
            .and_then(|text| text.parse::<u32>().ok())
            .filter(|&value| value <= MAX_EXPONENT);
        value.or_else(|| {
            self.refuse(
                node.span,
                format!(
                    "found {}, expected an exponent from 0 to {MAX_EXPONENT}",
                    node.describe()
                ),
            )
        })
    }

    fn refuse<T>(&mut self, span: Span, message: String) -> Option<T> {
        self.fault(
            Rule::E0107,
            span,
            message,
            "polynomial data are plain numbers; units belong into the arguments",
        );
        None
    }
}

/// The text of a plain number, with a digit in it: no `inf` or `nan`.
fn digits(node: &Node) -> Option<&str> {
    match &node.kind {
        Kind::Scalar(scalar)
            if !scalar.quoted && scalar.text.contains(|c: char| c.is_ascii_digit()) =>
        {
            Some(&scalar.text)
        }
        _ => None,
    }
}
