//! From a resolved case to a solution, from nothing.

use solver::continuation::{PathError, PathOptions, Ramp, follow};
use solver::{Guess, Options, Order, Problem, Solution, SolveError, Stats};
use thiserror::Error;

use super::belt::Belt;
use super::constants::{Constant, Constants};
use super::region::RegionId;
use super::start::{self, START_INTERVALS, START_SLIP_THRESHOLD, START_TORQUE};
use crate::case::{Clamp, Load, Resolved, Speed};

/// Tolerance on the way from the start to the case.
const ROUGH_TOLERANCE: f64 = 1e-2;

/// How accurately, and with what.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SolveOptions {
    /// Largest relative defect of the solution.
    pub tolerance: f64,
    /// Order of the collocation.
    pub order: Order,
    /// Whether derivatives of the outputs with respect to the given constants are wanted.
    pub sensitivities: bool,
}

impl Default for SolveOptions {
    fn default() -> Self {
        Self { tolerance: 1e-6, order: Order::Four, sensitivities: false }
    }
}

/// A solved drive.
#[derive(Debug, Clone)]
pub struct Solved {
    /// The problem.
    pub belt: Belt,
    /// Its solution.
    pub solution: Solution,
    /// Work over all continuation steps.
    pub stats: Stats,
    /// Continuation steps in all.
    pub continuation_steps: usize,
}

/// Why there is no solution.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum Failure {
    /// The equations of this model are not known.
    #[error("there are no equations for this choice of model")]
    NoEquations,
    /// A choice of operating point that is not solved for.
    #[error("{0} cannot be prescribed")]
    OperatingPoint(&'static str),
    /// Newton's method failed on the straight belt under a small torque.
    #[error("no solution was found for the start, a straight belt under a small torque: {0}")]
    Start(Box<SolveError>),
    /// The equations are singular at the solution.
    #[error("the solution has no derivatives: {0}")]
    Sensitivities(SolveError),
    /// The way from the start to the case was lost.
    #[error(
        "the solution was lost at primary torque {torque:.4} N·m, slip threshold {slip_threshold:.3e} m/s, slack tension \
         {slack_tension:.4} N: {cause}"
    )]
    Lost {
        /// Primary torque reached, N·m.
        torque: f64,
        /// Slip threshold reached, m/s.
        slip_threshold: f64,
        /// Slack tension reached, N.
        slack_tension: f64,
        /// What the solver says of the next step.
        cause: Box<SolveError>,
    },
}

impl Failure {
    fn of(error: PathError) -> Self {
        match error.last {
            None => Self::Start(error.cause),
            Some(last) => {
                let value = |constant: Constant| last.constants().get(constant.index()).copied().unwrap_or(f64::NAN);
                Self::Lost {
                    torque: value(Constant::PrimaryTorque),
                    slip_threshold: value(Constant::SlipThreshold),
                    slack_tension: value(Constant::SlackTension),
                    cause: error.cause,
                }
            }
        }
    }
}

/// The given constants of a case; the unknown ones are zero.
///
/// # Errors
/// [`Failure::OperatingPoint`].
pub fn given(case: &Resolved) -> Result<Constants, Failure> {
    let point = &case.operating_point;
    let Speed::Primary(speed) = point.speed else { return Err(Failure::OperatingPoint("the secondary's speed")) };
    let Load::PrimaryTorque(torque) = point.load else { return Err(Failure::OperatingPoint("this load")) };
    let Clamp::SlackTension(tension) = point.clamp else { return Err(Failure::OperatingPoint("this clamp")) };
    let mut constants = Constants([0.0; Constant::ALL.len()]);
    for (constant, value) in [
        (Constant::LongitudinalStiffness, case.belt.longitudinal_stiffness),
        (Constant::BendingStiffness, case.belt.bending_stiffness),
        (Constant::RadialStiffness, case.belt.radial_stiffness),
        (Constant::MassPerLength, case.belt.mass_per_length),
        (Constant::PrimaryRadius, case.drive.primary_radius),
        (Constant::SecondaryRadius, case.drive.secondary_radius),
        (Constant::CenterDistance, case.drive.center_distance),
        (Constant::HalfAngle, case.sheave.half_angle),
        (Constant::FrictionCoefficient, case.sheave.friction_coefficient),
        (Constant::SlipThreshold, case.sheave.slip_threshold),
        (Constant::PrimarySpeed, speed),
        (Constant::PrimaryTorque, torque),
        (Constant::SlackTension, tension),
    ] {
        constants[constant] = value;
    }
    Ok(constants)
}

/// Solves a case from nothing: a straight belt under a small torque with friction that is linear in the sliding
/// speed; then the torque is raised, then the slip threshold brought down.
///
/// # Errors
/// See [`Failure`].
pub fn solve(case: &Resolved, options: &SolveOptions) -> Result<Solved, Failure> {
    let target = start::constants(&given(case)?);
    let belt = Belt::new(&case.model, &target).ok_or(Failure::NoEquations)?;
    let unknowns: Vec<usize> = (0..Constant::UNKNOWN).collect();
    let last = Options { tolerance: options.tolerance, order: options.order, ..Options::default() };
    let rough = Options { tolerance: options.tolerance.max(ROUGH_TOLERANCE), ..last.clone() };

    let mut begin = target.clone();
    begin[Constant::PrimaryTorque] = target[Constant::PrimaryTorque].min(START_TORQUE);
    begin[Constant::SlipThreshold] = target[Constant::SlipThreshold].max(START_SLIP_THRESHOLD);
    let guess = Guess::uniform(belt.layout(), START_INTERVALS, &begin.0, |region, s, y| {
        if let Some(region) = RegionId::ALL.get(region) {
            y.copy_from_slice(&start::states(*region, s, &begin));
        }
    });
    let leg = |constant: Constant| (constant.index(), begin[constant], target[constant]);
    let (torque, from_torque, to_torque) = leg(Constant::PrimaryTorque);
    let (threshold, from_threshold, to_threshold) = leg(Constant::SlipThreshold);
    let legs = [
        (Ramp::new().linear(torque, from_torque, to_torque), rough.clone()),
        (Ramp::new().geometric(threshold, from_threshold, to_threshold), last),
    ];

    let (mut guess, mut stats, mut steps, mut solution) = (guess, Stats::default(), 0, None);
    for (path, solve) in legs {
        let options = PathOptions { solve, tolerance: ROUGH_TOLERANCE, ..PathOptions::default() };
        let followed = follow(&belt, &guess, &path, &unknowns, &options).map_err(Failure::of)?;
        stats += *followed.solution.stats();
        steps += followed.steps.iter().filter(|step| step.accepted).count();
        guess = Guess::from(&followed.solution);
        solution = Some(followed.solution);
    }
    let solution = solution.ok_or(Failure::NoEquations)?;
    Ok(Solved { belt, solution, stats, continuation_steps: steps })
}
