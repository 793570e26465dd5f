//! Whole drives: belt, actuators and engine as one problem. What is told becomes typed results in `sheave/_drive.py`.

use crate::result::Result as BeltSolution;
use crate::table::Table;
use crate::{case, convert, error, figure, interrupt, result};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};
use serde_json::{Value, json};
use sheave::Cancel;
use sheave::case::{Key, Resolved, Setting};
use sheave::drive::Branch;
use sheave::equilibrium::{
    self, Direction, DriveReport, EquilibriumError, Measured, ShiftBranch, ShiftCurve, ShiftOptions, ShiftPoint,
    UnknownDirection,
};
use sheave::plot::{Figure, Stack};
use sheave::quantity::{self, Dimension, rpm};
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Where a whole drive settles at a speed of its secondary or of its vehicle: everything but the belt's solution as a
/// dictionary, and that.
#[pyfunction]
#[pyo3(signature = (case=None, /, *, speed=None, vehicle_speed=None, direction="up", tolerance=1e-6, order=4, **keys))]
pub fn drive<'py>(
    py: Python<'py>,
    case: Option<&Bound<'py, PyAny>>,
    speed: Option<&Bound<'py, PyAny>>,
    vehicle_speed: Option<&Bound<'py, PyAny>>,
    direction: &str,
    tolerance: f64,
    order: i64,
    keys: Option<&Bound<'py, PyDict>>,
) -> PyResult<(Bound<'py, PyAny>, BeltSolution)> {
    let given = case::read_unswapped(py, "drive", case, keys)?;
    let case = given.resolve().map_err(|error| error::case(py, &error))?;
    let direction = one_direction(direction)?;
    let speed = match (speed, vehicle_speed) {
        (Some(_), Some(_)) => return Err(PyValueError::new_err("speed or vehicle_speed is given, not both")),
        (Some(speed), None) => of_secondary("speed", speed)?,
        (None, Some(speed)) => of_vehicle(&case, speed)?,
        (None, None) => of_case(&given).ok_or_else(|| {
            PyValueError::new_err(
                "at which speed of the secondary? Give speed=\"2000 rpm\" or vehicle_speed=\"30 km/h\"",
            )
        })?,
    };
    let options = result::options(tolerance, order)?;
    let work = || {
        let (found, outcome) = equilibrium::equilibrium_outcome(None, &case, speed, direction, &options)?;
        let mut warnings = equilibrium::unused_keys(&given);
        warnings.extend(sheave::result::warnings(&outcome));
        let report = DriveReport::new(&case, &found, outcome.clone(), true)?;
        warnings.extend(equilibrium::beyond_engine(&case, [report.primary_speed]));
        warnings.extend(equilibrium::beyond_travel(&case, [(report.primary_travel, report.secondary_travel)]));
        Ok((report, outcome, warnings))
    };
    let (report, outcome, warnings) = interrupt::run(py, work)?.map_err(|error| error::equilibrium(&error))?;
    let mut told = serde_json::to_value(&report).map_err(|error| PyValueError::new_err(error.to_string()))?;
    if let Value::Object(members) = &mut told {
        members.remove("drive");
        members.insert("parts".to_owned(), json!(report.parts));
        members.insert("warnings".to_owned(), json!(warnings));
        members.insert("summary".to_owned(), json!(report.summary()));
        members.insert("slip".to_owned(), json!(report.slip_words()));
    }
    Ok((convert::python(py, &told)?, BeltSolution { outcome: Arc::new(outcome), wanted: Branch::Tight }))
}

/// The shift curve of a whole drive, branch by branch; measured speeds from a CSV file stand beside it.
#[pyfunction]
#[pyo3(signature = (case=None, /, *, points=24, direction="both", start=None, stop=None, data=None, tolerance=1e-6,
    progress=None, **keys))]
pub fn shift(
    py: Python<'_>,
    case: Option<&Bound<'_, PyAny>>,
    points: i64,
    direction: &str,
    start: Option<&Bound<'_, PyAny>>,
    stop: Option<&Bound<'_, PyAny>>,
    data: Option<PathBuf>,
    tolerance: f64,
    progress: Option<&Bound<'_, PyAny>>,
    keys: Option<&Bound<'_, PyDict>>,
) -> PyResult<ShiftBranches> {
    let points = usize::try_from(points)
        .ok()
        .filter(|number| (2..=2000).contains(number))
        .ok_or_else(|| PyValueError::new_err(format!("points = {points}: expected a number from 2 to 2000")))?;
    let given = case::read_unswapped(py, "shift", case, keys)?;
    let case = given.resolve().map_err(|error| error::case(py, &error))?;
    let directions = match direction {
        "both" => vec![Direction::Up, Direction::Back],
        one => vec![one_direction(one)?],
    };
    let from = start.map(|speed| of_secondary("start", speed)).transpose()?;
    let to = stop.map(|speed| of_secondary("stop", speed)).transpose()?;
    if let (Some(from), Some(to)) = (from, to)
        && from >= to
    {
        return Err(PyValueError::new_err(format!(
            "start is {:.0} rpm and stop is {:.0} rpm: expected a higher speed to end at than to begin at",
            rpm(from),
            rpm(to)
        )));
    }
    let measured = data.map(|path| measured(&path)).transpose()?.unwrap_or_default();
    let options = ShiftOptions { points, directions, from, to, solve: result::options(tolerance, 4)? };
    let (cancel, solved) = (Cancel::new(), Arc::new(AtomicUsize::new(0)));
    let (held, count, whole) = (cancel.clone(), solved.clone(), case.clone());
    let work = move || {
        let mut see = |_: &ShiftPoint| {
            count.fetch_add(1, Ordering::Relaxed);
            if held.is_cancelled() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let branches = options.directions.iter();
        let branches = branches.map(|direction| equilibrium::shift_branch(&whole, *direction, &options, &mut see));
        branches.collect::<Result<Vec<_>, _>>()
    };
    let tell = |_: Python<'_>| match progress {
        Some(progress) => progress.call1((solved.load(Ordering::Relaxed),)).map(|_| ()),
        None => Ok(()),
    };
    let branches = interrupt::watched(py, &cancel, work, tell)?;
    let branches = branches.map_err(|error: EquilibriumError| error::equilibrium(&error))?;
    tell(py)?;
    let mut warnings = equilibrium::unused_keys(&given);
    let reports = branches.iter().flat_map(|branch| &branch.points).filter_map(|point| point.report.as_ref().ok());
    warnings.extend(equilibrium::beyond_engine(&case, reports.clone().map(|report| report.primary_speed)));
    warnings.extend(equilibrium::over_curve(&case, reports.map(Box::as_ref)));
    Ok(ShiftBranches { case, branches, measured, warnings })
}

/// The branches of a shift curve.
#[pyclass(frozen, module = "sheave._sheave")]
pub struct ShiftBranches {
    case: Resolved,
    branches: Vec<ShiftBranch>,
    measured: Vec<Measured>,
    warnings: Vec<String>,
}

#[pymethods]
impl ShiftBranches {
    /// Name of the edition of the equations.
    #[getter]
    fn edition(&self) -> &'static str {
        self.case.edition.name()
    }

    /// What is to be known before the curve is used.
    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.warnings.clone()
    }

    /// One row a point, as `sheave shift --table` writes it.
    fn table(&self) -> Table {
        let table = equilibrium::shift_table(&self.branches);
        let rows = table.rows.len();
        Table::new(table, vec![(vec!["secondary_speed".to_owned(), "direction".to_owned()], rows)])
    }

    /// What is known of each branch, as dictionaries.
    fn told<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let told = |branch: &ShiftBranch| {
            json!({
                "direction": branch.direction, "engagement_speed": branch.engagement, "take_off": branch.take_off,
                "shift_out": branch.shift_out, "full_shift": branch.full_shift, "remarks": branch.remarks,
                "deviation": equilibrium::deviation(branch, &self.measured),
            })
        };
        convert::python(py, &self.branches.iter().map(told).collect())
    }

    /// The panels of the figure as data; `other` is drawn beside it under `name`.
    #[pyo3(signature = (other=None, name="other"))]
    fn figures<'py>(
        &self,
        py: Python<'py>,
        other: Option<&Bound<'py, Self>>,
        name: &str,
    ) -> PyResult<Bound<'py, PyAny>> {
        figure::figures(py, &self.panels(other.map(Bound::get), name))
    }

    /// The figure as SVG; `other` is drawn beside it under `name`.
    #[pyo3(signature = (other=None, name="other"))]
    fn svg(&self, other: Option<&Bound<'_, Self>>, name: &str) -> PyResult<String> {
        let panels = self.panels(other.map(Bound::get), name);
        let stack = Stack { name: "shift".into(), caption: "The shift curve of a whole drive".into(), panels };
        stack.svg().map_err(|error| PyValueError::new_err(error.to_string()))
    }
}

impl ShiftBranches {
    fn panels(&self, other: Option<&Self>, name: &str) -> Vec<Figure> {
        let mut curves = vec![ShiftCurve { name: "this", branches: &self.branches }];
        curves.extend(other.map(|other| ShiftCurve { name, branches: &other.branches }));
        equilibrium::shift_figures(&curves, self.case.parts.vehicle.as_ref(), &self.measured)
    }
}

fn measured(path: &std::path::Path) -> PyResult<Vec<Measured>> {
    let wrong = |reason: String| error::bench_message(&format!("{} {reason}", path.display()));
    let file = std::fs::File::open(path).map_err(|error| wrong(format!("cannot be read: {error}")))?;
    equilibrium::read_measured(file).map_err(|error| wrong(error.to_string()))
}

fn one_direction(name: &str) -> PyResult<Direction> {
    name.parse().map_err(|_: UnknownDirection| {
        PyValueError::new_err(format!("direction = \"{name}\": expected \"up\", \"back\" or \"frictionless\""))
    })
}

/// The secondary's speed that a case gives, rad/s.
fn of_case(case: &sheave::case::Case) -> Option<f64> {
    case.settings().find_map(|(key, setting)| match setting {
        Setting::Number(value) if key == Key::SecondarySpeed => Some(value),
        _ => None,
    })
}

/// A speed of the secondary, rad/s.
fn of_secondary(name: &str, given: &Bound<'_, PyAny>) -> PyResult<f64> {
    positive(name, given, Dimension::ANGULAR_SPEED)
}

/// The secondary's speed at a speed of the vehicle, rad/s.
fn of_vehicle(case: &Resolved, given: &Bound<'_, PyAny>) -> PyResult<f64> {
    let vehicle = case.parts.vehicle.as_ref();
    let vehicle = vehicle.ok_or_else(|| PyValueError::new_err("vehicle_speed needs a case with [vehicle]"))?;
    Ok(vehicle.secondary_speed(positive("vehicle_speed", given, Dimension::SPEED)?))
}

/// A positive quantity: a number in SI units, a text with a unit, or a quantity of pint.
///
/// # Errors
/// `ValueError` for what is none, or not positive; `TypeError` for anything else.
pub fn positive(name: &str, given: &Bound<'_, PyAny>, dimension: Dimension) -> PyResult<f64> {
    let text = case::text_of(name, given)?;
    let plain = !given.is_instance_of::<PyString>() && !given.hasattr("to_base_units")?;
    let value = match text.parse::<f64>() {
        Ok(number) if plain => number,
        _ => {
            let read = quantity::parse(&text).and_then(|quantity| quantity.expect(dimension));
            read.map_err(|reason| PyValueError::new_err(format!("{name} = {text}: {reason}")))?
        }
    };
    if value > 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(PyValueError::new_err(format!("{name} = {given}: expected {dimension} that is positive and finite")))
    }
}
