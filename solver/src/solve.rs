//! Solving from a guess.

use crate::budget::Budget;
use crate::collocation::plan::Plan;
use crate::error::SolveError;
use crate::guess::Guess;
use crate::magnitude;
use crate::observer::{Observer, Silent};
use crate::options::Options;
use crate::problem::{Layout, Problem};
use crate::run::Run;
use crate::solution::Solution;
use crate::start::Start;

/// Solves a boundary value problem from a guess, on meshes refined until the tolerance is met.
///
/// `unknowns`: which constants to find, as indices into the layout's constants; there must be as many boundary
/// equations as states and unknowns together. A warm start is [`Guess::from`] a solution; if it turns out to be far
/// away, and its meshes are fine, a solution to 1e-3 is sought first, on coarser ones.
///
/// # Errors
/// See [`SolveError`]. Success means that Newton's correction, the boundary residuals and the defects have all
/// met their tolerances on the solution's mesh.
pub fn solve<P: Problem + ?Sized>(
    problem: &P,
    guess: &Guess,
    unknowns: &[usize],
    options: &Options,
) -> Result<Solution, SolveError> {
    solve_observed(problem, guess, unknowns, options, &mut Silent)
}

/// As [`solve`], watched by an observer that may cancel it.
///
/// # Errors
/// As [`solve`].
pub fn solve_observed<P: Problem + ?Sized>(
    problem: &P,
    guess: &Guess,
    unknowns: &[usize],
    options: &Options,
    observer: &mut dyn Observer,
) -> Result<Solution, SolveError> {
    solve_within(&problem, guess, unknowns, options, observer, &Budget::new(options))
}

/// As [`solve_observed`], as a part of a larger computation with a budget of its own.
pub(crate) fn solve_within(
    problem: &dyn Problem,
    guess: &Guess,
    unknowns: &[usize],
    options: &Options,
    observer: &mut dyn Observer,
    budget: &Budget,
) -> Result<Solution, SolveError> {
    let layout = problem.layout();
    check(layout, guess, unknowns, options)?;
    let plan = Plan::new(layout, unknowns);
    let mut run = Run::new(problem, plan, options, observer, budget);
    run.from_afar = true;
    let solved = run.refine(Start::from(guess))?;
    run.conclude(solved)
}

/// # Errors
/// The first input that makes no sense.
pub(crate) fn check(layout: &Layout, guess: &Guess, unknowns: &[usize], options: &Options) -> Result<(), SolveError> {
    options.check()?;
    layout.check()?;
    magnitude::check(layout, options)?;
    guess.check(layout)?;
    let constants = layout.constants.len();
    for (i, &index) in unknowns.iter().enumerate() {
        if index >= constants || unknowns[..i].contains(&index) {
            return Err(SolveError::Unknowns { index, constants });
        }
    }
    let (equations, states) = (layout.equations.len(), layout.states());
    if equations != states + unknowns.len() {
        return Err(SolveError::Count { equations, states, unknowns: unknowns.len() });
    }
    Ok(())
}
