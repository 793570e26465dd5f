//! Mathieu's eigenvalues `y'' + (λ - 2 q cos 2s) y = 0`, `y'(0) = y'(π) = 0`, `y(0) = 1`: λ is an unknown constant.
//!
//! At q = 0 they are the squares of even numbers, with cosines; from there they are followed to q = 5.
//!
//! ```text
//! cargo run --release -p sheave-solver --example mathieu
//! ```

use solver::continuation::{PathOptions, Ramp, follow};
use solver::model::{Differentiated, Model, Scalar};
use solver::{Guess, Layout, Linearisation, Options, Order, Problem, Region};
use std::f64::consts::PI;

const Q: usize = 0;
const LAMBDA: usize = 1;

struct Mathieu;

impl Model for Mathieu {
    fn layout(&self) -> Layout {
        let circle = Region::dense("half circle", (0.0, PI), &["y", "slope"], &[], 2);
        Layout::dense(vec![circle], &["q", "lambda"], &["even at 0", "even at pi", "norm"])
    }
    fn rhs<S: Scalar>(&self, _: usize, s: S, y: &[S], c: &[S], f: &mut [S]) {
        f[0] = y[1];
        f[1] = -(c[LAMBDA] - c[Q] * (s * 2.0).cos() * 2.0) * y[0];
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
        (g[0], g[1], g[2]) = (ends[1], ends[3], ends[0] - 1.0);
    }
}

/// Order and a_r(5); M. Abramowitz and I. A. Stegun, Handbook of Mathematical Functions, chapter 20; digits beyond its
/// eight from SciPy's `mathieu_a`.
const KNOWN: [(f64, f64); 3] = [(0.0, -5.8000460208515), (2.0, 7.4491097395292), (4.0, 17.0965816843660)];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let problem = Differentiated::new(Mathieu)?;
    let solve = Options { order: Order::Six, tolerance: 1e-10, ..Options::default() };
    let options = PathOptions { solve, ..PathOptions::default() };
    let names = ["order", "lambda", "known", "d(lambda)/dq", "intervals", "steps"];
    println!("{:>5} {:>17} {:>17} {:>13} {:>10} {:>6}", names[0], names[1], names[2], names[3], names[4], names[5]);
    for (order, known) in KNOWN {
        let guess = Guess::uniform(problem.layout(), 20, &[0.0, order * order], |_, s, y| {
            (y[0], y[1]) = ((order * s).cos(), -order * (order * s).sin());
        });
        let path = Ramp::new().linear(Q, 0.0, 5.0);
        let followed = follow(&problem, &guess, &path, &[LAMBDA], &options)?;
        let solution = &followed.solution;
        let rate = Linearisation::new(&problem, solution)?.sensitivity(Q).constants[LAMBDA];
        let (lambda, steps) = (solution.constants()[LAMBDA], followed.steps.len());
        println!("{order:5} {lambda:17.12} {known:17.12} {rate:13.9} {:10} {steps:6}", solution.intervals());
    }
    Ok(())
}
