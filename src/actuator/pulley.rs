//! What presses on a pulley: its actuator with its spring, as one law with its derivatives.

use super::error::ActuatorError;
use super::flyweight::Flyweights;
use super::helix::Helix;
use super::shift::Shift;
use super::spring::Spring;

/// What presses the sheaves of the primary together.
#[derive(Debug, Clone, PartialEq)]
pub enum PrimaryActuator {
    /// Flyweights against a spring.
    Flyweights {
        /// The flyweights.
        flyweights: Flyweights,
        /// The spring that opens the primary, if it has one.
        spring: Option<Spring>,
    },
    /// A force that a motor holds, N.
    Force(f64),
    /// A travel at which a motor holds the sheave, m; the force is what it takes.
    Position(f64),
}

/// What presses the sheaves of the secondary together.
#[derive(Debug, Clone, PartialEq)]
pub enum SecondaryActuator {
    /// A helix, and a spring that closes the secondary.
    Helix {
        /// The helix.
        helix: Helix,
        /// The spring in compression, if it has one.
        spring: Option<Spring>,
    },
    /// A force that a motor holds, N.
    Force(f64),
}

/// A force of an actuator with its derivatives: with respect to the travel of its movable sheave, and to what drives
/// it, which is the speed of the primary or the torque of the secondary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ActuatorForce {
    /// The force, N, positive where it presses the sheaves together.
    pub value: f64,
    /// Its derivative with respect to the speed in rad/s (primary) or the torque in N·m (secondary).
    pub by_drive: f64,
    /// Its derivative with respect to the travel, N/m.
    pub by_travel: f64,
    /// Part of the force that flyweights or the helix give, N.
    pub mechanism: f64,
    /// Part of the force that the spring gives, N: negative where it opens the sheave.
    pub spring: f64,
}

impl ActuatorForce {
    const fn held(force: f64) -> Self {
        Self { value: force, by_drive: 0.0, by_travel: 0.0, mechanism: force, spring: 0.0 }
    }
}

impl PrimaryActuator {
    /// F_P = F_fly(ω_P, s) − F_spring(s) at a speed in rad/s and a travel in m, positive where the sheave closes;
    /// `None` for an actuator that holds a position, whose force is what that takes.
    ///
    /// # Errors
    /// See [`ActuatorError`].
    pub fn force(&self, speed: f64, travel: f64, shift: Shift) -> Result<Option<ActuatorForce>, ActuatorError> {
        match self {
            Self::Force(force) => Ok(Some(ActuatorForce::held(*force))),
            Self::Position(_) => Ok(None),
            Self::Flyweights { flyweights, spring } => {
                let pressed = flyweights.force(speed, travel, shift)?;
                let against = spring.map(|spring| spring.force(travel)).transpose()?;
                let (back, stiffness) = against.map_or((0.0, 0.0), |force| (force.value, force.by_travel));
                Ok(Some(ActuatorForce {
                    value: pressed.value - back,
                    by_drive: pressed.by_speed,
                    by_travel: pressed.by_travel - stiffness,
                    mechanism: pressed.value,
                    spring: -back,
                }))
            }
        }
    }
}

impl SecondaryActuator {
    /// F_S = F_spring(s) + F_helix(M, s) at the belt's torque on the secondary in N·m and an opening in m, positive
    /// where the sheave opens.
    ///
    /// # Errors
    /// See [`ActuatorError`].
    pub fn force(&self, torque: f64, opening: f64, shift: Shift) -> Result<ActuatorForce, ActuatorError> {
        match self {
            Self::Force(force) => Ok(ActuatorForce::held(*force)),
            Self::Helix { helix, spring } => {
                let turned = helix.force(torque, opening, shift)?;
                let pushed = spring.map(|spring| spring.force(opening)).transpose()?;
                let (push, stiffness) = pushed.map_or((0.0, 0.0), |force| (force.value, force.by_travel));
                Ok(ActuatorForce {
                    value: turned.value + push,
                    by_drive: turned.by_torque,
                    by_travel: turned.by_opening + stiffness,
                    mechanism: turned.value,
                    spring: push,
                })
            }
        }
    }
}
