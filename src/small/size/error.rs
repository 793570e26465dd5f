//! What can be wrong with a drive that is to be sized, and where.

use crate::case::Placed;
use crate::quantity::QuantityError;

/// What is wrong.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SizeProblem {
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
    /// A key of an idler, set on its own.
    #[error(
        "`{path}` is not set on its own, as there may be several idlers: give each whole, inertia and diameter, such \
         as --idler \"3e-4 kg*m^2, 60 mm\""
    )]
    IdlerKey {
        /// As given.
        path: String,
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

/// A [`SizeProblem`] with its place in the file or the argument.
pub type SizeError = Placed<SizeProblem>;
