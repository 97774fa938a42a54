//! Identifiers of emitted code. All of them are made here: a name of the specification reaches code only as an identifier that passed
//! [`sanitised`], so it can neither break the syntax nor shadow what the emitted code relies on.

use std::collections::{BTreeMap, BTreeSet};

use nsv_spec::RUST_WORDS;
use proc_macro2::{Ident, Span};

/// Longest identifier; longer names are cut.
const LENGTH: usize = 64;

/// Names with a meaning in emitted functions: the number type and its literals, types, and constants, which `let` would take for patterns.
const OCCUPIED: [&str; 24] = [
    "Clock",
    "FRAC_1_PI",
    "FRAC_PI_2",
    "FRAC_PI_4",
    "HORIZON",
    "INITIAL_STATE",
    "INPUT_LIMIT",
    "Matrix",
    "NOISE_CHANNELS",
    "PI",
    "Params",
    "Prepared",
    "Real",
    "SAFE_INPUT",
    "SAMPLE_TIME",
    "STATES",
    "Sde",
    "State",
    "Status",
    "T",
    "TAU",
    "Vector",
    "real",
    "sparse",
];

/// Types of emitted code that no record may be called.
const TYPES: [&str; 4] = ["Matrix", "Real", "T", "Vector"];

/// `name` as an identifier: ASCII letters, digits and `_`, not starting with a digit, no keyword and no occupied name, of limited length.
/// A valid identifier that collides with nothing stays as it is.
fn sanitised(name: &str) -> String {
    let mut identifier: String = name
        .chars()
        .map(|c| if c.is_ascii_alphanumeric() { c } else { '_' })
        .take(LENGTH)
        .collect();
    if identifier.chars().all(|c| c == '_') {
        identifier.insert_str(0, "value");
    }
    if identifier.starts_with(|c: char| c.is_ascii_digit()) {
        identifier.insert(0, 'n');
    }
    if RUST_WORDS.contains(&identifier.as_str())
        || OCCUPIED.binary_search(&identifier.as_str()).is_ok()
    {
        identifier.push('_');
    }
    identifier
}

/// An identifier of the compiler's own, such as a keyword-free function name.
pub(crate) fn ident(name: &str) -> Ident {
    debug_assert_eq!(
        name,
        name.replace(|c: char| !(c.is_ascii_alphanumeric() || c == '_'), "")
    );
    Ident::new(name, Span::call_site())
}

/// `name` in snake case: `CL.alpha` is `cl_alpha`, `NsvAttitude` is `nsv_attitude`.
pub(crate) fn snake(name: &str) -> String {
    let mut snake = String::new();
    let mut after_lower = false;
    for c in name.chars() {
        if c.is_ascii_uppercase() && after_lower {
            snake.push('_');
        }
        after_lower = c.is_ascii_lowercase() || c.is_ascii_digit();
        snake.push(if c.is_ascii_alphanumeric() {
            c.to_ascii_lowercase()
        } else {
            '_'
        });
    }
    snake
}

/// `name` in upper camel case: `control_law` is `ControlLaw`.
pub(crate) fn camel(name: &str) -> String {
    let words = name
        .split(|c: char| !c.is_ascii_alphanumeric())
        .filter(|word| !word.is_empty());
    words
        .map(|word| word[..1].to_ascii_uppercase() + &word[1..])
        .collect()
}

/// A type's name for `name`: upper camel case, told apart from the types that emitted code uses.
pub(crate) fn type_name(name: &str) -> String {
    let name = camel(name);
    if name.is_empty()
        || name.starts_with(|c: char| c.is_ascii_digit())
        || TYPES.contains(&name.as_str())
    {
        return format!("Record{name}");
    }
    name
}

/// The identifiers of one name space, each given once.
#[derive(Clone, Debug, Default)]
pub(crate) struct Scope {
    taken: BTreeSet<String>,
    /// The number behind the last identifier that was wanted by several names.
    numbers: BTreeMap<String, usize>,
}

impl Scope {
    /// An identifier for `name`: its sanitised form, with a number behind it if that is taken.
    pub(crate) fn claim(&mut self, name: &str) -> Ident {
        let wanted = sanitised(name);
        if self.taken.insert(wanted.clone()) {
            return ident(&wanted);
        }
        let number = self.numbers.entry(wanted.clone()).or_insert(1);
        loop {
            *number += 1;
            let numbered = format!("{wanted}_{number}");
            if self.taken.insert(numbered.clone()) {
                return ident(&numbered);
            }
        }
    }

    /// The first free of `t1`, `t2`, ... from number `*next`, which moves behind it.
    pub(crate) fn temporary(&mut self, next: &mut usize) -> Ident {
        loop {
            *next += 1;
            let name = format!("t{next}");
            if self.taken.insert(name.clone()) {
                return ident(&name);
            }
        }
    }
}

/// The fields of a struct, by the names they have in the specification or in a program.
#[derive(Clone, Debug, Default)]
pub(crate) struct Fields {
    by_name: BTreeMap<String, Ident>,
}

impl Fields {
    /// Fields for `names`, in their order.
    pub(crate) fn new<'a>(names: impl IntoIterator<Item = &'a str>) -> Fields {
        let mut scope = Scope::default();
        let by_name = names
            .into_iter()
            .map(|name| (name.to_owned(), scope.claim(name)))
            .collect();
        Fields { by_name }
    }

    /// The field of `name`.
    pub(crate) fn get(&self, name: &str) -> &Ident {
        self.by_name
            .get(name)
            .unwrap_or_else(|| panic!("invariant: `{name}` is a field"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_word_of_rust_and_of_the_emitted_code_is_changed() {
        assert!(OCCUPIED.is_sorted());
        for word in RUST_WORDS.iter().chain(&OCCUPIED) {
            assert_eq!(sanitised(word), format!("{word}_"));
        }
    }

    #[test]
    fn identifiers_stay_and_everything_else_becomes_one() {
        let cases = [
            ("alpha", "alpha"),
            ("A_hat1", "A_hat1"),
            ("CL.alpha", "CL_alpha"),
            ("type", "type_"),
            ("gen", "gen_"),
            ("self", "self_"),
            ("T", "T_"),
            ("real", "real_"),
            ("STATES", "STATES_"),
            ("1st", "n1st"),
            ("", "value"),
            ("_", "value_"),
            ("a b", "a_b"),
            ("x; std::process::exit(1)", "x__std__process__exit_1_"),
            ("\u{3b1}\u{202e}", "value__"),
        ];
        for (name, expected) in cases {
            assert_eq!(sanitised(name), expected, "{name:?}");
            assert!(syn::parse_str::<Ident>(expected).is_ok(), "{expected}");
        }
        assert_eq!(sanitised(&"a".repeat(1000)).len(), LENGTH);
    }

    #[test]
    fn colliding_names_are_told_apart() {
        let mut scope = Scope::default();
        let claimed: Vec<String> = ["a.b", "a_b", "a b", "t1"]
            .map(|name| scope.claim(name).to_string())
            .into();
        assert_eq!(claimed, ["a_b", "a_b_2", "a_b_3", "t1"]);
        let mut next = 0;
        assert_eq!(scope.temporary(&mut next).to_string(), "t2");
        assert_eq!(scope.temporary(&mut next).to_string(), "t3");
    }

    #[test]
    fn cases_change_words() {
        assert_eq!(snake("CL.alpha"), "cl_alpha");
        assert_eq!(snake("NearSpaceVehicle2D"), "near_space_vehicle2_d");
        assert_eq!(camel("control_law"), "ControlLaw");
        assert_eq!(camel("a..b"), "AB");
    }
}
