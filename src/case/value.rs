//! What stands for a key in a text, checked against what the key takes.

use super::error::CaseProblem;
use super::keys::{Entry, Key, ValueKind};
use super::range::Range;
use super::raw::Raw;
use crate::model::Choice;
use crate::quantity::{self, Dimension, Quantity, QuantityError, Unit, ZERO_CELSIUS};

/// A bare number above this is a speed in rpm, not in rad/s: 2000 rad/s are 19,100 rpm.
const FASTEST_BARE: f64 = 2000.0;

/// A quantity, in SI.
///
/// # Errors
/// A value that is no quantity, of another dimension, outside the key's range, or a bare number that is surely in rpm.
pub(super) fn quantity_value(key: Key, raw: Raw<'_>, given: &str) -> Result<f64, CaseProblem> {
    let entry = key.entry();
    let ValueKind::Quantity { unit, range, .. } = entry.kind else {
        return Err(CaseProblem::Type { path: entry.path.into(), given: "a quantity", expected: entry.expected() });
    };
    let invalid = |reason| CaseProblem::Quantity { key, given: given.into(), reason };
    let quantity = match raw {
        Raw::Text(text) => quantity::parse(&text).map_err(invalid)?,
        Raw::Number(si) if si.is_finite() => Quantity { si, dimension: Dimension::NONE, bare: true },
        Raw::Number(_) => return Err(invalid(QuantityError::NotFinite)),
        Raw::List(_) => {
            return Err(CaseProblem::Type { path: entry.path.into(), given: "an array", expected: entry.expected() });
        }
        Raw::Other(given) => {
            return Err(CaseProblem::Type { path: entry.path.into(), given, expected: entry.expected() });
        }
    };
    let si = quantity.expect(unit.scale.dimension).map_err(invalid)?;
    let allowed = |si| range.contains(si, |bound| unit.to_si(bound));
    let rpm = unit.scale.dimension == Dimension::ANGULAR_SPEED;
    if rpm && quantity.bare && si.abs() > FASTEST_BARE && allowed(unit.to_si(si)) {
        return Err(CaseProblem::BareSpeed { key, given: given.into() });
    }
    if allowed(si) {
        return Ok(si);
    }
    let unit_missing = match unit.scale.dimension {
        // Of temperatures, those that people write without a unit are in degrees Celsius.
        Dimension::TEMPERATURE => (quantity.bare && allowed(si + ZERO_CELSIUS)).then_some("degC"),
        _ => (quantity.bare && allowed(unit.to_si(si))).then_some(unit.symbol),
    };
    Err(CaseProblem::OutOfRange { key, given: given.into(), unit_missing })
}

/// Most numbers of a list: no measured curve needs more.
const LONGEST_LIST: usize = 10_000;

/// Several quantities, in SI.
///
/// # Errors
/// As [`quantity_value`], for any of them; more than [`LONGEST_LIST`].
pub(super) fn list_value(
    key: Key,
    unit: Unit,
    range: Range,
    raw: Raw<'_>,
    given: &str,
) -> Result<Vec<f64>, CaseProblem> {
    let entry = key.entry();
    let invalid = |reason| CaseProblem::Quantity { key, given: given.into(), reason };
    let values = match raw {
        Raw::Text(text) => quantity::parse_list(&text, unit.scale.dimension).map_err(invalid)?,
        Raw::List(items) if items.len() <= LONGEST_LIST => {
            let one = |item: Raw<'_>| match item {
                Raw::Text(text) => {
                    quantity::parse(&text).and_then(|quantity| quantity.expect(unit.scale.dimension)).map_err(invalid)
                }
                Raw::Number(si) if si.is_finite() => Ok(si),
                Raw::Number(_) => Err(invalid(QuantityError::NotFinite)),
                Raw::List(_) => Err(wrong(entry, "an array of arrays")),
                Raw::Other(given) => Err(wrong(entry, given)),
            };
            items.into_iter().map(one).collect::<Result<_, _>>()?
        }
        Raw::List(_) => return Err(wrong(entry, "a list of more than 10,000 numbers")),
        Raw::Number(_) => return Err(wrong(entry, "a number")),
        Raw::Other(given) => return Err(wrong(entry, given)),
    };
    if !values.iter().all(|si| range.contains(*si, |bound| unit.to_si(bound))) {
        return Err(CaseProblem::OutOfRange { key, given: given.into(), unit_missing: None });
    }
    Ok(values)
}

fn wrong(entry: &Entry, given: &'static str) -> CaseProblem {
    CaseProblem::Type { path: entry.path.into(), given, expected: entry.expected() }
}

/// The name of one of the key's choices.
///
/// # Errors
/// [`CaseProblem::UnknownChoice`], or a value that is no text.
pub(super) fn choice_value(
    key: Key,
    choices: &[Choice],
    raw: Raw<'_>,
    given: &str,
) -> Result<&'static str, CaseProblem> {
    let entry = key.entry();
    match raw {
        Raw::Text(text) => choices
            .iter()
            .find(|choice| choice.name == text)
            .map(|choice| choice.name)
            .ok_or_else(|| CaseProblem::UnknownChoice { key, given: given.into() }),
        Raw::Number(_) => {
            Err(CaseProblem::Type { path: entry.path.into(), given: "a number", expected: entry.expected() })
        }
        Raw::List(_) => {
            Err(CaseProblem::Type { path: entry.path.into(), given: "an array", expected: entry.expected() })
        }
        Raw::Other(given) => Err(CaseProblem::Type { path: entry.path.into(), given, expected: entry.expected() }),
    }
}
