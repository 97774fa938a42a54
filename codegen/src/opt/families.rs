//! Polynomial families that passes make: each once, under a name of its own.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use crate::ir::{FamilyId, FamilyMember, PolynomialFamily, Program};

/// What a family computes: its argument, its members' names and the bits of their coefficients.
type Content = (String, Vec<(String, Vec<u64>)>);

/// The families of a program while more are made.
pub(super) struct Families {
    /// Names of all tables.
    taken: BTreeSet<String>,
    /// The next number for a name that is taken.
    numbers: BTreeMap<String, usize>,
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
            taken: polynomials.chain(families).chain(bases).cloned().collect(),
            numbers: BTreeMap::new(),
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
        let base = format!("at_{argument}");
        let mut name = base.clone();
        let number = self.numbers.entry(base.clone()).or_insert(1);
        while !self.taken.insert(name.clone()) {
            *number += 1;
            name = format!("{base}_{number}");
        }
        let index = program.families.len();
        let id = FamilyId(u32::try_from(index).expect("invariant: fewer than 2^32 families"));
        program.families.push(PolynomialFamily {
            name,
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
