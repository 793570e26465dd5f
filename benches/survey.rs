//! A survey of drives from scooters to snowmobiles, each solved from nothing: the share that is solved, what becomes of
//! the others, and what it costs. `cargo bench --bench survey -- SEED DESIGNS [EDITION ...] [from=I] [only=I,J]
//! [work=N] [unproved] [solved]`.
//!
//! A design that is not solved is classified by proof: its geometry is refused; or its slack tension lies below the
//! least that carries its torque, to which the drive was followed from a tighter belt (a fold of the branch, or the
//! collapse of the secondary's speed). What is left is named as failed.
//!
//! With `solved`, the proofs are put to the test: designs that are solved are handed to them as if they were not, and
//! none may be found to lie beyond a limit.

use sheave::design::{Verdict, verdict};
use sheave::drive::{Constant, Failure, Question, Route, SolveOptions, Trouble, WORK_LIMIT, solve};
use std::collections::BTreeMap;
use std::time::Instant;

mod designs;
use designs::{Design, case, design, settings};

const EDITIONS: [&str; 4] = ["consistent", "thesis", "published", "string"];
const TOLERANCE: f64 = 1e-3;
/// Slip threshold at which the counts are split, m/s.
const SPLIT: f64 = 1e-4;
/// What became of a design.
enum Fate {
    /// Solved, with so many Newton iterations, on that route.
    Solved(usize, &'static str),
    /// Its slack tension lies below the smallest that carries its torque: there is nothing to solve.
    BeyondLimit(String),
    /// The belt is pressed through its groove.
    Sunk(String),
    /// The geometry is refused.
    Geometry(String),
    /// A solution exists, or may exist, and was not found.
    Failed(String),
}

/// What a proof says of a design that is solved, if it is said to have no solution: a proof that is wrong.
fn refuted(edition: &str, design: &Design) -> Option<String> {
    let resolved = case(edition, design).ok()?;
    let constants = Question::of(&resolved).constants;
    let failure = Failure::Lost {
        trouble: Trouble::Unknown,
        torque: constants[Constant::PrimaryTorque],
        slip_threshold: constants[Constant::SlipThreshold],
        slack_tension: constants[Constant::SlackTension],
        cause: Box::new(solver::SolveError::Cancelled),
    };
    let options = SolveOptions { tolerance: TOLERANCE, ..SolveOptions::default() };
    match verdict(&resolved, &failure, &options) {
        Verdict::Open => None,
        wrong => Some(wrong.to_string()),
    }
}

/// Designs of small and of larger slip thresholds, each by what became of them: solved, beyond a limit, failed.
#[derive(Default)]
struct Split([[usize; 3]; 2]);

impl Split {
    fn count(&mut self, design: &Design, fate: &Fate) {
        let fate = match fate {
            Fate::Solved(..) => 0,
            Fate::BeyondLimit(_) | Fate::Sunk(_) => 1,
            Fate::Failed(_) => 2,
            Fate::Geometry(_) => return,
        };
        let small = design.iter().any(|(key, value)| *key == "sheave.slip_threshold" && *value < SPLIT);
        self.0[usize::from(small)][fate] += 1;
    }
}

fn fate(edition: &str, design: &Design, work_limit: usize, prove: bool) -> Fate {
    let options = SolveOptions { tolerance: TOLERANCE, work_limit, ..SolveOptions::default() };
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
    match verdict(&resolved, &failure, &options) {
        proof @ (Verdict::Tension { .. } | Verdict::Torque { .. } | Verdict::Pushed) => {
            Fate::BeyondLimit(proof.to_string())
        }
        sunk @ Verdict::Sunk { .. } => Fate::Sunk(sunk.to_string()),
        open => {
            let words = failure.solver().map_or(String::new(), ToString::to_string);
            Fate::Failed(format!("{failure}; {open}; the solver says: {words}"))
        }
    }
}

/// Of values in order, the one that a share of them do not exceed.
fn at_share<T>(ordered: &[T], share: f64) -> Option<&T> {
    ordered.get((ordered.len().saturating_sub(1) as f64 * share) as usize)
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| argument != "--bench").collect();
    let numbers: Vec<u64> = arguments.iter().filter_map(|argument| argument.parse().ok()).collect();
    let (seed, designs) = (numbers.first().copied().unwrap_or(1), numbers.get(1).copied().unwrap_or(200));
    let option = |name: &str| arguments.iter().find_map(|argument| argument.strip_prefix(name).map(str::to_owned));
    let from: u64 = option("from=").and_then(|from| from.parse().ok()).unwrap_or(0);
    let only: Option<Vec<u64>> = option("only=").map(|list| list.split(',').filter_map(|i| i.parse().ok()).collect());
    let work_limit: usize = option("work=").and_then(|work| work.parse().ok()).unwrap_or(WORK_LIMIT);
    let prove = !arguments.iter().any(|argument| argument == "unproved");
    let test_proofs = arguments.iter().any(|argument| argument == "solved");
    let named: Vec<&str> = EDITIONS.into_iter().filter(|edition| arguments.iter().any(|a| a == edition)).collect();
    let editions = if named.is_empty() { EDITIONS[..3].to_vec() } else { named };
    for edition in editions {
        let mut routes = BTreeMap::new();
        let (mut sunk, mut split, mut wrong) = (Vec::new(), Split::default(), Vec::new());
        let mut times = [Vec::new(), Vec::new()];
        let (mut beyond, mut refused, mut failed, mut work) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for index in only.clone().unwrap_or_else(|| (from..from + designs).collect()) {
            let design = design(seed, index);
            let begun = Instant::now();
            let fate = fate(edition, &design, work_limit, prove);
            let seconds = begun.elapsed().as_secs_f64();
            times[usize::from(!matches!(fate, Fate::Solved(..)))].push((seconds, index));
            split.count(&design, &fate);
            match fate {
                Fate::Solved(iterations, route) => {
                    if only.is_some() {
                        println!("{edition} {index} solved in {iterations} Newton iterations by the route {route:?}");
                    }
                    *routes.entry(route).or_insert(0) += 1;
                    work.push((iterations, index));
                    if test_proofs && let Some(proof) = refuted(edition, &design) {
                        println!("{edition} {index} is solved, and WRONGLY said to have no solution: {proof}");
                        println!("    {}", settings(&design));
                        wrong.push(index);
                    }
                    continue;
                }
                Fate::BeyondLimit(why) => {
                    println!("{edition} {index} beyond its slip limit: {why}");
                    beyond.push(index);
                }
                Fate::Sunk(why) => {
                    println!("{edition} {index} pressed through its groove: {why}");
                    sunk.push(index);
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
        let all = work.len() + beyond.len() + sunk.len() + refused.len() + failed.len();
        let quantile = |q: f64| at_share(&work, q).map_or(0, |(work, _)| *work);
        let solvable = work.len() + failed.len();
        println!(
            "| {edition} | seed {seed} | {all} designs | {} solved | {} beyond the slip limit | {} pressed through | \
             {} refused | {} failed | {:.2} % | Newton iterations {} median, {} 99 %, {} worst (design {}) |",
            work.len(),
            beyond.len(),
            sunk.len(),
            refused.len(),
            failed.len(),
            100.0 * work.len() as f64 / solvable as f64,
            quantile(0.5),
            quantile(0.99),
            quantile(1.0),
            work.last().map_or(0, |(_, index)| *index),
        );
        println!(
            "failed: {failed:?}\nbeyond the slip limit: {beyond:?}\npressed through: {sunk:?}\nrefused: {refused:?}"
        );
        for (which, [solved, beyond, failed]) in ["of at least", "below"].into_iter().zip(split.0) {
            println!(
                "slip thresholds {which} {SPLIT:.0e} m/s: {solved} solved, {beyond} beyond a limit, {failed} failed"
            );
        }
        for (what, mut times) in ["that are solved", "that are not, proofs included"].into_iter().zip(times) {
            times.sort_unstable_by(|(one, _), (other, _)| one.total_cmp(other));
            if let [Some((median, _)), Some((most, _)), Some((worst, index))] =
                [0.5, 0.99, 1.0].map(|q| at_share(&times, q))
            {
                println!(
                    "seconds for designs {what}: {median:.3} median, {most:.3} 99 %, {worst:.3} worst (design {index})"
                );
            }
        }
        if test_proofs {
            println!("of {} that are solved, said to have no solution: {wrong:?}", work.len());
        }
    }
}
