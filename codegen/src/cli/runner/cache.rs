//! Where built runners are kept.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use crate::cli::failure::{Exit, Failure};

/// The cache folder.
#[derive(Clone, Debug)]
pub(crate) struct Cache {
    root: PathBuf,
}

impl Cache {
    /// `$NSV_CACHE_DIR`, else `$XDG_CACHE_HOME/nsv`, else `$HOME/.cache/nsv`; made if it is not there.
    pub(crate) fn open() -> Result<Cache, Failure> {
        let root = root(|name| std::env::var_os(name)).ok_or_else(|| {
            Failure::new(Exit::Environment, "no place for built simulators").with_help("set NSV_CACHE_DIR to a folder that you may write")
        })?;
        Cache::at(root)
    }

    /// The cache in that folder.
    pub(crate) fn at(root: PathBuf) -> Result<Cache, Failure> {
        let cache = Cache { root };
        for folder in [cache.simulators(), cache.logs()] {
            std::fs::create_dir_all(&folder)
                .map_err(|error| Failure::io("create", &folder, &error).with_help("set NSV_CACHE_DIR to a folder that you may write"))?;
        }
        Ok(cache)
    }

    /// The folder itself.
    pub(crate) fn root(&self) -> &Path {
        &self.root
    }

    /// One folder for each built runner, by key.
    pub(crate) fn simulators(&self) -> PathBuf {
        self.root.join("simulators")
    }

    /// What compilers said about builds that failed.
    pub(crate) fn logs(&self) -> PathBuf {
        self.root.join("logs")
    }
}

fn root(variable: impl Fn(&str) -> Option<OsString>) -> Option<PathBuf> {
    let set = |name: &str| variable(name).filter(|value| !value.is_empty()).map(PathBuf::from);
    // A relative XDG path is to be ignored, says the standard.
    let xdg = set("XDG_CACHE_HOME").filter(|path| path.is_absolute()).map(|path| path.join("nsv"));
    let home = || set("HOME").or_else(|| set("USERPROFILE")).map(|path| path.join(".cache/nsv"));
    let chosen = set("NSV_CACHE_DIR").map(|path| std::path::absolute(&path).unwrap_or(path));
    chosen.or(xdg).or_else(home)
}

#[cfg(test)]
mod tests {
    #[test]
    fn our_variable_wins_then_xdg_then_home() {
        let root = |pairs: &[(&str, &str)]| {
            let pairs = pairs.to_vec();
            super::root(move |name| pairs.iter().find(|(other, _)| *other == name).map(|(_, value)| value.into()))
        };
        assert_eq!(root(&[("NSV_CACHE_DIR", "/a"), ("XDG_CACHE_HOME", "/b"), ("HOME", "/c")]), Some("/a".into()));
        assert_eq!(root(&[("NSV_CACHE_DIR", ""), ("XDG_CACHE_HOME", "/b"), ("HOME", "/c")]), Some("/b/nsv".into()));
        assert_eq!(root(&[("XDG_CACHE_HOME", "b"), ("HOME", "/c")]), Some("/c/.cache/nsv".into()));
        assert_eq!(root(&[]), None);
    }
}
