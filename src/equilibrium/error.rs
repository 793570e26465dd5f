//! Why a drive has no equilibrium.

use thiserror::Error;

use super::phase::Phase;
use crate::actuator::ActuatorError;
use crate::drive::{Failure, Trouble};
use crate::model::InternalError;
use crate::quantity::rpm;

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
        "the flyweights press with {force:.1} N less than their spring at {:.0} rpm, to which a belt that does not \
         slip would hold the engine: the primary is open, and no state was found in which the belt slips and carries \
         torque",
        rpm(*speed)
    )]
    Disengaged {
        /// Speed of the primary, rad/s.
        speed: f64,
        /// By how much the spring is stronger, N.
        force: f64,
    },
    /// A speed at which the engine would have to turn far faster than its torque is known.
    #[error(
        "with the secondary at {:.0} rpm the engine would have to turn at some {:.0} rpm even at the ratio of \
         {ratio:.2} at which the sheaves stand highest, and its torque is known up to {:.0} rpm",
        rpm(*secondary_speed), rpm(ratio * secondary_speed), rpm(*last_speed)
    )]
    BeyondEngine {
        /// Speed of the secondary, rad/s.
        secondary_speed: f64,
        /// R_S/R_P at the high stop.
        ratio: f64,
        /// The highest speed for which the engine's torque is given, rad/s.
        last_speed: f64,
    },
    /// The boundary value problem was not solved.
    #[error("{phase}: {}", told(.failure))]
    Failure {
        /// Where the sheaves were taken to stand.
        phase: Phase,
        /// Why.
        failure: Box<Failure>,
        /// Whether a belt without bending stiffness has a slip threshold that is smaller than its equilibria are
        /// found with.
        sharp: bool,
    },
    /// No state is consistent with all stops.
    #[error(
        "no state of the drive is consistent with its stops: {0} were tried in turn, and each was left for another"
    )]
    Cycle(usize),
    /// The equations hold, and the drive does not come to such a state.
    #[error("{phase}: {why}")]
    Implausible {
        /// Where the sheaves were taken to stand.
        phase: Phase,
        /// What is wrong with it.
        why: &'static str,
    },
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
            Self::Actuator { .. }
            | Self::Disengaged { .. }
            | Self::BeyondEngine { .. }
            | Self::Cycle(_)
            | Self::Implausible { .. }
            | Self::Internal(_) => false,
        }
    }

    /// Whether the search was stopped from elsewhere: see [`cancellable`](crate::cancellable).
    pub fn is_cancelled(&self) -> bool {
        matches!(self, Self::Failure { failure, .. } if failure.is_cancelled())
    }

    /// Whether it is a search that was lost, with nothing to be seen on the belt.
    pub(super) fn is_unexplained(&self) -> bool {
        match self {
            Self::Failure { failure, .. } => matches!(failure.trouble(), Some(Trouble::Work | Trouble::Unknown)),
            _ => false,
        }
    }

    /// The one of two that tells what happened to the belt; the first where both do, or neither. That the search was
    /// stopped from elsewhere is told before all.
    pub(super) fn or_explained(self, other: Self) -> Self {
        let tells_more = other.is_cancelled() || self.is_unexplained() && !other.is_unexplained();
        if tells_more && !self.is_cancelled() { other } else { self }
    }

    /// What to try, where there is more to say than the message says.
    pub fn hint(&self) -> Option<&'static str> {
        match self {
            Self::Failure { failure, sharp, .. } => match failure.trouble() {
                Some(Trouble::Slip { .. } | Trouble::Pushed { .. } | Trouble::Lifted { .. }) => Some(
                    "the belt may slip grossly with what the actuators press: heavier flyweights, a stiffer secondary \
                     spring or a smaller helix angle clamp it tighter",
                ),
                Some(Trouble::Buckles { .. }) => Some(
                    "what the actuators press leaves the slack strand no tension at such a speed: heavier flyweights, \
                     a stiffer secondary spring or a smaller helix angle clamp the belt tighter",
                ),
                Some(Trouble::Deep { .. }) => Some(
                    "the actuators press the belt through its groove, or their stops leave it no room: check springs, \
                     travels and radii, and the unit of `belt.radial_stiffness`",
                ),
                Some(Trouble::Stiff { .. }) => Some(
                    "check the unit of `belt.bending_stiffness`, and that the actuators press: a belt so loose does \
                     not wrap its pulleys",
                ),
                Some(Trouble::Work | Trouble::Unknown) if *sharp => Some(
                    "without bending stiffness equilibria are found with a larger slip threshold: try \
                     `sheave.slip_threshold` of 0.005 m/s, or another edition",
                ),
                Some(Trouble::Work | Trouble::Unknown) => Some(
                    "there may be no equilibrium at this speed: `sheave shift` shows at which there is one; the engine \
                     may be out of its range, or the actuators may press too little or too much",
                ),
                None => failure.hint(),
            },
            Self::Disengaged { .. } => {
                Some("try a higher speed of the secondary, heavier flyweights or a softer spring")
            }
            Self::BeyondEngine { .. } => {
                Some("try a lower speed of the secondary, or give the engine's torque at higher speeds")
            }
            Self::Missing { .. }
            | Self::Speed(_)
            | Self::Actuator { .. }
            | Self::Cycle(_)
            | Self::Implausible { .. }
            | Self::Internal(_) => None,
        }
    }
}

/// The laws of engine and actuators are no keys of a case: how far each was met, `Failure` says to whoever asks.
fn told(failure: &Failure) -> String {
    match failure {
        Failure::Unreached { trouble, torque, slack_tension, .. } => format!(
            "no equilibrium was found: {trouble}; the last state on the way has a primary torque of {torque:.2} N·m \
             and a slack tension of {slack_tension:.2} N"
        ),
        other => other.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_belt_without_bending_stiffness_is_told_of_its_slip_threshold() {
        let lost = |sharp: bool, trouble: Trouble| {
            let cause = Box::new(solver::SolveError::Cancelled);
            let failure = Failure::Unreached { trouble, reached: Vec::new(), torque: 1.0, slack_tension: 1.0, cause };
            EquilibriumError::Failure { phase: Phase::Shift, failure: Box::new(failure), sharp }
        };
        let hint = |sharp, trouble| lost(sharp, trouble).hint().unwrap();
        assert!(hint(true, Trouble::Unknown).contains("`sheave.slip_threshold` of 0.005 m/s"));
        assert!(hint(true, Trouble::Work).contains("or another edition"));
        assert!(!hint(false, Trouble::Unknown).contains("slip_threshold"));
    }
}
