//! A shock of width ε: `ε u'' + u u' - u = 0`, `u(0) = -1`, `u(1) = 3/2`.
//!
//! Away from the shock u' = 1: u = s - 1 on its left, s + 1/2 on its right; it stands where both are equally far from
//! zero, at s = 1/4, and there ε u' = (3/4)²/2 to leading order (J. Kevorkian and J. D. Cole, "Perturbation Methods in
//! Applied Mathematics", Springer 1981). From a straight guess Newton's iteration finds it only for large ε; for
//! smaller ones the solver is told which constant makes the problem hard.
//!
//! ```text
//! cargo run --release -p sheave-solver --example shock
//! ```

use solver::continuation::{How, Stiffness, solve_automatically};
use solver::model::{Differentiated, Model, Scalar};
use solver::{Guess, Layout, Linearisation, Options, Order, Problem, Region, RegionSolution};

struct Shock;

impl Model for Shock {
    fn layout(&self) -> Layout {
        let line = Region::dense("line", (0.0, 1.0), &["u", "slope"], &[], 1);
        Layout::dense(vec![line], &["epsilon"], &["left", "right"])
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], c: &[S], f: &mut [S]) {
        f[0] = y[1];
        f[1] = y[0] * (-y[1] + 1.0) / c[0];
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
        (g[0], g[1]) = (ends[0] + 1.0, ends[2] - 1.5);
    }
}

/// Where u crosses zero, by bisection.
fn place(line: &RegionSolution) -> f64 {
    let (mut left, mut right) = (0.0, 1.0);
    for _ in 0..60 {
        let middle = 0.5 * (left + right);
        if line.eval(middle)[0] < 0.0 { left = middle } else { right = middle }
    }
    left
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let problem = Differentiated::new(Shock)?;
    let options = Options { order: Order::Six, ..Options::default() };
    println!("known: shock at 0.25, epsilon * slope there 0.28125, both to leading order");
    println!(
        "{:>8} {:>10} {:>15} {:>10} {:>10} {:>10}  how",
        "epsilon", "shock at", "epsilon * slope", "error", "intervals", "stiffness"
    );
    for epsilon in [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6] {
        let guess = Guess::uniform(problem.layout(), 20, &[epsilon], |_, s, y| (y[0], y[1]) = (2.5 * s - 1.0, 2.5));
        let stiffness = Stiffness { constant: 0, easy: Some(1.0) };
        let found = solve_automatically(&problem, &guess, &[], Some(stiffness), &options)?;
        let how = match found.how {
            How::Direct => "directly".to_owned(),
            How::Stiffness { easy, steps } => format!("from epsilon = {easy} in {steps} steps"),
            How::Homotopy { points } => format!("by homotopy, {points} points"),
        };
        let solution = &found.solution;
        let line = &solution.regions()[0];
        let at = place(line);
        let slope = epsilon * line.eval(at)[1];
        let conditioning = Linearisation::new(&problem, solution)?.conditioning();
        println!(
            "{epsilon:8.0e} {at:10.6} {slope:15.6} {:10.1e} {:10} {:10.1e}  {how}",
            solution.error_estimate(),
            solution.intervals(),
            conditioning.stiffness()
        );
    }
    Ok(())
}
