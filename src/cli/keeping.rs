//! Points of a map as they come, kept in a journal beside its file; and how a file takes the place of an earlier one.

use super::output;
use super::stop::Stop;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use sheave::beltmap::{Keep, Progress};
use sheave::study::{Journal, JournalError, Journaled, Row, set_aside, sync_folder};
use std::collections::HashMap;
use std::fs::File;
use std::io::{self, BufRead, BufReader, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// A journal, and a line on standard error for people to see.
pub struct Keeping {
    journal: Mutex<Journal>,
    rows: HashMap<usize, Row>,
    bar: ProgressBar,
}

impl Keeping {
    /// The journal beside a file: begun, or gone on with.
    pub fn begin(out: &Path, about: &dyn Journaled, resume: bool) -> Result<Self, Stop> {
        let path = journal_path(out);
        let begun = if resume {
            Journal::resume(&path, about)
        } else {
            Journal::begin(&path, about).map(|(journal, aside)| {
                if let Some(old) = aside {
                    let (path, old) = (path.display(), old.display());
                    tracing::warn!(
                        "{path} of a run that was ended before is now {old}; with --resume it would have been completed"
                    );
                }
                journal
            })
        };
        let mut journal = begun.map_err(|error| match error {
            JournalError::System { path, error } => Stop::Write(path, error),
            other => Stop::Usage(other.to_string()),
        })?;
        for line in journal.damaged() {
            tracing::warn!("{}, line {line} is damaged and passed over: its point is solved again", path.display());
        }
        let rows = journal.rows().map_err(|error| Stop::Write(path.display().to_string(), error))?;
        Ok(Self::new(journal, rows))
    }

    /// A journal without a name, with which nobody can go on.
    pub fn nameless(about: &dyn Journaled) -> Result<Self, Stop> {
        let journal = Journal::nameless(about).map_err(|error| Stop::Write("a temporary file".into(), error))?;
        Ok(Self::new(journal, Vec::new()))
    }

    fn new(journal: Journal, rows: Vec<Row>) -> Self {
        let target =
            if io::stderr().is_terminal() { ProgressDrawTarget::stderr() } else { ProgressDrawTarget::hidden() };
        let bar = ProgressBar::with_draw_target(None, target).with_position(rows.len() as u64);
        let bar = match ProgressStyle::with_template("{spinner} {pos} points, {per_sec}; {msg}; Ctrl-C, then --resume")
        {
            Ok(style) => bar.with_style(style),
            Err(_) => bar,
        };
        let rows = rows.into_iter().map(|row| (row.index, row)).collect();
        Self { journal: Mutex::new(journal), rows, bar }
    }

    /// Takes the line away.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }

    /// Removes the journal, when what it is about is safe elsewhere.
    pub fn remove(self) -> Result<(), Stop> {
        let stored = self.journal.into_inner().unwrap_or_else(PoisonError::into_inner).finish();
        stored.and_then(|rows| rows.remove()).map_err(|error| Stop::Write("(remove) the journal".into(), error))
    }
}

impl Keep for Keeping {
    fn kept(&self, point: usize) -> Option<Row> {
        self.rows.get(&point).cloned()
    }

    fn keep(&self, row: Row) -> io::Result<()> {
        self.journal.lock().unwrap_or_else(PoisonError::into_inner).add(row)?;
        self.bar.inc(1);
        Ok(())
    }

    fn progress(&self, progress: Progress) {
        let Progress { nodes, solved, error } = progress;
        tracing::info!("a grid of {nodes} nodes, {solved} points solved, error {error:.2e}");
        self.bar.set_message(format!("{nodes} nodes, error {error:.1e}"));
    }
}

/// Where the journal of a file stands.
fn journal_path(out: &Path) -> PathBuf {
    let mut name = out.as_os_str().to_owned();
    name.push(".journal");
    PathBuf::from(name)
}

/// Writes a file. An earlier one that says something else is kept under another name; gives that as a warning.
pub fn deliver(
    path: &Path,
    content: impl FnOnce(&mut (dyn Write + Send)) -> io::Result<()>,
) -> Result<Option<String>, Stop> {
    let stop = |error| Stop::Write(path.display().to_string(), error);
    let written = output::beside(path, content).map_err(stop)?;
    let mut warning = None;
    if path.exists() && !same_content(written.path(), path).map_err(stop)? {
        let old = set_aside(path).map_err(stop)?;
        warning = Some(format!("{} of an earlier run is now {}", path.display(), old.display()));
    }
    written.persist(path).map_err(|error| stop(error.error))?;
    sync_folder(path);
    tracing::info!("wrote {}", path.display());
    Ok(warning)
}

/// Whether two files say the same.
fn same_content(a: &Path, b: &Path) -> io::Result<bool> {
    const PART: usize = 1 << 16;
    if std::fs::metadata(a)?.len() != std::fs::metadata(b)?.len() {
        return Ok(false);
    }
    let (mut a, mut b) =
        (BufReader::with_capacity(PART, File::open(a)?), BufReader::with_capacity(PART, File::open(b)?));
    loop {
        let (left, right) = (a.fill_buf()?, b.fill_buf()?);
        let length = left.len().min(right.len());
        if length == 0 {
            return Ok(left.len() == right.len());
        }
        if left.get(..length) != right.get(..length) {
            return Ok(false);
        }
        a.consume(length);
        b.consume(length);
    }
}
