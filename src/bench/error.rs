//! What can be wrong with a description or with measured data, and where.

use crate::case::Place;
use crate::quantity::QuantityError;
use std::fmt;

/// What is wrong.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Problem {
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
    /// Nothing in a file of measurements could be used.
    #[error("nothing in `{path}` can be used: {reason}")]
    NoData {
        /// The file, or what stands for several.
        path: String,
        /// Why.
        reason: String,
    },
}

/// A [`Problem`] with its place in a file if it has one. Displays as one line; with the feature `cli` it is a
/// `miette::Diagnostic`, which underlines the place.
#[derive(Debug, Clone, PartialEq)]
pub struct BenchError(Box<(Problem, Option<Place>, Option<String>)>);

impl BenchError {
    pub(crate) fn new(problem: Problem, place: Option<Place>) -> Self {
        Self(Box::new((problem, place, None)))
    }

    pub(crate) fn read(path: &std::path::Path, error: &std::io::Error) -> Self {
        Problem::Read { path: path.display().to_string(), reason: error.to_string() }.into()
    }

    /// With advice on what to try.
    #[must_use]
    pub(crate) fn advise(mut self, advice: impl Into<String>) -> Self {
        self.0.2 = Some(advice.into());
        self
    }

    /// What is wrong.
    pub fn problem(&self) -> &Problem {
        &self.0.0
    }

    /// Where, if a text says it.
    pub fn place(&self) -> Option<&Place> {
        self.0.1.as_ref()
    }

    /// What to try, if there is more to say than the message says.
    pub fn advice(&self) -> Option<&str> {
        self.0.2.as_deref()
    }
}

impl From<Problem> for BenchError {
    fn from(problem: Problem) -> Self {
        Self::new(problem, None)
    }
}

impl fmt::Display for BenchError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&crate::text::printable(&self.problem().to_string()))
    }
}

impl std::error::Error for BenchError {}

#[cfg(feature = "cli")]
mod diagnostic {
    use super::BenchError;
    use miette::{Diagnostic, LabeledSpan, SourceCode};
    use std::fmt;

    impl Diagnostic for BenchError {
        fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
            Some(Box::new(self.advice()?))
        }

        fn source_code(&self) -> Option<&dyn SourceCode> {
            self.place().map(|place| place.source.as_ref() as &dyn SourceCode)
        }

        fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
            let place = self.place()?;
            let span = if place.value.is_empty() { place.key.clone() } else { place.value.clone() };
            Some(Box::new(std::iter::once(LabeledSpan::new_with_span(Some("here".into()), span))))
        }
    }
}
