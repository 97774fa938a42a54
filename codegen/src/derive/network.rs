//! MTPN approximation (4) of a block's uncertainty and its weight law (32) (65).

use nsv_spec::model::Network;

use super::law::Law;
use super::symbol::{Side, Symbol, Term, diagonal, name, number, vector, zeros};
use crate::ir::{MonomialBasis, Shape};

impl Law<'_> {
    /// z_i, P_i, A_hat_i.
    pub(super) fn define_network(&mut self, i: usize, network: &Network) {
        self.group(format!("MTPN of block {i} (4) (16)"));
        let basis = MonomialBasis::new(
            &format!("basis{i}"),
            network.order,
            network.basis,
            &network.input_names,
        );
        let nodes = basis.exponents.len();
        self.bases.insert(i, basis);
        let inputs = network.inputs.iter().zip(&network.scale);
        let scaled = |(&input, &scale): (_, &f64)| {
            let input = Symbol::from(Term::Model(input, Side::Design));
            if scale == 1.0 {
                input
            } else {
                input / number(scale)
            }
        };
        let z = Symbol::from(Term::Stack(inputs.map(scaled).collect()));
        let z = self.define(format!("z{i}"), format!("z_{i}, network inputs"), z);
        let p = self.define(
            format!("P{i}"),
            format!("P_{i} = P_m(z_{i}), {nodes} nodes"),
            Term::Basis(i, z).into(),
        );
        let shape = Shape::Matrix(nodes, self.width());
        let w = self.state(
            format!("W{i}"),
            shape,
            format!("MTPN weights of block {i}, nodes by channels (32) (65)"),
            zeros(shape),
        );
        let output = diagonal(&network.iota) * w.transpose().times(p);
        self.define(
            format!("A_hat{i}"),
            format!("A_hat_{i} = iota_{i} W_{i}^T P_{i}"),
            output,
        );
    }

    /// W_i' = Gamma_i (P_i c_i I_i - lambda_i W_i).
    pub(super) fn define_weight_rate(&mut self, i: usize, network: &Network) {
        self.group(format!("weight law of block {i} (32) (65)"));
        let (p, c, w) = (
            name(format!("P{i}")),
            name(format!("c{i}")),
            name(format!("W{i}")),
        );
        let regressor = p.outer(vector(&network.iota) * c);
        let rate = number(network.gamma) * (regressor - number(network.lambda) * w);
        self.define(
            format!("W{i}_dot"),
            format!("W_{i}' = Gamma_{i} (P_{i} c_{i} I_{i} - lambda_{i} W_{i})"),
            rate,
        );
    }
}
