//! From solutions of cases nearby to that of a case.

use solver::continuation::PathOptions;
use solver::{Options, Solution, SolveError, Stats};

use super::approach::approach;
use super::belt::BeltProblem;
use super::budget::Budget;
use super::correct::{corrected, relaxed};
use super::failure::Failure;
use super::predict::predicted;
use super::question::Question;
use super::solve::{ROUGH_TOLERANCE, SolveOptions};
use super::solved::Solved;
use crate::cancel::is_cancelled;
use crate::case::{ModelChoices, Resolved};
use crate::model::{Constant, Constants};

// What a warm start may cost; beyond it, a cold start is the cheaper one.
const SMALLEST_STEP: f64 = 0.25;
const MAX_ITERATIONS: usize = 15;
const MAX_STEPS: usize = 3;
const MAX_MESHES: usize = 12;
const MAX_INTERVALS: usize = 2000;

/// Solves a case from a solution nearby: see [`solve_along`].
///
/// # Errors
/// As [`solve_along`].
pub fn solve_from(from: &Solved, case: &Resolved, options: &SolveOptions) -> Result<Solved, Failure> {
    solve_along(&[from], case, options)
}

/// Solves a case by following the last of the solutions `trail` while what differs, constants and prescribed values,
/// goes to what the case says: the slip threshold geometrically, all others linearly. The solution before the last, if
/// there is one, tells how the path bends. All must be of one model; the caller sees to that. Gives up early, on
/// anything but a case nearby.
///
/// # Errors
/// See [`Failure`]. A case out of reach of the trail may still be solved by [`solve`](super::solve).
pub fn solve_along(trail: &[&Solved], case: &Resolved, options: &SolveOptions) -> Result<Solved, Failure> {
    let question = Question::of(case);
    let [rest @ .., last] = trail else { return Err(Failure::NoStart) };
    if question.is_ordinary() && last.question.is_ordinary() {
        let before = rest.last().filter(|before| before.question.is_ordinary());
        along(before.map(|before| &before.solution), &last.solution, &case.model, question, options)
    } else {
        solve_question_from(last, &case.model, &question, options)
    }
}

/// As [`solve_from`], for any question.
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
    let work = options;
    let options = PathOptions {
        solve: within(options),
        tolerance: ROUGH_TOLERANCE,
        first_step: 1.0,
        smallest_step: SMALLEST_STEP,
        max_steps: MAX_STEPS,
        ..PathOptions::default()
    };
    let mut budget = Budget::new(work.work_limit);
    let mut solved = approach(model, from, question, &options, &mut budget)?;
    // The work from here on, not that of the solution nearby.
    solved.stats = *solved.solution.stats();
    solved.continuation_steps -= from.continuation_steps;
    Ok(solved)
}

/// What the solver may spend.
fn within(options: &SolveOptions) -> Options {
    Options { max_meshes: MAX_MESHES, max_intervals: MAX_INTERVALS, ..options.solver() }
}

/// From one solution to another of the same unknowns, in one predicted step if that succeeds, else in a few.
fn along(
    before: Option<&Solution>,
    from: &Solution,
    model: &ModelChoices,
    question: Question,
    options: &SolveOptions,
) -> Result<Solved, Failure> {
    let belt = BeltProblem::new(model, &question.constants).ok_or(Failure::NoEquations)?;
    let origin = Constants::of(from);
    let (mut stats, mut steps, mut progress, mut step) = (Stats::default(), 0, 0.0, 1.0);
    let (mut before, mut here) = (before.cloned(), from.clone());
    let mut budget = Budget::new(options.work_limit);
    let lost = |here: &Solution, cause| {
        let failure = || Failure::of(&belt, &question.constants, Some(here), Box::new(cause));
        if is_cancelled() { Failure::Cancelled } else { failure() }
    };
    while progress < 1.0 {
        let next = f64::min(progress + step, 1.0);
        let tolerance = if next < 1.0 { options.tolerance.max(ROUGH_TOLERANCE) } else { options.tolerance };
        let to = origin.toward(&question.constants, next);
        match advance(&belt, before.as_ref(), &here, &to, tolerance, options, &mut budget) {
            Ok(solution) => {
                stats += *solution.stats();
                steps += 1;
                (before, progress) = (Some(std::mem::replace(&mut here, solution)), next);
            }
            Err(cause) if step < 2.0 * SMALLEST_STEP || budget.is_spent() || is_cancelled() => {
                return Err(lost(&here, cause));
            }
            Err(_) => step /= 2.0,
        }
    }
    let corrected = corrected(&belt, here, &options.solver(), false, &mut stats, &mut budget);
    let solution = corrected.map_err(|(last, cause)| lost(&last, cause))?;
    Ok(Solved { question, belt, stats, continuation_steps: steps, solution, route: None })
}

/// How far a case is from a solution: the largest factor between the given constants of both; infinite where they
/// differ in sign, or something else is prescribed in place of one.
pub fn remoteness(from: &Solved, case: &Resolved) -> f64 {
    let question = Question::of(case);
    if !question.is_ordinary() || !from.question.is_ordinary() {
        return f64::INFINITY;
    }
    let (here, target) = (Constants::of(&from.solution), question.constants);
    let given = Constant::ALL.into_iter().filter(|constant| !from.solution.unknowns().contains(&constant.index()));
    let factor = |constant: Constant| match target[constant] / here[constant] {
        _ if target[constant] == here[constant] => 1.0,
        factor if factor > 0.0 => factor.max(1.0 / factor),
        _ => f64::INFINITY,
    };
    given.map(factor).fold(1.0, f64::max)
}

/// One step, from a solution to other given constants.
fn advance(
    belt: &BeltProblem,
    before: Option<&Solution>,
    from: &Solution,
    to: &Constants,
    tolerance: f64,
    options: &SolveOptions,
    budget: &mut Budget,
) -> Result<Solution, SolveError> {
    let options = Options { tolerance, max_iterations: MAX_ITERATIONS, rescues: 0, ..within(options) };
    let guess = predicted(belt, before, from, to, tolerance)?;
    solver::solve_observed(belt, &guess, from.unknowns(), &relaxed(&options), budget)
}

impl Constants {
    /// Those of a solution.
    pub(super) fn of(solution: &Solution) -> Self {
        let value = |constant: Constant| solution.constants().get(constant.index()).copied().unwrap_or(f64::NAN);
        Self(Constant::ALL.map(value))
    }

    /// A share of the path to other constants.
    pub(super) fn toward(&self, to: &Self, share: f64) -> Self {
        let mut constants = self.clone();
        for constant in Constant::ALL {
            let (here, there) = (self[constant], to[constant]);
            constants[constant] = match constant {
                _ if share == 1.0 => there,
                Constant::SlipThreshold if here > 0.0 && there > 0.0 => here * (there / here).powf(share),
                _ => here + share * (there - here),
            };
        }
        constants
    }
}
