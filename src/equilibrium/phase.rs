//! Where the sheaves of a drive stand, and which way it shifts.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::actuator::Shift;

/// Which way a drive shifts, or is about to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum Direction {
    /// Up: the primary closes against friction, the secondary opens.
    Up,
    /// Back, towards low ratio: the primary opens, the secondary closes.
    Back,
    /// Friction in the actuators is left out.
    #[default]
    Frictionless,
}

impl Direction {
    /// What the primary's sheave does.
    pub const fn primary(self) -> Shift {
        match self {
            Self::Up => Shift::Closing,
            Self::Back => Shift::Opening,
            Self::Frictionless => Shift::Frictionless,
        }
    }

    /// What the secondary's sheave does.
    pub const fn secondary(self) -> Shift {
        self.primary().other()
    }

    /// Name in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Up => "up",
            Self::Back => "back",
            Self::Frictionless => "frictionless",
        }
    }
}

/// A direction of this name does not exist.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{0}` is no direction: expected up, back or frictionless")]
pub struct UnknownDirection(pub String);

impl std::str::FromStr for Direction {
    type Err = UnknownDirection;

    fn from_str(name: &str) -> Result<Self, UnknownDirection> {
        match name {
            "up" => Ok(Self::Up),
            "back" => Ok(Self::Back),
            "frictionless" => Ok(Self::Frictionless),
            other => Err(UnknownDirection(other.to_owned())),
        }
    }
}

/// A stop on which a sheave may rest.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Stop {
    /// The secondary is closed: low ratio.
    SecondaryClosed,
    /// The primary is closed: high ratio.
    PrimaryClosed,
    /// The secondary is open: high ratio.
    SecondaryOpen,
}

/// Where the sheaves stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Phase {
    /// At the low stop.
    Low,
    /// Between the stops: the drive shifts.
    Shift,
    /// At a high stop.
    High(
        /// Which.
        Stop,
    ),
    /// Where a motor holds the primary.
    Held,
}

impl Phase {
    /// What a report calls it.
    pub const fn reported(self) -> ReportedPhase {
        match self {
            Self::Low => ReportedPhase::Low,
            Self::Shift => ReportedPhase::Shift,
            Self::High(_) => ReportedPhase::High,
            Self::Held => ReportedPhase::Held,
        }
    }

    /// The stop on which a sheave rests.
    pub const fn stop(self) -> Option<Stop> {
        match self {
            Self::Low => Some(Stop::SecondaryClosed),
            Self::High(stop) => Some(stop),
            Self::Shift | Self::Held => None,
        }
    }
}

/// The phase of a launch in which a report finds a drive, whichever stop it stands at.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum ReportedPhase {
    /// At the low stop, up to the take-off of a shift curve: the belt slips as a clutch does. An equilibrium by itself,
    /// which knows no take-off, is [`ReportedPhase::Low`] there.
    Engagement,
    /// At the low stop.
    Low,
    /// Between the stops.
    Shift,
    /// At a high stop.
    High,
    /// Where a motor holds the primary.
    Held,
}

impl ReportedPhase {
    /// Name in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Engagement => "engagement",
            Self::Low => "low",
            Self::Shift => "shift",
            Self::High => "high",
            Self::Held => "held",
        }
    }
}

impl fmt::Display for ReportedPhase {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl fmt::Display for Phase {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Low => "at the low stop, the secondary closed",
            Self::Shift => "between the stops",
            Self::High(Stop::PrimaryClosed) => "at the high stop, the primary closed",
            Self::High(Stop::SecondaryOpen) => "at the high stop, the secondary open",
            Self::High(Stop::SecondaryClosed) => "at the stop of the secondary",
            Self::Held => "where the motor holds the primary",
        })
    }
}
