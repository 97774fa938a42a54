//! What names mean in the expressions of a specification, and what a name depends on.

use std::cell::Cell;
use std::collections::{BTreeMap, BTreeSet};

use crate::diagnostic::Span;
use crate::expr::arena::PolynomialId;
use crate::expr::{MAX_INSERTED, Origin, Scope, Symbol};
use crate::model::{Polynomial, Table};

/// Most names among which to look for the one that was meant, and how often to look at all: suggestions for every slip in a
/// specification with thousands of names and slips would take minutes.
const MOST_NAMES: usize = 2000;
const MOST_SUGGESTIONS: usize = 20;

/// What the value of a name varies with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Dependence {
    /// Time.
    pub(super) time: bool,
    /// The innermost block among the states that it varies with.
    pub(super) block: Option<usize>,
    /// A further state of the flown plant, or an input.
    pub(super) truth: bool,
}

impl Dependence {
    /// What only the flown plant has.
    pub(super) const TRUTH: Self = Dependence {
        time: false,
        block: None,
        truth: true,
    };

    pub(super) fn join(self, other: Self) -> Self {
        Dependence {
            time: self.time || other.time,
            block: self.block.max(other.block),
            truth: self.truth || other.truth,
        }
    }
}

/// Where an expression stands, which decides what it may name at all.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// A number that must be known when the code is generated.
    Constant,
    /// Anywhere else; on which states and on time it may depend is checked by [`super::structure`].
    Model,
}

/// All names of a specification.
#[derive(Debug, Default)]
pub(super) struct Names {
    symbols: BTreeMap<String, (Symbol, Dependence)>,
    refused: BTreeSet<String>,
    origins: BTreeMap<String, Origin>,
    /// Names that nothing else has, of what no expression may name; with the reason.
    unusable: BTreeMap<String, String>,
    /// How many suggestions have been asked for.
    asked: Cell<usize>,
    /// What each function uses beside its arguments, in the functions that it calls too.
    uses: BTreeMap<String, BTreeSet<String>>,
    /// What is being computed, if it has a name.
    pub(super) subject: Option<String>,
    /// How much calls and loops have inserted.
    inserted: usize,
    /// Polynomial data, derivatives that expressions ask for at the end.
    pub(super) polynomials: Vec<Polynomial>,
    /// Lookup tables; `None` after a fault.
    pub(super) tables: Vec<Option<Table>>,
    /// Whether there are no others; a name that is not known may be one that could not be read.
    pub(super) complete: bool,
}

impl Names {
    /// Tells where a name is declared.
    pub(super) fn declare(&mut self, name: &str, span: Span, noun: &'static str) {
        let origin = Origin {
            span,
            noun,
            uses: Vec::new(),
        };
        self.origins.insert(name.into(), origin);
    }

    /// What a name stands for.
    pub(super) fn symbol(&self, name: &str) -> Option<&Symbol> {
        self.symbols.get(name).map(|(symbol, _)| symbol)
    }

    /// Where a name is declared; `None` for those of the language.
    pub(super) fn origin_of(&self, name: &str) -> Option<&Origin> {
        self.origins.get(name)
    }

    /// Tells which names a declared one is defined by.
    pub(super) fn defined_by(&mut self, name: &str, uses: Vec<String>) {
        if let Some(origin) = self.origins.get_mut(name) {
            origin.uses = uses;
        }
    }

    /// Gives a name its meaning.
    pub(super) fn define(&mut self, name: &str, symbol: Symbol, dependence: Dependence) {
        let symbol = if self.refused.contains(name) {
            Symbol::Faulty
        } else {
            symbol
        };
        self.symbols.insert(name.into(), (symbol, dependence));
    }

    /// Declares a name without meaning, for a fault has been reported; its uses are passed over.
    pub(super) fn refuse(&mut self, name: &str) {
        self.refused.insert(name.into());
        self.symbols
            .insert(name.into(), (Symbol::Faulty, Dependence::default()));
    }

    /// Declares a name that no expression may use, unless it means something else.
    pub(super) fn forbid(&mut self, name: &str, why: impl Into<String>) {
        self.unusable.insert(name.into(), why.into());
    }

    /// Declares what a function uses.
    pub(super) fn define_uses(&mut self, function: &str, uses: BTreeSet<String>) {
        self.uses.insert(function.into(), uses);
    }

    /// What a function uses; nothing for what is none.
    pub(super) fn uses(&self, function: &str) -> impl Iterator<Item = &String> {
        self.uses.get(function).into_iter().flatten()
    }

    /// What a name depends on.
    pub(super) fn dependence(&self, name: &str) -> Dependence {
        self.symbols
            .get(name)
            .map(|(_, dependence)| *dependence)
            .unwrap_or_default()
    }

    /// The names as seen from a place.
    pub(super) fn view(&mut self, place: Place) -> View<'_> {
        View { names: self, place }
    }
}

/// The names as seen from one place.
pub(super) struct View<'a> {
    names: &'a mut Names,
    place: Place,
}

impl View<'_> {
    fn visible(&self, symbol: &Symbol) -> bool {
        self.place == Place::Model
            || matches!(
                symbol,
                Symbol::Constant(..)
                    | Symbol::Polynomial(..)
                    | Symbol::Function(_)
                    | Symbol::Table(..)
                    | Symbol::Faulty
            )
    }
}

impl Scope for View<'_> {
    fn resolve(&self, name: &str) -> Option<Symbol> {
        let Some((symbol, _)) = self.names.symbols.get(name) else {
            return match self.names.unusable.get(name) {
                Some(why) => Some(Symbol::Unavailable(why.clone())),
                None => (!self.names.complete).then_some(Symbol::Faulty),
            };
        };
        if self.visible(symbol) {
            return Some(symbol.clone());
        }
        let what = self.names.subject.as_deref().unwrap_or("this number");
        Some(Symbol::Unavailable(format!(
            "{what} must be known when the code is generated: it may use constants only"
        )))
    }

    fn names(&self) -> Vec<String> {
        let asked = self.names.asked.get() + 1;
        self.names.asked.set(asked);
        if asked > MOST_SUGGESTIONS || self.names.symbols.len() > MOST_NAMES {
            return Vec::new();
        }
        let visible = self
            .names
            .symbols
            .iter()
            .filter(|(_, (symbol, _))| self.visible(symbol));
        visible.map(|(name, _)| name.clone()).collect()
    }

    fn origin(&self, name: &str) -> Option<Origin> {
        self.names.origins.get(name).cloned()
    }

    fn insert(&mut self, operations: usize) -> bool {
        self.names.inserted = self.names.inserted.saturating_add(operations);
        self.names.inserted <= MAX_INSERTED
    }

    fn derivative(&mut self, polynomial: PolynomialId, argument: usize) -> PolynomialId {
        let of = &self.names.polynomials[polynomial.0 as usize];
        let name = format!("{}_d{}", of.name, argument + 1);
        let id = |at: usize| {
            PolynomialId(u32::try_from(at).expect("invariant: fewer than 2^32 polynomials"))
        };
        if let Some(at) = self
            .names
            .polynomials
            .iter()
            .position(|known| known.name == name)
        {
            return id(at);
        }
        let derivative = Polynomial {
            name,
            terms: differentiate(of, argument),
            ..of.clone()
        };
        self.names.polynomials.push(derivative);
        id(self.names.polynomials.len() - 1)
    }
}

/// d/dz_j of c z_j^a is c a z_j^(a-1); terms without z_j vanish.
fn differentiate(polynomial: &Polynomial, argument: usize) -> Vec<(f64, Vec<u32>)> {
    let mut terms = Vec::new();
    for (coefficient, exponents) in &polynomial.terms {
        let exponent = exponents[argument];
        if exponent > 0 {
            let mut lowered = exponents.clone();
            lowered[argument] = exponent - 1;
            terms.push((coefficient * f64::from(exponent), lowered));
        }
    }
    if terms.is_empty() {
        terms.push((0.0, vec![0; polynomial.arguments.len()]));
    }
    terms
}
