//! All files of one specification's module.

use std::collections::BTreeMap;

use nsv_spec::model::Model;
use proc_macro2::TokenStream;
use quote::quote;

use crate::emit::comment::{Comments, clean, code, docs, prose};
use crate::emit::controller::{Controller, NEXT};
use crate::emit::function::{Function, Record, Results};
use crate::emit::interface::Interface;
use crate::emit::names::{Fields, ident, snake};
use crate::emit::pieces::Split;
use crate::emit::plant::Plant;
use crate::emit::polynomial::Library;
use crate::emit::simulator::Simulator;
use crate::emit::source::Source;
use crate::emit::state::state_fields;
use crate::emit::{lyapunov, params};
use crate::ir::Program;
use crate::opt::{Arithmetic, cost};

/// Everything that a module is emitted from.
#[derive(Clone, Debug)]
pub struct Artifact<'a> {
    /// The specification, checked.
    pub model: &'a Model,
    /// Version of the generator.
    pub version: &'a str,
    /// What the optimiser was allowed to change.
    pub arithmetic: Arithmetic,
    /// Initial states of the controller.
    pub initial: Program,
    /// One sample of the law.
    pub control: Program,
    /// Drift and diffusion of the plant.
    pub plant: Program,
    /// Lyapunov function and its generator.
    pub lyapunov: Program,
}

/// The texts of a module's files, by file name.
pub fn module(artifact: &Artifact<'_>) -> BTreeMap<String, String> {
    let programs = Programs {
        initial: &artifact.initial,
        control: &artifact.control,
        plant: &artifact.plant,
        lyapunov: &artifact.lyapunov,
    };
    files(
        &Interface::of(artifact.model, artifact.version, artifact.arithmetic),
        &programs,
    )
}

/// The text of the library that has the given modules: name and title of each.
pub fn library(modules: &[(&str, &str)]) -> String {
    let items = modules.iter().map(|(name, title)| {
        let (name, docs) = (ident(&snake(name)), docs(&[prose(title)]));
        quote!(#docs #[rustfmt::skip] pub mod #name;)
    });
    let source = Source {
        header: &[],
        docs: &[
            "Committed output of the nsv compiler, one module per specification under `specs/`."
                .to_owned(),
        ],
        allow: &[],
        imports: &[],
        items: items.collect(),
    };
    let text = source.text(&Comments::default());
    text.replacen("\n\n", "\n#![no_std]\n#![forbid(unsafe_code)]\n\n", 1)
}

/// The programs of an artifact.
pub(crate) struct Programs<'a> {
    pub(crate) initial: &'a Program,
    pub(crate) control: &'a Program,
    pub(crate) plant: &'a Program,
    pub(crate) lyapunov: &'a Program,
}

/// Lints that the emitted files allow.
pub(crate) const ALLOW: [(&str, &str); 4] = [
    ("non_snake_case", "names are those of the equations"),
    ("clippy::too_many_arguments", "as in the equations"),
    ("clippy::approx_constant", "numbers are as specified"),
    ("clippy::eq_op", "x - x is not 0 for every x"),
];

/// What a function of a program may mention.
pub(crate) const FUNCTION_IMPORTS: [&str; 12] = [
    "core::f64::consts::FRAC_1_PI",
    "core::f64::consts::FRAC_PI_2",
    "core::f64::consts::FRAC_PI_4",
    "core::f64::consts::PI",
    "core::f64::consts::TAU",
    "nsv_runtime::kernel",
    "nsv_runtime::linear::Ldlt",
    "nsv_runtime::linear::Matrix",
    "nsv_runtime::linear::Vector",
    "nsv_runtime::real::Mask",
    "nsv_runtime::real::Part",
    "nsv_runtime::real::Real",
];

/// What the files may mention besides.
const IMPORTS: [(&str, &[&str]); 7] = [
    ("params", &["nsv_runtime::noise::Noise"]),
    (
        "polynomials",
        &[
            "nsv_runtime::polynomial::horner",
            "nsv_runtime::polynomial::horner_fused",
        ],
    ),
    (
        "tables",
        &["nsv_runtime::table::Axis", "nsv_runtime::table::Table"],
    ),
    (
        "controller",
        &[
            "nsv_runtime::ahead::OfTime",
            "nsv_runtime::status::Status",
            "super::params::Params",
            "super::polynomials",
            "super::tables",
        ],
    ),
    (
        "plant",
        &[
            "nsv_runtime::ahead::OfTime",
            "nsv_runtime::noise::Noise",
            "nsv_runtime::sde::Sde",
            "super::params::Params",
            "super::polynomials",
            "super::tables",
        ],
    ),
    (
        "lyapunov",
        &[
            "super::controller::State",
            "super::params::Params",
            "super::polynomials",
            "super::tables",
        ],
    ),
    (
        "simulator",
        &[
            "nsv_runtime::actuator::Actuator",
            "nsv_runtime::actuator::Delay",
            "nsv_runtime::ahead::Ahead",
            "nsv_runtime::ahead::Stages",
            "nsv_runtime::actuator::Effect",
            "nsv_runtime::actuator::Fault",
            "nsv_runtime::closed_loop::ClosedLoop",
            "nsv_runtime::closed_loop::Options",
            "nsv_runtime::closed_loop::Runs",
            "nsv_runtime::noise::Noise",
            "nsv_runtime::sde",
            "nsv_runtime::sde::Scheme",
            "nsv_runtime::sensor::Draws",
            "nsv_runtime::sensor::Sensor",
            "super::controller",
            "super::controller::Controller",
            "super::controller::Output",
            "super::controller::SAMPLE_TIME",
            "super::controller::State",
            "super::lyapunov",
            "super::params::Params",
            "super::plant::INITIAL_STATE",
            "super::plant::NOISE_CHANNELS",
            "super::plant::Plant",
            "super::plant::STATES",
            "super::plant",
        ],
    ),
];

/// The texts of the files.
pub(crate) fn files(interface: &Interface, programs: &Programs<'_>) -> BTreeMap<String, String> {
    let library = Library::of(&[
        programs.control,
        programs.plant,
        programs.initial,
        programs.lyapunov,
    ]);
    let fields = params::fields(interface);
    let states = state_fields(programs.initial);
    let mut texts = Texts {
        interface,
        files: BTreeMap::new(),
    };
    texts.add(
        "params",
        "run-time parameters",
        &[],
        params::items(interface, &fields),
        &Comments::default(),
    );
    if !library.is_empty() {
        let about = "polynomial data and monomials of the networks";
        texts.add(
            "polynomials",
            about,
            &[],
            library.items(&interface.sources),
            &Comments::default(),
        );
    }
    if !library.tables.is_empty() {
        texts.add(
            "tables",
            "lookup tables",
            &[],
            library.tables.items(&interface.sources),
            &Comments::default(),
        );
    }
    let mut comments = Comments::default();
    let controller = Controller {
        interface,
        initial: programs.initial,
        control: programs.control,
        params: &fields,
        tables: &library,
    };
    let items = controller.items(&mut comments);
    texts.add(
        "controller",
        "control law and sampled controller",
        &[programs.initial, programs.control],
        items,
        &comments,
    );
    let mut comments = Comments::default();
    let items = Plant {
        interface,
        plant: programs.plant,
        params: &fields,
        tables: &library,
    }
    .items(&mut comments);
    texts.add(
        "plant",
        "plant and disturbances",
        &[programs.plant],
        items,
        &comments,
    );
    let mut comments = Comments::default();
    let items = lyapunov::items(programs.lyapunov, &fields, &states, &library, &mut comments);
    texts.add(
        "lyapunov",
        "Lyapunov function and its generator",
        &[programs.lyapunov],
        items,
        &comments,
    );
    let items = simulator(interface, programs, &fields, &states, &library);
    texts.add(
        "simulator",
        "closed loop of controller and plant",
        &[],
        items,
        &Comments::default(),
    );
    texts.add_root();
    texts.files
}

fn simulator(
    interface: &Interface,
    programs: &Programs<'_>,
    params: &Fields,
    states: &Fields,
    library: &Library,
) -> Vec<TokenStream> {
    let plant_records = [Record {
        prefix: "params",
        ty: "Params",
        fields: params,
    }];
    let control_records = [
        Record {
            prefix: "params",
            ty: "Params",
            fields: params,
        },
        Record {
            prefix: "state",
            ty: "State",
            fields: states,
        },
    ];
    let lyapunov_records = lyapunov::records(params, states);
    let function = |program, records| Function {
        program,
        docs: &[],
        records,
        results: Results::Own,
        tables: library,
        updates: Some(NEXT),
    };
    let (plant, control) = (
        function(programs.plant, &plant_records),
        function(programs.control, &control_records),
    );
    Simulator {
        interface,
        dynamics: &Split::dynamics(&plant),
        law: &Split::law(&control),
        plant: &plant,
        lyapunov: &function(programs.lyapunov, &lyapunov_records),
        initial: programs.initial,
        control: &control,
    }
    .items()
}

struct Texts<'a> {
    interface: &'a Interface,
    files: BTreeMap<String, String>,
}

impl Texts<'_> {
    /// Comments at the top of a file. The specification's hash is in `mod.rs` alone, so that a change of the specification changes
    /// those files only that depend on it.
    fn header(&self, programs: &[&Program]) -> Vec<String> {
        let mut header = vec![format!(
            "nsv {}: change the specification and run `nsv generate`, do not edit.",
            clean(&self.interface.version)
        )];
        if self.interface.arithmetic == Arithmetic::Fast {
            header.push(
                "math fast: sums and products are reassociated, results differ from `--math strict` by roundings"
                    .to_owned(),
            );
        }
        header.extend(
            programs
                .iter()
                .map(|program| format!("{}: {}", clean(&program.name), cost::count(program))),
        );
        header
    }

    fn add(
        &mut self,
        name: &str,
        about: &str,
        programs: &[&Program],
        items: Vec<TokenStream>,
        comments: &Comments,
    ) {
        let docs = [format!("{}: {about}.", code(&self.interface.name))];
        let header = self.header(programs);
        let own = IMPORTS
            .iter()
            .find(|(file, _)| *file == name)
            .map_or::<&[&str], _>(&[], |(_, imports)| imports);
        let imports: Vec<&str> = FUNCTION_IMPORTS.iter().chain(own).copied().collect();
        let source = Source {
            header: &header,
            docs: &docs,
            allow: &ALLOW,
            imports: &imports,
            items,
        };
        self.files
            .insert(format!("{name}.rs"), source.text(comments));
    }

    fn add_root(&mut self) {
        let modules = self.files.keys().map(|file| {
            let name = ident(file.trim_end_matches(".rs"));
            quote!(pub mod #name;)
        });
        let modules: Vec<TokenStream> = modules.collect();
        let (hash, version) = (clean(&self.interface.hash), clean(&self.interface.version));
        let (hash_docs, version_docs) = (
            docs(&["SHA-256 of the specification."]),
            docs(&["Version of the generator."]),
        );
        let items = vec![
            quote!(#(#modules)*),
            quote!(
                pub use controller::{Controller, Output, State};
                pub use params::Params;
                pub use simulator::Simulator;
            ),
            quote!(#hash_docs pub const SPEC_HASH: &str = #hash;),
            quote!(#version_docs pub const GENERATOR: &str = #version;),
        ];
        let docs = [prose(&self.interface.title)];
        let header = self.header(&[]);
        let source = Source {
            header: &header,
            docs: &docs,
            allow: &[],
            imports: &[],
            items,
        };
        self.files
            .insert("mod.rs".to_owned(), source.text(&Comments::default()));
    }
}
