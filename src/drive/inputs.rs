//! What boundary equations and outputs take from a solution.

use solver::Solution;

/// Ends and integrals of a solution, as boundary equations take them.
pub fn inputs(solution: &Solution) -> (Vec<f64>, Vec<f64>) {
    let value = |end: Option<&f64>| end.copied().unwrap_or(f64::NAN);
    let ends = solution.regions().iter().flat_map(|part| {
        let entries = (0..part.states()).map(|i| value(part.state(i).first()));
        let exits = (0..part.states()).map(|i| value(part.state(i).last()));
        entries.chain(exits)
    });
    let integrals = solution.regions().iter().flat_map(|part| part.integrals().iter().copied());
    (ends.collect(), integrals.collect())
}
