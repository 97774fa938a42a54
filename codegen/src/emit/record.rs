//! Structs of numbers: the parameters and the controller's states.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::emit::comment::docs;
use crate::emit::names::ident;
use crate::emit::types::type_of_shape;
use crate::ir::Shape;

/// A field.
pub(crate) struct Field {
    /// Its identifier.
    pub(crate) name: Ident,
    /// Shape of its value.
    pub(crate) shape: Shape,
    /// Rustdoc.
    pub(crate) docs: Vec<String>,
}

/// `pub struct ty<T> { .. }`. A struct without fields holds the number type as a marker.
pub(crate) fn definition(ty: &str, lines: &[String], fields: &[Field]) -> TokenStream {
    let (ty, lines) = (ident(ty), docs(lines));
    let fields = fields.iter().map(|field| {
        let (docs, name, shape) = (docs(&field.docs), &field.name, type_of_shape(field.shape));
        quote!(#docs pub #name: #shape,)
    });
    let marker = fields.len() == 0;
    let marker = marker.then(|| quote!(scalar: core::marker::PhantomData<T>,));
    quote! {
        #lines
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[repr(align(64))]
        pub struct #ty<T> { #(#fields)* #marker }
    }
}

/// `ty { field: value(field), .. }`.
pub(crate) fn literal(
    ty: &TokenStream,
    fields: &[Field],
    value: impl Fn(&Field) -> TokenStream,
) -> TokenStream {
    if fields.is_empty() {
        return quote!(#ty { scalar: core::marker::PhantomData });
    }
    let fields = fields.iter().map(|field| {
        let (name, value) = (&field.name, value(field));
        quote!(#name: #value)
    });
    quote!(#ty { #(#fields),* })
}

/// The type whose associated functions make values of a shape: `T`, `Vector` or `Matrix`.
pub(crate) fn constructor(shape: Shape) -> TokenStream {
    match shape {
        Shape::Scalar => quote!(T),
        Shape::Vector(_) => quote!(Vector),
        Shape::Matrix(..) => quote!(Matrix),
    }
}
