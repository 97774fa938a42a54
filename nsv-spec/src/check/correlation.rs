//! Guarantees that parameters drawn together have a covariance matrix: symmetric, positive semidefinite, in their units.

use super::Context;
use super::numbers::{Numbers, in_unit, written_in};
use crate::diagnostic::{Applicability, Diagnostic, Rule, counted};
use crate::expr::arena::Shape;
use crate::model::Dispersion;
use crate::spec::{Correlation, Word};
use crate::suggest::{beside, nearest};
use crate::unit::Dimension;

/// Asymmetry and negative pivots that roundings may leave, relative to the diagonal.
const ROUNDING: f64 = 1e-12;
/// Most parameters whose covariance is written out in a help.
const SHOWN: usize = 4;

impl Context<'_> {
    /// Gives each parameter of a group its row of the Cholesky factor.
    pub(super) fn check_correlations(&mut self) {
        let spec = self.spec;
        for correlation in &spec.correlations {
            let Some(members) = self.members(correlation) else {
                continue;
            };
            let numbers = self.numbers_for(&correlation.covariance, "covariance");
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
        for name in correlation.parameters.as_ref().ok()? {
            let at = self.member(name, correlation)?;
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

    fn member(&mut self, name: &Word, correlation: &Correlation) -> Option<usize> {
        let known = || self.spec.parameters.iter().map(|one| &one.name.value);
        let found = known().position(|known| *known == name.value);
        if found.is_none() && self.spec.parameters.complete {
            let message = format!("unknown parameter `{}`", name.value);
            let fault = Diagnostic::error(Rule::E0116, name.span, message);
            // One that is listed already cannot have been meant.
            let listed = |known: &&String| {
                let mut listed = correlation.parameters.iter().flatten();
                listed.any(|other| other.value == **known)
            };
            let meant = nearest(&name.value, known().filter(|known| !listed(known)));
            let declare = "declare it under `parameters`";
            let otherwise = || beside(&name.value, known().filter(listed), declare);
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
                "covariance is {}, expected {} as there are {}",
                covariance.shape,
                Shape::Matrix(n, n),
                counted(n, "parameter")
            );
            self.faults.push(as_matrix(
                Diagnostic::error(Rule::E0605, span, message),
                n,
                covariance,
            ));
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
                self.unit_mismatch(covariance.places[at], &what, found, expected, help);
                return None;
            }
        }
        self.check_symmetry(n, covariance)?;
        let entry = |row: usize, col: usize| covariance.values[row * n + col];
        let factor = cholesky(n, entry);
        if factor.is_none() {
            let fault = self.indefinite(members, covariance);
            self.faults.push(fault);
        }
        factor
    }

    /// Reports the first two entries that should be one covariance and are not.
    fn check_symmetry(&mut self, n: usize, covariance: &Numbers) -> Option<()> {
        let entry = |row: usize, col: usize| covariance.values[row * n + col];
        let uneven = |&(row, col): &(usize, usize)| {
            let scale = libm::sqrt((entry(row, row) * entry(col, col)).abs());
            (entry(row, col) - entry(col, row)).abs() > ROUNDING * scale
        };
        let mut pairs = (0..n).flat_map(|row| (row + 1..n).map(move |col| (row, col)));
        let Some((row, col)) = pairs.find(uneven) else {
            return Some(());
        };
        let shown = |row: usize, col: usize| {
            let at = row * n + col;
            let value = in_unit(covariance.values[at], covariance.dimensions[at]);
            format!("entry ({}, {}) is {value}", row + 1, col + 1)
        };
        let (one, other) = (shown(row, col), shown(col, row));
        let message = format!("covariance is not symmetric: {one}, {other}");
        let fault = Diagnostic::error(Rule::E0612, covariance.places[row * n + col], message);
        let fault = match covariance.places[col * n + row] {
            place if Some(place) == fault.span => fault,
            place => fault.with_label(one).with_related(place, other),
        };
        let help = "both are the covariance of the same two parameters: write it in both places";
        self.faults.push(fault.with_help(help));
        None
    }

    /// What is wrong with a symmetric matrix that has no Cholesky factor.
    fn indefinite(&self, members: &[usize], covariance: &Numbers) -> Diagnostic {
        let n = members.len();
        let shown = |at: usize| in_unit(covariance.values[at], covariance.dimensions[at]);
        let value = |row: usize, col: usize| covariance.values[row * n + col];
        let name = |member: usize| &self.spec.parameters[members[member]].name.value;
        if let Some(at) = (0..n).find(|&at| value(at, at) < 0.0) {
            let place = at * n + at;
            let message = format!(
                "variance of `{}` is {}, expected at least 0",
                name(at),
                shown(place)
            );
            return Diagnostic::error(Rule::E0612, covariance.places[place], message)
                .with_help("the variance, a standard deviation squared, stands on the diagonal");
        }
        let largest = |row: usize, col: usize| libm::sqrt(value(row, row) * value(col, col));
        let mut pairs = (0..n).flat_map(|row| (row + 1..n).map(move |col| (row, col)));
        let beyond = pairs.find(|&(row, col)| value(row, col).abs() > largest(row, col));
        if let Some((row, col)) = beyond {
            let at = row * n + col;
            let (deviations, most) = (
                format!(
                    "sqrt({})*sqrt({})",
                    shown(row * n + row),
                    shown(col * n + col)
                ),
                in_unit(largest(row, col), covariance.dimensions[at]),
            );
            let message = format!(
                "covariance of `{}` and `{}` is {}, beyond the product of their standard deviations, {deviations} = {most}",
                name(row),
                name(col),
                shown(at)
            );
            return Diagnostic::error(Rule::E0612, covariance.places[at], message).with_help(
                format!("variances stand on the diagonal, covariances beside it: this one goes from -{most} to {most}"),
            );
        }
        let message = "covariance is not positive semidefinite: a combination of the parameters has a negative variance";
        Diagnostic::error(Rule::E0612, covariance.span, message).with_help(
            "each covariance alone is possible, but not all of them together: make some smaller",
        )
    }
}

/// The fault of a covariance that is no matrix, with the one that variances alone make, if it can be shown.
fn as_matrix(fault: Diagnostic, n: usize, covariance: &Numbers) -> Diagnostic {
    let variances = match covariance.shape {
        Shape::Vector(rows) if rows == n && n <= SHOWN => &covariance.values,
        _ => {
            let help = format!(
                "write {}, one for each parameter, with the variances on the diagonal",
                counted(n, "row")
            );
            return fault.with_help(help);
        }
    };
    let entry = |row: usize, col: usize| match row == col {
        true => in_unit(variances[row], covariance.dimensions[row]),
        false => "0".to_owned(),
    };
    let row = |row: usize| {
        let entries: Vec<String> = (0..n).map(|col| entry(row, col)).collect();
        format!("[{}]", entries.join(", "))
    };
    let rows: Vec<String> = (0..n).map(row).collect();
    let matrix = format!("[{}]", rows.join(", "));
    let help = format!(
        "write `{matrix}` if these are variances of independent parameters; covariances take the place of the zeros"
    );
    fault
        .with_help(help)
        .with_suggestion(covariance.span, matrix, Applicability::Possible)
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
