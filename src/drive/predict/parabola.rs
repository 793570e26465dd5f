//! Predictions from solutions alone, where there are enough of them: no matrix is put together for a tangent.

use std::array;

use solver::{Guess, RegionGuess};

use super::moved::{drift, kinks};
use super::nodes::{Nodes, expected};
use super::path::{Measure, PathPiece, TRAIL, Waypoint, states_at, sum};
use super::scale::Scale;
use super::sliding::{slide, speeds};
use crate::drive::belt::BeltProblem;
use crate::drive::region::RegionId;
use crate::drive::start;
use crate::model::{Constant, Constants};

/// Change that a fourth solution may make to what is predicted of the unknown constants, relative to them, in slip
/// thresholds over the speed of the primary's pitch line. A tangent takes as much work as 1.4 of Newton's iterations,
/// so that a parabola pays that is somewhat worse: of 10, 30 and 100, this takes the least work, or nearly so, along
/// ratios, slack tensions and torques, by all editions, to 1e-3, 1e-4 and 1e-6 (`docs/performance.md`).
const CLOSE: f64 = 30.0;

/// The guess at the end of a piece of path: the parabola through its last three solutions, if one more says that it is
/// close, on the nodes that `tolerance` asks for. The unknown constants are predicted relative to those of the tight,
/// inextensible belt.
pub(super) fn predicted(belt: &BeltProblem, path: &PathPiece<'_>, tolerance: f64) -> Option<Guess> {
    let trail = Trail::new(belt, path)?;
    let [now, before, earlier, _] = trail.steps;
    let parabola = Extrapolation::new([now, before, earlier]);
    let constants = trail.ahead(&parabola);
    if !trail.is_close(&constants, &trail.ahead(&Extrapolation::new(trail.steps))) {
        return None;
    }
    let constants = constants.0.into_iter().chain(path.to.targets.iter().copied()).collect();
    let mut guess = Guess { constants, regions: Vec::new() };
    for region in RegionId::ALL {
        let seen = trail.seen(region, tolerance)?;
        guess.regions.push(seen.ahead(&parabola)?);
        if region.is_contact() {
            let _ = trail.slide(region, &seen, &parabola, &mut guess);
        }
    }
    Some(guess)
}

/// The last solutions on a piece of path.
struct Trail<'a> {
    belt: &'a BeltProblem,
    path: &'a PathPiece<'a>,
    /// The one that is left, and those before it.
    points: [&'a Waypoint<'a>; TRAIL],
    /// Where they are, in steps ahead.
    steps: [f64; TRAIL],
    /// The tight, inextensible belt of each drive.
    tight: [Constants; TRAIL],
}

impl<'a> Trail<'a> {
    fn new(belt: &'a BeltProblem, path: &'a PathPiece<'a>) -> Option<Self> {
        let [first, second, third, ..] = path.before else { return None };
        let [one, two, three, ..] = path.all_back(belt, Measure::Logarithmic)[..] else { return None };
        let points = [path.from, first, second, third];
        let tight = points.map(|point| start::constants(&point.position.drive));
        Some(Self { belt, path, points, steps: [0.0, -one, -two, -three], tight })
    }

    /// The drive's constants at the end: the unknown ones as they change relative to those of the tight belt.
    fn ahead<const N: usize>(&self, extrapolation: &Extrapolation<N>) -> Constants {
        let mut drive = self.path.to.drive.clone();
        let unknown = |constant: &Constant| self.path.unknowns.contains(&constant.index());
        let value = |constant: Constant| move |point: usize| self.points[point].position.drive[constant];
        for constant in Constant::ALL.into_iter().skip(Constant::UNKNOWN).filter(unknown) {
            drive[constant] = extrapolation.ahead(value(constant));
        }
        let end = start::constants(&drive);
        for constant in Constant::ALL.into_iter().take(Constant::UNKNOWN).filter(unknown) {
            let (now, value) = (value(constant)(0), value(constant));
            let scale = Scale::of(constant, now, extrapolation.ahead(value) - now);
            let rest = extrapolation.ahead(|point| scale.to(value(point)) - scale.to(self.tight[point][constant]));
            drive[constant] = scale.from(scale.to(end[constant]) + rest);
        }
        drive
    }

    /// Whether the parabola is close, as far as the cubic tells: both with the constants that they predict.
    fn is_close(&self, parabola: &Constants, cubic: &Constants) -> bool {
        let here = &self.path.from.position.drive;
        let speed = here[Constant::PrimaryRadius] * here[Constant::PrimarySpeed];
        let slip = (here[Constant::SlipThreshold] / speed).abs();
        let mut unknown = Constant::ALL.into_iter().filter(|constant| self.path.unknowns.contains(&constant.index()));
        unknown.all(|constant| (parabola[constant] - cubic[constant]).abs() <= CLOSE * slip * here[constant].abs())
    }

    /// A region at the last three solutions, at the nodes that `tolerance` asks for: where these have moved, if kinks
    /// of friction belong together one by one, else where they are.
    fn seen(&self, region: RegionId, tolerance: f64) -> Option<Seen> {
        let index = region.index();
        let [now, before] = [0, 1].map(|point: usize| self.points[point].solution.regions().get(index));
        let (now, before, mesh) = (now?, before?, now?.mesh());
        let moved = if region.is_contact() { self.moved(region, mesh) } else { None };
        let places = moved.unwrap_or_else(|| [mesh.to_vec(), mesh.to_vec()]);
        let nodes = if self.path.bends {
            let exponent = self.path.from.solution.order().defect_exponent();
            let expected = expected(now, (before, &places[0], -self.steps[1]), exponent);
            Nodes::needed(now, &expected, exponent, tolerance).and_middles(&expected, tolerance)
        } else {
            Nodes::all(now)
        };
        let [then, earlier] = places.each_ref().map(|places| nodes.linear(places));
        let states = |point: usize, places: &[f64]| states_at(&self.points[point].solution, index, places);
        let states = [nodes.states(&self.points[0].solution, index)?, states(1, &then)?, states(2, &earlier)?];
        Some(Seen { states, places: [nodes.linear(mesh), then, earlier] })
    }

    /// Where some places of a contact were at the two solutions before the last, seen from the kinks of friction.
    fn moved(&self, region: RegionId, mesh: &[f64]) -> Option<[Vec<f64>; 2]> {
        let kinks = |point: usize| {
            let solution = &self.points[point].solution;
            kinks(self.belt, region, solution.regions().get(region.index())?, solution.constants())
        };
        let now = kinks(0)?;
        let at = |point: usize| {
            let step = self.steps[point];
            Some(sum(mesh, step, &drift(mesh, &kinks(point)?, &now, -step)?))
        };
        Some([at(1)?, at(2)?])
    }

    /// Has a contact of the guess slide as predicted.
    fn slide(&self, region: RegionId, seen: &Seen, parabola: &Extrapolation<3>, guess: &mut Guess) -> Option<()> {
        let speeds =
            |point: usize| speeds(self.belt, region, self.points[point].solution.constants(), seen.states.get(point)?);
        let speeds = [speeds(0)?, speeds(1)?, speeds(2)?];
        slide(self.belt, region, guess, &parabola.rows_ahead(speeds.each_ref().map(Vec::as_slice)))
    }
}

/// A region as it was at the last three solutions.
struct Seen {
    places: [Vec<f64>; 3],
    states: [Vec<Vec<f64>>; 3],
}

impl Seen {
    /// The region at the end, unless its nodes pass each other.
    fn ahead(&self, parabola: &Extrapolation<3>) -> Option<RegionGuess> {
        let mesh = parabola.rows_ahead(self.places.each_ref().map(Vec::as_slice));
        let [now, then, before] = &self.states;
        let rows = now.iter().zip(then).zip(before);
        let states = rows.map(|((now, then), before)| parabola.rows_ahead([now, then, before])).collect();
        mesh.windows(2).all(|ends| ends[0] < ends[1]).then_some(RegionGuess { mesh, states })
    }
}

/// Polynomial extrapolation from `N` points to one step ahead of the first of them.
struct Extrapolation<const N: usize> {
    /// What each point's value counts.
    weights: [f64; N],
}

impl<const N: usize> Extrapolation<N> {
    /// From where the points are, in steps ahead: Lagrange's polynomials.
    fn new(steps: [f64; N]) -> Self {
        let weight = |point: usize| {
            let others = steps.iter().enumerate().filter(|(other, _)| *other != point);
            others.map(|(_, step)| (1.0 - step) / (steps[point] - step)).product()
        };
        Self { weights: array::from_fn(weight) }
    }

    /// The value one step ahead, from that at each point; to the last bit what they have in common.
    fn ahead(&self, value: impl Fn(usize) -> f64) -> f64 {
        let first = value(0);
        let changes = self.weights.iter().enumerate().skip(1);
        first + changes.map(|(point, weight)| weight * (value(point) - first)).sum::<f64>()
    }
}

impl Extrapolation<3> {
    /// As [`ahead`](Self::ahead), for each value of three rows.
    fn rows_ahead(&self, [now, then, before]: [&[f64]; 3]) -> Vec<f64> {
        let values = now.iter().zip(then).zip(before);
        values.map(|((now, then), before)| self.ahead(|point| [*now, *then, *before][point])).collect()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;
    use crate::case::{Case, Resolved};
    use crate::drive::position::Position;
    use crate::drive::predict::tangents;
    use crate::drive::question::Question;
    use crate::drive::solved::Solved;
    use crate::drive::{SolveOptions, solve};

    #[test]
    fn polynomials_are_continued_exactly() {
        let steps = [0.0, -0.5, -1.75, -2.0];
        let cubic = |t: f64| 3.0 - 2.0 * t + 0.5 * t * t - 0.25 * t * t * t;
        let found = Extrapolation::new(steps).ahead(|point| cubic(steps[point]));
        assert!((found - cubic(1.0)).abs() < 1e-12, "{found}");
        let parabola = |t: f64| 3.0 - 2.0 * t + 0.5 * t * t;
        let three = Extrapolation::new([0.0, -0.5, -1.75]);
        let found = three.ahead(|point| parabola(steps[point]));
        assert!((found - parabola(1.0)).abs() < 1e-12, "{found}");
        // What does not change, such as the ends of a region, does not move by rounding.
        assert_eq!(three.ahead(|_| 0.1), 0.1);
    }

    /// The base case at another torque, N·m.
    fn case(torque: f64) -> Resolved {
        let mut case = Case::default();
        case.set("operating_point.primary_torque", &torque.to_string()).unwrap();
        case.resolve().unwrap()
    }

    fn at(torque: f64) -> (Question, Solved) {
        let case = case(torque);
        let options = SolveOptions { tolerance: 1e-4, ..SolveOptions::default() };
        (Question::of(&case), solve(&case, &options).unwrap())
    }

    #[test]
    fn the_parabola_is_as_close_as_the_tangent_and_is_left_where_the_path_turns() {
        let unknowns: Vec<usize> = (0..Constant::UNKNOWN).collect();
        let [far, third, second, first, last, next] = [10.0, 11.0, 12.0, 13.0, 14.0, 15.0].map(at);
        let belt = &last.1.belt;
        let waypoint = |point: &'_ (Question, Solved)| Waypoint {
            solution: std::borrow::Cow::Owned(point.1.solution.clone()),
            position: Position::of(&point.1, &point.0).unwrap(),
        };
        let [far, third, second, first, last] = [&far, &third, &second, &first, &last].map(waypoint);
        let to = Position::asked(&next.0);
        let predict = |before: &[Waypoint<'_>]| {
            let path = PathPiece { before, from: &last, to: &to, unknowns: &unknowns, bends: true };
            (predicted(belt, &path, 1e-4), tangents::predicted(belt, &path, 1e-4).unwrap())
        };
        let (parabola, tangent) = predict(&[first.clone(), second.clone(), third.clone()]);
        // The speed ratio and the mass flow, on which sliding hangs.
        let miss = |guess: &Guess, constant: Constant| {
            let (found, expected) = (guess.constants[constant.index()], next.1.constant(constant));
            (found / expected - 1.0).abs()
        };
        let parabola = parabola.unwrap();
        for constant in [Constant::SpeedRatio, Constant::Flow] {
            let (this, that) = (miss(&parabola, constant), miss(&tangent, constant));
            assert!(this < 1e-5 && this < 2.0 * that + 1e-6, "{constant:?}: {this:e}, by the tangent {that:e}");
        }
        // Both stand on the nodes that they say they do: those of the tangent are as many as its defects ask for.
        let (part, exponent) = (&last.solution.regions()[0], last.solution.order().defect_exponent());
        let needed = Nodes::needed(part, part.defects(), exponent, 1e-4);
        assert_eq!(tangent.regions[0].mesh.len(), needed.len());
        let before = [first.clone(), second.clone(), third.clone()];
        let path = PathPiece { before: &before, from: &last, to: &to, unknowns: &unknowns, bends: true };
        let seen = Trail::new(belt, &path).unwrap().seen(RegionId::Primary, 1e-4).unwrap();
        assert_eq!(parabola.regions[0].mesh.len(), seen.places[0].len());
        assert!(seen.places[0].iter().filter(|s| part.mesh().contains(s)).count() < part.mesh().len());
        // Too few, one from elsewhere, and one at a place that is there already.
        assert!(predict(&[first.clone(), second.clone()]).0.is_none());
        assert!(predict(&[first.clone(), second.clone(), waypoint(&next)]).0.is_none());
        assert!(predict(&[first.clone(), first.clone(), far.clone()]).0.is_none());
        // A gap: the fourth is farther away, and the parabola as close.
        assert!(predict(&[first, second, far]).0.is_some());
    }

    #[test]
    fn the_parabola_is_left_where_solutions_change_too_fast() {
        let unknowns: Vec<usize> = (0..Constant::UNKNOWN).collect();
        let points = [0.5, 2.0, 8.0, 18.0].map(at);
        let [third, second, first, last] = points.each_ref().map(|point| Waypoint::of(&point.1, &point.0).unwrap());
        let to = Position::asked(&Question::of(&case(40.0)));
        let path =
            PathPiece { before: &[first, second, third], from: &last, to: &to, unknowns: &unknowns, bends: true };
        assert!(predicted(&points[3].1.belt, &path, 1e-4).is_none());
    }
}
