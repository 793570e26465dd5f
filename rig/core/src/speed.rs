//! Speed from the moments at which a magnet passes a Hall sensor, once a revolution.
//!
//! A pulse earlier than the shortest plausible period is a bounce and is ignored (thesis, section 8.2.1: 10 ms for the
//! engine, 6 ms for the secondary). An interval of two or three times the period before it is a pulse that went
//! missing; after
//! three such in a row the next is believed: the shaft has really slowed down. A shaft without pulses stands still
//! after a time-out.

use crate::clock::{Instant, TICKS_PER_SECOND};

/// Revolutions that a speed is taken over, at most: two working cycles of a four-stroke engine, so that firing
/// averages out.
pub const REVOLUTIONS: usize = 4;

/// Intervals in a row that are taken for missing pulses: no shaft of the rig can halve its speed within one revolution.
const MOST_REPAIRS: u8 = 3;

/// What counts as a pulse, in ticks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PulseLimits {
    /// A pulse sooner than this after the one before it is a bounce.
    pub shortest_period: u32,
    /// Without a pulse for this long the shaft stands still.
    pub stopped_after: u32,
}

impl PulseLimits {
    /// The engine's shaft: 10 ms, so at most 6000 rpm (its governor holds 3800 rpm); at rest after 0.5 s.
    pub const PRIMARY: Self = Self { shortest_period: TICKS_PER_SECOND / 100, stopped_after: TICKS_PER_SECOND / 2 };
    /// The secondary's shaft: 6 ms, so at most 10,000 rpm (7600 rpm expected); at rest after 0.5 s.
    pub const SECONDARY: Self =
        Self { shortest_period: TICKS_PER_SECOND / 1000 * 6, stopped_after: TICKS_PER_SECOND / 2 };
}

/// A speed as it was counted: revolutions in a number of ticks. Both are zero for a shaft at rest.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Speed {
    /// Duration in ticks of 4 µs.
    pub ticks: u32,
    /// Whole revolutions in it.
    pub revolutions: u8,
}

impl Speed {
    /// A shaft that does not turn.
    pub const ZERO: Self = Self { ticks: 0, revolutions: 0 };

    /// Revolutions per minute, rounded to whole ones; 0 at rest.
    #[must_use]
    pub fn rpm(self) -> u16 {
        if self.ticks == 0 {
            return 0;
        }
        let rounded = (u32::from(self.revolutions) * (60 * TICKS_PER_SECOND) + self.ticks / 2) / self.ticks;
        if rounded > u32::from(u16::MAX) { u16::MAX } else { rounded as u16 }
    }

    /// Revolutions per minute; 0 at rest.
    #[must_use]
    pub fn rpm_exact(self) -> f64 {
        if self.ticks == 0 {
            0.0
        } else {
            f64::from(self.revolutions) * 60.0 * f64::from(TICKS_PER_SECOND) / f64::from(self.ticks)
        }
    }
}

/// What became of a pulse.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The first after standing still: no period yet.
    First,
    /// The end of one revolution.
    Revolution,
    /// The end of so many revolutions, of which all but one pulse went missing.
    Repaired(u8),
    /// Too soon to be a revolution.
    Bounce,
}

/// What a meter knows at a moment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reading {
    /// The speed; [`Speed::ZERO`] at rest and before the first whole revolution.
    pub speed: Speed,
    /// When the last accepted pulse came, if any did.
    pub last_pulse: Option<Instant>,
    /// No pulse within the time-out.
    pub stopped: bool,
    /// Three revolutions, more than those without, had a pulse in their midst that came too late to be a bounce: the
    /// shaft turns faster than
    /// the shortest period allows, and the speed is a fraction of the true one.
    pub too_fast: bool,
    /// Pulses ignored as bounces since the start, modulo 256.
    pub bounces: u8,
    /// Pulses found missing since the start, modulo 256.
    pub missing: u8,
    /// Pulses accepted since the start, modulo 65,536.
    pub accepted: u16,
}

impl Reading {
    /// A shaft of which nothing is known.
    pub const EMPTY: Self = Self {
        speed: Speed::ZERO,
        last_pulse: None,
        stopped: true,
        too_fast: false,
        bounces: 0,
        missing: 0,
        accepted: 0,
    };
}

/// One shaft's pulses.
#[derive(Clone, Copy, Debug)]
pub struct SpeedMeter {
    limits: PulseLimits,
    last: Option<Instant>,
    intervals: [Speed; REVOLUTIONS],
    filled: u8,
    next: u8,
    period: u32,
    repaired: u8,
    latest_ignored: u32,
    too_fast_for: u8,
    bounces: u8,
    missing: u8,
    accepted: u16,
}

impl SpeedMeter {
    /// A shaft at rest.
    #[must_use]
    pub const fn new(limits: PulseLimits) -> Self {
        Self {
            limits,
            last: None,
            intervals: [Speed::ZERO; REVOLUTIONS],
            filled: 0,
            next: 0,
            period: 0,
            repaired: 0,
            latest_ignored: 0,
            too_fast_for: 0,
            bounces: 0,
            missing: 0,
            accepted: 0,
        }
    }

    /// A pulse at a moment.
    #[inline(never)]
    pub fn pulse(&mut self, at: Instant) -> Verdict {
        let Some(last) = self.last else { return self.restart(at) };
        let since = at.since(last);
        if since < self.limits.shortest_period {
            self.bounces = self.bounces.wrapping_add(1);
            self.latest_ignored = since;
            return Verdict::Bounce;
        }
        if since >= self.limits.stopped_after {
            return self.restart(at);
        }
        self.last = Some(at);
        self.accepted = self.accepted.wrapping_add(1);
        let late = self.latest_ignored > since / 4;
        self.too_fast_for = if late { (self.too_fast_for + 1).min(8) } else { self.too_fast_for.saturating_sub(1) };
        self.latest_ignored = 0;
        self.interval(since)
    }

    fn restart(&mut self, at: Instant) -> Verdict {
        self.last = Some(at);
        self.accepted = self.accepted.wrapping_add(1);
        self.filled = 0;
        self.next = 0;
        self.period = 0;
        self.repaired = 0;
        self.latest_ignored = 0;
        self.too_fast_for = 0;
        Verdict::First
    }

    fn interval(&mut self, since: u32) -> Verdict {
        let revolutions = self.revolutions_in(since);
        if revolutions > 1 && self.repaired < MOST_REPAIRS {
            self.repaired += 1;
            self.missing = self.missing.wrapping_add(revolutions - 1);
            self.push(Speed { ticks: since, revolutions });
            return Verdict::Repaired(revolutions);
        }
        if revolutions > 1 {
            // As long as those before: the shaft has slowed down, and what was taken for missing pulses was none.
            self.filled = 0;
            self.next = 0;
        }
        self.repaired = 0;
        self.period = since;
        self.push(Speed { ticks: since, revolutions: 1 });
        Verdict::Revolution
    }

    /// 2 or 3 if `since` is that many times the last period within a quarter of it, else 1.
    fn revolutions_in(&self, since: u32) -> u8 {
        let margin = self.period / 4;
        if margin == 0 {
            return 1;
        }
        let mut multiple = self.period;
        for revolutions in 2..=3 {
            multiple += self.period;
            if since.abs_diff(multiple) < margin {
                return revolutions;
            }
        }
        1
    }

    fn push(&mut self, interval: Speed) {
        if let Some(place) = self.intervals.get_mut(usize::from(self.next)) {
            *place = interval;
        }
        self.next = if usize::from(self.next) + 1 < REVOLUTIONS { self.next + 1 } else { 0 };
        if usize::from(self.filled) < REVOLUTIONS {
            self.filled += 1;
        }
    }

    /// The speed at a moment.
    ///
    /// Over the last [`REVOLUTIONS`] intervals; once no pulse has come for two and a half periods, the speed that a
    /// pulse
    /// at this moment would give, which is an upper bound; zero after the time-out.
    #[must_use]
    pub fn reading(&self, now: Instant) -> Reading {
        let mut reading = Reading::EMPTY;
        self.observe(now, &mut reading);
        reading
    }

    /// The same, written in place.
    #[inline(never)]
    pub fn observe(&self, now: Instant, reading: &mut Reading) {
        let elapsed = self.last.map_or(u32::MAX, |last| now.since(last));
        let stopped = elapsed >= self.limits.stopped_after;
        reading.speed = if stopped { Speed::ZERO } else { self.speed(elapsed) };
        reading.last_pulse = self.last;
        reading.stopped = stopped;
        reading.too_fast = !stopped && self.too_fast_for >= 3;
        reading.bounces = self.bounces;
        reading.missing = self.missing;
        reading.accepted = self.accepted;
    }

    #[inline(never)]
    fn speed(&self, elapsed: u32) -> Speed {
        let mut sum = Speed::ZERO;
        for interval in self.intervals.iter().take(usize::from(self.filled)) {
            sum.ticks += interval.ticks;
            sum.revolutions += interval.revolutions;
        }
        // Four intervals of less than `stopped_after` each: products of some 1e8 fit in 32 bits.
        if sum.ticks > 0 && elapsed.saturating_mul(u32::from(sum.revolutions) * 2) > sum.ticks.saturating_mul(5) {
            return Speed { ticks: elapsed, revolutions: 1 };
        }
        sum
    }
}
