//! Samples of several channels at one uniform rate.

use super::{CHANNELS, Sample};
use std::collections::VecDeque;

/// Samples of one channel that may wait for another channel; beyond, the other has a gap.
const WAITING: usize = 1 << 14;

/// What comes out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Row {
    /// Values of all channels at a time in s; not a number for a channel that the log does not have. Behind them how
    /// many samples each channel has from the time after the row before, or from the end of a gap, to this one.
    Values(f64, [f64; CHANNELS], [usize; CHANNELS]),
    /// A channel has no samples for a while, or another stretch begins.
    Gap,
}

/// Brings channels to one rate by linear interpolation between their samples.
#[derive(Debug)]
pub struct Uniform {
    /// Which channels there are.
    present: [bool; CHANNELS],
    waiting: [VecDeque<Sample>; CHANNELS],
    period: f64,
    longest: f64,
    /// The next time to be had, s.
    next: Option<f64>,
    /// Whether a channel has come to another stretch since the last row.
    crossed: bool,
    /// Whether the last row was a gap.
    gapped: bool,
    /// Samples of each channel since the last row.
    since: [usize; CHANNELS],
    /// Whether there are values before the next row from which on samples are counted.
    counted: bool,
    /// Gaps so far.
    pub gaps: u64,
    /// Largest number of samples that waited at once.
    pub resident: usize,
}

impl Uniform {
    /// At `rate` per second; between samples of one channel that are farther apart than `longest` s nothing is
    /// interpolated.
    pub fn new(present: [bool; CHANNELS], rate: f64, longest: f64) -> Self {
        let period = 1.0 / rate;
        let waiting = Default::default();
        Self {
            present,
            waiting,
            period,
            longest,
            next: None,
            crossed: false,
            gapped: false,
            since: [0; CHANNELS],
            counted: false,
            gaps: 0,
            resident: 0,
        }
    }

    /// Takes a sample and hands on what can be had now.
    pub fn push(&mut self, sample: Sample, rows: &mut Vec<Row>) {
        if let Some(queue) = self.waiting.get_mut(sample.channel as usize)
            && queue.back().is_none_or(|last| last.time < sample.time)
        {
            queue.push_back(sample);
            if queue.len() > WAITING {
                queue.pop_front();
            }
        }
        self.resident = self.resident.max(self.waiting.iter().map(VecDeque::len).sum());
        while let Some(row) = self.row() {
            self.gapped = row == Row::Gap;
            self.since = [0; CHANNELS];
            self.counted = !self.gapped;
            rows.push(row);
        }
    }

    /// The next row, if all channels have samples around it.
    fn row(&mut self) -> Option<Row> {
        let channels = || (0..CHANNELS).filter(|channel| self.present.get(*channel) == Some(&true));
        let next = match self.next {
            Some(next) => next,
            None => {
                let first = |channel: usize| self.waiting.get(channel)?.front().map(|sample| sample.time);
                let mut latest = f64::NEG_INFINITY;
                for channel in channels() {
                    latest = latest.max(first(channel)?);
                }
                latest
            }
        };
        self.next = Some(next);
        let (mut values, mut behind) = ([f64::NAN; CHANNELS], None::<f64>);
        for (channel, queue) in self.waiting.iter_mut().enumerate() {
            if self.present.get(channel) != Some(&true) {
                continue;
            }
            while queue.get(1).is_some_and(|second| second.time <= next) {
                let first = queue.pop_front();
                self.since.iter_mut().skip(channel).take(1).for_each(|since| *since += 1);
                self.crossed |= first.map(|first| first.stretch) != queue.front().map(|second| second.stretch);
            }
            let (Some(a), Some(b)) = (queue.front(), queue.get(1)) else { return None };
            if next < a.time || b.time - a.time > self.longest || a.stretch != b.stretch {
                behind = Some(behind.unwrap_or(0.0).max(if next < a.time { a.time } else { b.time }));
                continue;
            }
            let share = (next - a.time) / (b.time - a.time);
            if let Some(value) = values.get_mut(channel) {
                *value = a.value + share * (b.value - a.value);
            }
        }
        if std::mem::take(&mut self.crossed) && behind.is_none() && !self.gapped {
            self.gaps += 1;
            return Some(Row::Gap);
        }
        // The first time of the grid behind the gap, or the next one.
        let steps = behind.map_or(1.0, |time| ((time - next) / self.period).ceil().max(1.0));
        let following = next + steps * self.period;
        if following <= next || !following.is_finite() {
            // A time so far from zero that a period is lost in rounding: no rate can be kept there.
            self.waiting.iter_mut().for_each(VecDeque::clear);
            self.next = None;
            self.gaps += 1;
            return Some(Row::Gap);
        }
        self.next = Some(following);
        self.gaps += u64::from(behind.is_some());
        // Of what came before the first row, that has the last one.
        let since = if self.counted { self.since } else { self.present.map(usize::from) };
        Some(behind.map_or(Row::Values(next, values, since), |_| Row::Gap))
    }
}

#[cfg(test)]
mod tests {
    use super::super::Channel;
    use super::*;

    #[test]
    fn straight_lines_come_out_as_they_went_in() {
        let mut uniform = Uniform::new([true, true, false], 100.0, 0.5);
        let mut rows = Vec::new();
        for at in 0..400 {
            let time = 0.013 * f64::from(at);
            uniform.push(Sample { time, channel: Channel::Primary, value: 3.0 + 2.0 * time, stretch: 0 }, &mut rows);
            let time = 0.5 + 0.021 * f64::from(at);
            uniform.push(Sample { time, channel: Channel::Secondary, value: 7.0 - time, stretch: 0 }, &mut rows);
        }
        assert!(rows.len() > 400 && uniform.gaps == 0, "{}", rows.len());
        for row in &rows {
            let Row::Values(time, [primary, secondary, torque], _) = row else { panic!("a gap") };
            assert!((primary - 3.0 - 2.0 * time).abs() < 1e-9 && (secondary - 7.0 + time).abs() < 1e-9);
            assert!(torque.is_nan());
        }
    }

    #[test]
    fn times_that_rounding_cannot_tell_apart_end_the_grid() {
        let mut uniform = Uniform::new([true, false, false], 125.0, 4.0);
        let mut rows = Vec::new();
        for time in [1e16, 1e16 + 2.0, 1e16 + 4.0, 1e16 + 6.0] {
            uniform.push(Sample { time, channel: Channel::Primary, value: 1.0, stretch: 0 }, &mut rows);
        }
        assert!(rows.len() < 10 && rows.iter().all(|row| *row == Row::Gap), "{rows:?}");
    }

    #[test]
    fn stretches_are_parted_however_close_they_are() {
        // With times of the grid between the samples, and without: 8 ms apart, at 500 and at 20 per second.
        for rate in [500.0, 20.0] {
            let mut uniform = Uniform::new([true, false, false], rate, 0.1);
            let mut rows = Vec::new();
            for at in 0..200_u64 {
                let (time, stretch) = (0.008 * at as f64, at / 100);
                uniform.push(Sample { time, channel: Channel::Primary, value: stretch as f64, stretch }, &mut rows);
            }
            assert!((1..=2).contains(&uniform.gaps), "{rate}: {}", uniform.gaps);
            // Nothing between the two levels is made up, and the gap lies between them.
            let gap = rows.iter().position(|row| *row == Row::Gap).unwrap();
            for (at, row) in rows.iter().enumerate() {
                let Row::Values(_, [value, ..], _) = row else { continue };
                assert_eq!(*value, if at < gap { 0.0 } else { 1.0 }, "{rate}");
            }
        }
    }

    #[test]
    fn samples_are_counted_as_they_were_measured() {
        // Slower and faster than the uniform rate, and a gap of which none counts.
        for (period, rate) in [(0.2, 125.0), (0.01, 100.0), (0.001, 125.0)] {
            let mut uniform = Uniform::new([true, true, false], rate, 0.25);
            let (mut rows, mut taken) = (Vec::new(), 0);
            for at in 0..2000 {
                let time = period * f64::from(at) + if at < 1000 { 0.0 } else { 50.0 };
                for channel in [Channel::Primary, Channel::Secondary] {
                    uniform.push(Sample { time, channel, value: 1.0, stretch: 0 }, &mut rows);
                }
                taken += 1;
            }
            let count = |channel: usize| {
                let of = |row: &Row| if let Row::Values(_, _, since) = row { since[channel] } else { 0 };
                rows.iter().map(of).sum::<usize>()
            };
            let few = 2 + 2 * (1.0 / rate / period).ceil() as usize;
            assert!((taken - few..=taken).contains(&count(0)) && count(0) == count(1), "{period}: {}", count(0));
            assert_eq!(count(2), 0);
        }
    }

    #[test]
    fn nothing_is_made_up_in_a_gap() {
        let mut uniform = Uniform::new([true, false, false], 100.0, 0.1);
        let mut rows = Vec::new();
        for time in [0.0, 0.05, 0.1, 1e6, 1e6 + 0.05] {
            uniform.push(Sample { time, channel: Channel::Primary, value: 1.0, stretch: 0 }, &mut rows);
        }
        assert_eq!(uniform.gaps, 1);
        assert!(rows.len() < 20, "{}", rows.len());
    }
}
