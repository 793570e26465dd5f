//! Problems stated by closures, with derivatives of each kind.

#![allow(clippy::unwrap_used)]

use solver::bvp::{Bvp, Differenced, Exact, Formulas, Number};
use solver::continuation::{BranchOptions, trace};
use solver::{LayoutError, Linearisation, Options, Order, Solution, SolveError};
use std::cell::Cell;
use std::f64::consts::{PI, TAU};
use std::ops::{Add, Mul, Sub};

/// Derivatives of Bratu's problem by hand.
struct ByHand;

impl Formulas for ByHand {
    fn rhs(&self, _: f64, y: &[f64], p: &[f64], f: &mut [f64]) {
        (f[0], f[1]) = (y[1], -p[0] * y[0].exp());
    }
    fn rhs_derivatives(&self, x: f64, y: &[f64], p: &[f64], f: &mut [f64], columns: &mut [f64]) {
        self.rhs(x, y, p, f);
        columns.copy_from_slice(&[0.0, f[1], 1.0, 0.0, 0.0, -y[0].exp()]);
    }
    fn boundary(&self, a: &[f64], b: &[f64], _: &[f64], g: &mut [f64]) {
        (g[0], g[1]) = (a[0], b[0]);
    }
    fn boundary_derivatives(&self, a: &[f64], b: &[f64], p: &[f64], g: &mut [f64], columns: &mut [f64]) {
        self.boundary(a, b, p, g);
        columns.copy_from_slice(&[1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0]);
    }
}

#[test]
fn three_kinds_of_derivatives_lead_to_the_same_solution() {
    let bratu = |lambda: f64| {
        Bvp::new(
            &["u", "slope"],
            (0.0, 1.0),
            |_, y, p, f| (f[0], f[1]) = (y[1], -p[0] * y[0].exp()),
            |a, b, _, g| (g[0], g[1]) = (a[0], b[0]),
        )
        .given("lambda", lambda)
    };
    let exact = bratu(1.0);
    let differenced = Bvp::by_differences(
        &["u", "slope"],
        (0.0, 1.0),
        |_, y, p, f| (f[0], f[1]) = (y[1], -p[0] * y[0].exp()),
        |a, b, _, g| (g[0], g[1]) = (a[0], b[0]),
    )
    .given("lambda", 1.0);
    let by_hand = Bvp::with(&["u", "slope"], (0.0, 1.0), ByHand).given("lambda", 1.0);
    let options = Options { order: Order::Six, tolerance: 1e-9, ..Options::default() };
    let solutions =
        [exact.solve(&options).unwrap(), differenced.solve(&options).unwrap(), by_hand.solve(&options).unwrap()];
    // u(1/2) = 2 ln cosh θ with λ = 8 θ²/cosh² θ.
    for solution in &solutions {
        assert!((solution.regions()[0].eval(0.5)[0] - 0.140_539_214_4).abs() < 1e-9);
        assert_eq!(solution.stats().meshes, solutions[0].stats().meshes);
    }
    // d(u)/d(λ), for which derivatives with respect to the parameter are right.
    let rates = [
        Linearisation::new(&exact, &solutions[0]).unwrap().sensitivity(0),
        Linearisation::new(&by_hand, &solutions[2]).unwrap().sensitivity(0),
    ]
    .map(|tangent| tangent.regions[0].states[1][0]);
    let slope = |lambda: f64| bratu(lambda).solve(&options).unwrap().regions()[0].state(1)[0];
    let difference = (slope(1.001) - slope(0.999)) / 0.002;
    assert!(rates.iter().all(|rate| (rate - difference).abs() < 1e-6), "{rates:?} {difference}");
    // The library's other functions take it as they take any problem.
    let branch = BranchOptions { range: (0.5, 10.0), ..BranchOptions::default() };
    let branch = trace(&exact, &exact.start(), 0, &[], &branch, &[]).unwrap();
    assert!((branch.folds().next().unwrap().parameter - 3.513_830_719).abs() < 1e-5);
}

/// SciPy's example: `y'' + k² y = 0`, `y(0) = y(1) = 0`, `y'(0) = k`, k near 6.
#[test]
fn an_unknown_parameter_is_found() {
    let waves = Bvp::new(
        &["y", "slope"],
        (0.0, 1.0),
        |_, y, p, f| (f[0], f[1]) = (y[1], -p[0].powi(2) * y[0]),
        |a, b, p, g| (g[0], g[1], g[2]) = (a[0], b[0], a[1] - p[0]),
    )
    .unknown("k", 6.0)
    .guess(8, |x, y| y[0] = (TAU * x).sin());
    let solution = waves.solve(&Options::default()).unwrap();
    assert!((solution.constants()[0] - TAU).abs() < 1e-5);
}

/// Five states and three parameters: more inputs than one pass of derivatives carries.
/// `y_i' = p_(i mod 3) y_(i+1) + x`.
#[test]
fn many_states_and_parameters_have_all_their_derivatives() {
    let chain = Bvp::new(
        &["y0", "y1", "y2", "y3", "y4"],
        (0.0, 1.0),
        |x, y, p, f| {
            for i in 0..5 {
                f[i] = p[i % 3] * y[(i + 1) % 5].sin() + x * PI;
            }
        },
        |a, b, p, g| {
            (g[0], g[1], g[2], g[3], g[4]) = (a[0] - 1.0, b[1] * p[2], 0.5 - a[2], b[3] + a[4], 2.0 * a[4] - p[0]);
        },
    )
    .given("p0", 0.3)
    .given("p1", -0.2)
    .given("p2", 0.7);
    let solution = chain.solve(&Options::default()).unwrap();
    // Exact derivatives: the iteration converges quadratically.
    assert!(solution.stats().newton_iterations <= 6, "{:?}", solution.stats());
    assert!(solution.max_boundary_residual() < 1e-9);
}

#[test]
fn an_interval_that_is_none_is_refused() {
    let wrong = Bvp::new(&["y"], (1.0, 0.0), |_, y, _, f| f[0] = y[0], |a, _, _, g| g[0] = a[0] - 1.0);
    assert!(matches!(wrong.solve(&Options::default()), Err(SolveError::Layout(_))));
}

/// u, w and w' given at both ends.
fn clamped<T: Copy + Add<f64, Output = T> + Sub<f64, Output = T>>(a: &[T], b: &[T], _: &[T], g: &mut [T]) {
    g.copy_from_slice(&[a[0] - 1.0, b[0], a[2] - 0.5, b[2], a[3] - 1.0, b[3] + 1.2]);
}

/// `u'' = -u w`, `w''' = u - q w'`, q unknown, as they stand and as a system of first order.
#[test]
fn equations_of_higher_order_are_solved_as_their_system_is() {
    let system = Bvp::new(
        &["u", "u'", "w", "w'", "w''"],
        (0.0, 1.0),
        |_, z, p, f| f.copy_from_slice(&[z[1], -z[0] * z[2], z[3], z[4], z[0] - p[0] * z[3]]),
        clamped,
    );
    let highest = |_: f64, z: &[Number], p: &[Number], out: &mut [Number]| {
        (out[0], out[1]) = (-z[0] * z[2], z[0] - p[0] * z[3]);
    };
    let functions = [("u", 2), ("w", 3)];
    let stated = Bvp::of_higher_order(&functions, (0.0, 1.0), highest, clamped).unwrap();
    let grouped = stated.clone().sparse(&[&[0, 2], &[0, 3]]).unwrap().unknown("q", 1.0);
    let (system, stated) = (system.unknown("q", 1.0), stated.unknown("q", 1.0));
    let differenced = Differenced::new(
        |_: f64, z: &[f64], p: &[f64], out: &mut [f64]| (out[0], out[1]) = (-z[0] * z[2], z[0] - p[0] * z[3]),
        clamped,
    );
    let differenced = Bvp::of_higher_order_with(&functions, (0.0, 1.0), differenced).unwrap();
    let differenced = differenced.sparse(&[&[0, 2], &[0, 3]]).unwrap().unknown("q", 1.0);
    let guess = |x: f64, z: &mut [f64]| z.copy_from_slice(&[1.0 - x, -1.0, 0.5 + x - 1.5 * x * x, 1.0 - 3.0 * x, -3.0]);
    let (system, stated) = (system.guess(10, guess), stated.guess(10, guess));
    let (grouped, differenced) = (grouped.guess(10, guess), differenced.guess(10, guess));
    for order in [Order::Four, Order::Six, Order::Eight, Order::SixGauss] {
        let options = Options { order, tolerance: 1e-8, ..Options::default() };
        let first = system.solve(&options).unwrap();
        let [second, third] = [stated.solve(&options).unwrap(), grouped.solve(&options).unwrap()];
        for other in [&second, &third] {
            assert_eq!((first.regions()[0].mesh(), first.constants()), (other.regions()[0].mesh(), other.constants()));
            (0..5).for_each(|state| assert_eq!(first.regions()[0].state(state), other.regions()[0].state(state)));
        }
        let by_differences = differenced.solve(&options).unwrap();
        assert!((by_differences.constants()[0] - first.constants()[0]).abs() < 1e-7);
    }
    let error = stated.guess(3, |_, y| y.fill(f64::NAN)).solve(&Options::default()).unwrap_err();
    assert!(error.to_string().contains("u of region interval"), "{error}");
    let error = Bvp::of_higher_order(&[("u", 2), ("w", 0)], (0.0, 1.0), highest, clamped).err();
    assert_eq!(error, Some(LayoutError::Order { function: "w".to_owned() }));
}

const PIECES: usize = 12;

/// A row of pieces, each losing heat to its neighbours and, by its square, to what is around; a source in all of them.
fn heat<T>(t: &[T], source: T, f: &mut [T])
where
    T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T> + Mul<f64, Output = T>,
{
    for i in 0..PIECES {
        let (before, after) = (t[i.max(1) - 1], t[(i + 1).min(PIECES - 1)]);
        f[i] = (before - t[i] * 2.0 + after) * 3.0 - t[i] * t[i] + source * i as f64;
    }
}

/// All temperatures given on the left, and one on the right.
fn begun<T: Copy + Add<f64, Output = T> + Sub<f64, Output = T>>(a: &[T], b: &[T], _: &[T], g: &mut [T]) {
    (0..PIECES).for_each(|i| g[i] = a[i] - 1.0 + 0.05 * i as f64);
    g[PIECES] = b[PIECES - 1] - 0.8;
}

#[test]
fn states_that_no_value_shares_are_differentiated_together() {
    let names: Vec<String> = (0..PIECES).map(|i| format!("T{i}")).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let neighbours: Vec<Vec<usize>> = (0..PIECES).map(|i| (i.max(1) - 1..(i + 2).min(PIECES)).collect()).collect();
    let neighbours: Vec<&[usize]> = neighbours.iter().map(Vec::as_slice).collect();
    let calls = Cell::new(0_usize);
    let counted = || calls.set(calls.get() + 1);
    let differenced = || {
        let f = |_: f64, t: &[f64], p: &[f64], f: &mut [f64]| {
            counted();
            heat(t, p[0], f);
        };
        Bvp::by_differences(&names, (0.0, 0.5), f, begun).unknown("source", 0.0)
    };
    let exact = || {
        let f = |_: f64, t: &[Number], p: &[Number], f: &mut [Number]| {
            counted();
            heat(t, p[0], f);
        };
        Bvp::with(&names, (0.0, 0.5), Exact::new(f, begun)).unknown("source", 0.0)
    };
    let (by_groups, exact_by_groups) =
        (differenced().sparse(&neighbours).unwrap(), exact().sparse(&neighbours).unwrap());
    // At one point: the values, three groups and the parameter; in numbers of four derivatives all at once.
    let y: Vec<f64> = (0..PIECES).map(|i| 0.1 * i as f64 - 0.3).collect();
    let at_point = |formulas: &dyn Formulated| {
        let (mut f, mut columns) = (vec![0.0; PIECES], vec![f64::NAN; PIECES * (PIECES + 1)]);
        let before = calls.get();
        formulas.derivatives(&y, &mut f, &mut columns);
        (calls.get() - before, f, columns)
    };
    let (few, values, found) = at_point(by_groups.formulas());
    let (once, values_exact, found_exact) = at_point(exact_by_groups.formulas());
    let (all, values_dense, known) = at_point(exact().formulas());
    assert_eq!((few, once, all), (5, 1, 4));
    assert_eq!((&values, &values_exact, &found_exact), (&values_dense, &values_dense, &known));
    assert!(found.iter().zip(&known).all(|(found, known)| (found - known).abs() < 1e-6));
    // The same solutions, with fewer calls.
    let options = Options { tolerance: 1e-7, ..Options::default() };
    let counted = |solution: &dyn Fn() -> Result<Solution, SolveError>| {
        let before = calls.get();
        (solution().unwrap().constants()[0], calls.get() - before)
    };
    let (known, all) = counted(&|| differenced().solve(&options));
    let (found, fewer) = counted(&|| by_groups.solve(&options));
    assert!((found - known).abs() < 1e-6 && fewer < all / 2, "{found} for {known}, {fewer} calls for {all}");
    assert_eq!(counted(&|| exact().solve(&options)).0, counted(&|| exact_by_groups.solve(&options)).0);
    // What makes no sense is refused.
    let missing = differenced().sparse(&neighbours[1..]).err();
    assert_eq!(missing, Some(LayoutError::Dependences { given: PIECES - 1, expected: PIECES }));
    let mut beyond = neighbours.clone();
    beyond[3] = &[2, PIECES];
    let error = differenced().sparse(&beyond).err().unwrap();
    assert!(matches!(error, LayoutError::RegionPattern { row: 3, column: PIECES, .. }), "{error}");
}

/// Formulas of whatever kind.
trait Formulated {
    fn derivatives(&self, y: &[f64], f: &mut [f64], columns: &mut [f64]);
}

impl<M: Formulas> Formulated for M {
    fn derivatives(&self, y: &[f64], f: &mut [f64], columns: &mut [f64]) {
        self.rhs_derivatives(0.2, y, &[0.7], f, columns);
    }
}

/// Steps of differences are measured in the magnitudes that are stated: those of 1 would leave nothing of such inputs.
#[test]
fn differences_are_taken_in_steps_of_the_magnitude_that_is_stated() {
    let d = 1e-9;
    let problem = Bvp::by_differences(
        &["u"],
        (0.0, 1.0),
        move |_, y, p, f| f[0] = (p[0] / d).powi(2) - y[0],
        |a, _, _, g| g[0] = a[0],
    )
    .given("p", 3.0 * d)
    .typical("p", d)
    .unwrap();
    let solution = problem.solve(&Options { tolerance: 1e-8, ..Options::default() }).unwrap();
    let rate = Linearisation::new(&problem, &solution).unwrap().sensitivity(0).inputs()[1] * d;
    // u(1) = (p/d)² (1 - 1/e)
    assert!((rate - 6.0 * (1.0 - (-1.0_f64).exp())).abs() < 1e-6, "{rate}");

    // u'' = 2 u³ in units of k: u = 1/(2 - x). All inputs have steps, those of the boundary too.
    let k = 1e-9;
    let names = ["u", "slope", "scale"];
    let f = move |_: f64, y: &[f64], _: &[f64], f: &mut [f64]| {
        (f[0], f[1], f[2]) = (y[1], 2.0 * y[0].powi(3) / (k * k) * (y[2] / k).powi(2), 0.0);
    };
    let bc = move |a: &[f64], b: &[f64], p: &[f64], g: &mut [f64]| {
        (g[0], g[1], g[2]) = (a[0] * a[0] / k - 0.25 * k, b[0].powi(3) / (k * k) - k, b[2] * p[0] / k - k);
    };
    let guess = |x: f64, y: &mut [f64]| (y[0], y[1], y[2]) = (k * (0.5 + 0.5 * x), 0.5 * k, k);
    let dense = Bvp::by_differences(&names, (0.0, 1.0), f, bc);
    let sparse = Bvp::by_differences(&names, (0.0, 1.0), f, bc).sparse(&[&[1], &[0, 2], &[]]).unwrap();
    for problem in [dense, sparse] {
        let stated = names.iter().try_fold(problem, |problem, name| problem.typical(name, k)).unwrap();
        let stated = stated.given("k", k).typical("k", k).unwrap().guess(10, guess);
        let solution = stated.solve(&Options { tolerance: 1e-8, ..Options::default() }).unwrap();
        let found = solution.regions()[0].eval(0.5)[0] / k;
        assert!((found - 1.0 / 1.5).abs() < 1e-7, "{found}");
    }

    let highest = move |_: f64, z: &[f64], _: &[f64], highest: &mut [f64]| highest[0] = 2.0 * z[0].powi(3) / (k * k);
    let ends = move |a: &[f64], b: &[f64], _: &[f64], g: &mut [f64]| {
        (g[0], g[1]) = (a[0] * a[0] / k - 0.25 * k, b[0].powi(3) / (k * k) - k);
    };
    let stated = Bvp::of_higher_order_with(&[("u", 2)], (0.0, 1.0), Differenced::new(highest, ends)).unwrap();
    let stated = stated.typical("u", k).unwrap().typical("u'", k).unwrap();
    let stated = stated.guess(10, |x, y| (y[0], y[1]) = (k * (0.5 + 0.5 * x), 0.5 * k));
    let solution = stated.solve(&Options { tolerance: 1e-8, ..Options::default() }).unwrap();
    let found = solution.regions()[0].eval(0.5)[0] / k;
    assert!((found - 1.0 / 1.5).abs() < 1e-7, "{found}");
}

/// A step that is lost beside what comes out is made longer: `0 - 1e10` is the same when 1.5e-8 is added to it.
#[test]
fn differences_of_large_values_are_taken_in_longer_steps() {
    for size in [1e7, 1e8, 1e9, 1e10] {
        let f = |_: f64, y: &[f64], _: &[f64], f: &mut [f64]| (f[0], f[1]) = (y[1], 0.0);
        let bc = move |a: &[f64], b: &[f64], _: &[f64], g: &mut [f64]| (g[0], g[1]) = (a[0], b[0] - size);
        let line = Bvp::by_differences(&["u", "slope"], (0.0, 1.0), f, bc);
        let found = line.solve(&Options::default()).unwrap().regions()[0].eval(0.5)[0];
        assert!((found / size - 0.5).abs() < 1e-6, "{size:e}: {found}");

        // u'' = u + r(x), solved by u = size sin(2x), one value at a time and by groups of states.
        let exact = move |x: f64| size * (2.0 * x).sin();
        let f = move |x: f64, y: &[f64], _: &[f64], f: &mut [f64]| (f[0], f[1]) = (y[1], y[0] - 5.0 * exact(x));
        let bc = move |a: &[f64], b: &[f64], _: &[f64], g: &mut [f64]| (g[0], g[1]) = (a[0], b[0] - exact(1.0));
        let dense = Bvp::by_differences(&["u", "slope"], (0.0, 1.0), f, bc);
        let sparse = Bvp::by_differences(&["u", "slope"], (0.0, 1.0), f, bc).sparse(&[&[1], &[0]]).unwrap();
        for problem in [dense, sparse] {
            let found = problem.solve(&Options::default()).unwrap().regions()[0].eval(0.5)[0];
            assert!((found / exact(0.5) - 1.0).abs() < 1e-5, "{size:e}: {found}");
        }
    }
}

/// What does not depend on an input still has no derivative by it, however large it is.
#[test]
fn large_values_that_do_not_depend_on_an_input_have_no_derivative() {
    let f = |_: f64, y: &[f64], p: &[f64], f: &mut [f64]| (f[0], f[1]) = (1e10 + 3.0 * y[1], -1e12 + p[0]);
    let formulas = Differenced::new(f, |_: &[f64], _: &[f64], _: &[f64], _: &mut [f64]| {});
    let (mut out, mut columns) = ([0.0; 2], [f64::NAN; 6]);
    formulas.rhs_derivatives(0.0, &[0.0, 0.0], &[0.0], &mut out, &mut columns);
    assert_eq!((columns[0], columns[1], columns[3], columns[4]), (0.0, 0.0, 0.0, 0.0));
    assert!((columns[2] / 3.0 - 1.0).abs() < 1e-4 && (columns[5] - 1.0).abs() < 1e-4, "{columns:?}");
}

/// Magnitudes, tolerances and messages go by names: one that two have would be taken for the first of them.
#[test]
fn a_name_is_given_once() {
    let twice = Bvp::new(
        &["u", "u"],
        (0.0, 1.0),
        |_, y, _, f| (f[0], f[1]) = (y[1], -y[0]),
        |a, b, _, g| {
            (g[0], g[1]) = (a[0], b[0] - 1.0);
        },
    );
    let among = |error: SolveError| match error {
        SolveError::Layout(LayoutError::Repeated { name, among }) => (name, among),
        other => panic!("{other}"),
    };
    assert_eq!(among(twice.solve(&Options::default()).unwrap_err()), ("u".to_owned(), "states"));
    let once = Bvp::new(&["u"], (0.0, 1.0), |_, y, p, f| f[0] = p[0] * y[0], |a, _, _, g| g[0] = a[0] - 1.0);
    let constants = once.clone().given("p", 1.0).given("p", 2.0).solve(&Options::default()).unwrap_err();
    assert_eq!(among(constants), ("p".to_owned(), "constants"));
    let either = once.given("u", 1.0);
    assert!(either.solve(&Options::default()).is_ok());
    let error = either.typical("u", 1.0).err();
    assert_eq!(error, Some(LayoutError::Repeated { name: "u".to_owned(), among: "states and parameters" }));
}
