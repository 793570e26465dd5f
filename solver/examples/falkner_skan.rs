//! The Falkner-Skan boundary layer `f''' + f f'' + β (1 - f'²) = 0`, `f(0) = f'(0) = 0`, `f' → 1`: how far the layer
//! reaches is unknown, and found.
//!
//! The region is written on (0, 1) and multiplied by its length L, a constant that one more condition determines:
//! `f''(L) = 1e-8`, where the layer counts as ended.
//!
//! ```text
//! cargo run --release -p sheave-solver --example falkner_skan
//! ```

use solver::continuation::{PathOptions, Ramp, follow};
use solver::model::{Differentiated, Model, Scalar};
use solver::{Guess, Layout, Options, Order, Problem, Region};

const BETA: usize = 0;
const LENGTH: usize = 1;

struct FalknerSkan;

impl Model for FalknerSkan {
    fn layout(&self) -> Layout {
        let layer = Region::dense("layer", (0.0, 1.0), &["f", "velocity", "shear"], &[], 2);
        Layout::dense(vec![layer], &["beta", "length"], &["wall", "no slip", "outer flow", "edge"])
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], c: &[S], f: &mut [S]) {
        f[0] = c[LENGTH] * y[1];
        f[1] = c[LENGTH] * y[2];
        f[2] = -c[LENGTH] * (y[0] * y[2] + c[BETA] * (-y[1] * y[1] + 1.0));
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
        (g[0], g[1]) = (ends[0], ends[1]);
        (g[2], g[3]) = (ends[4] - 1.0, (ends[5] - 1e-8) * 1e6);
    }
}

/// β and f''(0); T. Cebeci and H. B. Keller, J. Comput. Phys. 7 (1971) 289-300, and for β = 0 and 1 the flat plate and
/// the stagnation point as tabulated everywhere.
const KNOWN: [(f64, f64); 7] = [
    (-0.18, 0.128637),
    (-0.1, 0.319270),
    (0.0, 0.469600),
    (0.3, 0.774755),
    (0.5, 0.927680),
    (1.0, 1.232588),
    (2.0, 1.687218),
];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let problem = Differentiated::new(FalknerSkan)?;
    let solve = Options { order: Order::Six, tolerance: 1e-8, ..Options::default() };
    let options = PathOptions { solve, ..PathOptions::default() };
    println!("{:>6} {:>12} {:>10} {:>8} {:>10} {:>7}", "beta", "f''(0)", "known", "length", "intervals", "steps");
    for (beta, known) in KNOWN {
        // From the flat plate; its velocity is roughly 1 - exp(-s).
        let guess = Guess::uniform(problem.layout(), 20, &[0.0, 6.0], |_, s, y| {
            let decay = (-6.0 * s).exp();
            y.copy_from_slice(&[6.0 * s - 1.0 + decay, 1.0 - decay, decay]);
        });
        let path = Ramp::new().linear(BETA, 0.0, beta);
        let followed = follow(&problem, &guess, &path, &[LENGTH], &options)?;
        let (solution, steps) = (&followed.solution, followed.steps.len());
        let shear = solution.regions()[0].state(2)[0];
        let length = solution.constants()[LENGTH];
        println!("{beta:6.2} {shear:12.8} {known:10.6} {length:8.4} {:10} {steps:7}", solution.intervals());
    }
    Ok(())
}
