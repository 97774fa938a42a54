//! Embeds the sources of the runtime library and of its numeric types, so that `nsv simulate` can build generated code wherever a Rust
//! toolchain is.

use std::error::Error;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs};

fn main() -> Result<(), Box<dyn Error>> {
    let root = PathBuf::from(env::var("CARGO_MANIFEST_DIR")?).join("..");
    let runtime = root.join("runtime");
    let mut files = Vec::new();
    for folder in ["src", "math/src"] {
        let sources = runtime.join(folder);
        println!("cargo::rerun-if-changed={}", sources.display());
        collect(&sources, &mut files)?;
    }
    files.sort();
    let mut text = String::from(
        "/// Path below `runtime` and text of every source file there.\npub(super) const RUNTIME: &[(&str, &str)] = &[\n",
    );
    for file in files {
        let name = file
            .strip_prefix(&runtime)?
            .to_string_lossy()
            .replace('\\', "/");
        writeln!(
            text,
            "    ({name:?}, include_str!({:?})),",
            fs::canonicalize(&file)?
        )?;
    }
    text.push_str("];\n");
    fs::write(
        PathBuf::from(env::var("OUT_DIR")?).join("embedded.rs"),
        text,
    )?;
    Ok(())
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) -> Result<(), Box<dyn Error>> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            collect(&path, files)?;
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    Ok(())
}
