//! From a question to a solution, from nothing.

use solver::continuation::{PathOptions, follow_observed};
use solver::{Guess, Options, Order, Solution, SolveError, Stats};

use super::approach::approach;
use super::belt::BeltProblem;
use super::budget::Budget;
use super::correct::{corrected, relaxed};
use super::failure::Failure;
use super::question::{Question, Swap};
use super::route::Route;
use super::solved::{Solved, accepted};
use super::start;
use crate::case::{ModelChoices, Resolved};
use crate::model::{Constant, Constants};

/// Tolerance on the path from the start to the case.
pub(super) const ROUGH_TOLERANCE: f64 = 1e-2;
/// Factor on it where the path is followed on finer meshes.
const FINER: f64 = 0.1;
/// The same for a belt without bending stiffness.
const STRING_TOLERANCE: f64 = 1e-3;
/// Newton iterations of a step on the path: where the belt adheres at 1e-5 m/s, kinks travel over the mesh for a while.
const WAY_ITERATIONS: usize = 25;
/// The same for a belt without bending stiffness.
const STRING_ITERATIONS: usize = 30;
/// Intervals of a region on the path.
const WAY_INTERVALS: usize = 2000;
/// Smallest step on a stage of the path, as a share of the stage.
const SMALLEST_STEP: f64 = 1e-4;
/// Steps on a stage of the path, accepted or not.
const LEG_STEPS: usize = 400;
/// Factors on the estimated slack tension from which prescribed values are approached, tried in turn.
const TENSIONS: [f64; 4] = [1.0, 3.0, 0.4, 0.05];

/// Newton iterations of a solve from nothing, unless asked otherwise.
pub const WORK_LIMIT: usize = 14_000;

/// How accurately, and with what.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SolveOptions {
    /// Largest relative defect of the solution.
    pub tolerance: f64,
    /// Order of the collocation.
    pub order: Order,
    /// Whether derivatives of the outputs with respect to the given constants are wanted.
    pub sensitivities: bool,
    /// Newton iterations that a solve from nothing may take, over all routes that it tries.
    pub work_limit: usize,
}

impl Default for SolveOptions {
    fn default() -> Self {
        Self { tolerance: 1e-6, order: Order::Four, sensitivities: false, work_limit: WORK_LIMIT }
    }
}

impl SolveOptions {
    /// For the solver. What is asked of a belt is that its defects meet the tolerance; where a design amplifies them,
    /// the solver's estimate of the error may exceed it all the same.
    pub(super) fn solver(&self) -> Options {
        let (tolerance, order) = (self.tolerance, self.order);
        let cancel = crate::cancel::current();
        Options { tolerance, order, cancel, accept_inaccurate: true, ..Options::default() }
    }
}

/// Solves a case from nothing; see [`solve_question`].
///
/// # Errors
/// See [`Failure`].
pub fn solve(case: &Resolved, options: &SolveOptions) -> Result<Solved, Failure> {
    if case.operating_point.margin.is_some() {
        return Err(Failure::MarginGiven);
    }
    solve_question(&case.model, &Question::of(case), options)
}

/// Answers a question from nothing: a straight belt under a small torque, at a tension that wraps it, with friction
/// that is linear in the sliding speed; then torque, slip threshold and tension go where the question wants them, or
/// near it where they are unknown. From there the values found of what is prescribed move to the values asked for, with
/// the constants unknown that are to be found: one boundary value problem at every step.
///
/// # Errors
/// See [`Failure`].
pub fn solve_question(model: &ModelChoices, question: &Question, options: &SolveOptions) -> Result<Solved, Failure> {
    question.check(model)?;
    if question.is_ordinary() {
        return ordinary(model, question, options);
    }
    let mut failure = None;
    for factor in TENSIONS {
        let near = match near(model, question, factor, options) {
            Ok(near) => near,
            Err(next) => {
                failure = Some(Failure::farther(failure, next));
                continue;
            }
        };
        for order in [together, one_by_one] {
            match order(model, &near, question, options) {
                Ok(solved) => return Ok(solved),
                Err(next) => failure = Some(Failure::farther(failure, next)),
            }
        }
    }
    Err(failure.unwrap_or(Failure::NoEquations))
}

/// An ordinary solution, to the tolerance of the path, near that of a question.
fn near(model: &ModelChoices, question: &Question, factor: f64, options: &SolveOptions) -> Result<Solved, Failure> {
    let mut constants = question.constants.clone();
    if question.frees(Constant::SlackTension) {
        constants[Constant::SlackTension] *= factor;
    } else if question.frees(Constant::PrimaryTorque) {
        constants[Constant::PrimaryTorque] /= factor;
    }
    let rough = SolveOptions { tolerance: options.tolerance.max(ROUGH_TOLERANCE), ..*options };
    ordinary(model, &Question::new(constants), &rough)
}

/// Answers a question from the solution of another, however far: everything that is prescribed goes there at once, in as
/// many steps as that takes.
///
/// # Errors
/// See [`Failure`].
pub fn approach_question(
    from: &Solved,
    model: &ModelChoices,
    question: &Question,
    options: &SolveOptions,
) -> Result<Solved, Failure> {
    question.check(model)?;
    together(model, from, question, options)
}

/// Moves everything that is prescribed at once.
fn together(
    model: &ModelChoices,
    near: &Solved,
    question: &Question,
    options: &SolveOptions,
) -> Result<Solved, Failure> {
    approach(model, near, question, &path_options(model, options.solver()))
}

/// Moves what is prescribed one value after the other.
fn one_by_one(
    model: &ModelChoices,
    near: &Solved,
    question: &Question,
    options: &SolveOptions,
) -> Result<Solved, Failure> {
    let mut here = near.clone();
    let (count, constants) = (question.swaps.len(), &near.question.constants);
    if count == 0 {
        return together(model, near, question, options);
    }
    for done in 1..=count {
        let swaps: Vec<Swap> = question.swaps.iter().take(done).copied().collect();
        let closings = if done == count { question.closings.clone() } else { Vec::new() };
        let next = Question { constants: constants.clone(), swaps, closings };
        let solver = if done == count { options.solver() } else { rough(options) };
        here = approach(model, &here, &next, &path_options(model, solver))?;
    }
    here.question = question.clone();
    Ok(here)
}

fn rough(options: &SolveOptions) -> Options {
    Options { tolerance: options.tolerance.max(ROUGH_TOLERANCE), max_intervals: WAY_INTERVALS, ..options.solver() }
}

/// How a stage of the path is followed, `solve` being for its end.
fn path_options(model: &ModelChoices, solve: Options) -> PathOptions {
    let (tolerance, max_iterations) = match model.bending {
        Some(_) => (ROUGH_TOLERANCE, WAY_ITERATIONS),
        // Nothing smooths a string's way into the groove: coarse meshes miss it, and Newton's iteration takes its time.
        None => (STRING_TOLERANCE, STRING_ITERATIONS),
    };
    PathOptions {
        solve,
        tolerance,
        max_iterations,
        smallest_step: SMALLEST_STEP,
        max_steps: LEG_STEPS,
        ..PathOptions::default()
    }
}

/// A question without swaps: by the routes in turn, until one arrives or the work limit is reached.
fn ordinary(model: &ModelChoices, question: &Question, options: &SolveOptions) -> Result<Solved, Failure> {
    let target = &question.constants;
    let belt = BeltProblem::new(model, target).ok_or(Failure::NoEquations)?;
    let mut failure = None;
    let mut budget = Budget::new(options.work_limit);
    for route in Route::ALL {
        let given = budget.part(options.work_limit / Route::ALL.len());
        let mut left = given;
        let climbed = climb(model, &belt, route, target, options, &mut left);
        budget.take(&given, &left);
        match climbed {
            Ok((solution, stats, continuation_steps)) => {
                let (question, route) = (question.clone(), Some(route));
                return Ok(Solved { question, belt, solution, stats, continuation_steps, route });
            }
            Err(next) => {
                let spent = given.left() - left.left();
                tracing::debug!("the route by {} was lost after {spent} Newton iterations: {next}", route.name());
                failure = Some(Failure::farther(failure, next));
            }
        }
        if budget.is_spent() {
            break;
        }
    }
    Err(failure.unwrap_or(Failure::NoEquations))
}

/// Follows the stages of a route; where the path is lost, it goes on from there once more, on finer meshes.
fn climb(
    model: &ModelChoices,
    belt: &BeltProblem,
    route: Route,
    target: &Constants,
    options: &SolveOptions,
    budget: &mut Budget,
) -> Result<(Solution, Stats, usize), Failure> {
    let begin = route.begin(target);
    let mut climb = Climb { model, belt, route, target, options, stats: Stats::default(), steps: 0 };
    let lost = match climb.follow(start::guess(belt, &begin), &begin, Mesh::Coarse, budget) {
        Ok(solution) => return Ok((solution, climb.stats, climb.steps)),
        Err(lost) => lost,
    };
    let Some(last) = lost.last.filter(|_| model.bending.is_some() && !budget.is_spent()) else {
        return Err(lost.failure);
    };
    let solution = climb.follow(Guess::from(&*last), &Constants::of(&last), Mesh::Fine, budget);
    let solution = solution.map_err(|again| Failure::farther(Some(lost.failure), again.failure))?;
    Ok((solution, climb.stats, climb.steps))
}

/// How fine the meshes of the path are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Mesh {
    Coarse,
    Fine,
}

/// The path along a route.
struct Climb<'a> {
    model: &'a ModelChoices,
    belt: &'a BeltProblem,
    route: Route,
    target: &'a Constants,
    options: &'a SolveOptions,
    stats: Stats,
    steps: usize,
}

/// Where the path was lost, and why.
struct Lost {
    last: Option<Box<Solution>>,
    failure: Failure,
}

impl Lost {
    fn new(last: Option<Box<Solution>>, cause: Box<SolveError>) -> Self {
        Self { failure: Failure::of(last.as_deref(), cause), last }
    }
}

impl Climb<'_> {
    /// Follows the stages from a guess whose given constants are those of `begin`.
    fn follow(&mut self, guess: Guess, begin: &Constants, mesh: Mesh, budget: &mut Budget) -> Result<Solution, Lost> {
        let stages = self.route.stages(begin, self.target);
        let unknowns: Vec<usize> = (0..Constant::UNKNOWN).collect();
        let (count, mut guess, mut found) = (stages.len(), guess, None::<Solution>);
        for (index, path) in stages.into_iter().enumerate() {
            let solver = if index + 1 == count { self.options.solver() } else { rough(self.options) };
            let mut options = path_options(self.model, relaxed(&solver));
            if mesh == Mesh::Fine {
                options.tolerance *= FINER;
                options.max_iterations *= 2;
            }
            let followed = follow_observed(self.belt, &guess, &path, &unknowns, &options, budget);
            // What was found on the stages before is as good a place to go on from.
            let followed = followed.map_err(|error| Lost::new(error.last.or(found.map(Box::new)), error.cause))?;
            self.stats += *followed.solution.stats();
            self.steps += accepted(&followed);
            let solution = corrected(self.belt, followed.solution, &solver, false, &mut self.stats)
                .map_err(|(last, cause)| Lost::new(Some(last), Box::new(cause)))?;
            guess = Guess::from(&solution);
            found = Some(solution);
        }
        found.ok_or(Lost { last: None, failure: Failure::NoEquations })
    }
}
