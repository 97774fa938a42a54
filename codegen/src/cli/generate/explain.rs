//! `nsv generate --explain-cost`: the operations of each program, pass by pass and equation by equation, as a table or as JSON.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use nsv_codegen::lower::Programs;
use nsv_codegen::opt::cost::Cost;
use nsv_codegen::opt::explain::{EquationCost, Explanation, explain};
use nsv_spec::diagnostic::FileId;
use nsv_spec::model::Model;
use serde_json::{Value, json};

use super::origin::{Origin, origin};
use crate::cli::compile::Math;

/// Every program explained, in the order in which they are emitted.
pub(super) fn explanations(programs: &Programs, math: Math) -> Vec<Explanation> {
    let all = [
        &programs.control,
        &programs.plant,
        &programs.initial,
        &programs.lyapunov,
        &programs.quantities,
    ];
    all.map(|program| explain(program, math.into())).into()
}

/// The line of the specification that a quantity comes from, `file:line`.
fn place(model: &Model, equation: &EquationCost) -> Option<String> {
    let Origin { span, .. } = origin(model, &equation.quantity)?;
    let (line, _) = model.sources.location(span);
    Some(format!("{}:{line}", model.sources.source(span.file).name))
}

/// The explanations as JSON.
pub(super) fn document(model: &Model, math: Math, explanations: &[Explanation]) -> Value {
    let programs = explanations.iter().map(|explanation| {
        let passes = explanation.passes.iter().map(|pass| {
            json!({
                "pass": pass.name,
                "round": pass.round,
                "instructions": pass.instructions,
                "operations": counts(pass.cost),
            })
        });
        let equations = explanation.equations.iter().map(|equation| {
            json!({
                "quantity": equation.quantity,
                "group": equation.group,
                "equation": equation.equation,
                "spec": place(model, equation),
                "before": counts(equation.before),
                "after": counts(equation.after),
            })
        });
        json!({
            "program": explanation.program,
            "lowered": counts(explanation.lowered),
            "passes": passes.collect::<Vec<_>>(),
            "optimised": counts(explanation.optimised()),
            "equations": equations.collect::<Vec<_>>(),
        })
    });
    let math = if math == Math::Fast { "fast" } else { "strict" };
    json!({ "spec": model.name, "math": math, "programs": programs.collect::<Vec<_>>() })
}

fn counts(cost: Cost) -> Value {
    cost.columns()
        .map(|(name, count)| (name.to_owned(), count.into()))
        .into_iter()
        .collect::<serde_json::Map<String, Value>>()
        .into()
}

/// The explanations as text.
pub(super) fn table(model: &Model, explanations: &[Explanation]) -> String {
    let mut text = format!("{LEGEND}\n");
    for explanation in explanations {
        let _ = writeln!(text, "program {}", explanation.program);
        passes(&mut text, explanation);
        equations(&mut text, model, explanation);
        lines(&mut text, model, explanation);
        text.push('\n');
    }
    text
}

const LEGEND: &str = "Operations on numbers, those of arrays counted entry by entry: add also subtracts, a fused multiply-add is an add \
and a mul, call is an elementary function, select a comparison or a choice. `a > b`: a before the optimiser, b after it, `-` none. \
Numbers in round brackets are those of the equations in the paper, behind a pass its round.\n";

/// Width of a count, and of a pair of counts.
const COUNT: usize = 7;
const PAIR: usize = 12;

fn passes(text: &mut String, explanation: &Explanation) {
    let _ = write!(text, "  {:<28}", "after pass (round)");
    for (name, _) in explanation.lowered.columns() {
        let _ = write!(text, "{name:>COUNT$}");
    }
    let rows = explanation
        .passes
        .iter()
        .map(|pass| (format!("{} ({})", pass.name, pass.round), pass.cost));
    for (name, cost) in std::iter::once(("lowered".to_owned(), explanation.lowered)).chain(rows) {
        let _ = write!(text, "\n  {name:<28}");
        for (_, count) in cost.columns() {
            let _ = write!(text, "{count:>COUNT$}");
        }
    }
    text.push('\n');
}

/// The equations of one heading, in which something is computed.
fn equations(text: &mut String, model: &Model, explanation: &Explanation) {
    let mut group = None;
    for equation in &explanation.equations {
        if equation.before == Cost::default() && equation.after == Cost::default() {
            continue;
        }
        if group != Some(&equation.group) {
            group = Some(&equation.group);
            let group = match equation.group.as_str() {
                "" => "values without equation",
                group => group,
            };
            heading(text, group, equation.before);
        }
        row(text, model, equation);
    }
}

fn heading(text: &mut String, words: &str, columns: Cost) {
    let _ = write!(text, "\n  {words:<54}");
    for (name, _) in columns.columns() {
        let _ = write!(text, "{name:>PAIR$}");
    }
    text.push('\n');
}

/// `quantity  file:line  before>after ..`, and the equation below.
fn row(text: &mut String, model: &Model, equation: &EquationCost) {
    let place = place(model, equation).unwrap_or_default();
    let _ = write!(text, "    {:<16} {place:<35}", equation.quantity);
    cells(text, equation.before, equation.after);
    if !equation.equation.is_empty() {
        let _ = writeln!(text, "        {}", equation.equation);
    }
}

/// What each line of the specification costs: the sum over the quantities that come from it.
fn lines(text: &mut String, model: &Model, explanation: &Explanation) {
    let mut sums: BTreeMap<(FileId, usize, String), (Cost, Cost)> = BTreeMap::new();
    for equation in &explanation.equations {
        if let Some(Origin { span, what }) = origin(model, &equation.quantity) {
            let (line, _) = model.sources.location(span);
            let (before, after) = sums.entry((span.file, line, what)).or_default();
            *before = *before + equation.before;
            *after = *after + equation.after;
        }
    }
    sums.retain(|_, costs| *costs != Default::default());
    if sums.is_empty() {
        return;
    }
    heading(text, "by line of the specification", explanation.lowered);
    for ((file, line, what), (before, after)) in sums {
        let place = format!("{}:{line}", model.sources.source(file).name);
        let _ = write!(text, "    {what:<20} {place:<31}");
        cells(text, before, after);
    }
}

/// `before > after` for each kind of operation.
fn cells(text: &mut String, before: Cost, after: Cost) {
    for ((_, before), (_, after)) in before.columns().iter().zip(after.columns()) {
        let cell = match (*before, after) {
            (0, 0) => "-".to_owned(),
            (before, after) if before == after => after.to_string(),
            (before, after) => format!("{before} > {after}"),
        };
        let _ = write!(text, "{cell:>PAIR$}");
    }
    text.push('\n');
}
