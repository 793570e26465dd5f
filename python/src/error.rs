//! Errors of the library as exceptions of Python, which keep place and hint.

use pyo3::import_exception;
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use sheave::bench::BenchError;
use sheave::case::{CaseError, Place};
use sheave::design::DesignError;
use sheave::drive::Failure;
use sheave::equilibrium::EquilibriumError;
use sheave::model::InternalError;
use sheave::study::StudyError;

/// The exceptions themselves are written in Python.
mod python {
    use super::import_exception;
    import_exception!(sheave.errors, BenchError);
    import_exception!(sheave.errors, CaseError);
    import_exception!(sheave.errors, DesignError);
    import_exception!(sheave.errors, MapError);
    import_exception!(sheave.errors, SolveError);
    import_exception!(sheave.errors, StudyError);
}

/// Where something stands in a file or an argument: source, line and column from 1, the text, what is wrong with it.
type Where = (String, usize, usize, String, String);

fn place(place: &Place, span: std::ops::Range<usize>, label: &str) -> Where {
    let text = &place.source.text;
    let before = text.get(..span.start).unwrap_or_default();
    let line = 1 + before.matches('\n').count();
    let column = 1 + before.rsplit('\n').next().unwrap_or_default().chars().count();
    let given = text.get(span).unwrap_or_default().to_owned();
    (place.source.name.clone(), line, column, given, label.to_owned())
}

/// What is wrong with a case: the first mistake, and the others of the same text as `others`.
pub fn case(py: Python<'_>, error: &CaseError) -> PyErr {
    let (message, hint, places) = told(error);
    let others: Vec<_> = error.others().iter().map(told).collect();
    let arguments = (message, hint, places, others);
    arguments
        .into_pyobject(py)
        .map_or_else(Into::into, |all: Bound<'_, PyTuple>| python::CaseError::new_err(all.unbind()))
}

fn told(error: &CaseError) -> (String, Option<String>, Vec<Where>) {
    let places = error.places().iter().enumerate();
    let places = places.map(|(index, at)| place(at, error.span(at), error.label(index))).collect();
    let others = error.others().iter().map(|other| format!("; {other}")).collect::<String>();
    let whole = error.to_string();
    let message = whole.strip_suffix(&others).unwrap_or(&whole).to_owned();
    (message, error.hint(), places)
}

/// Hints speak of the command line.
fn for_python(hint: &str) -> String {
    hint.replace("`sheave limit`", "`sheave.limit`")
}

/// Why there is no solution.
pub fn solve(py: Python<'_>, failure: &Failure) -> PyErr {
    let _ = py;
    let hint = failure.hint().map(for_python);
    if failure.is_bad_input() {
        return python::CaseError::new_err((failure.to_string(), hint));
    }
    python::SolveError::new_err((failure.to_string(), hint))
}

/// Why a whole drive has no equilibrium.
pub fn equilibrium(error: &EquilibriumError) -> PyErr {
    let hint = error.hint().map(for_python);
    if error.is_bad_input() {
        return case_message(error.to_string(), hint);
    }
    python::SolveError::new_err((error.to_string(), hint))
}

/// What is wrong with a case, without a place.
pub fn case_message(message: String, hint: Option<String>) -> PyErr {
    python::CaseError::new_err((message, hint))
}

/// What is wrong with measurements, without a place.
pub fn bench_message(message: String) -> PyErr {
    python::BenchError::new_err((message, None::<String>))
}

/// What must not happen.
pub fn internal(error: &InternalError) -> PyErr {
    python::SolveError::new_err((error.to_string(), None::<String>))
}

/// A limit or an optimum that there is not.
pub fn design(py: Python<'_>, error: &DesignError) -> PyErr {
    match error {
        DesignError::Start(failure) => {
            python::DesignError::new_err((error.to_string(), failure.hint().map(for_python)))
        }
        DesignError::Internal(error) => internal(error),
        _ => {
            let _ = py;
            python::DesignError::new_err((error.to_string(), None::<String>))
        }
    }
}

/// A study that cannot be begun, or was ended.
pub fn study(py: Python<'_>, error: &StudyError) -> PyErr {
    match error {
        StudyError::Case(error) => case(py, error),
        other => python::StudyError::new_err((other.to_string(), None::<String>)),
    }
}

/// Measurements that cannot be used.
pub fn bench(error: &BenchError) -> PyErr {
    let places: Vec<Where> = error
        .place()
        .map(|at| {
            let span = if at.value.is_empty() { at.key.clone() } else { at.value.clone() };
            place(at, span, "here")
        })
        .into_iter()
        .collect();
    python::BenchError::new_err((error.to_string(), error.advice().map(str::to_owned), places))
}

/// A map that cannot be made or read, or has no value at a point.
pub fn map(message: &str) -> PyErr {
    python::MapError::new_err((message.to_owned(), None::<String>))
}

/// A boundary value problem without a solution.
pub fn bvp(error: &sheave::solver::SolveError) -> PyErr {
    python::SolveError::new_err((error.to_string(), Some(error.advice().to_owned())))
}
