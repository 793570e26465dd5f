//! From a question to a solution, from nothing.

use std::collections::VecDeque;

use solver::{Guess, Options};

use super::approach::approach;
use super::belt::BeltProblem;
use super::budget::Budget;
use super::climb::climb;
use super::failure::Failure;
use super::influence::check_influence;
use super::options::{ROUGH_TOLERANCE, SolveOptions, path_options, rough};
use super::position::Position;
use super::question::{Question, Swap};
use super::route::Route;
use super::solved::Solved;
use super::trouble::Trouble;
use crate::cancel::is_cancelled;
use crate::case::{ModelChoices, Resolved};
use crate::model::{Constant, Output};

/// Tolerances to which a solution is sought that was not found to the one asked for.
const LADDER: [f64; 3] = [1e-4, 1e-6, 1e-3];
/// A tighter tolerance, over that asked for: its finer meshes are another way to a solution.
const TIGHTER: f64 = 0.1;
/// Tighter than this none is tried.
const TIGHTEST: f64 = 1e-11;
/// Over the tolerance asked for, what the last step but one towards it is at least.
const AT_LEAST: f64 = 2.0;
/// Factors on what is unknown for a prescribed value, from which that is approached, tried in turn: on the first of
/// [`SCALED`] that is.
const FACTORS: [f64; 4] = [1.0, 3.0, 0.4, 0.05];
/// Constants whose estimates may be off by such a factor. More torque is as less tension.
const SCALED: [Constant; 8] = [
    Constant::SlackTension,
    Constant::PrimaryTorque,
    Constant::BendingStiffness,
    Constant::RadialStiffness,
    Constant::LongitudinalStiffness,
    Constant::FrictionCoefficient,
    Constant::MassPerLength,
    Constant::PrimarySpeed,
];

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
    let mut budget = Budget::new(options.work_limit);
    match attempt(model, question, options, Routes::UntilThere, &mut budget) {
        Err(failure) if failure.is_at(question) => match at_another_tolerance(model, question, options, &mut budget) {
            Some(answer) => answer,
            // What little work may be left finds no more than a beginning: what was found before tells more.
            None => attempt(model, question, options, Routes::All, &mut budget).map_err(|again| match again {
                Failure::Cancelled => again,
                again => Failure::farther(Some(failure), again, &question.constants),
            }),
        },
        answer => answer,
    }
}

/// A question whose path was followed to its end and no farther: by a solution to another tolerance, tighter ones last;
/// nothing if there is none, either. If none of them is made accurate enough, the failure that attains most.
fn at_another_tolerance(
    model: &ModelChoices,
    question: &Question,
    options: &SolveOptions,
    budget: &mut Budget,
) -> Option<Result<Solved, Failure>> {
    let mut nearest: Option<(f64, Failure)> = None;
    let differ = |one: f64, other: f64| libm::log10(one / other).abs() > 0.5;
    let tighter = (TIGHTER * options.tolerance).max(TIGHTEST);
    let tighter = LADDER.into_iter().all(|other| differ(other, tighter)).then_some(tighter);
    for tolerance in LADDER.into_iter().chain(tighter).filter(|other| differ(*other, options.tolerance)) {
        let other = SolveOptions { tolerance, ..*options };
        let found = match attempt(model, question, &other, Routes::UntilThere, budget) {
            Ok(found) => found,
            Err(Failure::Cancelled) => return Some(Err(Failure::Cancelled)),
            Err(_) => continue,
        };
        tracing::info!("not found to {:.0e}, and found to {tolerance:.0e}", options.tolerance);
        // A solution that holds more than was asked for holds that, too.
        let enough = tolerance <= options.tolerance;
        let answer = if enough { Ok(found) } else { tightened(found, tolerance, options, budget) };
        match answer {
            Err(failure @ Failure::Tolerance { attainable, .. }) if !budget.is_spent() => {
                if nearest.as_ref().is_none_or(|(least, _)| attainable < *least) {
                    nearest = Some((attainable, failure));
                }
            }
            answer => return Some(answer),
        }
    }
    nearest.map(|(_, failure)| Err(failure))
}

/// A solution made more accurate, step by step.
fn tightened(
    mut solved: Solved,
    mut attained: f64,
    options: &SolveOptions,
    budget: &mut Budget,
) -> Result<Solved, Failure> {
    while attained > options.tolerance {
        // A step that ends within rounding of what is asked for ends there.
        let next = 0.1 * attained;
        let tolerance = if next < AT_LEAST * options.tolerance { options.tolerance } else { next };
        let finer = Options { tolerance, ..options.solver() };
        let unknowns = solved.solution.unknowns().to_vec();
        match solver::solve_observed(&solved.belt, &Guess::from(&solved.solution), &unknowns, &finer, budget) {
            Ok(solution) => {
                solved.stats += *solution.stats();
                (solved.solution, attained) = (solution, tolerance);
            }
            Err(_) if is_cancelled() => return Err(Failure::Cancelled),
            Err(cause) => {
                return Err(Failure::Tolerance {
                    asked: options.tolerance,
                    attainable: attained,
                    cause: Box::new(cause),
                });
            }
        }
    }
    Ok(solved)
}

/// How many routes are tried.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Routes {
    /// No more once one has led to the case, whether or not it has a solution there to the tolerance.
    UntilThere,
    /// No more once one has shown that the belt slips: of a start that was guessed, for which there are others.
    UntilSlipping,
    /// All, until there is a solution.
    All,
}

/// Answers a question to the tolerance of `options`.
fn attempt(
    model: &ModelChoices,
    question: &Question,
    options: &SolveOptions,
    routes: Routes,
    budget: &mut Budget,
) -> Result<Solved, Failure> {
    if question.is_ordinary() {
        return ordinary(model, question, options, routes, budget);
    }
    let (target, mut failure) = (&question.constants, None);
    let scaled = SCALED.into_iter().find(|constant| question.frees(*constant));
    // Where there is nothing to scale, every start is the same.
    let (mut factors, mut first) =
        (if scaled.is_some() { VecDeque::from(FACTORS) } else { VecDeque::from([FACTORS[0]]) }, true);
    while let Some(factor) = factors.pop_front() {
        let near = match near(model, question, (scaled, factor), options, budget) {
            Ok(near) => near,
            Err(next) => {
                failure = Some(Failure::farther(failure, next, target));
                continue;
            }
        };
        if std::mem::take(&mut first)
            && let Some(nearer) = nearer(&near, question, factor)?
        {
            factors.push_front(nearer);
        }
        for order in [together, one_by_one] {
            let given = budget.part(options.work_limit / (2 * FACTORS.len()));
            let mut left = given;
            let answer = order(model, &near, question, options, &mut left);
            budget.take(&given, &left);
            match answer {
                Ok(solved) => return Ok(solved),
                Err(next) => failure = Some(Failure::farther(failure, next, target)),
            }
        }
        if is_cancelled() || budget.is_spent() {
            break;
        }
        // Only what is not reached is worth a look at why.
        check_influence(&near, question)?;
    }
    Err(ended(failure))
}

/// Why everything that was tried came to nothing.
fn ended(failure: Option<Failure>) -> Failure {
    if is_cancelled() { Failure::Cancelled } else { failure.unwrap_or(Failure::NoEquations) }
}

/// The factor with which an axial force that is prescribed would be found, were it proportional to the tension: where
/// friction is steep, a path of a tenth of the tension may be too long. Nothing for what else is prescribed.
fn nearer(near: &Solved, question: &Question, factor: f64) -> Result<Option<f64>, Failure> {
    let force = question.conditions().zip(Position::of(near, question)?.targets).find(|((output, _), _)| {
        question.frees(Constant::SlackTension)
            && matches!(output, Output::PrimaryAxialForce | Output::SecondaryAxialForce)
    });
    let nearer = force.map(|((_, asked), found)| factor * asked / found);
    Ok(nearer.filter(|nearer| nearer.is_finite() && *nearer > 0.0))
}

/// An ordinary solution, to the tolerance of the path, near that of a question.
fn near(
    model: &ModelChoices,
    question: &Question,
    (scaled, factor): (Option<Constant>, f64),
    options: &SolveOptions,
    budget: &mut Budget,
) -> Result<Solved, Failure> {
    let mut constants = question.constants.clone();
    match scaled {
        Some(Constant::PrimaryTorque) => constants[Constant::PrimaryTorque] /= factor,
        Some(constant) => constants[constant] *= factor,
        None => {}
    }
    let rough = SolveOptions { tolerance: options.tolerance.max(ROUGH_TOLERANCE), ..*options };
    ordinary(model, &Question::new(constants), &rough, Routes::UntilSlipping, budget)
}

/// Answers a question from the solution of another, however far: everything that is prescribed goes there at once, in
/// as many steps as that takes.
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
    let mut budget = Budget::new(options.work_limit);
    together(model, from, question, options, &mut budget)
}

/// Moves everything that is prescribed at once.
fn together(
    model: &ModelChoices,
    near: &Solved,
    question: &Question,
    options: &SolveOptions,
    budget: &mut Budget,
) -> Result<Solved, Failure> {
    approach(model, near, question, &path_options(model, options.solver()), budget)
}

/// Moves what is prescribed one value after the other.
fn one_by_one(
    model: &ModelChoices,
    near: &Solved,
    question: &Question,
    options: &SolveOptions,
    budget: &mut Budget,
) -> Result<Solved, Failure> {
    let mut here = near.clone();
    let (count, constants) = (question.swaps.len(), &near.question.constants);
    if count == 0 {
        return together(model, near, question, options, budget);
    }
    for done in 1..=count {
        let swaps: Vec<Swap> = question.swaps.iter().take(done).copied().collect();
        let closings = if done == count { question.closings.clone() } else { Vec::new() };
        let next = Question { constants: constants.clone(), swaps, closings };
        let solver = if done == count { options.solver() } else { rough(options) };
        here = approach(model, &here, &next, &path_options(model, solver), budget)?;
    }
    here.question = question.clone();
    Ok(here)
}

/// A question without swaps: by the routes in turn, until one arrives or the work limit is reached.
fn ordinary(
    model: &ModelChoices,
    question: &Question,
    options: &SolveOptions,
    routes: Routes,
    budget: &mut Budget,
) -> Result<Solved, Failure> {
    let target = &question.constants;
    let belt = BeltProblem::new(model, target).ok_or(Failure::NoEquations)?;
    let mut failure = None;
    let routes_to_try: Vec<Route> = Route::ALL.into_iter().filter(|route| route.is_for(model, target)).collect();
    let mut parts: usize = routes_to_try.iter().map(|route| route.parts()).sum();
    for route in routes_to_try {
        // What a route leaves is for those after it.
        let given = budget.part(route.parts() * (budget.left() / parts));
        parts -= route.parts();
        let mut left = given;
        let climbed = climb(model, &belt, route, target, options, &mut left);
        budget.take(&given, &left);
        let spent = given.left() - left.left();
        match climbed {
            Ok((solution, stats, continuation_steps)) => {
                tracing::info!("solved by the route {:?}, {continuation_steps} continuation steps", route.name());
                let (question, route) = (question.clone(), Some(route));
                return Ok(Solved { question, belt, solution, stats, continuation_steps, route });
            }
            Err(next) => {
                tracing::info!("the route {:?} was lost after work of {spent}: {next}", route.name());
                if let Some(words) = next.solver() {
                    tracing::debug!("the solver says: {words}");
                }
                let enough = match routes {
                    Routes::UntilThere => next.is_at(question),
                    Routes::UntilSlipping => next.trouble().is_some_and(Trouble::slips),
                    Routes::All => false,
                };
                failure = Some(Failure::farther(failure, next, target));
                if enough {
                    break;
                }
            }
        }
        // Where a strand would be pushed, no other route has more.
        if is_cancelled() || budget.is_spent() || Trouble::of_case(target).is_some() {
            break;
        }
    }
    Err(ended(failure))
}
