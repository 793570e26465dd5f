//! The calibration of the torque sensor (thesis, 9.1): known weights on a rope around the brake's rotor, 500 values of
//! the converter for each, a straight line through them.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use rig_core::Frame;

use crate::calibration::{Calibration, CalibrationError, RowError, last_of_csv};
use crate::hardware::Hardware;
use crate::runs;
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
    /// The row that was made, or the one that is read back, is no calibration.
    #[error("{path}: {error}", path = path.display())]
    Row {
        /// Which file.
        path: PathBuf,
        /// Why.
        error: RowError,
    },
    /// The file's last row is another one after the new one was added.
    #[error(
        "{path}: the new calibration was added, but the last row read back is ADC = {slope} T + {intercept}",
        path = path.display()
    )]
    NotLast {
        /// Which file.
        path: PathBuf,
        /// Slope read back.
        slope: f64,
        /// Intercept read back.
        intercept: f64,
    },
    /// The operator could not be asked.
    #[error("the next weight cannot be asked for: {0}")]
    Asking(io::Error),
    /// It failed with readings taken, and these were kept.
    #[error("{error}; the readings taken until then are in {path}", path = path.display())]
    After {
        /// Why.
        error: Box<CalibrateError>,
        /// Where the readings are.
        path: PathBuf,
    },
    /// It failed with readings taken, and these could not be kept either.
    #[error("{error}; the readings taken until then could not be kept: {why}")]
    AfterAll {
        /// Why.
        error: Box<CalibrateError>,
        /// Why they could not be kept.
        why: Box<CalibrateError>,
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

/// One value of the converter under a torque at the secondary, N·m.
pub type LoadReading = (f64, u16);

/// Measures under one mass (kg) after the other and keeps the line through the readings. Before anything is asked or
/// measured it is checked that the masses can give a line and that it can be kept; the folder of `file` is made where
/// it is missing. `hang` has a mass hung, which makes a torque in N·m;
/// `measured` is told of the values under each. Where something fails, the readings until then are kept all the same.
///
/// # Errors
/// If fewer than two different masses are given, values do not come, or nothing can be fitted or written.
pub fn run<H: Hardware>(
    rig: &mut H,
    masses: &[f64],
    rope: Rope,
    file: &Path,
    mut hang: impl FnMut(&mut H, f64, f64) -> io::Result<()>,
    mut measured: impl FnMut(&[u16]),
) -> Result<(Calibration, PathBuf), CalibrateError> {
    let mut loads: Vec<f64> = masses.iter().map(|mass| rope.torque(*mass)).collect();
    loads.sort_by(f64::total_cmp);
    loads.dedup();
    if loads.len() < 2 {
        return Err(CalibrationError::TooFewLoads { loads: loads.len() }.into());
    }
    let since = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH);
    let seconds = since.map_or(0, |since| since.as_secs());
    prepare(file, seconds)?;
    let mut readings = Vec::new();
    let mut under = |mass: f64, readings: &mut Vec<LoadReading>| {
        let torque = rope.torque(mass);
        hang(rig, mass, torque).map_err(CalibrateError::Asking)?;
        let values = measure(rig)?;
        measured(&values);
        readings.extend(values.into_iter().map(|value| (torque, value)));
        Ok(())
    };
    let done = masses.iter().try_for_each(|mass| under(*mass, &mut readings));
    match done {
        Ok(()) => keep(file, &readings, seconds),
        Err(error) if readings.is_empty() => Err(error),
        Err(error) => Err(match keep_readings(file, &readings, seconds) {
            Ok(path) => CalibrateError::After { error: Box::new(error), path },
            Err(why) => CalibrateError::AfterAll { error: Box::new(error), why: Box::new(why) },
        }),
    }
}

/// Fits the readings (torque at the secondary in N·m, value) and keeps both: the readings in a new file
/// `NAME-readings-SECONDS.csv` beside `file`, the line as one more row of `file`, whose last row counts. Nothing is
/// written over.
///
/// # Errors
/// If nothing can be fitted or written, or the new row is not the one that counts afterwards.
pub fn keep(file: &Path, readings: &[LoadReading], seconds: u64) -> Result<(Calibration, PathBuf), CalibrateError> {
    let path = keep_readings(file, readings, seconds)?;
    let added = Calibration::fit(readings).map_err(CalibrateError::from).and_then(|calibration| {
        add_row(file, &calibration, seconds)?;
        Ok(calibration)
    });
    match added {
        Ok(calibration) => Ok((calibration, path)),
        Err(error) => Err(CalibrateError::After { error: Box::new(error), path }),
    }
}

/// Sees to it that a calibration can be kept: makes the folder, tries a file in it, and reads what `file` has so far.
fn prepare(file: &Path, seconds: u64) -> Result<(), CalibrateError> {
    let of = |path: &Path| {
        let path = path.to_owned();
        move |error| CalibrateError::File { path, error }
    };
    if let Some(folder) = file.parent().filter(|folder| !folder.as_os_str().is_empty()) {
        fs::create_dir_all(folder).map_err(of(folder))?;
    }
    let beside = readings_path(file, seconds);
    runs::create_new(&beside, "").and_then(|()| fs::remove_file(&beside)).map_err(of(&beside))?;
    match fs::read_to_string(file) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(of(file)(error)),
        Ok(_) | Err(_) => Ok(()),
    }
}

/// Where the readings are kept beside `file`.
fn readings_path(file: &Path, seconds: u64) -> PathBuf {
    let stem = file.file_stem().map_or_else(|| "calibration".into(), |stem| stem.to_string_lossy());
    file.with_file_name(format!("{stem}-readings-{seconds}.csv"))
}

/// Writes the readings to a new file beside `file`, and says to which.
fn keep_readings(file: &Path, readings: &[LoadReading], seconds: u64) -> Result<PathBuf, CalibrateError> {
    let beside = readings_path(file, seconds);
    let mut text = String::from("torque_Nm,adc\n");
    for (torque, value) in readings {
        text.push_str(&format!("{torque:.6},{value}\n"));
    }
    runs::create_new(&beside, &text).map_err(|error| CalibrateError::File { path: beside.clone(), error })?;
    Ok(beside)
}

/// Adds a calibration as the last row of a file: all of it is written beside and renamed, and then read back.
fn add_row(file: &Path, calibration: &Calibration, seconds: u64) -> Result<(), CalibrateError> {
    let of_file = |error| CalibrateError::File { path: file.to_owned(), error };
    let of_row = |error| CalibrateError::Row { path: file.to_owned(), error };
    let Calibration { slope, intercept, r_squared, slope_interval, intercept_interval } = *calibration;
    let row = format!("{slope},{intercept},{r_squared},{slope_interval},{intercept_interval},{seconds}\n");
    last_of_csv(&row).map_err(of_row)?;
    let mut text = match fs::read_to_string(file) {
        Ok(text) => text,
        Err(error) if error.kind() == io::ErrorKind::NotFound => String::new(),
        Err(error) => return Err(of_file(error)),
    };
    if !(text.is_empty() || text.ends_with('\n')) {
        text.push('\n');
    }
    text.push_str(&row);
    runs::replace(file, &text).map_err(of_file)?;
    let last = last_of_csv(&fs::read_to_string(file).map_err(of_file)?).map_err(of_row)?;
    if (last.slope, last.intercept, last.r_squared) != (slope, intercept, r_squared) {
        return Err(CalibrateError::NotLast { path: file.to_owned(), slope: last.slope, intercept: last.intercept });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
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
        assert_eq!((text.lines().count(), last_of_csv(&text)), (2, Ok(fit)));
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

    /// Two loads of ten values each on a line of the given slope.
    fn readings(slope: f64) -> Vec<LoadReading> {
        (0..20u16)
            .map(|place| {
                let load = f64::from(place / 10);
                (load, (slope * load).round() as u16 + 35_000 + place % 3)
            })
            .collect()
    }

    #[test]
    fn the_new_row_counts_whatever_the_file_ended_in() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("c7.csv");
        let old = "50,30000,0.9997,0.05,1.5,1700000000";
        for (place, before) in
            [old.to_owned(), format!("{old}\n{}", &old[..9]), format!("{old}\r\n\n")].iter().enumerate()
        {
            fs::write(&file, before).unwrap();
            let (fit, _) = keep(&file, &readings(1000.0), place as u64).unwrap();
            let text = fs::read_to_string(&file).unwrap();
            assert_eq!(last_of_csv(&text), Ok(fit), "{text}");
            assert!(text.starts_with(before.as_str()) && (fit.slope - 1000.0).abs() < 5.0, "{text}");
        }
        let names: Vec<_> = fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
        assert_eq!(names.len(), 4, "{names:?}");
        fs::write(&file, [0xff, b'\n']).unwrap();
        let error = keep(&file, &readings(1000.0), 9).unwrap_err().to_string();
        assert!(error.contains("c7.csv") && error.contains("c7-readings-9.csv"), "{error}");
    }

    #[cfg(unix)]
    #[test]
    fn a_link_stays_a_link_and_the_file_behind_it_gets_the_row() {
        let folder = tempfile::tempdir().unwrap();
        let (file, link) = (folder.path().join("cal.csv"), folder.path().join("link.csv"));
        fs::write(&file, "50,30000,0.9997\n").unwrap();
        std::os::unix::fs::symlink(&file, &link).unwrap();
        let (fit, _) = keep(&link, &readings(1000.0), 1).unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(last_of_csv(&fs::read_to_string(&file).unwrap()), Ok(fit));
    }

    #[test]
    fn masses_that_give_no_line_are_refused_before_anything_is_measured() {
        let folder = tempfile::tempdir().unwrap();
        let rope = Rope { radius: 0.12, gears: (32.0, 61.0) };
        for masses in [&[][..], &[10.0], &[10.0, 10.0, 10.0]] {
            let mut asked = 0;
            let hang = |_: &mut SimulatedRig, _, _| {
                asked += 1;
                Ok(())
            };
            let file = folder.path().join("cal.csv");
            let error = run(&mut SimulatedRig::new(false), masses, rope, &file, hang, |_| {}).unwrap_err();
            let loads = masses.len().min(1);
            assert!(
                matches!(error, CalibrateError::Fit(CalibrationError::TooFewLoads { loads: found }) if found == loads),
                "{error}"
            );
            assert_eq!(asked, 0);
        }
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    }

    #[test]
    fn what_cannot_be_kept_is_found_before_anything_is_measured() {
        let folder = tempfile::tempdir().unwrap();
        let rope = Rope { radius: 0.12, gears: (32.0, 61.0) };
        fs::write(folder.path().join("file"), "").unwrap();
        fs::write(folder.path().join("binary.csv"), [0xff, b'\n']).unwrap();
        let mut asked = 0;
        let mut calibrate = |name: &str| {
            let hang = |rig: &mut SimulatedRig, _, torque| {
                asked += 1;
                rig.hung_load = Some(torque);
                let settled = rig.now() + 500_000;
                rig.wait_until(settled);
                Ok(())
            };
            let file = folder.path().join(name);
            run(&mut SimulatedRig::new(false), &[0.0, 40.0], rope, &file, hang, |_| {})
        };
        // A file in place of the folder, a folder in place of the file, and one that is no text.
        for (name, at) in [("file/cal.csv", "file"), (".", ""), ("binary.csv", "binary.csv")] {
            let error = calibrate(name).unwrap_err().to_string();
            assert!(error.contains(&*folder.path().join(at).to_string_lossy()), "{error}");
            assert_eq!(error.matches(&*folder.path().to_string_lossy()).count(), 1, "{error}");
        }
        // A folder that is missing is made.
        let (fit, beside) = calibrate("new/folder/cal.csv").unwrap();
        assert!((fit.slope - 108.19).abs() < 1.0 && beside.exists(), "{fit:?}");
        assert_eq!(asked, 2, "of the calibrations that could not be kept no weight was asked for");
        assert_eq!(fs::read_dir(folder.path().join("new/folder")).unwrap().count(), 2);
        // The path of a file that cannot be written is said once.
        let error = keep(&folder.path().join("missing/cal.csv"), &readings(1000.0), 1).unwrap_err().to_string();
        assert_eq!(error.matches("missing").count(), 1, "{error}");
    }

    #[test]
    fn weights_too_light_for_the_noise_give_no_calibration_and_the_readings_stay() {
        let folder = tempfile::tempdir().unwrap();
        let (file, rope) = (folder.path().join("c.csv"), Rope { radius: 0.12, gears: (32.0, 61.0) });
        let hang = |rig: &mut SimulatedRig, _, torque| {
            rig.hung_load = Some(torque);
            Ok(())
        };
        let error = run(&mut SimulatedRig::new(false), &[0.0, 0.001], rope, &file, hang, |_| {}).unwrap_err();
        let CalibrateError::After { error, path } = error else { panic!("{error}") };
        assert!(matches!(*error, CalibrateError::Fit(CalibrationError::Uncertain { .. })), "{error}");
        assert_eq!(fs::read_to_string(path).unwrap().lines().count(), 1 + 2 * VALUES_PER_LOAD);
        assert!(!file.exists());
    }

    #[test]
    fn what_was_measured_before_a_failure_is_kept() {
        let folder = tempfile::tempdir().unwrap();
        let (file, rope) = (folder.path().join("cal.csv"), Rope { radius: 0.12, gears: (32.0, 61.0) });
        let mut rig = SimulatedRig::new(false);
        let hang = |rig: &mut SimulatedRig, mass: f64, torque: f64| {
            rig.hung_load = Some(torque);
            if mass > 15.0 {
                rig.fail_at(0, Fault::LinkLost);
            }
            Ok(())
        };
        let error = run(&mut rig, &[0.0, 10.0, 20.0], rope, &file, hang, |_| {}).unwrap_err();
        let CalibrateError::After { error, path } = error else { panic!("{error}") };
        assert!(matches!(*error, CalibrateError::TooFewValues { found: 0 }));
        assert_eq!(fs::read_to_string(path).unwrap().lines().count(), 1 + 2 * VALUES_PER_LOAD);
        assert!(!file.exists(), "and no calibration is made of half of the loads");
        // A converter that does not respond to the load is found at the end; its readings are kept, too.
        let error = keep(&file, &[(0.0, 7), (1.0, 7)], 3).unwrap_err();
        assert!(matches!(&error, CalibrateError::After { path, .. } if path.exists()), "{error}");
        assert!(!file.exists());
    }
}
