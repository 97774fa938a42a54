//! From items to the text of a file: imports by use, prettyplease, comments, blank lines, header.

use std::collections::HashSet;

use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};
use quote::quote;

use crate::emit::comment::{Comments, module_docs};
use crate::emit::names::ident;

/// Modules that emitted code calls by path; a variable may have the same name.
const MODULES: [&str; 7] = [
    "controller",
    "kernel",
    "lyapunov",
    "plant",
    "polynomials",
    "sde",
    "tables",
];

/// Methods of masks: their trait is not named where they are called.
const MASK_METHODS: [&str; 5] = ["and", "or", "not", "any", "all"];

/// One emitted file.
pub(crate) struct Source<'a> {
    /// Lines of the comment at the top.
    pub(crate) header: &'a [String],
    /// Module documentation.
    pub(crate) docs: &'a [String],
    /// Lints that the file allows, with the reason.
    pub(crate) allow: &'a [(&'a str, &'a str)],
    /// Imports, each as a path; those that no item mentions are left out.
    pub(crate) imports: &'a [&'a str],
    /// The items.
    pub(crate) items: Vec<TokenStream>,
}

impl Source<'_> {
    /// The text.
    pub(crate) fn text(self, comments: &Comments) -> String {
        let docs = module_docs(self.docs);
        let imports = imports(self.imports, &Uses::of(&self.items));
        let mut text = String::new();
        for line in self.header {
            text.push_str(&format!("// {line}\n"));
        }
        if !self.header.is_empty() {
            text.push('\n');
        }
        text.push_str(&formatted(quote!(#docs)));
        let allow = allowances(self.allow);
        text.push_str(&formatted(quote!(#(#allow)*)));
        let imports = formatted(quote!(#(#imports)*));
        for part in std::iter::once(imports).chain(self.items.into_iter().map(formatted)) {
            if !part.is_empty() {
                text.push('\n');
                text.push_str(&part);
            }
        }
        spaced(comments.restore(&text).trim_start())
    }
}

/// Whether `tokens` contain the identifier `name`.
pub(crate) fn mentions(tokens: &TokenStream, name: &str) -> bool {
    tokens.clone().into_iter().any(|token| match token {
        TokenTree::Ident(ident) => ident == name,
        TokenTree::Group(group) => mentions(&group.stream(), name),
        _ => false,
    })
}

/// The identifiers of some code.
#[derive(Default)]
struct Uses {
    names: HashSet<String>,
    /// Those before `::`.
    paths: HashSet<String>,
    /// Those before `(`.
    calls: HashSet<String>,
}

impl Uses {
    fn of(items: &[TokenStream]) -> Self {
        let mut uses = Self::default();
        for item in items {
            uses.add(item);
        }
        uses
    }

    fn add(&mut self, tokens: &TokenStream) {
        let mut before = None;
        for token in tokens.clone() {
            match &token {
                TokenTree::Punct(punct)
                    if punct.as_char() == ':' && punct.spacing() == Spacing::Joint =>
                {
                    self.paths.extend(before.take());
                }
                TokenTree::Group(group) => {
                    if group.delimiter() == Delimiter::Parenthesis {
                        self.calls.extend(before.take());
                    }
                    self.add(&group.stream());
                }
                _ => {}
            }
            before = match token {
                TokenTree::Ident(ident) => Some(ident.to_string()),
                _ => None,
            };
            self.names.extend(before.clone());
        }
    }
}

/// What a function body needs in front: the short name of literals.
pub(crate) fn prologue(body: &TokenStream) -> TokenStream {
    if mentions(body, "real") {
        quote!(let real = T::from_f64;)
    } else {
        TokenStream::new()
    }
}

fn allowances(lints: &[(&str, &str)]) -> Vec<TokenStream> {
    let attribute = |&(lint, reason): &(&str, &str)| {
        let lint: Vec<_> = lint.split("::").map(ident).collect();
        quote!(#![allow(#(#lint)::*, reason = #reason)])
    };
    lints.iter().map(attribute).collect()
}

/// `use` items for the paths whose last segment is mentioned; paths that differ only in it share one item.
fn imports(paths: &[&str], uses: &Uses) -> Vec<TokenStream> {
    let mut grouped: Vec<(&str, Vec<&str>)> = Vec::new();
    let mut paths = paths.to_vec();
    paths.sort_by_key(|path| (!path.starts_with("super"), *path)); // as rustfmt has them
    for path in paths {
        let (module, name) = path
            .rsplit_once("::")
            .expect("invariant: an import is a path");
        let needed = match name {
            "Mask" => {
                uses.paths.contains(name)
                    || MASK_METHODS
                        .iter()
                        .any(|method| uses.calls.contains(*method))
            }
            name if MODULES.contains(&name) => uses.paths.contains(name),
            name => uses.names.contains(name),
        };
        if !needed {
            continue;
        }
        match grouped.last_mut() {
            Some((last, names)) if *last == module => names.push(name),
            _ => grouped.push((module, vec![name])),
        }
    }
    let item = |(module, names): (&str, Vec<&str>)| {
        let module: Vec<_> = module.split("::").map(segment).collect();
        let names: Vec<_> = names.into_iter().map(ident).collect();
        match names.as_slice() {
            [name] => quote!(use #(#module)::* :: #name;),
            _ => quote!(use #(#module)::* :: {#(#names),*};),
        }
    };
    grouped.into_iter().map(item).collect()
}

fn segment(name: &str) -> TokenStream {
    if name == "super" {
        quote!(super)
    } else {
        let name = ident(name);
        quote!(#name)
    }
}

fn formatted(tokens: TokenStream) -> String {
    let file = syn::parse2::<syn::File>(tokens);
    prettyplease::unparse(&file.expect("invariant: emitted items are Rust"))
}

/// Puts blank lines between the members of an `impl`.
fn spaced(text: &str) -> String {
    let mut spaced = String::with_capacity(text.len());
    let mut lines = text.lines().peekable();
    while let Some(line) = lines.next() {
        spaced.push_str(line);
        spaced.push('\n');
        let starts_member = |next: &&str| {
            ["    ///", "    #[", "    fn "]
                .iter()
                .any(|start| next.starts_with(start))
        };
        let ends_member = line == "    }" || line == "    ];" || line.starts_with("    const ");
        if ends_member && lines.peek().is_some_and(starts_member) {
            spaced.push('\n');
        }
    }
    spaced
}
