//! The runner as a Rust package that needs nothing but itself.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io;
use std::path::Path;

use nsv_math::lanes::Width;
use sha2::{Digest, Sha256};

mod embedded {
    include!(concat!(env!("OUT_DIR"), "/embedded.rs"));
}

/// Name of the package and its binary.
pub(crate) const NAME: &str = "nsv-simulator";

const MANIFEST: &str = r#"[package]
name = "nsv-simulator"
version = "0.0.0"
edition = "2024"

[dependencies]
nsv-runtime = { path = "runtime", features = ["std"] }

[profile.release]
opt-level = 3
codegen-units = 1
incremental = false
strip = true

[workspace]
"#;

/// The main function of a simulator in lanes of `lanes` numbers and in scalars. Results do not depend on the lanes, the time to compile does.
fn main(lanes: usize) -> String {
    format!(
        "//! Simulates one control problem.
#![allow(dead_code, reason = \"a simulation calls a part of the generated code\")]

mod spec;

use nsv_runtime::closed_loop::InLanes;
use spec::simulator::Simulator;

fn main() -> std::process::ExitCode {{
    nsv_runtime::runner::main::<InLanes<Simulator, {lanes}>>()
}}
"
    )
}

/// Files of a package by path, forward slashes between.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Package {
    files: BTreeMap<String, String>,
}

impl Package {
    /// The runner of generated code, given by path inside its module's folder.
    pub(crate) fn new(generated: &BTreeMap<String, String>) -> Package {
        let runtime = embedded::RUNTIME
            .iter()
            .map(|&(path, text)| (path, text.to_owned()));
        Package::with_runtime(generated, runtime, manifest_of_runtime())
    }

    fn with_runtime<'a>(
        generated: &BTreeMap<String, String>,
        runtime: impl Iterator<Item = (&'a str, String)>,
        manifest_of_runtime: String,
    ) -> Package {
        let mut files: BTreeMap<String, String> = runtime
            .map(|(path, text)| (format!("runtime/{path}"), text))
            .collect();
        files.insert("runtime/Cargo.toml".into(), manifest_of_runtime);
        files.insert("runtime/math/Cargo.toml".into(), manifest_of_math());
        files.insert("Cargo.toml".into(), MANIFEST.into());
        files.insert("Cargo.lock".into(), lock());
        files.insert("src/main.rs".into(), main(Width::widest().lanes()));
        files.extend(
            generated
                .iter()
                .map(|(path, text)| (format!("src/spec/{path}"), text.clone())),
        );
        Package { files }
    }

    /// Hash of every file and of the toolchain that will build them, hex.
    pub(crate) fn key(&self, toolchain: &str) -> String {
        let mut hash = Sha256::new();
        let pairs = self
            .files
            .iter()
            .map(|(path, text)| (path.as_str(), text.as_str()));
        for (path, text) in pairs.chain([("rustc", toolchain)]) {
            // Lengths first, so that no two different sets run together to the same bytes.
            hash.update((path.len() as u64).to_le_bytes());
            hash.update((text.len() as u64).to_le_bytes());
            hash.update(path);
            hash.update(text);
        }
        let mut hex = String::new();
        for byte in hash.finalize() {
            let _ = write!(hex, "{byte:02x}");
        }
        hex
    }

    /// Writes every file below `folder`.
    pub(crate) fn write(&self, folder: &Path) -> io::Result<()> {
        for (path, text) in &self.files {
            let path = folder.join(path);
            std::fs::create_dir_all(path.parent().unwrap_or(folder))?;
            std::fs::write(path, text)?;
        }
        Ok(())
    }
}

/// Stands in for the runtime's own manifest, which inherits from the workspace.
fn manifest_of_runtime() -> String {
    manifest(
        "nsv-runtime",
        "std = [\"nsv-math/std\"]",
        "nsv-math = { path = \"math\" }\n",
    )
}

/// Stands in for the manifest of the numeric types.
fn manifest_of_math() -> String {
    manifest("nsv-math", "std = []", "")
}

fn manifest(name: &str, features: &str, dependencies: &str) -> String {
    let version = env!("CARGO_PKG_VERSION");
    format!(
        "[package]\nname = \"{name}\"\nversion = \"{version}\"\nedition = \"2024\"\n\n\
         [features]\ndefault = []\n{features}\n\n[dependencies]\n{dependencies}"
    )
}

fn lock() -> String {
    let version = env!("CARGO_PKG_VERSION");
    format!(
        "version = 4\n\n[[package]]\nname = \"nsv-math\"\nversion = \"{version}\"\n\n\
         [[package]]\nname = \"nsv-runtime\"\nversion = \"{version}\"\ndependencies = [\n \"nsv-math\",\n]\n\n\
         [[package]]\nname = \"{NAME}\"\nversion = \"0.0.0\"\ndependencies = [\n \"nsv-runtime\",\n]\n"
    )
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// A package whose runtime is a fake that answers the protocol with the argument list.
    pub(crate) fn fake(spec: &str) -> Package {
        let runtime = "#![no_std]\n#[cfg(feature = \"std\")]\nextern crate std;\n#[cfg(feature = \"std\")]\npub mod runner;\n\
                       pub trait ClosedLoop { const NAME: &'static str; }\npub mod closed_loop {\n\
                       pub struct InLanes<L, const LANES: usize>(L);\n\
                       impl<L: crate::ClosedLoop, const LANES: usize> crate::ClosedLoop for InLanes<L, LANES> { const NAME: &'static str = L::NAME; }\n}\n";
        let runner = "use std::process::ExitCode;\npub fn main<L: crate::ClosedLoop>() -> ExitCode {\n\
                      std::println!(\"{} {}\", L::NAME, 4.0_f64.sqrt());\nExitCode::SUCCESS\n}\n";
        let generated = [
            ("mod.rs".to_owned(), "pub mod simulator;\n".to_owned()),
            ("simulator.rs".to_owned(), spec.to_owned()),
        ];
        let runtime = [
            ("src/lib.rs", runtime.to_owned()),
            ("src/runner/mod.rs", runner.to_owned()),
            ("math/src/lib.rs", "#![no_std]\n".to_owned()),
        ];
        Package::with_runtime(
            &generated.into(),
            runtime.into_iter(),
            manifest_of_runtime(),
        )
    }

    pub(crate) const SPEC: &str = "pub struct Simulator;\nimpl nsv_runtime::ClosedLoop for Simulator { const NAME: &'static str = \"fake\"; }\n";

    #[test]
    fn every_source_of_the_runtime_is_embedded() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../runtime");
        for lib in ["src/lib.rs", "math/src/lib.rs"] {
            let text = std::fs::read_to_string(root.join(lib)).unwrap();
            assert!(embedded::RUNTIME.contains(&(lib, text.as_str())));
        }
        for (path, text) in embedded::RUNTIME {
            assert_eq!(
                *text,
                std::fs::read_to_string(root.join(path)).unwrap(),
                "{path}"
            );
        }
    }

    #[test]
    fn the_manifests_say_what_the_originals_say() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let section = |text: &str, name: &str| -> Vec<String> {
            let after = text.split(&format!("[{name}]")).nth(1).unwrap_or_default();
            let lines = after
                .lines()
                .skip(1)
                .take_while(|line| !line.starts_with('['));
            lines
                .filter(|line| !line.is_empty())
                .map(|line| line.split(['.', ' ', '=']).next().unwrap().to_owned())
                .collect()
        };
        for (ours, original) in [
            (manifest_of_runtime(), "runtime/Cargo.toml"),
            (manifest_of_math(), "runtime/math/Cargo.toml"),
        ] {
            let text = std::fs::read_to_string(root.join(original)).unwrap();
            for name in ["features", "dependencies"] {
                assert_eq!(
                    section(&ours, name),
                    section(&text, name),
                    "{original} [{name}]"
                );
            }
        }
    }

    #[test]
    fn nothing_comes_from_a_registry() {
        assert!(!lock().contains("source = "), "{}", lock());
    }

    #[test]
    fn the_key_knows_every_byte() {
        let package = fake(SPEC);
        assert_eq!(package.key("rustc 1"), fake(SPEC).key("rustc 1"));
        assert_ne!(package.key("rustc 1"), package.key("rustc 2"));
        assert_ne!(
            package.key("rustc 1"),
            fake("pub struct Simulator;").key("rustc 1")
        );
        assert_eq!(package.key("").len(), 64);
    }
}
