//! The command line from outside: exit status, what goes to which stream, what is written where.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use serde_json::Value;
use std::path::Path;
use std::process::{Command, Output};

/// Runs the program.
fn sheave(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_sheave"));
    command.args(arguments).env_remove("RUST_LOG").env("NO_COLOR", "1");
    command.output().unwrap()
}

fn status(output: &Output) -> i32 {
    output.status.code().unwrap()
}

fn stdout(output: &Output) -> &str {
    std::str::from_utf8(&output.stdout).unwrap()
}

fn stderr(output: &Output) -> &str {
    std::str::from_utf8(&output.stderr).unwrap()
}

/// The one object on standard output: the parser refuses a second one.
fn object(output: &Output) -> Value {
    let value: Value = serde_json::from_str(stdout(output)).unwrap_or_else(|error| panic!("{error}: {output:?}"));
    assert!(value.is_object());
    value
}

fn case_file(folder: &Path, text: &str) -> String {
    let path = folder.join("case.toml");
    std::fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

#[test]
fn bad_input_is_status_2_with_nothing_on_standard_output() {
    let folder = tempfile::tempdir().unwrap();
    let file = case_file(folder.path(), "[belt]\nlength = \"3 kg\"\n");
    for (arguments, said) in [
        (vec!["solve", &file], vec!["case.toml:2:10", "belt.length", "3 kg", "a length", "857.2 mm"]),
        (vec!["solve", "no-such.toml"], vec!["no-such.toml", "cannot read"]),
        (vec!["solve", "."], vec!["cannot read"]),
        (vec!["solve", "--set", "belt.lenght=1"], vec!["belt.lenght", "belt.length", "--set:1:1"]),
        (vec!["solve", "--set", "belt.length"], vec!["KEY=VALUE"]),
        (vec!["solve", "--set", "sheave.half_angle=-1 deg"], vec!["sheave.half_angle", "-1 deg", "below 45 deg"]),
        (vec!["solve", "--set", "sheave.friction_coefficient=nan"], vec!["not a finite number"]),
        (vec!["solve", "--unset", "belt"], vec!["unknown key `belt`"]),
        (
            vec!["solve", "--set", "operating_point.slack_tension=1", "--set", "operating_point.tight_tension=2"],
            vec!["operating_point.slack_tension", "operating_point.tight_tension", "both given"],
        ),
        (vec!["solve", "--edition", "thesi"], vec!["published", "thesis", "consistent", "string"]),
        (vec!["solve", "--tol", "1"], vec!["1e-12", "1e-1"]),
        (vec!["solve", "--tol", "nan"], vec!["1e-12", "1e-1"]),
        (vec!["solve", "--order", "5"], vec!["4, 6 or 8"]),
        (vec!["solve", "--frobnicate"], vec!["--frobnicate"]),
        // A negative quantity is a value, and not an option.
        (vec!["launch", "examples/drive/gx9.toml", "--distance", "-3 m"], vec!["--distance -3 m", "not positive"]),
        (vec!["drive", "examples/drive/gx9.toml", "--speed", "-3 rpm"], vec!["--speed -3 rpm", "not positive"]),
        (vec!["ramp", "examples/drive/gx9.toml", "--target", "-3200 rpm"], vec!["-3200 rpm", "not positive"]),
        (vec!["frobnicate"], vec!["frobnicate"]),
        (vec![], vec!["Usage"]),
    ] {
        let output = sheave(&arguments);
        assert_eq!(status(&output), 2, "{arguments:?}: {output:?}");
        assert_eq!(stdout(&output), "", "{arguments:?}");
        // The message may be broken into lines.
        let message = stderr(&output).replace("\n  │", "").split_whitespace().collect::<Vec<_>>().join(" ");
        for part in said {
            assert!(message.contains(part), "{arguments:?} does not say {part}: {message}");
        }
    }
}

#[test]
fn a_file_that_is_not_text_is_bad_input() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("case.toml");
    std::fs::write(&path, [0xff, 0xfe, 0x00]).unwrap();
    let output = sheave(&["solve", path.to_str().unwrap()]);
    assert_eq!((status(&output), stdout(&output)), (2, ""));
    assert!(stderr(&output).contains("cannot read"));
}

#[test]
fn bad_input_with_json_is_one_object() {
    let output = sheave(&["solve", "--json", "--set", "belt.length=3 kg"]);
    assert_eq!(status(&output), 2);
    let object = object(&output);
    assert_eq!(object["schema"], 1);
    assert_eq!(object["converged"], false);
    assert!(object["failure"]["message"].as_str().unwrap().contains("`belt.length` = 3 kg"));
    assert!(stderr(&output).contains("wrong dimension"));
}

#[test]
fn help_names_every_key() {
    let help = sheave(&["solve", "--help"]);
    let keys = sheave(&["keys"]);
    for output in [&help, &keys] {
        assert_eq!((status(output), stderr(output)), (0, ""));
        for entry in &sheave::case::TABLE {
            let missing = !stdout(output).lines().any(|line| line.trim_start().starts_with(entry.name()));
            assert!(!missing, "{} is missing", entry.path);
        }
    }
    assert!(stdout(&help).contains("Exit status"));
    insta::assert_snapshot!("keys", stdout(&keys));
}

#[test]
fn a_solved_case_is_one_object() {
    let output = sheave(&["solve", "--json", "--tol", "1e-3"]);
    assert_eq!(status(&output), 0, "{output:?}");
    let object = object(&output);
    assert_eq!(object["converged"], true);
    assert_eq!(object["inputs"]["belt"]["length"], 0.8572);
    assert_eq!(object["solver"]["tolerance"], 1e-3);
}

#[test]
fn warnings_go_to_standard_error() {
    let published = sheave(&["solve", "--json", "--tol", "1e-3", "--edition", "published"]);
    assert_eq!((status(&published), &object(&published)["converged"]), (0, &Value::Bool(true)));
    assert!(stderr(&published).contains("Energy is not conserved"), "{}", stderr(&published));
    assert_eq!(stderr(&sheave(&["solve", "--json", "--tol", "1e-3"])), "");
}

#[test]
fn a_solved_case_is_summed_up() {
    let output = sheave(&["solve", "--tol", "1e-3", "--edition", "thesis", "-v"]);
    assert_eq!(status(&output), 0, "{output:?}");
    assert!(stdout(&output).contains("thesis") && stdout(&output).ends_with('\n'));
}

#[test]
fn results_are_written_whole() {
    let folder = tempfile::tempdir().unwrap();
    let results = folder.path().join("deep/results");
    let output = sheave(&["solve", "--tol", "1e-3", "--out", results.to_str().unwrap()]);
    assert_eq!(status(&output), 0, "{output:?}");
    let mut names: Vec<_> =
        std::fs::read_dir(&results).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    for name in ["profile.csv", "report.html", "result.json", "trajectory.png", "trajectory.svg"] {
        assert!(names.iter().any(|other| other == name), "{name}");
    }
    assert!(names.iter().all(|name| !name.ends_with(".part")));
    let page = std::fs::read_to_string(results.join("report.html")).unwrap();
    assert!(page.contains("<svg") && page.ends_with("</html>\n"));
    // It opens without a network and without other files.
    for outside in ["src=", "<script", "<link rel=\"stylesheet", "@import", "url("] {
        assert!(!page.contains(outside), "{outside}");
    }
    let result: Value = serde_json::from_str(&std::fs::read_to_string(results.join("result.json")).unwrap()).unwrap();
    assert_eq!(result["converged"], true);
}

#[test]
fn a_folder_that_cannot_be_made_is_status_1() {
    let folder = tempfile::tempdir().unwrap();
    let file = case_file(folder.path(), "");
    let output = sheave(&["solve", "--out", &format!("{file}/below")]);
    assert_eq!((status(&output), stdout(&output)), (1, ""));
    assert!(stderr(&output).contains("cannot write"));
}

#[test]
fn no_solution_is_status_3_with_its_reason() {
    // Far more torque than the clamp can carry.
    let hopeless =
        ["solve", "--json", "--tol", "1e-3", "--edition", "thesis", "--set", "operating_point.slack_tension=1 N"];
    let output = sheave(&hopeless);
    assert_eq!(status(&output), 3, "{output:?}");
    let object = object(&output);
    assert_eq!(object["converged"], false);
    assert_eq!(object["edition"], "thesis");
    assert_eq!(object["inputs"]["operating_point"]["slack_tension"], 1.0);
    assert!(stderr(&output).contains(object["failure"]["message"].as_str().unwrap()));
}

#[test]
fn derivations_are_printed_in_three_formats() {
    for (format, head) in
        [("text", "Derivation of the edition thesis"), ("markdown", "# "), ("latex", "\\documentclass")]
    {
        let output = sheave(&["derive", "--edition", "thesis", "--format", format]);
        assert_eq!(status(&output), 0, "{output:?}");
        let text = stdout(&output);
        assert!(
            text.starts_with(head) && ["(3.34)", "(3.40)", "(5.13)", "5.3.5"].iter().all(|step| text.contains(step))
        );
    }
    assert_eq!(status(&sheave(&["derive", "--edition", "thesi"])), 2);
    let page = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/docs/derivation.md")).unwrap();
    assert_eq!(
        stdout(&sheave(&["derive", "--format", "markdown"])),
        page,
        "write it anew with: cargo run -p sheave-eqgen -- write"
    );
}

#[test]
fn every_command_fails_with_one_object() {
    let wrong = "belt.length=3 kg";
    let slack = "operating_point.slack_tension=1 N";
    for (arguments, status_expected, kind) in [
        (vec!["solve", "--json", "--set", wrong], 2, "input"),
        (vec!["limit", "--json", "--set", wrong], 2, "input"),
        (vec!["optimum", "--json", "--set", wrong], 2, "input"),
        (vec!["init", "--json", "--set", wrong], 2, "input"),
        (vec!["init", "--json"], 2, "input"),
        (vec!["pulley", "--json", "--set", wrong], 2, "input"),
        (vec!["size", "--json", "--set", "input.diameter=3 kg"], 2, "input"),
        (vec!["radii", "--json", "--set", wrong], 2, "input"),
        (vec!["limit", "no such file", "--json"], 2, "unreadable"),
        (vec!["optimum", "--json", "--tol", "3"], 2, "usage"),
        (vec!["solve", "--json", "--edition", "fifth"], 2, "usage"),
        (vec!["solve", "--json", "--out", "somewhere"], 2, "usage"),
        (vec!["solve", "--json", "--tol", "1e-3", "--edition", "thesis", "--set", slack], 3, "no_solution"),
    ] {
        let output = sheave(&arguments);
        assert_eq!(status(&output), status_expected, "{arguments:?}: {}", stderr(&output));
        let object = object(&output);
        assert_eq!((&object["schema"], &object["command"]), (&1.into(), &arguments[0].into()), "{object}");
        assert!(object["inputs"].is_object() && object["warnings"].is_array(), "{object}");
        assert_eq!((&object["converged"], &object["failure"]["kind"]), (&false.into(), &kind.into()), "{object}");
        let (message, hint) = (&object["failure"]["message"], &object["failure"]["hint"]);
        assert!(message.as_str().is_some_and(|text| text.len() > 10), "{object}");
        assert!(hint.is_null() || hint.is_string(), "{object}");
    }
}

#[test]
fn every_result_is_one_object_of_one_family() {
    for arguments in [
        vec!["solve", "--json", "--tol", "1e-2"],
        vec!["limit", "--json", "--tol", "1e-2"],
        vec!["init", "--json", "--set", "operating_point.secondary_axial_force=550 N"],
        vec!["pulley", "--json", "--tol", "1e-2"],
        vec!["size", "--json", "--set", "input.diameter=100 mm"],
        vec!["radii", "--json", "--ratio", "1.2"],
        vec!["belt", "examples/belts/cvtech.toml", "--json"],
    ] {
        let output = sheave(&arguments);
        assert_eq!(status(&output), 0, "{arguments:?}: {}", stderr(&output));
        let object = object(&output);
        assert_eq!((&object["schema"], &object["command"]), (&1.into(), &arguments[0].into()), "{object}");
        assert!(object["inputs"].as_object().is_some_and(|inputs| !inputs.is_empty()), "{object}");
        assert!(object["warnings"].is_array() && object.get("failure").is_none(), "{object}");
    }
}

#[test]
fn what_programs_and_shells_ask_for() {
    let output = sheave(&["keys", "--json"]);
    let object = object(&output);
    let keys = object["keys"].as_array().unwrap();
    let key = |path: &str| keys.iter().find(|key| key["key"] == path).unwrap();
    assert_eq!(key("belt.length")["unit"], "mm");
    assert!(key("edition")["choices"].as_array().unwrap().iter().any(|choice| choice["name"] == "thesis"));
    for shell in ["bash", "zsh", "fish"] {
        let output = sheave(&["completions", shell]);
        assert!(String::from_utf8_lossy(&output.stdout).contains("work-limit"), "{shell}");
    }
    let page = sheave(&["man"]);
    assert!(String::from_utf8_lossy(&page.stdout).contains(".TH sheave"));
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(status(&sheave(&["man", "--out", folder.path().to_str().unwrap()])), 0);
    assert!(folder.path().join("sheave-solve.1").exists());
}

#[test]
fn summaries_are_in_the_units_asked_for() {
    let summary = |units: &str| {
        let output = sheave(&["solve", "--tol", "1e-3", "--units", units]);
        assert_eq!(status(&output), 0);
        String::from_utf8(output.stdout).unwrap()
    };
    let row = |text: &str, name: &str| {
        let line = text.lines().find(|line| line.trim_start().starts_with(name)).unwrap().to_owned();
        let value = line.replace(name, "").split_whitespace().next().unwrap().parse::<f64>().unwrap();
        (value, line.split_whitespace().last().unwrap().to_owned())
    };
    let (workshop, us, si) = (summary("workshop"), summary("us"), summary("si"));
    let (newtons, pounds) = (row(&workshop, "axial force"), row(&us, "axial force"));
    assert_eq!((newtons.1.as_str(), pounds.1.as_str()), ("N", "lbf"));
    assert!((newtons.0 / pounds.0 - 4.4482).abs() < 1e-3);
    assert_eq!(row(&si, "speed").1, "rad/s");
    assert!((row(&workshop, "largest penetration").0 / row(&us, "largest penetration").0 - 25.4).abs() < 0.5);
    assert_eq!(status(&sheave(&["solve", "--units", "furlongs"])), 2);
}

#[test]
fn cases_stand_side_by_side_and_tables_are_drawn() {
    let other = ["beside", "--tol", "1e-3", "--set", "operating_point.slack_tension=150 N"];
    let output = sheave(&other);
    let text = String::from_utf8(output.stdout.clone()).unwrap();
    let line = text.lines().find(|line| line.contains("slack tension")).unwrap();
    let cells: Vec<&str> = line.split_whitespace().collect();
    assert_eq!(cells, ["slack", "tension", "100.0", "150.0", "+50.0", "N"]);
    let object = object(&sheave(&[&other[..], &["--json"]].concat()));
    assert_eq!(object["second"]["inputs"]["operating_point"]["slack_tension"], 150.0);
    let folder = tempfile::tempdir().unwrap();
    let (table, figures) = (folder.path().join("table.csv"), folder.path().join("figures"));
    let (table, figures) = (table.to_str().unwrap(), figures.to_str().unwrap());
    let grid = ["--over", "operating_point.primary_torque=6,18", "--over", "drive.ratio=0.9..1.2:3"];
    assert_eq!(status(&sheave(&[&["sweep", "--tol", "1e-2", "--out", table], &grid[..]].concat())), 0);
    assert_eq!(status(&sheave(&["plot", table, "--out", figures])), 0);
    let svg = std::fs::read_to_string(folder.path().join("figures/efficiency_overall.svg")).unwrap();
    assert!(svg.contains("= 18 N·m") && svg.contains("ratio") && svg.contains("overall efficiency"), "{svg}");
    let svg = std::fs::read_to_string(folder.path().join("figures/primary_axial_force.svg")).unwrap();
    assert!(svg.contains("primary axial force") && svg.contains("(N)"), "{svg}");
    let refused = sheave(&["plot", table, "--y", "no.such", "--out", figures]);
    assert_eq!(status(&refused), 2);
    assert!(stderr(&refused).contains("no column `no.such`"));
}

/// An interrupt ends a solve that would take long, with its own status and nothing on standard output but the object.
#[cfg(unix)]
#[test]
fn an_interrupt_ends_a_command_in_order() {
    let grid = ["sweep", "--over", "operating_point.slack_tension=100..200 N:200000", "--tol", "1e-7"];
    let mut child = Command::new(env!("CARGO_BIN_EXE_sheave"))
        .args(grid)
        .stdout(std::process::Stdio::piped())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    let mut lines = std::io::BufRead::lines(std::io::BufReader::new(child.stdout.take().unwrap()));
    for _ in 0..3 {
        lines.next().unwrap().unwrap();
    }
    let interrupt = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(interrupt.success());
    for line in lines {
        assert!(line.unwrap().contains("true"));
    }
    assert_eq!(child.wait().unwrap().code(), Some(130));
}

#[test]
fn a_command_refuses_what_it_would_not_use() {
    let swap = "belt.bending_stiffness for efficiency.overall = 0.9";
    for command in ["drive", "shift", "launch", "init", "radii"] {
        let output = sheave(&[command, "examples/drive/gx9.toml", "--swap", swap]);
        assert_eq!(status(&output), 2, "{command}");
        assert!(stderr(&output).contains("expected a case without swap"), "{command}: {}", stderr(&output));
    }
    let range = ["shift", "examples/drive/gx9.toml", "--from", "3000 rpm", "--to", "2000 rpm"];
    let output = sheave(&range);
    assert_eq!(status(&output), 2);
    assert!(stderr(&output).contains("--from is 3000 rpm and --to is 2000 rpm"), "{}", stderr(&output));
}

/// Far below the speed at which the belt takes off it slips like a clutch, whatever share of its friction is left.
#[test]
fn a_belt_that_slips_like_a_clutch_is_told_as_slipping() {
    let at = |speed: &str| {
        object(&sheave(&["drive", "examples/drive/gx9.toml", "--tol", "1e-4", "--speed", speed, "--json"]))
    };
    let (slow, shifting) = (at("600 rpm"), at("3000 rpm"));
    assert!(
        slow["speed_efficiency"].as_f64().unwrap() < 0.8 && slow["primary_travel"].as_f64().unwrap() < -1e-3,
        "{slow}"
    );
    assert_eq!((&slow["slipping"], &shifting["slipping"]), (&Value::Bool(true), &Value::Bool(false)));
    let warned = |object: &Value| object["warnings"].to_string().contains("slips like a clutch");
    assert!(warned(&slow) && !warned(&shifting), "{slow}");
    // A whole curve says so as well.
    let throttle = ["--set", "engine.throttle=0.2", "--tol", "1e-4", "--points", "8", "--json"];
    for command in [&["shift", "--direction", "up"][..], &["launch"]] {
        let curve = object(&sheave(&[command, &["examples/drive/gx9.toml"], &throttle].concat()));
        assert!(warned(&curve), "{curve}");
    }
}

/// A table of a part is used beyond its ends, and that is said.
#[test]
fn a_table_that_ends_before_its_sheave_is_told() {
    let varying = |openings: &str, angles: &str| {
        let (openings, angles) = (
            format!("secondary.actuator.helix_openings={openings}"),
            format!("secondary.actuator.helix_angles={angles}"),
        );
        let drive = ["examples/drive/gx9.toml", "--unset", "secondary.actuator.helix_angle", "--tol", "1e-4", "--json"];
        let set = ["--set", &openings, "--set", &angles];
        let one = sheave(&[&["drive", "--speed", "2500 rpm"], &drive[..], &set].concat());
        let curve = sheave(&[&["shift", "--direction", "up", "--points", "4"], &drive[..], &set].concat());
        [one, curve].map(|output| object(&output)["warnings"].to_string())
    };
    let told = varying("0, 3, 5 mm", "38, 38, 38 deg");
    for (warnings, stands) in told.iter().zip(["stands at", "travels from"]) {
        let said =
            format!("`secondary.actuator.helix_openings` is given from 0.00 to 5.00 mm, and the sheave {stands}");
        assert!(warnings.contains(&said), "{told:?}");
    }
    let whole = varying("0, 10, 20 mm", "38, 38, 38 deg");
    assert!(whole.iter().all(|warnings| !warnings.contains("is given from")), "{whole:?}");
}

/// Without a power in, nothing is a share of it; in engine braking the secondary is the pulley that drives.
#[test]
fn what_has_no_torque_has_no_share_and_braking_turns_the_pulleys_round() {
    let none = object(&sheave(&["solve", "--tol", "1e-3", "--set", "operating_point.primary_torque=0", "--json"]));
    assert_eq!((&none["energy"]["imbalance"], &none["energy"]["closure"]), (&Value::Null, &Value::Null));
    let set = ["operating_point.primary_torque=-18 N*m", "operating_point.slack_tension=500 N"];
    let braking = object(&sheave(&["pulley", "--tol", "1e-3", "--set", set[0], "--set", set[1], "--json"]));
    for (pulley, sign) in [("primary", -1.0), ("secondary", -1.0)] {
        let number = |name: &str| braking[pulley][name].as_f64().unwrap();
        assert!(number("tight_tension") > number("slack_tension"), "{braking}");
        assert!(number("torque") * sign > 0.0 && number("full_torque") * sign > 0.0, "{braking}");
        assert!((number("torque") / number("full_torque") - 1.0).abs() < 0.15, "{braking}");
    }
}

/// So does one of any other command that solves: its one object says that it was cancelled.
#[cfg(unix)]
#[test]
fn an_interrupted_command_says_so_in_its_object() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let curve = ["shift", "examples/drive/gx9.toml", "--points", "2000", "--tol", "1e-8", "-v", "--json"];
    let launch = ["launch", "examples/drive/gx9.toml", "-v", "--json"];
    let chapters = ["reproduce", "--points", "1000", "--out", out, "-v"];
    for command in [&curve[..], &launch[..], &chapters[..]] {
        let mut child = Command::new(env!("CARGO_BIN_EXE_sheave"))
            .args(command)
            .current_dir(env!("CARGO_MANIFEST_DIR"))
            .stdout(std::process::Stdio::piped())
            .stderr(std::process::Stdio::piped())
            .spawn()
            .unwrap();
        let mut lines = std::io::BufRead::lines(std::io::BufReader::new(child.stderr.take().unwrap()));
        lines.find(|line| line.as_ref().is_ok_and(|line| line.contains("stage 1"))).unwrap().unwrap();
        let interrupt = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
        assert!(interrupt.success());
        let said: Vec<String> = lines.map_while(Result::ok).collect();
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(130), "{command:?}: {said:?}");
        assert!(said.iter().any(|line| line.starts_with("stopping")), "{command:?}: {said:?}");
        if command.contains(&"--json") {
            let object: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
            assert_eq!(object["failure"]["kind"], "cancelled", "{object}");
        }
    }
}

/// A map of another belt, parts that no box has and shares in percent: what `tune`, `ramp` and `helix` say.
#[test]
fn what_a_search_for_a_tune_cannot_take_is_status_2() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let example = |name: &str| format!("{}/examples/drive/{name}", env!("CARGO_MANIFEST_DIR"));
    let (gx9, parts, map) = (example("gx9.toml"), example("gx9-parts.toml"), path("map.csv"));
    let over = ["ratio=1..1.1:2", "torque=20 N*m..25 N*m:2", "speed=3300 rpm..3500 rpm:2", "slack_tension=150..200:2"];
    let mut arguments = vec!["map", &gx9, "--losses", "off", "--accuracy", "0.5", "--out", &map];
    over.iter().for_each(|over| arguments.extend(["--over", over]));
    let made = sheave(&arguments);
    assert_eq!(status(&made), 0, "{made:?}");
    let boxed = |text: &str| {
        std::fs::write(path("parts.toml"), text).unwrap();
        path("parts.toml")
    };
    let said = |arguments: &[&str]| {
        let output = sheave(arguments);
        assert_eq!(status(&output), 2, "{arguments:?}: {output:?}");
        stderr(&output).split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let tune = |more: &[&str]| {
        let mut arguments = vec!["tune", gx9.as_str(), "--target", "3400 rpm"];
        arguments.extend(more);
        said(&arguments)
    };
    let given = ["--parts", &parts, "--map", &map];
    let losses = tune(&given);
    let expected = format!("{map}: the map was made with `losses.include` = \"off\", and the case has \"on\"");
    assert!(losses.contains(&expected), "{losses}");
    let friction = tune(&[&given[..], &["--losses", "off", "--set", "sheave.friction_coefficient=0.2"]].concat());
    let expected = format!("{map}: the map was made with `sheave.friction_coefficient` = ");
    assert!(friction.contains(&expected) && friction.contains("and the case has 0.2"), "{friction}");
    // Of its own case the map is taken: it reaches as far as it does, and that is no fault of the question.
    let own = sheave(&["tune", &gx9, "--target", "3400 rpm", "--parts", &parts, "--map", &map, "--losses", "off"]);
    assert_eq!(status(&own), 3, "{own:?}");
    let mass = tune(&["--parts", &boxed("[a]\nprimary.actuator.mass = [\"1 m\", \"2 g\"]")]);
    assert!(mass.contains("`primary.actuator.mass` = 1 m") && mass.contains("expected a mass"), "{mass}");
    let belt = tune(&["--parts", &boxed("[a]\nb = { belt.bending_stiffness = \"0.5 N*m^2\" }")]);
    assert!(belt.contains("`a` sets `belt.bending_stiffness`: expected keys of [primary.actuator]"), "{belt}");
    let share = tune(&["--parts", &parts, "--least-reserve", "140%"]);
    assert!(share.contains("the least slip reserve is 1.4: expected a share from 0 to below 1"), "{share}");
    let share = tune(&["--parts", &parts, "--least-reserve", "much"]);
    assert!(share.contains("expected a share such as 0.3 or 30%"), "{share}");
    let target = said(&["tune", &gx9, "--target", "340 rpm", "--parts", &parts]);
    assert!(target.contains("the target is 340 rpm: expected a speed above"), "{target}");
    for command in ["ramp", "helix"] {
        let share = said(&[command, &gx9, "--target", "3400 rpm", "--reserve", "140%"]);
        assert!(share.contains("1.4") && share.contains("expected a share from 0 to below 1"), "{command}: {share}");
        let share = said(&[command, &gx9, "--target", "3400 rpm", "--reserve", "3 kg"]);
        assert!(share.contains("expected a share such as 0.3 or 30%"), "{command}: {share}");
    }
}

/// What the contract of the command line names of a shift curve.
#[test]
fn a_shift_curve_has_what_other_programs_read() {
    let arguments =
        ["shift", "examples/drive/gx9.toml", "--direction", "up", "--points", "8", "--tol", "1e-3", "--json"];
    let output = sheave(&arguments);
    assert_eq!(status(&output), 0, "{}", stderr(&output));
    let object = object(&output);
    assert!(object["engagement_speed"].as_f64().is_some_and(|speed| speed > 100.0), "{object}");
    let points = object["points"].as_array().unwrap();
    let mut phases: Vec<&str> = points.iter().map(|point| point["phase"].as_str().unwrap()).collect();
    phases.dedup();
    assert_eq!(phases, ["engagement", "low", "shift", "high"]);
    for point in points {
        assert_eq!(point["direction"], "up");
        let number = |name: &str| point[name].as_f64().unwrap_or_else(|| panic!("{name}: {point}"));
        for name in ["ratio", "vehicle_speed", "primary_axial_force", "secondary_axial_force", "primary_torque"] {
            assert!(number(name) > 0.0, "{name}: {point}");
        }
        assert!(number("efficiency") < 1.0 && number("slip_reserve") < 1.0, "{point}");
        let speeds = number("primary_speed") / number("secondary_speed");
        assert!((number("speed_ratio") - speeds).abs() < 1e-12 * speeds, "{point}");
    }
}

/// What is wrong with the arguments is said before anything is made, and costs no work.
#[test]
fn arguments_are_refused_before_folders_are_made() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("made");
    let made = out.to_str().unwrap();
    let table = folder.path().join("table.csv");
    std::fs::write(
        &table,
        "belt.bending_stiffness,converged,efficiency.overall,failure\n0.1,true,0.9,\n0.2,false,,lost\n",
    )
    .unwrap();
    let table = table.to_str().unwrap();
    let semicolons = folder.path().join("semicolons.csv");
    std::fs::write(&semicolons, "a;b\n1;2\n").unwrap();
    let semicolons = semicolons.to_str().unwrap();
    let gx9 = "examples/drive/gx9.toml";
    let no_drive = case_file(folder.path(), "");
    for (arguments, said) in [
        (vec!["helix", gx9, "--target", "3800 rpm", "--points", "1", "--out", made], "from 5 to 1000"),
        (vec!["shift", gx9, "--compare", &no_drive, "--out", made], "actuators"),
        (vec!["plot", table, "--y", "failure", "--out", made], "column `failure` holds `lost`"),
        (vec!["plot", semicolons, "--out", made], "one of the columns (separated by commas): `a;b`"),
    ] {
        let output = sheave(&arguments);
        assert_eq!(status(&output), 2, "{arguments:?}: {output:?}");
        assert!(stderr(&output).contains(said), "{arguments:?}: {}", stderr(&output));
        assert!(!out.exists(), "{arguments:?}");
    }
    let output = sheave(&["plot", table, "--y", "efficiency.overall", "--out", made]);
    assert_eq!(status(&output), 0, "{output:?}");
}

/// A drive without an equilibrium tells programs what was understood, and apart from what happened what to try.
#[test]
fn a_drive_that_has_no_equilibrium_says_what_to_try() {
    let output = sheave(&["drive", "examples/drive/gx9.toml", "--speed", "20000 rpm", "--json"]);
    assert_eq!(status(&output), 3, "{output:?}");
    let object = object(&output);
    assert_eq!(object["inputs"]["belt"]["length"], 0.834, "{object}");
    let failure = &object["failure"];
    assert!(failure["message"].as_str().is_some_and(|message| message.contains("12048 rpm")), "{object}");
    assert!(failure["hint"].as_str().is_some_and(|hint| hint.starts_with("try a lower speed")), "{object}");
    assert!(stderr(&output).contains("try a lower speed"), "{output:?}");
}

/// The best clamp does not depend on the one that the case has, not even where that is a margin against slip.
#[test]
fn the_best_clamp_is_sought_beside_a_margin() {
    let best = |arguments: &[&str]| {
        let output = sheave(arguments);
        assert_eq!(status(&output), 0, "{output:?}");
        object(&output)["slack_tension"].as_f64().unwrap_or_else(|| panic!("{output:?}"))
    };
    let margin = ["optimum", "--set", "operating_point.slip_reserve=30%", "--tol", "1e-5", "--json"];
    let difference = best(&margin) / best(&["optimum", "--tol", "1e-5", "--json"]) - 1.0;
    assert!(difference.abs() < 1e-3, "{difference}");
}

/// Measured points that no part of the curve lies beside are counted.
#[test]
fn measured_points_beyond_the_curve_are_told() {
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("line.csv");
    let warned = |rows: &str| {
        std::fs::write(&data, format!("secondary_rpm,primary_rpm,direction\n{rows}")).unwrap();
        let arguments = ["shift", "examples/drive/gx9.toml", "--direction", "up", "--tol", "1e-4", "--points", "4"];
        let output = sheave(&[&arguments[..], &["--json", "--data", data.to_str().unwrap()]].concat());
        assert_eq!(status(&output), 0, "{output:?}");
        object(&output)["warnings"].to_string()
    };
    let told = warned("2000,3000,up\n3000,3100,\n30000,3900,up\n30000,3900,back\n");
    assert!(told.contains("1 of 3 measured points, up, lie beyond the ends of the curve"), "{told}");
    let told = warned("2000,3000,up\n3000,3100,up\n");
    assert!(!told.contains("beyond the ends of the curve"), "{told}");
}

/// Few points of a curve, many measured ones: how much of the difference is owed to lines is told, and is about right.
#[test]
fn what_interpolation_adds_to_a_difference_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("line.csv");
    let line: Vec<String> = (0..40).map(|at| format!("{},3000", 1200.0 + 50.0 * f64::from(at))).collect();
    std::fs::write(&data, format!("secondary_rpm,primary_rpm\n{}\n", line.join("\n"))).unwrap();
    let at = |points: &str| {
        let data = data.to_str().unwrap();
        let arguments = ["shift", "examples/drive/gx9.toml", "--direction", "up", "--tol", "1e-4", "--json"];
        let output = sheave(&[arguments.as_slice(), &["--data", data, "--points", points]].concat());
        assert_eq!(status(&output), 0, "{output:?}");
        let object = object(&output);
        let of = |name: &str| object["branches"][0]["deviation"][name].as_f64().unwrap();
        (of("mean"), of("interpolation"), object["warnings"].to_string().contains("so few points"))
    };
    let (coarse, fine) = (at("6"), at("48"));
    let moved = (coarse.0 - fine.0).abs();
    assert!(coarse.2 && !fine.2 && fine.1 < 0.1 * coarse.1, "{coarse:?} {fine:?}");
    assert!((0.2..5.0).contains(&(coarse.1 / moved)), "{coarse:?} {fine:?}");
}
