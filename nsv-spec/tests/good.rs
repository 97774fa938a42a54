//! What a good specification becomes.

use std::path::Path;

use nsv_spec::diagnostic::{Rule, Severity};
use nsv_spec::model::{Dispersion, Disturbance, Model};
use nsv_spec::{load, load_str};

fn pendulum() -> Model {
    let (model, warnings) = load(Path::new("tests/good/pendulum.yaml"))
        .map_err(|faults| faults.short())
        .expect("a good specification");
    assert_eq!(warnings, []);
    model
}

#[test]
fn constants_are_si_whatever_their_order_and_form() {
    let model = pendulum();
    let value = |name: &str| {
        model
            .constants
            .iter()
            .find(|constant| constant.name == name)
            .unwrap()
            .value
            .data
            .clone()
    };
    assert_eq!(value("g"), [9.81]);
    assert_eq!(value("length"), [0.5]);
    assert_eq!(value("inertia"), [0.5]);
    let names: Vec<&str> = model
        .constants
        .iter()
        .map(|constant| constant.name.as_str())
        .collect();
    assert_eq!(
        names,
        ["g", "length", "inertia", "mass"],
        "in order of declaration"
    );
}

#[test]
fn plant_and_controller_have_their_own_parameters() {
    let friction = &pendulum().parameters[0];
    assert_eq!((friction.value, friction.design_value), (0.1, 0.12));
    assert_eq!(friction.dispersion, Some(Dispersion::Uniform(0.05, 0.2)));
}

#[test]
fn definitions_use_earlier_ones_only() {
    let model = pendulum();
    let names: Vec<&str> = model
        .definitions
        .iter()
        .map(|definition| definition.name.as_str())
        .collect();
    assert_eq!(names, ["gravity", "speed", "drag_rate"]);
}

#[test]
fn states_keep_the_unit_they_are_written_in() {
    let model = pendulum();
    let angle = &model.blocks[0].states[0];
    assert_eq!(angle.initial, 5.0 * std::f64::consts::PI / 180.0);
    assert_eq!(angle.display, ("deg".into(), std::f64::consts::PI / 180.0));
    assert_eq!(model.blocks[1].states[0].display.0, "deg/s");
    assert_eq!(model.inputs[0].display, ("N*m".into(), 1.0));
}

#[test]
fn gains_take_their_full_shape() {
    let model = pendulum();
    let [position, motion] = model.blocks.as_slice() else {
        panic!("two blocks")
    };
    assert_eq!(position.filter, Some(vec![0.02]));
    assert_eq!(position.observer.as_ref().unwrap().data, [10.0]);
    assert_eq!(
        (motion.k.as_slice(), motion.c.data.as_slice()),
        (&[2.0][..], &[50.0][..])
    );
    assert_eq!(
        (
            motion.observer.as_ref().unwrap().rows,
            motion.observer.as_ref().unwrap().cols
        ),
        (2, 1)
    );
    let network = motion.network.as_ref().unwrap();
    assert_eq!(network.input_names, ["angle", "rate"]);
    let Disturbance::Exosystem(channels) = &motion.disturbance else {
        panic!("an exosystem")
    };
    assert_eq!(
        (channels[0].n.rows, channels[0].n.cols),
        (2, 0),
        "no excitation"
    );
    assert_eq!(channels[0].initial, [0.0, 0.0]);
}

#[test]
fn kbar_auto_is_the_supremum_rounded_up() {
    let model = pendulum();
    // k = 3 e^-t + 0.5: |k'/k| is largest at t = 0, 3 / 3.5
    assert_eq!(model.blocks[0].kbar, 0.858);
    assert!(
        model
            .defaults
            .iter()
            .any(|line| line.starts_with("controller.blocks.position.kbar = 0.858 1/s"))
    );
}

#[test]
fn defaults_are_recorded() {
    insta::assert_snapshot!("defaults", pendulum().defaults.join("\n"));
}

#[test]
fn derivatives_of_polynomial_data_are_polynomial_data() {
    let text = std::fs::read_to_string("tests/good/pendulum.yaml").unwrap();
    let text = text.replace("drag.cubic(speed)*", "partial(drag.cubic, speed, speed)*");
    let (model, _) = load_str("pendulum.yaml", &text)
        .map_err(|faults| faults.short())
        .unwrap();
    assert_eq!(model.polynomials[1].name, "drag.cubic_d1");
    assert_eq!(
        model.polynomials[1].terms,
        [(0.03, vec![2]), (0.02, vec![0])]
    );
}

#[test]
fn the_fingerprint_depends_on_every_byte_but_not_on_the_place() {
    let text = std::fs::read_to_string("tests/good/pendulum.yaml").unwrap();
    let hash = |name: &str, text: &str| load_str(name, text).unwrap().0.hash;
    assert_eq!(hash("pendulum.yaml", &text), pendulum().hash);
    assert_ne!(hash("pendulum.yaml", &format!("{text}\n")), pendulum().hash);
    assert_eq!(pendulum().hash.len(), 64);
}

#[test]
fn a_kbar_below_its_bound_is_a_warning() {
    let text = std::fs::read_to_string("tests/good/pendulum.yaml")
        .unwrap()
        .replace("kbar: auto", "kbar: 0.5");
    let (_, warnings) = load_str("pendulum.yaml", &text)
        .map_err(|faults| faults.short())
        .unwrap();
    assert_eq!(
        (warnings.len(), warnings[0].rule, warnings[0].severity),
        (1, Rule::W0001, Severity::Warning)
    );
    assert_eq!(
        warnings[0].message,
        "`kbar` of block `position` is 0.5, below sup sqrt((k'/k)^2 + 1e-6) = 0.8571"
    );
}

fn warnings_of(text: &str) -> Vec<(Rule, String)> {
    let loaded = load_str("cart.yaml", text).map_err(|faults| faults.short());
    let (_, warnings) = loaded.expect("a good specification");
    let told = warnings.into_iter();
    told.map(|warning| (warning.rule, warning.message))
        .collect()
}

#[test]
fn an_argument_that_its_function_does_not_use_is_a_warning() {
    let base = nsv_spec::diagnostic::explain::BASE;
    let text = base.replace(
        "plant:\n",
        "functions: {drag: {arguments: [rate, limit, gain], value: \"each(i, 1, 1, gain*rate)[1]\"}}\nplant:\n",
    );
    let text = text.replace("\"-v/(1 s)\"", "\"drag(v, 1, -1 1/s)\"");
    let expected = "argument `limit` of function `drag` is never used";
    assert_eq!(warnings_of(&text), [(Rule::W0003, expected.to_owned())]);
}

#[test]
fn a_function_or_a_table_that_nothing_calls_is_a_warning() {
    let base = nsv_spec::diagnostic::explain::BASE;
    let text = base.replace(
        "plant:\n",
        "functions: {drag: {arguments: [rate], value: -rate}}\ntables: {lift: {axes: {mach: [0, 1]}, values: [0, 1], \
         interpolation: linear, extrapolation: clamp}}\nplant:\n",
    );
    let expected = [
        "function `drag` is never used",
        "table `lift` is never used",
    ];
    let expected = expected.map(|message| (Rule::W0002, message.to_owned()));
    assert_eq!(warnings_of(&text), expected);
}

#[test]
fn a_fragment_is_as_good_as_the_text_itself() {
    let directory = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string("tests/good/pendulum.yaml").unwrap();
    let (start, end) = (
        text.find("constants:").unwrap(),
        text.find("plant:").unwrap(),
    );
    std::fs::create_dir(directory.path().join("models")).unwrap();
    std::fs::write(directory.path().join("models/data.yaml"), &text[start..end]).unwrap();
    let path = directory.path().join("pendulum.yaml");
    std::fs::write(
        &path,
        format!(
            "{}include: [models/data.yaml]\n{}",
            &text[..start],
            &text[end..]
        ),
    )
    .unwrap();
    let (model, _) = load(&path).map_err(|faults| faults.short()).unwrap();
    assert!(model.sources.files[1].name.ends_with("models/data.yaml"));
    let names = |model: &Model| {
        model
            .constants
            .iter()
            .map(|constant| constant.name.clone())
            .collect::<Vec<_>>()
    };
    assert_eq!(names(&model), names(&pendulum()));
}

#[test]
fn tables_are_the_same_in_a_file_and_in_the_specification() {
    let file = load(Path::new("tests/good/tables.yaml")).map_err(|faults| faults.short());
    let (file, _) = file.expect("a good specification");
    let inline = load(Path::new("tests/good/language.yaml")).map_err(|faults| faults.short());
    let (inline, _) = inline.expect("a good specification");
    assert_eq!(file.tables[0].interpolant, inline.tables[0].interpolant);
    assert_eq!(file.tables[0].arguments, inline.tables[0].arguments);
    let moment = &file.tables[1].interpolant;
    assert_eq!(
        moment.value(&[0.6, 5.0 * std::f64::consts::PI / 180.0], &[0, 0]),
        -25.0
    );
    assert!(moment.value(&[0.7, 0.0], &[0, 0]).is_nan());
    let thrust = &inline.tables[1].interpolant;
    assert_eq!(thrust.value(&[3000.0], &[0]), 14000.0);
}

#[test]
fn the_fingerprint_covers_data_files() {
    let directory = tempfile::tempdir().unwrap();
    std::fs::create_dir(directory.path().join("data")).unwrap();
    let copy = |name: &str, change: &dyn Fn(String) -> String| {
        let text = std::fs::read_to_string(Path::new("tests/good").join(name)).unwrap();
        std::fs::write(directory.path().join(name), change(text)).unwrap();
    };
    let hash = || load(&directory.path().join("tables.yaml")).unwrap().0.hash;
    copy("tables.yaml", &|text| text);
    copy("data/aero.csv", &|text| text);
    let before = hash();
    assert_eq!(before, hash());
    copy("data/aero.csv", &|text| text.replace("1.35", "1.36"));
    assert_ne!(before, hash());
}

#[test]
fn no_prefix_and_no_shuffle_of_a_data_file_panics() {
    let directory = tempfile::tempdir().unwrap();
    std::fs::create_dir(directory.path().join("data")).unwrap();
    let specification = std::fs::read_to_string("tests/good/tables.yaml").unwrap();
    std::fs::write(directory.path().join("tables.yaml"), specification).unwrap();
    let data = std::fs::read_to_string("tests/good/data/aero.csv").unwrap();
    let mut bytes = data.clone().into_bytes();
    let mut texts: Vec<Vec<u8>> = (0..data.len()).map(|end| bytes[..end].to_vec()).collect();
    for at in 0..400 {
        // A step that has no divisor in common with the length mixes the bytes a little more each time.
        let (from, to) = (at * 37 % bytes.len(), at * 101 % bytes.len());
        bytes.swap(from, to);
        texts.push(bytes.clone());
    }
    let mut good = 0;
    for text in texts {
        std::fs::write(directory.path().join("data/aero.csv"), text).unwrap();
        good += usize::from(load(&directory.path().join("tables.yaml")).is_ok());
    }
    assert!(good < 40, "{good}");
}
