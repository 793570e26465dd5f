//! Rows as they come, kept on disk: whatever ends the program, none is lost.
//!
//! A journal is a line that says what the study is, then lines about sets of column names and about rows, as they come.
//! Every line carries a checksum, and every row the index of its point: of a line that is damaged or torn nothing is
//! believed, and the others stand. A set of names, on which many rows hang, is written twice. The file is locked while
//! a sweep writes it; once a second its lines are forced onto the disk, so that a power cut costs a second's rows at
//! most.
//!
//! Rows stay on the disk: in memory there is a place in the file for each.

pub(super) mod line;
mod own;

pub use own::{set_aside, sync_folder};

use super::plan::Study;
use super::row::{Cell, Columns, Layouts, Row};
use super::rows::StoredRows;
use line::{Line, read_row};
use own::Found;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Rows of so long may be lost in a power cut.
const UNSYNCED: Duration = Duration::from_secs(1);
/// A slow disk is given this many times as long to itself between two of its efforts.
const RESPITE: u32 = 10;
/// Longest line that is read: far more than a row has.
const LONGEST: u64 = 16 << 20;
/// Tries at a journal that comes and goes.
const TRIES: usize = 20;

/// Rows of a study that is under way, on disk.
#[derive(Debug)]
pub struct Journal {
    path: PathBuf,
    file: File,
    /// Where the file ends.
    end: u64,
    layouts: Layouts,
    /// By point: where its row's line begins, 0 for none, and its set of names.
    places: Vec<(u64, u32)>,
    rows: usize,
    solved: usize,
    damaged: Vec<usize>,
    synced: Instant,
    effort: Duration,
}

/// Why a journal cannot be used. Whatever the reason, the file is left as it was.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum JournalError {
    /// It belongs to another study.
    #[error(
        "{path} belongs to another study: {differs} differ; without --resume it is set aside and the sweep begun anew"
    )]
    Other {
        /// The journal.
        path: String,
        /// What differs.
        differs: String,
    },
    /// Another process holds it.
    #[error("another sweep is writing {path}: wait until it has ended, or give another --out")]
    Busy {
        /// The journal.
        path: String,
    },
    /// What stands there was not made by this program.
    #[error("{path} is {what}, not a journal of a sweep; it is left alone: move it away, or give another --out")]
    Foreign {
        /// Where the journal would stand.
        path: String,
        /// What does.
        what: String,
    },
    /// The system's word.
    #[error("{path}: {error}")]
    System {
        /// The journal.
        path: String,
        /// What the system says.
        error: io::Error,
    },
}

/// What a journal is about.
pub trait Journaled {
    /// Everything that the rows depend on, as one line of JSON: an object.
    fn fingerprint(&self) -> String;

    /// How many rows there may be.
    fn points(&self) -> usize;
}

impl Journaled for Study {
    fn fingerprint(&self) -> String {
        Self::fingerprint(self)
    }

    fn points(&self) -> usize {
        Self::points(self)
    }
}

impl Journal {
    /// Begins a journal at `path`. One that is there already is set aside under the first free name of `path.old.1`,
    /// `path.old.2` and so on, which is given back.
    ///
    /// # Errors
    /// See [`JournalError`]; a file that is no journal is left alone.
    pub fn begin(path: &Path, study: &dyn Journaled) -> Result<(Self, Option<PathBuf>), JournalError> {
        let system = |error| JournalError::System { path: path.display().to_string(), error };
        let mut aside = None;
        for _ in 0..TRIES {
            match own::find(path).map_err(system)? {
                Found::Nothing => match own::create(path) {
                    Ok(Found::Ours(file)) => {
                        let begun = Self::empty(path, file, study).map_err(system)?;
                        sync_folder(path);
                        return Ok((begun, aside));
                    }
                    // Another process was faster.
                    Ok(_) => {}
                    Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                    Err(error) => return Err(system(error)),
                },
                Found::Ours(mut file) => {
                    if is_torn_header(&mut file, study).map_err(system)? {
                        return Ok((Self::empty(path, file, study).map_err(system)?, aside));
                    }
                    ours(&mut file, path)?;
                    aside = Some(own::set_aside(path).map_err(system)?);
                }
                Found::Busy => return Err(JournalError::Busy { path: path.display().to_string() }),
                Found::Foreign(what) => return Err(foreign(path, what)),
            }
        }
        Err(JournalError::Busy { path: path.display().to_string() })
    }

    /// Goes on with the journal at `path`, which must be one of the same study; begins one if there is none. Lines that
    /// are damaged are passed over, see [`Journal::damaged`].
    ///
    /// # Errors
    /// See [`JournalError`].
    pub fn resume(path: &Path, study: &dyn Journaled) -> Result<Self, JournalError> {
        let system = |error| JournalError::System { path: path.display().to_string(), error };
        let mut file = match own::find(path).map_err(system)? {
            Found::Nothing => return Self::begin(path, study).map(|(journal, _)| journal),
            Found::Ours(file) => file,
            Found::Busy => return Err(JournalError::Busy { path: path.display().to_string() }),
            Found::Foreign(what) => return Err(foreign(path, what)),
        };
        if is_torn_header(&mut file, study).map_err(system)? {
            return Self::empty(path, file, study).map_err(system);
        }
        ours(&mut file, path)?;
        let mut journal = Self::new(path, file, study);
        journal.read_all(study)?;
        journal.file.set_len(journal.end).map_err(system)?;
        journal.file.seek(SeekFrom::End(0)).map_err(system)?;
        Ok(journal)
    }

    /// A journal without a name, for rows that only have to outlive the sweep; nobody can go on with it.
    ///
    /// # Errors
    /// What the system says.
    pub fn nameless(study: &dyn Journaled) -> io::Result<Self> {
        Self::empty(Path::new("a temporary file"), tempfile::tempfile()?, study)
    }

    fn new(path: &Path, file: File, study: &dyn Journaled) -> Self {
        Self {
            path: path.into(),
            file,
            end: 0,
            layouts: Layouts::default(),
            places: vec![(0, 0); study.points()],
            rows: 0,
            solved: 0,
            damaged: Vec::new(),
            synced: Instant::now(),
            effort: Duration::ZERO,
        }
    }

    /// With its first line, in a file that has at most a part of it.
    fn empty(path: &Path, mut file: File, study: &dyn Journaled) -> io::Result<Self> {
        let header = line::header(&study.fingerprint());
        file.seek(SeekFrom::Start(0))?;
        file.write_all(header.as_bytes())?;
        file.sync_all()?;
        let mut journal = Self::new(path, file, study);
        journal.end = header.len() as u64;
        Ok(journal)
    }

    /// Reads all lines, to where the last whole one ends.
    fn read_all(&mut self, study: &dyn Journaled) -> Result<(), JournalError> {
        let path = self.path.display().to_string();
        let system = |error| JournalError::System { path: path.clone(), error };
        self.file.seek(SeekFrom::Start(0)).map_err(system)?;
        let mut reader = BufReader::new(self.file.try_clone().map_err(system)?);
        let (mut text, mut number) = (Vec::new(), 0);
        loop {
            text.clear();
            let read = reader.by_ref().take(LONGEST).read_until(b'\n', &mut text).map_err(system)?;
            // Torn, or the end.
            let Some(content) = text.strip_suffix(b"\n") else { break };
            number += 1;
            if number == 1 {
                self.check(content, study)?;
            } else if self.keep_line(content).is_none() {
                self.damaged.push(number);
            }
            self.end += read as u64;
        }
        Ok(())
    }

    /// Whether the first line is that of the same study.
    fn check(&self, header: &[u8], study: &dyn Journaled) -> Result<(), JournalError> {
        let path = self.path.display().to_string();
        let Some(theirs) = line::fingerprint(header) else {
            return Err(JournalError::Foreign { path, what: "a file whose first line is damaged".into() });
        };
        let ours = study.fingerprint();
        if theirs == ours { Ok(()) } else { Err(JournalError::Other { path, differs: differences(theirs, &ours) }) }
    }

    /// Takes in a line; nothing if it is damaged.
    fn keep_line(&mut self, content: &[u8]) -> Option<()> {
        match line::read(content)? {
            Line::Columns(number, names) => self.layouts.put(number, names),
            Line::Row(index, layout, cells) => {
                if self.layouts.names(layout)?.len() != cells.len() {
                    return None;
                }
                self.place(index, layout, &cells, self.end)
            }
        }
    }

    /// Notes where a row's line begins.
    fn place(&mut self, index: usize, layout: usize, cells: &[Cell], begin: u64) -> Option<()> {
        let place = self.places.get_mut(index)?;
        if place.0 == 0 {
            *place = (begin, u32::try_from(layout).ok()?);
            self.rows += 1;
            self.solved += usize::from(self.layouts.is_solved(layout, cells));
        }
        Some(())
    }

    /// Whether the point has its row.
    pub fn has(&self, index: usize) -> bool {
        self.places.get(index).is_some_and(|place| place.0 != 0)
    }

    /// How many rows there are.
    pub fn len(&self) -> usize {
        self.rows
    }

    /// Whether there is no row.
    pub fn is_empty(&self) -> bool {
        self.rows == 0
    }

    /// Lines, counted from 1, that were found damaged and passed over; what they said is not known.
    pub fn damaged(&self) -> &[usize] {
        &self.damaged
    }

    /// The rows that are there, each with the number of its point.
    ///
    /// # Errors
    /// What the system says.
    pub fn rows(&mut self) -> io::Result<Vec<Row>> {
        let mut rows = Vec::with_capacity(self.rows);
        let mut reader = BufReader::new(self.file.try_clone()?);
        let mut text = Vec::new();
        for (index, (place, layout)) in self.places.iter().enumerate().filter(|(_, (place, _))| *place != 0) {
            text.clear();
            reader.seek(SeekFrom::Start(*place))?;
            reader.by_ref().take(LONGEST).read_until(b'\n', &mut text)?;
            let read = text.strip_suffix(b"\n").and_then(read_row);
            let names = self.layouts.names(*layout as usize).cloned();
            if let (Some((_, cells)), Some(columns)) = (read, names) {
                rows.push(Row { index, columns, cells });
            }
        }
        self.file.seek(SeekFrom::Start(self.end))?;
        Ok(rows)
    }

    /// Adds a row, and returns when the system has it.
    ///
    /// # Errors
    /// What the system says.
    pub fn add(&mut self, row: Row) -> io::Result<()> {
        if self.has(row.index) {
            return Ok(());
        }
        let (layout, new) = self.layouts.number(row.columns);
        if new && let Some(names) = self.layouts.names(layout) {
            let names = line::columns(layout, names);
            self.write(&[names.as_bytes(), names.as_bytes()].concat())?;
        }
        let begin = self.end;
        self.write(line::row(row.index, layout, &row.cells).as_bytes())?;
        self.place(row.index, layout, &row.cells, begin);
        self.sync()
    }

    /// Writes at the end. What was written in part, as on a full disk, is taken back.
    fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        if let Err(error) = self.file.write_all(bytes) {
            // If even that fails the line is torn, and not believed.
            let _ = self.file.set_len(self.end);
            return Err(error);
        }
        self.end += bytes.len() as u64;
        Ok(())
    }

    /// Has the lines put on the disk, once in a while.
    fn sync(&mut self) -> io::Result<()> {
        if self.synced.elapsed() < UNSYNCED.max(RESPITE * self.effort) {
            return Ok(());
        }
        let start = Instant::now();
        self.file.sync_data()?;
        (self.synced, self.effort) = (Instant::now(), start.elapsed());
        Ok(())
    }

    /// Ends the journal: its rows are read from it, and its file stays locked until [`StoredRows::remove`].
    ///
    /// # Errors
    /// What the system says.
    pub fn finish(self) -> io::Result<StoredRows> {
        self.file.sync_data()?;
        Ok(StoredRows::new(self.path, self.file, self.layouts, self.places, self.rows - self.solved))
    }
}

/// Refuses a file that does not begin as a journal does.
fn ours(file: &mut File, path: &Path) -> Result<(), JournalError> {
    let system = |error| JournalError::System { path: path.display().to_string(), error };
    let mut start = Vec::new();
    file.seek(SeekFrom::Start(0)).map_err(system)?;
    file.take(line::MAGIC.len() as u64).read_to_end(&mut start).map_err(system)?;
    if start == line::MAGIC.as_bytes() { Ok(()) } else { Err(foreign(path, "a file of something else")) }
}

/// Whether the file is nothing but the beginning of this study's first line: a sweep was ended while it wrote it.
fn is_torn_header(file: &mut File, study: &dyn Journaled) -> io::Result<bool> {
    let header = line::header(&study.fingerprint());
    if file.metadata()?.len() >= header.len() as u64 {
        return Ok(false);
    }
    let mut start = Vec::new();
    file.seek(SeekFrom::Start(0))?;
    file.take(header.len() as u64).read_to_end(&mut start)?;
    Ok(header.as_bytes().starts_with(&start))
}

fn foreign(path: &Path, what: &str) -> JournalError {
    JournalError::Foreign { path: path.display().to_string(), what: what.into() }
}

/// Names of what two fingerprints do not have in common.
fn differences(theirs: &str, ours: &str) -> String {
    let read =
        |text: &str| serde_json::from_str::<serde_json::Map<String, serde_json::Value>>(text).unwrap_or_default();
    let (theirs, ours) = (read(theirs), read(ours));
    let differ = |name: &&String| theirs.get(*name) != ours.get(*name);
    let names: Columns = ours.keys().filter(differ).cloned().collect();
    names.join(", ")
}
