//! Why a drive has no equilibrium.

use thiserror::Error;

use super::point::Phase;
use crate::actuator::ActuatorError;
use crate::drive::Failure;
use crate::model::InternalError;

/// Why a drive has no equilibrium, or none was found.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum EquilibriumError {
    /// The case lacks a part of the drive.
    #[error("the case has no {what}: {needs}")]
    Missing {
        /// What is missing.
        what: &'static str,
        /// What it takes.
        needs: &'static str,
    },
    /// A speed that no equilibrium can have.
    #[error("the speed of the secondary is {0} rad/s: expected a positive one")]
    Speed(f64),
    /// The actuators do not press where the drive would have to be.
    #[error("{phase}: {error}")]
    Actuator {
        /// Where the sheaves stand.
        phase: Phase,
        /// What is wrong.
        error: ActuatorError,
    },
    /// The flyweights do not overcome their spring.
    #[error(
        "the flyweights press with {force:.1} N less than their spring at {:.0} rpm: the primary is open, and the belt \
         carries no torque", speed * 30.0 / std::f64::consts::PI
    )]
    Disengaged {
        /// Speed of the primary, rad/s.
        speed: f64,
        /// By how much the spring is stronger, N.
        force: f64,
    },
    /// The boundary value problem was not solved.
    #[error("{phase}: {failure}")]
    Failure {
        /// Where the sheaves were taken to stand.
        phase: Phase,
        /// Why.
        failure: Box<Failure>,
    },
    /// No state is consistent with all stops.
    #[error(
        "no state of the drive is consistent with its stops: {0} were tried in turn, and each was left for another"
    )]
    Cycle(usize),
    /// What must not happen.
    #[error(transparent)]
    Internal(#[from] InternalError),
}

impl EquilibriumError {
    /// Whether the case is at fault rather than the search.
    pub fn is_bad_input(&self) -> bool {
        match self {
            Self::Missing { .. } | Self::Speed(_) => true,
            Self::Failure { failure, .. } => failure.is_bad_input(),
            Self::Actuator { .. } | Self::Disengaged { .. } | Self::Cycle(_) | Self::Internal(_) => false,
        }
    }

    /// Whether the search was stopped from elsewhere: see [`cancellable`](crate::cancellable).
    pub fn is_cancelled(&self) -> bool {
        matches!(self, Self::Failure { failure, .. } if failure.is_cancelled())
    }

    /// What to try, where there is more to say than the message says.
    pub fn hint(&self) -> Option<&'static str> {
        match self {
            Self::Failure { .. } => Some(
                "the belt may slip grossly with what the actuators press: heavier flyweights, a stiffer secondary \
                 spring or a smaller helix angle clamp it tighter",
            ),
            Self::Disengaged { .. } => {
                Some("try a higher speed of the secondary, heavier flyweights or a softer spring")
            }
            _ => None,
        }
    }
}
