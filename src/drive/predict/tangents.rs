//! Predictions by tangents.

use solver::{Guess, Linearisation, RegionGuess, RegionSolution, Solution, SolveError, Tangent, TangentRegion};

use super::moved::{beyond_threshold, drift, drift_to, kinks, zeros};
use super::nodes::Nodes;
use super::path::{Measure, PathPiece, Waypoint, states_at, sum};
use super::scale::Scale;
use super::sliding::{slide, speeds};
use crate::drive::belt::BeltProblem;
use crate::drive::position::Position;
use crate::drive::region::RegionId;
use crate::drive::start;
use crate::model::{Constant, Constants};

/// Difference quotients along the path take this share of it.
const DIFFERENCE: f64 = 1e-3;

/// The guess at the end of a piece of path: its first solution and the tangent there, bent as the path from the
/// solution before it bends, on those of its nodes that `tolerance` asks for. The unknown constants follow those of the
/// tight, inextensible belt.
pub(super) fn predicted(belt: &BeltProblem, path: &PathPiece<'_>, tolerance: f64) -> Result<Guess, SolveError> {
    let curve = Curve::new(belt, path)?;
    let mut guess = Guess::from(&*path.from.solution);
    guess.constants = curve.constants();
    for (index, region) in guess.regions.iter_mut().enumerate() {
        region.mesh = curve.places(index, &region.mesh, 1.0);
        region.states = curve.states(index);
    }
    for region in RegionId::ALL.into_iter().filter(|region| region.is_contact()) {
        let _ = curve.adhere(region, &mut guess);
    }
    if path.bends {
        let exponent = path.from.solution.order().defect_exponent();
        for (part, region) in path.from.solution.regions().iter().zip(&mut guess.regions) {
            let nodes = Nodes::needed(part, part.defects(), exponent, tolerance);
            region.mesh = nodes.linear(&region.mesh);
            region.states.iter_mut().for_each(|states| *states = nodes.linear(states));
        }
    }
    Ok(guess)
}

/// The path through a solution: its first and, where the solution before lies on it, second derivatives.
struct Curve<'a> {
    belt: &'a BeltProblem,
    from: &'a Solution,
    unknowns: &'a [usize],
    here: &'a Constants,
    /// Where the piece ends; of unknown constants that are given by default, as the tangent has them there.
    to: Position,
    ahead: Tangent,
    bend: Option<Bend<'a>>,
    /// Whether the belt has bending stiffness.
    stiff: bool,
    /// How far the nodes of each region move; empty where they stay. All rates are those seen from there.
    drifts: Vec<Vec<f64>>,
}

/// Where the path came from.
struct Bend<'a> {
    before: &'a Solution,
    constants: &'a Constants,
    back: Tangent,
    /// Length of the step back, in steps ahead.
    length: f64,
}

impl<'a> Curve<'a> {
    fn new(belt: &'a BeltProblem, path: &PathPiece<'a>) -> Result<Self, SolveError> {
        let (from, here) = (&*path.from.solution, &path.from.position);
        let origin = here.vector();
        let at = Guess { constants: origin.clone(), ..Guess::from(from) };
        let linearisation = Linearisation::near(belt, &at, path.unknowns, from.order())?;
        let tangent = |to: &Position| {
            let direction: Vec<f64> = origin.iter().zip(to.vector()).map(|(here, to)| to - here).collect();
            linearisation.tangent(&direction)
        };
        let ahead = tangent(path.to);
        let mut to = path.to.clone();
        for constant in Constant::ALL.into_iter().skip(Constant::UNKNOWN) {
            let at = constant.index();
            if path.unknowns.contains(&at) {
                to.drive[constant] = here.drive[constant] + ahead.constants.get(at).copied().unwrap_or(0.0);
            }
        }
        let bend = path.before.first().and_then(|point| {
            let length = path.back(belt, point, Measure::Linear)?;
            let Waypoint { solution, position } = point;
            Some(Bend { before: solution, back: tangent(position), constants: &position.drive, length })
        });
        let drifts = vec![Vec::new(); from.regions().len()];
        Ok(Self { belt, from, unknowns: path.unknowns, here: &here.drive, to, ahead, bend, stiff: path.bends, drifts }
            .moving())
    }

    /// This path, seen from places that move with the kinks of friction.
    fn moving(mut self) -> Self {
        for region in RegionId::ALL.into_iter().filter(|region| region.is_contact()) {
            let index = region.index();
            let (Some(now), Some(drift)) = (self.from.regions().get(index), self.drift(region)) else { continue };
            follow(now, &drift, 1.0, self.ahead.regions.get_mut(index));
            if let Some(bend) = &mut self.bend {
                follow(now, &drift, -bend.length, bend.back.regions.get_mut(index));
            }
            self.drifts[index] = drift;
        }
        self
    }

    /// How far the nodes of a contact move in one step ahead: as they have since the solution before, else as the
    /// tangent says, unless the belt has no bending stiffness: that is lost more often by it. Kinks that follow the
    /// tangent, and bend as their way from the solution before does, are no better: from two solutions, to 1e-3 and
    /// 1e-4, steps take 0.9 to 1.7 times the work with them.
    fn drift(&self, region: RegionId) -> Option<Vec<f64>> {
        let Some(bend) = &self.bend else { return if self.stiff { self.drift_by_tangent(region) } else { None } };
        let (then, now) = (bend.before.regions().get(region.index())?, self.from.regions().get(region.index())?);
        let kinks = |part: &RegionSolution, solution: &Solution| kinks(self.belt, region, part, solution.constants());
        drift(now.mesh(), &kinks(then, bend.before)?, &kinks(now, self.from)?, bend.length)
    }

    /// As [`drift`](Self::drift), by the tangent: a kink moves by the rate at which the sliding speed there outgrows
    /// the slip threshold, over the slope of the speed along the contact. What the tangent has of the speed is not
    /// extrapolated to other places: it bends at the kink.
    fn drift_by_tangent(&self, region: RegionId) -> Option<Vec<f64>> {
        let mesh = self.from.regions().get(region.index())?.mesh();
        let beyond = |h: f64| {
            let (states, constants) = self.along(&self.ahead, region, h)?;
            beyond_threshold(self.belt, region, &states.concat(), &constants)
        };
        let (before, now, after) = (beyond(-DIFFERENCE)?, beyond(0.0)?, beyond(DIFFERENCE)?);
        let rate = |node: usize| (after[node] - before[node]) / (2.0 * DIFFERENCE);
        let moved = |&kink: &f64| {
            let right = mesh.partition_point(|node| *node <= kink).clamp(1, mesh.len() - 1);
            let left = right - 1;
            let length = mesh[right] - mesh[left];
            let share = (kink - mesh[left]) / length;
            kink - length * (rate(left) + share * (rate(right) - rate(left))) / (now[right] - now[left])
        };
        let kinks = zeros(mesh, &now);
        let next: Vec<f64> = kinks.iter().map(moved).collect();
        drift_to(mesh, &kinks, &next)
    }

    /// Where the nodes of a region are so many steps ahead.
    fn places(&self, region: usize, mesh: &[f64], steps: f64) -> Vec<f64> {
        let drift = self.drifts.get(region).filter(|drift| drift.len() == mesh.len());
        drift.map_or_else(|| mesh.to_vec(), |drift| sum(mesh, steps, drift))
    }

    /// The states of a region at the solution before, where its nodes were.
    fn then(&self, region: usize, mesh: &[f64]) -> Option<Vec<Vec<f64>>> {
        let bend = self.bend.as_ref()?;
        states_at(bend.before, region, &self.places(region, mesh, -bend.length))
    }

    /// The states of a region at its nodes.
    fn states(&self, region: usize) -> Vec<Vec<f64>> {
        let Some(part) = self.from.regions().get(region) else { return Vec::new() };
        let then = self.then(region, part.mesh());
        let row = |state: usize| {
            let rates = |tangent: &'_ Tangent| tangent.regions.get(region)?.states.get(state).cloned();
            let (ahead, back) = (rates(&self.ahead)?, self.bend.as_ref().and_then(|bend| rates(&bend.back)));
            let then = then.as_ref().and_then(|then| then.get(state));
            Some(self.extrapolated(part.state(state), &ahead, then.map(Vec::as_slice), back.as_deref()))
        };
        (0..part.states()).map(|state| row(state).unwrap_or_else(|| part.state(state).to_vec())).collect()
    }

    /// Values at the end of the path from those now, their rates ahead, and, if known, those then with the rates back.
    fn extrapolated(&self, now: &[f64], ahead: &[f64], then: Option<&[f64]>, back: Option<&[f64]>) -> Vec<f64> {
        let mut values: Vec<f64> = now.iter().zip(ahead).map(|(now, ahead)| now + ahead).collect();
        if let (Some(then), Some(back), Some(bend)) = (then, back, &self.bend) {
            for (((value, now), then), back) in values.iter_mut().zip(now).zip(then).zip(back) {
                *value += (then - now - back) / (bend.length * bend.length);
            }
        }
        values
    }

    /// All constants: the given ones as they are wanted, the unknown ones relative to the tight belt's.
    fn constants(&self) -> Vec<f64> {
        let ahead = Tight::new(self.here, &self.to.drive);
        let back = self.bend.as_ref().map(|bend| (bend, Tight::new(self.here, bend.constants)));
        let constant = |constant: Constant| {
            let (at, value) = (constant.index(), self.here[constant]);
            if !self.unknowns.contains(&at) {
                return self.to.drive[constant];
            }
            let rate = |tangent: &Tangent| tangent.constants.get(at).copied().unwrap_or(0.0);
            let scale = Scale::of(constant, value, rate(&self.ahead));
            let second = back.as_ref().map_or(0.0, |(bend, tight)| {
                let rest = scale.to(bend.constants[constant]) - scale.to(value) - scale.rate(value, rate(&bend.back));
                (rest - tight.bend(constant, scale)) / (bend.length * bend.length)
            });
            let moved = scale.to(value) + scale.rate(value, rate(&self.ahead));
            scale.from(moved + ahead.bend(constant, scale) + second)
        };
        Constant::ALL.into_iter().map(constant).chain(self.to.targets.iter().copied()).collect()
    }

    /// The states of a region at its nodes, and all constants, so many times a tangent away.
    fn along(&self, tangent: &Tangent, region: RegionId, h: f64) -> Option<(Vec<Vec<f64>>, Vec<f64>)> {
        let part = self.from.regions().get(region.index())?;
        let rates = tangent.regions.get(region.index())?.states.iter().enumerate();
        let states = rates.map(|(state, rate)| sum(part.state(state), h, rate)).collect();
        Some((states, sum(&self.here.0, h, &tangent.constants)))
    }

    /// Has a contact of the guess slide as predicted.
    fn adhere(&self, region: RegionId, guess: &mut Guess) -> Option<()> {
        let index = region.index();
        let part = self.from.regions().get(index)?;
        let rate = |tangent: &Tangent| {
            let moved = |h: f64| {
                let (states, constants) = self.along(tangent, region, h)?;
                speeds(self.belt, region, &constants, &states)
            };
            let (a, b) = (moved(-DIFFERENCE)?, moved(DIFFERENCE)?);
            Some(a.iter().zip(&b).map(|(a, b)| (b - a) / (2.0 * DIFFERENCE)).collect::<Vec<f64>>())
        };
        let now = speeds(self.belt, region, &self.here.0, &RegionGuess::from(part).states)?;
        let bend = self.bend.as_ref();
        let then = bend.and_then(|bend| speeds(self.belt, region, &bend.constants.0, &self.then(index, part.mesh())?));
        let back = bend.and_then(|bend| rate(&bend.back));
        let wanted = self.extrapolated(&now, &rate(&self.ahead)?, then.as_deref(), back.as_deref());
        slide(self.belt, region, guess, &wanted)
    }
}

/// Adds what is seen from places that move through a solution.
fn follow(part: &RegionSolution, drift: &[f64], factor: f64, rates: Option<&mut TangentRegion>) {
    let states = rates.into_iter().flat_map(|rates| rates.states.iter_mut().enumerate());
    for (state, rates) in states {
        for ((rate, slope), drift) in rates.iter_mut().zip(part.slope(state)).zip(drift) {
            *rate += factor * slope * drift;
        }
    }
}

/// The unknown constants of the tight, inextensible belt along a path. The drive's stay close to them, and what a
/// tangent leaves out of them would put the sliding speeds wrong by many slip thresholds: 2.5 % of change in both radii
/// change the speed ratio by 5 %, and its square by 0.25 %, which is 60 mm/s of sliding.
struct Tight {
    begin: Constants,
    end: Constants,
    /// Both ends of a difference quotient at the begin.
    around: [Constants; 2],
}

impl Tight {
    fn new(from: &Constants, to: &Constants) -> Self {
        let tight = |share: f64| start::constants(&from.toward(to, share));
        Self { begin: tight(0.0), end: tight(1.0), around: [tight(-DIFFERENCE), tight(DIFFERENCE)] }
    }

    /// What a tangent leaves out along the whole path.
    fn bend(&self, constant: Constant, scale: Scale) -> f64 {
        let value = |drive: &Constants| scale.to(drive[constant]);
        let [before, after] = &self.around;
        value(&self.end) - value(&self.begin) - (value(after) - value(before)) / (2.0 * DIFFERENCE)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;
    use crate::case::{Case, Resolved};
    use crate::drive::question::Question;
    use crate::drive::{SolveOptions, solve, solve_from};

    fn case(edition: &str, tension: f64) -> Resolved {
        let mut case = Case::default();
        case.set("edition", edition).unwrap();
        case.set("operating_point.slack_tension", &tension.to_string()).unwrap();
        case.resolve().unwrap()
    }

    /// How far the nearest of some places is.
    fn nearest(places: &[f64], place: f64) -> f64 {
        places.iter().map(|other| (other - place).abs()).fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn from_one_solution_kinks_move_to_where_they_are_found() {
        let options = SolveOptions { tolerance: 1e-4, ..SolveOptions::default() };
        let unknowns: Vec<usize> = (0..Constant::UNKNOWN).collect();
        for edition in ["published", "thesis", "consistent"] {
            let last = solve(&case(edition, 100.0), &options).unwrap();
            let from = Waypoint::of(&last, &Question::of(&case(edition, 100.0))).unwrap();
            for tension in [90.0, 110.0] {
                let to = Position::asked(&Question::of(&case(edition, tension)));
                let path = PathPiece { before: &[], from: &from, to: &to, unknowns: &unknowns, bends: true };
                let guess = predicted(&last.belt, &path, 1e-4).unwrap();
                let next = solve(&case(edition, tension), &options).unwrap();
                for region in [RegionId::Primary, RegionId::Secondary] {
                    let of = |solution: &Solution| {
                        kinks(&last.belt, region, &solution.regions()[region.index()], solution.constants()).unwrap()
                    };
                    let (now, found) = (of(&last.solution), of(&next.solution));
                    assert_eq!(now.len(), found.len(), "{edition}, {tension} N");
                    let RegionGuess { mesh, states } = &guess.regions[region.index()];
                    let beyond = beyond_threshold(&last.belt, region, &states.concat(), &guess.constants).unwrap();
                    let expected = zeros(mesh, &beyond);
                    for (now, found) in now.iter().zip(&found) {
                        let (miss, way) = (nearest(&expected, *found), (found - now).abs());
                        assert!(miss < 0.25 * way + 1e-3, "{edition}, {tension} N: {now} {found} {expected:?}");
                    }
                }
                let warm = solve_from(&last, &case(edition, tension), &options).unwrap();
                assert!(warm.stats.newton_iterations <= 6 && warm.continuation_steps == 1, "{:?}", warm.stats);
            }
        }
    }
}
