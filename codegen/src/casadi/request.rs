//! From a formula and a job to the canonical request and its key.
//!
//! Equal mathematics gives equal bytes: dead values are dropped, equal values are one, and names of intermediate values, origins,
//! coefficients and names of polynomial data are left out.

use std::collections::BTreeMap;

use sha2::{Digest, Sha256};

use super::document::{CASADI_VERSION, Node, Request, SCHEMA};
use super::job::Job;
use super::store::Key;
use crate::ir::{Comparison, Function, Kernel, Op, Operator, PolynomialId, Program, Shape, Type, ValueId};

/// A request, and what it leaves out.
#[derive(Clone, Debug)]
pub struct Question<'a> {
    /// The formula.
    pub formula: &'a Program,
    /// The request.
    pub request: Request,
    /// The formula's polynomial data by the index that the request gives it.
    pub polynomials: Vec<PolynomialId>,
}

impl<'a> Question<'a> {
    /// The question for `job` derivatives of `formula`. A formula that derivation does not make (networks, `Solve`, literals other
    /// than 0, 1 and -1) is a compiler bug and panics.
    pub fn new(formula: &'a Program, job: &Job) -> Self {
        job.assert_fits(formula);
        let mut builder = Builder { formula, nodes: Vec::new(), index: BTreeMap::new(), polynomials: Vec::new() };
        let mut nodes = BTreeMap::new();
        for id in live(formula) {
            let node = builder.node(id, &nodes);
            nodes.insert(id, node);
        }
        let inputs = formula.inputs.iter().map(|input| (input.name.clone(), dimensions(input.shape))).collect();
        let outputs = formula.outputs.iter().map(|(name, id)| (name.clone(), nodes[id])).collect();
        let request = Request { inputs, nodes: builder.nodes, outputs, job: job.clone() };
        Self { formula, request, polynomials: builder.polynomials }
    }

    /// Hash of the schema, CasADi's version and the request.
    pub fn key(&self) -> Key {
        key(&self.request)
    }
}

/// Hash of the schema, CasADi's version and a request.
pub(crate) fn key(request: &Request) -> Key {
    let body = serde_json::to_string(request).expect("invariant: a request is JSON");
    let digest = Sha256::digest(format!("{SCHEMA}\n{CASADI_VERSION}\n{body}"));
    Key::from_digest(digest.as_slice())
}

/// Shape as a list of sizes.
pub(crate) fn dimensions(shape: Shape) -> Vec<usize> {
    match shape {
        Shape::Scalar => Vec::new(),
        Shape::Vector(rows) => vec![rows],
        Shape::Matrix(rows, columns) => vec![rows, columns],
    }
}

/// Values that an output needs, in order.
fn live(formula: &Program) -> Vec<ValueId> {
    let mut needed = vec![false; formula.instructions.len()];
    for (name, id) in &formula.outputs {
        assert!(matches!(formula.ty(*id), Type::Real(_)), "invariant: `{name}` is real");
        needed[id.0 as usize] = true;
    }
    let mut values = Vec::new();
    for (position, instruction) in formula.instructions.iter().enumerate().rev() {
        if needed[position] {
            instruction.op.operands().iter().for_each(|operand| needed[operand.0 as usize] = true);
            values.push(ValueId(u32::try_from(position).expect("invariant: fewer than 2^32 instructions")));
        }
    }
    values.reverse();
    values
}

struct Builder<'a> {
    formula: &'a Program,
    nodes: Vec<Node>,
    index: BTreeMap<Node, usize>,
    polynomials: Vec<PolynomialId>,
}

impl Builder<'_> {
    fn node(&mut self, id: ValueId, nodes: &BTreeMap<ValueId, usize>) -> usize {
        let op = &self.formula.instruction(id).op;
        let operands: Vec<usize> = op.operands().iter().map(|operand| nodes[operand]).collect();
        let (name, data) = match op {
            Op::Const(values) => return self.literal(values, self.formula.shape(id)),
            Op::Array(_) if self.formula.shape(id) == Shape::Scalar => return operands[0],
            Op::Array(_) => ("array", integers(&dimensions(self.formula.shape(id)))),
            Op::Input(position) => ("input", integers(&[*position])),
            Op::Element(_, row, column) => ("element", integers(&[*row, *column])),
            Op::PowInt(_, n) => ("power", vec![i64::from(*n)]),
            Op::Polynomial(polynomial, _) => ("polynomial", vec![self.polynomial(*polynomial)]),
            Op::Kernel(Kernel::TanOver, _) => ("tan_over", vec![0]),
            Op::Kernel(kernel, _) => ("sin_cos_over", vec![kernel_order(*kernel)]),
            Op::Apply(function, _) => (function_name(*function), Vec::new()),
            Op::Binary(operator, ..) => (operator_name(*operator), Vec::new()),
            Op::Compare(comparison, ..) => (comparison_name(*comparison), Vec::new()),
            Op::And(..) => ("and", Vec::new()),
            Op::Or(..) => ("or", Vec::new()),
            Op::Not(_) => ("not", Vec::new()),
            Op::Select(..) => ("select", Vec::new()),
            Op::MatMul(..) => ("matmul", Vec::new()),
            Op::Transpose(_) => ("transpose", Vec::new()),
            Op::Dot(..) => ("dot", Vec::new()),
            Op::Outer(..) => ("outer", Vec::new()),
            Op::SumSquares(_) => ("sum_squares", Vec::new()),
            Op::Solve(..) | Op::SingularVector(_) | Op::Basis(..) | Op::BasisRate(..) | Op::BasisRate2(..) => {
                panic!("invariant: CasADi is not asked for derivatives of {op:?}")
            }
        };
        self.intern(Node(name.to_owned(), operands, data))
    }

    /// A literal array as an array of scalar literals.
    fn literal(&mut self, values: &[f64], shape: Shape) -> usize {
        let entries: Vec<usize> = values.iter().map(|value| self.scalar_literal(*value)).collect();
        match shape {
            Shape::Scalar => entries[0],
            _ => self.intern(Node("array".to_owned(), entries, integers(&dimensions(shape)))),
        }
    }

    fn scalar_literal(&mut self, value: f64) -> usize {
        let integer = [-1i64, 0, 1].into_iter().find(|integer| *integer as f64 == value);
        let integer = integer.expect("invariant: a formula has no literals but -1, 0 and 1");
        self.intern(Node("const".to_owned(), Vec::new(), vec![integer]))
    }

    /// Index by first use.
    fn polynomial(&mut self, id: PolynomialId) -> i64 {
        let position = self.polynomials.iter().position(|known| *known == id).unwrap_or_else(|| {
            self.polynomials.push(id);
            self.polynomials.len() - 1
        });
        integers(&[position])[0]
    }

    fn intern(&mut self, node: Node) -> usize {
        *self.index.entry(node.clone()).or_insert_with(|| {
            self.nodes.push(node);
            self.nodes.len() - 1
        })
    }
}

fn integers(values: &[usize]) -> Vec<i64> {
    values.iter().map(|value| i64::try_from(*value).expect("invariant: sizes are small")).collect()
}

fn kernel_order(kernel: Kernel) -> i64 {
    match kernel {
        Kernel::SinCosOver | Kernel::TanOver => 0,
        Kernel::SinCosOverD1 => 1,
        Kernel::SinCosOverD2 => 2,
        Kernel::SinCosOverD3 => 3,
    }
}

fn function_name(function: Function) -> &'static str {
    match function {
        Function::Neg => "neg",
        Function::Abs => "abs",
        Function::Sign => "sign",
        Function::Sqrt => "sqrt",
        Function::Exp => "exp",
        Function::Ln => "ln",
        Function::Sin => "sin",
        Function::Cos => "cos",
        Function::Tan => "tan",
        Function::Asin => "asin",
        Function::Acos => "acos",
        Function::Atan => "atan",
        Function::Sinh => "sinh",
        Function::Cosh => "cosh",
        Function::Tanh => "tanh",
    }
}

fn operator_name(operator: Operator) -> &'static str {
    match operator {
        Operator::Add => "add",
        Operator::Sub => "sub",
        Operator::Mul => "mul",
        Operator::Div => "div",
        Operator::Pow => "pow",
        Operator::Min => "min",
        Operator::Max => "max",
        Operator::Atan2 => "atan2",
    }
}

fn comparison_name(comparison: Comparison) -> &'static str {
    match comparison {
        Comparison::Lt => "lt",
        Comparison::Le => "le",
        Comparison::Gt => "gt",
        Comparison::Ge => "ge",
        Comparison::Eq => "eq",
        Comparison::Ne => "ne",
    }
}
