//! A hundred random programs with every operation, emitted, compiled together in one crate, and run against the evaluator, bit for bit.

use std::fmt::Write as _;
use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use nsv_codegen::emit::standalone;
use nsv_codegen::ir::eval::eval;
use nsv_codegen::ir::random::{inputs, program};
use nsv_codegen::ir::{Program, Shape, Values};
use nsv_codegen::opt::optimise;
use nsv_tests::specification::repository;

const PROGRAMS: u64 = 100;
const LENGTH: usize = 120;
/// Inputs of each program.
const POINTS: u64 = 12;

/// Entries of values as words and back.
const FLAT: &str = "
use nsv_runtime::linear::{Matrix, Vector};

pub trait Flat {
    fn read(words: &mut impl Iterator<Item = u64>) -> Self;
    fn write(&self, line: &mut Vec<u64>);
}

impl Flat for f64 {
    fn read(words: &mut impl Iterator<Item = u64>) -> Self {
        f64::from_bits(words.next().unwrap())
    }
    fn write(&self, line: &mut Vec<u64>) {
        line.push(self.to_bits());
    }
}

impl Flat for bool {
    fn read(_: &mut impl Iterator<Item = u64>) -> Self {
        unreachable!()
    }
    fn write(&self, line: &mut Vec<u64>) {
        line.push(f64::from(u8::from(*self)).to_bits());
    }
}

impl<const N: usize> Flat for Vector<f64, N> {
    fn read(words: &mut impl Iterator<Item = u64>) -> Self {
        Vector(std::array::from_fn(|_| f64::read(words)))
    }
    fn write(&self, line: &mut Vec<u64>) {
        self.0.iter().for_each(|entry| entry.write(line));
    }
}

impl<const R: usize, const C: usize> Flat for Matrix<f64, R, C> {
    fn read(words: &mut impl Iterator<Item = u64>) -> Self {
        Matrix::rows(std::array::from_fn(|_| std::array::from_fn(|_| f64::read(words))))
    }
    fn write(&self, line: &mut Vec<u64>) {
        self.to_rows().iter().flatten().for_each(|entry| entry.write(line));
    }
}
";

/// Reads a program's number and its inputs from each line, and writes its outputs.
const MAIN: &str = "
mod flat;

use flat::Flat;

fn main() {
    for line in std::io::stdin().lines() {
        let line = line.unwrap();
        let mut words = line.split(' ').map(|word| u64::from_str_radix(word, 16).unwrap());
        let mut results = Vec::new();
        call(words.next().unwrap(), &mut words, &mut results);
        let text: Vec<String> = results.iter().map(|word| format!(\"{word:x}\")).collect();
        println!(\"{}\", text.join(\" \"));
    }
}
";

/// The type of a value in emitted code.
fn type_text(shape: Shape) -> String {
    match shape {
        Shape::Scalar => "f64".into(),
        Shape::Vector(n) => format!("nsv_runtime::linear::Vector<f64, {n}>"),
        Shape::Matrix(rows, columns) => {
            format!("nsv_runtime::linear::Matrix<f64, {rows}, {columns}>")
        }
    }
}

/// Every other program is emitted as it is, the others optimised.
fn emitted(index: u64) -> Program {
    let program = program(index, LENGTH);
    if index.is_multiple_of(2) {
        optimise(program)
    } else {
        program
    }
}

/// Writes the crate, whose dependencies are those that built this test.
fn write(folder: &Path) {
    let source = folder.join("src");
    fs::create_dir_all(&source).unwrap();
    let mut main = MAIN.to_owned();
    let mut arms = String::new();
    for index in 0..PROGRAMS {
        let program = emitted(index);
        fs::write(source.join(format!("p{index}.rs")), standalone(&program)).unwrap();
        writeln!(main, "mod p{index};").unwrap();
        let arguments: Vec<String> = program
            .inputs
            .iter()
            .map(|input| format!("<{} as Flat>::read(words)", type_text(input.shape)))
            .collect();
        let results: String = program
            .outputs
            .iter()
            .map(|(name, _)| format!(" outputs.{name}.write(results);"))
            .collect();
        writeln!(
            arms,
            "{index} => {{ let outputs = p{index}::{}({});{results} }}",
            program.name,
            arguments.join(", ")
        )
        .unwrap();
    }
    writeln!(
        main,
        "fn call(index: u64, words: &mut impl Iterator<Item = u64>, results: &mut Vec<u64>) {{"
    )
    .unwrap();
    writeln!(main, "match index {{ {arms} _ => unreachable!() }} }}").unwrap();
    fs::write(source.join("main.rs"), main).unwrap();
    fs::write(source.join("flat.rs"), FLAT).unwrap();
    let runtime = repository("runtime");
    let manifest = format!(
        "[package]\nname = \"random-programs\"\nversion = \"0.0.0\"\nedition = \"2024\"\n[dependencies]\nnsv-runtime = {{ path = {runtime:?} }}\n\
         [profile.dev]\nopt-level = 1\ndebug = false\n[workspace]\n"
    );
    fs::write(folder.join("Cargo.toml"), manifest).unwrap();
    fs::copy(repository("Cargo.lock"), folder.join("Cargo.lock")).unwrap();
}

/// The compiled crate.
fn build() -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("random_programs");
    write(&folder);
    let mut cargo = Command::new(env!("CARGO"));
    cargo
        .args(["build", "--offline", "--quiet"])
        .current_dir(&folder);
    let output = cargo
        .env("CARGO_TARGET_DIR", folder.join("target"))
        .env_remove("CARGO_BUILD_TARGET")
        .output()
        .unwrap();
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    folder.join("target/debug/random-programs")
}

/// The bits of all values of the program's inputs or outputs in their order.
fn words<'n>(names: impl Iterator<Item = &'n String>, values: &Values) -> Vec<u64> {
    names
        .flat_map(|name| values[name].iter().map(|entry| entry.to_bits()))
        .collect()
}

/// Feeds lines to a process and returns its lines.
fn answers(executable: &Path, questions: String) -> Vec<String> {
    let mut process = Command::new(executable)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let mut input = process.stdin.take().unwrap();
    let writer = std::thread::spawn(move || input.write_all(questions.as_bytes()).unwrap());
    let output = process.wait_with_output().unwrap();
    writer.join().unwrap();
    assert!(output.status.success());
    String::from_utf8(output.stdout)
        .unwrap()
        .lines()
        .map(str::to_owned)
        .collect()
}

#[test]
fn compiled_programs_keep_the_bits_of_the_evaluator() {
    let executable = build();
    let cases = || (0..PROGRAMS).flat_map(|index| (0..POINTS).map(move |point| (index, point)));
    let values = |index, point| inputs(&program(index, LENGTH), 1000 * point + index);
    let mut questions = String::new();
    for (index, point) in cases() {
        let input = words(
            program(index, LENGTH)
                .inputs
                .iter()
                .map(|input| &input.name),
            &values(index, point),
        );
        let input: String = input.iter().map(|word| format!(" {word:x}")).collect();
        writeln!(questions, "{index:x}{input}").unwrap();
    }
    let answers = answers(&executable, questions);
    assert_eq!(answers.len(), cases().count());
    let (mut entries, mut numbers) = (0, 0);
    for ((index, point), answer) in cases().zip(answers) {
        let program = program(index, LENGTH);
        let expected = words(
            program.outputs.iter().map(|(name, _)| name),
            &eval(&program, &values(index, point)).unwrap(),
        );
        let found: Vec<u64> = answer
            .split(' ')
            .map(|word| u64::from_str_radix(word, 16).unwrap())
            .collect();
        assert_eq!(found.len(), expected.len());
        for (found, expected) in found.into_iter().zip(expected) {
            let (a, b) = (f64::from_bits(found), f64::from_bits(expected));
            assert!(
                found == expected || (a.is_nan() && b.is_nan()),
                "program {index}, point {point}: {a:e} compiled, {b:e} evaluated"
            );
            entries += 1;
            numbers += usize::from(b.is_finite());
        }
    }
    assert!(
        2 * numbers > entries,
        "{numbers} of {entries} results are finite numbers"
    );
}
