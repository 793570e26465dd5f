//! `sheave keys`: the keys of a case file, from their table.

use super::envelope;
use super::output;
use super::stop::Stop;
use clap::Args;
use serde::Serialize;
use sheave::case::{Choice, Entry, Range, RangeEnd, TABLE, ValueKind};
use sheave::quantity::Unit;
use std::fmt::Write;

/// List the keys of a case file with their units, ranges and defaults
#[derive(Debug, Args)]
pub struct Arguments {
    /// Print them as one JSON object
    #[arg(long)]
    json: bool,
}

/// A key, for programs.
#[derive(Debug, Serialize)]
struct Described {
    key: &'static str,
    doc: &'static str,
    symbol: &'static str,
    /// Unit in which range and default are given; none for a choice, and for a number without unit.
    unit: Option<&'static str>,
    /// Values that are taken, in words; none if all positive ones are.
    range: Option<String>,
    /// Whether it takes a list of numbers.
    list: bool,
    /// Value of the base case, or the default of a choice.
    default: Option<String>,
    choices: Vec<Chosen>,
}

#[derive(Debug, Serialize)]
struct Chosen {
    name: &'static str,
    doc: &'static str,
}

#[derive(Debug, Serialize)]
struct Keys {
    keys: Vec<Described>,
}

pub fn run(arguments: &Arguments) -> Result<(), Stop> {
    if arguments.json {
        let keys = TABLE.iter().map(described).collect();
        return output::print(&envelope::object("keys", &(), &[], &Keys { keys })?);
    }
    output::print(&table())
}

fn described(entry: &Entry) -> Described {
    let numbers = |unit: &Unit, range: &Range| {
        let positive = range.low == RangeEnd::Open(0.0) && range.high == RangeEnd::None;
        let words = (!positive).then(|| range.words(unit.symbol).to_string());
        (Some(unit.symbol).filter(|symbol| !symbol.is_empty()), words)
    };
    let (unit, range) = match &entry.kind {
        ValueKind::Quantity { unit, range, .. } | ValueKind::List { unit, range, .. } => numbers(unit, range),
        ValueKind::Choice { .. } => (None, None),
    };
    let (default, choices) = match entry.kind {
        ValueKind::Quantity { base, .. } => (base.then(|| entry.example()), &[][..]),
        ValueKind::List { .. } => (None, &[][..]),
        ValueKind::Choice { choices, default } => (default.map(str::to_owned), choices),
    };
    let list = matches!(entry.kind, ValueKind::List { .. });
    let choices = choices.iter().map(|choice| Chosen { name: choice.name, doc: choice.doc }).collect();
    Described { key: entry.path, doc: entry.doc, symbol: entry.symbol, unit, range, list, default, choices }
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
