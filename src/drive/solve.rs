//! From a resolved case to a solution, from nothing.

use solver::continuation::{PathError, PathOptions, Ramp, follow};
use solver::{Guess, Options, Order, Solution, SolveError, Stats};
use thiserror::Error;

use super::belt::Belt;
use super::constants::{Constant, Constants};
use super::start;
use crate::case::{Clamp, Load, Resolved, Speed};

/// Tolerance on the way from the start to the case.
pub(super) const ROUGH_TOLERANCE: f64 = 1e-2;
/// Intervals of a region on the way.
const WAY_INTERVALS: usize = 2000;
/// Smallest step on a leg of the way, as a share of the leg.
const SMALLEST_STEP: f64 = 1e-4;
/// Steps on a leg of the way, accepted or not.
const LEG_STEPS: usize = 200;

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
    /// A warm start without a solution to start from.
    #[error("there is no solution to start from")]
    NoStart,
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
    /// That of two failures which came closer to the case: with the case's own friction if possible, then with less
    /// tension, for it is loose belts that are lost.
    fn farther(first: Option<Self>, second: Self) -> Self {
        let key = |failure: &Self| match failure {
            Self::Lost { slip_threshold, slack_tension, .. } => (*slip_threshold, *slack_tension),
            _ => (f64::INFINITY, f64::INFINITY),
        };
        match first {
            Some(first) if key(&first) <= key(&second) => first,
            _ => second,
        }
    }

    pub(super) fn of(error: PathError) -> Self {
        match error.last {
            None => Self::Start(error.cause),
            Some(last) => Self::lost(&last, *error.cause),
        }
    }

    /// Beyond the solution `last`.
    pub(super) fn lost(last: &Solution, cause: SolveError) -> Self {
        let value = |constant: Constant| last.constants().get(constant.index()).copied().unwrap_or(f64::NAN);
        Self::Lost {
            torque: value(Constant::PrimaryTorque),
            slip_threshold: value(Constant::SlipThreshold),
            slack_tension: value(Constant::SlackTension),
            cause: Box::new(cause),
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

/// Solves a case from nothing: a straight belt under a small torque, at a tension that wraps it, with friction that is
/// linear in the sliding speed; then torque, slip threshold and tension go where the case wants them.
///
/// # Errors
/// See [`Failure`].
pub fn solve(case: &Resolved, options: &SolveOptions) -> Result<Solved, Failure> {
    let target = start::constants(&given(case)?);
    let belt = Belt::new(&case.model, &target).ok_or(Failure::NoEquations)?;
    let unknowns: Vec<usize> = (0..Constant::UNKNOWN).collect();
    let mut failure = None;
    for tension in start::tensions(&target) {
        let begin = start::easy(&target, tension);
        match climb(&belt, &begin, &target, &unknowns, options) {
            Ok((solution, stats, continuation_steps)) => {
                return Ok(Solved { belt, solution, stats, continuation_steps });
            }
            Err(next) => failure = Some(Failure::farther(failure, next)),
        }
    }
    Err(failure.unwrap_or(Failure::NoEquations))
}

/// The legs of the way from an easy drive to the case, in order: each moves some constants to where the case has them.
fn legs(begin: &Constants, target: &Constants) -> Vec<Ramp> {
    let ends = |constant: Constant| (constant.index(), begin[constant], target[constant]);
    let linear = |ramp: Ramp, (at, from, to): (usize, f64, f64)| ramp.linear(at, from, to);
    let geometric = |ramp: Ramp, (at, from, to): (usize, f64, f64)| ramp.geometric(at, from, to);
    let torque = linear(Ramp::new(), ends(Constant::PrimaryTorque));
    let threshold = geometric(Ramp::new(), ends(Constant::SlipThreshold));
    let tension = ends(Constant::SlackTension);
    if target[Constant::SlackTension] > begin[Constant::SlackTension] {
        vec![geometric(torque, tension), threshold]
    } else if target[Constant::SlackTension] < begin[Constant::SlackTension] {
        // A loose belt may transmit the torque only once friction is what the case says.
        vec![torque, threshold, geometric(Ramp::new(), tension)]
    } else {
        vec![torque, threshold]
    }
}

fn climb(
    belt: &Belt,
    begin: &Constants,
    target: &Constants,
    unknowns: &[usize],
    options: &SolveOptions,
) -> Result<(Solution, Stats, usize), Failure> {
    let last = Options { tolerance: options.tolerance, order: options.order, ..Options::default() };
    let way =
        Options { tolerance: options.tolerance.max(ROUGH_TOLERANCE), max_intervals: WAY_INTERVALS, ..last.clone() };
    let legs = legs(begin, target);
    let (count, mut stats, mut steps, mut found) = (legs.len(), Stats::default(), 0, None::<Solution>);
    for (index, path) in legs.into_iter().enumerate() {
        let solve = if index + 1 == count { last.clone() } else { way.clone() };
        let options = PathOptions {
            solve,
            tolerance: ROUGH_TOLERANCE,
            smallest_step: SMALLEST_STEP,
            max_steps: LEG_STEPS,
            ..PathOptions::default()
        };
        let guess = found.as_ref().map_or_else(|| start::guess(belt, begin), Guess::from);
        let followed = follow(belt, &guess, &path, unknowns, &options).map_err(Failure::of)?;
        stats += *followed.solution.stats();
        steps += followed.steps.iter().filter(|step| step.accepted).count();
        found = Some(followed.solution);
    }
    found.map(|solution| (solution, stats, steps)).ok_or(Failure::NoEquations)
}
