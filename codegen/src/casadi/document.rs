//! The documents exchanged with `export.py` and stored in export files.

use serde::{Deserialize, Serialize};

use super::job::Job;

/// Version of the documents; a change of them, or of what `export.py` answers, takes a new number.
pub const SCHEMA: &str = "nsv-partials/1";

/// The version of CasADi that answers; another one may write other expressions.
pub const CASADI_VERSION: &str = "3.8.2";

/// One operation: name, operands (earlier nodes), integers.
///
/// Of a request: `const [] [-1, 0 or 1]`, `input [] [position]`, `array [entries] [shape]`, `element [a] [row, column]`,
/// `powi [a] [n]`, `solve [a, b] []`, `polynomial [arguments] [index]`, `sin_cos_over [a] [order]`, and names of functions and operators.
/// Of a tape, where every node is a scalar: `const [] [constant]`, `input [] [position, entry]`, `powi`, `sin_cos_over`,
/// `tan_over`, `solve [matrix .., right side ..] [rows, entry]`, `polynomial [arguments] [index, order by each argument ..]`, and CasADi's operations in capitals.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Node(pub String, pub Vec<usize>, pub Vec<i64>);

/// A formula to differentiate. Inputs keep their names, intermediate values have none.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Request {
    /// Name and shape: `[]` for a scalar, `[rows]`, or `[rows, columns]`.
    pub inputs: Vec<(String, Vec<usize>)>,
    /// Operations in order.
    pub nodes: Vec<Node>,
    /// Name and node.
    pub outputs: Vec<(String, usize)>,
    /// The derivatives asked for.
    pub job: Job,
}

/// Scalar instructions of the derivatives.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Tape {
    /// Constants in hexadecimal floating point, exact.
    pub constants: Vec<String>,
    /// Instructions in order.
    pub nodes: Vec<Node>,
    /// Name, and node of each entry in row-major order; `None` for a structural zero.
    pub outputs: Vec<(String, Vec<Option<usize>>)>,
}

/// What `export.py` reads.
#[derive(Debug, Serialize)]
pub(crate) struct Ask<'a> {
    pub schema: &'a str,
    pub casadi: &'a str,
    /// `None` asks for versions only.
    pub request: Option<&'a Request>,
}

/// What `export.py` writes.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Answer {
    pub schema: String,
    pub tape: Option<Tape>,
    pub python: Option<String>,
    pub error: Option<Refusal>,
}

/// Why `export.py` did not answer.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Refusal {
    pub code: String,
    pub message: String,
}

/// A stored answer with its question.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Export {
    /// [`SCHEMA`].
    pub schema: String,
    /// [`CASADI_VERSION`].
    pub casadi: String,
    /// The question.
    pub request: Request,
    /// The answer.
    pub tape: Tape,
}
