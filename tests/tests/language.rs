//! What an author may change without Python, what needs new partial derivatives, and the choices of the language in closed loop.

use std::collections::BTreeSet;
use std::fs;

use nsv_codegen::casadi::{self, Environment, Provider};
use nsv_codegen::derive::error::DeriveError;
use nsv_codegen::ir::Op;
use nsv_codegen::lower::Programs;
use nsv_codegen::opt::optimise;
use nsv_spec::model::Model;
use nsv_tests::interpreted::run;
use nsv_tests::specification::{
    compiled, model, named, programs, provider, repository, specifications,
};

/// The flagship after replacements, each of a text that stands once in its files, with the committed exports.
fn edited(edits: &[(&str, &str)]) -> Result<(Model, Programs), DeriveError> {
    let folder = tempfile::tempdir().unwrap();
    let files = [
        "nsv_attitude.yaml",
        "models/ghv_attitude.yaml",
        "models/ghv_aerodynamics.yaml",
    ];
    let mut texts = files.map(|file| fs::read_to_string(repository("specs").join(file)).unwrap());
    for (old, new) in edits {
        let found: usize = texts.iter().map(|text| text.matches(old).count()).sum();
        assert_eq!(found, 1, "`{old}` stands once");
        texts = texts.map(|text| text.replace(old, new));
    }
    fs::create_dir(folder.path().join("models")).unwrap();
    for (file, text) in files.iter().zip(texts) {
        fs::write(folder.path().join(file), text).unwrap();
    }
    let model = model(&folder.path().join(files[0]));
    let mut provider = Provider::new(Environment::offline(repository("specs/partials")), |_| {});
    let programs = programs(&model, &mut provider)?;
    Ok((model, programs))
}

/// The edit needs nothing new, and the loop still tracks for a second.
fn check_edit(edits: &[(&str, &str)]) -> (Model, Programs) {
    let short = ("horizon: 20 s", "horizon: 1 s");
    let settled = ("settle: 4.5 s", "settle: 0.5 s");
    let all: Vec<(&str, &str)> = edits.iter().copied().chain([short, settled]).collect();
    let (model, programs) = edited(&all).unwrap_or_else(|error| panic!("{edits:?}: {error}"));
    let run = run(&model, &programs, None);
    assert!(run.finite && run.ratio < 1.0, "{edits:?}: {run:?}");
    (model, programs)
}

#[test]
fn numbers_need_no_new_derivatives() {
    check_edit(&[]);
    check_edit(&[("K: 1.5\n", "K: 1.75\n")]);
    check_edit(&[
        ("C: 20 ", "C: [20, 25, 30] "),
        ("filter: 0.1 s ", "filter: [0.1 s, 0.08 s, 0.12 s] "),
    ]);
    check_edit(&[("x_cg: {value: 0, ", "x_cg: {value: 0.1, ")]);
    check_edit(&[
        ("sample_time: 2 ms", "sample_time: 1 ms"),
        ("{M_x: 2000 kN*m", "{M_x: 2500 kN*m"),
    ]);
    check_edit(&[(
        "constraint: (3*exp(-t/(1 s)) + 0.5)*1 deg",
        "constraint: (4*exp(-t/(1 s)) + 0.7)*1 deg",
    )]);
}

#[test]
fn a_network_of_another_order_needs_no_new_derivatives() {
    let (_, smaller) = check_edit(&[]);
    let edit = (
        "network: {order: 3, inputs: [alpha, beta, mu]",
        "network: {order: 4, inputs: [alpha, beta, mu]",
    );
    let (_, larger) = check_edit(&[edit]);
    let (_, complete) = check_edit(&[(
        "inputs: [alpha, beta, mu]",
        "basis: complete, inputs: [alpha, beta, mu]",
    )]);
    let nodes = |programs: &Programs| programs.control.bases[0].exponents.len();
    // Pairwise: 1 + 3 m + 3 m (m - 1)/2 nodes; complete: all 20 monomials up to the third degree.
    assert_eq!(
        [nodes(&smaller), nodes(&larger), nodes(&complete)],
        [19, 31, 20]
    );
}

/// Without Python, a formula that nobody differentiated before is an error that names it.
#[test]
fn a_new_formula_needs_its_derivatives() {
    let error = edited(&[(
        "0.02 rad/s * sin(t/(1 s))*exp(-0.1*t/(1 s))",
        "0.02 rad/s * sin(t/(1 s))*tanh(t/(1 s))",
    )])
    .unwrap_err();
    let DeriveError::Partials(error) = error else {
        panic!("{error}")
    };
    assert!(
        matches!(error, casadi::Error::ExportMissing { .. }),
        "{error}"
    );
    assert!(error.to_string().contains("are not stored"), "{error}");
}

/// Model and programs of `lookup` after replacements in the specification and in its data file, with the committed exports.
fn looked_up(edits: &[(&str, &str)]) -> Result<(Model, Programs), DeriveError> {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("data")).unwrap();
    let files = ["lookup.yaml", "data/lookup.csv"];
    let read = |file: &str| fs::read_to_string(repository("tests/specs").join(file)).unwrap();
    let mut texts = files.map(read);
    for (old, new) in edits {
        let found: usize = texts.iter().map(|text| text.matches(old).count()).sum();
        assert_eq!(found, 1, "`{old}` stands once");
        texts = texts.map(|text| text.replace(old, new));
    }
    for (file, text) in files.iter().zip(texts) {
        fs::write(folder.path().join(file), text).unwrap();
    }
    let model = model(&folder.path().join(files[0]));
    let exports = repository("tests/specs/partials");
    let programs = programs(
        &model,
        &mut Provider::new(Environment::offline(exports), |_| {}),
    )?;
    Ok((model, programs))
}

#[test]
fn numbers_of_tables_need_no_new_derivatives() {
    let edits: [&[(&str, &str)]; 5] = [
        &[("0.3,0.4,-0.1,0.35", "0.3,0.4,-0.2,0.35")],
        &[(
            "[-150, -70, -20, 0, 35, 80, 150]",
            "[-150, -70, -25, 0, 35, 80, 150]",
        )],
        &[(
            "[-2.1, -1.4, -0.3, 0, 0.5, 1.2, 1.9]\n    interpolation: cubic",
            "[-2.1, -1.4, -0.3, 0, 0.5, 1.2, 1.9]\n    interpolation: linear",
        )],
        &[("limit*tanh(value/limit)", "limit*tanh(value/limit) ")],
        &[("[[[0.1, 0.4, 0.2]", "[[[0.1, 0.5, 0.2]")],
    ];
    let (original, _) = looked_up(&[]).unwrap();
    for edit in edits {
        let (model, programs) = looked_up(edit).unwrap_or_else(|error| panic!("{edit:?}: {error}"));
        assert_ne!(model.hash, original.hash);
        let run = run(&model, &programs, None);
        assert!(run.finite, "{edit:?}: {run:?}");
    }
}

#[test]
fn a_run_that_leaves_a_table_without_extrapolation_is_not_finite() {
    let (model, programs) = looked_up(&[("q: [-1, 1]", "q: [-0.01, 0.01]")]).unwrap();
    assert!(!run(&model, &programs, None).finite);
}

/// What a chain is made with.
#[derive(Clone, Copy, Debug)]
struct Chain {
    blocks: usize,
    /// A line of `controller` besides the sample time.
    choice: &'static str,
    constrained: bool,
    disturbed: bool,
    noisy: bool,
}

const CHAIN: Chain = Chain {
    blocks: 2,
    choice: "norm: frobenius",
    constrained: true,
    disturbed: true,
    noisy: false,
};

/// x1' = x2, x2' = -sin x1 - 0.2 x2 + x3, x3' = -0.5 x3 + x4, x4' = -0.5 x4 + u, ended by u after some blocks, each disturbed by a sine,
/// the last one shaken by a Wiener process.
fn text(chain: Chain) -> String {
    let Chain {
        blocks,
        choice,
        constrained,
        disturbed,
        noisy,
    } = chain;
    let drifts = ["0*q1", "-sin(q1) - 0.2*q2", "-0.5*q3", "-0.5*q4"];
    let (mut plant, mut controller) = (String::new(), String::new());
    for (i, drift) in (1..=blocks).zip(drifts) {
        plant += &format!(
            "    b{i}:\n      states: {{q{i}: 0}}\n      drift: [\"({drift})/(1 s)\"]\n      gain: [[\"1/(1 s)\"]]\n"
        );
        controller += &format!("    b{i}:\n      K: 1.5\n      kbar: 0.5\n      C: 20\n");
        if disturbed {
            plant += &format!("      disturbance: {{bounded: [\"0.1*sin({i}*t/(1 s))/(1 s)\"]}}\n");
            controller += "      eta_1: 0.1\n      observer: 10\n";
        }
        if noisy && i == blocks {
            plant += "      noise: {effectiveness: [[\"0.05*sqrt(1 s)/(1 s)\"]], intensity: [1]}\n";
            controller += "      eta_noise: 0.1\n      noise_bound: {tau: 1, lambda: 0.1, varsigma: 1, phi: {initial: 10, kappa: 2, \
                           threshold: 0.01, min: auto}}\n";
        }
        if i < blocks {
            controller += "      eta_2: 0.1\n      eta_3: 2\n";
        }
        if i < blocks && !choice.contains("exact") {
            controller += "      filter: 0.02 s\n";
        }
        if i == 1 && constrained {
            controller += "      constraint: 2*exp(-t/(1 s)) + 0.5\n";
        }
    }
    let (scheme, noise) = if noisy {
        ("euler_maruyama", "wiener")
    } else {
        ("rk4", "sampled")
    };
    format!(
        "nsv: 1\nname: chain\ntitle: Scalar chain\nplant:\n  blocks:\n{plant}  inputs: {{push: 1000}}\n\
         reference: {{q1: sin(t/(1 s))*(1 - exp(-(t/(1 s))^3))}}\ncontroller:\n  sample_time: 2 ms\n  {choice}\n  blocks:\n{controller}\
         scenario: {{horizon: 6 s, substeps: 1, scheme: {scheme}, noise: {noise}, seed: 1, runs: 1, settle: 3 s}}\n"
    )
}

/// The model of a chain.
fn modelled(chain: Chain) -> Model {
    let text = text(chain);
    let (model, _) = nsv_spec::load_str("chain.yaml", &text)
        .unwrap_or_else(|faults| panic!("{:?}\n{text}", faults.items));
    model
}

/// Simulates a chain with the exports in `tests/specs/partials`: a sine is tracked inside the constraint. Gives its rms error.
fn fly(chain: Chain) -> f64 {
    let (model, mut exports) = (
        modelled(chain),
        provider(&repository("tests/specs/chain.yaml")),
    );
    let programs =
        programs(&model, &mut exports).unwrap_or_else(|error| panic!("{chain:?}: {error}"));
    let run = run(&model, &programs, chain.noisy.then_some(1));
    assert!(run.finite && run.ratio < 0.3, "{chain:?}: {run:?}");
    run.rms
}

/// Chains that track to 0.013, of all lengths and with each choice of the controller.
fn filtered() -> Vec<Chain> {
    let lengths = (1..=4).flat_map(|blocks| {
        [
            Chain { blocks, ..CHAIN },
            Chain {
                blocks,
                noisy: true,
                ..CHAIN
            },
        ]
    });
    let choices = [
        "norm: spectral",
        "integration: euler",
        "barrier_margin: 0.01",
    ]
    .map(|choice| Chain { choice, ..CHAIN });
    lengths
        .chain(choices)
        .chain([Chain {
            constrained: false,
            blocks: 3,
            ..CHAIN
        }])
        .collect()
}

/// Chains without disturbances, which no derivative along known dynamics knows: with filters, and with exact derivatives.
fn calm() -> Vec<(Chain, Chain)> {
    let chains = (2..=4).map(|blocks| Chain {
        blocks,
        disturbed: false,
        ..CHAIN
    });
    chains
        .map(|chain| {
            (
                chain,
                Chain {
                    choice: "virtual_derivative: exact",
                    ..chain
                },
            )
        })
        .collect()
}

/// A chain that is disturbed nevertheless.
const EXACT: Chain = Chain {
    choice: "virtual_derivative: exact",
    ..CHAIN
};

#[test]
fn chains_of_any_length_track() {
    for chain in filtered() {
        let rms = fly(chain);
        assert!(rms < 0.013, "{chain:?}: {rms}");
    }
}

#[test]
fn exact_derivatives_track_better_than_filters() {
    for (filtered, exact) in calm() {
        let (filtered, exact, blocks) = (fly(filtered), fly(exact), exact.blocks);
        assert!(
            exact < 1e-3 && exact < 0.1 * filtered,
            "{blocks} blocks: {exact} exact, {filtered} filtered"
        );
    }
    assert!(fly(EXACT) < 0.03);
}

/// The law of a chain of links multiplies by the mass matrix where it inverts the gain, and factorises it once.
#[test]
fn a_mass_matrix_is_inverted_by_none_and_factorised_once() {
    let (model, programs) = compiled(&named("link_chain"));
    let run = run(&model, &programs, None);
    let degrees = run.rms.to_degrees();
    assert!(run.finite && degrees < 0.2, "{run:?}");
    let law = optimise(programs.control.clone());
    let count = |of: fn(&Op) -> bool| law.instructions.iter().filter(|one| of(&one.op)).count();
    assert_eq!(count(|op| matches!(op, Op::Ldlt(_))), 1, "{law}");
    // G_2 as a whole for its norm, and F_2 of the observer.
    assert_eq!(count(|op| matches!(op, Op::Solve(..))), 2, "{law}");
}

#[test]
fn every_export_of_the_tests_is_used() {
    let mut exports = provider(&repository("tests/specs/chain.yaml"));
    let files = specifications("tests/specs")
        .into_iter()
        .map(|path| model(&path));
    let chains = filtered()
        .into_iter()
        .chain(
            calm()
                .into_iter()
                .flat_map(|(filtered, exact)| [filtered, exact]),
        )
        .chain([EXACT]);
    for model in files.chain(chains.map(modelled)) {
        programs(&model, &mut exports).unwrap_or_else(|error| panic!("{}: {error}", model.name));
    }
    assert_eq!(exports.unused().unwrap(), BTreeSet::new());
}
