//! Reads the values behind keys: text, expressions, whole numbers and choices.
//!
//! A value with a fault is reported, and marked as unreadable for the checks.

use super::fields::{Fields, Reader, list};
use crate::diagnostic::{Diagnostic, Rule};
use crate::spec::{AutoCode, Choice, Code, Formula, Located, Read, Unreadable, Word};
use crate::suggest::nearest;
use crate::vocabulary::{Key, Kind as Expects};
use crate::yaml::{Entry, Kind, Node};

impl Reader {
    /// Text for people.
    pub(super) fn word(&mut self, node: &Node) -> Read<Word> {
        let Kind::Scalar(scalar) = &node.kind else {
            self.kind(node, "text", "write it in quotes");
            return Err(Unreadable);
        };
        Ok(Located {
            value: scalar.text.clone(),
            span: node.span,
        })
    }

    /// Text in every item of a list.
    pub(super) fn words(&mut self, items: Read<&[Node]>) -> Read<Vec<Word>> {
        let words: Vec<Read<Word>> = items?.iter().map(|item| self.word(item)).collect();
        words.into_iter().collect()
    }

    /// Text for people under a key, to whom it does not matter why it is missing.
    pub(super) fn note(&mut self, fields: &Fields<'_>, key: &str) -> Option<Word> {
        self.text(fields, key)?.ok()
    }

    /// Text under a key.
    pub(crate) fn text(&mut self, fields: &Fields<'_>, key: &str) -> Option<Read<Word>> {
        match fields.entry(key) {
            Some(entry) => Some(self.word(&entry.value)),
            None => (!fields.left_out(key)).then_some(Err(Unreadable)),
        }
    }

    /// An expression or a nested list of them.
    pub(super) fn formula_of(&mut self, node: &Node) -> Formula {
        match &node.kind {
            Kind::Seq(items) => {
                if items.is_empty() {
                    self.kind(node, "at least one entry", "write its entries");
                }
                if self.in_pieces(items) {
                    return Formula::Code(Code::unreadable(node.span));
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
            .unwrap_or_else(|| Formula::Code(Code::unreadable(fields.span)))
    }

    /// An expression under a key.
    pub(super) fn optional_formula(&mut self, fields: &Fields<'_>, key: &str) -> Option<Formula> {
        fields.entry(key).map(|entry| self.formula_of(&entry.value))
    }

    /// One expression.
    pub(super) fn code_of(&mut self, node: &Node) -> Code {
        if self.cut.contains(&node.span) {
            return Code::unreadable(node.span);
        }
        if let Kind::Scalar(scalar) = &node.kind {
            return Code {
                text: Ok(scalar.code.clone()),
                base: scalar.base.clone(),
            };
        }
        self.kind(
            node,
            "a number or an expression",
            "write a number with its unit, or an expression in quotes",
        );
        Code::unreadable(node.span)
    }

    /// A quantity under a key that is required.
    pub(super) fn code(&mut self, fields: &Fields<'_>, key: &str) -> Code {
        self.optional_code(fields, key)
            .unwrap_or_else(|| Code::unreadable(fields.span))
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
            Kind::Scalar(scalar) if nearest(&scalar.text, ["auto"]).is_some() => {
                let message = format!("found {}, expected `auto` or a number", node.describe());
                let fault = Diagnostic::error(Rule::E0103, node.span, message);
                let meant = nearest(&scalar.text, ["auto"]);
                let otherwise = || "write `auto`".into();
                let fault = fault.did_you_mean(node.span, &scalar.text, meant, otherwise);
                self.faults.push(fault);
                AutoCode::Code(Code::unreadable(node.span))
            }
            _ => AutoCode::Code(self.code_of(node)),
        })
    }

    /// A whole number; one that cannot be read counts as left out.
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
    ) -> Choice<T> {
        let Some(Entry { value: node, .. }) = fields.entry(key) else {
            return match fields.left_out(key) {
                true => Ok(None),
                false => Err(Unreadable),
            };
        };
        let Some(Key {
            kind: Expects::Choice(words),
            ..
        }) = fields.key(key)
        else {
            unreachable!("invariant: `{key}` is a choice");
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
            return Err(Unreadable);
        };
        Ok(Some(Located {
            value: values[at],
            span: node.span,
        }))
    }
}
