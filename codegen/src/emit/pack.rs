//! Calls of one function on an array of arguments, of which each value gets a name: `let [sin_alpha, sin_mu] = ..`.

use std::collections::BTreeMap;

use proc_macro2::TokenStream;
use quote::quote;

use crate::emit::methods::function_name;
use crate::emit::names::Scope;
use crate::emit::plan::Plan;
use crate::ir::{Function, Op, Program, Shape, Type, ValueId};

/// A call on an array of which nothing but single values is used.
pub(crate) struct Pack<'p> {
    function: Function,
    arguments: &'p [ValueId],
    /// Whether each value is used.
    used: Vec<bool>,
}

/// The calls on arrays of which nothing but single values is used.
pub(crate) fn packs<'p>(program: &'p Program, plan: &Plan) -> BTreeMap<ValueId, Pack<'p>> {
    let mut packs = BTreeMap::new();
    let live = (0..)
        .map(ValueId)
        .zip(&program.instructions)
        .zip(&plan.live);
    for ((id, instruction), _) in live.filter(|(_, live)| **live) {
        if let Op::Apply(function, array) = instruction.op
            && let Op::Array(arguments) = &program.instruction(array).op
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

impl Pack<'_> {
    /// The variables of the values, named after the variables of their arguments; `_` for those that nothing uses.
    pub(crate) fn variables(
        &self,
        names: impl Fn(ValueId) -> Option<String>,
        scope: &mut Scope,
    ) -> Vec<TokenStream> {
        let function = function_name(self.function);
        let variable = |(&argument, &used): (&ValueId, &bool)| {
            if !used {
                return quote!(_);
            }
            let variable = match names(argument) {
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
