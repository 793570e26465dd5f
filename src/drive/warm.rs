//! From solutions of cases nearby to that of a case.

use solver::continuation::PathOptions;
use solver::{Guess, Options, Solution, SolveError, Stats};

use super::approach::{approach, posed};
use super::belt::BeltProblem;
use super::budget::Budget;
use super::correct::{corrected, relaxed};
use super::failure::Failure;
use super::options::{ROUGH_TOLERANCE, SolveOptions};
use super::position::Position;
use super::predict::{PathPiece, TRAIL, Waypoint, predicted};
use super::question::Question;
use super::solved::Solved;
use crate::cancel::is_cancelled;
use crate::case::{ModelChoices, Resolved};
use crate::model::Constant;

// What a warm start may cost; beyond it, a cold start is the cheaper one.
const SMALLEST_STEP: f64 = 0.25;
const MAX_ITERATIONS: usize = 15;
const MAX_STEPS: usize = 3;
const MAX_MESHES: usize = 12;
const MAX_INTERVALS: usize = 2000;

/// Miss of a prediction over the tolerance from which on a coarse solution is sought first: of one from a solution
/// alone, measured by the square of the step, and of one that knows how the path bends, by its cube. Steps of 1 to 25 %
/// in slack tension, torque, ratio or friction of the base case, to tolerances of 1e-4 to 1e-8: with these, each takes
/// the less work of both ways or nearly so (`docs/performance.md`).
const FAR_ALONE: f64 = 1.2e4;
const FAR: f64 = 300.0;
/// Tolerance above which there is nothing to gain by it.
const FINE: f64 = 3e-6;

/// A step in a radius or the centre distance takes as much work as one of this many times its logarithm in slack
/// tension or torque: the belt has to be laid anew, and not only to be pulled tighter.
const GEOMETRY: i32 = 5;

/// Solves a case from a solution nearby: see [`solve_along`].
///
/// # Errors
/// As [`solve_along`].
pub fn solve_from(from: &Solved, case: &Resolved, options: &SolveOptions) -> Result<Solved, Failure> {
    solve_along(&[from], case, options)
}

/// Solves a case by following the last of the solutions `trail` while what differs, constants and prescribed values,
/// goes to what the case says: the slip threshold geometrically, all others linearly. The solutions before the last, if
/// there are any, tell how the path bends; more than [`TRAIL`] in all are of no use. All must be of one model; the
/// caller sees to that. Gives up early, on anything but a case nearby.
///
/// # Errors
/// See [`Failure`]. A case out of reach of the trail may still be solved by [`solve`](super::solve).
pub fn solve_along(trail: &[&Solved], case: &Resolved, options: &SolveOptions) -> Result<Solved, Failure> {
    let [rest @ .., last] = trail else { return Err(Failure::NoStart) };
    along(rest, last, &case.model, Question::of(case), options)
}

/// As [`solve_from`], for any question: what outputs and laws are asked to be moves with everything else that is given,
/// from what they are at the solution nearby.
///
/// # Errors
/// See [`Failure`].
pub fn solve_question_from(
    from: &Solved,
    model: &ModelChoices,
    question: &Question,
    options: &SolveOptions,
) -> Result<Solved, Failure> {
    question.check(model)?;
    along(&[], from, model, question.clone(), options)
}

/// As [`solve_question_from`], in at most three steps along a straight path, each predicted by no more than the
/// tangent. Curves of solutions that turn are followed with it: it leaves them less easily for a branch beside them.
///
/// # Errors
/// See [`Failure`].
pub fn step_to_question(
    from: &Solved,
    model: &ModelChoices,
    question: &Question,
    options: &SolveOptions,
) -> Result<Solved, Failure> {
    question.check(model)?;
    let path = PathOptions {
        solve: within(options),
        tolerance: ROUGH_TOLERANCE,
        first_step: 1.0,
        smallest_step: SMALLEST_STEP,
        max_steps: MAX_STEPS,
        ..PathOptions::default()
    };
    let mut budget = Budget::new(options.work_limit);
    let mut solved = approach(model, from, question, &path, &mut budget)?;
    // The work from here on, not that of the solution nearby.
    solved.stats = *solved.solution.stats();
    solved.continuation_steps -= from.continuation_steps;
    Ok(solved)
}

/// What the solver may spend.
fn within(options: &SolveOptions) -> Options {
    Options { max_meshes: MAX_MESHES, max_intervals: MAX_INTERVALS, ..options.solver() }
}

/// From the last of some solutions to another, in one predicted step if that succeeds, else in a few.
fn along(
    before: &[&Solved],
    from: &Solved,
    model: &ModelChoices,
    question: Question,
    options: &SolveOptions,
) -> Result<Solved, Failure> {
    let belt = posed(model, &question)?;
    let mut here = Waypoint::of(from, &question)?;
    let (origin, target) = (here.position.clone(), Position::asked(&question));
    let nearest = before.iter().rev().take(TRAIL - 1);
    let mut before = nearest.map(|before| Waypoint::of(before, &question)).collect::<Result<Vec<_>, _>>()?;
    let unknowns: Vec<usize> = question.unknowns().into_iter().map(Constant::index).collect();
    let (mut stats, mut steps, mut progress, mut step) = (Stats::default(), 0, 0.0, 1.0);
    let mut budget = Budget::new(options.work_limit);
    let lost = |here: &Solution, cause: Box<SolveError>| match question.is_ordinary() {
        _ if is_cancelled() => Failure::Cancelled,
        true => Failure::of(&belt, &question.constants, Some(here), cause),
        false => Failure::approaching(&belt, &question, (here, here.constants()), cause),
    };
    while progress < 1.0 {
        let next = f64::min(progress + step, 1.0);
        let tolerance = if next < 1.0 { options.tolerance.max(ROUGH_TOLERANCE) } else { options.tolerance };
        let (to, bends) = (&origin.toward(&target, next), model.bending.is_some());
        let path = PathPiece { before: &before, from: &here, to, unknowns: &unknowns, bends };
        let shortest = step < 2.0 * SMALLEST_STEP;
        match advance(&belt, &path, tolerance, shortest, options, &mut budget) {
            Ok((solution, work)) => {
                stats += work;
                steps += 1;
                before.insert(0, std::mem::replace(&mut here, Waypoint::within(solution)?));
                progress = next;
            }
            Err(cause) if shortest || budget.is_spent() || is_cancelled() => {
                return Err(lost(&here.solution, Box::new(cause)));
            }
            Err(_) => step /= 2.0,
        }
    }
    let always = !question.is_ordinary();
    let corrected = corrected(&belt, here.solution.into_owned(), &options.solver(), always, &mut stats, &mut budget);
    let solution = corrected.map_err(|(last, cause)| lost(&last, Box::new(cause)))?;
    Ok(Solved { question, belt, stats, continuation_steps: steps, solution, route: None })
}

/// How far a case is from a solution, by what it takes to get there: the largest factor between the given constants of
/// both, and between what outputs are and are asked to be, those of the geometry to a power; infinite where they differ
/// in sign.
pub fn remoteness(from: &Solved, case: &Resolved) -> f64 {
    let question = Question::of(case);
    let unknowns: Vec<usize> = question.unknowns().into_iter().map(Constant::index).collect();
    let there = Position::asked(&question);
    Position::of(from, &question).map_or(f64::INFINITY, |here| factor(&here, &there, &unknowns, GEOMETRY))
}

/// How far a case is from another one: see [`remoteness`].
pub fn apart(from: &Resolved, to: &Resolved) -> f64 {
    let (here, there) = (Question::of(from), Question::of(to));
    let unknowns: Vec<usize> = there.unknowns().into_iter().map(Constant::index).collect();
    factor(&Position::asked(&here), &Position::asked(&there), &unknowns, GEOMETRY)
}

/// How tight a belt is: slack tension by torque, 1/m; infinite without torque. The way from a tighter belt to a looser
/// one takes a third to a half less work than the way back, and is hardly ever lost.
pub fn tightness(case: &Resolved) -> f64 {
    let constants = Question::of(case).constants;
    constants[Constant::SlackTension] / constants[Constant::PrimaryTorque].abs()
}

/// The largest factor between the given constants, and between the prescribed outputs, of two positions, those of the
/// geometry to a power; infinite where they differ in sign.
fn factor(here: &Position, there: &Position, unknowns: &[usize], geometry: i32) -> f64 {
    let given = Constant::ALL.into_iter().filter(|constant| !unknowns.contains(&constant.index()));
    let factor = |(here, there): (f64, f64)| match there / here {
        _ if there == here => 1.0,
        factor if factor > 0.0 => factor.max(1.0 / factor),
        _ => f64::INFINITY,
    };
    let constants = given.map(|constant| {
        let factor = factor((here.drive[constant], there.drive[constant]));
        match constant {
            Constant::PrimaryRadius | Constant::SecondaryRadius | Constant::CenterDistance => factor.powi(geometry),
            _ => factor,
        }
    });
    let targets = here.targets.iter().copied().zip(there.targets.iter().copied()).map(factor);
    constants.chain(targets).fold(1.0, f64::max)
}

/// One step, to other given values, to a tolerance; the shortest possible is tried in every way.
fn advance(
    belt: &BeltProblem,
    path: &PathPiece<'_>,
    tolerance: f64,
    shortest: bool,
    options: &SolveOptions,
    budget: &mut Budget,
) -> Result<(Solution, Stats), SolveError> {
    let options = Options { tolerance, max_iterations: MAX_ITERATIONS, rescues: 0, ..within(options) };
    let unknowns = path.unknowns;
    let solve = |guess: &Guess, options: &Options, budget: &mut Budget| {
        solver::solve_observed(belt, guess, unknowns, &relaxed(options), budget)
    };
    let mut work = Stats::default();
    if is_far(path, tolerance) {
        let rough = Options { tolerance: ROUGH_TOLERANCE, ..options.clone() };
        match solve(&predicted(belt, path, ROUGH_TOLERANCE)?, &rough, budget) {
            Ok(near) => {
                work += *near.stats();
                if let Ok(solution) = solve(&Guess::from(&near), &options, budget) {
                    work += *solution.stats();
                    return Ok((solution, work));
                }
            }
            // A shorter step is the better way on.
            Err(cause) if !shortest => return Err(cause),
            Err(_) => {}
        }
    }
    let solution = solve(&predicted(belt, path, tolerance)?, &options, budget)?;
    work += *solution.stats();
    Ok((solution, work))
}

/// Whether a coarse solution first is less work than the fine one at once. What is predicted misses by the square of
/// the step, or by its cube where the solution before tells how the path bends.
fn is_far(path: &PathPiece<'_>, tolerance: f64) -> bool {
    let step = libm::log(factor(&path.from.position, path.to, path.unknowns, 1));
    let miss = if path.before.is_empty() { step * step / FAR_ALONE } else { step * step * step / FAR };
    tolerance <= FINE && miss > tolerance
}
