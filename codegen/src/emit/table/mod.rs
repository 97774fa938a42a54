//! Lookup tables: their axes and numbers, a function for each derivative that is called alone, and one for each family of them.

mod family;
mod numbers;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use crate::emit::basis::list;
use crate::emit::comment::{code, docs};
use crate::emit::family::FamilyNames;
use crate::emit::names::Scope;
use crate::ir::{Op, Program, TableData, TableFamily, TableId};
use numbers::{Axis, Data};

/// The tables of a set of programs, each once, with the derivatives that are called.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tables {
    axes: Vec<Axis>,
    tables: Vec<Data>,
    /// Derivatives that are called alone, and the function's name.
    functions: Vec<(Derivative, Ident)>,
    families: Vec<Family>,
    scope: Scope,
    types: Scope,
}

/// Position of a table, and how often by each argument.
type Derivative = (usize, Vec<u32>);

/// A family with its names.
#[derive(Clone, Debug)]
struct Family {
    arguments: Vec<String>,
    members: Vec<Derivative>,
    names: FamilyNames,
}

impl Tables {
    /// Takes over what an operation calls.
    pub(crate) fn add(&mut self, program: &Program, op: &Op) {
        match op {
            Op::Table(id, orders, _) => self.add_derivative(program, *id, orders),
            Op::TableFamily(id, _) => {
                self.add_family(program, &program.table_families[id.0 as usize]);
            }
            _ => {}
        }
    }

    fn add_derivative(&mut self, program: &Program, id: TableId, orders: &[u32]) {
        let derivative = (self.add_table(program, id), orders.to_vec());
        if self.functions.iter().all(|(known, _)| *known != derivative) {
            let Data {
                table, function, ..
            } = &self.tables[derivative.0];
            let name = match orders.iter().all(|&order| order == 0) {
                true => function.clone(),
                false => self.scope.claim(&derivative_name(table, orders)),
            };
            self.functions.push((derivative, name));
        }
    }

    fn add_family(&mut self, program: &Program, family: &TableFamily) {
        let members = family.members.iter();
        let members =
            members.map(|member| (self.add_table(program, member.table), member.orders.clone()));
        let members: Vec<Derivative> = members.collect();
        if self.family(&family.arguments, &members).is_some() {
            return;
        }
        let tables = &self.tables;
        let names = members.iter();
        let names = names.map(|(at, orders)| derivative_name(&tables[*at].table, orders));
        let (functions, types) = (&mut self.scope, &mut self.types);
        let names = FamilyNames::new("tables", &family.name, names, functions, types);
        self.families.push(Family {
            arguments: family.arguments.clone(),
            members,
            names,
        });
    }

    /// The position of a table, after taking it over unless it is known.
    fn add_table(&mut self, program: &Program, id: TableId) -> usize {
        let table = &program.tables[id.0 as usize];
        if let Some(at) = self.position(table) {
            return at;
        }
        let function = self.scope.claim(&table.name);
        let axes = (0..table.arguments.len()).map(|axis| self.add_axis(table, axis));
        let axes = axes.collect();
        // Not the upper case alone, which may be the name of a table itself.
        let numbers = format!("{}_NUMBERS", table.name.to_uppercase());
        self.tables.push(Data {
            table: table.clone(),
            function,
            axes,
            numbers: self.scope.claim(&numbers),
        });
        self.tables.len() - 1
    }

    /// The name of an axis, which tables share.
    fn add_axis(&mut self, table: &TableData, axis: usize) -> Ident {
        let (degree, mut breaks) = table.axes();
        let (last, breaks) = (axis + 1 == breaks.len(), breaks.swap_remove(axis));
        let known = self
            .axes
            .iter()
            .find(|known| known.breaks == breaks && known.degree == degree && known.last == last);
        if let Some(known) = known {
            return known.name.clone();
        }
        let argument = table.arguments[axis].clone();
        let name = self
            .scope
            .claim(&format!("{}_AXIS", argument.to_uppercase()));
        self.axes.push(Axis {
            breaks,
            degree,
            last,
            argument,
            name: name.clone(),
        });
        name
    }

    fn position(&self, table: &TableData) -> Option<usize> {
        self.tables.iter().position(|known| known.table == *table)
    }

    fn family(&self, arguments: &[String], members: &[Derivative]) -> Option<&FamilyNames> {
        let mut families = self.families.iter();
        let found =
            families.find(|family| family.arguments == arguments && family.members == members);
        found.map(|family| &family.names)
    }

    /// Whether there are none.
    pub(crate) fn is_empty(&self) -> bool {
        self.tables.is_empty()
    }

    /// Path of the function that computes a derivative of a table; nothing for another operation.
    pub(crate) fn path(&self, program: &Program, op: &Op) -> TokenStream {
        let Op::Table(id, orders, _) = op else {
            return TokenStream::new();
        };
        let at = self.position(&program.tables[id.0 as usize]);
        let mut functions = self.functions.iter();
        let found = functions.find(|((table, of), _)| Some(*table) == at && of == orders);
        found
            .map(|(_, name)| quote!(tables::#name))
            .unwrap_or_default()
    }

    /// Names of each family of a program; `None` for one that it does not call.
    pub(crate) fn family_names(&self, program: &Program) -> Vec<Option<FamilyNames>> {
        let families = program.table_families.iter().map(|family| {
            let members = family.members.iter().map(|member| {
                let at = self.position(&program.tables[member.table.0 as usize])?;
                Some((at, member.orders.clone()))
            });
            let members: Vec<Derivative> = members.collect::<Option<_>>()?;
            self.family(&family.arguments, &members).cloned()
        });
        families.collect()
    }

    /// Axes, numbers and functions. `sources` tells where data comes from, by its name in the specification.
    pub(crate) fn items(&self, sources: &[(String, String)]) -> Vec<TokenStream> {
        let mut items: Vec<TokenStream> = self.axes.iter().map(Axis::item).collect();
        for (at, data) in self.tables.iter().enumerate() {
            items.push(data.item(sources));
            let functions = self.functions.iter().filter(|((of, _), _)| *of == at);
            items
                .extend(functions.map(|((_, orders), name)| {
                    function(data, orders, name, &mut self.constants())
                }));
        }
        for family in &self.families {
            let members = family.members.iter();
            let members: Vec<_> = members
                .map(|(at, orders)| (&self.tables[*at], orders.as_slice()))
                .collect();
            let (arguments, names) = (&family.arguments, &family.names);
            let mut scope = self.constants();
            items.extend(family::items(arguments, &members, names, &mut scope));
        }
        items
    }

    /// The names of a function's variables, none of which may be that of a constant.
    fn constants(&self) -> Scope {
        let mut scope = Scope::default();
        let axes = self.axes.iter().map(|axis| &axis.name);
        for name in axes.chain(self.tables.iter().map(|data| &data.numbers)) {
            scope.claim(&name.to_string());
        }
        scope
    }
}

/// `lift_d1_d3` for one derivative by the first and one by the third argument.
fn derivative_name(table: &TableData, orders: &[u32]) -> String {
    let times = orders.iter().enumerate();
    let suffix = times.map(|(at, &order)| format!("_d{}", at + 1).repeat(order as usize));
    table.name.clone() + &suffix.collect::<String>()
}

/// What a derivative is, for people.
fn derivative_doc(table: &TableData, orders: &[u32]) -> String {
    let by = table.arguments.iter().zip(orders);
    let by = by.flat_map(|(name, &order)| std::iter::repeat_n(name.clone(), order as usize));
    let by: Vec<String> = by.collect();
    match by.is_empty() {
        true => format!("Table {}.", code(&table.name)),
        false => format!(
            "Derivative of table {} by {}.",
            code(&table.name),
            list(&by)
        ),
    }
}

fn function(data: &Data, orders: &[u32], name: &Ident, scope: &mut Scope) -> TokenStream {
    let arguments = data.table.arguments.iter();
    let arguments: Vec<Ident> = arguments.map(|name| scope.claim(name)).collect();
    let (docs, numbers) = (docs(&[derivative_doc(&data.table, orders)]), &data.numbers);
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

    #[test]
    fn tables_at_one_place_read_as_one_function_that_finds_it() {
        let program: Program = "program p
input x: vec3
table lift(mach, alpha, h) = breaks [0.0, 2.0], breaks [-1.0, 1.0], breaks [0.0, 1.0], linear clamp [0.5, 1.0, 1.5, 2.0, 2.5, 3.5, 4.5, 6.5]
table drag(m, a, LIFT_NUMBERS) = breaks [0.0, 2.0], breaks [-1.0, 1.0], breaks [0.0, 1.0], linear error [0.5, 1.0, 1.5, 2.0, 2.5, 3.5, 4.5, 6.5]
table heat(mach) = breaks [0.0, 2.0], linear error [0.5, 1.0]
tables at_mach_alpha_h(mach, alpha, h) = drag [0, 0, 0], lift [0, 0, 0], lift [1, 0, 0], lift [0, 0, 1]
tables at_mach(mach) = heat [0], heat [1]
%0: vec3 = input x
%1: real = element %0, 0, 0
%2: real = element %0, 1, 0
%3: real = element %0, 2, 0
%4: vec4 = tables at_mach_alpha_h, %1, %2, %3
%5: vec2 = tables at_mach, %1
%6: real = element %4, 2, 0
%7: real = element %5, 1, 0
%8: real = mul %6, %7
%9: real = table drag 0 0 1, %3, %2, %1
output y = %8
output z = %4
output w = %9
"
        .parse()
        .expect("a readable program");
        program.assert_sound();
        insta::assert_snapshot!(standalone(&program));
    }
}
