//! One slip in the structure of a good specification is one fault: what follows from it is not reported, and faults elsewhere are.

use std::fs;
use std::ops::Range;
use std::path::Path;
use std::thread;

use nsv_spec::diagnostic::{FileId, Rule, Span};
use nsv_spec::load;
use nsv_spec::yaml::{self, Kind, Node};

/// Maps whose keys the user chooses.
const NAMED: [&str; 13] = [
    "axes",
    "blocks",
    "constants",
    "definitions",
    "functions",
    "inputs",
    "parameters",
    "parts",
    "polynomials",
    "rates",
    "reference",
    "states",
    "tables",
];
/// A change of the text.
struct Slip {
    path: String,
    place: Range<usize>,
    replacement: &'static str,
}

/// Every vocabulary key under another name, and every value of another kind.
fn slips(node: &Node, text: &str, path: &str, all: &mut Vec<Slip>) {
    let named = path
        .rsplit('.')
        .next()
        .is_some_and(|key| NAMED.contains(&key));
    match &node.kind {
        Kind::Map(entries) => {
            for entry in entries {
                let path = format!("{path}.{}", entry.key.text);
                if !named {
                    all.push(Slip {
                        path: format!("{path} renamed"),
                        place: range(entry.key.span),
                        replacement: "something_else",
                    });
                }
                let place = range(entry.value.span);
                // The span of a text in quotes is that of its content.
                let plain = !text[..place.start].ends_with(['"', '\'']);
                let replacement = match &entry.value.kind {
                    Kind::Map(_) => "3",
                    _ => "{something: else}",
                };
                if plain && !path.ends_with("sweep") {
                    all.push(Slip {
                        path: format!("{path} is {replacement}"),
                        place,
                        replacement,
                    });
                }
                slips(&entry.value, text, &path, all);
            }
        }
        Kind::Seq(items) => (items.iter()).for_each(|item| slips(item, text, path, all)),
        _ => {}
    }
}

fn range(span: Span) -> Range<usize> {
    span.start as usize..span.end as usize
}

fn with(text: &str, place: &Range<usize>, replacement: &str) -> String {
    format!(
        "{}{replacement}{}",
        &text[..place.start],
        &text[place.end..]
    )
}

/// The text with two more faults, which have nothing to do with any slip in what it has already.
fn with_others(text: &str) -> String {
    let others = "definitions:\n  wrong_unit: 1 m + 1 s\n  wrong_name: nothing_has_this_name\n";
    let key = text.find("\ndefinitions:").map(|at| at + 1);
    let line = key.and_then(|key| Some(key..key + text[key..].find('\n')? + 1));
    match line {
        Some(line) => with(text, &line, others),
        None => format!("{text}{others}"),
    }
}

/// Whether a rule is about keys, kinds of values and what is given twice.
fn structural(rule: Rule, slip: &Slip) -> bool {
    use Rule::{E0025, E0101, E0103, E0104, E0106, E0107, E0118};
    match rule {
        E0025 | E0101 | E0103 | E0104 | E0106 | E0107 => true,
        // A gain under an unknown key is missing.
        E0118 => slip.path.starts_with(".controller.blocks.") && slip.path.ends_with(" renamed"),
        _ => false,
    }
}

/// Every rule of a faulty specification that should not be among those of a slip, or that should and is not.
fn surprise(slip: &Slip, rules: &[Rule]) -> bool {
    let slips = rules.iter().filter(|rule| structural(**rule, slip)).count();
    let (units, names) = (Rule::E0403, Rule::E0301);
    let others = (rules.contains(&units), rules.contains(&names));
    let known = usize::from(others.0) + usize::from(others.1);
    if slips == 0 {
        return false;
    }
    // Names may be declared in what could not be read, anything in what holds the definitions.
    let declares = !(slip.path.starts_with(".controller.") || slip.path.starts_with(".scenario."));
    let holds = slip.path.starts_with(".definitions ");
    slips + known < rules.len() || !(others.0 || holds) || !(others.1 || declares)
}

#[test]
fn what_follows_from_a_slip_is_not_reported_and_what_does_not_is() {
    let directory = tempfile::tempdir().expect("a folder");
    for folder in ["", "data", "models"] {
        let to = directory.path().join(folder);
        fs::create_dir_all(&to).expect("a folder");
        for entry in fs::read_dir(Path::new("../specs").join(folder)).expect("a folder") {
            let from = entry.expect("a directory entry").path();
            if from.is_file() {
                fs::copy(&from, to.join(from.file_name().expect("a name"))).expect("a copy");
            }
        }
    }
    let names = [
        "underwater_vehicle",
        "missile_pitch",
        "ghv_unstable",
        "nsv_six_dof",
    ];
    let folder = directory.path();
    let found: Vec<(usize, String)> = thread::scope(|scope| {
        let threads = names.map(|name| scope.spawn(move || slips_of(folder, name)));
        (threads.into_iter())
            .map(|thread| thread.join().expect("no panic"))
            .collect()
    });
    let tried: usize = found.iter().map(|(tried, _)| tried).sum();
    let surprises: String = found.into_iter().map(|(_, surprises)| surprises).collect();
    assert!(tried > 700, "{tried} slips");
    assert!(surprises.is_empty(), "{surprises}");
}

/// How many slips of a specification were tried, and what was said of them that should not be, or was not.
fn slips_of(folder: &Path, name: &str) -> (usize, String) {
    let text = fs::read_to_string(format!("../specs/{name}.yaml")).expect("a specification");
    let tree = yaml::read(&text, FileId(0)).expect("YAML");
    let mut all = Vec::new();
    slips(&tree, &text, "", &mut all);
    let path = folder.join(format!("slip_{name}.yaml"));
    let mut surprises = String::new();
    for slip in &all {
        let slipped = with(&text, &slip.place, slip.replacement);
        fs::write(&path, with_others(&slipped)).expect("a file");
        let faults = load(&path).expect_err("two faults at least");
        let rules: Vec<Rule> = faults.items.iter().map(|item| item.rule).collect();
        if surprise(slip, &rules) {
            surprises.push_str(&format!("{name}{}:\n{}\n", slip.path, faults.short()));
        }
    }
    (all.len(), surprises)
}
