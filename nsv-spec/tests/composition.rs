//! What a specification is put together from: extended files, arguments of included ones, settings and sweeps.

use std::fs;
use std::path::{Path, PathBuf};

use nsv_spec::compose::Composition;
use nsv_spec::diagnostic::{Diagnostics, Rule};
use nsv_spec::model::Model;

const GOOD: &str = "tests/good/pendulum.yaml";

fn composed(path: &Path, settings: &[&str]) -> Result<Model, Diagnostics> {
    let settings: Vec<String> = settings.iter().map(|&setting| setting.into()).collect();
    let composition = Composition::read(path, &settings)?;
    composition.base().map(|(model, _)| model)
}

fn set(settings: &[&str]) -> Model {
    composed(Path::new(GOOD), settings)
        .map_err(|faults| faults.short())
        .expect("a good specification")
}

/// The faults of settings of the pendulum, in short form.
fn refused(settings: &[&str]) -> String {
    composed(Path::new(GOOD), settings)
        .expect_err("faults")
        .short()
}

/// A folder with the pendulum, a specification `over.yaml` beside it, and whatever else.
fn folder(over: &str, others: &[(&str, &str)]) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("a temporary file");
    fs::copy(GOOD, folder.path().join("pendulum.yaml")).expect("a temporary file");
    for (name, text) in others {
        fs::write(folder.path().join(name), text).expect("a temporary file");
    }
    let path = folder.path().join("over.yaml");
    fs::write(&path, over).expect("a temporary file");
    (folder, path)
}

fn constant(model: &Model, name: &str) -> f64 {
    let found = model
        .constants
        .iter()
        .find(|constant| constant.name == name);
    found.expect("a constant").value.data[0]
}

#[test]
fn a_setting_takes_the_place_of_what_is_written() {
    let model = set(&[
        "controller.blocks.position.K=7.5",
        "constants.length=40 cm",
        "reference.angle=if(t < 1 s, 4 deg, 6 deg)",
        "controller.norm=spectral",
    ]);
    assert_eq!(model.blocks[0].k, [7.5]);
    assert_eq!(constant(&model, "length"), 0.4);
    assert_eq!(model.controller.norm, nsv_spec::model::Norm::Spectral);
}

#[test]
fn the_last_of_two_settings_holds() {
    let model = set(&[
        "controller.blocks.motion.K=3",
        "controller.blocks.motion.K=4",
    ]);
    assert_eq!(model.blocks[1].k, [4.0]);
}

#[test]
fn a_setting_can_add_a_key_to_a_short_form() {
    let settings = ["plant.inputs.torque.actuator.lag=50 ms"];
    assert!(set(&settings).inputs[0].actuator.is_some());
}

#[test]
fn a_tilde_takes_a_key_away() {
    let model = set(&[
        "controller.blocks.motion.network=~",
        "controller.blocks.motion.error_bound=~",
    ]);
    assert!(model.blocks[1].network.is_none());
}

#[test]
fn the_fingerprint_covers_settings() {
    let plain = set(&[]).hash;
    let one = set(&["controller.blocks.motion.K=3"]).hash;
    let other = set(&["controller.blocks.motion.K=4"]).hash;
    assert!(plain != one && one != other);
    assert_eq!(one, set(&["controller.blocks.motion.K=3"]).hash);
}

#[test]
fn faults_point_into_the_setting() {
    insta::assert_snapshot!(refused(&[
        "controller.blocks.position.K=2 m",
        "constants.length=0.5 m * unknown",
    ]));
}

#[test]
fn a_path_that_leads_nowhere_is_one_fault_for_each() {
    insta::assert_snapshot!(refused(&[
        "controller.blocks.positon.K=2",
        "controler.sample_time=1 ms",
        "constants.lenght=1 m",
        "controller.sample_time.value=1 ms",
        "include=[other.yaml]",
        "plant.inputs.torque.lag=1 s",
        "controller.blocks.motion.networc=~",
        "controller.blocks.motion.eta_3=~",
        "constants.length=[",
        "controller=@nowhere.yaml",
        "..=1",
    ]));
}

#[test]
fn a_section_can_come_from_another_file() {
    let text = fs::read_to_string(GOOD)
        .unwrap()
        .replace("sample_time: 2 ms", "sample_time: 4 ms");
    let (_folder, other) = folder(&text, &[]);
    let setting = format!("controller=@{}", other.display());
    let model = set(&[&setting]);
    assert_eq!(
        (model.controller.sample_time, model.name),
        (0.004, "pendulum".into())
    );
    let wrong = format!("truth=@{}", other.display());
    assert!(refused(&[&wrong]).contains("no `truth` in"));
}

#[test]
fn a_specification_extends_another() {
    let over = "nsv: 1\nname: over\nextends: pendulum.yaml\nconstants: {length: 0.7 m}\n\
                controller: {blocks: {motion: {network: ~, error_bound: ~}}}\nreference: {angle: 4 deg}\n";
    let (_folder, path) = folder(over, &[]);
    let model = composed(&path, &[])
        .map_err(|faults| faults.short())
        .unwrap();
    assert_eq!(
        (model.name.as_str(), model.title.as_str()),
        ("over", "over")
    );
    assert_eq!(constant(&model, "length"), 0.7);
    assert!(model.blocks[1].network.is_none());
    assert_eq!(model.blocks[0].k, set(&[]).blocks[0].k);
}

#[test]
fn a_chain_of_extensions_changes_what_is_left_of_it() {
    let middle = "nsv: 1\nname: middle\nextends: pendulum.yaml\nconstants: {length: 0.6 m}\n";
    let over = "nsv: 1\nname: over\nextends: middle.yaml\nscenario: {seed: 9}\n";
    let (_folder, path) = folder(over, &[("middle.yaml", middle)]);
    let model = composed(&path, &[])
        .map_err(|faults| faults.short())
        .unwrap();
    assert_eq!((constant(&model, "length"), model.scenario.seed), (0.6, 9));
}

#[test]
fn faults_of_extended_text_point_into_its_own_file() {
    let over = "nsv: 1\nname: over\nextends: pendulum.yaml\nconstants: {length: 0.7 kg}\n";
    let (_folder, path) = folder(over, &[]);
    let faults = composed(&path, &[]).unwrap_err();
    let place = |at: usize| {
        let span = faults.items[at].span.unwrap();
        Path::new(&faults.sources.source(span.file).name)
            .file_name()
            .unwrap()
            .to_owned()
    };
    assert!(
        (0..faults.items.len()).any(|at| place(at) == "pendulum.yaml"),
        "{}",
        faults.short()
    );
}

#[test]
fn an_included_file_takes_arguments() {
    let text = fs::read_to_string(GOOD).unwrap();
    let (start, end) = (
        text.find("constants:").unwrap(),
        text.find("plant:").unwrap(),
    );
    let include = |with: &str| {
        let include = format!("include: [{{file: data.yaml{with}}}]\n");
        format!("{}{include}{}", &text[..start], &text[end..])
    };
    let data = &text[start..end];
    let load = |with: &str| {
        let (_folder, path) = folder(&include(with), &[("data.yaml", data)]);
        composed(&path, &[])
            .map_err(|faults| faults.short())
            .unwrap()
    };
    assert_eq!(constant(&load(""), "length"), 0.5);
    let model = load(", with: {length: 0.7 m, friction: {value: 0.15 1/s}}");
    assert_eq!(constant(&model, "length"), 0.7);
    // Of a map only the keys that are given change.
    assert_eq!(model.parameters[0].value, 0.15);
    assert!(model.parameters[0].dispersion.is_some());
}

fn swept(sweep: &str, settings: &[&str]) -> Composition {
    let over =
        format!("nsv: 1\nname: over\nextends: pendulum.yaml\nscenario: {{sweep: {sweep}}}\n");
    let (_folder, path) = folder(&over, &[]);
    let settings: Vec<String> = settings.iter().map(|&setting| setting.into()).collect();
    Composition::read(&path, &settings)
        .map_err(|faults| faults.short())
        .expect("a good specification")
}

#[test]
fn a_sweep_is_every_combination() {
    let composition = swept(
        "{controller.blocks.position.K: [1, 2], constants.length: [40 cm, 50 cm, 60 cm]}",
        &[],
    );
    let variants = composition.variants();
    assert_eq!(variants.len(), 6);
    assert_eq!(
        variants[1].settings(),
        ["controller.blocks.position.K=1", "constants.length=50 cm"]
    );
    let models: Vec<Model> = variants
        .iter()
        .map(|variant| composition.variant(variant).unwrap().0)
        .collect();
    assert_eq!(
        (models[5].blocks[0].k[0], constant(&models[5], "length")),
        (2.0, 0.6)
    );
    let base = composition.base().unwrap().0;
    assert_eq!(base.blocks[0].k, set(&[]).blocks[0].k);
    let mut hashes: Vec<&str> = models
        .iter()
        .chain([&base])
        .map(|model| &*model.hash)
        .collect();
    hashes.sort_unstable();
    hashes.dedup();
    assert_eq!(hashes.len(), 7);
}

#[test]
fn a_variant_is_what_its_settings_make() {
    let sweep = "{controller.blocks.position.K: [1, 2], reference.angle: ['5 deg * cos(2*t/(1 s))', 4 deg]}";
    let composition = swept(sweep, &[]);
    for variant in composition.variants() {
        let settings = variant.settings();
        let settings: Vec<&str> = settings.iter().map(String::as_str).collect();
        let alone = swept(sweep, &settings);
        assert_eq!(alone.variants(), []);
        let swept = composition.variant(&variant).unwrap().0;
        assert_eq!(alone.base().unwrap().0.hash, swept.hash);
    }
}

#[test]
fn what_is_set_is_not_swept() {
    let sweep = "{controller.blocks.position.K: [1, 2], constants.length: [40 cm, 50 cm]}";
    let composition = swept(sweep, &["controller.blocks.position.K=9"]);
    let variants = composition.variants();
    assert_eq!(variants.len(), 2);
    let (model, _) = composition.variant(&variants[0]).unwrap();
    assert_eq!(model.blocks[0].k, [9.0]);
    assert_eq!(swept(sweep, &["scenario.sweep=~"]).variants(), []);
}

#[test]
fn a_bad_variant_points_at_its_value() {
    let composition = swept("{controller.blocks.position.K: [1, -2]}", &[]);
    let variants = composition.variants();
    assert!(composition.variant(&variants[0]).is_ok());
    let faults = composition.variant(&variants[1]).unwrap_err();
    assert_eq!(faults.items[0].rule, Rule::E0601);
    let span = faults.items[0].span.unwrap();
    let source = faults.sources.source(span.file);
    assert_eq!(&source.text[span.start as usize..span.end as usize], "-2");
    assert!(source.on_disk);
}
