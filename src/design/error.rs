//! What can be wrong with a question about a design.

use thiserror::Error;

use crate::case::Key;
use crate::drive::Failure;
use crate::losses::NoLosses;
use crate::model::InternalError;
use solver::SolveError;

/// Why a limit or an optimum could not be had.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum DesignError {
    /// The case gives something in a way that leaves the question without an answer.
    #[error("`{}` is given: {expected}", key.path())]
    Given {
        /// The key at fault.
        key: Key,
        /// What is expected instead.
        expected: &'static str,
    },
    /// There is not even an operating point to start from.
    #[error("no operating point was found to start from: {0}")]
    Start(#[from] Failure),
    /// The drive from which a limit is sought is beyond it.
    #[error(
        "no drive was found with a speed efficiency of {:.2} %: already that from which the limit is sought, with \
         {torque:.2} N·m and a slack tension of {slack_tension:.1} N, has {:.2} %",
        100.0 * asked, 100.0 * had
    )]
    Beyond {
        /// Least speed efficiency asked for.
        asked: f64,
        /// Speed efficiency there is.
        had: f64,
        /// Primary torque there, N·m.
        torque: f64,
        /// Slack tension there, N.
        slack_tension: f64,
    },
    /// What must not happen.
    #[error(transparent)]
    Internal(#[from] InternalError),
    /// The equations are singular where a derivative is needed.
    #[error("a solution on the path has no derivatives: {0}")]
    Singular(#[from] SolveError),
    /// The efficiency sought has losses in it that cannot be told.
    #[error("the efficiency with losses has no optimum: {0}")]
    Losses(#[from] NoLosses),
}

impl DesignError {
    /// Whether the case is at fault rather than the search.
    pub const fn is_bad_input(&self) -> bool {
        match self {
            Self::Given { .. } => true,
            Self::Start(failure) => failure.is_bad_input(),
            Self::Beyond { .. } | Self::Singular(_) | Self::Internal(_) | Self::Losses(_) => false,
        }
    }
}
