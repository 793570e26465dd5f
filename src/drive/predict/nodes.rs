//! Which nodes the mesh of a guess has: those of the solution that is left which it cannot do without, and one more in
//! the middle of intervals that would be too long at the end of the step.
//!
//! Along a path the kinks of friction move: they leave their fine meshes behind, and come upon intervals that were just
//! short enough. What is not foreseen of that takes another mesh, and with it another matrix.

use solver::{RegionSolution, Solution};

/// Share of the tolerance that the defect may have where a node is left out.
const SHARE: f64 = 0.05;
/// Nodes in a row that may be left out.
const LONGEST_GAP: usize = 7;
/// Defects grow at most by this factor in one step, as far as the steps before it tell, or fall by it: of an interval
/// that a kink has come to or left, the last step tells no more.
const MOST_GROWTH: f64 = 10.0;

/// Nodes of one region's mesh.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Nodes {
    /// Nodes of the solution that are kept, the ends among them.
    kept: Vec<usize>,
    /// Those of them after which there is one in the middle before the next.
    halved: Vec<usize>,
}

impl Nodes {
    /// Those that a region cannot do without to keep its defects within a share of `tolerance`, if the intervals of the
    /// solution have these `defects`, and they grow with their length to the power `exponent`.
    pub(super) fn needed(part: &RegionSolution, defects: &[f64], exponent: u32, tolerance: f64) -> Self {
        let (mesh, last) = (part.mesh(), part.intervals());
        let factor = |interval: usize| {
            let factor = factor(mesh, defects, interval, exponent);
            if factor.is_finite() { factor } else { f64::INFINITY }
        };
        let limit = SHARE * tolerance;
        let (mut kept, mut from, mut largest) = (vec![0], 0, factor(0));
        for node in 1..last {
            let next = factor(node);
            largest = f64::max(largest, next);
            let superfluous = largest * power(mesh[node + 1] - mesh[from], exponent) <= limit;
            if !superfluous || node - from > LONGEST_GAP {
                kept.push(node);
                (from, largest) = (node, next);
            }
        }
        kept.push(last);
        Self { kept, halved: Vec::new() }
    }

    /// And those in the middle of the intervals whose defects exceed `tolerance`.
    pub(super) fn and_middles(mut self, defects: &[f64], tolerance: f64) -> Self {
        let intervals = self.kept.windows(2).filter(|ends| ends[1] == ends[0] + 1).map(|ends| ends[0]);
        let too_long = |interval: &usize| defects.get(*interval).is_some_and(|&defect| defect > tolerance);
        self.halved = intervals.filter(too_long).collect();
        self
    }

    /// All nodes of a solution's region, and no others.
    pub(super) fn all(part: &RegionSolution) -> Self {
        Self { kept: (0..=part.intervals()).collect(), halved: Vec::new() }
    }

    /// How many there are.
    pub(super) fn len(&self) -> usize {
        self.kept.len() + self.halved.len()
    }

    /// Values there from those at all nodes of the solution, in the middle of an interval the mean of both ends.
    pub(super) fn linear(&self, values: &[f64]) -> Vec<f64> {
        self.with(values, |node| 0.5 * (values[node] + values[node + 1]))
    }

    /// The states of a solution's region.
    pub(super) fn states(&self, solution: &Solution, region: usize) -> Option<Vec<Vec<f64>>> {
        let part = solution.regions().get(region)?;
        let mesh = part.mesh();
        let middles: Vec<f64> = self.halved.iter().map(|&node| 0.5 * (mesh[node] + mesh[node + 1])).collect();
        let inner = part.eval_many(&middles);
        let row = |state: usize| {
            let mut inner = inner[state * middles.len()..].iter().copied();
            self.with(part.state(state), |_| inner.next().unwrap_or(f64::NAN))
        };
        Some((0..part.states()).map(row).collect())
    }

    /// Values at the nodes that are kept, and after those that say so the one that `middle` has for them.
    fn with(&self, values: &[f64], mut middle: impl FnMut(usize) -> f64) -> Vec<f64> {
        let (mut all, mut halved) = (Vec::with_capacity(self.len()), self.halved.iter().copied().peekable());
        for &node in &self.kept {
            all.push(values[node]);
            all.extend(halved.next_if_eq(&node).map(&mut middle));
        }
        all
    }
}

/// The defects that a region's intervals would have one step ahead, if they go on to grow as they have from the
/// solution before, `back` such steps behind, where the nodes were at `places`. NaN where they are not known.
pub(super) fn expected(
    now: &RegionSolution,
    (before, places, back): (&RegionSolution, &[f64], f64),
    exponent: u32,
) -> Vec<f64> {
    let factor = |part: &RegionSolution, interval: usize| factor(part.mesh(), part.defects(), interval, exponent);
    let mut there = 0;
    let grown = |(interval, ends): (usize, &[f64])| {
        let middle = 0.5 * (ends[0] + ends[1]);
        while there + 1 < before.intervals() && before.mesh()[there + 1] <= middle {
            there += 1;
        }
        let growth = libm::pow(factor(now, interval) / factor(before, there), 1.0 / back);
        let growth = if growth.is_nan() { 1.0 } else { growth.clamp(1.0 / MOST_GROWTH, MOST_GROWTH) };
        now.defects().get(interval).map_or(f64::NAN, |defect| defect * growth)
    };
    places.windows(2).enumerate().map(grown).collect()
}

/// The defect of an interval is this times that power of its length, however long it is made. NaN if it is not known.
fn factor(mesh: &[f64], defects: &[f64], interval: usize, exponent: u32) -> f64 {
    let defect = defects.get(interval).copied().unwrap_or(f64::NAN);
    defect / power(mesh[interval + 1] - mesh[interval], exponent)
}

fn power(length: f64, exponent: u32) -> f64 {
    (0..exponent).fold(1.0, |power, _| power * length)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;
    use crate::case::Case;
    use crate::drive::{SolveOptions, solve};
    use crate::model::Constant;
    use solver::{Guess, Options};

    fn solved(torque: f64, tolerance: f64) -> crate::drive::Solved {
        let mut case = Case::default();
        case.set("operating_point.primary_torque", &torque.to_string()).unwrap();
        solve(&case.resolve().unwrap(), &SolveOptions { tolerance, ..SolveOptions::default() }).unwrap()
    }

    #[test]
    fn nodes_are_left_out_that_are_not_missed() {
        let solved = solved(14.0, 1e-6);
        let unknowns: Vec<usize> = (0..Constant::UNKNOWN).collect();
        let options = Options { tolerance: 1e-3, ..Options::default() };
        // Intervals that are left, and meshes that it takes from there.
        let solve_with = |nodes: &dyn Fn(&RegionSolution) -> Nodes| {
            let mut guess = Guess::from(&solved.solution);
            for (region, part) in guess.regions.iter_mut().zip(solved.solution.regions()) {
                let nodes = nodes(part);
                region.mesh = nodes.linear(&region.mesh);
                region.states.iter_mut().for_each(|states| *states = nodes.linear(states));
            }
            let intervals: usize = guess.regions.iter().map(|region| region.mesh.len() - 1).sum();
            (intervals, solver::solve(&solved.belt, &guess, &unknowns, &options).unwrap().history().len())
        };
        let all = solved.solution.intervals();
        assert_eq!(solve_with(&Nodes::all).0, all);
        let exponent = solved.solution.order().defect_exponent();
        let needed = |tolerance: f64| solve_with(&|part| Nodes::needed(part, part.defects(), exponent, tolerance));
        let (intervals, meshes) = needed(options.tolerance);
        assert!(4 * intervals < 3 * all && meshes == 1, "{intervals} of {all} intervals, {meshes} meshes");
        let (intervals, meshes) = needed(2000.0 * options.tolerance);
        assert!(meshes > 1, "{intervals} of {all} intervals, {meshes} meshes");
    }

    #[test]
    fn middles_stand_where_defects_are_too_large_and_carry_the_solution_there() {
        let solved = solved(14.0, 1e-3);
        let part = &solved.solution.regions()[0];
        let (mesh, last) = (part.mesh(), part.intervals() - 1);
        let mut defects = vec![1.0; part.intervals()];
        (defects[0], defects[3], defects[last], defects[5]) = (3.0, 2.1, f64::INFINITY, f64::NAN);
        let nodes = Nodes::all(part).and_middles(&defects, 2.0);
        let found = nodes.linear(mesh);
        assert_eq!((found.len(), nodes.len()), (mesh.len() + 3, mesh.len() + 3));
        let middle = |interval: usize| 0.5 * (mesh[interval] + mesh[interval + 1]);
        assert_eq!((found[0], found[1], found[2]), (mesh[0], middle(0), mesh[1]));
        assert_eq!((found[4], found[5], found[6]), (mesh[3], middle(3), mesh[4]));
        assert_eq!((found[found.len() - 2], found[found.len() - 1]), (middle(last), mesh[last + 1]));
        for (state, values) in nodes.states(&solved.solution, 0).unwrap().into_iter().enumerate() {
            let expected: Vec<f64> = found.iter().map(|s| part.eval(*s)[state]).collect();
            assert!(values.iter().zip(&expected).all(|(a, b)| (a - b).abs() <= 1e-14 * (1.0 + b.abs())), "{state}");
        }
        // An interval that others have been joined to is not halved.
        let joined = Nodes { kept: vec![0, 4, 5], halved: Vec::new() }.and_middles(&[3.0; 5], 2.0);
        assert_eq!(joined.halved, [4]);
    }

    #[test]
    fn defects_grow_on_as_they_have_grown_whatever_the_meshes() {
        let [before, now, coarse] = [(13.0, 1e-4), (14.0, 1e-4), (14.0, 1e-3)].map(|(torque, tol)| solved(torque, tol));
        let exponent = now.solution.order().defect_exponent();
        let parts = [&before, &now, &coarse].map(|solved| &solved.solution.regions()[0]);
        let growth = |before: &RegionSolution, back: f64| -> Vec<f64> {
            let places = parts[1].mesh();
            let expected = expected(parts[1], (before, places, back), exponent);
            expected.iter().zip(parts[1].defects()).map(|(expected, defect)| expected / defect).collect()
        };
        assert!(growth(parts[1], 1.0).iter().all(|growth| (growth - 1.0).abs() < 1e-12));
        // Of one solution on two meshes.
        let mut same = growth(parts[2], 1.0);
        same.sort_by(f64::total_cmp);
        let middle = |part: usize| same[same.len() * part / 4];
        assert!(middle(1) > 0.3 && middle(3) < 3.0, "{} {} {}", middle(1), middle(2), middle(3));
        // Half a step back tells of the square of what a whole one does.
        let (whole, half) = (growth(parts[0], 1.0), growth(parts[0], 0.5));
        let square = |(whole, half): (&f64, &f64)| {
            (half / (whole * whole).clamp(1.0 / MOST_GROWTH, MOST_GROWTH) - 1.0).abs() < 1e-9
        };
        let free = |(whole, _): &(&f64, &f64)| (1.001 / MOST_GROWTH..0.999 * MOST_GROWTH).contains(*whole);
        assert!(whole.iter().zip(&half).filter(free).all(square));
        assert!(whole.iter().any(|growth| *growth > 1.5) && whole.iter().any(|growth| *growth < 0.7));
    }
}
