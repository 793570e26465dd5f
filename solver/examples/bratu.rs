//! Bratu's problem `u'' = -λ exp(u)`, `u(0) = u(1) = 0`: the branch of solutions through its fold.
//!
//! ```text
//! cargo run --release -p sheave-solver --example bratu
//! ```

use solver::continuation::{BranchOptions, PointKind, trace};
use solver::model::{Differentiated, Model, Scalar};
use solver::{Guess, Layout, Options, Order, Problem, Region, Solution};

struct Bratu;

impl Model for Bratu {
    fn layout(&self) -> Layout {
        let string = Region::dense("string", (0.0, 1.0), &["u", "slope"], &[], 1);
        Layout::dense(vec![string], &["lambda"], &["left end", "right end"])
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], c: &[S], f: &mut [S]) {
        f[0] = y[1];
        f[1] = -c[0] * y[0].exp();
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
        (g[0], g[1]) = (ends[0], ends[2]);
    }
}

fn middle(solution: &Solution) -> f64 {
    solution.regions().first().map_or(f64::NAN, |string| string.eval(0.5)[0])
}

/// λ for a given u(1/2) = 2 ln cosh θ: λ = 8 θ² / cosh² θ.
fn lambda(middle: f64) -> f64 {
    let theta = (0.5 * middle).exp().acosh();
    8.0 * (theta / theta.cosh()).powi(2)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let problem = Differentiated::new(Bratu)?;
    let guess = Guess::uniform(problem.layout(), 10, &[0.5], |_, _, y| y.fill(0.0));
    let options = BranchOptions {
        solve: Options { order: Order::Six, tolerance: 1e-9, ..Options::default() },
        range: (0.5, 10.0),
        ..BranchOptions::default()
    };
    let three = |solution: &Solution| middle(solution) - 3.0;
    let branch = trace(&problem, &guess, 0, &[], &options, &[&three])?;
    println!("{:>12} {:>14} {:>14}  point", "u(1/2)", "lambda", "exact");
    for point in &branch.points {
        let name = match point.kind {
            PointKind::Regular => "",
            PointKind::BranchPoint => "branch point",
            PointKind::Fold => "fold (known: 3.513830719)",
            PointKind::Event(_) => "u(1/2) = 3",
            PointKind::End => "end of the range",
        };
        let height = middle(&point.solution);
        println!("{height:12.8} {:14.9} {:14.9}  {name}", point.parameter, lambda(height));
    }
    println!("{} Newton iterations in all", branch.stats.newton_iterations);
    Ok(())
}
