//! Specifications of the repository and what they compile to, from committed partial derivatives only.
//!
//! With `NSV_UPDATE_EXPORTS` and `NSV_PYTHON` (an interpreter that has casadi) set, missing exports are taken and stored.

use std::env;
use std::path::{Path, PathBuf};

use nsv_codegen::casadi::{Environment, Mode, Provider};
use nsv_codegen::derive::derive;
use nsv_codegen::derive::error::DeriveError;
use nsv_codegen::lower::Programs;
use nsv_spec::model::Model;

/// A path of the repository.
pub fn repository(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .parent()
        .unwrap()
        .join(path)
}

/// The specifications in a folder of the repository, by name of file.
pub fn specifications(folder: &str) -> Vec<PathBuf> {
    let entries = repository(folder)
        .read_dir()
        .unwrap()
        .map(|entry| entry.unwrap().path());
    let mut paths: Vec<PathBuf> = entries
        .filter(|path| {
            path.extension()
                .is_some_and(|extension| extension == "yaml")
        })
        .collect();
    assert!(!paths.is_empty(), "{folder} has specifications");
    paths.sort();
    paths
}

/// The specification of this name, of the product or of the tests.
pub fn named(name: &str) -> PathBuf {
    let candidates =
        ["specs", "tests/specs"].map(|folder| repository(folder).join(format!("{name}.yaml")));
    let found = candidates.into_iter().find(|path| path.exists());
    found.unwrap_or_else(|| panic!("there is a specification {name}"))
}

/// The model of a specification without faults.
pub fn model(path: &Path) -> Model {
    let loaded = nsv_spec::load(path);
    let (model, _) =
        loaded.unwrap_or_else(|faults| panic!("{}: {:?}", path.display(), faults.items));
    model
}

/// A provider of the exports in `partials` beside the specification.
pub fn provider(path: &Path) -> Provider<'static> {
    let exports = path.with_file_name("partials");
    let update = env::var_os("NSV_UPDATE_EXPORTS").is_some();
    let environment = if update {
        Environment::from_variables(exports, Mode::Provision).expect("variables that can be used")
    } else {
        Environment::offline(exports)
    };
    Provider::new(environment, |_| {})
}

/// The programs of a model.
pub fn programs(model: &Model, provider: &mut Provider<'_>) -> Result<Programs, DeriveError> {
    let law = derive(model, provider)?;
    if env::var_os("NSV_UPDATE_EXPORTS").is_some() {
        provider.commit().unwrap();
    }
    Ok(Programs::new(&law))
}

/// Model and programs of a specification.
pub fn compiled(path: &Path) -> (Model, Programs) {
    let model = model(path);
    let programs = programs(&model, &mut provider(path))
        .unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    (model, programs)
}
