//! Belt maps.

use crate::{case, convert, error, file, interrupt, result, study};
use numpy::ndarray::ArrayView2;
use numpy::{PyArray1, PyArray2, PyReadonlyArray2, ToPyArray};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyString};
use sheave::Cancel;
use sheave::beltmap::{self, Keep, MapAxis, MapError, MapFormat, MapOptions, MapPlan, Progress, Quantity};
use sheave::drive::SolveOptions;
use sheave::study::Row;
use std::io;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Makes a map: see `sheave.map`.
#[pyfunction]
#[pyo3(signature = (case=None, /, *, over, accuracy=1e-3, tolerance=None, max_points=20_000,
    least_speed_efficiency=0.9, jobs=None, progress=None, **keys))]
pub fn map(
    py: Python<'_>,
    case: Option<&Bound<'_, PyAny>>,
    over: &Bound<'_, PyAny>,
    accuracy: f64,
    tolerance: Option<f64>,
    max_points: usize,
    least_speed_efficiency: f64,
    jobs: Option<usize>,
    progress: Option<&Bound<'_, PyAny>>,
    keys: Option<&Bound<'_, PyDict>>,
) -> PyResult<BeltMap> {
    let case = case::read(py, case, keys)?;
    study::some_thread(jobs)?;
    // As the command does: points are solved a hundred times as accurately as the map is read. What is no accuracy, the
    // plan refuses.
    let solve = result::options(tolerance.unwrap_or((0.01 * accuracy).clamp(1e-12, 1e-1)), 4);
    let solve = if accuracy.is_nan() { SolveOptions::default() } else { solve? };
    let options = MapOptions { accuracy, solve, max_points, least_speed_efficiency, jobs };
    let plan = MapPlan::new(case, axes(py, over)?, options).map_err(|error| refused(py, &error))?;
    let (cancel, solved) = (Cancel::new(), Arc::new(AtomicUsize::new(0)));
    let kept = Counting::new(cancel.clone(), solved.clone());
    let tell = |_: Python<'_>| match progress {
        Some(progress) => progress.call1((solved.load(Ordering::Relaxed),)).map(|_| ()),
        None => Ok(()),
    };
    let map = interrupt::watched(py, &cancel, move || plan.build(&kept), tell)?;
    map.map(|map| BeltMap(Arc::new(map))).map_err(|error| refused(py, &error))
}

/// What a map is over, from a dictionary of keys and their ranges or breakpoints, a text or several.
fn axes(py: Python<'_>, over: &Bound<'_, PyAny>) -> PyResult<Vec<MapAxis>> {
    let parsed = |text: &str| MapAxis::parse(text).map_err(|error| refused(py, &error));
    if let Ok(text) = over.cast::<PyString>() {
        return Ok(vec![parsed(text.to_str()?)?]);
    }
    let Some(named) = case::dictionary(over)? else {
        let texts: Vec<String> = over.extract().map_err(|_| {
            let kind = over.get_type();
            PyTypeError::new_err(format!("over: expected a dictionary of keys and their ranges, or texts, not {kind}"))
        })?;
        return texts.iter().map(|text| parsed(text)).collect();
    };
    let axis = |(key, values): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        let name: String = key.extract().map_err(|_| PyTypeError::new_err("over: keys are texts"))?;
        let path = case::with_dots(&name);
        if let Ok(text) = values.cast::<PyString>() {
            return parsed(&format!("{path}={}", text.to_str()?));
        }
        // What is no key of a map, the text is refused for.
        let Some(key) = MapAxis::key_named(&path) else { return parsed(&format!("{path}=0..1")) };
        MapAxis::new(key, case::values(py, &name, key, &values)?).map_err(|error| refused(py, &error))
    };
    named.iter().map(axis).collect()
}

/// Values and derivatives.
type Interpolated<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray2<f64>>);

/// Keeps nothing but the number of points, and takes no more once it is cancelled.
pub struct Counting {
    cancel: Cancel,
    solved: Arc<AtomicUsize>,
}

impl Counting {
    /// Counts into `solved`.
    pub fn new(cancel: Cancel, solved: Arc<AtomicUsize>) -> Self {
        Self { cancel, solved }
    }
}

impl Keep for Counting {
    fn kept(&self, _point: usize) -> Option<Row> {
        None
    }

    fn keep(&self, _row: Row) -> io::Result<()> {
        if self.cancel.is_cancelled() { Err(io::ErrorKind::Interrupted.into()) } else { Ok(()) }
    }

    fn progress(&self, progress: Progress) {
        self.solved.store(progress.solved, Ordering::Relaxed);
    }
}

/// Why there is no map, as an exception.
pub fn refused(py: Python<'_>, error: &MapError) -> PyErr {
    match error {
        MapError::Case(error) => error::case(py, error),
        MapError::Study(error) => error::study(py, error),
        MapError::Internal(error) => error::internal(error),
        other => error::map(&other.to_string()),
    }
}

/// A table of what a belt does over two or more keys of its case, read between its nodes with a known error.
#[pyclass(frozen, module = "sheave")]
pub struct BeltMap(pub Arc<beltmap::BeltMap>);

#[pymethods]
impl BeltMap {
    /// Reads a map that was written as CSV, by `write` or by `sheave map`.
    #[staticmethod]
    fn read(path: PathBuf) -> PyResult<Self> {
        let map = beltmap::BeltMap::read(&path);
        map.map(|map| Self(Arc::new(map))).map_err(|error| error::map(&error.to_string()))
    }

    /// Writes the map; the ending of the name says in which form. The file appears whole.
    fn write(&self, py: Python<'_>, path: PathBuf) -> PyResult<()> {
        let format = MapFormat::of(&path)
            .ok_or_else(|| PyValueError::new_err("expected a file name that ends in .csv, .parquet or .nc"))?;
        file::write(py, &path, |to| format.write(&self.0, to))
    }

    /// What the map is over, in the order of coordinates: the keys of its axes.
    #[getter]
    fn keys(&self) -> Vec<&'static str> {
        self.0.axes().iter().map(|axis| axis.key().path()).collect()
    }

    /// Where the map has nodes, SI: breakpoints by key.
    #[getter]
    fn breakpoints<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for axis in self.0.axes() {
            dict.set_item(axis.key().path(), axis.breakpoints().to_pyarray(py))?;
        }
        Ok(dict)
    }

    /// What the map tells, with its unit.
    #[getter]
    fn quantities<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        self.0.quantities().iter().try_for_each(|quantity| dict.set_item(quantity.name(), quantity.unit()))?;
        Ok(dict)
    }

    /// How the map was made, and how accurate it is.
    #[getter]
    fn report<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        convert::object(py, self.0.report())
    }

    /// The case in the middle of the map, resolved to SI units.
    #[getter]
    fn inputs<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        convert::python(py, self.0.inputs())
    }

    /// A quantity at many points: `points` of shape (m, number of axes), SI, in the order of `keys`. Gives its values,
    /// shape (m,), and its derivatives, shape (m, number of axes); not a number outside the map.
    fn interpolate<'py>(
        &self,
        py: Python<'py>,
        quantity: &str,
        points: &Bound<'py, PyAny>,
    ) -> PyResult<Interpolated<'py>> {
        let wanted = Quantity::from_name(quantity).filter(|quantity| self.0.quantities().contains(quantity));
        let wanted = wanted.ok_or_else(|| {
            let told: Vec<String> = self.0.quantities().iter().map(|told| format!("`{}`", told.name())).collect();
            let expected = format!("expected one that it interpolates: {}", told.join(", "));
            PyValueError::new_err(format!("the map does not interpolate `{quantity}`: {expected}"))
        })?;
        let axes = self.0.axes().len();
        let array = py.import("numpy")?.call_method1("asarray", (points, "float64"))?;
        let shape: Vec<usize> = array.getattr("shape")?.extract()?;
        let [_, given] = shape[..] else {
            return Err(PyValueError::new_err(format!(
                "points: expected an array of shape (m, {axes}), not {shape:?}"
            )));
        };
        if given != axes {
            return Err(PyValueError::new_err(format!("{given} coordinates are given: the map has {axes} axes")));
        }
        let points: PyReadonlyArray2<'py, f64> = array.extract()?;
        let points = points.as_array();
        let (mut values, mut slopes) = (Vec::with_capacity(points.nrows()), Vec::with_capacity(points.len()));
        for point in points.outer_iter() {
            let at = self.0.at(&point.to_vec());
            let found = at.as_ref().ok().and_then(|at| Some((at.value(wanted).ok()?, at.slopes(wanted).ok()?)));
            match found {
                Some((value, slope)) => {
                    values.push(value);
                    slopes.extend_from_slice(slope);
                }
                None => {
                    values.push(f64::NAN);
                    slopes.extend(std::iter::repeat_n(f64::NAN, axes));
                }
            }
        }
        let shaped = ArrayView2::from_shape((values.len(), axes), &slopes);
        let shaped = shaped.map_err(|error| PyValueError::new_err(error.to_string()))?;
        Ok((values.to_pyarray(py), PyArray2::from_array(py, &shaped)))
    }

    /// Refused: a file has every digit.
    fn __reduce__(&self) -> PyResult<()> {
        Err(PyTypeError::new_err("a map cannot be pickled: `write` it as .csv, and `BeltMap.read` it again"))
    }

    /// Unit of each axis, as files state it, by key.
    #[getter]
    fn units<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for axis in self.0.axes() {
            dict.set_item(axis.key().path(), axis.unit().as_ref())?;
        }
        Ok(dict)
    }

    /// The table of the map as the library of a Functional Mock-up Unit reads it: see `fmu/table.rs`.
    fn table_bytes<'py>(&self, py: Python<'py>) -> Bound<'py, PyBytes> {
        let mut bytes = Vec::new();
        let count =
            |bytes: &mut Vec<u8>, count: usize| bytes.extend(u32::try_from(count).unwrap_or(u32::MAX).to_le_bytes());
        let text = |bytes: &mut Vec<u8>, text: &str| {
            count(bytes, text.len());
            bytes.extend(text.as_bytes());
        };
        count(&mut bytes, self.0.axes().len());
        for axis in self.0.axes() {
            let places = axis.breakpoints();
            text(&mut bytes, axis.key().path());
            bytes.extend(places.get(places.len() / 2).copied().unwrap_or(f64::NAN).to_le_bytes());
            count(&mut bytes, places.len());
            places.iter().for_each(|place| bytes.extend(place.to_le_bytes()));
        }
        count(&mut bytes, self.0.quantities().len());
        self.0.quantities().iter().for_each(|quantity| text(&mut bytes, quantity.name()));
        self.0.derivatives().iter().for_each(|derivative| bytes.extend(derivative.to_le_bytes()));
        bytes.extend(self.0.usable_above().iter().map(|usable| u8::from(*usable)));
        PyBytes::new(py, &bytes)
    }

    /// Everything at one point: its coordinates in the order of `keys`, or by key, by the names that `over` takes.
    /// Raises MapError outside the map.
    #[pyo3(signature = (*coordinates, **by_key))]
    fn at<'py>(
        &self,
        py: Python<'py>,
        coordinates: Vec<f64>,
        by_key: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let at = match by_key {
            None => coordinates,
            Some(named) if coordinates.is_empty() => self.by_key(named)?,
            Some(_) => return Err(PyTypeError::new_err("coordinates are given in their order, or by key, not both")),
        };
        let point = self.0.at(&at).map_err(|outside| error::map(&outside.to_string()))?;
        let dict = PyDict::new(py);
        for quantity in self.0.quantities() {
            dict.set_item(
                quantity.name(),
                point.value(*quantity).map_err(|outside| error::map(&outside.to_string()))?,
            )?;
        }
        let mut derived = vec![
            ("secondary.speed", point.secondary_speed()),
            ("slip_reserve", point.slip_reserve()),
            ("efficiency.overall", point.efficiency()),
        ];
        if self.0.quantities().contains(&Quantity::Losses) {
            derived.push(("efficiency.overall_with_losses", point.efficiency_with_losses()));
        }
        for (name, value) in derived {
            dict.set_item(name, value.map_err(|outside| error::map(&outside.to_string()))?)?;
        }
        Ok(dict)
    }

    fn __repr__(&self) -> String {
        let axes = self.0.axes().iter().map(|axis| format!("{} ({})", axis.key().path(), axis.len()));
        let report = self.0.report();
        format!(
            "<sheave.BeltMap over {}: largest error {:.1e}, {} of {} cells with values>",
            axes.collect::<Vec<_>>().join(" × "),
            report.error.largest,
            report.usable_cells,
            report.cells
        )
    }
}

impl BeltMap {
    fn by_key(&self, named: &Bound<'_, PyDict>) -> PyResult<Vec<f64>> {
        let mut at: Vec<Option<(String, f64)>> = vec![None; self.0.axes().len()];
        for (name, value) in named {
            let name: String = name.extract()?;
            let place = self.place(&name)?;
            if let Some((first, _)) = &at[place] {
                return Err(PyValueError::new_err(case::twice(first, &name)));
            }
            let number = if case::is_no_number(&value)? { None } else { value.extract().ok() };
            let number = number.ok_or_else(|| {
                PyTypeError::new_err(format!(
                    "`{name}` = {value}: expected a number in SI units, as the map's nodes are"
                ))
            })?;
            at[place] = Some((name, number));
        }
        let missing =
            |axis: usize| PyValueError::new_err(format!("`{}` is not given", self.0.axes()[axis].key().path()));
        let number =
            |(axis, given): (usize, Option<(String, f64)>)| given.ok_or_else(|| missing(axis)).map(|(_, at)| at);
        at.into_iter().enumerate().map(number).collect()
    }

    /// The place among the axes of the one that a name means.
    fn place(&self, name: &str) -> PyResult<usize> {
        let path = match MapAxis::key_named(&case::with_dots(name)) {
            Some(key) => key.path().to_owned(),
            // What several sections have is refused.
            None => case::path_of(name)?,
        };
        self.0.axes().iter().position(|axis| axis.key().path() == path).ok_or_else(|| {
            let axes: Vec<String> = self.keys().iter().map(|key| format!("`{key}`")).collect();
            PyValueError::new_err(format!("`{name}` is no axis of the map: expected {}", axes.join(", ")))
        })
    }
}
