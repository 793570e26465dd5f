//! Whole solves of one Newton iteration on given meshes, each in a process of its own, whose peak memory is its own.

use crate::shortest;
use solver::model::{Differentiated, Model, Scalar};
use solver::{Control, Guess, Layout, Options, Order, Problem, Region, solve};
use std::fmt::Write as _;
use std::process::Command;

/// Names the case to a child process.
pub const CHILD: &str = "SOLVER_COST_CASE";

const INTERVALS: [usize; 9] = [100, 300, 1000, 3000, 10_000, 30_000, 100_000, 300_000, 1_000_000];

pub struct Measured {
    pub order: usize,
    pub intervals: usize,
    pub seconds: f64,
    /// Peak memory beyond that of a solve on four intervals.
    pub bytes: usize,
}

/// `u'' = u + e^s`, `u(0) = 0`, `u(1) = 1`.
struct Line;

impl Model for Line {
    fn layout(&self) -> Layout {
        Layout::dense(vec![Region::dense("line", (0.0, 1.0), &["u", "slope"], &[], 0)], &[], &["left", "right"])
    }
    fn rhs<S: Scalar>(&self, _: usize, s: S, y: &[S], _: &[S], f: &mut [S]) {
        (f[0], f[1]) = (y[1], y[0] + s.exp());
    }
    fn boundary<S: Scalar>(&self, e: &[S], _: &[S], _: &[S], g: &mut [S]) {
        (g[0], g[1]) = (e[0], e[2] - 1.0);
    }
}

fn run(order: Order, intervals: usize) -> f64 {
    let problem = Differentiated::new(Line).unwrap();
    let guess = Guess::uniform(problem.layout(), intervals, &[], |_, _, y| y.fill(0.0));
    // One mesh, as given.
    let options = Options {
        order,
        control: Control::Defect,
        tolerance: 1e3,
        newton_tolerance: Some(1e-6),
        max_meshes: 1,
        max_intervals: intervals,
        ..Options::default()
    };
    shortest(|| {
        let solution = solve(&problem, &guess, &[], &options).unwrap();
        assert_eq!((solution.intervals(), solution.stats().newton_iterations), (intervals, 1));
    })
}

/// Measures the case that `text` names, and prints it.
pub fn child(text: &str) {
    let (order, intervals) = text.split_once(' ').unwrap();
    let order = if order == "6" { Order::Six } else { Order::Four };
    let seconds = run(order, intervals.parse().unwrap());
    println!("{seconds:e} {}", peak());
}

/// Peak memory of this process in bytes; 0 where the system does not say.
fn peak() -> usize {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find(|line| line.starts_with("VmHWM:")).unwrap_or_default();
    line.split_whitespace().nth(1).and_then(|kilobytes| kilobytes.parse::<usize>().ok()).unwrap_or(0) * 1024
}

fn measure(order: usize, intervals: usize) -> (f64, usize) {
    let program = std::env::current_exe().unwrap();
    let output = Command::new(program).env(CHILD, format!("{order} {intervals}")).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8(output.stdout).unwrap();
    let (seconds, bytes) = text.trim().split_once(' ').unwrap();
    (seconds.parse().unwrap(), bytes.parse().unwrap())
}

pub fn all() -> Vec<Measured> {
    let mut rows = Vec::new();
    for order in [4, 6] {
        let least = measure(order, 4).1;
        for intervals in INTERVALS {
            let (seconds, bytes) = measure(order, intervals);
            rows.push(Measured { order, intervals, seconds, bytes: bytes.saturating_sub(least) });
        }
    }
    rows
}

pub fn table(rows: &[Measured]) -> String {
    let mut out = String::from(
        "| order | intervals | solve, ms | µs an interval | peak memory, MB | bytes an interval \
        |\n|---|---|---|---|---|---|\n",
    );
    for row in rows {
        let (n, ms) = (row.intervals as f64, 1e3 * row.seconds);
        let _ = writeln!(
            out,
            "| {} | {} | {ms:.3} | {:.3} | {:.1} | {:.0} |",
            row.order,
            row.intervals,
            1e3 * ms / n,
            row.bytes as f64 / 1e6,
            row.bytes as f64 / n
        );
    }
    out
}
