//! Quantities of the tan-type barrier Lyapunov function (23) (28) (58), total: no 0/0 at e = 0 and no pole at the bound.
//!
//! With s = e^T e and E = pi s^2 / (2 k^4) the factor k^4/(2 pi) sin(E) cos(E)/s^2 of Lam0 equals sin(E) cos(E)/(4 E), and
//! 4 pi s^2/k^4 of Ybar equals 8 E: neither k^4 nor s^2 is left to overflow or to divide by. E is clamped at pi/2 - delta.

use std::f64::consts::PI;

use super::law::Law;
use super::symbol::{Symbol, diagonal, name, number};
use crate::derive::symbol::Term;
use crate::ir::{Function, Kernel};

impl Law<'_> {
    /// s_i, E_i, cos E_i, 1/cos^2 E_i, c_i of a block with its error e_i defined.
    pub(super) fn define_barrier(&mut self, i: usize) {
        self.group(format!("barrier of block {i} (23) (26)"));
        let e = name(format!("e{i}"));
        let s = self.define(
            format!("s{i}"),
            format!("s_{i} = e_{i}^T e_{i}"),
            e.clone().dot(e.clone()),
        );
        if self.model.blocks[i - 1].constraint.is_some() {
            let k = name(format!("k{i}"));
            let limit = self.barrier_limit();
            let raw = number(PI / 2.0) * (s.clone() / (k.clone() * k)).pow(2);
            let raw = self.define(
                format!("E{i}_free"),
                format!("pi s_{i}^2 / (2 k_{i}^4), before the clamp"),
                raw,
            );
            self.define(
                format!("violated{i}"),
                format!("E_{i} >= pi/2 - delta"),
                raw.clone().at_least(limit.clone()),
            );
            let clamped = raw.min(limit);
            let clamped = self.define(
                format!("E{i}"),
                format!("E_{i} = pi s_{i}^2 / (2 k_{i}^4), at most pi/2 - delta"),
                clamped,
            );
            let cos = self.define(
                format!("cosE{i}"),
                format!("cos E_{i}"),
                clamped.apply(Function::Cos),
            );
            self.define(
                format!("sec2E{i}"),
                format!("1 / cos^2 E_{i}"),
                number(1.0) / cos.pow(2),
            );
        } else {
            self.define(
                format!("E{i}"),
                format!("E_{i} = 0: no constraint"),
                number(0.0),
            );
        }
        let c = self.over_cos2(i, s) * e;
        self.define(
            format!("c{i}"),
            format!("c_{i} = s_{i} e_{i}^T / cos^2 E_{i}"),
            c,
        );
    }

    /// pi/2 - delta, where E is clamped.
    fn barrier_limit(&self) -> Symbol {
        number(PI / 2.0 - self.model.controller.barrier_margin)
    }

    /// Lam0_i = ((4 kbar + K)/4 sin(E) cos(E)/E + kbar) e, (31) (Remark 4).
    pub(super) fn barrier_feedback(&self, i: usize) -> Symbol {
        let block = &self.model.blocks[i - 1];
        let quarter: Vec<f64> = block
            .k
            .iter()
            .map(|k| (4.0 * block.kbar + k) / 4.0)
            .collect();
        let e = name(format!("e{i}"));
        let shaped = diagonal(&quarter) * e.clone();
        let shaped = match block.constraint {
            Some(_) => {
                let kernel = Symbol::from(Term::Kernel(Kernel::SinCosOver, name(format!("E{i}"))));
                // sin(E) cos(E)/s^2 with E clamped and s as it is: 1 inside the constraint.
                let clamp = number(1.0).min(self.barrier_limit() / name(format!("E{i}_free")));
                kernel * clamp * shaped
            }
            None => shaped,
        };
        shaped + number(block.kbar) * e
    }

    /// ||Ybar_i|| of (58), corrected (E3): Ybar = a e e^T + b I with a s = 8 E sin E / cos^3 E and b = 3 / cos^2 E
    /// (the factor 8 E = 4 pi s^2 / k^4 is not clamped).
    pub(super) fn define_hessian_norm(&mut self, i: usize) {
        let quantity = |base: &str| name(format!("{base}{i}"));
        let constraint = self.model.blocks[i - 1].constraint;
        let rank_one = constraint.map(|_| {
            let sine = quantity("E").apply(Function::Sin);
            let over_cos3 = quantity("cosE") * quantity("sec2E").pow(2);
            number(8.0) * name(format!("E{i}_free")) * sine * over_cos3
        });
        let identity = self.over_cos2(i, number(3.0));
        let largest = match rank_one {
            Some(rank_one) => rank_one + identity.clone(),
            None => identity.clone(),
        };
        let others = (self.width() - 1) as f64;
        let (square, norm) = match self.model.controller.norm {
            nsv_spec::model::Norm::Frobenius if others > 0.0 => {
                let square = largest.pow(2) + number(others) * identity.pow(2);
                (square, quantity("Ybar_square").apply(Function::Sqrt))
            }
            _ => (largest.clone().pow(2), largest),
        };
        self.define(format!("Ybar_square{i}"), format!("||Ybar_{i}||^2"), square);
        let text = format!(
            "||Ybar_{i}||, Ybar_{i} = (4 pi/k_{i}^4) (sin E_{i}/cos^3 E_{i}) s_{i} e_{i} e_{i}^T + (3/cos^2 E_{i}) I  (58)"
        );
        self.define(format!("Ybar_norm{i}"), text, norm);
    }

    /// A quantity divided by cos^2 E_i; unchanged without a constraint, where E_i = 0.
    pub(super) fn over_cos2(&self, i: usize, value: Symbol) -> Symbol {
        match self.model.blocks[i - 1].constraint {
            Some(_) => value * name(format!("sec2E{i}")),
            None => value,
        }
    }

    /// A quantity times cos^2 E_i.
    pub(super) fn times_cos2(&self, i: usize, value: Symbol) -> Symbol {
        match self.model.blocks[i - 1].constraint {
            Some(_) => name(format!("cosE{i}")).pow(2) * value,
            None => value,
        }
    }
}
