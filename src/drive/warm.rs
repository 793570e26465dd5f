//! From one solution to that of a case nearby.

use solver::continuation::{PathOptions, Ramp, follow};
use solver::{Guess, Options};

use super::belt::Belt;
use super::constants::Constant;
use super::solve::{Failure, ROUGH_TOLERANCE, SolveOptions, Solved, given};
use crate::case::Resolved;

// What a warm start may cost; beyond it, a cold start is the shorter way.
const MAX_STEPS: usize = 3;
const SMALLEST_STEP: f64 = 0.2;
const MAX_MESHES: usize = 12;
const MAX_INTERVALS: usize = 2000;

/// Solves a case by following the solution `from` while the constants that differ go to those of the case: the slip
/// threshold geometrically, all others linearly. Both must be of one model; the caller sees to that. Gives up early, on
/// anything but a case nearby.
///
/// # Errors
/// See [`Failure`]. A case out of reach of `from` may still be solved by [`solve`](super::solve).
pub fn solve_from(from: &Solved, case: &Resolved, options: &SolveOptions) -> Result<Solved, Failure> {
    let target = given(case)?;
    let belt = Belt::new(&case.model, &target).ok_or(Failure::NoEquations)?;
    let start = Guess::from(&from.solution);
    let mut path = Ramp::new();
    for constant in Constant::ALL.into_iter().skip(Constant::UNKNOWN) {
        let index = constant.index();
        let Some(&here) = start.constants.get(index) else { continue };
        let there = target[constant];
        path = match constant {
            _ if here == there => path,
            Constant::SlipThreshold => path.geometric(index, here, there),
            _ => path.linear(index, here, there),
        };
    }
    let solve = Options {
        tolerance: options.tolerance,
        order: options.order,
        max_meshes: MAX_MESHES,
        max_intervals: MAX_INTERVALS,
        ..Options::default()
    };
    let options = PathOptions {
        solve,
        tolerance: ROUGH_TOLERANCE,
        first_step: 1.0,
        smallest_step: SMALLEST_STEP,
        max_steps: MAX_STEPS,
        ..PathOptions::default()
    };
    let unknowns: Vec<usize> = (0..Constant::UNKNOWN).collect();
    let followed = follow(&belt, &start, &path, &unknowns, &options).map_err(Failure::of)?;
    let steps = followed.steps.iter().filter(|step| step.accepted).count();
    Ok(Solved { belt, stats: *followed.solution.stats(), continuation_steps: steps, solution: followed.solution })
}
