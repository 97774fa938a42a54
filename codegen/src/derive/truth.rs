//! The true plant of the simulation: drift, disturbances and diffusion with the plant's own parameters (11) (12).

use nsv_spec::model::Disturbance;

use super::law::Law;
use super::observer::assemble;
use super::symbol::{Side, Symbol, Term, matrix, name};
use crate::ir::Shape;

/// The further states of the flown plant, a leaf.
pub(crate) const TRUTH: &str = "truth";

impl Law<'_> {
    /// `x<i>_flow`, `w<i>_flow`, `d<i>`, `HSigma<i>` of every block, and their packed forms `drift` and `diffusion`.
    pub(super) fn define_truth(&mut self) {
        for i in 1..=self.order() {
            self.define_true_block(i);
        }
        let further = self.define_flown();
        let blocks = || 1..=self.order();
        let exosystems = || blocks().filter(|i| self.leaves.contains_key(&format!("w{i}")));
        let flown = |i| match &self.model.truth {
            Some(_) => name(format!("x{i}_flown")),
            None => name(format!("x{i}_flow")),
        };
        let flows = blocks()
            .map(flown)
            .chain(further.clone())
            .chain(exosystems().map(|i| name(format!("w{i}_flow"))));
        let flows = flows.collect();
        let diffusion = |quantity: String| self.contains(&quantity).then(|| name(quantity));
        let own = blocks().map(|i| (self.width(), diffusion(format!("HSigma{i}"))));
        let own = own.chain(further.map(|_| (self.truth_states(), None)));
        let excited = exosystems().map(|i| (self.exosystem_states(i), diffusion(format!("N{i}"))));
        let diffusion: Vec<_> = own.chain(excited).collect();
        self.group(match self.truth_states() {
            0 => "packed plant state: x_1 .. x_n, then the exosystems",
            _ => "packed plant state: x_1 .. x_n, further states, then the exosystems",
        });
        self.define("drift", "dx/dt without noise", Term::Stack(flows).into());
        if diffusion.iter().any(|(_, block)| block.is_some()) {
            self.define(
                "diffusion",
                "columns: one per Wiener process",
                Term::BlockDiagonal(diffusion).into(),
            );
        }
    }

    /// `x<i>_flown`: x_i' with the rates that replace the block's own; and `truth_flow`, if there are further states.
    fn define_flown(&mut self) -> Option<Symbol> {
        let truth = self.model.truth.as_ref()?;
        self.group("flown plant, beyond the blocks");
        let rate = |expr| Symbol::from(Term::Model(expr, Side::Plant));
        for (i, replaced) in (1..).zip(&truth.replaced) {
            let disturbed = self.contains(&format!("d{i}"));
            let flown = replaced.iter().enumerate().map(|(at, replaced)| {
                let Some(own) = replaced else {
                    return Term::Slice(name(format!("x{i}_flow")), at, 1).into();
                };
                let own = Symbol::from(Term::Stack(vec![rate(*own)]));
                if disturbed {
                    own + Term::Slice(name(format!("d{i}")), at, 1).into()
                } else {
                    own
                }
            });
            let flown = Term::Stack(flown.collect()).into();
            self.define(
                format!("x{i}_flown"),
                format!("x_{i}' of the flown plant: its own rates + d_{i}"),
                flown,
            );
        }
        if truth.states.is_empty() {
            return None;
        }
        let rates = truth.rates.iter().map(|&expr| rate(expr)).collect();
        let text = "rates of the further states";
        Some(self.define("truth_flow", text, Term::Stack(rates).into()))
    }

    /// Number of further states of the flown plant.
    pub(crate) fn truth_states(&self) -> usize {
        (self.model.truth.as_ref()).map_or(0, |truth| truth.states.len())
    }

    fn define_true_block(&mut self, i: usize) {
        let block = &self.model.blocks[i - 1];
        self.group(format!("true dynamics of block {i} ({}) (11)", block.name));
        let model = |expr| Symbol::from(Term::Model(expr, Side::Plant));
        let next = if i == self.order() {
            name("u_sat")
        } else {
            name(format!("x{}", i + 1))
        };
        let drift = self.define(
            format!("F{i}_plant"),
            format!("F_{i} with the plant's parameters"),
            model(block.drift),
        );
        let gain = self.define(
            format!("G{i}_plant"),
            format!("G_{i} with the plant's parameters"),
            model(block.gain),
        );
        let mut flow = drift + gain.times(next);
        match &block.disturbance {
            Disturbance::None => {}
            Disturbance::Bounded(value) => {
                flow = flow + self.define(format!("d{i}"), format!("d_{i}(t)"), model(*value));
            }
            Disturbance::Exosystem(channels) => {
                let parts = assemble(channels);
                let l = self.constant(format!("L{i}"), &format!("L_{i}"), &parts.l);
                let w = name(format!("w{i}"));
                let d = self.define(
                    format!("d{i}"),
                    format!("d_{i} = L_{i} w_{i}  (12)"),
                    l.times(w.clone()),
                );
                flow = flow + d;
                self.define(
                    format!("w{i}_flow"),
                    format!("w_{i}' = M_{i} w_{i}  (12)"),
                    matrix(&parts.m).times(w),
                );
                if parts.n.cols > 0 {
                    self.define(
                        format!("N{i}"),
                        format!("N_{i}, excitation of the exosystem (12)"),
                        matrix(&parts.n),
                    );
                }
            }
        }
        self.define(
            format!("x{i}_flow"),
            format!("F_{i} + G_{i} x_{} + d_{i}", i + 1),
            flow,
        );
        if let Some(noise) = &block.noise {
            let rows: Vec<f64> = (0..self.width())
                .flat_map(|_| noise.intensity.iter().copied())
                .collect();
            let shape = Shape::Matrix(self.width(), noise.intensity.len());
            let sigma = Symbol::from(Term::Literal(shape, rows));
            self.define(
                format!("HSigma{i}"),
                format!("H_{i} Sigma_{i}"),
                model(noise.effectiveness) * sigma,
            );
        }
    }

    /// Number of exosystem states of a block.
    pub(crate) fn exosystem_states(&self, i: usize) -> usize {
        match self.leaves.get(&format!("w{i}")) {
            Some(Shape::Vector(states)) => *states,
            _ => 0,
        }
    }
}
