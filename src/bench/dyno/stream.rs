//! One file as a stream of clean samples.

use super::clock::{Clock, Stamp, WRAP};
use super::faults::{Fault, Faults};
use super::format::{Channel, Column, Format};
use super::lines::{Line, Lines};
use super::{CHANNELS, Sample};
use crate::bench::cells;
use crate::cancel::is_cancelled;
use std::collections::VecDeque;

/// Values around one that tell how much values scatter there, on each side.
const AROUND: usize = 5;
/// Values on each side whose median stands for that side.
const SIDE: usize = 3;
/// A value is an outlier when it is off the medians of both sides in the same direction by more than this many standard
/// deviations, as the median absolute deviation around estimates it (F. R. Hampel, JASA 69, 1974), and than [`FLOOR`]
/// and [`RESOLUTION`]. A step from one level to another, a ramp and a ripple have none.
const FARTHEST: f64 = 8.0;
/// Median absolute deviation to standard deviation of a normal distribution.
const NORMAL: f64 = 1.4826;
/// Share of the larger median within which nothing is an outlier: a deviation of eleven values is a rough one. The
/// sensor on a wheel jitters by 8 % of its speed in logs of which no row is wrong.
const FLOOR: f64 = 0.1;
/// Share of the sensor's range within which nothing is.
const RESOLUTION: f64 = 0.002;
/// Rows after which a stream asks whether it is to go on.
const CANCELLED: u64 = 1 << 14;
/// Columns of a row that are looked at.
const COLUMNS: usize = 512;

/// The values of a row by channel, and its line.
type Values = ([Option<f64>; CHANNELS], u64);

/// A file on its way through the reader.
pub struct Stream {
    lines: Lines,
    format: Format,
    clock: Clock<Values>,
    faults: Faults,
    /// Windows in time that are read, s.
    windows: Vec<(f64, f64)>,
    /// Window and resets of the counter at the last sample.
    place: (usize, u64),
    /// Number of the stretch that these make.
    stretch: u64,
    /// Values of the last row that was no repetition.
    before: Option<[Option<f64>; CHANNELS]>,
    /// Rows on their way past the test for outliers, with their lines, by channel.
    filter: [VecDeque<(Sample, u64)>; CHANNELS],
    /// Whether the test has seen the first values of a channel.
    begun: [bool; CHANNELS],
    ready: VecDeque<Sample>,
    rows: u64,
    ended: bool,
    /// Added to every time, s.
    pub shift: f64,
    /// Why the file was broken off.
    broken: Option<String>,
}

impl Stream {
    /// Reads `lines` in a format; times outside the window in s are skipped.
    pub fn new(lines: Lines, format: Format, window: (f64, f64)) -> Self {
        Self::over(lines, format, vec![window])
    }

    /// As [`Stream::new`], over several windows that do not overlap, each of which is a stretch of its own.
    pub fn over(lines: Lines, format: Format, windows: Vec<(f64, f64)>) -> Self {
        let clock = Clock::new(format.tick);
        Self {
            lines,
            format,
            clock,
            faults: Faults::default(),
            windows,
            place: (0, 0),
            stretch: 0,
            before: None,
            filter: Default::default(),
            begun: [false; CHANNELS],
            ready: VecDeque::new(),
            rows: 0,
            ended: false,
            shift: 0.0,
            broken: None,
        }
    }

    /// The next clean sample, in the order of time but for the few rows that the test for outliers needs; none once the
    /// work is cancelled.
    pub fn next_sample(&mut self) -> Option<Sample> {
        while self.ready.is_empty() && !self.ended {
            // Rows of which none is good may be many.
            if self.rows.is_multiple_of(CANCELLED) && is_cancelled() {
                self.ended = true;
                break;
            }
            self.row();
        }
        self.ready.pop_front().map(|sample| {
            let column = self.format.columns.iter().find(|column| column.channel == sample.channel);
            let value = sample.value * column.map_or(1.0, |column| column.factor);
            Sample { time: sample.time + self.shift, value, ..sample }
        })
    }

    /// What was wrong so far.
    pub fn faults(&self) -> &Faults {
        &self.faults
    }

    /// Rows read so far, good or bad.
    pub fn rows(&self) -> u64 {
        self.rows
    }

    /// Bytes read so far.
    pub fn bytes(&self) -> u64 {
        self.lines.bytes()
    }

    /// How often the counter of the time wrapped and jumped.
    pub fn turns(&self) -> (u64, u64) {
        (self.clock.wraps, self.clock.jumps)
    }

    /// Why the file ended before its end, if it did.
    pub fn broken(&self) -> Option<&str> {
        self.broken.as_deref()
    }

    /// Seconds after which the counter of the time starts again.
    pub fn period(&self) -> f64 {
        WRAP * self.format.tick
    }

    /// Samples in memory.
    pub fn resident(&self) -> usize {
        self.ready.len() + self.filter.iter().map(VecDeque::len).sum::<usize>()
    }

    /// What the file measures.
    pub fn channels(&self) -> impl Iterator<Item = Channel> + '_ {
        self.format.columns.iter().map(|column| column.channel)
    }

    /// Whether a value of the file is a raw one of a converter.
    pub fn raw(&self) -> bool {
        self.format.columns.iter().any(|column| column.raw)
    }

    /// Columns that are read in another unit than their header has.
    pub fn units(&self) -> &[(Channel, String)] {
        &self.format.units
    }

    fn row(&mut self) {
        match self.lines.next_line() {
            Ok(Some(Line::Text(line, text))) => {
                if text.iter().all(u8::is_ascii_whitespace) {
                    return;
                }
                self.rows += 1;
                match parsed(&self.format, text, line, &mut self.faults) {
                    Ok((ticks, values)) => self.stamped(ticks, values, line),
                    Err(fault) => self.faults.add(fault, line),
                }
            }
            Ok(Some(Line::TooLong(line))) => {
                self.rows += 1;
                self.faults.add(Fault::TooLong, line);
            }
            Ok(None) => self.end(),
            Err(error) => {
                self.faults.add(Fault::BrokenOff, self.rows);
                self.broken = Some(error.to_string());
                self.end();
            }
        }
    }

    fn end(&mut self) {
        self.ended = true;
        let refuted = self.clock.refuted();
        self.refuted(refuted);
        for column in &self.format.columns {
            let channel = column.channel as usize;
            let Some(queue) = self.filter.get_mut(channel) else { continue };
            // The last values have none behind them.
            let from = if self.begun[channel] { AROUND } else { 0 };
            remove_outliers(queue, from, queue.len().saturating_sub(1), column.range, &mut self.faults);
            self.ready.extend(queue.drain(..).map(|(sample, _)| sample));
        }
        self.ready.make_contiguous().sort_by(|a, b| a.time.total_cmp(&b.time));
    }

    fn stamped(&mut self, ticks: f64, values: [Option<f64>; CHANNELS], line: u64) {
        let (stamp, refuted) = self.clock.read(ticks, (values, line));
        self.refuted(refuted);
        let before = self.before;
        if !matches!(stamp, Stamp::Bad | Stamp::Same(_)) {
            self.before = Some(values);
        }
        match stamp {
            Stamp::At(time, row) => self.take(time, row),
            Stamp::Confirmed(rows) => rows.into_iter().for_each(|(time, row)| self.take(time, row)),
            Stamp::Bad => self.faults.add(Fault::OutOfSequence, line),
            Stamp::Held => {}
            Stamp::Same((values, line)) => {
                let fault = if before == Some(values) { Fault::Duplicate } else { Fault::Contradiction };
                self.faults.add(fault, line);
            }
        }
    }

    fn refuted(&mut self, rows: Vec<Values>) {
        rows.into_iter().for_each(|(_, line)| self.faults.add(Fault::OutOfSequence, line));
    }

    fn take(&mut self, time: f64, (values, line): Values) {
        let Some(window) = self.windows.iter().position(|(start, end)| (*start..=*end).contains(&time)) else {
            return;
        };
        let place = (window, self.clock.resets);
        if place != std::mem::replace(&mut self.place, place) {
            self.stretch += 1;
        }
        let stretch = self.stretch;
        let columns: Vec<Column> = self.format.columns.clone();
        for column in columns {
            let channel = column.channel as usize;
            let Some(value) = values.get(channel).copied().flatten() else { continue };
            if value < column.range.0 || value > column.range.1 {
                self.faults.add(Fault::OutOfRange, line);
                continue;
            }
            self.filtered(&column, Sample { time, channel: column.channel, value, stretch }, line);
        }
    }

    /// Compares the value in the middle with those around it, and hands on what is behind.
    fn filtered(&mut self, column: &Column, sample: Sample, line: u64) {
        let Some(queue) = self.filter.get_mut(column.channel as usize) else { return };
        queue.push_back((sample, line));
        if queue.len() <= 2 * AROUND {
            return;
        }
        // The first values have none before them; they are looked at as soon as those behind are there.
        let begun = std::mem::replace(&mut self.begun[column.channel as usize], true);
        let from = if begun { AROUND } else { 0 };
        remove_outliers(queue, from, AROUND, column.range, &mut self.faults);
        while queue.len() > 2 * AROUND {
            self.ready.extend(queue.pop_front().map(|(sample, _)| sample));
        }
    }
}

/// Removes outliers at places from `from` to `to`, both included.
fn remove_outliers(
    queue: &mut VecDeque<(Sample, u64)>,
    from: usize,
    to: usize,
    range: (f64, f64),
    faults: &mut Faults,
) {
    let values: Vec<f64> = queue.iter().map(|(sample, _)| sample.value).collect();
    let outliers: Vec<usize> = (from..=to).filter(|at| is_outlier(&values, *at, range)).collect();
    for at in outliers.into_iter().rev() {
        if let Some((_, line)) = queue.remove(at) {
            faults.add(Fault::Outlier, line);
        }
    }
}

fn is_outlier(values: &[f64], at: usize, range: (f64, f64)) -> bool {
    let part = |from: usize, to: usize| values.get(from.min(values.len())..to.min(values.len())).unwrap_or_default();
    let Some(value) = values.get(at) else { return false };
    let (before, behind) = (part(at.saturating_sub(SIDE), at), part(at + 1, at + 1 + SIDE));
    let sides = match (median(before.to_vec()), median(behind.to_vec())) {
        (Some(before), Some(behind)) => [before, behind],
        (Some(one), None) | (None, Some(one)) => [one, one],
        (None, None) => return false,
    };
    let [one, other] = sides.map(|side| value - side);
    if one * other <= 0.0 {
        return false;
    }
    let around = part(at.saturating_sub(AROUND), at + 1 + AROUND);
    let Some(middle) = median(around.to_vec()) else { return false };
    let deviation = median(around.iter().map(|value| (value - middle).abs()).collect()).unwrap_or(0.0);
    let level = sides[0].abs().max(sides[1].abs());
    let limit = (FARTHEST * NORMAL * deviation).max(FLOOR * level).max(RESOLUTION * (range.1 - range.0));
    one.abs().min(other.abs()) > limit
}

/// The upper median.
fn median(mut values: Vec<f64>) -> Option<f64> {
    let middle = values.len() / 2;
    values.get(middle)?;
    Some(*values.select_nth_unstable_by(middle, f64::total_cmp).1)
}

/// Time in ticks and the values of a row; a cell that is no number is counted, and its channel has no value.
fn parsed(
    format: &Format,
    text: &[u8],
    line: u64,
    faults: &mut Faults,
) -> Result<(f64, [Option<f64>; CHANNELS]), Fault> {
    let text = std::str::from_utf8(text).map_err(|_| Fault::NotText)?;
    let text = if line == 1 { text.trim_start_matches('\u{feff}') } else { text };
    let mut cells = cells::split(text).take(COLUMNS);
    let number = |cell: &str| cells::text(cell).parse::<f64>().ok().filter(|value| value.is_finite());
    let ticks = cells.next().and_then(number).ok_or(Fault::NotNumber)?;
    let mut values = [None; CHANNELS];
    let mut found = 0;
    for (place, cell) in (1..).zip(cells) {
        if place >= format.width && !cell.trim().is_empty() {
            return Err(Fault::TooWide);
        }
        let Some(column) = format.columns.iter().find(|column| column.place == place) else { continue };
        found += 1;
        match number(cell) {
            Some(value) => {
                if let Some(to) = values.get_mut(column.channel as usize) {
                    *to = Some(value);
                }
            }
            None if format.sparse && cell.trim().is_empty() => {}
            None => faults.add(Fault::NotNumber, line),
        }
    }
    if found < format.columns.len() { Err(Fault::TooShort) } else { Ok((ticks, values)) }
}
