//! `sheave radii`: where a belt runs on its two pulleys.

use super::case::CaseArguments;
use super::measured::{object, refused};
use super::output;
use super::stop::Stop;
use clap::Args;
use serde::Serialize;
use sheave::bench::BenchError;
use sheave::bench::radii::{Geometry, Limits, Radii, ShiftRange};
use sheave::case::Key;
use sheave::quantity::{self, Dimension};
use std::fmt::Write;

/// Find the radii at which a belt runs
///
/// From one radius to the other, from the ratio R_S/R_P to both, from what the movable sheave of the primary travels to
/// both, and back, for the case's belt.length, drive.center_distance and sheave.half_angle (6.12). Without any of them
/// the case's own primary radius applies. With the limits of both pulleys, the shift range too.
#[derive(Debug, Args)]
#[command(after_help = super::STATUS)]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// Radius of the belt on the primary: "60 mm"
    #[arg(long, value_name = "R", group = "given", value_parser = length, allow_hyphen_values = true)]
    primary: Option<f64>,
    /// Radius of the belt on the secondary
    #[arg(long, value_name = "R", group = "given", value_parser = length, allow_hyphen_values = true)]
    secondary: Option<f64>,
    /// Ratio R_S/R_P
    #[arg(long, value_name = "i", group = "given", allow_hyphen_values = true)]
    ratio: Option<f64>,
    /// What the movable sheave of the primary has travelled from --from, positive to close: "3 mm"
    #[arg(long, value_name = "s", group = "given", value_parser = length, allow_hyphen_values = true)]
    travel: Option<f64>,
    /// Radius on the primary from which travel is counted; the case's if it is not given
    #[arg(long, value_name = "R", value_parser = length, allow_hyphen_values = true)]
    from: Option<f64>,
    /// Smallest and largest radius that the primary has room for: "45 mm..93 mm"
    #[arg(long, value_name = "A..B", value_parser = limits, requires = "secondary_limits")]
    primary_limits: Option<(f64, f64)>,
    /// The same for the secondary
    #[arg(long, value_name = "A..B", value_parser = limits, requires = "primary_limits")]
    secondary_limits: Option<(f64, f64)>,
    /// Print the result as one JSON object, in SI units
    #[arg(long)]
    json: bool,
}

#[derive(Debug, Serialize, schemars::JsonSchema)]
pub struct Inputs {
    #[serde(flatten)]
    geometry: Geometry,
    travel_from: f64,
    primary_limits: Option<(f64, f64)>,
    secondary_limits: Option<(f64, f64)>,
}

#[derive(Debug, Serialize, schemars::JsonSchema)]
pub struct Found {
    #[serde(flatten)]
    radii: Radii,
    /// From `travel_from`, positive to close.
    primary_travel: f64,
    /// From where the belt runs beside `travel_from`, positive to close.
    secondary_travel: f64,
    shift_range: Option<ShiftRange>,
}

fn length(text: &str) -> Result<f64, String> {
    let read = quantity::parse(text).and_then(|quantity| quantity.expect(Dimension::LENGTH));
    read.map_err(|error| format!("{error}; expected a length, such as \"60 mm\""))
}

fn limits(text: &str) -> Result<(f64, f64), String> {
    let (low, high) = text.split_once("..").ok_or("expected two lengths, such as \"45 mm..93 mm\"")?;
    // One unit at the end serves for both.
    let unit = high.trim().trim_start_matches(|c: char| c.is_ascii_digit() || "+-.eE".contains(c));
    let bare = low.trim().parse::<f64>().is_ok();
    let low = if bare { format!("{} {unit}", low.trim()) } else { low.to_owned() };
    Ok((length(&low)?, length(high)?))
}

pub fn run(arguments: &Arguments) -> Result<(), Stop> {
    let mut case = arguments.case.read_unswapped("radii")?;
    // The base case has those of this ratio, for its own belt: others need not fit around its radii.
    if ![Key::PrimaryRadius, Key::SecondaryRadius, Key::Ratio, Key::Free].into_iter().any(|key| case.has(key)) {
        case.set_si(Key::Ratio, 1.0)?;
    }
    let case = case.resolve()?;
    let geometry = Geometry {
        pitch_length: case.belt.length,
        center_distance: case.drive.center_distance,
        half_angle: case.sheave.half_angle,
    };
    let from = arguments.from.unwrap_or(case.drive.primary_radius);
    let found = arguments.found(&geometry, from, case.drive.primary_radius);
    let found = found.map_err(|error| refused("radii", arguments.json, error))?;
    if !arguments.json {
        return output::print(&summary(&geometry, from, &found));
    }
    let (primary_limits, secondary_limits) = (arguments.primary_limits, arguments.secondary_limits);
    let inputs = serde_json::json!(Inputs { geometry, travel_from: from, primary_limits, secondary_limits });
    output::print(&object("radii", inputs, &[], &found)?)
}

impl Arguments {
    fn found(&self, geometry: &Geometry, from: f64, own: f64) -> Result<Found, BenchError> {
        let radii = match (self.primary, self.secondary, self.ratio, self.travel) {
            (Some(radius), ..) => geometry.at_primary(radius),
            (_, Some(radius), ..) => geometry.at_secondary(radius),
            (_, _, Some(ratio), _) => geometry.at_ratio(ratio),
            (_, _, _, Some(travel)) => geometry.at_travel(travel, from),
            (None, None, None, None) => geometry.at_primary(own),
        }?;
        let beside = geometry.at_primary(from)?;
        let limits = self.primary_limits.zip(self.secondary_limits);
        let limits = limits.map(|(primary, secondary)| Limits { primary, secondary });
        Ok(Found {
            radii,
            primary_travel: geometry.travel(from, radii.primary_radius),
            secondary_travel: geometry.travel(beside.secondary_radius, radii.secondary_radius),
            shift_range: limits.map(|limits| geometry.shift_range(&limits)).transpose()?,
        })
    }
}

fn summary(geometry: &Geometry, from: f64, found: &Found) -> String {
    let mut text = format!(
        "Belt of pitch length {:.2} mm, centres {:.2} mm apart, half angle {:.2} deg\n\n",
        1e3 * geometry.pitch_length,
        1e3 * geometry.center_distance,
        geometry.half_angle.to_degrees()
    );
    let mut row = |name: &str, value: f64, unit: &str| {
        let _ = writeln!(text, "  {name:<36}{value:>12.4} {unit}"); // writing to a string does not fail
    };
    let radii = &found.radii;
    row("primary radius R_P", 1e3 * radii.primary_radius, "mm");
    row("secondary radius R_S", 1e3 * radii.secondary_radius, "mm");
    row("ratio R_S/R_P", radii.ratio, "");
    row("wrap angle of the primary", radii.primary_wrap_angle.to_degrees(), "deg");
    row("wrap angle of the secondary", radii.secondary_wrap_angle.to_degrees(), "deg");
    row("length of a span", 1e3 * radii.span_length, "mm");
    row(&format!("primary travel from R_P = {:.3} mm", 1e3 * from), 1e3 * found.primary_travel, "mm");
    row("secondary travel", 1e3 * found.secondary_travel, "mm");
    if let Some(range) = &found.shift_range {
        row("lowest range, R_S/R_P", range.low.ratio, "");
        row("highest range, R_S/R_P", range.high.ratio, "");
        row("lowest over highest", range.span, "");
        row("primary radius, lowest range", 1e3 * range.low.primary_radius, "mm");
        row("primary radius, highest range", 1e3 * range.high.primary_radius, "mm");
        row("primary closes by", 1e3 * range.primary_travel, "mm");
        row("secondary opens by", 1e3 * range.secondary_travel, "mm");
    }
    text
}
