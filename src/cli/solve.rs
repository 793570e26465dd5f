//! `sheave solve`: one case, one result.

use super::case::CaseArguments;
use super::envelope;
use super::output;
use super::stop::Stop;
use clap::Args;
use serde::Serialize;
use sheave::case::{CaseError, Clamp, Key, Resolved};
use sheave::design::{Verdict, verdict};
use sheave::drive::{Branch, Failure, SolveOptions, WORK_LIMIT};
use sheave::quantity::{Dimension, parse};
use sheave::result::{
    FailureKind, FailureReport, Outcome, Units, run_on_branch as solve, summary_in, warnings, write_profile,
};
use solver::Order;
use std::io;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

/// Solve one case
///
/// Prints a summary in engineering units, or with --json one JSON object in SI units. The object of a case that
/// could not be solved has `"converged": false` and its reason under `failure`.
#[derive(Debug, Args)]
#[command(after_long_help = super::keys::table() + "\n" + super::STATUS)]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// Relative tolerance of the solution, from 1e-12 to 0.1
    #[arg(long, value_name = "T", default_value = "1e-6", value_parser = tolerance)]
    tol: f64,
    /// Order of the collocation: 4, 6 or 8
    #[arg(long, value_name = "4|6|8", default_value = "4", value_parser = order)]
    order: Order,
    /// Find the clamp that leaves this share of the friction at hand in reserve, in place of the case's clamp: 20%
    #[arg(long, value_name = "R")]
    reserve: Option<String>,
    /// Units of the summary: workshop (N, mm, rpm), si (N, m, rad/s) or us (lbf, in, rpm, hp); JSON is in SI always
    #[arg(long, value_name = "U", default_value = "workshop", value_parser = units)]
    units: Units,
    /// Where an axial force is given that belongs to two operating points: the tighter belt, or the looser
    #[arg(long, value_name = "WHICH", default_value = "tight", value_parser = ["tight", "loose"])]
    branch: String,
    /// Work that the search may take, and that for the reason where there is no solution as much again: Newton
    /// iterations, each counted once for every mesh interval
    #[arg(long, value_name = "N", default_value_t = WORK_LIMIT, value_parser = work_limit)]
    work_limit: usize,
    /// Print the result as one JSON object
    #[arg(long, conflicts_with = "out")]
    json: bool,
    /// Write result.json, profile.csv, figures (SVG, PNG) and report.html into this folder, and print the summary
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Add the derivatives of the outputs with respect to every given constant to the object
    #[arg(long)]
    sensitivities: bool,
}

/// What is known of a case that could not be solved.
#[derive(Debug, Serialize)]
struct Unsolved<'a> {
    edition: &'static str,
    inputs: &'a Resolved,
}

pub fn run(arguments: &Arguments) -> Result<(), Stop> {
    let case = arguments.resolve()?;
    if arguments.sensitivities && !arguments.json && arguments.out.is_none() {
        tracing::warn!(
            "--sensitivities adds to the object that --json prints and --out writes: without either it shows nothing"
        );
    }
    if let Some(folder) = &arguments.out {
        // Before the work: a folder that cannot be had makes it worthless.
        output::create_folder(folder)?;
    }
    let options = SolveOptions {
        tolerance: arguments.tol,
        order: arguments.order,
        sensitivities: arguments.sensitivities,
        uncertainty: true,
        work_limit: arguments.work_limit,
    };
    let wanted = if arguments.branch == Branch::Loose.name() { Branch::Loose } else { Branch::Tight };
    match solve(&case, wanted, &options) {
        Ok(outcome) => arguments.deliver(&outcome),
        Err(failure) => Err(arguments.failed(&case, &failure, &options)),
    }
}

impl Arguments {
    fn resolve(&self) -> Result<Resolved, CaseError> {
        let mut case = self.case.read()?;
        if let Some(reserve) = &self.reserve {
            case.make_room(&[Key::SlipReserve]);
            case.set(Key::SlipReserve.path(), reserve)?;
        }
        CaseArguments::check(&case)
    }

    fn deliver(&self, outcome: &Outcome) -> Result<(), Stop> {
        let mut warnings = warnings(outcome);
        let only = matches!(
            outcome.result.inputs.operating_point.clamp,
            Clamp::PrimaryAxialForce(_) | Clamp::SecondaryAxialForce(_)
        ) && outcome.result.other_solution.is_none();
        if self.branch == Branch::Loose.name() {
            warnings
                .extend(only.then(|| "Only one operating point was found for this axial force: this one.".to_owned()));
        }
        // With --json they are in the object, for people on standard error, too; the summary has them itself.
        if self.json {
            warnings.iter().for_each(|warning| tracing::warn!("{warning}"));
        }
        let json = || envelope::object("solve", &outcome.result.inputs, &warnings, &outcome.result);
        if self.json {
            return output::print(&json()?);
        }
        if let Some(folder) = &self.out {
            write_result(folder, &json()?)?;
            output::write_file(folder, "profile.csv", |to| write_profile(outcome, to).map_err(io::Error::from))?;
            let figures = sheave::plot::drive(outcome)?;
            output::write_figures(folder, &figures)?;
            let page = sheave::report::page(outcome, &figures)?;
            output::write_file(folder, "report.html", |to| to.write_all(page.as_bytes()))?;
        }
        output::print(&summary_in(self.units, &warnings, &outcome.result))
    }

    /// No solution: the object says so where the result would have stood.
    fn failed(&self, case: &Resolved, failure: &Failure, options: &SolveOptions) -> Stop {
        let stop = Stop::from(failure);
        let Stop::NoSolution(mut message) = stop else { return self.unsolved(case, stop.failure(), stop) };
        let mut hint = failure.hint().map(str::to_owned);
        match verdict(case, failure, options) {
            // The message says so already.
            Verdict::Pushed | Verdict::Open => {}
            proof => {
                message = format!("no solution: {proof}");
                hint = Some("clamp the belt tighter or ask for less torque; `sheave limit` has all limits".to_owned());
            }
        }
        let said = hint.iter().fold(message.clone(), |said, hint| format!("{said}\nwhat to try: {hint}"));
        self.unsolved(case, FailureReport { kind: FailureKind::NoSolution, message, hint }, Stop::NoSolution(said))
    }

    fn unsolved(&self, case: &Resolved, report: FailureReport, stop: Stop) -> Stop {
        let known = Unsolved { edition: case.edition.name(), inputs: case };
        if let Some(folder) = self.out.as_ref().filter(|folder| folder.join("report.html").exists()) {
            tracing::warn!("report.html, the figures and profile.csv in {} are of an earlier run", folder.display());
        }
        let told = match &self.out {
            Some(folder) => envelope::failure("solve", &known, &report).and_then(|text| write_result(folder, &text)),
            None if self.json => envelope::tell("solve", &known, &report),
            None => Ok(()),
        };
        told.err().unwrap_or(stop)
    }
}

fn write_result(folder: &Path, text: &str) -> Result<(), Stop> {
    output::write_file(folder, "result.json", |writer| writer.write_all(text.as_bytes()))
}

pub(super) fn tolerance(text: &str) -> Result<f64, String> {
    let within = |tolerance: &f64| (1e-12..=1e-1).contains(tolerance);
    text.parse().ok().filter(within).ok_or_else(|| "expected a number from 1e-12 to 1e-1, such as 1e-6".into())
}

/// A share with or without `%`.
pub(super) fn share(text: &str) -> Result<f64, String> {
    let read = parse(text).and_then(|quantity| quantity.expect(Dimension::NONE));
    read.map_err(|error| format!("{error}; expected a share such as 0.3 or 30%"))
}

/// A number of threads.
pub(super) fn jobs(text: &str) -> Result<NonZeroUsize, String> {
    text.parse().map_err(|_| "expected a whole number of threads, from 1".into())
}

pub(super) fn units(text: &str) -> Result<Units, String> {
    Units::by_name(text).ok_or_else(|| "expected workshop, si or us".into())
}

pub(super) fn work_limit(text: &str) -> Result<usize, String> {
    let positive = |limit: &usize| *limit > 0;
    text.parse().ok().filter(positive).ok_or_else(|| "expected a whole number above 0, such as 2250000".into())
}

fn order(text: &str) -> Result<Order, String> {
    match text {
        "4" => Ok(Order::Four),
        "6" => Ok(Order::Six),
        "8" => Ok(Order::Eight),
        _ => Err("expected 4, 6 or 8".into()),
    }
}
