//! The list of modules in the `lib.rs` of generated code.

/// The text with `pub mod name;` among its sorted module declarations; `None` if it has it.
pub(super) fn with_module(text: &str, name: &str) -> Option<String> {
    let declaration = format!("pub mod {name};");
    let is_module = |line: &&str| line.starts_with("pub mod ") && line.ends_with(';');
    if text.lines().any(|line| line == declaration) {
        return None;
    }
    let mut lines: Vec<&str> = text.lines().collect();
    let modules: Vec<usize> = (0..lines.len()).filter(|&i| is_module(&lines[i])).collect();
    let after = modules
        .iter()
        .copied()
        .find(|&i| lines[i] > declaration.as_str());
    match (after, modules.last()) {
        (Some(next), _) => lines.insert(next, &declaration),
        (None, Some(&last)) => lines.insert(last + 1, &declaration),
        (None, None) => lines.extend(["", &declaration]),
    }
    Some(lines.join("\n") + "\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn modules_are_declared_in_order() {
        let empty = "//! Output.\n#![no_std]\n";
        let one = with_module(empty, "m").unwrap();
        assert_eq!(one, "//! Output.\n#![no_std]\n\npub mod m;\n");
        let three = with_module(&with_module(&one, "z").unwrap(), "a").unwrap();
        assert_eq!(
            three,
            "//! Output.\n#![no_std]\n\npub mod a;\npub mod m;\npub mod z;\n"
        );
        assert_eq!(with_module(&three, "m"), None);
    }
}
