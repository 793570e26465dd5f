//! Time: a 16-bit hardware counter of 4 µs steps, continued in software without ever rolling over.

/// Microseconds in one tick: 16 MHz divided by the prescaler of 64.
pub const TICK_MICROSECONDS: u32 = 4;
/// Ticks in one second.
pub const TICKS_PER_SECOND: u32 = 1_000_000 / TICK_MICROSECONDS;

/// A moment, in ticks of 4 µs since the microcontroller started.
///
/// 48 of the 64 bits come from the counter and its overflows: it would roll over after 35 years.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Instant(pub u64);

impl Instant {
    /// Ticks from `earlier` to this moment; zero if `earlier` is later, `u32::MAX` if it is more than 4.7 hours ago.
    #[must_use]
    pub fn since(self, earlier: Self) -> u32 {
        let ticks = self.0.saturating_sub(earlier.0);
        if ticks > u32::MAX as u64 { u32::MAX } else { ticks as u32 }
    }

    /// Microseconds since the start.
    #[must_use]
    pub fn microseconds(self) -> u64 {
        self.0.wrapping_mul(TICK_MICROSECONDS as u64)
    }

    /// The moment `microseconds` after the start, rounded down to a whole tick.
    #[must_use]
    pub fn from_microseconds(microseconds: u64) -> Self {
        Self(microseconds / TICK_MICROSECONDS as u64)
    }

    /// What the thesis's program sends: microseconds in 32 bits, which roll over after 71.6 minutes (Appendix G).
    #[must_use]
    pub fn legacy_stamp(self) -> u32 {
        self.microseconds() as u32
    }
}

/// The overflows of a 16-bit counter.
#[derive(Clone, Copy, Debug, Default)]
pub struct Clock {
    overflows: u32,
}

impl Clock {
    /// A clock that starts now.
    #[must_use]
    pub const fn new() -> Self {
        Self { overflows: 0 }
    }

    /// A clock whose counter has overflowed `overflows` times already.
    #[must_use]
    pub const fn with_overflows(overflows: u32) -> Self {
        Self { overflows }
    }

    /// To be called once for every overflow of the counter, from its interrupt.
    pub fn overflow(&mut self) {
        self.overflows = self.overflows.wrapping_add(1);
    }

    /// The present moment from the counter's value.
    ///
    /// `overflow_pending` says that the counter has overflowed and its interrupt has not run yet: the flag must be read
    /// *after* the counter. A small value then belongs to the time after the overflow, a large one was read before it.
    #[must_use]
    pub fn instant(&self, counter: u16, overflow_pending: bool) -> Instant {
        let turned = overflow_pending && counter < 0x8000;
        let high = self.overflows.wrapping_add(u32::from(turned)).to_le_bytes();
        let low = counter.to_le_bytes();
        // Byte by byte: a shift of 64 bits is a loop on an 8-bit processor, and this runs in interrupts.
        Instant(u64::from_le_bytes([low[0], low[1], high[0], high[1], high[2], high[3], 0, 0]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn time_goes_on_over_every_roll_over_of_the_counter_and_of_32_bits() {
        let before = Clock::with_overflows(u16::MAX as u32);
        let mut after = before;
        after.overflow();
        assert_eq!(after.instant(0, false).since(before.instant(u16::MAX, false)), 1);
        // 2^32 µs, where the thesis's stamp starts anew, is nothing special here.
        let roll_over = Instant::from_microseconds(1 << 32);
        assert_eq!(roll_over.legacy_stamp(), 0);
        assert_eq!(roll_over.since(Instant(roll_over.0 - 10)), 10);
    }

    #[test]
    fn an_overflow_that_waits_for_its_interrupt_counts_once() {
        let mut clock = Clock::with_overflows(7);
        let pending = clock.instant(3, true);
        let early = clock.instant(0xfffe, true);
        clock.overflow();
        assert_eq!(clock.instant(3, false), pending);
        assert_eq!(pending.since(early), 5);
    }

    #[test]
    fn a_long_time_and_a_time_that_runs_backwards_saturate() {
        assert_eq!(Instant(1 << 40).since(Instant(0)), u32::MAX);
        assert_eq!(Instant(1).since(Instant(2)), 0);
    }
}
