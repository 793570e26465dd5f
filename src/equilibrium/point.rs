//! What the equilibrium of a drive is.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::error::EquilibriumError;
use crate::actuator::{ActuatorForce, Shift, travel};
use crate::case::{Actuation, Resolved};
use crate::drive::{Compressed, Solved};
use crate::model::{Constant, InternalError, Output};

/// Share of the speed below which a belt counts as slipping: one that holds loses up to a tenth and more of it, by
/// creep and by sinking into small radii.
pub const ARRIVING: f64 = 0.8;

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

/// The force of each part and of the belt, N.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Forces {
    /// What presses on the primary; nothing where a motor holds its position.
    pub primary: Option<ActuatorForce>,
    /// What presses on the secondary.
    pub secondary: ActuatorForce,
    /// Axial force of the belt on the primary.
    pub primary_belt: f64,
    /// Axial force of the belt on the secondary.
    pub secondary_belt: f64,
    /// Force on the stop, from 0; nothing between the stops.
    pub stop: Option<f64>,
    /// The larger difference of actuator and belt where they have to balance, over the belt's force: how well the
    /// equilibrium holds.
    pub residual: f64,
}

/// The equilibrium of a drive.
#[derive(Debug, Clone)]
pub struct Equilibrium {
    /// The solution.
    pub solved: Solved,
    /// Where the sheaves stand.
    pub phase: Phase,
    /// Which way friction acts.
    pub direction: Direction,
    /// Travel of the primary, m.
    pub primary_travel: f64,
    /// Opening of the secondary, m.
    pub secondary_travel: f64,
    /// The forces.
    pub forces: Forces,
}

impl Equilibrium {
    /// Reads a solution.
    pub(super) fn of(
        actuation: &Actuation,
        solved: Solved,
        phase: Phase,
        direction: Direction,
    ) -> Result<Self, EquilibriumError> {
        let outputs = solved.belt.output_values(&solved.solution)?;
        let half_angle = solved.constant(Constant::HalfAngle);
        let primary_travel = travel(half_angle, actuation.start_radius, solved.constant(Constant::PrimaryRadius));
        let secondary_travel = travel(half_angle, solved.constant(Constant::SecondaryRadius), actuation.closed_radius);
        let speed = solved.constant(Constant::PrimarySpeed);
        let told = |error| EquilibriumError::Actuator { phase, error };
        let primary = actuation.primary.force(speed, primary_travel, direction.primary()).map_err(told)?;
        let torque = outputs.get(Output::SecondaryTorque)?;
        let secondary = actuation.secondary.force(torque, secondary_travel, direction.secondary()).map_err(told)?;
        let (primary_belt, secondary_belt) =
            (outputs.get(Output::PrimaryAxialForce)?, outputs.get(Output::SecondaryAxialForce)?);
        let on_primary = primary.map_or(0.0, |force| force.value - primary_belt);
        let on_secondary = secondary.value - secondary_belt;
        let (stop, missed) = match phase {
            Phase::Shift => (None, (on_primary / primary_belt).abs().max((on_secondary / secondary_belt).abs())),
            Phase::Low => (Some(on_secondary), (on_primary / primary_belt).abs()),
            Phase::High(Stop::PrimaryClosed) => (Some(on_primary), (on_secondary / secondary_belt).abs()),
            Phase::High(Stop::SecondaryOpen | Stop::SecondaryClosed) => {
                (Some(-on_secondary), (on_primary / primary_belt).abs())
            }
            Phase::Held => (None, (on_secondary / secondary_belt).abs()),
        };
        let forces = Forces { primary, secondary, primary_belt, secondary_belt, stop, residual: missed };
        Ok(Self { solved, phase, direction, primary_travel, secondary_travel, forces })
    }

    /// Speed of the primary, rad/s.
    pub fn primary_speed(&self) -> f64 {
        self.solved.constant(Constant::PrimarySpeed)
    }

    /// Whether the belt carries the speed over: at least [`ARRIVING`] of it, where it is not one that slips as a clutch
    /// does.
    pub(super) fn holds(&self) -> Result<bool, InternalError> {
        Ok(self.output(Output::EfficiencySpeed)? >= ARRIVING)
    }

    /// Whether the belt is pulled everywhere: its speed alone does not hold it.
    pub(super) fn is_taut(&self) -> bool {
        Compressed::of(&self.solved.belt, &self.solved.solution).is_none()
    }

    /// Whether it is a state that a search may end with: the belt holds, and is pulled everywhere.
    pub(super) fn is_sound(&self) -> Result<bool, InternalError> {
        Ok(self.is_taut() && self.holds()?)
    }

    /// An output of the belt.
    ///
    /// # Errors
    /// [`InternalError::Output`] if drives with this belt do not have it.
    pub fn output(&self, output: Output) -> Result<f64, InternalError> {
        self.solved.belt.output_values(&self.solved.solution)?.get(output)
    }

    /// The case that gives the same drive to `sheave solve`: radii, speed, torque and slack tension as they were found.
    pub fn operating_case(&self, case: &Resolved) -> Resolved {
        super::question::posed_at(case, &self.solved)
    }
}
