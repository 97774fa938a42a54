//! What editors are given: the schema in the repository, its defaults, and the layout of files.

use std::path::{Path, PathBuf};
use std::{env, fs};

use nsv_spec::compose::Composition;
use nsv_spec::model::Model;
use nsv_spec::yaml::{Unformatted, format};

#[test]
fn the_schema_in_the_repository_is_the_one_that_the_tables_make() {
    let path = Path::new("../docs/nsv.schema.json");
    let text = serde_json::to_string_pretty(&nsv_spec::json_schema()).unwrap() + "\n";
    if env::var_os("NSV_UPDATE_DOCS").is_some() {
        fs::write(path, &text).unwrap();
    }
    assert!(
        fs::read_to_string(path).unwrap_or_default() == text,
        "docs/nsv.schema.json is stale: NSV_UPDATE_DOCS=1 cargo test -p nsv-spec --test editors"
    );
}

/// The pendulum without any key that has a default, and with settings.
fn bare(settings: &[String]) -> Model {
    let mut all: Vec<String> = [
        "safe", "substeps", "scheme", "noise", "seed", "runs", "settle",
    ]
    .iter()
    .map(|key| match *key {
        "safe" => "plant.inputs.torque.safe=~".to_owned(),
        key => format!("scenario.{key}=~"),
    })
    .collect();
    for key in ["network.basis", "network.scale", "noise_bound.phi.min"] {
        all.push(format!("controller.blocks.motion.{key}=~"));
    }
    all.extend_from_slice(settings);
    let composition = Composition::read(Path::new("tests/good/pendulum.yaml"), &all);
    let loaded = composition.and_then(|composition| composition.base());
    loaded
        .unwrap_or_else(|faults| panic!("{}", faults.short()))
        .0
}

/// Defaults of the schema, with a path to where the pendulum may say them.
fn defaults() -> Vec<(String, String)> {
    let schema = nsv_spec::json_schema();
    let places = [
        ("/$defs/controller", "controller"),
        ("/$defs/scenario", "scenario"),
        ("/$defs/input", "plant.inputs.torque"),
        ("/$defs/network", "controller.blocks.motion.network"),
        ("/$defs/phi", "controller.blocks.motion.noise_bound.phi"),
    ];
    let mut all = Vec::new();
    for (section, place) in places {
        let properties = schema.pointer(section).expect("a section")["properties"].clone();
        for (key, value) in properties.as_object().expect("a map") {
            if let Some(default) = value.get("default") {
                let text = default
                    .as_str()
                    .map_or_else(|| default.to_string(), str::to_owned);
                all.push((format!("{place}.{key}"), text));
            }
        }
    }
    all
}

/// What a model says of everything that has a default.
fn chosen(model: &Model) -> String {
    let inputs: Vec<_> = model.inputs.iter().map(|input| input.safe).collect();
    let networks: Vec<_> = model.blocks.iter().map(|block| &block.network).collect();
    let noise: Vec<_> = model
        .blocks
        .iter()
        .map(|block| &block.noise_bound)
        .collect();
    format!(
        "{:?} {:?} {inputs:?} {networks:?} {noise:?}",
        model.controller, model.scenario
    )
}

#[test]
fn a_default_of_the_schema_is_what_holds_without_the_key() {
    let defaults = defaults();
    assert!(defaults.len() >= 14, "{defaults:?}");
    let without = bare(&[]);
    for (path, value) in defaults {
        let given = bare(&[format!("{path}={value}")]);
        assert_eq!(chosen(&given), chosen(&without), "{path}={value}");
        let recorded = |model: &Model| model.defaults.len();
        assert_eq!(
            recorded(&given) + 1,
            recorded(&without),
            "{path} is recorded"
        );
    }
}

/// Every YAML file of a folder and those below it.
fn files(folder: &str) -> Vec<PathBuf> {
    let (mut pending, mut found) = (vec![PathBuf::from(folder)], Vec::new());
    while let Some(path) = pending.pop() {
        if path.is_dir() {
            pending.extend(
                fs::read_dir(&path)
                    .expect("a folder")
                    .map(|entry| entry.expect("an entry").path()),
            );
        } else if path.extension().is_some_and(|ending| ending == "yaml") {
            found.push(path);
        }
    }
    found
}

#[test]
fn a_layout_never_changes_a_meaning_and_is_its_own_layout() {
    let mut laid_out = 0;
    for folder in ["../specs", "../tests/specs", "tests/good", "tests/bad"] {
        for path in files(folder) {
            let Ok(text) = fs::read_to_string(&path) else {
                continue;
            };
            match format(&text) {
                Ok(new) => {
                    laid_out += 1;
                    assert_eq!(format(&new).ok(), Some(new), "{}", path.display());
                }
                Err(Unformatted::Fault(_)) => {}
                Err(Unformatted::Unsafe) => panic!("{}", path.display()),
            }
        }
    }
    assert!(laid_out > 100, "{laid_out}");
}

#[test]
fn every_specification_of_the_repository_is_laid_out() {
    for path in files("../specs") {
        let text = fs::read_to_string(&path).unwrap();
        assert!(
            format(&text).unwrap() == text,
            "{}: run `cargo nsv fmt`",
            path.display()
        );
    }
}
