//! `sheave map`: what a belt does over ratio, torque, speed and clamp, as a table with a known error.

use super::case::CaseArguments;
use super::envelope;
use super::keeping::{self, Keeping};
use super::output;
use super::solve::{jobs, share};
use super::stop::Stop;
use clap::Args;
use serde::Serialize;
use sheave::beltmap::{BeltMap, ErrorReport, MapAxis, MapError, MapFormat, MapOptions, MapPlan, Report};
use sheave::drive::SolveOptions;
use std::fmt::Write as _;
use std::io;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

/// Map a belt over ratio, torque, speed and clamp, as a table that others interpolate in
///
/// Solves a grid whose breakpoints lie as close as the accuracy asks for, and in every cell one point more, which
/// measures the error of interpolation. The table has forces, torques, speed loss, slip margin, radii and losses with
/// their exact derivatives; nodes beyond the slip limit are marked and cells that touch them have no values.
#[derive(Debug, Args)]
#[command(after_long_help = super::STATUS)]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// An axis of the map: KEY=FROM..TO, or KEY=FROM..TO:N and KEY=A,B,C for its first breakpoints. ratio, torque,
    /// speed and clamp stand for drive.ratio, operating_point.primary_torque, .primary_speed and .secondary_axial_force
    #[arg(long, value_name = "KEY=FROM..TO", required = true)]
    over: Vec<String>,
    /// Largest error of interpolation: of forces, torques and radii over their size, of shares as they are
    #[arg(long, value_name = "E", default_value_t = MapOptions::default().accuracy)]
    accuracy: f64,
    /// Relative tolerance of the solutions [default: a hundredth of the accuracy]
    #[arg(long, value_name = "T", value_parser = super::solve::tolerance)]
    tol: Option<f64>,
    /// Points to solve at most, nodes and check points; a map that would need more is written as it is
    #[arg(long, value_name = "N", default_value_t = MapOptions::default().max_points)]
    max_points: usize,
    /// Count the drive as slipping below this speed efficiency, from 0 to 1, unless a fifth of the friction at hand is
    /// left: sunk into its groove at a ratio of 3, a belt that does not slip has 0.94
    #[arg(long, value_name = "S", default_value_t = MapOptions::default().least_speed_efficiency, value_parser = share)]
    least_speed_efficiency: f64,
    /// Threads, no more of which are started than there are cores [default: all cores]
    #[arg(long, value_name = "N", value_parser = jobs)]
    jobs: Option<NonZeroUsize>,
    /// Write the map into this file: .csv, .parquet or .nc (NetCDF). Points are kept as they come in FILE.journal
    /// beside it until the map is whole. Without it, CSV goes to standard output
    #[arg(long, value_name = "FILE", value_parser = map_path)]
    out: Option<PathBuf>,
    /// Go on with a map that was ended: points in FILE.journal are not solved again
    #[arg(long, requires = "out")]
    resume: bool,
    /// Print how accurate the map is, and what it is of, as one JSON object
    #[arg(long, requires = "out")]
    json: bool,
}

/// What the command tells of a map.
#[derive(Debug, Serialize, schemars::JsonSchema)]
pub struct Told<'a> {
    axes: Vec<AxisTold>,
    quantities: Vec<&'static str>,
    #[serde(flatten)]
    report: &'a Report,
    file: String,
}

/// An axis of a map, SI.
#[derive(Debug, Serialize, schemars::JsonSchema)]
struct AxisTold {
    key: &'static str,
    from: f64,
    to: f64,
    breakpoints: usize,
}

pub fn run(arguments: &Arguments) -> Result<(), Stop> {
    let out = arguments.out.as_deref().map(output::place).transpose()?;
    let plan = arguments.plan()?;
    let keeping = match &out {
        Some(path) => Keeping::begin(path, &plan, arguments.resume)?,
        None => Keeping::nameless(&plan)?,
    };
    let map = plan.build(&keeping).map_err(stop)?;
    keeping.finish();
    let report = map.report();
    let mut warnings = warnings(report);
    match &out {
        None => {
            let written = MapFormat::Csv.write(&map, &mut io::stdout());
            written.map_err(|error| Stop::Write("standard output".into(), error))?;
        }
        Some(path) => {
            let format = MapFormat::of(path).unwrap_or(MapFormat::Csv);
            let aside = keeping::deliver(path, |to| format.write(&map, to))?;
            warnings.extend(aside);
            keeping.remove()?;
            arguments.tell(&plan, &map, path, &warnings)?;
        }
    }
    if !arguments.json {
        warnings.iter().for_each(|warning| tracing::warn!("{warning}"));
    }
    unreached(report).map_or(Ok(()), Err)
}

/// Why a map is not what was asked for.
fn unreached(report: &Report) -> Option<Stop> {
    let message = || {
        format!(
            "the map is written, and its error is {:.2e}, above {:.2e}: {} points did not suffice; give a larger \
             --accuracy or --max-points, or a smaller range",
            report.error.largest,
            report.accuracy,
            report.nodes + report.checks,
        )
    };
    (!report.reached).then(|| Stop::Unreached(message()))
}

/// What a user of the map ought to know.
fn warnings(report: &Report) -> Vec<String> {
    let mut warnings = Vec::new();
    let without = report.cells - report.usable_cells;
    if without > 0 {
        warnings.push(format!(
            "{without} of {} cells have no values: the belt slips at a corner ({} of {} nodes), has no solution there \
             ({}) or no drive ({})",
            report.cells, report.slipping, report.nodes, report.unsolved, report.no_drive
        ));
    }
    warnings
}

/// A map's error as a command's.
pub fn stop(error: MapError) -> Stop {
    match error {
        MapError::Case(error) => Stop::Input(error),
        MapError::Study(error) => error.into(),
        MapError::Internal(error) => error.into(),
        error @ MapError::Empty { .. } => Stop::NoSolution(error.to_string()),
        other => Stop::Usage(other.to_string()),
    }
}

impl Arguments {
    fn plan(&self) -> Result<MapPlan, Stop> {
        let axes = self.over.iter().map(|over| MapAxis::parse(over)).collect::<Result<Vec<_>, _>>().map_err(stop)?;
        let solve = SolveOptions { tolerance: self.tol.unwrap_or(0.01 * self.accuracy), ..SolveOptions::default() };
        let options = MapOptions {
            accuracy: self.accuracy,
            solve,
            max_points: self.max_points,
            least_speed_efficiency: self.least_speed_efficiency,
            jobs: self.jobs.map(NonZeroUsize::get),
        };
        MapPlan::new(self.case.read()?, axes, options).map_err(stop)
    }

    /// Prints what the map is; as an object that says what failed, too, where it is not accurate enough.
    fn tell(&self, plan: &MapPlan, map: &BeltMap, path: &Path, warnings: &[String]) -> Result<(), Stop> {
        if !self.json {
            return output::print(&summary(map, path));
        }
        let axis = |axis: &MapAxis| {
            let (from, to) = axis.range();
            AxisTold { key: axis.key().path(), from, to, breakpoints: axis.len() }
        };
        let told = Told {
            axes: map.axes().iter().map(axis).collect(),
            quantities: map.quantities().iter().map(|quantity| quantity.name()).collect(),
            report: map.report(),
            file: path.display().to_string(),
        };
        match unreached(map.report()) {
            None => output::print(&envelope::object("map", plan.case(), warnings, &told)?),
            Some(stop) => envelope::tell("map", &told, &stop.failure()),
        }
    }
}

fn summary(map: &BeltMap, path: &Path) -> String {
    let report = map.report();
    let mut text =
        format!("Belt map, edition {}\n\n", map.inputs().get("edition").and_then(|name| name.as_str()).unwrap_or(""));
    // Writing to a string cannot fail.
    for axis in map.axes() {
        let entry = axis.key().entry();
        let ((from, unit), (to, _)) = (entry.readable(axis.range().0), entry.readable(axis.range().1));
        let _ = writeln!(
            text,
            "  {:<24} {from:>9.3} to {to:>9.3} {unit:<4} {:>3} breakpoints",
            entry.name().replace('_', " "),
            axis.len()
        );
    }
    let _ = writeln!(
        text,
        "\n  {} nodes: {} solved, {} slipping, {} without solution, {} without drive",
        report.nodes, report.solved, report.slipping, report.unsolved, report.no_drive
    );
    let _ = writeln!(
        text,
        "  {} of {} cells have values; {} check points in them",
        report.usable_cells, report.cells, report.checks
    );
    let _ = writeln!(text, "\n  {:<34} {:>10} {:>10}", "largest error at check points", "cubic", "linear");
    let linear = |at: usize| report.linear_error.by_quantity.get(at).map_or(f64::NAN, |error| error.largest);
    for (at, error) in report.error.by_quantity.iter().enumerate() {
        let _ = writeln!(text, "  {:<34} {:>10.2e} {:>10.2e}", error.name, error.largest, linear(at));
    }
    type Part = (&'static str, fn(&ErrorReport) -> f64);
    let parts: [Part; 4] = [
        ("median of all", |e| e.median),
        ("9 in 10 below", |e| e.q90),
        ("99 in 100 below", |e| e.q99),
        ("largest of all", |e| e.largest),
    ];
    for (name, part) in parts {
        let _ = writeln!(text, "  {name:<34} {:>10.2e} {:>10.2e}", part(&report.error), part(&report.linear_error));
    }
    let verdict = if report.reached { "within" } else { "above" };
    let _ = writeln!(
        text,
        "\n  {verdict} the accuracy of {:.1e} that was asked for; written to {}",
        report.accuracy,
        path.display()
    );
    text
}

fn map_path(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    match MapFormat::of(&path) {
        Some(_) => Ok(path),
        None => Err("expected a file name that ends in .csv, .parquet or .nc".into()),
    }
}
