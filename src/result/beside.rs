//! Two results side by side.

use std::fmt::Write;

use super::schema::DriveResult;
use super::units::{Measured, Units};
use crate::case::Resolved;

type Result = DriveResult<Resolved>;

/// A quantity by its name, what it measures and its digits in workshop units, read off a result.
type Row = (&'static str, Measured, usize, fn(&Result) -> f64);

const ROWS: [Row; 17] = [
    ("primary axial force", Measured::Force, 1, |r| r.primary.axial_force),
    ("secondary axial force", Measured::Force, 1, |r| r.secondary.axial_force),
    ("slack tension", Measured::Force, 1, |r| r.primary.exit_tension),
    ("tight tension", Measured::Force, 1, |r| r.primary.entry_tension),
    ("primary torque", Measured::Torque, 3, |r| r.primary.torque),
    ("secondary torque", Measured::Torque, 3, |r| r.secondary.torque),
    ("primary speed", Measured::Speed, 1, |r| r.primary.speed),
    ("secondary speed", Measured::Speed, 1, |r| r.secondary.speed),
    ("power in", Measured::Power, 1, |r| r.energy.power_in),
    ("power out", Measured::Power, 1, |r| r.energy.power_out),
    ("friction loss", Measured::Power, 1, |r| r.energy.friction_loss),
    ("primary radius", Measured::Length, 2, |r| r.primary.radius),
    ("secondary radius", Measured::Length, 2, |r| r.secondary.radius),
    ("primary penetration", Measured::Length, 3, |r| r.primary.max_penetration),
    ("secondary penetration", Measured::Length, 3, |r| r.secondary.max_penetration),
    ("primary wrap angle", Measured::Angle, 2, |r| r.primary.wrap_angle),
    ("belt length", Measured::Length, 2, |r| r.belt.unstretched_length),
];

/// A share by its name, read off a result.
type Share = (&'static str, fn(&Result) -> Option<f64>);

/// Shares by their names; absent where they mean nothing.
const SHARES: [Share; 5] = [
    ("efficiency", |r| r.efficiency.overall),
    ("speed efficiency", |r| r.efficiency.speed),
    ("torque efficiency", |r| r.efficiency.torque),
    ("efficiency, all losses", |r| r.efficiency.overall_with_losses),
    ("slip reserve", |r| Some(r.slip_reserve)),
];

/// A table of two results and their differences, the second less the first.
pub fn beside(units: Units, names: [&str; 2], results: [&Result; 2]) -> String {
    let [first, second] = names;
    let mut text = format!("  {:<26}{first:>16}{second:>16}{:>16}\n", "", "difference");
    let editions = results.map(|result| result.edition.as_str());
    // Writing to a string cannot fail.
    let _ = writeln!(text, "  {:<26}{:>16}{:>16}", "edition", editions[0], editions[1]);
    let mut row = |name: &str, cells: [String; 3], unit: &str| {
        let [a, b, difference] = cells;
        let line = format!("  {name:<26}{a:>16}{b:>16}{difference:>16}  {unit}");
        let _ = writeln!(text, "{}", line.trim_end());
    };
    for (name, value) in SHARES {
        let [a, b] = results.map(value);
        let show = |value: Option<f64>| value.map_or("-".to_owned(), |value| format!("{:.2}", 100.0 * value));
        let difference = a.zip(b).map(|(a, b)| b - a);
        row(name, [show(a), show(b), signed(show(difference))], "%");
    }
    for (name, what, digits, value) in ROWS {
        let unit = units.of(what);
        let [a, b] = results.map(value);
        let cells = [unit.number(a, digits), unit.number(b, digits), signed(unit.number(b - a, digits))];
        row(name, cells, unit.symbol);
    }
    text
}

/// A difference with its sign.
fn signed(number: String) -> String {
    if number.starts_with('-') { number } else { format!("+{number}") }
}
