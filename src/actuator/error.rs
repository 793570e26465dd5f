//! What can be wrong with an actuator.

use super::profile::ProfileError;
use super::shift::Shift;
use thiserror::Error;

/// Why an actuator gives no force.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ActuatorError {
    /// A table makes no profile.
    #[error(transparent)]
    Profile(#[from] ProfileError),
    /// A number is out of its range.
    #[error("{what} is {given}: expected {expected}")]
    Parameter {
        /// What it is.
        what: &'static str,
        /// As given, SI.
        given: f64,
        /// What is expected.
        expected: &'static str,
    },
    /// A roller has no place on its ramp.
    #[error("at a travel of {:.3} mm the roller does not reach its ramp: check the ramp's points and the arm's \
        length", travel * 1e3)]
    OffRamp {
        /// Travel, m.
        travel: f64,
    },
    /// A mechanism that locks, or pulls where it should press.
    #[error(
        "at a travel of {:.3} mm the flyweights press with {force:.1} N: expected a force from 0; the ramp is steeper \
         than its friction allows, or slopes the wrong way", travel * 1e3
    )]
    NoForce {
        /// Travel, m.
        travel: f64,
        /// The force, N.
        force: f64,
    },
    /// A spring that is compressed beyond its solid length.
    #[error(
        "at a travel of {:.3} mm the spring would be {:.2} mm long, shorter than its solid length of {:.2} mm",
        travel * 1e3, length * 1e3, solid * 1e3
    )]
    SpringSolid {
        /// Travel, m.
        travel: f64,
        /// Length that the travel leaves, m.
        length: f64,
        /// Solid length, m.
        solid: f64,
    },
    /// A helix whose flank carries no torque.
    #[error(
        "at a travel of {:.3} mm the helix carries a torque of {torque:.2} N·m: its flank has no contact; wind the \
         spring up further, or give the angle of the other flank", travel * 1e3
    )]
    HelixContact {
        /// Travel, m.
        travel: f64,
        /// Torque, N·m.
        torque: f64,
    },
    /// A helix whose friction no torque overcomes.
    #[error(
        "at a travel of {:.3} mm the helix locks itself: it stands at {:.1}° and its flanks rub with a friction angle \
         of {:.1}°, so that no force makes the sheave {}; expected a friction angle below {:.1}°",
        travel * 1e3,
        angle.to_degrees(),
        friction_angle.to_degrees(),
        if *shift == Shift::Opening { "open" } else { "close" },
        if *shift == Shift::Opening { angle.to_degrees() } else { 90.0 - angle.to_degrees() }
    )]
    HelixLocks {
        /// Travel, m.
        travel: f64,
        /// Angle of the helix from the plane of rotation, rad.
        angle: f64,
        /// Friction angle of its flanks, rad.
        friction_angle: f64,
        /// Which way the sheave would go.
        shift: Shift,
    },
}

/// Refuses a parameter that does not hold what is expected of it.
pub(super) fn check(what: &'static str, given: f64, holds: bool, expected: &'static str) -> Result<(), ActuatorError> {
    if holds && given.is_finite() { Ok(()) } else { Err(ActuatorError::Parameter { what, given, expected }) }
}
