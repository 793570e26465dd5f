//! Sweeps from outside: rows, formats, threads, interruptions.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use serde_json::Value;
use std::path::Path;
use std::process::{Command, Output, Stdio};

fn program(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_sheave"));
    command.arg("sweep").args(["--tol", "1e-3"]).args(arguments).env_remove("RUST_LOG").env("NO_COLOR", "1");
    command
}

fn sweep(arguments: &[&str]) -> Output {
    program(arguments).output().unwrap()
}

fn written(path: &Path, arguments: &[&str]) -> Vec<u8> {
    let output = sweep(&[arguments, &["--out", path.to_str().unwrap()]].concat());
    assert!(output.status.success(), "{output:?}");
    assert!(output.stdout.is_empty());
    std::fs::read(path).unwrap()
}

fn records(csv: &[u8]) -> (Vec<String>, Vec<Vec<String>>) {
    let mut reader = csv::Reader::from_reader(csv);
    let headers = reader.headers().unwrap().iter().map(str::to_owned).collect();
    let record = |record: csv::StringRecord| record.iter().map(str::to_owned).collect();
    (headers, reader.records().map(|row| record(row.unwrap())).collect())
}

#[test]
fn rows_are_in_input_order_with_every_scalar_of_the_result() {
    let output = sweep(&["--over", "operating_point.slack_tension=200,100 N", "--over", "drive.ratio=0.9..1.1:3"]);
    assert!(output.status.success(), "{output:?}");
    let (headers, rows) = records(&output.stdout);
    assert_eq!(headers[..3], ["operating_point.slack_tension", "drive.ratio", "converged"]);
    assert_eq!(headers.last().unwrap(), "failure");
    let swept: Vec<_> = rows.iter().map(|row| (row[0].as_str(), row[1].as_str())).collect();
    let (a, b) = ("200.0", "100.0");
    assert_eq!(swept, [(a, "0.9"), (a, "1.0"), (a, "1.1"), (b, "0.9"), (b, "1.0"), (b, "1.1")]);
    assert!(rows.iter().all(|row| row[2] == "true"));

    // The same scalars, and the same numbers as one solve, to the tolerance.
    let set = "operating_point.slack_tension=100";
    let arguments = ["solve", "--tol", "1e-3", "--json", "--set", set, "--set", "drive.ratio=1.1"];
    let solved = Command::new(env!("CARGO_BIN_EXE_sheave")).args(arguments).output().unwrap();
    let object: Value = serde_json::from_slice(&solved.stdout).unwrap();
    let mut scalars = 0;
    let mut open = vec![(String::new(), &object)];
    while let Some((name, value)) = open.pop() {
        if let Value::Object(members) = value {
            open.extend(members.iter().map(|(key, value)| (format!("{name}.{key}"), value)));
            continue;
        }
        // What is a list, as the warnings are, is no scalar and has no column; the command's name tells rows nothing.
        // How uncertain outputs are is not asked for in a sweep.
        if value.is_array() || name == ".command" || name.starts_with(".uncertainty.") {
            continue;
        }
        scalars += 1;
        let column = headers.iter().position(|header| *header == name[1..]).unwrap_or_else(|| panic!("no {name}"));
        let cell = &rows[5][column];
        match value.as_f64() {
            _ if name == ".solver.wall_time" => assert_eq!(cell, ""),
            // Work, residuals and what is small by cancellation depend on the way to the solution.
            Some(_) if name.starts_with(".solver") || name.starts_with(".energy") || name.contains("sliding") => {}
            Some(one) => {
                let other: f64 = cell.parse().unwrap();
                assert!((other - one).abs() <= 0.03 * one.abs().max(1e-3), "{name}: {one} and {other}");
            }
            None => assert_eq!(*cell, value.to_string().trim_matches('"'), "{name}"),
        }
    }
    // And the varied keys and `failure`.
    assert_eq!(headers.len(), scalars + 3);
}

/// As torque rises, the places where the belt begins to slide move along both contacts. On meshes that stay where they
/// were these points take 92 Newton iterations.
#[test]
fn neighbours_are_few_iterations_apart() {
    let output = sweep(&[
        "--over",
        "operating_point.slack_tension=100 N",
        "--over",
        "operating_point.primary_torque=3..18 N*m:16",
    ]);
    assert!(output.status.success(), "{output:?}");
    let (headers, rows) = records(&output.stdout);
    let column = headers.iter().position(|name| name == "solver.newton_iterations").unwrap();
    let iterations: Vec<usize> = rows.iter().map(|row| row[column].parse().unwrap()).collect();
    assert_eq!(iterations.len(), 16);
    let warm: usize = iterations.iter().skip(1).sum();
    assert!(warm <= 60, "{iterations:?}");
}

#[test]
fn a_varied_key_takes_the_place_of_the_files_keys_for_the_same_thing() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/baja.toml");
    let output = sweep(&[file, "--over", "drive.ratio=0.9,1.1", "--over", "edition=thesis,consistent"]);
    assert!(output.status.success(), "{output:?}");
    let (headers, rows) = records(&output.stdout);
    assert_eq!(headers[..4], ["drive.ratio", "edition", "converged", "schema"]);
    assert_eq!(rows.len(), 4);
    assert!(rows.iter().all(|row| row[2] == "true"));
    assert_eq!(headers.iter().filter(|header| *header == "edition").count(), 1);
}

#[test]
fn a_point_without_a_solution_keeps_its_row_and_its_reason() {
    let output = sweep(&["--over", "drive.primary_radius=68,160 mm"]);
    assert!(output.status.success(), "{output:?}");
    let (headers, rows) = records(&output.stdout);
    assert_eq!((rows[0][1].as_str(), rows[1][1].as_str()), ("true", "false"));
    assert!(rows[1][headers.len() - 1].contains("overlap"));
    assert!(String::from_utf8_lossy(&output.stderr).contains("1 of 2 points"));
}

#[test]
fn bad_input_computes_nothing() {
    for (arguments, said) in [
        (vec!["--over", "drive.ratio"], "KEY=FROM..TO"),
        (vec![], "nothing is varied"),
        (vec!["--over", "drive.ration=1,2"], "drive.ratio"),
        (vec!["--over", "belt.length=1 kg,2 kg"], "a length"),
        (vec!["--over", "drive.ratio=1,2", "--over", "drive.ratio=1,2"], "varied twice"),
        (vec!["--over", "drive.ratio=1..2:9999", "--over", "belt.length=0.8..0.9:9999"], "more than"),
        (vec!["--over", "drive.ratio=1,2", "--out", "table.txt"], ".parquet"),
        (vec!["--over", "drive.ratio=1,2", "--resume"], "--out"),
        (vec!["--over", "drive.ratio=1,2", "--jobs", "0"], "--jobs"),
    ] {
        let output = sweep(&arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {output:?}");
        assert!(output.stdout.is_empty());
        let message = String::from_utf8_lossy(&output.stderr).replace("\n  │", "");
        let message = message.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(message.contains(said), "{arguments:?} does not say {said}: {message}");
    }
}

#[test]
fn the_number_of_threads_changes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let grid = ["--over", "edition=thesis,consistent", "--over", "operating_point.slack_tension=100..200 N:20"];
    for name in ["a.csv", "a.json", "a.parquet"] {
        let path = folder.path().join(name);
        let one = written(&path, &[&grid[..], &["--jobs", "1"]].concat());
        let two = written(&path, &[&grid[..], &["--jobs", "2"]].concat());
        let seven = written(&path, &[&grid[..], &["--jobs", "7"]].concat());
        assert!(one == two && one == seven, "{name}");
    }
}

#[test]
fn the_formats_say_the_same() {
    let folder = tempfile::tempdir().unwrap();
    let grid = ["--over", "drive.primary_radius=68,160 mm"];
    let (headers, rows) = records(&written(&folder.path().join("a.csv"), &grid));
    let json: Value = serde_json::from_slice(&written(&folder.path().join("a.json"), &grid)).unwrap();
    let force = headers.iter().position(|header| header == "primary.axial_force").unwrap();
    assert_eq!(json[0]["primary.axial_force"].to_string(), rows[0][force]);
    assert_eq!(json[0].as_object().unwrap().keys().collect::<Vec<_>>(), headers.iter().collect::<Vec<_>>());
    assert!(json[1]["primary.axial_force"].is_null());

    use parquet::file::reader::{FileReader, SerializedFileReader};
    let parquet = written(&folder.path().join("a.parquet"), &grid);
    let path = folder.path().join("copy.parquet");
    std::fs::write(&path, parquet).unwrap();
    let reader = SerializedFileReader::new(std::fs::File::open(&path).unwrap()).unwrap();
    let read: Vec<_> = reader.get_row_iter(None).unwrap().map(Result::unwrap).collect();
    assert_eq!(read.len(), 2);
    let text: Vec<String> = read[0].get_column_iter().map(|(name, _)| name.clone()).collect();
    assert_eq!(text, headers);
    let (_, field) = read[0].get_column_iter().nth(force).unwrap();
    let parquet::record::Field::Double(value) = field else { panic!("{field:?}") };
    assert_eq!(*value, rows[0][force].parse::<f64>().unwrap());
    assert!(matches!(read[1].get_column_iter().nth(force).unwrap().1, parquet::record::Field::Null));
}

#[test]
fn a_sweep_that_was_killed_is_completed_to_the_same_file() {
    let folder = tempfile::tempdir().unwrap();
    let grid =
        ["--over", "drive.ratio=0.8,1.2", "--over", "operating_point.slack_tension=100..200 N:300", "--jobs", "2"];
    let whole = written(&folder.path().join("whole.csv"), &grid);
    assert!(!folder.path().join("whole.csv.journal").exists());

    for (signal, number) in [("KILL", 9), ("INT", 2)] {
        if is_ignored(number) {
            eprintln!("{signal} not tried: whoever started this test has it ignored, and so do the programs it starts");
        } else {
            interrupted(folder.path(), &grid, signal, &whole);
        }
    }
}

/// Whether a signal is ignored here, as shells have that of Ctrl-C ignored by what they run in the background.
fn is_ignored(signal: u32) -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let ignored = ignored.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(0);
    ignored >> (signal - 1) & 1 == 1
}

/// Begins a sweep, ends it by a signal (that of Ctrl-C is INT), and completes it.
fn interrupted(folder: &Path, grid: &[&str], signal: &str, whole: &[u8]) {
    let (out, journal) = (folder.join("ended.csv"), folder.join("ended.csv.journal"));
    let out_text = out.to_str().unwrap();
    let arguments = [grid, &["--out", out_text]].concat();
    let mut child = program(&arguments).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
    // The first row, and far from all: what is left takes much longer than a signal.
    while std::fs::read(&journal).map_or(0, |text| text.iter().filter(|byte| **byte == b'\n').count()) < 3 {
        assert!(child.try_wait().unwrap().is_none(), "done before it could be ended");
        std::thread::yield_now();
    }
    assert!(child.try_wait().unwrap().is_none());
    // The shell's own `kill`: a bare machine has no other.
    let sent = Command::new("sh").args(["-c", &format!("kill -s {signal} {}", child.id())]).status().unwrap();
    assert!(sent.success());
    assert!(!child.wait().unwrap().success());
    let rows = std::fs::read(&journal).unwrap();
    assert!(!out.exists());
    // As if ended in the middle of a line.
    std::fs::write(&journal, [&rows[..], b"[17,0,[1.0,"].concat()).unwrap();

    // Another study does not take these rows for its own.
    let other = sweep(&["--over", "drive.ratio=0.8,1.3", "--out", out_text, "--resume"]);
    assert_eq!(other.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&other.stderr).contains("another study"));

    // What has been solved is kept even if it is not asked for.
    let (copy, torn) = (folder.join("again.csv"), std::fs::read(&journal).unwrap());
    std::fs::copy(&journal, folder.join("again.csv.journal")).unwrap();
    let again = sweep(&["--over", "drive.ratio=0.8,1.3", "--out", copy.to_str().unwrap()]);
    assert!(again.status.success() && String::from_utf8_lossy(&again.stderr).contains("with --resume"));
    let kept = folder.join("again.csv.journal.old.1");
    assert!(std::fs::read(&kept).unwrap() == torn);
    std::fs::remove_file(kept).unwrap();

    assert_eq!(written(&out, &[grid, &["--resume"]].concat()), whole);
    assert!(!journal.exists());
    // Without a journal it is begun anew.
    assert_eq!(written(&out, &[grid, &["--resume"]].concat()), whole);
    std::fs::remove_file(out).unwrap();
}

#[test]
fn every_study_file_of_the_examples_is_understood() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let mut studies = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|extension| extension == "toml") {
            let file = sheave::study::StudyFile::read(&path).unwrap_or_else(|error| panic!("{error}"));
            if !file.axes.is_empty() {
                sheave::study::Study::new(file.case, file.axes, sheave::drive::SolveOptions::default()).unwrap();
                studies += 1;
            }
        }
    }
    assert!(studies >= 5);
}
