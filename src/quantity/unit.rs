//! The units that are understood, with their factors.
//!
//! Factors are exact by definition. SI and the units accepted with it: BIPM, *The International System of Units*,
//! 9th edition (2019), tables 4, 7 and 8. Inch, foot, pound: the international yard and pound agreement of 1959
//! (1 in = 25.4 mm, 1 lb = 0.453 592 37 kg). Pound-force with the standard acceleration 9.806 65 m/s² (3rd CGPM, 1901);
//! ounce, psi and mechanical horsepower (550 ft·lbf/s) from these, as in NIST SP 811 (2008), appendix B, and so is
//! metric horsepower (`PS`, 75 kgf·m/s). Yarns: 1 tex is 1 g/km, 1 denier (`den`) 1 g in 9000 m (ISO 1144).

use super::Dimension;
use std::f64::consts::{PI, TAU};

/// A unit of measure: a value in it times `10^tens · numerator / denominator` is the value in SI.
///
/// Powers of ten are kept apart and applied to the decimal digits, so that `857.2 mm` becomes the same number as
/// `0.8572`, which neither `857.2 * 0.001` nor `857.2 / 1000.0` is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// How the unit is written; can be parsed.
    pub symbol: &'static str,
    /// What it measures, and how much of the SI unit it is.
    pub scale: Scale,
}

/// A factor to SI, and a dimension.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    /// Power of ten in the factor.
    pub tens: i32,
    /// Numerator of what else is in the factor.
    pub numerator: f64,
    /// Denominator of what else is in the factor.
    pub denominator: f64,
    /// What is measured.
    pub dimension: Dimension,
}

impl Unit {
    /// Thousandth of a metre.
    pub const MILLIMETRE: Self = Self::decimal("mm", -3, Dimension::LENGTH);
    /// Inch.
    pub const INCH: Self = Self::new("in", -4, 254.0, 1.0, Dimension::LENGTH);
    /// Degree of angle.
    pub const DEGREE: Self = Self::new("deg", 0, PI, 180.0, Dimension::ANGLE);
    /// Revolution per minute.
    pub const RPM: Self = Self::new("rpm", 0, TAU, 60.0, Dimension::ANGULAR_SPEED);
    /// Pound-force.
    pub const POUND_FORCE: Self = Self::new("lbf", -13, LBF, 1.0, Dimension::FORCE);
    /// Pound-force times foot, as workshops write it.
    pub const POUND_FOOT: Self = Self::new("lbf-ft", -17, 3048.0 * LBF, 1.0, Dimension::TORQUE);
    /// Mechanical horsepower.
    pub const HORSEPOWER: Self = Self::new("hp", -17, 550.0 * 3048.0 * LBF, 1.0, Dimension::POWER);

    /// A unit `10^tens · numerator / denominator` as large as the SI unit of `dimension`.
    pub const fn new(symbol: &'static str, tens: i32, numerator: f64, denominator: f64, dimension: Dimension) -> Self {
        Self { symbol, scale: Scale { tens, numerator, denominator, dimension } }
    }

    /// A unit that is a power of ten of the SI unit of `dimension`.
    pub const fn decimal(symbol: &'static str, tens: i32, dimension: Dimension) -> Self {
        Self::new(symbol, tens, 1.0, 1.0, dimension)
    }

    /// The unit as it is printed: `N·m²` for `N*m^2`.
    pub fn printed(&self) -> String {
        self.symbol.replace('*', "·").replace("^2", "²")
    }

    /// A value in this unit, in SI.
    pub fn to_si(&self, value: f64) -> f64 {
        self.scale.to_si(value)
    }

    /// A value in SI, in this unit.
    pub fn from_si(&self, value: f64) -> f64 {
        shift(value * self.scale.denominator / self.scale.numerator, -self.scale.tens)
    }

    /// This unit in SI, as a factor: what is multiplied by it is rounded once more than by [`Unit::to_si`].
    pub const fn in_si(&self) -> f64 {
        let Scale { tens, numerator, denominator, .. } = self.scale;
        // Exact up to 10^22.
        let (mut power, mut left) = (1.0, tens.unsigned_abs());
        while left > 0 {
            power *= 10.0;
            left -= 1;
        }
        if tens < 0 { numerator / (denominator * power) } else { power * numerator / denominator }
    }

    /// How many of it make up the SI unit, as a factor.
    pub const fn per_si(&self) -> f64 {
        1.0 / self.in_si()
    }
}

impl Scale {
    /// The plain number 1.
    pub(super) const ONE: Self = Self { tens: 0, numerator: 1.0, denominator: 1.0, dimension: Dimension::NONE };

    /// A value on this scale, in SI.
    pub fn to_si(&self, value: f64) -> f64 {
        shift(value, self.tens) * self.numerator / self.denominator
    }

    /// This scale times `other` to the power `exponent`; `None` when an exponent of the dimension overflows.
    pub(super) fn times(self, other: Self, exponent: i8) -> Option<Self> {
        let power = i32::from(exponent.unsigned_abs());
        let (up, down) = match exponent {
            ..0 => (other.denominator, other.numerator),
            0.. => (other.numerator, other.denominator),
        };
        Some(Self {
            tens: other.tens.checked_mul(exponent.into())?.checked_add(self.tens)?,
            numerator: self.numerator * up.powi(power),
            denominator: self.denominator * down.powi(power),
            dimension: self.dimension.times(other.dimension, exponent)?,
        })
    }
}

/// The value times a power of ten, correctly rounded: the point is moved in the shortest decimal form of the value.
fn shift(value: f64, tens: i32) -> f64 {
    if tens == 0 {
        return value;
    }
    let shifted = format!("{value:e}").split_once('e').and_then(|(digits, exponent)| {
        let exponent = exponent.parse::<i32>().ok()?.checked_add(tens)?;
        format!("{digits}e{exponent}").parse().ok()
    });
    shifted.unwrap_or(value * 10f64.powi(tens)) // infinities and not-a-numbers have no decimal form
}

/// A symbol that stands for a unit in a text.
struct Symbol {
    unit: Unit,
    /// Whether SI prefixes may precede it.
    prefixed: bool,
}

const fn plain(symbol: &'static str, tens: i32, numerator: f64, denominator: f64, dimension: Dimension) -> Symbol {
    Symbol { unit: Unit::new(symbol, tens, numerator, denominator, dimension), prefixed: false }
}

const fn known(unit: Unit) -> Symbol {
    Symbol { unit, prefixed: false }
}

const fn si(symbol: &'static str, tens: i32, dimension: Dimension) -> Symbol {
    Symbol { unit: Unit::decimal(symbol, tens, dimension), prefixed: true }
}

/// 1 lbf = 44482216152605e-13 N.
const LBF: f64 = 44_482_216_152_605.0;

static SYMBOLS: [Symbol; 37] = [
    si("m", 0, Dimension::LENGTH),
    known(Unit::INCH),
    plain("ft", -4, 3048.0, 1.0, Dimension::LENGTH),
    plain("mi", -3, 1_609_344.0, 1.0, Dimension::LENGTH),
    plain("mph", -5, 44_704.0, 1.0, Dimension::SPEED),
    si("g", -3, Dimension::MASS),
    plain("t", 3, 1.0, 1.0, Dimension::MASS),
    plain("lb", -8, 45_359_237.0, 1.0, Dimension::MASS),
    plain("oz", -8, 45_359_237.0, 16.0, Dimension::MASS),
    si("s", 0, Dimension::TIME),
    plain("min", 0, 60.0, 1.0, Dimension::TIME),
    plain("h", 0, 3600.0, 1.0, Dimension::TIME),
    si("Hz", 0, Dimension::FREQUENCY),
    si("rad", 0, Dimension::ANGLE),
    known(Unit::DEGREE),
    plain("°", 0, PI, 180.0, Dimension::ANGLE),
    plain("rev", 0, TAU, 1.0, Dimension::ANGLE),
    known(Unit::RPM),
    si("N", 0, Dimension::FORCE),
    known(Unit::POUND_FORCE),
    plain("ozf", -13, LBF, 16.0, Dimension::FORCE),
    plain("kgf", -5, 980_665.0, 1.0, Dimension::FORCE),
    plain("gf", -8, 980_665.0, 1.0, Dimension::FORCE),
    plain("den", -3, 1.0, 9000.0, Dimension::MASS_PER_LENGTH),
    plain("tex", -6, 1.0, 1.0, Dimension::MASS_PER_LENGTH),
    si("Nm", 0, Dimension::TORQUE),
    si("J", 0, Dimension::TORQUE),
    si("Pa", 0, Dimension::PRESSURE),
    si("bar", 5, Dimension::PRESSURE),
    plain("psi", -5, LBF, 64_516.0, Dimension::PRESSURE),
    plain("ksi", -2, LBF, 64_516.0, Dimension::PRESSURE),
    si("W", 0, Dimension::POWER),
    known(Unit::HORSEPOWER),
    plain("PS", -5, 73_549_875.0, 1.0, Dimension::POWER),
    plain("%", -2, 1.0, 1.0, Dimension::NONE),
    si("K", 0, Dimension::TEMPERATURE),
    plain("1", 0, 1.0, 1.0, Dimension::NONE),
];

/// What workshops write, as they write it: pounds are pounds-force here, and Nm² is N·m², not (N·m)².
static WORKSHOP: [Unit; 9] = [
    Unit::POUND_FOOT,
    Unit::new("lb-ft", -17, 3048.0 * LBF, 1.0, Dimension::TORQUE),
    Unit::new("ft-lbf", -17, 3048.0 * LBF, 1.0, Dimension::TORQUE),
    Unit::new("ft-lb", -17, 3048.0 * LBF, 1.0, Dimension::TORQUE),
    Unit::new("lbf-in", -17, 254.0 * LBF, 1.0, Dimension::TORQUE),
    Unit::new("in-lbf", -17, 254.0 * LBF, 1.0, Dimension::TORQUE),
    Unit::new("in-lb", -17, 254.0 * LBF, 1.0, Dimension::TORQUE),
    Unit::decimal("Nm²", 0, Dimension::BENDING_STIFFNESS),
    Unit::decimal("Nm^2", 0, Dimension::BENDING_STIFFNESS),
];

/// The unit that a workshop writes like this, and nothing else.
pub(super) fn workshop(text: &str) -> Option<Scale> {
    WORKSHOP.iter().find(|unit| unit.symbol == text).map(|unit| unit.scale)
}

/// Prefixes and their powers of ten.
const PREFIXES: [(char, i32); 9] = [
    ('G', 9),
    ('M', 6),
    ('k', 3),
    ('d', -1),
    ('c', -2),
    ('m', -3),
    ('µ', -6), // U+00B5, micro sign
    ('μ', -6), // U+03BC, Greek mu
    ('u', -6),
];

/// The unit with this symbol, prefixed or not; a symbol without a prefix comes first (`min` is a minute, `ft` a foot).
pub(super) fn find(symbol: &str) -> Option<Scale> {
    let exact = |name: &str| SYMBOLS.iter().find(|known| known.unit.symbol == name);
    if let Some(Symbol { unit, .. }) = exact(symbol) {
        return Some(unit.scale);
    }
    let mut rest = symbol.chars();
    let first = rest.next()?;
    let (_, tens) = PREFIXES.iter().find(|(prefix, _)| *prefix == first)?;
    let Symbol { unit, prefixed } = exact(rest.as_str())?;
    prefixed.then_some(Scale { tens: tens + unit.scale.tens, ..unit.scale })
}

/// All symbols without prefixes, for suggestions and help.
pub fn symbols() -> impl Iterator<Item = &'static str> {
    SYMBOLS.iter().map(|known| known.unit.symbol)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prefixes_only_where_they_make_sense() {
        assert!(find("mm").is_some() && find("kN").is_some() && find("MPa").is_some() && find("mrad").is_some());
        for nonsense in ["kft", "mrpm", "kdeg", "mm2", "k", "", "klbf", "cmm"] {
            assert_eq!(find(nonsense), None, "{nonsense}");
        }
    }

    #[test]
    fn factors_are_those_of_the_conversions() {
        for Symbol { unit, .. } in &SYMBOLS {
            let (there, back) = (unit.in_si() / unit.to_si(1.0), unit.per_si() / unit.from_si(1.0));
            assert!((there - 1.0).abs() < 1e-15 && (back - 1.0).abs() < 1e-15, "{}", unit.symbol);
        }
        assert_eq!((Unit::RPM.in_si(), Unit::RPM.per_si()), (PI / 30.0, 30.0 / PI));
        assert_eq!((Unit::INCH.in_si(), Unit::POUND_FORCE.in_si()), (0.0254, 4.448_221_615_260_5));
    }

    #[test]
    fn inch_pound_factors_are_the_tabulated_ones() {
        // NIST SP 811 (2008), appendix B.8.
        for (symbol, tabulated) in [
            ("in", 2.54e-2),
            ("ft", 3.048e-1),
            ("mi", 1.609_344e3),
            ("mph", 4.4704e-1),
            ("lb", 4.535_923_7e-1),
            ("oz", 2.834_952e-2),
            ("lbf", 4.448_222),
            ("ozf", 2.780_139e-1),
            ("kgf", 9.806_65),
            ("psi", 6.894_757e3),
            ("ksi", 6.894_757e6),
            ("hp", 7.456_999e2),
            ("PS", 7.354_988e2),
        ] {
            let factor = find(symbol).expect(symbol).to_si(1.0);
            assert!((factor / tabulated - 1.0).abs() < 5e-7, "{symbol}: {factor}");
        }
    }
}
