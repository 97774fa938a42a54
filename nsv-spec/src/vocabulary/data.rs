//! Keys of constants, parameters and polynomial data.

use super::dispersion::DISPERSION;
use super::{Kind, Section, optional, required};

/// Short or long form.
pub(super) const CONSTANT_KIND: Kind = Kind::Either(&[Kind::Formula, Kind::Section(&CONSTANT)]);
/// Short or long form.
pub(super) const PARAMETER_KIND: Kind = Kind::Either(&[Kind::Quantity, Kind::Section(&PARAMETER)]);

/// The long form of a constant.
pub static CONSTANT: Section = Section {
    noun: "a constant",
    keys: &[
        required(
            "value",
            Kind::Formula,
            "number, expression of constants, list, or list of lists",
        ),
        optional(
            "unit",
            Kind::Text,
            "unit of the value, if the value has none",
        ),
        optional("source", Kind::Text, "where the value comes from"),
    ],
};

/// The long form of a parameter.
pub static PARAMETER: Section = Section {
    noun: "a parameter",
    keys: &[
        required("value", Kind::Quantity, "nominal value"),
        optional(
            "unit",
            Kind::Text,
            "unit of the value, if the value has none",
        ),
        optional(
            "dispersion",
            Kind::Section(&DISPERSION),
            "how the plant's value is drawn in each run",
        ),
        optional("source", Kind::Text, "where the value comes from"),
    ],
};

/// A function of the specification.
pub static FUNCTION: Section = Section {
    noun: "a function",
    keys: &[
        required(
            "arguments",
            Kind::List(&Kind::Text),
            "names of the arguments, in order; a call gives each its value, of any shape and unit that the expression allows",
        ),
        required(
            "value",
            Kind::Expression,
            "what a call stands for: an expression of the arguments and of whatever else has a name",
        ),
        optional("source", Kind::Text, "where the function comes from"),
    ],
};

/// Short or long form.
const AXIS_KIND: Kind = Kind::Either(&[Kind::Grid, Kind::Text, Kind::Section(&AXIS)]);

/// A lookup table.
pub static TABLE: Section = Section {
    noun: "a table",
    keys: &[
        required(
            "axes",
            Kind::Named(&AXIS_KIND),
            "one to three arguments in order: their values where the table is given, or their unit if the file has the values",
        ),
        optional(
            "values",
            Kind::Grid,
            "value at every combination of the axes' values, in lists within lists, the first axis outermost",
        ),
        optional(
            "file",
            Kind::Text,
            "CSV file with a column for each axis and one of values, a row for each combination, the last axis changing fastest; relative to this file and below the specification's directory",
        ),
        optional(
            "column",
            Kind::Text,
            "header of the file's column of values; default: the table's name",
        ),
        optional(
            "unit",
            Kind::Text,
            "unit of the values; default: pure numbers",
        ),
        required(
            "interpolation",
            Kind::Choice(&["linear", "cubic"]),
            "between the points: straight lines, or cubic splines with two continuous derivatives (not-a-knot)",
        ),
        required(
            "extrapolation",
            Kind::Choice(&["clamp", "error"]),
            "outside the axes: the value at the nearer end, or no number, so that the controller refuses the sample and a simulated run ends",
        ),
        optional("source", Kind::Text, "where the data come from"),
    ],
};

/// The long form of an axis.
pub static AXIS: Section = Section {
    noun: "an axis",
    keys: &[
        optional(
            "values",
            Kind::Grid,
            "where the table is given, increasing; without it they are those of the file",
        ),
        optional(
            "unit",
            Kind::Text,
            "unit of the values; default: pure numbers",
        ),
    ],
};

/// A group of polynomial data.
pub static POLYNOMIAL: Section = Section {
    noun: "a polynomial group",
    keys: &[
        required(
            "arguments",
            Kind::List(&Kind::Text),
            "names of the dimensionless arguments, in order",
        ),
        optional("source", Kind::Text, "where the data come from"),
        required(
            "parts",
            Kind::Named(&Kind::List(&Kind::List(&Kind::Quantity))),
            "polynomials of the group, each a list of terms: coefficient, then the exponent of each argument",
        ),
    ],
};
