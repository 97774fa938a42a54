//! Guarantees that parameters drawn together have a covariance matrix: symmetric, positive semidefinite, in their units.

use super::Context;
use super::numbers::{Numbers, written_in};
use crate::diagnostic::{Diagnostic, Rule};
use crate::expr::arena::Shape;
use crate::model::Dispersion;
use crate::spec::{Correlation, Word};
use crate::suggest::nearest;
use crate::unit::Dimension;

/// Asymmetry and negative pivots that roundings may leave, relative to the diagonal.
const ROUNDING: f64 = 1e-12;

impl Context<'_> {
    /// Gives each parameter of a group its row of the Cholesky factor.
    pub(super) fn check_correlations(&mut self) {
        let spec = self.spec;
        for correlation in &spec.correlations {
            let Some(members) = self.members(correlation) else {
                continue;
            };
            let numbers = self.numbers(&correlation.covariance);
            let Some(factor) = numbers.and_then(|numbers| self.factor(&members, &numbers)) else {
                continue;
            };
            for (row, &member) in members.iter().enumerate() {
                let Some(parameter) = &mut self.parameters[member] else {
                    continue;
                };
                let factors = (0..=row).map(|col| (members[col], factor[row][col]));
                parameter.dispersion = Some(Dispersion::Correlated {
                    mean: parameter.value,
                    factors: factors.filter(|(_, factor)| *factor != 0.0).collect(),
                });
            }
        }
    }

    /// Indices of the parameters; each is known, listed once and has no dispersion yet.
    fn members(&mut self, correlation: &Correlation) -> Option<Vec<usize>> {
        let mut members = Vec::new();
        for name in &correlation.parameters {
            let at = self.member(name)?;
            let taken = (self.parameters[at].as_ref()).is_some_and(|one| one.dispersion.is_some());
            if taken || members.contains(&at) {
                let message = format!("parameter `{}` is dispersed twice", name.value);
                let first = self.spec.parameters[at].name.span;
                let fault = Diagnostic::error(Rule::E0611, name.span, message)
                    .with_related(first, "the parameter is declared here")
                    .with_help("give it a dispersion of its own, or list it in one correlation");
                self.faults.push(fault);
                return None;
            }
            members.push(at);
        }
        Some(members)
    }

    fn member(&mut self, name: &Word) -> Option<usize> {
        let known = || self.spec.parameters.iter().map(|one| &one.name.value);
        let found = known().position(|known| *known == name.value);
        if found.is_none() {
            let message = format!("unknown parameter `{}`", name.value);
            let fault = Diagnostic::error(Rule::E0116, name.span, message);
            let meant = nearest(&name.value, known());
            let otherwise = || "declare it under `parameters`".into();
            self.faults
                .push(fault.did_you_mean(name.span, &name.value, meant, otherwise));
        }
        found
    }

    /// The Cholesky factor, by rows.
    fn factor(&mut self, members: &[usize], covariance: &Numbers) -> Option<Vec<Vec<f64>>> {
        let (n, span) = (members.len(), covariance.span);
        if covariance.shape != Shape::Matrix(n, n) {
            let message = format!(
                "covariance is {}, expected {} as there are {n} parameters",
                covariance.shape,
                Shape::Matrix(n, n)
            );
            self.fault(Rule::E0605, span, message, "write `[[a, b], [b, c]]`");
            return None;
        }
        let dimensions: Option<Vec<Dimension>> = members
            .iter()
            .map(|&member| Some(self.parameters[member].as_ref()?.dimension))
            .collect();
        let dimensions = dimensions?;
        for (at, &found) in covariance.dimensions.iter().enumerate() {
            let expected = dimensions[at / n].checked_mul(dimensions[at % n])?;
            if found != expected && covariance.values[at] != 0.0 {
                let what = format!("entry ({}, {}) of the covariance", at / n + 1, at % n + 1);
                let help = written_in(expected);
                self.unit_mismatch(span, &what, found, expected, help);
                return None;
            }
        }
        let entry = |row: usize, col: usize| covariance.values[row * n + col];
        let even = (0..n * n).all(|at| {
            let (row, col) = (at / n, at % n);
            let scale = libm::sqrt(entry(row, row) * entry(col, col));
            (entry(row, col) - entry(col, row)).abs() <= ROUNDING * scale
        });
        let factor = if even { cholesky(n, entry) } else { None };
        if factor.is_none() {
            let message = "covariance is not symmetric and positive semidefinite";
            let help = "variances stand on the diagonal, and no covariance exceeds the product of two standard deviations";
            self.fault(Rule::E0612, span, message, help);
        }
        factor
    }
}

/// Lower triangular L with L L^T = A, for A positive semidefinite: a column without variance left is 0.
fn cholesky(n: usize, a: impl Fn(usize, usize) -> f64) -> Option<Vec<Vec<f64>>> {
    let mut l = vec![vec![0.0; n]; n];
    for col in 0..n {
        for row in col..n {
            let known: f64 = (0..col).map(|k| l[row][k] * l[col][k]).sum();
            let rest = a(row, col) - known;
            let negligible = ROUNDING * libm::sqrt(a(row, row) * a(col, col));
            l[row][col] = if row == col {
                match rest {
                    _ if rest < -negligible || rest.is_nan() => return None,
                    _ if rest <= negligible => 0.0,
                    _ => libm::sqrt(rest),
                }
            } else if l[col][col] > 0.0 {
                rest / l[col][col]
            } else if rest.abs() <= negligible {
                0.0
            } else {
                return None;
            };
        }
    }
    Some(l)
}

#[cfg(test)]
mod tests {
    use super::cholesky;

    #[test]
    fn the_factor_times_its_transpose_is_the_matrix() {
        let a = [[4.0, 2.0, -2.0], [2.0, 5.0, 1.0], [-2.0, 1.0, 6.0]];
        let l = cholesky(3, |row, col| a[row][col]).unwrap();
        for row in 0..3 {
            for col in 0..3 {
                let entry: f64 = (0..3).map(|k| l[row][k] * l[col][k]).sum();
                assert!((entry - a[row][col]).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn a_singular_covariance_has_a_factor_and_an_impossible_one_none() {
        let l = cholesky(2, |_, _| 1.0).unwrap();
        assert_eq!(l, [[1.0, 0.0], [1.0, 0.0]]);
        let strange = [[1.0, 2.0], [2.0, 1.0]];
        assert_eq!(cholesky(2, |row, col| strange[row][col]), None);
        let impossible = [[0.0, 1.0], [1.0, 1.0]];
        assert_eq!(cholesky(2, |row, col| impossible[row][col]), None);
    }
}
