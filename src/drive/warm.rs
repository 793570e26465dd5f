//! From one solution to that of a case nearby.

use solver::Options;
use solver::continuation::PathOptions;

use super::approach::approach;
use super::failure::Failure;
use super::question::Question;
use super::solve::{ROUGH_TOLERANCE, SolveOptions, Solved};
use crate::case::{Model, Resolved};

// What a warm start may cost; beyond it, a cold start is the shorter way.
const MAX_STEPS: usize = 3;
const SMALLEST_STEP: f64 = 0.2;
const MAX_MESHES: usize = 12;
const MAX_INTERVALS: usize = 2000;

/// Solves a case by following the solution `from` while what differs, constants and prescribed values, goes to what the
/// case says: the slip threshold geometrically, all others linearly. Both must be of one model; the caller sees to that.
/// Gives up early, on anything but a case nearby.
///
/// # Errors
/// See [`Failure`]. A case out of reach of `from` may still be solved by [`solve`](super::solve).
pub fn solve_from(from: &Solved, case: &Resolved, options: &SolveOptions) -> Result<Solved, Failure> {
    solve_question_from(from, &case.model, &Question::of(case), options)
}

/// As [`solve_from`], for any question.
///
/// # Errors
/// See [`Failure`].
pub fn solve_question_from(
    from: &Solved,
    model: &Model,
    question: &Question,
    options: &SolveOptions,
) -> Result<Solved, Failure> {
    question.check(model)?;
    let solve = Options { max_meshes: MAX_MESHES, max_intervals: MAX_INTERVALS, ..options.solver() };
    let options = PathOptions {
        solve,
        tolerance: ROUGH_TOLERANCE,
        first_step: 1.0,
        smallest_step: SMALLEST_STEP,
        max_steps: MAX_STEPS,
        ..PathOptions::default()
    };
    let mut solved = approach(model, from, question, &options)?;
    // The work from here on, not that of the solution nearby.
    solved.stats = *solved.solution.stats();
    solved.continuation_steps -= from.continuation_steps;
    Ok(solved)
}
