//! Heat through two materials: a copper piece that is heated inside, welded to a steel piece. Each is a region with its
//! own mesh; temperature and heat flow are continuous where they meet.
//!
//! ```text
//! copper, 0 < s < 0.4:   T' = -w/k,  w' = q        steel, 0.4 < s < 1:   T' = -w/k,  w' = 0
//! T(0) = 0,  T(1) = 1,  T and w continuous at 0.4;  q such that the mean temperature of the copper is 0.5
//! ```
//!
//! ```text
//! cargo run --release -p sheave-solver --example interface
//! ```

use solver::model::{Differentiated, Model, Scalar};
use solver::{Guess, Layout, Options, Problem, Region, solve};

/// Conductivities.
const K: [f64; 2] = [8.0, 1.0];
const JOINT: f64 = 0.4;
const MEAN: f64 = 0.5;

struct Rod;

impl Model for Rod {
    fn layout(&self) -> Layout {
        let copper = Region::dense("copper", (0.0, JOINT), &["T", "flow"], &["heat"], 1);
        let steel = Region::dense("steel", (JOINT, 1.0), &["T", "flow"], &[], 1);
        let equations = ["left end", "joint: temperature", "joint: flow", "right end", "mean temperature"];
        Layout::dense(vec![copper, steel], &["source"], &equations)
    }
    fn rhs<S: Scalar>(&self, region: usize, _: S, y: &[S], c: &[S], f: &mut [S]) {
        f[0] = -y[1] / K[region];
        f[1] = S::from(0.0);
        if region == 0 {
            f[1] = c[0];
            f[2] = y[0];
        }
    }
    fn boundary<S: Scalar>(&self, ends: &[S], integrals: &[S], _: &[S], g: &mut [S]) {
        // Ends: copper T, flow at 0; at the joint; steel T, flow at the joint; at 1.
        (g[0], g[1], g[2]) = (ends[0], ends[2] - ends[4], ends[3] - ends[5]);
        (g[3], g[4]) = (ends[6] - 1.0, integrals[0] - JOINT * MEAN);
    }
}

/// Source, flow at the left end and temperature of the joint, in closed form: the two conditions are linear in the
/// first two.
fn exact() -> (f64, f64, f64) {
    // T(1) = -(w a + q a²/2)/k1 - (w + q a)(1 - a)/k2 = 1,  ∫T = -(w a²/2 + q a³/6)/k1 = a mean.
    let (a, [k1, k2]) = (JOINT, K);
    let (a11, a12) = (-a / k1 - (1.0 - a) / k2, -0.5 * a * a / k1 - a * (1.0 - a) / k2);
    let (a21, a22) = (-0.5 * a * a / k1, -a * a * a / (6.0 * k1));
    let determinant = a11 * a22 - a12 * a21;
    let w = (a22 - a12 * a * MEAN) / determinant;
    let q = (a11 * a * MEAN - a21) / determinant;
    (q, w, -(w * a + 0.5 * q * a * a) / k1)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let problem = Differentiated::new(Rod)?;
    let guess = Guess::uniform(problem.layout(), 4, &[0.0], |_, _, y| y.fill(0.0));
    let solution = solve(&problem, &guess, &[0], &Options::default())?;
    let [copper, steel] = solution.regions() else { return Err("two regions".into()) };
    let (source, flow, joint) = exact();
    let joint_found = [copper.eval(JOINT)[0], steel.eval(JOINT)[0]];
    println!("{:24} {:>16} {:>16}", "", "found", "exact");
    println!("{:24} {:16.10} {source:16.10}", "source", solution.constants()[0]);
    println!("{:24} {:16.10} {flow:16.10}", "flow at the left end", copper.state(1)[0]);
    println!("{:24} {:16.10} {joint:16.10}", "joint, from the copper", joint_found[0]);
    println!("{:24} {:16.10} {joint:16.10}", "joint, from the steel", joint_found[1]);
    println!("{:24} {:16.10} {MEAN:16.10}", "mean of the copper", copper.integrals()[0] / JOINT);
    let stats = solution.stats();
    println!(
        "{} Newton iteration on {} + {} intervals",
        stats.newton_iterations,
        copper.intervals(),
        steel.intervals()
    );
    Ok(())
}
