//! Nominal radii of a belt that does not stretch, both ways (Appendix B), and what sheaves travel for them.
//!
//! ```
//! use sheave::bench::radii::Geometry;
//! let drive = Geometry { pitch_length: 0.8572, center_distance: 0.214, half_angle: 12f64.to_radians() };
//! let low = drive.at_ratio(1.74)?;
//! let high = drive.at_ratio(0.72)?;
//! assert!((drive.travel(low.primary_radius, high.primary_radius) - 0.0127).abs() < 1e-5); // 2 tan β ΔR
//! # Ok::<(), sheave::bench::BenchError>(())
//! ```

use super::error::{BenchError, BenchProblem};
use crate::actuator::travel_by_radius;
use crate::case::geometry::{NoRadii, pitch_length, radii_of_ratio, radius_beside, wrap_angles};
use serde::Serialize;

/// A belt around two pulleys; SI.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Geometry {
    /// L_p, m.
    pub pitch_length: f64,
    /// L_c, m.
    pub center_distance: f64,
    /// β, rad.
    pub half_angle: f64,
}

/// Where the belt runs; SI.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Radii {
    /// R_P, m.
    pub primary_radius: f64,
    /// R_S, m.
    pub secondary_radius: f64,
    /// R_S/R_P.
    pub ratio: f64,
    /// Φ_P, rad (6.11).
    pub primary_wrap_angle: f64,
    /// Φ_S, rad (6.11).
    pub secondary_wrap_angle: f64,
    /// Length of one straight span, m.
    pub span_length: f64,
}

/// Smallest and largest radii that the pulleys have room for, m.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Limits {
    /// Of the primary.
    pub primary: (f64, f64),
    /// Of the secondary.
    pub secondary: (f64, f64),
}

/// From the lowest range, where the secondary runs slowest, to the highest.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ShiftRange {
    /// Lowest range.
    pub low: Radii,
    /// Highest range.
    pub high: Radii,
    /// Ratio in the lowest over that in the highest range.
    pub span: f64,
    /// What the movable sheave of the primary travels to close, m.
    pub primary_travel: f64,
    /// What that of the secondary travels to open, m.
    pub secondary_travel: f64,
}

impl Geometry {
    fn none(&self, given: &str, reason: NoRadii) -> BenchError {
        let (length, center) = (1e3 * self.pitch_length, 1e3 * self.center_distance);
        let reason = format!(
            "a belt of pitch length {length:.2} mm around pulleys {center:.2} mm apart does not close: {reason}"
        );
        BenchError::from(BenchProblem::Unusable { path: given.into(), reason })
            .advise("check the belt's length and the distance between the centres")
    }

    /// Both radii, which fit each other.
    fn with(&self, primary_radius: f64, secondary_radius: f64) -> Radii {
        let (primary_wrap_angle, secondary_wrap_angle) =
            wrap_angles(primary_radius, secondary_radius, self.center_distance);
        let span_length = (self.center_distance.powi(2) - (secondary_radius - primary_radius).powi(2)).sqrt();
        let ratio = secondary_radius / primary_radius;
        Radii { primary_radius, secondary_radius, ratio, primary_wrap_angle, secondary_wrap_angle, span_length }
    }

    /// Radii from the ratio R_S/R_P (`radii_given_ratio` of Appendix B).
    ///
    /// # Errors
    /// [`BenchProblem::Unusable`] for a belt that does not close, or a ratio that is not positive and finite.
    pub fn at_ratio(&self, ratio: f64) -> Result<Radii, BenchError> {
        positive("ratio", ratio)?;
        let radii = radii_of_ratio(ratio, self.pitch_length, self.center_distance);
        radii.map(|(primary, secondary)| self.with(primary, secondary)).map_err(|none| self.none("ratio", none))
    }

    /// Radii from that of the primary.
    ///
    /// # Errors
    /// As [`Geometry::at_ratio`], and for a radius that leaves no room for the other pulley.
    pub fn at_primary(&self, radius: f64) -> Result<Radii, BenchError> {
        Ok(self.with(radius, self.beside("primary radius", radius)?))
    }

    /// Radii from that of the secondary (`nominal_primary_radius` of Appendix B).
    ///
    /// # Errors
    /// As [`Geometry::at_primary`].
    pub fn at_secondary(&self, radius: f64) -> Result<Radii, BenchError> {
        Ok(self.with(self.beside("secondary radius", radius)?, radius))
    }

    /// Radii from what the primary's movable sheave has travelled, positive to close, from where the belt ran at
    /// `from`.
    ///
    /// # Errors
    /// As [`Geometry::at_primary`].
    pub fn at_travel(&self, travel: f64, from: f64) -> Result<Radii, BenchError> {
        let radius = from + travel / travel_by_radius(self.half_angle);
        if !(radius > 0.0 && radius.is_finite()) {
            let reason = format!(
                "{:.3} mm from a radius of {:.3} mm leads to one of {:.3} mm; with a half angle of {:.2} deg the \
                 sheave opens by no more than {:.3} mm",
                1e3 * travel,
                1e3 * from,
                1e3 * radius,
                self.half_angle.to_degrees(),
                -1e3 * self.travel(from, 0.0)
            );
            return Err(BenchProblem::Unusable { path: "travel".into(), reason }.into());
        }
        self.at_primary(radius)
    }

    /// What the movable sheave of a pulley travels, the other standing still, for the belt to move from one radius to
    /// another: Δs = 2 tan(β) ΔR, positive to close; m.
    pub fn travel(&self, from: f64, to: f64) -> f64 {
        travel_by_radius(self.half_angle) * (to - from)
    }

    fn beside(&self, given: &str, radius: f64) -> Result<f64, BenchError> {
        positive(given, radius)?;
        if radius >= self.center_distance {
            let reason = format!(
                "{:.3} mm leaves no room for the other pulley, {:.3} mm away",
                1e3 * radius,
                1e3 * self.center_distance
            );
            return Err(BenchProblem::Unusable { path: given.into(), reason }.into());
        }
        radius_beside(radius, self.pitch_length, self.center_distance).map_err(|none| self.none(given, none))
    }

    /// The largest shift range within limits.
    ///
    /// # Errors
    /// Limits in the wrong order, or between which the belt fits nowhere.
    pub fn shift_range(&self, limits: &Limits) -> Result<ShiftRange, BenchError> {
        for (name, (smallest, largest)) in [("primary limits", limits.primary), ("secondary limits", limits.secondary)]
        {
            positive(name, smallest)?;
            if !(smallest <= largest && largest.is_finite()) {
                let reason = format!("{smallest} m to {largest} m is no range: expected the smaller radius first");
                return Err(BenchProblem::Unusable { path: name.into(), reason }.into());
            }
        }
        // The one radius falls as the other grows: an end is where the first of the two meets its limit.
        let end = |primary: f64, secondary: f64, low: bool| {
            let by_primary = self.at_primary(primary);
            match by_primary {
                Ok(radii) if low && radii.secondary_radius <= secondary => Ok(radii),
                Ok(radii) if !low && radii.secondary_radius >= secondary => Ok(radii),
                _ => self.at_secondary(secondary),
            }
        };
        let low = end(limits.primary.0, limits.secondary.1, true)?;
        let high = end(limits.primary.1, limits.secondary.0, false)?;
        let within = |value: f64, (smallest, largest): (f64, f64)| {
            value >= smallest * (1.0 - 1e-12) && value <= largest * (1.0 + 1e-12)
        };
        for radii in [low, high] {
            if !(within(radii.primary_radius, limits.primary) && within(radii.secondary_radius, limits.secondary)) {
                let reason = format!(
                    "the belt fits nowhere between these limits: with {:.3} mm on the secondary it runs at {:.3} mm \
                     on the primary",
                    1e3 * radii.secondary_radius,
                    1e3 * radii.primary_radius
                );
                return Err(BenchProblem::Unusable { path: "limits".into(), reason }.into());
            }
        }
        Ok(ShiftRange {
            low,
            high,
            span: low.ratio / high.ratio,
            primary_travel: self.travel(low.primary_radius, high.primary_radius),
            secondary_travel: -self.travel(low.secondary_radius, high.secondary_radius),
        })
    }

    /// Pitch length around given radii, m, and by how much the belt is longer; (6.12).
    pub fn error(&self, primary: f64, secondary: f64) -> f64 {
        self.pitch_length - pitch_length(primary, secondary, self.center_distance)
    }
}

fn positive(name: &str, value: f64) -> Result<(), BenchError> {
    if value > 0.0 && value.is_finite() {
        return Ok(());
    }
    let reason = format!("{value} is out of range: expected a finite number above zero");
    Err(BenchProblem::Unusable { path: name.into(), reason }.into())
}
