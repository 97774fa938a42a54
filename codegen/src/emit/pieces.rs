//! A program as functions that can be called as often as each needs: once for a run, once for a sample, once for a sample of each run; and
//! one function that calls them all.

use std::collections::BTreeSet;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::emit::comment::{Comments, code};
use crate::emit::function::{Function, Record, Results};
use crate::emit::names::{Fields, Scope, ident, snake};
use crate::emit::record::{self, Field};
use crate::ir::{Program, ValueId};
use crate::opt::hoist::{Pieces, hoist};

/// The function of a program in pieces.
pub(crate) struct Split<'a> {
    whole: &'a Function<'a>,
    pieces: Pieces,
    shared: bool,
}

const PREPARE: &str =
    "What depends on the parameters alone: needed once for a run. See [`Prepared`].";
const CLOCK: &str = "What depends on time and parameters alone: needed once for a sample of all runs with these parameters. See [`Clock`].";

impl<'a> Split<'a> {
    /// Splits the law, whose parameters are those of the design in every run.
    pub(crate) fn law(whole: &'a Function<'a>) -> Split<'a> {
        Self::new(whole, "law", &["t", "params"])
    }

    /// Splits the plant, whose parameters can differ from run to run.
    pub(crate) fn dynamics(whole: &'a Function<'a>) -> Split<'a> {
        Self::new(whole, "dynamics", &["t"])
    }

    /// Splits a function; the piece that gives its results is called `rest`, and `common` are the inputs that all runs have in common.
    fn new(whole: &'a Function<'a>, rest: &str, common: &[&str]) -> Split<'a> {
        let mut pieces = hoist(whole.program);
        pieces.rest.name = rest.to_owned();
        let shared = pieces.clock.as_ref().is_some_and(|clock| {
            let mut inputs = clock.inputs.iter();
            inputs.all(|input| common.contains(&record_of(&input.name)))
        });
        Split {
            whole,
            pieces,
            shared,
        }
    }

    /// The piece of what depends on parameters alone.
    pub(crate) fn prepare(&self) -> Option<&Program> {
        self.pieces.prepare.as_ref()
    }

    /// The piece of what depends on time and parameters alone.
    pub(crate) fn clock(&self) -> Option<&Program> {
        self.pieces.clock.as_ref()
    }

    /// Whether all runs have the same clock, which then implements `OfTime`.
    pub(crate) fn shares_clock(&self) -> bool {
        self.shared
    }

    /// The piece that gives the results: the whole if there is no other.
    pub(crate) fn rest(&self) -> &Program {
        if self.is_whole() {
            self.whole.program
        } else {
            &self.pieces.rest
        }
    }

    fn is_whole(&self) -> bool {
        self.pieces.prepare.is_none() && self.pieces.clock.is_none()
    }

    /// The pieces with their structs, and the function that calls them; the function alone if it has no pieces.
    pub(crate) fn items(&self, comments: &mut Comments) -> Vec<TokenStream> {
        let Pieces {
            prepare,
            clock,
            rest,
        } = &self.pieces;
        if self.is_whole() {
            return self.whole.items(comments);
        }
        let (prepared, at) = (fields(prepare), fields(clock));
        let records = self.records(&prepared, &at);
        let own = self.whole.output_fields();
        let results = self.whole.results_type().to_string();
        let mut items = Vec::new();
        let mut calls = Vec::new();
        let arguments = self.whole.argument_names();
        let mut add =
            |items: &mut Vec<TokenStream>, program: &Program, docs: &[String], results| {
                let function = Function {
                    program,
                    docs,
                    records: &records,
                    results,
                    tables: self.whole.tables,
                    updates: self.whole.updates,
                };
                calls.push(call(&function, &arguments));
                items.extend(function.function(comments));
            };
        if let Some(prepare) = prepare {
            items.push(definition(
                prepare,
                "Prepared",
                "Values of [`prepare`].",
                &prepared,
            ));
            let results = Results::Existing("Prepared", &prepared);
            add(&mut items, prepare, &[PREPARE.to_owned()], results);
        }
        if let Some(clock) = clock {
            items.push(definition(clock, "Clock", "Values of [`clock`].", &at));
            if self.shared {
                items.push(of_time(clock, &at));
            }
            add(
                &mut items,
                clock,
                &[CLOCK.to_owned()],
                Results::Existing("Clock", &at),
            );
        }
        items.extend(self.whole.own_results());
        let existing = Results::Existing(&results, &own);
        add(&mut items, rest, self.whole.docs, existing);
        items.push(self.whole.calling(&self.body(&calls)));
        items
    }

    /// The records of the whole and of the values of its pieces.
    fn records<'r>(&'r self, prepared: &'r Fields, clock: &'r Fields) -> Vec<Record<'r>> {
        let record = |prefix, ty, fields| Record { prefix, ty, fields };
        let mut records = self.whole.records.to_vec();
        records.extend([
            record("prepared", "Prepared", prepared),
            record("clock", "Clock", clock),
        ]);
        records
    }

    /// The function of a part of `rest`, from the values of the other pieces.
    pub(crate) fn part(
        &self,
        program: &Program,
        docs: &[String],
        comments: &mut Comments,
    ) -> Vec<TokenStream> {
        let (prepared, clock) = (fields(&self.pieces.prepare), fields(&self.pieces.clock));
        let function = Function {
            program,
            docs,
            records: &self.records(&prepared, &clock),
            results: Results::Own,
            tables: self.whole.tables,
            updates: None,
        };
        function.items(comments)
    }

    /// Calls of the pieces one after another.
    fn body(&self, calls: &[TokenStream]) -> TokenStream {
        let mut calls = calls.iter();
        let mut bind = |piece: &Option<Program>, name: &str| {
            let name = ident(name);
            piece.as_ref().map(|_| {
                let call = calls.next();
                quote!(let #name = #call;)
            })
        };
        let prepared = bind(&self.pieces.prepare, "prepared");
        let clock = bind(&self.pieces.clock, "clock");
        let rest = calls.next();
        quote!(#prepared #clock #rest)
    }
}

/// A call of a piece where the arguments of the whole are variables.
fn call(piece: &Function<'_>, arguments: &[(String, Ident)]) -> TokenStream {
    let name = piece.name();
    let variable = |argument: String| {
        let of_whole = arguments.iter().find(|(known, _)| *known == argument);
        match of_whole {
            Some((_, variable)) => quote!(#variable),
            None => {
                let variable = ident(&argument);
                quote!(&#variable)
            }
        }
    };
    let arguments = piece.arguments().into_iter().map(variable);
    quote!(#name(#(#arguments),*))
}

/// The fields of a piece's results.
fn fields(piece: &Option<Program>) -> Fields {
    let outputs = piece.iter().flat_map(|piece| &piece.outputs);
    Fields::new(outputs.map(|(name, _)| name.as_str()))
}

fn definition(piece: &Program, ty: &str, about: &str, fields: &Fields) -> TokenStream {
    record::definition(ty, &[about.to_owned()], &record_fields(piece, fields))
}

/// A call of a piece where each argument, an input or the record of inputs, is `value` of its name.
pub(crate) fn call_with(program: &Program, value: impl Fn(&str) -> TokenStream) -> TokenStream {
    let mut known = BTreeSet::new();
    let names = program.inputs.iter().map(|input| record_of(&input.name));
    let arguments = names.filter(|name| known.insert(*name)).map(value);
    let name = Scope::default().claim(&snake(&program.name));
    quote!(#name(#(#arguments),*))
}

/// The record that an input is part of, or the input itself.
fn record_of(input: &str) -> &str {
    input.split_once('.').map_or(input, |(record, _)| record)
}

fn record_fields(piece: &Program, fields: &Fields) -> Vec<Field> {
    let field = |(name, id): &(String, ValueId)| Field {
        name: fields.get(name).clone(),
        shape: piece.shape(*id),
        docs: vec![field_doc(piece, name, *id)],
    };
    piece.outputs.iter().map(field).collect()
}

/// A clock that all runs have in common as values for several times at once.
fn of_time(clock: &Program, fields: &Fields) -> TokenStream {
    let call = call_with(clock, |argument| match argument {
        "t" => quote!(t),
        _ => quote!(&Params::design()),
    });
    let lane = record::literal(&quote!(Self), &record_fields(clock, fields), |field| {
        let name = &field.name;
        quote!(self.#name.in_every_lane(lane))
    });
    quote! {
        impl<T: Real> OfTime<T> for Clock<T> {
            #[inline(always)]
            fn at(t: T) -> Self { #call }

            #[inline(always)]
            fn of_lane(&self, lane: usize) -> Self { #lane }
        }
    }
}

/// The equation of a value, or the quantity that it is a part of.
fn field_doc(piece: &Program, name: &str, id: ValueId) -> String {
    let instruction = piece.instruction(id);
    let origin = instruction
        .origin
        .and_then(|origin| piece.origins.get(origin));
    match origin {
        Some(origin) if !origin.equation.is_empty() => code(&origin.equation),
        _ if instruction.name.is_some() => format!("{}.", code(name)),
        _ => {
            let quantity = name.trim_end_matches(|c: char| c.is_ascii_digit());
            format!("Part of {}.", code(quantity.trim_end_matches('_')))
        }
    }
}
