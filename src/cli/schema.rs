//! The JSON Schema of what each command prints with `--json`.

use super::stop::Stop;
use super::{beside, init, inverse, keys, launch, limit, map, optimum, output, pulley, radii, shift, tune};
use clap::Args;
use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, SchemaGenerator};
use serde_json::{Map, Value, json};
use sheave::case::Resolved;
use sheave::result::{DriveResult, FailureReport, SCHEMA};
use std::path::PathBuf;

/// Print the JSON Schema of what a command prints with --json
///
/// One schema (draft 2020-12) for each command that has --json. It describes results and failures alike: an object with
/// the field `failure` is one of a command that did not work.
#[derive(Debug, Args)]
pub struct Arguments {
    /// The command; without it the commands that have a schema are listed
    #[arg(value_name = "COMMAND", conflicts_with = "out", value_parser = names())]
    command: Option<String>,
    /// Write every schema into this folder, as COMMAND.schema.json
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// Makes the schema of the command of that name.
type Describe = fn(&str) -> Value;

/// Commands that print an object, and its schema.
const COMMANDS: [(&str, Describe); 19] = [
    ("solve", schema::<Resolved, DriveResult<Resolved>>),
    ("limit", schema::<Resolved, limit::Found<'static>>),
    ("optimum", schema::<Resolved, optimum::Found>),
    ("init", schema::<Value, init::Object>),
    ("pulley", schema::<Resolved, pulley::Object<'static>>),
    ("size", schema::<Value, sheave::small::size::Sizing>),
    ("belt", schema::<Value, sheave::bench::belt::Properties>),
    ("radii", schema::<radii::Inputs, radii::Found>),
    ("dyno", schema::<Value, sheave::bench::dyno::Reduced>),
    ("drive", schema::<Resolved, sheave::equilibrium::DriveReport>),
    ("shift", schema::<Resolved, shift::Told<'static>>),
    ("launch", schema::<Resolved, launch::Told<'static>>),
    ("map", schema::<Resolved, map::Told<'static>>),
    ("tune", schema::<Resolved, tune::Told<'static>>),
    ("ramp", schema::<Resolved, inverse::Told<'static>>),
    ("helix", schema::<Resolved, inverse::Told<'static>>),
    ("beside", schema::<Resolved, beside::Both<'static>>),
    ("keys", schema::<(), keys::Keys>),
    ("compare", schema::<Value, sheave::bench::compare::Comparison>),
];

fn names() -> Vec<&'static str> {
    COMMANDS.iter().map(|(command, _)| *command).collect()
}

pub fn run(arguments: &Arguments) -> Result<(), Stop> {
    if let Some(folder) = &arguments.out {
        output::create_folder(folder)?;
        return COMMANDS.iter().try_for_each(|(command, schema)| {
            let text = output::json(&schema(command))?;
            output::write_file(folder, &format!("{command}.schema.json"), |to| to.write_all(text.as_bytes()))
        });
    }
    let asked = COMMANDS.iter().find(|(command, _)| Some(*command) == arguments.command.as_deref());
    output::print(&match asked {
        Some((command, schema)) => output::json(&schema(command))?,
        None => names().join("\n") + "\n",
    })
}

/// The schema of a command's object: what all objects have in common, and the fields of a result `R` or a failure.
fn schema<I: JsonSchema, R: JsonSchema>(command: &str) -> Value {
    let mut generator = SchemaSettings::draft2020_12().for_serialize().into_generator();
    let inputs = subschema::<I>(&mut generator);
    let result = subschema::<R>(&mut generator);
    let failure = subschema::<FailureReport>(&mut generator);
    let definitions: Map<String, Value> = generator.take_definitions(true);
    let nothing = json!({ "type": "object", "maxProperties": 0 });
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "$id": format!("{command}.schema.json"),
        "title": format!("sheave {command} --json"),
        "description": "What the command prints: a result, or with the field `failure` why there is none. SI units.",
        "type": "object",
        "required": ["schema", "command", "inputs", "warnings"],
        "properties": {
            "schema": { "const": SCHEMA },
            "command": { "const": command },
            "inputs": { "anyOf": [inputs, nothing] },
            "warnings": { "type": "array", "items": { "type": "string" } },
        },
        "if": { "required": ["failure"] },
        "then": { "required": ["converged"], "properties": { "converged": { "const": false }, "failure": failure } },
        "else": result,
        "$defs": definitions,
    })
}

fn subschema<T: JsonSchema>(generator: &mut SchemaGenerator) -> Value {
    generator.subschema_for::<T>().to_value()
}
