//! `sheave optimum`: the clamp of best overall efficiency.

use super::design::{self, GridArguments};
use super::envelope;
use super::output;
use super::stop::Stop;
use clap::Args;
use serde::Serialize;
use sheave::design::{DriveState, OptimumPlace, optimum, optimum_figures, optimum_map};
use sheave::quantity::celsius;

/// Find the clamp of best overall efficiency for the torque of a case
///
/// A tight belt wastes power on its way in and out of the grooves, a loose one by slipping; between lies the best
/// clamp. With --over, a table over a grid of any keys, and with --out its figures.
#[derive(Debug, Args)]
#[command(after_long_help = super::STATUS)]
pub struct Arguments {
    #[command(flatten)]
    grid: GridArguments,
}

#[derive(Debug, Serialize, schemars::JsonSchema)]
pub struct Found {
    edition: &'static str,
    #[serde(flatten)]
    state: DriveState,
    bound: OptimumPlace,
    gradient: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    efficiency_with_losses: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    belt_temperature: Option<f64>,
    evaluations: usize,
}

pub fn run(arguments: &Arguments) -> Result<(), Stop> {
    let options = arguments.grid.options();
    if arguments.grid.is_grid() {
        let study = arguments.grid.study(options)?;
        let table = optimum_map(&study, arguments.grid.jobs(), &options)?;
        return arguments.grid.deliver(&study, &table, optimum_figures);
    }
    let case = arguments.grid.case().resolve()?;
    let best = optimum(&case, &options).map_err(design::stop)?;
    let found = Found {
        edition: case.edition.name(),
        state: best.state,
        bound: best.bound,
        gradient: best.gradient,
        efficiency_with_losses: best.efficiency_with_losses,
        belt_temperature: best.belt_temperature,
        evaluations: best.evaluations,
    };
    let json = || envelope::object("optimum", &case, &[], &found);
    output::print(&if arguments.grid.json() { json()? } else { summary(&found) })
}

fn summary(found: &Found) -> String {
    let state = &found.state;
    let what = match found.bound {
        OptimumPlace::Inner => "the best clamp",
        OptimumPlace::Loosest => "no maximum found: the loosest belt tried",
        OptimumPlace::Tightest => "no maximum found: the tightest belt tried",
    };
    let with_losses = found.efficiency_with_losses.map_or_else(
        || "  (of friction alone: --losses on maximises it with hysteresis, drag and gears)\n".to_owned(),
        |efficiency| format!("  efficiency with losses {:>9.3} %\n", 100.0 * efficiency),
    );
    let temperature = found
        .belt_temperature
        .map_or_else(String::new, |temperature| format!("  belt temperature      {:>10.2} °C\n", celsius(temperature)));
    format!(
        "Best clamp for {:.2} N·m, edition {}: {what}\n\n\
         \x20 overall efficiency    {:>10.3} %, d/d(slack tension) {:.1e} %/N\n\
         {with_losses}{temperature}\
         \x20 speed efficiency      {:>10.3} %\n\
         \x20 slack tension         {:>10.2} N\n\
         \x20 tight tension         {:>10.2} N\n\
         \x20 primary axial force   {:>10.2} N\n\
         \x20 secondary axial force {:>10.2} N\n\
         \x20 {} solutions\n",
        state.primary_torque,
        found.edition,
        100.0 * state.overall_efficiency,
        100.0 * found.gradient,
        100.0 * state.speed_efficiency,
        state.slack_tension,
        state.tight_tension,
        state.primary_axial_force,
        state.secondary_axial_force,
        found.evaluations,
    )
}
