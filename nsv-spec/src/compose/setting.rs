//! `PATH=VALUE`: a value that is set on the command line.

use std::path::Path;

use super::path::{get, keys, set};
use crate::diagnostic::{Diagnostic, Rule, SourceMap, Span};
use crate::include::read_file;
use crate::yaml::{self, Key, Kind, Node, excerpt};

/// What stands before a setting in the source that shows it.
const FLAG: &str = "--set ";

/// Splits `PATH=VALUE`; both sides hold something.
pub fn split(setting: &str) -> Option<(&str, &str)> {
    let (path, value) = setting.split_once('=')?;
    (!path.trim().is_empty() && !value.trim().is_empty()).then_some((path, value))
}

/// The text of a setting as a source of its own, which the fingerprint covers.
pub(super) fn shown(path: &str, value: &str) -> String {
    format!("{FLAG}{path}={value}")
}

/// Applies a setting to a tree and gives its path.
pub(super) fn apply(
    tree: &mut Node,
    setting: &str,
    sources: &mut SourceMap,
) -> Result<Vec<Key>, Vec<Diagnostic>> {
    let (path, value) = split(setting).unwrap_or((setting, ""));
    let text = shown(path, value);
    let start = FLAG.len() as u32;
    let end = start + path.len() as u32;
    let file = sources.add_virtual("command line", text.as_str().into());
    let keys = keys(path, Span { file, start, end });
    // Blanks in place of what stands before it, so that the value has its own place.
    let indented = " ".repeat(end as usize + 1) + value;
    let value = match value.trim_start().strip_prefix('@') {
        Some(name) => {
            let end = text.len() as u32;
            let span = Span {
                file,
                start: end - name.len() as u32,
                end,
            };
            from_file(name, span, &keys, sources)?
        }
        None => {
            let text = yaml::text(indented.as_bytes(), file).map_err(|fault| vec![*fault])?;
            yaml::read(&text, file).map_err(|fault| vec![*fault])?
        }
    };
    set(tree, &keys, value).map_err(|fault| vec![*fault])?;
    Ok(keys)
}

/// The value that another specification has under the same path, with all that it includes and extends.
fn from_file(
    name: &str,
    span: Span,
    path: &[Key],
    sources: &mut SourceMap,
) -> Result<Node, Vec<Diagnostic>> {
    let joined = read_file(Path::new(name), sources).map_err(|mut faults| {
        // A file that cannot be read has no place of its own.
        for fault in faults.iter_mut().filter(|fault| fault.span.is_none()) {
            fault.span = Some(span);
        }
        faults
    })?;
    if !joined.faults.is_empty() {
        return Err(joined.faults);
    }
    match get(&joined.tree, path) {
        Some(node) if !matches!(node.kind, Kind::Null) => Ok(node.clone()),
        _ => {
            let path: Vec<&str> = path.iter().map(|key| &*key.text).collect();
            let message = format!("no `{}` in `{}`", path.join("."), excerpt(name));
            Err(vec![
                Diagnostic::error(Rule::E0030, span, message)
                    .with_help("the value is taken from the same path of the other file"),
            ])
        }
    }
}
