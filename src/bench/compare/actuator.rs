//! The axial force of flyweights and a spring on the primary: (9.2) and (9.3).

use crate::actuator::travel_by_radius;
use crate::bench::error::BenchError;
use crate::bench::sheet::{Entry, QuantityKind, Sheet};
use crate::case::Range;
use crate::quantity::{Dimension, Unit};
use std::path::Path;

const MM: QuantityKind =
    QuantityKind::Quantity { unit: Unit::decimal("mm", -3, Dimension::LENGTH), range: Range::positive_to(1e4) };
const PLAIN: QuantityKind =
    QuantityKind::Quantity { unit: Unit::decimal("", 0, Dimension::NONE), range: Range::POSITIVE };

const fn entry(path: &'static str, kind: QuantityKind, example: &'static str, doc: &'static str) -> Entry {
    Entry { path, kind, example, doc }
}

/// Keys of a description of the primary's actuator.
#[rustfmt::skip]
pub static TABLE: [Entry; 8] = [
    entry("flyweights.count", PLAIN, "3", "flyweights"),
    entry("flyweights.mass", QuantityKind::Quantity { unit: Unit::decimal("g", -3, Dimension::MASS),
        range: Range::POSITIVE }, "\"228 g\"",
        "m, mass of each"),
    entry("flyweights.position.belt_radius", MM, "\"68 mm\"", "one [[flyweights.position]] for each radius of the belt \
        on the primary"),
    entry("flyweights.position.radius", MM, "\"52 mm\"", "r, radius of a flyweight's centre of mass there"),
    entry("flyweights.position.advantage", PLAIN, "0.6", "ΔD_R/ΔD_A, radial over axial displacement there"),
    entry("spring.force_at_full_shift", QuantityKind::Quantity { unit: Unit::decimal("N", 0, Dimension::FORCE),
        range: Range::POSITIVE },
        "\"950 N\"", "force of the spring at full shift"),
    entry("spring.rate", QuantityKind::Quantity { unit: Unit::decimal("N/m", 0, Dimension::new(0, 1, -2, 0)),
        range: Range::POSITIVE },
        "\"18200 N/m\"", "rate of the spring"),
    entry("spring.full_shift_radius", MM, "\"93 mm\"", "radius of the belt on the primary at full shift"),
];

/// Flyweights and spring of the primary, SI.
#[derive(Debug, Clone, PartialEq)]
pub struct Actuator {
    /// Number of flyweights times the mass of each, kg.
    mass: f64,
    /// Belt radius, radius of the centre of mass, mechanical advantage; in the order of belt radii.
    positions: Vec<(f64, f64, f64)>,
    full_shift_force: f64,
    rate: f64,
    full_shift_radius: f64,
}

impl Actuator {
    /// Reads a description.
    ///
    /// # Errors
    /// What is wrong with the file.
    pub fn read(path: &Path) -> Result<Self, BenchError> {
        Self::of(&Sheet::read(path, &TABLE)?)
    }

    /// As [`Actuator::read`], from the text of a file.
    ///
    /// # Errors
    /// As [`Actuator::read`].
    pub fn parse(name: &str, text: &str) -> Result<Self, BenchError> {
        Self::of(&Sheet::parse(name, text, &TABLE)?)
    }

    fn of(sheet: &Sheet) -> Result<Self, BenchError> {
        let position = |at: usize| {
            let need = |name: &str| sheet.need(&format!("flyweights.position.{at}.{name}"));
            Ok((need("belt_radius")?, need("radius")?, need("advantage")?))
        };
        let mut positions =
            (0..sheet.count("flyweights.position")).map(position).collect::<Result<Vec<_>, BenchError>>()?;
        positions.sort_by(|a, b| a.0.total_cmp(&b.0));
        if positions.len() < 2 || positions.windows(2).any(|pair| pair[0].0 == pair[1].0) {
            let reason = "a table of at least two positions, each at another belt radius, is needed";
            return Err(sheet.unusable("flyweights.position", reason));
        }
        Ok(Self {
            mass: sheet.need("flyweights.count")? * sheet.need("flyweights.mass")?,
            positions,
            full_shift_force: sheet.need("spring.force_at_full_shift")?,
            rate: sheet.need("spring.rate")?,
            full_shift_radius: sheet.need("spring.full_shift_radius")?,
        })
    }

    /// Derivative of [`Actuator::axial_force`] by the half angle in N/rad: rate · 2 (R_full − R_P)/cos² β.
    pub fn force_by_half_angle(&self, radius: f64, half_angle: f64) -> f64 {
        let tangent = 0.5 * travel_by_radius(half_angle);
        self.rate * 2.0 * (1.0 + tangent * tangent) * (self.full_shift_radius - radius)
    }

    /// F_A in N at a belt radius in m and a speed in rad/s, with the sheaves' half angle in rad:
    /// (count m r ΔD_R/ΔD_A) ω² − (F_full − rate · 2 tan β (R_full − R_P)) (9.3).
    ///
    /// # Errors
    /// A radius outside the table, or a force that does not push the sheaves together; the words say which.
    pub fn axial_force(&self, radius: f64, speed: f64, half_angle: f64) -> Result<f64, String> {
        let pair = self.positions.windows(2).find(|pair| pair[0].0 <= radius && radius <= pair[1].0);
        let Some([a, b]) = pair else {
            return Err(format!("the table of flyweight positions does not cover a radius of {:.2} mm", 1e3 * radius));
        };
        let share = (radius - a.0) / (b.0 - a.0);
        let (arm, advantage) = (a.1 + share * (b.1 - a.1), a.2 + share * (b.2 - a.2));
        let opened = travel_by_radius(half_angle) * (self.full_shift_radius - radius);
        let spring = self.full_shift_force - self.rate * opened;
        let force = self.mass * arm * advantage * speed.powi(2) - spring;
        if force > 0.0 { Ok(force) } else { Err(format!("flyweights and spring leave an axial force of {force:.1} N")) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_force_is_that_of_the_thesis() {
        let text = "[flyweights]\ncount = 3\nmass = \"228 g\"\n\
                    [[flyweights.position]]\nbelt_radius = \"40 mm\"\nradius = \"45 mm\"\nadvantage = 0.5\n\
                    [[flyweights.position]]\nbelt_radius = \"93 mm\"\nradius = \"60 mm\"\nadvantage = 0.5\n\
                    [spring]\nforce_at_full_shift = \"950 N\"\nrate = \"18200 N/m\"\nfull_shift_radius = \"93 mm\"\n";
        let actuator = Actuator::parse("a.toml", text).unwrap();
        let (radius, speed, angle) = (0.0665, 300.0, 12f64.to_radians());
        let expected =
            3.0 * 0.228 * 0.0525 * 0.5 * speed * speed - (950.0 - 18200.0 * 2.0 * angle.tan() * (0.093 - radius));
        assert!((actuator.axial_force(radius, speed, angle).unwrap() - expected).abs() < 1e-9);
        let force = |angle: f64| actuator.axial_force(radius, speed, angle).unwrap();
        let slope = (force(angle + 1e-4) - force(angle - 1e-4)) / 2e-4;
        assert!((actuator.force_by_half_angle(radius, angle) / slope - 1.0).abs() < 1e-6, "{slope}");
        assert!(actuator.axial_force(0.1, speed, angle).unwrap_err().contains("does not cover"));
        assert!(actuator.axial_force(0.09, 10.0, angle).unwrap_err().contains("leave an axial force"));
    }
}
