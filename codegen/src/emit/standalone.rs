//! One program as a file of its own, for tests, benchmarks and embedding.

use proc_macro2::TokenStream;
use quote::quote;

use crate::emit::comment::{Comments, code, docs};
use crate::emit::function::{Function, Record, Results};
use crate::emit::module::{ALLOW, FUNCTION_IMPORTS};
use crate::emit::names::{Fields, ident, type_name};
use crate::emit::polynomial::Library;
use crate::emit::record::{self, Field};
use crate::emit::source::Source;
use crate::ir::{Input, Program};

/// The program as a module: structs for its dotted inputs, its polynomials, its results and the function. It needs `nsv_runtime` only.
pub fn standalone(program: &Program) -> String {
    let prefixes = prefixes(program);
    let fields: Vec<Fields> = prefixes
        .iter()
        .map(|prefix| Fields::new(members(program, prefix).map(|(name, _)| name)))
        .collect();
    let types: Vec<String> = prefixes.iter().map(|prefix| type_name(prefix)).collect();
    let records: Vec<Record<'_>> = prefixes
        .iter()
        .zip(&types)
        .zip(&fields)
        .map(|((prefix, ty), fields)| Record { prefix, ty, fields })
        .collect();
    let library = Library::of(&[program]);
    let mut items: Vec<TokenStream> = records
        .iter()
        .map(|record| definition(program, record))
        .collect();
    if !library.is_empty() {
        items.push(polynomials(&library));
    }
    if !library.tables.is_empty() {
        let (tables, docs) = (library.tables.items(&[]), docs(&["Lookup tables."]));
        items.push(quote!(#docs pub mod tables {
            use nsv_runtime::real::Real;
            use nsv_runtime::table::{Axis, Table};
            #(#tables)*
        }));
    }
    let mut comments = Comments::default();
    let lines = [format!("The program {}.", code(&program.name))];
    let function = Function {
        program,
        docs: &lines,
        records: &records,
        results: Results::Own,
        tables: &library,
        updates: None,
    };
    items.extend(function.items(&mut comments));
    let source = Source {
        header: &[],
        docs: &lines,
        allow: &ALLOW,
        imports: &FUNCTION_IMPORTS,
        items,
    };
    source.text(&comments)
}

/// What dotted inputs begin with, each once.
fn prefixes(program: &Program) -> Vec<String> {
    let mut prefixes: Vec<String> = Vec::new();
    for (prefix, _) in program
        .inputs
        .iter()
        .filter_map(|input| input.name.split_once('.'))
    {
        if prefixes.iter().all(|known| known != prefix) {
            prefixes.push(prefix.to_owned());
        }
    }
    prefixes
}

fn members<'p>(
    program: &'p Program,
    prefix: &'p str,
) -> impl Iterator<Item = (&'p str, &'p Input)> {
    program.inputs.iter().filter_map(move |input| {
        let (own, rest) = input.name.split_once('.')?;
        (own == prefix).then_some((rest, input))
    })
}

fn definition(program: &Program, record: &Record<'_>) -> TokenStream {
    let field = |(name, input): (&str, &Input)| Field {
        name: record.fields.get(name).clone(),
        shape: input.shape,
        docs: vec![format!("Input {}.", code(&input.name))],
    };
    let fields: Vec<Field> = members(program, record.prefix).map(field).collect();
    record::definition(
        record.ty,
        &[format!("Inputs {}.", code(&format!("{}.*", record.prefix)))],
        &fields,
    )
}

fn polynomials(library: &Library) -> TokenStream {
    let (items, docs) = (
        library.items(&[]),
        docs(&["Polynomial data and monomials."]),
    );
    let code = quote!(#(#items)*);
    let vector = crate::emit::source::mentions(&code, "Vector").then(|| {
        let name = ident("Vector");
        quote!(use nsv_runtime::linear::#name;)
    });
    let schemes = ["horner", "horner_fused"].map(ident);
    let schemes = schemes
        .iter()
        .filter(|scheme| crate::emit::source::mentions(&code, &scheme.to_string()));
    quote!(#docs pub mod polynomials { #vector #(use nsv_runtime::polynomial::#schemes;)* use nsv_runtime::real::Real; #code })
}
