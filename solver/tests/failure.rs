//! Failures: what each says, and that it names the place.

#![allow(clippy::unwrap_used, clippy::needless_range_loop)]

use solver::model::{Differentiated, Model, Scalar};
use solver::{
    Event, Guess, GuessError, Layout, NewtonError, Options, Problem, Region, SolveError, solve, solve_observed,
};
use std::ops::ControlFlow;

/// `u'' = rhs(u)` on (0, 1) with `u(0) = left`, `u(1) = right`, by kind.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    /// `u'' = sqrt(u - 0.5)`: undefined below.
    Root,
    /// `u'' = -π² u`: any multiple of sin is a solution.
    Resonant,
    /// The second boundary equation is empty.
    Empty,
    /// `u'' = -λ exp(u)` beyond the fold: no solution.
    Bratu,
    /// `u'' = 1e8 (u - sign(s - 1/3))`: needs many intervals.
    Step,
    /// `u'' = 2500 u` with `u(1) = 1`: a layer at the right end.
    Layer,
}

impl Model for Kind {
    fn layout(&self) -> Layout {
        let string = Region::dense("string", (0.0, 1.0), &["u", "slope"], &[], 1);
        Layout::dense(vec![string], &["lambda"], &["left end", "right end"])
    }
    fn rhs<S: Scalar>(&self, _: usize, s: S, y: &[S], c: &[S], f: &mut [S]) {
        f[0] = y[1];
        f[1] = match self {
            Self::Root => (y[0] - 0.5).sqrt(),
            Self::Resonant => -y[0] * std::f64::consts::PI.powi(2),
            Self::Empty => y[0],
            Self::Layer => y[0] * 2500.0,
            Self::Bratu => -c[0] * y[0].exp(),
            Self::Step => (y[0] - if s.re() < 1.0 / 3.0 { -1.0 } else { 1.0 }) * 1e8,
        };
    }
    fn boundary<S: Scalar>(&self, e: &[S], _: &[S], _: &[S], g: &mut [S]) {
        g[0] = if *self == Self::Root { e[0] - 1.0 } else { e[0] };
        g[1] = match self {
            Self::Empty => S::from(0.0),
            Self::Resonant | Self::Layer => e[2] - 1.0,
            _ => e[2],
        };
    }
}

fn attempt(kind: Kind, lambda: f64, value: f64, options: &Options) -> Result<solver::Solution, SolveError> {
    let problem = Differentiated::new(kind).unwrap();
    let guess = Guess::uniform(problem.layout(), 10, &[lambda], |_, _, y| y.fill(value));
    solve(&problem, &guess, &[], options)
}

#[test]
fn a_value_that_is_not_finite_is_located() {
    let error = attempt(Kind::Root, 0.0, 0.25, &Options::default()).unwrap_err();
    let SolveError::Newton { error: NewtonError::NonFinite(found), intervals: 10 } = &error else { panic!("{error}") };
    assert_eq!(found.quantity, "the right-hand side of slope");
    assert_eq!((found.region.as_deref(), found.position), (Some("string"), Some(0.0)));
    assert_eq!(found.states, [("u".to_owned(), 0.25), ("slope".to_owned(), 0.25)]);
    assert!(error.to_string().contains("the right-hand side of slope is NaN in region string at 0"), "{error}");
}

#[test]
fn a_singular_problem_shows_what_is_undetermined() {
    let options = Options { rescues: 0, ..Options::default() };
    let error = attempt(Kind::Empty, 0.0, 0.0, &options).unwrap_err();
    let SolveError::Newton { error: NewtonError::Singular { rank, size, null_vector, empty_equations }, .. } = &error
    else {
        panic!("{error}")
    };
    assert_eq!((*rank, *size), (3, 4));
    assert_eq!(empty_equations, &["right end".to_owned()]);
    assert!(null_vector.iter().any(|component| component.name == "slope at the exit of string"), "{error}");
}

#[test]
fn beyond_a_fold_the_iteration_stalls_and_says_where() {
    let error = attempt(Kind::Bratu, 4.0, 0.0, &Options { rescues: 0, ..Options::default() }).unwrap_err();
    let SolveError::Newton { error: newton, .. } = &error else { panic!("{error}") };
    match newton {
        NewtonError::Stalled { largest, .. } | NewtonError::IterationLimit { largest, .. } => {
            assert!(largest[0].name.contains("of string"), "{error}");
        }
        other => panic!("{other}"),
    }
}

#[test]
fn the_iteration_limit_is_one() {
    let options = Options { max_iterations: 1, rescues: 0, ..Options::default() };
    let error = attempt(Kind::Bratu, 3.4, 0.0, &options).unwrap_err();
    let limit = matches!(&error, SolveError::Newton { error: NewtonError::IterationLimit { iterations: 1, .. }, .. });
    assert!(limit, "{error}");
}

#[test]
fn a_saturated_mesh_says_where_it_is_too_coarse() {
    let options = Options { max_intervals: 40, ..Options::default() };
    let error = attempt(Kind::Step, 0.0, 0.0, &options).unwrap_err();
    let SolveError::MeshLimit { region, state, position, defect, intervals, .. } = &error else { panic!("{error}") };
    assert!(region == "string" && ["u", "slope"].contains(&state.as_str()), "{error}");
    assert!(*defect > 1e-6 && *intervals <= 40 && (position - 1.0 / 3.0).abs() < 0.1, "{error}");
}

/// At the right end, where the layer is, and not at the beginning of the region.
#[test]
fn where_meshes_run_out_the_place_is_that_of_the_largest_defect() {
    let options = Options { max_meshes: 1, ..Options::default() };
    let error = attempt(Kind::Layer, 0.0, 0.0, &options).unwrap_err();
    let SolveError::MeshLimit { region, state, position, defect, .. } = &error else { panic!("{error}") };
    assert!(region == "string" && ["u", "slope"].contains(&state.as_str()), "{error}");
    assert!(*position >= 0.8 && *defect > 1e-6, "{position}");
}

/// Where no mesh has brought convergence, what is told is why.
#[test]
fn where_meshes_run_out_without_convergence_the_iterations_failure_is_told() {
    let options = Options { max_meshes: 1, ..Options::default() };
    let error = attempt(Kind::Bratu, 10.0, 0.0, &options).unwrap_err();
    assert!(matches!(error, SolveError::Newton { intervals: 10, .. }), "{error}");
}

#[test]
fn a_guess_that_does_not_fit_is_refused() {
    let problem = Differentiated::new(Kind::Bratu).unwrap();
    let good = Guess::uniform(problem.layout(), 4, &[1.0], |_, _, y| y.fill(0.0));
    let attempt = |guess: &Guess| solve(&problem, guess, &[], &Options::default()).unwrap_err().to_string();
    let mut guess = good.clone();
    guess.regions[0].mesh[1] = 0.9;
    assert_eq!(attempt(&guess), "the mesh of region string does not increase from 0.9 to 0.5");
    let mut guess = good.clone();
    guess.regions[0].states[1][2] = f64::NAN;
    assert_eq!(attempt(&guess), "slope of region string is not finite in the guess");
    let mut guess = good.clone();
    guess.constants.clear();
    assert_eq!(attempt(&guess), "constants in the guess: 0 given, 1 expected");
    let unknowns = solve(&problem, &good, &[0], &Options::default()).unwrap_err();
    assert_eq!(unknowns, SolveError::Count { equations: 2, states: 2, unknowns: 1 });
    let mut guess = good;
    guess.regions.clear();
    let error = solve(&problem, &guess, &[], &Options::default()).unwrap_err();
    assert!(matches!(error, SolveError::Guess(GuessError::Shape { .. })));
}

#[test]
fn an_observer_sees_progress_and_cancels() {
    let problem = Differentiated::new(Kind::Bratu).unwrap();
    let guess = Guess::uniform(problem.layout(), 4, &[1.0], |_, _, y| y.fill(0.0));
    let mut events = Vec::new();
    let mut watch = |event: &Event| {
        events.push(*event);
        if matches!(event, Event::Mesh { .. }) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let error = solve_observed(&problem, &guess, &[], &Options::default(), &mut watch).unwrap_err();
    assert_eq!(error, SolveError::Cancelled);
    assert!(matches!(events[0], Event::Newton { iteration: 1, .. }));
    assert!(matches!(events[events.len() - 1], Event::Mesh { intervals: 4, .. }));
}

#[test]
fn the_resonant_problem_is_not_reported_solved() {
    // Discretised, the matrix is singular only in the limit: the solution found, if any, must be huge and unsure.
    let error = attempt(Kind::Resonant, 0.0, 0.0, &Options::default());
    println!("{:?}", error.as_ref().map(|s| (s.history().to_vec(), s.regions()[0].state(0)[5])));
    if let Ok(solution) = error {
        let largest = solution.regions()[0].state(0).iter().fold(0.0_f64, |max, u| max.max(u.abs()));
        assert!(largest > 1e4, "{largest}");
    }
}
