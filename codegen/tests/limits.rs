//! The page of limits says what the compiler does: it is written from the constants, and what is more is refused with the fault that it names.

use std::path::Path;
use std::{env, fs};

use nsv_codegen::limits::limits_reference;
use nsv_spec::limits::{LIMITS, Limit};
use nsv_spec::load_str;

#[test]
fn the_page_in_the_repository_is_the_one_that_the_constants_make() {
    let path = Path::new("../docs/limits.md");
    if env::var_os("NSV_UPDATE_DOCS").is_some() {
        fs::write(path, limits_reference()).unwrap();
    }
    assert!(
        fs::read_to_string(path).unwrap_or_default() == limits_reference(),
        "docs/limits.md is stale: NSV_UPDATE_DOCS=1 cargo test -p nsv-codegen --test limits"
    );
}

/// A specification with a top-level section of its own and a drift.
fn specification(section: &str, drift: &str) -> String {
    format!(
        "nsv: 1\nname: limits\n{section}\nplant:\n  blocks: {{b: {{states: {{x: 0.1}}, drift: {drift:?}, gain: 1/(1 s)}}}}\n  inputs: {{force: 5}}\n\
         reference: {{x: 0}}\ncontroller: {{sample_time: 2 ms, blocks: {{b: {{K: 1, kbar: 1, C: 5}}}}}}\n\
         scenario: {{horizon: 5 s, substeps: 4, scheme: rk4, noise: sampled}}\n"
    )
}

fn repeated(part: &str, count: usize, separator: &str) -> String {
    vec![part; count].join(separator)
}

/// A specification with `count` of something.
fn with(what: &str, count: usize) -> String {
    let table = |axes: &str, values: String| {
        let section = format!(
            "tables: {{l: {{axes: {{{axes}}}, values: [{values}], interpolation: linear, extrapolation: clamp}}}}"
        );
        specification(&section, "-x/(1 s)")
    };
    let numbers = |count: usize| {
        (0..count)
            .map(|at| at.to_string())
            .collect::<Vec<_>>()
            .join(", ")
    };
    let drift = |text: String| specification("", &format!("({text})/(1 s)"));
    match what {
        "bytes of a file: specification, fragment or data" => {
            let text = specification("", "-x/(1 s)");
            let rest = count - text.len();
            format!("{text}#{}\n", " ".repeat(rest - 2))
        }
        "bytes of a name" => specification(
            &format!("constants: {{{}: 1}}", "a".repeat(count)),
            "-x/(1 s)",
        ),
        "bytes of an expression" => {
            specification("", &format!("{}-x/(1 s)", " ".repeat(count - 8)))
        }
        "depth of an expression" => specification(
            "",
            &format!("{}x/(1 s){}", "(".repeat(count - 3), ")".repeat(count - 3)),
        ),
        "operations of an expression" => drift(repeated("x", count / 2 - 1, "+")),
        "calls of functions within each other" => {
            let inner = (2..=count)
                .map(|at| format!("f{at}: {{arguments: [a], value: f{}(a) + 1}}", at - 1));
            let first = "f1: {arguments: [a], value: a + 1}".to_owned();
            let functions: Vec<String> = std::iter::once(first).chain(inner).collect();
            specification(
                &format!("functions: {{{}}}", functions.join(", ")),
                &format!("-f{count}(x)/(1 s)"),
            )
        }
        "unknowns of a `solve` or `inverse`" => {
            let row = |at: usize| {
                let entry = |other: usize| if other == at { "2" } else { "0" };
                format!("[{}]", (0..count).map(entry).collect::<Vec<_>>().join(", "))
            };
            let rows: Vec<String> = (0..count).map(row).collect();
            let right = vec!["x"; count].join(", ");
            drift(format!("solve([{}], [{right}])[1]", rows.join(", ")))
        }
        "blocks of a plant" => {
            let block = |at: usize| {
                format!("b{at}: {{states: {{y{at}: 0}}, drift: \"-y{at}/(1 s)\", gain: 1/(1 s)}}")
            };
            let gains = |at: usize| {
                format!("b{at}: {{K: 1, kbar: 1, C: 5, filter: 1 s, eta_2: 1, eta_3: 1}}")
            };
            let last = format!("b{count}: {{K: 1, kbar: 1, C: 5}}");
            let blocks: Vec<String> = (1..=count).map(block).collect();
            let gains: Vec<String> = (1..count).map(gains).chain([last]).collect();
            specification("", "-x/(1 s)")
                .replace(
                    "{b: {states: {x: 0.1}, drift: \"-x/(1 s)\", gain: 1/(1 s)}}",
                    &format!("{{{}}}", blocks.join(", ")),
                )
                .replace(
                    "{b: {K: 1, kbar: 1, C: 5}}",
                    &format!("{{{}}}", gains.join(", ")),
                )
                .replace("{x: 0}", "{y1: 0}")
        }
        "states of a block" => {
            let list = |item: &dyn Fn(usize) -> String| {
                (1..=count).map(item).collect::<Vec<_>>().join(", ")
            };
            let row = |at: usize| {
                let entry = |other: usize| if other == at { "1/(1 s)" } else { "0" };
                format!(
                    "[{}]",
                    (1..=count).map(entry).collect::<Vec<_>>().join(", ")
                )
            };
            specification("", "-x/(1 s)")
                .replace(
                    "{x: 0.1}",
                    &format!("{{{}}}", list(&|at| format!("y{at}: 0.1"))),
                )
                .replace(
                    "\"-x/(1 s)\"",
                    &format!("[{}]", list(&|at| format!("\"-y{at}/(1 s)\""))),
                )
                .replace("gain: 1/(1 s)", &format!("gain: [{}]", list(&row)))
                .replace(
                    "{force: 5}",
                    &format!("{{{}}}", list(&|at| format!("u{at}: 5"))),
                )
                .replace(
                    "{x: 0}",
                    &format!("{{{}}}", list(&|at| format!("y{at}: 0"))),
                )
        }
        "variants of a sweep" => specification("", "-x/(1 s)").replace(
            "substeps: 4",
            &format!(
                "sweep: {{controller.blocks.b.K: [{}]}}",
                numbers(count + 1).replacen("0, ", "", 1)
            ),
        ),
        "rounds of an `each`" => drift(format!("sum(each(i, 1, {count}, i*x))")),
        "brackets within each other in a unit" => {
            let unit = format!("{}m{}", "(".repeat(count), ")".repeat(count));
            specification(
                &format!("constants: {{a: {{value: 1, unit: \"{unit}\"}}}}"),
                "-x/(1 s)",
            )
        }
        "exponent in a dimension" => specification(
            &format!("constants: {{a: (1 m^32)*(1 m^{})}}", count - 32),
            "-x/(1 s)",
        ),
        "exponent in polynomial data" => specification(
            &format!("polynomials: {{p: {{arguments: [u], parts: {{q: [[1, {count}]]}}}}}}"),
            "-x/(1 s)",
        ),
        "axes of a table" => {
            let axes: Vec<String> = (0..count).map(|at| format!("u{at}: [0, 1]")).collect();
            let values = (1..count).fold("1, 2".to_owned(), |inner, _| {
                format!("[{inner}], [{inner}]")
            });
            table(&axes.join(", "), values)
        }
        "points of an axis" => table(&format!("u: [{}]", numbers(count)), numbers(count)),
        "plant steps of one sample" => {
            specification("", "-x/(1 s)").replace("substeps: 4", &format!("substeps: {count}"))
        }
        "runs of a campaign" => {
            specification("", "-x/(1 s)").replace("substeps: 4", &format!("runs: {count}"))
        }
        what => panic!("no specification shows the most and what is more: {what}"),
    }
}

/// Limits that take several files, much text or a scenario of their own to show.
const ELSEWHERE: &[&str] = &[
    MAGNITUDE,
    "files of one specification, itself included",
    "fragments that include each other, in a chain",
    "data files of one specification",
    "depth of lists and maps in YAML",
    "values in a YAML file, aliases written out",
    "aliases in a YAML file",
    "operations that calls and loops insert into one specification",
    "faults that one expression reports",
    "values of a table",
    "states of an exosystem",
    "nodes of a network",
    "plant steps of one run",
    "delay of an actuator, in plant steps",
];

#[test]
fn the_most_is_accepted_and_one_more_is_refused_with_its_fault() {
    for what in ELSEWHERE {
        assert!(LIMITS.iter().any(|limit| limit.what == *what), "{what}");
    }
    for limit in LIMITS
        .iter()
        .filter(|limit| !ELSEWHERE.contains(&limit.what))
    {
        let most = limit.most as usize;
        // Operations are counted in steps of two here.
        let beyond = match limit.what {
            what if what.starts_with("operations") => most + 4,
            _ => most + 1,
        };
        check(limit, &with(limit.what, most), &with(limit.what, beyond));
    }
}

const MAGNITUDE: &str = "magnitude in SI of a gain, parameter or other number under a key of its own, and of its inverse";

#[test]
fn numbers_whose_powers_overflow_are_refused() {
    let limit = LIMITS.iter().find(|limit| limit.what == MAGNITUDE).unwrap();
    let with = |key: &str, value: &str| {
        specification("", "-x/(1 s)").replace(&format!("{key}: 1,"), &format!("{key}: {value},"))
    };
    for (key, most, beyond) in [
        ("K", "1e50", "1.1e50"),
        ("kbar", "1e50", "1e308"),
        ("kbar", "1e-50", "9e-51"),
        ("K", "1e-50", "1e-310"),
    ] {
        check(limit, &with(key, most), &with(key, beyond));
    }
}

/// The first text is accepted, the second refused with the fault of the limit.
fn check(limit: &Limit, most: &str, beyond: &str) {
    if let Err(faults) = load_str("limits.yaml", most) {
        panic!("{}: {}", limit.what, faults.short());
    }
    let faults = load_str("limits.yaml", beyond).expect_err(limit.what);
    let codes: Vec<&str> = faults.items.iter().map(|item| item.rule.name()).collect();
    assert!(
        codes.contains(&limit.rule.name()),
        "{}: {codes:?}",
        limit.what
    );
}
