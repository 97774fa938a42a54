//! Writes the first corpus into `corpus/`: specifications, the gallery, every expression and unit in them, tables, and tapes that CasADi answered.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use nsv_codegen::casadi::{Environment, Mode, Provider};
use nsv_codegen::ir::{Program, random};
use nsv_fuzz::entry::QUESTIONS;
use nsv_spec::diagnostic::FileId;
use nsv_spec::yaml::{self, Kind, Node};

fn main() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut expressions = BTreeSet::new();
    for path in specifications(&folder.join("../..")) {
        let name = path
            .file_name()
            .expect("a file")
            .to_string_lossy()
            .into_owned();
        let text = fs::read_to_string(&path).expect("text");
        for target in ["yaml", "spec"] {
            write(folder, target, &name, text.as_bytes());
        }
        if let Ok(tree) = yaml::read(&text, FileId(0)) {
            scalars(&tree, &mut expressions);
        }
    }
    for (at, text) in expressions.iter().enumerate() {
        write(
            folder,
            "expression",
            &format!("{at}"),
            format!("{}{text}", at % 3).as_bytes(),
        );
        if let Some((digits, unit)) = text.split_once(' ')
            && unit.len() < 20
            && digits.parse::<f64>().is_ok()
        {
            write(
                folder,
                "unit",
                &format!("{at}"),
                format!("{digits} {unit}").as_bytes(),
            );
        }
    }
    for (at, text) in UNITS.iter().enumerate() {
        write(folder, "unit", &format!("of_{at}"), text.as_bytes());
    }
    for (at, text) in TABLES.iter().enumerate() {
        write(folder, "table", &format!("{at}"), text.as_bytes());
    }
    for seed in 0..40 {
        let text = random::program(seed, 30).to_string();
        write(folder, "program", &format!("{seed}"), text.as_bytes());
    }
    let scratch = tempfile::tempdir().expect("a directory");
    let mut provider = Provider::new(
        Environment::from_variables(scratch.path(), Mode::Provision)
            .expect("variables that can be used"),
        |_| {},
    );
    for (at, (formula, job)) in QUESTIONS.iter().enumerate() {
        let formula: Program = formula.parse().expect("a formula");
        provider.partials(&formula, &job()).expect("an answer");
        for (which, export) in provider.exports().enumerate() {
            let tape = serde_json::to_string(&export.tape).expect("JSON");
            let export = serde_json::to_string(export).expect("JSON");
            for (kind, text) in [("tape", tape), ("export", export)] {
                write(
                    folder,
                    "export",
                    &format!("{kind}_{at}_{which}"),
                    format!("{at}{text}").as_bytes(),
                );
            }
        }
    }
}

const UNITS: [&str; 12] = [
    "2.54 cm",
    "1e-3 kg/(m*s^2)",
    "9 m/s^2/sqrt(Hz)",
    "1 deg/sqrt(h)",
    "33 slug*ft^2",
    "5 sqrt(kg*m^2/s^3)",
    "7 uF",
    "8 dam",
    "1 (1/s)^-3",
    "12345678901234567890 psi",
    "4 rpm",
    "2 lbf*in",
];

const TABLES: [&str; 6] = [
    "axes: {u: [0, 1]}\nvalues: [1, 2]\ninterpolation: linear\nextrapolation: clamp",
    "axes: {mach: [0.2, 0.6], alpha: {values: [-5, 0, 5, 12], unit: deg}}\nvalues: [[-0.4, 0.1, 0.6, 1.2], [-0.45, 0.12, 0.7, 1.35]]\n\
     interpolation: linear\nextrapolation: error",
    "axes: {h: {values: [0, 1, 3, 6, 10], unit: km}}\nvalues: [20, 18.5, 14, 9, 4]\nunit: kN\ninterpolation: cubic\nextrapolation: error",
    "axes: {u: \"1\"}\nfile: data.csv\ninterpolation: linear\nextrapolation: clamp\n---\nu,lift\n0,1\n1,2.5e-3\n",
    "axes: {u: \"1\", v: m}\nfile: data.csv\ncolumn: cd\nunit: kN\ninterpolation: linear\nextrapolation: clamp\n---\n# comment\n\
     u, v , cl, cd\n0,1,2,3\n0,2,3,4\n1,1,4,5\n1,2,-5,6\n\n2,1,0,0\n2,2,0,1\n",
    "axes: {u: \"1\"}\nfile: data.csv\ninterpolation: cubic\nextrapolation: clamp\n---\nlift,u\n0,1\n1,2\n4,3\n9,4\n16,5\n",
];

fn write(folder: &Path, target: &str, name: &str, bytes: &[u8]) {
    let folder = folder.join("corpus").join(target);
    fs::create_dir_all(&folder).expect("a directory");
    fs::write(folder.join(name), bytes).expect("a file");
}

fn specifications(root: &Path) -> Vec<PathBuf> {
    let folders = [
        "specs",
        "specs/models",
        "tests/specs",
        "nsv-spec/tests/good",
        "nsv-spec/tests/bad",
    ];
    let files = folders
        .iter()
        .flat_map(|folder| fs::read_dir(root.join(folder)).expect("a directory"));
    let mut files: Vec<PathBuf> = files.map(|entry| entry.expect("an entry").path()).collect();
    files.retain(|path| path.extension().is_some_and(|end| end == "yaml"));
    files.sort();
    files
}

fn scalars(node: &Node, all: &mut BTreeSet<String>) {
    match &node.kind {
        Kind::Null => {}
        Kind::Scalar(scalar) => {
            all.insert(scalar.text.clone());
        }
        Kind::Seq(items) => items.iter().for_each(|item| scalars(item, all)),
        Kind::Map(entries) => entries.iter().for_each(|entry| scalars(&entry.value, all)),
    }
}
