//! Random well-formed specifications are accepted, mean the same in every style of writing, and compile. CasADi is not asked for their derivatives:
//! the formulas pass for constant, which changes the law but not what it takes to compile it.

mod draw;
mod flat;
mod generate;
mod style;

use draw::Draw;
use flat::Flat;
use nsv_codegen::driver::compile;
use nsv_codegen::opt::Arithmetic;
use nsv_spec::load_str;
use nsv_spec::model::Model;

const COUNT: u64 = 200;
/// Compiling takes long.
const COMPILED: u64 = 60;

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
    without_index(&all)
}

/// An arena's index, whose order is that of a hash table, left out.
fn without_index(shown: &str) -> String {
    let start = shown.find("index: {").expect("an arena");
    let mut depth = 0;
    let end = shown[start..].find(|c: char| {
        depth += i32::from(c == '{') - i32::from(c == '}');
        c == '}' && depth == 0
    });
    format!(
        "{}{}",
        &shown[..start],
        &shown[start + end.expect("its end")..]
    )
}

#[test]
fn a_specification_means_the_same_however_it_is_written() {
    for seed in 0..COUNT {
        let tree = generate::specification(&mut Draw(seed));
        let mut styles = Draw(seed ^ 0x5eed);
        let texts: Vec<String> = (0..3).map(|_| style::write(&tree, &mut styles)).collect();
        let first = meaning(&texts[0]);
        for text in &texts[1..] {
            let other = meaning(text);
            let same = first
                .bytes()
                .zip(other.bytes())
                .take_while(|(a, b)| a == b)
                .count();
            let from = |all: &str| {
                String::from_utf8_lossy(
                    &all.as_bytes()[same.saturating_sub(80)..(same + 40).min(all.len())],
                )
                .into_owned()
            };
            assert!(
                other == first,
                "{}\nis not\n{}\n{}\n---\n{text}",
                from(&first),
                from(&other),
                texts[0]
            );
        }
    }
}

#[test]
fn every_specification_compiles() {
    for seed in 0..COMPILED {
        let text = style::write(&generate::specification(&mut Draw(seed)), &mut Draw(seed));
        let compiled = compile(&model(&text), &mut Flat, Arithmetic::Strict);
        let compiled = compiled.unwrap_or_else(|error| panic!("{error}\n{text}"));
        assert!(compiled.files.contains_key("controller.rs"), "{text}");
        compiled.eval.assert_sound();
    }
}
