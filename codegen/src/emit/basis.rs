//! Monomial bases as functions: products of earlier monomials and their rates, by the recipe that [`crate::ir::basis`] shares with the
//! evaluator.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::emit::comment::{code, docs};
use crate::emit::names::Scope;
use crate::emit::source::{mentions, prologue};
use crate::emit::types::index;
use crate::ir::MonomialBasis;
use crate::ir::basis::Monomial;

/// Suffixes of a basis function, its rate and its second rate.
pub(crate) const RATES: [&str; 3] = ["", "_rate", "_rate2"];

/// The function of a basis (order 0) or of its first or second rate.
pub(crate) fn monomials(basis: &MonomialBasis, name: &Ident, order: usize) -> TokenStream {
    let recipe = basis
        .recipe()
        .expect("invariant: a verified basis has a recipe");
    let mut scope = Scope::default();
    let arguments: Vec<Ident> = ["z", "z_d1", "z_d2"][..=order]
        .iter()
        .map(|name| scope.claim(name))
        .collect();
    let names: Vec<Vec<Ident>> = (0..=order)
        .map(|rate| {
            basis
                .exponents
                .iter()
                .map(|exponents| scope.claim(&monomial_name(basis, exponents, rate)))
                .collect()
        })
        .collect();
    let mut statements: Vec<(Ident, TokenStream)> = Vec::new();
    for (position, monomial) in recipe.iter().enumerate() {
        for rate in 0..=order {
            let value = monomial_value(&names, &arguments, &recipe, *monomial, rate);
            statements.push((names[rate][position].clone(), value));
        }
    }
    let results = &names[order];
    let mut body = quote!(Vector([#(#results),*]));
    for (name, value) in statements.into_iter().rev() {
        if mentions(&body, &name.to_string()) {
            body = quote!(let #name = #value; #body);
        }
    }
    let function = format_ident!("{name}{}", RATES[order]);
    let (inputs, nodes) = (index(basis.inputs.len()), index(basis.exponents.len()));
    let parameters = arguments.iter().map(|argument| {
        let used = mentions(&body, &argument.to_string());
        let argument = if used {
            argument.clone()
        } else {
            format_ident!("_{argument}")
        };
        quote!(#argument: Vector<T, #inputs>)
    });
    let docs = docs(&[basis_doc(basis, order)]);
    let prologue = prologue(&body);
    quote! {
        #docs
        #[inline(always)]
        pub fn #function<T: Real>(#(#parameters),*) -> Vector<T, #nodes> {
            #prologue
            #body
        }
    }
}

fn basis_doc(basis: &MonomialBasis, order: usize) -> String {
    let of = format!(
        "the {} monomials {} of z = ({})",
        basis.exponents.len(),
        code(&basis.name),
        list(&basis.inputs)
    );
    match order {
        0 => format!("Values of {of}."),
        1 => format!("Rates of {of}, along the rate `z_d1` of z."),
        _ => format!("Second rates of {of}, along the rates `z_d1` and `z_d2` of z."),
    }
}

/// `alpha2_beta` for the exponents of alpha^2 beta, `alpha2_beta_d1` for its rate.
fn monomial_name(basis: &MonomialBasis, exponents: &[u32], rate: usize) -> String {
    let factors = basis.inputs.iter().zip(exponents).filter(|(_, e)| **e > 0);
    let factors: Vec<String> = factors
        .map(|(input, e)| {
            if *e == 1 {
                input.clone()
            } else {
                format!("{input}{e}")
            }
        })
        .collect();
    let name = if factors.is_empty() {
        "one".to_owned()
    } else {
        factors.join("_")
    };
    if rate == 0 {
        name
    } else {
        format!("{name}_d{rate}")
    }
}

/// The names of a basis' monomials, in order.
pub(crate) fn monomial_names(basis: &MonomialBasis) -> Vec<String> {
    basis
        .exponents
        .iter()
        .map(|exponents| monomial_name(basis, exponents, 0))
        .collect()
}

/// The value (0), rate (1) or second rate (2) of a monomial, in the order of operations that [`Monomial`] states.
fn monomial_value(
    names: &[Vec<Ident>],
    arguments: &[Ident],
    recipe: &[Monomial],
    monomial: Monomial,
    rate: usize,
) -> TokenStream {
    match monomial {
        Monomial::One if rate == 0 => quote!(T::one()),
        Monomial::One => quote!(T::zero()),
        Monomial::Input(input) => {
            let (argument, input) = (&arguments[rate], index(input));
            quote!(#argument[#input])
        }
        Monomial::Product { of, input } => {
            let p = |rate: usize| &names[rate][of];
            let z = |rate: usize| factor(names, arguments, recipe, input, rate);
            match rate {
                0 => {
                    let (p, z) = (p(0), z(0));
                    quote!(#p * #z)
                }
                1 => {
                    let (p, p1, z, z1) = (p(0), p(1), z(0), z(1));
                    quote!(#p1 * #z + #p * #z1)
                }
                _ => {
                    let (p, p1, p2, z, z1, z2) = (p(0), p(1), p(2), z(0), z(1), z(2));
                    quote!(#p2 * #z + real(2.0) * #p1 * #z1 + #p * #z2)
                }
            }
        }
    }
}

/// An input or its rate: by the name of its monomial where the basis has it, else as an entry.
fn factor(
    names: &[Vec<Ident>],
    arguments: &[Ident],
    recipe: &[Monomial],
    input: usize,
    rate: usize,
) -> TokenStream {
    match recipe
        .iter()
        .position(|monomial| *monomial == Monomial::Input(input))
    {
        Some(position) => {
            let name = &names[rate][position];
            quote!(#name)
        }
        None => {
            let (argument, input) = (&arguments[rate], index(input));
            quote!(#argument[#input])
        }
    }
}

/// Names as code.
pub(crate) fn list(names: &[String]) -> String {
    names
        .iter()
        .map(|name| code(name))
        .collect::<Vec<_>>()
        .join(", ")
}
