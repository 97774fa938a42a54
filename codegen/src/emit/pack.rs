//! Calls of one function on an array of arguments, of which each value gets a name: `let [sin_alpha, sin_mu] = ..`.

use std::collections::BTreeMap;

use proc_macro2::TokenStream;
use quote::quote;

use crate::emit::methods::function_name;
use crate::emit::names::{Scope, snake};
use crate::emit::plan::Plan;
use crate::ir::{Function, Op, Program, Shape, Type, ValueId};

/// A call on an array of which nothing but single values is used.
pub(crate) struct Pack {
    function: Function,
    arguments: Vec<Argument>,
    /// Whether each value is used.
    used: Vec<bool>,
}

/// What a call on an array is given.
enum Argument {
    /// A value.
    Value(ValueId),
    /// An entry of an input that has no name of its own.
    Entry(String),
}

/// The calls on arrays of which nothing but single values is used.
pub(crate) fn packs(program: &Program, plan: &Plan) -> BTreeMap<ValueId, Pack> {
    let mut packs = BTreeMap::new();
    let named = named_entries(program, plan);
    let live = (0..)
        .map(ValueId)
        .zip(&program.instructions)
        .zip(&plan.live);
    for ((id, instruction), _) in live.filter(|(_, live)| **live) {
        if let Op::Apply(function, array) = instruction.op
            && let Some(arguments) = arguments(program, array, &named)
            && function != Function::Neg
            && matches!(instruction.ty, Type::Real(Shape::Vector(_)))
            && !plan.labels.contains_key(&id)
        {
            let used = vec![false; arguments.len()];
            packs.insert(
                id,
                Pack {
                    function,
                    arguments,
                    used,
                },
            );
        }
        match instruction.op {
            Op::Element(values, row, 0) => {
                if let Some(pack) = packs.get_mut(&values) {
                    pack.used[row] = true;
                }
            }
            ref op => op.operands().iter().for_each(|operand| {
                packs.remove(operand);
            }),
        }
    }
    for (_, output) in &program.outputs {
        packs.remove(output);
    }
    packs
}

/// The named entries of inputs, by array and row.
fn named_entries(program: &Program, plan: &Plan) -> BTreeMap<(ValueId, usize), ValueId> {
    let labelled = plan.labels.keys();
    let entries = labelled.filter_map(|&id| match program.instruction(id).op {
        Op::Element(array, row, 0) if matches!(program.instruction(array).op, Op::Input(_)) => {
            Some(((array, row), id))
        }
        _ => None,
    });
    entries.collect()
}

/// The entries of an array that is made of them, or of an input.
fn arguments(
    program: &Program,
    array: ValueId,
    named: &BTreeMap<(ValueId, usize), ValueId>,
) -> Option<Vec<Argument>> {
    match (&program.instruction(array).op, program.shape(array)) {
        (Op::Array(arguments), _) => Some(arguments.iter().copied().map(Argument::Value).collect()),
        (Op::Input(at), Shape::Vector(n)) => {
            let input = snake(&program.inputs[*at].name);
            let entry = |row: usize| match named.get(&(array, row)) {
                Some(&id) => Argument::Value(id),
                None => Argument::Entry(format!("{input}_{row}")),
            };
            Some((0..n).map(entry).collect())
        }
        _ => None,
    }
}

impl Pack {
    /// The variables of the values, named after the variables of their arguments; `_` for those that nothing uses.
    pub(crate) fn variables(
        &self,
        names: impl Fn(ValueId) -> Option<String>,
        scope: &mut Scope,
    ) -> Vec<TokenStream> {
        let function = function_name(self.function, false);
        let variable = |(argument, &used): (&Argument, &bool)| {
            if !used {
                return quote!(_);
            }
            let name = match argument {
                Argument::Value(id) => names(*id),
                Argument::Entry(name) => Some(name.clone()),
            };
            let variable = match name {
                Some(name) => scope.claim(&format!("{function}_{name}")),
                None => scope.claim(function),
            };
            quote!(#variable)
        };
        self.arguments
            .iter()
            .zip(&self.used)
            .map(variable)
            .collect()
    }
}
