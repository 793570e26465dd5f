//! Bratu's problem, `u'' = -λ exp(u)`, `u(0) = u(1) = 0`, from thirteen guesses at each of three λ, all in parallel:
//! below λ = 3.5138 it has two solutions, and which is found depends on the guess.
//!
//! ```text
//! cargo run --release -p sheave-solver --features rayon --example many
//! ```

use solver::bvp::Bvp;
use solver::{Guess, Options, solve_many};

fn main() {
    let bratu = Bvp::new(
        &["u", "slope"],
        (0.0, 1.0),
        |_x, y, p, f| (f[0], f[1]) = (y[1], -p[0] * y[0].exp()),
        |a, b, _p, g| (g[0], g[1]) = (a[0], b[0]),
    )
    .given("lambda", 1.0);
    let mut guesses = Vec::new();
    for lambda in [1.0, 2.0, 3.0] {
        for height in (0..13).map(|k| 0.5 * f64::from(k)) {
            let mut guess = Guess { constants: vec![lambda], ..bratu.start() };
            for region in &mut guess.regions {
                let parabola = |x: f64| [4.0 * height * x * (1.0 - x), 4.0 * height * (1.0 - 2.0 * x)];
                region.states = (0..2).map(|i| region.mesh.iter().map(|&x| parabola(x)[i]).collect()).collect();
            }
            guesses.push((lambda, height, guess));
        }
    }
    let tasks: Vec<_> = guesses.iter().map(|(_, _, guess)| (&bratu, guess)).collect();
    let answers = solve_many(&tasks, &[], &Options::default());
    for ((lambda, height, _), answer) in guesses.iter().zip(answers) {
        let found = match answer {
            Ok(solution) => format!("{:.6}", solution.regions()[0].eval(0.5)[0]),
            Err(error) => error.to_string(),
        };
        println!("λ = {lambda}, from a height of {height:.1}: u(1/2) = {found}");
    }
}
