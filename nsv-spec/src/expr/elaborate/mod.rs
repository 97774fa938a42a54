//! Syntax to typed nodes: names are resolved, shapes and dimensions checked.
//!
//! Nodes are visited once, operands first, in a loop. An operand with a fault leaves no value, and what is made of it is passed
//! over in silence, so that each fault is reported once.

mod call;
mod data;
mod function;
mod name;
mod operator;
mod origin;

pub(crate) use function::MAX_CALLS;

use std::collections::{BTreeMap, BTreeSet};

pub(crate) use origin::with_origins;

use super::arena::{Arena, Bits, ExprId, Function, Node, Operator, Shape, Type};
use super::parser::MAX_FAULTS;
use super::scope::{Scope, Symbol};
use super::syntax::{Expr, Index, Kind, Literal, NodeId};
use super::typing::{self, Fault, Real};
use crate::diagnostic::{Diagnostic, Rule, Span};
use crate::unit::Dimension;

/// Gives an expression its meaning: resolves its names in `scope`, checks shapes and dimensions, and stores it in `arena`.
///
/// All faults that do not follow from one another are reported, in order of place. There are none in the `Err` if the only
/// fault is the use of a [`super::Symbol::Faulty`] name.
pub fn elaborate(
    expr: &Expr,
    scope: &mut dyn Scope,
    arena: &mut Arena,
) -> Result<ExprId, Vec<Diagnostic>> {
    let mut elaborator = Elaborator {
        expr,
        scope,
        arena,
        bound: BTreeMap::new(),
        depth: 0,
        values: Vec::new(),
        faults: Vec::new(),
        unknown: BTreeSet::new(),
        unit_until: None,
    };
    let root = elaborator.root();
    let mut faults = elaborator.faults;
    faults.sort_by_key(|fault| fault.span);
    root.filter(|_| faults.is_empty()).ok_or(faults)
}

struct Elaborator<'a> {
    expr: &'a Expr,
    scope: &'a mut dyn Scope,
    arena: &'a mut Arena,
    /// Arguments and counters, which are looked up before the names of the scope.
    bound: BTreeMap<String, Symbol>,
    /// How many calls and loops this expression lies in.
    depth: usize,
    /// What each syntax node became; `None` after a fault in it.
    values: Vec<Option<ExprId>>,
    faults: Vec<Diagnostic>,
    /// Unknown names, each reported where it comes first.
    unknown: BTreeSet<String>,
    /// End of the last name that was meant for a unit.
    unit_until: Option<u32>,
}

impl Elaborator<'_> {
    /// What the whole expression becomes.
    fn root(&mut self) -> Option<ExprId> {
        let expr = self.expr;
        for node in expr.nodes() {
            let value = self.value(node.span, &node.kind);
            self.values.push(value);
            if self.faults.len() >= MAX_FAULTS {
                return None;
            }
        }
        *self.values.last()?
    }

    fn value(&mut self, span: Span, kind: &Kind) -> Option<ExprId> {
        match kind {
            Kind::Number(literal) => Some(self.number(literal)),
            Kind::Name(name) => self.name(span, name),
            Kind::Negate(operand) => self.negate(*operand),
            Kind::Not(operand) => self.not(*operand),
            Kind::Infix(infix, left, right) => self.infix(span, *infix, *left, *right),
            Kind::Call(name, arguments) => self.call(span, name, arguments),
            Kind::Partial {
                polynomial,
                argument,
                at,
            } => self.partial(span, polynomial, argument, at),
            Kind::Array(items) => self.array(span, items),
            Kind::Index(operand, indices) => self.index(span, *operand, indices),
            Kind::Each {
                counter,
                range,
                body,
            } => self.each(span, counter, *range, body),
        }
    }

    fn number(&mut self, literal: &Literal) -> ExprId {
        let dimension = match &literal.unit {
            Some(unit) => unit.dimension,
            None if literal.value == 0.0 => Dimension::ANY,
            None => Dimension::ONE,
        };
        self.literal(literal.value, dimension)
    }

    fn literal(&mut self, value: f64, dimension: Dimension) -> ExprId {
        self.arena
            .intern(Node::Number(Bits(value.to_bits())), Type::scalar(dimension))
    }

    /// `[a, b]` of scalars is a vector, of vectors of one length the matrix with those rows.
    fn array(&mut self, span: Span, items: &[NodeId]) -> Option<ExprId> {
        let items = items
            .iter()
            .map(|&item| self.real(item, "an entry of an array"))
            .collect::<Vec<_>>();
        let items = items.into_iter().collect::<Option<Vec<_>>>()?;
        self.stack(span, items)
    }

    fn stack(&mut self, span: Span, items: Vec<(ExprId, Real)>) -> Option<ExprId> {
        let (_, first) = items.first()?;
        let row = first.shape;
        let odd = items
            .iter()
            .find(|(_, real)| real.shape != row || matches!(row, Shape::Matrix(..)));
        if let Some((_, odd)) = odd {
            let (message, help) = if odd.shape == row {
                (
                    format!("shape mismatch: an entry of an array is {row}"),
                    "entries are scalars, rows are vectors of scalars",
                )
            } else {
                (
                    format!("shape mismatch: array of {row} and {}", odd.shape),
                    "all rows of a matrix have one length",
                )
            };
            return self.report(span, Fault::new(Rule::E0505, message, help), &[]);
        }
        let shape = match row {
            Shape::Vector(cols) => Shape::Matrix(items.len(), cols),
            _ => Shape::Vector(items.len()),
        };
        let mut entries = Vec::new();
        let mut dimensions = Vec::new();
        for (id, real) in items {
            let places = 0..real.shape.entries();
            entries.extend(places.map(|place| {
                if row == Shape::Scalar {
                    id
                } else {
                    self.entry(id, place, 0)
                }
            }));
            dimensions.extend(real.dimensions);
        }
        Some(
            self.arena
                .intern(Node::Array(entries), Type::Real { shape, dimensions }),
        )
    }

    fn index(&mut self, span: Span, operand: NodeId, indices: &[Index]) -> Option<ExprId> {
        let (id, real) = self.real(operand, "what is indexed")?;
        let indices: Option<Vec<usize>> = indices
            .iter()
            .map(|index| self.whole_index(index))
            .collect();
        let indices = indices?;
        let (row, col) = match (real.shape, indices.as_slice()) {
            (Shape::Vector(_), &[row]) => (row, 1),
            (Shape::Matrix(..), &[row, col]) => (row, col),
            (shape, _) => {
                let help = match shape {
                    Shape::Scalar => "only vectors and matrices have entries",
                    Shape::Vector(_) => "a vector takes one index: `v[1]`",
                    Shape::Matrix(..) => "a matrix takes its row and column: `M[1, 2]`",
                };
                let count = if indices.len() == 1 {
                    "1 index".to_owned()
                } else {
                    format!("{} indices", indices.len())
                };
                let message = format!("shape mismatch: {count} into {shape}");
                return self.report(span, Fault::new(Rule::E0501, message, help), &[]);
            }
        };
        let (rows, cols) = real.shape.size();
        if row > rows || col > cols {
            let place = if let [row] = indices.as_slice() {
                row.to_string()
            } else {
                format!("({row}, {col})")
            };
            let message = format!("index {place} outside {}", real.shape);
            return self.report(
                span,
                Fault::new(Rule::E0503, message, index_help(real.shape)),
                &[],
            );
        }
        Some(self.entry(id, row - 1, col - 1))
    }

    /// The entry of an array at a 0-based place; of an array written out, the entry itself.
    fn entry(&mut self, id: ExprId, row: usize, col: usize) -> ExprId {
        let Type::Real { shape, dimensions } = self.arena.ty(id) else {
            return id;
        };
        let place = row * shape.size().1 + col;
        if let Node::Array(entries) = self.arena.node(id) {
            return entries[place];
        }
        let ty = Type::scalar(dimensions[place]);
        self.arena.intern(Node::Element(id, row, col), ty)
    }

    /// An operand that must be a number or an array of numbers, with its type.
    fn real(&mut self, operand: NodeId, what: &str) -> Option<(ExprId, Real)> {
        let id = self.values[operand.0 as usize]?;
        self.real_value(self.span_of(operand), id, what)
    }

    fn real_value(&mut self, span: Span, id: ExprId, what: &str) -> Option<(ExprId, Real)> {
        if let Some(real) = Real::of(self.arena.ty(id)) {
            return Some((id, real));
        }
        let fault = Fault::new(
            Rule::E0502,
            format!("{what} is a truth value, expected a number"),
            "choose numbers with `if(condition, a, b)`",
        );
        self.report(span, fault, &[])
    }

    /// An operand that must be a truth value.
    fn truth(&mut self, operand: NodeId, what: &str) -> Option<ExprId> {
        let id = self.values[operand.0 as usize]?;
        let Type::Real { shape, .. } = self.arena.ty(id) else {
            return Some(id);
        };
        let fault = Fault::new(
            Rule::E0502,
            format!("{what} is {shape}, expected a truth value"),
            "compare numbers, as in `x > 0`",
        );
        self.report(self.span_of(operand), fault, &[])
    }

    /// Stores a node whose type follows from a rule, or reports why it has none.
    fn typed(
        &mut self,
        span: Span,
        node: Node,
        ty: Result<Real, Fault>,
        operands: &[NodeId],
    ) -> Option<ExprId> {
        match ty {
            Ok(ty) => Some(self.arena.intern(node, ty.into())),
            Err(fault) => self.report(span, fault, operands),
        }
    }

    /// Reports a fault at a place; `operands` are shown with what they are.
    fn report<T>(&mut self, span: Span, fault: Fault, operands: &[NodeId]) -> Option<T> {
        let Fault {
            rule,
            message,
            mut help,
            suggestion,
        } = fault;
        if rule.family() == "E04" {
            help.extend(self.misread_unit(span));
        }
        let mut diagnostic = Diagnostic {
            suggestion,
            ..Diagnostic::error(rule, span, message).with_help(help)
        };
        for &operand in operands {
            let place = self.span_of(operand);
            let ty = self.values[operand.0 as usize].map(|id| self.arena.ty(id));
            if let (true, Some(real)) = (place != span, ty.and_then(Real::of)) {
                diagnostic =
                    diagnostic.with_related(place, format!("this is {}", real.described()));
            }
        }
        if rule.family() == "E04" {
            diagnostic = self.with_origins(diagnostic, span);
        }
        self.faults.push(diagnostic);
        None
    }

    /// A warning for `2 m*g` within `span` where `g` was read as the gram but is also a name.
    fn misread_unit(&self, span: Span) -> Option<String> {
        let inside = |place: Span| span.start <= place.start && place.end <= span.end;
        let literals = self.expr.nodes().iter().filter(|node| inside(node.span));
        let units = literals.filter_map(|node| match &node.kind {
            Kind::Number(Literal { unit, .. }) => unit.as_ref(),
            _ => None,
        });
        units.into_iter().find_map(|unit| {
            let name = unit.symbols().skip(1).find(|name| self.resolve(name).is_some())?;
            let text = &unit.text;
            Some(format!("; in `{text}`, `{name}` is a unit: put blanks around the operator to use the name `{name}`"))
        })
    }

    fn span_of(&self, node: NodeId) -> Span {
        self.expr.node(node).span
    }
}

fn index_help(shape: Shape) -> String {
    match shape {
        Shape::Matrix(rows, cols) => {
            format!("rows are counted from 1 to {rows}, columns from 1 to {cols}")
        }
        shape => format!("entries are counted from 1 to {}", shape.entries()),
    }
}
