//! A Latin hypercube of 2,000 designs, every edition, each from a cold start: the share solved, and what became of the
//! others. `cargo bench --bench hypercube [-- DESIGNS]`.

use std::collections::BTreeMap;

use sheave::case::Case;
use sheave::drive::{Failure, SolveOptions};
use sheave::result::run;

/// Key, from, to, and whether the logarithm is uniform.
const AXES: [(&str, f64, f64, bool); 9] = [
    ("drive.ratio", 0.6, 2.0, false),
    ("operating_point.slack_tension", 30.0, 800.0, true),
    ("operating_point.primary_torque", 1.0, 30.0, false),
    ("operating_point.primary_speed", 104.7, 628.3, false),
    ("belt.bending_stiffness", 0.02, 0.6, true),
    ("sheave.half_angle", 0.1396, 0.3142, false),
    ("sheave.friction_coefficient", 0.25, 0.55, false),
    ("belt.longitudinal_stiffness", 1e5, 4e5, false),
    ("sheave.slip_threshold", 1e-5, 1e-2, true),
];

/// A deterministic stream of 64-bit numbers (SplitMix64).
struct Stream(u64);

impl Stream {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// `designs` points, one in each of `designs` slices of every axis.
fn hypercube(designs: usize) -> Vec<Vec<(&'static str, f64)>> {
    let mut stream = Stream(2018);
    let columns = AXES.map(|(key, from, to, log)| {
        let mut order: Vec<usize> = (0..designs).collect();
        for i in (1..designs).rev() {
            order.swap(i, (stream.next() % (i as u64 + 1)) as usize);
        }
        order
            .into_iter()
            .map(|slice| {
                let u = (slice as f64 + stream.unit()) / designs as f64;
                (key, if log { from * (to / from).powf(u) } else { from + (to - from) * u })
            })
            .collect::<Vec<_>>()
    });
    (0..designs).map(|i| columns.iter().map(|column| column[i]).collect()).collect()
}

fn main() {
    let designs = std::env::args().filter_map(|argument| argument.parse().ok()).next().unwrap_or(2000);
    for edition in ["published", "thesis", "consistent"] {
        let (mut solved, mut failures, mut time) = (0, BTreeMap::<&str, usize>::new(), Vec::new());
        for (index, point) in hypercube(designs).into_iter().enumerate() {
            let mut case = Case::default();
            let set = |case: &mut Case, key: &str, value: f64| case.set(key, &value.to_string());
            let mut refused = case.set("edition", edition).is_err();
            for (key, value) in &point {
                refused |= set(&mut case, key, *value).is_err();
                if *key == "sheave.half_angle" {
                    refused |=
                        set(&mut case, "belt.radial_stiffness", 18.71e6 * value.tan() / 12f64.to_radians().tan())
                            .is_err();
                }
            }
            let Some(resolved) = case.resolve().ok().filter(|_| !refused) else {
                *failures.entry("refused").or_default() += 1;
                continue;
            };
            let start = std::time::Instant::now();
            let outcome = run(&resolved, &SolveOptions { tolerance: 1e-4, ..SolveOptions::default() });
            let seconds = start.elapsed().as_secs_f64();
            match outcome {
                Ok(outcome) => {
                    solved += 1;
                    time.push(outcome.result.solver.wall_time);
                }
                Err(failure) => {
                    let kind = match failure {
                        Failure::Start(_) => "start",
                        Failure::Lost { .. } => "lost",
                        _ => "other",
                    };
                    *failures.entry(kind).or_default() += 1;
                    let values: Vec<String> = point
                        .iter()
                        .map(|(key, value)| format!("{}={value:.4e}", key.rsplit('.').next().unwrap_or(key)))
                        .collect();
                    println!("{edition} {index} ({seconds:.2} s): {failure}\n    {}", values.join(" "));
                }
            }
        }
        time.sort_by(f64::total_cmp);
        let quantile = |q: f64| time.get(((time.len() as f64 - 1.0) * q) as usize).copied().unwrap_or(f64::NAN) * 1e3;
        println!(
            "{edition}: {solved} of {designs} solved ({:.2} %), failures {failures:?}, time median {:.1} ms, 95 % {:.1} ms, longest {:.1} ms",
            100.0 * solved as f64 / designs as f64,
            quantile(0.5),
            quantile(0.95),
            quantile(1.0)
        );
    }
}
