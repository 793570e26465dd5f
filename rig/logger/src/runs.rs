//! A run's folder: always new, with its journal, its metadata, and the files that `sheave dyno` reads.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use rig_core::{Frame, Identity};
use serde::{Deserialize, Serialize};

use crate::calibration::Calibration;
use crate::journal::{JOURNAL, Journal, Record};
use crate::steady::{BEGINS, Mean, Point, READING, READING_UNSETTLED, SETTLING};
use crate::watch::speed_lost;

/// What a run was made with; `run.toml` beside the data.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Metadata {
    /// Program that wrote it.
    pub logger: String,
    /// Seconds since 1970 at the start, by the logger's clock.
    pub started_unix: u64,
    /// "simulated" or "linux".
    pub rig: String,
    /// Firmware version, as the device said.
    pub firmware: String,
    /// What the time stamps count: the device's clock, µs in a tick.
    pub tick_microseconds: u8,
    /// Revolutions that a speed is taken over.
    pub revolutions: u8,
    /// Gear reduction between the secondary and the brake's shaft, already within the calibration.
    pub reduction: String,
    /// From converter value to torque at the secondary, (9.1).
    pub calibration: Calibration,
}

impl Metadata {
    /// Metadata of a run that begins now.
    #[must_use]
    pub fn now(rig: &str, identity: &Identity, calibration: Calibration) -> Self {
        let [major, minor, patch] = identity.firmware;
        let since = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH);
        Self {
            logger: format!("sheave-rig {}", env!("CARGO_PKG_VERSION")),
            started_unix: since.map_or(0, |duration| duration.as_secs()),
            rig: rig.to_owned(),
            firmware: format!("{major}.{minor}.{patch}"),
            tick_microseconds: identity.tick_microseconds,
            revolutions: identity.revolutions,
            reduction: "32:61".to_owned(),
            calibration,
        }
    }
}

/// Creates the first folder `run-0001`, `run-0002`, … that does not exist yet, with the metadata in it.
///
/// # Errors
/// If nothing can be created there.
pub fn create(parent: &Path, metadata: &Metadata) -> io::Result<PathBuf> {
    fs::create_dir_all(parent)?;
    for number in 1..=999_999u32 {
        let folder = parent.join(format!("run-{number:04}"));
        match fs::create_dir(&folder) {
            Ok(()) => {
                let text = toml::to_string(metadata).map_err(io::Error::other)?;
                write(&folder, "run.toml", &text)?;
                return Ok(folder);
            }
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            Err(error) => return Err(error),
        }
    }
    Err(io::Error::other(format!("{} holds a million runs already", parent.display())))
}

/// Writes a whole file beside its place, synchronises it, and renames it.
fn write(folder: &Path, name: &str, text: &str) -> io::Result<()> {
    replace(&folder.join(name), text)
}

/// Writes the whole of a file anew, beside its place first; a link to it stays one, and its permissions stay.
pub(crate) fn replace(path: &Path, text: &str) -> io::Result<()> {
    let path = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let mut beside = path.clone().into_os_string();
    beside.push(".tmp");
    let mut file = File::create(&beside)?;
    file.write_all(text.as_bytes())?;
    if let Ok(before) = fs::metadata(&path) {
        file.set_permissions(before.permissions())?;
    }
    file.sync_all()?;
    fs::rename(&beside, &path)?;
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    File::open(folder.unwrap_or(Path::new(".")))?.sync_all()
}

/// Reads a run's metadata.
///
/// # Errors
/// If the file is missing or not as it should be.
pub fn metadata(folder: &Path) -> io::Result<Metadata> {
    let path = folder.join("run.toml");
    let text = fs::read_to_string(&path).map_err(named(&path))?;
    toml::from_str(&text).map_err(io::Error::other).map_err(named(&path))
}

/// Reads a run's journal.
pub(crate) fn journal(folder: &Path) -> io::Result<Journal> {
    let path = folder.join(JOURNAL);
    Journal::read(&path).map_err(named(&path))
}

/// Says of an error which file it is about.
fn named(path: &Path) -> impl Fn(io::Error) -> io::Error {
    move |error| io::Error::new(error.kind(), format!("{}: {error}", path.display()))
}

/// What an export did.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Exported {
    /// Frames in the journal.
    pub frames: usize,
    /// Operating points with a file of each channel.
    pub points: usize,
    /// Lines of the journal that were no records; at most one after a power cut.
    pub bad_lines: usize,
}

/// One channel: time stamps of the device in µs, and values. A value whose stamp has not changed is the same one again.
#[derive(Default)]
struct Channel {
    text: String,
    last: Option<u64>,
}

impl Channel {
    fn add(&mut self, stamp: Option<u64>, value: &str) {
        if stamp.is_some() && stamp != self.last {
            self.last = stamp;
            if let Some(stamp) = stamp {
                self.text.push_str(&format!("{stamp},{value}\n"));
            }
        }
    }
}

/// What is being read of an operating point.
struct Reading {
    number: u32,
    channels: [Channel; 4],
    begins: u64,
    settling_ms: u64,
    settled: bool,
    /// A shaft showed no speed meanwhile.
    lost: bool,
    means: [Mean; 3],
}

impl Reading {
    fn frame(&mut self, frame: &Frame, calibration: &Calibration) {
        let snapshot = &frame.snapshot;
        let (p, s) = (snapshot.primary.speed.rpm_exact(), snapshot.secondary.speed.rpm_exact());
        let torque = calibration.torque(snapshot.torque);
        let stamp = |at: Option<rig_core::Instant>| at.map(rig_core::Instant::microseconds);
        let converted = stamp(snapshot.torque_at);
        self.lost |= speed_lost(frame);
        let [primary, secondary, adc, torques] = &mut self.channels;
        let [primary_mean, secondary_mean, torque_mean] = &mut self.means;
        primary_mean.add(p);
        secondary_mean.add(s);
        if converted != adc.last {
            torque_mean.add(torque);
        }
        primary.add(stamp(snapshot.primary.last_pulse), &format!("{p:.3}"));
        secondary.add(stamp(snapshot.secondary.last_pulse), &format!("{s:.3}"));
        adc.add(converted, &snapshot.torque.to_string());
        torques.add(converted, &format!("{torque:.5}"));
    }

    fn point(&self, pass: u32, number: u32, ends: u64) -> Point {
        let [primary, secondary, torque] = &self.means;
        Point {
            pass,
            number,
            primary_rpm: primary.result(),
            secondary_rpm: secondary.result(),
            torque: torque.result(),
            conversions: torque.count(),
            duration: (ends - self.begins) as f64 * 1e-6,
            settling_ms: self.settling_ms,
            settled: self.settled && !self.lost,
        }
    }
}

/// What a journal's records come to.
#[derive(Default)]
struct Exporting {
    log: String,
    frames: usize,
    points: Vec<Point>,
    passes: u32,
    /// The number of the next point within its pass.
    number: u32,
    settling_since: u64,
    settled: bool,
    reading: Option<Reading>,
}

impl Exporting {
    fn record(&mut self, folder: &Path, record: &Record, calibration: &Calibration) -> io::Result<()> {
        match record {
            Record::Frame { at, bytes } => {
                let Ok(frame) = Frame::from_bytes(bytes) else { return Ok(()) };
                self.frames += 1;
                let (primary, secondary) = (frame.snapshot.primary.speed, frame.snapshot.secondary.speed);
                let (p, s) = (primary.rpm_exact(), secondary.rpm_exact());
                let torque = calibration.torque(frame.snapshot.torque);
                self.log.push_str(&format!("{:.3},{p:.3},{s:.3},{torque:.4}\n", *at as f64 * 1e-3));
                // A point is what came after its beginning.
                if let Some(reading) = self.reading.as_mut().filter(|reading| reading.begins < *at) {
                    reading.frame(&frame, calibration);
                }
            }
            Record::Point { at, number, begins: true } => {
                self.reading = Some(Reading {
                    number: *number,
                    channels: Default::default(),
                    begins: *at,
                    settling_ms: at.saturating_sub(self.settling_since) / 1000,
                    settled: self.settled,
                    lost: false,
                    means: Default::default(),
                });
            }
            Record::Point { at, begins: false, .. } => {
                let Some(reading) = self.reading.take() else { return Ok(()) };
                self.points.push(reading.point(self.passes.saturating_sub(1), self.number, *at));
                self.number += 1;
                for (name, channel) in ["P", "S", "ADC", "TORQUE"].iter().zip(reading.channels) {
                    write(folder, &format!("{name}_{}.csv", reading.number), &channel.text)?;
                }
            }
            Record::Note { at, text } => match text.as_str() {
                BEGINS => (self.passes, self.number) = (self.passes + 1, 0),
                SETTLING => self.settling_since = *at,
                READING => self.settled = true,
                READING_UNSETTLED => self.settled = false,
                _ => {}
            },
            Record::Temperature { .. } => {}
        }
        Ok(())
    }
}

/// Makes of a journal: `log.csv` of the whole run (timestamp_ms, primary_rpm, secondary_rpm, torque), for each
/// operating point the files P_n, S_n, ADC_n and TORQUE_n of Appendix H, and the table of points, `points.csv`. May be
/// repeated at any time; the journal is never touched.
///
/// # Errors
/// If the folder cannot be read or written.
pub fn export(folder: &Path) -> io::Result<Exported> {
    let calibration = metadata(folder)?.calibration;
    let journal = journal(folder)?;
    let mut exporting = Exporting::default();
    for record in &journal.records {
        exporting.record(folder, record, &calibration)?;
    }
    write(folder, "log.csv", &format!("timestamp_ms,primary_rpm,secondary_rpm,torque\n{}", exporting.log))?;
    write_points(folder, &exporting.points)?;
    Ok(Exported { frames: exporting.frames, points: exporting.points.len(), bad_lines: journal.bad_lines.len() })
}

/// Writes the points of a test as `points.csv`, in the columns that `sheave compare` reads.
///
/// # Errors
/// If the file cannot be written.
pub fn write_points(folder: &Path, points: &[Point]) -> io::Result<()> {
    write(folder, "points.csv", &points_table(points))
}

/// Writes a new file; one that is there already is left as it is.
///
/// # Errors
/// If it exists, or cannot be written.
pub fn write_new(path: &Path, text: &str) -> io::Result<()> {
    create_new(path, text).map_err(named(path))
}

/// The same, for one who names the file himself.
pub(crate) fn create_new(path: &Path, text: &str) -> io::Result<()> {
    let mut file = File::create_new(path)?;
    file.write_all(text.as_bytes())?;
    file.sync_all()
}

/// The table of points, in the columns that `sheave compare` reads.
#[must_use]
pub fn points_table(points: &[Point]) -> String {
    let mut text = String::from(
        "run,step,primary_rpm,primary_rpm_sd,secondary_rpm,secondary_rpm_sd,secondary_torque_Nm,\
            secondary_torque_sd,n_torque,\
         duration_s,settling_s,settled\n",
    );
    for point in points {
        let numbers = [point.primary_rpm, point.secondary_rpm, point.torque];
        let columns: Vec<String> = numbers.iter().map(|(mean, sd)| format!("{mean:.4},{sd:.4}")).collect();
        let (settling, seconds) = (point.settling_ms as f64 * 1e-3, point.duration);
        let (pass, number, conversions, settled) = (point.pass, point.number, point.conversions, point.settled);
        text.push_str(&format!(
            "{pass},{number},{},{conversions},{seconds:.4},{settling:.3},{settled}\n",
            columns.join(",")
        ));
    }
    text
}
