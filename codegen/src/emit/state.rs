//! The controller's states as a struct: what each is, and how a step keeps or replaces them as a whole.

use proc_macro2::TokenStream;
use quote::quote;

use crate::emit::basis::monomial_names;
use crate::emit::comment::{code, docs};
use crate::emit::interface::Block;
use crate::emit::names::Fields;
use crate::emit::quantity;
use crate::emit::record::{self, Field, constructor};
use crate::ir::{Origin, Program, ValueId};

/// What the struct is made from.
pub(crate) struct State<'a> {
    /// Blocks of the plant.
    pub(crate) blocks: &'a [Block],
    /// Initial states: names and shapes.
    pub(crate) initial: &'a Program,
    /// The law: equations of the next states, bases of the networks.
    pub(crate) control: &'a Program,
    /// Fields by the names of the states.
    pub(crate) fields: &'a Fields,
}

/// The fields of `State`, by the names of the controller's states.
pub(crate) fn state_fields(initial: &Program) -> Fields {
    Fields::new(initial.outputs.iter().map(|(name, _)| name.as_str()))
}

impl State<'_> {
    /// The struct and its methods.
    pub(crate) fn items(&self) -> Vec<TokenStream> {
        let field = |(name, id): &(String, ValueId)| Field {
            name: self.fields.get(name).clone(),
            shape: self.initial.shape(*id),
            docs: self.docs(name),
        };
        let fields: Vec<Field> = self.initial.outputs.iter().map(field).collect();
        let definition = record::definition(
            "State",
            &["The controller's states, in SI units.".to_owned()],
            &fields,
        );
        let zero = record::literal(&quote!(Self), &fields, |field| {
            let constructor = constructor(field.shape);
            quote!(#constructor::zero())
        });
        let select = record::literal(&quote!(Self), &fields, |field| {
            let (constructor, name) = (constructor(field.shape), &field.name);
            quote!(#constructor::select(mask, a.#name, b.#name))
        });
        let finite = all(fields
            .iter()
            .map(|Field { name, .. }| quote!(self.#name.is_finite())));
        let (zero_docs, select_docs) = (
            docs(&["All zero."]),
            docs(&["`a` where the mask is true, else `b`."]),
        );
        let finite_docs = docs(&["Whether every entry is finite."]);
        let used = if fields.is_empty() {
            quote!(_mask: T::Mask, _a: &Self, _b: &Self)
        } else {
            quote!(mask: T::Mask, a: &Self, b: &Self)
        };
        let implementation = quote! {
            impl<T: Real> State<T> {
                #zero_docs
                #[inline(always)]
                pub fn zero() -> Self { #zero }

                #select_docs
                #[inline(always)]
                pub fn select(#used) -> Self { #select }

                #finite_docs
                #[inline(always)]
                pub fn is_finite(&self) -> T::Mask { #finite }
            }
        };
        vec![definition, implementation]
    }

    /// The equation of a state's rate, or else of its next value.
    fn origin(&self, name: &str) -> Option<&Origin> {
        let rate = format!("{name}_dot");
        let named = self
            .control
            .instructions
            .iter()
            .find(|instruction| instruction.name.as_ref() == Some(&rate));
        let next = format!("next.{name}");
        let output = self
            .control
            .outputs
            .iter()
            .find(|(output, _)| *output == next);
        let output = output.map(|(_, id)| self.control.instruction(*id));
        let origins = [named, output]
            .into_iter()
            .flatten()
            .filter_map(|instruction| self.control.origins.get(instruction.origin?));
        origins
            .into_iter()
            .find(|origin| !origin.equation.is_empty())
    }

    fn docs(&self, name: &str) -> Vec<String> {
        let origin = self.origin(name);
        let mut lines = vec![quantity::describe(name, self.blocks)];
        if let Some(origin) = origin {
            lines.extend([String::new(), code(&origin.equation)]);
        }
        if let Some(block) = name.strip_prefix('W')
            && let Some(basis) = self
                .control
                .bases
                .iter()
                .find(|basis| basis.name == format!("basis{block}"))
        {
            lines.extend([
                String::new(),
                format!("Rows: {}.", code(&monomial_names(basis).join(", "))),
            ]);
        }
        lines
    }
}

/// Conjunction of masks.
pub(crate) fn all(masks: impl Iterator<Item = TokenStream>) -> TokenStream {
    masks
        .reduce(|all, mask| quote!(#all.and(#mask)))
        .unwrap_or_else(|| quote!(T::Mask::splat(true)))
}
