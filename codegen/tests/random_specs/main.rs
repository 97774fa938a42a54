//! Random well-formed specifications are accepted, mean the same in every style of writing, and compile where that needs no derivative that nobody
//! has asked CasADi for.

mod draw;
mod generate;
mod style;

use draw::Draw;
use nsv_codegen::casadi::{Error, Provider, Settings};
use nsv_codegen::derive::error::DeriveError;
use nsv_codegen::driver::compile;
use nsv_codegen::opt::Arithmetic;
use nsv_spec::load_str;
use nsv_spec::model::Model;

const COUNT: u64 = 300;

fn model(text: &str) -> Model {
    let loaded = load_str("random.yaml", text);
    loaded
        .unwrap_or_else(|faults| panic!("{}\n{text}", faults.short()))
        .0
}

/// All of a model but where it was written.
fn meaning(text: &str) -> String {
    let mut model = model(text);
    model.sources = Default::default();
    model.hash.clear();
    let shown = format!("{model:?}");
    let mut parts = shown.split("Span { ");
    let mut all = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        all.push_str(&part[part.find('}').expect("the end of a span")..]);
    }
    all
}

#[test]
fn a_specification_means_the_same_however_it_is_written() {
    for seed in 0..COUNT {
        let tree = generate::specification(&mut Draw(seed));
        let mut styles = Draw(seed ^ 0x5eed);
        let texts: Vec<String> = (0..3).map(|_| style::write(&tree, &mut styles)).collect();
        let first = meaning(&texts[0]);
        for text in &texts[1..] {
            assert!(meaning(text) == first, "{}\n---\n{text}", texts[0]);
        }
    }
}

#[test]
fn every_specification_compiles_or_lacks_an_export_only() {
    let mut compiled = 0;
    for seed in 0..COUNT {
        let text = style::write(&generate::specification(&mut Draw(seed)), &mut Draw(seed));
        let model = model(&text);
        let nowhere = Settings::offline("tests/random_specs/no_exports");
        match compile(
            &model,
            &mut Provider::new(nowhere, |_| {}),
            Arithmetic::Strict,
        ) {
            Ok(found) => {
                assert!(found.files.contains_key("controller.rs"));
                compiled += 1;
            }
            Err(DeriveError::Partials(Error::ExportMissing { .. })) => {}
            Err(error) => panic!("{error}\n{text}"),
        }
    }
    assert!(compiled >= 10, "{compiled} specifications compile");
}
