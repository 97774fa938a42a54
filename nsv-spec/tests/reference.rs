//! The reference page of the language says what the compiler does: it is written from the compiler's tables, and its examples compile.

use std::path::Path;
use std::{env, fs};

use nsv_spec::load_str;
use nsv_spec::reference::{WORLD, examples, language_reference};

#[test]
fn the_page_in_the_repository_is_the_one_that_the_tables_make() {
    let path = Path::new("../docs/language.md");
    if env::var_os("NSV_UPDATE_DOCS").is_some() {
        fs::write(path, language_reference()).unwrap();
    }
    let found = fs::read_to_string(path).unwrap_or_default();
    assert!(
        found == language_reference(),
        "docs/language.md is stale: NSV_UPDATE_DOCS=1 cargo test -p nsv-spec --test reference"
    );
}

#[test]
fn every_example_compiles() {
    for (at, example) in examples().enumerate() {
        let line = format!("definitions:\n  example: {example:?}\n");
        let text = WORLD.replacen("definitions:\n", &line, 1);
        assert_ne!(text, WORLD);
        let loaded = load_str("language.yaml", &text);
        let (model, _) =
            loaded.unwrap_or_else(|faults| panic!("{at} {example}: {}", faults.short()));
        assert!(
            model
                .definitions
                .iter()
                .any(|definition| definition.name == "example")
        );
    }
}

#[test]
fn functions_and_constants_of_the_schema_are_those_of_the_page() {
    let (schema, page) = (nsv_spec::json_schema(), language_reference());
    let formula = schema["$defs"]["formula"]["description"].as_str().unwrap();
    let (_, functions) = formula.split_once("functions are ").unwrap();
    for function in functions.split("), ") {
        let function = function.trim_end_matches(')');
        assert!(page.contains(&format!("| `{function})` |")), "{function}");
    }
}
