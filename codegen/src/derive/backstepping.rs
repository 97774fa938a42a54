//! Error variables (14), virtual controls (31) and control (64): one formula for every block.

use nsv_spec::model::{Block, Disturbance, NoiseBound, VirtualDerivative};

use super::law::Law;
use super::observer::assemble;
use super::symbol::{Symbol, name, number, reciprocal, vector};
use crate::ir::{Function, Shape};

impl Law<'_> {
    /// h_{i-1}, the command that block i follows; h_0 = y_r.
    fn command(&self, i: usize) -> Symbol {
        if i == 1 {
            name("y_r")
        } else {
            name(format!("h{}", i - 1))
        }
    }

    /// Derivative of [`Law::command`].
    pub(super) fn reference_rate(&self, i: usize) -> Symbol {
        if i == 1 {
            name("y_r_dot")
        } else {
            name(format!("h{}_dot", i - 1))
        }
    }

    /// e_i = x_i - h_{i-1} - zeta_i, with zeta_i the state of the auxiliary system.
    pub(super) fn define_error(&mut self, i: usize) {
        self.group(format!("error variable of block {i} (14)"));
        let command = if i == 1 {
            "y_r".to_string()
        } else {
            format!("h_{}", i - 1)
        };
        let e = name(format!("x{i}")) - self.command(i) - name(format!("zeta{i}"));
        self.define(
            format!("e{i}"),
            format!("e_{i} = x_{i} - {command} - zeta_{i}"),
            e,
        );
    }

    /// Norms ||G_i||^2, ||H_i||^2 and Psi_i (62) as far as the block uses them.
    pub(super) fn define_norms(&mut self, i: usize, block: &Block) {
        if i < self.order() {
            self.group(format!("norms of block {i}"));
            self.define_norm_squared(
                format!("G_norm2_{i}"),
                format!("||G_{i}||^2"),
                name(format!("G{i}")),
            );
        }
        let (Some(_), Some(bound)) = (&block.noise, &block.noise_bound) else {
            return;
        };
        self.group(format!("noise terms of block {i} (58) (62)"));
        let h = name(format!("H{i}"));
        let h2 =
            self.define_norm_squared(format!("H_norm2_{i}"), format!("||H_{i}||^2"), h.clone());
        self.define_hessian_norm(i);
        let mut psi =
            (h2 * number(bound.varsigma)).pow(2) * name(format!("Ybar_square{i}")) / number(2.0);
        if let Disturbance::Exosystem(channels) = &block.disturbance {
            let n = assemble(channels).n;
            if n.cols > 0 {
                let n2 =
                    self.constant_norm_squared(format!("N_norm2_{i}"), format!("||N_{i}||^2"), &n);
                psi = psi + number(2.0) * n2;
            }
        }
        if let Some(s) = &block.observer {
            let observer = self.constant(format!("S{i}"), &format!("S_{i}"), s);
            let image = self.define(format!("SH{i}"), format!("S_{i} H_{i}"), observer.times(h));
            let norm = self.define_norm_squared(
                format!("SH_norm2_{i}"),
                format!("||S_{i} H_{i}||^2"),
                image,
            );
            psi = psi + number(block.eta_noise) * norm.pow(2);
        }
        let text = format!(
            "Psi_{i} = ||H_{i}||^4 ||Ybar_{i}||^2 varsigma_{i}^2/2 + 2 ||N_{i}||^2 + eta_noise ||S_{i} H_{i}||^4  (62)"
        );
        self.define(format!("Psi{i}"), text, psi);
    }

    /// Lam_i: barrier feedback and one damping term for each thing to dominate, (31) (63) (64).
    pub(super) fn define_damping(&mut self, i: usize, block: &Block) {
        let equation = if i < self.order() { "(31)" } else { "(63)" };
        self.group(format!("robust feedback of block {i} {equation}"));
        let quantity = |base: &str| name(format!("{base}{i}"));
        let (e, s, c) = (quantity("e"), quantity("s"), quantity("c"));
        let feedback = self.barrier_feedback(i);
        let mut text =
            "(4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before the clamp of E  (31)"
                .to_string();
        let mut sum = self.define(format!("Lam0_{i}"), format!("Lam0 = {text}"), feedback);
        let mut add = |law: &mut Self, part: &str, equation: &str, term: Symbol| {
            let part = law.define(format!("Lam{i}_{part}"), equation, term);
            text = format!("{text} + {equation}");
            sum = sum.clone() + part;
        };
        match &block.disturbance {
            Disturbance::None => {}
            Disturbance::Bounded(_) => add(
                self,
                "disturbance",
                "eta_1/2 c^T  (36)",
                number(block.eta_1) / number(2.0) * c.clone(),
            ),
            Disturbance::Exosystem(channels) => {
                let l = assemble(channels).l;
                let l2 =
                    self.constant_norm_squared(format!("L_norm2_{i}"), format!("||L_{i}||^2"), &l);
                let term = l2 / (number(2.0) * number(block.eta_1)) * c.clone();
                add(self, "disturbance", "||L||^2/(2 eta_1) c^T  (63)", term);
            }
        }
        if i < self.order() {
            let term = number(block.eta_2) / number(2.0) * quantity("G_norm2_") * c;
            add(self, "filter", "eta_2/2 ||G||^2 c^T  (37)", term);
        }
        if let Some(bound) = &block.error_bound {
            let half = self.over_cos2(i, number(0.5)) * e.clone();
            add(self, "network", "e / (2 cos^2 E)  (63)", half);
            let shape = (reciprocal(&bound.b) * e.clone()).apply(Function::Tanh);
            add(
                self,
                "error_bound",
                "eps_hat Tanh(e / b)  (64)",
                quantity("eps") * shape,
            );
        }
        if i > 1 {
            let outer = i - 1;
            let coupling = name(format!("G_norm2_{outer}")) * name(format!("s_c{outer}"));
            let eta = self.model.blocks[outer - 1].eta_3;
            let term = self.times_cos2(
                i,
                coupling.pow(2) * e.clone() / (number(4.0) * number(eta).pow(4)),
            );
            add(
                self,
                "coupling",
                "||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c, eta_3 of the outer block  (38)",
                term,
            );
        }
        if let (Some(_), Some(bound)) = (&block.noise, &block.noise_bound) {
            let gain = quantity("H_norm2_") * quantity("Ybar_norm") * quantity("sigma");
            let sigma = gain * self.define_error_scale(i, bound) * e.clone();
            add(
                self,
                "noise",
                "||H||^2 ||Ybar|| sigma_hat e / sqrt(s^2 + varsigma^2)  (64), errata 4 and 7",
                sigma,
            );
            let ratio = quantity("Psi") / (quantity("phi").pow(2) + s.pow(2));
            let term = self.times_cos2(i, ratio * e);
            add(
                self,
                "diffusion",
                "e Psi cos^2 E / (phi^2 + s^2)  (64)",
                term,
            );
        }
        self.define(format!("Lam{i}"), format!("Lam_{i} = {text}"), sum);
        if i < self.order() {
            self.define(
                format!("s_c{i}"),
                format!("||c_{i}||^2"),
                name(format!("c{i}")).dot(name(format!("c{i}"))),
            );
        }
    }

    /// 1 / sqrt(s_i^2 + varsigma_i^2).
    fn define_error_scale(&mut self, i: usize, bound: &NoiseBound) -> Symbol {
        let s2 = name(format!("s{i}")).pow(2) + number(bound.varsigma).pow(2);
        self.define(
            format!("s_scale{i}"),
            format!("1 / sqrt(s_{i}^2 + varsigma_{i}^2)"),
            number(1.0) / s2.apply(Function::Sqrt),
        )
    }

    /// alpha_i (31), or u (64) in the last block, by solving with G_i.
    pub(super) fn define_control(&mut self, i: usize, block: &Block) {
        let last = i == self.order();
        let (quantity, title) = if last {
            ("u".to_string(), "control (64)")
        } else {
            (format!("alpha{i}"), "virtual control (31)")
        };
        self.group(format!("{title} of block {i}"));
        let mut bracket = name(format!("F{i}"));
        if block.network.is_some() {
            bracket = bracket + name(format!("A_hat{i}"));
        }
        bracket = bracket - self.reference_rate(i) + self.leak(i, block);
        if block.observer.is_some() {
            bracket = bracket + name(format!("D_hat{i}"));
        }
        bracket = bracket + name(format!("Lam{i}"));
        let command = if i == 1 {
            "y_r".to_string()
        } else {
            format!("h_{}", i - 1)
        };
        let text = format!("F_{i} + A_hat_{i} - {command}' + C_{i} zeta_{i} + D_hat_{i} + Lam_{i}");
        let bracket = self.define(format!("bracket{i}"), text.clone(), bracket);
        let symbol = if last {
            "u".to_string()
        } else {
            format!("alpha_{i}")
        };
        let value = -name(format!("G{i}")).solve(bracket);
        let value = self.define(quantity, format!("{symbol} = -G_{i}^-1 [ {text} ]"), value);
        if last {
            let limit: Vec<f64> = self.model.inputs.iter().map(|input| input.limit).collect();
            let limit = vector(&limit);
            let saturated = value.max(-limit.clone()).min(limit);
            self.define(
                "u_sat",
                "sat(u), each component limited to +-u_max  (8)",
                saturated,
            );
        }
    }

    /// h_i and h_i': the dynamic surface filter (33); the exact derivative (34) comes from the rates.
    pub(super) fn define_filter(&mut self, i: usize, block: &Block) {
        if self.model.controller.virtual_derivative != VirtualDerivative::Filter {
            return;
        }
        let constants = block
            .filter
            .as_ref()
            .expect("invariant: a filtered block has filter constants");
        self.group(format!("dynamic surface filter of block {i} (33)"));
        let h = name(format!("h{i}"));
        let rate = reciprocal(constants) * (name(format!("alpha{i}")) - h);
        self.define(
            format!("h{i}_dot"),
            format!("h_{i}' = (alpha_{i} - h_{i}) / Fl_{i}"),
            rate,
        );
    }

    /// Filter state, declared before the inner block refers to it.
    pub(super) fn declare_filter(&mut self, i: usize) {
        if self.model.controller.virtual_derivative == VirtualDerivative::Filter {
            let doc = format!("filtered virtual control of block {i} (33)");
            self.state(
                format!("h{i}"),
                Shape::Vector(self.width()),
                doc,
                name(format!("alpha{i}")),
            );
        }
    }
}
