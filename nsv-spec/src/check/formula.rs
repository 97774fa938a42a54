//! Turns what is written into typed expressions of the model, with shapes and dimensions as expected.

use super::Context;
use super::numbers::with_unit;
use super::scope::{Names, Place};
use crate::diagnostic::{Diagnostic, Rule, Span};
use crate::expr::arena::{ExprId, Node, Shape, Type};
use crate::expr::syntax::{Expr, Kind, Node as Syntax};
use crate::expr::{self, Expected};
use crate::spec::{Code, Formula};
use crate::unit::Dimension;

/// A formula with its expressions parsed.
#[derive(Debug)]
pub(super) enum Parsed {
    /// One expression.
    Expr(Expr),
    /// An array written as a list.
    List(Vec<Parsed>, Span),
}

impl Parsed {
    pub(super) fn span(&self) -> Span {
        match self {
            Parsed::Expr(expr) => expr.span(),
            Parsed::List(_, span) => *span,
        }
    }

    /// Where each entry of a value of that shape is written, row-major; the whole formula where it is not written out.
    pub(super) fn places(&self, shape: Shape) -> Vec<Span> {
        let (rows, cols) = shape.size();
        let whole = self.span();
        let items = match shape {
            Shape::Scalar => Vec::new(),
            _ => self.items(),
        };
        let mut places = Vec::with_capacity(rows * cols);
        for row in 0..rows {
            let item = items.get(row);
            let span = item.map_or(whole, |item| item.span());
            let cells = match (shape, item) {
                (Shape::Matrix(..), Some(item)) => item.items(),
                _ => Vec::new(),
            };
            places.extend((0..cols).map(|col| cells.get(col).map_or(span, |cell| cell.span())));
        }
        places
    }

    fn items(&self) -> Vec<Written<'_>> {
        match self {
            Parsed::Expr(expr) => Written::Node(expr, expr.root()).items(),
            Parsed::List(items, _) => items.iter().map(Written::Parsed).collect(),
        }
    }

    pub(super) fn expressions<'a>(&'a self, all: &mut Vec<&'a Expr>) {
        match self {
            Parsed::Expr(expr) => all.push(expr),
            Parsed::List(items, _) => items.iter().for_each(|item| item.expressions(all)),
        }
    }
}

/// A part of a formula: an item of a YAML list, or of an array within an expression.
#[derive(Clone, Copy)]
enum Written<'a> {
    Parsed(&'a Parsed),
    Node(&'a Expr, &'a Syntax),
}

impl<'a> Written<'a> {
    fn span(self) -> Span {
        match self {
            Written::Parsed(parsed) => parsed.span(),
            Written::Node(_, node) => node.span,
        }
    }

    fn items(self) -> Vec<Written<'a>> {
        match self {
            Written::Parsed(parsed) => parsed.items(),
            Written::Node(expr, node) => match &node.kind {
                Kind::Array(items) => (items.iter())
                    .map(|&item| Written::Node(expr, expr.node(item)))
                    .collect(),
                _ => Vec::new(),
            },
        }
    }
}

impl Names {
    /// Every name that the formula uses as a value, with its place; what functions use is used where they are called.
    pub(super) fn used<'a>(&'a self, parsed: &'a Parsed) -> Vec<(&'a str, Span)> {
        let mut expressions = Vec::new();
        parsed.expressions(&mut expressions);
        let mut names = Vec::new();
        for expr in expressions {
            names.extend(expr.free_names());
            for (function, span) in expr.called_names() {
                names.extend(self.uses(function).map(|name| (name.as_str(), span)));
            }
        }
        names
    }
}

impl Context<'_> {
    /// Parses one expression.
    pub(super) fn parse(&mut self, code: &Code) -> Option<Parsed> {
        let text = code.text.as_ref().ok()?;
        // YAML's own numbers that are none.
        if matches!(
            text.trim_start_matches(['+', '-'])
                .to_ascii_lowercase()
                .as_str(),
            ".nan" | ".inf"
        ) {
            self.fault(
                Rule::E0603,
                code.base.span,
                format!("value is {text}, expected a finite number"),
                "write a number",
            );
            return None;
        }
        let parsed = expr::parse(text, code.base.clone());
        let parsed = self.accept(parsed)?;
        let names = parsed.free_names().into_iter().chain(parsed.called_names());
        self.used.extend(names.map(|(name, _)| name.to_owned()));
        Some(Parsed::Expr(parsed))
    }

    /// Parses every expression of a formula.
    pub(super) fn parse_formula(&mut self, formula: &Formula) -> Option<Parsed> {
        match formula {
            Formula::Code(code) => self.parse(code),
            Formula::List(items, span) => {
                let items: Vec<Option<Parsed>> =
                    items.iter().map(|item| self.parse_formula(item)).collect();
                let items: Option<Vec<Parsed>> = items.into_iter().collect();
                Some(Parsed::List(items?, *span))
            }
        }
    }

    /// The meaning of a formula at a place.
    pub(super) fn elaborate(&mut self, parsed: &Parsed, place: Place) -> Option<ExprId> {
        self.check_angles(parsed);
        self.check_quotients(parsed);
        self.meaning(parsed, place)
    }

    fn meaning(&mut self, parsed: &Parsed, place: Place) -> Option<ExprId> {
        match parsed {
            Parsed::Expr(expr) => {
                let meaning = expr::elaborate(expr, &mut self.names.view(place), &mut self.arena);
                self.accept(meaning)
            }
            Parsed::List(items, span) => {
                let items: Vec<Option<ExprId>> =
                    items.iter().map(|item| self.meaning(item, place)).collect();
                let items: Option<Vec<ExprId>> = items.into_iter().collect();
                self.stack(&items?, *span)
            }
        }
    }

    /// A vector of scalars, or a matrix of rows.
    fn stack(&mut self, items: &[ExprId], span: Span) -> Option<ExprId> {
        let mut shapes = Vec::new();
        for &item in items {
            match self.arena.shape(item) {
                Some(shape) => shapes.push(shape),
                None => {
                    self.fault(
                        Rule::E0502,
                        span,
                        "entry is a truth value, expected a number",
                        "choose numbers with `if(condition, a, b)`",
                    );
                    return None;
                }
            }
        }
        let shape = match shapes.first() {
            Some(Shape::Scalar) => Shape::Vector(items.len()),
            Some(&Shape::Vector(cols)) => Shape::Matrix(items.len(), cols),
            _ => return self.ragged(span),
        };
        if shapes.iter().any(|one| *one != shapes[0]) {
            return self.ragged(span);
        }
        let entries: Vec<ExprId> = items.iter().flat_map(|&item| self.entries(item)).collect();
        Some(self.array(entries, shape))
    }

    fn ragged<T>(&mut self, span: Span) -> Option<T> {
        self.fault(
            Rule::E0504,
            span,
            "rows of different lengths, expected scalars or rows of one length",
            "write `[a, b]` or `[[a, b], [c, d]]`",
        );
        None
    }

    /// The entries of an array as scalars.
    fn entries(&mut self, id: ExprId) -> Vec<ExprId> {
        let Type::Real { shape, dimensions } = self.arena.ty(id).clone() else {
            return vec![id];
        };
        match (self.arena.node(id).clone(), shape) {
            (_, Shape::Scalar) => vec![id],
            (Node::Array(entries), _) => entries,
            (_, shape) => {
                let cols = shape.size().1;
                let element = |(at, dimension)| {
                    self.arena.intern(
                        Node::Element(id, at / cols, at % cols),
                        Type::scalar(dimension),
                    )
                };
                dimensions.into_iter().enumerate().map(element).collect()
            }
        }
    }

    pub(super) fn array(&mut self, entries: Vec<ExprId>, shape: Shape) -> ExprId {
        let dimension = |&id: &ExprId| self.arena.ty(id).dimension().unwrap_or(Dimension::ONE);
        let dimensions = entries.iter().map(dimension).collect();
        self.arena
            .intern(Node::Array(entries), Type::Real { shape, dimensions })
    }

    /// The expression in the expected shape, with the expected dimensions. A scalar passes for an array of one entry.
    pub(super) fn expect(
        &mut self,
        id: ExprId,
        written: &Parsed,
        expected: &Expected<'_>,
    ) -> Option<ExprId> {
        let places = written.places(expected.shape);
        let single = self
            .arena
            .shape(id)
            .is_some_and(|shape| shape.entries() == 1 && shape != expected.shape);
        let id = if single && expected.shape.entries() == 1 {
            let entries = self.entries(id);
            self.array(entries, expected.shape)
        } else {
            id
        };
        let checked = expr::expect(&self.arena, id, written.span(), &places, expected);
        self.accept(checked).map(|()| id)
    }

    /// Parses, elaborates and checks a formula of the model; without shape and units to check where faults elsewhere hide what
    /// they should be.
    pub(super) fn formula(
        &mut self,
        formula: &Formula,
        expected: Option<&Expected<'_>>,
    ) -> Option<(ExprId, Parsed)> {
        let parsed = self.parse_formula(formula)?;
        let id = self.elaborate(&parsed, Place::Model)?;
        let Some(expected) = expected else {
            return Some((id, parsed));
        };
        let before = self.faults.len();
        let Some(expected_id) = self.expect(id, &parsed, expected) else {
            for fault in self.faults.split_off(before) {
                let fault = self.with_origins(fault, &parsed);
                let fault = match (formula, &parsed, expected.dimensions) {
                    (Formula::Code(code), Parsed::Expr(expr), &[wanted])
                        if fault.rule == Rule::E0407 && expr.as_literal().is_some() =>
                    {
                        with_unit(fault, code, wanted)
                    }
                    _ => fault,
                };
                self.faults.push(fault);
            }
            return None;
        };
        Some((expected_id, parsed))
    }

    /// A unit mismatch with the declarations of the names in the formula.
    fn with_origins(&mut self, fault: Diagnostic, parsed: &Parsed) -> Diagnostic {
        if fault.rule != Rule::E0407 {
            return fault;
        }
        let inside = |place: Span| {
            (fault.span).is_none_or(|span| span.start <= place.start && place.end <= span.end)
        };
        let names = self.names.used(parsed).into_iter();
        let names: Vec<String> = names
            .filter(|(_, place)| inside(*place))
            .map(|(name, _)| name.to_owned())
            .collect();
        let names = names.iter().map(String::as_str);
        expr::with_origins(&self.names.view(Place::Model), fault, names)
    }
}
