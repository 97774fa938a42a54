//! The committed code is what the specifications give, from committed partial derivatives alone, every time.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use nsv_codegen::casadi::Provider;
use nsv_codegen::driver::{compile, library, lower};
use nsv_codegen::ir::Op;
use nsv_codegen::opt::Arithmetic;
use nsv_spec::is_of_the_law;
use nsv_tests::specification::{model, provider, repository, specifications};

/// Module, title and files of a specification.
fn generate(
    path: &Path,
    provider: &mut Provider<'_>,
) -> (String, String, BTreeMap<String, String>) {
    let model = model(path);
    let compiled = compile(&model, provider, Arithmetic::Strict)
        .unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    (model.name, model.title, compiled.files)
}

/// Text of every file of a folder by name.
fn files(folder: &Path) -> BTreeMap<String, String> {
    let entries = folder
        .read_dir()
        .unwrap()
        .map(|entry| entry.unwrap().path());
    entries
        .map(|path| (file_name(&path), fs::read_to_string(&path).unwrap()))
        .collect()
}

fn file_name(path: &Path) -> String {
    path.file_name().unwrap().to_string_lossy().into_owned()
}

fn check(module: &str, generated: &BTreeMap<String, String>, committed: &BTreeMap<String, String>) {
    let names = |files: &BTreeMap<String, String>| files.keys().cloned().collect::<BTreeSet<_>>();
    assert_eq!(names(generated), names(committed), "{module}");
    for (file, text) in generated {
        // The first line is a hash of the others: where those part says more.
        let lines = text.lines().zip(committed[file].lines()).skip(1);
        let difference = lines.into_iter().find(|(new, old)| new != old);
        assert!(
            *text == committed[file],
            "{module}/{file} is stale: run `nsv generate specs/*.yaml`; {difference:?}"
        );
    }
}

#[test]
fn committed_code_is_fresh_and_complete() {
    let source = repository("generated/src");
    let paths = specifications("specs");
    let mut provider = provider(&paths[0]);
    let mut modules = BTreeMap::new();
    for path in &paths {
        let (name, title, generated) = generate(path, &mut provider);
        check(&name, &generated, &files(&source.join(&name)));
        modules.insert(name, title);
    }
    assert_eq!(
        fs::read_to_string(source.join("lib.rs")).unwrap(),
        library(&modules)
    );
    let present: BTreeSet<String> = source
        .read_dir()
        .unwrap()
        .map(|entry| file_name(&entry.unwrap().path()))
        .collect();
    let declared = modules.into_keys().chain(["lib.rs".to_owned()]).collect();
    assert_eq!(present, declared, "nothing else stands in generated/src");
    assert_eq!(
        provider.unused().unwrap(),
        BTreeSet::new(),
        "every export in specs/partials is used"
    );
}

#[test]
fn the_same_specification_gives_the_same_bytes() {
    for path in specifications("specs") {
        let twice = [(); 2].map(|()| generate(&path, &mut provider(&path)));
        assert_eq!(twice[0], twice[1]);
    }
}

/// A value of an emitted law that ends in the number of its block, or a derivative of one, has no name that a specification could give to something else.
#[test]
fn names_of_the_law_are_reserved() {
    for path in specifications("specs") {
        let model = model(&path);
        let programs = lower(&model, &mut provider(&path)).unwrap();
        let definitions = model.definitions.iter().map(|known| known.name.as_str());
        let states = model.blocks.iter().flat_map(|block| &block.states);
        let own: BTreeSet<&str> = definitions
            .chain(states.map(|state| state.name.as_str()))
            .collect();
        for program in [programs.initial, programs.control] {
            let values = program
                .instructions
                .iter()
                .filter(|value| !matches!(value.op, Op::Const(_)));
            for name in values.filter_map(|value| value.name.as_deref()) {
                let quantity = name
                    .rsplit_once("_dot")
                    .map_or(name, |(quantity, _)| quantity);
                let numbered = quantity.ends_with(|c: char| c.is_ascii_digit());
                assert!(
                    !numbered || own.contains(name) || is_of_the_law(name),
                    "{}: `{name}`",
                    model.name
                );
            }
        }
    }
}
