//! Guarantees that arguments of functions hide no other name, and warns of those that their function does not use.

use std::collections::BTreeMap;

use super::Context;
use super::names::Use;
use crate::diagnostic::{Applicability, Diagnostic, Rule, SourceMap, Span, a};
use crate::spec::{Function, Named, Word};

/// Longest text that a renaming replaces, bytes.
const LONGEST: u32 = 500;

impl Context<'_> {
    /// Arguments of functions: none twice, and none that hides another name.
    pub(super) fn check_arguments(&mut self, declared: &BTreeMap<String, (Span, &str)>) {
        let spec = self.spec;
        for function in &spec.functions {
            let Ok(arguments) = &function.value.arguments else {
                continue;
            };
            self.declare(
                &mut BTreeMap::new(),
                arguments.iter(),
                "argument",
                Use::Label,
            );
            for name in arguments {
                let Some((span, noun)) = declared.get(&name.value) else {
                    continue;
                };
                let message = format!("argument `{}` has the name of {}", name.value, a(noun));
                let fault = Diagnostic::error(Rule::E0113, name.span, message)
                    .with_related(*span, format!("the {noun} is declared here"));
                let fresh = fresh_name(&name.value, function, declared);
                let help = "give the argument another name, here and in `value`";
                let change = fresh.as_ref().and_then(|fresh| {
                    let change = renamed(self.sources, &function.value, name, fresh)?;
                    Some((format!("{help}, such as `{fresh}`"), change))
                });
                self.faults.push(match change {
                    Some((help, (span, text))) => {
                        fault
                            .with_help(help)
                            .with_suggestion(span, text, Applicability::Possible)
                    }
                    None => fault.with_help(help),
                });
            }
        }
    }

    /// Warns of arguments that do nothing: a call would give them a value in vain.
    pub(super) fn warn_of_unused_arguments(&mut self) {
        let spec = self.spec;
        for Named { name, value } in &spec.functions {
            let Some(body) = value.value.parsed() else {
                continue;
            };
            let used = body.free_names();
            for argument in value.arguments.iter().flatten() {
                if used.iter().any(|(used, _)| *used == argument.value) {
                    continue;
                }
                let message = format!(
                    "argument `{}` of function `{}` is never used",
                    argument.value, name.value
                );
                let warning = Diagnostic::warning(Rule::W0003, argument.span, message)
                    .with_related(value.value.base.span, "the value does not depend on it");
                self.warnings.push(warning.with_help(
                    "use it in `value`, or remove it here and wherever the function is called",
                ));
            }
        }
    }
}

/// A name like another one that nothing has yet.
fn fresh_name(
    name: &str,
    function: &Named<Function>,
    declared: &BTreeMap<String, (Span, &str)>,
) -> Option<String> {
    let taken = |name: &String| {
        let mut arguments = function.value.arguments.iter().flatten();
        declared.contains_key(name) || arguments.any(|argument| argument.value == *name)
    };
    ["in", "arg", "given", "value"]
        .into_iter()
        .map(|suffix| format!("{name}_{suffix}"))
        .find(|fresh| !taken(fresh))
}

/// The text from the first to the last place where a function has the name of an argument, with another name in each of them;
/// `None` if the file does not hold it as it is read.
fn renamed(
    sources: &SourceMap,
    function: &Function,
    argument: &Word,
    fresh: &str,
) -> Option<(Span, String)> {
    let code = &function.value;
    let body = code.parsed()?;
    let uses = body.free_names().into_iter();
    let uses = uses.filter(|(name, _)| *name == argument.value);
    let mut places: Vec<Span> = uses.map(|(_, span)| span).collect();
    places.push(argument.span);
    places.sort();
    let (first, last) = (places.first()?, places.last()?);
    let text = &sources.source(first.file).text;
    let held = |place: &Span| {
        let held = text.get(place.start as usize..place.end as usize);
        place.file == first.file && held == Some(&argument.value)
    };
    let length = last.end.saturating_sub(first.start);
    if !places.iter().all(held) || length > LONGEST {
        return None;
    }
    let mut replacement = String::new();
    let mut at = first.start;
    for place in &places {
        replacement.push_str(text.get(at as usize..place.start as usize)?);
        replacement.push_str(fresh);
        at = place.end;
    }
    let whole = Span {
        end: last.end,
        ..*first
    };
    Some((whole, replacement))
}
