//! Where built runners are kept.

use std::path::{Path, PathBuf};

use nsv_codegen::casadi::cache_folder;

use crate::cli::failure::{Exit, Failure};

const REMEDY: &str = "set NSV_CACHE_DIR to a folder that you may write";

/// The cache folder.
#[derive(Clone, Debug)]
pub(crate) struct Cache {
    root: PathBuf,
}

impl Cache {
    /// The folder that the partial derivatives are cached in too; made if it is not there.
    pub(crate) fn open() -> Result<Cache, Failure> {
        let root = cache_folder().ok_or_else(|| {
            Failure::new(Exit::Environment, "no place for built simulators").with_help(REMEDY)
        })?;
        // Cargo runs elsewhere: a relative folder would be another one there.
        Cache::at(std::path::absolute(&root).unwrap_or(root))
    }

    /// The cache in that folder.
    pub(crate) fn at(root: PathBuf) -> Result<Cache, Failure> {
        let cache = Cache { root };
        for folder in [cache.simulators(), cache.logs()] {
            std::fs::create_dir_all(&folder)
                .map_err(|error| Failure::io("create", &folder, &error).with_help(REMEDY))?;
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

    /// The program of a key, built or not.
    pub(crate) fn program(&self, key: &str) -> PathBuf {
        self.simulators()
            .join(key)
            .join(format!("simulator{}", std::env::consts::EXE_SUFFIX))
    }

    /// Number of built runners.
    pub(crate) fn built(&self) -> usize {
        let built =
            |entry: std::fs::DirEntry| self.program(&entry.file_name().to_string_lossy()).is_file();
        std::fs::read_dir(self.simulators()).map_or(0, |entries| {
            entries
                .flatten()
                .filter_map(|entry| built(entry).then_some(()))
                .count()
        })
    }
}
