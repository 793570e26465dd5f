//! Why there is no tune.

use crate::beltmap::MapError;
use crate::case::{CaseError, Key};
use crate::model::InternalError;
use thiserror::Error;

/// What is wrong with a box of parts, beyond its form.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum PartsProblem {
    /// A key of what all parts share.
    #[error(
        "`{kind}` sets `{}`: expected keys of [primary.actuator], [primary.spring], [secondary.actuator] or \
         [secondary.spring]; belt, sheaves, stops, losses and engine are the case's, for one map of the belt serves \
         all parts", key.path()
    )]
    Shared {
        /// The kind of parts.
        kind: String,
        /// What it sets.
        key: Key,
    },
    /// A key that two kinds set.
    #[error(
        "`{}` is set by two kinds of parts, `{first}` and `{second}`: expected one that sets it, for of each kind one \
         part is chosen", key.path()
    )]
    Twice {
        /// The key.
        key: Key,
        /// A kind that sets it.
        first: String,
        /// Another.
        second: String,
    },
    /// A key that does not exist, or a value that it does not take.
    #[error("`{kind}`: {error}")]
    Value {
        /// The kind of parts.
        kind: String,
        /// What is wrong with it.
        error: CaseError,
    },
}

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
    /// The box of parts is wrong.
    #[error(transparent)]
    Box(#[from] PartsProblem),
    /// There is no map of the belt.
    #[error("the map of the belt: {0}")]
    Map(#[from] MapError),
    /// What must not happen.
    #[error(transparent)]
    Internal(#[from] InternalError),
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
    /// A map of another belt, or made with other choices.
    #[error("the map was made with `{key}` = {map}, and the case has {case}: expected a map of this case's belt")]
    OtherMap {
        /// The first key that differs.
        key: &'static str,
        /// Its value in the map, as people read it.
        map: String,
        /// Its value in the case.
        case: String,
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
