//! Reads distributions.

use super::fields::{Fields, Reader, list};
use crate::diagnostic::{Rule, Span};
use crate::spec::{Code, Correlation, Dispersion, Read, Unreadable};
use crate::vocabulary::{CORRELATION, DISPERSION};
use crate::yaml::{Entry, Kind, Node};

impl Reader {
    /// The distribution under `dispersion`.
    pub(super) fn dispersion(&mut self, of: &Fields<'_>) -> Option<Read<Dispersion>> {
        match of.entry("dispersion") {
            Some(entry) => Some(self.distribution(&entry.value)),
            None => (!of.left_out("dispersion")).then_some(Err(Unreadable)),
        }
    }

    /// A map with one key, the kind of the distribution.
    pub(super) fn distribution(&mut self, node: &Node) -> Read<Dispersion> {
        let before = self.faults.len();
        let fields = self.fields(node, &DISPERSION);
        let kinds: Vec<&str> = DISPERSION.keys.iter().map(|key| key.name).collect();
        let given = |kind: &&'static str| Some((*kind, fields.entry(kind)?));
        let given: Vec<(&str, &Entry)> = kinds.iter().filter_map(given).collect();
        let &[(kind, entry)] = given.as_slice() else {
            if self.faults.len() == before {
                let message = format!("dispersion must have one of {}", list(&kinds));
                let help = "write `{uniform: [0.8, 1.2]}` or `{normal: [1, 0.1]}`";
                self.fault(Rule::E0106, fields.span, message, help);
            }
            return Err(Unreadable);
        };
        let value = &entry.value;
        match kind {
            "uniform" => (self.numbers(value, "[least, largest]")).map(Dispersion::Uniform),
            "normal" => (self.numbers(value, "[mean, deviation]")).map(Dispersion::Normal),
            "truncated_normal" => (self.numbers(value, "[mean, deviation, least, largest]"))
                .map(Dispersion::TruncatedNormal),
            "lognormal" => (self.numbers(value, "[median, sigma]")).map(Dispersion::Lognormal),
            _ => self.discrete(value),
        }
    }

    fn discrete(&mut self, node: &Node) -> Read<Dispersion> {
        let expected = "[value, probability]";
        let Kind::Seq(items) = &node.kind else {
            let help = "write `[[value, probability], ..]`";
            self.kind(node, "a list of values with probabilities", help);
            return Err(Unreadable);
        };
        let pairs = items.iter().map(|item| self.numbers(item, expected));
        let pairs: Vec<Read<[Code; 2]>> = pairs.collect();
        let pairs: Read<Vec<[Code; 2]>> = pairs.into_iter().collect();
        pairs.map(Dispersion::Discrete)
    }

    /// A list of N quantities.
    fn numbers<const N: usize>(&mut self, node: &Node, expected: &str) -> Read<[Code; N]> {
        let Kind::Seq(items) = &node.kind else {
            return self.not_numbers(node, N, expected);
        };
        let codes: Vec<Code> = items.iter().map(|item| self.code_of(item)).collect();
        match codes.try_into() {
            Ok(codes) => Ok(codes),
            Err(_) => self.not_numbers(node, N, expected),
        }
    }

    fn not_numbers<T>(&mut self, node: &Node, count: usize, expected: &str) -> Read<T> {
        let what = format!("a list of {count}: `{expected}`");
        let help = format!("write {count} in brackets: `{expected}`");
        self.kind(node, &what, &help);
        Err(Unreadable)
    }

    /// The list of `correlations`.
    pub(super) fn correlations(&mut self, specification: &Fields<'_>) -> Vec<Correlation> {
        let expected = "a list with one item for each group of parameters";
        let items = self.items(specification, "correlations", expected);
        let items = items.unwrap_or_default().iter();
        items.map(|item| self.correlation(item)).collect()
    }

    fn correlation(&mut self, node: &Node) -> Correlation {
        let fields = self.fields(node, &CORRELATION);
        let parameters = self.items(&fields, "parameters", "a list of names");
        Correlation {
            parameters: self.words(parameters),
            covariance: self.formula(&fields, "covariance"),
        }
    }

    /// Reports that a map must have exactly one of two keys.
    pub(super) fn one_of<T>(&mut self, span: Span, what: &str, keys: [&str; 2]) -> Read<T> {
        let [first, second] = keys;
        let message = format!("{what} must have one of `{first}` and `{second}`");
        self.fault(Rule::E0106, span, message, "choose one of them");
        Err(Unreadable)
    }
}
