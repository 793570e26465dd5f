//! What the commands about designs share: one case, or a grid of them.

use super::case::CaseArguments;
use super::output;
use super::solve::jobs;
use super::stop::Stop;
use clap::Args;
use sheave::design::DesignError;
use sheave::drive::{Failure, SolveOptions, WORK_LIMIT};
use sheave::plot::Figure;
use sheave::study::{Axis, Format, Study, StudyError, Table};
use std::num::NonZeroUsize;
use std::path::PathBuf;

/// A case, and what varies in it.
#[derive(Debug, Args)]
pub struct GridArguments {
    #[command(flatten)]
    case: CaseArguments,
    /// Relative tolerance of the solutions, from 1e-12 to 0.1
    #[arg(long, value_name = "T", default_value = "1e-6", value_parser = super::solve::tolerance)]
    tol: f64,
    /// Work that each solution may take: Newton iterations, each counted once for every mesh interval
    #[arg(long, value_name = "N", default_value_t = WORK_LIMIT, value_parser = super::solve::work_limit)]
    work_limit: usize,
    /// Print the result as one JSON object
    #[arg(long, conflicts_with = "over")]
    json: bool,
    /// Vary a key: KEY=FROM..TO[:N] (11 points if N is not given) or KEY=A,B,C; joined by & keys go together
    #[arg(long, value_name = "KEY=VALUES")]
    over: Vec<String>,
    /// Write map.csv and figures (SVG, PNG) into this folder; without it, CSV goes to standard output
    #[arg(long, value_name = "DIR", requires = "over")]
    out: Option<PathBuf>,
    /// Threads [default: all cores]
    #[arg(long, value_name = "N", value_parser = jobs, requires = "over")]
    jobs: Option<NonZeroUsize>,
}

impl GridArguments {
    pub fn case(&self) -> &CaseArguments {
        &self.case
    }

    pub fn options(&self) -> SolveOptions {
        SolveOptions { tolerance: self.tol, work_limit: self.work_limit, ..SolveOptions::default() }
    }

    pub fn json(&self) -> bool {
        self.json
    }

    pub fn is_grid(&self) -> bool {
        !self.over.is_empty()
    }

    pub fn jobs(&self) -> Option<usize> {
        self.jobs.map(NonZeroUsize::get)
    }

    pub fn study(&self, options: SolveOptions) -> Result<Study, Stop> {
        let axes = self.over.iter().map(|over| Axis::parse(over)).collect::<Result<Vec<_>, StudyError>>()?;
        if let Some(folder) = &self.out {
            output::create_folder(folder)?;
        }
        Ok(Study::new(self.case.read()?, axes, options)?)
    }

    /// The table, and the figures that `draw` makes of it.
    pub fn deliver(&self, study: &Study, table: &Table, draw: fn(&Study, &Table) -> Vec<Figure>) -> Result<(), Stop> {
        match table.failures() {
            0 => {}
            failures => tracing::warn!("{failures} of {} points have no answer; see `failure`", table.rows.len()),
        }
        match &self.out {
            None => {
                let mut text = Vec::new();
                let written = Format::Csv.write(table, &mut text);
                written.map_err(|error| Stop::Write("CSV".into(), error))?;
                output::print(&String::from_utf8_lossy(&text))?;
            }
            Some(folder) => {
                output::write_file(folder, "map.csv", |to| Format::Csv.write(table, to))?;
                output::write_figures(folder, &draw(study, table))?;
            }
        }
        if table.failures() < table.rows.len() {
            return Ok(());
        }
        Err(Stop::Unreached(format!("none of the {} points has an answer; see `failure`", table.rows.len())))
    }
}

/// Why there is no answer.
pub fn stop(error: DesignError) -> Stop {
    if let DesignError::Start(Failure::Cancelled) = error {
        return Stop::Cancelled;
    }
    if error.is_bad_input() { Stop::Usage(error.to_string()) } else { Stop::NoSolution(error.to_string()) }
}
