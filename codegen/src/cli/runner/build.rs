//! From a package to its program, through cargo or from the cache.

use std::io;
use std::path::{Path, PathBuf};

use super::cache::Cache;
use super::package::{NAME, Package};
use super::toolchain::{INSTALL, Toolchain};
use crate::cli::child;
use crate::cli::failure::{Exit, Failure};
use nsv_codegen::interrupt::Scratch;

/// A built runner.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Program {
    /// The executable file.
    pub path: PathBuf,
    /// What it was built from, as a hash.
    pub key: String,
}

/// The key that the program of `package` has or would have.
pub(crate) fn key(cache: &Cache, package: &Package) -> Result<String, Failure> {
    Ok(package.key(&Toolchain::find(&cache.simulators())?.version))
}

/// The program of `package`. `building` is called before a build that takes a while.
pub(crate) fn prepare(
    cache: &Cache,
    package: &Package,
    building: impl FnOnce(),
) -> Result<Program, Failure> {
    let toolchain = Toolchain::find(&cache.simulators())?;
    prepare_with(cache, package, &toolchain, building)
}

fn prepare_with(
    cache: &Cache,
    package: &Package,
    toolchain: &Toolchain,
    building: impl FnOnce(),
) -> Result<Program, Failure> {
    let key = package.key(&toolchain.version);
    let path = cache.program(&key);
    if path.is_file() {
        return Ok(Program { path, key });
    }
    building();
    let failed =
        |error: &io::Error| Failure::io("build a simulator in", &cache.simulators(), error);
    let scratch = Scratch::new_in(&cache.simulators()).map_err(|error| failed(&error))?;
    package
        .write(scratch.path())
        .map_err(|error| failed(&error))?;
    let built = cargo_build(
        toolchain,
        scratch.path(),
        &cache.logs().join(format!("{key}.log")),
    )?;
    // Only the program moves into place, in one step; sources and intermediate files go with the scratch folder.
    let kept = scratch.path().join("kept");
    std::fs::create_dir(&kept)
        .and_then(|()| std::fs::rename(built, kept.join(path.file_name().unwrap_or_default())))
        .and_then(|()| std::fs::rename(&kept, cache.simulators().join(&key)))
        .or_else(|error| if path.is_file() { Ok(()) } else { Err(error) }) // another nsv built the same
        .map_err(|error| failed(&error))?;
    Ok(Program { path, key })
}

/// Builds the package in `folder`; the path of the program.
fn cargo_build(toolchain: &Toolchain, folder: &Path, log: &Path) -> Result<PathBuf, Failure> {
    let mut command = toolchain.cargo(folder);
    command.args([
        "build",
        "--release",
        "--offline",
        "--locked",
        "--bin",
        NAME,
        "--message-format=json-render-diagnostics",
    ]);
    let mut program = None;
    let finished = child::run(&mut command, |line| {
        program = executable(line).or(program.take())
    })
    .map_err(|error| {
        let reason = crate::cli::failure::reason(&error);
        Failure::new(
            Exit::Environment,
            format_args!("cannot run `{}`: {reason}", toolchain.cargo_program()),
        )
        .with_help(INSTALL)
    })?;
    match program {
        Some(program) if finished.status.success() => Ok(program),
        _ => Err(rejected(&finished.stderr, log)),
    }
}

/// The program that a line of cargo's messages names.
fn executable(line: &str) -> Option<PathBuf> {
    let message: serde_json::Value = serde_json::from_str(line).ok()?;
    message.get("executable")?.as_str().map(PathBuf::from)
}

fn rejected(stderr: &str, log: &Path) -> Failure {
    let first = stderr
        .lines()
        .find(|line| line.starts_with("error"))
        .unwrap_or("cargo gave no reason");
    let kept = match std::fs::write(log, stderr) {
        Ok(()) => format!("the compiler's words are in `{}`", log.display()),
        Err(_) => format!("the compiler said:\n{stderr}"),
    };
    Failure::new(
        Exit::Environment,
        format_args!("cannot build the simulator: {first}\n  {kept}"),
    )
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;
    use std::process::Command;

    use super::super::package::tests::{SPEC, fake};
    use super::*;

    fn entries(folder: &Path) -> Vec<PathBuf> {
        std::fs::read_dir(folder)
            .unwrap()
            .map(|entry| entry.unwrap().path())
            .collect()
    }

    #[test]
    fn a_runner_is_built_once_and_only_the_program_stays() {
        let root = tempfile::tempdir().unwrap();
        let cache = Cache::at(root.path().to_owned()).unwrap();
        let builds = Cell::new(0);
        let prepare = || prepare(&cache, &fake(SPEC), || builds.set(builds.get() + 1)).unwrap();
        let built = prepare();
        assert_eq!(built, prepare());
        assert_eq!(key(&cache, &fake(SPEC)).unwrap(), built.key);
        let program = built.path;
        assert_eq!(builds.get(), 1);
        assert_eq!(entries(&cache.simulators()), [program.parent().unwrap()]);
        assert_eq!(entries(program.parent().unwrap()), [program.as_path()]);
        assert_eq!(
            child::answer(&mut Command::new(program)).as_deref(),
            Some("fake 2\n")
        );
    }

    #[test]
    fn code_that_does_not_compile_names_its_log() {
        let root = tempfile::tempdir().unwrap();
        let cache = Cache::at(root.path().to_owned()).unwrap();
        let failure = prepare(&cache, &fake("pub struct Simulator"), || {}).unwrap_err();
        let Failure::Message {
            exit: Exit::Environment,
            message,
            ..
        } = failure
        else {
            panic!("{failure:?}")
        };
        let log = entries(&cache.logs()).pop().unwrap();
        assert!(message.contains(&*log.to_string_lossy()), "{message}");
        assert!(
            std::fs::read_to_string(log)
                .unwrap()
                .contains("simulator.rs")
        );
        assert_eq!(entries(&cache.simulators()), [""; 0].map(PathBuf::from));
    }

    #[test]
    fn a_missing_cargo_is_said_with_a_remedy() {
        let root = tempfile::tempdir().unwrap();
        let cache = Cache::at(root.path().to_owned()).unwrap();
        let toolchain = Toolchain::with_cargo("/no/such/cargo");
        let failure = prepare_with(&cache, &fake(SPEC), &toolchain, || {}).unwrap_err();
        let Failure::Message {
            exit: Exit::Environment,
            message,
            help: Some(help),
        } = failure
        else {
            panic!("{failure:?}")
        };
        assert!(
            message.contains("/no/such/cargo") && help.contains("rustup"),
            "{message} {help}"
        );
    }
}
