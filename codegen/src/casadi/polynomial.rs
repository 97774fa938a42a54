//! Exact partial derivatives of polynomial data.

use crate::ir::PolynomialData;

/// Derivative `orders[j]` times by argument j: a term c z^a becomes (c a) z^(a-1), and drops out at a = 0.
/// Named `<name>_d1_d3` for one derivative by the first and one by the third argument.
pub(crate) fn differentiate(data: &PolynomialData, orders: &[u32]) -> PolynomialData {
    let mut result = data.clone();
    for (argument, order) in orders.iter().enumerate() {
        for _ in 0..*order {
            result.name = format!("{}_d{}", result.name, argument + 1);
            result.terms = result
                .terms
                .iter()
                .filter_map(|term| derivative(term, argument))
                .collect();
        }
    }
    result
}

fn derivative(
    (coefficient, exponents): &(f64, Vec<u32>),
    argument: usize,
) -> Option<(f64, Vec<u32>)> {
    let mut lower = exponents.clone();
    lower[argument] = exponents[argument].checked_sub(1)?;
    Some((coefficient * f64::from(exponents[argument]), lower))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mixed_derivative_is_exact() {
        let data = PolynomialData {
            name: "cl".to_owned(),
            arguments: vec!["alpha".to_owned(), "mach".to_owned()],
            terms: vec![(2.0, vec![0, 0]), (3.0, vec![2, 1]), (5.0, vec![0, 4])],
        };
        let derived = differentiate(&data, &[2, 1]);
        assert_eq!(derived.name, "cl_d1_d1_d2");
        assert_eq!(derived.terms, vec![(6.0, vec![0, 0])]);
        assert!(differentiate(&data, &[3, 0]).terms.is_empty());
    }
}
