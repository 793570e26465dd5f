//! From solutions of cases nearby to that of a case.

use solver::{Options, Solution, SolveError, Stats};

use super::belt::Belt;
use super::constants::{Constant, Constants};
use super::predict::predicted;
use super::solve::{Failure, ROUGH_TOLERANCE, SolveOptions, Solved, given};
use crate::case::Resolved;

// What a warm start may cost; beyond it, a cold start is the shorter way.
const SMALLEST_STEP: f64 = 0.25;
const MAX_ITERATIONS: usize = 15;
const MAX_MESHES: usize = 12;
const MAX_INTERVALS: usize = 2000;

/// Solves a case by following the last of the solutions `trail` while the constants that differ go to those of the case:
/// the slip threshold geometrically, all others linearly. The solution before the last, if there is one, tells how the way
/// bends. All must be of one model; the caller sees to that. Gives up early, on anything but a case nearby.
///
/// # Errors
/// See [`Failure`]. A case out of reach of the trail may still be solved by [`solve`](super::solve).
pub fn solve_from(trail: &[&Solved], case: &Resolved, options: &SolveOptions) -> Result<Solved, Failure> {
    let target = given(case)?;
    let belt = Belt::new(&case.model, &target).ok_or(Failure::NoEquations)?;
    let [.., last] = trail else { return Err(Failure::NoStart) };
    let origin = Constants::of(&last.solution);
    let (mut stats, mut steps, mut way, mut step) = (Stats::default(), 0, 0.0, 1.0);
    let mut before = if let [.., before, _] = trail { Some(before.solution.clone()) } else { None };
    let mut here = last.solution.clone();
    loop {
        let next = f64::min(way + step, 1.0);
        let tolerance = if next < 1.0 { options.tolerance.max(ROUGH_TOLERANCE) } else { options.tolerance };
        match advance(&belt, before.as_ref(), &here, &origin.toward(&target, next), tolerance, options) {
            Ok(solution) => {
                stats += *solution.stats();
                steps += 1;
                if next == 1.0 {
                    return Ok(Solved { belt, stats, continuation_steps: steps, solution });
                }
                (before, way) = (Some(std::mem::replace(&mut here, solution)), next);
            }
            Err(cause) if step < 2.0 * SMALLEST_STEP => return Err(Failure::lost(&here, cause)),
            Err(_) => step /= 2.0,
        }
    }
}

/// How far a case is from a solution: the largest factor between the given constants of both; infinite where one has
/// none, or of another sign.
pub fn remoteness(from: &Solved, case: &Resolved) -> f64 {
    let Ok(target) = given(case) else { return f64::INFINITY };
    let here = Constants::of(&from.solution);
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
    belt: &Belt,
    before: Option<&Solution>,
    from: &Solution,
    to: &Constants,
    tolerance: f64,
    options: &SolveOptions,
) -> Result<Solution, SolveError> {
    let options = Options {
        tolerance,
        order: options.order,
        max_meshes: MAX_MESHES,
        max_intervals: MAX_INTERVALS,
        max_iterations: MAX_ITERATIONS,
        rescues: 0,
        ..Options::default()
    };
    let guess = predicted(belt, before, from, to, tolerance)?;
    solver::solve(belt, &guess, from.unknowns(), &options)
}

impl Constants {
    /// Those of a solution.
    pub(super) fn of(solution: &Solution) -> Self {
        let value = |constant: Constant| solution.constants().get(constant.index()).copied().unwrap_or(f64::NAN);
        Self(Constant::ALL.map(value))
    }

    /// A share of the way to other constants.
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
