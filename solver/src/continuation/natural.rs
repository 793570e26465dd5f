//! Continuation in a path parameter, with a tangent predictor.
//!
//! P. Deuflhard, "Newton Methods for Nonlinear Problems", Springer 2004, chapter 5: the step is chosen from the first
//! contraction Θ of Newton's iteration at the predicted point. For a predictor of order 2 the step that would have
//! given the contraction Θ̄ is `(g(Θ̄)/g(Θ))^½` times the one taken, `g(Θ) = √(1 + 4Θ) - 1`.

use super::checkpoint::Checkpoint;
use super::path::Path;
use crate::budget::Budget;
use crate::collocation::Correction;
use crate::collocation::evaluate::Derivatives;
use crate::collocation::grid::intervals;
use crate::collocation::plan::Plan;
use crate::error::SolveError;
use crate::guess::Guess;
use crate::measure::{Solved, undefined};
use crate::observer::{Event, Observer, Silent};
use crate::options::{Control, Options, at_least_one, positive};
use crate::orientation::BranchCheck;
use crate::problem::{Layout, Problem};
use crate::run::Run;
use crate::solution::Solution;
use crate::solve::check;
use crate::start::Start;
use crate::stats::Stats;
use thiserror::Error;

/// After so many steps in a row whose first correction did not contract, contractions are taken to be of no use: kinks
/// lie everywhere, or the corrections within the tolerance.
const CROSSED: usize = 2;
/// Shares of the iterations that a step may take, and the factor on the next step, where contractions are of no use:
/// longer up to the first share, shorter beyond the second.
const QUICK: f64 = 0.25;
const SLOW: f64 = 0.5;
const LONGER: f64 = 2.0;

/// How a path is followed.
#[derive(Debug, Clone, PartialEq)]
pub struct PathOptions {
    /// For the solution at the end of the path.
    pub solve: Options,
    /// Tolerance on the path. Never tighter than `solve.tolerance`.
    pub tolerance: f64,
    /// First step in λ.
    pub first_step: f64,
    /// Smallest step in λ, no more than the largest: a step that fails at this length ends the continuation.
    pub smallest_step: f64,
    /// Largest step in λ.
    pub largest_step: f64,
    /// The first contraction of Newton's iteration that steps aim at.
    pub contraction: f64,
    /// Newton iterations on each mesh of a step.
    pub max_iterations: usize,
    /// Steps, accepted or not.
    pub max_steps: usize,
}

impl Default for PathOptions {
    fn default() -> Self {
        Self {
            solve: Options::default(),
            tolerance: 1e-3,
            first_step: 0.1,
            smallest_step: 1e-7,
            largest_step: 1.0,
            contraction: 0.25,
            max_iterations: 12,
            max_steps: 1000,
        }
    }
}

impl PathOptions {
    fn check(&self, from: &Checkpoint) -> Result<(), SolveError> {
        if !(0.0..=1.0).contains(&from.position) {
            return Err(SolveError::Option { name: "position", value: from.position, expected: "from 0 to 1" });
        }
        if from.direction.is_some() {
            let expected = "a point of a path, not of a branch";
            return Err(SolveError::Option { name: "position", value: from.position, expected });
        }
        at_least_one([("max_iterations", self.max_iterations)])?;
        positive([
            ("step", from.step),
            ("first_step", self.first_step),
            ("smallest_step", self.smallest_step),
            ("largest_step", self.largest_step),
            ("contraction", self.contraction),
            ("tolerance on the path", self.tolerance),
        ])?;
        if self.smallest_step > self.largest_step {
            let expected = "no more than largest_step";
            return Err(SolveError::Option { name: "smallest_step", value: self.smallest_step, expected });
        }
        Ok(())
    }
}

/// # Errors
/// The first index that is not one of a given constant.
pub(super) fn given(
    name: &'static str,
    indices: &[usize],
    layout: &Layout,
    unknowns: &[usize],
) -> Result<(), SolveError> {
    match indices.iter().find(|index| **index >= layout.constants.len() || unknowns.contains(index)) {
        Some(&index) => Err(SolveError::Option { name, value: index as f64, expected: "constants that are given" }),
        None => Ok(()),
    }
}

/// One step of a continuation, accepted or not.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepRecord {
    /// Path parameter tried.
    pub lambda: f64,
    /// Whether it was reached.
    pub accepted: bool,
    /// First contraction of Newton's iteration; infinite if it failed.
    pub contraction: f64,
    /// Newton iterations, all meshes of the step.
    pub newton_iterations: usize,
    /// Intervals of all regions after the step.
    pub intervals: usize,
}

/// The end of a path.
#[derive(Debug, Clone)]
pub struct Followed {
    /// The solution at λ = 1. Its work counts are those of the whole continuation.
    pub solution: Solution,
    /// All steps, the start being the first.
    pub steps: Vec<StepRecord>,
}

/// A path that could not be followed to its end.
#[derive(Debug, Clone, Error)]
#[error("continuation reached {lambda} of its path in {} steps, then failed: {cause}", .steps.len())]
pub struct PathError {
    /// Path parameter of the last solution; 0 if there was none.
    pub lambda: f64,
    /// The last solution, to the tolerance of the path. `None` if the start itself failed.
    pub last: Option<Box<Solution>>,
    /// All steps.
    pub steps: Vec<StepRecord>,
    /// Why the step beyond it failed, however short it was made.
    pub cause: Box<SolveError>,
}

/// Solves at the start of `path` and follows it to its end.
///
/// # Errors
/// [`PathError`] tells how far it got and why not farther.
pub fn follow<P: Problem + ?Sized>(
    problem: &P,
    start: &Guess,
    path: &dyn Path,
    unknowns: &[usize],
    options: &PathOptions,
) -> Result<Followed, PathError> {
    follow_observed(problem, start, path, unknowns, options, &mut Silent)
}

/// As [`follow`], watched by an observer that may cancel it.
///
/// # Errors
/// As [`follow`].
pub fn follow_observed<P: Problem + ?Sized>(
    problem: &P,
    start: &Guess,
    path: &dyn Path,
    unknowns: &[usize],
    options: &PathOptions,
    observer: &mut dyn Observer,
) -> Result<Followed, PathError> {
    let checkpoint = Checkpoint { position: 0.0, step: options.first_step, guess: start.clone(), direction: None };
    resume_follow(problem, &checkpoint, path, unknowns, options, observer)
}

/// Goes on from a checkpoint of an earlier continuation along the same path.
///
/// # Errors
/// As [`follow`]. The cause is [`SolveError::Option`] if the checkpoint is that of a branch.
pub fn resume_follow<P: Problem + ?Sized>(
    problem: &P,
    from: &Checkpoint,
    path: &dyn Path,
    unknowns: &[usize],
    options: &PathOptions,
    observer: &mut dyn Observer,
) -> Result<Followed, PathError> {
    follow_within(&problem, from, path, unknowns, options, observer, &Budget::new(&options.solve))
}

/// As [`resume_follow`], as a part of a larger computation with a budget of its own.
pub(super) fn follow_within(
    problem: &dyn Problem,
    from: &Checkpoint,
    path: &dyn Path,
    unknowns: &[usize],
    options: &PathOptions,
    observer: &mut dyn Observer,
    budget: &Budget,
) -> Result<Followed, PathError> {
    let start = &from.guess;
    let early = |cause| PathError { lambda: 0.0, last: None, steps: Vec::new(), cause: Box::new(cause) };
    let layout = problem.layout();
    check(layout, start, unknowns, &options.solve).map_err(early)?;
    options.check(from).map_err(early)?;
    given("path", &path.varied(), layout, unknowns).map_err(early)?;
    let plan = Plan::new(layout, unknowns);
    let first = Options { control: Control::Defect, ..options.solve.loosened(options.tolerance) };
    let path_options = Options { max_iterations: options.max_iterations, rescues: 0, ..first.clone() };
    let run = Run::new(problem, plan, &first, observer, budget);
    Follower { run, path, options, path_options: &path_options, steps: Vec::new(), check: BranchCheck::Kept }
        .follow(from)
}

struct Follower<'a, 'o, P: Problem + ?Sized> {
    run: Run<'a, 'o, P>,
    path: &'o dyn Path,
    options: &'o PathOptions,
    /// How each step is solved.
    path_options: &'o Options,
    steps: Vec<StepRecord>,
    /// Whether the branch has been kept so far.
    check: BranchCheck,
}

impl<'a, 'o, P: Problem + ?Sized> Follower<'a, 'o, P> {
    fn follow(mut self, from: &Checkpoint) -> Result<Followed, PathError> {
        let mut start = Start::from(&from.guess);
        let mut lambda = from.position;
        self.path.constants(lambda, &mut start.x.constants);
        let before = self.run.stats;
        let mut here = match self.run.refine(start) {
            Ok(solved) => solved,
            Err(cause) => return Err(PathError { lambda: 0.0, last: None, steps: self.steps, cause: Box::new(cause) }),
        };
        self.record(lambda, before, Some(&here));
        self.check = self.run.check;
        self.run.options = self.path_options;
        let mut step = from.step.min(1.0);
        let mut crossed = 0;
        while lambda < 1.0 {
            if self.steps.len() > self.options.max_steps {
                let cause = SolveError::Steps { steps: self.options.max_steps };
                return Err(self.give_up(&here, lambda, cause));
            }
            // A last sliver would cost a step of its own.
            let next = if lambda + 1.01 * step >= 1.0 { 1.0 } else { lambda + step };
            match self.step(&here, lambda, next) {
                Ok(solved) => {
                    crossed = if self.run.contraction < 1.0 { 0 } else { crossed + 1 };
                    step = self.next_step(next - lambda, crossed);
                    self.checked(&here, &solved, next);
                    (here, lambda) = (solved, next);
                    self.checkpoint(&here, lambda, step);
                }
                Err(cause) => {
                    step = 0.5 * (next - lambda);
                    if step < self.options.smallest_step || cause.is_interruption() {
                        return Err(self.give_up(&here, lambda, cause));
                    }
                }
            }
        }
        self.finish(here)
    }

    fn step(&mut self, here: &Solved<'a, P>, lambda: f64, next: f64) -> Result<Solved<'a, P>, SolveError> {
        let before = self.run.stats;
        let start = self.predict(here, lambda, next)?;
        let outcome = self.run.refine(start);
        self.record(next, before, outcome.as_ref().ok());
        let event = match outcome {
            Ok(_) => Event::Step { step: self.steps.len() - 1, lambda: next },
            Err(_) => Event::Rejected { lambda: next },
        };
        self.run.budget.notify(self.run.observer, &event, &self.run.stats)?;
        outcome
    }

    /// The tangent at `lambda`, followed to `next`, on meshes that suit the solution at `lambda`.
    fn predict(&mut self, here: &Solved<'a, P>, lambda: f64, next: f64) -> Result<Start, SolveError> {
        let mut slope = vec![0.0; here.converged.x.constants.len()];
        self.path.slope(lambda, &mut slope);
        let tangent = tangent(here, &slope, &mut self.run.stats)?;
        let scales = &here.converged.factorisation.scales;
        let mut x = here.system.stepped(&here.converged.x, scales, next - lambda, &tangent);
        self.path.constants(next, &mut x.constants);
        self.path.bend(&here.converged.x.constants, &mut x.constants);
        Ok(Start { grids: here.system.grids.clone(), x })
    }

    /// The next step after an accepted one, the last of `crossed` in a row whose first correction did not contract.
    fn next_step(&self, step: f64, crossed: usize) -> f64 {
        let contraction = self.run.contraction;
        let g = |theta: f64| (1.0 + 4.0 * theta).sqrt() - 1.0;
        let factor = (g(self.options.contraction) / g(contraction.max(1e-6))).sqrt();
        // Where no step is short enough for its first correction to contract, and the iterations converge all the same,
        // how long they take tells more.
        let share = self.run.iterations as f64 / self.options.max_iterations as f64;
        let factor = match crossed < CROSSED {
            true => factor,
            false if share <= QUICK => LONGER,
            false if share <= SLOW => 1.0,
            false => 1.0 / LONGER,
        };
        (step * factor.clamp(0.25, 4.0)).max(self.options.smallest_step).min(self.options.largest_step)
    }

    fn record(&mut self, lambda: f64, before: Stats, solved: Option<&Solved<'_, P>>) {
        self.steps.push(StepRecord {
            lambda,
            accepted: solved.is_some(),
            contraction: self.run.contraction,
            newton_iterations: (self.run.stats - before).newton_iterations,
            intervals: solved.map_or(0, |solved| intervals(&solved.system.grids)),
        });
    }

    /// Whether the step from `here` to `there` has kept the branch.
    fn checked(&mut self, here: &Solved<'_, P>, there: &Solved<'_, P>, lambda: f64) {
        let [before, after] = [here, there].map(|solved| solved.converged.factorisation.orientation());
        self.check = self.check.and(self.run.check.across(before, after).placed(lambda));
    }

    fn checkpoint(&mut self, here: &Solved<'_, P>, position: f64, step: f64) {
        if self.run.observer.wants_checkpoints() {
            let guess = Guess { regions: here.guess(), constants: here.converged.x.constants.clone() };
            self.run.observer.checkpoint(&Checkpoint { position, step, guess, direction: None });
        }
    }

    fn give_up(mut self, here: &Solved<'a, P>, lambda: f64, cause: SolveError) -> PathError {
        let mut last = self.run.finish(here).ok().map(Box::new);
        if let Some(last) = &mut last {
            last.branch_check = self.check;
        }
        PathError { lambda, last, steps: self.steps, cause: Box::new(cause) }
    }

    /// From the tolerance of the path to that of the solution.
    fn finish(mut self, here: Solved<'a, P>) -> Result<Followed, PathError> {
        self.run.options = &self.options.solve;
        // On the path errors were not estimated.
        self.run.keep = false;
        let start = Start { grids: here.system.grids.clone(), x: here.converged.x.clone() };
        let outcome = self.run.refine(start).and_then(|solved| self.run.conclude(solved));
        match outcome {
            Ok(mut solution) => {
                solution.branch_check = self.check.and(solution.branch_check.placed(1.0));
                Ok(Followed { solution, steps: self.steps })
            }
            Err(cause) => {
                self.run.options = self.path_options;
                Err(self.give_up(&here, 1.0, cause))
            }
        }
    }
}

/// d(solution)/dλ for constants that move at the rates `slope`, from the held factorisation.
pub(crate) fn tangent<P: Problem + ?Sized>(
    here: &Solved<'_, P>,
    slope: &[f64],
    stats: &mut Stats,
) -> Result<Correction, SolveError> {
    let mut work = here.system.work();
    let evaluated = here.system.evaluate(&here.converged.x, Derivatives::All, &mut work, stats);
    evaluated.map_err(undefined(&here.system.grids))?;
    let factorisation = &here.converged.factorisation;
    let rhs = here.system.parameter_rhs(&work, &factorisation.scales, slope);
    stats.linear_solves += 1;
    Ok(factorisation.solve(&here.system, rhs))
}
