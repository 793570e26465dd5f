//! An algebraic equation beside the differential ones: semi-explicit, of index 1.
//!
//! ```text
//! y' = v,  v' = -z,  0 = g(y, z) = z + z³ - q - q³  with  q = π² y,     y(0) = 0,  y(1/2) = 1
//! ```
//!
//! The last equation has one root, z = π² y, so that y = sin(πx). Index 1 means that ∂g/∂z has no zero: then
//! `solver::dae::Reduced` forms from g an equation for z' and a condition at the start, and what is left of g between
//! the ends is an error like any other, held to the tolerance with the solution.
//!
//! ```text
//! cargo run --release -p sheave-solver --example algebraic
//! ```

use solver::dae::{Dae, Reduced};
use solver::model::{Differentiated, Scalar};
use solver::{Guess, Layout, Options, Order, Problem, Region, solve};
use std::f64::consts::{FRAC_PI_2, PI};

struct Spring;

impl Dae for Spring {
    fn layout(&self) -> Layout {
        let line = Region::dense("line", (0.0, 0.5), &["y", "v", "z"], &[], 0);
        Layout::dense(vec![line], &[], &["left end", "right end"])
    }
    fn algebraic(&self, _: usize) -> usize {
        1
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], _: &[S], f: &mut [S]) {
        let (q, z) = (y[0] * (PI * PI), y[2]);
        (f[0], f[1]) = (y[1], -z);
        f[2] = z + z * z * z - q - q * q * q;
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
        // Ends: y, v, z at 0, then at 1/2.
        (g[0], g[1]) = (ends[0], ends[3] - 1.0);
    }
}

pub(crate) fn main() -> Result<(), Box<dyn std::error::Error>> {
    let problem = Differentiated::new(Reduced::new(Spring)?)?;
    let guess = Guess::uniform(problem.layout(), 10, &[], |_, x, y| (y[0], y[1], y[2]) = (2.0 * x, 2.0, 20.0 * x));
    for (order, tolerance) in [(Order::Four, 1e-4), (Order::Six, 1e-7), (Order::Eight, 1e-10)] {
        let solution = solve(&problem, &guess, &[], &Options { order, tolerance, ..Options::default() })?;
        let line = &solution.regions()[0];
        let mut error: f64 = 0.0;
        for k in 0..=200 {
            let x = 0.5 * f64::from(k) / 200.0;
            let y = line.eval(x);
            error = error.max((y[0] - (PI * x).sin()).abs()).max((y[2] / (PI * PI) - (PI * x).sin()).abs());
        }
        // By how much z misses the root, relative to its magnitude π²: g over ∂g/∂z, which is 1 at least.
        let left = problem.model().remainder(&solution) / (1.0 + 3.0 * PI.powi(4)) / (PI * PI);
        println!(
            "{order:?}, {tolerance:e}: error {error:.1e}, z off its equation by {left:.1e}; {} intervals",
            solution.intervals()
        );
        assert!(error < 3.0 * tolerance && left < 3.0 * tolerance);
        assert!((line.eval(0.0)[1] - 2.0 * FRAC_PI_2).abs() < 10.0 * tolerance);
    }
    Ok(())
}
