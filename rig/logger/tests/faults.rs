//! Faults while the throttle is open: power must end in time, and the operator must read why.

#![allow(clippy::unwrap_used)]

use std::io;
use std::path::Path;

use rig_logger::calibration::Calibration;
use rig_logger::hardware::{Brake, Hardware, Outputs};
use rig_logger::interlock::{Cause, Mode};
use rig_logger::journal::{Recorder, Sink};
use rig_logger::runs::{self, Metadata};
use rig_logger::session::{OperatingLimits, PERIOD_US, Session, Status};
use rig_logger::simulated::{Fault, SimulatedRig};
use rig_logger::steady::{Nobody, Operator, Plan, run};

/// Writes nowhere, until it is full.
struct Disk {
    room: usize,
}

impl io::Write for Disk {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.room = self.room.checked_sub(bytes.len()).ok_or(io::ErrorKind::StorageFull)?;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Sink for Disk {
    fn synchronise(&mut self) -> io::Result<()> {
        Ok(())
    }
}

fn session(rig: SimulatedRig, room: usize) -> Session<SimulatedRig> {
    Session::new(rig, Calibration::THESIS, OperatingLimits::RIG, Recorder::over(Box::new(Disk { room })))
}

const SHORT: Plan = Plan { read_ms: 1000, longest_settling_ms: 4000, most_points: 14, ..Plan::THESIS };
/// By then the throttle is open and the first point is being settled or read.
const UNDER_WAY: u64 = 9_000_000;

/// Follows the rig from inside the test: when power last was on.
#[derive(Default)]
struct Observer {
    last_running: u64,
}

impl Operator for Observer {
    fn command(&mut self, status: &Status) -> Option<rig_logger::interlock::Command> {
        if status.mode == "Running" {
            self.last_running = status.time;
        }
        None
    }
}

/// Runs with a fault; the cause of the stop and the time in ms from the fault to the closed throttle.
fn with(fault: Fault) -> (Option<Cause>, u64, Status) {
    let mut rig = SimulatedRig::new(false);
    rig.fail_at(UNDER_WAY, fault);
    let mut session = session(rig, usize::MAX);
    let mut observer = Observer::default();
    run(&mut session, &SHORT, &mut observer);
    let cause = session.cause();
    let (status, mode) = (session.status().clone(), session.mode());
    let (mut rig, _) = session.finish();
    if fault != Fault::DoublePulses {
        assert!(!rig.power(), "{fault:?}: {mode:?}");
        assert!(matches!(mode, Mode::Stopping(_) | Mode::Tripped(_)), "{fault:?}: {mode:?} {status:?}");
    }
    (cause, (observer.last_running + PERIOD_US).saturating_sub(UNDER_WAY) / 1000, status)
}

#[test]
fn every_fault_ends_power_in_time_and_says_why() {
    let mut table = String::from("| fault | what the operator reads | throttle closed after |\n|---|---|---|\n");
    for (fault, expected, within_ms) in [
        (Fault::LinkLost, Cause::LinkLost, 220),
        (Fault::PrimarySpeedStuck, Cause::SpeedStuck, 1000),
        (Fault::SecondarySpeedStuck, Cause::SpeedStuck, 1000),
        (Fault::BothSpeedsStuck, Cause::SpeedsLost, 1000),
        (Fault::TorqueStuck, Cause::TorqueStuck, 700),
        (Fault::BrakeReleased, Cause::BrakeReleased, 3500),
        (Fault::BrakeJammed, Cause::BrakeJammed, 60_000),
        (Fault::RotorHot, Cause::RotorHot, 330),
        (Fault::TemperatureUnreadable, Cause::TemperatureUnreadable, 530),
        (Fault::Runaway, Cause::Overspeed, 10_000),
        (Fault::EmergencyStop, Cause::EmergencyStop, 20),
        (Fault::DeviceReset, Cause::DeviceRestarted, 20),
    ] {
        let (cause, after, status) = with(fault);
        assert_eq!(cause, Some(expected), "{fault:?}: {status:?}");
        assert!(status.message.contains(expected.message()), "{}", status.message);
        assert!(after <= within_ms, "{fault:?}: {after} ms");
        table.push_str(&format!("| {fault:?} | {} | {after} ms |\n", expected.message()));
    }
    println!("{table}");
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../target");
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join("faults.md"), table).unwrap();
}

/// Both sensors lose their supply while the engine runs away: it is not left to itself, and no point of zeros settles.
#[test]
fn both_speeds_lost_end_power_and_no_point_is_made_of_zeros() {
    for begin in [UNDER_WAY, 12_000_000, 12_500_000, 13_000_000, 13_500_000] {
        let mut rig = SimulatedRig::new(false);
        rig.fail_at(begin, Fault::BothSpeedsStuck);
        rig.fail_at(begin + 500_000, Fault::Runaway);
        let mut session = session(rig, usize::MAX);
        let mut observer = Observer::default();
        let points = run(&mut session, &SHORT, &mut observer);
        assert_eq!(session.cause(), Some(Cause::SpeedsLost), "{points:?}");
        assert!(session.status().message.contains("Both speeds are lost"), "{:?}", session.status());
        let after = observer.last_running.saturating_sub(begin) / 1000;
        assert!((700..800).contains(&after), "{after} ms");
        assert!(points.iter().all(|point| !point.settled || point.primary_rpm.0 > 2000.0), "{points:?}");
    }
}

/// Pulses of both shafts fail for so short a time that it is no reason to stop; the point is marked.
#[test]
fn a_point_with_a_gap_in_its_speeds_is_not_settled() {
    let gap = |begin: u64, end: u64| {
        let parent = tempfile::tempdir().unwrap();
        let mut rig = SimulatedRig::new(false);
        rig.fail_between(begin, end, Fault::BothSpeedsStuck);
        let metadata = Metadata::now("simulated", &rig.identity().unwrap(), Calibration::THESIS);
        let folder = runs::create(parent.path(), &metadata).unwrap();
        let recorder = Recorder::create(&folder).unwrap();
        let mut session = Session::new(rig, Calibration::THESIS, OperatingLimits::RIG, recorder);
        let points = run(&mut session, &Plan { most_points: 1, read_ms: 5000, ..Plan::THESIS }, &mut Nobody);
        assert_eq!(session.cause(), None, "{:?}", session.status());
        assert!(session.finish().1);
        runs::export(&folder).unwrap();
        let table = std::fs::read_to_string(folder.join("points.csv")).unwrap();
        (points[0], table.lines().nth(1).unwrap().ends_with(",true"))
    };
    let (whole, table) = gap(0, 0);
    assert!(whole.settled && table);
    // The point is read from the tenth second to the fifteenth.
    let begin = 12_000_000;
    let (gapped, table) = gap(begin, begin + 400_000);
    assert!(!gapped.settled && !table, "{gapped:?}");
    assert!((gapped.primary_rpm.0 - whole.primary_rpm.0).abs() < 0.1 * whole.primary_rpm.0, "{gapped:?} {whole:?}");
}

/// Every pulse twice is a nuisance, not a danger: it is counted, and the test goes on with right speeds.
#[test]
fn double_pulses_change_no_speed() {
    let mut rig = SimulatedRig::new(false);
    rig.fail_at(UNDER_WAY, Fault::DoublePulses);
    let mut session = session(rig, usize::MAX);
    let points = run(&mut session, &Plan { most_points: 3, ..SHORT }, &mut Nobody);
    assert_eq!((points.len(), session.cause()), (3, None));
    let frame = session.frame().unwrap();
    assert!(frame.snapshot.primary.bounces != 0 && !frame.snapshot.primary.too_fast);
    assert!(points.iter().all(|point| (2400.0..3800.0).contains(&point.primary_rpm.0)), "{points:?}");
}

#[test]
fn a_full_disk_stops_the_rig_and_says_so() {
    let mut session = session(SimulatedRig::new(false), 200_000);
    let points = run(&mut session, &SHORT, &mut Nobody);
    assert_eq!(session.cause(), Some(Cause::RecordingFailed), "{points:?}");
    assert!(session.status().message.contains("Nothing was deleted"));
    let (mut rig, written) = session.finish();
    assert!(!written && !rig.power());
}

/// The logger is killed under an open throttle: its outputs stay, and the measuring device takes the ignition away.
#[test]
fn a_dead_logger_loses_the_ignition() {
    let mut rig = SimulatedRig::new(false);
    rig.set(&Outputs { throttle_open: true, ignition: true, brake: Brake::Hold }).unwrap();
    for step in 1..300 {
        rig.run_to(step * PERIOD_US);
        let _ = rig.exchange(true);
    }
    assert!(rig.power());
    let killed = rig.now();
    rig.run_to(killed + 240_000);
    assert!(rig.power());
    rig.run_to(killed + 251_000);
    assert!(!rig.power());
    rig.run_to(killed + 20_000_000);
    assert!(rig.plant.speeds[0] < 10.0, "the engine stands still: {}", rig.plant.speeds[0]);
}
