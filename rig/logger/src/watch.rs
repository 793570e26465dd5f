//! What the measurements say about the rig itself: is the brake on, are the sensors alive.

use rig_core::Frame;

use crate::hardware::Brake;

/// Actuator travel, µs, after which the brake counts as put on.
pub const PRELOAD_US: i64 = 2_900_000;
/// Below this torque, N·m, a turning secondary is not braked.
const LEAST_TORQUE: f64 = 0.5;
/// How long, µs, a sensor may be silent or repeat itself while its shaft must turn.
const PATIENCE_US: u64 = 1_000_000;
/// An engine that turns faster than this, rpm, runs by itself: no starter turns it so fast.
pub const IDLING_RPM: f64 = 1300.0;
/// How long, µs, it must have done so to count as idling.
pub const IDLING_US: u64 = 1_000_000;
/// Without a pulse for so long, µs, a shaft's speed is none to be averaged: below 300 rpm no operating point lies.
const PULSELESS_US: u64 = 200_000;

/// Whether a frame shows no present speed of a shaft: it stands still, or its last pulse is long ago.
#[must_use]
pub(crate) fn speed_lost(frame: &Frame) -> bool {
    let now = frame.snapshot.now.microseconds();
    [&frame.snapshot.primary, &frame.snapshot.secondary].into_iter().any(|shaft| {
        shaft.stopped || shaft.last_pulse.is_none_or(|pulse| now.saturating_sub(pulse.microseconds()) > PULSELESS_US)
    })
}

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
    /// Neither shaft shows pulses under an open throttle: both sensors are lost at once, or the engine has stalled.
    pub speeds_lost: bool,
    /// The engine idles, and has done so for long enough.
    pub idling: bool,
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
    both_silent_since: Option<u64>,
    idling_since: Option<u64>,
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
        self.both_silent_since = None;
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
        // Neither can be judged by the other where both are silent, as after a break of their common supply.
        let since = |since: Option<u64>, holds: bool| if holds { since.or(Some(time)) } else { None };
        self.both_silent_since = since(self.both_silent_since, self.speeds == [0.0; 2]);
        self.idling_since = since(self.idling_since, self.speeds[0] > IDLING_RPM);
    }

    /// What all of it means.
    #[must_use]
    pub fn findings(&self, running: bool) -> Findings {
        let long_open = self.time.saturating_sub(self.opened_at) > 2 * PATIENCE_US;
        let unloaded = running && long_open && self.speeds[1] > 500.0 && self.torque < LEAST_TORQUE;
        let unchanged = self.time.saturating_sub(self.changed_at) > PATIENCE_US / 4;
        let longer = |since: &u64, than: u64| self.time.saturating_sub(*since) > than;
        let silent = self.silent_since.iter().flatten().any(|since| longer(since, PATIENCE_US / 4));
        let both_silent = self.both_silent_since.is_some_and(|since| longer(&since, PATIENCE_US / 4));
        Findings {
            brake_on: self.travel_us >= PRELOAD_US && !unloaded,
            brake_jammed: self.brake_jammed,
            torque_stuck: self.stale || (running && unchanged),
            speed_stuck: running && silent,
            speeds_lost: running && both_silent,
            idling: self.idling_since.is_some_and(|since| longer(&since, IDLING_US)),
        }
    }
}
