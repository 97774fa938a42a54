//! Emitted text of small programs.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

use nsv_spec::model::{NoiseModel, Scheme};

use super::interface::{Block, Dispersion, Input, Interface, Parameter, State};
use super::module::{Programs, files};
use super::standalone;
use crate::ir::{self, Program, Shape, Type, Values, random};
use crate::opt::{Arithmetic, optimise, optimise_with};

fn program(text: &str) -> Program {
    let program: Program = text.parse().expect("a program");
    program.assert_sound();
    program
}

fn interface() -> Interface {
    let state = |name: &str, unit: &str| State {
        name: name.to_owned(),
        initial: 0.01,
        unit: unit.to_owned(),
        dispersion: None,
        sensor: None,
    };
    let input = |name: &str| Input {
        name: name.to_owned(),
        unit: "kg m^2 s^-2".to_owned(),
        limit: 1.0,
        safe: 0.0,
        actuator: None,
    };
    let parameter = |name: &str, dispersion| Parameter {
        name: name.to_owned(),
        unit: "kg".to_owned(),
        doc: "paper, Table 1".to_owned(),
        plant: 1.0,
        design: 1.5,
        dispersion,
    };
    Interface {
        truth: None,
        name: "pitch".to_owned(),
        title: "Pitch and yaw of a small vehicle".to_owned(),
        hash: "0".repeat(64),
        version: "0.1.0".to_owned(),
        arithmetic: Arithmetic::Strict,
        parameters: vec![
            parameter("mass", None),
            parameter("CL_scale", Some(Dispersion::Uniform(0.75, 1.25))),
        ],
        blocks: vec![
            Block {
                name: "attitude".to_owned(),
                states: vec![state("alpha", "rad"), state("beta", "rad")],
                exosystem: vec![],
                gains: Vec::new(),
            },
            Block {
                name: "rates".to_owned(),
                states: vec![state("p", "rad s^-1"), state("q", "rad s^-1")],
                exosystem: vec![0.1, 0.0],
                gains: Vec::new(),
            },
        ],
        inputs: vec![input("M_y"), input("M_z")],
        sample_time: 0.002,
        horizon: 20.0,
        substeps: 4,
        scheme: Scheme::RungeKutta4,
        noise: NoiseModel::Sampled,
        sources: vec![("CL.alpha".to_owned(), "paper, Table 2".to_owned())],
    }
}

/// The programs of a small hand-written module.
fn programs() -> [Program; 4] {
    [
        include_str!("samples/pitch.initial.txt"),
        include_str!("samples/pitch.control.txt"),
        include_str!("samples/pitch.plant.txt"),
        include_str!("samples/pitch.lyapunov.txt"),
    ]
    .map(program)
}

/// Its files.
fn pitch(interface: &Interface) -> BTreeMap<String, String> {
    let [initial, control, plant, lyapunov] = programs();
    files(
        interface,
        &Programs {
            initial: &initial,
            control: &control,
            plant: &plant,
            lyapunov: &lyapunov,
        },
    )
}

/// The same with a diffusion that a state changes, by Platen's scheme.
fn wandering(interface: &Interface) -> BTreeMap<String, String> {
    let [initial, control, _, lyapunov] = programs();
    let constant = "const [0.0, 0.0, 0.0, 0.0, 0.1, 0.0, 0.0, 0.1, 0.0, 0.0, 0.0, 0.0]";
    let changing = "array %15, %15, %15, %15, %21, %15, %15, %14, %15, %15, %15, %15";
    let plant = include_str!("samples/pitch.plant.txt").replace(constant, changing);
    files(
        interface,
        &Programs {
            initial: &initial,
            control: &control,
            plant: &program(&plant),
            lyapunov: &lyapunov,
        },
    )
}

#[test]
fn the_drift_is_not_evaluated_for_the_diffusion() {
    let interface = Interface {
        noise: NoiseModel::Wiener,
        scheme: Scheme::Platen,
        ..interface()
    };
    let fixed = pitch(&interface);
    assert!(fixed["simulator.rs"].contains("Scheme::EulerMaruyama"));
    assert!(!fixed["plant.rs"].contains("pub fn diffusion"));
    let changing = wandering(&interface);
    assert!(changing["simulator.rs"].contains("Scheme::Platen"));
    let plant = &changing["plant.rs"];
    let function = plant.split("pub fn diffusion").nth(1).expect("a function");
    assert!(
        !function.contains("u_sat") && function.contains("sin()"),
        "{function}"
    );
}

/// The law of the module whose weights decay: `next.W1` by `sum`, in its text form.
fn decaying(sum: &str, fused: bool) -> String {
    let [initial, _, plant, lyapunov] = programs();
    let changed = include_str!("samples/pitch.control.txt")
        .replace("%71: mat6x2 = mul %70, %62", "%71: mat6x2 = mul %62, %7")
        .replace("mat6x2 = add %7, %71", sum);
    let control = Program {
        fused,
        ..program(&changed)
    };
    let files = files(
        &interface(),
        &Programs {
            initial: &initial,
            control: &control,
            plant: &plant,
            lyapunov: &lyapunov,
        },
    );
    files["controller.rs"].split_whitespace().collect()
}

#[test]
fn weights_are_updated_in_place() {
    let strict = decaying("mat6x2 = add %71, %70", false);
    assert!(strict.contains("state.W1.scale_add_outer(real(0.002),t2,e1);"));
    let fused = decaying("mat6x2 = mul_add %7, %62, %70", true);
    assert!(fused.contains("state.W1.scale_add_outer_fused(real(0.002),t2,e1);"));
    let difference = decaying("mat6x2 = sub %71, %70", false);
    assert!(difference.contains("state.W1=state.W1*real(0.002)-t2.outer(e1);"));
}

/// A module of one scalar block without parameters, noise, constraint or polynomials.
fn bare() -> BTreeMap<String, String> {
    let [initial, control, plant, lyapunov] = [
        "program initial\ninput t: real\ninput x1: vec1\n%0: vec1 = const [0.0]\noutput zeta1 = %0",
        "program control\ninput t: real\ninput x1: vec1\ninput state.zeta1: vec1\n%0: vec1 = input x1\n%1: vec1 = input state.zeta1\n\
         %2: vec1 = neg %0\noutput u = %2\noutput u_sat = %2\noutput y_r = %1\noutput e1 = %0\noutput next.zeta1 = %1",
        "program plant\ninput t: real\ninput x: vec1\ninput u_sat: vec1\n%0: vec1 = input u_sat\noutput drift = %0",
        "program lyapunov\ninput t: real\ninput x1: vec1\n%0: vec1 = input x1\n%1: real = sum_squares %0\n%2: real = neg %1\n\
         output V = %1\noutput LV = %2",
    ]
    .map(program);
    let mut interface = Interface {
        name: "bare".to_owned(),
        parameters: vec![],
        ..interface()
    };
    interface.blocks.truncate(1);
    interface.blocks[0].states.truncate(1);
    interface.inputs.truncate(1);
    files(
        &interface,
        &Programs {
            initial: &initial,
            control: &control,
            plant: &plant,
            lyapunov: &lyapunov,
        },
    )
}

#[test]
fn a_module_reads_beside_its_equations() {
    for (name, text) in pitch(&interface()) {
        insta::assert_snapshot!(name.replace('.', "_"), text);
    }
}

#[test]
fn random_programs_are_rust() {
    for seed in 0..200 {
        let text = standalone(&random::program(seed, 120));
        assert!(syn::parse_file(&text).is_ok(), "{text}");
    }
}

/// Rust that calls the standalone function of a program with `inputs` and prints the bits of each output.
fn driver(module: &str, program: &Program, inputs: &Values) -> String {
    let literal = |input: &ir::Input| {
        let entries: Vec<String> = inputs[&input.name]
            .iter()
            .map(|v| format!("f64::from_bits({:#x})", v.to_bits()))
            .collect();
        match input.shape {
            Shape::Scalar => entries[0].clone(),
            Shape::Vector(_) => format!("Vector([{}])", entries.join(", ")),
            Shape::Matrix(_, columns) => {
                let rows: Vec<String> = entries
                    .chunks(columns)
                    .map(|row| format!("[{}]", row.join(", ")))
                    .collect();
                format!("Matrix::rows([{}])", rows.join(", "))
            }
        }
    };
    let mut arguments: Vec<String> = Vec::new();
    let mut records: BTreeMap<&str, Vec<String>> = BTreeMap::new();
    for input in &program.inputs {
        match input.name.split_once('.') {
            None => arguments.push(literal(input)),
            Some((prefix, field)) => {
                if !records.contains_key(prefix) {
                    arguments.push(format!("&{prefix}"));
                }
                records
                    .entry(prefix)
                    .or_default()
                    .push(format!("{field}: {}", literal(input)));
            }
        }
    }
    let records = records.iter().map(|(prefix, fields)| {
        format!(
            "let {prefix} = {module}::{} {{ {} }};",
            super::names::type_name(prefix),
            fields.join(", ")
        )
    });
    let records: String = records.collect();
    let outputs = program
        .outputs
        .iter()
        .map(|(name, id)| match program.ty(*id) {
            Type::Bool => format!("print(if out.{name} {{ 1.0 }} else {{ 0.0 }});"),
            Type::Real(Shape::Scalar) => format!("print(out.{name});"),
            Type::Real(Shape::Vector(_)) => format!("out.{name}.0.into_iter().for_each(print);"),
            Type::Real(Shape::Matrix(..)) => {
                format!("out.{name}.to_rows().into_iter().flatten().for_each(print);")
            }
            Type::Ldlt(_) => unreachable!("invariant: factors are no output"),
        });
    let outputs: String = outputs.collect();
    let function = &program.name;
    format!(
        "{{ {records} let out = {module}::{function}({}); {outputs} }}\n",
        arguments.join(", ")
    )
}

/// Builds a crate from `files` below `src/` in a fresh folder and gives what its program prints.
fn run(files: &BTreeMap<String, String>) -> String {
    let folder = tempfile::tempdir().expect("a folder");
    let runtime = Path::new(env!("CARGO_MANIFEST_DIR")).join("../runtime");
    let manifest = format!(
        "[package]\nname = \"emitted\"\nedition = \"2024\"\n[dependencies]\nnsv-runtime = {{ path = {runtime:?}, features = [\"std\"] }}\n[workspace]\n"
    );
    std::fs::write(folder.path().join("Cargo.toml"), manifest).expect("a writable folder");
    std::fs::copy(
        runtime.join("../Cargo.lock"),
        folder.path().join("Cargo.lock"),
    )
    .expect("the lock file");
    for (name, text) in files {
        let path = folder.path().join("src").join(name);
        std::fs::create_dir_all(path.parent().expect("a parent")).expect("a folder");
        std::fs::write(path, text).expect("a writable file");
    }
    let mut cargo = Command::new(env!("CARGO"));
    cargo
        .args(["run", "--quiet", "--offline"])
        .current_dir(folder.path());
    cargo
        .env("CARGO_TARGET_DIR", folder.path().join("target"))
        .env_remove("RUSTFLAGS");
    if let Ok(keep) = std::env::var("NSV_KEEP_EMITTED") {
        let copied = Command::new("cp")
            .arg("-r")
            .arg(folder.path())
            .arg(keep)
            .status();
        assert!(copied.is_ok_and(|status| status.success()));
    }
    let output = cargo.output().expect("cargo");
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    String::from_utf8(output.stdout).expect("text")
}

#[test]
fn compiled_programs_agree_with_evaluation_to_the_last_bit() {
    let mut files = BTreeMap::new();
    let mut library =
        String::from("//! Random programs.\n#![no_std]\n#![deny(warnings, missing_docs)]\n");
    let mut main = String::from(
        "use emitted::*;\nuse nsv_runtime::linear::{Matrix, Vector};\nfn print(value: f64) { println!(\"{:016x}\", value.to_bits()); }\n",
    );
    let mut body = String::new();
    let mut expected = Vec::new();
    for seed in 0..30 {
        let program = match seed {
            0..20 => random::program(seed, 120),
            20..28 => optimise_with(random::program(seed, 120), Arithmetic::Fast),
            _ => optimise(random::program(seed, 2000)),
        };
        let text = standalone(&program);
        assert_eq!(
            text.contains("T::outlined"),
            seed >= 28,
            "long ones have parts"
        );
        files.insert(format!("p{seed}.rs"), text);
        library.push_str(&format!("pub mod p{seed};\n"));
        for draw in 0..4 {
            let inputs = random::inputs(&program, 100 * seed + draw);
            let driver = driver(&format!("p{seed}"), &program, &inputs);
            main.push_str(&format!("fn run_{seed}_{draw}() {{\n{driver}}}\n"));
            body.push_str(&format!("run_{seed}_{draw}();\n"));
            let values = ir::eval::eval(&program, &inputs).expect("values");
            for (name, _) in &program.outputs {
                expected.extend(
                    values[name]
                        .iter()
                        .map(|value| (seed, draw, name.clone(), *value)),
                );
            }
        }
    }
    main.push_str(&format!("fn main() {{\n{body}}}\n"));
    files.insert("lib.rs".to_owned(), library);
    files.insert("main.rs".to_owned(), main);
    let printed = run(&files);
    assert_eq!(printed.lines().count(), expected.len());
    for (line, (seed, draw, name, value)) in printed.lines().zip(expected) {
        let found = f64::from_bits(u64::from_str_radix(line, 16).expect("bits"));
        let same = found.to_bits() == value.to_bits() || found.is_nan() && value.is_nan();
        assert!(
            same,
            "program {seed}, inputs {draw}, {name}: emitted {found:e}, evaluated {value:e}"
        );
    }
}

#[test]
fn an_emitted_module_flies() {
    let wiener = Interface {
        name: "wiener".to_owned(),
        noise: NoiseModel::Wiener,
        scheme: Scheme::Platen,
        ..interface()
    };
    let mut files = BTreeMap::new();
    for (name, module) in [
        ("pitch", pitch(&interface())),
        ("wiener", pitch(&wiener)),
        ("wandering", wandering(&wiener)),
        ("bare", bare()),
    ] {
        files.extend(
            module
                .into_iter()
                .map(|(file, text)| (format!("{name}/{file}"), text)),
        );
    }
    let library = super::library(&[
        ("bare", "Bare"),
        ("pitch", "Pitch and yaw"),
        (
            "wandering",
            "The same with a diffusion that a state changes",
        ),
        ("wiener", "The same with Wiener noise"),
    ]);
    let library = library.replace("#![no_std]", "#![no_std]\n#![deny(warnings, missing_docs)]");
    files.insert("lib.rs".to_owned(), library);
    files.insert(
        "main.rs".to_owned(),
        include_str!("samples/flight.rs").to_owned(),
    );
    assert_eq!(run(&files).trim(), "ok");
}

/// What a hostile specification would put where it names or describes things.
const HOSTILE: [&str; 7] = [
    "*/ fn evil() { std::process::exit(1) } /*",
    "x\"); std::process::exit(1); (\"",
    "line\nstd::process::exit(1);\n",
    "nsv_comment!(0);",
    "```\nstd::process::exit(1)\n```",
    "\u{202e}\u{2066}// right to left",
    "]] #![allow(warnings)] {{ \\",
];

#[test]
fn hostile_text_stays_in_comments_and_names() {
    for text in HOSTILE {
        let mut interface = interface();
        interface.title = text.to_owned();
        interface.version = text.to_owned();
        interface.hash = text.to_owned();
        interface.sources[0].1 = text.to_owned();
        interface.parameters[0].doc = text.to_owned();
        interface.parameters[0].unit = text.to_owned();
        interface.blocks[0].name = text.to_owned();
        let [initial, mut control, mut plant, lyapunov] = programs();
        for origin in &mut control.origins {
            origin.group = text.to_owned();
            origin.equation = text.to_owned();
        }
        control.polynomials[0].arguments[0] = text.to_owned();
        for instruction in &mut plant.instructions {
            if let Some(name) = &mut instruction.name {
                name.push_str(text);
            }
        }
        let programs = Programs {
            initial: &initial,
            control: &control,
            plant: &plant,
            lyapunov: &lyapunov,
        };
        for (file, emitted) in files(&interface, &programs) {
            check_harmless(&file, &emitted);
        }
    }
}

/// The text is Rust of the expected items only, on lines without control or direction characters, and no doc test runs.
fn check_harmless(file: &str, text: &str) {
    let parsed = syn::parse_file(text).unwrap_or_else(|error| panic!("{file}: {error}\n{text}"));
    let evil = parsed
        .items
        .iter()
        .any(|item| matches!(item, syn::Item::Fn(function) if function.sig.ident == "evil"));
    assert!(!evil && !text.contains("```"), "{file}\n{text}");
    assert!(
        text.chars()
            .all(|c| c == '\n' || !c.is_control() && !('\u{2000}'..='\u{206f}').contains(&c)),
        "{file}"
    );
    for line in text.lines().filter(|line| line.contains("process::exit")) {
        let line = line.trim_start();
        let in_text = line.starts_with("//") || line.starts_with("pub const");
        assert!(in_text, "{file}: {line}");
    }
}

#[test]
fn fast_arithmetic_is_recorded_in_every_file() {
    let [initial, control, plant, lyapunov] = programs();
    let programs = Programs {
        initial: &initial,
        control: &control,
        plant: &plant,
        lyapunov: &lyapunov,
    };
    for (arithmetic, recorded) in [(Arithmetic::Strict, false), (Arithmetic::Fast, true)] {
        let interface = Interface {
            arithmetic,
            ..interface()
        };
        for (file, text) in files(&interface, &programs) {
            assert_eq!(text.contains("\n// math fast: "), recorded, "{file}");
        }
    }
}
