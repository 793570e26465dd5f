//! `sheave limit`: the largest torque for a clamp, the smallest clamp for a torque.

use super::design::{self, GridArguments};
use super::envelope;
use super::output;
use super::stop::Stop;
use clap::Args;
use serde::Serialize;
use sheave::case::Resolved;
use sheave::design::{
    ClampLimits, Limit, LimitKind, LimitOptions, largest_torque, limit_figures, limit_map, smallest_clamps,
};
use sheave::quantity::{celsius, unsigned_zero};
use std::fmt::Write;

/// Find the largest torque for the clamp of a case, and the smallest clamps for its torque
///
/// Follows the drive from an operating point to a speed efficiency of 95 %, below which it slips and burns its belt; a
/// limit is a fold on the way, or that end. With --stall it is followed until the secondary stands still. With --over,
/// a table over a grid of any keys, and with --out its figures.
#[derive(Debug, Args)]
#[command(after_long_help = super::STATUS)]
pub struct Arguments {
    #[command(flatten)]
    grid: GridArguments,
    /// Count the drive as slipping below this speed efficiency, from 0 to 1: what a workshop calls the limit
    #[arg(long, value_name = "S", default_value = "0.95", value_parser = share)]
    least_speed_efficiency: f64,
    /// Follow the drive to the stall of its secondary, as --least-speed-efficiency 0 does: what the model bears, and no
    /// belt
    #[arg(long, conflicts_with = "least_speed_efficiency")]
    stall: bool,
}

#[derive(Debug, Serialize, schemars::JsonSchema)]
pub struct Found<'a> {
    edition: &'static str,
    #[serde(skip)]
    inputs: &'a Resolved,
    largest_torque: Limit,
    smallest_clamp: Option<ClampLimits>,
}

pub fn run(arguments: &Arguments) -> Result<(), Stop> {
    let solve = arguments.grid.options();
    let least_speed_efficiency = if arguments.stall { 0.0 } else { arguments.least_speed_efficiency };
    let options = LimitOptions { solve, least_speed_efficiency };
    if arguments.grid.is_grid() {
        let study = arguments.grid.study(solve)?;
        let table = limit_map(&study, arguments.grid.jobs(), &options)?;
        return arguments.grid.deliver(&study, &table, limit_figures);
    }
    let case = arguments.grid.case().resolve()?;
    let (largest_torque, _) = largest_torque(&case, &options).map_err(design::stop)?;
    // A case whose load is a speed has no torque to find a clamp for.
    let smallest_clamp = match smallest_clamps(&case, &options) {
        Ok((limits, _)) => Some(limits),
        Err(error) if error.is_bad_input() => None,
        Err(error) => return Err(design::stop(error)),
    };
    let edition = case.edition.name();
    let found = Found { edition, inputs: &case, largest_torque, smallest_clamp };
    let warnings: Vec<String> = bounds(&found).into_iter().chain(loose(&found)).collect();
    warnings.iter().for_each(|warning| tracing::warn!("{warning}"));
    let json = || envelope::object("limit", &case, &warnings, &found);
    output::print(&if arguments.grid.json() { json()? } else { summary(&found) })
}

/// That of some limits only bounds are known, where curves were lost.
fn bounds(found: &Found<'_>) -> Option<String> {
    let torque = ("largest torque".to_owned(), &found.largest_torque);
    let clamps = found.smallest_clamp.iter().flat_map(smallest);
    let lost = [torque].into_iter().chain(clamps).filter(|(_, limit)| matches!(limit.kind, LimitKind::Lost(_)));
    let names: Vec<String> = lost.map(|(name, _)| name).collect();
    (!names.is_empty()).then(|| {
        format!(
            "Only a bound is known, which may be far from the limit, of: {}. The curve there was lost: with a \
             larger `sheave.slip_threshold`, where friction is less steep, or in another edition it may be followed.",
            names.join(", ")
        )
    })
}

/// That the slack strand is held by inertia alone, which no case can ask for.
fn loose(found: &Found<'_>) -> Option<String> {
    let smallest = found.smallest_clamp.as_ref()?.slack_tension.value;
    (smallest < 0.0).then(|| {
        "The smallest slack tension is below zero: tractive tension is what centrifugal force leaves, and there it is \
         that force alone which keeps the slack span taut. As `operating_point.slack_tension`, only tensions above \
         zero are accepted."
            .to_owned()
    })
}

/// The smallest clamps, each with its name.
fn smallest(clamps: &ClampLimits) -> [(String, &Limit); 3] {
    [
        ("slack tension", &clamps.slack_tension),
        ("primary axial force", &clamps.primary_axial_force),
        ("secondary axial force", &clamps.secondary_axial_force),
    ]
    .map(|(clamp, limit)| (format!("smallest {clamp}"), limit))
}

fn summary(found: &Found<'_>) -> String {
    let mut text = format!("Limits of the drive, edition {}\n\n", found.edition);
    let (key, clamp) = found.inputs.operating_point.clamp.setting();
    let name = |name: &str| name.replace('_', " ");
    line(
        &mut text,
        &format!("largest torque for a {} of {clamp:.1} N", name(key.entry().name())),
        "N·m",
        &found.largest_torque,
    );
    if let Some(clamps) = &found.smallest_clamp {
        let (key, torque) = found.inputs.operating_point.load.setting();
        let load = format!("for a {} of {torque:.2} N·m", name(key.entry().name()));
        for (name, limit) in smallest(clamps) {
            line(&mut text, &format!("{name} {load}"), "N", limit);
        }
    }
    text
}

fn line(text: &mut String, what: &str, unit: &str, limit: &Limit) {
    let kind = match &limit.kind {
        LimitKind::Fold => "a fold".to_owned(),
        LimitKind::Collapse => "collapse of the speed ratio".to_owned(),
        LimitKind::SpeedEfficiency => "the least speed efficiency".to_owned(),
        LimitKind::Lost(reason) => {
            tracing::info!("{what}: {reason}");
            "the limit lies beyond: no solution was found farther on (-v says why)".to_owned()
        }
    };
    let [value, efficiency] = [format!("{:.3}", limit.value), format!("{:.1}", 100.0 * limit.state.speed_efficiency)];
    let [value, efficiency] = [&value, &efficiency].map(|number| unsigned_zero(number));
    let warm =
        limit.belt_temperature.map_or_else(String::new, |kelvin| format!(", the belt at {:.1} °C", celsius(kelvin)));
    // Writing to a string cannot fail.
    let _ = writeln!(text, "  {what:<64} {value:>10} {unit:<4} at {efficiency} % speed efficiency{warm}: {kind}");
}

fn share(text: &str) -> Result<f64, String> {
    let within = |share: &f64| (0.0..1.0).contains(share);
    text.parse().ok().filter(within).ok_or_else(|| "expected a number from 0 to below 1, such as 0.9".into())
}
