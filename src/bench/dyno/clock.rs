//! Time stamps of a counter that wraps, may be reset, and may be garbled.

/// A counter of 32 bits wraps after this many ticks.
pub const WRAP: f64 = 4_294_967_296.0;
/// A stamp no farther behind the one before is believed as it is, s; so is one within [`STEADY`] of the last steps.
const NEAR: f64 = 0.5;
/// Steps of a slow counter that are believed: two rows in between may be missing.
const STEADY: f64 = 3.0;
/// A stamp that is farther is believed when those behind it follow within this time of one another, s.
const LEAP: f64 = 10.0;
/// Two steps that far apart are of one counter when neither is longer than the other by more than this factor.
const ALIKE: f64 = 4.0;

/// Makes seconds of the ticks of a counter, row by row; `R` is what a row has beside its stamp.
#[derive(Debug, Clone)]
pub struct Clock<R> {
    /// Seconds per tick.
    tick: f64,
    /// Ticks that are added to what the counter says.
    offset: f64,
    /// The last time, in ticks with the offset.
    last: Option<f64>,
    /// The step to it, in ticks.
    step: f64,
    /// At most two rows that are to be confirmed: the first of all, or such whose stamps are far from the last.
    held: Vec<Held<R>>,
    /// How often the counter has wrapped.
    pub wraps: u64,
    /// How often it jumped: a pause, or a reset.
    pub jumps: u64,
    /// How often it was set back: nobody knows how long it stood still.
    pub resets: u64,
}

/// A row that is to be confirmed.
#[derive(Debug, Clone)]
struct Held<R> {
    /// What the counter says, carried on past its wrap if it has wrapped since the first row that is held.
    ticks: f64,
    /// Whether it has.
    wrapped: bool,
    row: R,
}

/// What a stamp means.
#[derive(Debug, Clone, PartialEq)]
pub enum Stamp<R> {
    /// Seconds.
    At(f64, R),
    /// Seconds of two or three rows that confirm one another; the last is this one.
    Confirmed(Vec<(f64, R)>),
    /// It cannot be a time.
    Bad,
    /// The same as the stamp of a row before.
    Same(R),
    /// It will only be used if those behind confirm it.
    Held,
}

impl<R> Clock<R> {
    /// A counter with that many seconds per tick.
    pub fn new(tick: f64) -> Self {
        Self { tick, offset: 0.0, last: None, step: 0.0, held: Vec::new(), wraps: 0, jumps: 0, resets: 0 }
    }

    /// Reads the stamp of one row. Gives the rows, too, that were held and are refuted by it: they are out of sequence.
    pub fn read(&mut self, ticks: f64, row: R) -> (Stamp<R>, Vec<R>) {
        if !(0.0..1e18).contains(&ticks) {
            return (Stamp::Bad, Vec::new());
        }
        if let Some(last) = self.last {
            let time = ticks + self.offset;
            if time == last {
                return (Stamp::Same(row), Vec::new());
            }
            let most = (NEAR / self.tick).max(STEADY * self.step).min(LEAP / self.tick);
            let near = |time: f64| time > last && time - last <= most;
            let turned = ticks < WRAP && last - self.offset < WRAP && near(time + WRAP);
            if near(time) || turned {
                if turned && !near(time) {
                    self.offset += WRAP;
                    self.wraps += 1;
                }
                return (Stamp::At(self.go(ticks), row), self.refuted());
            }
        }
        if self.held.iter().any(|held| held.ticks - if held.wrapped { WRAP } else { 0.0 } == ticks) {
            return (Stamp::Same(row), Vec::new());
        }
        self.far(ticks, row)
    }

    /// Reads a stamp that is far from the last. It counts when one that is held is close before it; farther from that,
    /// only when a third follows at a step like that between them: a single one may be garbled, whichever of them it
    /// is.
    fn far(&mut self, ticks: f64, row: R) -> (Stamp<R>, Vec<R>) {
        let first = self.held.first().and_then(|held| self.after(held, ticks));
        let second = self.held.get(1).and_then(|held| self.after(held, ticks));
        let between = match self.held.as_slice() {
            [first, second] => Some((second.ticks - first.ticks) * self.tick),
            _ => None,
        };
        let between = between.filter(|between| (0.0..=LEAP).contains(between));
        let alike = |step: f64| between.is_some_and(|between| step <= ALIKE * between && between <= ALIKE * step);
        let near = |step: f64| step <= NEAR;
        // Which of the rows that are held this one goes with, where it stands beside them, and whether that confirms
        // it.
        let (kept, place, confirmed) = match (first, second) {
            (_, Some(place)) if alike(place.step) => (0..2, Some(place), true),
            (_, Some(place)) if near(place.step) => (1..2, Some(place), true),
            (Some(place), _) if near(place.step) => (0..1, Some(place), true),
            (_, Some(place)) => (1..2, Some(place), false),
            (Some(place), None) => (0..1, Some(place), false),
            // Either may be the garbled one.
            (None, None) => (self.held.len().saturating_sub(1)..self.held.len(), None, false),
        };
        let behind = self.held.split_off(kept.end.min(self.held.len()));
        let refuted = self.held.drain(..kept.start.min(self.held.len())).chain(behind).map(|held| held.row).collect();
        let (ticks, wrapped) = place.map_or((ticks, false), |place| (place.ticks, place.wrapped));
        self.held.push(Held { ticks, wrapped, row });
        // Wraps count from the first that is held.
        if self.held.first().is_some_and(|first| first.wrapped) {
            for held in self.held.iter_mut().filter(|held| held.wrapped) {
                (held.ticks, held.wrapped) = (held.ticks - WRAP, false);
            }
        }
        (if confirmed { Stamp::Confirmed(self.confirm()) } else { Stamp::Held }, refuted)
    }

    /// Where a stamp stands if it follows a row that is held, and how far behind; nothing if it does not.
    fn after(&self, held: &Held<R>, ticks: f64) -> Option<After> {
        let turned = ticks < WRAP && held.ticks - if held.wrapped { WRAP } else { 0.0 } < WRAP;
        [(ticks, false), (ticks + WRAP, true)].into_iter().find_map(|(place, wrapped)| {
            let step = (place - held.ticks) * self.tick;
            let follows = step > 0.0 && step <= LEAP && (turned || !wrapped);
            follows.then_some(After { ticks: place, wrapped, step })
        })
    }

    /// The rows that are held agree: the counter begins there, or it has jumped.
    fn confirm(&mut self) -> Vec<(f64, R)> {
        let held = std::mem::take(&mut self.held);
        if let (Some(last), Some(first)) = (self.last, held.first()) {
            self.jumps += 1;
            // A counter that was set back goes on from the last time. Where it is a little behind only, the last was
            // wrong.
            if first.ticks + self.offset + LEAP / self.tick < last {
                self.offset = last - first.ticks;
                self.resets += 1;
            }
        }
        let turned = held.last().is_some_and(|held| held.wrapped);
        let times = held.into_iter().map(|held| (self.go(held.ticks), held.row)).collect();
        if turned {
            self.offset += WRAP;
            self.wraps += 1;
        }
        times
    }

    fn go(&mut self, ticks: f64) -> f64 {
        let time = ticks + self.offset;
        self.step = self.last.map_or(0.0, |last| (time - last).max(0.0));
        self.last = Some(time);
        time * self.tick
    }

    /// Takes the rows that are held; at the end of a file nothing will confirm them.
    pub fn refuted(&mut self) -> Vec<R> {
        self.held.drain(..).map(|held| held.row).collect()
    }
}

/// How a stamp follows a row that is held.
#[derive(Debug, Clone, Copy)]
struct After {
    /// In ticks, carried on past the wrap.
    ticks: f64,
    wrapped: bool,
    /// How far behind, s.
    step: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn times(stamps: &[f64]) -> (Vec<f64>, Clock<usize>) {
        let mut clock = Clock::new(1e-6);
        let mut refuted = Vec::new();
        let seconds = stamps.iter().zip(0_usize..).flat_map(|(ticks, row)| {
            let (stamp, out) = clock.read(*ticks, row);
            refuted.extend(out);
            match stamp {
                Stamp::At(time, _) => vec![time],
                Stamp::Confirmed(times) => times.into_iter().map(|(time, _)| time).collect(),
                Stamp::Bad | Stamp::Same(_) | Stamp::Held => vec![],
            }
        });
        let seconds: Vec<f64> = seconds.collect();
        // Every row has a time, or is refuted, or is still held.
        assert_eq!(seconds.len() + refuted.len() + clock.held.len(), stamps.len(), "{stamps:?}");
        (seconds, clock)
    }

    /// What is left of 100 rows, one every `step` seconds, when `garbled` of them have other stamps.
    fn left(step: f64, garbled: &[(usize, f64)]) -> usize {
        let mut stamps: Vec<f64> =
            (0..100_u32).map(|row| 33_808_000.0 + (1e6 * step * f64::from(row)).round()).collect();
        garbled.iter().for_each(|(row, stamp)| stamps[*row] = *stamp);
        let (seconds, clock) = times(&stamps);
        assert_eq!(clock.jumps, 0, "{step} {garbled:?}");
        assert!(seconds.windows(2).all(|pair| pair[0] < pair[1]), "{step} {garbled:?}: {seconds:?}");
        seconds.len()
    }

    #[test]
    fn one_bit_that_is_flipped_costs_one_row_wherever_it_is() {
        // The second stamp is 2.1 s after the first, and was taken for the end of a pause.
        assert_eq!(left(0.008, &[(1, 35_905_152.0)]), 99);
        for (step, row) in [0.008, 0.02, 0.1, 1.0].into_iter().flat_map(|step| (0..8).map(move |row| (step, row))) {
            for bit in 20..32 {
                let stamp = 33_808_000 + (1e6 * step) as u64 * row as u64;
                let left = left(step, &[(row, (stamp ^ (1 << bit)) as f64)]);
                // Where a row a second comes, one second more or less is another row's stamp, or between two.
                assert!(left == 99 || (step == 1.0 && left >= 98), "{step} s, row {row}, bit {bit}: {left}");
            }
        }
    }

    #[test]
    fn a_pause_or_a_reset_costs_nothing() {
        for step in [0.008, 0.1, 1.0] {
            for begin in [0.0, 5e6, 100e6, 3_000e6, WRAP - 1.5e6 * step] {
                let row = |begin: f64, row: u32| (begin + (1e6 * step * f64::from(row)).round()) % WRAP;
                let stamps: Vec<f64> =
                    (0..20).map(|at| row(33e6, at)).chain((0..20).map(|at| row(begin, at))).collect();
                let (seconds, clock) = times(&stamps);
                assert_eq!((seconds.len(), clock.jumps), (40, 1), "{step} {begin}");
            }
        }
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
        assert_eq!((seconds.len(), clock.jumps, clock.resets), (5, 1, 1));
        assert!(seconds.windows(2).all(|pair| pair[1] >= pair[0]), "{seconds:?}");
    }
}
