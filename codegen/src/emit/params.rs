//! `params.rs`: the run-time parameters with their nominal and design values and their dispersion.

use proc_macro2::TokenStream;
use quote::quote;

use crate::emit::comment::{docs, prose};
use crate::emit::dispersion::{described, draw};
use crate::emit::interface::{Interface, Parameter};
use crate::emit::literal::float;
use crate::emit::names::Fields;
use crate::emit::record::{self, Field};
use crate::ir::Shape;

/// The fields of `Params`, by the parameters' names.
pub(crate) fn fields(interface: &Interface) -> Fields {
    Fields::new(
        interface
            .parameters
            .iter()
            .map(|parameter| parameter.name.as_str()),
    )
}

/// The items of the file.
pub(crate) fn items(interface: &Interface, fields: &Fields) -> Vec<TokenStream> {
    let field = |parameter: &Parameter| Field {
        name: fields.get(&parameter.name).clone(),
        shape: Shape::Scalar,
        docs: field_docs(parameter),
    };
    let fields: Vec<Field> = interface.parameters.iter().map(field).collect();
    let definition = record::definition(
        "Params",
        &["Run-time parameters, in SI units.".to_owned()],
        &fields,
    );
    let implementation = implementation(interface, &fields);
    vec![definition, implementation]
}

fn field_docs(parameter: &Parameter) -> Vec<String> {
    let number = |value: f64| format!("{value:?}");
    let dispersion = described(parameter.dispersion.as_ref());
    let source = if parameter.doc.is_empty() {
        String::new()
    } else {
        format!(" Source: {}.", prose(&parameter.doc))
    };
    let (unit, plant, design) = (
        prose(&parameter.unit),
        number(parameter.plant),
        number(parameter.design),
    );
    vec![format!(
        "Unit: {unit}. Plant {plant}{dispersion}; controller {design}.{source}"
    )]
}

fn implementation(interface: &Interface, fields: &[Field]) -> TokenStream {
    let values = |value: &dyn Fn(&Parameter) -> TokenStream| {
        let position = |field: &Field| {
            fields
                .iter()
                .position(|known| known.name == field.name)
                .expect("invariant: a field")
        };
        record::literal(&quote!(Self), fields, |field| {
            let value = value(&interface.parameters[position(field)]);
            quote!(T::from_f64(#value))
        })
    };
    let plant = values(&|parameter| float(parameter.plant));
    let design = values(&|parameter| float(parameter.design));
    let plant_docs = docs(&["The plant's nominal values."]);
    let design_docs = docs(&["The values that the controller is designed with."]);
    let dispersed = dispersed(interface, fields);
    quote! {
        impl<T: Real> Params<T> {
            #plant_docs
            #[inline(always)]
            pub fn plant() -> Self { #plant }

            #design_docs
            #[inline(always)]
            pub fn design() -> Self { #design }

            #dispersed
        }
    }
}

fn dispersed(interface: &Interface, fields: &[Field]) -> TokenStream {
    let draws = interface
        .parameters
        .iter()
        .zip(fields)
        .enumerate()
        .filter_map(|(channel, (parameter, field))| {
            let value = draw(parameter.dispersion.as_ref()?, channel);
            let name = &field.name;
            Some(quote!(#name: #value))
        });
    let draws: Vec<TokenStream> = draws.collect();
    let (docs, noise, body) = match (draws.len(), fields.len()) {
        (0, _) => (
            docs(&["The plant's values in a run; none is dispersed."]),
            quote!(_noise),
            quote!(Self::plant()),
        ),
        (all, count) => {
            let rest = (all < count).then(|| quote!(, ..Self::plant()));
            let line = "The plant's values in each lane's run, drawn from the dispersions of the specification.";
            (
                docs(&[line]),
                quote!(noise),
                quote!(Self { #(#draws),* #rest }),
            )
        }
    };
    quote! {
        #docs
        #[inline(always)]
        pub fn dispersed(#noise: &Noise<T>) -> Self { #body }
    }
}
