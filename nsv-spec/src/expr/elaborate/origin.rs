//! Where the unit of a value comes from: the declarations of the names in it, and of those that they are defined by.

use std::collections::{BTreeSet, VecDeque};

use super::{Elaborator, Kind, Span};
use crate::diagnostic::{Diagnostic, Related};
use crate::expr::scope::{Scope, Symbol};
use crate::expr::typing::Real;
use crate::unit::Dimension;

/// Most declarations shown for one fault; more explain less.
const MOST: usize = 4;

impl Elaborator<'_> {
    /// The diagnostic with the declarations of the names within `span` that bring in units.
    pub(super) fn with_origins(&self, diagnostic: Diagnostic, span: Span) -> Diagnostic {
        let inside = |place: Span| span.start <= place.start && place.end <= span.end;
        let names = self.expr.nodes().iter().filter(|node| inside(node.span));
        let names = names.filter_map(|node| match &node.kind {
            Kind::Name(name) => Some(name.as_str()),
            _ => None,
        });
        with_origins(self.scope, diagnostic, names)
    }
}

/// The diagnostic with the declarations of some names and of what they are defined by, nearest first.
pub(crate) fn with_origins<'a>(
    scope: &dyn Scope,
    mut diagnostic: Diagnostic,
    names: impl Iterator<Item = &'a str>,
) -> Diagnostic {
    let mut queue: VecDeque<String> = names.map(str::to_owned).collect();
    let mut seen = BTreeSet::new();
    let mut shown = 0;
    while let Some(name) = queue.pop_front() {
        if shown == MOST || !seen.insert(name.clone()) {
            continue;
        }
        let (Some(real), Some(origin)) = (real(scope, &name), scope.origin(&name)) else {
            continue;
        };
        let told = |related: &Related| related.span == origin.span;
        if real.dimensions.iter().all(|one| *one == Dimension::ONE)
            || diagnostic.related.iter().any(told)
        {
            continue;
        }
        let label = format!(
            "{} `{name}` is {}, declared here",
            origin.noun,
            real.with_units()
        );
        diagnostic = diagnostic.with_related(origin.span, label);
        shown += 1;
        queue.extend(origin.uses);
    }
    diagnostic
}

/// The type of a name that stands for a number.
fn real(scope: &dyn Scope, name: &str) -> Option<Real> {
    match scope.resolve(name)? {
        Symbol::Constant(_, ty) | Symbol::Parameter(_, ty) | Symbol::Definition(_, ty) => {
            Real::of(&ty)
        }
        Symbol::State { dimension, .. } => Some(Real::scalar(dimension)),
        _ => None,
    }
}
