//! Entry points of the fuzzer and of the replay of its corpus (`codegen/tests/corpus.rs`): each reads bytes with one part of the compiler, and
//! holds what comes out against what must be true of it. Bytes that are refused are fine; a panic, a hang or unbounded memory is a fault.

use std::fs;

use nsv_codegen::casadi::document::{Export, Tape};
use nsv_codegen::casadi::{Job, Question, decode};
use nsv_codegen::ir::Program;
use nsv_codegen::ir::verify::verify;
use nsv_spec::diagnostic::{Base, Diagnostic, Diagnostics, FileId, SourceMap, Span};
use nsv_spec::unit::parse_unit;
use nsv_spec::yaml::{self, Kind, Node};
use nsv_spec::{expr, load, load_bytes};

/// Bytes as a file of YAML: every place in the tree lies in the text.
pub fn yaml(bytes: &[u8]) {
    let Ok(text) = yaml::text(bytes, FileId(0)) else {
        return;
    };
    match yaml::read(&text, FileId(0)) {
        Ok(tree) => assert_placed(&tree, &text),
        Err(fault) => assert_inside(fault.span, &text),
    }
}

fn assert_placed(node: &Node, text: &str) {
    assert_inside(Some(node.span), text);
    match &node.kind {
        Kind::Null | Kind::Scalar(_) => {}
        Kind::Seq(items) => items.iter().for_each(|item| assert_placed(item, text)),
        Kind::Map(entries) => {
            for entry in entries {
                assert_inside(Some(entry.key.span), text);
                assert_placed(&entry.value, text);
            }
        }
    }
}

fn assert_inside(span: Option<Span>, text: &str) {
    if let Some(span) = span {
        assert!(
            text.get(span.start as usize..span.end as usize).is_some(),
            "{span:?} is no part of the text"
        );
    }
}

/// Bytes as a whole specification: read, parsed, checked; faults can be shown.
pub fn spec(bytes: &[u8]) {
    assert_shown(&load_bytes("fuzz.yaml", bytes).map(|(_, warnings)| warnings));
}

fn assert_shown(found: &Result<Vec<Diagnostic>, Diagnostics>) {
    if let Err(faults) = found {
        assert!(!faults.items.is_empty(), "refused for a reason");
        assert!(faults.items.iter().all(|item| !item.message.is_empty()));
        assert_places(&faults.items, &faults.sources);
        drop(faults.short());
    }
}

fn assert_places(items: &[Diagnostic], sources: &SourceMap) {
    for item in items {
        let related = item.related.iter().map(|related| related.span);
        for span in item.span.into_iter().chain(related) {
            assert_inside(Some(span), &sources.source(span.file).text);
        }
    }
}

/// The specification that expressions are put into: names of every kind, and one of three places for the text.
fn around(place: u8, text: &str) -> String {
    let quoted = serde_json::to_string(text).expect("text is JSON");
    let or = |at: u8, other: &str| match place % 3 == at {
        true => quoted.clone(),
        false => other.to_owned(),
    };
    format!(
        r#"nsv: 1
name: fuzz
constants: {{g: 9.81 m/s^2, inertia: [[1 kg, 2 kg], [0 kg, 3 kg]], c: {}}}
parameters: {{mass: {{value: 2 kg, dispersion: {{uniform: [1 kg, 3 kg]}}}}, n: 3}}
polynomials: {{bend: {{arguments: [u, v], parts: {{lift: [[0.3, 1, 0], [-0.2, 0, 2]]}}}}}}
tables:
  thrust: {{axes: {{h: [0, 1, 3]}}, values: [20, 18, 14], unit: kN, interpolation: linear, extrapolation: clamp}}
functions: {{sat: {{arguments: [value, limit], value: limit*tanh(value/limit)}}, f: {{arguments: [a, b], value: {}}}}}
definitions: {{omega: "[x, 2*x, x^2]*(1 rad/s)", d: {}, e: "f(x, d)"}}
plant:
  blocks: {{b: {{states: {{x: 0.1, y: 0.2}}, drift: "[x, y]/(1 s)", gain: [[1/(1 s), 0/(1 s)], [0/(1 s), 1/(1 s)]]}}}}
  inputs: {{p: 5, q: 5}}
reference: {{x: 0, y: 0}}
controller: {{sample_time: 2 ms, blocks: {{b: {{K: 1, kbar: 1, C: 5}}}}}}
scenario: {{horizon: 5 s, substeps: 4, scheme: rk4, noise: sampled}}
"#,
        or(0, "1"),
        or(1, "a + b"),
        or(2, "x + y"),
    )
}

/// The first byte chooses a place for the expression, the rest is the expression: parsed alone, then checked in a specification.
pub fn expression(bytes: &[u8]) {
    let Some((place, text)) = bytes.split_first() else {
        return;
    };
    let Ok(text) = std::str::from_utf8(text) else {
        return;
    };
    match expr::parse(text, Base::exact(FileId(0), 0, text.len())) {
        Ok(_) => spec(around(*place, text).as_bytes()),
        Err(faults) => faults
            .iter()
            .for_each(|fault| assert_inside(fault.span, text)),
    }
}

/// A number, a blank and a unit: the unit is finite, its dimension can be written and read, and the number agrees with floating point.
pub fn unit(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else {
        return;
    };
    let (digits, name) = text.split_once(' ').unwrap_or(("1", text));
    let unit = match parse_unit(name) {
        Ok(unit) => unit,
        Err(error) => {
            assert!(name.get(error.range.clone()).is_some(), "{error:?}");
            let base = Base::exact(FileId(0), 0, name.len());
            drop(error.diagnostic(&base));
            return;
        }
    };
    assert!(unit.scale.is_finite() && unit.scale > 0.0, "{}", unit.scale);
    let again = parse_unit(&unit.dimension.to_string()).expect("a dimension is a unit");
    assert_eq!((again.dimension, again.scale), (unit.dimension, 1.0));
    if let Some(value) = unit.si(digits) {
        let product = digits.parse::<f64>().expect("a number") * unit.scale;
        let close = (value - product).abs() <= 5e-16 * product.abs() + f64::MIN_POSITIVE;
        assert!(close || !product.is_finite(), "{value} is not {product}");
    }
}

/// The declaration of a table in YAML, optionally a line `---` and the text of `data.csv`.
pub fn table(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else {
        return;
    };
    let (declaration, data) = text.split_once("\n---\n").unwrap_or((text, ""));
    let lines: String = declaration
        .lines()
        .map(|line| format!("    {line}\n"))
        .collect();
    let specification = format!(
        "nsv: 1\nname: fuzz\ntables:\n  lift:\n{lines}plant:\n  blocks: {{b: {{states: {{x: 0.1}}, drift: \"-lift(x)/(1 s)\", gain: 1/(1 s)}}}}\n  \
         inputs: {{force: 5}}\nreference: {{x: 0}}\ncontroller: {{sample_time: 2 ms, blocks: {{b: {{K: 1, kbar: 1, C: 5}}}}}}\n\
         scenario: {{horizon: 5 s, substeps: 4, scheme: rk4, noise: sampled}}\n"
    );
    FOLDER.with(|folder| {
        let path = folder.path().join("spec.yaml");
        fs::write(folder.path().join("data.csv"), data).expect("a file");
        fs::write(&path, specification).expect("a file");
        assert_shown(&load(&path).map(|(_, warnings)| warnings));
    });
}

thread_local! {
    /// Where [`table`] writes its files.
    static FOLDER: tempfile::TempDir = tempfile::tempdir().expect("a directory");
}

/// A formula, and what is asked about it.
pub type Asked = (&'static str, fn() -> Job);

/// Formulas whose derivatives the tapes of [`export`] claim to be.
pub const QUESTIONS: [Asked; 5] = [
    (SPRING, || Job::Hessian {
        wrt: vec!["x".into()],
    }),
    (LIFT, || Job::Rates {
        order: 2,
        varying: vec!["alpha".into(), "mach".into()],
    }),
    (ARRAYS, || Job::Jacobian {
        wrt: vec!["M".into(), "v".into()],
    }),
    (ARRAYS, || Job::Rates {
        order: 4,
        varying: vec!["v".into()],
    }),
    (EQUATIONS, || Job::Rates {
        order: 2,
        varying: vec!["x".into()],
    }),
];

const SPRING: &str = "
    program spring
    input x: vec2
    input k: real
    %0: vec2 = input x
    %1: real = input k
    %2: real = element %0, 0, 0
    %3: real = powi %2, 4
    %4: real = mul %3, %1
    output U = %4
";
const EQUATIONS: &str = "
    program equations
    input x: vec2
    %0: vec2 = input x
    %1: mat2x2 = outer %0, %0
    %2: vec2 = solve %1, %0
    output y = %2
";
const LIFT: &str = "
    program lift
    input alpha: real
    input mach: real
    polynomial cl(alpha, mach) = 0.25 [0, 1], 0.5 [1, 0], 2.0 [2, 3]
    table drag(alpha, mach) = breaks [0.0, 1.0, 2.0], breaks [0.0, 1.0], linear clamp [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]
    %0: real = input alpha
    %1: real = input mach
    %2: real = polynomial cl, %0, %1
    %3: real = table drag 0 0, %0, %1
    %4: real = mul %2, %3
    output q = %4
";
const ARRAYS: &str = "
    program arrays
    input M: mat2x2
    input v: vec2
    %0: mat2x2 = input M
    %1: vec2 = input v
    %2: vec2 = matmul %0, %1
    output q = %2
";

/// The first byte chooses a question, the rest is a tape, or a whole export, in JSON: what is decoded is a sound program.
pub fn export(bytes: &[u8]) {
    let Some((choice, json)) = bytes.split_first() else {
        return;
    };
    let tape = match serde_json::from_slice::<Export>(json) {
        Ok(export) => export.tape,
        Err(_) => match serde_json::from_slice::<Tape>(json) {
            Ok(tape) => tape,
            Err(_) => return,
        },
    };
    let (formula, job) = QUESTIONS[usize::from(choice.wrapping_sub(b'0')) % QUESTIONS.len()];
    let formula: Program = formula.parse().expect("a formula");
    let question = Question::new(&formula, &job());
    if let Ok(program) = decode(&question, &tape) {
        program.assert_sound();
    }
}

/// Bytes as the text form of a program: what is read is judged, and what is sound prints.
pub fn program(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else {
        return;
    };
    if let Ok(program) = text.parse::<Program>()
        && verify(&program).is_empty()
    {
        drop(program.to_string());
    }
}
