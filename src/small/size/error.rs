//! What can be wrong with a drive that is to be sized, and where.

use crate::case::Place;
use crate::quantity::QuantityError;
use crate::text::printable;
use std::fmt;

/// What is wrong.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Problem {
    /// The file cannot be read.
    #[error("cannot read the file `{path}`: {reason}")]
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
    /// A setting without `=`.
    #[error("`{text}` sets nothing: expected KEY=VALUE, such as `linear.mass=\"50 kg\"`")]
    Assignment {
        /// As given.
        text: String,
    },
    /// An idler that is not two quantities.
    #[error("`{text}` is no idler: expected INERTIA,DIAMETER, such as `\"3e-4 kg*m^2, 60 mm\"`")]
    IdlerText {
        /// As given.
        text: String,
    },
    /// A key that does not exist.
    #[error("unknown key `{path}`: expected one of {known}")]
    UnknownKey {
        /// As given, with its section.
        path: String,
        /// The keys that exist.
        known: String,
    },
    /// A section that is not a table, or a value that is neither a number nor a string.
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
        path: &'static str,
        /// As given.
        given: String,
        /// What is wrong with it.
        reason: QuantityError,
        /// What is expected.
        expected: String,
    },
    /// A quantity out of its range.
    #[error("`{path}` = {given} is out of range: expected {expected}")]
    OutOfRange {
        /// The key.
        path: &'static str,
        /// As given.
        given: String,
        /// What is expected.
        expected: String,
    },
    /// Numbers of which something that is wanted is too large, or does not exist.
    #[error(
        "these numbers are too large, or too small, to compute with: an inertia or a torque is not a finite number; \
         check their units"
    )]
    Overflow,
    /// A key that must be given.
    #[error("`{path}` is not given: expected {expected}")]
    Missing {
        /// The key.
        path: &'static str,
        /// What is expected.
        expected: String,
    },
}

/// A [`Problem`] with its place in the file or the argument. Displays as one line; with the feature `cli` it is a
/// `miette::Diagnostic`, which underlines the place.
#[derive(Debug, Clone, PartialEq)]
pub struct SizeError(Box<(Problem, Option<Place>)>);

impl SizeError {
    pub(super) fn new(problem: Problem, place: Option<Place>) -> Self {
        Self(Box::new((problem, place)))
    }

    /// What is wrong.
    pub fn problem(&self) -> &Problem {
        &self.0.0
    }

    /// Where, if a text says it.
    pub fn place(&self) -> Option<&Place> {
        self.0.1.as_ref()
    }
}

impl fmt::Display for SizeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&printable(&self.problem().to_string()))
    }
}

impl std::error::Error for SizeError {}

#[cfg(feature = "cli")]
mod diagnostic {
    use super::SizeError;
    use miette::{Diagnostic, LabeledSpan, SourceCode};

    impl Diagnostic for SizeError {
        fn source_code(&self) -> Option<&dyn SourceCode> {
            self.place().map(|place| place.source.as_ref() as &dyn SourceCode)
        }

        fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
            let place = self.place()?;
            let span = if place.value.is_empty() { place.key.clone() } else { place.value.clone() };
            let span = place.source.shown(span)?;
            Some(Box::new(std::iter::once(LabeledSpan::new_with_span(Some("here".into()), span))))
        }
    }
}
