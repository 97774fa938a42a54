//! JSON for files that people review: what fits on a line stays on a line.

use serde_json::Value;

const WIDTH: usize = 120;

/// `value` in at most [`WIDTH`] columns where it can be, with a newline at the end.
pub(crate) fn render(value: &Value) -> String {
    let mut text = String::new();
    write(value, 0, &mut text);
    text.push('\n');
    text
}

fn write(value: &Value, indent: usize, text: &mut String) {
    let compact = value.to_string();
    let items: Vec<(String, &Value)> = match value {
        Value::Array(items) => items.iter().map(|item| (String::new(), item)).collect(),
        Value::Object(entries) => entries
            .iter()
            .map(|(key, item)| (format!("{}: ", Value::from(key.as_str())), item))
            .collect(),
        _ => Vec::new(),
    };
    // An object is opened always, so that its keys stand one below the other.
    if items.is_empty() || (value.is_array() && indent + compact.len() <= WIDTH) {
        text.push_str(&compact);
        return;
    }
    let (open, close) = if value.is_array() {
        ('[', ']')
    } else {
        ('{', '}')
    };
    text.push(open);
    for (position, (key, item)) in items.iter().enumerate() {
        text.push_str(if position == 0 { "\n" } else { ",\n" });
        text.push_str(&" ".repeat(indent + 1));
        text.push_str(key);
        write(item, indent + 1, text);
    }
    text.push('\n');
    text.push_str(&" ".repeat(indent));
    text.push(close);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_arrays_stay_on_a_line() {
        let value =
            serde_json::json!({"nodes": [["ADD", [0, 1], []]], "long": vec![1_000_000; 20]});
        let text = render(&value);
        assert_eq!(serde_json::from_str::<Value>(&text).unwrap(), value);
        assert!(text.contains("\"nodes\": [[\"ADD\",[0,1],[]]]\n"), "{text}");
        assert!(
            text.lines().all(|line| line.len() <= WIDTH) && text.ends_with("}\n"),
            "{text}"
        );
    }
}
