//! Dimensions as exponents of base dimensions.

use std::borrow::Cow;
use std::fmt;

/// Exponents of length, mass, time, plane angle and temperature.
///
/// The angle counts as a dimension of its own although SI derives it from lengths: so an angle given for a friction
/// coefficient, or a frequency for an angular speed (a silent factor of 2π), is refused.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Dimension {
    /// Exponent of the metre.
    pub length: i8,
    /// Exponent of the kilogram.
    pub mass: i8,
    /// Exponent of the second.
    pub time: i8,
    /// Exponent of the radian.
    pub angle: i8,
    /// Exponent of the kelvin.
    pub temperature: i8,
}

/// Dimensions with a name that people use, and the unit in which files state them.
const NAMED: [(Dimension, &str, &str); 23] = [
    (Dimension::NONE, "a plain number", "1"),
    (Dimension::LENGTH, "a length", "m"),
    (Dimension::MASS, "a mass", "kg"),
    (Dimension::TIME, "a time", "s"),
    (Dimension::ANGLE, "an angle", "rad"),
    (Dimension::ANGULAR_SPEED, "an angular speed", "rad/s"),
    (Dimension::SPEED, "a speed", "m/s"),
    (Dimension::FREQUENCY, "a frequency", "1/s"),
    (Dimension::FORCE, "a force", "N"),
    (Dimension::TORQUE, "a torque", "N*m"),
    (Dimension::PRESSURE, "a pressure", "Pa"),
    (Dimension::POWER, "a power", "W"),
    (Dimension::MASS_PER_LENGTH, "a mass per length", "kg/m"),
    (Dimension::BENDING_STIFFNESS, "a bending stiffness", "N*m^2"),
    (Dimension::SPRING_RATE, "a force per length", "N/m"),
    (Dimension::TORSION_RATE, "a torque per angle", "N*m/rad"),
    (Dimension::AREA, "an area", "m^2"),
    (Dimension::DENSITY, "a density", "kg/m^3"),
    (Dimension::DRAG_PER_SPEED, "a torque over a speed", "N*m*s"),
    (Dimension::TEMPERATURE, "a temperature", "K"),
    (Dimension::PER_TEMPERATURE, "a share per kelvin", "1/K"),
    (Dimension::HEAT_TRANSFER, "a power over a difference of temperatures", "W/K"),
    (Dimension::HEAT_TRANSFER_PER_AREA, "a power over an area and a difference of temperatures", "W/(m^2*K)"),
];

impl Dimension {
    /// A plain number.
    pub const NONE: Self = Self::new(0, 0, 0, 0);
    /// Metre.
    pub const LENGTH: Self = Self::new(1, 0, 0, 0);
    /// Kilogram.
    pub const MASS: Self = Self::new(0, 1, 0, 0);
    /// Second.
    pub const TIME: Self = Self::new(0, 0, 1, 0);
    /// Radian.
    pub const ANGLE: Self = Self::new(0, 0, 0, 1);
    /// Radian per second.
    pub const ANGULAR_SPEED: Self = Self::new(0, 0, -1, 1);
    /// Metre per second.
    pub const SPEED: Self = Self::new(1, 0, -1, 0);
    /// Per second.
    pub const FREQUENCY: Self = Self::new(0, 0, -1, 0);
    /// Newton.
    pub const FORCE: Self = Self::new(1, 1, -2, 0);
    /// Newton metre.
    pub const TORQUE: Self = Self::new(2, 1, -2, 0);
    /// Pascal.
    pub const PRESSURE: Self = Self::new(-1, 1, -2, 0);
    /// Watt.
    pub const POWER: Self = Self::new(2, 1, -3, 0);
    /// Kilogram per metre.
    pub const MASS_PER_LENGTH: Self = Self::new(-1, 1, 0, 0);
    /// Newton metre squared.
    pub const BENDING_STIFFNESS: Self = Self::new(3, 1, -2, 0);

    /// Newton per metre.
    pub const SPRING_RATE: Self = Self::new(0, 1, -2, 0);
    /// Newton metre per radian.
    pub const TORSION_RATE: Self = Self::new(2, 1, -2, -1);
    /// Square metre.
    pub const AREA: Self = Self::new(2, 0, 0, 0);
    /// Kilogram per cubic metre.
    pub const DENSITY: Self = Self::new(-3, 1, 0, 0);

    /// Newton metre second per radian: a torque over a speed of rotation, written N*m*s.
    pub const DRAG_PER_SPEED: Self = Self::new(2, 1, -1, 0);

    /// Kelvin.
    pub const TEMPERATURE: Self = Self { temperature: 1, ..Self::NONE };
    /// Per kelvin.
    pub const PER_TEMPERATURE: Self = Self { temperature: -1, ..Self::NONE };
    /// Watt per kelvin.
    pub const HEAT_TRANSFER: Self = Self { temperature: -1, ..Self::POWER };
    /// Watt per square metre and kelvin.
    pub const HEAT_TRANSFER_PER_AREA: Self = Self { temperature: -1, ..Self::new(0, 1, -3, 0) };

    /// From the exponents of length, mass, time and angle.
    pub const fn new(length: i8, mass: i8, time: i8, angle: i8) -> Self {
        Self { length, mass, time, angle, temperature: 0 }
    }

    /// This dimension times `other` to the power `exponent`; `None` when an exponent leaves the range of `i8`.
    pub fn times(self, other: Self, exponent: i8) -> Option<Self> {
        let add = |a: i8, b: i8| a.checked_add(b.checked_mul(exponent)?);
        Some(Self {
            length: add(self.length, other.length)?,
            mass: add(self.mass, other.mass)?,
            time: add(self.time, other.time)?,
            angle: add(self.angle, other.angle)?,
            temperature: add(self.temperature, other.temperature)?,
        })
    }
}

impl From<generated::Dimension> for Dimension {
    fn from(generated::Dimension { length, mass, time, angle }: generated::Dimension) -> Self {
        Self { length, mass, time, angle, temperature: 0 }
    }
}

impl Dimension {
    /// The coherent SI unit as files state it, `N*m`; `1` for a plain number, a product of base units for a dimension
    /// without a name.
    ///
    /// ```
    /// use sheave::quantity::Dimension;
    /// assert_eq!(Dimension::TORQUE.si_unit(), "N*m");
    /// assert_eq!(Dimension::new(1, 0, -2, 0).si_unit(), "m*s^-2");
    /// ```
    pub fn si_unit(self) -> Cow<'static, str> {
        match NAMED.iter().find(|(dimension, ..)| *dimension == self) {
            Some((.., unit)) => Cow::Borrowed(unit),
            None => Cow::Owned(self.product()),
        }
    }

    /// The base units with their exponents.
    fn product(self) -> String {
        let exponents =
            [("m", self.length), ("kg", self.mass), ("s", self.time), ("rad", self.angle), ("K", self.temperature)];
        let power = |(symbol, exponent): (&str, i8)| match exponent {
            0 => None,
            1 => Some(symbol.to_owned()),
            _ => Some(format!("{symbol}^{exponent}")),
        };
        exponents.into_iter().filter_map(power).collect::<Vec<_>>().join("*")
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match NAMED.iter().find(|(dimension, ..)| dimension == self) {
            Some((_, words, _)) => f.write_str(words),
            None => write!(f, "a quantity in {}", self.product()),
        }
    }
}
