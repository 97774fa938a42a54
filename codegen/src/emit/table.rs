//! Lookup tables: their numbers, and a function for each derivative that is called.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use crate::emit::basis::list;
use crate::emit::comment::{code, docs, prose};
use crate::emit::literal;
use crate::emit::names::Scope;
use crate::ir::{Op, Program, TableData};
use nsv_spec::interpolation::{Degree, Extrapolation, weights};

/// The tables of a set of programs, each once, with the derivatives that are called.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tables {
    tables: Vec<Data>,
    /// Position of the table, orders, and the function's name.
    functions: Vec<(usize, Vec<u32>, Ident)>,
    scope: Scope,
}

/// A table with the names of its function and of its numbers.
#[derive(Clone, Debug)]
struct Data {
    table: TableData,
    function: Ident,
    numbers: Ident,
}

impl Tables {
    /// Takes over what an operation calls.
    pub(crate) fn add(&mut self, program: &Program, op: &Op) {
        let Op::Table(id, orders, _) = op else {
            return;
        };
        let data = &program.tables[id.0 as usize];
        let known = self.tables.iter().position(|known| known.table == *data);
        let at = known.unwrap_or_else(|| {
            let function = self.scope.claim(&data.name);
            // Not the upper case alone, which may be the name of a table itself.
            let numbers = format!("{}_NUMBERS", data.name.to_uppercase());
            self.tables.push(Data {
                table: data.clone(),
                function,
                numbers: self.scope.claim(&numbers),
            });
            self.tables.len() - 1
        });
        let called = |(table, of, _): &(usize, Vec<u32>, Ident)| *table == at && of == orders;
        if !self.functions.iter().any(called) {
            let name = match orders.iter().all(|&order| order == 0) {
                true => self.tables[at].function.clone(),
                false => self
                    .scope
                    .claim(&format!("{}{}", data.name, suffix(orders))),
            };
            self.functions.push((at, orders.clone(), name));
        }
    }

    /// Whether there are none.
    pub(crate) fn is_empty(&self) -> bool {
        self.functions.is_empty()
    }

    /// Path of the function that computes an operation; nothing for another operation.
    pub(crate) fn path(&self, program: &Program, op: &Op) -> TokenStream {
        let Op::Table(id, orders, _) = op else {
            return TokenStream::new();
        };
        let data = &program.tables[id.0 as usize];
        let found = self
            .functions
            .iter()
            .find(|(at, of, _)| self.tables[*at].table == *data && of == orders);
        found
            .map(|(_, _, name)| quote!(tables::#name))
            .unwrap_or_default()
    }

    /// Numbers and functions. `sources` tells where data comes from, by its name in the specification.
    pub(crate) fn items(&self, sources: &[(String, String)]) -> Vec<TokenStream> {
        let mut items = Vec::new();
        for (at, data) in self.tables.iter().enumerate() {
            let (table, numbers) = (&data.table, &data.numbers);
            items.push(self::numbers(table, numbers, sources));
            let functions = self.functions.iter().filter(|(of, ..)| *of == at);
            items.extend(functions.map(|(_, orders, name)| function(table, numbers, orders, name)));
        }
        items
    }
}

/// `_d1_d3` for one derivative by the first and one by the third argument.
fn suffix(orders: &[u32]) -> String {
    let times = orders.iter().enumerate();
    times
        .map(|(at, &order)| format!("_d{}", at + 1).repeat(order as usize))
        .collect()
}

fn numbers(data: &TableData, name: &Ident, sources: &[(String, String)]) -> TokenStream {
    let interpolant = &data.interpolant;
    let size = interpolant.degree.number() + 1;
    let last = interpolant.breaks.len() - 1;
    let axes = interpolant.breaks.iter().enumerate().map(|(axis, breaks)| {
        let intervals = (0..breaks.len() - 1).filter(|_| axis < last).map(|i| {
            let splines = weights(breaks, interpolant.degree, i);
            rows(splines.into_iter().take(size), size)
        });
        let breaks = literal::row(breaks);
        quote!(Axis { breaks: &#breaks, splines: &[#(#intervals),*] })
    });
    let curves = rows(interpolant.curves(), size);
    let held = interpolant.extrapolation == Extrapolation::Clamp;
    let source = sources.iter().find(|(known, _)| *known == data.name);
    let source = source.filter(|(_, source)| !source.is_empty());
    let source = source.map_or_else(String::new, |(_, source)| {
        format!(" Source: {}.", prose(source))
    });
    let (kind, breaks) = match interpolant.degree {
        Degree::Linear => ("linear", ""),
        Degree::Cubic => (
            "cubic",
            ", but for the second and the last but one point of an axis",
        ),
    };
    let outside = match interpolant.extrapolation {
        Extrapolation::Clamp => "outside its axes the value at the nearer end",
        Extrapolation::Error => "outside its axes no number",
    };
    let docs = docs(&[format!(
        "Table {} in {}, {kind}; {outside}. Breaks are its points, SI{breaks}.{source}",
        code(&data.name),
        list(&data.arguments)
    )]);
    let (dimensions, size) = (
        Literal::usize_unsuffixed(data.arguments.len()),
        Literal::usize_unsuffixed(size),
    );
    quote! {
        #docs
        static #name: Table<#dimensions, #size> = Table {
            axes: [#(#axes),*],
            curves: &#curves,
            held: #held,
        };
    }
}

/// Polynomials by their first `size` powers.
fn rows(polynomials: impl Iterator<Item = [f64; 4]>, size: usize) -> TokenStream {
    let rows = polynomials.map(|powers| literal::row(&powers[..size]));
    quote!([#(#rows),*])
}

fn function(data: &TableData, numbers: &Ident, orders: &[u32], name: &Ident) -> TokenStream {
    let mut scope = Scope::default();
    let arguments: Vec<Ident> = data
        .arguments
        .iter()
        .map(|name| scope.claim(name))
        .collect();
    let by: Vec<String> = data
        .arguments
        .iter()
        .zip(orders)
        .flat_map(|(name, &order)| std::iter::repeat_n(name.clone(), order as usize))
        .collect();
    let docs = docs(&[match by.is_empty() {
        true => format!("Table {}.", code(&data.name)),
        false => format!("Derivative of table {} by {}.", code(&data.name), list(&by)),
    }]);
    let orders = orders.iter().map(|&order| Literal::u32_unsuffixed(order));
    quote! {
        #docs
        #[inline(always)]
        pub fn #name<T: Real>(#(#arguments: T),*) -> T {
            #numbers.value([#(#orders),*], [#(#arguments),*])
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::emit::standalone;
    use crate::ir::Program;

    #[test]
    fn a_table_reads_as_numbers_and_functions() {
        let program: Program = "program p
input x: vec2
table lift(mach, alpha) = breaks [0.0, 0.5, 2.0], breaks [-1.0, 1.0], linear clamp [0.5, 1.0, 1.5, 2.0, 2.5, 3.5]
table drag(mach) = breaks [0.0, 2.0], cubic error [1.0, 2.0, 4.0, 8.0]
%0: vec2 = input x
%1: real = element %0, 0, 0
%2: real = element %0, 1, 0
%3: real = table lift 0 0, %1, %2
%4: real = table lift 0 1, %1, %2
%5: real = table drag 2, %1
%6: vec3 = array %3, %4, %5
output y = %6
"
        .parse()
        .expect("a readable program");
        program.assert_sound();
        insta::assert_snapshot!(standalone(&program));
    }
}
