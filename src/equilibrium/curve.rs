//! The shift curve: equilibria over the speed of the secondary, up and back, in the phases of a launch.

use serde::Serialize;

use super::error::EquilibriumError;
use super::phase::{Direction, Phase, ReportedPhase};
use super::point::Equilibrium;
use super::report::DriveReport;
use crate::actuator::PrimaryActuator;
use crate::case::Resolved;
use crate::drive::{Constant, SolveOptions};
use crate::model::Output;

/// How a shift curve is computed.
#[derive(Debug, Clone)]
pub struct ShiftOptions {
    /// Points of each direction, shared among low ratio, shifting and high ratio.
    pub points: usize,
    /// The directions.
    pub directions: Vec<Direction>,
    /// Speed of the secondary in rad/s at which the curve begins; where the belt takes off, if not given.
    pub from: Option<f64>,
    /// Speed of the secondary in rad/s at which it ends; where the engine's torque is known no farther, if not given.
    pub to: Option<f64>,
    /// How each point is solved.
    pub solve: SolveOptions,
}

impl Default for ShiftOptions {
    fn default() -> Self {
        Self {
            points: 24,
            directions: vec![Direction::Up, Direction::Back],
            from: None,
            to: None,
            solve: SolveOptions::default(),
        }
    }
}

/// Speeds of a point of a shift curve that means something by itself, rad/s.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Landmark {
    /// Speed of the primary.
    pub primary_speed: f64,
    /// Speed of the secondary.
    pub secondary_speed: f64,
    /// R_S/R_P.
    pub ratio: f64,
}

impl Landmark {
    pub(super) fn of(found: &Equilibrium) -> Result<Self, EquilibriumError> {
        let solved = &found.solved;
        Ok(Self {
            primary_speed: found.primary_speed(),
            secondary_speed: found.output(Output::SecondarySpeed)?,
            ratio: solved.constant(Constant::SecondaryRadius) / solved.constant(Constant::PrimaryRadius),
        })
    }
}

/// One point of a shift curve.
#[derive(Debug, Clone)]
pub struct ShiftPoint {
    /// Which way the drive shifts.
    pub direction: Direction,
    /// Speed of the secondary, rad/s.
    pub secondary_speed: f64,
    /// The equilibrium, or why there is none.
    pub report: Result<Box<DriveReport>, String>,
}

/// The shift curve in one direction.
#[derive(Debug, Clone)]
pub struct ShiftBranch {
    /// Which way the drive shifts.
    pub direction: Direction,
    /// Speed of the primary in rad/s from which flyweights overcome their spring.
    pub engagement: Option<f64>,
    /// Where the belt carries the engine's torque with a twentieth of the speed lost beyond what is lost where the
    /// drive shifts out: the clutch slips until then.
    pub take_off: Option<Landmark>,
    /// Where the drive leaves the low stop.
    pub shift_out: Option<Landmark>,
    /// Where it arrives at the high stop.
    pub full_shift: Option<Landmark>,
    /// The points, by increasing speed of the secondary.
    pub points: Vec<ShiftPoint>,
    /// Why something is missing.
    pub remarks: Vec<String>,
}

impl ShiftBranch {
    /// A report of one of its points, which knows where the belt takes off: like the other phases, that of engagement
    /// has its end for its last point.
    pub(super) fn in_phases(&self, report: DriveReport) -> DriveReport {
        let engaging = self.take_off.is_some_and(|at| report.secondary_speed <= at.secondary_speed * (1.0 + SAME));
        let phase =
            if engaging && report.phase == ReportedPhase::Low { ReportedPhase::Engagement } else { report.phase };
        DriveReport { phase, ..report }
    }
}

/// Share of a speed by which two that are one differ, each solved to a tolerance of its own.
const SAME: f64 = 1e-6;

/// The speed in rad/s from which the flyweights of a case overcome their spring at no travel; nothing for a servo, and
/// for flyweights without a spring.
///
/// # Errors
/// [`EquilibriumError::Actuator`] if they do not press.
pub fn engagement_speed(case: &Resolved, direction: Direction) -> Result<Option<f64>, EquilibriumError> {
    let Some(actuation) = &case.parts.actuation else { return Ok(None) };
    let PrimaryActuator::Flyweights { flyweights, spring: Some(spring) } = &actuation.primary else { return Ok(None) };
    let told = |error| EquilibriumError::Actuator { phase: Phase::Low, error };
    // Flyweights press with the square of the speed.
    let at_one = flyweights.force(1.0, 0.0, direction.primary()).map_err(told)?.value;
    let against = spring.force(0.0).map_err(told)?.value;
    Ok((at_one > 0.0).then(|| (against / at_one).sqrt()))
}
