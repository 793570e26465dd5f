//! What can be wrong with a description or with measured data, and where.

use crate::case::Placed;
use crate::quantity::QuantityError;

/// What is wrong.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BenchProblem {
    /// A file cannot be read.
    #[error("cannot read `{path}`: {reason}")]
    Read {
        /// As given.
        path: String,
        /// The system's words.
        reason: String,
    },
    /// The file is not TOML.
    #[error("this is not valid TOML: {message}")]
    Syntax {
        /// The parser's words.
        message: String,
    },
    /// A key that does not exist.
    #[error("unknown key `{path}`: expected {known}")]
    UnknownKey {
        /// As given, with its section.
        path: String,
        /// The keys that exist.
        known: String,
    },
    /// A section that is not a table, or a value of another type.
    #[error("`{path}` is {given}: expected {expected}")]
    Type {
        /// Key or section.
        path: String,
        /// Kind of value given.
        given: &'static str,
        /// What is expected.
        expected: String,
    },
    /// A text that is no quantity, or one of another dimension.
    #[error("`{path}` = {given}: {reason}; expected {expected}")]
    Quantity {
        /// The key.
        path: String,
        /// As given.
        given: String,
        /// What is wrong with it.
        reason: QuantityError,
        /// What is expected.
        expected: String,
    },
    /// A value out of its range.
    #[error("`{path}` = {given} is out of range: expected {expected}")]
    OutOfRange {
        /// The key.
        path: String,
        /// As given.
        given: String,
        /// What is expected.
        expected: String,
    },
    /// A key that must be given.
    #[error("`{path}` is not given: expected {expected}")]
    Missing {
        /// The key.
        path: String,
        /// What is expected.
        expected: String,
    },
    /// Values that do not go together, or with which nothing can be computed.
    #[error("`{path}`: {reason}")]
    Unusable {
        /// The key, option or file at fault.
        path: String,
        /// Why.
        reason: String,
    },
    /// A line of a file of measurements that must be right: a header, a calibration, an engine curve.
    #[error("`{path}`, line {line}: {reason}")]
    Line {
        /// The file.
        path: String,
        /// Counted from 1.
        line: u64,
        /// What is wrong, and what is expected.
        reason: String,
    },
    /// The model has no solution, or none was found.
    #[error("`{path}`: {reason}")]
    NoSolution {
        /// What it was to be solved for.
        path: String,
        /// Why.
        reason: String,
    },
    /// Stopped from elsewhere: see [`cancellable`](crate::cancellable).
    #[error("cancelled")]
    Cancelled,
    /// Nothing in a file of measurements could be used.
    #[error("nothing in `{path}` can be used: {reason}")]
    NoData {
        /// The file, or what stands for several.
        path: String,
        /// Why.
        reason: String,
    },
}

/// A [`BenchProblem`] with its place in a file if it has one.
pub type BenchError = Placed<BenchProblem>;

impl BenchError {
    pub(crate) fn read(path: &std::path::Path, error: &std::io::Error) -> Self {
        BenchProblem::Read { path: path.display().to_string(), reason: error.to_string() }.into()
    }
}
