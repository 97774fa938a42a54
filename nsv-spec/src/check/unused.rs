//! Warns of declarations in the specification itself that no expression uses; included files may serve several specifications.

use super::Context;
use crate::diagnostic::{Diagnostic, FileId, Rule};
use crate::spec::{Named, Word};

impl Context<'_> {
    /// Checks constants, parameters, definitions, functions and tables.
    pub(super) fn warn_of_unused(&mut self) {
        let spec = self.spec;
        let mut unused: Vec<(&'static str, &Word)> = Vec::new();
        let used = &self.used;
        unused.extend(without_use(&spec.constants, used, "constant"));
        unused.extend(without_use(&spec.parameters, used, "parameter"));
        unused.extend(without_use(&spec.definitions, used, "definition"));
        unused.extend(without_use(&spec.functions, used, "function"));
        unused.extend(without_use(&spec.tables, used, "table"));
        for (noun, name) in unused {
            let message = format!("{noun} `{}` is never used", name.value);
            let warning = Diagnostic::warning(Rule::W0002, name.span, message);
            self.warnings
                .push(warning.with_help("remove it, or use it where it was meant to be"));
        }
    }
}

fn without_use<'a, T>(
    declared: &'a [Named<T>],
    used: &'a std::collections::BTreeSet<String>,
    noun: &'static str,
) -> impl Iterator<Item = (&'static str, &'a Word)> {
    declared
        .iter()
        .map(|item| &item.name)
        .filter(|name| name.span.file == FileId(0) && !used.contains(&name.value))
        .map(move |name| (noun, name))
}
