//! Steps along a branch: predictor, corrector, step length; folds and events between two points.

mod crossing;
mod end;
mod finer;
mod location;
mod near;
mod places;
mod resolution;
mod touching;

use super::arclength::{Arclength, Direction, Reference, constant_squares, normalise};
use super::branch::{Branch, BranchError, BranchOptions, BranchPoint, EventFunction, PointKind};
use super::checkpoint::Checkpoint;
use crate::budget::Budget;
use crate::collocation::plan::Plan;
use crate::error::SolveError;
use crate::guess::Guess;
use crate::linearisation::{Linearisation, Tangent};
use crate::observer::{Event, Observer};
use crate::options::{Options, positive};
use crate::orientation::{BranchCheck, Determinant};
use crate::problem::Problem;
use crate::run::Run;
use crate::solution::Solution;
use crate::solve::{check, solve_within};
use crate::start::{self, Start};
use crate::stats::Stats;
use near::{Near, Span};
use places::Onto;
use resolution::{Passed, Resolved};

/// One tracing: what it was asked, and what it has found.
pub(super) struct Tracer<'a, 'e> {
    problem: &'a dyn Problem,
    parameter: usize,
    unknowns: &'a [usize],
    /// The unknowns and the parameter.
    extended: Vec<usize>,
    options: &'a BranchOptions,
    path_options: Options,
    events: &'a [EventFunction<'e>],
    observer: &'a mut dyn Observer,
    budget: &'a Budget,
    stats: Stats,
    points: Vec<BranchPoint>,
    check: BranchCheck,
}

/// A zero of one of the watched functions lies between two points.
struct Crossing {
    kind: PointKind,
    /// Values at both points.
    values: (f64, f64),
}

/// What is asked of a solution on the branch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Care {
    /// A point of the branch, on meshes of its own: finer or coarser ones, as its defects ask.
    Step,
    /// One between two points, which it is compared with: on their mesh, if that will do.
    Between,
    /// What the collocation equations of that mesh say, without a look at its defects.
    Glance,
}

/// A point found at some distance from another.
struct Advanced {
    point: Reference,
    /// False after a glance: its error is not known.
    judged: bool,
    /// How fast it moves along its direction as the distance grows.
    speed: f64,
    /// Newton's first contraction.
    contraction: f64,
    check: BranchCheck,
}

/// A step.
struct Stepped {
    next: Advanced,
    /// Whether there is a branch point before its end.
    crossed: bool,
    /// The determinant where it begins on the mesh of its end, if that is what the determinant is known by.
    remeshed: Option<Determinant>,
    /// By how much the next may be longer for the determinant to be known along it.
    longer: f64,
    /// What is special on the way, as far as the range goes: kind, distance, and the point, if it is not the end.
    located: Vec<(PointKind, f64, Option<Reference>)>,
}

/// What makes a step shorter where it is found, until it has done so often enough.
#[derive(Debug, Clone, Copy)]
struct Wary {
    /// That the iteration has not gone straight to the step's end: see [`BranchOptions::largest_contraction`].
    of_straying: bool,
    /// That there are two folds on the way.
    of_folds: bool,
}

/// Why a step is to be shorter.
enum Rejected {
    /// It failed, or a special point of it could not be located.
    Failed(SolveError),
    /// What it led to is far from where it began.
    Far,
    /// The determinant is not known along it, or has more zeros than one, or the parameter turns round twice: the
    /// length that it is to have.
    Unresolved(f64),
}

impl From<SolveError> for Rejected {
    fn from(cause: SolveError) -> Self {
        Self::Failed(cause)
    }
}

/// So often in a row a step is halved whose first correction has not contracted: if it still does not, contractions
/// tell nothing.
const SHORTENED: usize = 2;
/// So often in a row a step is made shorter for the determinant or for folds: where the right-hand side has a kink, the
/// determinant jumps.
const RESOLVED: usize = 12;
/// A parameter whose rates along the branch are smaller than this part of its range stands still: where they are
/// rounding, they change their sign without a fold.
const STILL: f64 = 1e-9;

impl<'a, 'e> Tracer<'a, 'e> {
    pub(super) fn new(
        problem: &'a dyn Problem,
        parameter: usize,
        unknowns: &'a [usize],
        options: &'a BranchOptions,
        events: &'a [EventFunction<'e>],
        observer: &'a mut dyn Observer,
        budget: &'a Budget,
    ) -> Self {
        let mut extended = unknowns.to_vec();
        extended.push(parameter);
        let path_options = Options { rescues: 0, max_iterations: options.max_iterations, ..options.solve.clone() };
        let stats = Stats::default();
        let points = Vec::new();
        Self {
            problem,
            parameter,
            unknowns,
            extended,
            options,
            path_options,
            events,
            observer,
            budget,
            stats,
            points,
            check: BranchCheck::Kept,
        }
    }

    /// Traces from where `start` says: point, arclength and first step.
    pub(super) fn run(
        mut self,
        start: impl FnOnce(&mut Self) -> Result<(Reference, f64, f64), SolveError>,
    ) -> Result<Branch, BranchError> {
        let traced = start(&mut self).and_then(|(here, arclength, step)| self.trace(here, arclength, step));
        match traced {
            Ok(()) => Ok(Branch { points: self.points, stats: self.stats, check: self.check }),
            Err(cause) => Err(BranchError { points: self.points, cause: Box::new(cause) }),
        }
    }

    fn trace(&mut self, mut here: Reference, mut arclength: f64, mut step: f64) -> Result<(), SolveError> {
        self.push(PointKind::Regular, arclength, &here);
        let mut previous: Option<(f64, Reference)> = None;
        let mut passed = Passed::default();
        let (mut shortened, mut unresolved) = (0, 0);
        while self.points.len() < self.options.max_points {
            let resolves = self.options.branch_points && self.options.resolve_branch_points;
            let known = (resolves && unresolved < RESOLVED).then_some(&passed);
            let wary = Wary { of_straying: shortened < SHORTENED, of_folds: unresolved < RESOLVED };
            let stepped = self.step((previous.as_ref(), known), (arclength, &here), step, wary);
            let Stepped { next, crossed, remeshed, longer, located } = match stepped {
                Ok(stepped) => stepped,
                Err(Rejected::Failed(cause)) if cause.is_interruption() => return Err(cause),
                Err(rejected) => {
                    match rejected {
                        Rejected::Unresolved(shorter) => {
                            step = shorter;
                            unresolved += 1;
                        }
                        Rejected::Far => {
                            step *= 0.5;
                            shortened += 1;
                        }
                        Rejected::Failed(cause) => {
                            if 0.5 * step < self.options.smallest_step {
                                return match self.reached_end(&here, step)? {
                                    Some(end) => {
                                        self.end(arclength, &here, &end);
                                        Ok(())
                                    }
                                    None => Err(cause),
                                };
                            }
                            step *= 0.5;
                        }
                    }
                    self.announce(&Event::Rejected { lambda: here.value(self.parameter) })?;
                    continue;
                }
            };
            (shortened, unresolved) = (0, 0);
            if remeshed.is_some() {
                passed = Passed::default();
            }
            passed.push(arclength, remeshed.unwrap_or(here.determinant));
            // The sense of the first step is given, so that a branch point is told from one that is crossed.
            let [before, after] = [&here, &next.point].map(|point| point.determinant.orientation);
            let turned = if crossed { next.check } else { next.check.across(before, after) };
            self.check = self.check.and(turned.placed(next.point.value(self.parameter)));
            for (kind, at, found) in located {
                self.push(kind, arclength + at, found.as_ref().unwrap_or(&next.point));
                if kind == PointKind::End || self.options.stop_at.contains(&kind) {
                    return Ok(());
                }
            }
            arclength += step;
            let Advanced { point: next, contraction, .. } = next;
            self.push(PointKind::Regular, arclength, &next);
            let g = |theta: f64| (1.0 + 4.0 * theta).sqrt() - 1.0;
            let factor = (g(self.options.contraction) / g(contraction.max(1e-6))).sqrt();
            let longer = (step * factor.min(longer).clamp(0.3, 2.0)).min(self.options.largest_step);
            if self.observer.wants_checkpoints() {
                let (guess, direction) = (Guess::from(&next.solution), Some(next.direction.clone()));
                self.observer.checkpoint(&Checkpoint { position: arclength, step: longer, guess, direction });
            }
            self.announce(&Event::Step { step: self.points.len() - 1, lambda: next.value(self.parameter) })?;
            previous = Some((step, std::mem::replace(&mut here, next)));
            step = longer;
        }
        Ok(())
    }

    /// The point at a distance, and what is special between, if nothing is found that it is `wary` of.
    fn step(
        &mut self,
        (previous, passed): (Option<&(f64, Reference)>, Option<&Passed>),
        (arclength, here): (f64, &Reference),
        step: f64,
        wary: Wary,
    ) -> Result<Stepped, Rejected> {
        let next = self.advance(here, step)?;
        let largest = self.options.largest_contraction;
        let straight = next.contraction <= largest && !matches!(next.check, BranchCheck::Turned { .. });
        if wary.of_straying && largest < f64::INFINITY && !straight && 0.5 * step >= self.options.smallest_step {
            return Err(Rejected::Far);
        }
        if wary.of_folds
            && largest < f64::INFINITY
            && let Some(between) = self.between_folds(here, step, &next)
            && between >= self.options.smallest_step
        {
            return Err(Rejected::Unresolved(between));
        }
        let (mut longer, mut located, mut remeshed) = (f64::INFINITY, Vec::new(), None);
        if let Some(passed) = passed.filter(|_| largest < f64::INFINITY) {
            let span = Span::new(here, step, &next);
            let mut resolved = self.resolved(passed, arclength, span)?;
            if matches!(resolved, Resolved::Shorter(_)) && !span.has_one_mesh() {
                // Where the meshes do not resolve what bifurcates, it may be them that the determinant differs by.
                match self.remeshed(span, Onto::Last) {
                    Err(cause) if cause.is_interruption() => return Err(cause.into()),
                    Err(_) => {}
                    Ok(first) => {
                        resolved = self.resolved(&Passed::default(), arclength, span.from(&first))?;
                        remeshed = Some(first.point.determinant);
                    }
                }
            }
            match resolved {
                Resolved::Shorter(step) if step >= self.options.smallest_step => {
                    return Err(Rejected::Unresolved(step));
                }
                Resolved::Shorter(_) => {}
                Resolved::Yes { longer: factor, touches } => {
                    longer = factor;
                    located.extend(touches.into_iter().map(|(at, point)| (PointKind::BranchPoint, at, Some(point))));
                }
            }
        }
        let crossings = self.crossings(here, &next.point);
        let crossed = crossings.iter().any(|crossing| crossing.kind == PointKind::BranchPoint);
        for crossing in crossings {
            match self.locate(previous, here, step, &next, &crossing) {
                Ok(Some((at, found))) => located.push((crossing.kind, at, found)),
                Ok(None) => {}
                // A branch that goes on is not lost for a place on it.
                Err(cause)
                    if crossing.kind == PointKind::BranchPoint
                        && !cause.is_interruption()
                        && 0.5 * step < self.options.smallest_step =>
                {
                    let at = (crossing.place() * step).clamp(0.0, step);
                    let Reference { solution, direction, .. } = if at < 0.5 * step { here } else { &next.point };
                    let point = Reference::new(solution.clone(), direction.clone(), Determinant::UNKNOWN);
                    located.push((crossing.kind, at, Some(point)));
                }
                Err(cause) => return Err(cause.into()),
            }
        }
        located.sort_by(|(_, a, _), (_, b, _)| a.total_cmp(b));
        // Where the parameter leaves the range and comes back into it, the end is before the fold.
        let beyond = located.iter().find(|(kind, _, found)| {
            *kind == PointKind::Fold && found.as_ref().is_some_and(|found| self.is_outside(found.value(self.parameter)))
        });
        if let Some((_, at, _)) = beyond
            && wary.of_folds
            && !self.is_outside(next.point.value(self.parameter))
            && *at >= self.options.smallest_step
        {
            return Err(Rejected::Unresolved(*at));
        }
        if let Some(end) = located.iter().position(|(kind, ..)| *kind == PointKind::End) {
            located.truncate(end + 1);
            // What is beyond the range may yet have been found at a lesser distance, where it turns.
            let value = |found: &Option<Reference>| found.as_ref().unwrap_or(&next.point).value(self.parameter);
            located.retain(|(kind, _, found)| *kind == PointKind::End || !self.is_outside(value(found)));
            if let Some((end, (_, _, found))) =
                self.end_before(next.point.value(self.parameter)).zip(located.last_mut())
            {
                let exact = self.exactly_at_end(found.as_ref().unwrap_or(&next.point), end, step)?;
                *found = Some(exact);
            }
        }
        Ok(Stepped { next, crossed, remeshed, longer, located })
    }

    /// The last point of a branch, at the end of the range, and the events just before it.
    fn end(&mut self, arclength: f64, here: &Reference, end: &Reference) {
        let rate = here.direction.constants[self.parameter];
        let arclength = arclength + ((end.value(self.parameter) - here.value(self.parameter)) / rate).max(0.0);
        for kind in (0..self.events.len()).map(PointKind::Event) {
            let crossing = Crossing { kind, values: (self.watched(kind, here), self.watched(kind, end)) };
            if crossing.is_one() {
                self.push(kind, arclength, end);
                if self.options.stop_at.contains(&kind) {
                    return;
                }
            }
        }
        self.push(PointKind::End, arclength, end);
    }

    fn announce(&mut self, event: &Event) -> Result<(), SolveError> {
        self.budget.notify(self.observer, event, &Stats::default())
    }

    fn push(&mut self, kind: PointKind, arclength: f64, at: &Reference) {
        self.points.push(BranchPoint {
            kind,
            parameter: at.value(self.parameter),
            rate: at.direction.constants[self.parameter],
            arclength,
            solution: at.solution.clone(),
            is_settled: kind != PointKind::BranchPoint || at.is_settled,
            direction: (kind == PointKind::BranchPoint).then(|| at.direction.clone()),
        });
    }

    fn check(&self, start: &Guess) -> Result<(), SolveError> {
        let layout = self.problem.layout();
        check(layout, start, self.unknowns, &self.options.solve)?;
        let constants = layout.constants.len();
        if self.parameter >= constants || self.unknowns.contains(&self.parameter) {
            return Err(SolveError::Unknowns { index: self.parameter, constants });
        }
        self.options.check(start.constants[self.parameter], self.events.len())
    }

    /// The point of a checkpoint. It lies where it lay; a Newton iteration confirms it.
    pub(super) fn resumed(&mut self, from: &Checkpoint) -> Result<Reference, SolveError> {
        self.check(&from.guess)?;
        positive([("step", from.step)])?;
        let direction = from.direction.clone().filter(|direction| direction.fits(&from.guess));
        let Some(direction) = direction else {
            return Err(SolveError::Option { name: "position", value: from.position, expected: "a point of a branch" });
        };
        let plan = Plan::new(self.problem.layout(), self.unknowns);
        let mut run = Run::new(self.problem, plan, &self.path_options, self.observer, self.budget);
        let solution = run.as_it_stands(Start::from(&from.guess))?;
        self.stats += run.stats;
        drop(run);
        Ok(self.advance(&Reference::new(solution, direction, Determinant::UNKNOWN), 0.0)?.point)
    }

    /// The solution at the start, with the tangent of the parameter alone.
    pub(super) fn first(&mut self, start: &Guess) -> Result<Reference, SolveError> {
        self.check(start)?;
        // The branch goes on from solutions of the collocation equations.
        let options = Options { defect_correction: false, ..self.options.solve.clone() };
        let solution = solve_within(self.problem, start, self.unknowns, &options, self.observer, self.budget)?;
        self.stats += *solution.stats();
        let sign = if self.options.upwards { 1.0 } else { -1.0 };
        if self.options.branch_points {
            match self.seen(&solution, sign) {
                Ok(mut seen) => {
                    seen.solution = solution;
                    return Ok(seen);
                }
                Err(cause) if cause.is_interruption() => return Err(cause),
                Err(_) => {}
            }
        }
        let linearisation = Linearisation::new(self.problem, &solution)?;
        self.budget.charge(linearisation.stats());
        self.stats += *linearisation.stats();
        let tangent = linearisation.sensitivity(self.parameter);
        Ok(self.reference(solution, &tangent, sign, Determinant::UNKNOWN).0)
    }

    /// A solution with the direction in which the branch leaves it, towards greater values of the parameter for a
    /// positive sign, and the determinant there, by which a branch point in the first step is seen: those of the
    /// equations that take their distance along the parameter alone.
    fn seen(&mut self, solution: &Solution, sign: f64) -> Result<Reference, SolveError> {
        let states = solution.regions().iter().enumerate().map(|(index, region)| {
            let count = self.problem.layout().regions[index].states.len();
            vec![vec![0.0; region.mesh().len()]; count]
        });
        let mut direction = Direction { states: states.collect(), constants: vec![0.0; solution.constants().len()] };
        direction.constants[self.parameter] = sign;
        let mut along = Reference::new(solution.clone(), direction, Determinant::UNKNOWN);
        normalise(self.problem.layout(), &mut along);
        let from = Near { point: &along, at: 0.0, speed: 1.0 };
        Ok(self.advance_from(&along, 0.0, (from, None), Care::Glance)?.point)
    }

    /// A point, and how fast it moves along its direction as the tangent does.
    fn reference(
        &self,
        solution: Solution,
        tangent: &Tangent,
        sign: f64,
        determinant: Determinant,
    ) -> (Reference, f64) {
        let scaled = |values: &Vec<f64>| values.iter().map(|value| sign * value).collect();
        let n = solution.constants().len();
        let direction = Direction {
            states: tangent.regions.iter().map(|region| region.states.iter().map(scaled).collect()).collect(),
            constants: tangent.constants[..n].iter().map(|rate| sign * rate).collect(),
        };
        let mut reference = Reference::new(solution, direction, determinant);
        let speed = normalise(self.problem.layout(), &mut reference);
        (reference, speed)
    }

    /// The solution at the distance `step`, and its tangent.
    fn advance(&mut self, here: &Reference, step: f64) -> Result<Advanced, SolveError> {
        let from = Near { point: here, at: 0.0, speed: 1.0 };
        self.advance_from(here, step, (from, None), Care::Step)
    }

    /// As [`advance`](Self::advance), predicted from one point known or between two.
    fn advance_from(
        &mut self,
        here: &Reference,
        step: f64,
        (near, other): (Near<'_>, Option<Near<'_>>),
        care: Care,
    ) -> Result<Advanced, SolveError> {
        let between = other.and_then(|other| near.between(&other, step));
        let mut guess = between.unwrap_or_else(|| near.point.moved(near.speed * (step - near.at)));
        guess.constants.push(step);
        self.advance_with(here, start::near(&near.point.solution, &near.point.inner, &guess), care)
    }

    /// As [`advance`](Self::advance), from what is expected there; its last constant is the distance.
    fn advance_with(&mut self, here: &Reference, start: Start, care: Care) -> Result<Advanced, SolveError> {
        let arclength = Arclength::new(self.problem, here);
        let problem: &dyn Problem = &arclength;
        let plan = Plan::defining(problem.layout(), &self.extended);
        let mut run = Run::new(problem, plan, &self.path_options, self.observer, self.budget);
        run.coarsen = care == Care::Step;
        run.needs_determined = false;
        let outcome = if care == Care::Glance {
            run.unjudged(start)
        } else {
            run.refine(start).and_then(|solved| Ok((run.finish(&solved)?, solved.system, solved.converged)))
        };
        let (contraction, check) = (run.contraction, run.check);
        let mut stats = run.stats;
        drop(run);
        let (budget, watches_determinant) = (self.budget, self.options.branch_points);
        let found = outcome.and_then(|(solution, system, converged)| {
            let inner = converged.x.inner.clone();
            let linearisation = match converged.at_once {
                true => Linearisation::held(system, converged),
                false => Linearisation::at(system, converged.x, Stats::default())?,
            };
            budget.charge(linearisation.stats());
            stats += *linearisation.stats();
            let determinant = match watches_determinant {
                true => linearisation.determinant(),
                false => Determinant::of_sign(linearisation.factorisation.orientation()),
            };
            Ok((solution, linearisation.sensitivity(arclength.step()), determinant, inner))
        });
        self.stats += stats;
        let (solution, tangent, determinant, inner) = found?;
        let solution = solution.restricted(self.problem.layout(), self.unknowns);
        let (mut point, speed) = self.reference(solution, &tangent, 1.0, determinant);
        // As if the distance were taken along the point's own direction.
        point.determinant.logarithm += libm::log(speed);
        point.inner = inner;
        Ok(Advanced { point, judged: care != Care::Glance, speed, contraction, check })
    }

    /// A point between two that are `step` apart, if its constants are no farther than that from what is expected.
    fn between(&self, found: Advanced, expected: &[f64], step: f64) -> Result<Advanced, SolveError> {
        let squares = constant_squares(self.problem.layout(), &found.point.solution);
        let misses = found.point.solution.constants().iter().zip(expected).zip(squares);
        let miss: f64 = misses.map(|((found, expected), square)| (found - expected).powi(2) / square).sum();
        if miss <= step * step {
            return Ok(found);
        }
        Err(SolveError::Astray { at: found.point.value(self.parameter) })
    }

    fn is_outside(&self, value: f64) -> bool {
        let (low, high) = self.options.range;
        !(low..=high).contains(&value)
    }

    /// Zeros between two points, in the order in which they are passed.
    fn crossings(&self, a: &Reference, b: &Reference) -> Vec<Crossing> {
        let mut kinds = vec![PointKind::Fold];
        if self.options.branch_points {
            kinds.push(PointKind::BranchPoint);
        }
        kinds.extend((0..self.events.len()).map(PointKind::Event));
        if self.is_outside(b.value(self.parameter)) {
            kinds.push(PointKind::End);
        }
        let crossing = |kind| Crossing { kind, values: (self.watched(kind, a), self.watched(kind, b)) };
        let mut found: Vec<Crossing> = kinds.into_iter().map(crossing).filter(|crossing| crossing.is_one()).collect();
        found.retain(|crossing| crossing.kind != PointKind::Fold || !self.stands_still(a, b));
        found.sort_by(|a, b| a.place().total_cmp(&b.place()));
        found
    }

    /// Whether the parameter's rates at two points are no more than rounding, as on a branch along which it is
    /// constant.
    fn stands_still(&self, a: &Reference, b: &Reference) -> bool {
        let (low, high) = self.options.range;
        let of_points = a.value(self.parameter).abs().max(b.value(self.parameter).abs());
        let size = Some(high - low).filter(|length| length.is_finite()).unwrap_or(of_points);
        let rate = |point: &Reference| point.direction.constants[self.parameter].abs();
        rate(a).max(rate(b)) <= STILL * size
    }

    /// The function whose zero makes a point special.
    fn watched(&self, kind: PointKind, at: &Reference) -> f64 {
        match kind {
            PointKind::Regular => f64::NAN,
            PointKind::BranchPoint => at.determinant.relative(&Determinant::UNKNOWN),
            // Where two branches cross the direction does not tell which way the parameter goes.
            PointKind::Fold if at.is_crossing => 0.0,
            PointKind::Fold => at.direction.constants[self.parameter],
            PointKind::Event(index) => self.events.get(index).map_or(f64::NAN, |event| event(&at.solution)),
            PointKind::End => {
                let (low, high) = self.options.range;
                let value = at.value(self.parameter);
                // Negative inside.
                (low - value).max(value - high)
            }
        }
    }
}

impl Advanced {
    fn near(&self, at: f64) -> Near<'_> {
        Near { point: &self.point, at, speed: self.speed }
    }
}

impl Crossing {
    fn is_one(&self) -> bool {
        let (a, b) = self.values;
        // The end may be where the branch begins.
        a * b < 0.0 || (b == 0.0 && a != 0.0) || (a == 0.0 && self.kind == PointKind::End)
    }

    /// Where the zero lies, by linear interpolation.
    fn place(&self) -> f64 {
        let (a, b) = self.values;
        a / (a - b)
    }
}

impl Reference {
    fn value(&self, constant: usize) -> f64 {
        self.solution.constants()[constant]
    }

    /// Moved along the direction.
    fn moved(&self, by: f64) -> Guess {
        let along = |values: &mut [f64], rates: &[f64]| {
            values.iter_mut().zip(rates).for_each(|(value, rate)| *value += by * rate)
        };
        let mut guess = Guess::from(&self.solution);
        for (region, direction) in guess.regions.iter_mut().zip(&self.direction.states) {
            region.states.iter_mut().zip(direction).for_each(|(values, rates)| along(values, rates));
        }
        along(&mut guess.constants, &self.direction.constants);
        guess
    }
}
