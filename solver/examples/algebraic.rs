//! A semi-explicit differential-algebraic problem of index 1, by differentiating its algebraic equation once.
//!
//! ```text
//! y' = v,  v' = -z,  0 = g(y, z) = z + z³ - q - q³  with  q = π² y,     y(0) = 0,  y(1/2) = 1
//! ```
//!
//! The last equation has one root, z = π² y, so that y = sin(πx). Index 1 means that ∂g/∂z has no zero: then dg/dx = 0
//! is an equation for z',
//!
//! ```text
//! z' = -(∂g/∂y v) / (∂g/∂z) = π² (1 + 3 q²) v / (1 + 3 z²)
//! ```
//!
//! and g = 0 at one end, as one more boundary condition, is g = 0 everywhere. What is left of g between the ends is an
//! error like any other, and is held to the tolerance with the solution.
//!
//! ```text
//! cargo run --release -p sheave-solver --example algebraic
//! ```

use solver::model::{Differentiated, Model, Scalar};
use solver::{Guess, Layout, Options, Order, Problem, Region, solve};
use std::f64::consts::{FRAC_PI_2, PI};

struct Spring;

/// `g(y, z)`.
fn algebraic<S: Scalar>(y: S, z: S) -> S {
    let q = y * (PI * PI);
    z + z * z * z - q - q * q * q
}

impl Model for Spring {
    fn layout(&self) -> Layout {
        let line = Region::dense("line", (0.0, 0.5), &["y", "v", "z"], &[], 0);
        Layout::dense(vec![line], &[], &["left end", "right end", "g at the left end"])
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], _: &[S], f: &mut [S]) {
        let (q, z) = (y[0] * (PI * PI), y[2]);
        (f[0], f[1]) = (y[1], -z);
        f[2] = y[1] * (q * q * 3.0 + 1.0) * (PI * PI) / (z * z * 3.0 + 1.0);
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
        // Ends: y, v, z at 0, then at 1/2.
        (g[0], g[1], g[2]) = (ends[0], ends[3] - 1.0, algebraic(ends[0], ends[2]));
    }
}

pub(crate) fn main() -> Result<(), Box<dyn std::error::Error>> {
    let problem = Differentiated::new(Spring)?;
    let guess = Guess::uniform(problem.layout(), 10, &[], |_, x, y| (y[0], y[1], y[2]) = (2.0 * x, 2.0, 20.0 * x));
    for (order, tolerance) in [(Order::Four, 1e-4), (Order::Six, 1e-7), (Order::Eight, 1e-10)] {
        let solution = solve(&problem, &guess, &[], &Options { order, tolerance, ..Options::default() })?;
        let line = &solution.regions()[0];
        let (mut error, mut left): (f64, f64) = (0.0, 0.0);
        for k in 0..=200 {
            let x = 0.5 * f64::from(k) / 200.0;
            let y = line.eval(x);
            error = error.max((y[0] - (PI * x).sin()).abs()).max((y[2] / (PI * PI) - (PI * x).sin()).abs());
            // In units of ∂g/∂z z: by how much z misses the root.
            left = left.max((algebraic(y[0], y[2]) / (1.0 + 3.0 * y[2] * y[2])).abs() / (PI * PI));
        }
        println!(
            "{order:?}, {tolerance:e}: error {error:.1e}, z off its equation by {left:.1e}; {} intervals",
            solution.intervals()
        );
        assert!(error < 3.0 * tolerance && left < 3.0 * tolerance);
        assert!((line.eval(0.0)[1] - 2.0 * FRAC_PI_2).abs() < 10.0 * tolerance);
    }
    Ok(())
}
