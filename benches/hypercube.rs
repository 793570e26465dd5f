//! A Latin hypercube of 2,000 designs, in three editions or those named, each from a cold start: the share solved, and
//! of the others whether they have a solution at all, which their slip limit tells.
//! `cargo bench --bench hypercube [-- DESIGNS EDITION ...]`.

use sheave::case::{Case, Resolved};
use sheave::design::{Limit, LimitKind, LimitOptions, smallest_clamps};
use sheave::drive::SolveOptions;
use sheave::random::Random;
use sheave::result::run;

const SLACK_TENSION: &str = "operating_point.slack_tension";

/// Key, from, to, and whether the logarithm is uniform.
const AXES: [(&str, f64, f64, bool); 9] = [
    ("drive.ratio", 0.6, 2.0, false),
    (SLACK_TENSION, 30.0, 800.0, true),
    ("operating_point.primary_torque", 1.0, 30.0, false),
    ("operating_point.primary_speed", 104.7, 628.3, false),
    ("belt.bending_stiffness", 0.02, 0.6, true),
    ("sheave.half_angle", 0.1396, 0.3142, false),
    ("sheave.friction_coefficient", 0.25, 0.55, false),
    ("belt.longitudinal_stiffness", 1e5, 4e5, false),
    ("sheave.slip_threshold", 1e-5, 1e-2, true),
];

/// `designs` points, one in each of `designs` slices of every axis.
fn hypercube(designs: usize) -> Vec<Vec<(&'static str, f64)>> {
    let mut stream = Random::new(2018);
    let columns = AXES.map(|(key, from, to, log)| {
        let mut order: Vec<usize> = (0..designs).collect();
        for i in (1..designs).rev() {
            order.swap(i, (stream.bits() % (i as u64 + 1)) as usize);
        }
        order
            .into_iter()
            .map(|slice| {
                let u = (slice as f64 + stream.uniform()) / designs as f64;
                (key, if log { from * (to / from).powf(u) } else { from + (to - from) * u })
            })
            .collect::<Vec<_>>()
    });
    (0..designs).map(|i| columns.iter().map(|column| column[i]).collect()).collect()
}

/// What became of a design.
enum Fate {
    /// Solved, in so many seconds.
    Solved(f64),
    /// Its slack tension lies below the smallest that carries its torque: there is nothing to solve.
    BeyondLimit(String),
    /// A solution exists, or may exist, and was not found.
    Failed(String),
}

const TOLERANCE: f64 = 1e-4;
/// The last only when it is named: without bending, most slip thresholds of the hypercube are out of its reach.
const EDITIONS: [&str; 4] = ["published", "thesis", "consistent", "string"];

fn case(edition: &str, point: &[(&str, f64)]) -> Result<Resolved, String> {
    let mut case = Case::default();
    let mut set = |key: &str, value: &str| case.set(key, value).map_err(|error| error.to_string());
    set("edition", edition)?;
    for (key, value) in point {
        set(key, &value.to_string())?;
        if *key == "sheave.half_angle" {
            let stiffness = 18.71e6 * value.tan() / 12f64.to_radians().tan();
            set("belt.radial_stiffness", &stiffness.to_string())?;
        }
    }
    case.resolve().map_err(|error| error.to_string())
}

fn fate(edition: &str, point: &[(&'static str, f64)]) -> Fate {
    let solve = SolveOptions { tolerance: TOLERANCE, ..SolveOptions::default() };
    let resolved = match case(edition, point) {
        Ok(resolved) => resolved,
        Err(refusal) => return Fate::Failed(format!("refused: {refusal}")),
    };
    let failure = match run(&resolved, &solve) {
        Ok(outcome) => return Fate::Solved(outcome.result.solver.wall_time.unwrap_or_default()),
        Err(failure) => failure,
    };
    let given = point.iter().find(|(key, _)| *key == SLACK_TENSION).map_or(f64::NAN, |(_, value)| *value);
    match smallest_clamps(&resolved, &LimitOptions { solve, least_speed_efficiency: 0.0 }) {
        Ok((limits, _)) => {
            let Limit { value, kind, .. } = limits.slack_tension;
            let told = format!("limit {value:.2} N ({})", kind.name());
            match kind {
                LimitKind::Fold | LimitKind::Collapse if given < value => Fate::BeyondLimit(told),
                _ => Fate::Failed(format!("{told}: {failure}")),
            }
        }
        Err(error) => Fate::Failed(format!("{failure}; its limit: {error}")),
    }
}

fn main() {
    let designs = std::env::args().filter_map(|argument| argument.parse().ok()).next().unwrap_or(2000);
    let named: Vec<String> = std::env::args().filter(|argument| EDITIONS.contains(&argument.as_str())).collect();
    let editions = if named.is_empty() { EDITIONS[..3].to_vec() } else { named.iter().map(String::as_str).collect() };
    for edition in editions {
        let (mut beyond, mut time) = (0, Vec::new());
        for (index, point) in hypercube(designs).into_iter().enumerate() {
            let what = match fate(edition, &point) {
                Fate::Solved(seconds) => {
                    time.push(seconds);
                    continue;
                }
                Fate::BeyondLimit(why) => {
                    beyond += 1;
                    format!("beyond its {why}")
                }
                Fate::Failed(why) => format!("FAILED, {why}"),
            };
            let values: Vec<String> = point
                .iter()
                .map(|(key, value)| format!("{}={value:.4e}", key.rsplit('.').next().unwrap_or(key)))
                .collect();
            println!("{edition} {index} {what}\n    {}", values.join(" "));
        }
        time.sort_by(f64::total_cmp);
        let quantile = |q: f64| time.get(((time.len() as f64 - 1.0) * q) as usize).copied().unwrap_or(f64::NAN) * 1e3;
        let (solved, solvable) = (time.len(), designs - beyond);
        println!(
            "{edition}: {solved} of {designs} solved, {beyond} beyond their slip limit, {} failed: {:.2} % of the \
             others; time median {:.1} ms, 95 % {:.1} ms, longest {:.1} ms",
            solvable - solved,
            100.0 * solved as f64 / solvable as f64,
            quantile(0.5),
            quantile(0.95),
            quantile(1.0)
        );
    }
}
