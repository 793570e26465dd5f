//! `sheave tune`: the combination of parts that holds the engine at a speed.

use super::case::CaseArguments;
use super::envelope;
use super::keeping::{self, Keeping};
use super::output;
use super::solve::{jobs, share};
use super::stop::Stop;
use clap::Args;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use serde::Serialize;
use sheave::beltmap::{BeltMap, MapFormat, MapOptions, MapPlan, Report};
use sheave::drive::SolveOptions;
use sheave::quantity::{Dimension, parse};
use sheave::study::Format;
use sheave::tune::{PartsBox, Ranking, Refused, Tune, TuneError, TuneOptions, TunePlan, pareto_figure, summary, table};
use std::io::{self, IsTerminal};
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

/// Tunes in the object that --json prints; tunes.csv of --out has all.
const TOLD: usize = 50;

/// Find the combination of parts that holds the engine at a speed over the whole shift
///
/// Maps the belt, balances the parts of every combination against it at points of the shift from low to high ratio, and
/// confirms the best by full solutions of the whole drive. A shift ends where a sheave comes to its stop; where the map
/// has no values, beside the slip limit, points are solved in full. Ranked by rms deviation from the target; with the
/// smallest slip reserve and the mean efficiency, those that no other combination beats are marked. Combinations that
/// make no drive, or slip, are counted with the reason.
#[derive(Debug, Args)]
#[command(after_long_help = super::STATUS)]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// The box of parts: a table for each kind, in it a table for each part with the keys of the case that it sets
    #[arg(long, value_name = "PARTS.toml")]
    parts: PathBuf,
    /// Speed to hold the engine at
    #[arg(long, value_name = "SPEED", value_parser = speed, allow_hyphen_values = true)]
    target: f64,
    /// A map of the drive's belt as CSV, in place of one that is made: over ratio, torque, speed and slack_tension, and
    /// with the case's belt, sheaves, edition and losses
    #[arg(long, value_name = "MAP.csv")]
    map: Option<PathBuf>,
    /// Accuracy of the map that is made
    #[arg(long, value_name = "E", default_value_t = 1e-2, conflicts_with = "map")]
    accuracy: f64,
    /// Points of the shift
    #[arg(long, value_name = "N", default_value_t = 11)]
    points: usize,
    /// Least slip reserve over the shift, as a share of the friction at hand, from 0 to below 1: 0.3 or 30%
    #[arg(long, value_name = "S", default_value = "0", value_parser = share)]
    least_reserve: f64,
    /// How many of the best are confirmed by full solutions
    #[arg(long, value_name = "N", default_value_t = 10)]
    best: usize,
    /// Threads, no more of which are started than there are cores [default: all cores]
    #[arg(long, value_name = "N", value_parser = jobs)]
    jobs: Option<NonZeroUsize>,
    /// Print the result as one JSON object, in SI units
    #[arg(long, conflicts_with = "out")]
    json: bool,
    /// Write result.json, tunes.csv, pareto.csv, the figure (SVG, PNG) and map.csv into this folder, and print the
    /// summary
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Go on with a search that was ended: map.csv of --out is used, or its journal gone on with
    #[arg(long, requires = "out", conflicts_with = "map")]
    resume: bool,
}

/// What the command tells.
#[derive(Debug, Serialize, schemars::JsonSchema)]
pub struct Told<'a> {
    target: f64,
    candidates: usize,
    /// Combinations that shift.
    shifting: usize,
    points: usize,
    ratios: &'a [f64],
    readings: usize,
    /// Points of shifts that were sought by full solutions, because the map has no values there.
    in_full: usize,
    refused: &'a [Refused],
    /// The best.
    tunes: Vec<&'a Tune>,
    /// Those that no other beats.
    pareto: Vec<&'a Tune>,
    map: &'a Report,
}

pub fn run(arguments: &Arguments) -> Result<(), Stop> {
    let parts = PartsBox::read(&arguments.parts).map_err(stop)?;
    let plan = TunePlan::new(arguments.case.read()?, parts, arguments.options()).map_err(stop)?;
    if let Some(folder) = &arguments.out {
        output::create_folder(folder)?;
    }
    let map = arguments.find_map(&plan)?;
    let mut warnings = Vec::new();
    if !map.report().reached {
        warnings.push(format!("the map's error is {:.1e}, more than was asked for", map.report().error.largest));
    }
    let bar = progress(plan.parts().candidates());
    let ranking = plan.search(&map, &|| bar.inc(1)).map_err(stop)?;
    bar.finish_and_clear();
    if ranking.tunes.is_empty() {
        return Err(nothing(&ranking));
    }
    arguments.deliver(&plan, &map, &ranking, &warnings)
}

/// No combination shifts.
fn nothing(ranking: &Ranking) -> Stop {
    let reasons: Vec<String> = ranking
        .refused
        .iter()
        .map(|refused| format!("{} {} ({})", refused.count, refused.reason, refused.example))
        .collect();
    Stop::NoSolution(format!("none of {} combinations shifts: {}", ranking.candidates, reasons.join("; ")))
}

/// A search's error as a command's.
fn stop(error: TuneError) -> Stop {
    match error {
        TuneError::Case(error) => Stop::Input(error),
        TuneError::Map(error) => super::map::stop(error),
        TuneError::Internal(error) => error.into(),
        other => Stop::Usage(other.to_string()),
    }
}

impl Arguments {
    fn options(&self) -> TuneOptions {
        TuneOptions {
            points: self.points,
            least_reserve: self.least_reserve,
            confirmed: self.best,
            jobs: self.jobs.map(NonZeroUsize::get),
            ..TuneOptions::new(self.target)
        }
    }

    /// The map: read, or made and kept.
    fn find_map(&self, plan: &TunePlan) -> Result<BeltMap, Stop> {
        if let Some(path) = &self.map {
            let map = BeltMap::read(path).map_err(|error| Stop::Usage(error.to_string()))?;
            return match plan.check_map(&map) {
                Ok(()) => Ok(map),
                Err(error @ (TuneError::Axis { .. } | TuneError::OtherMap { .. })) => {
                    Err(Stop::Usage(format!("{}: {error}", path.display())))
                }
                Err(error) => Err(stop(error)),
            };
        }
        let solve = SolveOptions { tolerance: 0.01 * self.accuracy, ..SolveOptions::default() };
        let options = MapOptions {
            accuracy: self.accuracy,
            solve,
            jobs: self.jobs.map(NonZeroUsize::get),
            ..MapOptions::default()
        };
        let map_plan = plan.map(options).map_err(stop)?;
        let Some(folder) = &self.out else {
            let keeping = Keeping::nameless(&map_plan)?;
            let map = map_plan.build(&keeping).map_err(super::map::stop)?;
            keeping.finish();
            return Ok(map);
        };
        let path = folder.join("map.csv");
        if self.resume
            && let Some(map) = finished(&path, &map_plan)
        {
            return Ok(map);
        }
        let keeping = Keeping::begin(&path, &map_plan, self.resume)?;
        let map = map_plan.build(&keeping).map_err(super::map::stop)?;
        keeping.finish();
        let aside = keeping::deliver(&path, |to| MapFormat::Csv.write(&map, to))?;
        aside.iter().for_each(|warning| tracing::warn!("{warning}"));
        keeping.remove()?;
        Ok(map)
    }

    fn deliver(&self, plan: &TunePlan, map: &BeltMap, ranking: &Ranking, warnings: &[String]) -> Result<(), Stop> {
        let told = Told {
            target: ranking.target,
            candidates: ranking.candidates,
            shifting: ranking.tunes.len(),
            points: ranking.points,
            ratios: &ranking.ratios,
            readings: ranking.readings,
            in_full: ranking.in_full,
            refused: &ranking.refused,
            tunes: ranking.tunes.iter().take(TOLD).collect(),
            pareto: ranking.tunes.iter().filter(|tune| tune.pareto).collect(),
            map: map.report(),
        };
        if self.json {
            return output::print(&envelope::object("tune", plan.case(), warnings, &told)?);
        }
        warnings.iter().for_each(|warning| tracing::warn!("{warning}"));
        if let Some(folder) = &self.out {
            let json = envelope::object("tune", plan.case(), warnings, &told)?;
            output::write_file(folder, "result.json", |to| to.write_all(json.as_bytes()))?;
            output::write_file(folder, "tunes.csv", |to| Format::Csv.write(&table(ranking, false), to))?;
            output::write_file(folder, "pareto.csv", |to| Format::Csv.write(&table(ranking, true), to))?;
            output::write_figures(folder, &[pareto_figure(ranking)])?;
        }
        output::print(&summary(ranking))
    }
}

/// A map of an earlier search, if it is the one that is wanted.
fn finished(path: &Path, plan: &MapPlan) -> Option<BeltMap> {
    let map = BeltMap::read(path).ok()?;
    let same_axes = map.axes().len() == plan.axes().len()
        && map.axes().iter().zip(plan.axes()).all(|(a, b)| a.key() == b.key() && a.range() == b.range());
    let same = map.report().accuracy == plan.options().accuracy
        && serde_json::to_value(plan.case()).is_ok_and(|inputs| inputs == *map.inputs());
    (same && same_axes).then_some(map)
}

/// On standard error, and only for people to see.
fn progress(candidates: usize) -> ProgressBar {
    let target = if io::stderr().is_terminal() { ProgressDrawTarget::stderr() } else { ProgressDrawTarget::hidden() };
    let bar = ProgressBar::with_draw_target(Some(candidates as u64), target);
    match ProgressStyle::with_template("{bar:20} {pos}/{len} combinations, {per_sec}, {eta} left") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}

/// A speed with its unit, rad/s.
fn speed(text: &str) -> Result<f64, String> {
    let read = parse(text).and_then(|quantity| quantity.expect(Dimension::ANGULAR_SPEED));
    read.map_err(|error| format!("{error}; expected a speed such as \"3400 rpm\""))
}
