//! Writes the list of generated modules: one per folder of `generated/src`.

use std::path::Path;
use std::{env, fs};

fn main() {
    let folder = "../../../generated/src";
    println!("cargo::rerun-if-changed={folder}");
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap());
    let mut names: Vec<String> = entries
        .filter(|entry| entry.path().is_dir())
        .map(|entry| entry.file_name().into_string().unwrap())
        .collect();
    names.sort();
    let arms: String = names
        .iter()
        .map(|name| format!("\"{name}\" => run::<nsv_generated::{name}::simulator::Simulator>(width, samples),\n"))
        .collect();
    let text = format!(
        "const MODULES: [&str; {}] = {names:?};\nfn measure(module: &str, width: Width, samples: u64) -> bool {{\nmatch module {{\n{arms}_ => false,\n}}\n}}\n",
        names.len()
    );
    fs::write(
        Path::new(&env::var("OUT_DIR").unwrap()).join("modules.rs"),
        text,
    )
    .unwrap();
}
