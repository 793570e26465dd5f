//! Solving what Newton's iteration cannot solve from the guess.

use super::branch::{BranchOptions, PointKind};
use super::checkpoint::Checkpoint;
use super::homotopy::Homotopy;
use super::natural::{PathError, PathOptions, follow_within, given};
use super::path::Ramp;
use super::trace::trace_within;
use crate::accuracy::{Accuracy, Shortfall};
use crate::budget::Budget;
use crate::error::SolveError;
use crate::guess::Guess;
use crate::observer::{Observer, Silent};
use crate::options::{Control, Options};
use crate::problem::{Layout, Problem};
use crate::solution::Solution;
use crate::solve::solve_within;
use crate::stats::Stats;

/// A constant that makes the problem hard.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stiffness {
    /// Index among the layout's constants; a given one.
    pub constant: usize,
    /// A value at which the problem is easy; if unknown, powers of ten times the given value are tried.
    pub easy: Option<f64>,
}

/// How a solution was come by.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum How {
    /// From the guess.
    Direct,
    /// By continuation in the stiffness, from the value `easy`, in so many steps.
    Stiffness {
        /// Where the path began.
        easy: f64,
        /// Steps tried.
        steps: usize,
    },
    /// By deforming the problem from one that the guess solves, in so many points of the branch.
    Homotopy {
        /// Points of the branch.
        points: usize,
    },
}

/// A solution, and how it was come by.
#[derive(Debug, Clone)]
pub struct Automatic {
    /// The solution; its work counts are of the last attempt. Its [`branch_check`](Solution::branch_check) says whether
    /// it is known to be the one that the guess leads to.
    pub solution: Solution,
    /// How.
    pub how: How,
    /// Work of what led to it; attempts that failed are not counted.
    pub stats: Stats,
}

/// Intervals of a region in the direct attempt if other ways are left.
const DIRECT_INTERVALS: usize = 1000;
/// Powers of ten that are tried for the easy value.
const POWERS: i32 = 8;

/// Solves directly if possible; else by continuation in the stiffness, if one is named; else by deforming the problem
/// from one that the guess solves.
///
/// # Errors
/// Options that make no sense; else why the direct attempt failed, if all else failed too.
pub fn solve_automatically<P: Problem + ?Sized>(
    problem: &P,
    guess: &Guess,
    unknowns: &[usize],
    stiffness: Option<Stiffness>,
    options: &Options,
) -> Result<Automatic, SolveError> {
    solve_automatically_observed(problem, guess, unknowns, stiffness, options, &mut Silent)
}

/// As [`solve_automatically`], watched by an observer that may cancel it.
///
/// # Errors
/// As [`solve_automatically`].
pub fn solve_automatically_observed<P: Problem + ?Sized>(
    problem: &P,
    guess: &Guess,
    unknowns: &[usize],
    stiffness: Option<Stiffness>,
    options: &Options,
    observer: &mut dyn Observer,
) -> Result<Automatic, SolveError> {
    solve_any(&problem, guess, unknowns, stiffness, options, observer)
}

fn solve_any(
    problem: &dyn Problem,
    guess: &Guess,
    unknowns: &[usize],
    stiffness: Option<Stiffness>,
    options: &Options,
    observer: &mut dyn Observer,
) -> Result<Automatic, SolveError> {
    let varied = stiffness.map(|stiffness| stiffness.constant);
    given("stiffness", varied.as_slice(), problem.layout(), unknowns)?;
    if let Some(easy) = stiffness.and_then(|stiffness| stiffness.easy).filter(|easy| !easy.is_finite()) {
        return Err(SolveError::Option { name: "easy", value: easy, expected: "a finite number" });
    }
    let intervals =
        if stiffness.is_some() { options.max_intervals.min(DIRECT_INTERVALS) } else { options.max_intervals };
    let direct = Options { max_intervals: intervals, ..options.clone() };
    let budget = Budget::new(options);
    let mut attempt = Attempt { problem, guess, unknowns, options, observer, budget: &budget, stats: Stats::default() };
    let mut outcome = solve_within(problem, guess, unknowns, &direct, attempt.observer, &budget);
    let short = match &outcome {
        Ok(solution) => matches!(solution.accuracy(), Accuracy::Short { because: Shortfall::Mesh, .. }),
        Err(error) => matches!(error, SolveError::Inaccurate { because: Shortfall::Mesh, .. }),
    };
    if intervals < options.max_intervals && short {
        outcome = solve_within(problem, guess, unknowns, options, attempt.observer, &budget);
    }
    let failure = match outcome {
        Ok(solution) => {
            let stats = *solution.stats();
            return Ok(Automatic { solution, how: How::Direct, stats });
        }
        Err(error) if error.is_final() => return Err(error),
        Err(error) => error,
    };
    let found = match stiffness {
        Some(stiffness) => attempt.by_stiffness(stiffness)?,
        None => None,
    };
    let found = match found {
        Some(found) => Some(found),
        None => attempt.by_homotopy()?,
    };
    match found {
        Some((solution, how)) => Ok(Automatic { solution, how, stats: attempt.stats }),
        None => Err(failure),
    }
}

struct Attempt<'a> {
    problem: &'a dyn Problem,
    guess: &'a Guess,
    unknowns: &'a [usize],
    options: &'a Options,
    observer: &'a mut dyn Observer,
    budget: &'a Budget,
    stats: Stats,
}

type Found = Option<(Solution, How)>;

impl Attempt<'_> {
    /// # Errors
    /// Only cancellation, and work that is spent.
    fn by_stiffness(&mut self, stiffness: Stiffness) -> Result<Found, SolveError> {
        let Some(&value) = self.guess.constants.get(stiffness.constant) else { return Ok(None) };
        let powers = (1..=POWERS).flat_map(|power| [10.0_f64.powi(power), 10.0_f64.powi(-power)]);
        let candidates: Vec<f64> = match stiffness.easy {
            Some(easy) => vec![easy],
            None => powers.map(|factor| factor * value).collect(),
        };
        // Where a layer's place depends on how well it is resolved, steps must be solved as well as their end.
        let loose = PathOptions { solve: self.options.clone(), ..PathOptions::default() };
        let tight = PathOptions { tolerance: self.options.tolerance, ..loose.clone() };
        let each = |path| candidates.iter().filter(|easy| **easy != value).map(move |easy| (path, *easy));
        for (path, easy) in each(&loose).chain(each(&tight)) {
            let ramp = Ramp::new().geometric(stiffness.constant, easy, value);
            let start = Checkpoint { position: 0.0, step: path.first_step, guess: self.guess.clone(), direction: None };
            match follow_within(self.problem, &start, &ramp, self.unknowns, path, self.observer, self.budget) {
                Ok(followed) => {
                    self.stats += *followed.solution.stats();
                    let how = How::Stiffness { easy, steps: followed.steps.len() };
                    return Ok(Some((followed.solution, how)));
                }
                Err(PathError { cause, .. }) if cause.is_interruption() => return Err(*cause),
                Err(_) => {}
            }
        }
        Ok(None)
    }

    /// # Errors
    /// Only cancellation, and work that is spent.
    fn by_homotopy(&mut self) -> Result<Found, SolveError> {
        let homotopy = Homotopy::new(self.problem, self.guess, self.budget);
        let layout: &Layout = homotopy.layout();
        let t = layout.constants.len() - 1;
        let mut start = self.guess.clone();
        start.constants.push(0.0);
        let on_path = Options { control: Control::Defect, ..self.options.loosened(1e-2) };
        // What else branches off on the way is of no concern.
        let options = BranchOptions {
            solve: on_path,
            range: (-1.0, 1.0),
            max_points: 300,
            resolve_branch_points: false,
            ..BranchOptions::default()
        };
        let (unknowns, budget) = (self.unknowns, self.budget);
        let branch = match trace_within(&homotopy, &start, t, unknowns, &options, &[], self.observer, budget) {
            Ok(branch) => branch,
            Err(error) if error.cause.is_interruption() => return Err(*error.cause),
            Err(_) => return Ok(None),
        };
        self.stats += branch.stats;
        self.stats.rhs_points += homotopy.points();
        let points = branch.points.len();
        let Some(last) = branch.points.last().filter(|last| last.kind == PointKind::End && last.parameter > 0.5) else {
            return Ok(None);
        };
        let mut end = Guess::from(&last.solution);
        end.constants.truncate(t);
        match solve_within(self.problem, &end, unknowns, self.options, self.observer, budget) {
            Ok(mut solution) => {
                self.stats += *solution.stats();
                solution.branch_check = branch.check.and(solution.branch_check.placed(1.0));
                Ok(Some((solution, How::Homotopy { points })))
            }
            Err(error) if error.is_interruption() => Err(error),
            Err(_) => Ok(None),
        }
    }
}
