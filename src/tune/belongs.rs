//! Whether a map is of the belt of a case.

use serde_json::Value;

use super::error::TuneError;
use crate::beltmap::{BeltMap, Quantity};
use crate::case::{Key, Resolved, TABLE};
use crate::model::{Include, InternalError};
use crate::text::quoted;

/// Numbers that are closer than this share of them are the same: one quantity in two units.
const ROUNDING: f64 = 1e-9;
/// Constants that are found for outputs, among the inputs.
const SWAP: &str = "swap";

/// Whether a map was made with what a case has, but for what the map is over and what it does not depend on: actuators,
/// engine and vehicle. `case` is that in the middle of the map that the case would have.
///
/// # Errors
/// [`TuneError::OtherMap`] names the first key that differs; [`TuneError::Internal`].
pub fn check(map: &BeltMap, case: &Resolved) -> Result<(), TuneError> {
    let theirs = map.inputs();
    let ours = serde_json::to_value(case).map_err(|_| InternalError::Json("a case"))?;
    let told = [map.quantities().contains(&Quantity::Losses), Quantity::of_case(case).contains(&Quantity::Losses)];
    for entry in &TABLE {
        if !matters(entry.key, told) {
            continue;
        }
        let pointer = format!("/{}", entry.path.replace('.', "/"));
        let [of_map, of_case] = if entry.key == Key::Losses {
            told.map(|told| Some(Value::from(if told { Include::On } else { Include::Off }.name())))
        } else {
            [theirs, &ours].map(|inputs| inputs.pointer(&pointer).cloned())
        };
        if !same(of_map.as_ref(), of_case.as_ref()) {
            let [map, case] = [of_map, of_case].map(|value| words(entry.key, value.as_ref()));
            return Err(TuneError::OtherMap { key: entry.path, map, case });
        }
    }
    let [of_map, of_case] = [theirs.get(SWAP), ours.get(SWAP)];
    if same(of_map, of_case) {
        return Ok(());
    }
    let told = |value: Option<&Value>| value.map_or_else(nothing, |value| quoted(&value.to_string()).into_owned());
    let [map, case] = [of_map, of_case].map(told);
    Err(TuneError::OtherMap { key: SWAP, map, case })
}

/// Whether a map over ratio, torque and speed of the primary and slack tension depends on a key. The ratio stands for
/// both radii, the other three for the operating point.
fn matters(key: Key, [of_map, of_case]: [bool; 2]) -> bool {
    match key {
        Key::CenterDistance | Key::Free | Key::Losses => true,
        // Of losses that neither tells, nothing counts.
        Key::LossTangent | Key::CordLossTangent => of_map || of_case,
        _ => match key.entry().section() {
            "" | "model" | "belt" | "sheave" | "thermal" => true,
            "losses" => of_map || of_case,
            _ => false,
        },
    }
}

fn same(one: Option<&Value>, other: Option<&Value>) -> bool {
    match (one, other) {
        (Some(Value::Number(one)), Some(Value::Number(other))) => match (one.as_f64(), other.as_f64()) {
            (Some(one), Some(other)) => (one - other).abs() <= ROUNDING * one.abs().max(other.abs()),
            _ => one == other,
        },
        (one, other) => one == other,
    }
}

fn nothing() -> String {
    "nothing".to_owned()
}

/// A value as people read it.
fn words(key: Key, value: Option<&Value>) -> String {
    match value {
        None => nothing(),
        Some(Value::String(name)) => format!("\"{name}\""),
        Some(value) => match value.as_f64() {
            Some(si) => {
                let (number, unit) = key.entry().readable(si);
                // To the digits that count.
                let number = format!("{number:.9e}").parse().unwrap_or(number);
                format!("{number} {unit}").trim_end().to_owned()
            }
            None => quoted(&value.to_string()).into_owned(),
        },
    }
}
