//! Monomial bases of the multi-dimensional Taylor polynomial network (4): canonical order, and the one recipe by which evaluation and
//! emitted code build monomials and their rates.

use std::collections::BTreeMap;

use nsv_spec::model::Basis as Kind;

use super::MonomialBasis;

/// How a monomial is made from earlier ones, with its rate (') and second rate ('') along a motion of the inputs z.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Monomial {
    /// `1`; rates `0`, `0`.
    One,
    /// `z_input`; rates `z'_input`, `z''_input`.
    Input(usize),
    /// With p the earlier monomial `of` and z the entry `input`:
    /// `m = p*z`; `m' = p'*z + p*z'`; `m'' = (p''*z + (2*p')*z') + p*z''`, in this order of operations.
    Product {
        /// Position of the earlier monomial.
        of: usize,
        /// Position of the input it is multiplied by.
        input: usize,
    },
}

impl MonomialBasis {
    /// The basis of all monomials up to `order`, or of those in at most two inputs, in canonical order: total degree ascending, then
    /// exponent of z_1 descending, z_2, ...
    pub fn new(name: &str, order: u32, kind: Kind, inputs: &[String]) -> MonomialBasis {
        let factors = match kind {
            Kind::Pairwise => 2,
            Kind::Complete => inputs.len(),
        };
        let mut exponents = Vec::new();
        let mut monomial = Vec::with_capacity(inputs.len());
        for degree in 0..=order {
            append(&mut exponents, &mut monomial, inputs.len(), factors, degree);
        }
        MonomialBasis {
            name: name.to_owned(),
            inputs: inputs.to_vec(),
            exponents,
        }
    }

    /// The recipe of each monomial: the one without its last factor, times that factor. `None` if a needed monomial is not in the basis
    /// before its product.
    pub fn recipe(&self) -> Option<Vec<Monomial>> {
        let mut position: BTreeMap<Vec<u32>, usize> = BTreeMap::new();
        let mut recipe = Vec::with_capacity(self.exponents.len());
        for (index, exponents) in self.exponents.iter().enumerate() {
            let degree: u32 = exponents.iter().sum();
            recipe.push(match exponents.iter().rposition(|&e| e > 0) {
                None => Monomial::One,
                Some(input) if degree == 1 => Monomial::Input(input),
                Some(input) => {
                    let mut earlier = exponents.clone();
                    earlier[input] -= 1;
                    Monomial::Product {
                        of: *position.get(&earlier)?,
                        input,
                    }
                }
            });
            position.insert(exponents.clone(), index);
        }
        Some(recipe)
    }
}

/// Appends the monomials of `degree` that begin with `monomial`, with at most `factors` different further inputs.
fn append(
    all: &mut Vec<Vec<u32>>,
    monomial: &mut Vec<u32>,
    inputs: usize,
    factors: usize,
    degree: u32,
) {
    if monomial.len() == inputs {
        if degree == 0 {
            all.push(monomial.clone());
        }
        return;
    }
    let highest = if factors == 0 { 0 } else { degree };
    for exponent in (0..=highest).rev() {
        monomial.push(exponent);
        let left = if exponent > 0 { factors - 1 } else { factors };
        if left > 0 || degree == exponent {
            append(all, monomial, inputs, left, degree - exponent);
        }
        monomial.pop();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn basis(order: u32, kind: Kind, inputs: usize) -> MonomialBasis {
        let names: Vec<String> = (1..=inputs).map(|i| format!("z{i}")).collect();
        MonomialBasis::new("basis1", order, kind, &names)
    }

    fn text(basis: &MonomialBasis) -> String {
        let digits = |e: &Vec<u32>| e.iter().map(u32::to_string).collect::<String>();
        basis
            .exponents
            .iter()
            .map(digits)
            .collect::<Vec<_>>()
            .join(" ")
    }

    fn choose(n: usize, k: usize) -> usize {
        (0..k).fold(1, |product, i| product * (n - i) / (i + 1))
    }

    #[test]
    fn three_inputs_of_order_three_have_the_papers_nineteen_nodes() {
        assert_eq!(
            text(&basis(3, Kind::Pairwise, 3)),
            "000 100 010 001 200 110 101 020 011 002 300 210 201 120 102 030 021 012 003"
        );
    }

    #[test]
    fn node_counts_follow_the_formulas() {
        for order in 0..=6 {
            for inputs in 1..=6 {
                let (m, pairs) = (order as usize, choose(inputs, 2));
                let pairwise = 1 + inputs * m + pairs * (m * m.saturating_sub(1) / 2);
                assert_eq!(
                    basis(order, Kind::Pairwise, inputs).exponents.len(),
                    pairwise,
                    "pairwise {order} {inputs}"
                );
                assert_eq!(
                    basis(order, Kind::Complete, inputs).exponents.len(),
                    choose(inputs + m, m),
                    "complete {order} {inputs}"
                );
            }
        }
    }

    #[test]
    fn recipes_multiply_to_their_exponents() {
        for kind in [Kind::Pairwise, Kind::Complete] {
            let basis = basis(5, kind, 4);
            let recipe = basis.recipe().expect("a recipe");
            for (monomial, exponents) in recipe.iter().zip(&basis.exponents) {
                let mut made = vec![0; 4];
                match *monomial {
                    Monomial::One => {}
                    Monomial::Input(input) => made[input] = 1,
                    Monomial::Product { of, input } => {
                        made.clone_from(&basis.exponents[of]);
                        made[input] += 1;
                    }
                }
                assert_eq!(&made, exponents);
            }
        }
    }

    #[test]
    fn recipe_needs_the_earlier_monomials() {
        let gap = MonomialBasis {
            name: "b".into(),
            inputs: vec!["z".into()],
            exponents: vec![vec![0], vec![3]],
        };
        assert_eq!(gap.recipe(), None);
    }
}
