//! What happens along the belt, as arrays.

use crate::convert;
use numpy::PyArray1;
use pyo3::exceptions::{PyAttributeError, PyKeyError};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use sheave::drive::RegionId;
use sheave::result::{Outcome, Sampled};

/// Every state and derived field along the belt, region by region. The arrays are views of memory that the regions
/// hold: nothing is copied, and they cannot be written to.
#[pyclass(frozen, module = "sheave")]
pub struct Profile {
    regions: [Py<Region>; 4],
}

impl Profile {
    pub fn new(py: Python<'_>, outcome: &Outcome, between: usize) -> PyResult<Self> {
        let region = |id: RegionId| {
            let sampled = Sampled::new(&outcome.solved.belt, &outcome.solved.solution, id, between);
            Py::new(py, Region { sampled })
        };
        let [a, b, c, d] = RegionId::ALL;
        Ok(Self { regions: [region(a)?, region(b)?, region(c)?, region(d)?] })
    }

    fn region(&self, py: Python<'_>, id: RegionId) -> Py<Region> {
        self.regions[id.index()].clone_ref(py)
    }
}

#[pymethods]
impl Profile {
    /// Contact with the primary.
    #[getter]
    fn primary(&self, py: Python<'_>) -> Py<Region> {
        self.region(py, RegionId::Primary)
    }

    /// Span from the primary to the secondary.
    #[getter]
    fn slack_span(&self, py: Python<'_>) -> Py<Region> {
        self.region(py, RegionId::SlackSpan)
    }

    /// Contact with the secondary.
    #[getter]
    fn secondary(&self, py: Python<'_>) -> Py<Region> {
        self.region(py, RegionId::Secondary)
    }

    /// Span from the secondary to the primary.
    #[getter]
    fn tight_span(&self, py: Python<'_>) -> Py<Region> {
        self.region(py, RegionId::TightSpan)
    }

    fn __repr__(&self) -> String {
        let points =
            |region: &Py<Region>| format!("{} {}", region.get().sampled.region.name(), region.get().sampled.s.len());
        format!("<sheave.Profile, points: {}>", self.regions.iter().map(points).collect::<Vec<_>>().join(", "))
    }
}

/// One region of the belt: a contact or a span. Columns are those of `profile.csv`, as attributes or by name:
/// `region.T`,
/// `region["T"]`.
#[pyclass(frozen, module = "sheave")]
pub struct Region {
    sampled: Sampled,
}

#[pymethods]
impl Region {
    /// Position in the region, from 0 where the belt enters to 1.
    #[getter]
    fn position<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        convert::borrowed(slf.clone().into_any(), &slf.get().sampled.s)
    }

    /// Names of the columns.
    #[getter]
    fn columns(&self) -> Vec<&'static str> {
        self.sampled.columns().map(|(symbol, _)| symbol.name).collect()
    }

    /// Unit of each column; empty for a pure number.
    #[getter]
    fn units<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        self.sampled.columns().try_for_each(|(symbol, _)| dict.set_item(symbol.name, symbol.unit))?;
        Ok(dict)
    }

    /// What each column is.
    #[getter]
    fn meanings<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        self.sampled.columns().try_for_each(|(symbol, _)| dict.set_item(symbol.name, symbol.doc))?;
        Ok(dict)
    }

    /// All columns by name.
    fn to_dict<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(slf.py());
        dict.set_item("position", Self::position(slf)?)?;
        for (symbol, numbers) in slf.get().sampled.columns() {
            dict.set_item(symbol.name, convert::borrowed(slf.clone().into_any(), numbers)?)?;
        }
        Ok(dict)
    }

    fn __getitem__<'py>(slf: &Bound<'py, Self>, name: &str) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let none = || {
            let known = slf.get().columns().join(", ");
            PyKeyError::new_err(format!(
                "no column `{name}` in region {}: there are {known}",
                slf.get().sampled.region.name()
            ))
        };
        Self::column(slf, name)?.ok_or_else(none)
    }

    fn __getattr__<'py>(slf: &Bound<'py, Self>, name: &str) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let none = || PyAttributeError::new_err(format!("a region has no attribute or column `{name}`"));
        Self::column(slf, name)?.ok_or_else(none)
    }

    fn __dir__(&self) -> Vec<&'static str> {
        let own = ["columns", "meanings", "position", "to_dict", "units"];
        own.into_iter().chain(self.columns()).collect()
    }

    fn __len__(&self) -> usize {
        self.sampled.s.len()
    }

    fn __repr__(&self) -> String {
        let (name, points) = (self.sampled.region.name(), self.sampled.s.len());
        format!("<sheave.Region {name}: {points} points of {}>", self.columns().join(", "))
    }
}

impl Region {
    fn column<'py>(slf: &Bound<'py, Self>, name: &str) -> PyResult<Option<Bound<'py, PyArray1<f64>>>> {
        let found = slf.get().sampled.columns().find(|(symbol, _)| symbol.name == name);
        found.map(|(_, numbers)| convert::borrowed(slf.clone().into_any(), numbers)).transpose()
    }
}
