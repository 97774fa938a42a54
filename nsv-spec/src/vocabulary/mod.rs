//! Every key of the language with its kind and meaning: the one table that both the parser and the JSON Schema are made from.

mod controller;
mod data;
mod details;
mod dispersion;
mod hardware;
mod plant;

pub(crate) use controller::{CONTROLLER, CONTROLLER_BLOCK, ERROR_BOUND, NETWORK, NOISE_BOUND};
pub(crate) use data::{AXIS, CONSTANT, FUNCTION, PARAMETER, POLYNOMIAL, TABLE};
use data::{CONSTANT_KIND, PARAMETER_KIND};
pub(crate) use details::{Details, details};
pub(crate) use dispersion::{CORRELATION, DISPERSION};
pub(crate) use hardware::{ACTUATOR, FAULT, SENSOR};
pub(crate) use plant::{EXOSYSTEM, INPUT, NOISE, PLANT, PLANT_BLOCK, STATE, TRUTH};

/// A map with known keys.
#[derive(Debug)]
pub struct Section {
    /// What it is, with article, for messages: `a network`.
    pub noun: &'static str,
    /// Its keys, in the order in which they are best written.
    pub keys: &'static [Key],
}

/// One key of a section.
#[derive(Debug)]
pub struct Key {
    /// The key.
    pub name: &'static str,
    /// What stands behind it.
    pub kind: Kind,
    /// Whether it must be there. Keys whose need depends on other choices are not required here but checked later.
    pub required: bool,
    /// Its meaning.
    pub doc: &'static str,
}

impl Key {
    /// Whether a map stands behind it.
    pub(crate) fn has_map(&self) -> bool {
        matches!(self.kind, Kind::Section(_) | Kind::Named(_))
    }
}

/// What may stand behind a key.
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    /// Text for people.
    Text,
    /// A whole number from 0.
    Count,
    /// One of these words.
    Choice(&'static [&'static str]),
    /// A number with its unit, or an expression of constants.
    Quantity,
    /// One expression: text or a number.
    Expression,
    /// An expression: text, a number, or a nested list of these.
    Formula,
    /// Plain numbers: one, or lists within lists of them.
    Grid,
    /// A list.
    List(&'static Kind),
    /// A map with known keys.
    Section(&'static Section),
    /// A map from names that the user chooses, or one entry for each of those.
    Named(&'static Kind),
    /// A map from some names that are declared elsewhere.
    ByName(&'static Kind),
    /// A map from paths in the specification to lists of values.
    Sweep,
    /// Any of these.
    Either(&'static [Kind]),
}

const fn required(name: &'static str, kind: Kind, doc: &'static str) -> Key {
    Key {
        name,
        kind,
        required: true,
        doc,
    }
}

const fn optional(name: &'static str, kind: Kind, doc: &'static str) -> Key {
    Key {
        name,
        kind,
        required: false,
        doc,
    }
}

/// What has a key of that name, in the order of the language.
pub(crate) fn places_of(key: &str) -> Vec<&'static str> {
    let mut places = Vec::new();
    search(&Kind::Section(&SPECIFICATION), key, &mut places);
    places
}

fn search(kind: &Kind, key: &str, places: &mut Vec<&'static str>) {
    match kind {
        Kind::Section(section) => {
            for known in section.keys {
                if known.name == key && !places.contains(&section.noun) {
                    places.push(section.noun);
                }
                search(&known.kind, key, places);
            }
        }
        Kind::List(inner) | Kind::Named(inner) | Kind::ByName(inner) => search(inner, key, places),
        Kind::Either(kinds) => kinds.iter().for_each(|kind| search(kind, key, places)),
        _ => {}
    }
}

/// A quantity or the word `auto`.
const QUANTITY_OR_AUTO: Kind = Kind::Either(&[Kind::Choice(&["auto"]), Kind::Quantity]);
const FORMULAS: Kind = Kind::Named(&Kind::Formula);

/// What a file declares with a value of one's own.
const ARGUMENT_KIND: Kind = Kind::Either(&[Kind::Formula, Kind::Section(&PARAMETER)]);
const INCLUDE_KIND: Kind = Kind::Either(&[Kind::Text, Kind::Section(&INCLUDE)]);

/// The long form of an included file.
pub static INCLUDE: Section = Section {
    noun: "an include",
    keys: &[
        required("file", Kind::Text, "the file"),
        optional(
            "with",
            Kind::ByName(&ARGUMENT_KIND),
            "values for constants and parameters that the file declares",
        ),
    ],
};

/// The whole specification.
pub static SPECIFICATION: Section = Section {
    noun: "a specification",
    keys: &[
        required(
            "nsv",
            Kind::Count,
            "version of the specification language: 1",
        ),
        required(
            "name",
            Kind::Text,
            "name of the generated module: a Rust identifier in snake case",
        ),
        optional(
            "title",
            Kind::Text,
            "one line for people; default: the name",
        ),
        optional(
            "include",
            Kind::List(&INCLUDE_KIND),
            "files with further sections, relative to this file and below its directory, each with values for what it declares if need be",
        ),
        optional(
            "extends",
            Kind::Text,
            "specification that this one changes: its keys are laid over those of that file, maps key by key; `~` takes a key away",
        ),
        optional(
            "constants",
            Kind::Named(&CONSTANT_KIND),
            "compile-time constants",
        ),
        optional(
            "parameters",
            Kind::Named(&PARAMETER_KIND),
            "run-time parameters, fields of the emitted `Params`",
        ),
        optional(
            "correlations",
            Kind::List(&Kind::Section(&CORRELATION)),
            "parameters that are drawn together in each run",
        ),
        optional(
            "polynomials",
            Kind::Named(&Kind::Section(&POLYNOMIAL)),
            "groups of polynomial data, such as aerodynamic coefficients",
        ),
        optional(
            "tables",
            Kind::Named(&Kind::Section(&TABLE)),
            "lookup tables of one to three arguments",
        ),
        optional(
            "functions",
            Kind::Named(&Kind::Section(&FUNCTION)),
            "functions of your own, in any order, without cycles",
        ),
        optional(
            "definitions",
            FORMULAS,
            "named intermediate quantities, in any order, without cycles",
        ),
        required(
            "plant",
            Kind::Section(&PLANT),
            "the system to be controlled",
        ),
        required(
            "reference",
            FORMULAS,
            "reference of every output channel: a function of time",
        ),
        required(
            "controller",
            Kind::Section(&CONTROLLER),
            "the design choices of the control law",
        ),
        required(
            "scenario",
            Kind::Section(&SCENARIO),
            "how the closed loop is simulated",
        ),
    ],
};

/// The scenario.
pub static SCENARIO: Section = Section {
    noun: "a scenario",
    keys: &[
        required("horizon", Kind::Quantity, "length of a run"),
        optional(
            "substeps",
            Kind::Count,
            "plant steps for each controller sample; default: 4",
        ),
        optional(
            "scheme",
            Kind::Choice(&["euler_maruyama", "platen", "rk4"]),
            "integration of the plant; default: rk4, with wiener noise euler_maruyama",
        ),
        optional(
            "noise",
            Kind::Choice(&["sampled", "wiener"]),
            "draws held over a sample, or Wiener increments; default: sampled",
        ),
        optional("seed", Kind::Count, "campaign seed; default: 1"),
        optional("runs", Kind::Count, "number of runs; default: 1"),
        optional(
            "settle",
            Kind::Quantity,
            "start of the window for rms values and settled ratios; default: 0 s",
        ),
        optional(
            "sweep",
            Kind::Sweep,
            "paths with values: every combination is a variant that is checked and flown",
        ),
    ],
};
