//! The controller.

use std::collections::BTreeMap;

use super::{AutoCode, Choice, Code, Declared, Formula, Located, Read};
use crate::diagnostic::Span;
use crate::model::{Basis, Integration, Norm, VirtualDerivative};

/// The controller.
#[derive(Clone, Debug, PartialEq)]
pub struct Controller {
    /// `sample_time`
    pub sample_time: Code,
    /// `virtual_derivative`
    pub virtual_derivative: Choice<VirtualDerivative>,
    /// `norm`
    pub norm: Choice<Norm>,
    /// `integration`
    pub integration: Choice<Integration>,
    /// `barrier_margin`
    pub barrier_margin: Option<Code>,
    /// `parameters`
    pub parameters: Declared<Code>,
    /// `blocks`
    pub blocks: Declared<ControllerBlock>,
}

/// The gains of a block.
#[derive(Clone, Debug, PartialEq)]
pub struct ControllerBlock {
    /// Places of the keys that are given.
    pub keys: BTreeMap<&'static str, Span>,
    /// Whether there are no others with a map.
    pub complete: bool,
    /// `K`
    pub k: Formula,
    /// `kbar`
    pub kbar: AutoCode,
    /// `C`
    pub c: Formula,
    /// `filter`
    pub filter: Option<Formula>,
    /// `eta_1`
    pub eta_1: Option<Code>,
    /// `eta_2`
    pub eta_2: Option<Code>,
    /// `eta_3`
    pub eta_3: Option<Code>,
    /// `eta_noise`
    pub eta_noise: Option<Code>,
    /// `observer`
    pub observer: Option<Formula>,
    /// `constraint`
    pub constraint: Option<Formula>,
    /// `network`
    pub network: Option<Located<Network>>,
    /// `error_bound`
    pub error_bound: Option<Located<ErrorBound>>,
    /// `noise_bound`
    pub noise_bound: Option<Located<NoiseBound>>,
}

/// A network.
#[derive(Clone, Debug, PartialEq)]
pub struct Network {
    /// `order`
    pub order: Read<Located<u64>>,
    /// `basis`
    pub basis: Choice<Basis>,
    /// `inputs`
    pub inputs: Read<Vec<Formula>>,
    /// `scale`
    pub scale: Option<Formula>,
    /// `iota`
    pub iota: Formula,
    /// `Gamma`
    pub gamma: Code,
    /// `lambda`
    pub lambda: Code,
}

/// The law of eps_hat.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorBound {
    /// `iota`
    pub iota: Code,
    /// `b`
    pub b: Formula,
}

/// The laws of sigma_hat and phi.
#[derive(Clone, Debug, PartialEq)]
pub struct NoiseBound {
    /// `tau`
    pub tau: Code,
    /// `lambda`
    pub lambda: Code,
    /// `varsigma`
    pub varsigma: Code,
    /// `phi.initial`
    pub phi_initial: Code,
    /// `phi.kappa`
    pub phi_kappa: Code,
    /// `phi.threshold`
    pub phi_threshold: Code,
    /// `phi.min`
    pub phi_min: Option<AutoCode>,
}
