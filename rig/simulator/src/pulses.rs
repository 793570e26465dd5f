//! Hall pulses as an engine makes them: with jitter, bounces and gaps, from a fixed seed.

use crate::{Bench, CYCLES_PER_SECOND, Event};

/// A small generator of random numbers (xorshift64*): the same numbers for the same seed on every machine.
pub struct Random(u64);

impl Random {
    /// A generator.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    /// The next number, uniform in 0..1.
    pub fn uniform(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// What disturbs a pulse train.
#[derive(Clone, Copy, Debug, Default)]
pub struct Disturbance {
    /// Every pulse comes early or late by up to this fraction of a period.
    pub jitter: f64,
    /// Further edges, up to this many, within 3 ms after a pulse.
    pub bounces: u32,
    /// Probability that a pulse is missing.
    pub missing: f64,
}

/// Schedules the pulses of one shaft from cycle `from` to `to` and returns the cycles of the true passages.
pub fn schedule(
    bench: &mut Bench,
    pin: u8,
    rpm: f64,
    (from, to): (u64, u64),
    with: Disturbance,
    seed: u64,
) -> Vec<u64> {
    let mut random = Random::new(seed);
    let period = 60.0 * CYCLES_PER_SECOND as f64 / rpm;
    let mut passages = Vec::new();
    let mut centre = from as f64 + period * random.uniform();
    let mut skipped = true;
    while centre < to as f64 {
        let at = (centre + period * with.jitter * (2.0 * random.uniform() - 1.0)) as u64;
        centre += period;
        // Never two in a row: what is not to be confused with a shaft of half the speed.
        skipped = !skipped && random.uniform() < with.missing;
        if skipped && with.missing > 0.0 {
            continue;
        }
        passages.push(at);
        bench.schedule(at, Event::Pin(pin, false));
        let mut edge = at;
        for _ in 0..with.bounces {
            let room = CYCLES_PER_SECOND as f64 * 0.003 / f64::from(with.bounces + 1);
            bench.schedule(edge + (room * 0.3) as u64, Event::Pin(pin, true));
            edge += (room * (0.4 + 0.6 * random.uniform())) as u64;
            bench.schedule(edge, Event::Pin(pin, false));
        }
        bench.schedule(edge + CYCLES_PER_SECOND / 2000, Event::Pin(pin, true));
    }
    passages
}
