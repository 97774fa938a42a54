//! Keys of the controller.

use super::{Kind, QUANTITY_OR_AUTO, Section, optional, required};

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
            Kind::ByName(&Kind::Quantity),
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
            "bound k(t) > 0 of the norm of the block's error (of the outputs the tracking error): a function of time",
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
