//! Nodes that a mesh can do without.

use solver::{RegionGuess, RegionSolution, Solution};

/// Share of the tolerance that the defect may have where a node is left out: it grows along the path.
pub(super) const SHARE: f64 = 0.05;
/// Nodes in a row that may be left out.
const LONGEST_GAP: usize = 7;

/// The nodes of each region without those whose intervals, as one, would still have a defect of no more than `limit`.
/// Along a path the kinks of friction move, and leave their fine meshes behind.
pub(super) fn kept(solution: &Solution, limit: f64) -> Vec<Vec<usize>> {
    let exponent = solution.order().defect_exponent();
    solution.regions().iter().map(|part| nodes(part, exponent, limit)).collect()
}

/// Leaves out all other nodes of a region, wherever they have moved to.
pub(super) fn keep(kept: &[usize], region: &mut RegionGuess) {
    let pick = |values: &[f64]| kept.iter().filter_map(|&node| values.get(node).copied()).collect();
    region.mesh = pick(&region.mesh);
    region.states = region.states.iter().map(|values| pick(values)).collect();
}

/// See [`kept`].
fn nodes(part: &RegionSolution, exponent: u32, limit: f64) -> Vec<usize> {
    let (mesh, last) = (part.mesh(), part.intervals());
    let power = |length: f64| (0..exponent).fold(1.0, |power, _| power * length);
    // The defect of an interval is this times that power of its length, however long it is made.
    let factor = |interval: usize| {
        let defect = part.defects().get(interval).filter(|defect| defect.is_finite());
        defect.map_or(f64::INFINITY, |defect| defect / power(mesh[interval + 1] - mesh[interval]))
    };
    let (mut kept, mut from, mut largest) = (vec![0], 0, factor(0));
    for node in 1..last {
        let next = factor(node);
        largest = f64::max(largest, next);
        let superfluous = largest * power(mesh[node + 1] - mesh[from]) <= limit;
        if !superfluous || node - from > LONGEST_GAP {
            kept.push(node);
            (from, largest) = (node, next);
        }
    }
    kept.push(last);
    kept
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;
    use crate::case::Case;
    use crate::drive::{SolveOptions, solve};
    use crate::model::Constant;
    use solver::{Guess, Options};

    #[test]
    fn nodes_are_left_out_that_are_not_missed() {
        let fine = SolveOptions { tolerance: 1e-6, ..SolveOptions::default() };
        let solved = solve(&Case::default().resolve().unwrap(), &fine).unwrap();
        let unknowns: Vec<usize> = (0..Constant::UNKNOWN).collect();
        let options = Options { tolerance: 1e-3, ..Options::default() };
        // Intervals that are left, and meshes that it takes from there.
        let solve_without = |limit: f64| {
            let mut guess = Guess::from(&solved.solution);
            for (region, kept) in guess.regions.iter_mut().zip(kept(&solved.solution, limit)) {
                keep(&kept, region);
            }
            let intervals: usize = guess.regions.iter().map(|region| region.mesh.len() - 1).sum();
            (intervals, solver::solve(&solved.belt, &guess, &unknowns, &options).unwrap().history().len())
        };
        let all = solved.solution.intervals();
        assert_eq!(solve_without(-1.0).0, all);
        let (intervals, meshes) = solve_without(SHARE * options.tolerance);
        assert!(4 * intervals < 3 * all && meshes == 1, "{intervals} of {all} intervals, {meshes} meshes");
        let (intervals, meshes) = solve_without(100.0 * options.tolerance);
        assert!(meshes > 1, "{intervals} of {all} intervals, {meshes} meshes");
    }
}
