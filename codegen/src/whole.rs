//! Files that are written whole: readers see the old text or the new one, never a part, and Ctrl-C waits until it is there.

use std::fs;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use tempfile::TempPath;

use crate::interrupt::shielded;

/// Puts `text` at `path`, in the place of what is there.
pub fn write(path: &Path, text: &[u8]) -> io::Result<()> {
    shielded(|| stage(path, text)?.persist())
}

/// As [`write`], but fails if anything is at `path`.
pub fn create(path: &Path, text: &[u8]) -> io::Result<()> {
    shielded(|| {
        let Staged { file, target } = stage(path, text)?;
        file.persist_noclobber(target).map_err(|error| error.error)
    })
}

/// A complete temporary file with the place that it is for. To be made and renamed, or dropped, under [`shielded`].
#[derive(Debug)]
pub struct Staged {
    file: TempPath,
    target: PathBuf,
}

impl Staged {
    /// Puts it in its place.
    pub fn persist(self) -> io::Result<()> {
        self.file.persist(self.target).map_err(|error| error.error)
    }
}

/// Writes `text` to a temporary file beside `path`. Its permissions are those of the file that is there, else those of the umask. A
/// folder that is missing is made.
pub fn stage(path: &Path, text: &[u8]) -> io::Result<Staged> {
    let target = target(path)?;
    let folder = folder_of(&target);
    fs::create_dir_all(folder)?;
    let mut builder = tempfile::Builder::new();
    builder.prefix(".nsv-");
    // Readable by whom the umask lets read, as any other file.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let mut file = builder.tempfile_in(folder)?;
    file.write_all(text)?;
    if let Ok(present) = fs::metadata(&target) {
        file.as_file().set_permissions(present.permissions())?;
    }
    file.as_file().sync_all()?;
    let file = file.into_temp_path();
    Ok(Staged { file, target })
}

/// The file that is written for `path`: behind a link, not the link. Folders, devices and pipes are refused, for a rename would put a
/// file in their place.
pub fn target(path: &Path) -> io::Result<PathBuf> {
    match fs::metadata(path) {
        Ok(present) if present.is_file() => fs::canonicalize(path),
        Ok(present) if present.is_dir() => Err(io::ErrorKind::IsADirectory.into()),
        Ok(_) => Err(io::Error::other("it is no regular file")),
        Err(_) => Ok(path.to_owned()),
    }
}

/// The folder of a file.
pub fn folder_of(path: &Path) -> &Path {
    path.parent()
        .filter(|parent| !parent.as_os_str().is_empty())
        .unwrap_or(Path::new("."))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_replaced_or_created_and_nothing_else_is_left() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("deep/a.txt");
        create(&path, b"first").unwrap();
        let again = create(&path, b"second").unwrap_err();
        assert_eq!(again.kind(), io::ErrorKind::AlreadyExists);
        assert_eq!(fs::read(&path).unwrap(), b"first");
        write(&path, b"third").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"third");
        assert!(write(folder_of(&path), b"a folder").is_err());
        assert_eq!(fs::read_dir(folder_of(&path)).unwrap().count(), 1);
    }

    #[cfg(unix)]
    #[test]
    fn links_are_followed_and_devices_refused() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::write(at("file"), b"old").unwrap();
        std::os::unix::fs::symlink(at("file"), at("link")).unwrap();
        write(&at("link"), b"new").unwrap();
        assert_eq!(fs::read(at("file")).unwrap(), b"new");
        assert!(fs::symlink_metadata(at("link")).unwrap().is_symlink());
        let refused = write(Path::new("/dev/null"), b"").unwrap_err();
        assert_eq!(refused.to_string(), "it is no regular file");
    }

    #[cfg(unix)]
    #[test]
    fn permissions_are_those_of_the_file_before_or_of_the_umask() {
        use std::os::unix::fs::PermissionsExt as _;
        let folder = tempfile::tempdir().unwrap();
        let mode = |name: &str| {
            let metadata = fs::metadata(folder.path().join(name)).unwrap();
            metadata.permissions().mode() & 0o777
        };
        let path = folder.path().join("a");
        write(&path, b"").unwrap();
        fs::write(folder.path().join("any"), b"").unwrap();
        assert_eq!(mode("a"), mode("any"));
        fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).unwrap();
        write(&path, b"new").unwrap();
        assert_eq!(mode("a"), 0o640);
    }
}
