//! Problems that say that they are linear: the same solutions from fewer evaluations, and no others.

#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

#[path = "../benches/peers/cases.rs"]
mod cases;
#[path = "../benches/peers/open.rs"]
mod open;
#[path = "../benches/peers/singular.rs"]
mod singular;
#[path = "../benches/peers/system.rs"]
mod system;

use cases::{CASES, Case, STATES};
use solver::bvp::{Bvp, Formulas};
use solver::dae::{Dae, Reduced};
use solver::model::{Differentiated, Model, Scalar};
use solver::{Guess, Layout, LayoutError, NewtonError, Options, Order, Problem, Region, Solution, SolveError, solve};
use system::System;

const ORDERS: [Order; 4] = [Order::Four, Order::Six, Order::Eight, Order::SixGauss];

fn stated(case: &'static Case, intervals: usize) -> Bvp<System> {
    system::stated(case, case.conditions(), intervals)
}

/// The largest difference of the u of two solutions, at the nodes of the first, to the largest u or 1.
fn distance(a: &Solution, b: &Solution, states: impl Iterator<Item = usize> + Clone) -> f64 {
    let (a, b) = (&a.regions()[0], &b.regions()[0]);
    let of = |i: usize| {
        let largest = a.state(i).iter().fold(1.0, |max: f64, u| max.max(u.abs()));
        let differences = a.mesh().iter().zip(a.state(i)).map(|(&x, u)| (b.eval(x)[i] - u).abs());
        differences.fold(0.0, f64::max) / largest
    };
    states.map(of).fold(0.0, f64::max)
}

/// The largest error of u at the nodes, to the largest u or 1; none where the solution is not known.
fn error(case: &Case, solution: &Solution) -> Option<f64> {
    let line = &solution.regions()[0];
    let (mut largest, mut error): (f64, f64) = (1.0, 0.0);
    for (i, state) in case.unknowns().enumerate() {
        for (&x, &u) in line.mesh().iter().zip(line.state(state)) {
            let exact = case.exact(x)?[i];
            (largest, error) = (largest.max(exact.abs()), error.max((u - exact).abs()));
        }
    }
    Some(error / largest)
}

/// Where the equations are singular at an end, what is said to be their solution is one.
#[test]
fn solutions_of_singular_cases_are_found() {
    assert!(!CASES.iter().chain(open::CASES).any(Case::is_singular));
    for case in singular::CASES {
        assert!(case.is_singular() && case.linear);
        let problem = system::stated(case, case.conditions(), 10).linear();
        let options = Options { order: Order::SixGauss, tolerance: 1e-8, ..Options::default() };
        let error = error(case, &problem.solve(&options).unwrap()).unwrap();
        assert!(error <= 1e-8, "{}: {error:e}", case.name);
    }
}

/// Those of the peers' bench, by differences.
#[test]
fn derivatives_of_all_cases_are_those_of_their_right_hand_sides() {
    for case in CASES.iter().chain(open::CASES).chain(singular::CASES) {
        let (states, equations) = (case.states(), case.equations());
        let (a, b) = case.interval;
        let x = a + 0.37 * (b - a);
        let mut z = [0.0; STATES];
        case.guess(x, &mut z[..states]);
        z.iter_mut().zip(1..).for_each(|(z, i)| *z += 0.1 + 0.03 * f64::from(i));
        let (mut f, mut rows) = ([0.0; STATES], [0.0; STATES * STATES]);
        case.derivatives(x, &z[..states], &mut f[..equations], &mut rows[..equations * states]);
        let at = |z: &[f64]| {
            let mut f = [0.0; STATES];
            case.values(x, &z[..states], &mut f[..equations]);
            f
        };
        assert_eq!(at(&z), f, "{}", case.name);
        for j in 0..states {
            let h = 1e-6 * (1.0 + z[j].abs());
            let moved = |by: f64| {
                let mut z = z;
                z[j] += by;
                at(&z)
            };
            let (more, less) = (moved(h), moved(-h));
            for i in 0..equations {
                let (difference, derivative) = ((more[i] - less[i]) / (2.0 * h), rows[i * states + j]);
                let size = 1.0 + f[i].abs() + derivative.abs();
                assert!((difference - derivative).abs() < 1e-6 * size, "{}: {i}, {j}: {difference:e}", case.name);
            }
        }
    }
}

#[test]
fn linear_problems_are_solved_as_well_from_fewer_evaluations() {
    let (mut values, mut derivatives) = ([0, 0], [0, 0]);
    for case in CASES.iter().chain(open::CASES).filter(|case| case.linear) {
        for order in ORDERS {
            for (tolerance, intervals) in [(1e-3, 4), (1e-3, 16), (1e-6, 8), (1e-9, 10), (1e-11, 16)] {
                for defect_correction in [false, true] {
                    let options = Options { order, tolerance, defect_correction, ..Options::default() };
                    let what = format!("{}, {order:?}, {tolerance:e} from {intervals}", case.name);
                    let plain = stated(case, intervals).solve(&options);
                    let said = stated(case, intervals).linear().solve(&options);
                    let (Ok(plain), Ok(said)) = (&plain, &said) else {
                        // What rounding does not let be solved need not fail in the same place.
                        assert!(tolerance < 1e-10, "{what}: {plain:?}, {said:?}");
                        continue;
                    };
                    let within = 10.0 * tolerance;
                    assert!(error(case, said).is_none_or(|error| error <= within), "{what}: {:?}", error(case, said));
                    let apart = distance(said, plain, case.unknowns());
                    assert!(apart <= within, "{what}: {apart:e}");
                    let (a, b) = (plain.stats(), said.stats());
                    assert!(tolerance < 1e-8 || b.newton_iterations <= 2 * b.meshes, "{what}");
                    values = [values[0] + a.rhs_points, values[1] + b.rhs_points];
                    if tolerance > 1e-8 {
                        derivatives = [derivatives[0] + a.jacobian_points, derivatives[1] + b.jacobian_points];
                    }
                }
            }
        }
    }
    assert!(3 * values[1] < 2 * values[0], "{values:?}");
    // Meshes are the same, but where rounding hides from an iteration that a problem is linear: there, meshes that may
    // grow more freely do not always pay (problem 10 at order 6).
    assert!(8 * derivatives[1] < 9 * derivatives[0], "{derivatives:?}");
}

/// Bratu's problem, which is not linear.
fn bratu(lambda: f64) -> Bvp<impl Formulas> {
    let f = move |_: f64, y: &[solver::bvp::Number], _: &[solver::bvp::Number], f: &mut [solver::bvp::Number]| {
        (f[0], f[1]) = (y[1], -lambda * y[0].exp());
    };
    Bvp::new(&["u", "slope"], (0.0, 1.0), f, |a, b, _, g| (g[0], g[1]) = (a[0], b[0]))
}

#[test]
fn what_is_not_linear_is_not_solved_as_if_it_were() {
    let mut told = 0;
    for order in ORDERS {
        for (intervals, max_intervals) in [(4, 1000), (10, 20), (10, 10)] {
            for (lambda, tolerance) in [(1.0, 1e-6), (1.0, 1e-9), (3.5, 1e-3), (3.5, 1e-6)] {
                let options = Options { order, max_intervals, tolerance, ..Options::default() };
                let guess = |_: f64, y: &mut [f64]| y.fill(0.0);
                match bratu(lambda).guess(intervals, guess).linear().solve(&options) {
                    // As one mesh follows on the other, corrections do: the defects say that they have been enough.
                    Ok(solution) => {
                        let exact = bratu(lambda).solve(&Options { tolerance: 1e-10, ..Options::default() }).unwrap();
                        let apart = distance(&exact, &solution, 0..2);
                        assert!(apart <= 10.0 * tolerance, "{order:?}, {lambda}, {tolerance:e}: {apart:e}");
                    }
                    Err(SolveError::NotLinear { quantity, region, position, found, expected }) => {
                        let names = (quantity.as_str(), region.as_str());
                        assert_eq!(names, ("the right-hand side of slope", "interval"));
                        assert!((0.0..=1.0).contains(&position) && (found - expected).abs() > 1e-7);
                        told += 1;
                    }
                    Err(SolveError::MeshLimit { .. }) if max_intervals < 100 => {}
                    Err(error) => panic!("{order:?}, {lambda}, {intervals}: {error}"),
                }
            }
        }
    }
    assert!(told >= 12, "{told}");
    let error = bratu(3.5).linear().solve(&Options { tolerance: 1e-9, ..Options::default() }).unwrap_err();
    assert!(error.to_string().starts_with("the problem says that it is linear, but the right-hand side of slope in"));
    assert!(error.advice().contains("correct its derivatives") && error.is_final());
}

/// `u'' = 4 u + x` with a derivative that is wrong.
struct Wrong;

impl Formulas for Wrong {
    fn rhs(&self, x: f64, y: &[f64], _: &[f64], f: &mut [f64]) {
        (f[0], f[1]) = (y[1], 4.0 * y[0] + x);
    }
    fn rhs_derivatives(&self, x: f64, y: &[f64], p: &[f64], f: &mut [f64], columns: &mut [f64]) {
        self.rhs(x, y, p, f);
        columns.copy_from_slice(&[0.0, 40.0, 1.0, 0.0]);
    }
    fn boundary(&self, a: &[f64], b: &[f64], _: &[f64], g: &mut [f64]) {
        (g[0], g[1]) = (a[0], b[0] - 1.0);
    }
    fn boundary_derivatives(&self, a: &[f64], b: &[f64], p: &[f64], g: &mut [f64], columns: &mut [f64]) {
        self.boundary(a, b, p, g);
        columns.copy_from_slice(&[1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
    }
}

#[test]
fn wrong_derivatives_of_a_linear_problem_are_told() {
    for order in ORDERS {
        let options = Options { order, ..Options::default() };
        // The iteration finds its way all the same, by residuals that are evaluated.
        let right = Bvp::with(&["u", "slope"], (0.0, 1.0), Wrong).solve(&options).unwrap();
        let exact = |x: f64| 1.25 * (2.0 * x).sinh() / 2.0_f64.sinh() - 0.25 * x;
        assert!((right.regions()[0].eval(0.5)[0] - exact(0.5)).abs() < 1e-5);
        let error = Bvp::with(&["u", "slope"], (0.0, 1.0), Wrong).linear().solve(&options).unwrap_err();
        assert!(matches!(error, SolveError::NotLinear { .. }), "{error}");
    }
}

#[test]
fn differences_are_not_relied_on() {
    let f = |x: f64, y: &[f64], _: &[f64], f: &mut [f64]| (f[0], f[1]) = (y[1], 4.0 * y[0] + x);
    let bc = |a: &[f64], b: &[f64], _: &[f64], g: &mut [f64]| (g[0], g[1]) = (a[0], b[0] - 1.0);
    let stated = Bvp::by_differences(&["u", "slope"], (0.0, 1.0), f, bc);
    let options = Options { tolerance: 1e-9, ..Options::default() };
    let (plain, said) = (stated.solve(&options).unwrap(), stated.clone().linear().solve(&options).unwrap());
    assert_eq!(plain.stats(), said.stats());
}

#[test]
fn unknown_parameters_may_be_among_what_it_is_linear_in() {
    for order in ORDERS {
        // u'' = p + sin x, with u = u' = 0 at 0 and u(1) = 2: u = p x²/2 + x - sin x.
        let problem = Bvp::new(
            &["u", "slope"],
            (0.0, 1.0),
            |x, y, p, f| (f[0], f[1]) = (y[1], p[0] + x.sin()),
            |a, b, _, g| (g[0], g[1], g[2]) = (a[0], a[1], b[0] - 2.0),
        )
        .unknown("p", 0.0);
        let options = Options { order, tolerance: 1e-9, ..Options::default() };
        let (plain, said) = (problem.solve(&options).unwrap(), problem.clone().linear().solve(&options).unwrap());
        let p = 2.0 * (1.0 + 1.0_f64.sin());
        assert!((said.constants()[0] - p).abs() < 4e-9, "{:?}", said.constants());
        assert!(said.stats().rhs_points < plain.stats().rhs_points);
        // A product of the two is not linear, until the parameter is given.
        let product = |unknown: bool| {
            let bc = move |a: &[solver::bvp::Number], b: &[solver::bvp::Number], _: &_, g: &mut [_]| {
                (g[0], g[1]) = (a[0], b[0] - 1.0);
                if unknown {
                    g[2] = a[1] - 1.2;
                }
            };
            let stated = Bvp::new(&["u", "slope"], (0.0, 1.0), |_, y, p, f| (f[0], f[1]) = (y[1], -p[0] * y[0]), bc);
            let named = if unknown { stated.unknown("p", 0.5) } else { stated.given("p", 0.5) };
            named.guess(10, |x, y| (y[0], y[1]) = (x, 1.0)).linear().solve(&options)
        };
        assert!(product(false).is_ok());
        match product(true) {
            Err(error) => assert!(matches!(error, SolveError::NotLinear { .. }), "{error}"),
            Ok(solution) => {
                let root = solution.constants()[0].sqrt();
                assert!((root / root.sin() - 1.2).abs() < 1e-7, "{root}");
            }
        }
    }
}

#[test]
fn boundary_equations_may_be_nonlinear() {
    for order in ORDERS {
        // u'' = u with u(0)³ = 8, u(1) = 2 exp(1): u = 2 exp(x).
        let problem = Bvp::new(
            &["u", "slope"],
            (0.0, 1.0),
            |_, y, _, f| (f[0], f[1]) = (y[1], y[0]),
            |a, b, _, g| (g[0], g[1]) = (a[0].powi(3) - 8.0, b[0] - 2.0 * 1.0_f64.exp()),
        )
        .guess(8, |_, y| y.fill(1.0))
        .linear();
        let options = Options { order, tolerance: 1e-9, ..Options::default() };
        let solution = problem.solve(&options).unwrap();
        assert!((solution.regions()[0].eval(0.0)[0] - 2.0).abs() < 1e-9);
        assert!(solution.max_boundary_residual() <= 1e-9);
    }
}

#[test]
fn a_solution_for_a_guess_is_left_as_it_is() {
    for (order, case) in ORDERS.into_iter().zip(CASES) {
        let options = Options { order, tolerance: 1e-7, ..Options::default() };
        let problem = stated(case, 8).linear();
        let solution = problem.solve(&options).unwrap();
        let again = solve(&problem, &Guess::from(&solution), &[], &options).unwrap();
        assert_eq!(again.regions()[0].mesh(), solution.regions()[0].mesh());
        assert_eq!(again.stats().newton_iterations, 1, "{order:?}");
    }
}

#[test]
fn guesses_that_are_far_too_large_do_no_harm() {
    let case = &CASES[0];
    for order in ORDERS {
        for size in [1.0, 1e4, 1e8, 1e12] {
            let options = Options { order, tolerance: 1e-7, ..Options::default() };
            let solution = stated(case, 10).guess(10, |x, y| y.fill(size * (1.0 + x))).linear().solve(&options);
            let error = error(case, &solution.unwrap()).unwrap();
            assert!(error < 1e-6, "{order:?}, {size:e}: {error:e}");
        }
    }
}

/// Two rods that meet, `k u'' = -1` with conductivities k of 1 and of 4, and a mean of the first one's u.
struct Rods {
    said_linear: bool,
}

impl Model for Rods {
    fn layout(&self) -> Layout {
        let rod = |name: &str, interval| Region::dense(name, interval, &["u", "flow"], &["heat"], 1);
        let equations = ["mean", "heat", "flow", "end", "other end"];
        Layout::dense(vec![rod("first", (0.0, 1.0)), rod("second", (1.0, 2.0))], &["offset"], &equations)
    }
    fn rhs<S: Scalar>(&self, region: usize, _: S, y: &[S], _: &[S], f: &mut [S]) {
        let k = [1.0, 4.0][region];
        (f[0], f[1], f[2]) = (y[1] / k, S::from(-1.0), y[0]);
    }
    fn boundary<S: Scalar>(&self, ends: &[S], integrals: &[S], c: &[S], g: &mut [S]) {
        (g[0], g[1], g[2]) = (integrals[0] - 1.0, ends[2] - ends[4], ends[3] - ends[5]);
        (g[3], g[4]) = (ends[0] - c[0], ends[6] - c[0] * 2.0);
    }
    fn is_linear(&self, _: &[usize]) -> bool {
        self.said_linear
    }
}

#[test]
fn models_of_several_regions_and_integrals_may_say_so() {
    for order in ORDERS {
        let options = Options { order, tolerance: 1e-9, ..Options::default() };
        let [said, silent] = [true, false].map(|said_linear| {
            let problem = Differentiated::new(Rods { said_linear }).unwrap();
            let guess = Guess::uniform(problem.layout(), 6, &[0.0], |_, _, y| y.fill(0.0));
            solve(&problem, &guess, &[0], &options).unwrap()
        });
        assert!((said.constants()[0] - silent.constants()[0]).abs() < 1e-12);
        assert!((said.regions()[0].integrals()[0] - 1.0).abs() < 1e-12);
        assert!(said.stats().rhs_points < silent.stats().rhs_points);
    }
}

/// `y' = z`, `0 = z + y - x`, y(0) = 0: y = x - 1 + exp(-x).
struct Lag;

impl Dae for Lag {
    fn layout(&self) -> Layout {
        Layout::dense(vec![Region::dense("time", (0.0, 2.0), &["y", "z"], &[], 0)], &[], &["start"])
    }
    fn algebraic(&self, _: usize) -> usize {
        1
    }
    fn rhs<S: Scalar>(&self, _: usize, x: S, y: &[S], _: &[S], f: &mut [S]) {
        (f[0], f[1]) = (y[1], y[1] + y[0] - x);
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
        g[0] = ends[0];
    }
    fn is_linear(&self, _: &[usize]) -> bool {
        true
    }
}

#[test]
fn differential_algebraic_problems_may_say_so() -> Result<(), LayoutError> {
    let problem = Differentiated::new(Reduced::new(Lag)?)?;
    let guess = Guess::uniform(&Reduced::new(Lag)?.layout(), 6, &[], |_, _, y| y.fill(0.0));
    let solution = solve(&problem, &guess, &[], &Options { tolerance: 1e-9, ..Options::default() }).unwrap();
    assert!((solution.regions()[0].eval(2.0)[0] - (1.0 + (-2.0_f64).exp())).abs() < 1e-9);
    assert_eq!(solution.stats().newton_iterations, solution.stats().meshes);
    Ok(())
}

/// `u'' = u + 2e4 u³ bump(x)`, `u(0) = u(1) = 1`: nonlinear where few meshes look at first.
fn hidden() -> Bvp<impl Formulas> {
    let f = |x: f64, y: &[solver::bvp::Number], _: &[solver::bvp::Number], f: &mut [solver::bvp::Number]| {
        let bump = 2e4 * (-((x - 0.37) / 0.004).powi(2)).exp();
        (f[0], f[1]) = (y[1], y[0] + y[0].powi(3) * bump);
    };
    Bvp::new(&["u", "slope"], (0.0, 1.0), f, |a, b, _, g| (g[0], g[1]) = (a[0] - 1.0, b[0] - 1.0))
}

#[test]
fn what_seemed_linear_on_the_first_mesh_need_not_be() {
    let fine = Options { order: Order::Six, tolerance: 1e-10, ..Options::default() };
    let reference = hidden().guess(100, |_, y| y.fill(1.0)).solve(&fine).unwrap();
    assert!(reference.history()[0].newton_iterations > 1, "{:?}", reference.history());
    for order in ORDERS {
        for tolerance in [1e-4, 1e-6, 1e-9] {
            let options = Options { order, tolerance, ..Options::default() };
            let solution = hidden().guess(4, |_, y| y.fill(0.0)).solve(&options).unwrap();
            // So it seems at this order.
            assert!(order != Order::Six || solution.history()[0].newton_iterations == 1, "{:?}", solution.history());
            let apart = distance(&solution, &reference, 0..2);
            assert!(apart <= 10.0 * tolerance, "{order:?}, {tolerance:e}: {apart:e}, {:?}", solution.history());
            // Meshes do not make up for what an iteration is there for.
            let finest = solution.history().iter().map(|mesh| mesh.intervals[0]).max();
            assert!(finest <= Some(500), "{order:?}, {tolerance:e}: {finest:?}");
        }
    }
}

#[test]
fn what_is_nearly_linear_is_solved_to_any_tolerance() {
    for size in [1e-12, 1e-10, 1e-8, 1e-6] {
        let f = move |_: f64, y: &[solver::bvp::Number], _: &[solver::bvp::Number], f: &mut [solver::bvp::Number]| {
            (f[0], f[1]) = (y[1], y[0] + y[0].powi(3) * size);
        };
        let bc = |a: &[solver::bvp::Number], b: &[solver::bvp::Number], _: &[solver::bvp::Number], g: &mut [_]| {
            (g[0], g[1]) = (a[0] - 1.0, b[0] - 1.0);
        };
        let problem = Bvp::new(&["u", "slope"], (0.0, 20.0), f, bc);
        let reference =
            problem.solve(&Options { order: Order::Eight, tolerance: 1e-12, ..Options::default() }).unwrap();
        for order in ORDERS {
            for tolerance in [1e-6, 1e-8, 1e-10] {
                let options = Options { order, tolerance, ..Options::default() };
                let apart = distance(&problem.solve(&options).unwrap(), &reference, 0..2);
                assert!(apart <= 10.0 * tolerance, "{size:e}, {order:?}, {tolerance:e}: {apart:e}");
            }
        }
    }
}

/// `ε u'' = -x u' + u/2`, a cusp at 0 of width √ε, and `ε u'' = u' - cos 9x`, a layer of width ε.
struct Thin {
    cusp: bool,
    eps: f64,
}

impl Formulas for Thin {
    fn rhs(&self, x: f64, y: &[f64], _: &[f64], f: &mut [f64]) {
        let moment = if self.cusp { 0.5 * y[0] - x * y[1] } else { y[1] - (9.0 * x).cos() };
        (f[0], f[1]) = (y[1], moment / self.eps);
    }
    fn rhs_derivatives(&self, x: f64, y: &[f64], c: &[f64], f: &mut [f64], columns: &mut [f64]) {
        self.rhs(x, y, c, f);
        let (by_u, by_slope) = if self.cusp { (0.5, -x) } else { (0.0, 1.0) };
        columns.copy_from_slice(&[0.0, by_u / self.eps, 1.0, by_slope / self.eps]);
    }
    fn boundary(&self, a: &[f64], b: &[f64], _: &[f64], g: &mut [f64]) {
        (g[0], g[1]) = if self.cusp { (a[0] - 1.0, b[0] - 2.0) } else { (a[0], b[0]) };
    }
    fn boundary_derivatives(&self, a: &[f64], b: &[f64], c: &[f64], g: &mut [f64], columns: &mut [f64]) {
        self.boundary(a, b, c, g);
        columns.copy_from_slice(&[1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
    }
}

/// On meshes that do not resolve its layers a solution may be a million times too large. What is left of that is
/// rounding, and no sign that the problem is not linear.
#[test]
fn linear_problems_whose_first_meshes_are_hopeless_are_not_said_to_be_others() {
    for (cusp, interval) in [(true, (-1.0, 2.0)), (false, (0.0, 2.0))] {
        for order in ORDERS {
            for tolerance in [1e-3, 1e-4, 1e-5, 1e-6, 1e-7] {
                for intervals in [4, 5, 8, 10] {
                    let problem = Bvp::with(&["u", "slope"], interval, Thin { cusp, eps: 1e-6 });
                    let problem = problem.guess(intervals, |_, y| y.fill(0.0)).linear();
                    let solved = problem.solve(&Options { order, tolerance, ..Options::default() });
                    assert!(solved.is_ok(), "{cusp}, {order:?}, {tolerance:e}, {intervals}: {}", solved.unwrap_err());
                }
            }
        }
    }
}

/// `u'' = 1` with both slopes given: no solution, or any constant more.
#[test]
fn what_a_linear_problem_leaves_undetermined_is_told() {
    for order in ORDERS {
        let problem = Bvp::new(
            &["u", "slope"],
            (0.0, 1.0),
            |_, y, _, f| (f[0], f[1]) = (y[1], y[0] * 0.0 + 1.0),
            |a, b, _, g| (g[0], g[1]) = (a[1], b[1] - 2.0),
        );
        let error = problem.linear().solve(&Options { order, ..Options::default() }).unwrap_err();
        let SolveError::Newton { error: NewtonError::Singular { null_vector, .. }, .. } = &error else {
            panic!("{error}")
        };
        assert!(null_vector[0].name.starts_with("u at"), "{error}");
    }
}

/// Of a problem that does not say so, later meshes show by what they are evaluated that it has been seen.
#[test]
fn what_an_iteration_shows_to_be_linear_is_evaluated_less_on_the_next_mesh() {
    let stated = |said: bool| {
        let case = &CASES[0];
        let problem = stated(case, 4);
        let options = Options { order: Order::Six, tolerance: 1e-7, ..Options::default() };
        let solution = if said { problem.linear() } else { problem }.solve(&options).unwrap();
        (*solution.stats(), solution.history().iter().map(|mesh| mesh.intervals[0]).collect::<Vec<_>>())
    };
    let ((silent, meshes), (said, same)) = (stated(false), stated(true));
    assert!(meshes.len() > 2 && meshes == same, "{meshes:?}, {same:?}");
    // Nodes and three stages of the first mesh, in vectors of four.
    let first = meshes[0].next_multiple_of(4);
    assert_eq!(silent.rhs_points - said.rhs_points, 4 * first + 4);
}
