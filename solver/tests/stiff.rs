//! Tight tolerances where layers are thin: rounding is judged interval by interval, and meshes do not creep.

#![allow(clippy::unwrap_used)]

use solver::model::{Differentiated, Model, Scalar};
use solver::{Accuracy, Guess, Layout, Options, Order, Problem, Region, solve};
use std::f64::consts::PI;

/// Cash's T14: `ε u'' = u - (ε π² + 1) cos πx` on (-1, 1), two layers of width √ε.
struct Layers;

impl Layers {
    fn exact(x: f64, e: f64) -> f64 {
        let layer = |distance: f64| (-distance / e.sqrt()).exp();
        (PI * x).cos() + layer(1.0 - x) + layer(1.0 + x)
    }
}

impl Model for Layers {
    fn layout(&self) -> Layout {
        Layout::dense(vec![Region::dense("all", (-1.0, 1.0), &["u", "slope"], &[], 1)], &["eps"], &["left", "right"])
    }
    fn rhs<S: Scalar>(&self, _: usize, x: S, y: &[S], c: &[S], f: &mut [S]) {
        f[0] = y[1];
        f[1] = (y[0] - (c[0] * (PI * PI) + 1.0) * (x * PI).cos()) / c[0];
    }
    fn boundary<S: Scalar>(&self, z: &[S], _: &[S], c: &[S], g: &mut [S]) {
        let end = (c[0].sqrt().recip() * -2.0).exp();
        (g[0], g[1]) = (z[0] - end, z[2] - end);
    }
}

/// On 6,000 intervals 8 ε N is 1e-11: defects of a tenth of that are met in layers, where intervals are short because
/// the solution varies, and not because they are many.
#[test]
fn tighter_tolerances_give_smaller_errors_down_to_1e_12() {
    let problem = Differentiated::new(Layers).unwrap();
    let eps = 1e-6;
    for order in [Order::Four, Order::Six] {
        for tolerance in [1e-8, 1e-9, 1e-12] {
            let guess = Guess::uniform(problem.layout(), 20, &[eps], |_, _, y| y.fill(0.0));
            let solution = solve(&problem, &guess, &[], &Options { order, tolerance, ..Options::default() }).unwrap();
            assert_eq!(solution.accuracy(), Accuracy::Met);
            let line = &solution.regions()[0];
            let error = line.mesh().iter().zip(line.state(0)).map(|(&x, u)| (u - Layers::exact(x, eps)).abs());
            let error = error.fold(0.0, f64::max);
            println!("{order:?} {tolerance:e}: {error:e}, {:?}", solution.stats());
            assert!(error <= tolerance, "{order:?} {tolerance:e}: {error:e}");
            assert!(solution.stats().meshes <= 30, "{order:?} {tolerance:e}: {:?}", solution.stats());
        }
    }
}
