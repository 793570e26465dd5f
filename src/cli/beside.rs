//! `sheave beside`: two cases side by side.

use super::envelope;
use super::output;
use super::stop::Stop;
use clap::Args;
use serde::Serialize;
use sheave::case::{Case, Key, Resolved};
use sheave::drive::SolveOptions;
use sheave::result::{DriveResult, Units, beside, run as solve, warnings};
use std::path::{Path, PathBuf};

/// Solve two cases and show them side by side, with their differences
///
/// Without a second file, the second case is the first with what --set and --edition change:
/// sheave beside --set operating_point.slack_tension="150 N"
#[derive(Debug, Args)]
#[command(after_long_help = super::STATUS)]
pub struct Arguments {
    /// Case file of the first; without one, the built-in base case
    #[arg(value_name = "FIRST.toml")]
    first: Option<PathBuf>,
    /// Case file of the second; without one, the first
    #[arg(value_name = "SECOND.toml")]
    second: Option<PathBuf>,
    /// Set a key of the second case
    #[arg(long = "set", value_name = "KEY=VALUE", allow_hyphen_values = true)]
    set: Vec<String>,
    /// Edition of the equations of the second case
    #[arg(long, value_name = "E", value_parser = super::case::edition_parser())]
    edition: Option<String>,
    /// Relative tolerance of the solutions, from 1e-12 to 0.1
    #[arg(long, value_name = "T", default_value = "1e-6", value_parser = super::solve::tolerance)]
    tol: f64,
    /// Units of the table: workshop, si or us
    #[arg(long, value_name = "U", default_value = "workshop", value_parser = super::solve::units)]
    units: Units,
    /// Print both results as one JSON object
    #[arg(long)]
    json: bool,
}

#[derive(Debug, Serialize)]
struct Both<'a> {
    first: &'a DriveResult<Resolved>,
    second: &'a DriveResult<Resolved>,
}

pub fn run(arguments: &Arguments) -> Result<(), Stop> {
    let read = |path: Option<&Path>| path.map_or_else(|| Ok(Case::base()), Case::read);
    let first = read(arguments.first.as_deref())?;
    let mut second = match &arguments.second {
        Some(path) => Case::read(path)?,
        None => first.clone(),
    };
    let key = |assignment: &String| Key::from_path(assignment.split('=').next().unwrap_or_default().trim());
    second.make_room(&arguments.set.iter().filter_map(key).collect::<Vec<Key>>());
    arguments.set.iter().try_for_each(|assignment| second.assign(assignment))?;
    if let Some(edition) = &arguments.edition {
        second.set(Key::Edition.path(), edition)?;
    }
    let options = SolveOptions { tolerance: arguments.tol, ..SolveOptions::default() };
    let solved = |case: &Case| -> Result<_, Stop> {
        let case = super::case::CaseArguments::check(case)?;
        solve(&case, &options).map_err(|failure| Stop::from(&failure))
    };
    let (first, second) = (solved(&first)?, solved(&second)?);
    let said: Vec<String> = [("first", &first), ("second", &second)]
        .into_iter()
        .flat_map(|(name, outcome)| warnings(outcome).into_iter().map(move |warning| format!("{name}: {warning}")))
        .collect();
    said.iter().for_each(|warning| tracing::warn!("{warning}"));
    let both = Both { first: &first.result, second: &second.result };
    if arguments.json {
        return output::print(&envelope::object("beside", &first.result.inputs, &said, &both)?);
    }
    output::print(&beside(arguments.units, ["first", "second"], [both.first, both.second]))
}
