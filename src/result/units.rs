//! The units in which a summary is written. Results themselves are in SI units.

use crate::quantity::{self, ZERO_CELSIUS};

/// A choice of units for people.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Units {
    /// N, N·m, rpm, W, mm, degrees: what drawings and data sheets have.
    #[default]
    Workshop,
    /// N, N·m, rad/s, W, m, rad: as in the JSON.
    Si,
    /// lbf, lbf·ft, rpm, hp, in, degrees.
    Us,
}

/// What is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Measured {
    Force,
    Torque,
    Speed,
    Power,
    Length,
    Sliding,
    Angle,
    Temperature,
}

/// A unit: a value in it is that in SI units times the factor plus the offset.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Unit {
    factor: f64,
    offset: f64,
    pub(super) symbol: &'static str,
    /// Digits behind the point more than in workshop units.
    more: usize,
}

const fn si(symbol: &'static str, more: usize) -> Unit {
    Unit { factor: 1.0, offset: 0.0, symbol, more }
}

const fn unit(unit: quantity::Unit, symbol: &'static str, more: usize) -> Unit {
    Unit { factor: unit.per_si(), offset: 0.0, symbol, more }
}

const NEWTON: Unit = si("N", 0);
const NEWTON_METRE: Unit = si("N·m", 0);
const RPM: Unit = unit(quantity::Unit::RPM, "rpm", 0);
const WATT: Unit = si("W", 0);
const DEGREE: Unit = unit(quantity::Unit::DEGREE, "deg", 0);
const MILLIMETRE: quantity::Unit = quantity::Unit::MILLIMETRE;
const INCH: quantity::Unit = quantity::Unit::INCH;

impl Units {
    /// By name: `us`, `si`, `workshop`.
    pub fn by_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|units| units.name() == name)
    }

    /// All choices.
    pub const ALL: [Self; 3] = [Self::Workshop, Self::Si, Self::Us];

    /// Name on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Workshop => "workshop",
            Self::Si => "si",
            Self::Us => "us",
        }
    }

    pub(super) const fn of(self, what: Measured) -> Unit {
        match (what, self) {
            (Measured::Force, Self::Workshop | Self::Si) => NEWTON,
            (Measured::Force, Self::Us) => unit(quantity::Unit::POUND_FORCE, "lbf", 0),
            (Measured::Torque, Self::Workshop | Self::Si) => NEWTON_METRE,
            (Measured::Torque, Self::Us) => unit(quantity::Unit::POUND_FOOT, "lbf·ft", 0),
            (Measured::Speed, Self::Workshop | Self::Us) => RPM,
            (Measured::Speed, Self::Si) => si("rad/s", 2),
            (Measured::Power, Self::Workshop | Self::Si) => WATT,
            (Measured::Power, Self::Us) => unit(quantity::Unit::HORSEPOWER, "hp", 3),
            (Measured::Length, Self::Workshop) => unit(MILLIMETRE, "mm", 0),
            (Measured::Length, Self::Si) => si("m", 3),
            (Measured::Length, Self::Us) => unit(INCH, "in", 2),
            (Measured::Sliding, Self::Workshop) => unit(MILLIMETRE, "mm/s", 0),
            (Measured::Sliding, Self::Si) => si("m/s", 3),
            (Measured::Sliding, Self::Us) => unit(INCH, "in/s", 2),
            (Measured::Angle, Self::Workshop | Self::Us) => DEGREE,
            (Measured::Angle, Self::Si) => si("rad", 2),
            (Measured::Temperature, Self::Workshop) => {
                Unit { factor: 1.0, offset: -ZERO_CELSIUS, symbol: "°C", more: 0 }
            }
            (Measured::Temperature, Self::Si) => si("K", 0),
            (Measured::Temperature, Self::Us) => Unit { factor: 1.8, offset: -459.67, symbol: "°F", more: 0 },
        }
    }

    /// A value in SI units, as text with so many digits in workshop units, and its unit behind it.
    pub(super) fn show(self, what: Measured, si: f64, digits: usize) -> String {
        let unit = self.of(what);
        format!("{} {}", unit.number(si, digits), unit.symbol)
    }
}

impl Unit {
    /// A value in SI units as a number in this unit, with so many digits in workshop units.
    pub(super) fn number(self, si: f64, digits: usize) -> String {
        let digits = digits + self.more;
        format!("{:.digits$}", si * self.factor + self.offset)
    }
}

#[cfg(test)]
mod tests {
    use super::{Measured, Units};

    #[test]
    fn units_are_those_of_their_places() {
        let shown = |units: Units| {
            [
                units.show(Measured::Force, 100.0, 1),
                units.show(Measured::Torque, 18.0, 1),
                units.show(Measured::Power, 745.699_871_58, 0),
                units.show(Measured::Length, 0.0254, 1),
                units.show(Measured::Speed, 100.0 * std::f64::consts::PI, 0),
                units.show(Measured::Temperature, 373.15, 0),
            ]
        };
        assert_eq!(shown(Units::Workshop), ["100.0 N", "18.0 N·m", "746 W", "25.4 mm", "3000 rpm", "100 °C"]);
        assert_eq!(shown(Units::Us), ["22.5 lbf", "13.3 lbf·ft", "1.000 hp", "1.000 in", "3000 rpm", "212 °F"]);
        assert_eq!(shown(Units::Si), ["100.0 N", "18.0 N·m", "746 W", "0.0254 m", "314.16 rad/s", "373 K"]);
        assert_eq!(Units::by_name("us"), Some(Units::Us));
        assert_eq!(Units::by_name("imperial"), None);
    }
}
