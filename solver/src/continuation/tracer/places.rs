//! The places between two points of a branch where it folds, branches, meets an event or ends.

use super::location::{Known, Polynomial, Search, Sought};
use super::near::{Span, are_alike};
use super::{Advanced, Care, Crossing, Near, Tracer};
use crate::collocation::plan::Plan;
use crate::continuation::arclength::Reference;
use crate::continuation::branch::PointKind;
use crate::error::SolveError;
use crate::guess::{Guess, RegionGuess};
use crate::orientation::Determinant;
use crate::run::Run;
use crate::solution::Solution;
use crate::start::{self, Start};

/// What is located is located to this part of the step.
const LOCATION: f64 = 1e-10;
/// Looks for one place at most,
const LOOKS: usize = 48;
/// of which no more than so many are told by polynomials: the others are enough to find it by halves.
const BY_POLYNOMIALS: usize = 12;
/// A place that moves no more is that of a zero if the function is no more than this part of what it is at the ends of
/// the step.
const FALLEN: f64 = 1e-3;
/// A function that has grown by so much where it changes its sign has a pole there.
const GROWN: f64 = 10.0;
/// At a branch point the matrix is singular, and beside it nearly so, where Newton's iteration ends in rounding. It is
/// looked at from so far, in parts of the step: to one side and the other, and farther off if need be,
const BESIDE: [f64; 4] = [1.0, -1.0, 10.0, -10.0];
pub(super) const DISTANCE: f64 = 1e-4;
/// until its place changes by no more than this, or would change by no more than [`LOCATION`] if the change shrank once
/// more as it has: it shrinks faster. The next change would be smaller by as much as the distance is.
pub(super) const SETTLED: f64 = 1e-8;
/// There the determinant is no more than this part of what it is at the ends of the step.
const VANISHED: f64 = 0.05;
/// After a change of place by so little, in parts of the step, the next look is expected to be the last; those before
/// are glances.
const NEARLY: f64 = 1e-3;
/// Two folds are looked for in a step along which the parameter goes back by more than about so many times what it is
/// exact to.
const DIP: f64 = 4.0;

/// Which of the ends of a step has the mesh that the other is to have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Onto {
    First,
    Last,
}

/// Whether the determinant changes its sign along a step.
fn is_crossed(span: Span<'_>) -> bool {
    let [a, b] = [span.first.point, &span.next.point].map(|point| point.determinant.orientation);
    a.is_some() && b.is_some() && a != b
}

impl Tracer<'_, '_> {
    /// A place between two points that are `step` apart, not far from the line between them; with care where a glance
    /// fails.
    pub(super) fn look(
        &mut self,
        span: Span<'_>,
        at: f64,
        near: (Near<'_>, Option<Near<'_>>),
        care: Care,
    ) -> Result<Advanced, SolveError> {
        let Span { here, step, next, .. } = span;
        let outcome = match self.advance_from(here, at, near, care) {
            Err(cause) if care == Care::Glance && !cause.is_interruption() => {
                self.advance_from(here, at, near, Care::Between)
            }
            outcome => outcome,
        };
        let constants = here.solution.constants().iter().zip(next.point.solution.constants());
        let line: Vec<f64> = constants.map(|(a, b)| a + at / step * (b - a)).collect();
        outcome.and_then(|found| self.between(found, &line, step))
    }

    /// Zero of the watched function, or where it jumps to the other sign, and the point there if it is not the next;
    /// none if an event's function has a pole there. Each look is predicted from the nearest that is known.
    pub(super) fn locate(
        &mut self,
        before: Option<&(f64, Reference)>,
        here: &Reference,
        step: f64,
        next: &Advanced,
        crossing: &Crossing,
    ) -> Result<Option<(f64, Option<Reference>)>, SolveError> {
        let (kind, span) = (crossing.kind, Span::new(here, step, next));
        if kind == PointKind::BranchPoint {
            let (mut at, mut point, slope) = self.locate_branch_point(before, span)?;
            if self.options.settle_branch_points {
                (at, point) = self.settled((here, step), (at, point), slope)?;
            }
            return Ok(Some((at, Some(point))));
        }
        if self.watched(kind, &next.point) == 0.0 {
            return Ok(Some((step, None)));
        }
        let mut search = self.search(kind, before, span);
        let mut seen: Vec<(f64, Advanced)> = Vec::new();
        let (first, last) = (crossing.values.0.abs(), crossing.values.1.abs());
        let mut at = search.next();
        let mut by_halves = false;
        for look in 1..=LOOKS {
            let near = span.around(&seen, at);
            let found = self.look(span, at, near, Care::Between)?;
            let usable = search.add(self.known(kind, found.near(at), here));
            let value = self.watched(kind, &found.point).abs();
            seen.push((at, found));
            if !usable || value <= LOCATION * (first + last) || search.length() <= LOCATION * step {
                break;
            }
            by_halves |= search.is_slow() || look >= BY_POLYNOMIALS;
            if !by_halves {
                let before = std::mem::replace(&mut at, search.next());
                if (at - before).abs() > LOCATION * step {
                    continue;
                }
                if value <= FALLEN * (first + last) {
                    break;
                }
                by_halves = true;
            }
            at = search.middle();
        }
        let size = |(_, found): &(f64, Advanced)| self.watched(kind, &found.point).abs();
        let is_event = matches!(kind, PointKind::Event(_));
        let ends = search.ends();
        let found = seen.into_iter().filter(|(at, _)| ends.contains(at));
        // The later of equal ones.
        let best = found.rev().min_by(|a, b| size(a).total_cmp(&size(b)));
        match best {
            Some(best) if is_event && size(&best) > GROWN * first.max(last) => Ok(None),
            Some((at, found)) => Ok(Some((at, Some(found.point)))),
            // Not even the first look has a value, as only an event's function may not.
            None if is_event => Ok(None),
            None => Err(SolveError::Cancelled),
        }
    }

    /// Where the determinant vanishes, looked at from beside it, and the point there: that nearest to it, moved along
    /// its direction; and the slope of the determinant, relative to that at `here`.
    ///
    /// All looks are on one mesh. On a mesh that resolves the branch, but not what bifurcates, the determinant vanishes
    /// elsewhere than on another.
    fn locate_branch_point(
        &mut self,
        before: Option<&(f64, Reference)>,
        span: Span<'_>,
    ) -> Result<(f64, Reference, f64), SolveError> {
        if span.has_one_mesh() {
            return self.locate_on_its_mesh(before, span);
        }
        // The later mesh is that of the next step.
        let first = self.remeshed(span, Onto::Last)?;
        let later = span.from(&first);
        if is_crossed(later) {
            return self.locate_on_its_mesh(None, later);
        }
        let last = self.remeshed(span, Onto::First)?;
        let earlier = span.to(&last);
        if is_crossed(earlier) {
            return self.locate_on_its_mesh(before, earlier);
        }
        // On the one mesh it lies before the step, on the other after it: at either end it may be told, which is where
        // the meshes that settle it begin. It is the finer mesh that is nearer to the truth.
        let intervals = |point: &Reference| point.solution.intervals();
        let is_later = intervals(&span.next.point) >= intervals(span.here);
        let (at, end, point) = if is_later { (0.0, later, &first.point) } else { (span.step, earlier, &last.point) };
        let unit = span.here.determinant;
        let values = |of: Span<'_>| [of.first.point, &of.next.point].map(|point| point.determinant.relative(&unit));
        let slope = |[a, b]: [f64; 2]| (b - a) / span.step;
        let (wanted, along) = (slope(values(span)), slope(values(end)));
        let slope = if along * wanted > 0.0 { along } else { wanted };
        Ok((at, self.moved(point, 0.0)?, slope))
    }

    /// The same, of a step both of whose ends are on the same mesh.
    fn locate_on_its_mesh(
        &mut self,
        before: Option<&(f64, Reference)>,
        span: Span<'_>,
    ) -> Result<(f64, Reference, f64), SolveError> {
        let Span { here, step, next, .. } = span;
        let kind = PointKind::BranchPoint;
        let mut search = self.search(kind, before.filter(|(_, point)| are_alike(point, &next.point)), span);
        let mut seen: Vec<(f64, Advanced)> = Vec::new();
        // What is judged may need a finer mesh for that: beside a branch point, rounding looks like a large error.
        let mut judged: Option<(f64, Advanced)> = None;
        let (mut place, mut care, mut change, mut settled) = (search.next(), Care::Glance, step, false);
        for _ in 0..LOOKS {
            let side = search.roomier(place);
            let mut outcome = Err(SolveError::Cancelled);
            for beside in BESIDE {
                let at = (place + side * beside * DISTANCE * step).clamp(0.0, step);
                let near = span.around(&seen, at);
                outcome = match self.look(span, at, near, care) {
                    Ok(found) if !are_alike(&found.point, &next.point) => {
                        judged = Some((at, found));
                        // Glances find the place, once they have nothing more to be judged by.
                        care = Care::Glance;
                        Err(SolveError::Astray { at: here.value(self.parameter) })
                    }
                    outcome => outcome.map(|found| (at, found)),
                };
                match &outcome {
                    Err(cause) if !cause.is_interruption() => {}
                    _ => break,
                }
            }
            let (at, found) = match outcome {
                Err(cause) if cause.is_interruption() || judged.is_none() => return Err(cause),
                Err(_) => break,
                Ok(found) => found,
            };
            let usable = search.add(self.known(kind, found.near(at), here));
            let is_judged = found.judged || judged.is_some();
            seen.push((at, found));
            let before = place;
            place = search.next();
            let last = std::mem::replace(&mut change, (place - before).abs());
            let expected = change * (change / last).min(1.0);
            settled = is_judged && (!usable || change <= SETTLED * step || expected <= LOCATION * step);
            if settled {
                break;
            }
            if judged.is_none() && (!usable || change <= NEARLY * step) {
                care = Care::Between;
            }
        }
        if !settled {
            // What the iteration leaves moves it from look to look, and the next place may be half of the bracket.
            place = search.secant().0;
        }
        // Between two pieces of the branch the determinant may change its sign without a zero.
        let value = |point: &Reference| point.determinant.relative(&here.determinant);
        let (nearest, _) = span.around(&seen, place);
        if value(nearest.point).abs() > VANISHED * value(span.first.point).abs().max(value(&next.point).abs()) {
            return Err(SolveError::Astray { at: nearest.point.value(self.parameter) });
        }
        let slope = match nearest.at - place {
            0.0 => search.secant().1,
            distance => value(nearest.point) / distance,
        };
        seen.extend(judged);
        if seen.iter().any(|(_, found)| found.judged) {
            seen.retain(|(_, found)| found.judged);
        }
        let (near, _) = Span::new(here, step, next).around(&seen, place);
        Ok((place, self.moved(near.point, near.speed * (place - near.at))?, slope))
    }

    /// One end of a step, on the mesh of the other.
    pub(super) fn remeshed(&mut self, span: Span<'_>, onto: Onto) -> Result<Advanced, SolveError> {
        let (at, point, mesh_of) = match onto {
            Onto::Last => (0.0, span.here, &span.next.point),
            Onto::First => (span.step, &span.next.point, span.here),
        };
        let meshes = point.solution.regions().iter().zip(mesh_of.solution.regions());
        let regions = meshes.map(|(from, onto)| {
            let mesh = onto.mesh().to_vec();
            RegionGuess { states: from.eval_along(&mesh), mesh }
        });
        let mut constants = point.solution.constants().to_vec();
        constants.push(at);
        let start = Start::from(&Guess { regions: regions.collect(), constants });
        let found = self.advance_with(span.here, start, Care::Glance)?;
        self.between(found, point.solution.constants(), span.step)
    }

    /// A place between two folds in a step: where the parameter goes back fastest, by the cubic that has its values and
    /// rates at both ends, if it goes in one direction there and in the other between by more than it is exact to.
    pub(super) fn between_folds(&self, here: &Reference, step: f64, next: &Advanced) -> Option<f64> {
        let ends = [Near { point: here, at: 0.0, speed: 1.0 }, next.near(step)];
        let cubic = Polynomial::through(&ends.map(|end| self.known(PointKind::Fold, end, here)));
        let [first, last] = [0.0, step].map(|at| cubic.at_with_curvature(at));
        // The curvature of a cubic is linear.
        let place = step * first.2 / (first.2 - last.2);
        let back = cubic.at(place).1;
        let goes_back = first.1 * last.1 > 0.0 && place > 0.0 && place < step && back * first.1 < 0.0;
        let exact = self.location_tolerance(&next.point).max(self.location_tolerance(here));
        (goes_back && !here.is_crossing && back.abs() * step > DIP * exact).then_some(place)
    }

    fn search(&self, kind: PointKind, before: Option<&(f64, Reference)>, span: Span<'_>) -> Search {
        let Span { here, step, next, .. } = span;
        let sought = if kind == PointKind::Fold { Sought::Extremum } else { Sought::Zero };
        let first = self.known(kind, span.first, here);
        let last = self.known(kind, next.near(step), here);
        // The distance goes on behind the step as far as the inner products of both points are alike.
        let before = before.filter(|_| first.slope.is_none());
        let before = before.map(|(step, point)| self.known(kind, Near { point, at: -step, speed: 1.0 }, here));
        Search::new(sought, before.filter(|before| before.value.is_finite()), [first, last])
    }

    /// What is known of a watched function at a point. Folds are extrema of the parameter.
    fn known(&self, kind: PointKind, Near { point, at, speed }: Near<'_>, here: &Reference) -> Known {
        let slope = speed * point.direction.constants[self.parameter];
        match kind {
            PointKind::Fold => Known { at, value: point.value(self.parameter), slope: Some(slope) },
            PointKind::End => {
                let (low, high) = self.options.range;
                let value = point.value(self.parameter);
                let sign = if low - value > value - high { -1.0 } else { 1.0 };
                Known { at, value: self.watched(kind, point), slope: Some(sign * slope) }
            }
            PointKind::BranchPoint => Known { at, value: point.determinant.relative(&here.determinant), slope: None },
            _ => Known { at, value: self.watched(kind, point), slope: None },
        }
    }

    /// A point moved along its direction by so little that it is a solution still.
    pub(super) fn moved(&mut self, point: &Reference, by: f64) -> Result<Reference, SolveError> {
        self.as_it_stands(point, &point.moved(by))
    }

    /// What differs so little from a point that it is a solution still.
    pub(super) fn as_it_stands(&mut self, point: &Reference, guess: &Guess) -> Result<Reference, SolveError> {
        let plan = Plan::new(self.problem.layout(), self.unknowns);
        let mut run = Run::new(self.problem, plan, &self.path_options, self.observer, self.budget);
        let start = start::near(&point.solution, &point.inner, guess);
        let moved = run.as_it_stands(start)?;
        self.stats += run.stats;
        drop(run);
        let Solution { error_estimate, accuracy, branch_check, .. } = point.solution;
        let solution = Solution { error_estimate, accuracy, branch_check, ..moved };
        Ok(Reference::new(solution, point.direction.clone(), Determinant::UNKNOWN))
    }
}
