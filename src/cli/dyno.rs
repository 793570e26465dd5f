//! `sheave dyno`: operating points from the logs of a dynamometer.

use super::measured::{refused, warn};
use super::output;
use super::stop::Stop;
use clap::{Args, ValueEnum};
use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;
use sheave::bench::dyno::{
    Fault, LogFile, Names, Options, Record, Reduced, SteadyPoint, calibration, figures, points_csv, records, reduce,
    runs, spectrum_figures,
};
use sheave::bench::engine::EngineCurve;
use sheave::bench::{BenchError, PageTable, page};
use sheave::quantity::Unit;
use sheave::result::envelope;
use std::fmt::Write;
use std::path::PathBuf;

/// Reduce raw logs of a dynamometer to operating points
///
/// Reads files of one channel and step each (P_3.csv, S_3.csv, ADC_3.csv, TORQUE_3.csv: time in µs, value), logs with a
/// header (timestamp_ms,primary_rpm,secondary_rpm,torque) and RaceCapture logs, compressed by gzip or not, and folders
/// of them. Rows that cannot be used are counted and named. Steady windows are averaged, with standard errors.
#[derive(Debug, Args)]
#[command(after_help = super::STATUS)]
pub struct Arguments {
    /// Logs, or folders of logs
    #[arg(value_name = "PATH", required = true)]
    paths: Vec<PathBuf>,
    /// Calibration of the torque: rows of torque in N·m and ADC, which are fitted, or of slope, intercept, R² (the last
    /// applies); for files ADC_*, columns `adc`, and the column that --torque names
    #[arg(long, value_name = "FILE")]
    calibration: Option<PathBuf>,
    /// The engine's curve: rpm, and power or torque in the unit that a header names; hp without one
    #[arg(long, value_name = "ENGINE.csv")]
    engine: Option<PathBuf>,
    /// Teeth of the gears on the secondary's and on the brake's shaft
    #[arg(long, value_name = "A:B", default_value = "1:1", value_parser = gear)]
    gear: f64,
    /// Where the torque's calibration holds
    #[arg(long, value_name = "WHERE", default_value = "secondary")]
    torque_at: TorqueAt,
    /// Uniform rate to which the channels are brought, Hz
    #[arg(long, value_name = "HZ", default_value_t = 125.0, value_parser = |text: &str| within(text, 1.0, 100_000.0))]
    rate: f64,
    /// Length of the windows that are averaged, s
    #[arg(long, value_name = "S", default_value_t = 3.0, value_parser = |text: &str| within(text, 0.05, 600.0))]
    window: f64,
    /// Longest gap in a channel that is bridged, s
    #[arg(long, value_name = "S", default_value_t = 0.25, value_parser = |text: &str| within(text, 0.001, 60.0))]
    longest_gap: f64,
    /// Column of a log with the speed of the primary (RPM3)
    #[arg(long, value_name = "NAME")]
    primary: Option<String>,
    /// Column of a log with the speed of the secondary, or of a shaft behind it (RPM2)
    #[arg(long, value_name = "NAME")]
    secondary: Option<String>,
    /// Column of a log with the torque, in N·m; raw where there is a --calibration
    #[arg(long, value_name = "NAME")]
    torque: Option<String>,
    /// Speed of the secondary over what its column has
    #[arg(long, value_name = "X", default_value_t = 1.0, value_parser = |text: &str| within(text, 1e-6, 1e6))]
    secondary_factor: f64,
    /// Table of the time windows of logs that are read: logfile, t_start, t_end in ms
    #[arg(long, value_name = "FILE")]
    runs: Option<PathBuf>,
    /// Revolutions of the engine between two firings
    #[arg(long, value_name = "N", default_value_t = 2.0, value_parser = |text: &str| within(text, 0.1, 10.0))]
    revolutions_per_firing: f64,
    /// Number of the point, from 0, whose torque and spectrum are drawn; the first steady one if it is not given
    #[arg(long, value_name = "N")]
    spectrum: Option<usize>,
    /// Print the result as one JSON object, in SI units
    #[arg(long, conflicts_with = "out")]
    json: bool,
    /// Write operating-points.csv, result.json, figures (SVG, PNG) and report.html into this folder, and print the
    /// summary
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// A place on the way of the torque.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum TorqueAt {
    /// It gives the torque of the secondary, as (9.1) does
    Secondary,
    /// It gives the torque of the brake's shaft, behind the gears
    Brake,
}

fn within(text: &str, low: f64, high: f64) -> Result<f64, String> {
    let value = text.parse::<f64>().ok().filter(|value| (low..=high).contains(value));
    value.ok_or_else(|| format!("expected a number from {low} to {high}"))
}

fn gear(text: &str) -> Result<f64, String> {
    let teeth = |text: &str| text.trim().parse::<f64>().ok().filter(|teeth| (1.0..=1e4).contains(teeth));
    let (own, brake) = text.split_once(':').ok_or("expected two numbers of teeth, such as 32:61")?;
    let (own, brake) = teeth(own).zip(teeth(brake)).ok_or("expected two numbers of teeth, such as 32:61")?;
    Ok(own / brake)
}

/// The object of the command, written piece by piece: points may be many.
#[derive(Serialize)]
struct Object<'a> {
    #[serde(flatten)]
    head: serde_json::Value,
    #[serde(flatten)]
    found: &'a Reduced,
}

pub fn run(arguments: &Arguments) -> Result<(), Stop> {
    output::folder_place(arguments.out.as_deref())?;
    let (options, mut found) = arguments.find().map_err(|error| refused("dyno", arguments.json, error))?;
    let (table, left_out) = points_csv(&found.points);
    if arguments.out.is_some() && (left_out > 0 || found.points.is_empty()) {
        found.warnings.push(left_out_words(&found.points, left_out));
    }
    let warnings = &found.warnings;
    warn(warnings);
    let inputs = serde_json::json!({ "paths": arguments.paths, "options": options, "engine": options.engine });
    let head = envelope("dyno", &inputs, warnings, &serde_json::json!({}));
    let head = head.map_err(|error| Stop::Write("JSON".into(), error.into()))?;
    let object = Object { head, found: &found };
    if arguments.json {
        return output::print_object(&object);
    }
    if let Some(folder) = &arguments.out {
        output::create_folder(folder)?;
        output::write_file(folder, "result.json", |to| {
            serde_json::to_writer_pretty(&mut *to, &object)?;
            to.write_all(b"\n")
        })?;
        output::write_file(folder, "operating-points.csv", |to| to.write_all(table.as_bytes()))?;
        let mut all = figures(&found.points, &found.records);
        all.extend(found.chosen.iter().flat_map(|point| spectrum_figures(point, options.rate)));
        output::write_figures(folder, &all)?;
        let lead = format!("{} points of {} records", found.points.len(), found.records.len());
        let page = page("Dynamometer", &lead, warnings, &tables(&options, &found), &all)?;
        output::write_file(folder, "report.html", |to| to.write_all(page.as_bytes()))?;
    }
    output::print(&summary(&found))
}

impl Arguments {
    fn options(&self, warnings: &mut Vec<String>) -> Result<Options, BenchError> {
        let engine = self.engine.as_deref().map(EngineCurve::read).transpose()?;
        warnings.extend(engine.as_ref().and_then(EngineCurve::assumption));
        Ok(Options {
            rate: self.rate,
            window: self.window,
            longest_gap: self.longest_gap,
            secondary_factor: self.secondary_factor,
            gear: self.gear,
            torque_at_sensor: self.torque_at == TorqueAt::Brake,
            revolutions: self.revolutions_per_firing,
            calibration: self.calibration.as_deref().map(calibration::read).transpose()?,
            engine,
            names: Names {
                primary: self.primary.clone(),
                secondary: self.secondary.clone(),
                torque: self.torque.clone(),
            },
            runs: self.runs.as_deref().map(runs).transpose()?.unwrap_or_default(),
            ..Options::default()
        })
    }

    fn find(&self) -> Result<(Options, Reduced), BenchError> {
        let mut warnings = Vec::new();
        let options = self.options(&mut warnings)?;
        let logs = records(&self.paths)?;
        let bar = progress(&logs);
        let found = reduce(&self.paths, &options, self.spectrum, |bytes| bar.inc(bytes));
        bar.finish_and_clear();
        let mut found = found?;
        let given = [("--primary", &self.primary), ("--secondary", &self.secondary), ("--torque", &self.torque)];
        let named: Vec<&str> = given.iter().filter(|(_, name)| name.is_some()).map(|(option, _)| *option).collect();
        if !named.is_empty() && logs.iter().flat_map(|record| &record.files).all(|(_, kind)| kind.is_some()) {
            let options = named.join(" and ");
            warnings.push(format!("{options} tells columns of logs with a header; these files have none"));
        }
        warnings.append(&mut found.warnings);
        found.warnings = warnings;
        Ok((options, found))
    }
}

/// Which points the table of operating points does not have, and why.
fn left_out_words(points: &[SteadyPoint], left_out: usize) -> String {
    if points.is_empty() {
        return "operating-points.csv has no operating point: nothing is steady".into();
    }
    let steady = || points.iter().filter(|point| point.steady);
    let counts = [
        (points.len() - steady().count(), "not steady"),
        (steady().filter(|point| point.primary_speed.is_none()).count(), "without the primary's speed"),
        (steady().filter(|point| point.secondary_speed.is_none()).count(), "without the secondary's speed"),
        (steady().filter(|point| point.secondary_torque.is_none()).count(), "without torque"),
    ];
    let why: Vec<String> =
        counts.iter().filter(|(count, _)| *count > 0).map(|(count, why)| format!("{count} {why}")).collect();
    let all = if left_out == points.len() { "has no operating point; it " } else { "" };
    format!("operating-points.csv {all}leaves out {left_out} of {} points: {}", points.len(), why.join(", "))
}

/// Progress in bytes, on standard error if people look at it.
fn progress(records: &[Record]) -> ProgressBar {
    let size = |(path, _): &LogFile| std::fs::metadata(path).map_or(0, |metadata| metadata.len());
    let bar = ProgressBar::new(records.iter().flat_map(|record| &record.files).map(size).sum());
    let style = ProgressStyle::with_template("{bar:40} {bytes} of {total_bytes}, {bytes_per_sec}");
    bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

/// A number of a cell, empty without one.
fn cell(value: Option<f64>, digits: usize) -> String {
    value.map_or_else(String::new, |value| format!("{value:.digits$}"))
}

fn row(point: &SteadyPoint) -> [String; 8] {
    let rpm = Unit::RPM.per_si();
    [
        point.record.rsplit('/').next().unwrap_or_default().to_owned(),
        cell(Some(point.start), 2),
        cell(point.primary_speed.map(|speed| speed.mean * rpm), 1),
        cell(point.secondary_speed.map(|speed| speed.mean * rpm), 1),
        cell(point.secondary_torque.map(|torque| torque.mean), 3),
        cell(point.secondary_torque.map(|torque| torque.error), 3),
        cell(point.efficiency.map(|efficiency| 100.0 * efficiency.value), 2),
        point.reason.clone().unwrap_or_default(),
    ]
}

const COLUMNS: [&str; 8] = [
    "record",
    "start (s)",
    "primary (rpm)",
    "secondary (rpm)",
    "torque (N·m)",
    "± (N·m)",
    "efficiency (%)",
    "not steady, why",
];

fn summary(found: &Reduced) -> String {
    let steady = found.points.iter().filter(|point| point.steady).count();
    let samples: u64 = found.records.iter().map(|record| record.samples).sum();
    let mut text = format!("{} records, {samples} uniform samples, {steady} steady points\n", found.records.len());
    // Writing to a string does not fail.
    for fault in Fault::ALL {
        let count: u64 =
            found.records.iter().flat_map(|record| &record.files).map(|file| file.faults.count(fault)).sum();
        if count > 0 {
            let _ = writeln!(text, "  {count} {}", fault.words());
        }
    }
    if found.points.is_empty() {
        return text;
    }
    let line = |text: &mut String, cells: &[String; 8]| {
        let [record, numbers @ .., reason] = cells;
        let name: String = record.chars().take(20).collect();
        let _ = write!(text, "{name:<20}");
        for number in numbers {
            let _ = write!(text, "{number:>16}");
        }
        let _ = writeln!(text, "  {reason}");
    };
    text.push('\n');
    line(&mut text, &COLUMNS.map(String::from));
    const SHOWN: usize = 60;
    found.points.iter().take(SHOWN).for_each(|point| line(&mut text, &row(point)));
    if found.points.len() > SHOWN {
        let _ = writeln!(text, "and {} more: --json or --out has all", found.points.len() - SHOWN);
    }
    text
}

fn tables(options: &Options, found: &Reduced) -> Vec<PageTable> {
    let names = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect();
    let points = found.points.iter().take(1000).map(|point| row(point).to_vec()).collect();
    let mut tables = vec![PageTable { title: "Operating points".into(), columns: names(&COLUMNS), rows: points }];
    if let Some(line) = options.calibration {
        let known = |value: Option<f64>| value.map_or("not known".to_owned(), |value| format!("{value:.6}"));
        let rows = vec![
            vec!["slope (1/N·m)".into(), format!("{:.6}", line.slope), known(line.slope_error)],
            vec!["intercept".into(), format!("{:.4}", line.intercept), known(line.intercept_error)],
            vec!["R²".into(), format!("{:.6}", line.r_squared), String::new()],
        ];
        let columns = names(&["calibration (9.1)", "value", "standard error"]);
        tables.push(PageTable { title: "Calibration of the torque".into(), columns, rows });
    }
    let file = |file: &sheave::bench::dyno::FileReport| {
        vec![
            file.file.clone(),
            file.rows.to_string(),
            file.faults.to_string(),
            file.problem.clone().unwrap_or_default(),
        ]
    };
    let rows = found.records.iter().flat_map(|record| &record.files).take(1000).map(file).collect();
    tables.push(PageTable { title: "Files".into(), columns: names(&["file", "rows", "faults", "problem"]), rows });
    tables
}
