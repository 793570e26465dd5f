//! What is recorded survives: a cut at any byte, a kill, a folder that is there already; and it comes back as it was.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

use proptest::prelude::*;
use rig_core::frame::FRAME_LENGTH;
use rig_logger::calibration::Calibration;
use rig_logger::journal::{JOURNAL, Journal, Record, Recorder};
use rig_logger::runs::{self, Metadata};

fn records() -> Vec<Record> {
    (0..60u64)
        .map(|place| match place % 4 {
            0 => Record::Frame { at: place, bytes: std::array::from_fn(|byte| (byte as u8).wrapping_mul(place as u8)) },
            1 => Record::Temperature { at: place, celsius: 20.0 + place as f64 / 3.0 },
            2 => Record::Point { at: place, number: place as u32, begins: place % 8 == 2 },
            _ => Record::Note { at: place, text: format!("note {place}: N·m, °C") },
        })
        .collect()
}

#[test]
fn a_cut_at_any_byte_loses_the_last_record_at_most() {
    let records = records();
    let lines: Vec<String> = records.iter().map(Record::line).collect();
    let whole = lines.concat().into_bytes();
    for cut in 0..=whole.len() {
        let journal = Journal::parse(&whole[..cut]);
        let mut complete = 0;
        let mut length = 0;
        for line in &lines {
            length += line.len();
            complete += usize::from(length <= cut);
        }
        assert_eq!(journal.records, records[..complete], "cut at {cut}");
        assert!(journal.bad_lines.len() <= 1);
    }
}

#[test]
fn one_disturbed_byte_loses_one_record() {
    let records = records();
    let whole: Vec<u8> = records.iter().flat_map(|record| record.line().into_bytes()).collect();
    for place in (0..whole.len()).step_by(7) {
        let mut bytes = whole.clone();
        bytes[place] ^= 0x04;
        let journal = Journal::parse(&bytes);
        // A disturbed line end joins two lines.
        assert!(journal.records.len() + 2 >= records.len(), "{place}");
        assert!(journal.records.iter().all(|record| records.contains(record)), "{place}");
    }
}

proptest! {
    #[test]
    fn no_bytes_panic(bytes in prop::collection::vec(any::<u8>(), 0..600)) {
        let _ = Journal::parse(&bytes);
    }

    #[test]
    fn a_record_comes_back_as_it_was(at: u64, bytes in prop::collection::vec(any::<u8>(), FRAME_LENGTH),
        celsius in -100.0..900.0) {
        for record in [Record::Frame { at, bytes: bytes.clone().try_into().unwrap() }, Record::Temperature { at,
            celsius }] {
            let line = record.line();
            prop_assert_eq!(Record::parse(line.strip_suffix('\n').unwrap()), Some(record));
        }
    }
}

fn metadata() -> Metadata {
    Metadata::now("simulated", &rig_core::device::identity([0, 1, 0]), Calibration::THESIS)
}

#[test]
fn every_run_has_a_folder_of_its_own_and_nothing_is_written_over() {
    let parent = tempfile::tempdir().unwrap();
    let first = runs::create(parent.path(), &metadata()).unwrap();
    let second = runs::create(parent.path(), &metadata()).unwrap();
    assert_ne!(first, second);
    assert!(Recorder::create(&first).unwrap().finish());
    assert!(Recorder::create(&first).is_err(), "a journal is never opened a second time");
    assert_eq!(runs::metadata(&first).unwrap().firmware, "0.1.0");
}

#[test]
fn a_file_that_a_run_lacks_is_named() {
    let parent = tempfile::tempdir().unwrap();
    let run = runs::create(parent.path(), &metadata()).unwrap();
    for lacking in [JOURNAL, "run.toml"] {
        let _ = std::fs::remove_file(run.join(lacking));
        for task in ["export", "replay"] {
            let output = program().arg(task).arg(&run).output().unwrap();
            let error = String::from_utf8(output.stderr).unwrap();
            assert!(!output.status.success() && error.contains(lacking), "{task}: {error}");
        }
    }
    std::fs::write(run.join("run.toml"), "calibration = 7\n").unwrap();
    let error = runs::metadata(&run).unwrap_err().to_string();
    assert!(error.contains("run.toml"), "{error}");
}

fn program() -> Command {
    Command::new(env!("CARGO_BIN_EXE_sheave-rig"))
}

fn export(run: &Path) -> String {
    let output = program().arg("export").arg(run).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// kill −9 in the midst of a run: the journal has at most one incomplete line, and the export works.
#[test]
fn a_killed_logger_leaves_a_run_that_can_be_read() {
    let parent = tempfile::tempdir().unwrap();
    let mut child = program()
        .args(["simulate", "--passes", "50", "--out"])
        .arg(parent.path())
        .stdout(Stdio::null())
        .spawn()
        .unwrap();
    let run = parent.path().join("run-0001");
    let journal = run.join(JOURNAL);
    // Until something has reached the disk; a minute is the limit on a slow machine.
    for _ in 0..600 {
        if std::fs::metadata(&journal).is_ok_and(|file| file.len() > 300_000) {
            break;
        }
        std::thread::sleep(Duration::from_millis(100));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    let read = Journal::read(&journal).unwrap();
    assert!(read.records.len() > 1000 && read.bad_lines.len() <= 1, "{} {:?}", read.records.len(), read.bad_lines);
    assert!(export(&run).contains(&format!("{} incomplete lines", read.bad_lines.len())));
    assert!(std::fs::read_to_string(run.join("log.csv")).unwrap().lines().count() > 1000);
    let replayed = program().arg("replay").arg(&run).output().unwrap();
    assert!(replayed.status.success() && String::from_utf8_lossy(&replayed.stdout).contains("putting the brake on"));
}
