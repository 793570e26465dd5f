//! `sheave drive`: the equilibrium of a whole drive.

use super::case::CaseArguments;
use super::envelope;
use super::output;
use super::solve::tolerance;
use super::stop::{Stop, solver_words};
use clap::{Args, ValueEnum};
use sheave::case::{Case, Key, Resolved};
use sheave::drive::SolveOptions;
use sheave::equilibrium::{
    Direction, DriveReport, EquilibriumError, beyond_engine, beyond_travel, equilibrium_outcome, unused_keys,
};
use sheave::quantity::{Dimension, parse};

/// Which way friction in the actuators acts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Branch {
    /// Shifting up: the primary closes against friction
    Up,
    /// Shifting back, as on a hill: the primary opens
    Back,
    /// Friction in the actuators left out
    Frictionless,
}

impl From<Branch> for Direction {
    fn from(branch: Branch) -> Self {
        match branch {
            Branch::Up => Self::Up,
            Branch::Back => Self::Back,
            Branch::Frictionless => Self::Frictionless,
        }
    }
}

/// Find where a whole drive settles: belt, actuators and engine as one problem
///
/// The case has [primary.actuator] and [secondary.actuator] with their springs, [engine], and if it likes [vehicle];
/// the secondary turns at a speed that is given. Radii, engine speed, torque and clamp are found; what the case says of
/// them is not used. Prints what presses, where the sheaves stand, the slip margin, the losses, and what a change of
/// each part does; with --json one object in SI units.
#[derive(Debug, Args)]
#[command(after_long_help = super::keys::table() + "\n" + super::STATUS)]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// Speed of the secondary, "2000 rpm", or of the vehicle, "30 km/h", as its unit says; in place of
    /// operating_point.secondary_speed
    #[arg(
        long,
        value_name = "SPEED",
        allow_hyphen_values = true,
        conflicts_with_all = ["secondary_speed", "vehicle_speed"]
    )]
    speed: Option<String>,
    /// Speed of the secondary; a number without a unit is in rad/s
    #[arg(long, value_name = "SPEED", allow_hyphen_values = true, conflicts_with = "vehicle_speed")]
    secondary_speed: Option<String>,
    /// Speed of the vehicle; a number without a unit is in m/s
    #[arg(long, value_name = "SPEED", allow_hyphen_values = true)]
    vehicle_speed: Option<String>,
    /// Which way the drive shifts, and so which way friction in the actuators acts
    #[arg(long, value_enum, default_value = "up")]
    direction: Branch,
    /// Relative tolerance of the solution, from 1e-12 to 0.1
    #[arg(long, value_name = "T", default_value = "1e-6", value_parser = tolerance)]
    tol: f64,
    /// Print the result as one JSON object
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<(), Stop> {
    let case = arguments.case.read_unswapped("drive")?;
    let resolved = case.resolve()?;
    let speed = arguments.secondary_speed(&case, &resolved)?;
    let warnings = unused_keys(&case);
    let options = SolveOptions { tolerance: arguments.tol, ..SolveOptions::default() };
    let found = equilibrium_outcome(None, &resolved, speed, arguments.direction.into(), &options).map_err(stop);
    let (found, outcome) = match found {
        Ok(found) => found,
        Err(stop) => {
            if arguments.json {
                envelope::tell("drive", &serde_json::json!({ "inputs": resolved }), &stop.failure())?;
            }
            return Err(stop);
        }
    };
    let mut warnings: Vec<String> = warnings.into_iter().chain(sheave::result::warnings(&outcome)).collect();
    let report = DriveReport::new(&resolved, &found, outcome, true).map_err(stop)?;
    warnings.extend(beyond_engine(&resolved, [report.primary_speed]));
    warnings.extend(beyond_travel(&resolved, [(report.primary_travel, report.secondary_travel)]));
    warnings.iter().for_each(|warning| tracing::warn!("{warning}"));
    if arguments.json {
        return output::print(&envelope::object("drive", &resolved, &warnings, &report)?);
    }
    output::print(&report.summary())
}

impl Arguments {
    fn secondary_speed(&self, case: &Case, resolved: &Resolved) -> Result<f64, Stop> {
        let of_vehicle = |option: &str, text: &str| {
            let vehicle = resolved.parts.vehicle.as_ref();
            let vehicle = vehicle.ok_or_else(|| {
                Stop::Usage(format!("{option} {text}: the speed of a vehicle needs a case with [vehicle]"))
            })?;
            quantity(option, text, Dimension::SPEED, "30 km/h").map(|speed| vehicle.secondary_speed(speed))
        };
        let of_secondary = |option: &str, text: &str| quantity(option, text, Dimension::ANGULAR_SPEED, "2000 rpm");
        if let Some(text) = &self.vehicle_speed {
            return of_vehicle("--vehicle-speed", text);
        }
        if let Some(text) = &self.secondary_speed {
            return of_secondary("--secondary-speed", text);
        }
        if let Some(text) = &self.speed {
            return match parse(text) {
                Ok(read) if read.expect(Dimension::SPEED).is_ok() && read.expect(Dimension::ANGULAR_SPEED).is_ok() => {
                    Err(Stop::Usage(format!(
                        "--speed {text}: of the secondary or of the vehicle? Give a unit such as \"2000 rpm\" or \
                         \"30 km/h\", or --secondary-speed in rad/s or --vehicle-speed in m/s"
                    )))
                }
                Ok(read) if read.expect(Dimension::SPEED).is_ok() => of_vehicle("--speed", text),
                Ok(_) | Err(_) => of_secondary("--speed", text),
            };
        }
        let given = case.settings().find_map(|(key, setting)| match setting {
            sheave::case::Setting::Number(value) if key == Key::SecondarySpeed => Some(value),
            _ => None,
        });
        given.ok_or_else(|| {
            Stop::Usage(
                "at which speed of the secondary? Give --speed \"2000 rpm\" or \"30 km/h\", or \
                 operating_point.secondary_speed in the case"
                    .to_owned(),
            )
        })
    }
}

/// A positive quantity from an option.
pub(super) fn quantity(option: &str, text: &str, dimension: Dimension, example: &str) -> Result<f64, Stop> {
    let read = parse(text).and_then(|quantity| quantity.expect(dimension));
    let wrong =
        |reason: String| Stop::Usage(format!("{option} {text}: {reason}; expected {dimension} such as \"{example}\""));
    match read {
        Ok(value) if value > 0.0 => Ok(value),
        Ok(_) => Err(wrong("not positive".to_owned())),
        Err(error) => Err(wrong(error.to_string())),
    }
}

/// Why there is no equilibrium.
pub(super) fn stop(error: EquilibriumError) -> Stop {
    if let EquilibriumError::Failure { failure, .. } = &error {
        tracing::info!("in full: {failure}");
        solver_words(failure);
    }
    match error.hint() {
        Some(hint) if error.is_bad_input() => Stop::Usage(format!("{error}\n{hint}")),
        None if error.is_bad_input() => Stop::Usage(error.to_string()),
        Some(hint) => Stop::Advised(error.to_string(), hint),
        None => Stop::NoSolution(error.to_string()),
    }
}
