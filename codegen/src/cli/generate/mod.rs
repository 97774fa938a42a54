//! `nsv generate`: writes the code of specifications, or checks that what is written is theirs.

mod difference;
mod explain;
mod inspect;
mod library;
mod origin;
mod target;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::compile::{Math, Partials, compile, load};
use super::failure::{Exit, Failure};
use super::files::replace;
use super::output::note;
use super::settings::Settings;
use difference::{Difference, compare};
use target::Target;

/// Write the code of specifications, one module each
#[derive(clap::Args)]
pub(crate) struct Args {
    /// Specifications to compile
    #[arg(required = true, value_name = "SPEC")]
    specs: Vec<PathBuf>,
    #[command(flatten)]
    settings: Settings,
    /// Folder for the modules; default: `generated/src` of the workspace around the specification
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Write nothing; exit with 4 if a file is not what the specification gives
    #[arg(long)]
    check: bool,
    /// What optimisation may change
    #[arg(long, value_enum, default_value_t)]
    math: Math,
    #[command(flatten)]
    inspect: inspect::Args,
}

/// Runs the verb.
pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    if args.inspect.wanted() {
        return inspect::run(&args.inspect, &args.specs, &args.settings, args.math);
    }
    let partials = if args.check {
        Partials::Stored
    } else {
        Partials::Committed
    };
    let mut target = Target::default();
    for spec in &args.specs {
        let model = load(spec, &args.settings)?;
        let out = match &args.out {
            Some(out) => out.clone(),
            None => workspace_output(spec)?,
        };
        target.add(
            &out,
            &model.name,
            &model.title,
            compile(spec, &model, partials, args.math)?.files,
        )?;
    }
    let differences = compare(&target)?;
    match args.check {
        true => verdict(&differences),
        false => write(&target, &differences),
    }
}

/// `generated/src` of the nearest ancestor that has one.
fn workspace_output(spec: &Path) -> Result<PathBuf, Failure> {
    let absolute = std::path::absolute(spec).map_err(|error| Failure::io("find", spec, &error))?;
    let candidates = absolute
        .ancestors()
        .skip(1)
        .map(|folder| folder.join("generated/src"));
    let here = std::env::current_dir().unwrap_or_default();
    candidates
        .map(|out| out.strip_prefix(&here).map_or(out.clone(), Path::to_owned)) // as people would write it
        .find(|out| out.join("lib.rs").is_file())
        .ok_or_else(|| {
            let message = format!(
                "no `generated/src/lib.rs` beside `{}` or above it",
                spec.display()
            );
            Failure::new(Exit::Usage, message).with_help("name a folder with --out DIR")
        })
}

fn verdict(differences: &BTreeMap<PathBuf, Difference>) -> Result<(), Failure> {
    if differences.is_empty() {
        note("generated code is up to date");
        return Ok(());
    }
    let any = |found: fn(Difference) -> bool| differences.values().any(|one| found(*one));
    let help = if any(Difference::precious) {
        "what was written by hand is lost when you remove it and run `nsv generate`"
    } else if any(|difference| difference == Difference::OtherMath) {
        "check with the `--math` that the code has, or run `nsv generate` with this one"
    } else {
        "run `nsv generate`"
    };
    Err(refuse(differences.iter(), help))
}

fn write(target: &Target, differences: &BTreeMap<PathBuf, Difference>) -> Result<(), Failure> {
    let mut precious = differences
        .iter()
        .filter(|(_, difference)| difference.precious())
        .peekable();
    if precious.peek().is_some() {
        return Err(refuse(
            precious,
            "nothing was written; move or remove these files, then run `nsv generate` again",
        ));
    }
    let left_over = differences
        .iter()
        .filter(|(_, difference)| **difference == Difference::LeftOver);
    let removed: Vec<PathBuf> = left_over.map(|(path, _)| path.clone()).collect();
    let changed = target
        .files
        .iter()
        .filter(|(path, _)| differences.contains_key(*path));
    let changed: Vec<(PathBuf, &str)> = changed
        .map(|(path, text)| (path.clone(), text.as_str()))
        .collect();
    replace(&changed, &removed)?;
    for folder in &target.folders {
        let all = target
            .files
            .keys()
            .filter(|path| path.starts_with(folder))
            .count();
        let written = changed
            .iter()
            .filter(|(path, _)| path.starts_with(folder))
            .count();
        note(format_args!(
            "{}: {all} files, {written} of them written now",
            folder.display()
        ));
    }
    Ok(())
}

/// Names the files and what is wrong with them.
fn refuse<'d>(
    differences: impl Iterator<Item = (&'d PathBuf, &'d Difference)>,
    help: &str,
) -> Failure {
    for (path, difference) in differences {
        note(format_args!(
            "error: `{}` {}",
            path.display(),
            difference.words()
        ));
    }
    note(format_args!("  = help: {help}"));
    Failure::Reported(Exit::Check)
}

#[cfg(test)]
mod tests {
    use nsv_codegen::seal::seal;

    use super::*;

    struct Output {
        root: tempfile::TempDir,
    }

    impl Output {
        fn new() -> Output {
            Output {
                root: tempfile::tempdir().unwrap(),
            }
        }

        fn at(&self, path: &str) -> PathBuf {
            self.root.path().join(path)
        }

        /// A module `arm` of two files.
        fn target(&self, body: &str) -> Target {
            let files = [("mod.rs", "pub mod plant;\n"), ("plant.rs", body)];
            let mut target = Target::default();
            let files = files
                .map(|(name, text)| (name.to_owned(), seal(text)))
                .into();
            target
                .add(self.root.path(), "arm", "An arm", files)
                .unwrap();
            target
        }

        fn differences(&self, target: &Target) -> Vec<(String, Difference)> {
            let found = compare(target).unwrap().into_iter();
            found
                .map(|(path, d)| (path.file_name().unwrap().to_string_lossy().into_owned(), d))
                .collect()
        }

        fn write(&self, target: &Target) -> Result<(), Failure> {
            super::write(target, &compare(target).unwrap())
        }

        fn check(&self, target: &Target, expected: &[(&str, Difference)]) {
            let expected: Vec<_> = expected
                .iter()
                .map(|(name, difference)| ((*name).to_owned(), *difference))
                .collect();
            assert_eq!(self.differences(target), expected);
        }
    }

    #[test]
    fn what_was_written_is_up_to_date() {
        let output = Output::new();
        let target = output.target("// 1\n");
        output.check(
            &target,
            &[
                ("mod.rs", Difference::Missing),
                ("plant.rs", Difference::Missing),
            ],
        );
        output.write(&target).unwrap();
        output.check(&target, &[]);
        assert!(verdict(&BTreeMap::new()).is_ok());
    }

    #[test]
    fn a_change_of_the_specification_makes_the_file_stale() {
        let output = Output::new();
        output.write(&output.target("// 1\n")).unwrap();
        let newer = output.target("// 2\n");
        output.check(&newer, &[("plant.rs", Difference::Stale)]);
        output.write(&newer).unwrap();
        output.check(&newer, &[]);
    }

    #[test]
    fn code_of_the_other_math_is_told_from_stale_code() {
        let output = Output::new();
        output
            .write(&output.target("// math fast: as said\n// 1\n"))
            .unwrap();
        let strict = output.target("// 1\n");
        output.check(&strict, &[("plant.rs", Difference::OtherMath)]);
    }

    #[test]
    fn work_by_hand_is_never_overwritten() {
        let output = Output::new();
        output.write(&output.target("// 1\n")).unwrap();
        let edited = std::fs::read_to_string(output.at("arm/plant.rs")).unwrap() + "// mine\n";
        std::fs::write(output.at("arm/plant.rs"), &edited).unwrap();
        std::fs::write(output.at("arm/extra.rs"), "// mine too\n").unwrap();
        let newer = output.target("// 2\n");
        output.check(
            &newer,
            &[
                ("extra.rs", Difference::Foreign),
                ("plant.rs", Difference::Edited),
            ],
        );
        assert!(matches!(
            output.write(&newer),
            Err(Failure::Reported(Exit::Check))
        ));
        assert_eq!(
            std::fs::read_to_string(output.at("arm/plant.rs")).unwrap(),
            edited
        );
    }

    #[test]
    fn files_that_are_no_longer_made_go() {
        let output = Output::new();
        let mut older = output.target("// 1\n");
        older
            .files
            .insert(output.at("arm/lyapunov.rs"), seal("// V\n"));
        output.write(&older).unwrap();
        let target = output.target("// 1\n");
        output.check(&target, &[("lyapunov.rs", Difference::LeftOver)]);
        output.write(&target).unwrap();
        assert!(!output.at("arm/lyapunov.rs").exists());
    }

    #[test]
    fn the_library_declares_its_modules() {
        let output = Output::new();
        std::fs::write(output.at("lib.rs"), "//! Nothing yet.\n#![no_std]\n").unwrap();
        let target = output.target("// 1\n");
        let missing = [
            ("mod.rs", Difference::Missing),
            ("plant.rs", Difference::Missing),
            ("lib.rs", Difference::Stale),
        ];
        output.check(&target, &missing);
        output.write(&target).unwrap();
        output.check(&output.target("// 1\n"), &[]);
        assert!(
            std::fs::read_to_string(output.at("lib.rs"))
                .unwrap()
                .contains("pub mod arm;")
        );
    }

    #[test]
    fn a_library_of_somebody_else_is_left_alone() {
        let output = Output::new();
        for text in ["pub mod mine;\n", "pub fn f() {}\n"] {
            std::fs::write(output.at("lib.rs"), text).unwrap();
            output.write(&output.target("// 1\n")).unwrap();
            assert_eq!(std::fs::read_to_string(output.at("lib.rs")).unwrap(), text);
        }
    }
}
