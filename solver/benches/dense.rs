//! What the feature `faer` gains: the small dense system of ends and constants, factored and solved by faer and by
//! nalgebra, over its number of unknowns. `cargo bench -p sheave-solver --bench dense`.
//!
//! A problem of four regions with five states has 30 to 60 unknowns there; a large border (many constants, conditions
//! at many places) has more.

use std::hint::black_box;
use std::time::Instant;

// The two that the crate chooses between, which are not public.
#[allow(dead_code)]
#[path = "../src/linear/dense/by_faer.rs"]
mod by_faer;
#[allow(dead_code)]
#[path = "../src/linear/dense/by_nalgebra.rs"]
mod by_nalgebra;

/// Shortest times of factoring the `n * n` matrix and of solving with the factors, in microseconds.
macro_rules! timed {
    ($name:ident, $by:ident) => {
        fn $name(n: usize, a: &[f64]) -> (f64, f64) {
            let mut rows = Vec::new();
            let mut factors = Some($by::Factors::of(n, a, &mut rows, None));
            let factor = shortest(n, || factors = Some($by::Factors::of(n, a, &mut rows, factors.take())));
            let mut b = vec![1.0; n];
            let solve = shortest(n, || {
                b.fill(1.0);
                factors.iter().for_each(|factors| factors.solve(&mut b));
            });
            (factor, solve)
        }
    };
}
timed!(faer, by_faer);
timed!(nalgebra, by_nalgebra);

/// Sizes that are measured.
const SIZES: [usize; 9] = [8, 16, 30, 44, 60, 100, 200, 400, 800];

/// Shortest of several runs, in microseconds.
fn shortest(n: usize, mut run: impl FnMut()) -> f64 {
    let runs = (400_000_000 / (n * n * n + 20_000)).clamp(5, 5000);
    let once = |_| {
        let start = Instant::now();
        run();
        1e6 * start.elapsed().as_secs_f64()
    };
    (0..runs).map(once).fold(f64::INFINITY, f64::min)
}

/// Entries without a pattern, between -1 and 1, with a diagonal that keeps the condition moderate.
fn matrix(n: usize) -> Vec<f64> {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut next = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    (0..n * n).map(|at| next() + if at % (n + 1) == 0 { 2.0 } else { 0.0 }).collect()
}

fn main() {
    println!("unknowns |  factor: faer   nalgebra  ratio |   solve: faer   nalgebra  ratio   (µs)");
    for n in SIZES {
        let a = black_box(matrix(n));
        let ((factor, solve), (factor_other, solve_other)) = (faer(n, &a), nalgebra(n, &a));
        println!(
            "{n:>8} | {factor:>13.1} {factor_other:>10.1} {:>6.2} | {solve:>13.2} {solve_other:>10.2} {:>6.2}",
            factor_other / factor,
            solve_other / solve
        );
    }
}
