//! What is written while the rig runs: one line for each record, appended, with its check, synchronised to the disk.
//!
//! ```text
//! F 1234567 01230001...*8C4F      a frame as it came over the bus, at host time µs
//! ```
//!
//! A line is complete when its end and its check are right; whatever stands after the last complete line of a file
//! that was
//! cut off is at most one record. Writing and synchronising happen on a thread of their own, because a disk may take
//! long
//! and the interlock may not; when it fails, the interlock is told.

use std::fs::{File, OpenOptions};
use std::io::{self, Write};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, SyncSender, TrySendError, sync_channel};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use rig_core::frame::{FRAME_LENGTH, checksum};

/// Name of the journal in a run's folder.
pub const JOURNAL: &str = "journal.log";
/// At the latest this long after a record was handed over, it is synchronised.
pub const SYNC_EVERY: Duration = Duration::from_millis(250);

/// One record.
#[derive(Clone, Debug, PartialEq)]
pub enum Record {
    /// A versioned frame with a good check, at host time in µs since the run began.
    Frame {
        /// Host time, µs.
        at: u64,
        /// As it came.
        bytes: [u8; FRAME_LENGTH],
    },
    /// The rotor's temperature, °C.
    Temperature {
        /// Host time, µs.
        at: u64,
        /// °C.
        celsius: f64,
    },
    /// The reading of an operating point begins or ends.
    Point {
        /// Host time, µs.
        at: u64,
        /// Number of the point, from 0.
        number: u32,
        /// Begins.
        begins: bool,
    },
    /// Anything that a person reads: a change of state, its cause.
    Note {
        /// Host time, µs.
        at: u64,
        /// One line.
        text: String,
    },
}

impl Record {
    /// Host time, µs.
    #[must_use]
    pub fn at(&self) -> u64 {
        match self {
            Self::Frame { at, .. } | Self::Temperature { at, .. } | Self::Point { at, .. } | Self::Note { at, .. } => {
                *at
            }
        }
    }

    /// The line, with its end.
    #[must_use]
    pub fn line(&self) -> String {
        let body = match self {
            Self::Frame { at, bytes } => {
                let hex: String = bytes.iter().map(|byte| format!("{byte:02x}")).collect();
                format!("F {at} {hex}")
            }
            Self::Temperature { at, celsius } => format!("T {at} {celsius}"),
            Self::Point { at, number, begins } => {
                format!("P {at} {number} {}", if *begins { "begins" } else { "ends" })
            }
            Self::Note { at, text } => format!("N {at} {}", text.replace(['\n', '\r', '*'], " ")),
        };
        format!("{body}*{:04X}\n", checksum(body.as_bytes()))
    }

    /// A record from its line without the end; `None` if anything about it is wrong.
    #[must_use]
    pub fn parse(line: &str) -> Option<Self> {
        let (body, check) = line.rsplit_once('*')?;
        if check.len() != 4 || u16::from_str_radix(check, 16).ok()? != checksum(body.as_bytes()) {
            return None;
        }
        let mut fields = body.splitn(3, ' ');
        let (kind, at, rest) = (fields.next()?, fields.next()?.parse().ok()?, fields.next()?);
        match kind {
            "F" => {
                let mut bytes = [0; FRAME_LENGTH];
                if !rest.is_ascii() || rest.len() != 2 * FRAME_LENGTH {
                    return None;
                }
                for (place, byte) in bytes.iter_mut().enumerate() {
                    *byte = u8::from_str_radix(rest.get(2 * place..2 * place + 2)?, 16).ok()?;
                }
                Some(Self::Frame { at, bytes })
            }
            "T" => Some(Self::Temperature { at, celsius: rest.parse().ok()? }),
            "P" => {
                let (number, which) = rest.split_once(' ')?;
                let begins = match which {
                    "begins" => true,
                    "ends" => false,
                    _ => return None,
                };
                Some(Self::Point { at, number: number.parse().ok()?, begins })
            }
            "N" => Some(Self::Note { at, text: rest.to_owned() }),
            _ => None,
        }
    }
}

/// What a journal holds.
#[derive(Debug, Default)]
pub struct Journal {
    /// Complete records in order.
    pub records: Vec<Record>,
    /// Numbers, from 1, of lines that are not records: disturbed, or cut off at the end.
    pub bad_lines: Vec<usize>,
}

impl Journal {
    /// Takes a journal's bytes apart; never fails, and names what it leaves out.
    #[must_use]
    pub fn parse(bytes: &[u8]) -> Self {
        let mut journal = Self::default();
        for (number, line) in bytes.split_inclusive(|byte| *byte == b'\n').enumerate() {
            let text = line.strip_suffix(b"\n").and_then(|line| std::str::from_utf8(line).ok());
            match text.and_then(Record::parse) {
                Some(record) => journal.records.push(record),
                None => journal.bad_lines.push(number + 1),
            }
        }
        journal
    }

    /// Reads a journal.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn read(path: &Path) -> io::Result<Self> {
        Ok(Self::parse(&std::fs::read(path)?))
    }
}

/// Where lines go: a file, or in tests something that fails.
pub trait Sink: Write + Send {
    /// All that was written is on the disk when this returns.
    ///
    /// # Errors
    /// If it cannot be brought there.
    fn synchronise(&mut self) -> io::Result<()>;
}

impl Sink for File {
    fn synchronise(&mut self) -> io::Result<()> {
        self.sync_data()
    }
}

/// Hands records to the writing thread.
pub struct Recorder {
    lines: Option<SyncSender<String>>,
    failed: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl Recorder {
    /// Starts a journal in a run's new folder.
    ///
    /// # Errors
    /// If it exists already, or cannot be created.
    pub fn create(folder: &Path) -> io::Result<Self> {
        let file = OpenOptions::new().append(true).create_new(true).open(folder.join(JOURNAL))?;
        File::open(folder)?.sync_all()?;
        Ok(Self::over(Box::new(file)))
    }

    /// Writes to something.
    #[must_use]
    pub fn over(sink: Box<dyn Sink>) -> Self {
        // Six seconds of records: a disk that takes longer counts as failed.
        let (lines, received) = sync_channel(1000);
        let failed = Arc::new(AtomicBool::new(false));
        let flag = Arc::clone(&failed);
        let thread = std::thread::spawn(move || {
            if write_all(sink, &received).is_err() {
                flag.store(true, Ordering::SeqCst);
            }
        });
        Self { lines: Some(lines), failed, thread: Some(thread) }
    }

    /// Hands a record over; never waits.
    pub fn record(&self, record: &Record) {
        let sent = self.lines.as_ref().map(|lines| lines.try_send(record.line()));
        if matches!(sent, None | Some(Err(TrySendError::Full(_) | TrySendError::Disconnected(_)))) {
            self.failed.store(true, Ordering::SeqCst);
        }
    }

    /// The same, but waits for room: for a rig whose time runs faster than the disk.
    pub fn record_patiently(&self, record: &Record) {
        if self.lines.as_ref().is_none_or(|lines| lines.send(record.line()).is_err()) {
            self.failed.store(true, Ordering::SeqCst);
        }
    }

    /// Whether everything has been written so far, as far as is known.
    #[must_use]
    pub fn good(&self) -> bool {
        !self.failed.load(Ordering::SeqCst)
    }

    /// Writes and synchronises what is left; whether all of it arrived.
    #[must_use]
    pub fn finish(mut self) -> bool {
        self.close();
        self.good()
    }

    fn close(&mut self) {
        self.lines = None;
        if let Some(thread) = self.thread.take()
            && thread.join().is_err()
        {
            self.failed.store(true, Ordering::SeqCst);
        }
    }
}

impl Drop for Recorder {
    fn drop(&mut self) {
        self.close();
    }
}

fn write_all(mut sink: Box<dyn Sink>, lines: &Receiver<String>) -> io::Result<()> {
    let mut synchronised = Instant::now();
    while let Ok(line) = lines.recv() {
        sink.write_all(line.as_bytes())?;
        if synchronised.elapsed() >= SYNC_EVERY {
            sink.synchronise()?;
            synchronised = Instant::now();
        }
    }
    sink.synchronise()
}
