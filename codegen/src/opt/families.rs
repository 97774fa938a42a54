//! Polynomials and families that passes make: each once, under a name of its own.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use crate::ir::{FamilyId, FamilyMember, PolynomialData, PolynomialFamily, PolynomialId, Program};

/// What a family computes: its argument, its members' names and the bits of their coefficients.
type Family = (String, Vec<(String, Vec<u64>)>);

/// What polynomial data computes: its arguments, and its terms with the bits of their coefficients.
type Data = (Vec<String>, Vec<(u64, Vec<u32>)>);

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

    /// A name, with a number if it is taken.
    pub(super) fn claim(&mut self, base: String) -> String {
        let mut name = base.clone();
        let number = self.numbers.entry(base.clone()).or_insert(1);
        while !self.names.insert(name.clone()) {
            *number += 1;
            name = format!("{base}_{number}");
        }
        name
    }
}

/// The polynomials and families of a program while more are made.
pub(super) struct Polynomials {
    /// Names of polynomials, families and bases.
    taken: Taken,
    /// The data and the families made so far.
    data: HashMap<Data, PolynomialId>, // looked up only, never iterated
    families: HashMap<Family, FamilyId>, // likewise
}

impl Polynomials {
    /// Those that a program has.
    pub(super) fn of(program: &Program) -> Polynomials {
        let polynomials = program.polynomials.iter().map(|data| &data.name);
        let families = program.families.iter().map(|family| &family.name);
        let bases = program.bases.iter().map(|basis| &basis.name);
        Polynomials {
            taken: Taken::new(polynomials.chain(families).chain(bases)),
            data: HashMap::new(),
            families: HashMap::new(),
        }
    }

    /// Polynomial data, appended under a name that nothing has, unless it was appended before.
    pub(super) fn add(&mut self, program: &mut Program, data: PolynomialData) -> PolynomialId {
        let bits = |(c, exponents): &(f64, Vec<u32>)| (c.to_bits(), exponents.clone());
        let key = (
            data.arguments.clone(),
            data.terms.iter().map(bits).collect(),
        );
        if let Some(&id) = self.data.get(&key) {
            return id;
        }
        let index = program.polynomials.len();
        let id =
            PolynomialId(u32::try_from(index).expect("invariant: fewer than 2^32 polynomials"));
        let name = self.taken.claim(data.name);
        program.polynomials.push(PolynomialData { name, ..data });
        self.data.insert(key, id);
        id
    }

    /// The family of these members, appended under a name that nothing has, unless it was appended before.
    pub(super) fn add_family(
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
        if let Some(&id) = self.families.get(&key) {
            return id;
        }
        let index = program.families.len();
        let id = FamilyId(u32::try_from(index).expect("invariant: fewer than 2^32 families"));
        program.families.push(PolynomialFamily {
            name: self.taken.claim(format!("at_{argument}")),
            argument: argument.to_owned(),
            members,
        });
        self.families.insert(key, id);
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
