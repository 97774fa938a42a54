//! `nsv generate`: writes the code of specifications, or checks that what is written is theirs.

mod difference;
mod modules;

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use super::compile::{Partials, compile, load};
use super::failure::{Exit, Failure};
use super::files::replace;
use super::output::note;
use difference::{Difference, compare, read};
use modules::with_module;

/// Write the code of specifications, one module each
#[derive(clap::Args)]
pub(crate) struct Args {
    /// Specifications to compile
    #[arg(required = true, value_name = "SPEC")]
    specs: Vec<PathBuf>,
    /// Folder for the modules; default: `generated/src` of the workspace around the specification
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Write nothing; exit with 4 if a file is not what the specification gives
    #[arg(long)]
    check: bool,
}

/// Runs the verb.
pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let mut wanted: BTreeMap<PathBuf, String> = BTreeMap::new();
    let mut folders: BTreeSet<PathBuf> = BTreeSet::new();
    for spec in &args.specs {
        let model = load(spec)?;
        let out = match &args.out {
            Some(out) => out.clone(),
            None => workspace_output(spec)?,
        };
        let folder = out.join(&model.name);
        if !folders.insert(folder.clone()) {
            return Err(Failure::new(
                Exit::Usage,
                format_args!("two specifications are named `{}`", model.name),
            ));
        }
        let compiled = compile(
            spec,
            &model,
            if args.check {
                Partials::Stored
            } else {
                Partials::Committed
            },
        )?;
        wanted.extend(
            compiled
                .files
                .into_iter()
                .map(|(path, text)| (folder.join(path), text)),
        );
        if let Some((path, text)) = registration(&out, &model.name, &wanted)? {
            wanted.insert(path, text);
        }
    }
    let differences = compare(&wanted, &folders)?;
    match args.check {
        true => verdict(&differences),
        false => write(&wanted, &folders, &differences),
    }
}

/// `generated/src` of the nearest ancestor that has one.
fn workspace_output(spec: &Path) -> Result<PathBuf, Failure> {
    let absolute = std::path::absolute(spec).map_err(|error| Failure::io("find", spec, &error))?;
    let found = absolute
        .ancestors()
        .skip(1)
        .map(|folder| folder.join("generated/src"))
        .find(|out| out.join("lib.rs").is_file());
    found.ok_or_else(|| {
        let message = format_args!(
            "no `generated/src/lib.rs` beside `{}` or above it",
            spec.display()
        )
        .to_string();
        Failure::new(Exit::Usage, message).with_help("name a folder with --out DIR")
    })
}

/// `lib.rs` of the output with the module declared, if there is such a file and it does not declare it yet.
fn registration(
    out: &Path,
    name: &str,
    wanted: &BTreeMap<PathBuf, String>,
) -> Result<Option<(PathBuf, String)>, Failure> {
    let path = out.join("lib.rs");
    let text = match wanted.get(&path) {
        Some(text) => text.clone(),
        None if path.is_file() => read(&path)?,
        None => return Ok(None),
    };
    Ok(with_module(&text, name).map(|text| (path, text)))
}

fn verdict(differences: &BTreeMap<PathBuf, Difference>) -> Result<(), Failure> {
    if differences.is_empty() {
        note("generated code is up to date");
        return Ok(());
    }
    for (path, difference) in differences {
        note(format_args!(
            "error: `{}` {}",
            path.display(),
            difference.words()
        ));
    }
    let help = match differences.values().any(|difference| difference.precious()) {
        true => "what was written by hand is lost when you remove it and run `nsv generate`",
        false => "run `nsv generate`",
    };
    note(format_args!("  = help: {help}"));
    Err(Failure::Reported(Exit::Check))
}

fn write(
    wanted: &BTreeMap<PathBuf, String>,
    folders: &BTreeSet<PathBuf>,
    differences: &BTreeMap<PathBuf, Difference>,
) -> Result<(), Failure> {
    let precious: Vec<_> = differences
        .iter()
        .filter(|(_, difference)| difference.precious())
        .collect();
    if !precious.is_empty() {
        for (path, difference) in precious {
            note(format_args!(
                "error: `{}` {}",
                path.display(),
                difference.words()
            ));
        }
        note(
            "  = help: nothing was written; move or remove these files, then run `nsv generate` again",
        );
        return Err(Failure::Reported(Exit::Check));
    }
    let removed: Vec<PathBuf> = differences
        .iter()
        .filter(|(_, d)| **d == Difference::LeftOver)
        .map(|(path, _)| path.clone())
        .collect();
    let changed = wanted
        .iter()
        .filter(|(path, _)| differences.contains_key(*path));
    let changed: Vec<(PathBuf, &str)> = changed
        .map(|(path, text)| (path.clone(), text.as_str()))
        .collect();
    replace(&changed, &removed)?;
    for folder in folders {
        let (all, new) = (
            wanted.keys().filter(|path| path.starts_with(folder)),
            changed.iter().filter(|(path, _)| path.starts_with(folder)),
        );
        note(format_args!(
            "{}: {} files, {} of them written now",
            folder.display(),
            all.count(),
            new.count()
        ));
    }
    Ok(())
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

        fn folder(&self) -> PathBuf {
            self.root.path().join("loop")
        }

        fn wanted(&self, body: &str) -> BTreeMap<PathBuf, String> {
            [
                ("mod.rs", seal("pub mod plant;\n")),
                ("plant.rs", seal(body)),
            ]
            .map(|(name, text)| (self.folder().join(name), text))
            .into()
        }

        fn differences(&self, wanted: &BTreeMap<PathBuf, String>) -> Vec<(String, Difference)> {
            let found = compare(wanted, &[self.folder()].into()).unwrap();
            found
                .into_iter()
                .map(|(path, d)| (path.file_name().unwrap().to_string_lossy().into_owned(), d))
                .collect()
        }

        fn write(&self, wanted: &BTreeMap<PathBuf, String>) -> Result<(), Failure> {
            let folders = [self.folder()].into();
            super::write(wanted, &folders, &compare(wanted, &folders).unwrap())
        }
    }

    #[test]
    fn what_was_written_is_up_to_date() {
        let output = Output::new();
        let wanted = output.wanted("// 1\n");
        assert_eq!(output.differences(&wanted).len(), 2);
        output.write(&wanted).unwrap();
        assert_eq!(output.differences(&wanted), []);
        assert!(verdict(&BTreeMap::new()).is_ok());
    }

    #[test]
    fn a_change_of_the_specification_makes_the_file_stale() {
        let output = Output::new();
        output.write(&output.wanted("// 1\n")).unwrap();
        let newer = output.wanted("// 2\n");
        assert_eq!(
            output.differences(&newer),
            [("plant.rs".to_owned(), Difference::Stale)]
        );
        output.write(&newer).unwrap();
        assert_eq!(output.differences(&newer), []);
    }

    #[test]
    fn work_by_hand_is_never_overwritten() {
        let output = Output::new();
        output.write(&output.wanted("// 1\n")).unwrap();
        let path = output.folder().join("plant.rs");
        let edited = std::fs::read_to_string(&path).unwrap() + "// mine\n";
        std::fs::write(&path, &edited).unwrap();
        std::fs::write(output.folder().join("extra.rs"), "// mine too\n").unwrap();
        let newer = output.wanted("// 2\n");
        let expected = [
            ("extra.rs".to_owned(), Difference::Foreign),
            ("plant.rs".to_owned(), Difference::Edited),
        ];
        assert_eq!(output.differences(&newer), expected);
        assert!(matches!(
            output.write(&newer),
            Err(Failure::Reported(Exit::Check))
        ));
        assert_eq!(std::fs::read_to_string(&path).unwrap(), edited);
    }

    #[test]
    fn files_that_are_no_longer_made_go() {
        let output = Output::new();
        let mut older = output.wanted("// 1\n");
        older.insert(output.folder().join("lyapunov.rs"), seal("// V\n"));
        output.write(&older).unwrap();
        let wanted = output.wanted("// 1\n");
        assert_eq!(
            output.differences(&wanted),
            [("lyapunov.rs".to_owned(), Difference::LeftOver)]
        );
        output.write(&wanted).unwrap();
        assert!(!output.folder().join("lyapunov.rs").exists());
    }
}
