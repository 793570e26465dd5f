//! Which way a drive shifts, which decides the sign of friction in its actuators.

use serde::{Deserialize, Serialize};

/// Which way the movable sheave of an actuator goes, or is about to go.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum Shift {
    /// It closes against friction, which takes of the force that presses it.
    Closing,
    /// It opens against friction, which adds to that force.
    Opening,
    /// Friction is left out.
    #[default]
    Frictionless,
}

impl Shift {
    /// Factor on friction angles: 1, −1 or 0.
    pub const fn sign(self) -> f64 {
        match self {
            Self::Closing => 1.0,
            Self::Opening => -1.0,
            Self::Frictionless => 0.0,
        }
    }

    /// What the other pulley's movable sheave does meanwhile.
    #[must_use]
    pub const fn other(self) -> Self {
        match self {
            Self::Closing => Self::Opening,
            Self::Opening => Self::Closing,
            Self::Frictionless => Self::Frictionless,
        }
    }
}
