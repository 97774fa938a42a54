//! The checked model of a control problem: all numbers in SI, all names resolved, all shapes and dimensions agreed.
//!
//! A `Model` is made by [`crate::load`] alone, so whoever holds one need not check again. Indices of blocks and channels are
//! 0-based here and 1-based wherever people read them.

mod dispersion;
mod hardware;

use std::collections::BTreeMap;

use crate::diagnostic::{SourceMap, Span, rounded};
use crate::expr::arena::{Arena, ExprId};
use crate::interpolation::Interpolant;
use crate::unit::Dimension;

pub use dispersion::{Dispersion, Truncated};
pub use hardware::{Actuator, Effect, Fault, Sensor};

/// A dense matrix of compile-time numbers, row-major.
#[derive(Clone, Debug, PartialEq)]
pub struct Matrix {
    /// Number of rows.
    pub rows: usize,
    /// Number of columns.
    pub cols: usize,
    /// Entries, row by row.
    pub data: Vec<f64>,
}

/// A control problem, checked.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Model {
    /// Module name, a Rust identifier in snake case.
    pub name: String,
    /// One line for people.
    pub title: String,
    /// Files read, the specification first.
    pub sources: SourceMap,
    /// SHA-256 over the names and texts of all sources, lower-case hex.
    pub hash: String,
    /// All expressions.
    pub exprs: Arena,
    /// Compile-time constants, in order of declaration.
    pub constants: Vec<Constant>,
    /// Run-time parameters, in order of declaration.
    pub parameters: Vec<Parameter>,
    /// Polynomial data blocks, in order of declaration.
    pub polynomials: Vec<Polynomial>,
    /// Lookup tables, in order of declaration.
    pub tables: Vec<Table>,
    /// Named definitions in an order in which each uses only earlier ones.
    pub definitions: Vec<Definition>,
    /// Blocks of the strict-feedback chain, outermost (the output) first; at least one.
    pub blocks: Vec<Block>,
    /// Control inputs; as many as each block has channels.
    pub inputs: Vec<Input>,
    /// What is flown where it is more than the blocks.
    pub truth: Option<Truth>,
    /// Reference signal y_r(t), a vector of the block width that depends on time, constants and parameters only.
    pub reference: ExprId,
    /// Where the reference is given.
    pub reference_span: Span,
    /// Choices for the controller as a whole.
    pub controller: Controller,
    /// How the closed loop is simulated.
    pub scenario: Scenario,
    /// Every default that was filled in, as `path = value` with the reason, for `nsv check -v`.
    pub defaults: Vec<String>,
}

/// A compile-time constant.
#[derive(Clone, Debug)]
pub struct Constant {
    /// Name in the specification, an identifier.
    pub name: String,
    /// SI value: a scalar (1 x 1) or an array.
    pub value: Matrix,
    /// Whether `value` is a scalar (a 1 x 1 matrix literal is not).
    pub scalar: bool,
    /// Dimension of each entry.
    pub dimension: Dimension,
    /// Source or description, for comments.
    pub doc: String,
    /// Where it was declared.
    pub span: Span,
}

/// A run-time parameter: a scalar field of the emitted `Params`.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Name, an identifier.
    pub name: String,
    /// SI value in the plant.
    pub value: f64,
    /// SI value that the controller is designed with.
    pub design_value: f64,
    /// Dimension.
    pub dimension: Dimension,
    /// How the plant's value is drawn in each run.
    pub dispersion: Option<Dispersion>,
    /// Source or description, for comments.
    pub doc: String,
    /// Where it was declared.
    pub span: Span,
}

/// Polynomial data: sum of c * z_1^a_1 * ... * z_v^a_v.
#[derive(Clone, Debug, PartialEq)]
pub struct Polynomial {
    /// Name, dotted as in the data (`CL.alpha`).
    pub name: String,
    /// Names of the arguments, in order.
    pub arguments: Vec<String>,
    /// Coefficient and exponents of each term, in the order of the data.
    pub terms: Vec<(f64, Vec<u32>)>,
    /// Source, for comments.
    pub doc: String,
    /// Where it was declared.
    pub span: Span,
}

/// A lookup table.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Name, an identifier.
    pub name: String,
    /// Names and dimensions of the arguments, in order.
    pub arguments: Vec<(String, Dimension)>,
    /// Dimension of the value.
    pub dimension: Dimension,
    /// The function, in SI.
    pub interpolant: Interpolant,
    /// Source, for comments.
    pub doc: String,
    /// Where it was declared.
    pub span: Span,
}

/// A named intermediate quantity of the plant model.
#[derive(Clone, Debug)]
pub struct Definition {
    /// Name, an identifier.
    pub name: String,
    /// Its expression.
    pub expr: ExprId,
    /// Where it was declared.
    pub span: Span,
}

/// One block of the chain: dx_i = (F_i + G_i x_{i+1} + dF_i + d_i) dt + H_i Sigma_i dw_i, with its part of the controller.
#[derive(Clone, Debug)]
pub struct Block {
    /// Name, an identifier.
    pub name: String,
    /// State channels; every block has the same number.
    pub states: Vec<State>,
    /// F_i, a vector.
    pub drift: ExprId,
    /// G_i, a square matrix.
    pub gain: ExprId,
    /// d_i.
    pub disturbance: Disturbance,
    /// H_i Sigma_i dw_i.
    pub noise: Option<Noise>,
    /// K_i, the diagonal.
    pub k: Vec<f64>,
    /// kbar_i (`auto` already computed).
    pub kbar: f64,
    /// C_i of the auxiliary system (13).
    pub c: Matrix,
    /// Fl_i of the filter (33), the diagonal, s; `None` in the last block and with `virtual_derivative: exact`.
    pub filter: Option<Vec<f64>>,
    /// eta_i1, used when the block has a disturbance.
    pub eta_1: f64,
    /// eta_i2, used when i < n.
    pub eta_2: f64,
    /// eta_i3, used by block i + 1.
    pub eta_3: f64,
    /// eta_noise_i, used when the block has noise and an observer.
    pub eta_noise: f64,
    /// S_i: m x m for a `bounded` disturbance, (exosystem states) x m for `exosystem`.
    pub observer: Option<Matrix>,
    /// k_i(t), a scalar expression of time, in SI.
    pub constraint: Option<ExprId>,
    /// MTPN of the block.
    pub network: Option<Network>,
    /// eps_hat law (66): for a network without a compound observer.
    pub error_bound: Option<ErrorBound>,
    /// sigma_hat and phi laws (67) (68): for a block with noise.
    pub noise_bound: Option<NoiseBound>,
    /// Where the block was declared.
    pub span: Span,
    /// Where each of its keys is given, those of the plant and those of the controller.
    pub keys: BTreeMap<&'static str, Span>,
}

/// One state channel.
#[derive(Clone, Debug)]
pub struct State {
    /// Name, an identifier.
    pub name: String,
    /// Initial value, SI.
    pub initial: f64,
    /// Dimension.
    pub dimension: Dimension,
    /// Unit to show it in, as written (`deg`), and the factor from that unit to SI.
    pub display: (String, f64),
    /// How the initial value is drawn in each run.
    pub dispersion: Option<Dispersion>,
    /// How the controller measures it; `None` exactly.
    pub sensor: Option<Sensor>,
}

impl State {
    /// A value of it, SI, in the unit to show it in.
    pub(crate) fn shown(&self, value: f64) -> String {
        let (unit, factor) = &self.display;
        let number = rounded(value / factor);
        match unit.as_str() {
            "1" => number,
            unit => format!("{number} {unit}"),
        }
    }
}

/// The flown plant where it is more than the blocks that the controller is designed on. A block state without a rate of its own here
/// moves as the block says, with the plant's parameters; disturbances and noise of the blocks act in either case.
#[derive(Clone, Debug)]
pub struct Truth {
    /// Further states.
    pub states: Vec<State>,
    /// Rate of each further state, a scalar expression of all states, inputs and time.
    pub rates: Vec<ExprId>,
    /// By block and channel, the rate that replaces F_i + G_i x_{i+1}.
    pub replaced: Vec<Vec<Option<ExprId>>>,
    /// Where it is given.
    pub span: Span,
}

/// Disturbance d_i of a block.
#[derive(Clone, Debug)]
pub enum Disturbance {
    /// None.
    None,
    /// A known function of time in the simulation, unknown to the controller.
    Bounded(ExprId),
    /// One linear exosystem per channel (10) (12).
    Exosystem(Vec<Exosystem>),
}

/// dw = M w dt + N dwbar, d = L w.
#[derive(Clone, Debug, PartialEq)]
pub struct Exosystem {
    /// M, square.
    pub m: Matrix,
    /// N; zero columns mean no excitation.
    pub n: Matrix,
    /// L, one row.
    pub l: Matrix,
    /// w(0).
    pub initial: Vec<f64>,
}

/// Diffusion H Sigma dw of a block.
#[derive(Clone, Debug)]
pub struct Noise {
    /// H, width x channels.
    pub effectiveness: ExprId,
    /// Diagonal of Sigma, one per noise channel.
    pub intensity: Vec<f64>,
}

/// Basis of an MTPN.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Basis {
    /// Products of at most two inputs (the paper's).
    Pairwise,
    /// All monomials up to the order.
    Complete,
}

/// Multi-dimensional Taylor polynomial network of a block.
#[derive(Clone, Debug)]
pub struct Network {
    /// Largest total degree.
    pub order: u32,
    /// Which monomials.
    pub basis: Basis,
    /// Inputs z, scalar expressions of the states of this and outer blocks.
    pub inputs: Vec<ExprId>,
    /// Names of the inputs, for weights and comments.
    pub input_names: Vec<String>,
    /// Divisor of each input, SI.
    pub scale: Vec<f64>,
    /// iota, one per channel.
    pub iota: Vec<f64>,
    /// Gamma, the scalar learning rate.
    pub gamma: f64,
    /// lambda, the leak.
    pub lambda: f64,
}

/// eps_hat law (66).
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorBound {
    /// iota_i0.
    pub rate: f64,
    /// b_i, one per channel.
    pub b: Vec<f64>,
}

/// sigma_hat law (67) and phi law (68).
#[derive(Clone, Debug, PartialEq)]
pub struct NoiseBound {
    /// taubar_i.
    pub tau: f64,
    /// lambda_sigma.
    pub lambda: f64,
    /// varsigma_i (the paper's second zeta, E6).
    pub varsigma: f64,
    /// phi_i(0).
    pub phi_initial: f64,
    /// kappa_phi.
    pub phi_kappa: f64,
    /// iota_phi, the threshold of (68).
    pub phi_threshold: f64,
    /// Floor of phi (E11).
    pub phi_min: PhiFloor,
}

/// Floor of phi.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PhiFloor {
    /// sqrt(Psi dt / 0.1).
    Auto,
    /// A declared value.
    Value(f64),
}

/// One control input.
#[derive(Clone, Debug)]
pub struct Input {
    /// Name, an identifier.
    pub name: String,
    /// u_max > 0, SI.
    pub limit: f64,
    /// Output for non-finite input, SI.
    pub safe: f64,
    /// How the command reaches the plant; `None` at once and exactly.
    pub actuator: Option<Actuator>,
    /// Dimension.
    pub dimension: Dimension,
    /// Unit to show it in, and the factor from that unit to SI.
    pub display: (String, f64),
}

/// Norm used for matrices in the law.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Norm {
    /// Root of the sum of squares.
    Frobenius,
    /// Largest singular value.
    Spectral,
}

/// Where h_i' comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VirtualDerivative {
    /// Dynamic surface filter (33).
    Filter,
    /// Exact total derivative along the known dynamics (34).
    Exact,
}

/// Integration of the controller's own states over one sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Integration {
    /// Linear parts by their exponential, the rest held over the sample: stable for every step size.
    Exponential,
    /// Explicit Euler.
    Euler,
}

/// Choices for the controller as a whole.
#[derive(Clone, Debug)]
pub struct Controller {
    /// Sample time, s.
    pub sample_time: f64,
    /// Matrix norm.
    pub norm: Norm,
    /// Filter or exact.
    pub virtual_derivative: VirtualDerivative,
    /// Discretisation of the controller's states.
    pub integration: Integration,
    /// delta: E is clamped at pi/2 - delta.
    pub barrier_margin: f64,
}

/// How noise enters the simulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoiseModel {
    /// Increments of a Wiener process.
    Wiener,
    /// One N(0,1) draw held over each sample (E8).
    Sampled,
}

/// Integration scheme of the plant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scheme {
    /// Euler-Maruyama, strong order 0.5 (1.0 for additive noise).
    EulerMaruyama,
    /// Derivative-free scheme of strong order 1.0 for diagonal or additive noise.
    Platen,
    /// Classical Runge-Kutta for runs without Wiener noise.
    RungeKutta4,
}

/// Most runs of a campaign.
pub const MAX_RUNS: u64 = 1_000_000_000;

/// Most plant steps of one run.
pub const MAX_STEPS: f64 = 1e9;

/// How the closed loop is simulated.
#[derive(Clone, Debug)]
pub struct Scenario {
    /// Length of a run, s.
    pub horizon: f64,
    /// Plant steps per controller sample.
    pub substeps: u32,
    /// Plant scheme.
    pub scheme: Scheme,
    /// Noise model.
    pub noise: NoiseModel,
    /// Campaign seed.
    pub seed: u64,
    /// Runs unless the command line says otherwise.
    pub runs: u64,
    /// Start of the rms window, s.
    pub settle: f64,
}
