//! Integrals are as accurate as a solution says it is, whether or not a condition uses them.

#![allow(clippy::unwrap_used)]

use solver::model::{Differentiated, Model, Scalar};
use solver::{Accuracy, Guess, Layout, Options, Order, Problem, Region, solve};

const ORDERS: [Order; 4] = [Order::Four, Order::Six, Order::SixGauss, Order::Eight];

/// `y' = -y`, `y(0) = 1`, with the integral of `y eˣ/((x - 1/2)² + w²)`: 2/w atan(1/(2w)), of a peak of which y knows
/// nothing. `condition`: the constant c is that integral.
struct Peak {
    width: f64,
    condition: bool,
}

impl Peak {
    fn exact(&self) -> f64 {
        2.0 / self.width * (0.5 / self.width).atan()
    }
}

impl Model for Peak {
    fn layout(&self) -> Layout {
        let line = Region::dense("line", (0.0, 1.0), &["y"], &["peak"], 1);
        let equations: &[&str] = if self.condition { &["start", "size"] } else { &["start"] };
        Layout::dense(vec![line], &["c"], equations)
    }
    fn rhs<S: Scalar>(&self, _: usize, s: S, y: &[S], _: &[S], f: &mut [S]) {
        f[0] = -y[0];
        f[1] = y[0] * s.exp() / ((s - 0.5) * (s - 0.5) + self.width * self.width);
    }
    fn boundary<S: Scalar>(&self, ends: &[S], integrals: &[S], c: &[S], g: &mut [S]) {
        g[0] = ends[0] - 1.0;
        if self.condition {
            g[1] = c[0] - integrals[0];
        }
    }
}

#[test]
fn an_integral_is_as_accurate_as_is_said() {
    for condition in [false, true] {
        for (width, order) in [0.1, 0.03, 0.01].into_iter().flat_map(|width| ORDERS.map(|order| (width, order))) {
            for tolerance in [1e-4, 1e-6, 1e-8] {
                let peak = Peak { width, condition };
                let exact = peak.exact();
                let problem = Differentiated::new(peak).unwrap();
                let guess = Guess::uniform(problem.layout(), 10, &[1.0], |_, _, y| y.fill(1.0));
                let unknowns: &[usize] = if condition { &[0] } else { &[] };
                let solution =
                    solve(&problem, &guess, unknowns, &Options { order, tolerance, ..Options::default() }).unwrap();
                let error = solution.regions()[0].integrals()[0] / exact - 1.0;
                println!(
                    "{condition} {width} {order:?} {tolerance:e}: {} intervals, {error:.1e}",
                    solution.intervals()
                );
                assert_eq!(solution.accuracy(), Accuracy::Met);
                assert!(error.abs() <= tolerance, "{condition} {width} {order:?} {tolerance:e}: {error}");
                // As a state would: some ten times as many intervals as the rest of the solution takes.
                assert!(solution.intervals() <= 400, "{} intervals", solution.intervals());
            }
        }
    }
}

/// Where a mesh may not be as fine as an integral asks for, that is what is said.
#[test]
fn an_integral_that_is_not_had_is_told() {
    let problem = Differentiated::new(Peak { width: 0.003, condition: false }).unwrap();
    let guess = Guess::uniform(problem.layout(), 10, &[1.0], |_, _, y| y.fill(1.0));
    let options = Options { order: Order::Eight, tolerance: 1e-8, max_intervals: 20, ..Options::default() };
    let error = solve(&problem, &guess, &[], &options).unwrap_err().to_string();
    assert!(error.contains("finer meshes are not allowed"), "{error}");
    let short = solve(&problem, &guess, &[], &Options { accept_inaccurate: true, ..options }).unwrap();
    assert!(matches!(short.accuracy(), Accuracy::Short { estimate, .. } if estimate > 1e-4));
}

/// Whoever sees to integrals by other means need not pay for them.
#[test]
fn integrals_may_be_left_to_the_caller() {
    let peak = Peak { width: 0.01, condition: false };
    let exact = peak.exact();
    let problem = Differentiated::new(peak).unwrap();
    let guess = Guess::uniform(problem.layout(), 10, &[1.0], |_, _, y| y.fill(1.0));
    let options = Options { tolerance: 1e-4, integrals: false, ..Options::default() };
    let solution = solve(&problem, &guess, &[], &options).unwrap();
    assert_eq!((solution.accuracy(), solution.intervals()), (Accuracy::Met, 10));
    assert!((solution.regions()[0].integrals()[0] / exact - 1.0).abs() > 0.1);
}
