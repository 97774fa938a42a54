//! A program as a Rust function over `T: Real`: arguments from its inputs, statements grouped by equation under comments that state
//! them, and a struct of results.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::emit::comment::{Comments, code, docs};
use crate::emit::expression::Names;
use crate::emit::names::{Fields, Scope, camel, ident, snake};
use crate::emit::pack::packs;
use crate::emit::parts::Whole;
use crate::emit::plan::Plan;
use crate::emit::polynomial::Library;
use crate::emit::quantity;
use crate::emit::source::prologue;
use crate::emit::statements::Statements;
use crate::emit::types::{literal_array, type_of, type_of_shape};
use crate::ir::{Input, Op, Origin, Program, Shape, Type, ValueId};
use crate::opt::cost;

/// A struct that stands for all inputs `prefix.NAME`, or for all outputs `prefix.NAME`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Record<'a> {
    /// What the names begin with, without the dot.
    pub(crate) prefix: &'a str,
    /// The struct's type.
    pub(crate) ty: &'a str,
    /// Its fields.
    pub(crate) fields: &'a Fields,
}

/// How results are returned.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Results<'a> {
    /// In a struct of the function's own, `NameOutputs`, emitted with it.
    Own,
    /// In a struct that exists, with a field for each output.
    Existing(&'a str, &'a Fields),
}

/// What is needed to emit a program as a function.
pub(crate) struct Function<'a> {
    /// The program.
    pub(crate) program: &'a Program,
    /// Rustdoc, without the operation counts.
    pub(crate) docs: &'a [String],
    /// Structs of inputs and outputs.
    pub(crate) records: &'a [Record<'a>],
    /// What is returned.
    pub(crate) results: Results<'a>,
    /// Names of the polynomial functions.
    pub(crate) tables: &'a Library,
    /// Outputs that replace fields of an argument, if there are any.
    pub(crate) updates: Option<Updates<'a>>,
}

/// Outputs `prefix.NAME` that replace the fields NAME of an argument, a record.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Updates<'a> {
    /// What the outputs' names begin with, without the dot.
    pub(crate) prefix: &'a str,
    /// The argument.
    pub(crate) argument: &'a str,
}

impl Function<'_> {
    /// The function, after the struct of its results if that is its own.
    pub(crate) fn items(&self, comments: &mut Comments) -> Vec<TokenStream> {
        let function = self.function(comments);
        self.own_results().into_iter().chain(function).collect()
    }

    /// The struct of its results, if that is its own.
    pub(crate) fn own_results(&self) -> Option<TokenStream> {
        match self.results {
            Results::Own => Some(self.outputs_struct()),
            Results::Existing(..) => None,
        }
    }

    /// The function's name.
    pub(crate) fn name(&self) -> Ident {
        Scope::default().claim(&snake(&self.program.name))
    }

    /// The type of its results.
    pub(crate) fn results_type(&self) -> Ident {
        match self.results {
            Results::Own => format_ident!("{}Outputs", camel(&self.name().to_string())),
            Results::Existing(ty, _) => ident(ty),
        }
    }

    /// The field of each output that is not in a record.
    pub(crate) fn output_fields(&self) -> Fields {
        match self.results {
            Results::Own => Fields::new(
                self.program
                    .outputs
                    .iter()
                    .map(|(name, _)| name.as_str())
                    .filter(|name| self.updated(name).is_none()),
            ),
            Results::Existing(_, fields) => fields.clone(),
        }
    }

    /// The names of its arguments, in order: inputs, and records under their prefix.
    pub(crate) fn arguments(&self) -> Vec<String> {
        let names = self.program.inputs.iter().map(|input| self.argument(input));
        let mut known = BTreeSet::new();
        names
            .filter(|name| known.insert(*name))
            .map(str::to_owned)
            .collect()
    }

    /// The argument that holds an input.
    pub(super) fn argument<'i>(&'i self, input: &'i Input) -> &'i str {
        self.record(&input.name)
            .map_or(input.name.as_str(), |(record, _)| record.prefix)
    }

    /// The record of a dotted name, and the name in it.
    pub(super) fn record<'n>(&self, name: &'n str) -> Option<(&Record<'_>, &'n str)> {
        let (prefix, rest) = name.split_once('.')?;
        Some((
            self.records.iter().find(|record| record.prefix == prefix)?,
            rest,
        ))
    }

    /// The field of an argument that an output replaces, as an input's name.
    pub(super) fn updated(&self, output: &str) -> Option<String> {
        let Updates { prefix, argument } = self.updates?;
        let name = output.strip_prefix(prefix)?.strip_prefix('.')?;
        Some(format!("{argument}.{name}"))
    }

    /// The function, and behind it its parts, if it is long.
    pub(crate) fn function(&self, comments: &mut Comments) -> Vec<TokenStream> {
        let plan = Plan::new(self.program);
        let (names, parameters) = self.names(&plan);
        let updates = self.update_list(&plan, &names);
        let whole = Whole {
            function: self,
            plan: &plan,
            names: &names,
            updates: &updates,
        };
        let (parts, last) = whole.parts(comments);
        let mut text = Statements::of(self);
        text.add_steps(&plan.steps[last..], &names, &updates, comments);
        text.add_updates(&names, &updates, comments);
        let (calls, statements) = (parts.iter().map(|part| &part.call), text.written);
        let result = self.result(&names);
        let body = quote!(#(#calls)* #(#statements)* #result);
        let prologue = prologue(&body);
        let function = self.with_body(&parameters, &quote!(#prologue #body));
        let parts = parts.into_iter().flat_map(|part| part.items);
        std::iter::once(function).chain(parts).collect()
    }

    /// The function with a body that calls others.
    pub(crate) fn calling(&self, body: &TokenStream) -> TokenStream {
        let (_, parameters) = self.names(&Plan::new(self.program));
        self.with_body(&parameters, body)
    }

    fn with_body(&self, parameters: &[TokenStream], body: &TokenStream) -> TokenStream {
        let (name, ty) = (self.name(), self.results_type());
        let mut lines = self.docs.to_vec();
        lines.extend([
            String::new(),
            format!("Operations: {}.", cost::count(self.program)),
        ]);
        let docs = docs(&lines);
        quote! {
            #docs
            #[inline(always)]
            pub fn #name<T: Real>(#(#parameters),*) -> #ty<T> { #body }
        }
    }

    /// The arguments with their variables.
    pub(crate) fn argument_names(&self) -> Vec<(String, Ident)> {
        let mut scope = Scope::default();
        let arguments = self.arguments().into_iter();
        arguments
            .map(|name| {
                let variable = scope.claim(&name);
                (name, variable)
            })
            .collect()
    }

    /// Names of everything, and the parameters of the function.
    fn names(&self, plan: &Plan) -> (Names<'_>, Vec<TokenStream>) {
        let program = self.program;
        let mut scope = Scope::default();
        let arguments: BTreeMap<String, Ident> = self
            .arguments()
            .into_iter()
            .map(|name| {
                let claimed = scope.claim(&name);
                (name, claimed)
            })
            .collect();
        let used = used_inputs(program, plan);
        let mut holding: BTreeMap<&str, (&Input, bool)> = BTreeMap::new();
        for (input, used) in program.inputs.iter().zip(used) {
            let (_, any) = holding
                .entry(self.argument(input))
                .or_insert((input, false));
            *any |= used;
        }
        let inputs = program
            .inputs
            .iter()
            .map(|input| match self.record(&input.name) {
                Some((record, rest)) => {
                    let (argument, field) = (&arguments[record.prefix], record.fields.get(rest));
                    quote!(#argument.#field)
                }
                None => {
                    let argument = &arguments[&input.name];
                    quote!(#argument)
                }
            });
        let inputs: Vec<TokenStream> = inputs.collect();
        let parameters = self
            .arguments()
            .iter()
            .map(|name| {
                let (input, used) = holding[name.as_str()];
                self.parameter(input, used, &arguments[name])
            })
            .collect();
        let mut variables = vec![None; program.instructions.len()];
        let labelled = plan
            .labels
            .iter()
            .map(|(id, label)| (*id, scope.claim(label)));
        for (id, variable) in labelled {
            variables[id.0 as usize] = Some(variable);
        }
        let packed = packs(program, plan);
        let mut next = 0;
        let temporaries = plan.steps.iter().flat_map(|step| &step.temporaries);
        for &id in temporaries.filter(|id| !packed.contains_key(id)) {
            variables[id.0 as usize].get_or_insert_with(|| match program.instruction(id).op {
                Op::Family(family, _) => scope.claim(&program.families[family.0 as usize].name),
                Op::Ldlt(matrix) if plan.labels.contains_key(&matrix) => {
                    scope.claim(&format!("{}_factors", plan.labels[&matrix]))
                }
                Op::TableFamily(family, _) => {
                    scope.claim(&program.table_families[family.0 as usize].name)
                }
                _ => scope.temporary(&mut next),
            });
        }
        let name = |id: ValueId| match program.instruction(id).op {
            Op::Input(position) => Some(program.inputs[position].name.clone()),
            _ => variables[id.0 as usize].as_ref().map(Ident::to_string),
        };
        let packs = packed
            .iter()
            .map(|(id, pack)| (*id, pack.variables(name, &mut scope)));
        let packs = packs.collect();
        let (polynomials, families, bases) = (
            self.tables.polynomial_paths(program),
            self.tables.family_names(program),
            self.tables.basis_paths(program),
        );
        (
            Names {
                program,
                inputs,
                variables,
                packs,
                polynomials,
                tables: &self.tables.tables,
                families,
                table_families: self.tables.tables.family_names(program),
                bases,
            },
            parameters,
        )
    }

    /// The parameter of an argument that holds `input` and perhaps others.
    fn parameter(&self, input: &Input, used: bool, argument: &Ident) -> TokenStream {
        let argument = if used {
            argument.clone()
        } else {
            format_ident!("_{argument}")
        };
        match self.record(&input.name) {
            Some((record, _)) => {
                let ty = ident(record.ty);
                let updated = self.updates.is_some_and(|to| to.argument == record.prefix);
                let mutable = updated.then(|| quote!(mut));
                quote!(#argument: &#mutable #ty<T>)
            }
            None => {
                let ty = type_of_shape(input.shape);
                quote!(#argument: #ty)
            }
        }
    }

    /// `let name = formula;`, with the type where the value is a literal array.
    pub(super) fn statement(&self, id: ValueId, names: &Names<'_>) -> TokenStream {
        let variable = &names.variables[id.0 as usize];
        let instruction = self.program.instruction(id);
        if let (Op::Const(data), Type::Real(shape @ (Shape::Vector(_) | Shape::Matrix(..)))) =
            (&instruction.op, instruction.ty)
        {
            let (ty, value) = (type_of_shape(shape), literal_array(shape, data));
            return quote!(let #variable: #ty = #value;);
        }
        let formula = names.formula(id).tokens;
        match names.packs.get(&id) {
            Some(entries) => quote!(let [#(#entries),*] = #formula.0;),
            None => quote!(let #variable = #formula;),
        }
    }

    pub(super) fn origin(&self, id: ValueId) -> Option<&Origin> {
        self.program
            .origins
            .get(self.program.instruction(id).origin?)
    }

    fn result(&self, names: &Names<'_>) -> TokenStream {
        let ty = self.results_type();
        let own = self.output_fields();
        let returned = self
            .program
            .outputs
            .iter()
            .filter(|(name, _)| self.updated(name).is_none());
        let early = self.returned_early(names);
        let fields = returned.map(|(name, id)| {
            let value = match early.get(id) {
                Some(variable) => quote!(#variable),
                None => names.operand(*id).tokens,
            };
            assigned(own.get(name), &value)
        });
        quote!(#ty { #(#fields),* })
    }

    fn outputs_struct(&self) -> TokenStream {
        let (ty, own) = (self.results_type(), self.output_fields());
        let returned = self
            .program
            .outputs
            .iter()
            .filter(|(name, _)| self.updated(name).is_none());
        let fields = returned.map(|(name, id)| {
            let (field, ty) = (own.get(name), type_of(self.program.ty(*id)));
            let docs = docs(&[self.output_doc(name, *id)]);
            quote!(#docs pub #field: #ty)
        });
        let docs = docs(&[format!("Results of [`{}`].", self.name())]);
        quote!(#docs #[derive(Clone, Copy, Debug)] pub struct #ty<T: Real> { #(#fields),* })
    }

    /// The equation of an output, or its name.
    pub(crate) fn output_doc(&self, name: &str, id: ValueId) -> String {
        match self.origin(id) {
            Some(origin) if !origin.equation.is_empty() => code(&origin.equation),
            _ => quantity::output(name),
        }
    }
}

/// `field: value`, or `field` where both are one name.
fn assigned(field: &Ident, value: &TokenStream) -> TokenStream {
    if *field == value.to_string() {
        quote!(#field)
    } else {
        quote!(#field: #value)
    }
}

/// Whether each input is used.
fn used_inputs(program: &Program, plan: &Plan) -> Vec<bool> {
    let mut used = vec![false; program.inputs.len()];
    for (instruction, live) in program.instructions.iter().zip(&plan.live) {
        if let Op::Input(position) = instruction.op {
            used[position] |= live;
        }
    }
    used
}

#[cfg(test)]
mod tests {
    use crate::emit::standalone;
    use crate::ir::Program;

    #[test]
    fn factors_of_a_matrix_are_named_after_it() {
        let program: Program = "program mass
input q: vec4
origin \"plant\" \"\"
%0: vec4 = input q
%1: mat4x4 = outer %0, %0
%2 M: mat4x4 = add %1, %1 @0
%3: ldlt4 = ldlt %2
%4: vec4 = solve %3, %0
%5: vec4 = sin %4
%6: mat4x4 = solve %3, %1
%7: vec4 = matmul %6, %5
output x = %7
"
        .parse()
        .expect("a readable program");
        program.assert_sound();
        insta::assert_snapshot!(standalone(&program));
    }
}
