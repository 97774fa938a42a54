//! The statements of a function: values in the order of the plan under the headings of their groups, and states that are replaced in place.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::emit::comment::Comments;
use crate::emit::expression::Names;
use crate::emit::function::{Function, Updates};
use crate::emit::names::ident;
use crate::emit::plan::{Plan, Step};
use crate::ir::{Op, ValueId};

/// An output that replaces a field of an argument.
pub(super) struct Update {
    /// The field.
    place: TokenStream,
    /// Name of the new value where it has to be known before other fields are replaced and has none.
    variable: Ident,
    value: ValueId,
    /// Whether its formula is written where the field is replaced, since nothing else uses it.
    in_place: bool,
    /// Whether it has to be read before other fields are replaced.
    before: bool,
}

/// The values that are written where they replace a field.
pub(super) fn in_place(updates: &[Update]) -> impl Iterator<Item = ValueId> {
    let in_place = updates.iter().filter(|update| update.in_place);
    in_place.map(|update| update.value)
}

/// Statements under the headings of their groups and the notes of their equations.
pub(super) struct Statements<'f> {
    function: &'f Function<'f>,
    pub(super) written: Vec<TokenStream>,
    group: &'f str,
    equation: &'f str,
}

impl<'f> Statements<'f> {
    pub(super) fn of(function: &'f Function<'f>) -> Self {
        Statements {
            function,
            written: Vec::new(),
            group: "",
            equation: "",
        }
    }

    /// The heading of a value's group, where another group begins.
    fn heading(&mut self, id: ValueId, comments: &mut Comments) {
        let group = self.function.origin(id).map_or("", |origin| &origin.group);
        if !group.is_empty() && group != self.group {
            self.written.push(comments.heading(group));
        }
        self.group = group;
    }

    /// The equation of a value, unless it was that of the value before.
    fn note(&mut self, id: ValueId, comments: &mut Comments) {
        let equation = self
            .function
            .origin(id)
            .map_or("", |origin| &origin.equation);
        if !equation.is_empty() && equation != self.equation {
            self.written.push(comments.note(equation));
        }
        self.equation = equation;
    }

    /// Temporaries and values of some steps. Those that `updates` write in place have temporaries alone.
    pub(super) fn add_steps(
        &mut self,
        steps: &[Step],
        names: &Names<'_>,
        updates: &[Update],
        comments: &mut Comments,
    ) {
        let in_place: BTreeSet<ValueId> = in_place(updates).collect();
        let function = self.function;
        for step in steps {
            let temporaries = step.temporaries.iter();
            let temporaries = temporaries.map(|&id| function.statement(id, names));
            let in_place = in_place.contains(&step.value);
            if !in_place || !step.temporaries.is_empty() {
                self.heading(step.value, comments);
            }
            self.written.extend(temporaries);
            if in_place {
                continue;
            }
            self.note(step.value, comments);
            self.written.push(function.statement(step.value, names));
        }
    }

    /// The updates, after what is read from the fields that they replace: no value is read after it was replaced.
    pub(super) fn add_updates(
        &mut self,
        names: &Names<'_>,
        updates: &[Update],
        comments: &mut Comments,
    ) {
        let late = updates.iter().filter(|update| update.before);
        let late = late.map(|update| (&update.variable, update.value));
        let returned = self.function.returned_early(names);
        let late = late.chain(returned.iter().map(|(id, variable)| (variable, *id)));
        self.written.extend(late.map(|(variable, value)| {
            let value = names.operand(value).tokens;
            quote!(let #variable = #value;)
        }));
        for update in updates {
            let place = &update.place;
            if update.in_place {
                self.heading(update.value, comments);
                self.note(update.value, comments);
                self.written.push(names.replacement(place, update.value));
            } else if update.before {
                let variable = &update.variable;
                self.written.push(quote!(#place = #variable;));
            } else {
                let value = names.operand(update.value).tokens;
                self.written.push(quote!(#place = #value;));
            }
        }
    }
}

impl Function<'_> {
    /// The updates, in the order of the plan.
    pub(super) fn update_list(&self, plan: &Plan, names: &Names<'_>) -> Vec<Update> {
        let mut uses = vec![0usize; self.program.instructions.len()];
        for (instruction, _) in self
            .program
            .instructions
            .iter()
            .zip(&plan.live)
            .filter(|(_, live)| **live)
        {
            for operand in instruction.op.operands() {
                uses[operand.0 as usize] += 1;
            }
        }
        for (_, id) in &self.program.outputs {
            uses[id.0 as usize] += 1;
        }
        let order: BTreeMap<ValueId, usize> =
            plan.steps.iter().map(|step| step.value).zip(0..).collect();
        let mut updates: Vec<Update> = self
            .program
            .outputs
            .iter()
            .filter_map(|(name, id)| Some((self.updated(name)?, *id)))
            .filter_map(|(field, id)| self.update(&field, id, uses[id.0 as usize], names))
            .collect();
        updates.sort_by_key(|update| order.get(&update.value));
        updates
    }

    /// How a field gets its new value; `None` if it keeps its own.
    fn update(&self, field: &str, id: ValueId, uses: usize, names: &Names<'_>) -> Option<Update> {
        let (_, name) = field.split_once('.')?;
        if matches!(self.program.instruction(id).op, Op::Input(at) if self.program.inputs[at].name == field)
        {
            return None;
        }
        let (record, name) = self.record(field).map(|(record, _)| (record, name))?;
        let argument = ident(record.prefix);
        let target = record.fields.get(name);
        let reads_others = self.reads(id, names).iter().any(|read| *read != field);
        let bound = names.variables[id.0 as usize].is_some();
        Some(Update {
            place: quote!(#argument.#target),
            variable: format_ident!("new_{}", target),
            value: id,
            in_place: bound && uses == 1 && !reads_others,
            before: !bound && reads_others,
        })
    }

    /// Results that are read from fields which are replaced, with the variables that hold them.
    pub(super) fn returned_early(&self, names: &Names<'_>) -> BTreeMap<ValueId, Ident> {
        let returned = self.program.outputs.iter();
        returned
            .filter(|(name, id)| {
                let bound = names.variables[id.0 as usize].is_some();
                self.updated(name).is_none() && !bound && !self.reads(*id, names).is_empty()
            })
            .map(|(name, id)| (*id, format_ident!("old_{}", ident(name))))
            .collect()
    }

    /// The fields of the updated argument that a value's own formula reads.
    fn reads(&self, id: ValueId, names: &Names<'_>) -> BTreeSet<&str> {
        let mut read = BTreeSet::new();
        let Some(Updates {
            argument: prefix, ..
        }) = self.updates
        else {
            return read;
        };
        let mut pending = vec![id];
        while let Some(value) = pending.pop() {
            if value != id && names.variables[value.0 as usize].is_some() {
                continue;
            }
            match self.program.instruction(value).op {
                Op::Input(at) => {
                    let name = self.program.inputs[at].name.as_str();
                    if name.split_once('.').is_some_and(|(of, _)| of == prefix) {
                        read.insert(name);
                    }
                }
                ref op => pending.extend(op.operands()),
            }
        }
        read
    }
}
