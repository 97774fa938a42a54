//! The Lyapunov function (52) and its Ito generator (2) along the true closed loop.
//!
//! LV = V_t + V_x f + 1/2 sum_j g_j^T V_xx g_j: the rate of V along the flow, and half the second rate of V along the straight line
//! through each diffusion column, which contracts gradient and Hessian without forming them.
//! What the proof does not know is taken as the simulation knows it: W* = 0, so the model error belongs to the compound disturbance;
//! the bound of the remaining network error is 0; sigma_bar = ||Sigma||^2.

use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::PI;

use nsv_spec::expr::arena::{ExprId, Node};
use nsv_spec::model::{Block, Disturbance, VirtualDerivative};

use super::error::DeriveError;
use super::law::Law;
use super::rates::{Direction, Rates};
use super::symbol::{Symbol, Term, name, number};
use crate::ir::{Function, Shape};

impl Law<'_> {
    /// V as the sum of named parts; returns their names.
    fn define_lyapunov(&mut self) -> Vec<String> {
        let mut parts = Vec::new();
        for (i, block) in (1..).zip(&self.model.blocks) {
            self.group(format!("Lyapunov function of block {i} (23) (52)"));
            let barrier = self.barrier_part(i, block);
            let mut add = |law: &mut Self, part: &str, text: String, value: Symbol| {
                let part = format!("V_{part}{i}");
                law.define(part.clone(), text, value);
                parts.push(part);
            };
            add(self, "T", format!("k_{i}^4/(2 pi) tan E_{i}"), barrier);
            if let Some(network) = &block.network {
                let w = name(format!("W{i}"));
                let squares = Symbol::from(Term::Trace(w.clone().transpose().times(w)));
                add(
                    self,
                    "W",
                    format!("tr(W_{i}^T W_{i})/(2 Gamma_{i})"),
                    squares / number(2.0 * network.gamma),
                );
            }
            if let Some(error) = self.define_observer_error(i, block) {
                add(
                    self,
                    "D",
                    format!("1/2 ||theta_{i} - th_{i}||^2"),
                    half_square(error),
                );
            }
            add(
                self,
                "zeta",
                format!("1/2 ||zeta_{i}||^2"),
                half_square(name(format!("zeta{i}"))),
            );
            if i < self.order()
                && self.model.controller.virtual_derivative == VirtualDerivative::Filter
            {
                let chi = name(format!("h{i}")) - name(format!("alpha{i}"));
                let chi = self.define(
                    format!("chi{i}"),
                    format!("chi_{i} = h_{i} - alpha_{i}  (34)"),
                    chi,
                );
                add(self, "chi", format!("1/2 ||chi_{i}||^2"), half_square(chi));
            }
            if let Some(bound) = &block.error_bound {
                let eps = name(format!("eps{i}"));
                add(
                    self,
                    "eps",
                    format!("eps_hat_{i}^2/(2 iota_{i}0)"),
                    eps.clone() * eps / number(2.0 * bound.rate),
                );
            }
            if let (Some(bound), Some(noise)) = (&block.noise_bound, &block.noise) {
                let sigma_bar: f64 = noise.intensity.iter().map(|sigma| sigma * sigma).sum();
                let error = number(sigma_bar) - name(format!("sigma{i}"));
                add(
                    self,
                    "sigma",
                    format!("(sigma_bar_{i} - sigma_hat_{i})^2/(2 taubar_{i})"),
                    error.clone() * error / number(2.0 * bound.tau),
                );
                let phi = name(format!("phi{i}"));
                add(
                    self,
                    "phi",
                    format!("phi_{i}^2/2"),
                    phi.clone() * phi / number(2.0),
                );
            }
        }
        parts
    }

    fn barrier_part(&self, i: usize, block: &Block) -> Symbol {
        let s = name(format!("s{i}"));
        match block.constraint {
            Some(_) => {
                let k = name(format!("k{i}"));
                k.pow(4) / number(2.0 * PI) * name(format!("E{i}")).apply(Function::Tan)
            }
            None => s.clone() * s / number(4.0),
        }
    }

    /// Estimation error of the block's observer: D - D_hat, or w - w_hat.
    fn define_observer_error(&mut self, i: usize, block: &Block) -> Option<Symbol> {
        block.observer.as_ref()?;
        match &block.disturbance {
            Disturbance::None => None,
            Disturbance::Bounded(_) => {
                let mut truth = name(format!("d{i}"));
                if self.uses_parameters(block.drift) {
                    truth = truth + (name(format!("F{i}_plant")) - name(format!("F{i}")));
                }
                if self.uses_parameters(block.gain) {
                    let next = if i == self.order() {
                        name("u_sat")
                    } else {
                        name(format!("x{}", i + 1))
                    };
                    truth =
                        truth + (name(format!("G{i}_plant")) - name(format!("G{i}"))).times(next);
                }
                let truth = self.define(
                    format!("D{i}"),
                    format!("D_{i} = d_{i} + model error of block {i}"),
                    truth,
                );
                Some(self.define(
                    format!("D_error{i}"),
                    format!("D_{i} - D_hat_{i}"),
                    truth - name(format!("D_hat{i}")),
                ))
            }
            Disturbance::Exosystem(_) => {
                let error = name(format!("w{i}")) - name(format!("w_hat{i}"));
                Some(self.define(format!("w_error{i}"), format!("w_{i} - w_hat_{i}"), error))
            }
        }
    }

    fn uses_parameters(&self, expr: ExprId) -> bool {
        let (mut seen, mut pending) = (BTreeSet::new(), vec![expr]);
        while let Some(expr) = pending.pop() {
            if !seen.insert(expr) {
                continue;
            }
            match self.model.exprs.node(expr) {
                Node::Parameter(_) => return true,
                Node::Definition(id) => pending.push(self.model.definitions[id.0 as usize].expr),
                node => pending.extend(node.operands()),
            }
        }
        false
    }

    /// Columns of the diffusion: the leaf that each moves, and the quantity that is its rate.
    fn define_noise_columns(&mut self) -> Vec<(String, String)> {
        let mut columns = Vec::new();
        for i in 1..=self.order() {
            for (leaf, source) in [
                (format!("x{i}"), format!("HSigma{i}")),
                (format!("w{i}"), format!("N{i}")),
            ] {
                if !self.contains(&source) {
                    continue;
                }
                let Some(Shape::Matrix(_, cols)) = self.shape(&source) else {
                    unreachable!("invariant: a diffusion is a matrix")
                };
                for col in 0..cols {
                    let column = format!("{source}_{}", col + 1);
                    self.define(
                        column.clone(),
                        format!("column {} of {source}", col + 1),
                        Term::Column(name(source.clone()), col).into(),
                    );
                    columns.push((leaf.clone(), column));
                }
            }
        }
        columns
    }
}

impl Rates<'_, '_> {
    /// V and LV.
    pub(super) fn define_generator(&mut self) -> Result<(), DeriveError> {
        let parts = self.law.define_lyapunov();
        let total = parts
            .iter()
            .map(name)
            .reduce(|a, b| a + b)
            .expect("invariant: every block has a Lyapunov function");
        self.law.group("Lyapunov function (52)");
        self.law.define("V", "V, sum of the parts above", total);
        self.law.group("Ito generator (2)");
        let columns = self.law.define_noise_columns();
        let flow = self.true_flow();
        let mut terms = Vec::new();
        for part in &parts {
            if let Some(rate) = self.rate(part, &flow, 1)? {
                terms.push(name(rate));
            }
        }
        for (at, (leaf, column)) in columns.iter().enumerate() {
            let starts = [(leaf.clone(), Some(column.clone()))].into();
            let line = Direction {
                tag: format!("noise{}_", at + 1),
                starts,
                straight: true,
            };
            for part in &parts {
                if let Some(second) = self.rate(part, &line, 2)? {
                    terms.push(name(second) / number(2.0));
                }
            }
        }
        let total = terms
            .into_iter()
            .reduce(|a, b| a + b)
            .expect("invariant: V moves");
        self.law.group("Ito generator (2)");
        self.law
            .define("LV", "LV = V_t + V_x f + 1/2 sum_j g_j^T V_xx g_j", total);
        Ok(())
    }

    /// Along the true closed loop.
    fn true_flow(&self) -> Direction {
        let mut starts = BTreeMap::from([("t".to_string(), Some("one".to_string()))]);
        for i in 1..=self.law.order() {
            for leaf in [format!("x{i}"), format!("w{i}")] {
                if self.law.leaves.contains_key(&leaf) {
                    starts.insert(leaf.clone(), Some(format!("{leaf}_flow")));
                }
            }
        }
        for state in &self.law.states {
            starts.insert(state.name.clone(), Some(format!("{}_dot", state.name)));
        }
        Direction {
            tag: "flow".into(),
            starts,
            straight: false,
        }
    }
}

fn half_square(value: Symbol) -> Symbol {
    value.clone().dot(value) / number(2.0)
}
