//! Time stamps of a counter that wraps, may be reset, and may be garbled.

/// A counter of 32 bits wraps after this many ticks.
pub const WRAP: f64 = 4_294_967_296.0;
/// A stamp no farther behind the one before is believed as it is, s; so is one within [`STEADY`] of the last steps.
const NEAR: f64 = 0.5;
/// Steps of a slow counter that are believed.
const STEADY: f64 = 20.0;
/// A stamp that is farther is believed when the next one follows it within this time, s.
const LEAP: f64 = 10.0;

/// Makes seconds of the ticks of a counter.
#[derive(Debug, Clone)]
pub struct Clock {
    /// Seconds per tick.
    tick: f64,
    /// Ticks that are added to what the counter says.
    offset: f64,
    /// The last time, in ticks with the offset.
    last: Option<f64>,
    /// The step to it, in ticks.
    step: f64,
    /// A time, in the counter's own ticks, that the next has to confirm: the first of all, or one far from the last.
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
    /// Seconds of the stamp that was held, and of this one, which confirms it.
    Confirmed(f64, f64),
    /// It cannot be a time.
    Bad,
    /// The same as the one before.
    Same,
    /// It will only be used if the next confirms it.
    Held,
}

impl Clock {
    /// A counter with that many seconds per tick.
    pub fn new(tick: f64) -> Self {
        Self { tick, offset: 0.0, last: None, step: 0.0, held: None, wraps: 0, jumps: 0 }
    }

    /// Reads one stamp. Says too whether it refutes the one that was held, which is then out of sequence.
    pub fn read(&mut self, ticks: f64) -> (Stamp, bool) {
        if !(0.0..1e18).contains(&ticks) {
            return (Stamp::Bad, false);
        }
        if let Some(last) = self.last {
            let time = ticks + self.offset;
            if time == last {
                return (Stamp::Same, false);
            }
            let most = (NEAR / self.tick).max(STEADY * self.step).min(LEAP / self.tick);
            let near = |time: f64| time > last && time - last <= most;
            let turned = ticks < WRAP && last - self.offset < WRAP && near(time + WRAP);
            if near(time) || turned {
                if turned && !near(time) {
                    self.offset += WRAP;
                    self.wraps += 1;
                }
                return (Stamp::At(self.go(ticks)), self.held.take().is_some());
            }
        }
        match self.held {
            Some(held) if held == ticks => (Stamp::Same, false),
            Some(held) if ticks > held && (ticks - held) * self.tick <= LEAP => self.confirm(held, ticks, 0.0),
            Some(held) if ticks < WRAP && held < WRAP && (ticks + WRAP - held) * self.tick <= LEAP => {
                self.wraps += 1;
                self.confirm(held, ticks, WRAP)
            }
            other => {
                self.held = Some(ticks);
                (Stamp::Held, other.is_some())
            }
        }
    }

    /// Two stamps agree: the counter begins there, or it has jumped.
    fn confirm(&mut self, held: f64, ticks: f64, turn: f64) -> (Stamp, bool) {
        self.held = None;
        if let Some(last) = self.last {
            self.jumps += 1;
            // A counter that was set back goes on from the last time. Where it is a little behind only, the last was
            // wrong.
            if held + self.offset + LEAP / self.tick < last {
                self.offset = last - held;
            }
        }
        let first = self.go(held);
        self.offset += turn;
        (Stamp::Confirmed(first, self.go(ticks)), false)
    }

    fn go(&mut self, ticks: f64) -> f64 {
        let time = ticks + self.offset;
        self.step = self.last.map_or(0.0, |last| (time - last).max(0.0));
        self.last = Some(time);
        time * self.tick
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
        let seconds = stamps.iter().flat_map(|ticks| match clock.read(*ticks).0 {
            Stamp::At(time) => vec![time],
            Stamp::Confirmed(held, time) => vec![held, time],
            Stamp::Bad | Stamp::Same | Stamp::Held => vec![],
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
        assert_eq!((seconds.len(), clock.jumps), (5, 1));
        // A flipped bit of the very first, and one of a second in between: nothing is shifted.
        let (seconds, _) = times(&[9e6, 1000.0, 9000.0, 17000.0 + 1_048_576.0, 25000.0, 33000.0]);
        assert_eq!(seconds.last(), Some(&(33000.0 * 1e-6)));
        assert_eq!(seconds.len(), 4);
        // One row in a second.
        assert_eq!(times(&[0.0, 1e6, 2e6, 3e6]).0.len(), 4);
        // A counter that was set to zero.
        let (seconds, clock) = times(&[70e6, 70.008e6, 100.0, 8100.0, 16100.0]);
        assert_eq!((seconds.len(), clock.jumps), (5, 1));
        assert!(seconds.windows(2).all(|pair| pair[1] >= pair[0]), "{seconds:?}");
    }
}
