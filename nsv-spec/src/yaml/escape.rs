//! Escapes of quoted scalars, with the place of each decoded byte.

/// A quoted text without its escapes, line breaks as in the file; and the bytes of it that stand elsewhere than those before
/// them let expect, each with its byte in the file, both counted from the start.
pub(super) fn decode(written: &str, double: bool) -> (String, Vec<(u32, u32)>) {
    let mut decoded = String::with_capacity(written.len());
    let mut places = Vec::new();
    let mut at = 0;
    while let Some(next) = written[at..].chars().next() {
        let rest = &written[at..];
        let length = match (double, next) {
            (true, '\\') => double_escape(rest, &mut decoded),
            (false, '\'') if rest.starts_with("''") => {
                decoded.push('\'');
                2
            }
            _ => {
                decoded.push(next);
                at += next.len_utf8();
                continue;
            }
        };
        at += length;
        // At most MAX_BYTES, so the casts are exact.
        places.push((decoded.len() as u32, at as u32));
    }
    (decoded, places)
}

/// Adds what the escape at the start of `rest` stands for, and gives the bytes that it takes.
fn double_escape(rest: &str, decoded: &mut String) -> usize {
    let Some(letter) = rest[1..].chars().next() else {
        return rest.len();
    };
    let digits = match letter {
        'x' => 2,
        'u' => 4,
        'U' => 8,
        '\n' | '\r' => {
            // A line break that joins: blanks of the next line belong to it.
            let blanks = rest[1..].trim_start_matches(['\r', '\n', ' ', '\t']);
            return rest.len() - blanks.len();
        }
        _ => 0,
    };
    let code = rest.get(2..2 + digits).unwrap_or_default();
    let plain = match letter {
        '0' => '\0',
        'a' => '\u{7}',
        'b' => '\u{8}',
        't' | '\t' => '\t',
        'n' => '\n',
        'v' => '\u{b}',
        'f' => '\u{c}',
        'r' => '\r',
        'e' => '\u{1b}',
        'N' => '\u{85}',
        '_' => '\u{a0}',
        'L' => '\u{2028}',
        'P' => '\u{2029}',
        'x' | 'u' | 'U' => u32::from_str_radix(code, 16)
            .ok()
            .and_then(char::from_u32)
            .unwrap_or(char::REPLACEMENT_CHARACTER),
        other => other,
    };
    decoded.push(plain);
    (1 + letter.len_utf8() + digits).min(rest.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The text in the file at each decoded character.
    fn check(written: &str, double: bool, expected: &str) {
        use crate::diagnostic::{Base, FileId, Span};
        let (decoded, places) = decode(written, double);
        assert_eq!(decoded, expected);
        let span = Span {
            file: FileId(0),
            start: 0,
            end: written.len() as u32,
        };
        let base = Base::escaped(span, places.into());
        for (at, found) in decoded.char_indices() {
            let end = at + found.len_utf8();
            let place = base.span_of(at..end);
            let there = &written[place.start as usize..place.end as usize];
            assert!(
                there == found.to_string() || there.contains(['\\', '\'']),
                "{there}"
            );
            assert_eq!(base.holds(at..end), there.len() == found.len_utf8());
        }
    }

    #[test]
    fn each_byte_knows_its_place() {
        check(r#"a \"b\" \x41c \u00e9d"#, true, "a \"b\" Ac \u{e9}d");
        check("it''s ''x", false, "it's 'x");
        check("a + \\\n   b \\t c", true, "a + b \t c");
        check("\\\u{e9} \\", true, "\u{e9} ");
        check("\\", true, "");
        check("\\u12", true, "\u{fffd}");
    }
}
