//! Why there is no tune.

use crate::beltmap::MapError;
use crate::case::{CaseError, Key};
use thiserror::Error;

/// Why the search for a tune cannot be begun.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum TuneError {
    /// The case is wrong.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// The file of parts is wrong.
    #[error("{path}: {reason}")]
    Parts {
        /// The file.
        path: String,
        /// What is wrong.
        reason: String,
    },
    /// There is no map of the belt.
    #[error("the map of the belt: {0}")]
    Map(#[from] MapError),
    /// The drive lacks what the search needs.
    #[error("the drive has no {what}: {needs}")]
    Missing {
        /// What is missing.
        what: &'static str,
        /// What to give.
        needs: &'static str,
    },
    /// No combination of parts makes a drive.
    #[error("none of the {count} combinations of parts makes a drive; the first: {reason}")]
    NoDrive {
        /// How many there are.
        count: usize,
        /// What is wrong with the first.
        reason: String,
    },
    /// A map that is not over what the search needs.
    #[error("the map is not over `{}`: expected one over {expected}", key.path())]
    Axis {
        /// The missing axis.
        key: Key,
        /// What is expected.
        expected: &'static str,
    },
    /// A number out of its range.
    #[error("{what} is {given}: expected {expected}")]
    Parameter {
        /// What it is.
        what: &'static str,
        /// As given.
        given: String,
        /// What is expected.
        expected: String,
    },
    /// The threads could not be had.
    #[error("cannot start {0} threads")]
    Threads(usize),
}
