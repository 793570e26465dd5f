//! Where a continuation stands, as text that a later process resumes from.

use super::arclength::Direction;
use crate::guess::{Guess, RegionGuess};
use crate::observer::{Event, Observer};
use std::fs;
use std::hash::{BuildHasher, RandomState};
use std::io::{self, BufRead, BufReader, Write};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use thiserror::Error;

const HEADER: &str = "bvp checkpoint 2";

/// A point that a continuation has reached. Written and read without loss.
#[derive(Debug, Clone, PartialEq)]
pub struct Checkpoint {
    /// Path parameter λ, or arclength on a branch.
    pub position: f64,
    /// The next step.
    pub step: f64,
    /// Meshes, states and constants.
    pub guess: Guess,
    /// On a branch, the direction in which it goes on; none on a path.
    pub direction: Option<Direction>,
}

/// A checkpoint that cannot be read.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum CheckpointError {
    /// Reading failed.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// The text is no checkpoint.
    #[error("line {line} of the checkpoint: {expected} expected")]
    Format {
        /// Counted from 1.
        line: usize,
        /// What should stand there.
        expected: &'static str,
    },
}

impl Checkpoint {
    /// One line for the header, one for position, step, number of regions and whether a direction follows, one for the
    /// constants; for each region its number of states, its mesh, and a line a state; then the direction's constants
    /// and states. Numbers have as many digits as it takes to read back the same.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn write(&self, mut out: impl Write) -> io::Result<()> {
        writeln!(out, "{HEADER}")?;
        let mut line = |values: &[f64]| {
            let words: Vec<String> = values.iter().map(|value| format!("{value:e}")).collect();
            writeln!(out, "{}", words.join(" "))
        };
        let directed = if self.direction.is_some() { 1.0 } else { 0.0 };
        line(&[self.position, self.step, self.guess.regions.len() as f64, directed])?;
        line(&self.guess.constants)?;
        for region in &self.guess.regions {
            line(&[region.states.len() as f64])?;
            line(&region.mesh)?;
            region.states.iter().try_for_each(|state| line(state))?;
        }
        if let Some(direction) = &self.direction {
            line(&direction.constants)?;
            direction.states.iter().flatten().try_for_each(|rates| line(rates))?;
        }
        out.flush()
    }

    /// Each line must be complete, the last one too: a number that was cut off would be another number.
    ///
    /// # Errors
    /// [`CheckpointError`].
    pub fn read(input: impl BufRead) -> Result<Self, CheckpointError> {
        let mut lines = Lines { input, line: 0 };
        if lines.next("the header")? != HEADER {
            return Err(CheckpointError::Format { line: 1, expected: "a header of this version" });
        }
        let head = lines.numbers("position, step, number of regions, and 1 or 0", Some(4))?;
        let &[position, step, regions, directed] = head.as_slice() else {
            return Err(CheckpointError::Format { line: 2, expected: "four numbers" });
        };
        let constants = lines.numbers("the constants", None)?;
        let mut guess = Guess { regions: Vec::new(), constants };
        for _ in 0..regions as usize {
            let states = lines.numbers("the number of states", Some(1))?;
            let count = states.first().map_or(0, |&count| count as usize);
            let mesh = lines.numbers("a mesh", None)?;
            let state = |_| lines.numbers("as many values of a state as nodes", Some(mesh.len()));
            let states = (0..count).map(state).collect::<Result<_, _>>()?;
            guess.regions.push(RegionGuess { mesh, states });
        }
        let direction = (directed == 1.0).then(|| lines.direction(&guess)).transpose()?;
        Ok(Self { position, step, guess, direction })
    }

    /// Writes to a file that is replaced as a whole: whoever stops the process finds the old checkpoint or the new one.
    ///
    /// # Errors
    /// Those of the file system.
    pub fn save(&self, path: &Path) -> io::Result<()> {
        // Two that save to one path do not write into each other's file: threads, or processes that have the same
        // number, as in containers.
        let mut beside = path.as_os_str().to_owned();
        beside.push(format!(".{:016x}.new", RandomState::new().hash_one(path)));
        let written = fs::File::create_new(&beside).and_then(|file| {
            self.write(io::BufWriter::new(&file))?;
            file.sync_all()?;
            fs::rename(&beside, path)
        });
        written.inspect_err(|_| drop(fs::remove_file(&beside)))
    }

    /// # Errors
    /// [`CheckpointError`].
    pub fn load(path: &Path) -> Result<Self, CheckpointError> {
        Self::read(BufReader::new(fs::File::open(path)?))
    }
}

struct Lines<B> {
    input: B,
    line: usize,
}

impl<B: BufRead> Lines<B> {
    fn next(&mut self, expected: &'static str) -> Result<String, CheckpointError> {
        self.line += 1;
        let mut text = String::new();
        self.input.read_line(&mut text)?;
        match text.strip_suffix('\n') {
            Some(line) => Ok(line.strip_suffix('\r').unwrap_or(line).to_owned()),
            None => Err(CheckpointError::Format { line: self.line, expected }),
        }
    }

    /// The finite numbers of one line: so many, if that is known.
    fn numbers(&mut self, expected: &'static str, count: Option<usize>) -> Result<Vec<f64>, CheckpointError> {
        let text = self.next(expected)?;
        let wrong = || CheckpointError::Format { line: self.line, expected };
        let finite = |word: &str| word.parse().ok().filter(|number: &f64| number.is_finite()).ok_or_else(wrong);
        let numbers: Vec<f64> = text.split_whitespace().map(finite).collect::<Result<_, _>>()?;
        if count.is_none_or(|count| numbers.len() == count) { Ok(numbers) } else { Err(wrong()) }
    }

    fn direction(&mut self, guess: &Guess) -> Result<Direction, CheckpointError> {
        let constants = self.numbers("the constants' rates", Some(guess.constants.len()))?;
        let mut states = Vec::new();
        for region in &guess.regions {
            let rates = |_| self.numbers("as many rates of a state as nodes", Some(region.mesh.len()));
            states.push((0..region.states.len()).map(rates).collect::<Result<_, _>>()?);
        }
        Ok(Direction { states, constants })
    }
}

/// An observer that saves every checkpoint to a file.
#[derive(Debug)]
pub struct Saved {
    path: PathBuf,
    /// The last failure to save; the continuation goes on.
    pub failure: Option<io::Error>,
}

impl Saved {
    /// Saves to this path.
    pub fn to(path: impl Into<PathBuf>) -> Self {
        Self { path: path.into(), failure: None }
    }
}

impl Observer for Saved {
    fn notify(&mut self, _: &Event) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    fn wants_checkpoints(&self) -> bool {
        true
    }

    fn checkpoint(&mut self, checkpoint: &Checkpoint) {
        if let Err(error) = checkpoint.save(&self.path) {
            self.failure = Some(error);
        }
    }
}
