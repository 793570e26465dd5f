//! What outputs are worth: their errors against a solution to 1e-10 at order 6, over random designs, at three
//! tolerances and both orders. `cargo bench --bench accuracy -- SEED DESIGNS`.
//!
//! An output is missed where its relative error exceeds the tolerance. Its uncertainty holds where the error is at most
//! twice what the result says.

use sheave::case::Resolved;
use sheave::drive::SolveOptions;
use sheave::result::{DriveResult, run};
use solver::Order;

mod designs;
use designs::{case, design, settings};

const REFERENCE: SolveOptions = SolveOptions {
    tolerance: 1e-10,
    order: Order::Six,
    sensitivities: false,
    uncertainty: false,
    work_limit: sheave::drive::WORK_LIMIT,
};
/// Relative error of the reference: less says nothing.
const FLOOR: f64 = 1e-9;
/// Factor on the stated uncertainty within which an error is to lie.
const WITHIN: f64 = 2.0;

type Result = DriveResult<Resolved>;

/// An output that is looked at.
struct Looked {
    name: &'static str,
    /// The name of its uncertainty, if it has one.
    uncertainty: Option<&'static str>,
    value: fn(&Result) -> f64,
    /// What its error is relative to.
    scale: fn(&Result) -> f64,
}

/// An output whose error is relative to itself.
const fn looked(name: &'static str, uncertainty: Option<&'static str>, value: fn(&Result) -> f64) -> Looked {
    Looked { name, uncertainty, value, scale: value }
}

const OUTPUTS: [Looked; 6] = [
    looked("efficiency", Some("efficiency.overall"), |r| r.efficiency.overall.unwrap_or(f64::NAN)),
    looked("primary axial force", Some("primary.axial_force"), |r| r.primary.axial_force),
    looked("secondary axial force", Some("secondary.axial_force"), |r| r.secondary.axial_force),
    looked("secondary torque", Some("secondary.torque"), |r| r.secondary.torque),
    // It may be close to nothing.
    Looked {
        name: "smallest sliding speed",
        uncertainty: None,
        value: |r| r.primary.min_sliding_speed.min(r.secondary.min_sliding_speed),
        scale: |r| r.primary.max_sliding_speed.max(r.secondary.max_sliding_speed),
    },
    looked("largest penetration", None, |r| r.primary.max_penetration.max(r.secondary.max_penetration)),
];

#[derive(Default)]
struct Tally {
    designs: usize,
    missed: usize,
    worst: f64,
    stated: usize,
    held: usize,
}

fn main() {
    let numbers: Vec<u64> = std::env::args().filter_map(|argument| argument.parse().ok()).collect();
    let (seed, designs) = (numbers.first().copied().unwrap_or(1), numbers.get(1).copied().unwrap_or(200));
    let demands: Vec<(f64, Order)> = [1e-3, 1e-6, 1e-9]
        .into_iter()
        .flat_map(|tolerance| [(tolerance, Order::Four), (tolerance, Order::Six)])
        .collect();
    let mut tallies: Vec<Vec<Tally>> =
        demands.iter().map(|_| OUTPUTS.iter().map(|_| Tally::default()).collect()).collect();
    let mut lost = vec![0; demands.len()];
    let mut references = 0;
    for index in 0..designs {
        let design = design(seed, index);
        let Ok(case) = case("consistent", &design) else { continue };
        let Ok(reference) = run(&case, &REFERENCE) else { continue };
        references += 1;
        for (at, (tolerance, order)) in demands.iter().enumerate() {
            let options = SolveOptions { tolerance: *tolerance, order: *order, ..SolveOptions::default() };
            let outcome = match run(&case, &options) {
                Ok(outcome) => outcome,
                Err(failure) => {
                    println!("design {index} is lost at {tolerance:.0e}, order {}: {failure}", order.number());
                    println!("   {}", settings(&design));
                    lost[at] += 1;
                    continue;
                }
            };
            for (tally, looked) in tallies[at].iter_mut().zip(&OUTPUTS) {
                let (found, exact) = ((looked.value)(&outcome.result), (looked.value)(&reference.result));
                if !exact.is_finite() {
                    continue;
                }
                let error = (found - exact).abs();
                let relative = error / (looked.scale)(&reference.result).abs();
                tally.designs += 1;
                tally.missed += usize::from(relative > tolerance.max(FLOOR));
                tally.worst = tally.worst.max(relative);
                let stated =
                    looked.uncertainty.and_then(|name| outcome.result.uncertainty.as_ref()?.get(name).copied());
                if let Some(stated) = stated {
                    tally.stated += 1;
                    tally.held += usize::from(error <= WITHIN * stated + FLOOR * exact.abs());
                }
            }
        }
    }
    println!("seed {seed}, {references} designs with a reference");
    println!(
        "| tolerance | order | lost | output | missed | worst | uncertainty holds |\n|---|---|---|---|---|---|---|"
    );
    for (((tolerance, order), tallies), lost) in demands.iter().zip(&tallies).zip(&lost) {
        for (Looked { name, .. }, tally) in OUTPUTS.iter().zip(tallies) {
            println!(
                "| {tolerance:.0e} | {} | {lost} | {name} | {} of {} | {:.1e} | {} |",
                order.number(),
                tally.missed,
                tally.designs,
                tally.worst,
                if tally.stated > 0 { format!("{} of {}", tally.held, tally.stated) } else { "-".to_owned() },
            );
        }
    }
}
