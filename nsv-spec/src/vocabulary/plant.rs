//! Keys of the plant.

use super::dispersion::DISPERSION;
use super::hardware::{ACTUATOR, SENSOR};
use super::{Kind, Section, optional, required};

/// The plant.
pub static PLANT: Section = Section {
    noun: "a plant",
    keys: &[
        required(
            "blocks",
            Kind::Named(&Kind::Section(&PLANT_BLOCK)),
            "blocks of the strict-feedback chain, the output block first",
        ),
        required(
            "inputs",
            Kind::Named(&INPUT_KIND),
            "control inputs with their limits, as many as each block has states",
        ),
        optional(
            "truth",
            Kind::Section(&TRUTH),
            "what is flown, where it is more than the blocks that the controller is designed on",
        ),
    ],
};

/// What is flown beyond the design.
pub static TRUTH: Section = Section {
    noun: "a truth",
    keys: &[
        optional(
            "states",
            Kind::Named(&STATE_KIND),
            "further states of the flown plant, unknown to the controller",
        ),
        required(
            "rates",
            Kind::ByName(&Kind::Formula),
            "rate of change of each further state, and of those states of the blocks that move otherwise than by F + G x; functions of all states, the inputs and time",
        ),
    ],
};

const STATE_KIND: Kind = Kind::Either(&[Kind::Quantity, Kind::Section(&STATE)]);
const INPUT_KIND: Kind = Kind::Either(&[Kind::Quantity, Kind::Section(&INPUT)]);

/// A block of the plant.
pub static PLANT_BLOCK: Section = Section {
    noun: "a plant block",
    keys: &[
        required(
            "states",
            Kind::Named(&STATE_KIND),
            "state channels with their initial values; the unit is also the display unit",
        ),
        required(
            "drift",
            Kind::Formula,
            "F: known dynamics, a vector of the states of this and outer blocks",
        ),
        required(
            "gain",
            Kind::Formula,
            "G: square matrix, how the next block's state or the input acts",
        ),
        optional(
            "disturbance",
            Kind::Section(&DISTURBANCE),
            "d: what acts on the block unknown to the controller",
        ),
        optional("noise", Kind::Section(&NOISE), "diffusion H Sigma dw"),
    ],
};

/// The long form of a state.
pub static STATE: Section = Section {
    noun: "a state",
    keys: &[
        required("initial", Kind::Quantity, "initial value"),
        optional(
            "unit",
            Kind::Text,
            "display unit, and unit of the initial value if that has none",
        ),
        optional(
            "dispersion",
            Kind::Section(&DISPERSION),
            "how the initial value is drawn in each run",
        ),
        optional(
            "sensor",
            Kind::Section(&SENSOR),
            "how the controller measures it; default: exactly",
        ),
    ],
};

/// A disturbance.
pub static DISTURBANCE: Section = Section {
    noun: "a disturbance",
    keys: &[
        optional(
            "bounded",
            Kind::Formula,
            "vector function of time, bounded with bounded rate",
        ),
        optional(
            "exosystem",
            Kind::List(&Kind::Section(&EXOSYSTEM)),
            "one linear system for each channel: dw = M w dt + N dwbar, d = L w",
        ),
    ],
};

/// The exosystem of one channel.
pub static EXOSYSTEM: Section = Section {
    noun: "an exosystem",
    keys: &[
        required("M", Kind::Formula, "square system matrix"),
        optional(
            "N",
            Kind::Formula,
            "noise input matrix; default: no excitation",
        ),
        required("L", Kind::Formula, "output row"),
        optional("initial", Kind::Formula, "initial state; default: zero"),
    ],
};

/// Diffusion of a block.
pub static NOISE: Section = Section {
    noun: "a noise",
    keys: &[
        required(
            "effectiveness",
            Kind::Formula,
            "H: matrix, states by noise channels",
        ),
        required(
            "intensity",
            Kind::Formula,
            "diagonal of Sigma, one entry for each noise channel",
        ),
    ],
};

/// The long form of an input.
pub static INPUT: Section = Section {
    noun: "an input",
    keys: &[
        required("limit", Kind::Quantity, "saturation limit, positive"),
        optional(
            "safe",
            Kind::Quantity,
            "output when a measurement is not finite; default: 0",
        ),
        optional(
            "actuator",
            Kind::Section(&ACTUATOR),
            "how the command reaches the plant; default: at once and exactly",
        ),
    ],
};
