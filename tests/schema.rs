//! The JSON Schemas: the committed ones are those that the program prints, and what the commands print fits them.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use boon::{Compiler, Schemas};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::Command;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("schemas")
}

/// Standard output of a command, whatever its exit status.
fn printed(arguments: &[&str]) -> String {
    let mut command = Command::new(env!("CARGO_BIN_EXE_sheave"));
    let output = command.args(arguments).current_dir(env!("CARGO_MANIFEST_DIR")).output().unwrap();
    String::from_utf8(output.stdout).unwrap()
}

fn object(arguments: &[&str]) -> Value {
    let text = printed(arguments);
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{arguments:?}: {error}\n{text}"))
}

/// What does not fit the schema of its command; empty if all does.
fn misfit(object: &Value) -> String {
    let path = folder().join(format!("{}.schema.json", object["command"].as_str().unwrap()));
    let (mut schemas, mut compiler) = (Schemas::new(), Compiler::new());
    let schema = compiler.compile(path.to_str().unwrap(), &mut schemas).unwrap();
    schemas.validate(object, schema).err().map(|error| format!("{error:#}")).unwrap_or_default()
}

#[test]
fn committed_schemas_are_those_that_the_program_prints() {
    let listed = printed(&["schema"]);
    for command in listed.lines() {
        let path = folder().join(format!("{command}.schema.json"));
        let committed = std::fs::read_to_string(&path).unwrap_or_default();
        let now = printed(&["schema", command]);
        assert!(committed == now, "{} is out of date; write it anew with: sheave schema --out schemas", path.display());
    }
    let files = std::fs::read_dir(folder()).unwrap().count();
    assert_eq!(files, listed.lines().count(), "a schema of no command");
}

#[test]
fn what_commands_print_fits_their_schemas() {
    let gx9 = "examples/drive/gx9.toml";
    let few = ["--target", "3300 rpm", "--points", "9", "--check", "1", "--tol", "1e-4", "--json"];
    let ramp = [&["ramp", gx9][..], &few].concat();
    // The example's own flyweights are too light for a helix at this speed.
    let helix = [&["helix", gx9, "--set", "primary.actuator.mass=175 g"][..], &few].concat();
    let commands: [&[&str]; 15] = [
        &["solve", "--json", "--sensitivities"],
        &["solve", "--json", "--edition", "published", "--set", "operating_point.primary_torque=-5 N*m"],
        &["solve", "--json", "--set", "operating_point.primary_torque=0"],
        &["solve", "--json", "--swap", "belt.bending_stiffness for efficiency.overall = 0.96"],
        &["limit", "--json", "--tol", "1e-2"],
        &["optimum", "--json", "--tol", "1e-2"],
        &["init", "--json", "--set", "operating_point.secondary_axial_force=550 N"],
        &["pulley", "--json", "--tol", "1e-2"],
        &["belt", "examples/belts/cvtech.toml", "--json"],
        &["size", "examples/size/conveyor.toml", "--json"],
        &["radii", "--json", "--ratio", "1.2"],
        &["drive", gx9, "--speed", "2500 rpm", "--tol", "1e-4", "--json"],
        &["launch", gx9, "--points", "8", "--tol", "1e-4", "--json"],
        &ramp,
        &helix,
    ];
    for arguments in commands {
        let object = object(arguments);
        assert!(object.get("failure").is_none(), "{arguments:?}: {object:#}");
        assert_eq!(misfit(&object), "", "{arguments:?}");
    }
}

#[test]
fn failures_fit_the_schemas_too() {
    let commands: [&[&str]; 6] = [
        &["ramp", "examples/drive/gx9.toml", "--target", "9000 rpm", "--json"],
        &["launch", "--json"],
        &["solve", "--json", "--set", "belt.length=3 kg"],
        &["solve", "--json", "--set", "operating_point.primary_torque=900 N*m"],
        &["limit", "--json", "--edition", "none"],
        &["dyno", "no-such-file.csv", "--json"],
    ];
    for arguments in commands {
        let object = object(arguments);
        assert!(object.get("failure").is_some(), "{arguments:?}: {object:#}");
        assert_eq!(misfit(&object), "", "{arguments:?}");
    }
}

#[test]
fn a_wrong_object_does_not_fit() {
    let mut object = object(&["solve", "--json"]);
    assert_eq!(misfit(&object), "");
    object["primary"]["axial_force"] = Value::from("900 N");
    assert!(misfit(&object).contains("axial_force"), "{}", misfit(&object));
}
