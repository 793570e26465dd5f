//! Guesses on fine meshes that are far from the solution: most of the way is gone on coarse meshes.

#![allow(clippy::unwrap_used)]

use solver::bvp::Bvp;
use solver::{Cancel, Event, Guess, Options, Problem, Solution, SolveError, solve, solve_observed};
use std::ops::ControlFlow;

/// Bratu's problem `u'' + λ e^u = 0`, `u(0) = u(1) = 0`.
fn bratu(lambda: f64) -> impl Problem {
    Bvp::new(
        &["u", "slope"],
        (0.0, 1.0),
        move |_, u, _, f| (f[0], f[1]) = (u[1], -lambda * u[0].exp()),
        |a, b, _, g| (g[0], g[1]) = (a[0], b[0]),
    )
}

fn options() -> Options {
    Options { tolerance: 1e-9, ..Options::default() }
}

/// Constant states on so many intervals.
fn guess_of(problem: &impl Problem, states: &[f64], intervals: usize) -> Guess {
    Guess::uniform(problem.layout(), intervals, &[], |_, _, u| u.copy_from_slice(states))
}

/// A solution on 400 intervals.
fn sampled(problem: &impl Problem, solution: &Solution) -> Guess {
    Guess::uniform(problem.layout(), 400, &[], |_, x, u| u.copy_from_slice(&solution.regions()[0].eval(x)))
}

/// The solution for λ = 1 on 400 intervals.
fn guess() -> Guess {
    let problem = bratu(1.0);
    sampled(&problem, &solve(&problem, &guess_of(&problem, &[0.0; 2], 10), &[], &options()).unwrap())
}

#[test]
fn what_is_far_is_approached_on_coarse_meshes_and_solved_to_the_tolerance() {
    let solution = solve(&bratu(3.0), &guess(), &[], &options()).unwrap();
    // u'(0)² = 2 λ (e^m - 1) for the largest value m, which is in the middle.
    let (slope, most) = (solution.regions()[0].state(1)[0], solution.regions()[0].eval(0.5)[0]);
    assert!((slope * slope - 6.0 * (most.exp() - 1.0)).abs() < 1e-8);
    let history = solution.history();
    assert!(history[0].newton_iterations == 1 && history[0].defects == [f64::INFINITY], "{history:?}");
    let coarse: usize = history[1].intervals.iter().sum();
    assert!(coarse < 20 && history[1].newton_iterations > 1, "{history:?}");
    for record in &history[2..] {
        assert!(record.newton_iterations <= 2, "{history:?}");
    }
}

#[test]
fn what_is_near_stays_on_its_meshes() {
    let solution = solve(&bratu(1.01), &guess(), &[], &options()).unwrap();
    let first = &solution.history()[0];
    assert!(first.intervals == [400] && first.defects[0] <= 1e-9, "{first:?}");
}

/// Beside the fold, Newton's iteration takes many steps although the first is short.
#[test]
fn what_takes_many_iterations_is_approached_on_coarse_meshes() {
    let near = solve(&bratu(3.51), &guess_of(&bratu(1.0), &[0.0; 2], 10), &[], &options()).unwrap();
    let solution = solve(&bratu(3.5138), &sampled(&bratu(3.51), &near), &[], &options()).unwrap();
    let history = solution.history();
    assert!(history[0].newton_iterations == 4 && history[0].defects == [f64::INFINITY], "{history:?}");
    assert!(history[1].intervals[0] < 20, "{history:?}");
}

/// `u'' = 3 tanh(100 u') + 5 cos 6x`, `u(0) = 0`, `u(1)` given: a friction that changes its sign within a hundredth.
fn friction(height: f64) -> impl Problem {
    Bvp::new(
        &["u", "slope"],
        (0.0, 1.0),
        |x, u, _, f| (f[0], f[1]) = (u[1], (u[1] * 100.0).tanh() * 3.0 + (6.0 * x).cos() * 5.0),
        move |a, b, _, g| (g[0], g[1]) = (a[0], b[0] - height),
    )
}

#[test]
fn what_needs_a_damped_step_is_approached_on_coarse_meshes() {
    let options = Options { tolerance: 1e-8, ..Options::default() };
    let near = solve(&friction(0.0), &guess_of(&friction(0.0), &[0.0; 2], 20), &[], &options).unwrap();
    assert!(near.intervals() > 200);
    let mut corrections = Vec::new();
    let mut note = |event: &Event| {
        if let Event::Newton { intervals, correction, .. } = event {
            corrections.push((*intervals, *correction));
        }
        ControlFlow::Continue(())
    };
    let solution = solve_observed(&friction(0.02), &Guess::from(&near), &[], &options, &mut note).unwrap();
    let history = solution.history();
    // No first correction that would say so by its size.
    assert!(corrections[0].0 == near.intervals() && corrections[0].1 < 0.1, "{corrections:?}");
    assert!(history[0].newton_iterations == 2 && history[0].defects == [f64::INFINITY], "{history:?}");
    assert!(history[1].intervals[0] < 30, "{history:?}");
}

#[test]
fn work_on_coarse_meshes_is_counted_and_ends_where_it_must() {
    let (guess, mut events) = (guess(), 0);
    let mut count = |_: &Event| {
        events += 1;
        ControlFlow::Continue(())
    };
    let solution = solve_observed(&bratu(3.0), &guess, &[], &options(), &mut count).unwrap();
    let iterations: usize = solution.history().iter().map(|record| record.newton_iterations).sum();
    assert_eq!(solution.stats().newton_iterations, iterations);
    assert!(events > iterations, "{events}");
    // Wherever it is stopped, it says so.
    for stop in 1..events {
        let mut left = stop;
        let mut stopping = |_: &Event| {
            left -= 1;
            if left == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let stopped = solve_observed(&bratu(3.0), &guess, &[], &options(), &mut stopping);
        assert!(matches!(stopped, Err(SolveError::Cancelled)), "{stop}: {stopped:?}");
    }
    let points = solution.stats().points();
    let limited = |limit| solve(&bratu(3.0), &guess, &[], &Options { work_limit: Some(limit), ..options() });
    assert!(matches!(limited(points / 4), Err(SolveError::WorkLimit { .. })));
    assert_eq!(limited(points).unwrap().stats(), solution.stats());
    let cancel = Cancel::new();
    cancel.cancel();
    let cancelled = solve(&bratu(3.0), &guess, &[], &Options { cancel: Some(cancel), ..options() });
    assert!(matches!(cancelled, Err(SolveError::Cancelled)));
}

/// There is no solution beyond λ = 3.51: what fails on coarse meshes is tried from the guess on its own.
#[test]
fn what_is_not_found_on_coarse_meshes_is_sought_on_fine_ones() {
    let lost = solve(&bratu(4.0), &guess(), &[], &options());
    let Err(SolveError::Newton { intervals, .. }) = lost else { panic!("{lost:?}") };
    assert!(intervals > 250, "{intervals}");
}
