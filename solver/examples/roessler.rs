//! Periodic orbits of Rössler's equations, their stability, and where the period doubles.
//!
//! ```text
//! x' = -y - z,  y' = x + y/5,  z' = 1/5 + z (x - c)
//! ```
//!
//! The orbit that is run through once is followed in c from 2.5 to 4, its period T an unknown constant. Time is in
//! units of T, and begins where y = 0. Floquet's multipliers say that it is stable up to c = 2.832445, where one of
//! them passes -1: the period doubles there for the first time on the way to chaos.
//!
//! ```text
//! cargo run --release -p sheave-solver --example roessler
//! ```

use solver::bvp::{Bvp, Formulas, Number};
use solver::continuation::{BranchOptions, PointKind, trace};
use solver::{Multipliers, Options, Orbit, Order};
use std::f64::consts::TAU;

pub(crate) const C: usize = 0;
pub(crate) const PERIOD: usize = 1;
/// Where the period doubles, by shooting with SciPy's DOP853 at a tolerance of 1e-13.
pub(crate) const KNOWN: f64 = 2.832_445_028;

pub(crate) fn roessler(c: f64) -> Bvp<impl Formulas> {
    Bvp::new(
        &["x", "y", "z"],
        (0.0, 1.0),
        |_, u, p, f| {
            let (c, period) = (p[C], p[PERIOD]);
            (f[0], f[1]) = (period * (-u[1] - u[2]), period * (u[0] + u[1] * 0.2));
            f[2] = period * (u[2] * (u[0] - c) + Number::constant(0.2));
        },
        |a, b, _, g| {
            (0..3).for_each(|i| g[i] = b[i] - a[i]);
            g[3] = a[1];
        },
    )
    .given("c", c)
    .unknown("T", 5.75)
    .guess(30, |t, u| {
        let (sine, cosine) = (TAU * t).sin_cos();
        (u[0], u[1], u[2]) = (-3.7 * cosine, -3.5 * sine, 0.1 + 1.5 * (-20.0 * (t - 0.55).powi(2)).exp());
    })
}

pub(crate) fn main() -> Result<(), Box<dyn std::error::Error>> {
    let problem = roessler(2.5);
    let solve = Options { order: Order::Eight, tolerance: 1e-8, ..Options::default() };
    let multipliers = |solution: &_| Multipliers::new(&problem, solution, 0, Orbit::Autonomous, 1e-7);
    // What cannot be found is no zero.
    let doubling = |solution: &_| multipliers(solution).map_or(f64::NAN, |found| found.doubling());
    let options = BranchOptions { solve, range: (2.5, 4.0), ..BranchOptions::default() };
    let branch = trace(&problem, &problem.start(), C, problem.unknowns(), &options, &[&doubling])?;
    println!("{:>11} {:>10} {:>12} {:>12}", "c", "T", "multiplier", "trivial - 1");
    for point in &branch.points {
        let found = multipliers(&point.solution)?;
        let trivial = found.trivial().map_or(f64::NAN, |trivial| trivial.re - 1.0);
        let what = match point.kind {
            PointKind::Event(_) => "the period doubles",
            _ if found.is_stable() => "stable",
            _ => "unstable",
        };
        let (period, largest) = (point.solution.constants()[PERIOD], found.values()[0].re);
        println!("{:11.7} {period:10.7} {largest:12.7} {trivial:12.1e} {what}", point.parameter);
    }
    let doubled = branch.points.iter().find(|point| matches!(point.kind, PointKind::Event(_)));
    let c = doubled.ok_or("no period doubling")?.parameter;
    assert!((c - KNOWN).abs() < 1e-7, "{c} for {KNOWN}");
    Ok(())
}
