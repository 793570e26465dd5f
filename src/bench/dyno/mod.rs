//! From the raw logs of a dynamometer to operating points, file by file and row by row in bounded memory.
//!
//! Three forms of logs are read: one file for each channel and step (`P_3.csv`, `S_3.csv`, `ADC_3.csv`, `TORQUE_3.csv`:
//! time in µs, value), one file with a header (`timestamp_ms,primary_rpm,secondary_rpm,torque`), and RaceCapture's, in
//! which channels of several rates share a file. All may be compressed by gzip. A row that cannot be used is counted by
//! its fault and nothing else is lost.

pub mod calibration;
mod clock;
mod faults;
mod format;
mod lines;
mod point;
mod read;
mod reduce;
mod show;
mod spectrum;
mod stream;
mod uniform;

pub use clock::{Clock, Stamp};
pub use faults::{Count, Fault, Faults};
pub use format::{Channel, Column, Format, Names, StepChannel, by_header, step_file};
pub use lines::{LONGEST, Line, Lines};
pub use point::{Criteria, Estimate, SteadyPoint};
pub use read::{FileReport, LogFile, Record, RecordReport, Run, is_log, process, records, runs};
pub use reduce::{MOST_POINTS, Reduced, reduce};
pub(crate) use show::aired;
pub use show::{figures, points_csv, spectrum_figures};
pub use spectrum::{Order, Spectrum};
pub use stream::Stream;
pub use uniform::{Row, Uniform};

use super::engine::EngineCurve;
use super::statistics::Line as Fit;
use serde::Serialize;

/// Channels that are read.
pub const CHANNELS: usize = 3;

/// One measured value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// s.
    pub time: f64,
    /// What was measured.
    pub channel: Channel,
    /// In the unit of its channel.
    pub value: f64,
    /// Number of its stretch: windows of a run, and what lies on both sides of a reset of the counter, are not
    /// averaged together, nor is anything interpolated between them.
    pub stretch: u64,
}

/// How logs are reduced.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Options {
    /// Uniform rate, Hz.
    pub rate: f64,
    /// Length of a window that is averaged, s.
    pub window: f64,
    /// Longest time between two samples of a channel that is bridged by interpolation, s.
    pub longest_gap: f64,
    /// What makes a window steady.
    pub criteria: Criteria,
    /// Speed of the secondary over what its column has.
    pub secondary_factor: f64,
    /// Speed of the brake's shaft over that of the secondary.
    pub gear: f64,
    /// Whether torque is measured, and calibrated, at the brake's shaft; else it is calibrated as torque of the
    /// secondary.
    pub torque_at_sensor: bool,
    /// Revolutions of the engine between two firings.
    pub revolutions: f64,
    /// Calibration of raw torque: ADC over N·m.
    pub calibration: Option<Fit>,
    /// Curve of the engine.
    #[serde(skip)]
    pub engine: Option<EngineCurve>,
    /// Names of columns.
    #[serde(skip)]
    pub names: Names,
    /// Time windows of logs, by the name of the file.
    #[serde(skip)]
    pub runs: Vec<Run>,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            rate: 125.0,
            window: 3.0,
            longest_gap: 0.25,
            criteria: Criteria::default(),
            secondary_factor: 1.0,
            gear: 1.0,
            torque_at_sensor: false,
            revolutions: 2.0,
            calibration: None,
            engine: None,
            names: Names::default(),
            runs: Vec::new(),
        }
    }
}
