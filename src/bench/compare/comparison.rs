//! What is compared with measurements, and what comes of it.

use super::actuator::Actuator;
use super::measured::BadRow;
use serde::Serialize;

/// What holds the belt tight at the measured points.
#[derive(Debug, Clone, PartialEq)]
pub enum Clamp {
    /// What the case says.
    OfCase,
    /// Flyweights and spring of the primary (9.3).
    Actuator(Actuator),
}

/// What the radii follow from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Radii {
    /// Both speeds and the belt's length: the belt slips in the model as it does on the bench.
    Speeds,
    /// The ratio of the speeds, which counts as that of the radii, by (6.12): as section 9.4 of the thesis has it.
    Ratio,
}

/// How points are compared.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// Relative tolerance of the solutions.
    pub tolerance: f64,
    /// The clamp.
    pub clamp: Clamp,
    /// The radii.
    pub radii: Radii,
    /// Keys that are fitted: those of a case, or [`ENGINE_SCALE`](super::ENGINE_SCALE).
    pub fit: Vec<String>,
}

/// One point with what the model says, SI.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Compared {
    /// Run of the table.
    pub run: String,
    /// Step of the table.
    pub step: Option<f64>,
    /// ω_P, rad/s.
    pub primary_speed: f64,
    /// ω_S, rad/s.
    pub secondary_speed: f64,
    /// Torque out of the secondary, N·m.
    pub secondary_torque: f64,
    /// Torque into the primary by measurement or the engine's curve, N·m.
    pub primary_torque: Option<f64>,
    /// ω_P/ω_S.
    pub speed_ratio: Option<f64>,
    /// R_P in the model, m.
    pub primary_radius: Option<f64>,
    /// Axial force on the primary in the model, N.
    pub primary_axial_force: Option<f64>,
    /// Measured, by the engine's curve as it is.
    pub efficiency_measured: Option<f64>,
    /// Standard error of the measured efficiency.
    pub efficiency_error: Option<f64>,
    /// Interval of 95 % confidence of the measured efficiency, by Student's distribution.
    pub efficiency_interval: Option<(f64, f64)>,
    /// The model's: with losses besides friction, if the case asks for them (`losses.include = "on"`).
    pub efficiency_model: Option<f64>,
    /// The model's with friction alone.
    pub efficiency_elastic: Option<f64>,
    /// Temperature of the belt in the model, K, if the case asks for it.
    pub belt_temperature: Option<f64>,
    /// Whether the point counts.
    pub used: bool,
    /// Why it does not.
    pub reason: Option<String>,
}

/// A constant that was fitted, SI.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FittedConstant {
    /// Its key.
    pub key: String,
    /// Where the search started.
    pub start: f64,
    /// Its value.
    pub value: f64,
    /// Standard error; `None` where the data do not determine it.
    pub standard_error: Option<f64>,
    /// Interval that contains it with 95 % confidence, as far as it lies within the key's range.
    pub interval: Option<(f64, f64)>,
    /// Whether it is held at an end of the key's range, beyond which it would agree better with the data.
    pub at_end_of_range: bool,
}

/// A fit.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Fit {
    /// What was fitted.
    pub constants: Vec<FittedConstant>,
    /// Correlations of the constants' logarithms.
    pub correlation: Vec<Vec<f64>>,
    /// Iterations.
    pub iterations: usize,
    /// Whether it converged.
    pub converged: bool,
    /// Why the model has no solution where the last step would have led, if that kept the fit from converging.
    pub obstacle: Option<String>,
    /// Condition of the derivatives.
    pub condition: f64,
    /// Whether points count by their standard errors; else all count the same.
    pub weighted: bool,
    /// Root of the mean square of what remains.
    pub rms: f64,
}

/// The comparison.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Comparison {
    /// All points, in the order of the table.
    pub points: Vec<Compared>,
    /// Rows of the table that are no points.
    pub bad_rows: Vec<BadRow>,
    /// Factor on the engine's power that makes both agree best, by the points whose input torque is not measured; 1
    /// where that of all is.
    pub scale: f64,
    /// Its interval of 95 % confidence; `None` for an end that the points do not determine.
    pub scale_interval: (f64, Option<f64>),
    /// Mean of model less measurement.
    pub mean_error: f64,
    /// Root of the mean square of the difference.
    pub rms: f64,
    /// The same with the scale.
    pub rms_after_scale: f64,
    /// R² of the measurements about the model; `None` where they do not differ.
    pub r_squared: Option<f64>,
    /// The same with the scale.
    pub r_squared_after_scale: Option<f64>,
    /// The fit, if one was asked for.
    pub fit: Option<Fit>,
    /// What a reader should know.
    #[serde(skip)]
    pub warnings: Vec<String>,
}
