//! Time stamps of a counter that wraps, may be reset, and may be garbled.

use super::faults::Fault;

/// A counter of 32 bits wraps after this many ticks.
pub const WRAP: f64 = 4_294_967_296.0;
/// Two stamps in a row are no farther apart, s; what is farther is believed when the next stamp confirms it.
const LEAP: f64 = 10.0;

/// Makes seconds that never fall of the ticks of a counter.
#[derive(Debug, Clone)]
pub struct Clock {
    /// Seconds per tick.
    tick: f64,
    /// Ticks that are added to what the counter says.
    offset: f64,
    /// The last time, in ticks with the offset.
    last: Option<f64>,
    /// A time, with the counter's own ticks, that the next has to confirm.
    held: Option<f64>,
    /// How often the counter has wrapped.
    pub wraps: u64,
    /// How often it jumped: a pause, or a reset.
    pub jumps: u64,
}

/// What a stamp means.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stamp {
    /// Seconds.
    At(f64),
    /// Seconds, behind a jump that an earlier stamp made and this one confirms.
    Behind(f64),
    /// It is not used.
    Bad(Fault),
    /// The same as the one before.
    Same,
    /// It will only be used if the next confirms it.
    Held,
}

impl Clock {
    /// A counter with that many seconds per tick.
    pub fn new(tick: f64) -> Self {
        Self { tick, offset: 0.0, last: None, held: None, wraps: 0, jumps: 0 }
    }

    /// Reads one stamp. A stamp that is held counts as out of sequence when the next does not confirm it.
    pub fn read(&mut self, ticks: f64) -> (Stamp, Option<Fault>) {
        if !(0.0..1e18).contains(&ticks) {
            return (Stamp::Bad(Fault::OutOfSequence), None);
        }
        let Some(last) = self.last else {
            self.last = Some(ticks);
            return (Stamp::At(ticks * self.tick), None);
        };
        let near = |time: f64, before: f64| time >= before && (time - before) * self.tick <= LEAP;
        let time = ticks + self.offset;
        if time == last {
            return (Stamp::Same, None);
        }
        if near(time, last) {
            return self.accept(time, false);
        }
        if ticks < WRAP && last - self.offset < WRAP && near(time + WRAP, last) {
            self.offset += WRAP;
            self.wraps += 1;
            return self.accept(time + WRAP, false);
        }
        match self.held.replace(ticks) {
            Some(held) if near(ticks, held) && ticks > held => {
                // Two agree: the counter has jumped. Time goes on from the last, so that it never falls.
                self.held = None;
                self.jumps += 1;
                if time < last {
                    self.offset = last - held;
                }
                self.accept(ticks + self.offset, true)
            }
            Some(_) => (Stamp::Held, Some(Fault::OutOfSequence)),
            None => (Stamp::Held, None),
        }
    }

    fn accept(&mut self, time: f64, jumped: bool) -> (Stamp, Option<Fault>) {
        let refuted = self.held.take().map(|_| Fault::OutOfSequence);
        self.last = Some(time);
        let seconds = time * self.tick;
        (if jumped { Stamp::Behind(seconds) } else { Stamp::At(seconds) }, refuted)
    }

    /// Whether the last stamp is still unconfirmed.
    pub fn pending(&self) -> bool {
        self.held.is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn times(stamps: &[f64]) -> (Vec<f64>, Clock) {
        let mut clock = Clock::new(1e-6);
        let seconds = stamps.iter().filter_map(|ticks| match clock.read(*ticks).0 {
            Stamp::At(time) | Stamp::Behind(time) => Some(time),
            Stamp::Bad(_) | Stamp::Same | Stamp::Held => None,
        });
        (seconds.collect(), clock)
    }

    #[test]
    fn a_wrap_is_no_step_back() {
        let (seconds, clock) = times(&[4_294_960_000.0, 4_294_967_000.0, 704.0, 8704.0]);
        assert_eq!(clock.wraps, 1);
        let steps: Vec<f64> = seconds.windows(2).map(|pair| ((pair[1] - pair[0]) * 1e6).round()).collect();
        assert_eq!(steps, [7000.0, 1000.0, 8000.0]);
    }

    #[test]
    fn one_garbled_stamp_is_dropped_and_a_true_jump_is_kept() {
        let (seconds, clock) = times(&[1000.0, 9000.0, 3_000_000_000.0, 17000.0, 5.0, 25000.0]);
        assert_eq!((seconds.len(), clock.jumps), (4, 0));
        let (seconds, clock) = times(&[1000.0, 9000.0, 500e6, 500.008e6, 500.016e6]);
        assert_eq!((seconds.len(), clock.jumps), (4, 1));
        // A counter that was set to zero.
        let (seconds, clock) = times(&[70e6, 70.008e6, 100.0, 8100.0, 16100.0]);
        assert_eq!((seconds.len(), clock.jumps), (4, 1));
        assert!(seconds.windows(2).all(|pair| pair[1] > pair[0]), "{seconds:?}");
    }
}
