//! `sheave size`: what the motor of a belt drive has to deal with.

use super::envelope;
use super::output;
use super::stop::Stop;
use clap::Args;
use sheave::quantity::{unsigned_zero, with_digits};
use sheave::small::size::{BeltDrive, Entry, IDLER, SizeError, Sizing, TABLE, size};
use std::fmt::Write;
use std::path::PathBuf;

/// Size a belt drive: torques and inertia at its input
///
/// For a belt that conveys a load in a straight line, one that changes speed, or both: load inertia, inertia with
/// pulleys, idlers and a rotary load, ratio, and the torques for external force, friction, load torque and acceleration
/// (3.21) to (3.27). The equations are in docs/small-models.md.
#[derive(Debug, Args)]
#[command(after_long_help = keys() + "\n" + super::STATUS)]
pub struct Arguments {
    /// File with the drive
    #[arg(value_name = "DRIVE.toml")]
    file: Option<PathBuf>,
    /// Set a key, in place of the file's value for it: input.diameter="100 mm"
    #[arg(long = "set", value_name = "KEY=VALUE", allow_hyphen_values = true)]
    set: Vec<String>,
    /// Add an idler: "3e-4 kg*m^2, 60 mm"
    #[arg(long = "idler", value_name = "INERTIA,DIAMETER")]
    idlers: Vec<String>,
    /// Print the result as one JSON object, in SI units
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<(), Stop> {
    let refused = |error: SizeError| Stop::Refused(miette::Report::new(error));
    let drive = BeltDrive::read(arguments.file.as_deref(), &arguments.set, &arguments.idlers).map_err(refused)?;
    let sizing = size(&drive).map_err(refused)?;
    let json = || envelope::object("size", &drive, &[], &sizing);
    output::print(&if arguments.json { json()? } else { summary(&sizing) })
}

/// The keys of a drive, for people to read.
fn keys() -> String {
    let mut text = String::from(
        "Keys of the file, sections and keys as in a case file; only input.diameter must be given, and for an idler \
         its diameter.\nA quantity is a string with a unit or a bare number in SI units. One table [[idler]] for each \
         idler.\n",
    );
    // Writing to a string cannot fail.
    fn add<T>(text: &mut String, entry: &Entry<T>) {
        let example = format!("\"{} {}\"", entry.example, entry.unit.symbol);
        let _ = writeln!(text, "  {:<24} {example:<18} {}, {}", entry.path, entry.symbol, entry.doc);
    }
    TABLE.iter().for_each(|entry| add(&mut text, entry));
    IDLER.iter().for_each(|entry| add(&mut text, entry));
    text
}

fn summary(sizing: &Sizing) -> String {
    let mut text = format!("Belt drive, ratio {:.4} (output over input diameter)\n\n", sizing.ratio);
    let mut row = |name: &str, value: f64, unit: &str| {
        // Writing to a string cannot fail.
        let value = with_digits(value, 6);
        let _ = writeln!(text, "  {name:<34}{:>14}  {unit}", unsigned_zero(&value));
    };
    let (inertia, torque) = (&sizing.inertia, &sizing.torque);
    row("inertia of belt and linear load", inertia.load, "kg·m²");
    row("inertia of idlers", inertia.idlers, "kg·m²");
    row("inertia of all that rotates", inertia.rotating, "kg·m²");
    row("inertia in all", inertia.total, "kg·m²");
    row("torque for the external force", torque.external, "N·m");
    row("torque for the friction force", torque.friction, "N·m");
    row("torque for the load torque", torque.load, "N·m");
    row("torque at constant speed", torque.steady, "N·m");
    row("torque to accelerate", torque.acceleration, "N·m");
    row("torque in all", torque.drive, "N·m");
    text
}
