//! Problems stated by closures, with derivatives of each kind.

#![allow(clippy::unwrap_used)]

use solver::bvp::{Bvp, Formulas};
use solver::continuation::{BranchOptions, trace};
use solver::{Linearisation, Options, Order, SolveError};
use std::f64::consts::{PI, TAU};

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
