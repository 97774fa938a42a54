//! The page of limits says what the compiler does: it is written from the constants, and what is more is refused with the fault that it names.

use std::path::Path;
use std::{env, fs};

use nsv_codegen::limits::limits_reference;
use nsv_spec::limits::LIMITS;
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
        _ => String::new(),
    }
}

#[test]
fn the_most_is_accepted_and_one_more_is_refused_with_its_fault() {
    let mut tried = 0;
    for limit in LIMITS {
        let most = limit.most as usize;
        let text = with(limit.what, most);
        if text.is_empty() {
            continue;
        }
        tried += 1;
        if let Err(faults) = load_str("limits.yaml", &text) {
            panic!("{}: {}", limit.what, faults.short());
        }
        // Operations are counted in steps of two here.
        let beyond = if limit.what.starts_with("operations") {
            most + 4
        } else {
            most + 1
        };
        let faults = load_str("limits.yaml", &with(limit.what, beyond)).expect_err(limit.what);
        let codes: Vec<&str> = faults.items.iter().map(|item| item.rule.name()).collect();
        assert!(
            codes.contains(&limit.rule.name()),
            "{}: {codes:?}",
            limit.what
        );
    }
    assert_eq!(tried, 13);
}
