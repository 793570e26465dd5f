//! What the measurements say about the rig itself: is the brake on, are the sensors alive.

use rig_core::Frame;

use crate::hardware::Brake;

/// Actuator travel, µs, after which the brake counts as put on.
pub const PRELOAD_US: i64 = 2_900_000;
/// Below this torque, N·m, a turning secondary is not braked.
const LEAST_TORQUE: f64 = 0.5;
/// How long, µs, a sensor may be silent or repeat itself while its shaft must turn.
const PATIENCE_US: u64 = 1_000_000;

/// What was found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Findings {
    /// The brake is on: its actuator has been, and a turning secondary shows torque.
    pub brake_on: bool,
    /// The torque does not follow the actuator.
    pub brake_jammed: bool,
    /// The torque is stale, or has been exactly the same for too long.
    pub torque_stuck: bool,
    /// A speed sensor is silent while its shaft must turn.
    pub speed_stuck: bool,
}

/// The observations behind it.
#[derive(Clone, Debug, Default)]
pub struct Watch {
    travel_us: i64,
    /// A test has found that the torque does not follow.
    pub brake_jammed: bool,
    torque: f64,
    last_value: u16,
    changed_at: u64,
    stale: bool,
    speeds: [f64; 2],
    time: u64,
    opened_at: u64,
    silent_since: [Option<u64>; 2],
}

impl Watch {
    /// The actuator was driven.
    pub fn moved(&mut self, brake: Brake, elapsed_us: u64) {
        let by = elapsed_us as i64;
        self.travel_us = match brake {
            Brake::Apply => self.travel_us + by,
            Brake::Release => (self.travel_us - by).max(0),
            Brake::Hold => self.travel_us,
        };
    }

    /// The throttle was opened.
    pub fn opened(&mut self, time: u64) {
        self.opened_at = time;
        self.changed_at = time;
        self.silent_since = [None; 2];
        self.brake_jammed = false;
    }

    /// A good frame came in.
    pub fn frame(&mut self, time: u64, frame: &Frame, torque: f64) {
        let snapshot = &frame.snapshot;
        let passed = (time - self.time) as f64 * 1e-6;
        self.torque += (torque - self.torque) * (passed / 0.3).min(1.0);
        self.time = time;
        if snapshot.torque != self.last_value {
            (self.last_value, self.changed_at) = (snapshot.torque, time);
        }
        self.stale = snapshot.torque_stale;
        self.speeds = [snapshot.primary.speed.rpm_exact(), snapshot.secondary.speed.rpm_exact()];
        // An engine under load has its secondary turning, and a turning secondary has its engine turning.
        let silent =
            [self.speeds[0] == 0.0 && self.speeds[1] > 500.0, self.speeds[1] == 0.0 && self.speeds[0] > 2600.0];
        for (since, silent) in self.silent_since.iter_mut().zip(silent) {
            *since = if silent { since.or(Some(time)) } else { None };
        }
    }

    /// What all of it means.
    #[must_use]
    pub fn findings(&self, running: bool) -> Findings {
        let long_open = self.time.saturating_sub(self.opened_at) > 2 * PATIENCE_US;
        let unloaded = running && long_open && self.speeds[1] > 500.0 && self.torque < LEAST_TORQUE;
        let unchanged = self.time.saturating_sub(self.changed_at) > PATIENCE_US / 4;
        let silent = self.silent_since.iter().flatten().any(|since| self.time.saturating_sub(*since) > PATIENCE_US / 4);
        Findings {
            brake_on: self.travel_us >= PRELOAD_US && !unloaded,
            brake_jammed: self.brake_jammed,
            torque_stuck: self.stale || (running && unchanged),
            speed_stuck: running && silent,
        }
    }
}
