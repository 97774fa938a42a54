//! Lookup tables with the same axes at the same arguments are evaluated together, so that each argument is searched for once.

use std::collections::BTreeMap;

use crate::ir::{Op, Program, TableFamily, TableFamilyId, TableId, TableMember, ValueId};

use super::families::Taken;
use super::rewrite::rewrite;

/// Where tables are evaluated: the first table with these axes, and the arguments.
type Place = (TableId, Vec<ValueId>);

/// What is evaluated at a place.
#[derive(Default)]
struct Gathering {
    members: Vec<TableMember>,
    /// The values, once they are computed.
    values: Option<ValueId>,
}

/// Gathers what is evaluated at each place in one family; what is alone there stays so.
pub(super) fn run(program: Program) -> Program {
    let axes = axes(&program);
    let instructions = program.instructions.iter();
    let places: Vec<Option<Place>> = instructions
        .map(|instruction| match &instruction.op {
            Op::Table(id, _, arguments) => Some((axes[id.0 as usize], arguments.clone())),
            _ => None,
        })
        .collect();
    let mut gatherings = gather(&program, &places);
    let mut families = Families::of(&program);
    let mut next = places.into_iter();
    rewrite(program, |program, instruction| {
        let place = next.next().expect("invariant: a place per instruction")?;
        let gathering = gatherings.get_mut(&place)?;
        let Op::Table(table, orders, arguments) = &instruction.op else {
            return None;
        };
        let is_it = |of: &TableMember| of.table == *table && of.orders == *orders;
        let row = gathering.members.iter().position(is_it)?;
        // One search instead of several for the same number in the same breaks (exact)
        let values = *gathering.values.get_or_insert_with(|| {
            let family = families.add(program, &gathering.members);
            program.push(Op::TableFamily(family, arguments.clone()))
        });
        Some(program.push(Op::Element(values, row, 0)))
    })
}

/// For each table the first with the same axes.
fn axes(program: &Program) -> Vec<TableId> {
    let mut first = BTreeMap::new();
    let tables = (0..).map(TableId).zip(&program.tables);
    let axes = tables.map(|(id, table)| *first.entry(table.axes()).or_insert(id));
    axes.collect()
}

/// Different derivatives at each place, where there are several, by name and orders.
fn gather(program: &Program, places: &[Option<Place>]) -> BTreeMap<Place, Gathering> {
    let mut gatherings: BTreeMap<Place, Gathering> = BTreeMap::new();
    for (instruction, place) in program.instructions.iter().zip(places) {
        if let (Op::Table(table, orders, _), Some(place)) = (&instruction.op, place) {
            let members = &mut gatherings.entry(place.clone()).or_default().members;
            let (table, orders) = (*table, orders.clone());
            members.push(TableMember { table, orders });
        }
    }
    for gathering in gatherings.values_mut() {
        let name = |of: &TableMember| &program.tables[of.table.0 as usize].name;
        let members = &mut gathering.members;
        members.sort_by(|a, b| (name(a), &a.orders).cmp(&(name(b), &b.orders)));
        members.dedup();
    }
    gatherings.retain(|_, gathering| gathering.members.len() > 1);
    gatherings
}

/// The families of a program while more are made.
struct Families {
    /// Names of tables and their families.
    taken: Taken,
    /// The families made so far.
    known: BTreeMap<Vec<TableMember>, TableFamilyId>,
}

impl Families {
    fn of(program: &Program) -> Families {
        let tables = program.tables.iter().map(|table| &table.name);
        let families = program.table_families.iter().map(|family| &family.name);
        Families {
            taken: Taken::new(tables.chain(families)),
            known: BTreeMap::new(),
        }
    }

    /// The family of these members, appended unless it was appended before.
    fn add(&mut self, program: &mut Program, members: &[TableMember]) -> TableFamilyId {
        if let Some(&id) = self.known.get(members) {
            return id;
        }
        let first = members[0].table;
        let arguments = program.tables[first.0 as usize].arguments.clone();
        let index = program.table_families.len();
        let id = TableFamilyId(u32::try_from(index).expect("invariant: fewer than 2^32 families"));
        program.table_families.push(TableFamily {
            name: self.taken.claim(format!("at_{}", arguments.join("_"))),
            arguments,
            members: members.to_vec(),
        });
        self.known.insert(members.to_vec(), id);
        id
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::opt::dead_code;
    use crate::opt::tests::assert_same_bits;

    /// Two tables each of two axes, cubic and linear, of one axis and of three; and two that differ from the first in one break, or in its sign.
    fn tables() -> String {
        let table = |signature: &str, breaks: &[&str], kind: &str, count: u32| {
            // Without order: 37 and 101 have no common divisor.
            let numbers = (0..count).map(|at| f64::from((at * 37 + count) % 101) / 32.0 - 1.5);
            let breaks: String = breaks.iter().map(|at| format!("breaks [{at}], ")).collect();
            let numbers: Vec<f64> = numbers.collect();
            format!("table {signature} = {breaks}{kind} {numbers:?}\n")
        };
        let (three, two) = ("0.0, 1.0, 2.0", "0.0, 1.0");
        [
            table("f(a, b)", &[three, two], "cubic clamp", 20),
            table("g(p, q)", &[three, two], "cubic error", 20),
            table("other(a, b)", &["0.0, 1.5, 2.0", two], "cubic clamp", 20),
            table("signed(a, b)", &["-0.0, 1.0, 2.0", two], "cubic clamp", 20),
            table("flat(a, b)", &[three, two], "linear clamp", 6),
            table("ramp(a, b)", &[three, two], "linear error", 6),
            table("one(a)", &[three], "linear clamp", 3),
            table("two(a)", &[three], "linear clamp", 3),
            table("c(a, b, h)", &[two, two, two], "linear clamp", 8),
            table("d(a, b, h)", &[two, two, two], "linear error", 8),
        ]
        .concat()
    }

    /// The members of each family that the pass makes of calls, separated by `; `, of these tables.
    fn families(calls: &str) -> Vec<String> {
        let frame = "input x: real\ninput y: real\n".to_owned()
            + &tables()
            + "%0: real = input x\n%1: real = input y\n";
        let calls: Vec<&str> = calls.split("; ").collect();
        let lines = calls
            .iter()
            .zip(2..)
            .map(|(call, id)| format!("%{id}: real = table {call}\n"));
        let outputs = (2..calls.len() + 2).map(|id| format!("output v{id} = %{id}\n"));
        let text: String = std::iter::once(frame).chain(lines).chain(outputs).collect();
        let before: Program = text.parse().unwrap();
        before.assert_sound();
        let after = dead_code::run(run(before.clone()));
        assert_same_bits(&before, &after, &text);
        let families = after.table_families.iter().map(|family| {
            let members = family.members.iter().map(|member| {
                let name = &after.tables[member.table.0 as usize].name;
                format!(" {name} {:?}", member.orders)
            });
            family.name.clone() + &members.collect::<String>()
        });
        families.collect()
    }

    #[test]
    fn tables_share_the_places_of_the_same_arguments_on_the_same_axes() {
        let check =
            |calls: &str, expected: &[&str]| assert_eq!(families(calls), expected, "{calls}");
        // Also where they differ in what they are outside their axes.
        check(
            "g 0 0, %0, %1; f 0 0, %0, %1",
            &["at_a_b f [0, 0] g [0, 0]"],
        );
        check(
            "flat 0 0, %0, %1; ramp 0 1, %0, %1",
            &["at_a_b flat [0, 0] ramp [0, 1]"],
        );
        check(
            "two 0, %0; one 0, %0; one 1, %0",
            &["at_a one [0] one [1] two [0]"],
        );
        // Derivatives of one table, each once.
        check(
            "f 2 1, %0, %1; f 0 0, %0, %1; f 2 1, %0, %1",
            &["at_a_b f [0, 0] f [2, 1]"],
        );
        check(
            "c 0 1 0, %0, %1, %0; d 1 0 1, %0, %1, %0",
            &["at_a_b_h c [0, 1, 0] d [1, 0, 1]"],
        );
        // The same family at other arguments is the same function.
        check(
            "f 0 0, %0, %1; g 0 0, %0, %1; f 0 0, %1, %0; g 0 0, %1, %0",
            &["at_a_b f [0, 0] g [0, 0]"],
        );
        check(
            "f 0 0, %0, %1; g 0 0, %0, %1; f 0 0, %1, %0; g 1 0, %1, %0",
            &["at_a_b f [0, 0] g [0, 0]", "at_a_b_2 f [0, 0] g [1, 0]"],
        );
    }

    #[test]
    fn tables_of_other_axes_or_arguments_share_nothing() {
        for calls in [
            "f 0 0, %0, %1",
            "f 0 0, %0, %1; f 0 0, %0, %1",
            "f 0 0, %0, %1; other 0 0, %0, %1",
            "f 0 0, %0, %1; signed 0 0, %0, %1",
            "f 0 0, %0, %1; flat 0 0, %0, %1",
            "f 0 0, %0, %1; g 0 0, %1, %0",
            "f 0 0, %0, %1; g 0 0, %0, %0",
            "flat 0 0, %0, %1; one 0, %0",
            "c 0 0 0, %0, %1, %0; d 0 0 0, %0, %1, %1",
        ] {
            assert_eq!(families(calls), [""; 0], "{calls}");
        }
    }
}
