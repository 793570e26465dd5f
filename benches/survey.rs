//! A survey of drives from scooters to snowmobiles, each solved from nothing: the share that is solved, what becomes of
//! the others, and what it costs. `cargo bench --bench survey -- SEED DESIGNS [EDITION ...] [from=I] [only=I,J]`.
//!
//! A design that is not solved is classified by proof: its geometry is refused; or its slack tension lies below the
//! least that carries its torque, to which the drive was followed from a tighter belt (a fold of the branch, or the
//! collapse of the secondary's speed). What is left is named as failed.

use sheave::case::{Case, Resolved};
use sheave::design::{LimitKind, LimitOptions, smallest_clamps};
use sheave::drive::{Route, SolveOptions, solve};
use sheave::random::Random;
use std::collections::BTreeMap;

const SLACK_TENSION: &str = "operating_point.slack_tension";
const TORQUE: &str = "operating_point.primary_torque";
const EDITIONS: [&str; 4] = ["consistent", "thesis", "published", "string"];
const TOLERANCE: f64 = 1e-3;
/// Newton iterations that each solve of a proof may take.
const PROOF_WORK: usize = 3000;
/// Least radius of a design, m: that of a scooter's primary.
const LEAST_RADIUS: f64 = 0.018;

/// Key, from, to, and whether the logarithm is uniform.
const AXES: [(&str, f64, f64, bool); 11] = [
    ("belt.longitudinal_stiffness", 5e4, 8e5, true),
    ("belt.bending_stiffness", 0.005, 1.5, true),
    ("belt.radial_stiffness", 5e6, 60e6, true),
    ("belt.mass_per_length", 0.1, 1.0, true),
    ("sheave.half_angle", 0.139_626, 0.349_066, false),
    ("sheave.friction_coefficient", 0.2, 0.7, false),
    ("sheave.slip_threshold", 1e-5, 1e-2, true),
    ("operating_point.primary_speed", 31.4159, 942.478, false),
    (TORQUE, -40.0, 60.0, false),
    (SLACK_TENSION, 20.0, 1500.0, true),
    ("drive.center_distance", 0.15, 0.35, false),
];

/// A design: keys and values in SI.
type Design = Vec<(&'static str, f64)>;

fn value(design: &Design, key: &str) -> f64 {
    design.iter().find(|(other, _)| *other == key).map_or(f64::NAN, |(_, value)| *value)
}

/// The design `index` of a seed: radii of a ratio from 0.4 to 3.5 that stand apart.
fn design(seed: u64, index: u64) -> Design {
    let mut stream = Random::new(seed.wrapping_mul(0x2545_f491_4f6c_dd1d) ^ index);
    let mut design: Design = AXES.map(|(key, from, to, log)| (key, stream.between(from, to, log))).to_vec();
    let center = design.last().map_or(0.0, |(_, center)| *center);
    let (primary, secondary) = loop {
        let ratio = stream.between(0.4, 3.5, true);
        let sum = center * stream.between(0.45, 0.85, false);
        let (primary, secondary) = (sum / (1.0 + ratio), sum * ratio / (1.0 + ratio));
        if primary.min(secondary) >= LEAST_RADIUS {
            break (primary, secondary);
        }
    };
    design.push(("drive.primary_radius", primary));
    design.push(("drive.secondary_radius", secondary));
    // The tension of the axis is that of the looser strand, which in engine braking is not the one that leaves the
    // primary.
    let torque = value(&design, TORQUE);
    if let Some((_, tension)) = design.iter_mut().find(|(key, _)| *key == SLACK_TENSION) {
        *tension += (-torque / primary).max(0.0);
    }
    // The belt that closes.
    let slope = ((secondary - primary) / center).asin();
    let spans = 2.0 * center * slope.cos();
    let arcs = std::f64::consts::PI * (primary + secondary) + 2.0 * slope * (secondary - primary);
    design.push(("belt.length", spans + arcs));
    design
}

/// What became of a design.
enum Fate {
    /// Solved, with so many Newton iterations, on that route.
    Solved(usize, &'static str),
    /// Its slack tension lies below the smallest that carries its torque: there is nothing to solve.
    BeyondLimit(String),
    /// The geometry is refused.
    Geometry(String),
    /// A solution exists, or may exist, and was not found.
    Failed(String),
}

fn case(edition: &str, design: &Design) -> Result<Resolved, String> {
    let mut case = Case::default();
    case.set("edition", edition).map_err(|error| error.to_string())?;
    for (key, value) in design {
        case.set(key, &value.to_string()).map_err(|error| error.to_string())?;
    }
    case.resolve().map_err(|error| error.to_string())
}

fn fate(edition: &str, design: &Design, prove: bool) -> Fate {
    let options = SolveOptions { tolerance: TOLERANCE, ..SolveOptions::default() };
    let resolved = match case(edition, design) {
        Ok(resolved) => resolved,
        Err(refusal) => return Fate::Geometry(refusal),
    };
    let failure = match solve(&resolved, &options) {
        Ok(solved) => return Fate::Solved(solved.stats.newton_iterations, solved.route.map_or("", Route::name)),
        Err(failure) => failure,
    };
    if !prove {
        return Fate::Failed(failure.to_string());
    }
    let given = value(design, SLACK_TENSION);
    let options = SolveOptions { work_limit: PROOF_WORK, ..options };
    match smallest_clamps(&resolved, &LimitOptions { solve: options, least_speed_efficiency: 0.0 }) {
        Ok((limits, _)) => {
            let limit = limits.slack_tension;
            let told = format!("limit {:.2} N ({})", limit.value, limit.kind.name());
            match limit.kind {
                LimitKind::Fold | LimitKind::Collapse if given < limit.value => Fate::BeyondLimit(told),
                _ => Fate::Failed(format!("{told}: {failure}")),
            }
        }
        Err(error) => Fate::Failed(format!("{failure}; its limit: {error}")),
    }
}

/// As options of the command line.
fn settings(design: &Design) -> String {
    design.iter().map(|(key, value)| format!("--set {key}={value:.6e}")).collect::<Vec<_>>().join(" ")
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| argument != "--bench").collect();
    let numbers: Vec<u64> = arguments.iter().filter_map(|argument| argument.parse().ok()).collect();
    let (seed, designs) = (numbers.first().copied().unwrap_or(1), numbers.get(1).copied().unwrap_or(200));
    let option = |name: &str| arguments.iter().find_map(|argument| argument.strip_prefix(name).map(str::to_owned));
    let from: u64 = option("from=").and_then(|from| from.parse().ok()).unwrap_or(0);
    let only: Option<Vec<u64>> = option("only=").map(|list| list.split(',').filter_map(|i| i.parse().ok()).collect());
    let prove = !arguments.iter().any(|argument| argument == "unproved");
    let named: Vec<&str> = EDITIONS.into_iter().filter(|edition| arguments.iter().any(|a| a == edition)).collect();
    let editions = if named.is_empty() { EDITIONS[..3].to_vec() } else { named };
    for edition in editions {
        let mut routes = BTreeMap::new();
        let (mut beyond, mut refused, mut failed, mut work) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for index in only.clone().unwrap_or_else(|| (from..from + designs).collect()) {
            let design = design(seed, index);
            match fate(edition, &design, prove) {
                Fate::Solved(iterations, route) => {
                    if only.is_some() {
                        println!("{edition} {index} solved in {iterations} Newton iterations by the route {route:?}");
                    }
                    *routes.entry(route).or_insert(0) += 1;
                    work.push((iterations, index));
                    continue;
                }
                Fate::BeyondLimit(why) => {
                    println!("{edition} {index} beyond its slip limit: {why}");
                    beyond.push(index);
                }
                Fate::Geometry(why) => {
                    println!("{edition} {index} refused: {why}");
                    refused.push(index);
                }
                Fate::Failed(why) => {
                    println!("{edition} {index} FAILED: {why}");
                    failed.push(index);
                }
            }
            println!("    {}", settings(&design));
        }
        println!("routes: {routes:?}");
        work.sort_unstable();
        let all = work.len() + beyond.len() + refused.len() + failed.len();
        let quantile = |q: f64| work.get(((work.len() as f64 - 1.0) * q) as usize).map_or(0, |(work, _)| *work);
        let solvable = work.len() + failed.len();
        println!(
            "| {edition} | seed {seed} | {all} designs | {} solved | {} beyond the slip limit | {} refused | {} failed | \
             {:.2} % | Newton iterations {} median, {} 99 %, {} worst (design {}) |",
            work.len(),
            beyond.len(),
            refused.len(),
            failed.len(),
            100.0 * work.len() as f64 / solvable as f64,
            quantile(0.5),
            quantile(0.99),
            quantile(1.0),
            work.last().map_or(0, |(_, index)| *index),
        );
        println!("failed: {failed:?}\nbeyond the slip limit: {beyond:?}\nrefused: {refused:?}");
    }
}
