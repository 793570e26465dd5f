//! Branch points on finer meshes.
//!
//! The mesh of a branch resolves its solutions; at a branch point, what bifurcates there has to be resolved as well.
//! Along a trivial solution, which asks for no mesh, a buckling load would be as exact as the mesh of the guess makes
//! it. Where the determinant vanishes is therefore sought on halved intervals, too, until the parameter there settles.

use super::location::{Known, Polynomial};
use super::near::are_alike;
use super::places::{DISTANCE, SETTLED};
use super::{Advanced, Care, Reference, Tracer};
use crate::error::SolveError;
use crate::orientation::Determinant;
use crate::solution::Solution;
use crate::start::{self, Start};

/// Times that all intervals are halved at most.
pub(super) const HALVINGS: usize = 6;
/// What is left of the error on a halved mesh is the last change over this at most: the methods' orders are four and
/// more, for which it is a fifteenth of it.
pub(super) const SHRINKS: f64 = 8.0;
/// A place is settled that changes by no more than this part of the tolerance.
const NEGLIGIBLE: f64 = 1e-2;
/// Looks for one place at most.
const LOOKS: usize = 16;
/// A finer mesh may move a branch point by so much of arclength, or by a step that is longer.
pub(super) const REACH: f64 = 0.1;
/// Two branch points that are close may be one on either side of where they are sought. On a finer mesh the determinant
/// rises or falls through the same one as on the coarser, and not with much less than its slope there.
const FLATTEST: f64 = 0.1;

/// Where it is steeper than this part of that slope, secants would come nearer to the zero by halves only.
const STEEPEST: f64 = 4.0;
/// The determinant is looked at from as far as in a step of this length at least: nearer to its zero, it is rounding.
const NEAREST: f64 = 0.01;
/// It is looked at from so many times as far where Newton's iteration ends in rounding.
const FARTHER: [f64; 3] = [1.0, 10.0, 100.0];
/// The last two looks are no farther from each other than this many times what the last is from the zero.
const WIDEST: f64 = 3.0;
/// Where two looks do not tell in which direction it lies, the third is so far from the first, in parts of the step.
const FAR: f64 = 1e-2;

/// The determinant at one place beside a branch point.
struct Look {
    at: f64,
    /// Relative to that of the point where the step begins.
    value: f64,
    advanced: Advanced,
}

/// What is found at the first of the distances [`FARTHER`] at which something is, or why nothing is at the last.
fn farther<T>(mut look: impl FnMut(f64) -> Result<T, SolveError>) -> Result<T, SolveError> {
    let mut outcome = Err(SolveError::Cancelled);
    for farther in FARTHER {
        outcome = look(farther);
        if outcome.as_ref().map_or_else(SolveError::is_interruption, |_| true) {
            break;
        }
    }
    outcome
}

impl Tracer<'_, '_> {
    /// A branch point as exact as the tolerance asks, and its place: of one that leaves the step, the end of the step,
    /// for points are told in their order.
    pub(super) fn settled(
        &mut self,
        (here, step): (&Reference, f64),
        (mut place, mut point): (f64, Reference),
        slope: f64,
    ) -> Result<(f64, Reference), SolveError> {
        let tolerance = self.location_tolerance(&point);
        for _ in 0..HALVINGS {
            if !self.can_be_halved(&point) {
                break;
            }
            let finer = match self.finer((here, step), (place, &point), slope, tolerance) {
                Err(cause) if cause.is_interruption() => return Err(cause),
                Ok(Some(finer)) => finer,
                Ok(None) => {
                    point.is_settled = true;
                    break;
                }
                Err(_) => {
                    // Two that a coarse mesh has apart may be one. If they are not, what was found on it stands.
                    if let Some((at, touching)) = self.settled_as_touch((here, step), (place, &point))? {
                        (place, point) = (at, touching);
                    }
                    break;
                }
            };
            let change = (finer.1.value(self.parameter) - point.value(self.parameter)).abs();
            (place, point) = finer;
            if change <= SHRINKS * tolerance {
                point.is_settled = true;
                break;
            }
        }
        Ok((place.clamp(0.0, step), point))
    }

    /// How exact the parameter of a branch point is to be.
    pub(super) fn location_tolerance(&self, point: &Reference) -> f64 {
        let scale = self.problem.layout().constants[self.parameter].scale.unwrap_or(1.0);
        self.options.solve.tolerance * point.value(self.parameter).abs().max(scale)
    }

    /// A change of arclength that is of no account for a branch point: the tolerance is about a relative change.
    pub(super) fn settled_distance(&self) -> f64 {
        NEGLIGIBLE * self.options.solve.tolerance
    }

    /// Whether a point's mesh may have twice its intervals.
    pub(super) fn can_be_halved(&self, point: &Reference) -> bool {
        let most = point.solution.regions().iter().map(|region| 2 * region.intervals()).max();
        most.is_some_and(|most| most <= self.options.solve.max_intervals)
    }

    /// The branch point on halved intervals; none if the coarser mesh has it to the tolerance. An error if it is not
    /// found.
    fn finer(
        &mut self,
        (here, step): (&Reference, f64),
        (place, point): (f64, &Reference),
        slope: f64,
        tolerance: f64,
    ) -> Result<Option<(f64, Reference)>, SolveError> {
        let found = self.place_on_halved((here, step), (place, point), slope)?;
        let Some((finer, look)) = found else { return Err(SolveError::Astray { at: point.value(self.parameter) }) };
        let near = look.advanced.near(look.at);
        let parameter = near.point.moved(near.speed * (finer - near.at)).constants[self.parameter];
        if (parameter - point.value(self.parameter)).abs() <= tolerance {
            return Ok(None);
        }
        let judged = match self.advance_from(here, look.at, (near, None), Care::Between) {
            Err(cause) if cause.is_interruption() => return Err(cause),
            Ok(judged) if are_alike(&judged.point, near.point) => judged,
            // Beside a branch point rounding looks like a large error, which no mesh makes smaller. What was small
            // enough on the coarser mesh is so on the finer.
            _ => {
                let mut judged = look.advanced;
                let Solution { error_estimate, accuracy, .. } = point.solution;
                judged.point.solution = Solution { error_estimate, accuracy, ..judged.point.solution };
                judged
            }
        };
        Ok(Some((finer, self.moved(&judged.point, judged.speed * (finer - look.at))?)))
    }

    /// The point of the branch on halved intervals at some distance from one that is known.
    pub(super) fn on_halved(
        &mut self,
        (here, reach): (&Reference, f64),
        (place, point): (f64, &Reference),
        beside: f64,
    ) -> Result<Advanced, SolveError> {
        let mut guess = point.moved(beside);
        guess.constants.push(place + beside);
        let halved = start::halved(&Start::from(&guess));
        let found = self.advance_with(here, halved, Care::Glance)?;
        self.between(found, point.solution.constants(), reach)
    }

    /// Where the determinant vanishes on halved intervals, by secants from where it does on those of a point; and the
    /// last look beside it.
    fn place_on_halved(
        &mut self,
        (here, step): (&Reference, f64),
        (place, point): (f64, &Reference),
        slope: f64,
    ) -> Result<Option<(f64, Look)>, SolveError> {
        let (beside, reach) = (DISTANCE * step.max(NEAREST), REACH.max(step));
        let expected = point.solution.constants();
        let settled = (SETTLED * step).max(self.settled_distance());
        let unit = here.determinant;
        let (at, first) = farther(|farther| {
            let beside = farther * beside;
            self.on_halved((here, reach), (place, point), beside).map(|found| (place + beside, found))
        })?;
        let mut last = Look::new(&unit, at, first);
        let mut known = vec![last.known()];
        let (mut zero, mut side, mut roughly) = (place, -1.0, None);
        for _ in 0..LOOKS {
            let (at, found) = farther(|farther| {
                let next = zero + side * farther * beside;
                let near = (last.advanced.near(last.at), None);
                let found = self.advance_from(here, next, near, Care::Glance)?;
                self.between(found, expected, reach).map(|found| (next, found))
            })?;
            let look = Look::new(&unit, at, found);
            let (before, secant) = (zero, (look.value - last.value) / (look.at - last.at));
            let is_steep = secant / slope >= FLATTEST;
            known.push(look.known());
            zero = match known[..] {
                _ if is_steep && secant / slope <= STEEPEST => look.at - look.value / secant,
                [.., a, b, c] => look.at + to_zero(&Polynomial::through(&[a, b, c]), look.at, slope),
                _ => place - FAR * step,
            };
            if !zero.is_finite() || (zero - place).abs() > reach {
                return Ok(None);
            }
            // A slope over a longer distance is not that at the zero.
            let is_slope = is_steep && (last.at - look.at).abs() <= WIDEST * (look.at - before).abs();
            if is_slope && (zero - before).abs() <= settled {
                return Ok(Some((zero, look)));
            }
            // What the iteration leaves may move it by more than is negligible, look for look.
            roughly = (is_slope && (zero - before).abs() <= self.options.solve.tolerance).then_some(zero);
            // To the one side and the other, so that the slope is not that between two places that are all but one.
            side = if look.at > before { -1.0 } else { 1.0 };
            last = look;
        }
        Ok(roughly.map(|zero| (zero, last)))
    }
}

impl Look {
    fn new(unit: &Determinant, at: f64, advanced: Advanced) -> Self {
        Self { at, value: advanced.point.determinant.relative(unit), advanced }
    }

    fn known(&self) -> Known {
        Known { at: self.at, value: self.value, slope: None }
    }
}

/// How far it is from a place to where a parabola goes through zero with a slope of this sign; to its extremum, if it
/// does so nowhere.
fn to_zero(parabola: &Polynomial, at: f64, sign: f64) -> f64 {
    let (value, slope, curvature) = parabola.at_with_curvature(at);
    let slope_there = libm::sqrt((slope * slope - 2.0 * curvature * value).max(0.0)).copysign(sign);
    if slope * slope_there > 0.0 { -2.0 * value / (slope + slope_there) } else { (slope_there - slope) / curvature }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_two_zeros_that_with_the_wanted_slope_is_sought() {
        let known = [-0.5, -0.49, 0.7].map(|at| Known { at, value: (at - 1.0) * (at - 3.0), slope: None });
        let parabola = Polynomial::through(&known);
        for at in [-1.0, 0.5, 1.5, 2.5, 4.0] {
            let [falling, rising] = [-2.0, 0.1].map(|slope| at + to_zero(&parabola, at, slope));
            assert!((falling - 1.0).abs() < 1e-10 && (rising - 3.0).abs() < 1e-10, "{at}: {falling}, {rising}");
        }
        let above = Polynomial::through(&known.map(|known| Known { value: known.value + 1.5, ..known }));
        assert!((to_zero(&above, 0.0, 1.0) - 2.0).abs() < 1e-10, "no zero: its extremum");
    }
}
