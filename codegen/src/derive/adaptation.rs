//! Adaptive bounds: eps_hat (66) for the network error, sigma_hat (67) and phi (68) for the noise.

use nsv_spec::model::Block;

use super::law::Law;
use super::symbol::{Symbol, name, number, reciprocal};
use crate::ir::{Function, Shape};

impl Law<'_> {
    /// eps_i, sigma_i, phi_i as far as the block has them.
    pub(super) fn declare_adaptation(&mut self, i: usize, block: &Block) {
        if block.error_bound.is_some() {
            self.state(
                format!("eps{i}"),
                Shape::Scalar,
                format!("estimate of the MTPN error bound of block {i} (66)"),
                number(0.0),
            );
        }
        if let Some(bound) = &block.noise_bound {
            self.state(
                format!("sigma{i}"),
                Shape::Scalar,
                format!("estimate of the noise intensity bound of block {i} (67)"),
                number(0.0),
            );
            self.state(
                format!("phi{i}"),
                Shape::Scalar,
                format!("compensation state of block {i} (68)"),
                number(bound.phi_initial),
            );
        }
    }

    /// eps_i', sigma_i', phi_i'.
    pub(super) fn define_adaptation_rates(&mut self, i: usize, block: &Block) {
        let quantity = |base: &str| name(format!("{base}{i}"));
        let (e, s) = (quantity("e"), quantity("s"));
        if let Some(bound) = &block.error_bound {
            self.group(format!("network error bound of block {i} (66)"));
            let shape = (reciprocal(&bound.b) * e.clone()).apply(Function::Tanh);
            let drive = self.over_cos2(i, s.clone()) * e.dot(shape);
            let rate = number(bound.rate) * (drive - quantity("eps"));
            let text = format!(
                "eps_hat_{i}' = iota_{i}0 (s_{i}/cos^2 E_{i} sum_j e_{i}j tanh(e_{i}j/b_{i}j) - eps_hat_{i})"
            );
            self.define(format!("eps{i}_dot"), text, rate);
        }
        let Some(bound) = &block.noise_bound else {
            return;
        };
        self.group(format!("noise bound of block {i} (67)"));
        let drive = self.over_cos2(
            i,
            quantity("H_norm2_") * quantity("Ybar_norm") * s.clone().pow(2),
        ) * quantity("s_scale");
        let rate = number(bound.tau) * (drive - number(bound.lambda) * quantity("sigma"));
        let text = format!(
            "sigma_hat_{i}' = taubar_{i} (||H_{i}||^2 ||Ybar_{i}|| s_{i}^2 / (cos^2 E_{i} sqrt(s_{i}^2 + varsigma_{i}^2)) - lambda_sigma sigma_hat_{i})"
        );
        self.define(format!("sigma{i}_dot"), text, rate);
        self.group(format!("compensation of block {i} (68)"));
        let decay = quantity("Psi") / (quantity("phi").pow(2) + s.pow(2)) + number(bound.phi_kappa);
        let decay = self.define(
            format!("phi{i}_decay"),
            format!("Psi_{i}/(phi_{i}^2 + s_{i}^2) + kappa_phi"),
            decay,
        );
        let rate = self
            .phi_active(i, bound.phi_threshold)
            .select(-quantity("phi") * decay, number(0.0));
        let text = format!(
            "phi_{i}' = -phi_{i} Psi_{i}/(phi_{i}^2 + s_{i}^2) - kappa_phi phi_{i} if ||e_{i}|| >= iota_phi, else 0"
        );
        self.define(format!("phi{i}_dot"), text, rate);
    }

    /// ||e_i|| >= iota_phi.
    pub(super) fn phi_active(&self, i: usize, threshold: f64) -> Symbol {
        let active = name(format!("s{i}")).apply(Function::Sqrt);
        active.at_least(number(threshold))
    }
}
