//! Solving: observed orders, conditions of every kind, meshes that follow the solution, work counts.

#![allow(clippy::unwrap_used, clippy::needless_range_loop)]

use solver::model::{Differentiated, Model, Scalar};
use solver::{Guess, Layout, Options, Order, Region, Solution, solve};

/// `y' = (y1, -y0 + s)` and friends: see each test.
struct Oscillator;

impl Model for Oscillator {
    fn layout(&self) -> Layout {
        // u'' = -u, u(0) = 0, u(2) = sin 2; the integral of u² is determined.
        let region = Region::dense("line", (0.0, 2.0), &["u", "v"], &["square"], 0);
        Layout::dense(vec![region], &[], &["left", "right"])
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], _: &[S], f: &mut [S]) {
        (f[0], f[1], f[2]) = (y[1], -y[0], y[0] * y[0]);
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
        (g[0], g[1]) = (ends[0], ends[2] - 2.0_f64.sin());
    }
}

fn on_fixed_mesh<M: Model>(
    model: M,
    intervals: usize,
    order: Order,
    constants: &[f64],
    unknowns: &[usize],
    f: impl FnMut(usize, f64, &mut [f64]),
) -> Solution {
    let problem = Differentiated::new(model).unwrap();
    let guess = Guess::uniform(solver::Problem::layout(&problem), intervals, constants, f);
    let options = Options {
        order,
        tolerance: 1e3,
        newton_tolerance: Some(1e-13),
        boundary_tolerance: Some(1e-11),
        ..Options::default()
    };
    solve(&problem, &guess, unknowns, &options).unwrap()
}

#[test]
fn nodes_dense_output_and_integrals_have_the_method_s_order() {
    for order in [Order::Four, Order::Six, Order::Eight, Order::SixGauss] {
        let errors = |intervals: usize| {
            let solution = on_fixed_mesh(Oscillator, intervals, order, &[], &[], |_, _, y| y.fill(0.0));
            let line = &solution.regions()[0];
            assert_eq!(line.intervals(), intervals);
            let nodes = line.mesh().iter().zip(line.state(1)).map(|(s, v)| (v - s.cos()).abs()).fold(0.0, f64::max);
            let dense = (0..997)
                .map(|i| f64::from(i) * 2.0 / 996.0)
                .map(|s| (line.eval(s)[1] - s.cos()).abs())
                .fold(0.0, f64::max);
            let exact = 1.0 - 4.0_f64.sin() / 4.0;
            (nodes, dense, (line.integrals()[0] - exact).abs())
        };
        let (coarse, fine) = (errors(8), errors(16));
        for (name, a, b) in [("nodes", coarse.0, fine.0), ("dense", coarse.1, fine.1), ("integral", coarse.2, fine.2)] {
            let observed = (a / b).log2();
            println!("{order:?} {name}: {a:.2e} {b:.2e} order {observed:.2}");
            assert!(observed > order.number() as f64 - 0.3, "{order:?} {name}: order {observed}");
        }
    }
}

/// `u'' = -λ² u`, `u(0) = u(1) = 0`, `∫ u² = 1/2`, on two regions that meet at 0.4 with unlike variables (`w = 2u`).
struct Eigenvalue;

impl Model for Eigenvalue {
    fn layout(&self) -> Layout {
        let left = Region::dense("left", (0.0, 0.4), &["u", "v"], &["half square"], 1);
        let right = Region::dense("right", (0.4, 1.0), &["w", "x"], &["cubes", "square"], 1);
        let equations = ["u left", "w right", "u joins w", "v joins x", "norm"];
        Layout::dense(vec![left, right], &["lambda"], &equations)
    }
    fn rhs<S: Scalar>(&self, region: usize, _: S, y: &[S], c: &[S], f: &mut [S]) {
        (f[0], f[1]) = (y[1], -y[0] * c[0] * c[0]);
        if region == 0 {
            f[2] = y[0] * y[0] * 0.5;
        } else {
            (f[2], f[3]) = (y[0].powi(3), y[0] * y[0]);
        }
    }
    fn boundary<S: Scalar>(&self, e: &[S], i: &[S], _: &[S], g: &mut [S]) {
        // Ends: u v | u v | w x | w x.
        (g[0], g[1], g[2], g[3]) = (e[0], e[6], e[2] * 2.0 - e[4], e[3] * 2.0 - e[5]);
        g[4] = i[0] * 2.0 + i[2] * 0.25 - 0.5;
    }
}

#[test]
fn an_eigenvalue_an_interface_and_an_integral_condition() {
    for order in [Order::Four, Order::Six, Order::Eight, Order::SixGauss] {
        let error = |intervals| {
            let solution = on_fixed_mesh(Eigenvalue, intervals, order, &[3.0], &[0], |region, s, y| {
                y[0] = (1.0 + region as f64) * 4.0 * s * (1.0 - s);
                y[1] = (1.0 + region as f64) * 4.0 * (1.0 - 2.0 * s);
            });
            let exact = |s: f64| (std::f64::consts::PI * s).sin();
            let right = &solution.regions()[1];
            let node = right.mesh().iter().zip(right.state(0)).map(|(&s, w)| (w - 2.0 * exact(s)).abs());
            let square: f64 = solution.regions()[0].integrals()[0] * 2.0 + right.integrals()[1] * 0.25;
            assert!((square - 0.5).abs() < 1e-10);
            assert_eq!(right.cumulative(1).last(), Some(&right.integrals()[1]));
            (solution.constants()[0] - std::f64::consts::PI).abs() + node.fold(0.0, f64::max)
        };
        let (coarse, fine) = (error(6), error(12));
        let observed = (coarse / fine).log2();
        assert!(observed > order.number() as f64 - 0.4, "{order:?}: {coarse:.2e} {fine:.2e} {observed}");
    }
}

/// Periodic, non-separated conditions: `y' = A y + r(s)` with a known periodic solution.
struct Periodic;

impl Model for Periodic {
    fn layout(&self) -> Layout {
        let region = Region::dense("circle", (0.0, std::f64::consts::TAU), &["a", "b", "c"], &[], 0);
        Layout::dense(vec![region], &[], &["a closes", "b closes", "all close"])
    }
    fn rhs<S: Scalar>(&self, _: usize, s: S, y: &[S], _: &[S], f: &mut [S]) {
        // a = sin s, b = cos s, c = sin s cos s.
        f[0] = y[1] + (y[2] - s.sin() * s.cos()) * 0.7;
        f[1] = -y[0] + (y[0] - s.sin()) * 0.3;
        f[2] = (s * 2.0).cos() + (y[2] - s.sin() * s.cos()) * 2.0;
    }
    fn boundary<S: Scalar>(&self, e: &[S], _: &[S], _: &[S], g: &mut [S]) {
        (g[0], g[1], g[2]) = (e[3] - e[0], e[4] - e[1], e[5] - e[2] + (e[3] - e[0]) * 0.1);
    }
}

#[test]
fn periodic_conditions_tie_both_ends() {
    let problem = Differentiated::new(Periodic).unwrap();
    for order in [Order::Four, Order::Six, Order::Eight, Order::SixGauss] {
        let guess = Guess::uniform(solver::Problem::layout(&problem), 10, &[], |_, _, y| y.fill(0.0));
        let solution = solve(&problem, &guess, &[], &Options { order, tolerance: 1e-8, ..Options::default() }).unwrap();
        let circle = &solution.regions()[0];
        for i in 0..200 {
            let s = f64::from(i) * 0.031;
            let y = circle.eval(s);
            assert!((y[0] - s.sin()).abs() + (y[1] - s.cos()).abs() < 3e-8, "{order:?} {s} {y:?}");
        }
        println!("{order:?} {} intervals, {:?}, {:?}", circle.intervals(), solution.stats(), solution.history());
        assert!(solution.stats().newton_iterations <= solution.stats().meshes, "linear: one iteration a mesh");
    }
}
