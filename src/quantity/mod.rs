//! Quantities: numbers with units, read from text into SI with their dimension checked.
//!
//! ```
//! use sheave::quantity::{Dimension, parse};
//! assert_eq!(parse("68.309 mm")?.expect(Dimension::LENGTH)?, 0.068309);
//! assert_eq!(parse("0.068309")?.expect(Dimension::LENGTH)?, 0.068309); // a bare number is SI
//! assert!(parse("3 kg")?.expect(Dimension::LENGTH).is_err());
//! # Ok::<(), sheave::quantity::QuantityError>(())
//! ```

mod dimension;
mod parse;
mod unit;

use crate::text::quoted;
pub use dimension::Dimension;
#[cfg(feature = "bench")]
pub(crate) use parse::on_shifted_scale;
pub use unit::{Scale, Unit, symbols};

/// 0 °C, K.
pub const ZERO_CELSIUS: f64 = 273.15;

/// A temperature in K, in °C.
pub fn celsius(kelvin: f64) -> f64 {
    kelvin - ZERO_CELSIUS
}

/// A speed of rotation in rad/s, in revolutions per minute.
///
/// ```
/// assert_eq!(sheave::quantity::rpm(100.0 * std::f64::consts::PI), 3000.0);
/// ```
pub fn rpm(speed: f64) -> f64 {
    Unit::RPM.from_si(speed)
}

/// A speed in m/s, in km/h.
pub fn km_per_h(speed: f64) -> f64 {
    3.6 * speed
}

/// A number as it is written, without the minus sign if all its digits are zero.
///
/// ```
/// use sheave::quantity::unsigned_zero;
/// assert_eq!([unsigned_zero("-0.00 W"), unsigned_zero("-0.01 W")], ["0.00 W", "-0.01 W"]);
/// ```
pub fn unsigned_zero(text: &str) -> &str {
    text.strip_prefix('-').filter(|number| !number.chars().any(|c| c.is_ascii_digit() && c != '0')).unwrap_or(text)
}

/// A number with so many decimals at least, and as many more as show three of its digits; with a power of ten where
/// that would take more than twelve.
///
/// ```
/// use sheave::quantity::with_digits;
/// assert_eq!([with_digits(100.0, 0), with_digits(16.4, 0), with_digits(4e-7, 6)], ["100", "16.4", "0.000000400"]);
/// assert_eq!([with_digits(0.0, 2), with_digits(-3e-15, 2)], ["0.00", "-3.00e-15"]);
/// ```
pub fn with_digits(value: f64, decimals: usize) -> String {
    const DIGITS: f64 = 3.0;
    const MOST: f64 = 12.0;
    let needed = if value == 0.0 { 0.0 } else { DIGITS - 1.0 - libm::log10(value.abs()).floor() };
    if needed > MOST {
        return format!("{value:.2e}");
    }
    let decimals = decimals.max(needed.max(0.0) as usize);
    format!("{value:.decimals$}")
}

/// A number with its dimension.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantity {
    /// Value in SI units.
    pub si: f64,
    /// What it measures; [`Dimension::NONE`] for a bare number.
    pub dimension: Dimension,
    /// No unit was written: the number stands for SI units of whatever is asked for.
    pub bare: bool,
}

impl Quantity {
    /// The value in SI, if it measures `expected` or is a bare number.
    ///
    /// # Errors
    /// [`QuantityError::Dimension`] when the unit measures something else.
    pub fn expect(self, expected: Dimension) -> Result<f64, QuantityError> {
        if self.bare || self.dimension == expected {
            Ok(self.si)
        } else {
            Err(QuantityError::Dimension { given: self.dimension, expected })
        }
    }
}

/// Reads numbers separated by commas, the last with the unit of all that have none: `0, 4.5, 11.7 mm`; in SI.
///
/// ```
/// use sheave::quantity::{Dimension, parse_list};
/// assert_eq!(parse_list("0, 4.5, 1 cm", Dimension::LENGTH)?, [0.0, 0.045, 0.01]);
/// # Ok::<(), sheave::quantity::QuantityError>(())
/// ```
///
/// # Errors
/// What is wrong with one of them, see [`QuantityError`].
pub fn parse_list(text: &str, expected: Dimension) -> Result<Vec<f64>, QuantityError> {
    let texts: Vec<&str> = text.split(',').map(str::trim).collect();
    let unit = texts.last().map_or("", |last| parse::split_number(last).1.trim());
    if unit.is_empty() && texts.iter().any(|text| !parse::split_number(text).1.trim().is_empty()) {
        return Err(QuantityError::LastUnit);
    }
    let one = |text: &&str| {
        let bare = parse::split_number(text).1.trim().is_empty();
        let read = if bare { parse(&format!("{text} {unit}")) } else { parse(text) };
        read?.expect(expected)
    };
    texts.iter().map(one).collect()
}

/// Reads a quantity: a number, then optionally a product of units (`18.71 MPa`, `0.2602 N*m^2`, `18 lbf·ft`,
/// `2 kg m/s²`). Factors of units are separated by `*`, `·`, a space or `/`; a `/` divides by the one factor behind it.
///
/// # Errors
/// What is wrong with the text, see [`QuantityError`].
pub fn parse(text: &str) -> Result<Quantity, QuantityError> {
    parse::quantity(text)
}

/// Why a text is no quantity, or not the one that is expected.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum QuantityError {
    /// The text does not begin with a number.
    #[error("it does not begin with a number")]
    NoNumber,
    /// The last of several numbers, whose unit holds for those without, has none, and another has one.
    #[error("its last number has no unit, and another has one: a unit stands behind each, or behind the last")]
    LastUnit,
    /// Infinite, not a number, or too large for a 64-bit float.
    #[error("it is not a finite number")]
    NotFinite,
    /// A unit that is not known.
    #[error("`{unit}` is not a known unit{}", nearest.as_ref().map(|unit| format!(" (did you mean \
        `{unit}`?)")).unwrap_or_default())]
    UnknownUnit {
        /// As written.
        unit: String,
        /// A known one that looks similar.
        nearest: Option<String>,
    },
    /// A character that has no place in a quantity.
    #[error("`{found}` is unexpected{}", if *found == ',' { " (decimals are written with a point)" } else { "" })]
    Unexpected {
        /// The character.
        found: char,
    },
    /// A unit is missing at the end, or a parenthesis is not closed.
    #[error("its unit is incomplete")]
    Incomplete,
    /// An exponent is missing, not an integer, or too large.
    #[error("exponents of units are integers from -9 to 9")]
    Exponent,
    /// A unit of another dimension.
    #[error("its unit is that of {given}, not of {expected}")]
    Dimension {
        /// Dimension of the unit given.
        given: Dimension,
        /// Dimension asked for.
        expected: Dimension,
    },
}

impl QuantityError {
    fn unknown_unit(unit: &str) -> Self {
        let (unit, lowercase) = (quoted(unit), quoted(unit).to_lowercase());
        let distance = |known: &str| strsim::damerau_levenshtein(known, &lowercase);
        let nearest = match (unit.as_ref(), lowercase.as_str()) {
            // Those of a temperature stand alone: in a product it is one of differences that is meant.
            ("degC" | "°C" | "degF" | "°F", _) => Some("K".to_owned()),
            (_, "c" | "degc" | "celsius") => Some("degC".to_owned()),
            (_, "f" | "degf" | "fahrenheit") => Some("degF".to_owned()),
            _ if unit::find(&lowercase).is_some() => Some(lowercase),
            _ => symbols().find(|known| distance(&known.to_lowercase()) <= 1).map(str::to_owned),
        };
        Self::UnknownUnit { unit: unit.into_owned(), nearest }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn si(text: &str, dimension: Dimension) -> f64 {
        parse(text).and_then(|quantity| quantity.expect(dimension)).unwrap_or_else(|error| panic!("{text}: {error}"))
    }

    #[test]
    fn quantities_of_the_base_case_are_exact() {
        assert_eq!(si("857.2 mm", Dimension::LENGTH), 0.8572);
        assert_eq!(si("68.309mm", Dimension::LENGTH), 0.068309);
        assert_eq!(si("0.4375 kg/m", Dimension::MASS_PER_LENGTH), 0.4375);
        assert_eq!(si("243.5 kN", Dimension::FORCE), 243.5e3);
        assert_eq!(si("0.2602 N*m^2", Dimension::BENDING_STIFFNESS), 0.2602);
        assert_eq!(si("18.71 MPa", Dimension::PRESSURE), 18.71e6);
        assert_eq!(si("12 deg", Dimension::ANGLE), 0.20943951023931953);
        assert_eq!(si("3400 rpm", Dimension::ANGULAR_SPEED), 356.0471674068432);
        assert_eq!(si("1e-4 m/s", Dimension::SPEED), 1e-4);
        assert_eq!(si("18 N*m", Dimension::TORQUE), 18.0);
    }

    #[test]
    fn a_list_has_one_unit_or_a_unit_for_each() {
        let speeds = ["1800 rpm", "2000 rpm"].map(|text| si(text, Dimension::ANGULAR_SPEED));
        for text in ["1800, 2000 rpm", "1800 rpm, 2000 rpm"] {
            assert_eq!(parse_list(text, Dimension::ANGULAR_SPEED).expect("a list"), speeds);
        }
        assert_eq!(parse_list("1800 rpm, 2000", Dimension::ANGULAR_SPEED), Err(QuantityError::LastUnit));
    }

    #[test]
    fn one_quantity_is_written_in_many_ways() {
        for torque in
            ["18 N·m", "18 N⋅m", "18Nm", "18 N m", "18000 mN*m", "0.018 kN·m", "18 kg·m²/s²", "18 kg m^2 s^-2"]
        {
            assert!((si(torque, Dimension::TORQUE) - 18.0).abs() < 1e-13, "{torque}");
        }
        for speed in ["60 rpm", "1 rev/s", "360 deg/s", "360°/s", "360 deg s⁻¹"] {
            assert!((si(speed, Dimension::ANGULAR_SPEED) - std::f64::consts::TAU).abs() < 1e-13, "{speed}");
        }
        assert!((si("18 lbf*ft", Dimension::TORQUE) - 24.404_723_2).abs() < 1e-6);
        for torque in ["18 ft-lb", "18 lb-ft", "18 lbf-ft", "18 ft-lbf", "18 lbf ft", "216 in-lb", "216 lbf-in"] {
            assert!((si(torque, Dimension::TORQUE) - 24.404_723_2).abs() < 1e-6, "{torque}");
        }
        for stiffness in ["0.26 Nm²", "0.26Nm^2", "0.26 N*m^2", "0.26 N·m²"] {
            assert_eq!(si(stiffness, Dimension::BENDING_STIFFNESS), 0.26, "{stiffness}");
        }
        assert_eq!(si("20 %", Dimension::NONE), 0.2);
        assert!((si("60 lbf", Dimension::FORCE) - 266.893_297).abs() < 1e-6);
        assert!((si("2714 psi", Dimension::PRESSURE) - 18_712_371.0).abs() < 5.0);
        assert!((si("1 N/(m*s)", Dimension::new(0, 1, -3, 0)) - 1.0).abs() < 1e-15);
        assert_eq!(si(" +.5e+1 1/s", Dimension::FREQUENCY), 5.0);
    }

    #[test]
    fn what_is_wrong_is_said() {
        let message = |text: &str| match parse(text).and_then(|quantity| quantity.expect(Dimension::LENGTH)) {
            Ok(value) => panic!("{text} was read as {value}"),
            Err(error) => error.to_string(),
        };
        assert_eq!(message(""), "it does not begin with a number");
        assert_eq!(message("mm"), "it does not begin with a number");
        assert_eq!(message("."), "it does not begin with a number");
        assert_eq!(message("-inf mm"), "it is not a finite number");
        assert_eq!(message("NaN"), "it is not a finite number");
        assert_eq!(message("1e999 mm"), "it is not a finite number");
        assert_eq!(message("68,3 mm"), "`,` is unexpected (decimals are written with a point)");
        assert_eq!(message("3 MM"), "`MM` is not a known unit (did you mean `mm`?)");
        assert_eq!(message("3 furlong"), "`furlong` is not a known unit");
        assert_eq!(message("60 C"), "`C` is not a known unit (did you mean `degC`?)");
        assert_eq!(message("140 degf"), "`degf` is not a known unit (did you mean `degF`?)");
        assert_eq!(message("0.01 1/degC"), "`degC` is not a known unit (did you mean `K`?)");
        assert_eq!(message("3 RPM"), "`RPM` is not a known unit (did you mean `rpm`?)");
        assert_eq!(message("3 kg"), "its unit is that of a mass, not of a length");
        assert_eq!(message("3 m^2"), "its unit is that of an area, not of a length");
        assert_eq!(message("3 m/"), "its unit is incomplete");
        assert_eq!(message("3 (m"), "its unit is incomplete");
        assert_eq!(message("3 m)"), "`)` is unexpected");
        assert_eq!(message("3 m^"), "exponents of units are integers from -9 to 9");
        assert_eq!(message("3 m^99"), "exponents of units are integers from -9 to 9");
        assert_eq!(message("0.4 1"), "`1` is unexpected");
        assert_eq!(message("0.4 1 1/s"), "`1` is unexpected");
        assert_eq!(message("3 ft-lb-s"), "`-` is unexpected");
        assert_eq!(message("3 m^9^9"), "`^` is unexpected");
        assert_eq!(message(&format!("3 {}m", "(".repeat(100_000))), "`(` is unexpected");
    }

    proptest! {
        #[test]
        fn no_text_panics(text in ".*") {
            let _ = parse(&text);
        }

        #[test]
        fn no_text_of_likely_characters_panics(text in "[-+0-9.eE]{0,6} ?[a-zA-Zµ°·*/^()⁻²³ 0-9-]{0,12}") {
            let _ = parse(&text);
        }

        #[test]
        fn a_number_in_a_unit_comes_back(value in prop::num::f64::NORMAL, index in 0..symbols().count()) {
            let symbol = symbols().nth(index).unwrap();
            // Which is a unit only where something is divided by: "1/s".
            prop_assume!(symbol != "1");
            prop_assume!(value.abs() > 1e-250 && value.abs() < 1e250);
            let scale = unit::find(symbol).unwrap();
            let read = parse(&format!("{value:e} {symbol}")).unwrap();
            prop_assert_eq!(read.dimension, scale.dimension);
            let back = Unit { symbol, scale }.from_si(read.si);
            prop_assert!((back / value - 1.0).abs() < 1e-14, "{} {}", value, back);
        }
    }
}
