//! Guarantees that every declared name is a usable identifier, means one thing, and collides with nothing in the emitted code.

use std::collections::BTreeMap;

use super::Context;
use crate::diagnostic::{Applicability, Diagnostic, Rule, Span, a};
use crate::expr::{CONSTANTS, entries, is_reserved};
use crate::spec::{Named, Word};
use crate::yaml::excerpt;

/// Longest name.
pub(super) const MAX_LENGTH: usize = 64;

/// Words that are no identifiers in Rust, or that cannot be bound by `let`.
pub const RUST_WORDS: [&str; 56] = [
    "as", "break", "const", "continue", "crate", "else", "enum", "extern", "false", "fn", "for",
    "if", "impl", "in", "let", "loop", "match", "mod", "move", "mut", "pub", "ref", "return",
    "self", "Self", "static", "struct", "super", "trait", "true", "type", "unsafe", "use", "where",
    "while", "async", "await", "dyn", "abstract", "become", "box", "do", "final", "macro",
    "override", "priv", "typeof", "unsized", "virtual", "yield", "try", "gen", "None", "Some",
    "Ok", "Err",
];

/// Names of the emitted functions' own values and arguments.
const EMITTED: [&str; 9] = [
    "y_r", "u", "u_sat", "V", "LV", "state", "params", "plant", "next",
];

/// Quantities of the law that are numbered by block, such as `x1` and `k2_dot`. Those that are numbers of the specification, as `M1` of
/// an exosystem, are not values of the emitted code.
const NUMBERED: [&str; 42] = [
    "x",
    "th",
    "h",
    "zeta",
    "W",
    "eps",
    "sigma",
    "phi",
    "w",
    "e",
    "s",
    "k",
    "E",
    "c",
    "z",
    "Lam",
    "Lam0_",
    "P",
    "A_hat",
    "D_hat",
    "w_hat",
    "alpha",
    "bracket",
    "Ybar_norm",
    "Ybar_square",
    "Psi",
    "F",
    "G",
    "H",
    "SH",
    "HSigma",
    "G_norm2_",
    "H_norm2_",
    "SH_norm2_",
    "d",
    "t",
    "ratio",
    "violated",
    "cosE",
    "sec2E",
    "s_c",
    "s_scale",
];

/// Module names that clash with the surroundings of the emitted code.
const MODULES: [&str; 8] = [
    "core",
    "std",
    "alloc",
    "test",
    "lib",
    "main",
    "nsv_runtime",
    "nsv",
];

/// What a name is used for, which decides what it may collide with.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Use {
    /// A constant, which is written by value, or a label: it meets no emitted name.
    Label,
    /// Becomes a name in the emitted code.
    Emitted,
}

impl Context<'_> {
    /// Checks every declared name. Names declared twice get no meaning.
    pub(super) fn check_names(&mut self) {
        let spec = self.spec;
        spec.name
            .iter()
            .for_each(|name| self.check_module_name(name));
        let mut declared: BTreeMap<String, (Span, &str)> = BTreeMap::new();
        self.declare(
            &mut declared,
            words(&spec.constants),
            "constant",
            Use::Label,
        );
        self.declare(
            &mut declared,
            words(&spec.parameters),
            "parameter",
            Use::Emitted,
        );
        for block in &spec.blocks {
            self.declare(
                &mut declared,
                words(&block.value.states),
                "state",
                Use::Emitted,
            );
        }
        if let Some(truth) = &spec.truth {
            self.declare(
                &mut declared,
                words(&truth.value.states),
                "state",
                Use::Emitted,
            );
            self.declare(&mut declared, words(&spec.inputs), "input", Use::Emitted);
        }
        self.declare(
            &mut declared,
            words(&spec.definitions),
            "definition",
            Use::Emitted,
        );
        self.declare(
            &mut declared,
            words(&spec.functions),
            "function",
            Use::Label,
        );
        self.declare(&mut declared, words(&spec.tables), "table", Use::Label);
        for table in &spec.tables {
            self.declare(
                &mut BTreeMap::new(),
                words(&table.value.axes),
                "axis",
                Use::Label,
            );
        }
        self.check_arguments(&declared);
        self.check_polynomial_names(&declared);
        self.declare(
            &mut BTreeMap::new(),
            words(&spec.blocks),
            "block",
            Use::Emitted,
        );
        if spec.truth.is_none() {
            self.declare(
                &mut BTreeMap::new(),
                words(&spec.inputs),
                "input",
                Use::Label,
            );
        }
    }

    fn check_module_name(&mut self, name: &Word) {
        if !self.check_identifier(name, "name", Use::Label) {
            return;
        }
        if name.value.chars().any(|c| c.is_ascii_uppercase()) {
            let message = format!(
                "name `{}` has capital letters, expected snake case",
                name.value
            );
            let lower = name.value.to_ascii_lowercase();
            let fault = Diagnostic::error(Rule::E0110, name.span, message)
                .with_help(format!("write `{lower}`"));
            self.faults
                .push(fault.with_suggestion(name.span, lower, Applicability::Certain));
        } else if MODULES.contains(&name.value.as_str()) {
            let message = format!("name `{}` clashes with a Rust crate or module", name.value);
            self.fault(
                Rule::E0111,
                name.span,
                message,
                format!("write `{}_plant`", name.value),
            );
        }
    }

    /// Checks the names of one kind and adds them to `declared`.
    pub(super) fn declare<'a>(
        &mut self,
        declared: &mut BTreeMap<String, (Span, &'a str)>,
        names: impl Iterator<Item = &'a Word>,
        noun: &'static str,
        usage: Use,
    ) {
        for name in names {
            self.check_identifier(name, noun, usage);
            if let Some((first, earlier)) = declared.get(&name.value) {
                let fault = Diagnostic::error(
                    Rule::E0113,
                    name.span,
                    format!("{noun} `{}` has the name of {}", name.value, a(earlier)),
                )
                .with_related(*first, format!("the {earlier} is declared here"))
                .with_help("give one of them another name");
                self.faults.push(fault);
                self.names.refuse(&name.value);
                continue;
            }
            declared.insert(name.value.clone(), (name.span, noun));
            if matches!(
                noun,
                "constant" | "parameter" | "state" | "definition" | "input"
            ) {
                self.names.declare(&name.value, name.span, noun);
            }
        }
    }

    /// Reports the first reason why a name cannot be used.
    fn check_identifier(&mut self, name: &Word, noun: &str, usage: Use) -> bool {
        let text = name.value.as_str();
        let shown = excerpt(text);
        let identifier = text.starts_with(|c: char| c.is_ascii_alphabetic())
            && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
            && text.len() <= MAX_LENGTH;
        if !identifier {
            let help = format!(
                "a name is a letter followed by letters, digits and `_`, at most {MAX_LENGTH} in all"
            );
            self.fault(
                Rule::E0110,
                name.span,
                format!("{noun} `{shown}` is not an identifier"),
                help,
            );
        } else if RUST_WORDS.contains(&text) {
            let message =
                format!("{noun} `{shown}` is a word of Rust, in which the code is emitted");
            self.fault(
                Rule::E0111,
                name.span,
                message,
                format!("write `{shown}_`, or better a longer name"),
            );
        } else if is_reserved(text) {
            let (what, help) = match CONSTANTS.iter().find(|constant| constant.name == text) {
                Some(constant) => (
                    format!("a constant of the language, {}", constant.value),
                    match noun == "constant" && self.spec.constants.len() == 1 {
                        true => {
                            "remove it with the `constants` around it, since the language has it, or choose another name"
                        }
                        false => "remove it, since the language has it, or choose another name",
                    },
                ),
                None if entries().any(|entry| entry.name == text) => (
                    "a function of the language".to_owned(),
                    "choose another name",
                ),
                None => (
                    "something in the language".to_owned(),
                    "choose another name",
                ),
            };
            let message = format!("{noun} `{shown}` has the name of {what}");
            self.fault(Rule::E0111, name.span, message, help);
        } else if usage == Use::Emitted && is_of_the_law(text) {
            let message = format!("{noun} `{shown}` is the name of a quantity of the control law");
            self.fault(
                Rule::E0112,
                name.span,
                message,
                format!("choose another name, such as `{shown}_value`"),
            );
        } else {
            return true;
        }
        false
    }

    /// Groups, parts and arguments of polynomial data; `CL.alpha` is emitted as `CL_alpha`.
    fn check_polynomial_names(&mut self, declared: &BTreeMap<String, (Span, &str)>) {
        let spec = self.spec;
        let mut emitted: BTreeMap<String, Span> = BTreeMap::new();
        for group in &spec.polynomials {
            self.check_identifier(&group.name, "polynomial group", Use::Label);
            self.declare(
                &mut BTreeMap::new(),
                group.value.arguments.iter().flatten(),
                "argument",
                Use::Label,
            );
            for part in &group.value.parts {
                self.check_identifier(&part.name, "polynomial", Use::Label);
                let name = format!("{}_{}", group.name.value, part.name.value);
                let taken = declared
                    .get(&name)
                    .map(|(span, _)| span)
                    .or_else(|| emitted.get(&name));
                if let Some(&taken) = taken {
                    let message = format!(
                        "polynomial `{}.{}` is emitted as `{name}`, which is taken",
                        group.name.value, part.name.value
                    );
                    let fault = Diagnostic::error(Rule::E0113, part.name.span, message)
                        .with_related(taken, "the name is declared here");
                    self.faults.push(fault.with_help("rename one of them"));
                }
                emitted.insert(name, part.name.span);
            }
        }
    }
}

/// Whether a name is that of a quantity of the law, which the emitted code uses itself.
pub fn is_of_the_law(name: &str) -> bool {
    let digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    // Derivatives are `_dot`, `_dot2`, ..
    let quantity = name
        .rsplit_once("_dot")
        .filter(|(_, order)| digits(order))
        .map_or(name, |(quantity, _)| quantity);
    let stem = quantity.trim_end_matches(|c: char| c.is_ascii_digit());
    let numbered = stem.len() < quantity.len() && NUMBERED.contains(&stem);
    numbered || EMITTED.contains(&name) || quantity == "y_r"
}

fn words<T>(all: &[Named<T>]) -> impl Iterator<Item = &Word> {
    all.iter().map(|item| &item.name)
}
