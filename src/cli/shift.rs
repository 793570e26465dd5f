//! `sheave shift`: the shift curve of a whole drive.

use super::case::CaseArguments;
use super::drive::{quantity, stop};
use super::envelope;
use super::output;
use super::solve::tolerance;
use super::stop::Stop;
use clap::{Args, ValueEnum};
use serde::Serialize;
use sheave::case::{Case, Resolved};
use sheave::drive::SolveOptions;
use sheave::equilibrium::{
    Deviation, Direction, Landmark, Measured, ShiftBranch, ShiftCurve, ShiftOptions, ShiftPoint, beyond_engine,
    deviation, has_all_parts, over_curve, read_measured, shift_branches, shift_figures, shift_table, unused_keys,
};
use sheave::plot::Stack;
use sheave::quantity::{Dimension, km_per_h, rpm};
use sheave::study::{Format, Table};
use std::fmt::Write;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// Which branches are computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Branches {
    /// Shifting up, then shifting back
    Both,
    /// Shifting up
    Up,
    /// Shifting back
    Back,
    /// Friction in the actuators left out
    Frictionless,
}

/// Compute the shift curve of a whole drive: engine speed over road speed, up and back
///
/// The phases of a launch: where flyweights overcome their spring, where the belt takes the drive off, low ratio,
/// shift-out, and high ratio until the engine gives no more torque. With --out a table, figures and the object; points
/// without an equilibrium say why, and the run goes on. The table is kept after every point, so that Ctrl-C loses none.
#[derive(Debug, Args)]
#[command(after_long_help = super::STATUS)]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// Points of each direction, half of them between the stops
    #[arg(long, value_name = "N", default_value = "24", value_parser = clap::value_parser!(u16).range(2..=2000))]
    points: u16,
    /// Which way
    #[arg(long, value_enum, default_value = "both")]
    direction: Branches,
    /// Speed of the secondary at which the curve begins [default: where the belt takes off]
    #[arg(long, value_name = "SPEED", allow_hyphen_values = true)]
    from: Option<String>,
    /// Speed of the secondary at which it ends [default: where the engine's torque is known no farther]
    #[arg(long, value_name = "SPEED", allow_hyphen_values = true)]
    to: Option<String>,
    /// Measured points beside it: CSV with the columns secondary_rpm, primary_rpm, and if there are both ways direction
    #[arg(long, value_name = "FILE")]
    data: Option<PathBuf>,
    /// The curve of another case in the same figure
    #[arg(long, value_name = "OTHER.toml")]
    compare: Option<PathBuf>,
    /// Relative tolerance of the solutions, from 1e-12 to 0.1
    #[arg(long, value_name = "T", default_value = "1e-6", value_parser = tolerance)]
    tol: f64,
    /// Write shift.csv, shift.json and the figures (SVG, PNG) into this folder
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Write the table into this file: .csv, .parquet or .json
    #[arg(long, value_name = "FILE", value_parser = table_format)]
    table: Option<PathBuf>,
    /// Print the result as one JSON object
    #[arg(long)]
    json: bool,
}

/// Share of the difference from the data that interpolation may have before it is told.
const NOTICED: f64 = 0.05;

fn table_format(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    let known = Format::of(&path).is_some();
    if known { Ok(path) } else { Err("expected a name that ends in .csv, .parquet or .json".into()) }
}

/// What is known of one direction, SI.
#[derive(Debug, Serialize, schemars::JsonSchema)]
struct BranchTold<'a> {
    direction: Direction,
    engagement_speed: Option<f64>,
    take_off: Option<Landmark>,
    shift_out: Option<Landmark>,
    full_shift: Option<Landmark>,
    deviation: Option<Deviation>,
    remarks: &'a [String],
}

#[derive(Debug, Serialize, schemars::JsonSchema)]
pub struct Told<'a> {
    edition: &'static str,
    /// Speed of the primary in rad/s from which flyweights overcome their spring, as the drive shifts up; of the first
    /// direction where it does not.
    engagement_speed: Option<f64>,
    branches: Vec<BranchTold<'a>>,
    points: serde_json::Value,
}

pub fn run(arguments: &Arguments) -> Result<(), Stop> {
    let case = arguments.case.read_unswapped("shift")?;
    let resolved = case.resolve()?;
    let other = arguments.compare.as_deref().map(|path| Case::read(path)?.resolve()).transpose()?;
    let measured = arguments.data.as_deref().map(read_data).transpose()?.unwrap_or_default();
    let options = arguments.options()?;
    [Some(&resolved), other.as_ref()].into_iter().flatten().try_for_each(has_all_parts).map_err(stop)?;
    if let Some(folder) = &arguments.out {
        output::create_folder(folder)?;
    }
    let mut warnings = unused_keys(&case);
    let cases: Vec<&Resolved> = [Some(&resolved), other.as_ref()].into_iter().flatten().collect();
    let mut curves = arguments.branches(&cases, &options)?.into_iter();
    let (branches, compared) = (curves.next().unwrap_or_default(), curves.next());
    let found = branches.iter().flat_map(|branch| &branch.points).filter_map(|point| point.report.as_ref().ok());
    warnings.extend(beyond_engine(&resolved, found.clone().map(|report| report.primary_speed)));
    warnings.extend(over_curve(&resolved, found.map(Box::as_ref)));
    let (failures, points) = failures(&branches);
    if failures > 0 {
        warnings.push(format!("{failures} of {points} points have no equilibrium; `failure` says why."));
    }
    let told = told(&resolved, &branches, &measured)?;
    for (branch, told) in branches.iter().zip(&told.branches) {
        let of_branch = |point: &&Measured| point.direction.is_none_or(|direction| direction == branch.direction);
        let given = measured.iter().filter(of_branch).count();
        let beyond = given - told.deviation.map_or(0, |found| found.points);
        if beyond > 0 {
            warnings.push(format!(
                "{beyond} of {given} measured points, {}, lie beyond the ends of the curve and are not compared.",
                branch.direction.name()
            ));
        }
    }
    for found in told.branches.iter().filter_map(|branch| branch.deviation) {
        if found.interpolation > NOTICED * found.rms {
            warnings.push(format!(
                "Of the {:.0} rpm beside the data, {}, about {:.0} rpm are owed to the lines between so few points: \
                 --points {} makes it less.",
                rpm(found.rms),
                found.direction.name(),
                rpm(found.interpolation),
                2 * options.points
            ));
        }
    }
    warnings.iter().for_each(|warning| tracing::warn!("{warning}"));
    arguments.deliver(&resolved, &branches, compared.as_deref(), &measured, &told, &warnings)?;
    if failures == points {
        let reasons = branches.iter().flat_map(|branch| branch.remarks.iter().cloned());
        let failed = branches.iter().flat_map(|branch| &branch.points).filter_map(|point| point.report.as_ref().err());
        let reason = reasons.chain(failed.cloned()).next().unwrap_or_default();
        return Err(Stop::NoSolution(format!("no point of the shift curve has an equilibrium: {reason}")));
    }
    if arguments.json {
        return output::print(&envelope::object("shift", &resolved, &warnings, &told)?);
    }
    output::print(&summary(&resolved, &branches, &told))
}

impl Arguments {
    fn options(&self) -> Result<ShiftOptions, Stop> {
        let speed = |option: &str, text: &Option<String>| {
            text.as_ref().map(|text| quantity(option, text, Dimension::ANGULAR_SPEED, "2000 rpm")).transpose()
        };
        let directions = match self.direction {
            Branches::Both => vec![Direction::Up, Direction::Back],
            Branches::Up => vec![Direction::Up],
            Branches::Back => vec![Direction::Back],
            Branches::Frictionless => vec![Direction::Frictionless],
        };
        let (from, to) = (speed("--from", &self.from)?, speed("--to", &self.to)?);
        if let (Some(from), Some(to)) = (from, to)
            && from >= to
        {
            return Err(Stop::Usage(format!(
                "--from is {:.0} rpm and --to is {:.0} rpm: expected a higher speed to end at than to begin at",
                rpm(from),
                rpm(to)
            )));
        }
        Ok(ShiftOptions {
            points: self.points.into(),
            directions,
            from,
            to,
            solve: SolveOptions { tolerance: self.tol, ..SolveOptions::default() },
        })
    }

    /// All branches of a case, and of the one beside it, side by side; what was found so far of the first is written
    /// after every point.
    fn branches(&self, cases: &[&Resolved], options: &ShiftOptions) -> Result<Vec<Vec<ShiftBranch>>, Stop> {
        let begun = |direction: &Direction| ShiftBranch {
            direction: *direction,
            engagement: None,
            take_off: None,
            shift_out: None,
            full_shift: None,
            points: Vec::new(),
            remarks: Vec::new(),
        };
        let so_far = Mutex::new(options.directions.iter().map(begun).collect::<Vec<ShiftBranch>>());
        let broken = Mutex::new(None);
        let see = |case: usize, point: &ShiftPoint| {
            let rpm = rpm(point.secondary_speed);
            tracing::info!("{} at {rpm:.0} rpm: {}", point.direction.name(), point_words(point));
            if case > 0 {
                return ControlFlow::Continue(());
            }
            let mut so_far = so_far.lock().unwrap_or_else(PoisonError::into_inner);
            let of_direction = so_far.iter_mut().filter(|branch| branch.direction == point.direction);
            of_direction.for_each(|branch| branch.points.push(point.clone()));
            match self.write_tables(&shift_table(&so_far)) {
                Ok(()) => ControlFlow::Continue(()),
                Err(error) => {
                    broken.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
                    ControlFlow::Break(())
                }
            }
        };
        let branches = shift_branches(cases, options, &see).map_err(stop)?;
        broken.into_inner().unwrap_or_else(PoisonError::into_inner).map_or(Ok(branches), Err)
    }

    fn write_tables(&self, table: &Table) -> Result<(), Stop> {
        if let Some(folder) = &self.out {
            output::write_file(folder, "shift.csv", |to| Format::Csv.write(table, to))?;
        }
        if let (Some(path), Some(format)) = (&self.table, self.table.as_deref().and_then(Format::of)) {
            let folder = path.parent().unwrap_or(Path::new(""));
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            output::write_file(folder, &name, |to| format.write(table, to))?;
        }
        Ok(())
    }

    fn deliver(
        &self,
        case: &Resolved,
        branches: &[ShiftBranch],
        compared: Option<&[ShiftBranch]>,
        measured: &[Measured],
        told: &Told<'_>,
        warnings: &[String],
    ) -> Result<(), Stop> {
        self.write_tables(&shift_table(branches))?;
        let Some(folder) = &self.out else { return Ok(()) };
        let text = envelope::object("shift", case, warnings, told)?;
        output::write_file(folder, "shift.json", |to| to.write_all(text.as_bytes()))?;
        let name = self.compare.as_deref().and_then(Path::file_stem).map(|name| name.to_string_lossy().into_owned());
        let other = name.unwrap_or_default();
        let mut curves = vec![ShiftCurve { name: "this", branches }];
        curves.extend(compared.map(|branches| ShiftCurve { name: &other, branches }));
        let panels = shift_figures(&curves, case.parts.vehicle.as_ref(), measured);
        let stack = Stack { name: "shift".into(), caption: "The shift curve of a whole drive".into(), panels };
        let (svg, png) = (stack.svg()?, stack.png()?);
        output::write_file(folder, "shift.svg", |to| to.write_all(svg.as_bytes()))?;
        output::write_file(folder, "shift.png", |to| to.write_all(&png))
    }
}

fn read_data(path: &Path) -> Result<Vec<Measured>, Stop> {
    let file = std::fs::File::open(path).map_err(|error| Stop::Usage(format!("{}: {error}", path.display())))?;
    read_measured(file).map_err(|error| Stop::Usage(format!("{} {error}", path.display())))
}

/// Points without an equilibrium, and all points.
fn failures(branches: &[ShiftBranch]) -> (usize, usize) {
    let points = || branches.iter().flat_map(|branch| &branch.points);
    (points().filter(|point| point.report.is_err()).count(), points().count())
}

fn point_words(point: &ShiftPoint) -> String {
    match &point.report {
        Ok(report) => format!("{:.0} rpm, {}", rpm(report.primary_speed), report.phase),
        Err(reason) => reason.clone(),
    }
}

fn told<'a>(case: &Resolved, branches: &'a [ShiftBranch], measured: &[Measured]) -> Result<Told<'a>, Stop> {
    let mut rows = Vec::new();
    let written = Format::Json.write(&shift_table(branches), &mut rows);
    written.map_err(|error| Stop::Write("JSON".into(), error))?;
    let points = serde_json::from_slice(&rows).map_err(|error| Stop::Write("JSON".into(), error.into()))?;
    let up = branches.iter().find(|branch| branch.direction == Direction::Up).or(branches.first());
    let engagement_speed = up.and_then(|branch| branch.engagement);
    let branches = branches.iter().map(|branch| BranchTold {
        direction: branch.direction,
        engagement_speed: branch.engagement,
        take_off: branch.take_off,
        shift_out: branch.shift_out,
        full_shift: branch.full_shift,
        deviation: deviation(branch, measured),
        remarks: &branch.remarks,
    });
    Ok(Told { edition: case.edition.name(), engagement_speed, branches: branches.collect(), points })
}

fn summary(case: &Resolved, branches: &[ShiftBranch], told: &Told<'_>) -> String {
    let mut text = format!("Shift curve, edition {}\n", told.edition);
    for (branch, told) in branches.iter().zip(&told.branches) {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "\n{}", branch.direction.name());
        if let Some(speed) = branch.engagement {
            let _ = writeln!(text, "  {:<22}{:>6.0} rpm", "flyweights engage", rpm(speed));
        }
        for (name, place) in
            [("belt takes off", branch.take_off), ("shift-out", branch.shift_out), ("full shift", branch.full_shift)]
        {
            if let Some(place) = place {
                let (engine, road) = (rpm(place.primary_speed), rpm(place.secondary_speed));
                let _ = writeln!(
                    text,
                    "  {name:<22}{engine:>6.0} rpm at a secondary of {road:.0} rpm, ratio {:.2}",
                    place.ratio
                );
            }
        }
        if let Some(found) = told.deviation {
            let _ = writeln!(
                text,
                "  {:<22}{:>6.0} rpm rms, {:+.0} rpm on average, over {} measured points",
                "beside the data",
                rpm(found.rms),
                rpm(found.mean),
                found.points
            );
        }
        let _ = writeln!(text, "\n{}", rows(case, branch));
        branch.remarks.iter().for_each(|remark| _ = writeln!(text, "  {remark}"));
    }
    text
}

fn rows(case: &Resolved, branch: &ShiftBranch) -> String {
    let road = if case.parts.vehicle.is_some() { "km/h" } else { "" };
    let mut text = format!(
        "  {:>9}{:>8}{:>8}{:>7}  {:<10}{:>9}{:>11}{:>8}{:>9}\n",
        "secondary", road, "engine", "ratio", "", "primary", "secondary", "slip", "effi-"
    );
    let _ = writeln!(
        text,
        "  {:>9}{:>8}{:>8}{:>7}  {:<10}{:>9}{:>11}{:>8}{:>9}",
        "rpm", "", "rpm", "", "", "N", "N", "reserve", "ciency"
    );
    for point in &branch.points {
        let secondary = rpm(point.secondary_speed);
        match &point.report {
            Ok(report) => {
                let road = report.vehicle_speed.map_or_else(String::new, |speed| format!("{:.1}", km_per_h(speed)));
                let slip =
                    if report.slipping { "slips".into() } else { format!("{:.1} %", 100.0 * report.slip_reserve) };
                let share = report.efficiency.map_or_else(|| "-".into(), |share| format!("{:.1} %", 100.0 * share));
                let doubt = report.doubt.filter(|_| !report.slipping);
                let doubt = doubt.map_or_else(String::new, |doubt| format!("  {}", doubt.name()));
                let _ = writeln!(
                    text,
                    "  {secondary:>9.0}{road:>8}{:>8.0}{:>7.3}  {:<10}{:>9.0}{:>11.0}{slip:>8}{share:>9}{doubt}",
                    rpm(report.primary_speed),
                    report.ratio,
                    report.phase,
                    report.primary_axial_force,
                    report.secondary_axial_force,
                );
            }
            Err(reason) => _ = writeln!(text, "  {secondary:>9.0}  {reason}"),
        }
    }
    text
}
