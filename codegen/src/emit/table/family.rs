//! Tables at the same arguments as one function: it looks once where each argument lies and for the splines there, and each value has its
//! name in the struct that is returned.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::derivative_doc;
use super::numbers::Data;
use crate::emit::basis::list;
use crate::emit::comment::docs;
use crate::emit::family::FamilyNames;
use crate::emit::names::Scope;
use crate::emit::types::index;

/// The struct and the function. The members are derivatives of tables with the same axes, and none of `scope` is a variable.
pub(super) fn items(
    arguments: &[String],
    members: &[(&Data, &[u32])],
    names: &FamilyNames,
    scope: &mut Scope,
) -> [TokenStream; 2] {
    let FamilyNames {
        function,
        ty,
        fields,
        ..
    } = names;
    let docs_of = |(data, orders): &(&Data, &[u32])| docs(&[derivative_doc(&data.table, orders)]);
    let docs_of_fields = members.iter().map(docs_of);
    let about = list(arguments);
    let variables: Vec<Ident> = arguments.iter().map(|name| scope.claim(name)).collect();
    let places = scope.claim("places");
    let axes = &members[0].0.axes;
    let found = axes.iter().zip(&variables);
    let found = found.map(|(axis, argument)| quote!(#axis.place(#argument)));
    let splines = splines(arguments, members, scope);
    let statements = splines.iter().map(|((axis, order), splines)| {
        let (name, axis, order) = (&axes[*axis], index(*axis), Literal::u32_unsuffixed(*order));
        quote!(let #splines = #name.weights(&#places[#axis], #order);)
    });
    let values = members.iter().zip(fields).map(|((data, orders), field)| {
        let (numbers, last) = (&data.numbers, orders.len() - 1);
        let leading = (0..last).map(|axis| &splines[&(axis, orders[axis])]);
        let order = Literal::u32_unsuffixed(orders[last]);
        quote!(#field: #numbers.at(&#places, &[#(#leading),*], #order))
    });
    let type_docs = docs(&[format!("Tables at one {about}.")]);
    let function_docs = docs(&[format!(
        "Tables of the same axes {about}: where the arguments lie is found once for all."
    )]);
    let definition = quote! {
        #type_docs
        #[derive(Clone, Copy, Debug)]
        pub struct #ty<T> { #(#docs_of_fields pub #fields: T),* }
    };
    let function = quote! {
        #function_docs
        #[inline(always)]
        pub fn #function<T: Real>(#(#variables: T),*) -> #ty<T> {
            let #places = [#(#found),*];
            #(#statements)*
            #ty { #(#values),* }
        }
    };
    [definition, function]
}

/// A variable for the splines of each axis but the last and each order by its argument.
fn splines(
    arguments: &[String],
    members: &[(&Data, &[u32])],
    scope: &mut Scope,
) -> BTreeMap<(usize, u32), Ident> {
    let leading = members.iter().flat_map(|(_, orders)| {
        let leading = &orders[..orders.len() - 1];
        leading.iter().copied().enumerate()
    });
    let different: BTreeSet<(usize, u32)> = leading.collect();
    let named = different.into_iter().map(|(axis, order)| {
        let suffix = match order {
            0 => String::new(),
            _ => format!("_d{order}"),
        };
        let name = scope.claim(&format!("{}_splines{suffix}", arguments[axis]));
        ((axis, order), name)
    });
    named.collect()
}
