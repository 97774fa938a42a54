//! `nsv fmt`: one layout for all specifications.

use std::path::{Path, PathBuf};

use nsv_spec::diagnostic::{Diagnostics, FileId, SourceMap};
use nsv_spec::yaml::{self, Unformatted};

use super::compile::show;
use super::failure::{Exit, Failure};
use super::files::replace;
use super::output::note;

/// Lay out specifications and the files that they include: indentation, blanks and empty lines, nothing else
#[derive(clap::Args)]
pub(crate) struct Args {
    /// YAML files to lay out
    #[arg(required = true, value_name = "SPEC")]
    specs: Vec<PathBuf>,
    /// Write nothing; exit with 4 if a file would change
    #[arg(long)]
    check: bool,
}

/// Runs the verb. Either every file is as it should be afterwards, or none is changed.
pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let mut changed: Vec<(PathBuf, String)> = Vec::new();
    for path in &args.specs {
        let (old, new) = formatted(path)?;
        if new != old {
            changed.push((path.clone(), new));
            let verb = if args.check {
                "would change"
            } else {
                "laid out"
            };
            note(format_args!("{verb} `{}`", path.display()));
        }
    }
    if args.check && !changed.is_empty() {
        note("  = help: run `nsv fmt` with the same files");
        return Err(Failure::Reported(Exit::Check));
    }
    let texts: Vec<(PathBuf, &str)> = changed
        .iter()
        .map(|(path, text)| (path.clone(), text.as_str()))
        .collect();
    replace(&texts, &[])
}

/// The text of a file and what it should be.
fn formatted(path: &Path) -> Result<(String, String), Failure> {
    let bytes = std::fs::read(path).map_err(|error| Failure::io("read", path, &error))?;
    let name = path.display().to_string();
    let refused = |fault, text| {
        let mut sources = SourceMap::default();
        sources.add(name.as_str(), text);
        show(&Diagnostics {
            sources,
            items: vec![fault],
        });
        Failure::Reported(Exit::Spec)
    };
    let text = yaml::text(&bytes, FileId(0))
        .map_err(|fault| refused(*fault, String::from_utf8_lossy(&bytes).into()))?;
    match yaml::format(&text) {
        Ok(new) => Ok((text.to_string(), new)),
        Err(Unformatted::Fault(fault)) => Err(refused(*fault, text)),
        Err(Unformatted::Unsafe) => Err(Failure::new(
            Exit::Check,
            format_args!("`{name}` was left alone: its meaning would have changed"),
        )
        .with_help("this is a fault of nsv; please report it with the file")),
    }
}
