//! The whole test set at moderate and hard parameters, as a Markdown table, beside scipy.integrate.solve_bvp.
//!
//! ```text
//! cargo bench -p sheave-solver --bench testset                       prints the tables
//! cargo bench -p sheave-solver --bench testset -- --write            and puts them into docs/testset.md
//! cargo bench -p sheave-solver --bench testset -- T28 NERVE          only these
//! ```
//!
//! SciPy is run by `$TESTSET_PYTHON`, else `python3`, if that can import scipy; without it its columns say n/a.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a bench fails by panicking")]

// The tests use the same problems, each its own part.
#[allow(dead_code)]
#[path = "../tests/testset/problems/mod.rs"]
mod problems;

use problems::catalogue::Case;
use problems::folds::{BRATU, NON};
use problems::run::{How, errors, kappa, obstacle, run};
use serde_json::Value;
use solver::{Options, Order};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::process::Command;
use std::time::Instant;

const TOLERANCE: f64 = 1e-6;
/// The other tolerance that the work to it is counted for.
const TIGHT: f64 = 1e-9;
/// Repetitions stop after this many seconds.
const PATIENCE: f64 = 0.1;
const REPETITIONS: usize = 7;
const ORDERS: [Order; 3] = [Order::Four, Order::Six, Order::Eight];
/// Place in `ORDERS` of the one whose condition is shown and whose time is compared with SciPy's.
const SHOWN: usize = 1;
const DOCUMENT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/testset.md");
const MARKERS: [&str; 2] = ["<!-- table: begin -->", "<!-- table: end -->"];

/// One problem at one parameter by one order.
struct Cell {
    how: How,
    /// Why the direct solve failed, or the continuation too.
    reason: Option<String>,
    solved: Option<Solved>,
    seconds: f64,
}

struct Solved {
    error: f64,
    intervals: usize,
    kappa: f64,
    /// The solver's own estimate of its error.
    estimate: f64,
    /// Which of several solutions it is.
    solution: Option<String>,
}

struct Row {
    label: String,
    parameter: Option<f64>,
    /// In the order of `ORDERS`.
    orders: [Cell; ORDERS.len()],
}

fn measure(case: &Case, parameter: Option<f64>, order: Order) -> Cell {
    let options = Options { order, tolerance: TOLERANCE, ..Options::default() };
    let start = Instant::now();
    let mut outcome = run(case, parameter, &options);
    for _ in 1..REPETITIONS {
        if start.elapsed().as_secs_f64() > PATIENCE {
            break;
        }
        outcome.seconds = outcome.seconds.min(run(case, parameter, &options).seconds);
    }
    let reason = outcome.solution.as_ref().err().cloned();
    let reason = reason.or_else(|| (outcome.how != How::Direct).then(|| obstacle(case, parameter, &options)).flatten());
    let solved = outcome.solution.ok().map(|solution| {
        let errors = errors(case, parameter, &solution);
        Solved {
            error: if errors.everywhere.is_nan() { f64::NAN } else { errors.everywhere.max(errors.tabulated) },
            intervals: solution.intervals(),
            kappa: kappa(case, &solution),
            estimate: solution.error_estimate(),
            solution: errors.solution,
        }
    });
    Cell { how: outcome.how, reason, solved, seconds: outcome.seconds }
}

/// SciPy's records by label and parameter; empty without Python.
fn scipy(ids: &[String]) -> BTreeMap<(String, String), Value> {
    let python = std::env::var("TESTSET_PYTHON").unwrap_or_else(|_| "python3".to_owned());
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/benches/testset_scipy.py");
    // Its matrices are small: several threads of their library would only slow it down.
    let output = Command::new(&python).env("OPENBLAS_NUM_THREADS", "1").arg(script).arg("run").args(ids).output();
    let records: Vec<Value> = match output {
        Ok(output) if output.status.success() => serde_json::from_slice(&output.stdout).unwrap_or_default(),
        _ => {
            eprintln!("{python} cannot run {script}: SciPy's columns are n/a (set TESTSET_PYTHON)");
            Vec::new()
        }
    };
    let key = |record: &Value| {
        let label = record["variant"].as_str().or(record["id"].as_str()).unwrap_or_default();
        (label.to_owned(), shown(record["parameter"].as_f64()))
    };
    records.into_iter().map(|record| (key(&record), record)).collect()
}

/// The parameter, short.
fn shown(parameter: Option<f64>) -> String {
    parameter.map_or_else(String::new, |p| {
        let plain = format!("{p}");
        if plain.len() <= 6 { plain } else { format!("{p:.1e}") }
    })
}

fn milliseconds(seconds: f64) -> String {
    let ms = 1e3 * seconds;
    if ms < 10.0 { format!("{ms:.2}") } else { format!("{ms:.0}") }
}

fn verdict(error: f64) -> String {
    if error <= 10.0 * TOLERANCE { format!("{error:.0e}") } else { format!("**{error:.0e}**") }
}

/// Error, intervals and time, with the way where that is not the direct one.
fn cell(cell: &Cell) -> String {
    let time = milliseconds(cell.seconds);
    let time = match cell.how {
        How::Direct => time,
        How::Continued(steps) => format!("{time} ({steps} steps)"),
        How::Deformed(points) => format!("{time} ({points} points)"),
    };
    match &cell.solved {
        None => format!("**failed** | | {time}"),
        Some(Solved { error, intervals, .. }) => format!("{} | {intervals} | {time}", verdict(*error)),
    }
}

fn scipy_cell(record: Option<&Value>) -> String {
    let Some(record) = record else { return "n/a | |".to_owned() };
    let status = record["status"].as_str().unwrap_or_default();
    let time = record["seconds"].as_f64().map_or_else(String::new, milliseconds);
    let nodes = record["nodes"].as_u64().map_or_else(String::new, |nodes| nodes.to_string());
    match record["error"].as_f64() {
        Some(error) => format!("{} | {nodes} | {time}", verdict(error)),
        None => format!("{} | {nodes} | {time}", status.trim_start_matches("failed: ")),
    }
}

fn table(rows: &[Row], scipy: &BTreeMap<(String, String), Value>) -> String {
    let mut out = String::from(
        "| problem | parameter | κ | order 4: error | intervals | ms | order 6: error | intervals | ms \
         | order 8: error | intervals | ms | SciPy: error | nodes | ms |\n\
         |---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n",
    );
    for row in rows {
        let kappa =
            row.orders[SHOWN].solved.as_ref().map_or_else(String::new, |solved| format!("{:.0e}", solved.kappa));
        let peer = scipy.get(&(row.label.clone(), shown(row.parameter)));
        let solution = row.orders[SHOWN].solved.as_ref().and_then(|solved| solved.solution.as_deref());
        let label = match solution {
            Some(name) if name != row.label => format!("{} ({name})", row.label),
            _ => row.label.clone(),
        };
        let parameter = shown(row.parameter);
        let ours = row.orders.iter().map(cell).collect::<Vec<_>>().join(" | ");
        let _ = writeln!(out, "| {label} | {parameter} | {kappa} | {ours} | {} |", scipy_cell(peer));
    }
    out
}

fn folds() -> String {
    let mut out = String::from(
        "| fold | parameter | relative error | largest u | slope at 0 | intervals | ms \
        |\n|---|---|---|---|---|---|---|\n",
    );
    for fold in [BRATU, NON] {
        let start = Instant::now();
        let found = fold.locate();
        let seconds = start.elapsed().as_secs_f64();
        let ([parameter, peak, slope], reference) = (found.values(), fold.reference());
        let error = (parameter - reference[0]).abs() / reference[0];
        let (intervals, time) = (found.0.intervals(), milliseconds(seconds));
        let id = fold.id;
        let _ =
            writeln!(out, "| {id} | {parameter:.10} | {error:.0e} | {peak:.9} | {slope:.9} | {intervals} | {time} |");
    }
    out
}

/// Counts, and the comparison of times where both solved directly.
fn summary(rows: &[Row], scipy: &BTreeMap<(String, String), Value>) -> String {
    let mut out = format!("{} runs (problem × parameter × guess) at a tolerance of {TOLERANCE:.0e}.\n\n", rows.len());
    for (index, order) in ORDERS.into_iter().enumerate() {
        let cells = || rows.iter().map(|row| (row, &row.orders[index]));
        let direct = cells().filter(|(_, cell)| cell.solved.is_some() && cell.how == How::Direct).count();
        let continued = cells().filter(|(_, cell)| cell.solved.is_some()).count() - direct;
        let list = |named: Vec<String>| if named.is_empty() { "none".to_owned() } else { named.join(", ") };
        let name_of = |row: &Row| format!("{} {}", row.label, shown(row.parameter)).trim_end().to_owned();
        let failed = list(cells().filter(|(_, cell)| cell.solved.is_none()).map(|(row, _)| name_of(row)).collect());
        let inexact = cells().filter_map(|(row, cell)| {
            let Solved { error, estimate, .. } = cell.solved.as_ref()?;
            let good = *error <= 10.0 * TOLERANCE;
            (!good).then(|| format!("{} ({error:.0e}; the solver's own estimate {estimate:.0e})", name_of(row)))
        });
        let inexact = list(inexact.collect());
        let _ = writeln!(
            out,
            "- Order {}: {direct} solved directly, {continued} by continuation; failed: {failed}; error above 10 × \
            tolerance: {inexact}.",
            order.number()
        );
    }
    let mut ratios: Vec<f64> = rows
        .iter()
        .filter_map(|row| {
            let peer = scipy.get(&(row.label.clone(), shown(row.parameter)))?;
            peer["error"].as_f64()?;
            Some(peer["seconds"].as_f64()? / row.orders[SHOWN].seconds)
        })
        .collect();
    ratios.sort_by(f64::total_cmp);
    if let Some(median) = ratios.get(ratios.len() / 2) {
        let failures = scipy.values().filter(|record| record["error"].is_null()).count();
        let _ = writeln!(
            out,
            "- SciPy: {failures} of {} runs fail directly; where it succeeds it takes {median:.0} times as long as \
            order 6 (median; {:.0} to {:.0}).",
            scipy.len(),
            ratios[0],
            ratios[ratios.len() - 1]
        );
    }
    out
}

/// What the runs take to a moderate and to a tight tolerance: points of evaluation and intervals.
fn work(ids: &[String]) -> String {
    let mut out = String::from("| | order 4 | order 6 | order 8 |\n|---|---|---|---|\n");
    for tolerance in [TOLERANCE, TIGHT] {
        let mut lines = [(); 3].map(|()| format!("| tolerance {tolerance:.0e}: "));
        let names = ["evaluations, geometric mean", "intervals, sum", "runs refused"];
        lines.iter_mut().zip(names).for_each(|(line, name)| line.push_str(name));
        for order in ORDERS {
            let options = Options { order, tolerance, ..Options::default() };
            let cases = problems::cases();
            let runs = cases.iter().filter(|case| ids.is_empty() || ids.iter().any(|id| id == case.id));
            let runs = runs.flat_map(|case| case.parameters().into_iter().map(move |parameter| (case, parameter)));
            let outcomes: Vec<_> = runs.map(|(case, parameter)| run(case, parameter, &options).solution).collect();
            let solved: Vec<_> = outcomes.iter().flatten().collect();
            let logarithms = solved.iter().map(|solution| (solution.stats().points() as f64).ln()).sum::<f64>();
            let intervals: usize = solved.iter().map(|solution| solution.intervals()).sum();
            let mean = (logarithms / solved.len().max(1) as f64).exp();
            let values = [format!("{mean:.0}"), intervals.to_string(), (outcomes.len() - solved.len()).to_string()];
            lines.iter_mut().zip(values).for_each(|(line, value)| {
                let _ = write!(line, " | {value}");
            });
        }
        let _ = writeln!(out, "{} |", lines.join(" |\n"));
    }
    out
}

fn reasons(rows: &[Row]) -> String {
    let mut out = String::new();
    for row in rows {
        for (order, cell) in ORDERS.into_iter().zip(&row.orders) {
            if let Some(reason) = &cell.reason {
                let order = order.number();
                let outcome = if cell.solved.is_some() { "not directly" } else { "failed" };
                let _ = writeln!(out, "- {} {}, order {order}, {outcome}: {reason}", row.label, shown(row.parameter));
            }
        }
    }
    out
}

fn write(text: &str) -> std::io::Result<()> {
    let old = std::fs::read_to_string(DOCUMENT)?;
    let [begin, end] = MARKERS.map(|marker| old.find(marker));
    let (Some(begin), Some(end)) = (begin, end) else {
        return Err(std::io::Error::other(format!("{DOCUMENT} has no markers {MARKERS:?}")));
    };
    let head = &old[..begin + MARKERS[0].len()];
    std::fs::write(DOCUMENT, format!("{head}\n\n{text}\n{}", &old[end..]))
}

fn main() -> std::io::Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| argument != "--bench").collect();
    let (flags, ids): (Vec<_>, Vec<_>) = arguments.into_iter().partition(|argument| argument.starts_with("--"));
    let rows: Vec<Row> = problems::cases()
        .iter()
        .filter(|case| ids.is_empty() || ids.iter().any(|id| id == case.id))
        .flat_map(|case| case.parameters().into_iter().map(move |parameter| (case, parameter)))
        .map(|(case, parameter)| Row {
            label: case.label(),
            parameter,
            orders: ORDERS.map(|order| measure(case, parameter, order)),
        })
        .collect();
    let scipy = scipy(&ids);
    let text = format!("{}\n{}\n{}\n{}", summary(&rows, &scipy), work(&ids), table(&rows, &scipy), folds());
    println!("{text}\n{}", reasons(&rows));
    if flags.iter().any(|flag| flag == "--write") { write(&text) } else { Ok(()) }
}
