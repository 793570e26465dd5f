//! Where a continuation stands, as text that a later process resumes from.

use crate::guess::{Guess, RegionGuess};
use crate::observer::{Event, Observer};
use std::fs;
use std::io::{self, BufRead, BufReader, Write};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use thiserror::Error;

const HEADER: &str = "bvp checkpoint 1";

/// A point that a continuation has reached. Written and read without loss.
#[derive(Debug, Clone, PartialEq)]
pub struct Checkpoint {
    /// Path parameter λ, or arclength on a branch.
    pub position: f64,
    /// The next step.
    pub step: f64,
    /// On a branch, d(parameter)/d(arclength): its sign says which way the branch was traced. On a path, 1.
    pub rate: f64,
    /// Meshes, states and constants.
    pub guess: Guess,
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
    /// # Errors
    /// Those of the writer.
    pub fn write(&self, mut out: impl Write) -> io::Result<()> {
        writeln!(out, "{HEADER}")?;
        let mut line = |values: &[f64]| {
            let words: Vec<String> = values.iter().map(|value| format!("{value:e}")).collect();
            writeln!(out, "{}", words.join(" "))
        };
        line(&[self.position, self.step, self.rate, self.guess.regions.len() as f64])?;
        line(&self.guess.constants)?;
        for region in &self.guess.regions {
            line(&[region.states.len() as f64])?;
            line(&region.mesh)?;
            region.states.iter().try_for_each(|state| line(state))?;
        }
        out.flush()
    }

    /// # Errors
    /// [`CheckpointError`].
    pub fn read(input: impl BufRead) -> Result<Self, CheckpointError> {
        let mut lines = Lines { lines: input.lines(), line: 0 };
        if lines.next("the header")? != HEADER {
            return Err(CheckpointError::Format { line: 1, expected: "a header of this version" });
        }
        let head = lines.numbers("position, step, rate and number of regions")?;
        let &[position, step, rate, regions] = head.as_slice() else {
            return Err(CheckpointError::Format { line: 2, expected: "four numbers" });
        };
        let constants = lines.numbers("the constants")?;
        let mut guess = Guess { regions: Vec::new(), constants };
        for _ in 0..regions as usize {
            let states = lines.numbers("the number of states")?;
            let count = states.first().map_or(0, |&count| count as usize);
            let mesh = lines.numbers("a mesh")?;
            let states = (0..count).map(|_| lines.numbers("values of a state")).collect::<Result<_, _>>()?;
            guess.regions.push(RegionGuess { mesh, states });
        }
        Ok(Self { position, step, rate, guess })
    }

    /// Writes to a file that is replaced as a whole.
    ///
    /// # Errors
    /// Those of the file system.
    pub fn save(&self, path: &Path) -> io::Result<()> {
        let new = path.with_extension("new");
        self.write(io::BufWriter::new(fs::File::create(&new)?))?;
        fs::rename(new, path)
    }

    /// # Errors
    /// [`CheckpointError`].
    pub fn load(path: &Path) -> Result<Self, CheckpointError> {
        Self::read(BufReader::new(fs::File::open(path)?))
    }
}

struct Lines<B> {
    lines: io::Lines<B>,
    line: usize,
}

impl<B: BufRead> Lines<B> {
    fn next(&mut self, expected: &'static str) -> Result<String, CheckpointError> {
        self.line += 1;
        let line = self.line;
        self.lines.next().ok_or(CheckpointError::Format { line, expected })?.map_err(CheckpointError::Io)
    }

    fn numbers(&mut self, expected: &'static str) -> Result<Vec<f64>, CheckpointError> {
        let text = self.next(expected)?;
        let line = self.line;
        let number = |word: &str| word.parse().map_err(|_| CheckpointError::Format { line, expected });
        text.split_whitespace().map(number).collect()
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
