//! Lookup tables of a program, and derivatives of them that are evaluated together.

use std::collections::BTreeSet;

use nsv_spec::interpolation::{Degree, Interpolant};

use super::TableId;

/// A lookup table.
#[derive(Clone, Debug, PartialEq)]
pub struct TableData {
    /// Name, a Rust identifier.
    pub name: String,
    /// Argument names.
    pub arguments: Vec<String>,
    /// The function.
    pub interpolant: Interpolant,
}

/// Derivatives of tables with the same axes, which are evaluated together at the same arguments.
#[derive(Clone, Debug, PartialEq)]
pub struct TableFamily {
    /// Name, such as `at_alpha_mach`.
    pub name: String,
    /// Argument names.
    pub arguments: Vec<String>,
    /// The derivatives, each once.
    pub members: Vec<TableMember>,
}

/// A derivative of a table.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct TableMember {
    /// The table.
    pub table: TableId,
    /// So many times by each argument.
    pub orders: Vec<u32>,
}

impl TableData {
    /// What two tables have in common if the same arguments lie at the same places of both, under the same splines: the degree and the breaks,
    /// to the sign of a zero. What a table is outside its axes does not matter for that.
    pub(crate) fn axes(&self) -> (Degree, Vec<Vec<u64>>) {
        let bits = |breaks: &Vec<f64>| breaks.iter().map(|at| at.to_bits()).collect();
        let axes = self.interpolant.breaks.iter().map(bits);
        (self.interpolant.degree, axes.collect())
    }

    /// Whether there is such a derivative.
    pub(crate) fn is_differentiable(&self, orders: &[u32]) -> bool {
        let degree = self.interpolant.degree.number();
        orders.len() == self.arguments.len() && orders.iter().all(|&order| order as usize <= degree)
    }

    /// Whether breaks and coefficients fit the arguments.
    pub(crate) fn is_sound(&self) -> bool {
        let interpolant = &self.interpolant;
        let breaks = &interpolant.breaks;
        let increasing = |breaks: &Vec<f64>| {
            breaks.len() >= 2
                && breaks.windows(2).all(|pair| pair[0] < pair[1])
                && breaks.iter().all(|at| at.is_finite())
        };
        let counts = breaks
            .iter()
            .map(|breaks| breaks.len().saturating_sub(1) + interpolant.degree.number());
        (1..=3).contains(&breaks.len())
            && breaks.len() == self.arguments.len()
            && breaks.iter().all(increasing)
            && counts.product::<usize>() == interpolant.coefficients.len()
            && interpolant.coefficients.iter().all(|c| c.is_finite())
    }
}

impl TableFamily {
    /// Whether its members are different derivatives of tables with the same axes.
    pub(crate) fn is_sound(&self, tables: &[TableData]) -> bool {
        let of = |member: &TableMember| tables.get(member.table.0 as usize);
        let Some(first) = self.members.first().and_then(of) else {
            return false;
        };
        let axes = first.axes();
        let fits = |member: &TableMember| {
            of(member).is_some_and(|table| {
                table.axes() == axes && table.is_differentiable(&member.orders)
            })
        };
        let distinct: BTreeSet<&TableMember> = self.members.iter().collect();
        self.arguments.len() == first.arguments.len()
            && distinct.len() == self.members.len()
            && self.members.iter().all(fits)
    }
}
