//! Right-hand sides and Jacobians of all four regions, per mesh point, beside another generator's.
//!
//! `cargo bench -p sheave-kernels --no-default-features --bench all_regions [-- PYTHON SCRIPT]`
//!
//! Edition `thesis`: two contacts and two spans with their derivatives in states and unknown constants. SCRIPT prints
//! the peer's time as `…: 0.224 us per point; …` and is run before and after; the smaller of its figures counts, as the
//! smallest of ours does.
#![allow(missing_docs, clippy::expect_used)]

mod common;

use common::{Batch, POINTS};
use generated::{CONTACT_LINEARISED_VISCOUS_COULOMB, SPAN_DERIVED, Simd};
use std::process::Command;
use std::time::Instant;

/// Batches a measurement; measurements.
const ROUNDS: (usize, usize) = (400, 40);

/// Microseconds per mesh point, the best of many.
fn ours(simd: Simd) -> f64 {
    Simd::limit(simd);
    let kernels = [&CONTACT_LINEARISED_VISCOUS_COULOMB, &SPAN_DERIVED];
    let mut batches: Vec<_> =
        kernels.iter().flat_map(|kernel| [(kernel, Batch::new(kernel)), (kernel, Batch::new(kernel))]).collect();
    let mut best = f64::INFINITY;
    for _ in 0..ROUNDS.1 {
        let start = Instant::now();
        for _ in 0..ROUNDS.0 {
            batches.iter_mut().for_each(|(kernel, batch)| batch.run(kernel.jacobian));
        }
        best = best.min(start.elapsed().as_secs_f64());
    }
    Simd::limit(Simd::Avx512);
    1e6 * best / (ROUNDS.0 * POINTS) as f64
}

/// What the peer prints, in microseconds.
fn peer(command: &[String]) -> Option<f64> {
    let (program, arguments) = command.split_first()?;
    let output = Command::new(program).args(arguments).output().expect("the peer runs");
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let figure = text.split(" us per point").next()?.rsplit(' ').next()?.parse().ok();
    if figure.is_none() {
        eprintln!("the peer says: {text}{}", String::from_utf8_lossy(&output.stderr));
    }
    figure
}

fn main() {
    let command: Vec<String> = std::env::args().skip(1).filter(|argument| argument != "--bench").collect();
    let before = peer(&command);
    let all: Vec<(Simd, f64)> = Simd::available().into_iter().map(|simd| (simd, ours(simd))).collect();
    let peer = before.into_iter().chain(peer(&command)).reduce(f64::min);
    if let Some(time) = peer {
        println!("peer     {time:8.4} µs per point of all regions");
    }
    for (simd, time) in all {
        let ratio = peer.map_or(String::new(), |peer| format!("   {:5.2} times the peer's speed", peer / time));
        println!("{:8} {time:8.4} µs per point of all regions{ratio}", format!("{simd:?}"));
    }
}
