//! Stored exports: found by their question, refused when they are not what they claim, written whole.

use std::collections::BTreeSet;
use std::fs;

use nsv_codegen::casadi::store::Store;
use nsv_codegen::casadi::{Environment, Error, Mode, Provider, Question};
use nsv_codegen::ir::Program;

use super::{formula, partials, path, rates};

fn product() -> Program {
    formula(
        "program product\n input x: real\n %0: real = input x\n %1: real = powi %0, 3\n output q = %1",
    )
}

/// A cache directory that holds the export of [`product`], as if CasADi had been asked before.
fn cache_with_product() -> tempfile::TempDir {
    partials(&product(), &rates(1, &["x"]));
    let cache = tempfile::tempdir().unwrap();
    let committed = Store::new(path("partials"));
    let program = product();
    let question = Question::new(&program, &rates(1, &["x"]));
    let export = committed
        .load(&question.key(), &question.request)
        .unwrap()
        .unwrap();
    Store::new(cache.path().join("partials"))
        .save(&export)
        .unwrap();
    cache
}

#[test]
fn a_cached_export_is_committed_when_it_is_used() {
    let (cache, specs) = (cache_with_product(), tempfile::tempdir().unwrap());
    let directory = specs.path().join("partials");
    let environment = Environment {
        cache: Some(cache.path().to_owned()),
        ..Environment::offline(&directory)
    };
    let mut provider = Provider::new(environment, |_| {});
    provider.partials(&product(), &rates(1, &["x"])).unwrap();
    provider.commit().unwrap();
    let stored = Store::new(&directory).keys().unwrap();
    assert_eq!(stored, provider.used());
    assert!(provider.unused().unwrap().is_empty());
    let key = stored.first().unwrap();
    let name = format!("{key}.json");
    assert_eq!(
        fs::read(directory.join(&name)).unwrap(),
        fs::read(path("partials").join(&name)).unwrap()
    );
    assert_eq!(
        fs::read_dir(&directory).unwrap().count(),
        1,
        "no temporary file stays"
    );

    let idle = Provider::new(Environment::offline(&directory), |_| {});
    assert_eq!(idle.unused().unwrap(), BTreeSet::from([key.clone()]));
}

#[test]
fn a_missing_export_is_reported() {
    let empty = tempfile::tempdir().unwrap();
    let mut provider = Provider::new(Environment::offline(empty.path()), |_| {});
    let error = provider
        .partials(&product(), &rates(1, &["x"]))
        .unwrap_err();
    assert!(matches!(error, Error::ExportMissing { .. }), "{error:?}");
    assert!(
        error
            .to_string()
            .starts_with("the partial derivatives of `product` are not stored"),
        "{error}"
    );
}

/// The message for a committed export of [`product`] after `change`.
fn changed(change: impl Fn(String) -> String) -> String {
    let (cache, specs) = (cache_with_product(), tempfile::tempdir().unwrap());
    let entry = fs::read_dir(cache.path().join("partials"))
        .unwrap()
        .next()
        .unwrap()
        .unwrap();
    let text = fs::read_to_string(entry.path()).unwrap();
    fs::write(specs.path().join(entry.file_name()), change(text)).unwrap();
    let mut provider = Provider::new(Environment::offline(specs.path()), |_| {});
    let error = provider
        .partials(&product(), &rates(1, &["x"]))
        .unwrap_err();
    error
        .to_string()
        .replace(&specs.path().display().to_string(), "specs")
}

#[test]
fn a_changed_export_is_refused() {
    let messages = [
        changed(|text| text.replace("3.8.2", "3.7.0")),
        changed(|text| text.replace("\"powi\",[0],[3]", "\"powi\",[0],[4]")),
        changed(|text| text.replace("\"MUL\"", "\"LOG1P\"")),
        changed(|text| text[..text.len() / 2].to_owned()),
        changed(|_| "null".to_owned()),
    ];
    insta::assert_snapshot!(messages.join("\n"));
}

/// A broken file in the cache is as good as none: the next place is asked, here Python, which is missing.
#[test]
fn a_broken_cache_entry_is_absent() {
    let (cache, specs) = (cache_with_product(), tempfile::tempdir().unwrap());
    let entry = fs::read_dir(cache.path().join("partials"))
        .unwrap()
        .next()
        .unwrap()
        .unwrap();
    fs::write(entry.path(), "{").unwrap();
    let environment = Environment {
        cache: Some(cache.path().to_owned()),
        python: Some("/nonexistent/python".into()),
        mode: Mode::Provision,
        ..Environment::offline(specs.path())
    };
    let mut provider = Provider::new(environment, |_| {});
    let error = provider
        .partials(&product(), &rates(1, &["x"]))
        .unwrap_err();
    assert!(matches!(error, Error::PythonMissing { .. }), "{error:?}");
}
