//! Text to tokens. A number and its unit are one token, for only here is it known what touches what.

use std::ops::Range;

use super::arena::Comparison;
use super::parser::MAX_FAULTS;
use super::syntax::{Infix, Literal};
use crate::diagnostic::{Applicability, Base, Diagnostic, Rule, quoted};
use crate::unit::{self, Unit, UnitFault};

/// A token and its bytes in the text.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Token {
    pub(super) kind: TokenKind,
    pub(super) range: Range<usize>,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) enum TokenKind {
    Number(Literal),
    /// Identifier with its dots.
    Name(String),
    Not,
    Infix(Infix),
    Open,
    Close,
    OpenArray,
    CloseArray,
    Comma,
    /// One past the last token.
    End,
}

/// All tokens of a text, or every fault in it.
pub(super) fn tokens(text: &str, base: &Base) -> Result<Vec<Token>, Vec<Diagnostic>> {
    let mut lexer = Lexer {
        text,
        base,
        at: 0,
        faults: Vec::new(),
    };
    let mut tokens = Vec::new();
    loop {
        lexer.skip_blanks();
        let start = lexer.at;
        let next = lexer.rest().chars().next();
        let Some(first) = next.filter(|_| lexer.faults.len() < MAX_FAULTS) else {
            break;
        };
        if let Some(kind) = lexer.token(first) {
            tokens.push(Token {
                kind,
                range: start..lexer.at,
            });
        }
    }
    tokens.push(Token {
        kind: TokenKind::End,
        range: text.len()..text.len(),
    });
    if lexer.faults.is_empty() {
        Ok(tokens)
    } else {
        Err(lexer.faults)
    }
}

struct Lexer<'a> {
    text: &'a str,
    base: &'a Base,
    at: usize,
    faults: Vec<Diagnostic>,
}

impl<'a> Lexer<'a> {
    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    fn skip_blanks(&mut self) {
        self.at = self.text.len()
            - self
                .rest()
                .trim_start_matches([' ', '\t', '\n', '\r'])
                .len();
    }

    /// The token at a character that is no blank; `None` after a fault.
    fn token(&mut self, first: char) -> Option<TokenKind> {
        let rest = self.rest();
        if rest
            .trim_start_matches('.')
            .starts_with(|c: char| c.is_ascii_digit())
        {
            return self.number();
        }
        if first == '_' || first.is_ascii_alphabetic() {
            return Some(self.name());
        }
        let symbol = SYMBOLS.iter().find(|(text, _)| rest.starts_with(text));
        match symbol {
            Some((text, kind)) if !rest.starts_with("**") => {
                self.at += text.len();
                Some(kind.clone())
            }
            _ => {
                self.unexpected(first);
                None
            }
        }
    }

    fn name(&mut self) -> TokenKind {
        let name = dotted_name(self.rest());
        self.at += name.len();
        let word = WORDS.iter().find(|(word, _)| *word == name);
        word.map_or_else(
            || TokenKind::Name(name.to_owned()),
            |(_, kind)| kind.clone(),
        )
    }

    fn number(&mut self) -> Option<TokenKind> {
        let start = self.at;
        let digits = decimal(self.rest());
        self.at += digits.len();
        if self.rest().starts_with(['.', '_']) {
            self.at += self
                .rest()
                .chars()
                .take_while(|&c| c == '.' || c == '_' || c.is_ascii_digit())
                .count();
            let message = format!("malformed number {}", quoted(&self.text[start..self.at]));
            let range = start..self.at;
            let plain = self.text[range.clone()].replace('_', "");
            self.report(
                Rule::E0202,
                range.clone(),
                message,
                "write numbers like `12000`, `0.5` or `1.5e-3`",
            );
            if decimal(&plain).len() == plain.len() {
                self.suggest(range, &plain, Applicability::Certain);
            }
            return None;
        }
        let unit = self.unit()?;
        let value = match &unit {
            Some(unit) => unit.si(digits),
            None => digits.parse().ok().filter(|value: &f64| value.is_finite()),
        };
        let mantissa = digits.split(['e', 'E']).next().unwrap_or_default();
        let is_zero = !mantissa.contains(|c| matches!(c, '1'..='9'));
        // A literal 0 fits every dimension, so a number that only rounds to 0 must not become one.
        let Some(value) = value.filter(|&value| (value == 0.0) == is_zero) else {
            let message = format!(
                "number {} is outside the range of f64",
                quoted(&self.text[start..self.at])
            );
            self.report(
                Rule::E0202,
                start..self.at,
                message,
                "magnitudes go from about 1e-308 to 1e308",
            );
            return None;
        };
        let integer = if unit.is_none() {
            digits.parse().ok()
        } else {
            None
        };
        Some(TokenKind::Number(Literal {
            value,
            unit,
            integer,
        }))
    }

    /// The unit right behind a number or one blank after it; outer `None` after a fault.
    fn unit(&mut self) -> Option<Option<Unit>> {
        let rest = self.rest();
        let blank = usize::from(rest.starts_with(' '));
        let text = &rest[blank..];
        if matches!(dotted_name(text), "and" | "or" | "not" | "if") {
            return Some(None);
        }
        match unit::scan(text) {
            Ok(None) => Some(None),
            Ok(Some((unit, length))) => {
                self.at += blank + length;
                Some(Some(unit))
            }
            Err(error) => {
                let error = error.shifted(self.at + blank);
                self.at = error.range.end;
                let fault = error.diagnostic(self.base);
                self.faults.push(match error.fault {
                    UnitFault::Unknown {
                        suggestion: None, ..
                    } => fault.with_help("to multiply by a quantity, write `*` in front of it"),
                    _ => fault,
                });
                None
            }
        }
    }

    fn unexpected(&mut self, first: char) {
        let found = FOREIGN
            .iter()
            .find(|(foreign, _)| self.rest().starts_with(foreign));
        let length = found.map_or(first.len_utf8(), |(foreign, _)| foreign.len());
        let range = self.at..self.at + length;
        let shown = self.text[range.clone()].chars().map(|c| match c {
            '\\' | '\'' | '"' => c.to_string(),
            _ => c.escape_debug().to_string(),
        });
        let message = format!("unexpected `{}`", shown.collect::<String>());
        let help = match found {
            Some((_, native)) => format!("write `{native}`"),
            None if first == '\\' => "write `solve(M, b)` for the solution of `M*x = b`".to_owned(),
            None => "expressions are made of numbers, names, operators, functions and brackets"
                .to_owned(),
        };
        self.at += length;
        self.report(Rule::E0201, range.clone(), message, help);
        if let Some((foreign, native)) = found {
            // `=` may be a slip for `==` or a thought from another language, a bracket has a partner, and `2` before a pi needs a `*`.
            let sure = !matches!(*foreign, "=" | "{" | "}" | ";" | "\u{3c0}");
            let native = self.spaced(&range, native);
            let applicability = match sure {
                true => Applicability::Certain,
                false => Applicability::Possible,
            };
            self.suggest(range, &native, applicability);
        }
    }

    /// What replaces a symbol, with blanks where a word would touch what stands beside it.
    fn spaced(&self, range: &Range<usize>, native: &str) -> String {
        let gap = |beside: Option<char>| match beside.is_some_and(|c| !c.is_whitespace()) {
            true => " ",
            false => "",
        };
        let before = gap(self.text[..range.start].chars().next_back());
        let after = gap(self.text[range.end..].chars().next());
        match native {
            "and" | "or" | "not" => format!("{before}{native}{after}"),
            "deg" => format!("{before}{native}"),
            _ => native.to_owned(),
        }
    }

    /// A change that mends the fault reported last.
    fn suggest(&mut self, range: Range<usize>, replacement: &str, applicability: Applicability) {
        if self.base.holds(range.clone())
            && let Some(fault) = self.faults.pop()
        {
            let span = self.base.span_of(range);
            self.faults
                .push(fault.with_suggestion(span, replacement, applicability));
        }
    }

    fn report(
        &mut self,
        rule: Rule,
        range: Range<usize>,
        message: String,
        help: impl Into<String>,
    ) {
        self.faults
            .push(Diagnostic::error(rule, self.base.span_of(range), message).with_help(help));
    }
}

/// The longest number at the start of a text: digits, a fraction, an exponent. An `e` that no digits follow is left alone.
fn decimal(text: &str) -> &str {
    let digits_from =
        |from: usize| from + text[from..].bytes().take_while(u8::is_ascii_digit).count();
    let mut end = digits_from(0);
    if text[end..].starts_with('.') && digits_from(end + 1) > end + 1 {
        end = digits_from(end + 1);
    }
    if text[end..].starts_with(['e', 'E']) {
        let sign = usize::from(text[end + 1..].starts_with(['+', '-']));
        let exponent = end + 1 + sign;
        if digits_from(exponent) > exponent {
            end = digits_from(exponent);
        }
    }
    &text[..end]
}

/// The longest name at the start of a text: identifiers joined by dots; empty if there is none.
fn dotted_name(text: &str) -> &str {
    let mut end = identifier(text);
    while end > 0 && text[end..].starts_with('.') {
        match identifier(&text[end + 1..]) {
            0 => break,
            length => end += 1 + length,
        }
    }
    &text[..end]
}

fn identifier(text: &str) -> usize {
    let word = |c: char| c == '_' || c.is_ascii_alphanumeric();
    if text.starts_with(|c: char| c.is_ascii_digit()) {
        0
    } else {
        text.find(|c| !word(c)).unwrap_or(text.len())
    }
}

/// Operators and brackets; one that begins another stands behind it.
const SYMBOLS: &[(&str, TokenKind)] = &[
    ("<=", TokenKind::Infix(Infix::Compare(Comparison::Le))),
    (">=", TokenKind::Infix(Infix::Compare(Comparison::Ge))),
    ("==", TokenKind::Infix(Infix::Compare(Comparison::Eq))),
    ("!=", TokenKind::Infix(Infix::Compare(Comparison::Ne))),
    ("<", TokenKind::Infix(Infix::Compare(Comparison::Lt))),
    (">", TokenKind::Infix(Infix::Compare(Comparison::Gt))),
    ("+", TokenKind::Infix(Infix::Add)),
    ("-", TokenKind::Infix(Infix::Sub)),
    ("*", TokenKind::Infix(Infix::Mul)),
    ("/", TokenKind::Infix(Infix::Div)),
    ("^", TokenKind::Infix(Infix::Pow)),
    ("(", TokenKind::Open),
    (")", TokenKind::Close),
    ("[", TokenKind::OpenArray),
    ("]", TokenKind::CloseArray),
    (",", TokenKind::Comma),
];

/// Operators that are words.
const WORDS: &[(&str, TokenKind)] = &[
    ("and", TokenKind::Infix(Infix::And)),
    ("or", TokenKind::Infix(Infix::Or)),
    ("not", TokenKind::Not),
];

/// Operators between two operands.
pub(super) fn operators() -> impl Iterator<Item = (&'static str, Infix)> {
    let tokens = SYMBOLS.iter().chain(WORDS);
    tokens.filter_map(|(text, kind)| match kind {
        TokenKind::Infix(operator) => Some((*text, *operator)),
        _ => None,
    })
}

/// What people write from other languages, and what to write here.
const FOREIGN: &[(&str, &str)] = &[
    ("**", "^"),
    ("&&", "and"),
    ("||", "or"),
    ("!", "not"),
    ("=", "=="),
    ("{", "["),
    ("}", "]"),
    (";", ","),
    ("\u{b7}", "*"),
    ("\u{d7}", "*"),
    ("\u{f7}", "/"),
    ("\u{2212}", "-"),
    ("\u{2264}", "<="),
    ("\u{2265}", ">="),
    ("\u{2260}", "!="),
    ("\u{b0}", "deg"),
    ("\u{3c0}", "pi"),
    ("\u{b2}", "^2"),
    ("\u{b3}", "^3"),
    ("\u{b5}", "u"),
];
