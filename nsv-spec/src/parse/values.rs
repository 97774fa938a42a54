//! Reads the values behind keys: text, expressions, whole numbers and choices.
//!
//! A value with a fault is reported and replaced by an empty one; the specification is discarded once it is read to its end.

use super::fields::{Fields, Reader, list};
use crate::diagnostic::{Base, Diagnostic, Rule};
use crate::spec::{AutoCode, Code, Formula, Located, Word};
use crate::suggest::nearest;
use crate::vocabulary::{Key, Kind as Expects};
use crate::yaml::{Kind, Node};

impl Reader {
    /// Text for people.
    pub(super) fn word(&mut self, node: &Node) -> Word {
        match &node.kind {
            Kind::Scalar(scalar) => Located {
                value: scalar.text.clone(),
                span: node.span,
            },
            _ => {
                self.kind(node, "text", "write it in quotes");
                Located {
                    value: String::new(),
                    span: node.span,
                }
            }
        }
    }

    /// Text under a key.
    pub(crate) fn text(&mut self, fields: &Fields<'_>, key: &str) -> Option<Word> {
        fields.entry(key).map(|entry| self.word(&entry.value))
    }

    /// An expression or a nested list of them.
    pub(super) fn formula_of(&mut self, node: &Node) -> Formula {
        match &node.kind {
            Kind::Seq(items) => {
                if items.is_empty() {
                    self.kind(node, "at least one entry", "write its entries");
                }
                Formula::List(
                    items.iter().map(|item| self.formula_of(item)).collect(),
                    node.span,
                )
            }
            _ => Formula::Code(self.code_of(node)),
        }
    }

    /// An expression under a key that is required.
    pub(super) fn formula(&mut self, fields: &Fields<'_>, key: &str) -> Formula {
        self.optional_formula(fields, key)
            .unwrap_or_else(|| Formula::List(Vec::new(), fields.span))
    }

    /// An expression under a key.
    pub(super) fn optional_formula(&mut self, fields: &Fields<'_>, key: &str) -> Option<Formula> {
        fields.entry(key).map(|entry| self.formula_of(&entry.value))
    }

    /// One expression.
    pub(super) fn code_of(&mut self, node: &Node) -> Code {
        if let Kind::Scalar(scalar) = &node.kind {
            return Code {
                text: scalar.code.clone(),
                base: scalar.base.clone(),
            };
        }
        self.kind(
            node,
            "a number or an expression",
            "write a number with its unit, or an expression in quotes",
        );
        Code {
            text: String::new(),
            base: Base::whole(node.span),
        }
    }

    /// A quantity under a key that is required.
    pub(super) fn code(&mut self, fields: &Fields<'_>, key: &str) -> Code {
        let empty = || Code {
            text: String::new(),
            base: Base::whole(fields.span),
        };
        self.optional_code(fields, key).unwrap_or_else(empty)
    }

    /// A quantity under a key.
    pub(super) fn optional_code(&mut self, fields: &Fields<'_>, key: &str) -> Option<Code> {
        fields.entry(key).map(|entry| self.code_of(&entry.value))
    }

    /// A quantity or `auto`.
    pub(super) fn auto(&mut self, fields: &Fields<'_>, key: &str) -> Option<AutoCode> {
        let node = &fields.entry(key)?.value;
        Some(match &node.kind {
            Kind::Scalar(scalar) if scalar.text == "auto" => AutoCode::Auto(node.span),
            _ => AutoCode::Code(self.code_of(node)),
        })
    }

    /// A whole number.
    pub(super) fn count(&mut self, fields: &Fields<'_>, key: &str) -> Option<Located<u64>> {
        let node = &fields.entry(key)?.value;
        let value = match &node.kind {
            Kind::Scalar(scalar) if !scalar.quoted => scalar.text.parse().ok(),
            _ => None,
        };
        if value.is_none() {
            self.kind(
                node,
                "a whole number from 0",
                "write plain digits, without unit, sign or point",
            );
        }
        value.map(|value| Located {
            value,
            span: node.span,
        })
    }

    /// One of the words that the vocabulary lists for the key; `values` are their meanings in the same order.
    pub(super) fn choice<T: Copy>(
        &mut self,
        fields: &Fields<'_>,
        key: &str,
        values: &[T],
    ) -> Option<Located<T>> {
        let node = &fields.entry(key)?.value;
        let Some(Key {
            kind: Expects::Choice(words),
            ..
        }) = fields.key(key)
        else {
            return None;
        };
        debug_assert_eq!(
            words.len(),
            values.len(),
            "invariant: every word of `{key}` has a meaning"
        );
        let found = match &node.kind {
            Kind::Scalar(scalar) => words.iter().position(|word| *word == scalar.text),
            _ => None,
        };
        let Some(at) = found else {
            let message = format!(
                "found {}, expected {} for `{key}`",
                node.describe(),
                list(words)
            );
            let fault = Diagnostic::error(Rule::E0103, node.span, message);
            let otherwise = || "write one of these words".into();
            self.faults.push(match &node.kind {
                Kind::Scalar(scalar) => {
                    let meant = nearest(&scalar.text, *words);
                    fault.did_you_mean(node.span, &scalar.text, meant, otherwise)
                }
                _ => fault.with_help(otherwise()),
            });
            return None;
        };
        Some(Located {
            value: values[at],
            span: node.span,
        })
    }
}
