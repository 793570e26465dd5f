//! Faults while the throttle is open: power must end in time, and the operator must read why.

#![allow(clippy::unwrap_used)]

use std::io;

use rig_logger::calibration::Calibration;
use rig_logger::hardware::{Brake, Hardware, Outputs};
use rig_logger::interlock::{Cause, Mode};
use rig_logger::journal::{Recorder, Sink};
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
    std::fs::write(concat!(env!("CARGO_MANIFEST_DIR"), "/../target/faults.md"), table).unwrap();
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
