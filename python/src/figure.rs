//! Figures of the library, as data for matplotlib and as SVG.

use crate::convert;
use pyo3::exceptions::{PyKeyError, PyValueError};
use pyo3::prelude::*;
use serde_json::{Value, json};
use sheave::plot::{Axis, Figure, Look, Series};

/// As a dictionary by name.
///
/// # Errors
/// None but Python's own.
pub fn figures<'py>(py: Python<'py>, figures: &[Figure]) -> PyResult<Bound<'py, PyAny>> {
    let all = figures.iter().map(|figure| (figure.name.clone(), one(figure)));
    convert::python(py, &Value::Object(all.collect()))
}

fn one(figure: &Figure) -> Value {
    let axis = |axis: &Axis| {
        let (label, logarithmic) = (&axis.label, axis.logarithmic);
        json!({ "label": label, "logarithmic": logarithmic, "range": axis.range, "step": axis.step })
    };
    let marks: Vec<Value> = figure.marks.iter().map(|mark| json!({ "at": mark.at, "text": mark.text })).collect();
    json!({
        "name": figure.name, "caption": figure.caption, "x": axis(&figure.x), "y": axis(&figure.y),
        "series": figure.series.iter().map(series).collect::<Vec<_>>(), "marks": marks, "equal": figure.equal,
    })
}

fn series(series: &Series) -> Value {
    let look = match series.look {
        Look::Line => "line",
        Look::Dashed => "dashed",
        Look::Guide => "guide",
        Look::Dots => "dots",
    };
    let coordinate = |value: f64| if value.is_finite() { json!(value) } else { Value::Null };
    let x: Vec<Value> = series.points.iter().map(|point| coordinate(point.0)).collect();
    let y: Vec<Value> = series.points.iter().map(|point| coordinate(point.1)).collect();
    json!({ "label": series.label, "color": series.color, "look": look, "marked": series.marked, "x": x, "y": y })
}

/// One of them as SVG.
///
/// # Errors
/// `KeyError` for a name that none has.
pub fn svg(figures: &[Figure], name: &str) -> PyResult<String> {
    let found = figures.iter().find(|figure| figure.name == name);
    let names = || figures.iter().map(|figure| figure.name.as_str()).collect::<Vec<_>>().join(", ");
    let figure = found.ok_or_else(|| PyKeyError::new_err(format!("no figure `{name}`: there are {}", names())))?;
    figure.svg().map_err(|error| PyValueError::new_err(error.to_string()))
}
