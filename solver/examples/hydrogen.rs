//! Energies of the hydrogen atom: `-u''/2 + (l (l + 1)/(2 r²) - 1/r) u = E u`, u = 0 at r = 0 and far away, ∫u² = 1.
//!
//! The equation is singular at r = 0, and is stated as it is: order 8 can do without it there. E is an unknown
//! constant, -1/(2 n²) of the state n; in atomic units.
//!
//! ```text
//! cargo run --release -p sheave-solver --example hydrogen
//! ```

use solver::bvp::Bvp;
use solver::{Options, Order};

struct State {
    name: &'static str,
    n: f64,
    l: f64,
    /// Roughly, and of any size.
    u: fn(f64) -> f64,
}

const STATES: [State; 4] = [
    State { name: "1s", n: 1.0, l: 0.0, u: |r| r * (-r).exp() },
    State { name: "2s", n: 2.0, l: 0.0, u: |r| r * (2.0 - r) * (-r / 2.0).exp() },
    State { name: "2p", n: 2.0, l: 1.0, u: |r| r * r * (-r / 2.0).exp() },
    State { name: "3d", n: 3.0, l: 2.0, u: |r| r.powi(3) * (-r / 3.0).exp() },
];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let options = Options { order: Order::Eight, tolerance: 1e-9, ..Options::default() };
    println!("{:>5} {:>16} {:>16} {:>10} {:>10}", "state", "E", "known", "estimate", "intervals");
    for State { name, n, l, u } in STATES {
        let known = -0.5 / (n * n);
        // Far away: u is e^-30 of what it is near the nucleus.
        let far = 30.0 * n;
        let atom = Bvp::new(
            &["u", "slope", "found within"],
            (0.0, far),
            move |r, y, p, f| {
                let potential = 0.5 * l * (l + 1.0) / (r * r) - 1.0 / r;
                (f[0], f[1], f[2]) = (y[1], y[0] * ((-p[0] + potential) * 2.0), y[0] * y[0]);
            },
            |a, b, _p, g| (g[0], g[1], g[2], g[3]) = (a[0], b[0], a[2], b[2] - 1.0),
        )
        .unknown("E", 1.1 * known)
        .guess(40, move |r, y| {
            let slope = (u(r + 1e-4) - u(r)) / 1e-4;
            (y[0], y[1], y[2]) = (u(r), slope, (r / (2.0 * n * n)).min(1.0));
        });
        let solution = atom.solve(&options)?;
        let (energy, estimate) = (solution.constants()[0], solution.error_estimate());
        println!("{name:>5} {energy:16.12} {known:16.12} {estimate:10.1e} {:10}", solution.intervals());
    }
    Ok(())
}
