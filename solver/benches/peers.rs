//! This crate beside COLNEW and TWPBVPC, each at its best configuration for the same accuracy reached.
//!
//! ```text
//! git clone https://github.com/cran/bvpSolve                                    the peers' sources, in Fortran
//! BVP_PEERS=bvpSolve/src cargo bench -p sheave-solver --bench peers          prints the tables
//! ... -- --write                                                                and puts them into docs/peers.md
//! ... -- Bratu                                                                  only problems whose names have this
//! ```
//!
//! The sources are compiled here (`gfortran -O2 -march=native`) and loaded; nothing of them is kept. Every code is
//! given the same functions for right-hand sides and derivatives. For every problem and accuracy all configurations
//! of each code are tried: tolerances 1e-3 to 1e-11; orders 4, 6 and 8 from 4, 8 and 16 intervals here, with and
//! without defect correction; 3 to 7 collocation points from 5, 10 and 20 intervals in COLNEW; with and without
//! conditioning in TWPBVPC. The fastest that reaches the accuracy counts, and those three are then timed in turn, the
//! least of nine rounds each. COLNEW solves equations of orders up to 4 as they are, the others the system of first
//! order. Solutions that are not known are computed first, and a peer must find the same. Equations that are singular
//! at an end are solved at Gauss points here, and not by TWPBVPC, which evaluates them there.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a bench fails by panicking")]

#[path = "peers/cases.rs"]
mod cases;
#[path = "peers/codes.rs"]
mod codes;
#[path = "peers/fields.rs"]
mod fields;
#[path = "peers/fortran.rs"]
mod fortran;
#[path = "peers/open.rs"]
mod open;
#[path = "peers/reference.rs"]
mod reference;
#[path = "peers/singular.rs"]
mod singular;
#[path = "peers/system.rs"]
mod system;

use cases::{CASES, Case};
use codes::{Code, Configuration, Run};
use reference::Truth;
use std::fmt::Write as _;
use std::path::PathBuf;

const ACCURACIES: [f64; 2] = [1e-6, 1e-8];
const ROUNDS: usize = 9;
/// Names the folder with the peers' sources.
const VARIABLE: &str = "BVP_PEERS";
const DOCUMENT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/peers.md");
const MARKERS: [&str; 2] = ["<!-- table: begin -->", "<!-- table: end -->"];

/// The fastest configuration of one code that reaches the accuracy.
struct Best {
    configuration: Configuration,
    run: Run,
}

fn best(code: Code, case: &'static Case, truth: &Truth, accuracy: f64) -> Option<Best> {
    let tried = code.configurations(case).into_iter().filter_map(|configuration| {
        let run = code.solve(case, &configuration)?.judged(case, truth);
        (run.error <= accuracy).then_some(Best { configuration, run })
    });
    let mut fit: Vec<Best> = tried.collect();
    fit.sort_by(|a, b| a.run.seconds.total_cmp(&b.run.seconds));
    // The first time of each is rough: the three fastest are timed again.
    fit.truncate(3);
    for best in &mut fit {
        for _ in 0..3 {
            let again = code.solve(case, &best.configuration).map_or(f64::INFINITY, |found| found.seconds);
            best.run.seconds = best.run.seconds.min(again);
        }
    }
    fit.into_iter().min_by(|a, b| a.run.seconds.total_cmp(&b.run.seconds))
}

/// In turn, so that all meet the same machine.
fn time(case: &'static Case, all: &mut [(Code, Option<Best>)]) {
    for _ in 0..ROUNDS {
        for (code, best) in all.iter_mut() {
            let Some(best) = best else { continue };
            if let Some(found) = code.solve(case, &best.configuration) {
                best.run.seconds = best.run.seconds.min(found.seconds);
            }
        }
    }
}

/// `none`: what is said where there is none.
fn cell(best: Option<&Best>, none: &str) -> String {
    best.map_or_else(
        || none.to_owned(),
        |best| {
            let Run { seconds, error, intervals } = best.run;
            let cells = [best.configuration.to_string(), format!("{intervals} ({error:.0e})")];
            format!("{:.3} | {}", 1e3 * seconds, cells.map(unbroken).join(" | "))
        },
    )
}

/// Names up to this length stand on one line.
const SHORT: usize = 16;

/// Set on one line: with spaces and hyphens that no line ends at.
fn unbroken(text: String) -> String {
    text.replace(' ', "\u{a0}").replace('-', "\u{2011}")
}

/// Ratios of this crate's times to a peer's.
struct Ratios {
    name: &'static str,
    all: Vec<(f64, &'static str)>,
    failed: usize,
    /// Problems that the peer alone solves.
    lost: Vec<&'static str>,
}

impl Ratios {
    fn add(&mut self, other: &Self) {
        self.all.extend(&other.all);
        self.failed += other.failed;
        self.lost.extend(&other.lost);
    }

    fn summary(&self) -> String {
        let mean = (self.all.iter().map(|(ratio, _)| ratio.ln()).sum::<f64>() / self.all.len() as f64).exp();
        let worst = self.all.iter().max_by(|a, b| a.0.total_cmp(&b.0));
        let best = self.all.iter().min_by(|a, b| a.0.total_cmp(&b.0));
        let (Some((worst, at)), Some((best, with))) = (worst, best) else { return String::new() };
        let lost = if self.lost.is_empty() { "none".to_owned() } else { self.lost.join(", ") };
        let within = self.all.iter().filter(|(ratio, _)| *ratio <= 2.0).count();
        format!(
            "- {}: geometric mean {mean:.2} of its time over {} problems, at most twice its time on {within} of them; \
             worst {worst:.2} ({at}), best {best:.2} ({with}). It fails on {} more. Problems that it alone solves: \
             {lost}.\n",
            self.name,
            self.all.len(),
            self.failed
        )
    }
}

/// The sets of problems.
const SETS: [(&str, &[Case]); 4] = [
    ("Known solutions", CASES),
    ("Computed solutions", open::CASES),
    ("Other fields", fields::CASES),
    ("Singular ends", singular::CASES),
];
/// How many of them are taken together.
const TOGETHER: usize = 2;

/// A problem, and what errors are measured against.
type Judged = (&'static Case, Truth);

/// The problems of a set whose names have any of those wanted.
fn judged(cases: &'static [Case], names: &[String]) -> Vec<Judged> {
    let wanted = |case: &&Case| names.is_empty() || names.iter().any(|name| case.name.contains(name));
    cases.iter().filter(wanted).map(|case| (case, Truth::of(case))).collect()
}

fn section(accuracy: f64, sets: &[(&str, Vec<Judged>)]) -> String {
    let mut out = format!("### Error at the nodes at most {accuracy:.0e}\n\n");
    let ratios = || ["COLNEW", "TWPBVPC"].map(|name| Ratios { name, all: Vec::new(), failed: 0, lost: Vec::new() });
    let mut together = ratios();
    for (index, (title, cases)) in sets.iter().enumerate() {
        let mut ratios = ratios();
        let _ = write!(
            out,
            "#### {title}\n\n\
             | problem | here, ms | order, tolerance | intervals (error) \
             | COLNEW, ms | points, tolerance | intervals (error) \
             | TWPBVPC, ms | tolerance | intervals (error) |\n\
             |---|---|---|---|---|---|---|---|---|---|\n"
        );
        for (case, truth) in cases {
            out.push_str(&row(case, truth, accuracy, &mut ratios));
        }
        out.push('\n');
        for (ratios, together) in ratios.iter().zip(&mut together) {
            out.push_str(&ratios.summary());
            if index < TOGETHER {
                together.add(ratios);
            }
        }
        out.push('\n');
    }
    out.push_str("The first two sets together:\n\n");
    together.iter().for_each(|ratios| out.push_str(&ratios.summary()));
    out
}

/// One problem's row of the table; its ratios are added to those of each peer.
fn row(case: &'static Case, truth: &Truth, accuracy: f64, ratios: &mut [Ratios; 2]) -> String {
    let mut all = Code::ALL.map(|code| (code, best(code, case, truth, accuracy)));
    time(case, &mut all);
    let [here, colnew, twpbvpc] = &all;
    let cells = [here, colnew, twpbvpc].map(|(code, best)| {
        let is_run = !code.configurations(case).is_empty();
        cell(best.as_ref(), if is_run { "fails | |" } else { "not run | |" })
    });
    // Primes: books set straight quotes as quotation marks.
    let name = case.name.replace("''", "″").replace('\'', "′").replace(" = ", "\u{a0}=\u{a0}");
    let name = if case.name.len() <= SHORT { unbroken(name) } else { name };
    eprintln!("{} | {}", case.name, cells.join(" | "));
    for (ratios, (_, peer)) in ratios.iter_mut().zip([colnew, twpbvpc]) {
        match (&here.1, peer) {
            (Some(here), Some(peer)) => ratios.all.push((here.run.seconds / peer.run.seconds, case.name)),
            (_, None) => ratios.failed += 1,
            (None, Some(_)) => ratios.lost.push(case.name),
        }
    }
    format!("| {name} | {} |\n", cells.join(" | "))
}

fn main() -> std::io::Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| argument != "--bench").collect();
    let (flags, names): (Vec<_>, Vec<_>) = arguments.into_iter().partition(|argument| argument.starts_with("--"));
    let Some(folder) = std::env::var_os(VARIABLE).map(PathBuf::from) else {
        eprintln!("not run: {VARIABLE} is not set to the folder with the peers' sources (see the head of {})", file!());
        return Ok(());
    };
    fortran::load(&folder).map_err(std::io::Error::other)?;
    let sets = SETS.map(|(title, cases)| (title, judged(cases, &names)));
    let tables = ACCURACIES.map(|accuracy| section(accuracy, &sets)).join("\n");
    let text = format!("Measured on: {}.\n\n{tables}", processor());
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
    let avx512 = if all.contains("avx512f") { ", with AVX-512" } else { "" };
    format!("{name}, family {family}, model {model}{avx512}, one core")
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
