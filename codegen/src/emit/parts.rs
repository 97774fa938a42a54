//! Long functions in parts: the first statements stand in functions of their own, since the time that rustc takes for one function grows
//! faster than its length. Values that later statements use are returned in a struct.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::emit::comment::{Comments, docs};
use crate::emit::expression::Names;
use crate::emit::function::Function;
use crate::emit::names::{camel, ident};
use crate::emit::plan::Plan;
use crate::emit::source::prologue;
use crate::emit::statements::{Statements, Update, in_place};
use crate::emit::types::{type_of, type_of_shape};
use crate::ir::eval::entries;
use crate::ir::{Op, ValueId};

/// Most statements of one function. A chain of coupled arms in one function took rustc 3.4 s for 255 statements, 16 s for 510 and 98 s for
/// 1,020; the last in parts of this length 12 s.
const LONGEST: usize = 200;

/// Statements in a function of their own.
pub(super) struct Part {
    /// Its structs and the function.
    pub(super) items: [TokenStream; 3],
    /// The statement that calls it.
    pub(super) call: TokenStream,
}

/// What parts are made of.
pub(super) struct Whole<'f> {
    pub(super) function: &'f Function<'f>,
    pub(super) plan: &'f Plan,
    pub(super) names: &'f Names<'f>,
    pub(super) updates: &'f [Update],
}

/// A variable: that of a value, or where a pack has one for each of its entries, that of an entry.
type Variable = (ValueId, Option<usize>);

/// What statements need.
#[derive(Default)]
struct Needs<'f> {
    variables: BTreeSet<Variable>,
    /// Arguments of the function.
    arguments: BTreeSet<&'f str>,
}

/// Where the variables of a function are set and used last, as positions of steps.
struct Lifetimes {
    set: BTreeMap<Variable, usize>,
    /// Behind all steps for what the results and updates use.
    last: BTreeMap<Variable, usize>,
    /// Statements before each step, and before the end.
    statements: Vec<usize>,
    /// Numbers that are set before each step and used from there on.
    numbers: Vec<usize>,
}

/// A field of the struct that a part is: its type, and what it is given.
struct Given {
    name: Ident,
    ty: TokenStream,
    value: TokenStream,
}

impl Whole<'_> {
    /// The parts of the function, none if it is short, and the position of the first step that is in none.
    pub(super) fn parts(&self, comments: &mut Comments) -> (Vec<Part>, usize) {
        let replaced: BTreeSet<ValueId> = in_place(self.updates).collect();
        let lifetimes = self.lifetimes(&replaced);
        let arguments = self.function.argument_names();
        let mut parts = Vec::new();
        let mut start = 0;
        while let Some(end) = lifetimes.cut(start) {
            let mut needs = Needs::default();
            for id in (start..end).flat_map(|step| self.computed(step, &replaced)) {
                self.add_needs(id, &mut needs);
            }
            let earlier = needs.variables.into_iter();
            let earlier = earlier.filter(|variable| lifetimes.set[variable] < start);
            let given = self
                .handed(&arguments, &needs.arguments)
                .chain(earlier.map(|variable| {
                    let (name, ty) = self.variable(variable);
                    let value = quote!(#name);
                    Given { name, ty, value }
                }));
            let computed = (start..end).flat_map(|step| self.computed(step, &replaced));
            let results: BTreeSet<Variable> = computed
                .flat_map(|id| self.set_by(id))
                .filter(|variable| {
                    lifetimes
                        .last
                        .get(variable)
                        .is_some_and(|&last| last >= end)
                })
                .collect();
            let (given, results) = (
                given.collect::<Vec<_>>(),
                results.into_iter().map(|variable| self.variable(variable)),
            );
            let number = parts.len() + 1;
            parts.push(self.part(
                number,
                start..end,
                &given,
                &results.collect::<Vec<_>>(),
                comments,
            ));
            start = end;
        }
        (parts, start)
    }

    /// The values that a step computes, those written in place left out.
    fn computed(&self, step: usize, replaced: &BTreeSet<ValueId>) -> impl Iterator<Item = ValueId> {
        let step = &self.plan.steps[step];
        let own = Some(step.value).filter(|value| !replaced.contains(value));
        step.temporaries.iter().copied().chain(own)
    }

    /// Adds what the formula of a value needs.
    fn add_needs<'n>(&'n self, id: ValueId, needs: &mut Needs<'n>) {
        let program = self.function.program;
        let mut formulas = vec![id];
        while let Some(id) = formulas.pop() {
            match program.instruction(id).op {
                Op::Input(at) => {
                    let argument = self.function.argument(&program.inputs[at]);
                    needs.arguments.insert(argument);
                }
                Op::Element(pack, row, _) if self.names.packs.contains_key(&pack) => {
                    needs.variables.insert((pack, Some(row)));
                }
                ref op => {
                    let operands = op.operands().into_iter();
                    formulas.extend(operands.filter(|&operand| !self.add_variable(operand, needs)));
                }
            }
        }
    }

    /// Adds the variable of a value, if it has one.
    fn add_variable(&self, id: ValueId, needs: &mut Needs<'_>) -> bool {
        let bound = self.names.variables[id.0 as usize].is_some();
        if bound {
            needs.variables.insert((id, None));
        }
        bound
    }

    /// The variables that the statement of a value sets.
    fn set_by(&self, id: ValueId) -> impl Iterator<Item = Variable> {
        let entries = self.names.packs.get(&id).map(Vec::len);
        let own = entries.is_none().then_some((id, None));
        let entries = (0..entries.unwrap_or(0)).map(move |entry| (id, Some(entry)));
        own.into_iter().chain(entries)
    }

    fn lifetimes(&self, replaced: &BTreeSet<ValueId>) -> Lifetimes {
        let (mut set, mut last) = (BTreeMap::new(), BTreeMap::new());
        let mut statements = vec![0];
        let end = self.plan.steps.len();
        for step in 0..end {
            let mut needs = Needs::default();
            let mut count = 0;
            for id in self.computed(step, replaced) {
                self.add_needs(id, &mut needs);
                set.extend(self.set_by(id).map(|variable| (variable, step)));
                count += 1;
            }
            last.extend(needs.variables.into_iter().map(|variable| (variable, step)));
            statements.push(statements[step] + count);
        }
        let mut needs = Needs::default();
        for (_, id) in &self.function.program.outputs {
            if replaced.contains(id) || !self.add_variable(*id, &mut needs) {
                self.add_needs(*id, &mut needs);
            }
        }
        last.extend(needs.variables.into_iter().map(|variable| (variable, end)));
        let numbers = self.numbers_across(&set, &last);
        Lifetimes {
            set,
            last,
            statements,
            numbers,
        }
    }

    /// How many numbers are set before each step, and before the end, and used from there on.
    fn numbers_across(
        &self,
        set: &BTreeMap<Variable, usize>,
        last: &BTreeMap<Variable, usize>,
    ) -> Vec<usize> {
        let steps = self.plan.steps.len() + 1;
        let (mut starting, mut ending) = (vec![0; steps], vec![0; steps]);
        for (variable, &end) in last {
            let (id, entry) = variable;
            let numbers = entry.map_or_else(|| entries(self.function.program.ty(*id)), |_| 1);
            starting[set[variable] + 1] += numbers;
            ending[end] += numbers;
        }
        let changes = starting.iter().zip(std::iter::once(&0).chain(&ending));
        let numbers = changes.scan(0, |alive, (starting, ending)| {
            *alive = *alive + starting - ending;
            Some(*alive)
        });
        numbers.collect()
    }

    /// The arguments of the function that a part needs.
    fn handed<'h>(
        &'h self,
        arguments: &'h [(String, Ident)],
        needed: &'h BTreeSet<&str>,
    ) -> impl Iterator<Item = Given> + 'h {
        let Function {
            program,
            records,
            updates,
            ..
        } = self.function;
        let arguments = arguments.iter();
        let arguments = arguments.filter(|(name, _)| needed.contains(name.as_str()));
        arguments.map(move |(argument, name)| {
            let name = name.clone();
            let Some(record) = records.iter().find(|record| record.prefix == argument) else {
                let input = program.inputs.iter().find(|input| input.name == *argument);
                let ty = type_of_shape(input.expect("invariant: an argument is an input").shape);
                let value = quote!(#name);
                return Given { name, ty, value };
            };
            let ty = ident(record.ty);
            let updated = updates.is_some_and(|updates| updates.argument == argument);
            let value = match updated {
                true => quote!(#name: &*#name),
                false => quote!(#name),
            };
            let ty = quote!(&'a #ty<T>);
            Given { name, ty, value }
        })
    }

    /// The identifier of a variable, and its type.
    fn variable(&self, (id, entry): Variable) -> (Ident, TokenStream) {
        if let Some(entry) = entry {
            let variable = self.names.packs[&id][entry].to_string();
            return (ident(&variable), quote!(T));
        }
        let variable = self.names.variables[id.0 as usize].clone();
        let variable = variable.expect("invariant: the value has a variable");
        let ty = match self.names.family(id) {
            Some(family) => {
                let ty = family.type_path();
                quote!(#ty<T>)
            }
            None => type_of(self.function.program.ty(id)),
        };
        (variable, ty)
    }

    /// A part of these steps.
    fn part(
        &self,
        number: usize,
        steps: Range<usize>,
        given: &[Given],
        results: &[(Ident, TokenStream)],
        comments: &mut Comments,
    ) -> Part {
        let function = self.function.name();
        let prefix = camel(&function.to_string());
        let (part, values) = (
            format_ident!("{prefix}Part{number}"),
            format_ident!("{prefix}Values{number}"),
        );
        let mut text = Statements::of(self.function);
        text.add_steps(&self.plan.steps[steps], self.names, self.updates, comments);
        let (statements, returned) = (text.written, results.iter().map(|(name, _)| name));
        let body = quote!(#(#statements)* #values { #(#returned),* });
        let prologue = prologue(&body);
        let borrows = given
            .iter()
            .any(|given| given.ty.to_string().starts_with('&'));
        let (lifetime, elided) = match borrows {
            true => (quote!('a,), quote!('_,)),
            false => Default::default(),
        };
        let given_names = given.iter().map(|given| &given.name);
        let members = given
            .iter()
            .map(|Given { name, ty, .. }| quote!(#name: #ty));
        let handed = given.iter().map(|given| &given.value);
        let found = results.iter().map(|(name, _)| name);
        let fields = results.iter().map(|(name, ty)| quote!(#name: #ty));
        let part_docs = docs(&[format!(
            "Part {number} of [`{function}`]: short functions compile faster than one long one."
        )]);
        let values_docs = docs(&[format!("What is used of the values of [`{part}`].")]);
        Part {
            call: quote!(let #values { #(#found),* } = T::outlined(#part { #(#handed),* });),
            items: [
                quote!(#part_docs struct #part<#lifetime T: Real> { #(#members),* }),
                quote!(#values_docs struct #values<T: Real> { #(#fields),* }),
                quote! {
                    impl<T: Real> Part for #part<#elided T> {
                        type Output = #values<T>;

                        #[inline(always)]
                        fn run(self) -> Self::Output {
                            let Self { #(#given_names),* } = self;
                            #prologue
                            #body
                        }
                    }
                },
            ],
        }
    }
}

impl Lifetimes {
    /// The end of a part that begins at step `start`: where the fewest numbers are in use, in the later half of the longest part. `None` if
    /// what is left is short enough.
    fn cut(&self, start: usize) -> Option<usize> {
        let end = self.statements.len() - 1;
        let count = |to: usize| self.statements[to] - self.statements[start];
        if count(end) <= LONGEST {
            return None;
        }
        let first = (start + 1..end).find(|&to| 2 * count(to) >= LONGEST)?;
        let others = (first + 1..end).take_while(|&to| count(to) <= LONGEST);
        std::iter::once(first)
            .chain(others)
            .min_by_key(|&to| (self.numbers[to], Reverse(to)))
    }
}

#[cfg(test)]
mod tests {
    use super::LONGEST;
    use crate::emit::standalone;
    use crate::ir::chain;
    use crate::opt::optimise;

    #[test]
    fn no_function_is_longer_than_the_longest() {
        let text = standalone(&optimise(chain::arms(100)));
        let functions: Vec<&str> = text.split("fn ").collect();
        let statements = functions
            .iter()
            .map(|function| function.matches("let ").count());
        // The names given to a part and those taken from its result are a statement each.
        let most = statements.max().expect("a function");
        assert!(most <= LONGEST + functions.len(), "{most}");
        assert!(text.contains("T::outlined(ChainPart3 {"));
    }

    #[test]
    fn a_short_function_stays_whole() {
        assert!(!standalone(&optimise(chain::arms(10))).contains("outlined"));
    }
}
