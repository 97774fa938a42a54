//! The JSON Schema of the language, for completion and checks in editors: the vocabulary in another notation.

use serde_json::{Map, Value, json};

use crate::diagnostic::FileId;
use crate::expr::{Entry, entries as functions};
use crate::vocabulary::{Details, Kind, SPECIFICATION, Section, details};
use crate::yaml::{self, Kind as Found, Node};

/// JSON Schema (draft 2020-12) of a specification.
pub fn json_schema() -> Value {
    let mut sections = Map::new();
    let mut schema = section(&SPECIFICATION, &mut sections);
    let root = schema
        .as_object_mut()
        .expect("invariant: a section is an object");
    root.insert(
        "$schema".into(),
        json!("https://json-schema.org/draft/2020-12/schema"),
    );
    root.insert("title".into(), json!("nsv specification"));
    root.insert("$defs".into(), Value::Object(sections));
    schema
}

/// A map with known keys; sections below it go into `sections` under their names.
fn section(section: &'static Section, sections: &mut Map<String, Value>) -> Value {
    let mut properties = Map::new();
    for key in section.keys {
        let mut value = kind(&key.kind, sections);
        if let Some(object) = value.as_object_mut() {
            let Details {
                unit,
                default,
                example,
            } = details(section.noun, key.name);
            let unit = match unit {
                "" => String::new(),
                unit => format!("; unit: {unit}"),
            };
            object.insert("description".into(), json!(format!("{}{unit}", key.doc)));
            for (name, text) in [("default", default), ("examples", example)] {
                if let Some(given) = plain(text) {
                    let given = if name == "examples" {
                        json!([given])
                    } else {
                        given
                    };
                    object.insert(name.into(), given);
                }
            }
        }
        properties.insert(key.name.into(), value);
    }
    let required: Vec<&str> = section
        .keys
        .iter()
        .filter(|key| key.required)
        .map(|key| key.name)
        .collect();
    json!({ "type": "object", "properties": properties, "required": required, "additionalProperties": false })
}

/// A value in YAML as one in JSON; nothing of an empty text.
fn plain(text: &str) -> Option<Value> {
    fn value(node: &Node) -> Value {
        match &node.kind {
            Found::Null => Value::Null,
            Found::Seq(items) => items.iter().map(value).collect(),
            Found::Map(entries) => {
                let entry = |entry: &yaml::Entry| (entry.key.text.clone(), value(&entry.value));
                Value::Object(entries.iter().map(entry).collect())
            }
            Found::Scalar(scalar) => {
                let whole = scalar.text.parse::<u64>().ok().map(Value::from);
                let number = || scalar.text.parse::<f64>().ok().map(Value::from);
                whole
                    .or_else(number)
                    .unwrap_or_else(|| Value::from(scalar.text.clone()))
            }
        }
    }
    let tree = yaml::read(text, FileId(0))
        .ok()
        .filter(|_| !text.is_empty())?;
    Some(value(&tree))
}

fn kind(kind: &'static Kind, sections: &mut Map<String, Value>) -> Value {
    match kind {
        Kind::Text => json!({ "type": "string" }),
        Kind::Count => json!({ "type": "integer", "minimum": 0 }),
        Kind::Choice(words) => json!({ "enum": words }),
        Kind::Quantity | Kind::Expression => json!({ "type": ["number", "string"] }),
        Kind::Formula => {
            sections.entry("formula").or_insert_with(|| {
                let functions: Vec<String> = functions().map(Entry::signature).collect();
                json!({
                    "description": format!("an expression: text, a number, or a nested list of these; functions are {}", functions.join(", ")),
                    "anyOf": [{ "type": ["number", "string"] }, { "type": "array", "minItems": 1, "items": { "$ref": "#/$defs/formula" } }],
                })
            });
            json!({ "$ref": "#/$defs/formula" })
        }
        Kind::Grid => {
            sections.entry("grid").or_insert_with(|| {
                json!({
                    "description": "a number, or a nested list of numbers",
                    "anyOf": [{ "type": "number" }, { "type": "array", "minItems": 1, "items": { "$ref": "#/$defs/grid" } }],
                })
            });
            json!({ "$ref": "#/$defs/grid" })
        }
        Kind::List(item) => json!({ "type": "array", "items": self::kind(item, sections) }),
        Kind::Sweep => json!({
            "type": "object",
            "minProperties": 1,
            "additionalProperties": { "type": "array", "minItems": 1 },
        }),
        Kind::Named(value) | Kind::ByName(value) => json!({
            "type": "object",
            "propertyNames": { "pattern": "^[A-Za-z][A-Za-z0-9_]{0,63}$" },
            "additionalProperties": self::kind(value, sections),
        }),
        Kind::Either(kinds) => {
            json!({ "anyOf": kinds.iter().map(|one| self::kind(one, sections)).collect::<Vec<_>>() })
        }
        Kind::Section(below) => {
            let name = below
                .noun
                .trim_start_matches("an ")
                .trim_start_matches("a ")
                .replace(' ', "_");
            if !sections.contains_key(&name) {
                let value = section(below, sections);
                sections.insert(name.clone(), value);
            }
            json!({ "$ref": format!("#/$defs/{name}") })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_is_described_and_every_reference_resolves() {
        let schema = json_schema();
        let mut pending = vec![&schema];
        while let Some(value) = pending.pop() {
            if let Some(properties) = value.get("properties").and_then(Value::as_object) {
                assert!(
                    properties
                        .values()
                        .all(|key| key["description"].is_string()),
                    "{value}"
                );
            }
            if let Some(reference) = value.get("$ref").and_then(Value::as_str) {
                assert!(schema.pointer(&reference[1..]).is_some(), "{reference}");
            }
            match value {
                Value::Object(map) => pending.extend(map.values()),
                Value::Array(items) => pending.extend(items),
                _ => {}
            }
        }
    }
}
