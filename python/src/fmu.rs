//! The shared library of Functional Mock-up Units, which the build compiles from `fmu/`.

use pyo3::exceptions::PyNotImplementedError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

/// The library, compiled for this platform.
static LIBRARY: &[u8] = include_bytes!(env!("SHEAVE_FMU"));

/// Name of this platform in a unit (FMI 2.0.4, 2.3), ending of a library's name, and the library.
#[pyfunction]
pub fn fmu_library(py: Python<'_>) -> PyResult<(&'static str, &'static str, Bound<'_, PyBytes>)> {
    let (platform, ending) = if cfg!(all(target_os = "linux", target_arch = "x86_64")) {
        ("linux64", ".so")
    } else if cfg!(all(target_os = "windows", target_arch = "x86_64")) {
        ("win64", ".dll")
    } else if cfg!(all(target_os = "macos", target_arch = "x86_64")) {
        ("darwin64", ".dylib")
    } else {
        return Err(PyNotImplementedError::new_err("FMI 2.0 has no name for this platform"));
    };
    Ok((platform, ending, PyBytes::new(py, LIBRARY)))
}
