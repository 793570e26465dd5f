//! From measurements: belt properties, operating points, comparisons with the model.

use crate::{case, convert, error, interrupt};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};
use serde_json::json;
use sheave::Cancel;
use sheave::bench::belt::Description;
use sheave::bench::compare::{self as comparison, Actuator, Clamp, Radii};
use sheave::bench::dyno::{self as logs, Names, calibration, runs};
use sheave::bench::engine::EngineCurve;
use sheave::bench::{BenchError, temperature};
use std::path::PathBuf;

/// The properties of a belt from bench tests, as a dictionary, with the case file that has them under `case_file`.
#[pyfunction]
#[pyo3(signature = (file, *, temperature=None))]
pub fn belt<'py>(
    py: Python<'py>,
    file: PathBuf,
    temperature: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let kelvin = temperature.map(|given| kelvin(given)).transpose()?;
    let work = move || {
        let description = Description::read(&file)?;
        let properties = description.evaluate(kelvin)?;
        let (case_file, inputs) = (properties.case_file(), json!(description.inputs()));
        Ok((properties, case_file, inputs))
    };
    let (properties, case_file, inputs) = py.detach(work).map_err(|error: BenchError| error::bench(&error))?;
    let object = convert::object(py, &properties)?;
    object.set_item("inputs", convert::python(py, &inputs)?)?;
    object.set_item("warnings", &properties.warnings)?;
    object.set_item("case_file", case_file)?;
    Ok(object)
}

/// A temperature: a text with a unit, kelvins, or a quantity of pint.
fn kelvin(given: &Bound<'_, PyAny>) -> PyResult<f64> {
    let text = case::text_of("temperature", given)?;
    // As a person writes it, not as a case file has it.
    let read = match text.parse::<f64>() {
        Ok(number) if !number.is_finite() => Err("expected a temperature above absolute zero".to_owned()),
        Ok(number) if !given.is_instance_of::<PyString>() => temperature(&number.to_string()),
        _ => temperature(&text),
    };
    read.map_err(|reason| PyValueError::new_err(format!("temperature = {given}: {reason}")))
}

/// Raw logs of a dynamometer reduced to operating points, as a dictionary of `points`, `records` and `warnings`, and
/// under `csv` the table that `compare` reads.
#[pyfunction]
#[pyo3(signature = (paths, *, calibration=None, engine=None, gear=1.0, torque_at="secondary", rate=125.0, window=3.0,
    longest_gap=0.25, primary=None, secondary=None, torque=None, secondary_factor=1.0, runs=None,
    revolutions_per_firing=2.0))]
pub fn dyno<'py>(
    py: Python<'py>,
    paths: Vec<PathBuf>,
    calibration: Option<PathBuf>,
    engine: Option<PathBuf>,
    gear: f64,
    torque_at: &str,
    rate: f64,
    window: f64,
    longest_gap: f64,
    primary: Option<String>,
    secondary: Option<String>,
    torque: Option<String>,
    secondary_factor: f64,
    runs: Option<PathBuf>,
    revolutions_per_firing: f64,
) -> PyResult<Bound<'py, PyAny>> {
    for (name, value, low, high) in [
        ("gear", gear, 1e-4, 1e4),
        ("rate", rate, 1.0, 100_000.0),
        ("window", window, 0.05, 600.0),
        ("longest_gap", longest_gap, 0.001, 60.0),
        ("secondary_factor", secondary_factor, 1e-6, 1e6),
        ("revolutions_per_firing", revolutions_per_firing, 0.1, 10.0),
    ] {
        if !(low..=high).contains(&value) {
            return Err(PyValueError::new_err(format!("{name} = {value}: expected a number from {low} to {high}")));
        }
    }
    let torque_at_sensor = match torque_at {
        "secondary" => false,
        "brake" => true,
        other => {
            return Err(PyValueError::new_err(format!("torque_at = \"{other}\": expected \"secondary\" or \"brake\"")));
        }
    };
    let names = Names { primary, secondary, torque };
    let work = move || {
        let engine = engine.as_deref().map(EngineCurve::read).transpose()?;
        let mut warnings: Vec<String> = engine.as_ref().and_then(EngineCurve::assumption).into_iter().collect();
        let options = logs::Options {
            rate,
            window,
            longest_gap,
            secondary_factor,
            gear,
            torque_at_sensor,
            revolutions: revolutions_per_firing,
            calibration: calibration.as_deref().map(calibration::read).transpose()?,
            engine,
            names,
            runs: runs.as_deref().map(self::runs).transpose()?.unwrap_or_default(),
            ..logs::Options::default()
        };
        let mut reduced = logs::reduce(&paths, &options, None, |_| ())?;
        warnings.extend(reduced.warnings.iter().map(|warning| error::for_python(warning)));
        let files = reduced.records.iter_mut().flat_map(|record| &mut record.files);
        files.filter_map(|file| file.problem.as_mut()).for_each(|problem| *problem = error::for_python(problem));
        Ok((reduced, warnings))
    };
    let (reduced, warnings) =
        interrupt::watched(py, &Cancel::new(), work, |_| Ok(()))?.map_err(|error: BenchError| error::bench(&error))?;
    let (csv, _) = logs::points_csv(&reduced.points);
    let object = convert::object(py, &reduced)?;
    object.set_item("warnings", warnings)?;
    object.set_item("csv", csv)?;
    Ok(object)
}

/// Measured operating points against the model, as a dictionary.
#[pyfunction]
#[pyo3(signature = (case=None, /, *, data, engine=None, flyweights=None, radii="speeds", fit=Vec::new(), tolerance=1e-4,
    **keys))]
pub fn compare<'py>(
    py: Python<'py>,
    case: Option<&Bound<'py, PyAny>>,
    data: PathBuf,
    engine: Option<PathBuf>,
    flyweights: Option<PathBuf>,
    radii: &str,
    fit: Vec<String>,
    tolerance: f64,
    keys: Option<&Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyAny>> {
    let radii = match radii {
        "speeds" => Radii::Speeds,
        "ratio" => Radii::Ratio,
        other => return Err(PyValueError::new_err(format!("radii = \"{other}\": expected \"speeds\" or \"ratio\""))),
    };
    let tolerance = crate::result::options(tolerance, 4)?.tolerance;
    let case = case::read(py, case, keys)?;
    let fit = fit.iter().map(|name| case::path_of(name)).collect::<PyResult<Vec<_>>>()?;
    let work = move || {
        let engine = engine.as_deref().map(EngineCurve::read).transpose()?;
        let table = comparison::read(&data, engine.as_ref())?;
        let clamp = match &flyweights {
            Some(path) => Clamp::Actuator(Actuator::read(path)?),
            None => Clamp::OfCase,
        };
        let options = comparison::Options { tolerance, radii, clamp, fit };
        let mut found = comparison::compare(&case, table, &options)?;
        found.warnings.extend(engine.as_ref().and_then(EngineCurve::assumption));
        Ok((comparison::summary(&found), found))
    };
    let (summary, found) =
        interrupt::watched(py, &Cancel::new(), work, |_| Ok(()))?.map_err(|error: BenchError| error::bench(&error))?;
    let object = convert::object(py, &found)?;
    object.set_item("warnings", &found.warnings)?;
    object.set_item("summary", summary)?;
    Ok(object)
}
