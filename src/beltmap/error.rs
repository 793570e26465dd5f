//! What can be wrong with a map.

use crate::case::{CaseError, Key};
use crate::model::InternalError;
use crate::study::StudyError;
use std::io;
use thiserror::Error;

/// Why there is no map.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum MapError {
    /// The case is wrong.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// What is varied is wrong, or a row could not be kept.
    #[error(transparent)]
    Study(#[from] StudyError),
    /// What must not happen.
    #[error(transparent)]
    Internal(#[from] InternalError),
    /// Nothing to be over.
    #[error(
        "a map needs axes: expected --over KEY=FROM..TO, such as `ratio=0.7..3.2`, up to {} times",
        super::MAX_AXES
    )]
    Axes,
    /// A key that a map cannot be over.
    #[error(
        "`{}` is no axis of a map: expected the ratio, a radius, a speed, a load, a clamp, or a stiffness or friction \
         of the belt", key.path()
    )]
    NotAnAxis {
        /// The key.
        key: Key,
    },
    /// Keys that go together.
    #[error("`{text}`: each axis of a map is one key")]
    Together {
        /// As given.
        text: String,
    },
    /// One key on two axes.
    #[error("`{}` is an axis twice", key.path())]
    Twice {
        /// The key.
        key: Key,
    },
    /// An axis without extent.
    #[error("`{}`: expected a range of finite values, such as 1..2", key.path())]
    TooShort {
        /// The key.
        key: Key,
    },
    /// A number out of its range.
    #[error("{what} is {given}: expected {expected}")]
    Parameter {
        /// What it is.
        what: &'static str,
        /// As given.
        given: f64,
        /// What is expected.
        expected: &'static str,
    },
    /// Heat makes the belt's properties depend on its past.
    #[error(
        "`[thermal]` is given: a map is of a belt at one temperature; take the section out (--unset thermal.ambient \
         --unset thermal.heat_transfer) and give the stiffnesses at that temperature"
    )]
    Thermal,
    /// A margin is solved for by several problems.
    #[error("`{}` is given: expected a tension or an axial force for the clamp of a map", key.path())]
    Margin {
        /// The key.
        key: Key,
    },
    /// No cell of the grid can be interpolated in.
    #[error(
        "no cell of the map has a solution at all its corners ({solved} of {nodes} nodes have one, {slipping} slip): \
         give a smaller torque, a tighter clamp or a smaller range"
    )]
    Empty {
        /// Nodes.
        nodes: usize,
        /// Of these, with a solution short of the slip limit.
        solved: usize,
        /// Of these, beyond the slip limit.
        slipping: usize,
    },
}

/// Why a map has no value at a point.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum Outside {
    /// Another number of coordinates than axes.
    #[error("{given} coordinates are given: the map has {expected} axes")]
    Coordinates {
        /// As given.
        given: usize,
        /// Axes.
        expected: usize,
    },
    /// Beyond an end of an axis.
    #[error("`{}` is {value} (SI): the map reaches from {from} to {to}", key.path())]
    Range {
        /// The axis.
        key: Key,
        /// The coordinate, SI.
        value: f64,
        /// First breakpoint, SI.
        from: f64,
        /// Last breakpoint, SI.
        to: f64,
    },
    /// In a cell that reaches beyond the slip limit, or that has a corner without a solution.
    #[error("the belt slips there, or in the same cell of the map: it has no value")]
    Slipping,
    /// A quantity that the map does not have.
    #[error("the map does not have `{0}`")]
    Quantity(&'static str),
}

/// Why a file is no map.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum MapFileError {
    /// The system's word.
    #[error("{path}: {error}")]
    Read {
        /// The file.
        path: String,
        /// What the system says.
        error: io::Error,
    },
    /// Not what `sheave map` writes.
    #[error("{path}: {reason}; expected a map that `sheave map` wrote")]
    Format {
        /// The file.
        path: String,
        /// What is wrong.
        reason: String,
    },
}
