//! A guess for a drive near one that is solved.

use solver::{Guess, Linearisation, Order, RegionGuess, RegionSolution, Solution, SolveError, Tangent, TangentRegion};

use super::belt::BeltProblem;
use super::moved::drift;
use super::position::Position;
use super::region::RegionId;
use super::start;
use crate::model::{Constant, Constants, Field, State};

/// Cosine of the angle between two steps beyond which the path counts as turning.
const STRAIGHT: f64 = 0.98;
/// A step back, in steps ahead, too short to tell a bend.
const SHORTEST_BACK: f64 = 0.2;
/// Difference quotients along the path take this share of it.
const DIFFERENCE: f64 = 1e-3;
/// Difference quotients in x, m.
const DEPTH: f64 = 1e-6;
/// Share of the tolerance that the defect may have where a node is left out: it grows along the path.
const THINNING: f64 = 0.05;
/// Change of the speed ratio, as a share of it, up to which it is predicted by its logarithm.
const LARGEST_CHANGE: f64 = 0.5;
/// Nodes in a row that may be left out.
const LONGEST_GAP: usize = 7;

/// A piece of the path from one solution to another.
pub(super) struct PathPiece<'a> {
    /// The solution before, if there is one, and where it stands.
    pub before: Option<&'a (Solution, Position)>,
    /// The solution that is left, and where it stands.
    pub from: &'a (Solution, Position),
    /// Where it is to go; unknown constants are not read.
    pub to: &'a Position,
    /// Indices of the unknown constants.
    pub unknowns: &'a [usize],
}

/// The guess at the end of a piece of path: its first solution and the tangent there, bent as the path from the
/// solution before it bends, on as many of its nodes as `tolerance` asks for. The unknown constants follow those of the
/// tight, inextensible belt.
pub(super) fn predicted(belt: &BeltProblem, path: &PathPiece<'_>, tolerance: f64) -> Result<Guess, SolveError> {
    let (from, _) = path.from;
    let curve = Curve::new(belt, path)?;
    let mut guess = Guess::from(from);
    guess.constants = curve.constants();
    for (index, region) in guess.regions.iter_mut().enumerate() {
        region.mesh = curve.places(index, &region.mesh, 1.0);
        region.states = curve.states(index);
    }
    for region in RegionId::ALL.into_iter().filter(|region| region.is_contact()) {
        // A kernel without sliding speed has nothing to lose.
        let _ = curve.adhere(region, &mut guess);
    }
    for (region, part) in guess.regions.iter_mut().zip(from.regions()) {
        thin(region, part, from.order(), THINNING * tolerance);
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
    /// How far the nodes of each region move; empty where they stay. All rates are those seen from there.
    drifts: Vec<Vec<f64>>,
}

/// Where the path came from.
struct Bend<'a> {
    before: &'a Solution,
    constants: &'a Constants,
    back: Tangent,
    /// Square of the length of the step back, in steps ahead.
    square: f64,
}

impl<'a> Curve<'a> {
    fn new(belt: &'a BeltProblem, path: &PathPiece<'a>) -> Result<Self, SolveError> {
        let (from, here) = path.from;
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
        let bend = path.before.and_then(|(before, position)| {
            let square = square_back(belt, here, position, path.to, path.unknowns)?;
            Some(Bend { before, back: tangent(position), constants: &position.drive, square })
        });
        let drifts = vec![Vec::new(); from.regions().len()];
        Ok(Self { belt, from, unknowns: path.unknowns, here: &here.drive, to, ahead, bend, drifts }.moving())
    }

    /// This path, seen from places that move with the kinks of friction.
    fn moving(mut self) -> Self {
        let Some(bend) = &mut self.bend else { return self };
        let back = bend.square.sqrt();
        for region in RegionId::ALL.into_iter().filter(|region| region.is_contact()) {
            let index = region.index();
            let (Some(then), Some(now)) = (bend.before.regions().get(index), self.from.regions().get(index)) else {
                continue;
            };
            let (then, here) = ((then, bend.before.constants()), (now, self.from.constants()));
            if let Some(drift) = drift(self.belt, region, then, here, back) {
                follow(now, &drift, 1.0, self.ahead.regions.get_mut(index));
                follow(now, &drift, -back, bend.back.regions.get_mut(index));
                self.drifts[index] = drift;
            }
        }
        self
    }

    /// Where the nodes of a region are so many steps ahead.
    fn places(&self, region: usize, mesh: &[f64], steps: f64) -> Vec<f64> {
        let drift = self.drifts.get(region).filter(|drift| drift.len() == mesh.len());
        drift.map_or_else(|| mesh.to_vec(), |drift| sum(mesh, steps, drift))
    }

    /// The states of a region at the solution before, where its nodes were.
    fn then(&self, region: usize, mesh: &[f64]) -> Option<Vec<Vec<f64>>> {
        let bend = self.bend.as_ref()?;
        Some(then(bend.before, region, &self.places(region, mesh, -bend.square.sqrt())))
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
                *value += (then - now - back) / bend.square;
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
                (rest - tight.bend(constant, scale)) / bend.square
            });
            let moved = scale.to(value) + scale.rate(value, rate(&self.ahead));
            scale.from(moved + ahead.bend(constant, scale) + second)
        };
        Constant::ALL.into_iter().map(constant).chain(self.to.targets.iter().copied()).collect()
    }

    /// Where the belt adheres, its sliding speed is the tiny difference of two large ones, and friction hangs on it: so
    /// the tangential sliding speed is what is predicted, and the penetration is what gives that.
    fn adhere(&self, region: RegionId, guess: &mut Guess) -> Option<()> {
        let index = region.index();
        let x = self.belt.kernel(region).state(State::Penetration)?;
        let sliding = |constants: &[f64], states: &[Vec<f64>]| {
            self.belt.field(region, Field::TangentialSlidingSpeed, &states.concat(), constants)
        };
        let part = self.from.regions().get(index)?;
        let states = RegionGuess::from(part).states;
        let rate = |tangent: &Tangent| {
            let rates = &tangent.regions.get(index)?.states;
            let moved = |h: f64| {
                let states: Vec<Vec<f64>> = states.iter().zip(rates).map(|(y, rate)| sum(y, h, rate)).collect();
                sliding(&sum(&self.here.0, h, &tangent.constants), &states)
            };
            let (a, b) = (moved(-DIFFERENCE)?, moved(DIFFERENCE)?);
            Some(a.iter().zip(&b).map(|(a, b)| (b - a) / (2.0 * DIFFERENCE)).collect::<Vec<f64>>())
        };
        let now = sliding(&self.here.0, &states)?;
        let bend = self.bend.as_ref();
        let then = bend.and_then(|bend| sliding(&bend.constants.0, &self.then(index, part.mesh())?));
        let back = bend.and_then(|bend| rate(&bend.back));
        let wanted = self.extrapolated(&now, &rate(&self.ahead)?, then.as_deref(), back.as_deref());

        let Guess { regions, constants } = guess;
        let states = &mut regions.get_mut(index)?.states;
        let found = sliding(constants, states)?;
        states.get_mut(x)?.iter_mut().for_each(|x| *x += DEPTH);
        let deeper = sliding(constants, states)?;
        for (((x, wanted), found), deeper) in states.get_mut(x)?.iter_mut().zip(&wanted).zip(&found).zip(&deeper) {
            *x += DEPTH * ((wanted - found) / (deeper - found) - 1.0);
        }
        Some(())
    }
}

/// The states of a region of another solution at some places.
fn then(before: &Solution, region: usize, places: &[f64]) -> Vec<Vec<f64>> {
    let Some(part) = before.regions().get(region) else { return Vec::new() };
    part.eval_many(places).chunks_exact(places.len().max(1)).map(<[f64]>::to_vec).collect()
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

fn sum(a: &[f64], h: f64, b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a + h * b).collect()
}

/// Square of the length of the step back, in steps ahead; `None` if the path turns here or the step was too short.
fn square_back(belt: &BeltProblem, here: &Position, back: &Position, to: &Position, unknowns: &[usize]) -> Option<f64> {
    let (mut ahead, mut behind, mut product) = (0.0, 0.0, 0.0);
    let moves = here.vector().into_iter().zip(here.magnitudes(belt)).zip(back.vector().into_iter().zip(to.vector()));
    for (_, ((here, size), (back, to))) in moves.enumerate().filter(|(at, _)| !unknowns.contains(at)) {
        let (a, b) = ((to - here) / size, (back - here) / size);
        (ahead, behind, product) = (ahead + a * a, behind + b * b, product + a * b);
    }
    let square = behind / ahead;
    (product < -STRAIGHT * (ahead * behind).sqrt() && square > SHORTEST_BACK * SHORTEST_BACK).then_some(square)
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

/// The scale on which a constant is predicted.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Scale {
    Linear,
    Logarithmic,
}

impl Scale {
    /// The speed ratio is predicted by its logarithm; unless it goes to nothing, as where the secondary comes to rest,
    /// or begins there.
    fn of(constant: Constant, value: f64, change: f64) -> Self {
        let proportional = constant == Constant::SpeedRatio && change.abs() < LARGEST_CHANGE * value;
        if proportional { Self::Logarithmic } else { Self::Linear }
    }

    fn to(self, value: f64) -> f64 {
        match self {
            Self::Linear => value,
            Self::Logarithmic => libm::log(value),
        }
    }

    fn from(self, scaled: f64) -> f64 {
        match self {
            Self::Linear => scaled,
            Self::Logarithmic => libm::exp(scaled),
        }
    }

    /// A rate of change on this scale.
    fn rate(self, value: f64, rate: f64) -> f64 {
        match self {
            Self::Linear => rate,
            Self::Logarithmic => rate / value,
        }
    }
}

/// Leaves out the nodes of a region that its solution can do without, wherever they have moved to: see [`kept`].
fn thin(region: &mut RegionGuess, part: &RegionSolution, order: Order, limit: f64) {
    let kept = kept(part, order.defect_exponent(), limit);
    let pick = |values: &[f64]| kept.iter().filter_map(|&node| values.get(node).copied()).collect();
    region.mesh = pick(&region.mesh);
    region.states = region.states.iter().map(|values| pick(values)).collect();
}

/// The nodes of a region without those whose intervals, as one, would still have a defect of no more than `limit`.
/// Along a path the kinks of friction move, and leave their fine meshes behind.
fn kept(part: &RegionSolution, exponent: u32, limit: f64) -> Vec<usize> {
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
    use solver::Options;

    #[test]
    fn nodes_are_left_out_that_are_not_missed() {
        let fine = SolveOptions { tolerance: 1e-6, ..SolveOptions::default() };
        let solved = solve(&Case::default().resolve().unwrap(), &fine).unwrap();
        let unknowns: Vec<usize> = (0..Constant::UNKNOWN).collect();
        let options = Options { tolerance: 1e-3, ..Options::default() };
        // Intervals that are left, and meshes that it takes from there.
        let solve_without = |limit: f64| {
            let mut guess = Guess::from(&solved.solution);
            for (region, part) in guess.regions.iter_mut().zip(solved.solution.regions()) {
                thin(region, part, solved.solution.order(), limit);
            }
            let intervals: usize = guess.regions.iter().map(|region| region.mesh.len() - 1).sum();
            (intervals, solver::solve(&solved.belt, &guess, &unknowns, &options).unwrap().history().len())
        };
        let all = solved.solution.intervals();
        assert_eq!(solve_without(-1.0).0, all);
        let (intervals, meshes) = solve_without(THINNING * options.tolerance);
        assert!(4 * intervals < 3 * all && meshes == 1, "{intervals} of {all} intervals, {meshes} meshes");
        let (intervals, meshes) = solve_without(100.0 * options.tolerance);
        assert!(meshes > 1, "{intervals} of {all} intervals, {meshes} meshes");
    }
}
