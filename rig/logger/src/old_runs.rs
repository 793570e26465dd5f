//! Runs as the thesis's program left them (Appendix H): for each operating point n the files `P_n.csv`, `S_n.csv`,
//! `ADC_n.csv` and `TORQUE_n.csv`, each with rows of time in µs and value, and nothing else.
//!
//! The clock of the thesis rolls over after 71.6 minutes; a stamp that falls by more than half of its range is taken
//! on. So are all stamps of a channel that begins behind a roll-over which another channel of its point begins before.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use crate::steady::{Mean, Point};

/// Channels, by the beginning of their files' names.
const CHANNELS: [&str; 4] = ["P", "S", "ADC", "TORQUE"];
/// Half of the range of a 32-bit stamp, µs.
const HALF_RANGE: u64 = 1 << 31;
/// The largest value of the converter, which has 16 bits.
const LARGEST_VALUE: f64 = u16::MAX as f64;
/// No stamp lies beyond this, µs: 285 years.
const LAST_STAMP: u64 = 1 << 53;

/// One channel of one operating point: times in µs, and values.
pub type Samples = Vec<(u64, f64)>;

/// One operating point of an old run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OldPoint {
    /// Its number.
    pub number: u32,
    /// Speed of the primary, rpm.
    pub primary: Samples,
    /// Speed of the secondary, rpm.
    pub secondary: Samples,
    /// The converter's values.
    pub converter: Samples,
    /// Torque at the secondary, N·m; empty where the run kept raw values only.
    pub torque: Samples,
}

/// Why an old run cannot be read.
#[derive(Debug, thiserror::Error)]
pub enum OldRunError {
    /// The folder or one of its files.
    #[error("{path}: {error}", path = path.display())]
    File {
        /// Which.
        path: PathBuf,
        /// Why.
        error: io::Error,
    },
    /// A row that is none.
    #[error("{path}, line {line}: a time in µs and a value were expected, '{given}' was found", path = path.display())]
    Row {
        /// Which file.
        path: PathBuf,
        /// Its line, from 1.
        line: usize,
        /// What stands there.
        given: String,
    },
    /// A time that no clock shows.
    #[error(
        "{path}, line {line}: a time of at most {LAST_STAMP} µs was expected, roll-overs included, '{given}' was found",
        path = path.display()
    )]
    Time {
        /// Which file.
        path: PathBuf,
        /// Its line, from 1.
        line: usize,
        /// What stands there.
        given: String,
    },
    /// A value that the converter cannot give.
    #[error(
        "{path}, line {line}: a value of the converter from 0 to {LARGEST_VALUE} was expected, '{given}' was found",
        path = path.display()
    )]
    Converter {
        /// Which file.
        path: PathBuf,
        /// Its line, from 1.
        line: usize,
        /// What stands there.
        given: String,
    },
    /// No such files at all.
    #[error("{path}: neither a journal nor files such as P_0.csv and S_0.csv are here", path = path.display())]
    Nothing {
        /// Which folder.
        path: PathBuf,
    },
}

/// Whether a folder holds an old run: no journal, but a speed file.
#[must_use]
pub fn is_one(folder: &Path) -> bool {
    !folder.join(crate::journal::JOURNAL).exists() && numbers(folder).is_ok_and(|numbers| !numbers.is_empty())
}

/// Numbers of the operating points, in order: those of the primary's files.
fn numbers(folder: &Path) -> io::Result<Vec<u32>> {
    let mut numbers = Vec::new();
    for entry in fs::read_dir(folder)? {
        let name = entry?.file_name();
        let number = name.to_str().and_then(|name| name.strip_prefix("P_")?.strip_suffix(".csv")?.parse::<u32>().ok());
        numbers.extend(number);
    }
    numbers.sort_unstable();
    Ok(numbers)
}

/// Reads an old run.
///
/// # Errors
/// If a file is missing or a row of it is not a time and a value. A last line without its end is left out: its value
/// may have lost digits.
pub fn read(folder: &Path) -> Result<Vec<OldPoint>, OldRunError> {
    let numbers = numbers(folder).map_err(|error| OldRunError::File { path: folder.to_owned(), error })?;
    if numbers.is_empty() {
        return Err(OldRunError::Nothing { path: folder.to_owned() });
    }
    numbers.into_iter().map(|number| point(folder, number)).collect()
}

fn point(folder: &Path, number: u32) -> Result<OldPoint, OldRunError> {
    let path = |name: &str| folder.join(format!("{name}_{number}.csv"));
    let channel = |name: &str| samples(&path(name), false);
    let [primary, secondary, converter, torque] = CHANNELS;
    let (converter, torque) = (samples(&path(converter), true), channel(torque));
    let absent = |read: &Result<Samples, OldRunError>| match read {
        Err(OldRunError::File { error, .. }) => error.kind() == io::ErrorKind::NotFound,
        Ok(_) | Err(_) => false,
    };
    // One of the two is enough.
    let (converter, torque) = match (absent(&converter), absent(&torque)) {
        (true, false) => (Vec::new(), torque?),
        (false, true) => (converter?, Vec::new()),
        (_, _) => (converter?, torque?),
    };
    let mut point = OldPoint { number, primary: channel(primary)?, secondary: channel(secondary)?, converter, torque };
    point.align();
    Ok(point)
}

/// Reads a channel, of the converter or of something else.
fn samples(path: &Path, of_converter: bool) -> Result<Samples, OldRunError> {
    let text = fs::read(path).map_err(|error| OldRunError::File { path: path.to_owned(), error })?;
    let text = String::from_utf8_lossy(&text);
    let mut samples: Samples = Vec::new();
    let mut turns = 0;
    for (line, row) in text.split_inclusive('\n').enumerate() {
        if !row.ends_with('\n') {
            // Whatever it says may have been longer.
            break;
        }
        let row = row.trim();
        let fields = row.split_once(',').and_then(|(time, value)| {
            let time = time.trim().parse::<u64>().ok()?;
            let value = value.trim().parse::<f64>().ok().filter(|value| value.is_finite())?;
            Some((time, value))
        });
        let Some((stamp, value)) = fields else {
            if row.is_empty() {
                continue;
            }
            return Err(OldRunError::Row { path: path.to_owned(), line: line + 1, given: row.to_owned() });
        };
        if of_converter && !(0.0..=LARGEST_VALUE).contains(&value) {
            return Err(OldRunError::Converter { path: path.to_owned(), line: line + 1, given: row.to_owned() });
        }
        let before = samples.last().map_or(0, |sample| sample.0);
        // All that was taken on so far is below the last stamp: nothing overflows here.
        if stamp.saturating_add(turns) < before.saturating_sub(HALF_RANGE) {
            turns += 2 * HALF_RANGE;
        }
        let Some(time) = stamp.checked_add(turns).filter(|time| *time <= LAST_STAMP) else {
            return Err(OldRunError::Time { path: path.to_owned(), line: line + 1, given: row.to_owned() });
        };
        samples.push((time, value));
    }
    Ok(samples)
}

impl OldPoint {
    /// Brings all channels to one clock. Each file by itself is read over the roll-overs within it, which says nothing
    /// of one between the first stamps of two channels: those that begin far below another begin behind it.
    fn align(&mut self) {
        let mut channels = [&mut self.primary, &mut self.secondary, &mut self.converter, &mut self.torque];
        let begins = channels.iter().filter_map(|channel| channel.first()).map(|sample| sample.0);
        let latest = begins.max().unwrap_or(0);
        // A clock that shows more has no 32 bits.
        if latest >= 2 * HALF_RANGE {
            return;
        }
        for channel in &mut channels {
            if channel.first().is_some_and(|sample| sample.0 + HALF_RANGE < latest) {
                channel.iter_mut().for_each(|sample| sample.0 += 2 * HALF_RANGE);
            }
        }
    }

    /// Torque at the secondary, N·m: as it was kept, or from the converter's values.
    #[must_use]
    pub fn torques(&self, calibration: &crate::calibration::Calibration) -> Samples {
        if !self.torque.is_empty() {
            return self.torque.clone();
        }
        self.converter.iter().map(|(time, value)| (*time, calibration.torque_at(*value))).collect()
    }

    /// Means and standard deviations. How long settling took was not recorded; the thesis waited four seconds.
    #[must_use]
    pub fn reduce(&self, calibration: &crate::calibration::Calibration) -> Point {
        let torques = self.torques(calibration);
        let times = || [&self.primary, &self.secondary, &torques].into_iter().flatten().map(|sample| sample.0);
        let span = times().max().unwrap_or(0) - times().min().unwrap_or(0);
        let mean = |samples: &Samples| Mean::of(samples.iter().map(|sample| sample.1));
        Point {
            pass: 0,
            number: self.number,
            primary_rpm: mean(&self.primary),
            secondary_rpm: mean(&self.secondary),
            torque: mean(&torques),
            conversions: torques.len() as u32,
            duration: span as f64 * 1e-6,
            settling_ms: 4000,
            settled: true,
        }
    }
}

/// Shows an old run again: one line for each second of each operating point.
///
/// # Errors
/// If it cannot be read, or the output not written.
pub fn replay(
    folder: &Path,
    calibration: &crate::calibration::Calibration,
    output: &mut dyn Write,
) -> Result<(), OldRunError> {
    let shown = |error| OldRunError::File { path: PathBuf::from("output"), error };
    writeln!(output, "{:>9} {:>9} {:>9} {:>9}", "s", "prim rpm", "sec rpm", "N·m").map_err(shown)?;
    for point in read(folder)? {
        let torques = point.torques(calibration);
        writeln!(output, "point {}", point.number).map_err(shown)?;
        let channels = [&point.primary, &point.secondary, &torques];
        let (begin, end) = channels
            .iter()
            .filter_map(|channel| Some((channel.first()?.0, channel.last()?.0)))
            .fold((u64::MAX, 0), |(begin, end), (first, last)| (begin.min(first), end.max(last)));
        let mut time = begin;
        while time <= end {
            let [p, s, t] = channels.map(|channel| {
                let after = channel.partition_point(|sample| sample.0 <= time);
                after.checked_sub(1).and_then(|at| channel.get(at)).map_or(f64::NAN, |sample| sample.1)
            });
            writeln!(output, "{:9.2} {p:9.1} {s:9.1} {t:9.2}", time as f64 * 1e-6).map_err(shown)?;
            // A clock that jumps must not make this endless: at most an hour of a point is shown.
            time = if end - begin > 3_600_000_000 { end.max(time + 1) } else { time + 1_000_000 };
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::calibration::Calibration;

    fn write(folder: &Path, name: &str, text: &str) {
        fs::write(folder.join(name), text).unwrap();
    }

    #[test]
    fn a_time_that_no_clock_shows_is_named_and_the_last_that_one_may_show_is_shown() {
        let folder = tempfile::tempdir().unwrap();
        for given in ["18446744073709551615,1", "18446744071562067968,1", "9007199254740993,1"] {
            for name in ["P_0.csv", "S_0.csv", "TORQUE_0.csv"] {
                write(folder.path(), name, &format!("{given}\n5,1\n"));
            }
            let mut shown = Vec::new();
            let errors = [read(folder.path()).map(drop), replay(folder.path(), &Calibration::THESIS, &mut shown)];
            for error in errors.map(|result| result.unwrap_err().to_string()) {
                assert!(error.contains("_0.csv, line 1") && error.contains(given), "{error}");
            }
        }
        for name in ["P_0.csv", "S_0.csv", "TORQUE_0.csv"] {
            write(folder.path(), name, "0,1\n9007199254740992,2\n");
        }
        let duration = read(folder.path()).unwrap()[0].reduce(&Calibration::THESIS).duration;
        assert!((duration - 9_007_199_254.740_992).abs() < 1.0, "{duration}");
        let mut shown = Vec::new();
        replay(folder.path(), &Calibration::THESIS, &mut shown).unwrap();
        assert_eq!(String::from_utf8(shown).unwrap().lines().count(), 4, "of a time too long its ends are shown");
    }

    /// Written as `write_file` of Appendix H does it: csv.writer's rows end in CR LF.
    fn old_run(folder: &Path) {
        for number in [0, 2, 10] {
            let at = |place: u64| 4_294_000_000u64 + place * 6000;
            let rows = |value: f64| -> String {
                (0..500).map(|place| format!("{},{}\r\n", at(place) % (1 << 32), value + (place % 2) as f64)).collect()
            };
            write(folder, &format!("P_{number}.csv"), &rows(2991.0));
            write(folder, &format!("S_{number}.csv"), &rows(1585.0));
            write(folder, &format!("ADC_{number}.csv"), &rows(37_466.0));
        }
    }

    #[test]
    fn an_old_run_is_read_over_the_roll_over_of_its_clock() {
        let folder = tempfile::tempdir().unwrap();
        old_run(folder.path());
        assert!(is_one(folder.path()));
        let points = read(folder.path()).unwrap();
        assert_eq!(points.iter().map(|point| point.number).collect::<Vec<_>>(), [0, 2, 10]);
        assert!(points[0].primary.is_sorted(), "time goes on");
        let point = points[1].reduce(&Calibration::THESIS);
        assert!((point.primary_rpm.0 - 2991.5).abs() < 1e-9 && (point.torque.0 - 21.4575).abs() < 1e-3, "{point:?}");
        assert!((point.duration - 2.994).abs() < 1e-9);
        let mut shown = Vec::new();
        replay(folder.path(), &Calibration::THESIS, &mut shown).unwrap();
        assert_eq!(String::from_utf8(shown).unwrap().lines().count(), 1 + 3 * (1 + 3));
    }

    #[test]
    fn channels_that_begin_on_both_sides_of_a_roll_over_have_one_clock() {
        // The same point long before a roll-over, and with the roll-over behind any of its first stamps.
        let of = |start: u64| {
            let folder = tempfile::tempdir().unwrap();
            for (name, first, period) in [("P", 0, 20_000), ("S", 9000, 38_000), ("ADC", 9500, 8000)] {
                let row = |at: u64| format!("{},37466\r\n", (start + at) % (1 << 32));
                let rows: String = (first..3_000_000).step_by(period).map(row).collect();
                write(folder.path(), &format!("{name}_0.csv"), &rows);
            }
            let point = read(folder.path()).unwrap()[0].reduce(&Calibration::THESIS);
            let mut shown = Vec::new();
            replay(folder.path(), &Calibration::THESIS, &mut shown).unwrap();
            (point, String::from_utf8(shown).unwrap())
        };
        let (expected, shown) = of(1_000_000);
        assert!((expected.duration - 2.9935).abs() < 1e-3, "{expected:?}");
        assert_eq!(shown.lines().count(), 1 + 1 + 3);
        for before in [1, 4000, 8000, 9001, 9200, 9501, 1_500_000] {
            let (point, shown) = of((1 << 32) - before);
            assert_eq!(point, expected, "{before} µs before the roll-over");
            assert_eq!(shown.lines().count(), 1 + 1 + 3, "{shown}");
            assert!(shown.lines().skip(3).all(|line| !line.contains("NaN")), "{shown}");
        }
    }

    #[test]
    fn a_value_that_the_converter_cannot_give_is_refused_with_its_line() {
        let folder = tempfile::tempdir().unwrap();
        old_run(folder.path());
        for given in ["70000", "-1", "65535.5", "1e9"] {
            write(folder.path(), "ADC_2.csv", &format!("1,0\n2,65535\n3,{given}\n4,37466\n"));
            let error = read(folder.path()).unwrap_err().to_string();
            assert!(error.contains("ADC_2.csv, line 3") && error.contains(&format!("'3,{given}'")), "{error}");
            assert!(error.contains("from 0 to 65535"), "{error}");
        }
        // Means of several values are no whole numbers, and count as they are.
        write(folder.path(), "ADC_2.csv", "1,37466.5\n2,37466.5\n");
        let torque = read(folder.path()).unwrap()[1].reduce(&Calibration::THESIS).torque.0;
        assert!((torque - (37_466.5 - 35_145.0) / 108.19).abs() < 1e-12, "{torque}");
    }

    #[test]
    fn what_is_wrong_is_named_with_its_line_and_a_cut_off_end_is_not() {
        let folder = tempfile::tempdir().unwrap();
        assert!(matches!(read(folder.path()), Err(OldRunError::Nothing { .. })));
        old_run(folder.path());
        write(folder.path(), "TORQUE_2.csv", "1,2\n5,x\n7,3\n");
        let error = read(folder.path()).unwrap_err().to_string();
        assert!(error.contains("TORQUE_2.csv, line 2") && error.contains("5,x"), "{error}");
        write(folder.path(), "TORQUE_2.csv", "1,2\n5,2.5\n70");
        // The other channels begin before a roll-over: these stamps lie behind it.
        let turn = 1 << 32;
        assert_eq!(read(folder.path()).unwrap()[1].torque, [(turn + 1, 2.0), (turn + 5, 2.5)]);
        // Cut at any byte, only whole rows count: `2` is none of `2991.0`.
        let whole = "1,2990.0\r\n5,2991.0\r\n";
        for cut in 0..=whole.len() {
            write(folder.path(), "TORQUE_2.csv", &whole[..cut]);
            let rows = whole[..cut].matches('\n').count();
            assert_eq!(
                read(folder.path()).unwrap()[1].torque,
                [(turn + 1, 2990.0), (turn + 5, 2991.0)][..rows],
                "cut at {cut}"
            );
        }
        fs::remove_file(folder.path().join("S_2.csv")).unwrap();
        assert!(read(folder.path()).unwrap_err().to_string().contains("S_2.csv"));
    }
}
