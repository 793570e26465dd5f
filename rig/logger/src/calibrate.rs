//! The calibration of the torque sensor (thesis, 9.1): known weights on a rope around the brake's rotor, 500 values of
//! the converter for each, a straight line through them.

use std::fs::OpenOptions;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use rig_core::Frame;

use crate::calibration::{Calibration, CalibrationError};
use crate::hardware::Hardware;
use crate::session::PERIOD_US;

/// Values of the converter for each load, as in the thesis.
pub const VALUES_PER_LOAD: usize = 500;
/// Standard gravity, m/s².
const GRAVITY: f64 = 9.806_65;
/// Without so many values within this time the converter does not work; they take 4 s where it does.
const LONGEST_US: u64 = 20_000_000;

/// Where the weights hang.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rope {
    /// Radius at which the rope leaves the rotor, m.
    pub radius: f64,
    /// Teeth of the gears of secondary and brake.
    pub gears: (f64, f64),
}

impl Rope {
    /// Torque at the secondary, N·m, under a mass in kg on the rope.
    #[must_use]
    pub fn torque(&self, mass: f64) -> f64 {
        mass * GRAVITY * self.radius * self.gears.0 / self.gears.1
    }
}

/// Why a calibration was not made.
#[derive(Debug, thiserror::Error)]
pub enum CalibrateError {
    /// The converter gives too few values.
    #[error("only {found} of {VALUES_PER_LOAD} good values came within 20 s: check converter, bus and supply")]
    TooFewValues {
        /// Good values that came.
        found: usize,
    },
    /// The shaft turns, so that the weight is not the torque.
    #[error("a shaft turns: hold the secondary before weights are hung on the rotor")]
    Turning,
    /// No line can be laid through the values.
    #[error(transparent)]
    Fit(#[from] CalibrationError),
    /// Files.
    #[error("{path}: {error}", path = path.display())]
    File {
        /// Which.
        path: PathBuf,
        /// Why.
        error: io::Error,
    },
}

/// Takes the converter's values under one load. Nothing is permitted or moved meanwhile.
///
/// # Errors
/// If they do not come, or a shaft turns.
pub fn measure(hardware: &mut impl Hardware) -> Result<Vec<u16>, CalibrateError> {
    let begin = hardware.now();
    let mut values = Vec::with_capacity(VALUES_PER_LOAD);
    let mut last = None;
    while values.len() < VALUES_PER_LOAD {
        let time = hardware.now();
        if time > begin + LONGEST_US {
            return Err(CalibrateError::TooFewValues { found: values.len() });
        }
        hardware.wait_until(time + PERIOD_US);
        // A disturbed transfer is made up for by the next one.
        let Ok(Ok(frame)) = hardware.exchange(false).map(|bytes| Frame::from_bytes(&bytes)) else { continue };
        let snapshot = frame.snapshot;
        if !(snapshot.primary.stopped && snapshot.secondary.stopped) {
            return Err(CalibrateError::Turning);
        }
        if !snapshot.torque_stale && snapshot.torque_at.is_some() && snapshot.torque_at != last {
            last = snapshot.torque_at;
            values.push(snapshot.torque);
        }
    }
    Ok(values)
}

/// Fits the readings (torque at the secondary in N·m, value) and keeps both: the readings in a new file
/// `NAME-readings-SECONDS.csv` beside `file`, the line as one more row of `file`, whose last row counts. Nothing is
/// written over.
///
/// # Errors
/// If nothing can be fitted or written.
pub fn keep(file: &Path, readings: &[(f64, u16)], seconds: u64) -> Result<(Calibration, PathBuf), CalibrateError> {
    let calibration = Calibration::fit(readings)?;
    let stem = file.file_stem().map_or_else(|| "calibration".into(), |stem| stem.to_string_lossy());
    let beside = file.with_file_name(format!("{stem}-readings-{seconds}.csv"));
    let mut text = String::from("torque_Nm,adc\n");
    for (torque, value) in readings {
        text.push_str(&format!("{torque:.6},{value}\n"));
    }
    append(&beside, &text, true).map_err(|error| CalibrateError::File { path: beside.clone(), error })?;
    let Calibration { slope, intercept, r_squared, slope_interval, intercept_interval } = calibration;
    let row = format!("{slope},{intercept},{r_squared},{slope_interval},{intercept_interval},{seconds}\n");
    append(file, &row, false).map_err(|error| CalibrateError::File { path: file.to_owned(), error })?;
    Ok((calibration, beside))
}

/// Appends and synchronises; with `new`, only to a file that does not exist yet.
fn append(path: &Path, text: &str, new: bool) -> io::Result<()> {
    let mut file = OpenOptions::new().append(true).create(true).create_new(new).open(path)?;
    file.write_all(text.as_bytes())?;
    file.sync_all()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::calibration::last_of_csv;
    use crate::simulated::{Fault, SimulatedRig};

    #[test]
    fn a_simulated_calibration_finds_the_line_of_the_thesis_and_keeps_everything() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("cal_values.csv");
        let rope = Rope { radius: 0.12, gears: (32.0, 61.0) };
        assert!((rope.torque(10.0) - 6.1734).abs() < 1e-3);
        let mut readings = Vec::new();
        let mut rig = SimulatedRig::new(false);
        for mass in [0.0, 10.0, 20.0, 40.0] {
            rig.hung_load = Some(rope.torque(mass));
            let settled = rig.now() + 500_000;
            rig.wait_until(settled);
            readings.extend(measure(&mut rig).unwrap().into_iter().map(|value| (rope.torque(mass), value)));
        }
        let (fit, beside) = keep(&file, &readings, 1).unwrap();
        assert!((fit.slope - 108.19).abs() < fit.slope_interval, "{fit:?}");
        assert!((fit.intercept - 35_145.0).abs() < fit.intercept_interval && fit.r_squared > 0.999, "{fit:?}");
        assert_eq!(std::fs::read_to_string(&beside).unwrap().lines().count(), 2001);
        assert!(keep(&file, &readings, 1).is_err(), "readings are never written over");
        keep(&file, &readings, 2).unwrap();
        let text = std::fs::read_to_string(&file).unwrap();
        assert_eq!((text.lines().count(), last_of_csv(&text)), (2, Some(fit)));
    }

    #[test]
    fn a_dead_converter_and_a_turning_shaft_are_named() {
        let mut rig = SimulatedRig::new(false);
        rig.fail_at(0, Fault::LinkLost);
        assert!(matches!(measure(&mut rig), Err(CalibrateError::TooFewValues { found: 0 })));
        let mut rig = SimulatedRig::new(false);
        rig.plant.speeds = [200.0; 2];
        rig.wait_until(100_000);
        assert!(matches!(measure(&mut rig), Err(CalibrateError::Turning)));
    }
}
