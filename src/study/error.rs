//! What can be wrong with a study.

use crate::case::{CaseError, Key};

/// Why a study cannot be begun.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StudyError {
    /// A value that its key does not take, a case that contradicts itself, or one that cannot be solved for.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// A text that names no axis.
    #[error(
        "`{text}` is no range of a key: expected KEY=FROM..TO[:N], such as `drive.ratio=0.72..1.74:21`, or KEY=A,B,C"
    )]
    Axis {
        /// As given.
        text: String,
    },
    /// The number of points of a range.
    #[error("`{text}`: `{given}` is no number of points; expected a whole number from 1 to \
        {max}", max = super::MAX_POINTS)]
    Count {
        /// The axis as given.
        text: String,
        /// Its number of points as given.
        given: String,
    },
    /// A range of names.
    #[error("`{}` has no ranges: list the values, such as `{}`", key.path(), key.entry().expected())]
    NoRange {
        /// The key.
        key: Key,
    },
    /// Keys that go together, with unlike numbers of values.
    #[error("`{text}`: keys that go together need as many values each, and have {first} and {second}")]
    Unlike {
        /// The axis as given.
        text: String,
        /// Values of the first key.
        first: usize,
        /// Values of another.
        second: usize,
    },
    /// One key on two axes.
    #[error("`{}` is varied twice", key.path())]
    Twice {
        /// The key.
        key: Key,
    },
    /// A grid without axes.
    #[error("nothing is varied: expected a key with its values, such as `drive.ratio=0.72..1.74:21`")]
    NoAxis,
    /// A grid too large to be meant.
    #[error("the grid has more than {} points", super::MAX_POINTS)]
    TooMany,
    /// A study file that is not understood.
    #[error("{path}: {reason}")]
    File {
        /// Its name.
        path: String,
        /// What is wrong.
        reason: String,
    },
    /// The threads could not be had.
    #[error("cannot start {0} threads")]
    Threads(usize),
    /// Stopped from elsewhere; the rows that were handed over hold.
    #[error("cancelled")]
    Cancelled,
    /// A row could not be handed over.
    #[error("cannot keep a row: {0}")]
    Keep(#[from] std::io::Error),
}
