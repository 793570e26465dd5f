//! Failures: what each says, and that it names the place.

#![allow(clippy::unwrap_used, clippy::panic, clippy::needless_range_loop)]

use solver::bvp::Bvp;
use solver::continuation::{BranchOptions, PathOptions, Ramp, Stiffness, follow, solve_automatically, trace};
use solver::model::{Differentiated, Model, Scalar};
use solver::{
    Event, Guess, GuessError, Layout, MeshBound, NewtonError, Options, Order, Problem, Region, SolveError, solve,
    solve_observed,
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
    /// `u'' = 1e4 (u - sign(s - 1/3))`: needs many intervals where it jumps.
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
            Self::Step => (y[0] - if s.re() < 1.0 / 3.0 { -1.0 } else { 1.0 }) * 1e4,
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
    let SolveError::MeshLimit { region, state, position, defect, intervals, because, .. } = &error else {
        panic!("{error}")
    };
    assert_eq!(*because, MeshBound::Intervals { most: 40 });
    assert!(region == "string" && ["u", "slope"].contains(&state.as_str()), "{error}");
    assert!(*defect > 1e-6 && *intervals <= 40 && (position - 1.0 / 3.0).abs() < 0.1, "{error}");
}

/// At the right end, where the layer is, and not at the beginning of the region.
#[test]
fn where_meshes_run_out_the_place_is_that_of_the_largest_defect() {
    let options = Options { max_meshes: 1, ..Options::default() };
    let error = attempt(Kind::Layer, 0.0, 0.0, &options).unwrap_err();
    let SolveError::MeshLimit { region, state, position, defect, because, .. } = &error else { panic!("{error}") };
    assert_eq!(*because, MeshBound::Meshes { most: 1 });
    assert!(region == "string" && ["u", "slope"].contains(&state.as_str()), "{error}");
    assert!(*position >= 0.8 && *defect > 1e-6, "{position}");
}

/// `u' = 1/√((1 - x)(1 + x))`: beside its ends the solution, the arc sine, is like a root. Not many intervals are in
/// the way of 1e-9, but short ones.
#[test]
fn a_solution_that_is_like_a_root_at_an_end_is_told_from_one_of_many_intervals() {
    let f = |x: f64, _: &[f64], _: &[f64], f: &mut [f64]| f[0] = 1.0 / ((1.0 - x) * (1.0 + x)).sqrt();
    let bc = |a: &[f64], _: &[f64], _: &[f64], g: &mut [f64]| g[0] = a[0];
    let problem = Bvp::by_differences(&["u"], (-1.0, 1.0), f, bc);
    for order in [Order::SixGauss, Order::Eight] {
        let error = problem.solve(&Options { order, tolerance: 1e-9, ..Options::default() }).unwrap_err();
        let SolveError::MeshLimit { position, because, .. } = &error else { panic!("{error}") };
        assert_eq!((*because, position.abs() > 1.0 - 1e-12), (MeshBound::Rounding, true), "{error}");
        assert!(error.advice().contains("x = t²"), "{}", error.advice());
    }
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

/// u' = p u with u = 0 at both ends: whatever p is. The iteration comes from where p is determined.
#[test]
fn a_constant_of_a_solution_that_vanishes_is_not_reported_found() {
    for order in [Order::Four, Order::Six, Order::Eight, Order::SixGauss] {
        let options = Options { order, rescues: 0, ..Options::default() };
        for guess in [1.0, 3.0, -2.0] {
            let problem =
                Bvp::new(&["u"], (0.0, 1.0), |_, y, p, f| f[0] = p[0] * y[0], |a, b, _, g| (g[0], g[1]) = (a[0], b[0]))
                    .unknown("p", 3.0)
                    .guess(10, move |_, y| y[0] = guess);
            let Err(SolveError::Newton { error: NewtonError::Singular { rank, size, null_vector, .. }, .. }) =
                problem.solve(&options)
            else {
                panic!("order {order:?}")
            };
            assert_eq!((rank, size, null_vector[0].name.as_str()), (2, 3, "constant p"));
        }
    }
    // A solution that vanishes and determines its constant is one.
    let problem =
        Bvp::new(&["u"], (0.0, 1.0), |_, y, p, f| f[0] = y[0] + p[0] - 2.0, |a, b, _, g| (g[0], g[1]) = (a[0], b[0]));
    let solution = problem.unknown("p", 3.0).guess(10, |_, y| y[0] = 1.0).solve(&Options::default()).unwrap();
    assert!((solution.constants()[0] - 2.0).abs() < 1e-12);
}

/// `u' = T (1 - 4 u + u² v)`, `v' = T (3 u - u² v)` (the Brusselator), with u(0) = 1 and the same at both ends: a
/// periodic orbit, or u = 1 and v = 3 with any T.
#[test]
fn a_period_of_an_equilibrium_is_not_reported_found() {
    let period = 7.156_919_92;
    for order in [Order::Four, Order::Six, Order::Eight, Order::SixGauss] {
        for (tolerance, rescues) in [(1e-3, 0), (1e-9, 0), (1e-3, 3), (1e-6, 3)] {
            let problem = Bvp::new(
                &["u", "v"],
                (0.0, 1.0),
                |_, y, p, f| {
                    let reaction = y[0] * y[0] * y[1];
                    (f[0], f[1]) = (p[0] * (1.0 - 4.0 * y[0] + reaction), p[0] * (3.0 * y[0] - reaction));
                },
                |a, b, _, g| (g[0], g[1], g[2]) = (a[0] - 1.0, b[0] - a[0], b[1] - a[1]),
            );
            let guess = |x: f64, y: &mut [f64]| {
                let phase = std::f64::consts::TAU * x;
                (y[0], y[1]) = (1.0 + 0.7 * phase.sin(), 3.0 + 0.7 * phase.cos());
            };
            let problem = problem.unknown("T", 6.3).guess(8, guess);
            let options = Options { order, tolerance, rescues, ..Options::default() };
            match problem.solve(&options) {
                Err(error) => {
                    let SolveError::Newton { error: NewtonError::Singular { null_vector, .. }, .. } = &error else {
                        panic!("{order:?}, {tolerance:e}: {error}")
                    };
                    assert_eq!((rescues, null_vector[0].name.as_str()), (0, "constant T"), "{order:?}: {error}");
                    assert!(error.advice().contains("amplitude"));
                }
                // Where the iteration is tried again from the guess, it finds the orbit, run through once or twice.
                Ok(solution) => {
                    let turns = solution.constants()[0] / period;
                    assert!((turns - turns.round()).abs() < 2.0 * tolerance && turns.abs() > 0.5, "{order:?}: {turns}");
                    assert!(rescues > 0 && solution.regions()[0].state(0).iter().any(|u| *u > 2.0), "{order:?}");
                }
            }
        }
    }
}

/// `u'' = 0.1 (1 - u²) T u' - T² u` (van der Pol): from a circle of half the size, on few intervals, an iteration may
/// end at zero to rounding, which seems to determine T still.
#[test]
fn a_period_of_what_is_zero_to_rounding_is_not_reported_found() {
    let mut refused = 0;
    for order in [Order::Four, Order::Six, Order::Eight, Order::SixGauss] {
        for (intervals, tolerance) in [(3, 1e-8), (3, 1e-9), (4, 1e-6), (4, 1e-9), (10, 1e-6)] {
            for absolute_tolerance in [None, Some(1e-30)] {
                let oscillator = Bvp::new(
                    &["u", "v"],
                    (0.0, 1.0),
                    |_, y, p, f| {
                        f[0] = p[0] * y[1];
                        f[1] = p[0] * ((1.0 - y[0] * y[0]) * y[1] * 0.1 - y[0]);
                    },
                    |a, b, _, g| (g[0], g[1], g[2]) = (a[0] - b[0], a[1] - b[1], a[1]),
                )
                .unknown("T", 6.36)
                .guess(intervals, |s, y| {
                    let angle = std::f64::consts::TAU * s;
                    (y[0], y[1]) = (angle.cos(), -angle.sin());
                });
                let options = Options { order, tolerance, absolute_tolerance, ..Options::default() };
                match oscillator.solve(&options) {
                    Ok(found) => {
                        let (period, what) = (found.constants()[0], format!("{order:?} from {intervals} intervals"));
                        assert!((period - 6.287_11).abs() < 1e-4, "{what} to {tolerance}: {period}");
                    }
                    Err(_) => refused += 1,
                }
            }
        }
    }
    assert!(refused > 0, "an iteration has ended at zero");
}

#[test]
fn coefficients_that_overflow_are_called_so() {
    let bratu = || {
        Bvp::new(
            &["u", "slope"],
            (0.0, 1.0),
            |_, y, _, f| (f[0], f[1]) = (y[1], -y[0].exp()),
            |a, b, _, g| (g[0], g[1]) = (a[0], b[0]),
        )
    };
    let error = bratu().guess(10, |_, y| y.fill(400.0)).solve(&Options::default()).unwrap_err();
    assert!(matches!(&error, SolveError::Newton { error: NewtonError::Overflow, .. }), "{error}");
    assert!(error.advice().contains("smaller values"));
    // Near rounding no mesh is fine enough, and no layer is to blame.
    let error = bratu().solve(&Options { tolerance: 1e-15, ..Options::default() }).unwrap_err();
    assert!(error.advice().contains("Rounding"), "{error}: {}", error.advice());
}

#[test]
fn indices_and_limits_that_make_no_sense_are_refused() {
    let problem =
        Bvp::new(&["u"], (0.0, 1.0), |_, y, p, f| f[0] = p[0] * y[0], |a, _, _, g| g[0] = a[0] - 1.0).given("p", 1.0);
    let guess = problem.start();
    let refused = |error: &SolveError, wanted: &str| match error {
        SolveError::Option { name, .. } => assert_eq!(*name, wanted),
        other => panic!("{other}"),
    };
    let ramp = Ramp::new().linear(1, 1.0, 3.0);
    refused(&follow(&problem, &guess, &ramp, &[], &PathOptions::default()).unwrap_err().cause, "path");
    let path = PathOptions { smallest_step: 2.0, largest_step: 1.0, ..PathOptions::default() };
    let steps = Ramp::new().linear(0, 1.0, 2.0);
    refused(&follow(&problem, &guess, &steps, &[], &path).unwrap_err().cause, "smallest_step");
    let stiffness = Some(Stiffness { constant: 5, easy: None });
    refused(&solve_automatically(&problem, &guess, &[], stiffness, &Options::default()).unwrap_err(), "stiffness");
    refused(&problem.solve(&Options { max_intervals: 0, ..Options::default() }).unwrap_err(), "max_intervals");
    let branch = |options: BranchOptions| trace(&problem, &guess, 0, &[], &options, &[]).unwrap_err().cause;
    let options = BranchOptions { range: (0.0, 2.0), ..BranchOptions::default() };
    refused(&branch(BranchOptions { max_iterations: 0, ..options.clone() }), "max_iterations");
    refused(&branch(BranchOptions { smallest_step: 1.0, largest_step: 0.1, ..options.clone() }), "smallest_step");
    for value in [0.0, -1.0, f64::NAN] {
        refused(&branch(BranchOptions { largest_contraction: value, ..options.clone() }), "largest_contraction");
    }
}
