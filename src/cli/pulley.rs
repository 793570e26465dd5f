//! `sheave pulley`: Euler's relation beside the full model.

use super::case::CaseArguments;
use super::envelope;
use super::output;
use super::solve::tolerance;
use super::stop::Stop;
use clap::{Args, ValueEnum};
use serde::Serialize;
use sheave::drive::SolveOptions;
use sheave::result::{Comparison, Grip, PulleyComparison, compare, run as solve, warnings};
use std::fmt::Write;

/// Compare the belt pulley of a drive line with the full model
///
/// Solves the case with the full model and asks what a pulley that knows nothing but Euler's relation makes of the
/// tensions: how much of its friction they take, how fast its belt would creep, and its torque. The equations are in
/// docs/small-models.md.
#[derive(Debug, Args)]
#[command(after_long_help = super::STATUS)]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// How the component's belt grips
    #[arg(long, value_enum, default_value = "v")]
    belt: Belt,
    /// Relative tolerance of the full model's solution, from 1e-12 to 0.1
    #[arg(long, value_name = "T", default_value = "1e-6", value_parser = tolerance)]
    tol: f64,
    /// Print the result as one JSON object, in SI units
    #[arg(long)]
    json: bool,
}

/// How a belt grips.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum, Serialize)]
#[serde(rename_all = "snake_case")]
enum Belt {
    /// Friction on both faces of the groove
    V,
    /// Friction on the circumference
    Flat,
    /// No slip
    Ideal,
}

impl Belt {
    fn grip(self) -> Grip {
        match self {
            Self::V => Grip::V,
            Self::Flat => Grip::Flat,
            Self::Ideal => Grip::Ideal,
        }
    }
}

#[derive(Debug, Serialize)]
struct Object<'a> {
    edition: &'static str,
    converged: bool,
    belt: Belt,
    #[serde(flatten)]
    comparison: &'a Comparison,
}

pub fn run(arguments: &Arguments) -> Result<(), Stop> {
    let case = arguments.case.resolve()?;
    let options = SolveOptions { tolerance: arguments.tol, ..SolveOptions::default() };
    let outcome = solve(&case, &options).map_err(|failure| Stop::from(&failure))?;
    let comparison = compare(&outcome, arguments.belt.grip()).map_err(|error| Stop::NoSolution(error.to_string()))?;
    let (edition, belt) = (case.edition.name(), arguments.belt);
    let object = Object { edition, converged: true, belt, comparison: &comparison };
    let json = || envelope::object("pulley", &case, &warnings(&outcome), &object);
    output::print(&if arguments.json { json()? } else { summary(&object) })
}

fn summary(object: &Object<'_>) -> String {
    let belt = match object.belt {
        Belt::V => "V-belt",
        Belt::Flat => "flat belt",
        Belt::Ideal => "ideal belt",
    };
    let mut text = format!("Belt pulley, {belt}, beside the full model, edition {}\n\n", object.edition);
    let Comparison { primary, secondary } = object.comparison;
    // Writing to a string cannot fail.
    let _ = writeln!(text, "  {:<38}{:>12}{:>12}", "", "primary", "secondary");
    let mut row = |name: &str, unit: &str, digits: usize, value: fn(&PulleyComparison) -> Option<f64>| {
        let cell = |pulley| value(pulley).map_or("-".to_owned(), |value| format!("{value:.digits$}"));
        let _ = writeln!(text, "  {name:<38}{:>12}{:>12}  {unit}", cell(primary), cell(secondary));
    };
    row("tight tension, full model", "N", 2, |pulley| Some(pulley.tight_tension));
    row("slack tension, full model", "N", 2, |pulley| Some(pulley.slack_tension));
    row("tension ratio, full model", "", 4, |pulley| Some(pulley.tension_ratio));
    row("largest ratio, Euler", "", 2, |pulley| pulley.largest_ratio);
    row("share of the friction taken", "%", 2, |pulley| Some(100.0 * pulley.share));
    row("wrap angle", "deg", 2, |pulley| Some(pulley.wrap_angle.to_degrees()));
    row("coefficient of friction", "", 4, |pulley| pulley.effective_coefficient);
    row("sliding speed, component", "mm/s", 4, |pulley| pulley.sliding_speed.map(|speed| 1e3 * speed));
    row("sliding speed, full model, smallest", "mm/s", 4, |pulley| Some(1e3 * pulley.full_min_sliding_speed));
    row("sliding speed, full model, largest", "mm/s", 4, |pulley| Some(1e3 * pulley.full_max_sliding_speed));
    row("torque, component", "N·m", 4, |pulley| Some(pulley.torque));
    row("torque, full model", "N·m", 4, |pulley| Some(pulley.full_torque));
    row("friction loss, component", "W", 4, |pulley| pulley.friction_loss);
    row("friction loss, full model", "W", 4, |pulley| Some(pulley.full_friction_loss));
    text
}
