//! Every limit on the size and depth of what is read, from the constants that hold it.

use crate::check::limits as check;
use crate::diagnostic::Rule;
use crate::{compose, expr, include, model, parse, unit, yaml};

/// A limit of the reader.
#[derive(Clone, Copy, Debug)]
pub struct Limit {
    /// What is limited.
    pub what: &'static str,
    /// The most that is accepted.
    pub most: f64,
    /// The fault of what is more.
    pub rule: Rule,
}

const fn limit(what: &'static str, most: usize, rule: Rule) -> Limit {
    Limit {
        what,
        most: most as f64,
        rule,
    }
}

/// Every limit, from files to numbers.
pub const LIMITS: &[Limit] = &[
    limit(
        "bytes of a file: specification, fragment or data",
        yaml::MAX_BYTES,
        Rule::E0001,
    ),
    limit(
        "files of one specification, itself included",
        include::MAX_FILES,
        Rule::E0023,
    ),
    limit(
        "fragments that include each other, in a chain",
        include::MAX_DEPTH,
        Rule::E0023,
    ),
    limit(
        "data files of one specification",
        include::MAX_DATA_FILES,
        Rule::E0023,
    ),
    limit(
        "depth of lists and maps in YAML",
        yaml::MAX_DEPTH,
        Rule::E0005,
    ),
    limit(
        "values in a YAML file, aliases written out",
        yaml::MAX_NODES,
        Rule::E0006,
    ),
    limit("aliases in a YAML file", yaml::MAX_ALIASES, Rule::E0006),
    limit("bytes of a name", check::NAME, Rule::E0110),
    limit("bytes of an expression", expr::MAX_TEXT, Rule::E0207),
    limit("depth of an expression", expr::MAX_DEPTH, Rule::E0206),
    limit("operations of an expression", expr::MAX_NODES, Rule::E0207),
    limit(
        "operations that calls and loops insert into one specification",
        expr::MAX_INSERTED,
        Rule::E0211,
    ),
    limit(
        "calls of functions within each other",
        expr::MAX_CALLS,
        Rule::E0211,
    ),
    limit(
        "rounds of an `each`",
        expr::MAX_ROUNDS as usize,
        Rule::E0210,
    ),
    limit(
        "unknowns of a `solve` or `inverse`",
        expr::MAX_UNKNOWNS,
        Rule::E0501,
    ),
    limit(
        "faults that one expression reports",
        expr::MAX_FAULTS,
        Rule::E0201,
    ),
    limit(
        "brackets within each other in a unit",
        unit::MAX_DEPTH,
        Rule::E0402,
    ),
    limit(
        "exponent in a dimension",
        unit::LARGEST as usize,
        Rule::E0406,
    ),
    limit(
        "exponent in polynomial data",
        parse::MAX_EXPONENT as usize,
        Rule::E0107,
    ),
    limit("axes of a table", check::AXES, Rule::E0324),
    limit("points of an axis", check::POINTS, Rule::E0324),
    limit("values of a table", check::VALUES, Rule::E0324),
    limit("blocks of a plant", check::BLOCKS, Rule::E0602),
    limit("states of a block", check::WIDTH, Rule::E0602),
    limit("states of an exosystem", check::EXOSYSTEM, Rule::E0503),
    limit("nodes of a network", check::NETWORK, Rule::E0609),
    Limit {
        what: "magnitude in SI of a gain, parameter or other number under a key of its own, and of its inverse",
        most: check::NUMBER,
        rule: Rule::E0602,
    },
    limit("plant steps of one sample", check::SUBSTEPS, Rule::E0602),
    limit(
        "plant steps of one run",
        model::MAX_STEPS as usize,
        Rule::E0602,
    ),
    limit("runs of a campaign", check::RUNS, Rule::E0602),
    limit("variants of a sweep", compose::MAX_VARIANTS, Rule::E0033),
    limit(
        "delay of an actuator, in plant steps",
        check::DELAY,
        Rule::E0613,
    ),
];

const INTRODUCTION: &str = "\
# Limits

A specification is untrusted text: nothing in it makes the compiler panic, hang or take memory without bound, and none of it reaches a shell,
an evaluator or a path outside its directory. This page is written by `NSV_UPDATE_DOCS=1 cargo test -p nsv-codegen --test limits` from the
constants that hold the limits.

## What is read

| what | most | fault beyond |
|---|---|---|
";

const TIME: &str = "
## Time and memory

Within these limits a specification is read and checked, or refused, in less than a second by an optimised build on one core, in less than
1 GB. That is what the fuzzer holds every input to (`tests/fuzz/README.md`); tests hold hostile texts that are
larger than its inputs to 5 seconds in an unoptimised build: a file of 10 MB, 100,000 brackets, an alias bomb, 10,000 definitions
(`nsv-spec/tests/gallery.rs`).
";

/// The part of the page that belongs to the reader; the compiler adds its own.
pub fn limits_reference() -> String {
    let mut page = INTRODUCTION.to_owned();
    for Limit { what, most, rule } in LIMITS {
        let most = match *most {
            huge if huge >= 1e16 => format!("{huge:e}"),
            most => most.to_string(),
        };
        page.push_str(&format!("| {what} | {most} | `{rule}` |\n"));
    }
    page.push_str(TIME);
    page
}
