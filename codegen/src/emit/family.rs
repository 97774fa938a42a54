//! Polynomials of one argument as one function: those of one degree are rows of one table, which the compiler turns into vector
//! instructions, and each value has its name in the struct that is returned.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::emit::comment::{code, docs, prose};
use crate::emit::literal::row;
use crate::emit::names::{Scope, ident, type_name};
use crate::emit::types::index;
use crate::ir::PolynomialFamily;

/// Names of a family in emitted code.
#[derive(Clone, Debug)]
pub(crate) struct FamilyNames {
    /// The module that it is in.
    pub(crate) module: Ident,
    /// The function.
    pub(crate) function: Ident,
    /// The struct of its values.
    pub(crate) ty: Ident,
    /// The field of each member.
    pub(crate) fields: Vec<Ident>,
}

impl FamilyNames {
    /// Names in a module that `functions` and `types` have not given yet, for a family of this name with members of these.
    pub(crate) fn new(
        module: &str,
        family: &str,
        members: impl Iterator<Item = String>,
        functions: &mut Scope,
        types: &mut Scope,
    ) -> FamilyNames {
        let mut fields = Scope::default();
        let function = functions.claim(family);
        FamilyNames {
            module: ident(module),
            ty: types.claim(&type_name(&function.to_string())),
            function,
            fields: members.map(|member| fields.claim(&member)).collect(),
        }
    }

    /// Path of the function.
    pub(crate) fn path(&self) -> TokenStream {
        let FamilyNames {
            module, function, ..
        } = self;
        quote!(#module::#function)
    }

    /// Path of the struct of its values.
    pub(crate) fn type_path(&self) -> TokenStream {
        let FamilyNames { module, ty, .. } = self;
        quote!(#module::#ty)
    }
}

/// The struct and the function. `source` tells where a member's data comes from.
pub(crate) fn items<'s>(
    family: &PolynomialFamily,
    fused: bool,
    names: &FamilyNames,
    source: impl Fn(&str) -> Option<&'s str>,
) -> [TokenStream; 2] {
    let argument = Scope::default().claim(&family.argument);
    let horner = format_ident!("{}", if fused { "horner_fused" } else { "horner" });
    let FamilyNames {
        function,
        ty,
        fields,
        ..
    } = names;
    let members = family.members.iter().zip(fields).map(|(member, field)| {
        let source = source(&member.name).map(|source| format!(", source: {}", prose(source)));
        let line = format!("{}{}.", code(&member.name), source.unwrap_or_default());
        let docs = docs(&[line]);
        quote!(#docs pub #field: T)
    });
    let tables = tables(family).into_iter().map(|members| {
        let rows = family.members[members.start].coefficients.len();
        let name = format_ident!("DEGREE_{}", rows - 1);
        let coefficients = (0..rows).map(|power| {
            let of = |member: usize| family.members[member].coefficients[power];
            row(&members.clone().map(of).collect::<Vec<f64>>())
        });
        let (width, rows, fields) = (index(members.len()), index(rows), &fields[members.clone()]);
        quote! {
            const #name: [[f64; #width]; #rows] = [#(#coefficients),*];
            let [#(#fields),*] = #horner(&#name, #argument);
        }
    });
    let (additions, multiplications) = family.members.iter().fold((0, 0), |(add, mul), member| {
        let (a, m) = member.operations();
        (add + a, mul + m)
    });
    let about = code(&family.argument);
    let type_docs = docs(&[format!("Polynomial data at one {about}.")]);
    let lines = [
        format!(
            "Polynomial data in {about} by Horner's scheme, with its other arguments, which are constants, in the coefficients."
        ),
        String::new(),
        format!(
            "{} polynomials; {additions} additions, {multiplications} multiplications. A row of a table holds the coefficients of one \
             power, the highest first.",
            family.members.len()
        ),
    ];
    let function_docs = docs(&lines);
    let definition = quote! {
        #type_docs
        #[derive(Clone, Copy, Debug)]
        pub struct #ty<T> { #(#members),* }
    };
    let function = quote! {
        #function_docs
        #[inline(always)]
        pub fn #function<T: Real>(#argument: T) -> #ty<T> {
            #(#tables)*
            #ty { #(#fields),* }
        }
    };
    [definition, function]
}

/// The members of each degree; those of one degree stand together.
fn tables(family: &PolynomialFamily) -> Vec<std::ops::Range<usize>> {
    let mut tables: Vec<std::ops::Range<usize>> = Vec::new();
    for (position, member) in family.members.iter().enumerate() {
        let degree = |position: usize| family.members[position].coefficients.len();
        match tables.last_mut() {
            Some(table) if degree(table.start) == member.coefficients.len() => {
                table.end = position + 1;
            }
            _ => tables.push(position..position + 1),
        }
    }
    tables
}
