//! Why there is no profile.

use thiserror::Error;

use crate::actuator::ActuatorError;
use crate::case::CaseError;
use crate::drive::Failure;
use crate::equilibrium::EquilibriumError;
use crate::model::InternalError;

/// Why no profile holds the engine at a speed.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum InverseError {
    /// The case, or the one with the profile in it, is refused.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// The case lacks a part, or the drive with the profile has no equilibrium.
    #[error(transparent)]
    Equilibrium(#[from] EquilibriumError),
    /// The case lacks what a profile is made for.
    #[error("the case has no {what}: {needs}")]
    Missing {
        /// What is missing.
        what: &'static str,
        /// What to give.
        needs: &'static str,
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
    /// There is no solution of the belt.
    #[error("at ratio {ratio:.2}, {clamp} no belt at the target's speed and full torque: {failure}")]
    Belt {
        /// Nominal ratio.
        ratio: f64,
        /// What was to clamp it, with a verb.
        clamp: &'static str,
        /// Why.
        failure: Box<Failure>,
    },
    /// The belt lies on a radius of the secondary that has nothing to do with its length.
    #[error(
        "at ratio {left:.2}, {clamp} no belt at the target's speed and full torque: the only state found has the belt \
         far deeper in the secondary than its length leaves it, at ratio {ratio:.2}"
    )]
    Deep {
        /// Ratio of the radii found.
        ratio: f64,
        /// Nominal ratio that the belt's length leaves.
        left: f64,
        /// What was to clamp it, with a verb.
        clamp: &'static str,
    },
    /// The reserve against slip is too small.
    #[error(
        "at ratio {ratio:.2}, {:.1} % of the friction at hand is in reserve, and {:.1} % are asked for: {remedy}",
        100.0 * reserve, 100.0 * wanted
    )]
    Reserve {
        /// Nominal ratio.
        ratio: f64,
        /// Share of the friction at hand that is left over.
        reserve: f64,
        /// Share that is asked for.
        wanted: f64,
        /// What to try.
        remedy: &'static str,
    },
    /// A part that is given does not press as it should.
    #[error("{error}")]
    Actuator {
        /// Why.
        error: ActuatorError,
    },
    /// The force that is left for the part has the wrong sign.
    #[error(
        "at a travel of {:.2} mm the {part} would have to {verb} with {:.0} N: the belt takes {belt:.0} N there, and \
         the spring gives {spring:+.0} N", travel * 1e3, force.abs()
    )]
    WrongSign {
        /// Which part.
        part: &'static str,
        /// What it would have to do.
        verb: &'static str,
        /// Travel of its sheave, m.
        travel: f64,
        /// The force, N.
        force: f64,
        /// Axial force of the belt, N.
        belt: f64,
        /// Force of the spring, N, positive where it presses.
        spring: f64,
    },
    /// No slope of the profile gives the force.
    #[error("at a travel of {:.2} mm no {profile} presses with {force:.0} N: {reason}", travel * 1e3)]
    Slope {
        /// Which profile.
        profile: &'static str,
        /// Travel of its sheave, m.
        travel: f64,
        /// The force, N.
        force: f64,
        /// Why.
        reason: &'static str,
    },
    /// A profile that crosses itself.
    #[error("the {profile} folds back at a travel of {:.2} mm: {reason}", travel * 1e3)]
    Folds {
        /// Which profile.
        profile: &'static str,
        /// Travel of its sheave, m.
        travel: f64,
        /// What that means, and what to try.
        reason: &'static str,
    },
    /// The integration was given up.
    #[error("the {profile} cannot be integrated: {reason}")]
    Integration {
        /// Which profile.
        profile: &'static str,
        /// What the integrator says.
        reason: String,
    },
    /// What must not happen.
    #[error(transparent)]
    Internal(#[from] InternalError),
}

impl InverseError {
    /// Whether what was asked is at fault, rather than that there is no such profile.
    pub fn is_bad_input(&self) -> bool {
        match self {
            Self::Case(_) | Self::Missing { .. } | Self::Parameter { .. } => true,
            Self::Equilibrium(error) => error.is_bad_input(),
            Self::Belt { failure, .. } => failure.is_bad_input(),
            Self::Deep { .. }
            | Self::Reserve { .. }
            | Self::Actuator { .. }
            | Self::WrongSign { .. }
            | Self::Slope { .. }
            | Self::Folds { .. }
            | Self::Integration { .. }
            | Self::Internal(_) => false,
        }
    }
}
