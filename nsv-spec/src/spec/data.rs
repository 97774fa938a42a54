//! Constants, parameters, polynomial data, lookup tables and functions.

use super::{Choice, Code, Declared, Formula, Read, Word};
use crate::diagnostic::Span;
use crate::interpolation::{Degree, Extrapolation};

/// A constant.
#[derive(Clone, Debug, PartialEq)]
pub struct Constant {
    /// Its value.
    pub value: Formula,
    /// `unit`
    pub unit: Option<Read<Word>>,
    /// `source`
    pub source: Option<Word>,
}

/// A parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Its value.
    pub value: Code,
    /// `unit`
    pub unit: Option<Read<Word>>,
    /// `dispersion`
    pub dispersion: Option<Read<Dispersion>>,
    /// `source`
    pub source: Option<Word>,
}

/// Distribution of a quantity.
#[derive(Clone, Debug, PartialEq)]
pub enum Dispersion {
    /// Least and largest value.
    Uniform([Code; 2]),
    /// Mean and standard deviation.
    Normal([Code; 2]),
    /// Mean, standard deviation, least and largest value.
    TruncatedNormal([Code; 4]),
    /// Median, and standard deviation of the logarithm.
    Lognormal([Code; 2]),
    /// Values, each with its probability.
    Discrete(Vec<[Code; 2]>),
}

/// Parameters that are drawn together.
#[derive(Clone, Debug, PartialEq)]
pub struct Correlation {
    /// `parameters`
    pub parameters: Read<Vec<Word>>,
    /// `covariance`
    pub covariance: Formula,
}

/// Coefficient and exponents of each term of a polynomial.
pub type Terms = Vec<(f64, Vec<u32>)>;

/// A function.
#[derive(Clone, Debug, PartialEq)]
pub struct Function {
    /// `arguments`
    pub arguments: Read<Vec<Word>>,
    /// `value`
    pub value: Code,
}

/// Plain numbers as written.
#[derive(Clone, Debug, PartialEq)]
pub enum Grid {
    /// One number.
    Number(Word),
    /// A list.
    List(Vec<Grid>, Span),
}

impl Grid {
    /// Where it is written.
    pub fn span(&self) -> Span {
        match self {
            Grid::Number(word) => word.span,
            Grid::List(_, span) => *span,
        }
    }
}

/// A lookup table.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// `axes`
    pub axes: Declared<Axis>,
    /// `values`
    pub values: Option<Read<Grid>>,
    /// `file`
    pub file: Option<Read<Word>>,
    /// `column`
    pub column: Option<Read<Word>>,
    /// `unit`
    pub unit: Option<Read<Word>>,
    /// `interpolation`
    pub interpolation: Choice<Degree>,
    /// `extrapolation`
    pub extrapolation: Choice<Extrapolation>,
    /// `source`
    pub source: Option<Word>,
}

/// An axis of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// `values`
    pub values: Option<Read<Grid>>,
    /// `unit`
    pub unit: Option<Read<Word>>,
}

/// A group of polynomial data.
#[derive(Clone, Debug, PartialEq)]
pub struct PolynomialGroup {
    /// `arguments`
    pub arguments: Read<Vec<Word>>,
    /// `source`
    pub source: Option<Word>,
    /// `parts`
    pub parts: Declared<Read<Terms>>,
}
