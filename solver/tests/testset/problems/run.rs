//! Solving a case and judging the result.

use crate::problems::catalogue::{Case, Reference};
use solver::continuation::{PathOptions, Ramp, Stiffness, follow, solve_automatically};
use solver::{Guess, Linearisation, Options, Order, Solution, solve};
use std::time::Instant;

/// How a solution was reached.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum How {
    /// From the suggested guess.
    Direct,
    /// Along a path in the parameter, of so many steps.
    Continued(usize),
    /// By deforming the problem, over so many points.
    Deformed(usize),
}

/// What a run brought.
pub struct Outcome {
    pub solution: Result<Solution, String>,
    pub how: How,
    pub seconds: f64,
}

/// Solves from the suggested guess, automatically by continuation where that fails: the parameter is named as what
/// makes the problem hard if the data suggests where to continue from.
pub fn run(case: &Case, parameter: Option<f64>, options: &Options) -> Outcome {
    let start = Instant::now();
    let stiffness = case.continue_from.zip(case.parameter);
    let stiffness = stiffness.map(|(easy, constant)| Stiffness { constant, easy: Some(easy) });
    let found = solve_automatically(&*case.problem, &case.guess(parameter), &case.unknowns, stiffness, options);
    let seconds = start.elapsed().as_secs_f64();
    match found {
        Err(error) => Outcome { solution: Err(error.to_string()), how: How::Direct, seconds },
        Ok(found) => {
            let how = match found.how {
                solver::continuation::How::Direct => How::Direct,
                solver::continuation::How::Stiffness { steps, .. } => How::Continued(steps),
                solver::continuation::How::Homotopy { points } => How::Deformed(points),
            };
            Outcome { solution: Ok(found.solution), how, seconds }
        }
    }
}

/// Why the suggested guess does not lead to a solution directly, if it does not.
pub fn obstacle(case: &Case, parameter: Option<f64>, options: &Options) -> Option<String> {
    solve(&*case.problem, &case.guess(parameter), &case.unknowns, options).err().map(|error| error.to_string())
}

/// By continuation in the parameter; `None` where none is suggested.
pub fn continued(case: &Case, parameter: Option<f64>, options: &Options) -> Option<(Result<Solution, String>, usize)> {
    let (from, to, index) = (case.continue_from?, parameter?, case.parameter?);
    let path = Ramp::new().geometric(index, from, to);
    let options = PathOptions { solve: options.clone(), ..PathOptions::default() };
    Some(match follow(&*case.problem, &case.guess(Some(from)), &path, &case.unknowns, &options) {
        Ok(followed) => (Ok(followed.solution), followed.steps.len()),
        Err(error) => (Err(error.to_string()), error.steps.len()),
    })
}

/// Largest reaction of the solution to defects and boundary residuals of 1, in units of typical magnitudes.
pub fn kappa(case: &Case, solution: &Solution) -> f64 {
    Linearisation::new(&*case.problem, solution).map_or(f64::NAN, |linearised| linearised.conditioning().kappa())
}

/// True errors, in the data's convention: largest over components and points of `|difference| / (1 + max |y_i|)`.
#[derive(Debug, Clone)]
pub struct Errors {
    /// At the tabulated points, and in the constants found.
    pub tabulated: f64,
    /// At four points of every interval: against the closed form, else against a solution to a tolerance of 1e-10.
    /// NaN if that could not be had.
    pub everywhere: f64,
    /// Which of several solutions it is.
    pub solution: Option<String>,
}

/// The true errors of a solution.
pub fn errors(case: &Case, parameter: Option<f64>, solution: &Solution) -> Errors {
    let references = case.references(parameter);
    let against = |reference: &Reference| tabulated(case, solution, reference);
    let nearest = references.iter().min_by(|a, b| against(a).total_cmp(&against(b))).unwrap();
    let exact = case.exact.as_ref().filter(|_| nearest.solution.as_deref() != Some("COSH3"));
    let c = case.constants_at(parameter);
    let everywhere = match exact {
        Some(exact) => everywhere(solution, &nearest.peak, |region, x| exact(region, x, &c).0),
        None => match solve(&*case.problem, &Guess::from(solution), &case.unknowns, &tight()) {
            Ok(better) if against_itself(case, &better, nearest) => {
                everywhere(solution, &nearest.peak, |region, x| better.regions()[region].eval(x))
            }
            _ => f64::NAN,
        },
    };
    Errors { tabulated: against(nearest), everywhere, solution: nearest.solution.clone() }
}

/// For the comparison where there is no closed form.
fn tight() -> Options {
    Options { order: Order::Six, tolerance: 1e-10, max_intervals: 50_000, ..Options::default() }
}

/// A solution to compare with must itself agree with the table.
fn against_itself(case: &Case, better: &Solution, reference: &Reference) -> bool {
    tabulated(case, better, reference) < 1e-8
}

fn tabulated(case: &Case, solution: &Solution, reference: &Reference) -> f64 {
    let regions = solution.regions();
    let (mut largest, mut first) = (0.0_f64, 0);
    for (region, solved) in case.problem.layout().regions.iter().zip(regions) {
        let (a, b) = region.interval;
        for (k, &x) in reference.x.iter().enumerate() {
            let x = if regions.len() > 1 { a + (b - a) * x } else { x };
            for (i, value) in solved.eval(x).into_iter().enumerate() {
                let difference = value - reference.y[first + i][k];
                largest = worst(largest, difference / (1.0 + reference.peak[first + i]));
            }
        }
        first += region.states.len();
    }
    let found = case.unknowns.iter().map(|&index| solution.constants()[index]);
    found
        .zip(&reference.constants)
        .fold(largest, |max, (c, reference)| worst(max, (c - reference) / (1.0 + reference.abs())))
}

fn everywhere(solution: &Solution, peak: &[f64], exact: impl Fn(usize, f64) -> Vec<f64>) -> f64 {
    let (mut largest, mut first) = (0.0_f64, 0);
    for (index, region) in solution.regions().iter().enumerate() {
        for pair in region.mesh().windows(2) {
            for part in [0.0, 0.27, 0.5, 0.83, 1.0] {
                let x = if part == 1.0 { pair[1] } else { pair[0] + part * (pair[1] - pair[0]) };
                for (i, (value, exact)) in region.eval(x).into_iter().zip(exact(index, x)).enumerate() {
                    largest = worst(largest, (value - exact) / (1.0 + peak[first + i]));
                }
            }
        }
        first += region.states();
    }
    largest
}

/// The larger magnitude; NaN counts as infinite.
fn worst(a: f64, b: f64) -> f64 {
    if b.is_nan() { f64::INFINITY } else { a.max(b.abs()) }
}
