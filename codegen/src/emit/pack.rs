//! Calls of one function on an array of arguments, of which each value gets a name: `let [sin_alpha, sin_mu] = ..`.

use std::collections::BTreeMap;

use proc_macro2::Ident;

use crate::emit::methods::function_name;
use crate::emit::names::Scope;
use crate::emit::plan::Plan;
use crate::ir::{Op, Program, ValueId};

/// The names of the values of each pack.
pub(crate) type Packs = BTreeMap<ValueId, Vec<Ident>>;

/// Names the values of calls on arrays.
pub(crate) fn named(
    program: &Program,
    packed: &BTreeMap<ValueId, &[ValueId]>,
    names: impl Fn(ValueId) -> Option<String>,
    scope: &mut Scope,
) -> Packs {
    let mut packs = Packs::new();
    for (&id, arguments) in packed {
        let Op::Apply(function, _) = program.instruction(id).op else {
            continue;
        };
        let function = function_name(function);
        let entries = arguments.iter().map(|&argument| match names(argument) {
            Some(name) => scope.claim(&format!("{function}_{name}")),
            None => scope.claim(function),
        });
        packs.insert(id, entries.collect());
    }
    packs
}

/// Calls on arrays with their arguments, of which no other value than single entries is used.
pub(crate) fn packed<'p>(program: &'p Program, plan: &Plan) -> BTreeMap<ValueId, &'p [ValueId]> {
    let mut found = BTreeMap::new();
    let live = (0..)
        .map(ValueId)
        .zip(&program.instructions)
        .zip(&plan.live);
    for ((id, instruction), _) in live.filter(|(_, live)| **live) {
        if let Op::Apply(_, array) = instruction.op
            && let Op::Array(arguments) = &program.instruction(array).op
            && !plan.labels.contains_key(&id)
        {
            found.insert(id, arguments.as_slice());
        }
        if !matches!(instruction.op, Op::Element(..)) {
            for operand in instruction.op.operands() {
                found.remove(&operand);
            }
        }
    }
    for (_, output) in &program.outputs {
        found.remove(output);
    }
    found
}
