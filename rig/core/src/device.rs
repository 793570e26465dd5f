//! The measuring device as a whole: two shafts, the converter, the permit; and what it answers on the bus.
//!
//! The firmware owns one [`Device`]; the simulated rig owns one, too, and feeds it pulses and conversions that it
//! makes up.

use crate::ad7171::ConversionError;
use crate::clock::{Instant, TICKS_PER_SECOND};
use crate::frame::{FRAME_LENGTH, Identity, LEGACY_LENGTH, renumber, write_frame, write_legacy};
use crate::permit::{PERMIT_TICKS, RunPermit};
use crate::snapshot::{Counters, Snapshot};
use crate::speed::{PulseLimits, REVOLUTIONS, SpeedMeter};

/// After this long without a good conversion the torque is stale: 100 ms, a dozen conversions.
pub const TORQUE_STALE_TICKS: u32 = TICKS_PER_SECOND / 10;

/// The device.
#[derive(Clone, Copy, Debug)]
pub struct Device {
    /// The engine's shaft.
    pub primary: SpeedMeter,
    /// The secondary's shaft.
    pub secondary: SpeedMeter,
    /// The run permit.
    pub permit: RunPermit,
    torque: u16,
    torque_at: Option<Instant>,
    counters: Counters,
}

impl Device {
    /// A device that has just started, for the reason given (see [`Counters::reset_cause`]).
    #[must_use]
    pub const fn new(reset_cause: u8) -> Self {
        Self {
            primary: SpeedMeter::new(PulseLimits::PRIMARY),
            secondary: SpeedMeter::new(PulseLimits::SECONDARY),
            permit: RunPermit::new(),
            torque: 0,
            torque_at: None,
            counters: Counters { conversions: 0, conversion_errors: 0, reset_cause },
        }
    }

    /// Why the processor started (see [`Counters::reset_cause`]).
    pub fn started_because(&mut self, reset_cause: u8) {
        self.counters.reset_cause = reset_cause;
    }

    /// A conversion came in.
    pub fn conversion(&mut self, at: Instant, result: Result<u16, ConversionError>) {
        match result {
            Ok(value) => {
                self.torque = value;
                self.torque_at = Some(at);
                self.counters.conversions = self.counters.conversions.wrapping_add(1);
            }
            Err(_) => self.counters.conversion_errors = self.counters.conversion_errors.wrapping_add(1),
        }
    }

    /// All there is to know now.
    #[must_use]
    pub fn snapshot(&mut self, now: Instant) -> Snapshot {
        let mut snapshot = Snapshot::EMPTY;
        self.observe(now, &mut snapshot);
        snapshot
    }

    /// The same, written in place.
    #[inline(never)]
    pub fn observe(&mut self, now: Instant, snapshot: &mut Snapshot) {
        snapshot.now = now;
        self.primary.observe(now, &mut snapshot.primary);
        self.secondary.observe(now, &mut snapshot.secondary);
        snapshot.torque = self.torque;
        snapshot.torque_at = self.torque_at;
        snapshot.torque_stale = self.torque_at.is_none_or(|at| now.since(at) >= TORQUE_STALE_TICKS);
        snapshot.permitted = self.permit.holds(now);
        snapshot.counters = self.counters;
    }
}

/// The firmware's own description, with its version from the package.
#[must_use]
pub const fn identity(firmware: [u8; 3]) -> Identity {
    Identity {
        firmware,
        tick_microseconds: crate::clock::TICK_MICROSECONDS as u8,
        revolutions: REVOLUTIONS as u8,
        primary_shortest_period: PulseLimits::PRIMARY.shortest_period,
        secondary_shortest_period: PulseLimits::SECONDARY.shortest_period,
        permit_centiseconds: (PERMIT_TICKS / (TICKS_PER_SECOND / 100)) as u16,
    }
}

/// All answers about measurements, made from one snapshot, so that no value in them is torn.
#[derive(Clone, Copy, Debug)]
pub struct BusAnswer {
    /// The versioned frame.
    pub frame: [u8; FRAME_LENGTH],
    /// The thesis's frame.
    pub legacy: [u8; LEGACY_LENGTH],
}

impl BusAnswer {
    /// Nothing measured yet.
    #[must_use]
    pub const fn empty() -> Self {
        Self { frame: [0; FRAME_LENGTH], legacy: [0; LEGACY_LENGTH] }
    }

    /// Gives the versioned frame another sequence number.
    pub fn renumber(&mut self, sequence: u16) {
        renumber(&mut self.frame, sequence);
    }

    /// The answers for a snapshot.
    pub fn fill(&mut self, snapshot: &Snapshot, sequence: u16) {
        write_frame(&mut self.frame, sequence, snapshot);
        write_legacy(&mut self.legacy, snapshot);
    }
}
