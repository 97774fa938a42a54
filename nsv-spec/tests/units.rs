//! The page on units says what the compiler does, and the lints on angles find slips and nothing else.

use std::path::Path;
use std::{env, fs};

use nsv_spec::diagnostic::Diagnostic;
use nsv_spec::unit::{parse_unit, units_reference};
use nsv_spec::{load, load_str};

#[test]
fn the_page_in_the_repository_is_the_one_that_the_table_makes() {
    let path = Path::new("../docs/units.md");
    if env::var_os("NSV_UPDATE_DOCS").is_some() {
        fs::write(path, units_reference()).unwrap();
    }
    assert!(
        fs::read_to_string(path).unwrap_or_default() == units_reference(),
        "docs/units.md is stale: NSV_UPDATE_DOCS=1 cargo test -p nsv-spec --test units"
    );
}

#[test]
fn units_of_the_page_are_read_with_and_without_their_prefixes() {
    let page = units_reference();
    let rows = page.lines().filter_map(|line| line.strip_prefix("| `"));
    let units: Vec<&str> = rows
        .clone()
        .filter(|row| row.matches('|').count() == 4)
        .collect();
    assert!(units.len() > 40);
    for row in units {
        let cells: Vec<&str> = row.split(" | ").collect();
        let name = cells[0].trim_end_matches('`');
        let unit = parse_unit(name).unwrap();
        assert_eq!(unit.scale, cells[2].parse::<f64>().unwrap(), "{name}");
        let prefixed = parse_unit(&format!("M{name}")).is_ok();
        assert_eq!(prefixed, cells[1] == "+", "{name}");
    }
}

fn plant(definitions: &str, reference: &str) -> Vec<Diagnostic> {
    let text = format!(
        "nsv: 1\nname: angles\n{definitions}plant:\n  blocks:\n    pitch: {{states: {{alpha: 5 deg, beta: 1 rad}}, drift: \"[alpha, beta]/(1 s)\", \
         gain: [[1/(1 s), 0/(1 s)], [0/(1 s), 1/(1 s)]]}}\n  inputs: {{a: 5, b: 5}}\nreference: {{alpha: {reference}, beta: 2}}\n\
         controller: {{sample_time: 2 ms, blocks: {{pitch: {{K: 1, kbar: 1, C: 5}}}}}}\n\
         scenario: {{horizon: 5 s, substeps: 4, scheme: rk4, noise: sampled}}\n"
    );
    let loaded = load_str("angles.yaml", &text);
    let (_, mut warnings) = loaded.unwrap_or_else(|faults| panic!("{}", faults.short()));
    warnings.retain(|warning| warning.rule.name() >= "W0010");
    warnings
}

fn of_definition(expression: &str) -> String {
    let found = plant(
        &format!("definitions: {{count: alpha/(1 deg), d: {expression:?}}}\n"),
        "0",
    );
    let shown = found.iter().map(|warning| {
        format!(
            "{} {}; {}",
            warning.rule,
            warning.message,
            warning.help.as_deref().unwrap_or_default()
        )
    });
    shown.collect::<Vec<_>>().join("\n")
}

#[test]
fn degrees_in_a_function_of_radians_are_a_warning() {
    let remedy = "leave out the division: nsv keeps angles in radians";
    for expression in [
        "sin(alpha/(1 deg))",
        "2*cos((alpha + beta)/(1 deg))",
        "sum(each(i, 1, 2, tan(i*alpha/(1 deg))))",
    ] {
        let found = of_definition(expression);
        assert!(
            found.starts_with("W0010") && found.ends_with(remedy),
            "{expression}: {found}"
        );
    }
    assert_eq!(
        of_definition("sin(45)"),
        "W0010 `sin` takes radians, found the number 45; write `45 deg`"
    );
    assert_eq!(
        of_definition("sin(count)"),
        "W0010 `sin` takes radians, found `count`, a number of degrees; use the angle itself, which nsv keeps in radians"
    );
}

#[test]
fn honest_angles_are_no_warning() {
    for expression in [
        "sin(alpha)",
        "sin(45 deg)",
        "sin(2)",
        "count*beta",
        "sin(2*pi*t/(1 s))",
        "exp(alpha/(1 deg))",
        "sin(alpha/(1 rad))",
        "sin(10*alpha)",
        "sin(alpha/2)",
    ] {
        let expression = expression.replace("t/(1 s)", "beta");
        assert_eq!(of_definition(&expression), "", "{expression}");
    }
}

#[test]
fn a_bare_reference_of_a_state_in_degrees_is_a_warning() {
    let messages = |reference: &str| -> Vec<String> {
        plant("", reference)
            .into_iter()
            .map(|warning| warning.message)
            .collect()
    };
    assert_eq!(
        messages("4"),
        ["reference of `alpha` is 4 rad, though `alpha` is declared in degrees"]
    );
    for honest in ["0", "4 deg", "0.1 rad", "sin(t/(1 s))"] {
        assert!(messages(honest).is_empty(), "{honest}");
    }
}

#[test]
fn no_specification_of_the_repository_is_warned_of_its_angles() {
    let mut count = 0;
    for directory in ["../specs", "../tests/specs", "tests/good"] {
        for entry in fs::read_dir(directory).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_some_and(|end| end == "yaml") {
                count += 1;
                let (_, warnings) = load(&path).map_err(|faults| faults.short()).unwrap();
                let of_angles: Vec<_> = warnings
                    .iter()
                    .filter(|warning| warning.rule.name() >= "W0010")
                    .collect();
                assert!(of_angles.is_empty(), "{}: {of_angles:?}", path.display());
            }
        }
    }
    assert!(count >= 14);
}
