//! `sheave init`: the simple belt drive.

use super::case::CaseArguments;
use super::envelope;
use super::output;
use super::stop::Stop;
use clap::Args;
use serde::Serialize;
use sheave::quantity::rpm;
use sheave::small::init::{InitError, InitialState, Method, PulleyId, SimpleDrive, Situation, solve};
use std::fmt::Write;

/// Where a drive starts: belt speed, speeds, torques and axial forces of the simple belt drive
///
/// The belt adheres where it enters a pulley, slides before it leaves, and does not move in its groove: closed forms,
/// or two equations by Newton's method. The case's operating point has to be one of the seven situations that are
/// listed below. The equations are in docs/small-models.md.
#[derive(Debug, Args)]
#[command(after_long_help = SITUATIONS.to_owned() + super::STATUS)]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// Without a torque, in closed form; a second speed follows from the primary's
    #[arg(long)]
    no_load: bool,
    /// Print the result as one JSON object, in SI units
    #[arg(long)]
    json: bool,
}

/// What may be given.
const SITUATIONS: &str = "\
Situations, by the keys of [operating_point]:
  1  primary_speed    secondary_torque                 secondary_axial_force
  2  secondary_speed  primary_torque                   primary_axial_force
  3  primary_speed    secondary_speed or speed_ratio   secondary_axial_force
  4  primary_speed    secondary_speed or speed_ratio   primary_axial_force
  5  primary_speed    secondary_torque                 primary_axial_force
  6  primary_speed    primary_torque                   secondary_axial_force
  7  primary_speed    primary_torque                   primary_axial_force
So that with the base case's speed and torque: sheave init --set operating_point.secondary_axial_force=\"550 N\"

";

/// The result object: keys as those of `solve --json` where they mean the same.
#[derive(Debug, Serialize, schemars::JsonSchema)]
pub struct Object {
    converged: bool,
    situation: u8,
    primary: Pulley,
    secondary: Pulley,
    belt: Belt,
    iterations: usize,
}

/// Torques are positive where the primary drives.
#[derive(Debug, Serialize, schemars::JsonSchema)]
struct Pulley {
    speed: f64,
    torque: f64,
    power: f64,
    axial_force: f64,
    contact_angle: f64,
    sliding_angle: f64,
}

#[derive(Debug, Serialize, schemars::JsonSchema)]
struct Belt {
    speed: f64,
    lift_off_force: f64,
    tight_force: f64,
    slack_force: f64,
    tight_tension: f64,
    slack_tension: f64,
}

pub fn run(arguments: &Arguments) -> Result<(), Stop> {
    let case = arguments.case.read_unswapped("init")?.resolve()?;
    let situation = Situation::of_case(&case, arguments.no_load).map_err(stop)?;
    let drive = SimpleDrive::of_case(&case);
    let state = solve(&drive, situation).map_err(stop)?;
    let object = object(situation, &drive, &state);
    let json = || envelope::object("init", &case, &[], &object);
    output::print(&if arguments.json { json()? } else { summary(&object) })
}

fn stop(error: InitError) -> Stop {
    let stop = match error {
        InitError::Given { .. } | InitError::NoSituation | InitError::FreeRadius => Stop::Usage,
        _ => Stop::NoSolution,
    };
    stop(error.to_string())
}

fn object(situation: Situation, drive: &SimpleDrive, state: &InitialState) -> Object {
    let pulley = |id: PulleyId, speed: f64, torque: f64, axial_force: f64| Pulley {
        speed,
        torque,
        power: torque * speed,
        axial_force,
        contact_angle: drive.contact_angle(id),
        sliding_angle: state.sliding_angle,
    };
    Object {
        converged: true,
        situation: situation.number(),
        // The belt brakes the primary: without the sign, and without −0.
        primary: pulley(PulleyId::Input, state.input_speed, 0.0 - state.input_torque, state.input_axial_force),
        secondary: pulley(PulleyId::Output, state.output_speed, state.output_torque, state.output_axial_force),
        belt: Belt {
            speed: state.belt_speed,
            lift_off_force: state.lift_off_force,
            tight_force: state.tight_force,
            slack_force: state.slack_force,
            tight_tension: state.tight_tension,
            slack_tension: state.slack_tension,
        },
        iterations: match state.method {
            Method::Closed => 0,
            Method::Newton { iterations } => iterations,
        },
    }
}

fn summary(object: &Object) -> String {
    let mut text = format!("Simple belt drive, situation {}\n\n", object.situation);
    // Writing to a string cannot fail.
    let _ = writeln!(text, "  {:<26}{:>12}{:>12}", "", "primary", "secondary");
    let mut row = |name: &str, unit: &str, digits: usize, value: fn(&Pulley) -> f64| {
        let (primary, secondary) = (value(&object.primary), value(&object.secondary));
        let _ = writeln!(text, "  {name:<26}{primary:>12.digits$}{secondary:>12.digits$}  {unit}");
    };
    row("speed", "rpm", 2, |pulley| rpm(pulley.speed));
    row("torque", "N·m", 3, |pulley| pulley.torque);
    row("power", "W", 1, |pulley| pulley.power);
    row("axial force", "N", 1, |pulley| pulley.axial_force);
    row("contact angle", "deg", 2, |pulley| pulley.contact_angle.to_degrees());
    row("of which sliding", "deg", 2, |pulley| pulley.sliding_angle.to_degrees());
    let belt = &object.belt;
    let _ = writeln!(text, "\n  belt, unstretched         {:>12.5} m/s", belt.speed);
    let _ = writeln!(text, "  {:<26}{:>12}{:>12}", "", "tight span", "slack span");
    let mut row = |name: &str, tight: f64, slack: f64| {
        // Where the belt brakes, the span that would be slack is the tight one.
        let (tight, slack) = (tight.max(slack), tight.min(slack));
        let _ = writeln!(text, "  {name:<26}{tight:>12.2}{slack:>12.2}  N");
    };
    row("longitudinal force", belt.tight_force, belt.slack_force);
    row("tractive tension", belt.tight_tension, belt.slack_tension);
    if belt.tight_force < belt.slack_force {
        let _ = writeln!(text, "  the belt brakes: the tight span runs off the primary");
    }
    let found = match object.iterations {
        0 => "in closed form".to_owned(),
        steps => format!("by {steps} steps of Newton's method"),
    };
    let _ = writeln!(text, "\n  found {found}");
    text
}
