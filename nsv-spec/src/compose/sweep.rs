//! `scenario.sweep`: the same specification with several values.

use super::path::{keys, set};
use super::setting;
use crate::diagnostic::{Diagnostic, Rule, SourceMap, Span, counted};
use crate::yaml::{Entry, Key, Kind, Node, excerpt};

/// Most combinations. Each is compiled and flown.
pub const MAX_VARIANTS: usize = 100;
/// Most keys whose numbers of values a message shows, and the number of combinations from which on it tells none.
const SHOWN: usize = 6;
const COUNTABLE: usize = 1_000_000;

/// One key with its values.
#[derive(Clone, Debug)]
struct Axis {
    path: Vec<Key>,
    name: String,
    place: Span,
    values: Vec<Node>,
}

/// The keys that are swept, in the order of the specification.
#[derive(Clone, Debug, Default)]
pub(super) struct Sweep {
    axes: Vec<Axis>,
}

/// One combination of swept values: the specification as `--set` with each of them would make it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Variant {
    /// Paths and values as text, in the order of the specification.
    pub values: Vec<(String, String)>,
    /// Which value of each axis.
    chosen: Vec<usize>,
}

impl Variant {
    /// The values as settings.
    pub fn settings(&self) -> Vec<String> {
        let setting = |(path, value): &(String, String)| format!("{path}={value}");
        self.values.iter().map(setting).collect()
    }
}

impl Sweep {
    /// Takes the sweep out of a tree. A path in `fixed` is not swept, since it was set by hand.
    pub(super) fn take(tree: &mut Node, fixed: &[String]) -> Result<Sweep, Vec<Diagnostic>> {
        let Some(entry) = entry(tree) else {
            return Ok(Sweep::default());
        };
        let Kind::Map(entries) = entry.value.kind else {
            let found = entry.value.describe();
            let message = format!("found {found}, expected a map from paths to lists of values");
            return Err(vec![fault(entry.value.span, message, EXAMPLE)]);
        };
        let too_many = |lengths: &[usize]| {
            let count = lengths.iter().copied().fold(1, usize::saturating_mul);
            let product: Vec<String> = lengths.iter().map(usize::to_string).collect();
            let product = match lengths {
                [_, _, ..] if lengths.len() <= SHOWN => format!(" ({})", product.join(" x ")),
                _ => String::new(),
            };
            let count = match count {
                ..COUNTABLE => counted(count, "combination"),
                _ => format!("more than {COUNTABLE} combinations"),
            };
            let message = format!("sweep has {count}{product}, expected at most {MAX_VARIANTS}");
            let help = "sweep fewer values, or fewer keys at once";
            fault(entry.key.span, message, help)
        };
        let lengths: Vec<usize> = entries.iter().map(|entry| length(&entry.value)).collect();
        let listed: usize = lengths.iter().sum();
        // Each value is tried, which takes time.
        if listed > 2 * MAX_VARIANTS {
            return Err(vec![too_many(&lengths)]);
        }
        let (mut axes, mut faults): (Vec<Axis>, Vec<Diagnostic>) = Default::default();
        for entry in entries {
            let twice = (axes.iter()).find(|axis| overlap(&axis.name, &entry.key.text));
            let first = twice.map(|axis| axis.place);
            match axis(tree, entry, first) {
                Ok(axis) => axes.push(axis),
                Err(fault) => faults.push(*fault),
            }
        }
        axes.retain(|axis| !fixed.contains(&axis.name));
        let lengths: Vec<usize> = axes.iter().map(|axis| axis.values.len()).collect();
        if lengths.iter().copied().fold(1, usize::saturating_mul) > MAX_VARIANTS {
            faults.push(too_many(&lengths));
        }
        match faults.is_empty() {
            true => Ok(Sweep { axes }),
            false => Err(faults),
        }
    }

    /// Every combination, the last key changing fastest; none if nothing is swept.
    pub(super) fn variants(&self) -> Vec<Variant> {
        if self.axes.is_empty() {
            return Vec::new();
        }
        let count: usize = self.axes.iter().map(|axis| axis.values.len()).product();
        (0..count).map(|at| self.variant(at)).collect()
    }

    fn variant(&self, mut at: usize) -> Variant {
        let mut chosen = Vec::new();
        for axis in self.axes.iter().rev() {
            chosen.push(at % axis.values.len());
            at /= axis.values.len();
        }
        chosen.reverse();
        let value = |(axis, &at): (&Axis, &usize)| (axis.name.clone(), axis.values[at].flow());
        Variant {
            values: self.axes.iter().zip(&chosen).map(value).collect(),
            chosen,
        }
    }

    /// Puts the values of a variant into a tree, and its settings among the sources as the command line would.
    pub(super) fn apply(
        &self,
        variant: &Variant,
        tree: &mut Node,
        sources: &mut SourceMap,
    ) -> Result<(), Vec<Diagnostic>> {
        for (axis, &at) in self.axes.iter().zip(&variant.chosen) {
            let value = &axis.values[at];
            sources.add_virtual(
                "command line",
                setting::shown(&axis.name, &value.flow()).into(),
            );
            set(tree, &axis.path, value.clone()).map_err(|fault| vec![*fault])?;
        }
        Ok(())
    }
}

/// Whether one path leads to what another leads to, or into it.
fn overlap(one: &str, other: &str) -> bool {
    let into = |path: &str, whole: &str| {
        let rest = path.strip_prefix(whole);
        rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
    };
    into(one, other) || into(other, one)
}

/// What a sweep looks like.
const EXAMPLE: &str = "write `sweep: {controller.blocks.position.K: [2, 4, 8]}`";

fn fault(span: Span, message: impl Into<String>, help: &str) -> Diagnostic {
    Diagnostic::error(Rule::E0033, span, message).with_help(help)
}

fn length(node: &Node) -> usize {
    match &node.kind {
        Kind::Seq(items) => items.len(),
        _ => 1,
    }
}

/// One key of a sweep. Every value must find its place in the tree.
fn axis(tree: &Node, entry: Entry, first: Option<Span>) -> Result<Axis, Box<Diagnostic>> {
    let (name, span) = (entry.key.text, entry.key.span);
    let Kind::Seq(values) = entry.value.kind else {
        let message = format!(
            "found {}, expected a list of values",
            entry.value.describe()
        );
        return Err(Box::new(fault(entry.value.span, message, EXAMPLE)));
    };
    if let Some(first) = first {
        let message = format!("`{}` is swept twice", excerpt(&name));
        let help = "write its values in one list, under one path";
        return Err(Box::new(
            fault(span, message, help).with_related(first, "first swept here"),
        ));
    }
    if values.is_empty() {
        let message = format!("`{}` is swept over no value", excerpt(&name));
        let help = "write at least one value, as in `[2, 4]`";
        return Err(Box::new(fault(entry.value.span, message, help)));
    }
    let path = keys(&name, span);
    for value in &values {
        set(&mut tree.clone(), &path, value.clone())?;
    }
    Ok(Axis {
        path,
        name,
        place: span,
        values,
    })
}

/// The entry `scenario.sweep`, taken out; a second one stays and is reported as a duplicate key.
fn entry(tree: &mut Node) -> Option<Entry> {
    let Kind::Map(sections) = &mut tree.kind else {
        return None;
    };
    let scenario = sections
        .iter_mut()
        .find(|entry| entry.key.text == "scenario")?;
    let Kind::Map(entries) = &mut scenario.value.kind else {
        return None;
    };
    let at = entries.iter().position(|entry| entry.key.text == "sweep")?;
    Some(entries.remove(at))
}
