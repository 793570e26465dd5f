//! `sheave keys`: the keys of a case file, from their table.

use super::output;
use super::stop::Stop;
use clap::Args;
use sheave::case::{Choice, Entry, RangeEnd, TABLE, ValueKind};
use std::fmt::Write;

/// List the keys of a case file with their units, ranges and defaults
#[derive(Debug, Args)]
pub struct Arguments {}

pub fn run(_: &Arguments) -> Result<(), Stop> {
    output::print(&table())
}

/// All keys by section, for people to read.
pub fn table() -> String {
    let mut text = String::from(
        "Keys of a case file; every one is optional. A quantity is a string with a unit (\"68.3 mm\", \"60 lbf\") or a \
         bare\nnumber in SI units. On the command line: --set section.key=value.\n",
    );
    let mut section = "";
    for entry in &TABLE {
        if entry.section() != section {
            section = entry.section();
            let _ = writeln!(text, "\n[{section}]"); // writing to a string does not fail
            text += note(section);
        } else if section.is_empty() {
            text.push('\n');
        }
        text += &line(entry);
        if let ValueKind::Choice { choices, .. } = entry.kind {
            text.extend(choices.iter().map(explain));
        }
    }
    text
}

/// What holds between the keys of a section.
fn note(section: &str) -> &'static str {
    match section {
        "drive" => "  # either both radii, or their ratio\n",
        "operating_point" => {
            "  # three slots, one key for each:\n\
             \x20 #   speed: primary_speed | secondary_speed\n\
             \x20 #   load:  primary_torque | secondary_torque | speed_ratio | the second speed, when both are given\n\
             \x20 #   clamp: slack_tension | tight_tension | primary_axial_force | secondary_axial_force |\n\
             \x20 #          slip_reserve | friction_utilization\n\
             \x20 # and with drive.free = \"both\" one key more\n"
        }
        _ => "",
    }
}

fn line(entry: &Entry) -> String {
    let (default, range) = match entry.kind {
        ValueKind::Quantity { unit, range, base, .. } => {
            let default = if base { entry.example() } else { "-".into() };
            // That it is positive goes without saying.
            let range = match range.low {
                RangeEnd::Open(0.0) if range.high == RangeEnd::None => String::new(),
                _ => format!("; {}", range.words(unit.symbol)),
            };
            (default, range)
        }
        ValueKind::List { unit, range, .. } => {
            let range = match (range.low, range.high) {
                (RangeEnd::None, RangeEnd::None) | (RangeEnd::Open(0.0), RangeEnd::None) => String::new(),
                _ => format!("; each {}", range.words(unit.symbol)),
            };
            ("list".into(), range)
        }
        ValueKind::Choice { default, .. } => (default.map_or("-".into(), |name| format!("\"{name}\"")), String::new()),
    };
    let symbol = if entry.symbol.is_empty() { String::new() } else { format!("{}, ", entry.symbol) };
    format!("  {:<24} {default:<16} {symbol}{}{range}\n", entry.name(), entry.doc)
}

fn explain(choice: &Choice) -> String {
    format!("    {:<22} {:<16} {}\n", "", choice.name, choice.doc)
}
