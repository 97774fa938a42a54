//! Families that passes make: each once, under a name of its own.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use crate::ir::{FamilyId, FamilyMember, PolynomialFamily, Program};

/// What a family computes: its argument, its members' names and the bits of their coefficients.
type Content = (String, Vec<(String, Vec<u64>)>);

/// Names that are taken.
#[derive(Default)]
pub(super) struct Taken {
    names: BTreeSet<String>,
    /// The last number that made a name another one.
    numbers: BTreeMap<String, usize>,
}

impl Taken {
    /// These names.
    pub(super) fn new<'n>(names: impl Iterator<Item = &'n String>) -> Taken {
        Taken {
            names: names.cloned().collect(),
            numbers: BTreeMap::new(),
        }
    }

    /// The name of a family at arguments, with a number if it is taken.
    pub(super) fn claim(&mut self, arguments: &str) -> String {
        let base = format!("at_{arguments}");
        let mut name = base.clone();
        let number = self.numbers.entry(base.clone()).or_insert(1);
        while !self.names.insert(name.clone()) {
            *number += 1;
            name = format!("{base}_{number}");
        }
        name
    }
}

/// The polynomial families of a program while more are made.
pub(super) struct Families {
    /// Names of polynomials, families and bases.
    taken: Taken,
    /// The families made so far.
    known: HashMap<Content, FamilyId>, // looked up only, never iterated
}

impl Families {
    /// The families that a program has.
    pub(super) fn of(program: &Program) -> Families {
        let polynomials = program.polynomials.iter().map(|data| &data.name);
        let families = program.families.iter().map(|family| &family.name);
        let bases = program.bases.iter().map(|basis| &basis.name);
        Families {
            taken: Taken::new(polynomials.chain(families).chain(bases)),
            known: HashMap::new(),
        }
    }

    /// The family of these members, appended under a name that no table has, unless it was appended before.
    pub(super) fn add(
        &mut self,
        program: &mut Program,
        argument: &str,
        members: Vec<FamilyMember>,
    ) -> FamilyId {
        let bits = |member: &FamilyMember| {
            let bits = member.coefficients.iter().map(|c| c.to_bits()).collect();
            (member.name.clone(), bits)
        };
        let key = (argument.to_owned(), members.iter().map(bits).collect());
        if let Some(&id) = self.known.get(&key) {
            return id;
        }
        let index = program.families.len();
        let id = FamilyId(u32::try_from(index).expect("invariant: fewer than 2^32 families"));
        program.families.push(PolynomialFamily {
            name: self.taken.claim(argument),
            argument: argument.to_owned(),
            members,
        });
        self.known.insert(key, id);
        id
    }
}

/// Numbers names that were given before.
pub(super) fn tell_apart<'a>(names: impl Iterator<Item = &'a mut String>) {
    let mut given: BTreeMap<String, usize> = BTreeMap::new();
    for name in names {
        let base = name.clone();
        let mut number = given.get(&base).copied().unwrap_or(0);
        while given.contains_key(name) {
            number += 1;
            *name = format!("{base}_{}", number + 1);
        }
        given.insert(base, number);
        given.insert(name.clone(), 0);
    }
}
