//! What every command's `--json` has in common: `schema`, `command`, `inputs`, `warnings`, and `failure` where it did
//! not work.

use super::SCHEMA;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

/// What kind of failure ended a command.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum FailureKind {
    /// Arguments that the command does not understand; nothing was computed.
    Usage,
    /// Something given is wrong; nothing was computed.
    Input,
    /// A file cannot be read.
    Unreadable,
    /// Nothing in the measurements can be used.
    NoData,
    /// There is no solution, or none was found.
    NoSolution,
    /// Stopped by Ctrl-C.
    Cancelled,
    /// A result could not be written.
    Output,
    /// A defect of the program.
    Internal,
}

/// Why there is no result.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct FailureReport {
    /// Of what kind.
    pub kind: FailureKind,
    /// What is wrong: the key, what was given, what is expected; or what happened to the belt.
    pub message: String,
    /// What to try, where there is more to say than the message says.
    pub hint: Option<String>,
}

/// The object of a command: the fields that all have in common, then those of `result`, an object of which `schema` and
/// `inputs` may be part.
///
/// # Errors
/// What the serialisation of `inputs` or `result` says.
pub fn envelope(
    command: &str,
    inputs: &impl Serialize,
    warnings: &[String],
    result: &impl Serialize,
) -> Result<Value, serde_json::Error> {
    let mut object = head(command, serde_json::to_value(inputs)?, warnings);
    match serde_json::to_value(result)? {
        Value::Object(fields) => object.extend(fields),
        other => {
            object.insert("result".into(), other);
        }
    }
    Ok(Value::Object(object))
}

/// The object of a command that did not work, with `"converged": false`; `known` is what can be said nevertheless, such
/// as the `inputs`.
///
/// # Errors
/// What the serialisation of `known` says.
pub fn failed(command: &str, known: &impl Serialize, failure: &FailureReport) -> Result<Value, serde_json::Error> {
    let mut object = head(command, Value::Object(Map::new()), &[]);
    object.insert("converged".into(), false.into());
    if let Value::Object(fields) = serde_json::to_value(known)? {
        object.extend(fields);
    }
    object.insert("failure".into(), serde_json::to_value(failure)?);
    Ok(Value::Object(object))
}

fn head(command: &str, inputs: Value, warnings: &[String]) -> Map<String, Value> {
    let mut object = Map::new();
    object.insert("schema".into(), SCHEMA.into());
    object.insert("command".into(), command.into());
    object.insert("inputs".into(), inputs);
    object.insert("warnings".into(), warnings.into());
    object
}
