//! Logs of a dynamometer: made ones whose truth is known, a real one, and broken ones.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use proptest::prelude::*;
use sheave::bench::dyno::{
    Fault, Lines, Names, Options, RecordReport, Row, Sample, SteadyPoint, Stream, Uniform, by_header, calibration,
    points_csv, process, records, reduce, runs,
};
use sheave::bench::engine::EngineCurve;
use sheave::bench::made::{Disturbance, Known, Step, files};
use sheave::random::Random;
use std::f64::consts::TAU;
use std::io::{Cursor, Write};
use std::path::{Path, PathBuf};

const RPM: f64 = TAU / 60.0;

/// Steps that need no model.
fn known() -> Known {
    let step = |at: u32| {
        let ratio = 0.8 + 0.15 * f64::from(at);
        let primary_speed = (3200.0 - 60.0 * f64::from(at)) * RPM;
        let secondary_speed = primary_speed / ratio * 0.994;
        Step {
            ratio,
            primary_speed,
            secondary_speed,
            primary_torque: 18.0,
            secondary_torque: 17.0 * ratio,
            efficiency: 0.94,
        }
    };
    Known { engine_scale: 1.0, slope: 108.19, intercept: 35145.0, steps: (0..6).map(step).collect() }
}

fn write(folder: &Path, files: &[(String, String)]) {
    for (name, text) in files {
        std::fs::write(folder.join(name), text).unwrap();
    }
}

fn read(paths: &[PathBuf], options: &Options) -> (Vec<SteadyPoint>, Vec<RecordReport>) {
    let (mut points, mut reports) = (Vec::new(), Vec::new());
    for record in records(paths).unwrap() {
        reports.push(process(&record, options, |point| points.push(point), |_| ()).unwrap());
    }
    (points, reports)
}

#[test]
fn logs_and_tables_of_spreadsheets_in_other_encodings_say_how_to_save_them() {
    let utf16 = |text: &str| -> Vec<u8> { text.encode_utf16().flat_map(u16::to_le_bytes).collect() };
    let log = by_header(&utf16("\u{feff}timestamp_ms,primary_rpm"), &Names::default()).unwrap_err();
    assert!(log.contains("UTF-16"), "{log}");
    let log = by_header(b"timestamp_ms,primary_rpm\r0,1000\r10,1000\r", &Names::default()).unwrap_err();
    assert!(log.contains("carriage returns alone"), "{log}");
    let calibration = calibration::parse("c", &utf16("\u{feff}torque,adc\n0,1\n")).unwrap_err();
    assert!(calibration.to_string().contains("`c`, line 1: it is written in UTF-16"), "{calibration}");
    let dimensions = [sheave::quantity::Dimension::LENGTH, sheave::quantity::Dimension::FORCE];
    let belt = sheave::bench::belt::parse_columns("b", &utf16("\u{feff}mm,N\n0,1\n"), dimensions).unwrap_err();
    assert!(belt.to_string().contains("`b`, line 1: it is written in UTF-16"), "{belt}");
    // As the CSV reader has it, lines may end in carriage returns alone there.
    assert!(sheave::bench::belt::parse_columns("b", b"mm,N\r0,1\r1,2\r", dimensions).is_ok());
}

#[test]
fn the_truth_of_made_steps_comes_out() {
    let folder = tempfile::tempdir().unwrap();
    let known = known();
    write(folder.path(), &files(&known, &Disturbance::default(), 7));
    let line = calibration::read(&folder.path().join("calibration.csv")).unwrap();
    assert!((line.slope - known.slope).abs() < 4.0 * line.slope_error.unwrap(), "{line:?}");
    assert!((line.intercept - known.intercept).abs() < 4.0 * line.intercept_error.unwrap(), "{line:?}");
    assert!(line.r_squared > 0.999);
    let options = Options { calibration: Some(line), gear: 32.0 / 61.0, ..Options::default() };
    let (points, reports) = read(&[folder.path().to_owned()], &options);
    assert_eq!((points.len(), reports.len()), (6, 6));
    for (point, step) in points.iter().zip(&known.steps) {
        assert!(point.steady, "{:?}", point.reason);
        let (primary, secondary) = (point.primary_speed.unwrap(), point.secondary_speed.unwrap());
        let torque = point.secondary_torque.unwrap();
        // A whole number of rpm was cut off.
        assert!((primary.mean - step.primary_speed).abs() < 0.6 * RPM + 5.0 * primary.error, "{primary:?} {step:?}");
        assert!((secondary.mean - step.secondary_speed).abs() < 0.6 * RPM + 5.0 * secondary.error, "{secondary:?}");
        assert!((torque.mean - step.secondary_torque).abs() < 5.0 * torque.error.max(0.02), "{torque:?} {step:?}");
        assert!(torque.error < 0.02 * torque.mean);
        // Firing and the brake's shaft are where they belong, with the amplitudes they were made with.
        let order = |name: &str| point.orders.iter().find(|order| order.name == name).unwrap();
        let firing = order("firing");
        assert!((firing.frequency - step.primary_speed / TAU / 2.0).abs() < 0.1);
        assert!((firing.amplitude.unwrap() / (0.25 * step.secondary_torque) - 1.0).abs() < 0.45, "{firing:?}");
        assert!(order("brake shaft").amplitude.unwrap() > 0.03 * step.secondary_torque);
        let mut largest = point.orders.clone();
        largest.sort_by(|a, b| b.amplitude.partial_cmp(&a.amplitude).unwrap());
        assert_eq!(largest[0].name, "firing");
    }
    // Every kind of disturbance that was made is named, and the counter's wrap is taken on.
    let count =
        |fault| reports.iter().flat_map(|report| &report.files).map(|file| file.faults.count(fault)).sum::<u64>();
    for fault in [Fault::Duplicate, Fault::OutOfRange, Fault::Outlier, Fault::OutOfSequence, Fault::NotNumber] {
        assert!(count(fault) > 0, "{fault:?}");
    }
    let wraps: u64 = reports.iter().flat_map(|report| &report.files).map(|file| file.time_wraps).sum();
    assert_eq!(wraps, 3, "one in each file of the step");
}

#[test]
fn one_file_form_and_its_steady_stretches() {
    let mut text = "timestamp_ms,primary_rpm,secondary_rpm,torque\n".to_owned();
    for at in 0..3000_u32 {
        let time = f64::from(at) * 8.0;
        // 8 s steady, 8 s of a ramp, 8 s steady.
        let share = (f64::from(at) / 1000.0 - 1.0).clamp(0.0, 1.0);
        let wave = (f64::from(at) * 1.3).sin();
        text += &format!("{time},{},{},{}\n", 3000.0 + 5.0 * wave, 3000.0 - 1200.0 * share, 17.0 + 12.0 * share + wave);
    }
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("log.csv");
    std::fs::write(&path, text).unwrap();
    let (points, reports) = read(&[path], &Options::default());
    assert!((4..=6).contains(&points.len()), "{}", points.len());
    for point in &points {
        let (speed, torque) = (point.secondary_speed.unwrap().mean / RPM, point.secondary_torque.unwrap().mean);
        let first = (speed - 3000.0).abs() < 12.0 && (torque - 17.0).abs() < 0.5;
        let last = (speed - 1800.0).abs() < 12.0 && (torque - 29.0).abs() < 0.5;
        assert!(first || last, "{speed} {torque}");
    }
    assert!(reports[0].unsteady > 0 && reports[0].gaps == 0);
}

/// All ten logs of the car: name, rows, and the median of the engine's speed between the speed ratios 2.5 and 1, along
/// which the drive shifts. Counted by another program, from the files as text.
const RUNS: [(&str, u64, f64); 10] = [
    ("8-6-24-tune1-2", 33_877, 3000.0),
    ("8-6-24-tune1-3", 32_878, 3000.0),
    ("8-6-24-tune1-4", 25_341, 3000.0),
    ("8-6-24-tune1-5", 32_936, 3000.0),
    ("8-6-24-tune3-1", 18_995, 3060.0),
    ("8-6-24-tune4-1", 33_696, 3300.0),
    ("8-6-24-tune4-2", 10_793, 3180.0),
    ("8-6-24-tune4-3", 17_546, 3180.0),
    ("8-6-24-tune4-4", 12_419, 3180.0),
    ("8-6-24-tune4-5", 13_288, 3120.0),
];

/// The folder of the car's logs, and how they are read: engine and wheel, 8.32 turns of the secondary for one of the
/// wheel.
fn terps() -> (PathBuf, Options) {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/terps");
    let options = Options {
        rate: 50.0,
        secondary_factor: 8.32,
        names: Names { primary: Some("RPM3".into()), secondary: Some("RPM2".into()), torque: None },
        runs: runs(&data.join("tunes.csv")).unwrap(),
        ..Options::default()
    };
    (data, options)
}

#[test]
fn the_shift_lines_of_three_tunes_come_out_of_ten_logs() {
    let (data, options) = terps();
    for (name, rows, line) in RUNS {
        let (_, reports) = read(&[data.join(format!("{name}.log.gz"))], &options);
        let file = &reports[0].files[0];
        let shifting =
            reports[0].trace.iter().filter(|(_, primary, secondary)| (1.0..=2.5).contains(&(primary / secondary)));
        let mut speeds: Vec<f64> = shifting.map(|(_, primary, _)| *primary).collect();
        speeds.sort_by(f64::total_cmp);
        let median = speeds[speeds.len() / 2];
        println!(
            "| `{name}` | {} | {} | {} | {} | {median:.0} |",
            file.rows,
            file.faults.total(),
            reports[0].samples,
            speeds.len()
        );
        assert_eq!((file.problem.as_deref(), file.rows), (None, rows), "{name}");
        // Nothing is dropped, and the run window is filled.
        assert_eq!(file.faults.total(), 0, "{name}: {}", file.faults);
        let run = options.runs.iter().find(|run| run.file == format!("{name}.log")).unwrap();
        let samples = ((run.end - run.start) * options.rate).round() as u64;
        assert!(reports[0].samples.abs_diff(samples) <= 4 && reports[0].gaps == 0, "{name}: {}", reports[0].samples);
        // The engine's speed comes in steps of 60 rpm.
        assert!((median - line).abs() <= 30.0, "{name}: {median} {line}");
    }
}

/// The run window of one of the real logs (tests/data/terps/README.md): engine at 60 rpm steps, wheel, 50 Hz of several
/// rates in one file.
#[test]
fn a_real_log_is_read_as_it_is() {
    let (data, options) = terps();
    let (_, reports) = read(&[data.join("8-6-24-tune4-2.log.gz")], &options);
    let [report] = reports.as_slice() else { panic!("{reports:?}") };
    let file = &report.files[0];
    assert_eq!((file.problem.as_deref(), file.rows), (None, 10_793));
    assert!(file.faults.total() < 5, "{}", file.faults);
    // 7723 to 13483 ms at 50 Hz.
    assert!((285..=289).contains(&report.samples), "{}", report.samples);
    assert_eq!(report.gaps, 0);
    let highest = report.trace.iter().map(|(_, primary, _)| *primary).fold(0.0, f64::max);
    let fastest = report.trace.iter().map(|(_, _, secondary)| *secondary).fold(0.0, f64::max);
    assert!((3300.0..4000.0).contains(&highest) && (3000.0..6500.0).contains(&fastest), "{highest} {fastest}");
}

/// A bit of the second row's stamp was flipped on its way, 2.1 s after the first: the step was lost, and only this row
/// is out of sequence.
#[test]
fn a_garbled_second_stamp_costs_one_row() {
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), &files(&known(), &Disturbance { transmission: 0.0, ..Disturbance::default() }, 11));
    let path = folder.path().join("ADC_3.csv");
    let text = std::fs::read_to_string(&path).unwrap();
    // The third row, for the logger repeats itself: the first is followed by its own stamp.
    let stamps: Vec<u64> = text.lines().map(|line| line.split(',').next().unwrap().parse().unwrap()).collect();
    let second = stamps.iter().position(|stamp| *stamp != stamps[0]).unwrap();
    let garbled = text.replacen(&stamps[second].to_string(), &(stamps[second] ^ (1 << 21)).to_string(), 1);
    assert_ne!(text, garbled);
    std::fs::write(&path, garbled).unwrap();
    let line = calibration::read(&folder.path().join("calibration.csv")).unwrap();
    let options = Options { calibration: Some(line), ..Options::default() };
    let (points, reports) = read(&[folder.path().to_owned()], &options);
    let file = reports.iter().flat_map(|report| &report.files).find(|file| file.file.ends_with("ADC_3.csv")).unwrap();
    assert!((1..=2).contains(&file.faults.count(Fault::OutOfSequence)), "{}", file.faults);
    assert_eq!(file.time_jumps, 0);
    let point = points.iter().find(|point| point.step == Some(3)).unwrap();
    assert!(point.steady && point.secondary_torque.unwrap().samples > 300, "{point:?}");
}

#[test]
fn a_broken_file_loses_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), &files(&known(), &Disturbance::default(), 3));
    std::fs::write(folder.path().join("S_2.csv"), [0_u8, 255, 10, 7]).unwrap();
    let mut encoder = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::default());
    let good = std::fs::read(folder.path().join("P_3.csv")).unwrap();
    encoder.write_all(&good).unwrap();
    let packed = encoder.finish().unwrap();
    std::fs::remove_file(folder.path().join("P_3.csv")).unwrap();
    std::fs::write(folder.path().join("P_3.csv.gz"), &packed[..packed.len() / 2]).unwrap();
    std::fs::write(folder.path().join("notes.csv"), "something,else\n1,2\n").unwrap();
    let line = calibration::read(&folder.path().join("calibration.csv")).unwrap();
    let (points, reports) =
        read(&[folder.path().to_owned()], &Options { calibration: Some(line), ..Options::default() });
    for step in [0, 1, 4, 5] {
        assert!(points.iter().any(|point| point.step == Some(step) && point.steady), "step {step}");
    }
    let problems: Vec<&str> =
        reports.iter().flat_map(|r| &r.files).filter_map(|file| file.problem.as_deref()).collect();
    assert!(problems.iter().any(|problem| problem.contains("first column is `something`")), "{problems:?}");
    let broken = reports.iter().flat_map(|r| &r.files).any(|file| file.faults.count(Fault::BrokenOff) == 1);
    assert!(broken, "{reports:?}");
}

#[test]
fn the_command_as_it_is_called() {
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), &files(&known(), &Disturbance::default(), 5));
    let [logs, calibration, engine, out] =
        ["", "calibration.csv", "engine.csv", "out"].map(|name| folder.path().join(name).to_str().unwrap().to_owned());
    std::fs::copy(Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/made/engine.csv"), &engine).unwrap();
    let run =
        |arguments: &[&str]| std::process::Command::new(env!("CARGO_BIN_EXE_sheave")).args(arguments).output().unwrap();
    let output = run(&["dyno", &logs, "--calibration", &calibration, "--engine", &engine, "--gear", "32:61", "--json"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let object: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((object["command"].as_str(), object["points"].as_array().unwrap().len()), (Some("dyno"), 6));
    let point = &object["points"][2];
    assert!(
        point["efficiency"]["value"].as_f64().unwrap() > 0.8 && point["efficiency"]["error"].as_f64().unwrap() > 0.0
    );
    assert!(
        object["warnings"].as_array().unwrap().iter().any(|text| text.as_str().unwrap().contains("out of sequence"))
    );
    let output = run(&["dyno", &logs, "--calibration", &calibration, "--engine", &engine, "--out", &out]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    for name in [
        "operating-points.csv",
        "result.json",
        "torque_time.svg",
        "torque_spectrum.png",
        "efficiency.svg",
        "report.html",
    ] {
        assert!(Path::new(&out).join(name).metadata().unwrap().len() > 0, "{name}");
    }
    // What it writes is what `sheave compare` reads.
    let engine = sheave::bench::engine::EngineCurve::read(Path::new(&engine)).unwrap();
    let table = sheave::bench::compare::read(&Path::new(&out).join("operating-points.csv"), Some(&engine)).unwrap();
    assert_eq!((table.points.len(), table.bad.len()), (6, 0));
    for (arguments, said) in [
        (vec!["dyno", "nowhere"], "cannot read `nowhere`"),
        (vec!["dyno", logs.as_str(), "--gear", "0:61"], "32:61"),
        (vec!["dyno", logs.as_str(), "--calibration", "nowhere"], "cannot read `nowhere`"),
        (vec!["dyno", calibration.as_str()], "no sample came out"),
    ] {
        let output = run(&arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        // Without the frame in which long messages are broken.
        let text = String::from_utf8_lossy(&output.stderr).replace('│', " ");
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(text.contains(said), "{arguments:?}: {text}");
    }
}

/// A log of rows 8 ms apart: its header, the first stamp in ms, the torque of each row.
fn log(header: &str, first: u32, torque: impl IntoIterator<Item = f64>) -> String {
    let row = |(at, torque): (u32, f64)| {
        let wave = (f64::from(at) * 1.3).sin();
        format!("{},{},{},{}\n", first + 8 * at, 3000.0 + 5.0 * wave, 2000.0 - 5.0 * wave, torque + 0.1 * wave)
    };
    format!("{header}\n") + &(0..).zip(torque).map(row).collect::<String>()
}

const TORQUE: &str = "timestamp_ms,primary_rpm,secondary_rpm,torque";

fn constant(value: f64, seconds: usize) -> impl Iterator<Item = f64> {
    std::iter::repeat_n(value, 125 * seconds)
}

fn torques(points: &[SteadyPoint]) -> Vec<f64> {
    points.iter().map(|point| point.secondary_torque.unwrap().mean.round()).collect()
}

#[test]
fn a_torque_column_that_is_named_is_calibrated() {
    let folder = tempfile::tempdir().unwrap();
    let [raw, known] = ["raw.csv", "known.csv"].map(|name| folder.path().join(name));
    std::fs::write(&raw, log(&TORQUE.replace("torque", "load"), 0, constant(35_145.0 + 108.19 * 17.0, 4))).unwrap();
    std::fs::write(&known, log(TORQUE, 0, constant(17.0, 4))).unwrap();
    let line = calibration::parse("c", b"108.19,35145,0.9\n").unwrap();
    let options = Options { calibration: Some(line), ..Options::default() };
    let named = Names { torque: Some("load".into()), ..Names::default() };
    let found = reduce(&[raw], &Options { names: named, ..options.clone() }, None, |_| ()).unwrap();
    assert_eq!(torques(&found.points)[0], 17.0);
    assert!(found.warnings.iter().any(|warning| warning.contains("poorly, R² = 0.9000")), "{:?}", found.warnings);
    // One that is in N·m by its name stays as it is, and that is said.
    let found = reduce(&[known], &options, None, |_| ()).unwrap();
    assert_eq!(torques(&found.points)[0], 17.0);
    let said = found.warnings.iter().any(|warning| warning.contains("known.csv") && warning.contains("not applied"));
    assert!(said, "{:?}", found.warnings);
}

#[test]
fn rows_that_are_no_calibration_are_refused() {
    for (text, words) in [
        ("torque_Nm,adc,n\n0,35145,1\n", "line 2: there are three numbers below a header of torque and ADC"),
        ("0,35145,30\n10,36227,30\n", "line 1: three numbers are slope, intercept and R², and 30 is no R²"),
    ] {
        let error = calibration::parse("c", text.as_bytes()).unwrap_err().to_string();
        assert!(error.contains(words) && error.contains("two columns"), "{error}");
    }
    let marked = calibration::parse("c", "\u{feff}0,100\n1,200\n2,300\n".as_bytes()).unwrap();
    assert!(marked.points == 3 && (marked.slope - 100.0).abs() < 1e-9, "{marked:?}");
}

#[test]
fn every_window_of_a_run_is_a_stretch_of_its_own() {
    let folder = tempfile::tempdir().unwrap();
    let [path, table] = ["log.csv", "table.csv"].map(|name| folder.path().join(name));
    std::fs::write(&path, log(TORQUE, 0, (0..1250).map(|at| if at < 562 { 17.0 } else { 30.0 }))).unwrap();
    let rows = "logfile,t_start,t_end\nlog.csv.gz,1000,4495\nelsewhere.log,0,1000\nlog.csv,4495,8000\n";
    std::fs::write(&table, format!("\u{feff}{rows}")).unwrap();
    let options = Options { runs: runs(&table).unwrap(), ..Options::default() };
    let found = reduce(&[path], &options, None, |_| ()).unwrap();
    assert_eq!(torques(&found.points), [17.0, 30.0]);
    let starts: Vec<f64> = found.points.iter().map(|point| (point.start * 10.0).round() / 10.0).collect();
    assert_eq!(starts, [1.0, 4.5]);
    assert!((860..=875).contains(&found.records[0].samples), "{}", found.records[0].samples);
    assert_eq!(found.warnings, ["the table of runs has logs that are not among these files: elsewhere.log"]);
    std::fs::write(&table, rows.replace("4495,8000", "4000,8000")).unwrap();
    let error = runs(&table).unwrap_err().to_string();
    assert!(error.contains("line 4: this window of `log.csv` overlaps that from 1000 to 4495 ms"), "{error}");
}

#[test]
fn a_reset_of_the_counter_parts_what_lies_on_both_sides() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("log.csv");
    let behind = log("", 0, constant(30.0, 4));
    std::fs::write(&path, log(TORQUE, 20_000, constant(17.0, 4)) + behind.trim_start()).unwrap();
    let (points, reports) = read(&[path], &Options::default());
    assert_eq!((reports[0].files[0].time_jumps, reports[0].gaps), (1, 1));
    assert_eq!(torques(&points), [17.0, 17.0, 30.0, 30.0]);
}

/// More power than the engine has is the doing of a curve, a unit or a gear, and not of a drive.
#[test]
fn more_power_than_the_engine_has_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("log.csv");
    let told = |torque: f64| {
        std::fs::write(&path, log(TORQUE, 0, constant(torque, 6))).unwrap();
        let engine = EngineCurve::parse("engine.csv", b"rpm,hp\n2000,6\n3000,9\n3800,10\n").unwrap();
        let options = Options { engine: Some(engine), ..Options::default() };
        let found = reduce(std::slice::from_ref(&path), &options, None, |_| ()).unwrap();
        let efficiency = found.points[0].efficiency.unwrap().value;
        (efficiency, found.warnings.into_iter().find(|warning| warning.contains("than the engine's curve gives")))
    };
    assert!(matches!(told(17.0), (efficiency, None) if efficiency < 1.0), "{:?}", told(17.0));
    let (efficiency, warning) = told(60.0);
    let said = format!(
        "at 2 of 2 steady points more power leaves the secondary than the engine's curve gives, up to \
                        {:.0} % of it",
        100.0 * efficiency
    );
    assert!(warning.as_ref().is_some_and(|warning| warning.starts_with(&said)), "{said}: {warning:?}");
}

/// Before the engine starts nothing scatters: that is no point of a drive.
#[test]
fn what_stands_still_is_no_steady_point() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("log.csv");
    let still: String = (0..500).map(|at| format!("{},0,0,0\n", 8 * at)).collect();
    std::fs::write(&path, format!("{TORQUE}\n{still}")).unwrap();
    let found = |path: &std::path::PathBuf| reduce(std::slice::from_ref(path), &Options::default(), None, |_| ());
    let error = found(&path).unwrap_err().to_string();
    assert!(error.contains("no pulley turns"), "{error}");
    std::fs::write(&path, format!("{TORQUE}\n{still}").to_owned() + &log("", 4000, constant(17.0, 6))[1..]).unwrap();
    let steady: Vec<SteadyPoint> = found(&path).unwrap().points.into_iter().filter(|point| point.steady).collect();
    assert!(!steady.is_empty() && steady.iter().all(|point| point.primary_speed.unwrap().mean > 0.0));
}

#[test]
fn raw_torque_without_a_calibration_is_named() {
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), &files(&known(), &Disturbance::default(), 3));
    let (_, reports) = read(&[folder.path().to_owned()], &Options::default());
    for report in &reports {
        let raw = report.files.iter().find(|file| file.file.contains("ADC_")).unwrap();
        assert_eq!(raw.problem.as_deref(), Some("its torque is raw: a calibration is needed (--calibration)"));
    }
}

#[test]
fn points_that_are_not_steady_are_not_in_the_table() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("log.csv");
    std::fs::write(&path, log(TORQUE, 0, constant(17.0, 4))).unwrap();
    let (mut points, _) = read(&[path], &Options::default());
    assert_eq!((points.len(), points_csv(&points).1), (2, 0));
    points[0].steady = false;
    let (table, left_out) = points_csv(&points);
    assert_eq!((table.lines().count(), left_out), (2, 1));
}

#[test]
fn logs_without_steady_points_say_why() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("log.csv");
    let reduced = |text: String, options: Options| {
        std::fs::write(&path, text).unwrap();
        reduce(std::slice::from_ref(&path), &options, None, |_| ())
    };
    let refused = |text: String, options: Options| reduced(text, options).unwrap_err().to_string();
    let ramp = log(TORQUE, 0, (0..1000).map(|at| 10.0 + 0.02 * f64::from(at)));
    let error = refused(ramp.clone(), Options::default());
    assert!(error.contains("windows of 3 s is steady; in") && error.contains("the torque changes by"), "{error}");
    // Runs are windows of what is not steady.
    let run = sheave::bench::dyno::Run { file: "log.csv".into(), start: 0.0, end: 8.0 };
    let found = reduced(ramp, Options { runs: vec![run], ..Options::default() }).unwrap();
    assert!(found.points.is_empty() && found.warnings[0].contains("is steady"), "{:?}", found.warnings);
    let short = refused(log(TORQUE, 0, constant(17.0, 4)), Options { window: 30.0, ..Options::default() });
    assert!(
        short.contains("no window of 30 s is filled") && short.contains("samples lie in shorter pieces"),
        "{short}"
    );
    let slow = format!("{TORQUE}\n") + &(0..20).map(|at| format!("{},3000,2000,17\n", 1000 * at)).collect::<String>();
    let error = refused(slow, Options::default());
    assert!(error.contains("no sample came out of 20 rows") && error.contains("(--longest-gap)"), "{error}");
    let found = reduced(log(TORQUE, 0, constant(17.0, 4)), Options { window: 0.05, ..Options::default() }).unwrap();
    let said = "0.05 s has 6 samples at 125 Hz: windows of 20 samples, 0.16 s";
    assert!(found.warnings[0].contains(said), "{:?}", found.warnings);
}

#[test]
fn a_table_without_points_is_explained() {
    let folder = tempfile::tempdir().unwrap();
    let [path, out] = ["log.csv", "out"].map(|name| folder.path().join(name));
    let run = |text: String| {
        std::fs::write(&path, text).unwrap();
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_sheave"));
        command.arg("dyno").arg(&path).arg("--out").arg(&out).output().unwrap()
    };
    let output = run(log(&TORQUE.replace("torque", "load"), 0, constant(17.0, 4)));
    assert!(output.status.success());
    let result = std::fs::read_to_string(out.join("result.json")).unwrap();
    let said = "operating-points.csv has no operating point; it leaves out 2 of 2 points: 2 without torque";
    assert!(result.contains(said), "{result}");
    let output = run(log(TORQUE, 0, (0..1000).map(|at| 10.0 + 0.02 * f64::from(at))));
    assert_eq!(output.status.code(), Some(2), "{}", String::from_utf8_lossy(&output.stderr));
}

/// A log that is made while it is read, so that its size costs nothing.
struct Endless {
    at: u64,
    rows: u64,
    line: Cursor<Vec<u8>>,
}

impl std::io::Read for Endless {
    fn read(&mut self, to: &mut [u8]) -> std::io::Result<usize> {
        let count = self.line.read(to)?;
        if count > 0 || self.at == self.rows {
            return Ok(count);
        }
        let mut text = String::new();
        for _ in 0..200.min(self.rows - self.at) {
            let wave = (self.at % 97) as f64;
            text += &format!("{},{:.1},{:.1},{:.3}\n", 8 * self.at, 3000.0 + wave, 2000.0 + wave, 20.0 + 0.1 * wave);
            self.at += 1;
        }
        self.line = Cursor::new(text.into_bytes());
        self.line.read(to)
    }
}

#[test]
fn memory_does_not_grow_with_the_log() {
    let format = by_header(b"timestamp_ms,primary_rpm,secondary_rpm,torque", &Names::default()).unwrap();
    let peak = |rows: u64| {
        let lines = Lines::new(Endless { at: 0, rows, line: Cursor::new(Vec::new()) }).unwrap();
        let mut stream = Stream::new(lines, format.clone(), (f64::NEG_INFINITY, f64::INFINITY));
        let mut uniform = Uniform::new([true; 3], 125.0, 0.25);
        let (mut peak, mut count, mut out) = (0, 0_u64, Vec::new());
        while let Some(sample) = stream.next_sample() {
            uniform.push(sample, &mut out);
            count += out.drain(..).filter(|row| matches!(row, Row::Values(..))).count() as u64;
            peak = peak.max(stream.resident() + uniform.resident);
        }
        assert!(count >= rows - 1, "{count} of {rows}");
        peak
    };
    let (short, long) = (peak(2_000), peak(100_000));
    // Fifty times the rows: the same few samples around a gap or the test for outliers.
    assert!(short < 60 && long < 60, "{short} {long}");
}

fn any_log() -> impl Strategy<Value = Vec<u8>> {
    let header = prop_oneof![
        Just("timestamp_ms,primary_rpm,secondary_rpm,torque\n".to_owned()),
        Just("\"Interval\"|\"ms\"|0|0|1,\"RPM2\"|\"rpm\"|0|8000|50,\"RPM3\"|\"rpm\"|0|8000|50\n".to_owned()),
        "[ -~]{0,40}\n",
        Just(String::new()),
    ];
    let cell = prop_oneof![
        "[-+0-9.eE]{0,12}",
        "[0-9]{1,20}",
        Just("nan".to_owned()),
        Just("1e308".to_owned()),
        Just("-1e308".to_owned()),
        Just(String::new()),
        ".{0,3}",
    ];
    let row = prop::collection::vec(cell, 0..6).prop_map(|cells| cells.join(","));
    let rows = prop::collection::vec((row, any::<bool>()), 0..60).prop_map(|rows| {
        rows.into_iter().map(|(row, unix)| row + if unix { "\n" } else { "\r\n" }).collect::<String>()
    });
    let noise = prop::collection::vec(any::<u8>(), 0..40);
    (header, rows, noise, any::<bool>()).prop_map(|(header, rows, noise, packed)| {
        let mut bytes = [header.as_bytes(), rows.as_bytes(), &noise].concat();
        if packed {
            let mut encoder = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
            encoder.write_all(&bytes).unwrap();
            bytes = encoder.finish().unwrap();
            bytes.truncate(bytes.len().saturating_sub(noise.len() / 8));
        }
        bytes
    })
}

/// Files to try: more with SHEAVE_FUZZ_FILES.
fn fuzzed_files() -> u32 {
    std::env::var("SHEAVE_FUZZ_FILES").ok().and_then(|text| text.parse().ok()).unwrap_or(300)
}

fn cases() -> ProptestConfig {
    // Strategies take a hundred times as long as the readers: what is wanted in great numbers is made by `Maker`.
    ProptestConfig { cases: fuzzed_files().min(2000), failure_persistence: None, ..ProptestConfig::default() }
}

/// Every reader of the bench on one content: no panic, no endless loop, every row accounted for.
fn read_by_all(bytes: &[u8]) {
    let bytes = bytes.to_vec();
    let readable = Lines::new(Cursor::new(bytes.clone()));
    if let Ok(mut lines) = readable {
        let mut rows = 0_u64;
        while let Ok(Some(_)) = lines.next_line() {
            rows += 1;
        }
        assert!(rows <= bytes.len() as u64 * 1100 + 1);
    }
    for format in [
        by_header(b"timestamp_ms,primary_rpm,secondary_rpm,torque", &Names::default()).unwrap(),
        by_header(bytes.split(|byte| *byte == b'\n').next().unwrap_or_default(), &Names::default())
            .unwrap_or_else(|_| sheave::bench::dyno::StepChannel::Primary.format()),
    ] {
        let Ok(lines) = Lines::new(Cursor::new(bytes.clone())) else { continue };
        let mut stream = Stream::new(lines, format, (f64::NEG_INFINITY, f64::INFINITY));
        let mut uniform = Uniform::new([true, false, false], 125.0, 0.25);
        let (mut out, mut last) = (Vec::new(), f64::NEG_INFINITY);
        while let Some(sample) = stream.next_sample() {
            assert!(sample.value.is_finite() && sample.time.is_finite());
            uniform.push(Sample { channel: sheave::bench::dyno::Channel::Primary, ..sample }, &mut out);
        }
        for row in out {
            if let Row::Values(time, values, _) = row {
                assert!(time > last && values[0].is_finite());
                last = time;
            }
        }
    }
    let _ = calibration::parse("fuzz", &bytes);
    let _ = sheave::bench::engine::EngineCurve::parse("fuzz", &bytes);
    let _ = sheave::bench::compare::parse("fuzz", &bytes, None);
    let _ = sheave::bench::belt::parse_columns("fuzz", &bytes, [sheave::quantity::Dimension::LENGTH; 2]);
    if let Ok(text) = std::str::from_utf8(&bytes) {
        let _ = sheave::bench::belt::Description::parse("fuzz", text);
        let _ = sheave::bench::compare::Actuator::parse("fuzz", text);
    }
}

/// Makes files that are nearly logs, many thousands a second.
struct Maker {
    random: Random,
    /// Good logs, of which some bytes are changed.
    good: Vec<Vec<u8>>,
}

impl Maker {
    const HEADERS: [&str; 7] = [
        "timestamp_ms,primary_rpm,secondary_rpm,torque\n",
        "timestamp_us,primary_rpm,adc\n",
        "\"Interval\"|\"ms\"|0|0|1,\"RPM2\"|\"rpm\"|0|8000|50,\"RPM3\"|\"rpm\"|0|8000|50\n",
        "primary_rpm,secondary_rpm,secondary_torque_Nm\n",
        "rpm,N*m\n",
        "[belt]\nname = 3\n",
        "",
    ];
    const TOKENS: [&str; 14] =
        ["nan", "inf", "-1e308", "1e308", "", " ", "0x1F", "é", "\"", "-", "1e", "4294967295", "1e-320", "="];

    fn pick<'a>(&mut self, of: &[&'a str]) -> &'a str {
        of[(self.random.bits() % of.len() as u64) as usize]
    }

    fn file(&mut self) -> Vec<u8> {
        let mut bytes = match self.random.bits() % 4 {
            0 => {
                let which = (self.random.bits() % self.good.len() as u64) as usize;
                let mut bytes = self.good[which].clone();
                for _ in 0..=self.random.bits() % 4 {
                    let at = (self.random.bits() % bytes.len() as u64) as usize;
                    bytes[at] ^= 1 << (self.random.bits() % 8);
                }
                bytes
            }
            _ => self.rows(),
        };
        if self.random.chance(0.05) {
            let mut encoder = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
            encoder.write_all(&bytes).unwrap();
            bytes = encoder.finish().unwrap();
        }
        if self.random.chance(0.2) {
            bytes.truncate((self.random.bits() % (bytes.len() as u64 + 1)) as usize);
        }
        bytes
    }

    fn rows(&mut self) -> Vec<u8> {
        let mut text = self.pick(&Self::HEADERS).to_owned();
        let mut stamp = self.random.bits() >> (self.random.bits() % 64);
        for _ in 0..self.random.bits() % 40 {
            stamp = if self.random.chance(0.1) { self.random.bits() >> 30 } else { stamp.wrapping_add(8) };
            text += &stamp.to_string();
            for _ in 0..self.random.bits() % 5 {
                text.push(',');
                match self.random.bits() % 6 {
                    0 => text += self.pick(&Self::TOKENS),
                    1 => text += &(self.random.bits() >> (self.random.bits() % 64)).to_string(),
                    _ => text += &(3000.0 * self.random.normal()).round().to_string(),
                }
            }
            text += self.pick(&["\n", "\n", "\n", "\r\n", "\r", ""]);
        }
        let mut bytes = text.into_bytes();
        for _ in 0..self.random.bits() % 8 {
            bytes.push(self.random.bits() as u8);
        }
        bytes
    }
}

#[test]
fn files_that_are_nearly_logs_are_read_by_all() {
    let good = files(&known(), &Disturbance::default(), 4);
    let good = good.into_iter().map(|(_, text)| text.lines().take(40).collect::<Vec<_>>().join("\n").into_bytes());
    let mut maker = Maker { random: Random::new(20_260), good: good.filter(|bytes| !bytes.is_empty()).collect() };
    for _ in 0..10 * fuzzed_files() {
        read_by_all(&maker.file());
    }
}

proptest! {
    #![proptest_config(cases())]

    /// Every reader of the bench on every kind of content.
    #[test]
    fn no_file_panics(bytes in any_log()) {
        read_by_all(&bytes);
    }

    /// Descriptions near a good one: a key, a value or a section is something else.
    #[test]
    fn no_description_panics(at in 0..60_usize, value in "[-+0-9.eE\" \
        a-zA-Z/*\\[\\]]{0,20}", temperature in prop::option::of(1.0..1e4_f64)) {
        let text = include_str!("../examples/belts/cvtech.toml");
        let changed: Vec<String> = text.lines().enumerate().map(|(line, text)| match text.split_once('=') {
            Some((key, _)) if line == at => format!("{key}={value}"),
            _ if line == at => value.clone(),
            _ => text.to_owned(),
        }).collect();
        if let Ok(description) = sheave::bench::belt::Description::parse("fuzz", &changed.join("\n")) {
            let _ = description.evaluate(temperature);
        }
    }
}

/// A log at 125 Hz, of values by the number of the row.
fn written(folder: &Path, rows: u32, row: impl Fn(f64) -> [f64; 3]) -> PathBuf {
    let line = |at: u32| {
        let [primary, secondary, torque] = row(f64::from(at));
        format!("{},{primary},{secondary},{torque}\n", 8 * at)
    };
    let path = folder.join("log.csv");
    std::fs::write(&path, format!("{TORQUE}\n") + &(0..rows).map(line).collect::<String>()).unwrap();
    path
}

/// Over a window no speed may change by more than 1 % of its mean, however uncertain this is.
#[test]
fn a_window_is_as_steady_as_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let speed = |rise: f64| {
        move |at: f64| {
            // A wave of three seconds, which makes the mean uncertain, on a ramp.
            let wave = (at * TAU / 188.0 + 1.6).sin();
            [3000.0 * (1.0 + rise * at / 375.0 + 0.02 * wave), 2000.0, 17.0 + 0.1 * (at * 1.3).sin()]
        }
    };
    let found = |rise: f64| read(&[written(folder.path(), 374, speed(rise))], &Options::default()).0;
    let slow = found(0.0);
    assert!(slow.len() == 1 && slow[0].steady, "{slow:?}");
    assert!(found(0.014).is_empty(), "{:?}", found(0.014));
}

/// More than eight standard deviations off both sides, and more than a tenth of the value, or 0.2 % of the range.
#[test]
fn an_outlier_is_what_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let mut random = Random::new(5);
    let noise: Vec<f64> = (0..500).map(|_| random.normal()).collect();
    let outliers = |speed: f64, torque: f64, deviation: f64| {
        let row = |at: f64| {
            let [speed, torque] = [speed, torque].map(|off| if at == 200.0 { off } else { 0.0 });
            let wave = noise[at as usize];
            [3000.0 + 2.0 * wave + speed, 2000.0 + at % 2.0, 17.0 + deviation * wave + torque]
        };
        let (_, reports) = read(&[written(folder.path(), 500, row)], &Options::default());
        reports[0].files[0].faults.count(Fault::Outlier)
    };
    // A tenth of 3000 rpm is 300; eight times its deviation are 16.
    assert_eq!([outliers(0.0, 0.0, 0.1), outliers(280.0, 0.0, 0.1), outliers(330.0, 0.0, 0.1)], [0, 0, 1]);
    // 0.2 % of a range of 2000 N·m are 4 N·m, more than a tenth of 17 N·m and than eight times 0.1 N·m.
    assert_eq!([outliers(0.0, 3.5, 0.1), outliers(0.0, 4.5, 0.1)], [0, 1]);
    // Eight times 3 N·m, as eleven values tell it.
    assert_eq!([outliers(0.0, 6.0, 3.0), outliers(0.0, 90.0, 3.0)], [0, 1]);
}

#[test]
fn a_step_that_is_too_short_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str, rows: u64, value: f64| {
        let text: String = (0..rows).map(|at| format!("{},{}\n", 8000 * at, value + (at % 5) as f64)).collect();
        std::fs::write(folder.path().join(name), text).unwrap();
    };
    for (step, rows) in [(0, 400), (1, 50), (2, 10)] {
        file(&format!("P_{step}.csv"), rows, 3000.0);
        file(&format!("S_{step}.csv"), rows, 2000.0);
        file(&format!("TORQUE_{step}.csv"), rows, 17.0);
    }
    file("P_3.csv", 400, 3000.0);
    std::fs::write(folder.path().join("S_3.csv"), "").unwrap();
    let found = reduce(&[folder.path().to_owned()], &Options::default(), None, |_| ()).unwrap();
    let told: Vec<(Option<u64>, bool)> = found.points.iter().map(|point| (point.step, point.steady)).collect();
    assert_eq!(told, [(Some(0), true), (Some(1), false), (Some(2), false)]);
    for (point, samples) in found.points.iter().skip(1).zip([50, 10]) {
        let reason = point.reason.as_deref().unwrap();
        let near = [samples - 1, samples].iter().any(|count| reason.contains(&format!("too short: {count} samples")));
        assert!(near && reason.contains("a window of 3 s takes 113 samples, 0.90 s, at least"), "{reason}");
    }
    assert!(found.points[2].primary_speed.is_none());
    assert!(found.warnings.iter().any(|said| said == "no sample came out of step 3"), "{:?}", found.warnings);
    let (table, left_out) = points_csv(&found.points);
    assert_eq!((table.lines().count(), left_out), (2, 2));
}

#[test]
fn intervals_of_ten_parts_are_students() {
    let folder = tempfile::tempdir().unwrap();
    let mut random = Random::new(3);
    let noise: Vec<f64> = (0..400).map(|_| random.normal()).collect();
    let row = |at: f64| [3000.0 + 5.0 * noise[at as usize], 2000.0 + at % 3.0, 17.0 + 0.1 * noise[at as usize]];
    let (points, reports) = read(&[written(folder.path(), 400, row)], &Options::default());
    let figures = sheave::bench::dyno::figures(&points, &reports);
    let torque = figures.iter().find(|figure| figure.name == "torque").unwrap();
    let bars = &torque.series[0].points;
    let error = points[0].secondary_torque.unwrap().error;
    let half = 0.5 * (bars[1].1 - bars[0].1) / error;
    // Nine degrees of freedom.
    assert!(error > 0.0 && (half - 2.262_157).abs() < 1e-5, "{half}");
}

#[test]
fn endings_in_capitals_are_endings() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("RUN1.CSV"), log(TORQUE, 0, constant(17.0, 4))).unwrap();
    std::fs::write(folder.path().join("Calibration.CSV"), "torque,adc\n").unwrap();
    for name in ["P_3.CSV", "s_3.csv"] {
        std::fs::write(folder.path().join(name), "0,3000\n").unwrap();
    }
    let found = records(&[folder.path().to_owned()]).unwrap();
    let names: Vec<String> = found.iter().map(|record| record.name.rsplit('/').next().unwrap().to_owned()).collect();
    assert_eq!(names, ["step 3", "RUN1.CSV", "s_3.csv"]);
}

/// Quoted cells, and a name that a terminal would act on, on the way from a log to the table of points.
#[test]
fn names_of_files_may_have_anything() {
    let folder = tempfile::tempdir().unwrap();
    let [out, logs] = ["out", "logs"].map(|name| folder.path().join(name));
    std::fs::create_dir(&logs).unwrap();
    let name = "run, \"1\" \u{1b}[31m.csv";
    let header = "timestamp_ms,\"speed, engine\",\"secondary_rpm\",torque";
    std::fs::write(logs.join(name), log(header, 0, constant(17.0, 4))).unwrap();
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_sheave"));
    command.arg("dyno").arg(&logs).args(["--primary", "speed, engine", "--out"]).arg(&out);
    let output = command.output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(![output.stdout, output.stderr].concat().contains(&0x1b));
    let curve = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/made/engine.csv");
    let engine = sheave::bench::engine::EngineCurve::read(&curve).unwrap();
    let table = sheave::bench::compare::read(&out.join("operating-points.csv"), Some(&engine)).unwrap();
    assert_eq!((table.points.len(), table.bad.len()), (2, 0));
    assert!(table.points[0].run.ends_with("run, \"1\" \\u{1b}[31m.csv"), "{}", table.points[0].run);
}

#[test]
fn reducing_ends_when_it_is_cancelled() {
    let folder = tempfile::tempdir().unwrap();
    let path = written(folder.path(), 10_000, |at| [3000.0 + at % 7.0, 2000.0, 17.0]);
    let cancel = sheave::Cancel::new();
    cancel.cancel();
    let error = sheave::cancellable(&cancel, || reduce(&[path], &Options::default(), None, |_| ())).unwrap_err();
    assert!(matches!(error.problem(), sheave::bench::BenchProblem::Cancelled), "{error}");
}

/// A log that does not end, until Ctrl-C: one object that says so, and the status of an interrupt.
#[cfg(unix)]
#[test]
fn an_interrupt_ends_it_in_order() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("endless.csv");
    assert!(std::process::Command::new("mkfifo").arg(&path).status().unwrap().success());
    let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_sheave"))
        .args(["dyno", "--json"])
        .arg(&path)
        .stdout(std::process::Stdio::piped())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    let mut pipe = std::fs::OpenOptions::new().write(true).open(&path).unwrap();
    pipe.write_all(format!("{TORQUE}\n").as_bytes()).unwrap();
    let (mut at, mut asked) = (0_u64, false);
    loop {
        let rows: String = (at..at + 1000).map(|at| format!("{},{},2000,17\n", 8 * at, 3000 + at % 7)).collect();
        at += 1000;
        if pipe.write_all(rows.as_bytes()).is_err() {
            break;
        }
        if at > 50_000 && !asked {
            let interrupt = std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status();
            assert!(interrupt.unwrap().success());
            asked = true;
        }
        // It would never end of itself.
        if at > 20_000_000 {
            child.kill().unwrap();
        }
    }
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130), "{output:?}");
    let object: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((&object["command"], &object["failure"]["kind"]), (&"dyno".into(), &"cancelled".into()), "{object}");
}

/// Decimal commas make more cells than there are columns: such rows were read as what they are not.
#[test]
fn rows_with_decimal_commas_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("log.csv");
    let rows: String = (0..500).map(|at| format!("{},3000,5,2000,1,17,2\n", 8 * at)).collect();
    std::fs::write(&path, format!("{TORQUE}\n{rows}")).unwrap();
    let error = reduce(std::slice::from_ref(&path), &Options::default(), None, |_| ()).unwrap_err().to_string();
    assert!(error.contains("500 rows with more cells than columns"), "{error}");
    // Empty cells behind the last column are no values, and a mark of the byte order is no part of a number.
    let rows: String = (0..500).map(|at| format!("{},{},2000,17,,\n", 8 * at, 3000 + at % 5)).collect();
    std::fs::write(&path, format!("\u{feff}{TORQUE}\r\n{rows}")).unwrap();
    let (points, reports) = read(std::slice::from_ref(&path), &Options::default());
    assert_eq!((points.len(), reports[0].files[0].faults.total()), (2, 0));
    let step = folder.path().join("P_0.csv");
    let rows: String = (0..500).map(|at| format!("{},{}\r\n", 8000 * at, 3000 + at % 5)).collect();
    std::fs::write(&step, format!("\u{feff}{rows}")).unwrap();
    let (points, reports) = read(&[step], &Options::default());
    assert_eq!((points.len(), reports[0].files[0].faults.total()), (2, 0), "{}", reports[0].files[0].faults);
    std::fs::write(&path, TORQUE.replace(',', ";")).unwrap();
    let error = reduce(&[path], &Options::default(), None, |_| ()).unwrap_err().to_string();
    assert!(error.contains("its first line has no commas"), "{error}");
    let error = calibration::parse("c", b"torque;adc\n0;35145\n10;36227\n20;37309\n").unwrap_err().to_string();
    assert!(error.contains("line 2: expected torque and ADC") && error.contains("commas between"), "{error}");
}

/// Columns in other units than those in which they are read, and one that is asked for twice.
#[test]
fn units_of_headers_are_not_passed_over() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("log.csv");
    let found = |header: &str, names: [&str; 3], secondary_factor: f64| {
        std::fs::write(&path, log(header, 0, constant(17.0, 4))).unwrap();
        let [primary, secondary, torque] = names.map(|name| Some(name.to_owned()));
        let names = Names { primary, secondary, torque };
        reduce(std::slice::from_ref(&path), &Options { names, secondary_factor, ..Options::default() }, None, |_| ())
    };
    let rich = "\"Interval\"|\"ms\"|0|0|1,\"E\"|\"rpm\"|0|8000|50,\"W\"|\"mph\"|0|8000|50,\"T\"|\"V\"|0|200|50";
    let warnings = found(rich, ["E", "W", "T"], 1.0).unwrap().warnings;
    let said = "the column `T` is in V by its header and is read as N·m, `W` is in mph by its header and is read";
    assert!(warnings.iter().any(|warning| warning.starts_with(said)), "{warnings:?}");
    let warnings = found(rich, ["E", "W", "T"], 14.0).unwrap().warnings;
    assert!(warnings.iter().any(|warning| warning.starts_with("the column `T` is in V by")), "{warnings:?}");
    assert!(warnings.iter().all(|warning| !warning.contains("mph")), "{warnings:?}");
    let plain = "time_ms,engine (rpm),wheel [1/min],load (N*m)";
    assert!(found(plain, ["engine (rpm)", "wheel [1/min]", "load (N*m)"], 1.0).unwrap().warnings.is_empty());
    let error = found(plain, ["engine (rpm)", "engine (rpm)", "load (N*m)"], 1.0).unwrap_err().to_string();
    assert!(error.contains("the column `engine (rpm)` is asked for twice"), "{error}");
}

/// A header that has the unit of its torque behind the name is read in that unit.
#[test]
fn torque_is_read_in_the_unit_of_its_header() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("log.csv");
    let found = |header: &str, torque: f64, names: Names| {
        std::fs::write(&path, log(header, 0, constant(torque, 4))).unwrap();
        reduce(std::slice::from_ref(&path), &Options { names, ..Options::default() }, None, |_| ()).unwrap()
    };
    let mean = |found: &sheave::bench::dyno::Reduced| found.points[0].secondary_torque.unwrap().mean;
    let plain = mean(&found(TORQUE, 17.0, Names::default()));
    // Pound-feet and inch-pounds in N·m, NIST SP 811; values in a small unit may exceed 1000.
    let (foot, inch) = (1.355_817_948_331_400_4, 0.112_984_829_027_616_7);
    for (column, value, unit) in [
        ("torque (Nm)", 17.0, 1.0),
        ("Torque [N-m]", 17.0, 1.0),
        ("torque (lb-ft)", 17.0, foot),
        ("secondary_torque (ft-lb)", 17.0, foot),
        ("torque_nm (N*m)", 17.0, 1.0),
        ("torque [LBF*IN]", 1500.0, inch),
    ] {
        let found = found(&TORQUE.replace("torque", column), value, Names::default());
        assert!((mean(&found) / ((plain + value - 17.0) * unit) - 1.0).abs() < 1e-9, "{column}: {}", mean(&found));
        assert!(found.warnings.is_empty(), "{column}: {:?}", found.warnings);
    }
    // One that is named, with its unit or without it, and one of RaceCapture's.
    for name in ["load (lb-ft)", "load"] {
        let names = Names { torque: Some(name.into()), ..Names::default() };
        let found = found(&TORQUE.replace("torque", "load (lb-ft)"), 17.0, names);
        assert!((mean(&found) / (plain * foot) - 1.0).abs() < 1e-9 && found.warnings.is_empty(), "{name}");
    }
    let rich = "\"Interval\"|\"ms\"|0|0|1,\"primary\"|\"rpm\"|0|8000|50,\"secondary\"|\"rpm\"|0|8000|50,\
                \"torque\"|\"ft-lb\"|0|200|50";
    assert!((mean(&found(rich, 17.0, Names::default())) / (plain * foot) - 1.0).abs() < 1e-9);
    // A unit that is not known, and a torque that nothing says is one.
    let unknown = found(&TORQUE.replace("torque", "torque (mV)"), 17.0, Names::default());
    let said = "the column `torque (mV)` is in mV by its header and is read as N·m";
    assert!(unknown.warnings.iter().any(|warning| warning.starts_with(said)), "{:?}", unknown.warnings);
    assert!((mean(&unknown) / plain - 1.0).abs() < 1e-12);
    let other = found(&TORQUE.replace("torque", "brake torque"), 17.0, Names::default());
    assert!(other.points[0].secondary_torque.is_none());
    let said = "the column `brake torque` is not read as a torque, which is named with --torque";
    assert!(other.warnings.iter().any(|warning| warning.starts_with(said)), "{:?}", other.warnings);
}

/// A log of white noise about constant values at a rate of its own, for so many seconds.
fn noisy(folder: &Path, period: u32, seconds: u32, seed: u64) -> PathBuf {
    let mut random = Random::new(seed);
    let line = |at: u32| {
        let mut about = |mean: f64, deviation: f64| mean + deviation * random.normal();
        let (primary, secondary, torque) = (about(3000.0, 5.0), about(2500.0, 5.0), about(20.0, 0.5));
        format!("{},{primary:.3},{secondary:.3},{torque:.5}\n", period * at)
    };
    let path = folder.join("noisy.csv");
    let rows: String = (0..1000 * seconds / period).map(line).collect();
    std::fs::write(&path, format!("{TORQUE}\n{rows}")).unwrap();
    path
}

/// What is interpolated between two measured values is no measurement: intervals are those of what was measured.
#[test]
fn intervals_of_slow_logs_cover_the_truth_as_often_as_they_say() {
    let folder = tempfile::tempdir().unwrap();
    for (period, window, samples, parts) in
        [(200, 3.0, 15, 3), (100, 1.0, 10, 2), (100, 3.0, 30, 7), (50, 3.0, 60, 10), (8, 0.5, 63, 10)]
    {
        let path = noisy(folder.path(), period, (500.0 * window) as u32, 5);
        let options = Options { window, ..Options::default() };
        let (points, _) = read(&[path], &options);
        let of = |point: &SteadyPoint| [point.primary_speed, point.secondary_speed, point.secondary_torque];
        let (mut inside, mut all) = (0, 0);
        for point in points.iter().filter(|point| point.duration > 0.95 * window) {
            for (average, truth) in of(point).into_iter().zip([3000.0 * RPM, 2500.0 * RPM, 20.0]) {
                let average = average.unwrap();
                assert!(average.samples.abs_diff(samples) <= 1, "{period} ms: {}", average.samples);
                assert_eq!((average.parts, point.parts()), (parts, parts), "{period} ms");
                let half = sheave::bench::student(average.parts - 1) * average.error;
                inside += u32::from((average.mean - truth).abs() <= half);
                all += 1;
            }
        }
        let coverage = f64::from(inside) / f64::from(all);
        println!("{period} ms, {window} s: {inside} of {all}, {coverage:.3}");
        // The standard deviation of a share of 1400 and more is 0.6 %.
        assert!(all > 1400 && (0.925..0.975).contains(&coverage), "{period} ms, {window} s: {coverage}");
        let (table, _) = points_csv(&points);
        assert!(table.lines().next().unwrap().ends_with(",secondary_torque_se,n_parts"), "{table}");
        assert!(table.lines().nth(1).unwrap().ends_with(&format!(",{parts}")), "{table}");
    }
    // Of two or three measured values nothing is told, and that is said.
    let options = Options { window: 0.5, ..Options::default() };
    let error = reduce(&[noisy(folder.path(), 200, 20, 1)], &options, None, |_| ()).unwrap_err().to_string();
    assert!(error.contains("the primary's speed has 3 measured samples, too few for a standard error"), "{error}");
    assert!(error.contains("expected 8 or more (a longer --window)"), "{error}");
}
