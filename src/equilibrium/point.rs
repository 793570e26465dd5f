//! What the equilibrium of a drive is.

use super::error::EquilibriumError;
use super::phase::{Direction, Phase, Stop};
use crate::actuator::{ActuatorForce, travel};
use crate::case::{Actuation, Clamp, Load, Resolved, Speed};
use crate::drive::{Compressed, Solved};
use crate::model::{Constant, InternalError, Output};

/// Share of the speed below which a belt counts as slipping: one that holds loses up to a tenth and more of it, by
/// creep and by sinking into small radii.
pub const ARRIVING: f64 = 0.8;

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
        posed_at(case, &self.solved)
    }
}

/// The case as an ordinary operating point at a solution.
pub(super) fn posed_at(case: &Resolved, solved: &Solved) -> Resolved {
    let mut posed = ordinary(case);
    posed.drive.primary_radius = solved.constant(Constant::PrimaryRadius);
    posed.drive.secondary_radius = solved.constant(Constant::SecondaryRadius);
    posed.operating_point.speed = Speed::Primary(solved.constant(Constant::PrimarySpeed));
    posed.operating_point.load = Load::PrimaryTorque(solved.constant(Constant::PrimaryTorque));
    posed.operating_point.clamp = Clamp::SlackTension(solved.constant(Constant::SlackTension));
    posed
}

/// The case with nothing free and nothing prescribed.
pub(super) fn ordinary(case: &Resolved) -> Resolved {
    let mut posed = case.clone();
    posed.drive.free = None;
    posed.operating_point.fourth = None;
    posed.operating_point.margin = None;
    posed.swaps.clear();
    posed.found.clear();
    posed
}
