//! Keys of what differs from run to run.

use super::{Kind, Section, optional, required};

/// Distribution of a dispersed quantity: exactly one of these.
pub static DISPERSION: Section = Section {
    noun: "a dispersion",
    keys: &[
        optional(
            "uniform",
            Kind::List(&Kind::Quantity),
            "least and largest value",
        ),
        optional(
            "normal",
            Kind::List(&Kind::Quantity),
            "mean and standard deviation",
        ),
        optional(
            "truncated_normal",
            Kind::List(&Kind::Quantity),
            "mean and standard deviation before truncation, least and largest value",
        ),
        optional(
            "lognormal",
            Kind::List(&Kind::Quantity),
            "median, and standard deviation of the logarithm",
        ),
        optional(
            "discrete",
            Kind::List(&Kind::List(&Kind::Quantity)),
            "values, each with its probability: [[value, probability], ..]",
        ),
    ],
};

/// Parameters that are drawn together.
pub static CORRELATION: Section = Section {
    noun: "a correlation",
    keys: &[
        required(
            "parameters",
            Kind::List(&Kind::Text),
            "names of at least two parameters without dispersion of their own; each is normal about its value",
        ),
        required(
            "covariance",
            Kind::Formula,
            "symmetric, positive semidefinite matrix",
        ),
    ],
};
