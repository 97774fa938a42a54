//! Files that a verb writes: sets of texts, and numbers of any length.

use std::fs::File;
use std::io::{self, BufWriter, Write as _};
use std::path::{Path, PathBuf};

use nsv_codegen::interrupt::{Scratch, shielded};
use nsv_codegen::whole::{Staged, folder_of, stage, target};

use super::failure::{Exit, Failure};

/// Replaces a set of files: all texts are on disk before the first old file goes, so a full disk changes nothing.
pub(crate) fn replace(texts: &[(PathBuf, &str)], removed: &[PathBuf]) -> Result<(), Failure> {
    shielded(|| {
        let failed = |path: &Path, error: &io::Error| Failure::io("write", path, error);
        let staged: Vec<(Staged, &PathBuf)> = texts
            .iter()
            .map(|(path, text)| match stage(path, text.as_bytes()) {
                Ok(staged) => Ok((staged, path)),
                Err(error) => Err(failed(path, &error)),
            })
            .collect::<Result<_, _>>()?;
        for (staged, path) in staged {
            staged.persist().map_err(|error| failed(path, &error))?;
        }
        for path in removed {
            std::fs::remove_file(path).map_err(|error| Failure::io("remove", path, &error))?;
        }
        Ok(())
    })
}

/// Writes one file of any size through `write`; nothing is at `path` before all of it is.
pub(crate) fn write<E: std::error::Error + 'static>(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> Result<(), E>,
) -> Result<(), Failure> {
    let failed = |error: &io::Error| Failure::io("write", path, error);
    let target = target(path).map_err(|error| failed(&error))?;
    let scratch = Scratch::new_in(folder_of(&target)).map_err(|error| failed(&error))?;
    let staged = scratch.path().join("staged");
    let mut file = BufWriter::new(File::create(&staged).map_err(|error| failed(&error))?);
    write(&mut file).map_err(|error| match operating_system(&error) {
        Some(error) => failed(error),
        None => Failure::new(
            Exit::Environment,
            format_args!("cannot write `{}`: {error}", path.display()),
        ),
    })?;
    file.flush().map_err(|error| failed(&error))?;
    if let Ok(present) = std::fs::metadata(&target) {
        let kept = file.get_ref().set_permissions(present.permissions());
        kept.map_err(|error| failed(&error))?;
    }
    drop(file);
    std::fs::rename(&staged, target).map_err(|error| failed(&error))
}

/// The operating system's error at the root of a writer's.
fn operating_system<'e>(error: &'e (dyn std::error::Error + 'static)) -> Option<&'e io::Error> {
    std::iter::successors(Some(error), |error| error.source())
        .find_map(|error| error.downcast_ref())
}

/// Whether files can be made at all of `outputs`, given with what they are, as far as names go, before work begins whose results go
/// there; and whether none of them replaces another, or one that is read.
pub(crate) fn expect_places(
    inputs: &[&Path],
    outputs: &[(&str, Option<&Path>)],
) -> Result<(), Failure> {
    let mut taken: Vec<(PathBuf, String)> = inputs
        .iter()
        .map(|path| (place(path), format!("`{}`, which is read,", path.display())))
        .collect();
    for &(what, path) in outputs {
        let Some(path) = path else { continue };
        expect_folder(path)?;
        let place = place(path);
        if let Some((_, other)) = taken.iter().find(|(taken, _)| *taken == place) {
            let words = format!("{other} and {what} are the same file `{}`", path.display());
            return Err(Failure::new(Exit::Usage, words).with_help("give each a name of its own"));
        }
        taken.push((place, what.to_owned()));
    }
    Ok(())
}

/// Where a file is or will be, whatever way leads there.
fn place(path: &Path) -> PathBuf {
    path.canonicalize().unwrap_or_else(|_| {
        let folder = folder_of(path).canonicalize();
        folder.map_or_else(
            |_| path.to_owned(),
            |folder| folder.join(path.file_name().unwrap_or_default()),
        )
    })
}

fn expect_folder(path: &Path) -> Result<(), Failure> {
    let failed = |error: io::Error| Failure::io("write", path, &error);
    target(path).map_err(failed)?;
    match std::fs::metadata(folder_of(path)) {
        Ok(folder) if folder.is_dir() => Ok(()),
        Ok(_) => Err(failed(io::Error::other("its folder is a file"))),
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            Err(failed(io::Error::other("its folder does not exist")))
        }
        Err(error) => Err(failed(error)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        let mut names: Vec<String> = std::fs::read_dir(folder)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned())
            .collect();
        names.sort();
        names
    }

    #[test]
    fn a_set_is_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        std::fs::write(at("old.rs"), "old").unwrap();
        replace(
            &[(at("a.rs"), "a"), (at("deep/b.rs"), "b")],
            &[at("old.rs")],
        )
        .unwrap();
        assert_eq!(names(folder.path()), ["a.rs", "deep"]);
        assert_eq!(std::fs::read_to_string(at("deep/b.rs")).unwrap(), "b");
    }

    #[test]
    fn one_bad_target_leaves_all_files_as_they_were() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        std::fs::write(at("a.rs"), "old").unwrap();
        std::fs::create_dir(at("b.rs")).unwrap();
        assert!(replace(&[(at("a.rs"), "new"), (at("b.rs"), "new")], &[]).is_err());
        assert_eq!(std::fs::read_to_string(at("a.rs")).unwrap(), "old");
        assert_eq!(names(folder.path()), ["a.rs", "b.rs"]);
    }

    #[test]
    fn a_folder_is_expected_above_a_file() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        std::fs::write(at("file"), "").unwrap();
        assert!(expect_folder(&at("new.csv")).is_ok());
        assert!(expect_folder(&at("file")).is_ok());
        for wrong in [at(""), at("no/new.csv"), at("file/new.csv")] {
            assert!(expect_folder(&wrong).is_err(), "{wrong:?}");
        }
    }

    #[test]
    fn files_do_not_replace_each_other() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        std::fs::write(at("read"), "").unwrap();
        let (read, new, again) = (at("read"), at("new"), at("./new"));
        let said = |outputs: &[(&str, Option<&Path>)]| match expect_places(&[&read], outputs) {
            Ok(()) => String::new(),
            Err(Failure::Message { message, .. }) => message,
            Err(other) => panic!("{other:?}"),
        };
        assert_eq!(said(&[("`--a`", Some(&new)), ("`--b`", None)]), "");
        assert!(
            said(&[("`--a`", Some(&new)), ("`--b`", Some(&again))])
                .starts_with("`--a` and `--b` are the same file")
        );
        assert!(
            said(&[("`--a`", Some(&read))]).contains("which is read, and `--a` are the same file")
        );
    }

    #[test]
    fn a_write_that_fails_half_way_leaves_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("out.csv");
        let failed = write(&path, |file| {
            let _ = file.write_all(b"half");
            Err(io::Error::other("no more"))
        });
        assert!(failed.is_err());
        assert_eq!(names(folder.path()), [""; 0]);
        write(&path, |file| file.write_all(b"whole")).unwrap();
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "whole");
    }

    #[cfg(unix)]
    #[test]
    fn a_file_keeps_its_permissions() {
        use std::os::unix::fs::PermissionsExt as _;
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("out.csv");
        std::fs::write(&path, "old").unwrap();
        std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o640)).unwrap();
        write(&path, |file| file.write_all(b"new")).unwrap();
        let mode = std::fs::metadata(&path).unwrap().permissions().mode();
        assert_eq!(mode & 0o777, 0o640);
    }
}
