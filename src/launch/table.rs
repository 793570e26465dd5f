//! A launch as a table and in words.

use std::fmt::Write;

use serde_json::Number;

use super::run::{Launch, LaunchPhase, LaunchPoint};
use crate::quantity::{km_per_h, rpm, unsigned_zero, with_digits};
use crate::study::{Cell, Table};

/// The launch over time, one row a moment; SI.
pub fn launch_table(launch: &Launch) -> Table {
    let columns = [
        "time",
        "speed",
        "distance",
        "acceleration",
        "phase",
        "engine_speed",
        "secondary_speed",
        "ratio",
        "power_in",
        "power_out",
        "heat",
    ];
    let number = |value: f64| Number::from_f64(value).map_or(Cell::Empty, Cell::Number);
    let row = |point: &LaunchPoint| {
        let phase = Cell::Text(phase_name(point.phase).into());
        let before = [point.time, point.speed, point.distance, point.acceleration].map(number);
        let after =
            [point.engine_speed, point.secondary_speed, point.ratio, point.power_in, point.power_out, point.heat];
        before.into_iter().chain([phase]).chain(after.map(number)).collect()
    };
    Table {
        columns: columns.iter().map(|name| (*name).to_owned()).collect(),
        rows: launch.points.iter().map(row).collect(),
    }
}

pub(super) const fn phase_name(phase: LaunchPhase) -> &'static str {
    match phase {
        LaunchPhase::Clutch => "clutch",
        LaunchPhase::Belt => "belt",
    }
}

/// What a person reads at a glance.
pub fn launch_summary(launch: &Launch) -> String {
    let mut text = String::from("Launch from standstill at the case's throttle\n\n");
    let foot = 0.3048;
    let mut line = |name: &str, value: String| {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "  {name:<26}{value}");
    };
    let lock = &launch.lock_up;
    let first = launch.points.first().map_or(0.0, |point| point.engine_speed);
    line(
        "clutch slips until",
        format!(
            "{:.2} s, {:.1} m, {:.1} km/h; the engine runs at {:.0} rpm",
            lock.time,
            lock.distance,
            km_per_h(lock.speed),
            rpm(first)
        ),
    );
    for mark in &launch.marks {
        line(
            &format!("{} ft ({} m)", with_digits(mark.distance / foot, 0), with_digits(mark.distance, 2)),
            format!("{:.3} s, at {:.1} km/h", mark.time, km_per_h(mark.speed)),
        );
    }
    let top = if launch.limited_by_curve { "end of the shift curve" } else { "top speed" };
    line(
        top,
        format!(
            "{:.1} km/h; {:.1} km/h after {:.2} s and {:.1} m",
            km_per_h(launch.top_speed),
            km_per_h(launch.done.speed),
            launch.done.time,
            launch.done.distance
        ),
    );
    let energy = &launch.energy;
    let share = |part: f64| {
        let (kilojoules, percent) = (format!("{:.1}", 1e-3 * part), format!("{:.1}", 100.0 * part / energy.engine));
        format!("{} kJ, {} %", unsigned_zero(&kilojoules), unsigned_zero(&percent))
    };
    let end = &launch.end;
    line(
        "energy from the engine",
        format!("{:.1} kJ over {:.2} s and {:.1} m, of which", 1e-3 * energy.engine, end.time, end.distance),
    );
    for (name, part) in [
        ("  heat in the clutch", energy.clutch_heat),
        ("  heat in the CVT after", energy.belt_heat),
        ("  heat in the final drive", energy.final_drive_heat),
        ("  rolling, grade, air", energy.resistance),
        ("  the moving vehicle", energy.kinetic),
    ] {
        line(name, share(part));
    }
    text
}
