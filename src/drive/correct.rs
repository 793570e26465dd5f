//! The last corrections: boundary equations met as closely as asked, or as rounding permits.
//!
//! Sliding speeds are small differences of large ones: a correction of the belt's speed that is small enough for the
//! speed may still move the torque, or an axial force that is prescribed.

use solver::{Guess, Options, Solution, SolveError, Stats};

use super::belt::BeltProblem;
use super::budget::Budget;

/// How much larger boundary residuals may be before a solution is corrected.
const RELAXATION: f64 = 100.0;
/// Newton's tolerance of a corrected solution over that of the solution, and where rounding forbids a smaller one.
const NEWTON_SHARE: f64 = 1e-4;
const LEAST_NEWTON: f64 = 1e-13;

/// Options for a solution that will be corrected.
pub(super) fn relaxed(options: &Options) -> Options {
    Options { boundary_tolerance: Some(RELAXATION * options.boundary_tolerance()), ..options.clone() }
}

/// The solution after further corrections: `always`, or if its boundary residuals are too large.
///
/// # Errors
/// Boundary residuals that stay too large; the solution as it was.
pub(super) fn corrected(
    belt: &BeltProblem,
    solution: Solution,
    options: &Options,
    always: bool,
    stats: &mut Stats,
    budget: &mut Budget,
) -> Result<Solution, (Box<Solution>, SolveError)> {
    let met = solution.max_boundary_residual() <= options.boundary_tolerance();
    if met && !always {
        return Ok(solution);
    }
    let newton_tolerance = Some((NEWTON_SHARE * options.tolerance).max(LEAST_NEWTON));
    let options = Options { newton_tolerance, rescues: 0, ..options.clone() };
    match solver::solve_observed(belt, &Guess::from(&solution), solution.unknowns(), &options, budget) {
        Ok(better) => {
            *stats += *better.stats();
            Ok(better)
        }
        // Rounding forbade it; what is there may do.
        Err(_) if met => Ok(solution),
        Err(cause) => Err((Box::new(solution), cause)),
    }
}
