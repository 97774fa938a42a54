//! From a formula and a job to the canonical request and its key.
//!
//! Equal mathematics gives equal bytes: dead values are dropped, equal values are one, and names of intermediate values, origins,
//! coefficients and names of polynomial data are left out.

use std::collections::BTreeMap;

use sha2::{Digest, Sha256};

use super::document::{CASADI_VERSION, Node, Request, SCHEMA};
use super::job::Job;
use super::store::Key;
use crate::ir::mnemonic::{COMPARISONS, FUNCTIONS, OPERATORS, word};
use crate::ir::{Kernel, Op, PolynomialId, Program, Shape, TableId, Type, ValueId};

/// A request, and what it leaves out.
#[derive(Clone, Debug)]
pub struct Question<'a> {
    /// The formula.
    pub formula: &'a Program,
    /// The request.
    pub request: Request,
    /// The formula's data by the index that the request gives it.
    pub data: Vec<Data>,
}

/// What CasADi sees as a call of a function that it knows nothing of but the number of its arguments. A table is no other than polynomial data
/// to it, and the derivative of either is a call again.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Data {
    /// Polynomial data.
    Polynomial(PolynomialId),
    /// A derivative of a table.
    Table(TableId, Vec<u32>),
}

impl<'a> Question<'a> {
    /// The question for `job` derivatives of `formula`. A formula that derivation does not make (networks, literals other
    /// than 0, 1 and -1) is a compiler bug and panics.
    pub fn new(formula: &'a Program, job: &Job) -> Self {
        job.assert_fits(formula);
        for (name, id) in &formula.outputs {
            assert!(
                matches!(formula.ty(*id), Type::Real(_)),
                "invariant: `{name}` is real"
            );
        }
        let mut builder = Builder {
            formula,
            nodes: Vec::new(),
            index: BTreeMap::new(),
            data: Vec::new(),
        };
        let mut nodes = BTreeMap::new();
        for id in needed(formula) {
            let node = builder.node(id, &nodes);
            nodes.insert(id, node);
        }
        let inputs = formula
            .inputs
            .iter()
            .map(|input| (input.name.clone(), dimensions(input.shape)))
            .collect();
        let outputs = formula
            .outputs
            .iter()
            .map(|(name, id)| (name.clone(), nodes[id]))
            .collect();
        let request = Request {
            inputs,
            nodes: builder.nodes,
            outputs,
            job: job.clone(),
        };
        Self {
            formula,
            request,
            data: builder.data,
        }
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

/// Values that the outputs need, operands first, each output's after those of the outputs before: the order of the program's statements
/// does not count.
fn needed(formula: &Program) -> Vec<ValueId> {
    let mut placed = vec![false; formula.instructions.len()];
    let mut values = Vec::new();
    let mut stack: Vec<ValueId> = formula.outputs.iter().rev().map(|(_, id)| *id).collect();
    while let Some(&id) = stack.last() {
        let missing: Vec<ValueId> = formula
            .instruction(id)
            .op
            .operands()
            .into_iter()
            .filter(|operand| !placed[operand.0 as usize])
            .collect();
        if !missing.is_empty() {
            stack.extend(missing.iter().rev());
            continue;
        }
        stack.pop();
        if !std::mem::replace(&mut placed[id.0 as usize], true) {
            values.push(id);
        }
    }
    values
}

struct Builder<'a> {
    formula: &'a Program,
    nodes: Vec<Node>,
    index: BTreeMap<Node, usize>,
    data: Vec<Data>,
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
            Op::PowInt(_, n) => ("powi", vec![i64::from(*n)]),
            Op::Polynomial(id, _) => ("polynomial", vec![self.call(Data::Polynomial(*id))]),
            Op::Table(id, orders, _) => {
                let data = Data::Table(*id, orders.clone());
                ("polynomial", vec![self.call(data)])
            }
            Op::Kernel(Kernel::TanOver, _) => ("tan_over", vec![0]),
            Op::Kernel(Kernel::SinCosOver, _) => ("sin_cos_over", vec![0]),
            Op::Kernel(Kernel::SinCosOverD1, _) => ("sin_cos_over", vec![1]),
            Op::Kernel(Kernel::SinCosOverD2, _) => ("sin_cos_over", vec![2]),
            Op::Kernel(Kernel::SinCosOverD3, _) => ("sin_cos_over", vec![3]),
            Op::Apply(function, _) => (word(&FUNCTIONS, *function), Vec::new()),
            Op::Binary(operator, ..) => (word(&OPERATORS, *operator), Vec::new()),
            Op::Compare(comparison, ..) => (word(&COMPARISONS, *comparison), Vec::new()),
            Op::And(..) => ("and", Vec::new()),
            Op::Or(..) => ("or", Vec::new()),
            Op::Not(_) => ("not", Vec::new()),
            Op::Select(..) => ("select", Vec::new()),
            Op::MatMul(..) => ("matmul", Vec::new()),
            Op::Transpose(_) => ("transpose", Vec::new()),
            Op::Dot(..) => ("dot", Vec::new()),
            Op::Outer(..) => ("outer", Vec::new()),
            Op::SumSquares(_) => ("sum_squares", Vec::new()),
            Op::Solve(..) => ("solve", Vec::new()),
            Op::MulAdd(..)
            | Op::Ldlt(_)
            | Op::SingularVector(_)
            | Op::TableFamily(..)
            | Op::Family(..)
            | Op::Basis(..)
            | Op::BasisRate(..)
            | Op::BasisRate2(..) => {
                panic!("invariant: CasADi is not asked for derivatives of {op:?}")
            }
        };
        self.intern(Node(name.to_owned(), operands, data))
    }

    /// A literal array as an array of scalar literals.
    fn literal(&mut self, values: &[f64], shape: Shape) -> usize {
        let entries: Vec<usize> = values
            .iter()
            .map(|value| self.scalar_literal(*value))
            .collect();
        match shape {
            Shape::Scalar => entries[0],
            _ => self.intern(Node(
                "array".to_owned(),
                entries,
                integers(&dimensions(shape)),
            )),
        }
    }

    fn scalar_literal(&mut self, value: f64) -> usize {
        let integer = [-1i64, 0, 1]
            .into_iter()
            .find(|integer| *integer as f64 == value);
        let integer = integer.expect("invariant: a formula has no literals but -1, 0 and 1");
        self.intern(Node("const".to_owned(), Vec::new(), vec![integer]))
    }

    /// Index by first use.
    fn call(&mut self, data: Data) -> i64 {
        let known = self.data.iter().position(|known| *known == data);
        let position = known.unwrap_or_else(|| {
            self.data.push(data);
            self.data.len() - 1
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
    values
        .iter()
        .map(|value| i64::try_from(*value).expect("invariant: sizes are small"))
        .collect()
}
