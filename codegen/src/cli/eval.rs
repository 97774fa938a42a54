//! `nsv eval`: every quantity of the law at given states, in the order of its equations.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use nsv_codegen::ir::build::size;
use nsv_codegen::ir::eval::eval;
use nsv_codegen::ir::{Program, Shape, Type, Values};
use nsv_spec::model::{Disturbance, Model};
use serde::{Serialize, Serializer};
use serde_json::{Map, Value};

use super::compile::{Math, Partials, compile, load};
use super::failure::{Exit, Failure};
use super::output;
use super::settings::Settings;

/// Print every quantity of the law at given states as JSON, in the order of its equations
#[derive(clap::Args)]
pub(crate) struct Args {
    /// Specification
    #[arg(value_name = "SPEC")]
    spec: PathBuf,
    #[command(flatten)]
    settings: Settings,
    /// JSON object with a number, list or list of rows for each input, SI: `t, x1, .., th1, h1, zeta1, W1, eps1, sigma1, phi1, ..`;
    /// parameters and the true exosystem states `w1, ..` may be left out
    #[arg(long, value_name = "FILE.json")]
    at: PathBuf,
}

/// Runs the verb.
pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let model = load(&args.spec, &args.settings)?;
    let given = read(&args.at)?;
    let program = compile(&args.spec, &model, Partials::Cached, Math::Strict)?.eval;
    let values = inputs(&program, &given, &defaults(&model))
        .map_err(|faults| rejected(&args.at, &faults))?;
    let outputs = eval(&program, &values)
        .map_err(|error| Failure::new(Exit::Usage, format_args!("cannot evaluate: {error}")))?;
    output::json(&document(&program, &outputs))
}

fn read(path: &Path) -> Result<Map<String, Value>, Failure> {
    let text = std::fs::read_to_string(path).map_err(|error| Failure::io("read", path, &error))?;
    serde_json::from_str(&text).map_err(|error| {
        Failure::new(
            Exit::Usage,
            format_args!("`{}` is not a JSON object: {error}", path.display()),
        )
    })
}

/// Values that need not be given: the parameters of the specification, and the true states of its exosystems at the start.
fn defaults(model: &Model) -> Values {
    let parameters = model.parameters.iter().flat_map(|parameter| {
        let design = format!("params.{}", parameter.name);
        let plant = format!("plant.{}", parameter.name);
        [
            (design, vec![parameter.design_value]),
            (plant, vec![parameter.value]),
        ]
    });
    let exosystems = (1..).zip(&model.blocks).filter_map(|(i, block)| {
        let Disturbance::Exosystem(channels) = &block.disturbance else {
            return None;
        };
        let initial = channels
            .iter()
            .flat_map(|channel| channel.initial.iter().copied());
        Some((format!("w{i}"), initial.collect()))
    });
    parameters.chain(exosystems).collect()
}

/// Everything wrong with the values given.
#[derive(Debug, Default, PartialEq)]
struct Faults {
    missing: Vec<String>,
    unknown: Vec<String>,
    /// What there is in the place of an unknown one.
    known: Vec<String>,
    misshapen: Vec<String>,
}

fn rejected(path: &Path, faults: &Faults) -> Failure {
    let list = |names: &[String]| names.join(", ");
    let kinds = [
        ("missing", list(&faults.missing)),
        ("unknown", list(&faults.unknown)),
        ("known", list(&faults.known)),
        ("misshapen", list(&faults.misshapen)),
    ];
    let lines: String = kinds
        .iter()
        .filter(|(_, names)| !names.is_empty())
        .map(|(kind, names)| format!("\n  {kind}: {names}"))
        .collect();
    Failure::new(
        Exit::Usage,
        format_args!(
            "`{}` does not give the inputs of the law{lines}",
            path.display()
        ),
    )
}

/// The inputs of `program` from the values given, and from `defaults` where none is.
fn inputs(
    program: &Program,
    given: &Map<String, Value>,
    defaults: &Values,
) -> Result<Values, Faults> {
    let (mut values, mut faults) = (Values::new(), Faults::default());
    let known: BTreeSet<&str> = program
        .inputs
        .iter()
        .map(|input| input.name.as_str())
        .collect();
    faults.unknown = given
        .keys()
        .filter(|name| !known.contains(name.as_str()))
        .cloned()
        .collect();
    if !faults.unknown.is_empty() {
        faults.known = known.into_iter().map(str::to_owned).collect();
    }
    for input in &program.inputs {
        let wanted = format!("{} ({})", input.name, describe(input.shape));
        match (given.get(&input.name), defaults.get(&input.name)) {
            (Some(value), _) => match entries(value, input.shape) {
                Some(entries) => drop(values.insert(input.name.clone(), entries)),
                None => faults.misshapen.push(wanted),
            },
            (None, Some(default)) => drop(values.insert(input.name.clone(), default.clone())),
            (None, None) => faults.missing.push(wanted),
        }
    }
    if faults == Faults::default() {
        Ok(values)
    } else {
        Err(faults)
    }
}

fn describe(shape: Shape) -> String {
    match shape {
        Shape::Scalar => "a number".to_owned(),
        Shape::Vector(n) => format!("a list of {n}"),
        Shape::Matrix(r, c) => format!("{r} rows of {c}"),
    }
}

/// Row-major entries of a JSON value of that shape.
fn entries(value: &Value, shape: Shape) -> Option<Vec<f64>> {
    let list = |value: &Value, length: usize| -> Option<Vec<Value>> {
        value
            .as_array()
            .filter(|items| items.len() == length)
            .cloned()
    };
    match shape {
        Shape::Scalar => Some(vec![value.as_f64()?]),
        Shape::Vector(n) => list(value, n)?.iter().map(Value::as_f64).collect(),
        Shape::Matrix(r, c) => {
            let rows = list(value, r)?
                .iter()
                .map(|row| entries(row, Shape::Vector(c)))
                .collect::<Option<Vec<_>>>()?;
            Some(rows.concat())
        }
    }
}

/// Values in the order of the equations.
struct Quantities(Vec<(String, Value)>);

impl Serialize for Quantities {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, value)| (name, value)))
    }
}

/// The outputs with their shapes; a number that is not finite is `null`.
fn document(program: &Program, outputs: &Values) -> Quantities {
    let shown = program.outputs.iter().filter_map(|(name, id)| {
        let data = outputs.get(name)?;
        let value = match program.ty(*id) {
            Type::Bool => Value::from(data.first() == Some(&1.0)),
            Type::Real(Shape::Scalar) => Value::from(data[0]),
            Type::Real(Shape::Vector(_)) => Value::from(data.clone()),
            Type::Real(shape @ Shape::Matrix(_, columns)) => {
                debug_assert_eq!(data.len(), size(shape));
                Value::from(
                    data.chunks(columns)
                        .map(|row| Value::from(row.to_vec()))
                        .collect::<Vec<_>>(),
                )
            }
            Type::Ldlt(_) => return None,
        };
        Some((name.clone(), value))
    });
    Quantities(shown.collect())
}

#[cfg(test)]
mod tests {
    use nsv_codegen::ir::{Input, Op};
    use serde_json::json;

    use super::*;

    fn program() -> Program {
        let input = |name: &str, shape| Input {
            name: name.into(),
            shape,
        };
        let inputs = vec![
            input("t", Shape::Scalar),
            input("x1", Shape::Vector(2)),
            input("W1", Shape::Matrix(3, 2)),
            input("params.m", Shape::Scalar),
        ];
        let mut program = Program {
            name: "eval".into(),
            inputs,
            ..Program::default()
        };
        let (t, x) = (program.push(Op::Input(0)), program.push(Op::Input(1)));
        let (w, m) = (program.push(Op::Input(2)), program.push(Op::Input(3)));
        let y = program.push(Op::MatMul(w, x));
        let late = program.push(Op::Compare(nsv_codegen::ir::Comparison::Gt, t, m));
        program.outputs = [("y", y), ("late", late), ("W", w), ("t", t)]
            .map(|(name, id)| (name.to_owned(), id))
            .into();
        program
    }

    fn defaults() -> Values {
        [("params.m".to_owned(), vec![2.0])].into()
    }

    fn given(value: Value) -> Map<String, Value> {
        value.as_object().unwrap().clone()
    }

    #[test]
    fn quantities_keep_their_shapes_and_their_order() {
        let program = program();
        let given = given(json!({"t": 3, "x1": [1, 10], "W1": [[1, 2], [3, 4], [5, 6]]}));
        let values = inputs(&program, &given, &defaults()).unwrap();
        let shown = document(&program, &eval(&program, &values).unwrap());
        assert_eq!(
            serde_json::to_string(&shown).unwrap(),
            r#"{"y":[21.0,43.0,65.0],"late":true,"W":[[1.0,2.0],[3.0,4.0],[5.0,6.0]],"t":3.0}"#
        );
    }

    #[test]
    fn every_fault_is_in_one_error() {
        let given = given(json!({"x1": [1, 2, 3], "x9": 0, "params.m": "heavy"}));
        let faults = inputs(&program(), &given, &defaults()).unwrap_err();
        let Failure::Message {
            exit: Exit::Usage,
            message,
            ..
        } = rejected(Path::new("at.json"), &faults)
        else {
            panic!()
        };
        insta::assert_snapshot!(message);
    }
}
