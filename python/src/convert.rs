//! From what serialises to what Python has.

use numpy::ndarray::ArrayView1;
use numpy::{PyArray1, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList, PyString};
use serde::Serialize;
use serde_json::Value;

/// As dictionaries, lists, numbers and texts.
///
/// # Errors
/// What the serialisation says.
pub fn object<'py>(py: Python<'py>, value: &impl Serialize) -> PyResult<Bound<'py, PyAny>> {
    let value = serde_json::to_value(value).map_err(|error| PyValueError::new_err(error.to_string()))?;
    python(py, &value)
}

/// A JSON value as Python has it.
///
/// # Errors
/// None but Python's own.
pub fn python<'py>(py: Python<'py>, value: &Value) -> PyResult<Bound<'py, PyAny>> {
    Ok(match value {
        Value::Null => py.None().into_bound(py),
        Value::Bool(truth) => truth.into_pyobject(py)?.to_owned().into_any(),
        Value::Number(number) => match number.as_i64() {
            Some(integer) => integer.into_pyobject(py)?.into_any(),
            None => number.as_f64().unwrap_or(f64::NAN).into_pyobject(py)?.into_any(),
        },
        Value::String(text) => PyString::new(py, text).into_any(),
        Value::Array(items) => {
            let list = PyList::empty(py);
            items.iter().try_for_each(|item| list.append(python(py, item)?))?;
            list.into_any()
        }
        Value::Object(members) => {
            let dict = PyDict::new(py);
            members.iter().try_for_each(|(key, value)| dict.set_item(key, python(py, value)?))?;
            dict.into_any()
        }
    })
}

/// An array of numpy over numbers that `owner` holds and never changes: nothing is copied, and `owner` lives as long as
/// the array. Writing to it is refused.
///
/// # Errors
/// None but Python's own.
pub fn borrowed<'py>(owner: Bound<'py, PyAny>, numbers: &[f64]) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let view = ArrayView1::from(numbers);
    // SAFETY: the callers hold `numbers` in a frozen class, whose instance `owner` is; they are neither moved nor
    // changed while it lives, and the array keeps it alive.
    let array = unsafe { PyArray1::borrow_from_array(&view, owner) };
    debug_assert_eq!(array.len(), numbers.len());
    array.readwrite().make_nonwriteable();
    Ok(array)
}
