//! `sheave launch`: a vehicle from standstill to its top speed.

use super::case::CaseArguments;
use super::drive::{quantity, stop as no_equilibrium};
use super::envelope;
use super::output;
use super::solve::tolerance;
use super::stop::Stop;
use clap::Args;
use serde::Serialize;
use sheave::drive::SolveOptions;
use sheave::equilibrium::{Direction, Landmark, ShiftOptions, beyond_engine, over_curve, shift_branch, unused_keys};
use sheave::launch::{
    Launch, LaunchCurve, LaunchError, LaunchOptions, launch, launch_figures, launch_summary, launch_table,
};
use sheave::plot::Stack;
use sheave::quantity::{Dimension, rpm};
use sheave::study::Format;
use std::ops::ControlFlow;
use std::path::PathBuf;

/// Launch a vehicle from standstill to its top speed along the shift curve of its drive
///
/// The shift curve is solved, upshift, and the vehicle accelerates with what the secondary delivers beyond rolling
/// resistance, grade and air, without the inertia of engine and pulleys. Until the belt takes off the clutch slips: the
/// engine runs as at take-off, its torque arrives, and the speed that is lost becomes heat. Prints the times over 100
/// ft and 150 ft, the top speed, and where the energy went; with --out a table over time and the figure.
#[derive(Debug, Args)]
#[command(after_long_help = super::STATUS)]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// Distance of which the time is told, covered within two hours; again for more [default: 100 ft and 150 ft]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    distance: Vec<String>,
    /// Share of the top speed at which the launch is done, above 0 and below 1
    #[arg(long, value_name = "S", default_value_t = 0.99, value_parser = share)]
    share: f64,
    /// Points of the shift curve
    #[arg(long, value_name = "N", default_value = "32", value_parser = clap::value_parser!(u16).range(8..=2000))]
    points: u16,
    /// Relative tolerance of the solutions, from 1e-12 to 0.1
    #[arg(long, value_name = "T", default_value = "1e-6", value_parser = tolerance)]
    tol: f64,
    /// Print the result as one JSON object
    #[arg(long)]
    json: bool,
    /// Write launch.csv, launch.json and the figure (SVG, PNG) into this folder
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// What the command tells, SI.
#[derive(Debug, Serialize, schemars::JsonSchema)]
pub struct Told<'a> {
    edition: &'static str,
    /// Where the belt takes off; the clutch slips until then.
    take_off: Option<Landmark>,
    shift_out: Option<Landmark>,
    full_shift: Option<Landmark>,
    #[serde(flatten)]
    launch: &'a Launch,
}

pub fn run(arguments: &Arguments) -> Result<(), Stop> {
    let case = arguments.case.read_unswapped("launch")?;
    let resolved = case.resolve()?;
    let options = arguments.options()?;
    let Some(vehicle) = resolved.parts.vehicle else {
        let needs = "give [vehicle] with mass, final_ratio and wheel_radius";
        return Err(stop(LaunchError::Missing { what: "vehicle", needs }));
    };
    if let Some(folder) = &arguments.out {
        output::create_folder(folder)?;
    }
    let shift = ShiftOptions {
        points: arguments.points.into(),
        directions: vec![Direction::Up],
        solve: SolveOptions { tolerance: arguments.tol, ..SolveOptions::default() },
        ..ShiftOptions::default()
    };
    let branch =
        shift_branch(&resolved, Direction::Up, &shift, &mut |_| ControlFlow::Continue(())).map_err(no_equilibrium)?;
    let curve = LaunchCurve::new(&branch).map_err(stop)?;
    let beginning = match &resolved.parts.engine {
        Some(engine) => curve.beginning(&branch, engine).map_err(stop)?,
        None => None,
    };
    let found = launch(&curve, &vehicle, &options).map_err(stop)?;
    let mut warnings = unused_keys(&case);
    warnings.extend(branch.remarks.iter().cloned());
    warnings.extend(beginning);
    warnings.extend(beyond_engine(&resolved, found.points.iter().map(|point| point.engine_speed)));
    let reports = || branch.points.iter().filter_map(|point| point.report.as_ref().ok());
    let missing = branch.points.len() - reports().count();
    if missing > 0 {
        warnings.push(format!("{missing} of {} points of the shift curve have no equilibrium.", branch.points.len()));
    }
    warnings.extend(found.held_back());
    warnings.extend(over_curve(&resolved, reports().map(Box::as_ref)));
    if let Some(report) = reports().find(|report| report.slipping) {
        let rpm = rpm(report.secondary_speed);
        warnings
            .push(format!("The belt slips at a secondary speed of {rpm:.0} rpm and elsewhere: see `sheave shift`."));
    }
    let told = Told {
        edition: resolved.edition.name(),
        take_off: branch.take_off,
        shift_out: branch.shift_out,
        full_shift: branch.full_shift,
        launch: &found,
    };
    warnings.iter().for_each(|warning| tracing::warn!("{warning}"));
    let object = envelope::object("launch", &resolved, &warnings, &told)?;
    if let Some(folder) = &arguments.out {
        output::write_file(folder, "launch.json", |to| to.write_all(object.as_bytes()))?;
        output::write_file(folder, "launch.csv", |to| Format::Csv.write(&launch_table(&found), to))?;
        let caption = "A launch from standstill".to_owned();
        let stack = Stack { name: "launch".into(), caption, panels: launch_figures(&found) };
        let (svg, png) = (stack.svg()?, stack.png()?);
        output::write_file(folder, "launch.svg", |to| to.write_all(svg.as_bytes()))?;
        output::write_file(folder, "launch.png", |to| to.write_all(&png))?;
    }
    output::print(&if arguments.json { object } else { launch_summary(&found) })
}

fn stop(error: LaunchError) -> Stop {
    match error {
        LaunchError::Equilibrium(error) => no_equilibrium(error),
        error @ (LaunchError::Missing { .. } | LaunchError::Parameter { .. }) => Stop::Usage(error.to_string()),
        error => Stop::NoSolution(error.to_string()),
    }
}

impl Arguments {
    fn options(&self) -> Result<LaunchOptions, Stop> {
        let mut options = LaunchOptions { share_of_top: self.share, ..LaunchOptions::default() };
        if !self.distance.is_empty() {
            let length = |text: &String| quantity("--distance", text, Dimension::LENGTH, "100 ft");
            options.distances = self.distance.iter().map(length).collect::<Result<_, _>>()?;
        }
        Ok(options)
    }
}

fn share(text: &str) -> Result<f64, String> {
    let wrong = || "expected a number above 0 and below 1".to_owned();
    text.parse().ok().filter(|share| (f64::MIN_POSITIVE..1.0).contains(share)).ok_or_else(wrong)
}
