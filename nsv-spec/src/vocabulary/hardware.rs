//! Keys of actuators and sensors: what lies between the controller and the plant.

use super::dispersion::DISPERSION;
use super::{Kind, Section, optional, required};

/// What happens to a command on its way to the plant, in this order.
pub static ACTUATOR: Section = Section {
    noun: "an actuator",
    keys: &[
        optional(
            "delay",
            Kind::Quantity,
            "dead time, a whole number of plant steps",
        ),
        optional(
            "quantum",
            Kind::Quantity,
            "commands are rounded to multiples of it",
        ),
        optional("lag", Kind::Quantity, "time constant of a first-order lag"),
        optional("rate_limit", Kind::Quantity, "fastest change"),
        optional(
            "faults",
            Kind::List(&Kind::Section(&FAULT)),
            "what fails, in order of time",
        ),
    ],
};

/// A fault of an actuator: exactly one of `effectiveness` and `stuck`.
pub static FAULT: Section = Section {
    noun: "a fault",
    keys: &[
        required("at", Kind::Quantity, "when it happens"),
        optional(
            "effectiveness",
            Kind::Quantity,
            "share of the effect that is left, 0 to 1",
        ),
        optional(
            "stuck",
            Kind::Either(&[Kind::Choice(&["here"]), Kind::Quantity]),
            "where it stands from then on: a value, or `here`",
        ),
    ],
};

/// What happens to a state on its way to the controller, in this order.
pub static SENSOR: Section = Section {
    noun: "a sensor",
    keys: &[
        optional(
            "bias",
            Kind::Either(&[Kind::Quantity, Kind::Section(&DISPERSION)]),
            "constant error: a value, or drawn in each run",
        ),
        optional(
            "noise",
            Kind::Quantity,
            "standard deviation of a normal error, drawn at each sample",
        ),
        optional(
            "quantum",
            Kind::Quantity,
            "measurements are rounded to multiples of it",
        ),
        optional(
            "dropout",
            Kind::Quantity,
            "probability that a sample is lost and the last one is given again",
        ),
    ],
};
