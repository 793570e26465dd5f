//! From branch points onto the branches that cross there.

#![allow(clippy::unwrap_used)]

use solver::bvp::Bvp;
use solver::continuation::{Branch, BranchOptions, PointKind, trace, trace_crossing};
use solver::{Guess, Options, Order, Solution, SolveError, solve};

/// Sign changes of the first state inside the interval.
fn nodes(solution: &Solution) -> usize {
    let u = solution.regions()[0].state(0);
    let largest = u.iter().fold(0.0_f64, |max, u| max.max(u.abs()));
    let clear: Vec<f64> = u.iter().copied().filter(|u| u.abs() > 1e-3 * largest).collect();
    clear.windows(2).filter(|pair| pair[0] * pair[1] < 0.0).count()
}

/// The largest first state, between nodes too: those of two meshes are not the same.
fn amplitude(solution: &Solution) -> f64 {
    let region = &solution.regions()[0];
    let ((a, b), samples) = ((region.mesh()[0], region.mesh()[region.intervals()]), 1000);
    let places = (0..=samples).map(|i| a + (b - a) * f64::from(i) / f64::from(samples));
    places.fold(0.0_f64, |max, s| max.max(region.eval(s)[0].abs()))
}

/// AUTO's demo `bvp`: `u'' = -(λ π)² u + u²`, `u(0) = u(1) = 0`. From the branch point at λ = k both halves of a branch
/// of solutions with k - 1 nodes leave.
#[test]
fn all_five_branches_of_autos_demo_are_reached() {
    let pi = std::f64::consts::PI;
    let demo = Bvp::new(
        &["u", "slope"],
        (0.0, 1.0),
        move |_, y, p, f| (f[0], f[1]) = (y[1], y[0] * y[0] - (p[0] * pi).powi(2) * y[0]),
        |a, b, _, g| (g[0], g[1]) = (a[0], b[0]),
    )
    .given("lambda", 0.5)
    .guess(40, |_, y| y.fill(0.0));
    let options = BranchOptions { range: (0.3, 5.7), largest_step: 0.15, ..BranchOptions::default() };
    let trivial = trace(&demo, &demo.start(), 0, &[], &options, &[]).unwrap();
    let points: Vec<_> = trivial.branch_points().collect();
    assert_eq!(points.len(), 5);
    for (k, point) in points.into_iter().enumerate() {
        let options = BranchOptions {
            first_step: 0.2,
            max_points: 12,
            branch_points: false,
            largest_step: 0.5,
            solve: Options { tolerance: 1e-6, ..Options::default() },
            ..options.clone()
        };
        let halves = trace_crossing(&demo, point, 0, &[], &options, &[]).unwrap();
        for half in &halves {
            let last = half.points.last().unwrap();
            println!(
                "{k}: {} points to λ = {}, amplitude {}",
                half.points.len(),
                last.parameter,
                amplitude(&last.solution)
            );
            assert!(amplitude(&last.solution) > 0.05, "branch {}: back on the trivial branch", k + 1);
            assert_eq!(nodes(&last.solution), k, "branch {}", k + 1);
            // A solution in its own right.
            let again = solve(&demo, &Guess::from(&last.solution), &[], &options.solve).unwrap();
            let difference = amplitude(&again) - amplitude(&last.solution);
            // Points of a branch are held to a defect, not to an error: these are right to three digits.
            assert!(difference.abs() < 2e-3 * amplitude(&again), "branch {}: {difference}", k + 1);
        }
        let first = |half: &Branch| half.points[2].solution.regions()[0].eval_slope(0.0)[0];
        assert!(first(&halves[0]) * first(&halves[1]) < 0.0, "both halves are the same");
    }
}

/// Euler's strut: `θ'' = -λ sin θ`, `θ'(0) = θ'(1) = 0`. It buckles at λ = (k π)², to both sides alike; beyond,
/// `√λ = 2 k K(sin(θ₀/2))` with the complete elliptic integral K.
#[test]
fn a_strut_buckles_to_both_sides_as_the_elliptic_integral_says() {
    let strut = Bvp::new(
        &["angle", "curvature"],
        (0.0, 1.0),
        |_, y, p, f| (f[0], f[1]) = (y[1], -p[0] * y[0].sin()),
        |a, b, _, g| (g[0], g[1]) = (a[1], b[1]),
    )
    .given("load", 5.0);
    let options = BranchOptions {
        solve: Options { tolerance: 1e-8, ..Options::default() },
        range: (5.0, 45.0),
        ..BranchOptions::default()
    };
    let straight = trace(&strut, &strut.start(), 0, &[], &options, &[]).unwrap();
    for (k, point) in (1..).zip(straight.branch_points()) {
        for half in trace_crossing(&strut, point, 0, &[], &options, &[]).unwrap() {
            let end = half.points.last().unwrap();
            assert_eq!((end.kind, nodes(&end.solution)), (PointKind::End, k), "{k}");
            for point in half.points.iter().skip(2) {
                let modulus = (point.solution.regions()[0].state(0)[0].abs() / 2.0).sin();
                let wanted = (2.0 * f64::from(k as u32) * elliptic(modulus)).powi(2);
                assert!((point.parameter / wanted - 1.0).abs() < 1e-5, "{k}: {} for {wanted}", point.parameter);
            }
        }
    }
    assert_eq!(straight.branch_points().count(), 2);
    let error = trace_crossing(&strut, &straight.points[1], 0, &[], &options, &[]).unwrap_err();
    assert!(matches!(*error.cause, SolveError::Option { .. }), "{error}");
}

/// Complete elliptic integral of the first kind, by the arithmetic-geometric mean.
fn elliptic(modulus: f64) -> f64 {
    let (mut a, mut b) = (1.0, (1.0 - modulus * modulus).sqrt());
    for _ in 0..30 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    std::f64::consts::FRAC_PI_2 / a
}

/// Two lines that cross, y = a λ and y = b λ: where both move with λ, the null vector at a given λ lies between them.
/// Beside y a state that is zero, so that the derivatives of no condition vanish.
#[test]
fn of_two_branches_that_both_move_it_is_the_other_one_that_is_traced() {
    for (known, other) in [(3.0, 1.0), (1.0, -1.0), (1.0, 3.0), (-2.0, 0.5), (1.0, 0.0)] {
        let lines = Bvp::new(
            &["y", "zero"],
            (0.0, 1.0),
            |_, _, _, f| f.iter_mut().for_each(|f| *f = 0.0.into()),
            move |a, b, p, g| {
                g[0] = (a[0] - p[0] * known) * (a[0] - p[0] * other) + a[1];
                g[1] = b[1];
            },
        )
        .given("lambda", -0.5)
        .guess(4, move |_, y| (y[0], y[1]) = (-0.5 * known, 0.0));
        let options = BranchOptions { range: (-0.6, 0.6), ..BranchOptions::default() };
        let branch = trace(&lines, &lines.start(), 0, &[], &options, &[]).unwrap();
        let crossing = branch.branch_points().next().unwrap();
        let halves = trace_crossing(&lines, crossing, 0, &[], &options, &[]).unwrap();
        let ends = halves.map(|half| {
            let end = half.points.last().unwrap();
            assert_eq!(end.kind, PointKind::End, "{known}, {other}");
            assert!((end.solution.regions()[0].state(0)[0] - other * end.parameter).abs() < 1e-5, "{known}, {other}");
            end.parameter
        });
        assert!(ends[0] * ends[1] < 0.0, "{known}, {other}: {ends:?}");
    }
}

/// AUTO's demo `pp2` at rest: prey without predators loses its stability to that with predators where there is a third
/// of it, and dies out at p = 3/5. With them there is a third of it whatever p; dead it is whatever p.
#[test]
fn predators_and_prey_at_rest_meet_the_state_with_both_and_that_with_none() {
    let rest = Bvp::new(
        &["prey", "predators"],
        (0.0, 1.0),
        |_, _, _, f| f.iter_mut().for_each(|f| *f = 0.0.into()),
        |a, _, p, g| {
            let (u, v) = (a[0], a[1]);
            g[0] = 3.0 * u * (1.0 - u) - u * v - p[0] * (1.0 - (u * -5.0).exp());
            g[1] = v * (3.0 * u - 1.0);
        },
    )
    .given("p", 0.0)
    .guess(4, |_, y| (y[0], y[1]) = (1.0, 0.0));
    let options = BranchOptions { range: (-0.1, 1.0), max_points: 20, ..BranchOptions::default() };
    let branch = trace(&rest, &rest.start(), 0, &[], &options, &[]).unwrap();
    let points: Vec<_> = branch.branch_points().collect();
    assert_eq!(points.len(), 2);
    assert!((points[0].parameter - 2.0 / 3.0 / (1.0 - (-5.0_f64 / 3.0).exp())).abs() < 1e-6);
    assert!((points[1].parameter - 0.6).abs() < 1e-6);
    for (point, prey) in points.into_iter().zip([1.0 / 3.0, 0.0]) {
        let options = BranchOptions { max_points: 6, ..options.clone() };
        for half in trace_crossing(&rest, point, 0, &[], &options, &[]).unwrap() {
            assert!(half.points.len() > 3);
            for point in half.points {
                assert!((amplitude(&point.solution) - prey).abs() < 1e-5, "{prey} at {}", point.parameter);
            }
        }
    }
}

/// AUTO's demo `bvp` about a state that moves with λ, as far as `amplitude` says: the branch points stay at 1, 2 and 3.
/// The meshes of such a branch are coarse, and what Newton's iteration leaves moves the determinant's zero.
#[test]
fn branch_points_settle_along_a_branch_that_moves() {
    let pi = std::f64::consts::PI;
    for (amplitude, order) in [(1.0, Order::Four), (1.0, Order::Eight), (5.0, Order::Four), (5.0, Order::Eight)] {
        let moved = Bvp::new(
            &["w", "slope"],
            (0.0, 1.0),
            move |x, y, p, f| {
                let u = y[0] - p[0] * (amplitude * x * (1.0 - x));
                (f[0], f[1]) = (y[1], u * u - p[0] * p[0] * pi * pi * u - p[0] * (2.0 * amplitude));
            },
            |a, b, _, g| (g[0], g[1]) = (a[0], b[0]),
        )
        .given("lambda", 0.5)
        .guess(40, move |x, y| {
            (y[0], y[1]) = (0.5 * amplitude * x * (1.0 - x), 0.5 * amplitude * (1.0 - 2.0 * x));
        });
        let solve = Options { order, tolerance: 1e-7, ..Options::default() };
        let options = BranchOptions { solve, range: (0.3, 3.6), ..BranchOptions::default() };
        let branch = trace(&moved, &moved.start(), 0, &[], &options, &[]).unwrap();
        let found: Vec<f64> = branch.branch_points().map(|point| point.parameter).collect();
        assert_eq!(found.len(), 3, "{amplitude}, {order:?}: {found:?}");
        for (found, wanted) in found.iter().zip([1.0, 2.0, 3.0]) {
            assert!((found - wanted).abs() < 3e-7, "{amplitude}, {order:?}: {found} for {wanted}");
        }
    }
}

/// A linear strut bent as far as one likes: on the branch that crosses, the load stands still, and does not fold.
#[test]
fn where_the_parameter_stands_still_there_is_no_fold() {
    let strut = Bvp::new(
        &["u", "slope"],
        (0.0, 1.0),
        |_, y, p, f| (f[0], f[1]) = (y[1], y[0] * -p[0]),
        |a, b, _, g| (g[0], g[1]) = (a[0], b[0]),
    )
    .given("load", 5.0);
    for order in [Order::Four, Order::Six, Order::Eight] {
        for range in [(5.0, 15.0), (5.0, f64::INFINITY)] {
            let solve = Options { order, ..Options::default() };
            let options = BranchOptions { solve, range, max_points: 8, ..BranchOptions::default() };
            let branch = trace(&strut, &strut.start(), 0, &[], &options, &[]).unwrap();
            let point = branch.branch_points().next().unwrap();
            let options = BranchOptions { max_points: 60, ..options };
            for half in trace_crossing(&strut, point, 0, &[], &options, &[]).unwrap() {
                assert!(half.points.len() > 40 && half.folds().count() == 0, "{order:?}: {}", half.folds().count());
            }
        }
    }
}

/// AUTO's demo `ppp` at rest: the state without prey crosses that with it, and its equations are products, whose rows
/// vanish with both factors where they cross.
#[test]
fn where_an_equation_is_a_product_the_other_branch_is_traced() {
    let rest = Bvp::new(
        &["prey", "predators", "top"],
        (0.0, 1.0),
        |_, _, _, f| f.iter_mut().for_each(|f| *f = 0.0.into()),
        |a, _, p, g| {
            let (u, v, w) = (a[0], a[1], a[2]);
            g[0] = u * (1.0 - u - 3.0 * v);
            g[1] = v * -0.25 + 3.0 * u * v - 3.0 * v * w - p[0] * (1.0 - (v * -5.0).exp());
            g[2] = w * (3.0 * v - 0.5);
        },
    )
    .given("p", -0.3)
    .guess(4, |_, y| (y[0], y[1], y[2]) = (-0.13, 0.377, 0.0));
    for order in [Order::Four, Order::Six, Order::Eight] {
        let solve = Options { order, ..Options::default() };
        let options = BranchOptions { solve, range: (-0.3, 0.3), max_points: 40, ..BranchOptions::default() };
        let branch = trace(&rest, &rest.start(), 0, &[], &options, &[]).unwrap();
        let [point] = branch.branch_points().collect::<Vec<_>>()[..] else { panic!("{order:?}") };
        assert!((point.parameter + 0.102_738_04).abs() < 1e-6);
        let options = BranchOptions { max_points: 6, ..options };
        for half in trace_crossing(&rest, point, 0, &[], &options, &[]).unwrap() {
            let prey = half.points.iter().map(|point| point.solution.regions()[0].state(0)[0].abs());
            assert!(half.points.len() > 3 && prey.fold(0.0, f64::max) < 1e-6, "{order:?}");
        }
    }
}

/// `u'' = -p sin(u - b) + b''` with `b = 1 + x²`, and `u = b` at both ends: `u = b` is a solution for all p, exact on
/// any mesh, from which others branch off at `p = (kπ)²`. Rounding in it looks like a large error beside them, for
/// which finer meshes are taken there, on which they lie elsewhere.
#[test]
fn branch_points_settle_where_rounding_looks_like_an_error_beside_them() {
    let strut = |intervals: usize| {
        Bvp::new(
            &["u", "slope"],
            (0.0, 1.0),
            |x, y, p, f| (f[0], f[1]) = (y[1], -p[0] * (y[0] - 1.0 - x * x).sin() + 2.0),
            |a, b, _, g| (g[0], g[1]) = (a[0] - 1.0, b[0] - 2.0),
        )
        .given("p", 1.0)
        .guess(intervals, |x, y| (y[0], y[1]) = (1.0 + x * x, 2.0 * x))
    };
    let settings = [
        (Order::Six, 1e-6, 5),
        (Order::Six, 1e-8, 7),
        (Order::Six, 1e-9, 5),
        (Order::Six, 1e-10, 7),
        (Order::Eight, 1e-8, 5),
        (Order::Eight, 1e-10, 5),
        (Order::SixGauss, 1e-6, 5),
        (Order::SixGauss, 1e-9, 7),
    ];
    for (order, tolerance, intervals) in settings {
        let strut = strut(intervals);
        let solve = Options { order, tolerance, ..Options::default() };
        let options = BranchOptions { solve, range: (1.0, 400.0), ..BranchOptions::default() };
        let branch = trace(&strut, &strut.start(), 0, &[], &options, &[]).unwrap();
        let exact = |k: usize| (k as f64 * std::f64::consts::PI).powi(2);
        let found: Vec<_> = branch.branch_points().map(|point| (point.parameter, point.is_settled)).collect();
        println!("{order:?} {tolerance:.0e} from {intervals}: {} points, {found:?}", branch.points.len());
        assert_eq!(found.len(), 6, "{order:?} {tolerance:.0e} from {intervals}");
        assert!(
            found.iter().all(|(_, is_settled)| *is_settled),
            "{order:?} {tolerance:.0e} from {intervals}: {found:?}"
        );
        let is_exact = |(k, point): (usize, &(f64, bool))| (point.0 / exact(k + 1) - 1.0).abs() <= 10.0 * tolerance;
        assert!(found.iter().enumerate().all(is_exact), "{order:?} {tolerance:.0e} from {intervals}: {found:?}");
        assert_eq!(branch.points.last().map(|end| (end.kind, end.parameter)), Some((PointKind::End, 400.0)));

        let unsettled = BranchOptions { settle_branch_points: false, ..options };
        let branch = trace(&strut, &strut.start(), 0, &[], &unsettled, &[]).unwrap();
        assert_eq!(branch.branch_points().count(), 6, "{order:?} {tolerance:.0e} from {intervals}, not settled");
    }
}
