//! Any given constant unknown, and any output prescribed in its place: `belt.bending_stiffness for efficiency.overall = 0.96`.

use super::keys::Key;
use crate::drive::{Constant, Output};
use crate::quantity::{self, Dimension};
use std::fmt;

/// A constant that is found, and the output that is prescribed in its place.
#[derive(Debug, Clone, PartialEq)]
pub struct Exchange {
    /// The key whose constant is found; its value is where the search starts.
    pub key: Key,
    /// The constant.
    pub constant: Constant,
    /// What is prescribed.
    pub output: Output,
    /// Its value, SI.
    pub value: f64,
}

impl fmt::Display for Exchange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} for {} = {:e}", self.key.path(), self.output.path(), self.value)
    }
}

/// From `KEY for OUTPUT = VALUE`, or what is wrong with it.
pub(super) fn read(text: &str) -> Result<Exchange, String> {
    let form = || "expected KEY for OUTPUT = VALUE, such as `belt.bending_stiffness for efficiency.overall = 0.96`";
    let (what, value) = text.split_once('=').ok_or_else(form)?;
    let (path, output) = what.split_once(" for ").ok_or_else(form)?;
    let (path, output, value) = (path.trim(), output.trim(), value.trim());
    let unknown = || match Key::nearest(path) {
        Some(key) => format!("unknown key `{path}`: expected a key such as `{}`", key.path()),
        None => format!("unknown key `{path}`"),
    };
    let key = Key::from_path(path).ok_or_else(unknown)?;
    let given = Constant::ALL.into_iter().skip(Constant::UNKNOWN).find(|constant| constant.key() == Some(key));
    let constant =
        given.ok_or_else(|| format!("`{path}` gives no constant that could be found: expected one that does"))?;
    let output = Output::named(output).ok_or_else(|| {
        let start: String = output.chars().take(60).collect();
        let near = Output::all().min_by_key(|other| strsim::damerau_levenshtein(&other.path(), &start));
        let near = near.map(|near| format!(", such as `{}`", near.path())).unwrap_or_default();
        format!("unknown output `{output}`: expected one of a result{near}")
    })?;
    let read = quantity::parse(value).and_then(|quantity| quantity.expect(dimension(output)));
    let value = read.map_err(|reason| format!("`{}` = {value}: {reason}", output.path()))?;
    Ok(Exchange { key, constant, output, value })
}

/// The dimension of an output, from its name in the result object.
fn dimension(output: Output) -> Dimension {
    let path = output.path();
    let (region, key) = path.split_once('.').unwrap_or(("", &path));
    match (region, key) {
        ("efficiency", _) | (_, "imbalance" | "closure") => Dimension::NONE,
        (_, "mass_flow") => Dimension::new(0, 1, -1, 0),
        (_, "speed") => Dimension::ANGULAR_SPEED,
        (_, "torque" | "binding_moment") => Dimension::TORQUE,
        (_, "axial_force" | "entry_tension" | "exit_tension") => Dimension::FORCE,
        (_, "wrap_angle" | "entry_angle" | "exit_angle" | "orientation_angle") => Dimension::ANGLE,
        (_, "resultant_x" | "resultant_y" | "arc_length" | "unstretched_length") => Dimension::LENGTH,
        _ => Dimension::POWER,
    }
}
