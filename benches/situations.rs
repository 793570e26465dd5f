//! The seven input situations as operating points, on random drives: each is solved in the ordinary way, then asked for
//! by speeds, torques and axial forces, from nothing. `cargo bench --bench situations [-- DRIVES]`.

use sheave::case::{Case, Key};
use sheave::drive::{Constant, SolveOptions};
use sheave::random::Random;
use sheave::result::{Outcome, run};
use solver::Order;
use std::time::Instant;

/// Key, from, to.
const AXES: [(Key, f64, f64); 8] = [
    (Key::Ratio, 0.72, 1.74),
    (Key::SlackTension, 60.0, 400.0),
    (Key::PrimaryTorque, 4.0, 25.0),
    (Key::PrimarySpeed, 150.0, 450.0),
    (Key::BendingStiffness, 0.05, 0.5),
    (Key::LongitudinalStiffness, 1.5e5, 4e5),
    (Key::FrictionCoefficient, 0.3, 0.5),
    (Key::RadialStiffness, 1.4e7, 2.6e7),
];

fn solve(case: &Case, options: &SolveOptions) -> Result<Outcome, String> {
    let resolved = case.resolve().map_err(|error| error.to_string())?;
    run(&resolved, options).map_err(|failure| failure.to_string())
}

/// Situations solved, and what they cost.
#[derive(Debug, Clone, Copy, Default)]
struct Tally {
    solved: usize,
    steps: usize,
    iterations: usize,
}

impl Tally {
    fn add(&mut self, found: &Outcome) {
        let cost = &found.result.solver;
        *self += Self { solved: 1, steps: cost.continuation_steps, iterations: cost.newton_iterations };
    }
}

impl std::ops::AddAssign for Tally {
    fn add_assign(&mut self, other: Self) {
        self.solved += other.solved;
        self.steps += other.steps;
        self.iterations += other.iterations;
    }
}

impl std::fmt::Display for Tally {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} solved, {} steps, {} Newton iterations", self.solved, self.steps, self.iterations)
    }
}

/// The situations, each with its keys and their values.
fn situations(known: &Outcome) -> [(&'static str, [(Key, f64); 3]); 7] {
    let (primary, secondary) = (&known.result.primary, &known.result.secondary);
    let (speed_in, speed_out) = ((Key::PrimarySpeed, primary.speed), (Key::SecondarySpeed, secondary.speed));
    let (torque_in, torque_out) = ((Key::PrimaryTorque, primary.torque), (Key::SecondaryTorque, secondary.torque));
    let (clamp_in, clamp_out) =
        ((Key::PrimaryAxialForce, primary.axial_force), (Key::SecondaryAxialForce, secondary.axial_force));
    [
        ("ω_I, M_O, F_CO", [speed_in, torque_out, clamp_out]),
        ("ω_O, M_I, F_CI", [speed_out, torque_in, clamp_in]),
        ("ω_I, ω_O, F_CO", [speed_in, speed_out, clamp_out]),
        ("ω_I, ω_O, F_CI", [speed_in, speed_out, clamp_in]),
        ("ω_I, M_O, F_CI", [speed_in, torque_out, clamp_in]),
        ("ω_I, M_I, F_CO", [speed_in, torque_in, clamp_out]),
        ("ω_I, M_I, F_CI", [speed_in, torque_in, clamp_in]),
    ]
}

/// A drive without its operating point, and one with it.
fn drive(stream: &mut Random, edition: &str) -> Result<(Case, Case), String> {
    let mut bare = Case::base();
    bare.set("edition", edition).map_err(|error| error.to_string())?;
    let mut whole = bare.clone();
    for (key, from, to) in AXES {
        let value = from + (to - from) * stream.uniform();
        whole.set_si(key, value).map_err(|error| error.to_string())?;
        if key.entry().section() != "operating_point" {
            bare.set_si(key, value).map_err(|error| error.to_string())?;
        }
    }
    Ok((bare, whole))
}

fn main() -> Result<(), String> {
    let drives: usize = std::env::args().filter_map(|argument| argument.parse().ok()).next().unwrap_or(25);
    let options = SolveOptions { tolerance: 1e-8, order: Order::Six, sensitivities: false, ..SolveOptions::default() };
    for edition in ["consistent", "thesis"] {
        let mut stream = Random::new(2012);
        let (mut skipped, mut worst, mut seconds) = (0, 0.0_f64, Vec::new());
        let mut tallies = [Tally::default(); 7];
        for index in 0..drives {
            let (bare, whole) = drive(&mut stream, edition)?;
            let Ok(known) = solve(&whole, &options) else {
                skipped += 1;
                continue;
            };
            for ((name, slots), tally) in situations(&known).into_iter().zip(&mut tallies) {
                let mut case = bare.clone();
                slots
                    .iter()
                    .try_for_each(|(key, value)| case.set_si(*key, *value))
                    .map_err(|error| error.to_string())?;
                let start = Instant::now();
                match solve(&case, &options) {
                    Ok(found) => {
                        seconds.push(start.elapsed().as_secs_f64());
                        tally.add(&found);
                        for constant in [Constant::PrimarySpeed, Constant::PrimaryTorque, Constant::SlackTension] {
                            let off = found.solved.constant(constant) / known.solved.constant(constant) - 1.0;
                            worst = worst.max(off.abs());
                        }
                    }
                    Err(reason) => println!("{edition}, drive {index}, {name}: {reason}"),
                }
            }
        }
        seconds.sort_by(f64::total_cmp);
        let median = seconds.get(seconds.len() / 2).copied().unwrap_or(f64::NAN);
        let mut all = Tally::default();
        for (tally, number) in tallies.iter().zip(1..) {
            println!("{edition}, situation {number}: {tally}");
            all += *tally;
        }
        println!(
            "{edition}: {all}, of {} ({skipped} drives have no ordinary solution), back to {worst:.1e} at worst, \
             median {:.0} ms, {:.1} s in all",
            7 * (drives - skipped),
            1e3 * median,
            seconds.iter().sum::<f64>()
        );
    }
    Ok(())
}
