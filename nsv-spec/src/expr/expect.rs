//! Checks that an expression has the shape and dimensions that its place asks for.

use super::arena::{Arena, ExprId, Shape, Type};
use super::typing::{in_entry, shown};
use crate::diagnostic::{Diagnostic, Rule, Span};
use crate::unit::Dimension;

/// What a place in the specification asks of its expression.
#[derive(Clone, Copy, Debug)]
pub struct Expected<'a> {
    /// The place in words, the subject of the message: ``drift of block `attitude` ``.
    pub what: &'a str,
    /// Shape.
    pub shape: Shape,
    /// Dimension of every entry in row-major order, or a single one for all.
    pub dimensions: &'a [Dimension],
    /// For each row, what its dimension follows from: the place, and what is there. Empty where that needs no telling.
    pub reasons: &'a [(Span, String)],
    /// The same for each column.
    pub columns: &'a [(Span, String)],
}

/// Checks the expression `id`, written at `span` with its entries at `places`, if these are known, and reports every entry of a
/// wrong dimension.
pub fn expect(
    arena: &Arena,
    id: ExprId,
    span: Span,
    places: &[Span],
    expected: &Expected<'_>,
) -> Result<(), Vec<Diagnostic>> {
    let what = expected.what;
    let Type::Real { shape, dimensions } = arena.ty(id) else {
        let message = format!("{what} is a truth value, expected {}", expected.shape);
        return Err(vec![
            Diagnostic::error(Rule::E0502, span, message)
                .with_help("choose numbers with `if(condition, a, b)`"),
        ]);
    };
    if *shape != expected.shape {
        let wanted = match expected.shape.entries() {
            1 => Shape::Scalar,
            _ => expected.shape,
        };
        let message = format!("shape mismatch: {what} is {shape}, expected {wanted}");
        return Err(vec![
            Diagnostic::error(Rule::E0504, span, message).with_help(shape_help(wanted)),
        ]);
    }
    let wanted = expected.dimensions.iter().cycle();
    let wrong = dimensions.iter().zip(wanted).enumerate();
    let wrong = wrong.filter(|(_, (found, wanted))| found.agree(**wanted).is_none());
    let mut misfits: Vec<Misfit> = Vec::new();
    for (entry, (&found, &wanted)) in wrong {
        let misfit = Misfit {
            at: places.get(entry).copied().unwrap_or(span),
            entry,
            found,
            wanted,
            more: 0,
        };
        match misfits.iter_mut().find(|known| known.is_like(&misfit)) {
            Some(known) => known.more += 1,
            None => misfits.push(misfit),
        }
    }
    let faults: Vec<_> = misfits
        .into_iter()
        .map(|misfit| {
            let Misfit {
                at,
                entry,
                found,
                wanted,
                more,
            } = misfit;
            let place = match (shape.entries(), more) {
                (1, _) => String::new(),
                (_, 0) => in_entry(*shape, entry),
                _ => format!("{} and {more} more", in_entry(*shape, entry)),
            };
            let message = format!(
                "unit mismatch{place}: {what} is {}, expected {}",
                found.in_words(),
                shown(wanted)
            );
            let label = format!("this is {}", found.in_words());
            let fault = Diagnostic::error(Rule::E0407, at, message)
                .with_label(label)
                .with_help(dimension_help(found, wanted));
            let cols = shape.size().1;
            let row = expected.reasons.get(entry / cols);
            let reasons = row.into_iter().chain(expected.columns.get(entry % cols));
            reasons.fold(fault, |fault, (place, reason)| {
                fault.with_related(*place, reason)
            })
        })
        .collect();
    if faults.is_empty() {
        Ok(())
    } else {
        Err(faults)
    }
}

/// An entry of another unit than wanted, and how many more of the same expression lack the same factor, which is one fault.
struct Misfit {
    at: Span,
    entry: usize,
    found: Dimension,
    wanted: Dimension,
    more: usize,
}

impl Misfit {
    fn is_like(&self, other: &Misfit) -> bool {
        let lacks = |misfit: &Misfit| misfit.wanted.checked_div(misfit.found);
        self.at == other.at && lacks(self) == lacks(other)
    }
}

fn shape_help(shape: Shape) -> String {
    match shape {
        Shape::Scalar => {
            "write one expression, or take an entry of an array with `v[1]` or `M[1, 2]`".to_owned()
        }
        Shape::Vector(rows) => format!("write {rows} entries: `[..]`"),
        Shape::Matrix(rows, cols) => format!("write {rows} rows of {cols} entries: `[[..], ..]`"),
    }
}

fn dimension_help(found: Dimension, wanted: Dimension) -> String {
    match wanted.checked_div(found) {
        Some(_) if wanted == Dimension::ONE => {
            format!("divide it by a quantity in {found}, such as `/(1 {found})`")
        }
        Some(factor) if found == Dimension::ONE => {
            format!("multiply it by its unit, as in `*(1 {factor})`")
        }
        Some(factor) => match factor.checked_powi(-1) {
            Some(inverse) if factor.to_string().starts_with("1/") => {
                format!("divide it by a quantity in {inverse}")
            }
            _ => format!("multiply it by a quantity in {factor}"),
        },
        None => format!("write it in units of {}", shown(wanted)),
    }
}
