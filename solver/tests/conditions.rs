//! Integral conditions, whatever the integral's size; iterates at which the matrix is singular.

#![allow(clippy::unwrap_used)]

use solver::continuation::{BranchOptions, trace};
use solver::model::{Differentiated, Model, Scalar};
use solver::{Guess, Layout, NewtonError, Options, Order, Problem, Region, SolveError, solve};

const ORDERS: [Order; 4] = [Order::Four, Order::Six, Order::Eight, Order::SixGauss];

/// `u'' = load + rate u`, `u'(0) = 0`, `∫ u = mean`.
struct Mean {
    load: f64,
    rate: f64,
}

impl Model for Mean {
    fn layout(&self) -> Layout {
        let line = Region::dense("line", (0.0, 1.0), &["u", "slope"], &["u"], 1);
        Layout::dense(vec![line], &["mean"], &["slope on the left", "mean of u"])
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], _: &[S], f: &mut [S]) {
        (f[0], f[1], f[2]) = (y[1], y[0] * self.rate + self.load, y[0]);
    }
    fn boundary<S: Scalar>(&self, e: &[S], i: &[S], c: &[S], g: &mut [S]) {
        (g[0], g[1]) = (e[1], i[0] - c[0]);
    }
}

#[test]
fn an_integral_may_be_prescribed_from_a_zero_guess_and_may_vanish() {
    for order in ORDERS {
        let options = Options { order, tolerance: 1e-9, ..Options::default() };
        // u = x²/2 + mean - 1/6.
        for mean in [0.0, 1.0, -3.0, 1e-9] {
            let problem = Differentiated::new(Mean { load: 1.0, rate: 0.0 }).unwrap();
            let guess = Guess::uniform(problem.layout(), 10, &[mean], |_, _, y| y.fill(0.0));
            let line = &solve(&problem, &guess, &[], &options).unwrap().regions()[0].clone();
            assert!((line.state(0)[0] - (mean - 1.0 / 6.0)).abs() < 1e-12, "{order:?}, {mean}");
            assert!((line.integrals()[0] - mean).abs() < 1e-12);
        }
        // u vanishes everywhere, and with it every term of the condition.
        let problem = Differentiated::new(Mean { load: 0.0, rate: 1.0 }).unwrap();
        let guess = Guess::uniform(problem.layout(), 10, &[0.0], |_, x, y| (y[0], y[1]) = (1.0 + x, 1.0));
        let solution = solve(&problem, &guess, &[], &options).unwrap();
        assert!(solution.regions()[0].state(0).iter().all(|u| u.abs() < 1e-12));
    }
}

/// A condition that is not met is not excused: there is no u with u' = 0, u(0) = 0 and a mean of 1.
#[test]
fn an_integral_condition_that_cannot_be_met_is_no_success() {
    struct Constant;
    impl Model for Constant {
        fn layout(&self) -> Layout {
            let line = Region::dense("line", (0.0, 1.0), &["u"], &["u"], 1);
            Layout::dense(vec![line], &["c"], &["left", "mean of u"])
        }
        fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], c: &[S], f: &mut [S]) {
            (f[0], f[1]) = (c[0] * 0.0, y[0]);
        }
        fn boundary<S: Scalar>(&self, e: &[S], i: &[S], _: &[S], g: &mut [S]) {
            (g[0], g[1]) = (e[0], i[0] - 1.0);
        }
    }
    let problem = Differentiated::new(Constant).unwrap();
    let guess = Guess::uniform(problem.layout(), 10, &[0.0], |_, _, y| y.fill(0.0));
    let error = solve(&problem, &guess, &[0], &Options::default()).unwrap_err();
    assert!(matches!(error, SolveError::Newton { error: NewtonError::Singular { .. }, .. }), "{error}");
}

/// AUTO's demo `int`: `u'' = -λ exp(u)`, `u(0) - u(1) = p`, `∫ u = m`, at p = m = 0 from λ = 0; λ is found for a
/// growing jump p.
struct Int;

impl Model for Int {
    fn layout(&self) -> Layout {
        let line = Region::dense("line", (0.0, 1.0), &["u", "slope"], &["u"], 3);
        Layout::dense(vec![line], &["lambda", "jump", "mean"], &["jump of u", "mean of u"])
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], c: &[S], f: &mut [S]) {
        (f[0], f[1], f[2]) = (y[1], -c[0] * y[0].exp(), y[0]);
    }
    fn boundary<S: Scalar>(&self, e: &[S], i: &[S], c: &[S], g: &mut [S]) {
        (g[0], g[1]) = (e[0] - e[2] - c[1], i[0] - c[2]);
    }
}

/// Along the branch in λ with both prescribed, `u' = -λ (exp u)` integrated over a period and the mean zero leave a
/// family that the two orders must agree on.
#[test]
fn a_branch_with_an_integral_constraint_is_traced_from_zero() {
    let problem = Differentiated::new(Int).unwrap();
    let guess = Guess::uniform(problem.layout(), 10, &[0.0, 0.0, 0.0], |_, _, y| y.fill(0.0));
    let slopes = ORDERS.map(|order| {
        let options = BranchOptions {
            solve: Options { order, tolerance: 1e-8, ..Options::default() },
            range: (0.0, 5.0),
            ..BranchOptions::default()
        };
        let branch = trace(&problem, &guess, 0, &[], &options, &[]).unwrap();
        let end = branch.points.last().unwrap();
        assert!((end.parameter - 5.0).abs() < 1e-8);
        let line = &end.solution.regions()[0];
        assert!(line.integrals()[0].abs() < 1e-8, "{order:?}");
        line.state(1)[0]
    });
    assert!((slopes[0] - slopes[1]).abs() < 1e-6, "{slopes:?}");
    // u is even about the middle: u'(0) = λ/2 ∫ exp u.
    assert!(slopes[0] > 2.5, "{slopes:?}");
}

/// `u' = c`, `u(0) = 0` and `u(0) + f(u(1)) = 0`: where f' = 0, both conditions have the same derivatives.
#[derive(Clone, Copy)]
enum Scalarised {
    /// `u² - 4`: stationary at the guess 0.
    Square,
    /// `(u - 1)³ - 8`: one Newton step leads from the guess to u = 1, where the derivative vanishes.
    Cube,
}

impl Model for Scalarised {
    fn layout(&self) -> Layout {
        Layout::dense(vec![Region::dense("line", (0.0, 1.0), &["u"], &[], 1)], &["c"], &["left", "right"])
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, _: &[S], c: &[S], f: &mut [S]) {
        f[0] = c[0];
    }
    fn boundary<S: Scalar>(&self, e: &[S], _: &[S], _: &[S], g: &mut [S]) {
        g[0] = e[0];
        g[1] = e[0]
            + match self {
                Self::Square => e[1] * e[1] - 4.0,
                Self::Cube => (e[1] - 1.0).powi(3) - 8.0,
            };
    }
}

#[test]
fn a_singular_matrix_at_an_iterate_is_stepped_away_from() {
    let start = 1.0 - 4.0_f64.cbrt();
    for (model, first, roots) in [(Scalarised::Square, 0.0, [2.0, -2.0]), (Scalarised::Cube, start, [3.0, 3.0])] {
        let problem = Differentiated::new(model).unwrap();
        let guess = Guess::uniform(problem.layout(), 8, &[first], |_, s, y| y[0] = first * s);
        // No halved meshes: the iteration itself must get away.
        let options = Options { rescues: 0, ..Options::default() };
        let solution = solve(&problem, &guess, &[0], &options).unwrap();
        let found = solution.constants()[0];
        assert!(roots.iter().any(|root| (found - root).abs() < 1e-8), "{found}");
        assert!(solution.stats().newton_iterations <= 20, "{:?}", solution.stats());
    }
}

/// The example says how an algebraic equation is stated beside differential ones; it asserts the known solution.
#[path = "../examples/algebraic.rs"]
mod algebraic;

#[test]
fn an_algebraic_equation_of_index_1_holds_by_its_derivative_and_one_end() {
    algebraic::main().unwrap();
}
