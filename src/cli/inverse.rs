//! `sheave ramp` and `sheave helix`: the profiles that hold the engine at a speed.

use super::case::CaseArguments;
use super::drive::{Branch, quantity};
use super::envelope;
use super::output;
use super::solve::{share, tolerance};
use super::stop::Stop;
use clap::Args;
use serde::Serialize;
use sheave::actuator::{AngleFrom, Mechanism, PrimaryActuator};
use sheave::drive::SolveOptions;
use sheave::equilibrium::inverse::{
    Check, Inverse, InverseError, InverseOptions, InversePoint, Made, Outline, Shape, dxf, inverse, inverse_figures,
    inverse_summary, inverse_table, surface,
};
use sheave::equilibrium::{Direction, unused_keys};
use sheave::plot::Stack;
use sheave::quantity::{Dimension, rpm};
use sheave::study::Format;
use std::path::PathBuf;

/// Make the flyweights' profile that holds the engine at a speed over the whole shift
///
/// The belt is solved along the shift with the engine at the target's speed and torque, clamped by the case's helix and
/// springs; what it takes on the primary is what the flyweights have to give. For primary.actuator.type = "table" that
/// makes the list of coefficients, for "ramp" and "arm" the ramp, for "cam" the cam's pitch curve. The drive is then
/// solved forward with the profile as it is written. With --out the profile as CSV, as a part that a case names with
/// `file`, as DXF to scale and as figures. Profiles that cannot be made are refused with the reason.
#[derive(Debug, Args)]
#[command(after_long_help = super::STATUS)]
pub struct RampArguments {
    #[command(flatten)]
    common: Common,
    /// Radius of the roller of an arm: its ramp's surface is drawn beside the path of the roller's centre
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    roller_radius: Option<String>,
}

/// Make the helix that holds the engine at a speed over the whole shift
///
/// The belt is solved along the shift with the engine at the target's speed and torque, clamped by the case's
/// flyweights and spring; what it takes on the secondary beyond its spring is what the helix has to give, at an angle
/// that varies over the opening. The drive is then solved forward with the helix as it is written. With --out the helix
/// as CSV, as a part that a case names with `file`, unrolled as DXF to scale, and as figures. Profiles that cannot be
/// made are refused with the reason.
#[derive(Debug, Args)]
#[command(after_long_help = super::STATUS)]
pub struct HelixArguments {
    #[command(flatten)]
    common: Common,
}

#[derive(Debug, Args)]
struct Common {
    #[command(flatten)]
    case: CaseArguments,
    /// Speed to hold the engine at: "3400 rpm"
    #[arg(long, value_name = "SPEED", allow_hyphen_values = true)]
    target: String,
    /// Least slip reserve over the shift, as a share of the friction at hand, from 0 to below 1; with --both the
    /// reserve at every place: 0.3 or 30% [default: 0; 0.3 with --both]
    #[arg(long, value_name = "S", value_parser = share)]
    reserve: Option<f64>,
    /// Make both profiles: the helix for the slip reserve, the flyweights' for the speed
    #[arg(long)]
    both: bool,
    /// Which way the drive shifts, and so which way friction in the actuators acts
    #[arg(long, value_enum, default_value = "up")]
    direction: Branch,
    /// Points of the profile, from 5 to 1000
    #[arg(long, value_name = "N", default_value_t = 41)]
    points: usize,
    /// Places between them at which the drive is solved forward
    #[arg(long, value_name = "N", default_value_t = 9)]
    check: usize,
    /// Relative tolerance of the solutions, from 1e-12 to 0.1
    #[arg(long, value_name = "T", default_value = "1e-6", value_parser = tolerance)]
    tol: f64,
    /// Print the result as one JSON object
    #[arg(long)]
    json: bool,
    /// Write the table, the parts, DXF, the figure (SVG, PNG) and the object into this folder
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// A profile that was made: SI.
#[derive(Debug, Serialize, schemars::JsonSchema)]
struct ProfileTold<'a> {
    /// Section of the case file.
    section: &'static str,
    /// What the profile is: coefficient, ramp, roller, cam or helix.
    kind: &'static str,
    /// Travels, openings, places on the ramp, or distances from the pivot.
    places: &'a [f64],
    /// Coefficients, radii, angles of the pitch curve, or helix angles from the plane of rotation.
    values: &'a [f64],
}

#[derive(Debug, Serialize, schemars::JsonSchema)]
pub struct Told<'a> {
    edition: &'static str,
    made: Made,
    /// Speed asked for, rad/s.
    target: f64,
    /// Torque of the engine there, N·m.
    torque: f64,
    direction: Direction,
    /// Slip reserve asked for.
    reserve: f64,
    smallest_slip_reserve: f64,
    profiles: Vec<ProfileTold<'a>>,
    /// The belt along the shift.
    points: &'a [InversePoint],
    /// The drive solved forward.
    check: &'a Check,
}

pub fn ramp(arguments: &RampArguments) -> Result<(), Stop> {
    let roller = arguments.roller_radius.as_deref();
    let roller = roller.map(|text| quantity("--roller-radius", text, Dimension::LENGTH, "6.35 mm")).transpose()?;
    arguments.common.run("ramp", Made::Ramp, roller)
}

pub fn helix(arguments: &HelixArguments) -> Result<(), Stop> {
    arguments.common.run("helix", Made::Helix, None)
}

fn stop(error: InverseError) -> Stop {
    match error {
        InverseError::Case(error) => Stop::Input(error),
        error if error.is_bad_input() => Stop::Usage(error.to_string()),
        error => Stop::NoSolution(error.to_string()),
    }
}

impl Common {
    fn run(&self, command: &'static str, made: Made, roller: Option<f64>) -> Result<(), Stop> {
        let case = self.case.read_unswapped(command)?;
        let made = if self.both { Made::Both } else { made };
        let target = quantity("--target", &self.target, Dimension::ANGULAR_SPEED, "3400 rpm")?;
        let defaults = InverseOptions::new(target, made);
        let options = InverseOptions {
            reserve: self.reserve.unwrap_or(defaults.reserve),
            direction: self.direction.into(),
            points: self.points,
            checked: self.check,
            solve: SolveOptions { tolerance: self.tol, ..SolveOptions::default() },
            ..defaults
        };
        options.check().map_err(stop)?;
        let resolved = case.resolve()?;
        let mut warnings = unused_keys(&case);
        if resolved.thermal.is_some() {
            warnings.push("The belt is as stiff as the case gives it: its temperature is left out.".to_owned());
        }
        let actuation = resolved.parts.actuation.as_ref();
        if roller.is_some() && actuation.is_some_and(|parts| !has_roller(&parts.primary)) {
            return Err(Stop::Usage("--roller-radius is for primary.actuator.type = \"arm\"".to_owned()));
        }
        output::folder_place(self.out.as_deref())?;
        let found = inverse(&case, &options).map_err(stop)?;
        let outlines = outlines(&found, roller)?;
        warnings.extend(found.remarks());
        let warned = |warning: &String| tracing::warn!("{warning}");
        warnings.iter().for_each(warned);
        self.deliver(command, &found, &outlines, &warnings)
    }

    fn deliver(
        &self,
        command: &'static str,
        found: &Inverse,
        outlines: &[(&'static str, Vec<Outline>)],
        warnings: &[String],
    ) -> Result<(), Stop> {
        let resolved = found.case.resolve()?;
        let told = Told {
            edition: resolved.edition.name(),
            made: found.options.made,
            target: found.options.target,
            torque: found.torque,
            direction: found.options.direction,
            reserve: found.options.reserve,
            smallest_slip_reserve: found.smallest_reserve(),
            profiles: found.parts.iter().map(|part| profile(part.section, &part.shape)).collect(),
            points: &found.points,
            check: &found.check,
        };
        if let Some(folder) = &self.out {
            output::create_folder(folder)?;
            let object = envelope::object(command, &resolved, warnings, &told)?;
            output::write_file(folder, &format!("{command}.json"), |to| to.write_all(object.as_bytes()))?;
            let table = inverse_table(found);
            output::write_file(folder, &format!("{command}.csv"), |to| Format::Csv.write(&table, to))?;
            for part in &found.parts {
                let name = name_of(part.section);
                output::write_file(folder, &format!("{name}.toml"), |to| {
                    to.write_all(part_text(part, found).as_bytes())
                })?;
            }
            for (name, curves) in outlines.iter().filter(|(_, curves)| !curves.is_empty()) {
                output::write_file(folder, &format!("{name}.dxf"), |to| to.write_all(dxf(curves).as_bytes()))?;
            }
            let all: Vec<Outline> = outlines.iter().flat_map(|(_, curves)| curves.iter().cloned()).collect();
            let caption = "The profile that holds the engine at the target".to_owned();
            let stack = Stack { name: command.into(), caption, panels: inverse_figures(found, &all) };
            let (svg, png) = (stack.svg()?, stack.png()?);
            output::write_file(folder, &format!("{command}.svg"), |to| to.write_all(svg.as_bytes()))?;
            output::write_file(folder, &format!("{command}.png"), |to| to.write_all(&png))?;
        }
        if self.json {
            return output::print(&envelope::object(command, &resolved, warnings, &told)?);
        }
        let from = resolved.parts.actuation.as_ref().map_or(AngleFrom::Rotation, |parts| parts.angle_from);
        output::print(&inverse_summary(found, from))
    }
}

/// Whether a roller on an arm presses on the primary.
const fn has_roller(primary: &PrimaryActuator) -> bool {
    match primary {
        PrimaryActuator::Flyweights { flyweights, .. } => matches!(flyweights.mechanism, Mechanism::RollerArm(_)),
        PrimaryActuator::Force(_) | PrimaryActuator::Position(_) => false,
    }
}

/// The file's text: what it is for, and the keys.
fn part_text(part: &sheave::equilibrium::inverse::MadePart, found: &Inverse) -> String {
    let rpm = rpm(found.options.target);
    format!(
        "# Made to hold the engine at {rpm:.0} rpm and {:.2} N·m over the whole shift. A case names this file under \
        [{}]:\n\
         # file = \"{}.toml\"\n{}",
        found.torque,
        part.section,
        name_of(part.section),
        part.text
    )
}

fn name_of(section: &str) -> &'static str {
    if section.starts_with("secondary") { "helix" } else { "ramp" }
}

/// The curves of each part, by the name of its files; with the surface on which a roller of this radius runs.
fn outlines(found: &Inverse, roller: Option<f64>) -> Result<Vec<(&'static str, Vec<Outline>)>, Stop> {
    let mut all = Vec::new();
    for part in &found.parts {
        let mut curves = part.outlines.clone();
        if let (Shape::Roller(path), Some(radius)) = (&part.shape, roller) {
            let surface = surface(path, radius).map_err(|place| {
                Stop::NoSolution(format!(
                    "the ramp of a roller of {:.2} mm crosses itself at {:.2} mm: the path of the roller's centre is \
                     bent more tightly than the roller; give a smaller --roller-radius",
                    1e3 * radius,
                    1e3 * place
                ))
            })?;
            curves.push(surface);
        }
        all.push((name_of(part.section), curves));
    }
    Ok(all)
}

fn profile<'a>(section: &'static str, shape: &'a Shape) -> ProfileTold<'a> {
    let kind = match shape {
        Shape::Coefficient(_) => "coefficient",
        Shape::Ramp(_) => "ramp",
        Shape::Roller(_) => "roller",
        Shape::Cam(_) => "cam",
        Shape::Helix(..) => "helix",
    };
    let profile = shape.profile();
    ProfileTold { section, kind, places: profile.places(), values: profile.values() }
}
