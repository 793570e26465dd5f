//! The keys of a case file, as a page needs them.

use serde_json::{Value, json};

use crate::case::{Choice, Entry, Key, RangeEnd, TABLE, ValueKind};
use crate::quantity::{Dimension, Unit, celsius};

/// How a quantity is shown: in its key's unit, temperatures in °C.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Shown {
    unit: Unit,
    is_temperature: bool,
}

/// How the quantity of a key is shown; none for a choice.
pub(super) fn shown(key: Key) -> Option<Shown> {
    match key.entry().kind {
        ValueKind::Quantity { unit, .. } => {
            Some(Shown { unit, is_temperature: unit.scale.dimension == Dimension::TEMPERATURE })
        }
        ValueKind::List { .. } | ValueKind::Choice { .. } => None,
    }
}

impl Shown {
    /// From SI.
    pub(super) fn in_unit(self, si: f64) -> f64 {
        if self.is_temperature { celsius(si) } else { self.unit.from_si(si) }
    }

    /// From the unit of the key's table.
    fn of_table(self, value: f64) -> f64 {
        if self.is_temperature { celsius(value) } else { value }
    }

    /// As it is written behind a number in a case file.
    fn symbol(self) -> &'static str {
        if self.is_temperature { "degC" } else { self.unit.symbol }
    }

    /// As it is printed.
    pub(super) fn printed(self) -> String {
        if self.is_temperature { "°C".into() } else { self.unit.printed() }
    }
}

/// All keys, in the order of their table.
pub(super) fn table() -> Value {
    json!({ "keys": TABLE.iter().map(key).collect::<Vec<_>>() })
}

fn key(entry: &Entry) -> Value {
    let mut object = json!({
        "path": entry.path,
        "section": entry.section(),
        "name": entry.name(),
        "symbol": entry.marked_symbol(),
        "doc": entry.doc,
        "expected": entry.expected(),
    });
    match (entry.kind, shown(entry.key)) {
        (ValueKind::Quantity { range, example, base, .. }, Some(shown)) => {
            object["unit"] = shown.symbol().into();
            object["printed_unit"] = shown.printed().into();
            object["low"] = bound(range.low, shown);
            object["high"] = bound(range.high, shown);
            object["example"] = shown.of_table(example).into();
            object["base"] = base.into();
            object["slider"] = json!(reach(entry.key));
        }
        (ValueKind::Choice { choices, default }, _) => {
            let choice = |choice: &Choice| json!({ "name": choice.name, "doc": choice.doc });
            object["choices"] = choices.iter().map(choice).collect();
            object["default"] = default.into();
        }
        (ValueKind::List { .. } | ValueKind::Quantity { .. }, _) => {}
    }
    object
}

fn bound(bound: RangeEnd, shown: Shown) -> Value {
    match bound {
        RangeEnd::None => Value::Null,
        RangeEnd::Open(value) => json!({ "value": shown.of_table(value), "open": true }),
        RangeEnd::Closed(value) => json!({ "value": shown.of_table(value), "open": false }),
    }
}

/// From where to where a slider goes, in the unit shown: small vehicles' drives. A page lets its sliders reach farther
/// where a case does. None for a choice, and for what stands around a drive: actuators, engine and vehicle.
fn reach(key: Key) -> Option<[f64; 2]> {
    Some(match key {
        Key::BeltLength => [600.0, 1200.0],
        Key::MassPerLength => [0.1, 1.0],
        Key::LongitudinalStiffness => [50.0, 600.0],
        Key::BendingStiffness => [0.02, 1.0],
        Key::RadialStiffness => [4.0, 60.0],
        Key::Perimeter => [20.0, 200.0],
        Key::LossTangent => [0.0, 0.5],
        Key::CordLossTangent => [0.0, 0.2],
        Key::HalfAngle => [8.0, 20.0],
        Key::FrictionCoefficient => [0.1, 0.8],
        Key::SlipThreshold => [1e-5, 1e-2],
        Key::CenterDistance => [180.0, 300.0],
        Key::PrimaryRadius | Key::SecondaryRadius => [35.0, 100.0],
        Key::Ratio => [0.5, 2.5],
        Key::PrimarySpeed | Key::SecondarySpeed => [300.0, 9000.0],
        Key::PrimaryTorque | Key::SecondaryTorque => [-30.0, 150.0],
        Key::SpeedRatio => [0.4, 2.0],
        Key::SlackTension => [2.0, 500.0],
        Key::TightTension => [50.0, 2000.0],
        Key::PrimaryAxialForce | Key::SecondaryAxialForce => [200.0, 4000.0],
        Key::SlipReserve => [1.0, 80.0],
        Key::FrictionUtilization => [20.0, 99.0],
        Key::PrimaryDrag | Key::SecondaryDrag => [0.0, 2.0],
        Key::PrimaryDragPerSpeed | Key::SecondaryDragPerSpeed => [0.0, 0.005],
        Key::GearEfficiency => [0.8, 1.0],
        Key::Ambient => [-20.0, 60.0],
        Key::HeatTransfer => [1.0, 40.0],
        Key::HeatTransferPerArea => [20.0, 500.0],
        Key::FrictionShare => [0.0, 1.0],
        Key::ReferenceTemperature => [0.0, 120.0],
        Key::BendingSoftening | Key::RadialSoftening => [0.0, 0.05],
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quantity::ZERO_CELSIUS;

    /// The sections whose keys a page moves.
    const SECTIONS: [&str; 8] = ["", "model", "belt", "sheave", "drive", "operating_point", "losses", "thermal"];

    #[test]
    fn sliders_lie_within_what_their_keys_allow_and_hold_their_examples() {
        for entry in &TABLE {
            let is_shown = SECTIONS.contains(&entry.section());
            let ValueKind::Quantity { unit, range, example, .. } = entry.kind else { continue };
            assert_eq!(reach(entry.key).is_some(), is_shown, "{}", entry.path);
            if !is_shown {
                continue;
            }
            let shown = shown(entry.key).expect("a quantity is shown");
            let [from, to] = reach(entry.key).expect("a quantity has a slider");
            let example = shown.of_table(example);
            assert!(from <= example && example <= to, "{}: {example} in {from} to {to}", entry.path);
            for end in [from, to] {
                let si = if shown.is_temperature { end + ZERO_CELSIUS } else { unit.to_si(end) };
                assert!(range.contains(si, |bound| unit.to_si(bound)), "{}: {end}", entry.path);
            }
        }
    }
}
