//! Solutions less their estimated errors: what is left at the nodes, in constants and in integrals.

#![allow(clippy::unwrap_used)]

use solver::bvp::Bvp;
use solver::continuation::{BranchOptions, trace};
use solver::model::{Differentiated, Model, Scalar};
use solver::{Control, Guess, Layout, Options, Order, Problem, Region, Solution, solve};
use std::f64::consts::PI;

const ORDERS: [Order; 4] = [Order::Four, Order::Six, Order::Eight, Order::SixGauss];

/// `u'' = -λ u` in two halves of [0, 1], `u(0) = 0`, `∫ u² = 1/2` and a condition that is not linear at the right end:
/// `u = sin πx`, `λ = π²`. The integrals of u are part of no condition.
struct Wave;

impl Model for Wave {
    fn layout(&self) -> Layout {
        let half = |name, interval| Region::dense(name, interval, &["u", "slope"], &["square", "mean"], 1);
        let halves = vec![half("left", (0.0, 0.5)), half("right", (0.5, 1.0))];
        Layout::dense(halves, &["lambda"], &["left", "u", "slope", "right", "norm"])
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], c: &[S], f: &mut [S]) {
        (f[0], f[1], f[2], f[3]) = (y[1], -c[0] * y[0], y[0] * y[0], y[0]);
    }
    fn boundary<S: Scalar>(&self, e: &[S], i: &[S], _: &[S], g: &mut [S]) {
        // Ends of the left half, then of the right one: both states where it begins and where it ends.
        (g[0], g[1], g[2]) = (e[0], e[4] - e[2], e[5] - e[3]);
        (g[3], g[4]) = (e[6].sin() + e[6] * e[6], i[0] + i[2] - 0.5);
    }
}

/// The wave on so many intervals a half, whatever the error.
fn wave(order: Order, intervals: usize, defect_correction: bool) -> Solution {
    let problem = Differentiated::new(Wave).unwrap();
    let guess = Guess::uniform(problem.layout(), intervals, &[PI * PI], |_, x, y| {
        (y[0], y[1]) = ((PI * x).sin(), PI * (PI * x).cos());
    });
    let options = Options {
        order,
        defect_correction,
        control: Control::Defect,
        tolerance: 0.5,
        newton_tolerance: Some(1e-13),
        boundary_tolerance: Some(1e-6),
        ..Options::default()
    };
    let solution = solve(&problem, &guess, &[0], &options).unwrap();
    assert_eq!(solution.intervals(), 2 * intervals);
    assert_eq!(solution.is_corrected(), defect_correction);
    solution
}

/// Largest errors of a wave: at its nodes; of λ; of the integrals of u² and u up to each node; between nodes.
fn errors(solution: &Solution) -> [f64; 4] {
    let mut errors = [0.0_f64; 4];
    errors[1] = (solution.constants()[0] - PI * PI).abs();
    for region in solution.regions() {
        let (mesh, start) = (region.mesh(), region.mesh()[0]);
        let square = |x: f64| x / 2.0 - (2.0 * PI * x).sin() / (4.0 * PI);
        let mean = |x: f64| -(PI * x).cos() / PI;
        for (j, &x) in mesh.iter().enumerate() {
            let at_node = (region.state(0)[j] - (PI * x).sin()).abs();
            let slope = (region.state(1)[j] - PI * (PI * x).cos()).abs();
            errors[0] = errors[0].max(at_node).max(slope);
            let squares = (region.cumulative(0)[j] - (square(x) - square(start))).abs();
            let means = (region.cumulative(1)[j] - (mean(x) - mean(start))).abs();
            errors[2] = errors[2].max(squares).max(means);
        }
        for pair in mesh.windows(2) {
            for part in [0.2, 0.5, 0.7] {
                let x = pair[0] + part * (pair[1] - pair[0]);
                errors[3] = errors[3].max((region.eval(x)[0] - (PI * x).sin()).abs());
            }
        }
    }
    errors
}

#[test]
fn little_is_left_and_that_is_smaller_by_two_orders() {
    for (order, (intervals, part)) in ORDERS.into_iter().zip([(8, 2e-3), (6, 2e-3), (2, 4e-3)]) {
        let found = errors(&wave(order, intervals, false));
        let [coarse, fine] = [intervals, 2 * intervals].map(|intervals| errors(&wave(order, intervals, true)));
        for (what, ((found, coarse), fine)) in
            ["nodes", "lambda", "integrals"].iter().zip(found.iter().zip(coarse).zip(fine))
        {
            assert!(coarse < part * found, "{order:?}, {what}: {found:e} -> {coarse:e}");
            let rate = (coarse / fine).log2();
            assert!(rate > order.number() as f64 + 1.4, "{order:?}, {what}: {coarse:e} -> {fine:e}, order {rate}");
        }
        assert!(coarse[3] <= 1.01 * found[3], "{order:?}: {:e} -> {:e}", found[3], coarse[3]);
    }
}

#[test]
fn conditions_are_met_as_before_and_estimates_are_those_from_before() {
    for order in ORDERS {
        let [found, corrected] = [false, true].map(|correction| wave(order, 8, correction));
        assert_eq!(found.error_estimate(), corrected.error_estimate());
        assert_eq!(found.max_defect(), corrected.max_defect());
        assert!(corrected.max_boundary_residual() <= 1e-6, "{:e}", corrected.max_boundary_residual());
        assert!((corrected.regions()[0].state(0)[0]).abs() < 1e-12);
        let square: f64 = corrected.regions().iter().map(|region| region.integrals()[0]).sum();
        assert!((square - 0.5).abs() < 1e-6);
        for region in corrected.regions() {
            for k in 0..2 {
                assert_eq!(region.cumulative(k).last(), Some(&region.integrals()[k]));
            }
        }
    }
}

/// Troesch's problem, `u'' = 3 sinh 3u`: slopes are those of the equation at the corrected values.
#[test]
fn slopes_at_the_nodes_are_those_that_the_equations_have_there() {
    let problem = Bvp::new(
        &["u", "slope"],
        (0.0, 1.0),
        |_, y, _, f| (f[0], f[1]) = (y[1], 3.0 * (3.0 * y[0]).sinh()),
        |a, b, _, g| (g[0], g[1]) = (a[0], b[0] - 1.0),
    );
    for order in ORDERS {
        let options = Options { order, tolerance: 1e-4, defect_correction: true, ..Options::default() };
        let solution = problem.solve(&options).unwrap();
        let line = &solution.regions()[0];
        assert!(solution.is_corrected());
        for (j, u) in line.state(0).iter().enumerate() {
            assert_eq!(line.slope(0)[j], line.state(1)[j]);
            assert!((line.slope(1)[j] - 3.0 * (3.0 * u).sinh()).abs() < 1e-12);
        }
    }
}

/// `u' = exp(20 u) - 1` in the condition, too: with the error taken off, it would be missed by more than it may be.
#[test]
fn a_solution_whose_conditions_would_not_be_met_stays_as_it_was_found() {
    let problem = Bvp::new(
        &["u", "slope"],
        (0.0, 1.0),
        |_, y, _, f| (f[0], f[1]) = (y[1], -9.0 * y[0]),
        |a, b, _, g| (g[0], g[1]) = (a[0] - 1.0, (4.0 * b[0]).exp() - (4.0 * b[1]).exp()),
    )
    .guess(6, |x, y| (y[0], y[1]) = ((3.0 * x).cos(), -3.0 * (3.0 * x).sin()));
    let solved = |boundary_tolerance| {
        let options = Options {
            control: Control::Defect,
            tolerance: 0.3,
            newton_tolerance: Some(1e-12),
            boundary_tolerance: Some(boundary_tolerance),
            defect_correction: true,
            ..Options::default()
        };
        problem.solve(&options).unwrap()
    };
    let (kept, corrected) = (solved(1e-9), solved(1.0));
    assert!(!kept.is_corrected() && corrected.is_corrected());
    assert!(kept.max_boundary_residual() <= 1e-9 && corrected.max_boundary_residual() > 1e-9);
}

/// `u'' = -9.86 u`, `u(0) = 0`, `u(1) = 1`, near resonance: defects that meet the tolerance cause errors that do not.
#[test]
fn estimates_that_miss_the_tolerance_are_not_taken_off() {
    let problem = Bvp::new(
        &["u", "slope"],
        (0.0, 1.0),
        |_, y, _, f| (f[0], f[1]) = (y[1], y[0] * -9.86),
        |a, b, _, g| (g[0], g[1]) = (a[0], b[0] - 1.0),
    );
    for (control, corrected) in [(Control::Defect, false), (Control::Error, true)] {
        let options = Options { control, tolerance: 1e-3, defect_correction: true, ..Options::default() };
        let solution = problem.solve(&options).unwrap();
        assert_eq!(solution.error_estimate() <= 1e-3, corrected, "{control:?}: {:e}", solution.error_estimate());
        assert_eq!(solution.is_corrected(), corrected);
    }
}

/// A branch goes on from solutions of the collocation equations.
#[test]
fn the_points_of_a_branch_are_not_corrected() {
    let problem = Bvp::new(
        &["u", "slope"],
        (0.0, 1.0),
        |_, y, p, f| (f[0], f[1]) = (y[1], -p[0] * y[0].exp()),
        |a, b, _, g| (g[0], g[1]) = (a[0], b[0]),
    )
    .given("lambda", 0.0);
    let solve = Options { defect_correction: true, tolerance: 1e-5, ..Options::default() };
    let options = BranchOptions { solve, range: (0.0, 1.0), ..BranchOptions::default() };
    let branch = trace(&problem, &problem.start(), 0, &[], &options, &[]).unwrap();
    assert!(branch.points.len() > 2 && branch.points.iter().all(|point| !point.solution.is_corrected()));
}

/// Whatever their order, and however many lie in one interval.
#[test]
fn states_at_many_places_are_those_at_each_to_the_same_bits() {
    for order in ORDERS {
        let solution = wave(order, 6, false);
        let part = &solution.regions()[0];
        let many: Vec<f64> = (0..=40).map(|i| 0.5 * f64::from(i) / 40.0).collect();
        let mut places = vec![0.07, 0.06, 0.41, 0.42, -0.1, 0.6, 0.425, 0.43, 0.44, 0.0, 0.5];
        places.extend(many.iter().chain(part.mesh()));
        for places in [&places[..], &many[..], &many[..3], &places[..1], &[]] {
            let all = part.eval_many(places);
            assert_eq!(all.len(), 2 * places.len());
            for state in 0..2 {
                let each: Vec<u64> = places.iter().map(|s| part.eval(*s)[state].to_bits()).collect();
                let bits = |values: &[f64]| values.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
                assert_eq!(bits(&all[state * places.len()..][..places.len()]), each, "order {}", order.number());
                assert_eq!(bits(&part.eval_state(state, places)), each);
            }
            assert!(part.eval_state(2, places).is_empty());
        }
    }
}
