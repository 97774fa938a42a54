//! Numbers from expressions, while a specification is read: constants, initial values, suprema over the horizon.

use std::fmt;

use nsv_math::real::Real;

use super::arena::{
    Arena, Bits, Comparison, ConstantId, DefinitionId, ExprId, Function, Node, Operator,
    ParameterId, PolynomialId, Shape, TableId,
};
use crate::interpolation::Interpolant;
use crate::linear;
use crate::model::Polynomial;

/// Values of what an expression refers to; by default nothing has one.
pub trait Environment {
    /// Entries of a constant, row-major.
    fn constant(&self, _id: ConstantId) -> Option<Vec<f64>> {
        None
    }

    /// Value of a parameter.
    fn parameter(&self, _id: ParameterId) -> Option<f64> {
        None
    }

    /// Value of a state channel, both indices 0-based.
    fn state(&self, _block: usize, _channel: usize) -> Option<f64> {
        None
    }

    /// Value of a further state of the flown plant, 0-based.
    fn truth(&self, _at: usize) -> Option<f64> {
        None
    }

    /// Value of a control input, 0-based.
    fn input(&self, _at: usize) -> Option<f64> {
        None
    }

    /// Time, s.
    fn time(&self) -> Option<f64> {
        None
    }

    /// Expression of a definition.
    fn definition(&self, _id: DefinitionId) -> Option<ExprId> {
        None
    }

    /// A lookup table.
    fn table(&self, _id: TableId) -> Option<&Interpolant> {
        None
    }

    /// Polynomial data.
    fn polynomial(&self, _id: PolynomialId) -> Option<&Polynomial> {
        None
    }
}

/// The expression needs something that the [`Environment`] does not have; an invariant that the caller knows better than
/// the user.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EvaluationError {
    /// The leaf without a value.
    pub leaf: Node,
}

impl fmt::Display for EvaluationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "no value for {:?}", self.leaf)
    }
}

impl std::error::Error for EvaluationError {}

/// Value of an expression in SI, entries row-major; a truth value is 1 or 0. Definitions must not refer to themselves.
///
/// Each shared part is computed once, and in a loop: neither long nor deep expressions exhaust the stack. Elementary functions
/// are those of `nsv-math`, integer powers and reductions in the order of the emitted code.
pub fn evaluate(
    arena: &Arena,
    id: ExprId,
    environment: &dyn Environment,
) -> Result<Vec<f64>, EvaluationError> {
    let mut evaluator = Evaluator {
        arena,
        environment,
        values: Values::of(arena),
    };
    let mut pending = vec![id];
    while let Some(&next) = pending.last() {
        if evaluator.values.get(next).is_some() {
            pending.pop();
            continue;
        }
        let operands = evaluator.operands(next)?.into_iter();
        let missing = pending.len();
        pending.extend(operands.filter(|&operand| evaluator.values.get(operand).is_none()));
        if pending.len() == missing {
            let value = evaluator.compute(next)?;
            evaluator.values.insert(next, &value);
            pending.pop();
        }
    }
    Ok(evaluator.values.at(id).to_vec())
}

struct Evaluator<'a> {
    arena: &'a Arena,
    environment: &'a dyn Environment,
    values: Values,
}

/// Values of expressions, one behind the other.
struct Values {
    /// Start and end of the entries of each expression of the arena, [`Values::UNKNOWN`] before it has any.
    ranges: Vec<(u32, u32)>,
    entries: Vec<f64>,
}

impl Values {
    const UNKNOWN: (u32, u32) = (1, 0);

    fn of(arena: &Arena) -> Values {
        Values {
            ranges: vec![Self::UNKNOWN; arena.len()],
            entries: Vec::new(),
        }
    }

    fn get(&self, id: ExprId) -> Option<&[f64]> {
        let (start, end) = self.ranges[id.0 as usize];
        (start <= end).then(|| &self.entries[start as usize..end as usize])
    }

    fn at(&self, id: ExprId) -> &[f64] {
        self.get(id).expect("invariant: operands have their values")
    }

    fn insert(&mut self, id: ExprId, value: &[f64]) {
        let place =
            |length: usize| u32::try_from(length).expect("invariant: expressions are bounded");
        let start = place(self.entries.len());
        self.entries.extend(value);
        self.ranges[id.0 as usize] = (start, place(self.entries.len()));
    }
}

impl Evaluator<'_> {
    /// What must be known first; the body of a definition counts as its operand.
    fn operands(&self, id: ExprId) -> Result<Vec<ExprId>, EvaluationError> {
        match self.arena.node(id) {
            Node::Definition(definition) => Ok(vec![
                self.found(id, self.environment.definition(*definition))?,
            ]),
            node => Ok(node.operands()),
        }
    }

    fn found<T>(&self, id: ExprId, value: Option<T>) -> Result<T, EvaluationError> {
        value.ok_or_else(|| EvaluationError {
            leaf: self.arena.node(id).clone(),
        })
    }

    fn compute(&self, id: ExprId) -> Result<Vec<f64>, EvaluationError> {
        let environment = self.environment;
        let scalar = |value: Option<f64>| self.found(id, value).map(|value| vec![value]);
        Ok(match self.arena.node(id) {
            Node::Number(Bits(bits)) => vec![f64::from_bits(*bits)],
            Node::Constant(constant) => self.found(id, environment.constant(*constant))?,
            Node::Parameter(parameter) => scalar(environment.parameter(*parameter))?,
            Node::State { block, channel } => scalar(environment.state(*block, *channel))?,
            Node::Truth(at) => scalar(environment.truth(*at))?,
            Node::Input(at) => scalar(environment.input(*at))?,
            Node::Time => scalar(environment.time())?,
            Node::Definition(definition) => {
                let body = self.found(id, environment.definition(*definition))?;
                self.values.at(body).to_vec()
            }
            Node::Polynomial(polynomial, arguments) => {
                let data = self.found(id, environment.polynomial(*polynomial))?;
                let arguments: Vec<f64> = arguments
                    .iter()
                    .map(|&argument| self.number(argument))
                    .collect();
                vec![polynomial_value(data, &arguments)]
            }
            Node::Table(table, orders, arguments) => {
                let table = self.found(id, environment.table(*table))?;
                let arguments: Vec<f64> = arguments
                    .iter()
                    .map(|&argument| self.number(argument))
                    .collect();
                vec![table.value(&arguments, orders)]
            }
            node => self.combine(node),
        })
    }

    /// Value of a node made of other nodes.
    fn combine(&self, node: &Node) -> Vec<f64> {
        let value = |id: &ExprId| self.values.at(*id);
        let truth = |id: &ExprId| self.number(*id) != 0.0;
        match node {
            Node::Apply(f, a) => value(a).iter().map(|&x| function(*f, x)).collect(),
            Node::Binary(operator, a, b) => {
                broadcast(value(a), value(b), |x, y| binary(*operator, x, y))
            }
            Node::PowInt(a, n) => vec![integer_power(self.number(*a), n.unsigned_abs())],
            Node::Compare(comparison, a, b) => vec![f64::from(compare(
                *comparison,
                self.number(*a),
                self.number(*b),
            ))],
            Node::And(a, b) => vec![f64::from(truth(a) && truth(b))],
            Node::Or(a, b) => vec![f64::from(truth(a) || truth(b))],
            Node::Not(a) => vec![f64::from(!truth(a))],
            Node::If(condition, a, b) => value(if truth(condition) { a } else { b }).to_vec(),
            Node::Array(entries) => entries.iter().map(|&entry| self.number(entry)).collect(),
            Node::Element(a, row, col) => vec![value(a)[row * self.size(*a).1 + col]],
            Node::MatMul(a, b) => self.matrix_product(*a, *b),
            Node::Transpose(a) => {
                let (rows, cols) = self.size(*a);
                let places = (0..cols).flat_map(|col| (0..rows).map(move |row| row * cols + col));
                places.map(|place| value(a)[place]).collect()
            }
            Node::Dot(a, b) => vec![sum(value(a).iter().zip(value(b)).map(|(x, y)| x * y))],
            Node::Cross(a, b) => cross(value(a), value(b)),
            Node::Solve(a, b) => {
                let mut x = value(b).to_vec();
                linear::solve(value(a), self.size(*b).1, &mut x);
                x
            }
            Node::Number(_)
            | Node::Constant(_)
            | Node::Parameter(_)
            | Node::State { .. }
            | Node::Truth(_)
            | Node::Input(_)
            | Node::Time
            | Node::Definition(_)
            | Node::Polynomial(..)
            | Node::Table(..) => {
                unreachable!("invariant: leaves have their value from the environment")
            }
        }
    }

    fn matrix_product(&self, a: ExprId, b: ExprId) -> Vec<f64> {
        let ((rows, inner), (_, cols)) = (self.size(a), self.size(b));
        let (a, b) = (self.values.at(a), self.values.at(b));
        let entry = |row: usize, col: usize| {
            sum((0..inner).map(|k| a[row * inner + k] * b[k * cols + col]))
        };
        (0..rows)
            .flat_map(|row| (0..cols).map(move |col| (row, col)))
            .map(|(row, col)| entry(row, col))
            .collect()
    }

    fn number(&self, id: ExprId) -> f64 {
        self.values.at(id)[0]
    }

    fn size(&self, id: ExprId) -> (usize, usize) {
        self.arena.shape(id).unwrap_or(Shape::Scalar).size()
    }
}

fn function(function: Function, x: f64) -> f64 {
    match function {
        Function::Neg => -x,
        Function::Abs => x.abs(),
        Function::Sign if x > 0.0 => 1.0,
        Function::Sign if x < 0.0 => -1.0,
        Function::Sign => x,
        Function::Sqrt => Real::sqrt(x),
        Function::Exp => Real::exp(x),
        Function::Ln => Real::ln(x),
        Function::Sin => Real::sin(x),
        Function::Cos => Real::cos(x),
        Function::Tan => Real::tan(x),
        Function::Asin => Real::asin(x),
        Function::Acos => Real::acos(x),
        Function::Atan => Real::atan(x),
        Function::Sinh => Real::sinh(x),
        Function::Cosh => Real::cosh(x),
        Function::Tanh => Real::tanh(x),
    }
}

fn binary(operator: Operator, x: f64, y: f64) -> f64 {
    match operator {
        Operator::Add => x + y,
        Operator::Sub => x - y,
        Operator::Mul => x * y,
        Operator::Div => x / y,
        Operator::Pow => Real::pow(x, y),
        Operator::Min => {
            if x < y {
                x
            } else {
                y
            }
        }
        Operator::Max => {
            if x > y {
                x
            } else {
                y
            }
        }
        Operator::Atan2 => Real::atan2(x, y),
    }
}

fn compare(comparison: Comparison, x: f64, y: f64) -> bool {
    match comparison {
        Comparison::Lt => x < y,
        Comparison::Le => x <= y,
        Comparison::Gt => x > y,
        Comparison::Ge => x >= y,
        Comparison::Eq => x == y,
        Comparison::Ne => x != y,
    }
}

fn broadcast(left: &[f64], right: &[f64], rule: impl Fn(f64, f64) -> f64) -> Vec<f64> {
    match (left, right) {
        (&[x], _) => right.iter().map(|&y| rule(x, y)).collect(),
        (_, &[y]) => left.iter().map(|&x| rule(x, y)).collect(),
        _ => left.iter().zip(right).map(|(&x, &y)| rule(x, y)).collect(),
    }
}

/// x^n by left-to-right binary powering, n >= 1.
fn integer_power(x: f64, n: u32) -> f64 {
    let lower_bits = (0..n.max(1).ilog2()).rev();
    lower_bits.fold(x, |power, bit| {
        if n >> bit & 1 == 1 {
            power * power * x
        } else {
            power * power
        }
    })
}

/// Left to right, starting from the first term.
fn sum(terms: impl Iterator<Item = f64>) -> f64 {
    terms.reduce(|sum, term| sum + term).unwrap_or(0.0)
}

fn cross(a: &[f64], b: &[f64]) -> Vec<f64> {
    (0..3)
        .map(|i| (i + 1) % 3)
        .map(|j| (j, (j + 1) % 3))
        .map(|(j, k)| a[j] * b[k] - a[k] * b[j])
        .collect()
}

/// Sum of c * z_1^a_1 * ... * z_v^a_v, term by term.
fn polynomial_value(data: &Polynomial, arguments: &[f64]) -> f64 {
    let term = |(coefficient, exponents): &(f64, Vec<u32>)| {
        let factors = arguments
            .iter()
            .zip(exponents)
            .filter(|(_, exponent)| **exponent > 0);
        factors.fold(*coefficient, |product, (&argument, &exponent)| {
            product * integer_power(argument, exponent)
        })
    };
    sum(data.terms.iter().map(term))
}
