//! Branches traced here and by AUTO-07p, each at its best configuration for the same accuracy of what is located.
//!
//! ```text
//! apt-get install auto-07p gfortran                          AUTO, as Debian packages it, and a Fortran compiler
//! cargo bench -p sheave-solver --bench auto                  prints the tables
//! ... -- --write                                             and puts them into docs/auto.md
//! ... -- exp                                                 only problems whose names have this
//! ```
//!
//! AUTO is looked for in the folder that `AUTO_DIR` names, then where Debian puts it. Equations are written here for
//! it, with their derivatives; `gfortran -O2` compiles and links them once, which no time includes. Its time is what it
//! prints as its total time, less that of a run of the same program that ends with the first point. For every problem
//! and accuracy all configurations of both are tried, the fastest that reaches the accuracy counts, and the two are
//! then timed in turn, the least of many rounds each.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a bench fails by panicking")]

#[path = "auto/demos.rs"]
mod demos;
#[path = "auto/here.rs"]
mod here;
#[path = "auto/peer.rs"]
mod peer;

use demos::{DEMOS, Demo};
use peer::Auto;
use std::fmt::Write as _;

const ACCURACIES: [f64; 3] = [1e-6, 1e-8, 1e-10];
const ROUNDS: usize = 25;
const DOCUMENT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/auto.md");
const MARKERS: [&str; 2] = ["<!-- table: begin -->", "<!-- table: end -->"];

/// What a run brought.
#[derive(Debug, Clone, Copy)]
pub struct Run {
    /// Computing time.
    pub seconds: f64,
    /// Largest relative error of what is located.
    pub error: f64,
    /// Points of the branch, located ones included.
    pub points: usize,
}

/// The fastest configuration that reaches the accuracy.
struct Best<C> {
    configuration: C,
    run: Run,
}

/// From what each configuration has brought.
fn best<C: Copy>(tried: &[(C, Run)], accuracy: f64, again: impl Fn(&C) -> Option<Run>) -> Option<Best<C>> {
    let fit = tried.iter().filter(|(_, run)| run.error <= accuracy);
    let mut fit: Vec<Best<C>> = fit.map(|&(configuration, run)| Best { configuration, run }).collect();
    fit.sort_by(|a, b| a.run.seconds.total_cmp(&b.run.seconds));
    // The first time of each is rough: the fastest are timed again.
    fit.truncate(16);
    for best in &mut fit {
        for _ in 0..5 {
            best.run.seconds =
                best.run.seconds.min(again(&best.configuration).map_or(f64::INFINITY, |run| run.seconds));
        }
    }
    fit.into_iter().min_by(|a, b| a.run.seconds.total_cmp(&b.run.seconds))
}

fn tried<C: Copy>(all: Vec<C>, run: impl Fn(&C) -> Option<Run>) -> Vec<(C, Run)> {
    let twice = |configuration: C| {
        let (first, second) = (run(&configuration)?, run(&configuration)?);
        Some((configuration, Run { seconds: first.seconds.min(second.seconds), ..first }))
    };
    all.into_iter().filter_map(twice).collect()
}

fn rows(demo: &'static Demo, auto: &Auto) -> String {
    let program = auto.program(demo).unwrap_or_else(|error| panic!("{}: {error}", demo.name));
    let reference = here::reference(demo).unwrap_or_else(|| panic!("{}: no reference", demo.name));
    eprintln!("{}: {reference:?}", demo.name);
    let ours = tried(here::configurations(demo), |configuration| here::run(demo, configuration, &reference));
    let theirs = tried(peer::configurations(demo), |configuration| program.run(configuration, &reference));
    let mut out = String::new();
    for accuracy in ACCURACIES {
        let mut here = best(&ours, accuracy, |configuration| here::run(demo, configuration, &reference));
        let mut peer = best(&theirs, accuracy, |configuration| program.run(configuration, &reference));
        // In turn, so that both meet the same machine.
        if let (Some(here), Some(peer)) = (&mut here, &mut peer) {
            for _ in 0..ROUNDS {
                let again = here::run(demo, &here.configuration, &reference).map_or(f64::INFINITY, |run| run.seconds);
                here.run.seconds = here.run.seconds.min(again);
                let again = program.run(&peer.configuration, &reference).map_or(f64::INFINITY, |run| run.seconds);
                peer.run.seconds = peer.run.seconds.min(again);
            }
        }
        let ratio = match (&here, &peer) {
            (Some(here), Some(peer)) => format!("{:.2}", here.run.seconds / peer.run.seconds),
            _ => String::new(),
        };
        let [here, peer] = [cell(here.as_ref()), cell(peer.as_ref())];
        // No line ends within a number.
        let row =
            format!("| `{}` | {accuracy:.0e} | {here} | {peer} | {ratio} |", demo.name).replace("e-", "e\u{2011}");
        eprintln!("{row}");
        let _ = writeln!(out, "{row}");
    }
    out
}

fn cell<C: std::fmt::Display>(best: Option<&Best<C>>) -> String {
    best.map_or_else(
        || "not reached | | |".to_owned(),
        |Best { configuration, run }| {
            format!("{:.2} | {configuration} | {} ({:.0e})", 1e3 * run.seconds, run.points, run.error)
        },
    )
}

fn main() -> std::io::Result<()> {
    let (bench, arguments): (Vec<String>, Vec<String>) = std::env::args().skip(1).partition(|a| a == "--bench");
    if bench.is_empty() {
        // As a test this would take minutes.
        return Ok(());
    }
    let (flags, names): (Vec<_>, Vec<_>) = arguments.into_iter().partition(|argument| argument.starts_with("--"));
    let auto = match Auto::found() {
        Ok(auto) => auto,
        Err(missing) => {
            eprintln!("not run: {missing}");
            return Ok(());
        }
    };
    let mut text = "| demo | accuracy | here, ms | how | points (error) | AUTO, ms | how | points (error) | ratio \
                    |\n|---|---|---|---|---|---|---|---|---|\n"
        .to_owned();
    for demo in DEMOS.iter().filter(|demo| names.is_empty() || names.iter().any(|name| demo.name.contains(name))) {
        text += &rows(demo, &auto);
    }
    let text = format!("Measured on: {}.\n\n{text}", processor());
    println!("{text}");
    if flags.iter().any(|flag| flag == "--write") { write(&text) } else { Ok(()) }
}

/// The machine, as Linux names it.
fn processor() -> String {
    let all = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let field = |name: &str| {
        let line = all.lines().find(|line| line.starts_with(name))?;
        Some(line.split_once(':')?.1.trim().to_owned())
    };
    let fields = ["model name", "cpu family", "model"].map(|name| field(name).unwrap_or_else(|| "unknown".to_owned()));
    let [name, family, model] = fields;
    format!("{name}, family {family}, model {model}, one core")
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
