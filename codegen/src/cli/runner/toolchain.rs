//! The Rust toolchain that builds runners.

use std::ffi::OsString;
use std::path::Path;
use std::process::Command;

use crate::cli::child;
use crate::cli::failure::{Exit, Failure};

/// How to get a toolchain.
pub(crate) const INSTALL: &str = "install Rust 1.89 or newer from https://rustup.rs, or set CARGO and RUSTC to the programs to use";

/// Programs, and what the compiler says it is.
#[derive(Clone, Debug)]
pub(crate) struct Toolchain {
    cargo: OsString,
    rustc: OsString,
    /// `rustc -vV`: version, commit and host.
    pub(crate) version: String,
}

impl Toolchain {
    /// `$CARGO` and `$RUSTC`, else those in the path, asked in `folder`, where a toolchain file would apply to the build too.
    pub(crate) fn find(folder: &Path) -> Result<Toolchain, Failure> {
        let program = |variable: &str, name: &str| {
            std::env::var_os(variable)
                .filter(|value| !value.is_empty())
                .unwrap_or_else(|| name.into())
        };
        let (cargo, rustc) = (program("CARGO", "cargo"), program("RUSTC", "rustc"));
        let version = child::answer(Command::new(&rustc).arg("-vV").current_dir(folder));
        let missing = || {
            Failure::new(
                Exit::Environment,
                format_args!("cannot run `{} -vV`", rustc.to_string_lossy()),
            )
            .with_help(INSTALL)
        };
        Ok(Toolchain {
            version: version.ok_or_else(missing)?,
            cargo,
            rustc,
        })
    }

    /// A cargo command in `folder`, without the settings of the surroundings that would change what is built.
    pub(crate) fn cargo(&self, folder: &Path) -> Command {
        let mut command = Command::new(&self.cargo);
        command
            .current_dir(folder)
            .env("CARGO_TARGET_DIR", folder.join("target"))
            .env("RUSTC", &self.rustc);
        for (name, _) in std::env::vars_os() {
            let name = name.to_string_lossy();
            let changes_code = name.ends_with("RUSTFLAGS") || name.starts_with("CARGO_PROFILE_");
            if changes_code || name == "CARGO_BUILD_TARGET" {
                command.env_remove(&*name);
            }
        }
        command
    }

    /// A rustc command.
    pub(crate) fn rustc(&self, folder: &Path) -> Command {
        let mut command = Command::new(&self.rustc);
        command.current_dir(folder);
        command
    }

    /// The first line of the version.
    pub(crate) fn name(&self) -> &str {
        self.version.lines().next().unwrap_or_default()
    }

    /// The program used as cargo.
    pub(crate) fn cargo_program(&self) -> String {
        self.cargo.to_string_lossy().into_owned()
    }

    #[cfg(test)]
    pub(crate) fn with_cargo(cargo: &str) -> Toolchain {
        Toolchain {
            cargo: cargo.into(),
            rustc: "rustc".into(),
            version: "test".into(),
        }
    }
}
