//! What the elimination costs beside general methods on the same matrix, and that time and memory grow in proportion
//! to the number of intervals.
//!
//! ```text
//! cargo bench -p sheave-solver --bench linear                prints the tables
//! cargo bench -p sheave-solver --bench linear -- --write     and writes docs/solver-cost.csv and docs/solver-cost.svg
//! ```
#![allow(clippy::unwrap_used, clippy::panic, reason = "a bench fails by panicking")]

// The crate's own elimination, which is not public.
#[path = "linear/flops.rs"]
mod flops;
#[allow(dead_code, unused_imports, unused_macros)]
#[path = "../src/linear/mod.rs"]
mod linear;
#[path = "linear/matrix.rs"]
mod matrix;
#[path = "linear/plot.rs"]
mod plot;
#[path = "linear/whole.rs"]
mod whole;

use matrix::{Bordered, SIZES};
use plot::Curve;
use std::fmt::Write as _;
use std::time::Instant;
use whole::{CHILD, Measured};

const CSV: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/solver-cost.csv");
const SVG: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/solver-cost.svg");
/// A dense matrix beyond this many unknowns takes too long.
const DENSE_LIMIT: usize = 2600;

/// Runs longer than this are timed by the processor time they got, which does not depend on who else is at work.
const SLICE: f64 = 0.02;

/// Nanoseconds this thread has been running, to a few milliseconds; `None` where the system does not say.
fn processor_time() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    text.split_whitespace().next()?.parse().ok()
}

/// Shortest of several runs, in seconds: as many as fit into a fifth of a second, at most 200 and at least three.
pub fn shortest<T>(mut run: impl FnMut() -> T) -> f64 {
    let begin = Instant::now();
    let mut best = f64::INFINITY;
    for count in 1..=200 {
        let (start, before) = (Instant::now(), processor_time());
        std::hint::black_box(run());
        let elapsed = start.elapsed().as_secs_f64();
        let running = before.zip(processor_time()).map(|(before, after)| 1e-9 * (after - before));
        best = best.min(running.filter(|_| elapsed > SLICE).unwrap_or(elapsed));
        if count >= 3 && begin.elapsed().as_secs_f64() > 0.2 {
            break;
        }
    }
    best
}

/// One matrix by the three methods; seconds.
struct Compared {
    intervals: usize,
    unknowns: usize,
    elimination: f64,
    /// Numerical factorisation and solve; the analysis of the pattern is separate.
    sparse: f64,
    analysis: f64,
    dense: Option<f64>,
    /// Largest difference of any two of the solutions.
    difference: f64,
}

fn compare(intervals: usize) -> Compared {
    let problem = Bordered::new(intervals);
    let own = problem.eliminated();
    let (analysis, sparse, by_sparse) = problem.by_sparse_lu();
    let difference = |other: &[f64]| own.iter().zip(other).fold(0.0, |max: f64, (a, b)| max.max((a - b).abs()));
    let mut largest = difference(&by_sparse).max(difference(&problem.solution));
    let dense = (problem.unknowns() <= DENSE_LIMIT).then(|| {
        let (seconds, by_dense) = problem.by_dense_lu();
        largest = largest.max(difference(&by_dense));
        seconds
    });
    assert!(largest < 1e-6, "the methods disagree by {largest:e}");
    let elimination = shortest(|| problem.eliminated());
    Compared { intervals, unknowns: problem.unknowns(), elimination, sparse, analysis, dense, difference: largest }
}

fn table(rows: &[Compared]) -> String {
    let mut out = String::from(
        "| intervals | unknowns | elimination, ms | sparse LU, ms | ratio | (analysis, ms) | dense LU, ms | ratio | \
        difference |\n\
         |---|---|---|---|---|---|---|---|---|\n",
    );
    for row in rows {
        let dense = row.dense.map_or("".to_owned(), |dense| format!("{:.3}", 1e3 * dense));
        let ratio = row.dense.map_or("".to_owned(), |dense| format!("{:.0}", dense / row.elimination));
        let _ = writeln!(
            out,
            "| {} | {} | {:.4} | {:.4} | {:.1} | {:.4} | {dense} | {ratio} | {:.0e} |",
            row.intervals,
            row.unknowns,
            1e3 * row.elimination,
            1e3 * row.sparse,
            row.sparse / row.elimination,
            1e3 * row.analysis,
            row.difference
        );
    }
    out
}

/// How fast the elimination computes; and what the shapes of a larger problem cost.
fn rates(rows: &[Compared]) -> String {
    let (factor, solve) = flops::an_interval(matrix::SHAPE);
    let mut out =
        format!("{factor:.0} operations an interval to factor, {solve:.0} to solve; thousand millions a second:");
    for row in rows {
        let rate = (factor + solve) * row.intervals as f64 / row.elimination / 1e9;
        let _ = write!(out, " {rate:.1} ({} intervals)", row.intervals);
    }
    out.push('\n');
    for (n, p, k) in [(2, 0, 0), (4, 2, 2), (5, 2, 1), (5, 3, 0)] {
        let (factor, solve) = flops::an_interval(linear::chain::Sizes { n, p, k });
        let _ = writeln!(out, "{n} states, {p} constants, {k} integrals: {factor:.0} to factor, {solve:.0} to solve");
    }
    out
}

fn csv(rows: &[Compared], whole: &[Measured]) -> String {
    let mut out = String::from("what,intervals,seconds,bytes\n");
    for row in rows {
        let _ = writeln!(out, "elimination,{},{:e},", row.intervals, row.elimination);
        let _ = writeln!(out, "sparse LU,{},{:e},", row.intervals, row.sparse);
        if let Some(dense) = row.dense {
            let _ = writeln!(out, "dense LU,{},{dense:e},", row.intervals);
        }
    }
    for row in whole {
        let _ = writeln!(out, "solve order {},{},{:e},{}", row.order, row.intervals, row.seconds, row.bytes);
    }
    out
}

fn curves(rows: &[Compared], whole: &[Measured]) -> [Vec<Curve>; 2] {
    let points = |value: &dyn Fn(&Compared) -> Option<f64>| {
        rows.iter().filter_map(|row| Some((row.intervals as f64, value(row)?))).collect()
    };
    let orders = |value: fn(&Measured) -> f64| {
        [4, 6].map(|order| {
            let mine = whole.iter().filter(|row| row.order == order);
            let name = format!("solve, order {order}");
            Curve { name, points: mine.map(|row| (row.intervals as f64, value(row))).collect() }
        })
    };
    let mut times = vec![
        Curve { name: "dense LU".to_owned(), points: points(&|row| row.dense) },
        Curve { name: "sparse LU".to_owned(), points: points(&|row| Some(row.sparse)) },
        Curve { name: "elimination".to_owned(), points: points(&|row| Some(row.elimination)) },
    ];
    times.extend(orders(|row| row.seconds));
    [times, orders(|row| row.bytes as f64).into()]
}

fn main() {
    if let Ok(text) = std::env::var(CHILD) {
        return whole::child(&text);
    }
    let rows: Vec<Compared> = SIZES.into_iter().map(compare).collect();
    println!("{}", table(&rows));
    println!("{}", rates(&rows));
    let whole = whole::all();
    println!("{}", whole::table(&whole));
    if std::env::args().any(|argument| argument == "--write") {
        std::fs::write(CSV, csv(&rows, &whole)).unwrap();
        let [times, memory] = curves(&rows, &whole);
        std::fs::write(SVG, plot::draw(&times, &memory).unwrap()).unwrap();
    }
}
