//! Steps along a branch: predictor, corrector, step length; folds and events between two points.

mod crossing;
mod location;

use super::arclength::{Arclength, Direction, Reference, normalise};
use super::branch::{Branch, BranchError, BranchOptions, BranchPoint, EventFunction, PointKind};
use super::checkpoint::Checkpoint;
use super::natural::positive;
use crate::budget::Budget;
use crate::collocation::plan::Plan;
use crate::error::SolveError;
use crate::guess::{Guess, RegionGuess};
use crate::linearisation::{Linearisation, Tangent};
use crate::measure::Solved;
use crate::observer::{Event, Observer};
use crate::options::Options;
use crate::orientation::{BranchCheck, Determinant};
use crate::problem::Problem;
use crate::run::Run;
use crate::solution::Solution;
use crate::solve::{check, solve_within};
use crate::start::{self, Start};
use crate::stats::Stats;
use location::{Known, Search, Sought};

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

/// What is located is located to this part of the step.
const LOCATION: f64 = 1e-10;
/// Looks for one place at most.
const LOOKS: usize = 40;
/// At a branch point the matrix is singular, and beside it nearly so, where Newton's iteration ends in rounding. It is
/// looked at from so far, in parts of the step: to one side and the other, and farther off if need be,
const BESIDE: [f64; 4] = [1.0, -1.0, 10.0, -10.0];
const DISTANCE: f64 = 1e-4;
/// until its place changes by no more than this. The next change would be smaller by as much as the distance is.
const SETTLED: f64 = 1e-8;

/// A zero of one of the watched functions lies between two points.
struct Crossing {
    kind: PointKind,
    /// Values at both points.
    values: (f64, f64),
}

/// Where a point is predicted from.
#[derive(Clone, Copy)]
struct Near<'r> {
    point: &'r Reference,
    /// Its distance.
    at: f64,
    speed: f64,
}

/// A point found at some distance from another.
struct Advanced {
    point: Reference,
    /// How fast it moves along its direction as the distance grows.
    speed: f64,
    /// Newton's first contraction.
    contraction: f64,
    check: BranchCheck,
}

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
        while self.points.len() < self.options.max_points {
            let next = match self.advance(&here, step) {
                Ok(found) => found,
                Err(cause) if cause.is_interruption() => return Err(cause),
                Err(cause) => {
                    step *= 0.5;
                    if step < self.options.smallest_step {
                        return Err(cause);
                    }
                    self.announce(&Event::Rejected { lambda: here.value(self.parameter) })?;
                    continue;
                }
            };
            let crossings = self.crossings(&here, &next.point);
            let crossed = crossings.iter().any(|crossing| crossing.kind == PointKind::BranchPoint);
            // The sense of the first step is given, so that a branch point is told from one that is crossed.
            let [before, after] = [&here, &next.point].map(|point| point.determinant.orientation);
            let turned = if crossed { next.check } else { next.check.across(before, after) };
            self.check = self.check.and(turned.placed(next.point.value(self.parameter)));
            for crossing in crossings {
                let (at, found) = self.locate(previous.as_ref(), &here, step, &next, &crossing)?;
                match found {
                    Some(found) => self.push(crossing.kind, arclength + at, &found),
                    None => self.push(crossing.kind, arclength + at, &next.point),
                }
                if crossing.kind == PointKind::End {
                    return Ok(());
                }
            }
            arclength += step;
            let Advanced { point: next, contraction, .. } = next;
            self.push(PointKind::Regular, arclength, &next);
            let g = |theta: f64| (1.0 + 4.0 * theta).sqrt() - 1.0;
            let factor = (g(self.options.contraction) / g(contraction.max(1e-6))).sqrt();
            let longer = (step * factor.clamp(0.3, 2.0)).min(self.options.largest_step);
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
        });
    }

    fn check(&self, start: &Guess) -> Result<(), SolveError> {
        let layout = self.problem.layout();
        check(layout, start, self.unknowns, &self.options.solve)?;
        let constants = layout.constants.len();
        if self.parameter >= constants || self.unknowns.contains(&self.parameter) {
            return Err(SolveError::Unknowns { index: self.parameter, constants });
        }
        self.options.check(start.constants[self.parameter])
    }

    /// The point of a checkpoint. It lies where it lay; a Newton iteration confirms it.
    pub(super) fn resumed(&mut self, from: &Checkpoint) -> Result<Reference, SolveError> {
        self.check(&from.guess)?;
        positive(&[("step", from.step)])?;
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
        let options = &self.options.solve;
        let solution = solve_within(self.problem, start, self.unknowns, options, self.observer, self.budget)?;
        self.stats += *solution.stats();
        let linearisation = Linearisation::new(self.problem, &solution)?;
        self.budget.charge(linearisation.stats());
        self.stats += *linearisation.stats();
        let tangent = linearisation.sensitivity(self.parameter);
        let sign = if self.options.upwards { 1.0 } else { -1.0 };
        Ok(self.reference(solution, &tangent, sign, Determinant::UNKNOWN).0)
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
        self.advance_from(here, step, (from, None), true)
    }

    /// As [`advance`](Self::advance), predicted from one point known or between two.
    fn advance_from(
        &mut self,
        here: &Reference,
        step: f64,
        (near, other): (Near<'_>, Option<Near<'_>>),
        coarsen: bool,
    ) -> Result<Advanced, SolveError> {
        let arclength = Arclength::new(self.problem, here);
        let problem: &dyn Problem = &arclength;
        let between = other.and_then(|other| near.between(&other, step));
        let mut guess = between.unwrap_or_else(|| near.point.moved(near.speed * (step - near.at)));
        guess.constants.push(step);
        let plan = Plan::defining(problem.layout(), &self.extended);
        let mut run = Run::new(problem, plan, &self.path_options, self.observer, self.budget);
        // Places between two points are compared with each other: on one mesh, if that will do.
        run.coarsen = coarsen;
        let outcome =
            run.refine(start::near(&near.point.solution, &guess)).and_then(|solved| Ok((run.finish(&solved)?, solved)));
        let (contraction, check) = (run.contraction, run.check);
        let mut stats = run.stats;
        drop(run);
        let budget = self.budget;
        let found = outcome.and_then(|(solution, solved)| {
            let Solved { system, converged, .. } = solved;
            let linearisation = match converged.at_once {
                true => Linearisation::held(system, converged),
                false => Linearisation::at(system, converged.x, Stats::default())?,
            };
            budget.charge(linearisation.stats());
            stats += *linearisation.stats();
            let determinant = linearisation.factorisation.determinant();
            Ok((solution, linearisation.sensitivity(arclength.step()), determinant))
        });
        self.stats += stats;
        let (solution, tangent, determinant) = found?;
        let solution = solution.restricted(self.problem.layout(), self.unknowns);
        let (point, speed) = self.reference(solution, &tangent, 1.0, determinant);
        Ok(Advanced { point, speed, contraction, check })
    }

    /// Zeros between two points, in the order in which they are passed.
    fn crossings(&self, a: &Reference, b: &Reference) -> Vec<Crossing> {
        let mut kinds = vec![PointKind::Fold];
        if self.options.branch_points {
            kinds.push(PointKind::BranchPoint);
        }
        kinds.extend((0..self.events.len()).map(PointKind::Event));
        let (low, high) = self.options.range;
        let outside = |value: f64| !(low..=high).contains(&value);
        if outside(b.value(self.parameter)) {
            kinds.push(PointKind::End);
        }
        let crossing = |kind| Crossing { kind, values: (self.watched(kind, a), self.watched(kind, b)) };
        let mut found: Vec<Crossing> = kinds.into_iter().map(crossing).filter(|crossing| crossing.is_one()).collect();
        found.sort_by(|a, b| a.place().total_cmp(&b.place()));
        found
    }

    /// The function whose zero makes a point special.
    fn watched(&self, kind: PointKind, at: &Reference) -> f64 {
        match kind {
            PointKind::Regular => f64::NAN,
            PointKind::BranchPoint => at.determinant.relative(&Determinant::UNKNOWN),
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

    /// Zero of the watched function, and the point there if it is not the next. Each is predicted from the nearest that
    /// is known.
    fn locate(
        &mut self,
        before: Option<&(f64, Reference)>,
        here: &Reference,
        step: f64,
        next: &Advanced,
        crossing: &Crossing,
    ) -> Result<(f64, Option<Reference>), SolveError> {
        let kind = crossing.kind;
        if kind == PointKind::BranchPoint {
            return self.locate_branch_point(before, here, step, next).map(|(at, found)| (at, Some(found)));
        }
        if self.watched(kind, &next.point) == 0.0 {
            return Ok((step, None));
        }
        let mut search = self.search(kind, before, here, (step, next));
        let mut seen: Vec<(f64, Advanced)> = Vec::new();
        let (mut at, small) = (search.next(), LOCATION * (crossing.values.0.abs() + crossing.values.1.abs()));
        for _ in 0..LOOKS {
            let near = around(here, (step, next), &seen, at);
            let found = self.advance_from(here, at, near, false)?;
            let usable = search.add(self.known(kind, found.near(at), here));
            let done = self.watched(kind, &found.point).abs() <= small;
            seen.push((at, found));
            let before = at;
            at = search.next();
            if !usable || done || search.length() <= LOCATION * step || (at - before).abs() <= LOCATION * step {
                break;
            }
        }
        let size = |(_, found): &(f64, Advanced)| self.watched(kind, &found.point).abs();
        let best = seen.into_iter().min_by(|a, b| size(a).total_cmp(&size(b)));
        best.map(|(at, found)| (at, Some(found.point))).ok_or(SolveError::Cancelled)
    }

    /// Where the determinant vanishes, looked at from beside it, and the point there: that nearest to it, moved along
    /// its direction.
    fn locate_branch_point(
        &mut self,
        before: Option<&(f64, Reference)>,
        here: &Reference,
        step: f64,
        next: &Advanced,
    ) -> Result<(f64, Reference), SolveError> {
        let kind = PointKind::BranchPoint;
        let mut search = self.search(kind, before, here, (step, next));
        let mut seen: Vec<(f64, Advanced)> = Vec::new();
        let mut place = search.next();
        for _ in 0..LOOKS {
            let side = search.roomier(place);
            let mut outcome = Err(SolveError::Cancelled);
            for beside in BESIDE {
                let at = (place + side * beside * DISTANCE * step).clamp(0.0, step);
                let near = around(here, (step, next), &seen, at);
                outcome = self.advance_from(here, at, near, false).map(|found| (at, found));
                match &outcome {
                    Err(cause) if !cause.is_interruption() => {}
                    _ => break,
                }
            }
            let (at, found) = outcome?;
            let usable = search.add(self.known(kind, found.near(at), here));
            seen.push((at, found));
            let before = place;
            place = search.next();
            if !usable || (place - before).abs() <= SETTLED * step {
                break;
            }
        }
        let (near, _) = around(here, (step, next), &seen, place);
        Ok((place, self.moved(near.point, near.speed * (place - near.at))?))
    }

    fn search(
        &self,
        kind: PointKind,
        before: Option<&(f64, Reference)>,
        here: &Reference,
        (step, next): (f64, &Advanced),
    ) -> Search {
        let sought = if kind == PointKind::Fold { Sought::Extremum } else { Sought::Zero };
        let first = self.known(kind, Near { point: here, at: 0.0, speed: 1.0 }, here);
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
    fn moved(&mut self, point: &Reference, by: f64) -> Result<Reference, SolveError> {
        let plan = Plan::new(self.problem.layout(), self.unknowns);
        let mut run = Run::new(self.problem, plan, &self.path_options, self.observer, self.budget);
        let start = start::near(&point.solution, &point.moved(by));
        let moved = run.as_it_stands(start)?;
        self.stats += run.stats;
        drop(run);
        let Solution { error_estimate, accuracy, branch_check, .. } = point.solution;
        let solution = Solution { error_estimate, accuracy, branch_check, ..moved };
        Ok(Reference::new(solution, point.direction.clone(), Determinant::UNKNOWN))
    }
}

/// Of the ends of a step and what has been seen between: that nearest to a place, and the nearest on its other side.
fn around<'r>(
    here: &'r Reference,
    (step, next): (f64, &'r Advanced),
    seen: &'r [(f64, Advanced)],
    place: f64,
) -> (Near<'r>, Option<Near<'r>>) {
    let (first, last) = (Near { point: here, at: 0.0, speed: 1.0 }, next.near(step));
    let all = || [first, last].into_iter().chain(seen.iter().map(|(at, found)| found.near(*at)));
    let nearer = |best: Near<'r>, other: Near<'r>| {
        if (other.at - place).abs() < (best.at - place).abs() { other } else { best }
    };
    let below = all().filter(|near| near.at <= place).reduce(nearer);
    let above = all().filter(|near| near.at > place).reduce(nearer);
    match (below, above) {
        (Some(below), Some(above)) if (above.at - place) < (place - below.at) => (above, Some(below)),
        (Some(near), other) | (other, Some(near)) => (near, other),
        (None, None) => (first, None),
    }
}

impl Near<'_> {
    /// The point at a place between two, by the cubic that has their values and directions; none if their meshes are
    /// not the same.
    fn between(&self, other: &Near<'_>, at: f64) -> Option<Guess> {
        let length = other.at - self.at;
        let sigma = (at - self.at) / length;
        let (tau, square) = (1.0 - sigma, sigma * sigma);
        let [rise, leaving, arriving] = [
            square * (3.0 - 2.0 * sigma),
            sigma * tau * tau * length * self.speed,
            -square * tau * length * other.speed,
        ];
        let cubic =
            |((a, from), (b, to)): ((&f64, &f64), (&f64, &f64))| a + rise * (b - a) + leaving * from + arriving * to;
        let [one, two] = [self.point, other.point];
        let mut regions = Vec::new();
        for (index, (a, b)) in one.solution.regions().iter().zip(two.solution.regions()).enumerate() {
            if a.mesh() != b.mesh() {
                return None;
            }
            let mut region = RegionGuess::from(a);
            let rates = one.direction.states[index].iter().zip(&two.direction.states[index]).enumerate();
            for (values, (i, (from, to))) in region.states.iter_mut().zip(rates) {
                *values = values.iter().zip(from).zip(b.state(i).iter().zip(to)).map(cubic).collect();
            }
            regions.push(region);
        }
        let [a, b] = [one, two].map(|point| point.solution.constants().iter().zip(&point.direction.constants));
        Some(Guess { regions, constants: a.zip(b).map(cubic).collect() })
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
