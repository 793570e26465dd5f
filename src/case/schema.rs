//! The JSON Schema of a resolved case, from the one table of keys.

use super::given::SWAP;
use super::keys::{TABLE, ValueKind};
use super::resolve::Resolved;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde_json::{Map, Value, json};
use std::borrow::Cow;

impl JsonSchema for Resolved {
    fn schema_name() -> Cow<'static, str> {
        "Case".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let mut keys = Map::new();
        for entry in &TABLE {
            insert(&mut keys, entry.path, value(entry.doc, entry.kind));
        }
        let swap = "given constants that are unknown, and the outputs that are given in their place";
        keys.insert(SWAP.to_owned(), json!({ "description": swap, "type": "array", "items": { "type": "string" } }));
        json_schema!({
            "description": "A case as it was understood, in SI units.",
            "type": "object",
            "properties": keys,
            "additionalProperties": false,
        })
    }
}

/// Puts the schema of a key where its dots say: `belt.length` into the properties of the object `belt`.
fn insert(keys: &mut Map<String, Value>, path: &str, schema: Value) {
    let Some((section, rest)) = path.split_once('.') else {
        keys.insert(path.to_owned(), schema);
        return;
    };
    let object = keys
        .entry(section)
        .or_insert_with(|| json!({ "type": "object", "properties": {}, "additionalProperties": false }));
    if let Some(inner) = object.get_mut("properties").and_then(Value::as_object_mut) {
        insert(inner, rest, schema);
    }
}

fn value(doc: &str, kind: ValueKind) -> Value {
    let numbers = json!({ "type": "array", "items": { "type": "number" } });
    match kind {
        // A key that may depend on frequency and temperature is a table where it does.
        ValueKind::Quantity { .. } => json!({ "description": doc, "anyOf": [{ "type": "number" }, {
            "type": "object",
            "required": ["value"],
            "properties": {
                "frequency": numbers,
                "temperature": numbers,
                "value": { "type": "array", "items": { "anyOf": [{ "type": "number" }, numbers] } },
            },
            "additionalProperties": false,
        }] }),
        ValueKind::List { .. } => json!({ "description": doc, "type": "array", "items": { "type": "number" } }),
        ValueKind::Choice { choices, .. } => {
            let names: Vec<&str> = choices.iter().map(|choice| choice.name).collect();
            json!({ "description": doc, "type": "string", "enum": names })
        }
    }
}
