//! Which solution it is: orientation, what is said of a solution that cannot be vouched for, branch points.

#![allow(clippy::unwrap_used)]

use solver::bvp::Bvp;
use solver::continuation::{BranchOptions, PathOptions, PointKind, Ramp, follow, trace, trace_crossing};
use solver::model::{Differentiated, Model, Scalar};
use solver::{BranchCheck, Guess, Layout, Options, Order, Orientation, Problem, Region, Solution, solve};

const ORDERS: [Order; 4] = [Order::Four, Order::Six, Order::Eight, Order::SixGauss];

fn two_states() -> Layout {
    let line = Region::dense("line", (0.0, 1.0), &["u", "slope"], &[], 1);
    Layout::dense(vec![line], &["lambda"], &["left", "right"])
}

/// `u'' = -λ exp(u)`, `u(0) = u(1) = 0`: two solutions below the fold.
struct Bratu;

impl Model for Bratu {
    fn layout(&self) -> Layout {
        two_states()
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], c: &[S], f: &mut [S]) {
        (f[0], f[1]) = (y[1], -c[0] * y[0].exp());
    }
    fn boundary<S: Scalar>(&self, e: &[S], _: &[S], _: &[S], g: &mut [S]) {
        (g[0], g[1]) = (e[0], e[2]);
    }
}

fn bratu(height: f64, intervals: usize, order: Order) -> Solution {
    let problem = Differentiated::new(Bratu).unwrap();
    let guess = Guess::uniform(problem.layout(), intervals, &[1.0], |_, s, y| {
        (y[0], y[1]) = (4.0 * height * s * (1.0 - s), 4.0 * height * (1.0 - 2.0 * s));
    });
    solve(&problem, &guess, &[], &Options { order, ..Options::default() }).unwrap()
}

#[test]
fn orientation_tells_two_solutions_apart_on_any_mesh() {
    for order in ORDERS {
        for intervals in [5, 8, 11, 20, 23, 64] {
            let [low, high] = [0.1, 4.0].map(|height| bratu(height, intervals, order));
            assert!(low.regions()[0].eval(0.5)[0] < 1.0 && high.regions()[0].eval(0.5)[0] > 3.0);
            // Linearised at the lower solution, v(1) for v(0) = 0, v'(0) = 1 is positive; at the upper one it is
            // negative.
            assert_eq!(low.orientation(), bratu(0.1, 10, Order::Four).orientation(), "{intervals}");
            assert!(low.orientation().is_some() && low.orientation() != high.orientation(), "{intervals}");
        }
    }
}

#[test]
fn a_solution_far_from_its_guess_is_not_vouched_for() {
    assert_eq!(bratu(0.14, 20, Order::Four).branch_check(), BranchCheck::Kept);
    // From a guess between the two, Newton's iteration ends at the one or the other.
    for (height, upper) in [(2.0, false), (3.0, true)] {
        let solution = bratu(height, 20, Order::Four);
        assert_eq!(solution.regions()[0].eval(0.5)[0] > 1.0, upper);
        assert_eq!(solution.branch_check(), BranchCheck::Strayed { at: 0.0 }, "{height}");
    }
}

/// `u' = c`, `u(0) = 0`, `u(1)³ - 3 u(1) + λ = 0`: an S with folds at λ = ±2.
struct Hysteresis;

impl Model for Hysteresis {
    fn layout(&self) -> Layout {
        let line = Region::dense("line", (0.0, 1.0), &["u"], &[], 2);
        Layout::dense(vec![line], &["c", "lambda"], &["left", "right"])
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, _: &[S], c: &[S], f: &mut [S]) {
        f[0] = c[0];
    }
    fn boundary<S: Scalar>(&self, e: &[S], _: &[S], c: &[S], g: &mut [S]) {
        (g[0], g[1]) = (e[0], e[1].powi(3) - e[1] * 3.0 + c[1]);
    }
}

#[test]
fn a_path_that_jumps_at_a_fold_says_so() {
    let problem = Differentiated::new(Hysteresis).unwrap();
    let guess = Guess::uniform(problem.layout(), 8, &[2.2, -3.0], |_, s, y| y[0] = 2.2 * s);
    let to = |lambda: f64| {
        let path = Ramp::new().linear(1, -3.0, lambda);
        follow(&problem, &guess, &path, &[0], &PathOptions::default())
    };
    let kept = to(1.0).unwrap().solution;
    assert_eq!(kept.branch_check(), BranchCheck::Kept);
    assert!(kept.constants()[0] > 1.0, "still on the upper branch");
    // Beyond the fold at λ = 2 the only solution is on the lower branch: the path ends, or says that it left its
    // branch.
    if let Ok(jumped) = to(3.0) {
        assert!(jumped.solution.constants()[0] < -1.0);
        assert_ne!(jumped.solution.branch_check(), BranchCheck::Kept);
    }
}

/// AUTO's demo `bvp`: `u'' = -(λ π)² u + u²`, `u(0) = u(1) = 0`. On the trivial branch there are branch points at every
/// whole λ.
struct Eigenvalues;

impl Model for Eigenvalues {
    fn layout(&self) -> Layout {
        two_states()
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], c: &[S], f: &mut [S]) {
        let frequency = c[0] * std::f64::consts::PI;
        (f[0], f[1]) = (y[1], y[0] * y[0] - frequency * frequency * y[0]);
    }
    fn boundary<S: Scalar>(&self, e: &[S], _: &[S], _: &[S], g: &mut [S]) {
        (g[0], g[1]) = (e[0], e[2]);
    }
}

#[test]
fn the_five_branch_points_of_autos_demo_are_located() {
    let problem = Differentiated::new(Eigenvalues).unwrap();
    let guess = Guess::uniform(problem.layout(), 10, &[0.5], |_, _, y| y.fill(0.0));
    for order in ORDERS {
        let options = BranchOptions {
            solve: Options { order, ..Options::default() },
            range: (0.5, 5.5),
            largest_step: 0.15,
            ..BranchOptions::default()
        };
        let branch = trace(&problem, &guess, 0, &[], &options, &[]).unwrap();
        let found: Vec<f64> = branch.branch_points().map(|point| point.parameter).collect();
        assert_eq!(found.len(), 5, "{order:?}: {found:?}");
        for (found, wanted) in found.iter().zip(1..) {
            // The trivial solution asks for no mesh: what bifurcates does.
            let error = (found / f64::from(wanted) - 1.0).abs();
            assert!(error < options.solve.tolerance, "{order:?}: {found} for {wanted}");
        }
        let lengths: Vec<f64> = branch.points.iter().map(|point| point.arclength).collect();
        assert!(lengths.is_sorted(), "{order:?}: {lengths:?}");
        // Without, they are those of the discrete problem.
        let unsettled = BranchOptions { settle_branch_points: false, ..options.clone() };
        let branch_of_mesh = trace(&problem, &guess, 0, &[], &unsettled, &[]).unwrap();
        assert!(branch_of_mesh.stats.factorisations < branch.stats.factorisations, "{order:?}");
        for (found, wanted) in branch_of_mesh.branch_points().map(|point| point.parameter).zip(1..) {
            assert!((found / f64::from(wanted) - 1.0).abs() < 2e-2, "{order:?}: {found} for {wanted}");
        }
        assert_eq!(branch.folds().count(), 0);
        assert_eq!(branch.points.last().unwrap().kind, PointKind::End);
        let unwatched = BranchOptions { branch_points: false, ..options };
        assert_eq!(trace(&problem, &guess, 0, &[], &unwatched, &[]).unwrap().branch_points().count(), 0);
    }
}

#[test]
fn branch_points_in_the_middle_of_steps_are_located_by_few_solves() {
    let problem = Differentiated::new(Eigenvalues).unwrap();
    let guess = Guess::uniform(problem.layout(), 32, &[0.0], |_, _, y| y.fill(0.0));
    let options = BranchOptions {
        solve: Options { order: Order::Eight, tolerance: 1e-12, ..Options::default() },
        range: (0.0, 5.5),
        // From λ = 0.95 a step leads to 1.05: in its middle the matrix is singular.
        largest_step: 0.1,
        // On the mesh as it is, and in steps as long as that.
        settle_branch_points: false,
        resolve_branch_points: false,
        ..BranchOptions::default()
    };
    let branch = trace(&problem, &guess, 0, &[], &options, &[]).unwrap();
    let found: Vec<f64> = branch.branch_points().map(|point| point.parameter).collect();
    assert_eq!(found.len(), 5, "{found:?}");
    for (found, wanted) in found.iter().zip(1..) {
        assert!((found - f64::from(wanted)).abs() < 5e-9, "{found} for {wanted}");
    }
    for point in branch.branch_points() {
        assert_eq!(point.solution.constants()[0], point.parameter);
    }
    // One solve for every other point, and five for a branch point or the end.
    let others = branch.points.len() - 6;
    assert!(branch.stats.meshes <= others + 6 * 5, "{others} other points: {:?}", branch.stats);
    // Where u vanishes, the iteration's own factorisation gives the tangent.
    assert!(branch.stats.factorisations <= branch.stats.newton_iterations + 2, "{:?}", branch.stats);
}

/// The last step leads beyond the range's end, and beyond a branch point behind it: the sign that has changed there is
/// accounted for.
#[test]
fn a_branch_point_behind_the_end_of_the_range_is_no_turn() {
    let problem = Differentiated::new(Eigenvalues).unwrap();
    let guess = Guess::uniform(problem.layout(), 32, &[0.0], |_, _, y| y.fill(0.0));
    let options = BranchOptions { range: (0.0, 0.99), largest_step: 0.1, ..BranchOptions::default() };
    let branch = trace(&problem, &guess, 0, &[], &options, &[]).unwrap();
    assert_eq!((branch.check, branch.branch_points().count()), (BranchCheck::Kept, 0));
    assert_eq!(branch.points.last().unwrap().kind, PointKind::End);
}

#[test]
fn the_orientation_is_that_of_the_problem_itself() {
    // u'' = -(λ π)² u: v(1) = sin(λ π)/(λ π) for v(0) = 0, v'(0) = 1 changes sign at every whole λ.
    let problem = Differentiated::new(Eigenvalues).unwrap();
    let at = |lambda: f64| {
        let guess = Guess::uniform(problem.layout(), 40, &[lambda], |_, _, y| y.fill(0.0));
        solve(&problem, &guess, &[], &Options::default()).unwrap().orientation().unwrap()
    };
    let signs = [0.5, 1.5, 2.5, 3.5, 4.5].map(at);
    assert!(signs.windows(2).all(|pair| pair[0] != pair[1]), "{signs:?}");
    assert!(signs.contains(&Orientation::Positive) && signs.contains(&Orientation::Negative));
}

/// `u'' + λ (u - u³) = 0`, `u(0) = u(π) = 0`: branch points of the trivial solution at the squares of whole numbers.
struct Buckling;

impl Model for Buckling {
    fn layout(&self) -> Layout {
        let mut layout = two_states();
        layout.regions[0].interval = (0.0, std::f64::consts::PI);
        layout
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], c: &[S], f: &mut [S]) {
        (f[0], f[1]) = (y[1], c[0] * (y[0] * y[0] * y[0] - y[0]));
    }
    fn boundary<S: Scalar>(&self, e: &[S], _: &[S], _: &[S], g: &mut [S]) {
        (g[0], g[1]) = (e[0], e[2]);
    }
}

#[test]
fn loads_of_buckling_do_not_hang_on_the_mesh_of_the_guess() {
    let problem = Differentiated::new(Buckling).unwrap();
    let guess = Guess::uniform(problem.layout(), 10, &[0.5], |_, _, y| y.fill(0.0));
    let options = BranchOptions { range: (0.5, 30.0), largest_step: 0.2, ..BranchOptions::default() };
    let loads = |options: &BranchOptions| -> Vec<f64> {
        let branch = trace(&problem, &guess, 0, &[], options, &[]).unwrap();
        branch.branch_points().map(|point| point.parameter).collect()
    };
    let settled = loads(&options);
    assert_eq!(settled.len(), 5, "{settled:?}");
    for (found, wanted) in settled.iter().zip([1.0, 4.0, 9.0, 16.0, 25.0]) {
        assert!((found / wanted - 1.0).abs() < options.solve.tolerance, "{found} for {wanted}");
    }
    let of_mesh = loads(&BranchOptions { settle_branch_points: false, ..options.clone() });
    assert!((of_mesh[4] - 25.0).abs() > 0.1, "{of_mesh:?}");
    // In the first step, too.
    let guess = Guess::uniform(problem.layout(), 10, &[24.5], |_, _, y| y.fill(0.0));
    let options = BranchOptions { range: (24.0, 30.0), first_step: 0.2, ..options };
    let branch = trace(&problem, &guess, 0, &[], &options, &[]).unwrap();
    let found = branch.branch_points().next().map(|point| point.parameter);
    assert!(found.is_some_and(|found| (found / 25.0 - 1.0).abs() < options.solve.tolerance), "{found:?}");
}

/// Branch points of the state of rest up to a value, at default steps: those of a determinant that is known, and those
/// of its sign at the steps' ends.
fn branch_points_of_rest(bvp: &impl Problem, start: &Guess, order: Order, to: f64) -> [Vec<f64>; 2] {
    [true, false].map(|resolve_branch_points| {
        let solve = Options { order, ..Options::default() };
        let range = (-1.0, to);
        let options = BranchOptions { solve, range, resolve_branch_points, ..BranchOptions::default() };
        let branch = trace(bvp, start, 0, &[], &options, &[]).unwrap();
        assert_eq!(
            branch.points.last().map(|point| point.kind),
            Some(PointKind::End),
            "{} points",
            branch.points.len()
        );
        branch.branch_points().map(|point| point.parameter).collect()
    })
}

/// Two struts, of which one buckles at the squares of whole numbers, the other at loads less by `apart`.
fn struts(apart: f64, intervals: usize) -> (impl Problem, Guess) {
    let struts = Bvp::new(
        &["u", "du", "v", "dv"],
        (0.0, std::f64::consts::PI),
        move |_, y, p, f| {
            (f[0], f[1]) = (y[1], p[0] * (y[0] * y[0] * y[0] - y[0]));
            (f[2], f[3]) = (y[3], (p[0] + apart) * (y[2] * y[2] * y[2] - y[2]));
        },
        |a, b, _, g| (g[0], g[1], g[2], g[3]) = (a[0], b[0], a[2], b[2]),
    );
    let struts = struts.given("load", 0.1).guess(intervals, |_, y| y.fill(0.0));
    let start = struts.start();
    (struts, start)
}

/// Pairs that a step may pass with a determinant of the same sign before and behind.
#[test]
fn branch_points_that_one_step_would_pass_are_told_apart() {
    let mut passed = 0;
    for order in [Order::Six, Order::Eight] {
        for apart in [2.0, 1.0, 0.5, 0.2, 0.05, 0.01] {
            let (struts, start) = struts(apart, 24);
            let [found, by_sign] = branch_points_of_rest(&struts, &start, order, 12.0);
            let mut wanted: Vec<f64> = [1.0, 4.0, 9.0].into_iter().flat_map(|load| [load, load - apart]).collect();
            wanted.retain(|load| *load > 0.1);
            wanted.sort_by(f64::total_cmp);
            assert_eq!(found.len(), wanted.len(), "{order:?} {apart}: {found:?} for {wanted:?}");
            for (found, wanted) in found.iter().zip(&wanted) {
                assert!((found / wanted - 1.0).abs() < 1e-5, "{order:?} {apart}: {found} for {wanted}");
            }
            passed += wanted.len() - by_sign.len();
        }
    }
    assert!(passed > 20, "steps that would pass pairs: {passed}");
}

/// On ten intervals of order 4 both of a pair are far from where they are on fine ones, by up to 0.4, and as far or
/// farther than from each other: each settles to its own.
#[test]
fn branch_points_that_are_close_do_not_settle_to_each_other() {
    for apart in [1.0, 0.5, 0.1, 1e-2, 1e-3] {
        let (struts, start) = struts(apart, 10);
        let [found, _] = branch_points_of_rest(&struts, &start, Order::Four, 26.0);
        let pairs = [1.0, 4.0, 9.0, 16.0, 25.0].into_iter().flat_map(|load| [load - apart, load]);
        let wanted: Vec<f64> = pairs.filter(|load| *load > 0.1).collect();
        assert_eq!(found.len(), wanted.len(), "{apart}: {found:?} for {wanted:?}");
        for (found, wanted) in found.iter().zip(&wanted) {
            assert!((found / wanted - 1.0).abs() < 1e-5, "{apart}: {found} for {wanted}");
        }
    }
}

/// Where two struts are alike, either buckles: the determinant has a double zero, and keeps its sign.
#[test]
fn branch_points_of_even_multiplicity_are_found() {
    for (order, intervals) in ORDERS.into_iter().flat_map(|order| [(order, 10), (order, 24)]) {
        let (struts, start) = struts(0.0, intervals);
        let [found, by_sign] = branch_points_of_rest(&struts, &start, order, 26.0);
        assert!(are(&found, &[1.0, 4.0, 9.0, 16.0, 25.0]), "{order:?}: {found:?}");
        assert!(by_sign.is_empty(), "{order:?}: {by_sign:?}");
    }
    // Of the branches that leave one is found, to both sides.
    let (struts, start) = struts(0.0, 24);
    let options = BranchOptions { range: (0.0, 4.0), ..BranchOptions::default() };
    let rest = trace(&struts, &start, 0, &[], &options, &[]).unwrap();
    let buckling = rest.branch_points().next().unwrap();
    for half in trace_crossing(&struts, buckling, 0, &[], &options, &[]).unwrap() {
        let end = half.points.last().unwrap();
        assert!(end.kind == PointKind::End && end.solution.regions()[0].eval(0.5)[0].abs() > 0.1);
    }
}

fn are(found: &[f64], wanted: &[f64]) -> bool {
    found.len() == wanted.len() && found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 2e-6 * b.max(1.0))
}

/// `u'' + λ u - u³ = 0` on a ring: from λ = k² waves branch off that may stand anywhere, a sine and a cosine, and
/// from 0 the constant. Meshes that are not uniform take the two apart: where they settle they are at one place.
#[test]
fn waves_on_a_ring_branch_off_by_twos() {
    for (order, graded) in ORDERS.into_iter().flat_map(|order| [(order, 0.0), (order, 0.3)]) {
        let ring = Bvp::new(
            &["u", "slope"],
            (0.0, std::f64::consts::TAU),
            |_, y, p, f| (f[0], f[1]) = (y[1], y[0] * y[0] * y[0] - p[0] * y[0]),
            |a, b, _, g| (g[0], g[1]) = (a[0] - b[0], a[1] - b[1]),
        );
        let ring = ring.given("lambda", -0.5).guess(20, |_, y| y.fill(0.0));
        let mut start = ring.start();
        start.regions[0].mesh.iter_mut().for_each(|s| *s += graded * s.sin());
        let [found, by_sign] = branch_points_of_rest(&ring, &start, order, 27.0);
        assert!(are(&found, &[0.0, 1.0, 4.0, 9.0, 16.0, 25.0]), "{order:?}, {graded}: {found:?}");
        assert!(by_sign.len() < 6, "{order:?}, {graded}: {by_sign:?}");
    }
}

/// `u'' + λ u + β v - u³ = 0` and `v'' + λ v - β u - v³ = 0`: the zeros of the determinant are complex, k² ± iβ. It
/// comes as close to zero as β is small, and touches it nowhere.
#[test]
fn a_determinant_that_comes_close_to_zero_is_no_branch_point() {
    for (order, bound) in ORDERS.into_iter().flat_map(|order| [1e-1, 1e-2, 1e-3, 1e-4].map(|bound| (order, bound))) {
        let strings = Bvp::new(
            &["u", "du", "v", "dv"],
            (0.0, std::f64::consts::PI),
            move |_, y, p, f| {
                (f[0], f[1]) = (y[1], y[0] * y[0] * y[0] - p[0] * y[0] - bound * y[2]);
                (f[2], f[3]) = (y[3], y[2] * y[2] * y[2] - p[0] * y[2] + bound * y[0]);
            },
            |a, b, _, g| (g[0], g[1], g[2], g[3]) = (a[0], b[0], a[2], b[2]),
        );
        let strings = strings.given("lambda", 0.1).guess(24, |_, y| y.fill(0.0));
        let [found, _] = branch_points_of_rest(&strings, &strings.start(), order, 26.0);
        assert!(found.is_empty(), "{order:?}, {bound}: {found:?}");
    }
}

/// `u_t = r u - (1 + ∂²)² u - u³` (J. Swift and P. C. Hohenberg, Phys. Rev. A 15 (1977) 319-328), u and its curvature
/// zero at both ends: rest loses its stability to n half waves on the length L at `r = (1 - (nπ/L)²)²`, many of them
/// close together.
#[test]
fn patterns_of_swift_and_hohenberg_are_all_met() {
    for (length, intervals) in [(10.0, 32), (20.0, 32), (31.4, 48)] {
        let patterns = Bvp::new(
            &["u", "slope", "curvature", "third"],
            (0.0, length),
            |_, y, p, f| {
                let fourth = (p[0] - 1.0) * y[0] - 2.0 * y[2] - y[0] * y[0] * y[0];
                (f[0], f[1], f[2], f[3]) = (y[1], y[2], y[3], fourth);
            },
            |a, b, _, g| (g[0], g[1], g[2], g[3]) = (a[0], b[0], a[2], b[2]),
        );
        let patterns = patterns.given("r", -0.1).guess(intervals, |_, y| y.fill(0.0));
        let half_waves = |n: u32| (1.0 - (f64::from(n) * std::f64::consts::PI / length).powi(2)).powi(2);
        let mut wanted: Vec<f64> = (1..60).map(half_waves).filter(|r| *r < 1.0).collect();
        wanted.sort_by(f64::total_cmp);
        for order in [Order::Six, Order::Eight] {
            let [found, by_sign] = branch_points_of_rest(&patterns, &patterns.start(), order, 1.0);
            assert_eq!(found.len(), wanted.len(), "{order:?} {length}: {found:?} for {wanted:?}");
            for (found, wanted) in found.iter().zip(&wanted) {
                assert!((found - wanted).abs() < 2e-5, "{order:?} {length}: {found} for {wanted}");
            }
            assert!(by_sign.len() < wanted.len(), "{order:?} {length}");
        }
    }
}

/// Struts of lengths 1 to 3 beside each other buckle at `(kπ/l)²`: two or three of them at once where their lengths are
/// commensurable, which coarse meshes of order 4 take apart. What is said to have settled is right; what has not is not
/// said to have.
#[test]
fn branch_points_that_have_not_settled_are_not_said_to_have() {
    let unsettled = [vec![1.0], vec![1.0, 1.01], vec![1.0, 2.0], vec![1.0, 2.0, 3.0]].map(|lengths| {
        let names: Vec<String> = (0..2 * lengths.len()).map(|i| format!("y{i}")).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let squares: Vec<f64> = lengths.iter().map(|length: &f64| length * length).collect();
        let struts = Bvp::new(
            &names,
            (0.0, 1.0),
            |_, y, p, f| {
                for (i, square) in squares.iter().enumerate() {
                    (f[2 * i], f[2 * i + 1]) = (y[2 * i + 1], y[2 * i] * p[0] * -square);
                }
            },
            |a, b, _, g| (0..squares.len()).for_each(|i| (g[2 * i], g[2 * i + 1]) = (a[2 * i], b[2 * i])),
        )
        .given("load", 1.0)
        .guess(10, |_, y| y.fill(0.0));
        let options = BranchOptions { range: (1.0, 100.0), ..BranchOptions::default() };
        let branch = trace(&struts, &struts.start(), 0, &[], &options, &[]).unwrap();
        let loads = |length: &f64| {
            let load = std::f64::consts::PI.powi(2) / (length * length);
            (1..10).map(move |k| f64::from(k * k) * load)
        };
        let exact: Vec<f64> = lengths.iter().flat_map(loads).collect();
        let error = |load: f64| exact.iter().map(|exact| (load / exact - 1.0).abs()).fold(f64::INFINITY, f64::min);
        assert!(branch.branch_points().count() >= 3, "{lengths:?}");
        for point in branch.branch_points().filter(|point| point.is_settled) {
            assert!(error(point.parameter) < 1e-5, "{lengths:?}: {}", point.parameter);
        }
        assert!(branch.points.iter().all(|point| point.is_settled || point.kind == PointKind::BranchPoint));
        branch.branch_points().filter(|point| !point.is_settled && error(point.parameter) > 1e-3).count()
    });
    assert_eq!(unsettled[..2], [0; 2]);
    assert!(unsettled[3] > 0, "no point is left by which this could fail");
}

/// Two struts, one of them a little longer, have three pairs of branch points, of which a step may hold one near its
/// end: the determinant falls there, and rises at the beginning of the next.
#[test]
fn pairs_beside_the_end_of_a_step_are_seen() {
    let found = |longer: f64, order: Order| {
        let struts = Bvp::new(
            &["u", "du", "v", "dv"],
            (0.0, 1.0),
            move |_, y, p, f| {
                (f[0], f[1]) = (y[1], y[0] * -p[0]);
                (f[2], f[3]) = (y[3], y[2] * p[0] * -(1.0 + longer).powi(2));
            },
            |a, b, _, g| (g[0], g[1], g[2], g[3]) = (a[0], b[0], a[2], b[2]),
        )
        .given("load", 1.0)
        .guess(10, |_, y| y.fill(0.0));
        let solve = Options { order, ..Options::default() };
        let options = BranchOptions { solve, range: (1.0, 100.0), ..BranchOptions::default() };
        trace(&struts, &struts.start(), 0, &[], &options, &[]).unwrap().branch_points().count()
    };
    for order in [Order::Four, Order::Six, Order::Eight] {
        assert_eq!([1e-1, 1e-2, 1e-3].map(|longer| found(longer, order)), [6; 3], "{order:?}");
    }
}
