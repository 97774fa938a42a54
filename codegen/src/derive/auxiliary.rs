//! Auxiliary anti-windup system (13), with the sign of its input corrected (E1).

use nsv_spec::model::Block;

use super::law::Law;
use super::symbol::{Symbol, name, zeros};
use crate::ir::Shape;

impl Law<'_> {
    /// zeta_i of every block.
    pub(super) fn declare_auxiliary(&mut self) {
        for i in 1..=self.order() {
            let doc = format!("auxiliary anti-windup state of block {i} (13)");
            let shape = Shape::Vector(self.width());
            self.state(format!("zeta{i}"), shape, doc, zeros(shape));
        }
    }

    /// zeta_i' = -C_i zeta_i + G_i zeta_{i+1}, and G_n (sat(u) - u) for the last.
    pub(super) fn define_auxiliary_rate(&mut self, i: usize, block: &Block) {
        self.group(format!("auxiliary system of block {i} (13), erratum 1"));
        let leak = self.leak(i, block);
        let (input, text) = if i == self.order() {
            (name("u_sat") - name("u"), "(sat(u) - u)".to_string())
        } else {
            (name(format!("zeta{}", i + 1)), format!("zeta_{}", i + 1))
        };
        let rate = name(format!("G{i}")).times(input) - leak;
        self.define(
            format!("zeta{i}_dot"),
            format!("zeta_{i}' = -C_{i} zeta_{i} + G_{i} {text}"),
            rate,
        );
    }

    /// C_i zeta_i.
    pub(super) fn leak(&mut self, i: usize, block: &Block) -> Symbol {
        self.gain(
            format!("C{i}"),
            &format!("C_{i}"),
            &block.c,
            name(format!("zeta{i}")),
        )
    }
}
