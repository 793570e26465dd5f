//! What the commands about measurements share: their objects and how they end.

use super::output;
use super::stop::Stop;
use serde::Serialize;
use serde_json::{Map, Value};
use sheave::bench::{BenchError, Problem};
use sheave::result::SCHEMA;

/// The object of a command that has a result.
pub fn object(command: &str, inputs: Value, warnings: &[String], result: &impl Serialize) -> Result<String, Stop> {
    let mut object = head(command, inputs, warnings);
    let result = serde_json::to_value(result).map_err(|error| Stop::Write("JSON".into(), error.into()))?;
    match result {
        Value::Object(fields) => object.extend(fields),
        other => {
            object.insert("result".into(), other);
        }
    }
    output::json(&Value::Object(object))
}

fn head(command: &str, inputs: Value, warnings: &[String]) -> Map<String, Value> {
    let mut object = Map::new();
    object.insert("schema".into(), SCHEMA.into());
    object.insert("command".into(), command.into());
    object.insert("inputs".into(), inputs);
    object.insert("warnings".into(), warnings.into());
    object
}

/// Tells people of warnings.
pub fn warn(warnings: &[String]) {
    for warning in warnings {
        tracing::warn!("{warning}");
    }
}

/// Bad input: whoever asked for JSON gets an object, too.
pub fn refused(command: &str, json: bool, error: BenchError) -> Stop {
    let kind = match error.problem() {
        Problem::Read { .. } => "unreadable",
        Problem::NoData { .. } => "no_data",
        _ => "input",
    };
    let told = if json { failure(command, kind, &error.to_string(), error.advice()) } else { Ok(()) };
    told.err().unwrap_or_else(|| Stop::Refused(miette::Report::new(error)))
}

/// Prints the object of a command that failed.
pub fn failure(command: &str, kind: &str, message: &str, hint: Option<&str>) -> Result<(), Stop> {
    let mut object = head(command, Value::Object(Map::new()), &[]);
    object.insert("failure".into(), serde_json::json!({ "kind": kind, "message": message, "hint": hint }));
    output::print(&output::json(&Value::Object(object))?)
}
