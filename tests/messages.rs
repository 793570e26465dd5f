//! Every message that a user may meet, word for word: what was typed, the exit status, and what is said.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::fmt::Write;
use std::io::Write as _;
use std::process::{Command, Output, Stdio};

fn run(arguments: &[&str], input: &str, folder: &std::path::Path) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_sheave"));
    command.args(arguments).current_dir(folder).env_remove("RUST_LOG").env("NO_COLOR", "1").env("COLUMNS", "110");
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    child.stdin.take().unwrap().write_all(input.as_bytes()).unwrap();
    child.wait_with_output().unwrap()
}

/// What was said, without the ends of lines that are blank.
fn told(output: &Output) -> String {
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    text.lines().map(|line| line.trim_end().to_owned() + "\n").collect()
}

fn transcript(commands: &[(&[&str], &str)]) -> String {
    transcript_in(tempfile::tempdir().unwrap().path(), commands)
}

fn transcript_in(folder: &std::path::Path, commands: &[(&[&str], &str)]) -> String {
    let mut text = String::new();
    for (arguments, input) in commands {
        let output = run(arguments, input, folder);
        writeln!(text, "$ sheave {}", arguments.join(" ").escape_debug()).unwrap();
        if !input.is_empty() {
            let shown: String = input.escape_debug().take(100).collect();
            writeln!(text, "< {shown}").unwrap();
        }
        let status = output.status.code().unwrap();
        writeln!(text, "? {status}\n{}", told(&output)).unwrap();
        assert!(!text.contains('\u{1b}'), "an escape reaches the terminal: {text:?}");
    }
    text
}

#[test]
fn inputs_that_do_not_mean_what_they_say() {
    let all: &[(&[&str], &str)] = &[
        (&["solve", "--set", "operating_point.primary_speed=3400"], ""),
        (&["solve", "--set", "operating_point.slack_tension=60 lb"], ""),
        (&["solve", "--set", "operating_point.primary_torque=60 lb*ft"], ""),
        (&["solve", "--set", "sheave.friction_coefficient=0.4 1"], ""),
        (&["solve", "--set", "operating_point.slip_reserve=120 %"], ""),
        (&["solve", "--reserve", "20%", "--set", "drive.free=both"], ""),
        (&["solve", "-"], "[sweep]\nover = [\"drive.ratio=1,2\"]\n"),
        (&["sweep", "--over", "drive.ratoi=1..2:3"], ""),
        (&["sweep", "--over", "belt.length=1..2 N:3"], ""),
        (&["limit", "--set", "operating_point.slip_reserve=0.2"], ""),
        (&["size", "--set", "input.diameter=1e308 mm", "--set", "linear.mass=1e300 kg"], ""),
        (&["solve", "-"], "[belt]\nlength = \"3 kg\"\nlenght = 3\n[sheave]\nhalf_angle = \"50 deg\"\n"),
        (&["solve", "-"], "\u{feff}[belt]\nlength = \"3 kg\"\n"),
    ];
    insta::assert_snapshot!("inputs", transcript(all));
}

#[test]
fn nothing_of_a_text_reaches_the_terminal_raw() {
    let long = format!("[belt]\nlength = \"{} kg\"\n", "1".repeat(70_000));
    let far = format!("a = [{}]\n[belt]\nlength = 3\n", "1,".repeat(40_000));
    let column = format!("belt = {{ {} length = \"3 kg\" }}\n", " ".repeat(70_000));
    let all: &[(&[&str], &str)] = &[
        (&["solve", "-"], &column),
        (&["init", "-"], &column),
        (&["solve", "--set", "belt.length=\u{1b}[31mred"], ""),
        (&["solve", "--set", "\u{1b}]0;title\u{7}=1"], ""),
        (&["solve", "--edition", "\u{1b}[2Jthesis"], ""),
        (&["solve", "no\u{1b}[31mfile.toml"], ""),
        (&["sweep", "--over", "drive.ratio=1,\u{9b}31m"], ""),
        (&["sweep", "--over", "drive.ratio=1,2", "--out", "no\u{1b}[31mfolder/a.csv"], ""),
        (&["solve", "-"], "# \u{202e}\n[belt]\nlength = \"\\u001b[31m\"\n\"\u{202e}\" = 3\n"),
        (&["size", "--set", "input.diameter=\u{1b}[31m"], ""),
        (&["solve", "-"], &long),
        (&["solve", "-"], &far),
        (&["sweep", "-"], &far),
    ];
    insta::assert_snapshot!("escapes", transcript(all));
}

#[test]
fn results_that_need_a_warning_have_it() {
    let warned = |arguments: &[&str]| {
        let output = run(arguments, "", &std::env::temp_dir());
        assert_eq!(output.status.code(), Some(0), "{arguments:?}: {output:?}");
        let summary = String::from_utf8_lossy(&output.stdout).into_owned();
        let lines = summary.lines().filter(|line| line.trim_start().starts_with("warning:"));
        told(&output) + &lines.collect::<Vec<_>>().join("\n")
    };
    let base = ["solve", "--tol", "1e-3"];
    let set = |settings: &[&'static str]| {
        let settings = settings.iter().flat_map(|setting| ["--set", setting]);
        warned(&base.into_iter().chain(settings).collect::<Vec<_>>())
    };
    assert_eq!(set(&[]), "");
    assert!(set(&["drive.primary_radius=68 mm"]).contains("Only `drive.primary_radius` is given"));
    let contradicts = set(&["belt.length=950 mm", "drive.primary_radius=68.3 mm", "drive.secondary_radius=68.3 mm"]);
    assert!(contradicts.contains("`belt.length` = 950.0 mm contradicts the radii"), "{contradicts}");
    assert!(set(&["edition=published"]).contains("the doing of the equations of edition `published`"));
    let stiff = set(&["belt.bending_stiffness=5", "operating_point.primary_torque=5"]);
    assert!(stiff.contains("by its speed alone"), "{stiff}");
    let slow = set(&["operating_point.primary_speed=300 rpm", "operating_point.slack_tension=1 N"]);
    assert!(slow.contains("The belt is in compression"), "{slow}");
    let idle = set(&["operating_point.primary_torque=0.1"]);
    assert!(idle.contains("The secondary has to be driven") && !idle.contains("Energy is not conserved"), "{idle}");
    // Without torque no power goes into the primary, and nothing is told as a share of it.
    let unloaded = set(&["operating_point.primary_torque=0", "edition=published"]);
    assert!(unloaded.contains("there is no efficiency to tell") && unloaded.contains(" W out (9"), "{unloaded}");
    let soft = set(&["belt.radial_stiffness=0.5 MPa", "operating_point.slack_tension=500 N"]);
    assert!(soft.contains("of its radius"), "{soft}");
    assert!(warned(&["solve", "--tol", "1e-3", "--sensitivities"]).contains("without either it shows nothing"));
}

/// A line whose numbers are cut after three decimals, so that the next ones, which the mesh decides, are not compared.
fn shortened(line: &str) -> String {
    let mut decimals = None;
    let kept = |character: &char| {
        decimals = match (*character, decimals) {
            ('.', _) => Some(0),
            ('0'..='9', Some(count)) => Some(count + 1),
            _ => None,
        };
        decimals.is_none_or(|count| count <= 3)
    };
    line.chars().filter(kept).collect()
}

#[test]
fn the_summary_opens_with_answers() {
    let output = run(&["solve", "--tol", "1e-8", "--reserve", "30%"], "", &std::env::temp_dir());
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let answers: Vec<String> = text.lines().skip(2).take_while(|line| !line.is_empty()).map(shortened).collect();
    insta::assert_snapshot!("answers", answers.join("\n"));
}

/// Friction in reserve is not all: a belt that is pushed, or adheres nowhere, or has to be driven from both sides.
#[test]
fn a_drive_that_is_not_sound_is_not_green() {
    let all = [
        ("belt.bending_stiffness=5 N*m^2", "a strand of the belt is pushed"),
        ("belt.bending_stiffness=2 N*m^2", "the belt adheres on neither pulley"),
        ("operating_point.primary_torque=0.1 N*m", "both pulleys have to be driven"),
    ];
    for (set, doubt) in all {
        let output = run(&["solve", "--tol", "1e-3", "--set", set], "", &std::env::temp_dir());
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        assert!(text.contains(&format!("amber: it does not slip, but {doubt};")), "{set}: {text}");
    }
}

/// What a belt does where there is no solution, in its own terms; the solver's words only for whoever asks with `-v`.
#[test]
fn failures_say_what_happened_to_the_belt() {
    let all: &[(&[&str], &str)] = &[
        (&["solve", "--tol", "1e-3", "--set", "operating_point.primary_torque=-15"], ""),
        (&["solve", "--tol", "1e-4", "--edition", "thesis", "--set", "operating_point.slack_tension=15"], ""),
    ];
    let text = transcript(all);
    assert!(!text.contains("NaN") && !text.contains("rank") && !text.contains("Newton"), "{text}");
    insta::assert_snapshot!("failures", text);
    let lost = |arguments: &[&str]| {
        let output = run(arguments, "", &std::env::temp_dir());
        assert_eq!(output.status.code(), Some(3), "{arguments:?}");
        told(&output)
    };
    let pushed = ["solve", "--tol", "1e-3", "--set", "operating_point.primary_torque=-15"];
    assert!(lost(&[&["-v"], &pushed[..]].concat()).contains("the solver says:"));
    let short = lost(&["solve", "--tol", "1e-3", "--work-limit", "2000"]);
    assert!(short.contains("reached its work limit") && short.contains("--work-limit"), "{short}");
}

/// An axial force of two operating points: the tighter is taken, the other is offered, and both have that force.
#[test]
fn two_solutions_are_told_and_each_can_be_had() {
    let solve = |branch: &[&str]| {
        let (torque, force) = ("operating_point.primary_torque=3", "operating_point.primary_axial_force=110 N");
        let base = ["solve", "--json", "--tol", "1e-4", "--set", force, "--set", torque];
        let output = run(&[&base[..], branch].concat(), "", &std::env::temp_dir());
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        serde_json::from_slice::<serde_json::Value>(&output.stdout).unwrap()
    };
    let (tight, loose) = (solve(&[]), solve(&["--branch", "loose"]));
    let tension = |object: &serde_json::Value| object["primary"]["exit_tension"].as_f64().unwrap();
    let other = |object: &serde_json::Value| object["other_solution"]["slack_tension"].as_f64().unwrap();
    assert!(tension(&tight) > tension(&loose));
    assert!((other(&tight) - tension(&loose)).abs() < 1e-2 && (other(&loose) - tension(&tight)).abs() < 1e-2);
    let warned = |object: &serde_json::Value, branch: &str| object["warnings"].to_string().contains(branch);
    assert!(warned(&tight, "--branch loose") && warned(&loose, "--branch tight"));
}

/// Copies the files of a folder of examples, and of its folders.
fn copy(from: &std::path::Path, to: &std::path::Path) {
    std::fs::create_dir_all(to).unwrap();
    for entry in std::fs::read_dir(from).unwrap() {
        let entry = entry.unwrap();
        let target = to.join(entry.file_name());
        if entry.file_type().unwrap().is_dir() {
            copy(&entry.path(), &target);
        } else {
            std::fs::copy(entry.path(), target).unwrap();
        }
    }
}

#[test]
fn drives_that_cannot_work_say_why() {
    let folder = tempfile::tempdir().unwrap();
    copy(concat!(env!("CARGO_MANIFEST_DIR"), "/examples/drive").as_ref(), folder.path());
    let whole = std::fs::read_to_string(folder.path().join("gx9.toml")).unwrap();
    let servo =
        whole.replace("file = \"parts/gx9-arms.toml\"\nmass = \"134 g\"", "type = \"servo\"\nposition = \"20 mm\"");
    let servo = servo.replace("[primary.spring]\nrate = \"60 lbf/in\"\npreload = \"67.5 lbf\"\n", "");
    std::fs::write(folder.path().join("servo.toml"), servo).unwrap();
    let all: &[(&[&str], &str)] = &[
        (&["drive", "gx9.toml", "--speed", "20000 rpm"], ""),
        (&["drive", "gx9.toml", "--secondary-speed", "20000 rpm"], ""),
        (&["drive", "gx9.toml", "--speed", "300 km/h"], ""),
        (&["drive", "gx9.toml", "--speed", "200"], ""),
        (&["drive", "gx9.toml", "--speed", "200 N"], ""),
        (&["drive", "gx9.toml", "--speed", "2000 rpm", "--set", "secondary.actuator.friction_angle=44 deg"], ""),
        (&["drive", "gx9.toml", "--speed", "2000 rpm", "--set", "secondary.actuator.helix_openings=0, 9 mm"], ""),
        (&["drive", "servo.toml", "--speed", "2000 rpm"], ""),
        (&["shift", "gx9.toml", "--direction", "up", "--tol", "1e-3", "--points", "2", "--from", "9000 rpm"], ""),
        (&["launch", "gx9.toml", "--tol", "1e-3", "--points", "8", "--set", "vehicle.drag_area=300"], ""),
        (&["sweep", "--over", "drive.ratio=1,2", "--jobs", "0"], ""),
        (&["map", "gx9.toml", "--least-speed-efficiency", "nine"], ""),
    ];
    insta::assert_snapshot!("drives", transcript_in(folder.path(), all));
}

#[test]
fn logs_that_cannot_be_used_say_why() {
    let folder = tempfile::tempdir().unwrap();
    copy(concat!(env!("CARGO_MANIFEST_DIR"), "/examples/made").as_ref(), &folder.path().join("made"));
    let points = "primary_rpm,secondary_rpm,secondary_torque_Nm,primary_torque_Nm\n3300,3200,16,18\n";
    std::fs::write(folder.path().join("one.csv"), points).unwrap();
    let all: &[(&[&str], &str)] = &[
        (&["dyno", "made", "--calibration", "made/calibration.csv", "--spectrum", "999"], ""),
        (&["dyno", "made", "--calibration", "made/calibration.csv", "--primary", "RPM3"], ""),
        (&["bench-data", "--engine", "made/engine.csv", "--steps", "2", "--out", "made"], ""),
        (&["compare", "--data", "one.csv", "--fit", "sheave.friction_coefficient"], ""),
    ];
    insta::assert_snapshot!("logs", transcript_in(folder.path(), all));
}
