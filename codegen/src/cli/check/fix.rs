//! `nsv check --fix`: applies what is certain to the files.
//!
//! A file is replaced as a whole by renaming a complete copy over it, so that whatever happens it holds either the old text or the
//! new one. It is left alone if it has changed since it was read, or is not below the specification's directory.

use std::fs;
use std::path::{Path, PathBuf};

use nsv_codegen::whole;
use nsv_spec::diagnostic::{Diagnostics, Fixed};

use super::Checked;
use crate::cli::failure::{Exit, Failure};
use crate::cli::output::note;
use crate::cli::settings::Settings;

/// Most rounds: a fix may bring to light what was hidden behind a fault, such as names behind syntax.
const ROUNDS: usize = 10;

/// Mends a specification as far as that is certain, tells what was changed, and gives what is left.
pub(super) fn run<'a>(path: &'a Path, settings: &Settings) -> Result<Vec<Checked<'a>>, Failure> {
    for _ in 0..ROUNDS {
        let checked = super::check(path, settings);
        let mendable = checked
            .iter()
            .map(|one| (&one.faults, one.faults.fix()))
            .find(|(_, fixed)| !fixed.is_empty());
        let Some((faults, fixed)) = mendable else {
            return Ok(checked);
        };
        for file in &fixed {
            apply(path, faults, file)?;
        }
    }
    Ok(super::check(path, settings))
}

fn apply(spec: &Path, faults: &Diagnostics, fixed: &Fixed) -> Result<(), Failure> {
    let source = faults.sources.source(fixed.file);
    let name = Path::new(&source.name);
    let target = target(spec, name).map_err(|reason| refuse(name, &reason))?;
    let present = fs::read(&target).map_err(|error| refuse(name, &error.to_string()))?;
    if present != source.text.as_bytes() {
        return Err(refuse(name, "it has changed since it was read"));
    }
    whole::write(&target, fixed.text.as_bytes())
        .map_err(|error| refuse(name, &error.to_string()))?;
    for change in &fixed.applied {
        let (line, column) = faults.sources.location(change.span);
        let range = change.span.start as usize..change.span.end as usize;
        let shown = |text: &str| text.replace('\u{feff}', "(byte order mark)");
        note(format_args!(
            "{}:{line}:{column}: fixed `{}` -> `{}`",
            source.name,
            shown(&source.text[range]),
            shown(&change.replacement),
        ));
    }
    Ok(())
}

/// The file behind a name, if it lies below the directory of the specification.
fn target(spec: &Path, name: &Path) -> Result<PathBuf, String> {
    let canonical = |path: &Path| fs::canonicalize(path).map_err(|error| error.to_string());
    let target = canonical(name)?;
    if target == canonical(spec)? {
        return Ok(target);
    }
    let directory = match spec.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    match target.starts_with(canonical(directory)?) {
        true => Ok(target),
        false => Err("it is outside the specification's directory".into()),
    }
}

fn refuse(name: &Path, reason: &str) -> Failure {
    Failure::new(
        Exit::Environment,
        format!("cannot fix {}: {reason}", name.display()),
    )
}
