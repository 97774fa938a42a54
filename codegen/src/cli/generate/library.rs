//! The list of modules in the `lib.rs` of generated code.

use std::collections::BTreeMap;

use syn::{Attribute, Expr, ExprLit, Item, Lit, Meta};

/// Names and titles of the modules that a library declares; `None` if it holds anything else.
pub(super) fn declared(text: &str) -> Option<BTreeMap<String, String>> {
    let items = syn::parse_file(text).ok()?.items;
    let module = |item: Item| match item {
        Item::Mod(module) if module.content.is_none() => {
            Some((module.ident.to_string(), title(&module.attrs)))
        }
        _ => None,
    };
    items.into_iter().map(module).collect()
}

/// The documentation as one line, without the escapes that keep it from being markup.
fn title(attributes: &[Attribute]) -> String {
    let line = |attribute: &Attribute| match &attribute.meta {
        Meta::NameValue(pair) if pair.path.is_ident("doc") => match &pair.value {
            Expr::Lit(ExprLit {
                lit: Lit::Str(text),
                ..
            }) => Some(text.value().trim().to_owned()),
            _ => None,
        },
        _ => None,
    };
    let joined = attributes
        .iter()
        .filter_map(line)
        .collect::<Vec<_>>()
        .join(" ");
    let mut plain = String::new();
    let mut letters = joined.chars();
    while let Some(letter) = letters.next() {
        plain.extend(if letter == '\\' {
            letters.next()
        } else {
            Some(letter)
        });
    }
    plain
}

#[cfg(test)]
mod tests {
    use nsv_codegen::driver::library;

    use super::*;

    #[test]
    fn what_is_written_reads_back() {
        let long = "An arm with [two] links and a <title> that is so long that it takes several lines of documentation to hold all of it";
        let modules = [
            ("arm", long),
            ("motor", "Motor \\ arm"),
            ("pendulum", "Pendulum"),
        ];
        let modules: BTreeMap<String, String> = modules
            .map(|(name, title)| (name.to_owned(), title.to_owned()))
            .into();
        let text = library(&modules);
        assert_eq!(declared(&text), Some(modules.clone()));
        assert_eq!(library(&declared(&text).unwrap()), text);
        assert_eq!(declared("//! Empty.\n#![no_std]\n"), Some(BTreeMap::new()));
    }

    #[test]
    fn a_library_with_code_is_not_ours() {
        assert_eq!(declared("pub mod a;\npub fn f() {}\n"), None);
        assert_eq!(declared("pub mod a { }\n"), None);
        assert_eq!(declared("not rust"), None);
    }
}
