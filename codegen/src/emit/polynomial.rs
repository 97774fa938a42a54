//! Polynomial data and monomial bases as functions: nested Horner schemes and products of earlier monomials, by the recipes that
//! [`crate::ir::horner`] and [`crate::ir::basis`] share with the evaluator.

use std::collections::BTreeSet;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::emit::comment::{code, docs, prose};
use crate::emit::expression::{Fragment, Level};
use crate::emit::literal;
use crate::emit::names::{Scope, snake};
use crate::emit::plan::live;
use crate::emit::source::{mentions, prologue};
use crate::emit::types::index;
use crate::ir::basis::Monomial;
use crate::ir::horner::Horner;
use crate::ir::{MonomialBasis, Op, PolynomialData, Program};

/// Suffixes of a basis function, its rate and its second rate.
const RATES: [&str; 3] = ["", "_rate", "_rate2"];

/// The polynomials and bases of a set of programs, each once, with the names of their functions.
#[derive(Clone, Debug, Default)]
pub(crate) struct Library {
    polynomials: Vec<(PolynomialData, Ident)>,
    bases: Vec<(MonomialBasis, Ident)>,
    /// Functions of bases that are called: position and order of the rate.
    called: BTreeSet<(usize, usize)>,
}

impl Library {
    /// What `programs` use. Data of one name that differs between programs gets two functions.
    pub(crate) fn of(programs: &[&Program]) -> Library {
        let mut library = Library::default();
        let mut scope = Scope::default();
        for program in programs {
            let live = live(program);
            for (instruction, _) in program
                .instructions
                .iter()
                .zip(live)
                .filter(|(_, live)| *live)
            {
                library.add(program, &instruction.op, &mut scope);
            }
        }
        library
    }

    fn add(&mut self, program: &Program, op: &Op, scope: &mut Scope) {
        let (basis, order) = match *op {
            Op::Polynomial(id, _) => {
                let data = &program.polynomials[id.0 as usize];
                if self.polynomials.iter().all(|(known, _)| known != data) {
                    self.polynomials
                        .push((data.clone(), scope.claim(&data.name)));
                }
                return;
            }
            Op::Basis(basis, _) => (basis, 0),
            Op::BasisRate(basis, ..) => (basis, 1),
            Op::BasisRate2(basis, ..) => (basis, 2),
            _ => return,
        };
        let basis = &program.bases[basis.0 as usize];
        let position = self
            .bases
            .iter()
            .position(|(known, _)| known == basis)
            .unwrap_or_else(|| {
                self.bases.push((basis.clone(), scope.claim(&basis.name)));
                self.bases.len() - 1
            });
        self.called.insert((position, order));
    }

    /// Whether there is nothing to emit.
    pub(crate) fn is_empty(&self) -> bool {
        self.polynomials.is_empty() && self.bases.is_empty()
    }

    /// Path of the function of each polynomial of a program; empty for one that it does not call.
    pub(crate) fn polynomial_paths(&self, program: &Program) -> Vec<TokenStream> {
        let path = |data: &PolynomialData| {
            let found = self.polynomials.iter().find(|(known, _)| known == data);
            found
                .map(|(_, name)| quote!(polynomials::#name))
                .unwrap_or_default()
        };
        program.polynomials.iter().map(path).collect()
    }

    /// Paths of the functions of each basis of a program: value, rate, second rate; empty for one that it does not call.
    pub(crate) fn basis_paths(&self, program: &Program) -> Vec<[TokenStream; 3]> {
        let path = |basis: &MonomialBasis| {
            let found = self.bases.iter().find(|(known, _)| known == basis);
            RATES.map(|suffix| {
                let name = found.map(|(_, name)| format_ident!("{name}{suffix}"));
                name.map(|name| quote!(polynomials::#name))
                    .unwrap_or_default()
            })
        };
        program.bases.iter().map(path).collect()
    }

    /// The functions. `sources` tells where data comes from, by its name in the specification.
    pub(crate) fn items(&self, sources: &[(String, String)]) -> Vec<TokenStream> {
        let polynomials = self
            .polynomials
            .iter()
            .map(|(data, name)| polynomial(data, name, source(data, sources)));
        let bases = self.called.iter().map(|&(position, order)| {
            let (basis, name) = &self.bases[position];
            monomials(basis, name, order)
        });
        polynomials.chain(bases).collect()
    }
}

/// The source of polynomial data, or of that whose derivative it is.
fn source<'s>(data: &PolynomialData, sources: &'s [(String, String)]) -> Option<&'s str> {
    let of = |name: &str| {
        sources.iter().find(|(known, _)| {
            known == name || known.replace('.', "_") == name || snake(known) == name
        })
    };
    let (_, source) =
        std::iter::successors(Some(data.name.as_str()), |name| primitive(name)).find_map(of)?;
    Some(source.as_str()).filter(|source| !source.is_empty())
}

/// `name` for `name_d1`, a partial derivative.
fn primitive(name: &str) -> Option<&str> {
    let shorter = name.trim_end_matches(|c: char| c.is_ascii_digit());
    shorter
        .strip_suffix("_d")
        .filter(|_| shorter.len() < name.len())
}

fn polynomial(data: &PolynomialData, name: &Ident, source: Option<&str>) -> TokenStream {
    let horner = Horner::new(data);
    let (additions, multiplications) = horner.operations();
    let mut scope = Scope::default();
    let arguments: Vec<Ident> = data
        .arguments
        .iter()
        .map(|argument| scope.claim(argument))
        .collect();
    let mut scheme = Scheme {
        arguments: &arguments,
        scope,
        statements: Vec::new(),
    };
    let value = scheme.value(&horner, "a").tokens;
    let statements = scheme.statements;
    let body = quote!(#(#statements)* #value);
    let parameters = arguments.iter().map(|argument| {
        if mentions(&body, &argument.to_string()) {
            return quote!(#argument: T);
        }
        let unused = format_ident!("_{argument}");
        quote!(#unused: T)
    });
    let source = source.map_or_else(String::new, |source| format!(" Source: {}.", prose(source)));
    let docs = docs(&[
        format!(
            "Polynomial data {} in {}, by Horner's scheme.{source}",
            code(&data.name),
            list(&data.arguments)
        ),
        String::new(),
        format!(
            "{} terms; {additions} additions, {multiplications} multiplications.",
            data.terms.len()
        ),
    ]);
    let prologue = prologue(&body);
    quote! {
        #docs
        #[inline]
        pub fn #name<T: Real>(#(#parameters),*) -> T {
            #prologue
            #body
        }
    }
}

fn list(names: &[String]) -> String {
    names
        .iter()
        .map(|name| code(name))
        .collect::<Vec<_>>()
        .join(", ")
}

/// A Horner scheme being written.
struct Scheme<'a> {
    arguments: &'a [Ident],
    scope: Scope,
    statements: Vec<TokenStream>,
}

impl Scheme<'_> {
    /// The value of a scheme. Coefficients that depend on further arguments are bound to `prefix` and their power before it.
    fn value(&mut self, horner: &Horner, prefix: &str) -> Fragment {
        let (argument, leading, steps) = match horner {
            Horner::Constant(value) => {
                let value = literal::float(*value);
                return Fragment::postfix(quote!(real(#value)));
            }
            Horner::Scheme {
                argument,
                leading,
                steps,
            } => (*argument, leading, steps),
        };
        let z = self.arguments[argument].clone();
        let highest = steps.len();
        let mut value = self.coefficient(leading, &format!("{prefix}{highest}"));
        for (power, step) in (0..highest).rev().zip(steps) {
            let factor = value.at(Level::Product);
            value = Fragment {
                tokens: quote!(#factor * #z),
                level: Level::Product,
            };
            if let Some(step) = step {
                let (product, term) = (
                    value.tokens,
                    self.coefficient(step, &format!("{prefix}{power}"))
                        .at(Level::Product),
                );
                value = Fragment {
                    tokens: quote!(#product + #term),
                    level: Level::Sum,
                };
            }
        }
        value
    }

    fn coefficient(&mut self, horner: &Horner, name: &str) -> Fragment {
        let value = self.value(horner, &format!("{name}_"));
        if matches!(horner, Horner::Constant(_)) {
            return value;
        }
        let (name, value) = (self.scope.claim(name), value.tokens);
        self.statements.push(quote!(let #name = #value;));
        Fragment::postfix(quote!(#name))
    }
}

/// The function of a basis (order 0) or of its first or second rate.
fn monomials(basis: &MonomialBasis, name: &Ident, order: usize) -> TokenStream {
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
        #[inline]
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
