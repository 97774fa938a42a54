//! A small world of names, and one helper for each phase.

mod faults;
mod hostile;
mod meaning;
mod syntax;
mod values;

use super::arena::*;
use super::*;
use crate::diagnostic::{Diagnostic, FileId};
use crate::unit::{Dimension, parse_unit};

/// A plant with states `alpha` and `x`, a constant `g` and so on; `broken` has a fault elsewhere, `later` must not be used.
#[derive(Default)]
struct World {
    derivatives: Vec<(PolynomialId, usize)>,
    inserted: usize,
}

const THREE: Shape = Shape::Vector(3);

fn dimension(unit: &str) -> Dimension {
    parse_unit(unit).unwrap().dimension
}

impl Scope for World {
    fn resolve(&self, name: &str) -> Option<Symbol> {
        let array = |shape, unit| Type::uniform(shape, dimension(unit));
        Some(match name {
            "t" => Symbol::Time,
            "g" => Symbol::Constant(ConstantId(0), Type::scalar(dimension("m/s^2"))),
            "inertia" => Symbol::Constant(ConstantId(1), array(Shape::Matrix(3, 3), "kg*m^2")),
            "mixed" => Symbol::Constant(ConstantId(2), mixed()),
            "mass" => Symbol::Parameter(ParameterId(0), Type::scalar(dimension("kg"))),
            "n" => Symbol::Parameter(ParameterId(1), Type::scalar(Dimension::ONE)),
            "alpha" => Symbol::State {
                block: 0,
                channel: 0,
                dimension: Dimension::ONE,
            },
            "x" => Symbol::State {
                block: 0,
                channel: 1,
                dimension: dimension("m"),
            },
            "v" => Symbol::State {
                block: 1,
                channel: 0,
                dimension: dimension("m/s"),
            },
            "omega" => Symbol::Definition(DefinitionId(0), array(THREE, "rad/s")),
            "pair" => Symbol::Definition(DefinitionId(1), array(Shape::Vector(2), "m")),
            "CL.alpha" => {
                Symbol::Polynomial(PolynomialId(0), vec!["alpha_deg".into(), "mach".into()])
            }
            "later" => Symbol::Unavailable("constants depend on constants only".into()),
            "broken" => Symbol::Faulty,
            _ => return None,
        })
    }

    fn names(&self) -> Vec<String> {
        let names = "t g inertia mixed mass n alpha x v omega pair CL.alpha";
        names.split(' ').map(str::to_owned).collect()
    }

    fn insert(&mut self, operations: usize) -> bool {
        self.inserted += operations;
        self.inserted <= 10_000
    }

    fn derivative(&mut self, polynomial: PolynomialId, argument: usize) -> PolynomialId {
        self.derivatives.push((polynomial, argument));
        PolynomialId(100 + u32::try_from(argument).unwrap())
    }
}

/// Rows in m and s.
fn mixed() -> Type {
    let dimensions = vec![dimension("m"), dimension("s")];
    Type::Real {
        shape: Shape::Vector(2),
        dimensions,
    }
}

fn base(text: &str) -> Base {
    Base::exact(FileId(0), 1000, text.len())
}

/// Faults as `code from..to message [place: label] | help`, offsets in the text.
fn shown(faults: &[Diagnostic]) -> String {
    let lines = faults.iter().map(|fault| {
        let span = fault.span.unwrap();
        let related = fault.related.iter().map(|related| {
            format!(
                " [{}..{}: {}]",
                related.span.start - 1000,
                related.span.end - 1000,
                related.label
            )
        });
        let help = fault.help.as_deref().unwrap_or("no help");
        let (start, end) = (span.start - 1000, span.end - 1000);
        format!(
            "{} {start}..{end} {}{} | {help}",
            fault.rule,
            fault.message,
            related.collect::<String>()
        )
    });
    lines.collect::<Vec<_>>().join("\n")
}

/// The meaning of an expression, or its faults.
fn meaning(text: &str) -> Result<(Arena, ExprId), String> {
    let syntax = parse(text, base(text)).map_err(|faults| shown(&faults))?;
    let mut arena = Arena::default();
    let id =
        elaborate(&syntax, &mut World::default(), &mut arena).map_err(|faults| shown(&faults))?;
    Ok((arena, id))
}

/// A node with its operands in prefix form.
fn node(arena: &Arena, id: ExprId) -> String {
    let head = match arena.node(id) {
        Node::Number(Bits(bits)) => return f64::from_bits(*bits).to_string(),
        Node::Constant(ConstantId(id)) => return format!("c{id}"),
        Node::Parameter(ParameterId(id)) => return format!("p{id}"),
        Node::State { block, channel } => return format!("x{block}.{channel}"),
        Node::Time => return "t".to_owned(),
        Node::Definition(DefinitionId(id)) => return format!("d{id}"),
        Node::Apply(function, _) => format!("{function:?}"),
        Node::Binary(operator, ..) => format!("{operator:?}"),
        Node::PowInt(_, n) => format!("PowInt{n}"),
        Node::Compare(comparison, ..) => format!("{comparison:?}"),
        Node::Element(_, row, col) => format!("Element{row},{col}"),
        Node::Polynomial(PolynomialId(id), _) => format!("Poly{id}"),
        other => format!("{other:?}").split('(').next().unwrap().to_owned(),
    };
    let operands: Vec<_> = arena
        .node(id)
        .operands()
        .into_iter()
        .map(|operand| node(arena, operand))
        .collect();
    format!("{head}({})", operands.join(" "))
}

/// The type as `shape in dimensions`.
fn kind(arena: &Arena, id: ExprId) -> String {
    let Type::Real { shape, dimensions } = arena.ty(id) else {
        return "truth".to_owned();
    };
    let dimensions: Vec<_> = dimensions.iter().map(Dimension::to_string).collect();
    format!("{shape} in {}", dimensions.join(", "))
}
