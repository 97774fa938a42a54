//! Every key of the language with its kind and meaning: the one table that both the parser and the JSON Schema are made from.

/// A map with known keys.
#[derive(Debug)]
pub struct Section {
    /// What it is, with article, for messages: `a network`.
    pub noun: &'static str,
    /// Its keys, in the order in which they are best written.
    pub keys: &'static [Key],
}

/// One key of a section.
#[derive(Debug)]
pub struct Key {
    /// The key.
    pub name: &'static str,
    /// What stands behind it.
    pub kind: Kind,
    /// Whether it must be there. Keys whose need depends on other choices are not required here but checked later.
    pub required: bool,
    /// Its meaning.
    pub doc: &'static str,
}

/// What may stand behind a key.
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    /// Text for people.
    Text,
    /// A whole number from 0.
    Count,
    /// One of these words.
    Choice(&'static [&'static str]),
    /// A number with its unit, or an expression of constants.
    Quantity,
    /// An expression: text, a number, or a nested list of these.
    Formula,
    /// A list.
    List(&'static Kind),
    /// A map with known keys.
    Section(&'static Section),
    /// A map from names that the user chooses.
    Named(&'static Kind),
    /// Any of these.
    Either(&'static [Kind]),
}

const fn required(name: &'static str, kind: Kind, doc: &'static str) -> Key {
    Key {
        name,
        kind,
        required: true,
        doc,
    }
}

const fn optional(name: &'static str, kind: Kind, doc: &'static str) -> Key {
    Key {
        name,
        kind,
        required: false,
        doc,
    }
}

/// A quantity or the word `auto`.
const QUANTITY_OR_AUTO: Kind = Kind::Either(&[Kind::Choice(&["auto"]), Kind::Quantity]);
const FORMULAS: Kind = Kind::Named(&Kind::Formula);
const POLYNOMIAL_TERM: Kind = Kind::List(&Kind::Quantity);

/// The whole specification.
pub static SPECIFICATION: Section = Section {
    noun: "a specification",
    keys: &[
        required(
            "nsv",
            Kind::Count,
            "version of the specification language: 1",
        ),
        required(
            "name",
            Kind::Text,
            "name of the generated module: a Rust identifier in snake case",
        ),
        optional(
            "title",
            Kind::Text,
            "one line for people; default: the name",
        ),
        optional(
            "include",
            Kind::List(&Kind::Text),
            "files with further sections, relative to this file and below its directory",
        ),
        optional(
            "constants",
            Kind::Named(&CONSTANT_KIND),
            "compile-time constants",
        ),
        optional(
            "parameters",
            Kind::Named(&PARAMETER_KIND),
            "run-time parameters, fields of the emitted `Params`",
        ),
        optional(
            "polynomials",
            Kind::Named(&Kind::Section(&POLYNOMIAL)),
            "groups of polynomial data, such as aerodynamic coefficients",
        ),
        optional(
            "definitions",
            FORMULAS,
            "named intermediate quantities, in any order, without cycles",
        ),
        required(
            "plant",
            Kind::Section(&PLANT),
            "the system to be controlled",
        ),
        required(
            "reference",
            FORMULAS,
            "reference of every output channel: a function of time",
        ),
        required(
            "controller",
            Kind::Section(&CONTROLLER),
            "the design choices of the control law",
        ),
        required(
            "scenario",
            Kind::Section(&SCENARIO),
            "how the closed loop is simulated",
        ),
    ],
};

const CONSTANT_KIND: Kind = Kind::Either(&[Kind::Formula, Kind::Section(&CONSTANT)]);
const PARAMETER_KIND: Kind = Kind::Either(&[Kind::Quantity, Kind::Section(&PARAMETER)]);

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

/// Distribution of a dispersed parameter.
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
            Kind::Named(&Kind::List(&POLYNOMIAL_TERM)),
            "polynomials of the group, each a list of terms: coefficient, then the exponent of each argument",
        ),
    ],
};

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
    ],
};

/// The controller.
pub static CONTROLLER: Section = Section {
    noun: "a controller",
    keys: &[
        required("sample_time", Kind::Quantity, "sample time"),
        optional(
            "virtual_derivative",
            Kind::Choice(&["filter", "exact"]),
            "source of the virtual control's derivative; default: filter",
        ),
        optional(
            "norm",
            Kind::Choice(&["frobenius", "spectral"]),
            "matrix norm of the law; default: frobenius",
        ),
        optional(
            "integration",
            Kind::Choice(&["exponential", "euler"]),
            "discretisation of the controller's states; default: exponential",
        ),
        optional(
            "barrier_margin",
            Kind::Quantity,
            "delta: E is clamped at pi/2 - delta; default: 1e-3",
        ),
        optional(
            "parameters",
            Kind::Named(&Kind::Quantity),
            "parameter values the controller is designed with, where they differ from the plant's",
        ),
        required(
            "blocks",
            Kind::Named(&Kind::Section(&CONTROLLER_BLOCK)),
            "gains of each plant block, under the same names",
        ),
    ],
};

/// The gains of a block.
pub static CONTROLLER_BLOCK: Section = Section {
    noun: "a controller block",
    keys: &[
        required(
            "K",
            Kind::Formula,
            "error gain, scalar or one for each channel, positive",
        ),
        required(
            "kbar",
            QUANTITY_OR_AUTO,
            "barrier gain, at least sup sqrt((k'/k)^2 + 1e-6), which `auto` computes",
        ),
        required(
            "C",
            Kind::Formula,
            "gain of the anti-windup system: scalar, diagonal or matrix, positive definite",
        ),
        optional(
            "filter",
            Kind::Formula,
            "time constant of the command filter, scalar or one for each channel; inner blocks have none",
        ),
        optional(
            "eta_1",
            Kind::Quantity,
            "weight of the disturbance estimate's error",
        ),
        optional("eta_2", Kind::Quantity, "weight of the filter's error"),
        optional(
            "eta_3",
            Kind::Quantity,
            "weight of the coupling to the next block",
        ),
        optional(
            "eta_noise",
            Kind::Quantity,
            "weight of the noise in the observer",
        ),
        optional(
            "observer",
            Kind::Formula,
            "observer gain S: scalar, diagonal or matrix",
        ),
        optional(
            "constraint",
            Kind::Formula,
            "bound k(t) > 0 of the error's norm: a function of time",
        ),
        optional(
            "network",
            Kind::Section(&NETWORK),
            "polynomial network that learns what the model lacks",
        ),
        optional(
            "error_bound",
            Kind::Section(&ERROR_BOUND),
            "adaptive bound of the network's error",
        ),
        optional(
            "noise_bound",
            Kind::Section(&NOISE_BOUND),
            "adaptive bounds of the noise",
        ),
    ],
};

/// A polynomial network.
pub static NETWORK: Section = Section {
    noun: "a network",
    keys: &[
        required("order", Kind::Count, "largest total degree, at least 1"),
        optional(
            "basis",
            Kind::Choice(&["pairwise", "complete"]),
            "products of at most two inputs, or all; default: pairwise",
        ),
        required(
            "inputs",
            Kind::List(&Kind::Formula),
            "expressions of the states of this and outer blocks",
        ),
        optional(
            "scale",
            Kind::Formula,
            "divisor of each input; default: 1 in SI",
        ),
        required(
            "iota",
            Kind::Formula,
            "output scale, scalar or one for each channel, positive",
        ),
        required("Gamma", Kind::Quantity, "learning rate, positive"),
        required("lambda", Kind::Quantity, "leak, positive"),
    ],
};

/// The law of eps_hat.
pub static ERROR_BOUND: Section = Section {
    noun: "an error bound",
    keys: &[
        required("iota", Kind::Quantity, "adaptation rate, positive"),
        required(
            "b",
            Kind::Formula,
            "width of the tanh, scalar or one for each channel, positive",
        ),
    ],
};

/// The laws of sigma_hat and phi.
pub static NOISE_BOUND: Section = Section {
    noun: "a noise bound",
    keys: &[
        required(
            "tau",
            Kind::Quantity,
            "adaptation rate of sigma_hat, positive",
        ),
        required("lambda", Kind::Quantity, "leak of sigma_hat, positive"),
        required("varsigma", Kind::Quantity, "smoothing constant, positive"),
        required("phi", Kind::Section(&PHI), "the auxiliary state phi"),
    ],
};

/// The state phi.
pub static PHI: Section = Section {
    noun: "a phi",
    keys: &[
        required("initial", Kind::Quantity, "initial value, positive"),
        required("kappa", Kind::Quantity, "decay rate, positive"),
        required(
            "threshold",
            Kind::Quantity,
            "error norm below which phi is held, positive",
        ),
        optional(
            "min",
            QUANTITY_OR_AUTO,
            "floor of phi; default: auto, sqrt(Psi dt / 0.1)",
        ),
    ],
};

/// The scenario.
pub static SCENARIO: Section = Section {
    noun: "a scenario",
    keys: &[
        required("horizon", Kind::Quantity, "length of a run"),
        optional(
            "substeps",
            Kind::Count,
            "plant steps for each controller sample; default: 4",
        ),
        optional(
            "scheme",
            Kind::Choice(&["euler_maruyama", "platen", "rk4"]),
            "integration of the plant; default: rk4, with wiener noise euler_maruyama",
        ),
        optional(
            "noise",
            Kind::Choice(&["sampled", "wiener"]),
            "draws held over a sample, or Wiener increments; default: sampled",
        ),
        optional("seed", Kind::Count, "campaign seed; default: 1"),
        optional("runs", Kind::Count, "number of runs; default: 1"),
        optional(
            "settle",
            Kind::Quantity,
            "start of the window for rms values; default: 0 s",
        ),
    ],
};
