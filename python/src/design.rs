//! Limits and the best clamp.

use crate::{case, convert, error, interrupt, result};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde_json::json;
use sheave::design::{self, Limit, LimitKind, LimitOptions};

/// The largest torque for the clamp of a case and the smallest clamps for its torque, as dictionaries.
#[pyfunction]
#[pyo3(signature = (case=None, /, *, least_speed_efficiency=0.95, tolerance=1e-6, **keys))]
pub fn limit<'py>(
    py: Python<'py>,
    case: Option<&Bound<'py, PyAny>>,
    least_speed_efficiency: f64,
    tolerance: f64,
    keys: Option<&Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyAny>> {
    let least_speed_efficiency = share(least_speed_efficiency)?;
    let case = case::resolved(py, &case::read(py, case, keys)?)?;
    let options = LimitOptions { solve: result::options(tolerance, 4)?, least_speed_efficiency };
    let edition = case.edition.name();
    let work = move || {
        let largest = design::largest_torque(&case, &options)?.0;
        // A case whose load is a speed has no torque to find a clamp for.
        match design::smallest_clamps(&case, &options) {
            Ok((limits, _)) => Ok((largest, Some(limits))),
            Err(error) if error.is_bad_input() => Ok((largest, None)),
            Err(error) => Err(error),
        }
    };
    let (largest, smallest) = interrupt::run(py, work)?.map_err(|error| error::design(&error))?;
    let one = |limit: &Limit| {
        let reason = if let LimitKind::Lost(reason) = &limit.kind { Some(reason.as_str()) } else { None };
        let (kind, temperature) = (limit.kind.name(), limit.belt_temperature);
        json!({
            "value": limit.value, "kind": kind, "reason": reason, "state": limit.state, "belt_temperature": temperature,
        })
    };
    let smallest = smallest.map(|limits| {
        json!({
            "slack_tension": one(&limits.slack_tension),
            "primary_axial_force": one(&limits.primary_axial_force),
            "secondary_axial_force": one(&limits.secondary_axial_force),
        })
    });
    convert::python(py, &json!({ "edition": edition, "largest_torque": one(&largest), "smallest_clamp": smallest }))
}

/// A least speed efficiency, checked.
///
/// # Errors
/// `ValueError`.
pub fn share(least_speed_efficiency: f64) -> PyResult<f64> {
    if (0.0..1.0).contains(&least_speed_efficiency) {
        return Ok(least_speed_efficiency);
    }
    let given = least_speed_efficiency;
    Err(PyValueError::new_err(format!("least_speed_efficiency = {given}: expected a number from 0 to below 1")))
}

/// The clamp of best overall efficiency for the torque of a case, as a dictionary.
#[pyfunction]
#[pyo3(signature = (case=None, /, *, tolerance=1e-6, **keys))]
pub fn optimum<'py>(
    py: Python<'py>,
    case: Option<&Bound<'py, PyAny>>,
    tolerance: f64,
    keys: Option<&Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyAny>> {
    let case = case::resolved(py, &case::read(py, case, keys)?)?;
    let options = result::options(tolerance, 4)?;
    let edition = case.edition.name();
    let best = interrupt::run(py, move || design::optimum(&case, &options))?;
    let best = best.map_err(|error| error::design(&error))?;
    convert::python(
        py,
        &json!({
            "edition": edition, "state": best.state, "bound": best.bound, "gradient": best.gradient,
            "efficiency_with_losses": best.efficiency_with_losses, "belt_temperature": best.belt_temperature,
            "evaluations": best.evaluations,
        }),
    )
}
