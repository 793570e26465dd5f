//! What losses add to the time of a solve: the same warm and cold steps without and with them, one after the other.
//!
//! `cargo bench --bench losses` prints medians of both, and what losses add.

use sheave::case::{Case, Resolved};
use sheave::clock::Stopwatch;
use sheave::drive::{SolveOptions, Solved, solve, solve_along};
use sheave::result::interpret;

/// Pairs of solutions, and how far the slack tension of a warm step moves.
const PAIRS: usize = 120;
const STEP: f64 = 0.01;

fn case(tension: f64, losses: &str) -> Result<Resolved, String> {
    let mut case = Case::base();
    let mut set = |key: &str, value: &str| case.set(key, value).map_err(|error| error.to_string());
    set("operating_point.slack_tension", &tension.to_string())?;
    set("losses.include", losses)?;
    case.resolve().map_err(|error| error.to_string())
}

/// Seconds that a solve and the reading of its result take.
fn seconds(case: &Resolved, near: Option<&Solved>, options: &SolveOptions) -> Result<f64, String> {
    let start = Stopwatch::start();
    let solved = match near {
        Some(near) => solve_along(&[near], case, options),
        None => solve(case, options),
    };
    let solved = solved.map_err(|failure| failure.to_string())?;
    interpret(case, options, solved, Stopwatch::start()).map_err(|failure| failure.to_string())?;
    Ok(start.seconds().unwrap_or(f64::NAN))
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

fn main() -> Result<(), String> {
    for tolerance in [1e-3, 1e-4, 1e-6] {
        let options = SolveOptions { tolerance, ..SolveOptions::default() };
        let near = solve(&case(100.0, "off")?, &options).map_err(|failure| failure.to_string())?;
        for (name, near) in [("warm", Some(&near)), ("cold", None)] {
            let (mut without, mut with) = (Vec::new(), Vec::new());
            for pair in 0..PAIRS {
                let tension = 100.0 * (1.0 + STEP * (1 + pair % 5) as f64);
                without.push(seconds(&case(tension, "off")?, near, &options)?);
                with.push(seconds(&case(tension, "on")?, near, &options)?);
            }
            let added = median(with.iter().zip(&without).map(|(with, without)| with - without).collect());
            let without = median(without);
            println!(
                "{name} at {tolerance:.0e}: {:.3} ms without, {:.3} ms with; losses add {:.1} %",
                1e3 * without,
                1e3 * median(with),
                100.0 * added / without
            );
        }
    }
    Ok(())
}
