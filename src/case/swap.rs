//! Any given constant unknown, and any output prescribed in its place:
//! `belt.bending_stiffness for efficiency.overall = 0.96`.

use super::keys::Key;
use crate::model::{Constant, Output};
use crate::quantity;
use std::fmt;

/// A constant that is found, and the output that is prescribed in its place.
#[derive(Debug, Clone, PartialEq)]
pub struct GivenSwap {
    /// The key whose constant is found; its value is where the search starts.
    pub key: Key,
    /// The constant.
    pub constant: Constant,
    /// What is prescribed.
    pub output: Output,
    /// Its value, SI.
    pub value: f64,
}

impl fmt::Display for GivenSwap {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} for {} = {:e}", self.key.path(), self.output.name(), self.value)
    }
}

/// From `KEY for OUTPUT = VALUE`, or what is wrong with it.
pub(super) fn read(text: &str) -> Result<GivenSwap, String> {
    let form = || "expected KEY for OUTPUT = VALUE, such as `belt.bending_stiffness for efficiency.overall = 0.96`";
    let (what, value) = text.split_once('=').ok_or_else(form)?;
    let (path, output) = what.split_once(" for ").ok_or_else(form)?;
    let (path, output, value) = (path.trim(), output.trim(), value.trim());
    let unknown = || match Key::nearest(path) {
        Some(key) => format!("unknown key `{path}`: expected a key such as `{}`", key.path()),
        None => format!("unknown key `{path}`"),
    };
    let key = Key::from_path(path).ok_or_else(unknown)?;
    let given =
        Constant::ALL.into_iter().skip(Constant::UNKNOWN).find(|constant| Key::of_constant(*constant) == Some(key));
    let constant =
        given.ok_or_else(|| format!("`{path}` gives no constant that could be found: expected one that does"))?;
    let output = output.parse::<Output>().map_err(|unknown| {
        let start: String = output.chars().take(60).collect();
        let distance = |other: &Output| strsim::damerau_levenshtein(other.name(), &start);
        let near = Output::ALL.into_iter().min_by_key(distance).map(|near| format!(", such as `{}`", near.name()));
        format!("unknown output `{}`: expected one of a result{}", unknown.name, near.unwrap_or_default())
    })?;
    let read = quantity::parse(value).and_then(|quantity| quantity.expect(output.symbol().dimension.into()));
    let value = read.map_err(|reason| format!("`{}` = {value}: {reason}", output.name()))?;
    Ok(GivenSwap { key, constant, output, value })
}
