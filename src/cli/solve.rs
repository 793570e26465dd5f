//! `sheave solve`: one case, one result.

use super::case::CaseArguments;
use super::output;
use super::stop::Stop;
use clap::Args;
use serde::Serialize;
use sheave::case::{CaseError, Key, Resolved};
use sheave::drive::{Failure, SolveOptions};
use sheave::result::{Outcome, SCHEMA, run as solve, summary, warnings, write_profile};
use solver::Order;
use std::io;
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
    /// Order of the collocation: 4 or 6
    #[arg(long, value_name = "4|6", default_value = "4", value_parser = order)]
    order: Order,
    /// Find the clamp that leaves this share of the friction at hand in reserve, in place of the case's clamp: 20%
    #[arg(long, value_name = "R")]
    reserve: Option<String>,
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

/// What stands in the place of a result that could not be had.
#[derive(Debug, Serialize)]
struct Failed<'a> {
    schema: u32,
    #[serde(skip_serializing_if = "Option::is_none")]
    edition: Option<&'static str>,
    converged: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    inputs: Option<&'a Resolved>,
    failure: &'a str,
}

pub fn run(arguments: &Arguments) -> Result<(), Stop> {
    let case = arguments.resolve().map_err(|error| arguments.refused(error))?;
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
        ..SolveOptions::default()
    };
    match solve(&case, &options) {
        Ok(outcome) => arguments.deliver(&outcome),
        Err(failure) => Err(arguments.failed(&case, &failure)),
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
        for warning in warnings(outcome) {
            tracing::warn!("{warning}");
        }
        if self.json {
            return output::print(&output::json(&outcome.result)?);
        }
        if let Some(folder) = &self.out {
            write_result(folder, &output::json(&outcome.result)?)?;
            output::write_file(folder, "profile.csv", |to| write_profile(outcome, to).map_err(io::Error::from))?;
            let figures = sheave::plot::drive(outcome)?;
            output::write_figures(folder, &figures)?;
            let page = sheave::report::page(outcome, &figures)?;
            output::write_file(folder, "report.html", |to| to.write_all(page.as_bytes()))?;
        }
        output::print(&summary(&outcome.result))
    }

    /// Bad input: whoever asked for JSON gets an object, too.
    fn refused(&self, error: CaseError) -> Stop {
        let failure = error.to_string();
        let failed = Failed { schema: SCHEMA, edition: None, converged: false, inputs: None, failure: &failure };
        let printed = if self.json { output::json(&failed).and_then(|text| output::print(&text)) } else { Ok(()) };
        printed.err().unwrap_or(Stop::Input(error))
    }

    /// No solution: the object says so where the result would have stood.
    fn failed(&self, case: &Resolved, failure: &Failure) -> Stop {
        let (reason, bad_input) = (failure.to_string(), failure.is_bad_input());
        let failure = reason.as_str();
        let edition = Some(case.edition.name());
        let failed = Failed { schema: SCHEMA, edition, converged: false, inputs: Some(case), failure };
        let told = output::json(&failed).and_then(|text| match &self.out {
            Some(folder) => write_result(folder, &text),
            None if self.json => output::print(&text),
            None => Ok(()),
        });
        let stop = if bad_input { Stop::Usage } else { Stop::NoSolution };
        told.err().unwrap_or_else(|| stop(reason.clone()))
    }
}

fn write_result(folder: &Path, text: &str) -> Result<(), Stop> {
    output::write_file(folder, "result.json", |writer| writer.write_all(text.as_bytes()))
}

pub(super) fn tolerance(text: &str) -> Result<f64, String> {
    let within = |tolerance: &f64| (1e-12..=1e-1).contains(tolerance);
    text.parse().ok().filter(within).ok_or_else(|| "expected a number from 1e-12 to 1e-1, such as 1e-6".into())
}

fn order(text: &str) -> Result<Order, String> {
    match text {
        "4" => Ok(Order::Four),
        "6" => Ok(Order::Six),
        _ => Err("expected 4 or 6".into()),
    }
}
