//! Studies: one case over a grid of its keys, at once or in parts.

use crate::interrupt;
use crate::table::Table;
use crate::{case, design, error, result};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};
use sheave::Cancel;
use sheave::case::{Key, Setting, ValueKind};
use sheave::design::{LimitOptions, limit_map, optimum_map};
use sheave::drive::SolveOptions;
use sheave::quantity::Dimension;
use sheave::study::{self, Axis, Row, StudyError, TableBuilder};
use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

/// A study that is not yet solved: a case, what varies in it, and how accurately it is solved. Its parts can be solved
/// apart, on other machines too.
#[pyclass(frozen, module = "sheave")]
pub struct Study {
    study: Arc<study::Study>,
    case: sheave::case::Case,
}

#[pymethods]
impl Study {
    /// `over` is a dictionary of keys and their values, or texts as `sheave sweep --over` takes them; beside it, or in
    /// its place, the case may be a study file, which says itself what varies. Numbers are in SI units. All other
    /// arguments are keys of the case.
    ///
    /// Raises CaseError, StudyError.
    #[new]
    #[pyo3(signature = (case=None, /, *, over=None, tolerance=1e-6, order=4, **keys))]
    fn new(
        py: Python<'_>,
        case: Option<&Bound<'_, PyAny>>,
        over: Option<&Bound<'_, PyAny>>,
        tolerance: f64,
        order: i64,
        keys: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let (case, mut all) = case::read_study(py, case, keys)?;
        let options = result::options(tolerance, order)?;
        let given = over.map(|over| axes(py, over)).transpose()?.unwrap_or_default();
        // What the call varies is not varied by the file as well.
        all.retain(|axis| !given.iter().any(|other| other.keys().iter().any(|key| axis.keys().contains(key))));
        all.extend(given);
        // Every point is checked: of a large grid, while others may run.
        Self::of(py, case, all, options)
    }

    /// Made anew from its case, its axes and its options.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
        let (py, this) = (slf.py(), slf.get());
        let rebuild = py.import("sheave._sheave")?.getattr("rebuild_study")?;
        let axes = this.study.axes().iter().map(text).collect::<PyResult<Vec<String>>>()?;
        let options = this.study.options();
        let arguments = (case::Case(this.case.clone()), axes, options.tolerance, options.order.number());
        Ok((rebuild, arguments.into_pyobject(py)?.into_any()))
    }

    fn __len__(&self) -> usize {
        self.study.points()
    }

    /// What varies: for each axis, its keys and its number of points. The last axis is the fastest.
    #[getter]
    fn axes(&self) -> Vec<(Vec<String>, usize)> {
        let keys = |axis: &Axis| axis.keys().iter().map(|key| key.path().to_owned()).collect();
        self.study.axes().iter().map(|axis| (keys(axis), axis.points())).collect()
    }

    /// Everything the rows depend on, as a line of text.
    #[getter]
    fn fingerprint(&self) -> String {
        self.study.fingerprint()
    }

    /// The points in parts that can be solved apart, as pairs of the first point and the one behind the last: each has
    /// at least `points` points, the last excepted. What a part gives on its own is what it gives as part of the whole.
    #[pyo3(signature = (points=0))]
    fn parts(&self, points: usize) -> Vec<(usize, usize)> {
        self.study.parts(points).into_iter().map(|part| (part.start, part.end)).collect()
    }

    /// Solves all points, or those from `start` to below `stop`, on `jobs` threads (all cores without it); `progress`
    /// is called with the number of points solved now and then. Rows depend on the grid alone. Ctrl-C ends the study. A
    /// point without a solution has a row that says why.
    #[pyo3(signature = (start=0, stop=None, *, jobs=None, progress=None))]
    fn run(
        &self,
        py: Python<'_>,
        start: usize,
        stop: Option<usize>,
        jobs: Option<usize>,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Table> {
        let stop = stop.unwrap_or(self.study.points());
        if start > stop || stop > self.study.points() {
            let points = self.study.points();
            return Err(PyValueError::new_err(format!("points {start} to {stop}: the study has {points}")));
        }
        self.table(py, start..stop, jobs, progress)
    }

    /// The limits at every point, as `sheave limit --over` has them: the largest torque, unless the load is what
    /// varies, and the smallest clamps, unless the clamp is; the drive is followed to a speed efficiency of
    /// `least_speed_efficiency`. A point without an answer has a row that says why.
    #[pyo3(signature = (*, least_speed_efficiency=0.95, jobs=None))]
    fn limits(&self, py: Python<'_>, least_speed_efficiency: f64, jobs: Option<usize>) -> PyResult<Table> {
        let least_speed_efficiency = design::share(least_speed_efficiency)?;
        let options = LimitOptions { solve: *self.study.options(), least_speed_efficiency };
        self.answers(py, jobs, move |study| limit_map(study, jobs, &options))
    }

    /// The clamp of best overall efficiency at every point, as `sheave optimum --over` has it. A point without an
    /// answer has a row that says why.
    #[pyo3(signature = (*, jobs=None))]
    fn optima(&self, py: Python<'_>, jobs: Option<usize>) -> PyResult<Table> {
        self.answers(py, jobs, move |study| optimum_map(study, jobs, study.options()))
    }

    fn __repr__(&self) -> String {
        let axes = self.axes();
        let axes: Vec<String> = axes.iter().map(|(keys, points)| format!("{} ({points})", keys.join(" & "))).collect();
        format!("<sheave.Study: {} points over {}>", self.study.points(), axes.join(" × "))
    }
}

impl Study {
    fn of(py: Python<'_>, case: sheave::case::Case, axes: Vec<Axis>, options: SolveOptions) -> PyResult<Self> {
        let study = interrupt::run(py, || study::Study::new(case.clone(), axes, options))?;
        study.map(|study| Self { study: Arc::new(study), case }).map_err(|error| error::study(py, &error))
    }

    fn answers(
        &self,
        py: Python<'_>,
        jobs: Option<usize>,
        find: impl FnOnce(&study::Study) -> Result<study::Table, StudyError> + Send + 'static,
    ) -> PyResult<Table> {
        some_thread(jobs)?;
        let study = self.study.clone();
        let table = interrupt::watched(py, &Cancel::new(), move || find(&study), |_| Ok(()))?;
        Ok(Table::new(table.map_err(|error| error::study(py, &error))?, self.axes()))
    }

    fn table(
        &self,
        py: Python<'_>,
        points: Range<usize>,
        jobs: Option<usize>,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Table> {
        some_thread(jobs)?;
        let study = self.study.clone();
        let (cancel, solved) = (Cancel::new(), Arc::new(AtomicUsize::new(0)));
        let (held, count) = (cancel.clone(), solved.clone());
        let work = move || {
            let builder = Mutex::new(TableBuilder::new(study.points()));
            let keep = |row: Row| {
                if held.is_cancelled() {
                    return Err(std::io::ErrorKind::Interrupted.into());
                }
                builder.lock().unwrap_or_else(PoisonError::into_inner).insert(row);
                count.fetch_add(1, Ordering::Relaxed);
                Ok(())
            };
            study::run(&study, jobs, |index| points.contains(&index), keep)?;
            Ok(builder.into_inner().unwrap_or_else(PoisonError::into_inner).finish())
        };
        let tell = |_: Python<'_>| match progress {
            Some(progress) => progress.call1((solved.load(Ordering::Relaxed),)).map(|_| ()),
            None => Ok(()),
        };
        let table = interrupt::watched(py, &cancel, work, tell)?.map_err(|error| error::study(py, &error))?;
        tell(py)?;
        Ok(Table::new(table, self.axes()))
    }
}

/// # Errors
/// `ValueError` for no thread at all.
pub fn some_thread(jobs: Option<usize>) -> PyResult<()> {
    match jobs {
        Some(0) => Err(PyValueError::new_err("jobs = 0: expected at least one thread")),
        _ => Ok(()),
    }
}

/// A study from what `Study.__reduce__` gives: for `pickle`.
#[pyfunction]
pub fn rebuild_study(
    py: Python<'_>,
    case: &Bound<'_, case::Case>,
    axes: Vec<String>,
    tolerance: f64,
    order: i64,
) -> PyResult<Study> {
    let axes = axes.iter().map(|text| Axis::parse(text).map_err(|error| error::study(py, &error)));
    let axes = axes.collect::<PyResult<_>>()?;
    Study::of(py, case.get().0.clone(), axes, result::options(tolerance, order)?)
}

/// An axis as text, with every digit of its values.
fn text(axis: &Axis) -> PyResult<String> {
    let key = |(place, key): (usize, &Key)| {
        // In words: a bare number that is surely in rpm is refused.
        let unit = match key.entry().kind {
            ValueKind::Quantity { unit, .. } if unit.scale.dimension == Dimension::ANGULAR_SPEED => " rad/s",
            _ => "",
        };
        let value = |point: usize| match axis.at(point).nth(place) {
            Some((_, Setting::Number(number))) => Ok(format!("{number:e}{unit}")),
            Some((_, Setting::Name(name))) => Ok(name.to_owned()),
            Some((_, Setting::List(_) | Setting::Table(_))) | None => {
                Err(PyTypeError::new_err(format!("a study over `{}` cannot be pickled", key.path())))
            }
        };
        let values = (0..axis.points()).map(value).collect::<PyResult<Vec<_>>>()?;
        Ok(format!("{}={}", key.path(), values.join(",")))
    };
    Ok(axis.keys().iter().enumerate().map(key).collect::<PyResult<Vec<_>>>()?.join("&"))
}

/// What varies, from a dictionary, a text or several.
fn axes(py: Python<'_>, over: &Bound<'_, PyAny>) -> PyResult<Vec<Axis>> {
    let parsed = |text: &str| Axis::parse(text).map_err(|error| error::study(py, &error));
    if let Ok(text) = over.cast::<PyString>() {
        return Ok(vec![parsed(text.to_str()?)?]);
    }
    if let Some(values) = case::dictionary(over)? {
        return values.iter().map(|(key, values)| axis(py, &key, &values)).collect();
    }
    let texts: Vec<String> = over.extract().map_err(|_| {
        let kind = over.get_type();
        PyTypeError::new_err(format!("over: expected a dictionary of keys and their values, or texts, not {kind}"))
    })?;
    texts.iter().map(|text| parsed(text)).collect()
}

/// One axis: a key and its values.
fn axis(py: Python<'_>, key: &Bound<'_, PyAny>, values: &Bound<'_, PyAny>) -> PyResult<Axis> {
    let name: String = key.extract().map_err(|_| PyTypeError::new_err("over: keys are texts"))?;
    let path = case::path_of(&name)?;
    let parsed = |text: String| Axis::parse(&text).map_err(|error| error::study(py, &error));
    if let Ok(text) = values.cast::<PyString>() {
        return parsed(format!("{path}={}", text.to_str()?));
    }
    if let Some(known) = Key::from_path(&path)
        && let ValueKind::Quantity { .. } = known.entry().kind
    {
        // Numbers at once; quantities of pint have units, and what has no length can be gone through only once.
        let plain = !values.hasattr("to_base_units")? && values.len().is_ok() && are_numbers(values)?;
        let numbers = if plain { values.extract::<Vec<f64>>().unwrap_or_default() } else { Vec::new() };
        let numbers = if numbers.is_empty() { case::values(py, &name, known, values)? } else { numbers };
        return Axis::of(known, numbers).map_err(|error| error::study(py, &error));
    }
    let texts = values.try_iter()?.map(|item| case::text_of(&name, &item?)).collect::<PyResult<Vec<_>>>()?;
    if let Some(text) = texts.iter().find(|text| text.contains([',', '&']) || text.contains("..")) {
        return Err(PyValueError::new_err(format!("over: `{name}` = {text}: expected one value an item")));
    }
    parsed(format!("{path}={}", texts.join(",")))
}

/// Whether none of a sequence's items merely passes for a number.
fn are_numbers(values: &Bound<'_, PyAny>) -> PyResult<bool> {
    // Of numpy and pandas; others say otherwise what they hold.
    if let Ok(kind) = values.getattr("dtype").and_then(|kind| kind.getattr("kind"))
        && ["i", "u", "f"].contains(&kind.str()?.to_str()?)
    {
        return Ok(true);
    }
    for item in values.try_iter()? {
        if case::is_no_number(&item?)? {
            return Ok(false);
        }
    }
    Ok(true)
}
