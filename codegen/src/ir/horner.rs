//! The one evaluation scheme of polynomial data: Horner in the first argument, with coefficients that are Horner schemes in the second,
//! and so on. [`super::eval`] and the emitter walk the same tree, so they agree to the last bit by construction.

use std::collections::BTreeMap;

use super::{FamilyMember, PolynomialData};

/// A polynomial as nested Horner schemes.
#[derive(Clone, Debug, PartialEq)]
pub enum Horner {
    /// A coefficient of the data.
    Constant(f64),
    /// `r = leading`, then for each step, one per lower exponent: `r = r * z`, and `r = r + c` where the step has a coefficient; in a
    /// fused program that is one operation.
    Scheme {
        /// The argument z, by position.
        argument: usize,
        /// Coefficient of the highest power of z.
        leading: Box<Horner>,
        /// Coefficients of the lower powers, from the highest down to the constant; `None` where the data has no term.
        steps: Vec<Option<Horner>>,
    },
}

impl Horner {
    /// The scheme of `data`. Terms with equal exponents are summed in their order; a term with coefficient 0 is no term; a polynomial
    /// without terms is 0; an argument that does not occur makes no scheme.
    pub fn new(data: &PolynomialData) -> Horner {
        let mut sums: BTreeMap<&[u32], f64> = BTreeMap::new();
        for (coefficient, exponents) in &data.terms {
            sums.entry(exponents)
                .and_modify(|sum| *sum += coefficient)
                .or_insert(*coefficient);
        }
        let terms: Vec<(&[u32], f64)> = sums.into_iter().filter(|&(_, c)| c != 0.0).collect();
        nest(&terms, 0)
    }

    /// The value at `arguments`; if it is fused, with one rounding for each power.
    pub fn eval(&self, arguments: &[f64], fused: bool) -> f64 {
        match self {
            Horner::Constant(c) => *c,
            Horner::Scheme {
                argument,
                leading,
                steps,
            } => {
                let z = arguments[*argument];
                steps
                    .iter()
                    .fold(leading.eval(arguments, fused), |r, step| match step {
                        Some(c) if fused => f64::mul_add(r, z, c.eval(arguments, fused)),
                        Some(c) => r * z + c.eval(arguments, fused),
                        None => r * z,
                    })
            }
        }
    }

    /// Number of additions and of multiplications.
    pub fn operations(&self) -> (u64, u64) {
        match self {
            Horner::Constant(_) => (0, 0),
            Horner::Scheme { leading, steps, .. } => {
                let (additions, multiplications) = leading.operations();
                steps.iter().flatten().fold(
                    (additions, multiplications + steps.len() as u64),
                    |(add, mul), c| {
                        let (inner_add, inner_mul) = c.operations();
                        (add + 1 + inner_add, mul + inner_mul)
                    },
                )
            }
        }
    }
}

impl FamilyMember {
    /// The value at `z`; if it is fused, with one rounding for each power.
    pub fn eval(&self, z: f64, fused: bool) -> f64 {
        let mut coefficients = self.coefficients.iter();
        let leading = coefficients.next().copied().unwrap_or_default();
        coefficients.fold(leading, |r, &c| {
            if fused {
                f64::mul_add(r, z, c)
            } else {
                r * z + c
            }
        })
    }

    /// Number of additions and of multiplications.
    pub fn operations(&self) -> (u64, u64) {
        let lower = self.coefficients.iter().skip(1);
        let absent = |c: &&f64| c.to_bits() == (-0.0f64).to_bits();
        let (all, idle) = (lower.len() as u64, lower.filter(absent).count() as u64);
        (all - idle, all)
    }
}

/// Scheme of terms that agree in the exponents before `argument`; sorted by exponents.
fn nest(terms: &[(&[u32], f64)], argument: usize) -> Horner {
    let Some(&(exponents, coefficient)) = terms.last() else {
        return Horner::Constant(0.0);
    };
    if argument == exponents.len() {
        return Horner::Constant(coefficient);
    }
    let highest = exponents[argument];
    let coefficient_of = |power: u32| {
        let start = terms.partition_point(|(e, _)| e[argument] < power);
        let end = terms.partition_point(|(e, _)| e[argument] <= power);
        (start < end).then(|| nest(&terms[start..end], argument + 1))
    };
    let leading =
        coefficient_of(highest).expect("invariant: the last term has the highest exponent");
    if highest == 0 {
        return leading;
    }
    Horner::Scheme {
        argument,
        leading: Box::new(leading),
        steps: (0..highest).rev().map(coefficient_of).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn data(terms: &[(f64, &[u32])]) -> PolynomialData {
        let count = terms.first().map_or(2, |(_, e)| e.len());
        let arguments = (1..=count).map(|i| format!("z{i}")).collect();
        PolynomialData {
            name: "p".into(),
            arguments,
            terms: terms.iter().map(|(c, e)| (*c, e.to_vec())).collect(),
        }
    }

    /// The scheme as a formula.
    fn formula(horner: &Horner) -> String {
        match horner {
            Horner::Constant(c) => c.to_string(),
            Horner::Scheme {
                argument,
                leading,
                steps,
            } => steps.iter().fold(formula(leading), |r, step| match step {
                Some(c) => format!("({r}*z{} + {})", argument + 1, formula(c)),
                None => format!("{r}*z{}", argument + 1),
            }),
        }
    }

    fn check(terms: &[(f64, &[u32])], expected: &str) {
        assert_eq!(formula(&Horner::new(&data(terms))), expected);
    }

    #[test]
    fn coefficients_nest_in_later_arguments() {
        check(
            &[
                (3.0, &[0, 0]),
                (4.0, &[0, 1]),
                (5.0, &[2, 0]),
                (7.0, &[1, 2]),
            ],
            "((5*z1 + 7*z2*z2)*z1 + (4*z2 + 3))",
        );
    }

    #[test]
    fn missing_powers_multiply_without_adding() {
        check(&[(2.0, &[3]), (1.0, &[0])], "(2*z1*z1*z1 + 1)");
    }

    #[test]
    fn equal_exponents_are_summed_and_zeros_dropped() {
        check(
            &[(2.0, &[1]), (3.0, &[0]), (4.0, &[1]), (-3.0, &[0])],
            "6*z1",
        );
    }

    #[test]
    fn no_terms_are_zero() {
        check(&[], "0");
    }

    #[test]
    fn value_is_the_polynomial() {
        let horner = Horner::new(&data(&[
            (3.0, &[0, 0]),
            (4.0, &[0, 1]),
            (5.0, &[2, 0]),
            (7.0, &[1, 2]),
        ]));
        for fused in [false, true] {
            assert_eq!(horner.eval(&[2.0, 3.0], fused), 3.0 + 12.0 + 20.0 + 126.0);
        }
        assert_eq!(horner.operations(), (3, 5));
    }
}
