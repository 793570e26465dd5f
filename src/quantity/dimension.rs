//! Dimensions as exponents of base dimensions.

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

/// Dimensions with a name that people use.
const NAMED: [(Dimension, &str); 23] = [
    (Dimension::NONE, "a plain number"),
    (Dimension::LENGTH, "a length"),
    (Dimension::MASS, "a mass"),
    (Dimension::TIME, "a time"),
    (Dimension::ANGLE, "an angle"),
    (Dimension::ANGULAR_SPEED, "an angular speed"),
    (Dimension::SPEED, "a speed"),
    (Dimension::FREQUENCY, "a frequency"),
    (Dimension::FORCE, "a force"),
    (Dimension::TORQUE, "a torque"),
    (Dimension::PRESSURE, "a pressure"),
    (Dimension::POWER, "a power"),
    (Dimension::MASS_PER_LENGTH, "a mass per length"),
    (Dimension::BENDING_STIFFNESS, "a bending stiffness"),
    (Dimension::SPRING_RATE, "a force per length"),
    (Dimension::TORSION_RATE, "a torque per angle"),
    (Dimension::AREA, "an area"),
    (Dimension::DENSITY, "a density"),
    (Dimension::DRAG_PER_SPEED, "a torque over a speed"),
    (Dimension::TEMPERATURE, "a temperature"),
    (Dimension::PER_TEMPERATURE, "a share per kelvin"),
    (Dimension::HEAT_TRANSFER, "a power over a difference of temperatures"),
    (Dimension::HEAT_TRANSFER_PER_AREA, "a power over an area and a difference of temperatures"),
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

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some((_, name)) = NAMED.iter().find(|(dimension, _)| dimension == self) {
            return f.write_str(name);
        }
        f.write_str("a quantity in ")?;
        let exponents =
            [("m", self.length), ("kg", self.mass), ("s", self.time), ("rad", self.angle), ("K", self.temperature)];
        let mut separator = "";
        for (symbol, exponent) in exponents.into_iter().filter(|(_, exponent)| *exponent != 0) {
            write!(f, "{separator}{symbol}")?;
            if exponent != 1 {
                write!(f, "^{exponent}")?;
            }
            separator = "*";
        }
        Ok(())
    }
}
