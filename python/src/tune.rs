//! The search for a tune. What is told becomes typed results in `sheave/_drive.py`.

use crate::beltmap::{BeltMap, Counting};
use crate::equilibrium::positive;
use crate::table::Table;
use crate::{case, convert, error, figure, interrupt, parts, result, study};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use sheave::Cancel;
use sheave::beltmap::MapOptions;
use sheave::quantity::Dimension;
use sheave::tune::{PartsBox, Ranking, TuneError, TuneOptions, TunePlan, pareto_figure, summary, table as tune_table};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Searches a box of parts: see `sheave.tune`. `parts` is the path of a file of parts, or a dictionary.
#[pyfunction]
#[pyo3(signature = (case=None, /, *, parts, target, map=None, accuracy=1e-2, max_points=20_000, points=11,
    least_reserve=0.0, best=10, jobs=None, progress=None, **keys))]
pub fn tune(
    py: Python<'_>,
    case: Option<&Bound<'_, PyAny>>,
    parts: &Bound<'_, PyAny>,
    target: &Bound<'_, PyAny>,
    map: Option<&Bound<'_, BeltMap>>,
    accuracy: f64,
    max_points: usize,
    points: usize,
    least_reserve: f64,
    best: usize,
    jobs: Option<usize>,
    progress: Option<&Bound<'_, PyAny>>,
    keys: Option<&Bound<'_, PyDict>>,
) -> PyResult<Ranked> {
    study::some_thread(jobs)?;
    let case = case::read(py, case, keys)?;
    let target = positive("target", target, Dimension::ANGULAR_SPEED)?;
    let parts = parts::read(parts)?.map_err(|error| refused(py, &error))?;
    let options = TuneOptions { points, least_reserve, confirmed: best, jobs, ..TuneOptions::new(target) };
    // As the command does: the map's points are solved a hundred times as accurately as it is read.
    let solve = result::options((0.01 * accuracy).clamp(1e-12, 1e-1), 4)?;
    let map_options = MapOptions { accuracy, solve, max_points, jobs, ..MapOptions::default() };
    let plan = TunePlan::new(case.clone(), parts.clone(), options).map_err(|error| refused(py, &error))?;
    let given = map.map(|map| map.get().0.clone());
    let (cancel, solved, screened) = (Cancel::new(), Arc::new(AtomicUsize::new(0)), Arc::new(AtomicUsize::new(0)));
    let kept = Counting::new(cancel.clone(), solved.clone());
    let count = screened.clone();
    let work = move || {
        let map = match given {
            Some(map) => map,
            None => Arc::new(plan.map(map_options)?.build(&kept)?),
        };
        let done = || _ = count.fetch_add(1, Ordering::Relaxed);
        let ranking = plan.search(&map, &done)?;
        Ok((map, ranking))
    };
    let tell = |_: Python<'_>| match progress {
        Some(progress) => {
            let done = solved.load(Ordering::Relaxed) + screened.load(Ordering::Relaxed);
            progress.call1((done,)).map(|_| ())
        }
        None => Ok(()),
    };
    let found = interrupt::watched(py, &cancel, work, tell)?;
    let (map, ranking) = found.map_err(|error: TuneError| refused(py, &error))?;
    tell(py)?;
    Ok(Ranked { case, parts, map, ranking })
}

fn refused(py: Python<'_>, error: &TuneError) -> PyErr {
    match error {
        TuneError::Case(error) => error::case(py, error),
        TuneError::Map(error) => crate::beltmap::refused(py, error),
        TuneError::Internal(error) => error::internal(error),
        TuneError::Axis { .. } | TuneError::OtherMap { .. } => error::map(&error.to_string()),
        TuneError::Parameter { .. } | TuneError::Threads(_) => PyValueError::new_err(error.to_string()),
        // What is wrong with the drive, or with the box of parts.
        other => error::case_message(&other.to_string(), None),
    }
}

/// What was found in a box of parts.
#[pyclass(frozen, module = "sheave._sheave")]
pub struct Ranked {
    case: sheave::case::Case,
    parts: PartsBox,
    map: Arc<sheave::beltmap::BeltMap>,
    ranking: Ranking,
}

#[pymethods]
impl Ranked {
    /// All of it as dictionaries.
    fn told<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        convert::object(py, &self.ranking)
    }

    /// All tunes with their parts and merits, best first; those that no other beats alone with `pareto`.
    #[pyo3(signature = (pareto=false))]
    fn table(&self, pareto: bool) -> Table {
        let table = tune_table(&self.ranking, pareto);
        let rows = table.rows.len();
        Table::new(table, vec![(vec!["candidate".to_owned()], rows)])
    }

    /// The map on which combinations were screened.
    #[getter]
    fn map(&self) -> BeltMap {
        BeltMap(self.map.clone())
    }

    /// The case with the parts of a combination in it.
    fn case(&self, py: Python<'_>, candidate: usize) -> PyResult<case::Case> {
        let count = self.parts.candidates();
        if candidate >= count {
            return Err(PyValueError::new_err(format!("combination {candidate}: there are {count}, counted from 0")));
        }
        self.parts.case(&self.case, candidate).map(case::Case).map_err(|error| error::case(py, &error))
    }

    /// The best in words.
    #[getter]
    fn summary(&self) -> String {
        summary(&self.ranking)
    }

    /// Deviation over slip reserve as data.
    fn figures<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        figure::figures(py, &[pareto_figure(&self.ranking)])
    }

    /// Deviation over slip reserve as SVG.
    fn svg(&self) -> PyResult<String> {
        figure::svg(&[pareto_figure(&self.ranking)], "pareto")
    }
}
