//! The base case of edition `published` beside another program, in one run.
//!
//! `cargo bench --bench peer [-- PYTHON SCRIPT [OPTIONS]]`
//!
//! SCRIPT prints one JSON object with the seconds of `cold_with_thinned_meshes`, `resolve` and `step`. Ours are the
//! median and the best of many on one core; ratios are of the best.
#![allow(missing_docs, clippy::expect_used)]

use serde_json::Value;
use sheave::case::{Case, Resolved};
use sheave::drive::{Constant, SolveOptions, solve, solve_from};
use sheave::result::sensitivities;
use solver::{Guess, Options};
use std::process::Command;
use std::time::Instant;

const TIMES: usize = 60;

fn case(tension: &str) -> Resolved {
    let mut case = Case::base();
    let set = case.set("edition", "published").and_then(|()| case.set("operating_point.slack_tension", tension));
    set.and_then(|()| case.resolve()).expect("the base case")
}

/// Seconds: the best and the median.
fn time(mut run: impl FnMut()) -> (f64, f64) {
    let mut all: Vec<f64> = (0..TIMES)
        .map(|_| {
            let start = Instant::now();
            run();
            start.elapsed().as_secs_f64()
        })
        .collect();
    all.sort_by(f64::total_cmp);
    (all[0], all[TIMES / 2])
}

fn peer(command: &[String]) -> Value {
    let Some((program, arguments)) = command.split_first() else { return Value::Null };
    // Its matrices are small: more threads of BLAS cost it time on two cores.
    let output =
        Command::new(program).args(arguments).env("OPENBLAS_NUM_THREADS", "1").output().expect("the peer runs");
    serde_json::from_slice(&output.stdout).unwrap_or_else(|error| {
        eprintln!("the peer: {error}; {}", String::from_utf8_lossy(&output.stderr));
        Value::Null
    })
}

fn main() {
    let command: Vec<String> = std::env::args().skip(1).filter(|argument| argument != "--bench").collect();
    let options = SolveOptions { tolerance: 1e-3, ..SolveOptions::default() };
    let (base, tighter) = (case("100 N"), case("125 N"));
    let solved = solve(&base, &options).expect("the base case is solved");
    let unknowns: Vec<usize> = (0..Constant::UNKNOWN).collect();
    let solver = Options { tolerance: 1e-3, order: options.order, ..Options::default() };
    let guess = Guess::from(&solved.solution);
    let cold = time(|| drop(solve(&base, &options).expect("solved")));
    let again = time(|| drop(solver::solve(&solved.belt, &guess, &unknowns, &solver).expect("solved")));
    let step = time(|| drop(solve_from(&solved, &tighter, &options).expect("solved")));
    let all = time(|| drop(sensitivities(&solved).expect("regular")));
    let stepped = solve_from(&solved, &tighter, &options).expect("solved");
    println!(
        "work of the step: {} Newton iterations, {} factorisations, {} intervals",
        stepped.stats.newton_iterations,
        stepped.stats.factorisations,
        stepped.solution.intervals()
    );
    let theirs = peer(&command);
    println!("{:44} {:>10} {:>10} {:>10} {:>8}", "", "best / ms", "median", "peer / ms", "ratio");
    for (name, (best, median), key) in [
        ("cold start to the base case", cold, "cold_with_thinned_meshes"),
        ("the base case solved again", again, "resolve"),
        ("slack tension 100 N to 125 N", step, "step"),
        ("all sensitivities of all outputs", all, ""),
    ] {
        let peer = theirs[key]["seconds"].as_f64();
        let ratio = peer.map_or(String::new(), |peer| format!("{:10.1} {:8.0}", 1e3 * peer, peer / best));
        println!("{name:44} {:10.3} {:10.3} {ratio}", 1e3 * best, 1e3 * median);
    }
    println!("sensitivities over the warm step: {:.0} %", 100.0 * all.0 / step.0);
}
