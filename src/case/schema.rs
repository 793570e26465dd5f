//! The JSON Schema of a resolved case, from the one table of keys.

use super::file::SWAP;
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
        let mut sections = Map::new();
        for section in TABLE.chunk_by(|a, b| a.section() == b.section()) {
            let keys = section.iter().map(|entry| (entry.name().to_owned(), value(entry.doc, entry.kind)));
            match section {
                [entry, ..] if !entry.section().is_empty() => {
                    let keys: Map<String, Value> = keys.collect();
                    let object = json!({ "type": "object", "properties": keys, "additionalProperties": false });
                    sections.insert(entry.section().to_owned(), object);
                }
                _ => sections.extend(keys),
            }
        }
        let swap = "given constants that are unknown, and the outputs that are given in their place";
        sections
            .insert(SWAP.to_owned(), json!({ "description": swap, "type": "array", "items": { "type": "string" } }));
        json_schema!({
            "description": "A case as it was understood, in SI units.",
            "type": "object",
            "properties": sections,
            "additionalProperties": false,
        })
    }
}

fn value(doc: &str, kind: ValueKind) -> Value {
    match kind {
        ValueKind::Quantity { .. } => json!({ "description": doc, "type": "number" }),
        ValueKind::Choice { choices, .. } => {
            let names: Vec<&str> = choices.iter().map(|choice| choice.name).collect();
            json!({ "description": doc, "type": "string", "enum": names })
        }
    }
}
