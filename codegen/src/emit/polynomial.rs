//! Polynomial data as functions, by the nested Horner schemes that [`crate::ir::horner`] shares with the evaluator; and the library of
//! all polynomials and bases of a module.

use std::collections::BTreeSet;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::emit::basis::{RATES, list, monomials};
use crate::emit::comment::{code, docs, prose};
use crate::emit::expression::{Fragment, Level};
use crate::emit::family::{self, FamilyNames};
use crate::emit::literal;
use crate::emit::names::{Scope, snake};
use crate::emit::source::{mentions, prologue};
use crate::emit::table::Tables;
use crate::ir::horner::Horner;
use crate::ir::{MonomialBasis, Op, PolynomialData, PolynomialFamily, Program};
use crate::opt::dead_code::live;

/// The polynomials and bases of a set of programs, each once, with the names of their functions.
#[derive(Clone, Debug, Default)]
pub(crate) struct Library {
    polynomials: Vec<(PolynomialData, Ident)>,
    families: Vec<(PolynomialFamily, FamilyNames)>,
    bases: Vec<(MonomialBasis, Ident)>,
    /// Lookup tables, in a module of their own.
    pub(crate) tables: Tables,
    /// Whether polynomials are fused: the programs of a module are, or none of them.
    fused: bool,
    /// Functions of bases that are called: position and order of the rate.
    called: BTreeSet<(usize, usize)>,
}

impl Library {
    /// What `programs` use. Data of one name that differs between programs gets two functions.
    pub(crate) fn of(programs: &[&Program]) -> Library {
        let mut library = Library {
            fused: programs.iter().any(|program| program.fused),
            ..Library::default()
        };
        let (mut scope, mut types) = (Scope::default(), Scope::default());
        for program in programs {
            let live = live(program);
            for (instruction, _) in program
                .instructions
                .iter()
                .zip(live)
                .filter(|(_, live)| *live)
            {
                library.add(program, &instruction.op, &mut scope, &mut types);
                library.tables.add(program, &instruction.op);
            }
        }
        library
    }

    fn add(&mut self, program: &Program, op: &Op, scope: &mut Scope, types: &mut Scope) {
        let (basis, order) = match *op {
            Op::Polynomial(id, _) => {
                let data = &program.polynomials[id.0 as usize];
                if self.polynomials.iter().all(|(known, _)| known != data) {
                    self.polynomials
                        .push((data.clone(), scope.claim(&data.name)));
                }
                return;
            }
            Op::Family(id, _) => {
                let family = &program.families[id.0 as usize];
                if self.families.iter().all(|(known, _)| known != family) {
                    let members = family.members.iter().map(|member| member.name.clone());
                    let module = "polynomials";
                    let names = FamilyNames::new(module, &family.name, members, scope, types);
                    self.families.push((family.clone(), names));
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
        self.polynomials.is_empty() && self.families.is_empty() && self.bases.is_empty()
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

    /// Names of each family of a program; `None` for one that it does not call.
    pub(crate) fn family_names(&self, program: &Program) -> Vec<Option<FamilyNames>> {
        let names = |family: &PolynomialFamily| {
            let found = self.families.iter().find(|(known, _)| known == family);
            found.map(|(_, names)| names.clone())
        };
        program.families.iter().map(names).collect()
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
            .map(|(data, name)| polynomial(data, self.fused, name, source(&data.name, sources)));
        let families = self.families.iter().flat_map(|(family, names)| {
            family::items(family, self.fused, names, |member| source(member, sources))
        });
        let bases = self.called.iter().map(|&(position, order)| {
            let (basis, name) = &self.bases[position];
            monomials(basis, name, order)
        });
        polynomials.chain(families).chain(bases).collect()
    }
}

/// The source of polynomial data, or of that whose derivative it is.
fn source<'s>(name: &str, sources: &'s [(String, String)]) -> Option<&'s str> {
    let of = |name: &str| {
        sources.iter().find(|(known, _)| {
            known == name || known.replace('.', "_") == name || snake(known) == name
        })
    };
    let (_, source) = std::iter::successors(Some(name), |name| primitive(name)).find_map(of)?;
    Some(source.as_str()).filter(|source| !source.is_empty())
}

/// `name` for `name_d1`, a partial derivative.
fn primitive(name: &str) -> Option<&str> {
    let shorter = name.trim_end_matches(|c: char| c.is_ascii_digit());
    shorter
        .strip_suffix("_d")
        .filter(|_| shorter.len() < name.len())
}

fn polynomial(
    data: &PolynomialData,
    fused: bool,
    name: &Ident,
    source: Option<&str>,
) -> TokenStream {
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
        fused,
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
        #[inline(always)]
        pub fn #name<T: Real>(#(#parameters),*) -> T {
            #prologue
            #body
        }
    }
}

/// A Horner scheme being written.
struct Scheme<'a> {
    arguments: &'a [Ident],
    fused: bool,
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
            let term = step
                .as_ref()
                .map(|step| self.coefficient(step, &format!("{prefix}{power}")));
            if let (Some(term), true) = (&term, self.fused) {
                let (factor, term) = (value.at(Level::Postfix), &term.tokens);
                value = Fragment::postfix(quote!(#factor.mul_add(#z, #term)));
                continue;
            }
            let factor = value.at(Level::Product);
            value = Fragment {
                tokens: quote!(#factor * #z),
                level: Level::Product,
            };
            if let Some(term) = term {
                let (product, term) = (value.tokens, term.at(Level::Product));
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
