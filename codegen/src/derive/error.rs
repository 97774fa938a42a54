//! Why a law cannot be derived although its specification is sound.

use std::fmt;

/// A failed derivation.
#[derive(Debug)]
pub enum DeriveError {
    /// CasADi could not supply partials.
    Partials(crate::casadi::Error),
    /// A rate of an MTPN of higher than second order is needed.
    NetworkOrder,
}

impl fmt::Display for DeriveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Partials(error) => error.fmt(f),
            Self::NetworkOrder => f.write_str(
                "the exact virtual derivative of this law needs a third rate of an mtpn; use `virtual_derivative: filter`, or give the network to an inner block",
            ),
        }
    }
}

impl std::error::Error for DeriveError {}

impl From<crate::casadi::Error> for DeriveError {
    fn from(error: crate::casadi::Error) -> Self {
        Self::Partials(error)
    }
}
