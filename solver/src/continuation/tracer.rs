//! Steps along a branch: predictor, corrector, step length; folds and events between two points.

mod crossing;

use super::arclength::{Arclength, Direction, Reference, normalise};
use super::branch::{Branch, BranchError, BranchOptions, BranchPoint, EventFunction, PointKind};
use super::checkpoint::Checkpoint;
use super::natural::positive;
use crate::budget::Budget;
use crate::collocation::plan::Plan;
use crate::error::SolveError;
use crate::guess::{Guess, RegionGuess};
use crate::linearisation::{Linearisation, Tangent};
use crate::observer::{Event, Observer};
use crate::options::Options;
use crate::orientation::{BranchCheck, Orientation};
use crate::problem::Problem;
use crate::run::Run;
use crate::solution::Solution;
use crate::solve::{check, solve_within};
use crate::start::{self, Start};
use crate::stats::Stats;

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

/// A branch point is located to this power of two of the step.
const BISECTIONS: usize = 22;

/// A zero of one of the watched functions lies between two points.
struct Crossing {
    kind: PointKind,
    /// Values at both points.
    values: (f64, f64),
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
        while self.points.len() < self.options.max_points {
            let (next, contraction, check) = match self.advance(&here, step) {
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
            let crossings = self.crossings(&here, &next);
            let crossed = crossings.iter().any(|crossing| crossing.kind == PointKind::BranchPoint);
            // The sense of the first step is given, so that a branch point is told from one that is crossed.
            let turned = if crossed { check } else { check.across(here.orientation, next.orientation) };
            self.check = self.check.and(turned.placed(next.value(self.parameter)));
            for crossing in crossings {
                let (at, found) = match crossing.kind {
                    PointKind::BranchPoint => self.locate_branch_point(&here, step, next.orientation)?,
                    _ => self.locate(&here, step, &next, &crossing)?,
                };
                self.push(crossing.kind, arclength + at, &found);
                if crossing.kind == PointKind::End {
                    return Ok(());
                }
            }
            arclength += step;
            self.push(PointKind::Regular, arclength, &next);
            let g = |theta: f64| (1.0 + 4.0 * theta).sqrt() - 1.0;
            let factor = (g(self.options.contraction) / g(contraction.max(1e-6))).sqrt();
            let longer = (step * factor.clamp(0.3, 2.0)).min(self.options.largest_step);
            if self.observer.wants_checkpoints() {
                let (guess, direction) = (Guess::from(&next.solution), Some(next.direction.clone()));
                self.observer.checkpoint(&Checkpoint { position: arclength, step: longer, guess, direction });
            }
            self.announce(&Event::Step { step: self.points.len() - 1, lambda: next.value(self.parameter) })?;
            (here, step) = (next, longer);
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
        let (here, ..) = self.advance(&Reference { solution, direction, orientation: None }, 0.0)?;
        Ok(here)
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
        Ok(self.reference(solution, &tangent, sign))
    }

    fn reference(&self, solution: Solution, tangent: &Tangent, sign: f64) -> Reference {
        let scaled = |values: &Vec<f64>| values.iter().map(|value| sign * value).collect();
        let n = solution.constants().len();
        let direction = Direction {
            states: tangent.regions.iter().map(|region| region.states.iter().map(scaled).collect()).collect(),
            constants: tangent.constants[..n].iter().map(|rate| sign * rate).collect(),
        };
        let mut reference = Reference { solution, direction, orientation: None };
        normalise(self.problem.layout(), &mut reference);
        reference
    }

    /// The solution at the distance `step`, its tangent, and Newton's first contraction.
    fn advance(&mut self, here: &Reference, step: f64) -> Result<(Reference, f64, BranchCheck), SolveError> {
        self.advance_from(here, step, here, 0.0)
    }

    /// As [`advance`](Self::advance), predicted from a point known to lie at the distance `known`.
    fn advance_from(
        &mut self,
        here: &Reference,
        step: f64,
        near: &Reference,
        known: f64,
    ) -> Result<(Reference, f64, BranchCheck), SolveError> {
        let arclength = Arclength::new(self.problem, here);
        let problem: &dyn Problem = &arclength;
        let rates = near.solution.constants().iter().zip(&near.direction.constants);
        let mut constants: Vec<f64> = rates.map(|(c, rate)| c + (step - known) * rate).collect();
        constants.push(step);
        let guess = Guess { regions: near.moved(step - known), constants };
        let plan = Plan::defining(problem.layout(), &self.extended);
        let mut run = Run::new(problem, plan, &self.path_options, self.observer, self.budget);
        let outcome =
            run.refine(start::near(&near.solution, &guess)).and_then(|solved| Ok((run.finish(&solved)?, solved)));
        let (contraction, check) = (run.contraction, run.check);
        let mut stats = run.stats;
        drop(run);
        let budget = self.budget;
        let found = outcome.and_then(|(solution, solved)| {
            let x = solved.converged.x;
            let linearisation = Linearisation::at(solved.system, x, Stats::default())?;
            budget.charge(linearisation.stats());
            stats += *linearisation.stats();
            Ok((solution, linearisation.sensitivity(arclength.step())))
        });
        self.stats += stats;
        let (solution, tangent) = found?;
        let orientation = solution.orientation();
        let solution = solution.restricted(self.problem.layout(), self.unknowns);
        let reference = Reference { orientation, ..self.reference(solution, &tangent, 1.0) };
        Ok((reference, contraction, check))
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
            PointKind::BranchPoint => match at.orientation {
                Some(Orientation::Positive) => 1.0,
                Some(Orientation::Negative) => -1.0,
                None => f64::NAN,
            },
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

    /// Where the orientation changes to that `after` the step, by bisection: near a branch point the matrix is nearly
    /// singular, and all that is asked of it is a sign.
    fn locate_branch_point(
        &mut self,
        here: &Reference,
        step: f64,
        after: Option<Orientation>,
    ) -> Result<(f64, Reference), SolveError> {
        let (mut low, mut high, mut best) = (0.0, step, None);
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (low + high);
            match self.advance(here, middle) {
                Ok((found, ..)) => {
                    if found.orientation == after {
                        high = middle;
                    } else {
                        low = middle;
                    }
                    best = Some((middle, found));
                }
                Err(cause) if cause.is_interruption() => return Err(cause),
                // The matrix is singular: this is the place, as closely as it can be told.
                Err(_) => break,
            }
        }
        match best {
            Some(found) => Ok(found),
            None => Ok((low, self.advance(here, low)?.0)),
        }
    }

    /// Zero of the watched function by the Illinois method (M. Dowell and P. Jarratt, BIT 11 (1971) 168-174).
    /// Each point is predicted from the nearest that is known.
    fn locate(
        &mut self,
        here: &Reference,
        step: f64,
        next: &Reference,
        crossing: &Crossing,
    ) -> Result<(f64, Reference), SolveError> {
        let (mut a, mut b) = (0.0, step);
        let (mut fa, mut fb) = crossing.values;
        let small = 1e-10 * (fa.abs() + fb.abs());
        let mut best: Option<(f64, f64, Reference)> = None;
        for _ in 0..40 {
            let at = (a * fb - b * fa) / (fb - fa);
            let mut near = if at <= 0.5 * step { (here, 0.0) } else { (next, step) };
            if let Some((_, place, found)) =
                best.as_ref().filter(|(_, place, _)| (place - at).abs() < (near.1 - at).abs())
            {
                near = (found, *place);
            }
            let (found, ..) = self.advance_from(here, at, near.0, near.1)?;
            let f = self.watched(crossing.kind, &found);
            if best.as_ref().is_none_or(|best| f.abs() < best.0.abs()) {
                best = Some((f, at, found));
            }
            if !(f.abs() > small) || (b - a).abs() <= 1e-10 * step {
                break;
            }
            if f * fb < 0.0 {
                (a, fa) = (b, fb);
            } else {
                fa *= 0.5;
            }
            (b, fb) = (at, f);
        }
        best.map(|(_, at, found)| (at, found)).ok_or(SolveError::Cancelled)
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

    /// The states moved along the direction.
    fn moved(&self, step: f64) -> Vec<RegionGuess> {
        let regions = self.solution.regions().iter().zip(&self.direction.states);
        let moved = regions.map(|(region, direction)| RegionGuess {
            mesh: region.mesh().to_vec(),
            states: direction
                .iter()
                .enumerate()
                .map(|(i, rates)| region.state(i).iter().zip(rates).map(|(y, rate)| y + step * rate).collect())
                .collect(),
        });
        moved.collect()
    }
}
