//! What the device knows at one moment.

use crate::clock::Instant;
use crate::speed::Reading;

/// What is only counted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counters {
    /// Good conversions since the start, modulo 256.
    pub conversions: u8,
    /// Bad conversions since the start, modulo 256.
    pub conversion_errors: u8,
    /// The processor's own account of why it started: bit 0 power, 1 reset pin, 2 low voltage, 3 watchdog.
    pub reset_cause: u8,
}

/// Everything that is known at one moment, of one piece.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Snapshot {
    /// The moment.
    pub now: Instant,
    /// The engine's shaft.
    pub primary: Reading,
    /// The secondary's shaft.
    pub secondary: Reading,
    /// The converter's last good value.
    pub torque: u16,
    /// When it was ready.
    pub torque_at: Option<Instant>,
    /// No good conversion within [`TORQUE_STALE_TICKS`](crate::device::TORQUE_STALE_TICKS).
    pub torque_stale: bool,
    /// The run permit holds.
    pub permitted: bool,
    /// Counts.
    pub counters: Counters,
}

impl Snapshot {
    /// Nothing known.
    pub const EMPTY: Self = Self {
        now: Instant(0),
        primary: Reading::EMPTY,
        secondary: Reading::EMPTY,
        torque: 0,
        torque_at: None,
        torque_stale: true,
        permitted: false,
        counters: Counters { conversions: 0, conversion_errors: 0, reset_cause: 0 },
    };
}
