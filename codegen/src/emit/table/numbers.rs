//! Axes and tables as constants: a crate that calls the functions knows the numbers of a constant, not those of another crate's static.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use crate::emit::basis::list;
use crate::emit::comment::{code, docs, prose};
use crate::emit::literal;
use crate::ir::TableData;
use nsv_spec::interpolation::{Degree, Extrapolation, weights};

/// A table with the names of its function, of its axes and of its numbers.
#[derive(Clone, Debug)]
pub(super) struct Data {
    pub(super) table: TableData,
    pub(super) function: Ident,
    pub(super) axes: Vec<Ident>,
    pub(super) numbers: Ident,
}

/// An axis with the name that it was given first.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Axis {
    /// Bits of the breaks.
    pub(super) breaks: Vec<u64>,
    pub(super) degree: Degree,
    /// Whether it is the last one of a table, whose splines are in the table's curves.
    pub(super) last: bool,
    pub(super) argument: String,
    pub(super) name: Ident,
}

impl Axis {
    /// The constant.
    pub(super) fn item(&self) -> TokenStream {
        let breaks: Vec<f64> = self
            .breaks
            .iter()
            .map(|&bits| f64::from_bits(bits))
            .collect();
        let size = self.degree.number() + 1;
        let intervals = (0..breaks.len() - 1).filter(|_| !self.last).map(|i| {
            let splines = weights(&breaks, self.degree, i);
            rows(splines.into_iter().take(size), size)
        });
        let points = match self.degree {
            Degree::Linear => "its points",
            Degree::Cubic => "its points but for the second and the last but one",
        };
        let splines = if self.last { "" } else { ", and splines" };
        let about = code(&self.argument);
        let docs = docs(&[format!(
            "Axis {about}: breaks, SI, which are {points}{splines}."
        )]);
        let (name, breaks) = (&self.name, literal::row(&breaks));
        let size = Literal::usize_unsuffixed(size);
        quote! {
            #docs
            const #name: Axis<#size> = Axis { breaks: &#breaks, splines: &[#(#intervals),*] };
        }
    }
}

impl Data {
    /// The constant. `sources` tells where data comes from, by its name in the specification.
    pub(super) fn item(&self, sources: &[(String, String)]) -> TokenStream {
        let Data {
            table,
            axes,
            numbers,
            ..
        } = self;
        let interpolant = &table.interpolant;
        let size = interpolant.degree.number() + 1;
        let curves = rows(interpolant.curves(), size);
        let held = interpolant.extrapolation == Extrapolation::Clamp;
        let source = sources.iter().find(|(known, _)| *known == table.name);
        let source = source.filter(|(_, source)| !source.is_empty());
        let source = source.map_or_else(String::new, |(_, source)| {
            format!(" Source: {}.", prose(source))
        });
        let kind = match interpolant.degree {
            Degree::Linear => "linear",
            Degree::Cubic => "cubic",
        };
        let outside = match interpolant.extrapolation {
            Extrapolation::Clamp => "outside its axes the value at the nearer end",
            Extrapolation::Error => "outside its axes no number",
        };
        let docs = docs(&[format!(
            "Table {} in {}, {kind}; {outside}.{source}",
            code(&table.name),
            list(&table.arguments)
        )]);
        let (dimensions, size) = (
            Literal::usize_unsuffixed(axes.len()),
            Literal::usize_unsuffixed(size),
        );
        quote! {
            #docs
            const #numbers: Table<#dimensions, #size> = Table {
                axes: [#(#axes),*],
                curves: &#curves,
                held: #held,
            };
        }
    }
}

/// Polynomials by their first `size` powers.
fn rows(polynomials: impl Iterator<Item = [f64; 4]>, size: usize) -> TokenStream {
    let rows = polynomials.map(|powers| literal::row(&powers[..size]));
    quote!([#(#rows),*])
}
