//! Errors of the library as exceptions of Python, which keep place and hint.

use pyo3::import_exception;
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use sheave::bench::BenchError;
use sheave::case::{CaseError, Place};
use sheave::design::{DesignError, Verdict};
use sheave::drive::Failure;
use sheave::equilibrium::EquilibriumError;
use sheave::model::InternalError;
use sheave::solver::{MeshBound, NewtonError, Shortfall, SolveError};
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
    // What the command line takes by these options is an argument here.
    let name = match place.source.name.as_str() {
        "--set" | "--unset" | "--swap" => "argument",
        name => name,
    };
    (name.to_owned(), line, column, given, label.to_owned())
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
    (message, error.hint().as_deref().map(for_python), places)
}

/// What is said otherwise here than on the command line.
const SAID: [(&str, &str); 13] = [
    ("`sheave sweep FILE` solves", "`sheave.sweep(FILE)` solves"),
    ("a map that `sheave map` wrote", "a map that `BeltMap.write` or `sheave map` wrote"),
    ("; `-v` says what the solver met", ""),
    ("--branch tight", "branch=\"tight\""),
    ("--branch loose", "branch=\"loose\""),
    (
        "expected --over KEY=FROM..TO, such as `ratio=0.7..3.2`,",
        "expected keys and ranges, such as `ratio=\"0.7..3.2\"`,",
    ),
    (
        "--unset thermal.ambient --unset thermal.heat_transfer",
        "`case.without(\"thermal.ambient\", \"thermal.heat_transfer\")`",
    ),
    ("or give --temperature on the command line", "or give `temperature`"),
    ("`sheave limit`", "`sheave.limit`"),
    ("`sheave map`", "`sheave.map`"),
    ("`sheave shift`", "`sheave.shift`"),
    ("`sheave sweep`", "`sheave.sweep`"),
    ("`sheave tune`", "`sheave.tune`"),
];

/// What the library says, with the names that commands and options have in Python.
pub fn for_python(said: &str) -> String {
    options(&in_page(said))
}

/// As [`for_python`] of a page, in which two hyphens may stand for something else: what is known by its sentence.
pub fn in_page(said: &str) -> String {
    let mut text = reserve(said);
    for (there, here) in SAID {
        if text.contains(there) {
            text = text.replace(there, here);
        }
    }
    text
}

/// `--reserve 30%` as the key that it sets.
fn reserve(said: &str) -> String {
    const OPTION: &str = "--reserve ";
    let mut text = String::with_capacity(said.len());
    let mut rest = said;
    while let Some((before, after)) = rest.split_once(OPTION) {
        let digits = after.len() - after.trim_start_matches(|c: char| c.is_ascii_digit()).len();
        let (share, behind) = after.split_at(digits);
        text.push_str(before);
        match behind.strip_prefix('%') {
            Some(behind) if digits > 0 => {
                text.push_str(&format!("slip_reserve=\"{share}%\""));
                rest = behind;
            }
            _ => {
                text.push_str(OPTION);
                rest = after;
            }
        }
    }
    text.push_str(rest);
    text
}

/// Options of the command line that stand alone in a sentence, as arguments: `--work-limit` is `work_limit`.
fn options(said: &str) -> String {
    let mut text = String::with_capacity(said.len());
    let mut rest = said;
    while let Some(at) = rest.find("--") {
        let (before, after) = (&rest[..at], &rest[at + 2..]);
        let length = after.len() - after.trim_start_matches(|c: char| c.is_ascii_lowercase() || c == '-').len();
        let name = after[..length].trim_end_matches('-');
        text.push_str(before);
        let alone = before.is_empty() || before.ends_with([' ', '(', '`']);
        if alone && name.starts_with(|c: char| c.is_ascii_lowercase()) {
            text.push_str(&name.replace('-', "_"));
        } else {
            text.push_str("--");
            text.push_str(name);
        }
        rest = &after[name.len()..];
    }
    text.push_str(rest);
    text
}

/// Why there is no solution.
pub fn solve(failure: &Failure) -> PyErr {
    let hint = failure.hint().map(for_python);
    if failure.is_bad_input() {
        return python::CaseError::new_err((failure.to_string(), hint));
    }
    python::SolveError::new_err((failure.to_string(), hint))
}

/// Why there is no solution, where that is proven.
pub fn unsolved(proof: &Verdict) -> PyErr {
    let hint = "clamp the belt tighter or ask for less torque; `sheave.limit` has all limits";
    python::SolveError::new_err((format!("no solution: {proof}"), Some(hint.to_owned())))
}

/// Why a whole drive has no equilibrium.
pub fn equilibrium(error: &EquilibriumError) -> PyErr {
    let hint = error.hint().map(for_python);
    if error.is_bad_input() {
        return case_message(&error.to_string(), hint);
    }
    python::SolveError::new_err((error.to_string(), hint))
}

/// What is wrong with a case, without a place.
pub fn case_message(message: &str, hint: Option<String>) -> PyErr {
    python::CaseError::new_err((for_python(message), hint))
}

/// What is wrong with measurements, without a place.
pub fn bench_message(message: &str) -> PyErr {
    python::BenchError::new_err((for_python(message), None::<String>))
}

/// What must not happen.
pub fn internal(error: &InternalError) -> PyErr {
    python::SolveError::new_err((error.to_string(), None::<String>))
}

/// A limit or an optimum that there is not.
pub fn design(error: &DesignError) -> PyErr {
    match error {
        DesignError::Start(failure) => {
            python::DesignError::new_err((error.to_string(), failure.hint().map(for_python)))
        }
        DesignError::Internal(error) => internal(error),
        _ => python::DesignError::new_err((for_python(&error.to_string()), None::<String>)),
    }
}

/// A study that cannot be begun, or was ended.
pub fn study(py: Python<'_>, error: &StudyError) -> PyErr {
    match error {
        StudyError::Case(error) => case(py, error),
        other => python::StudyError::new_err((for_python(&other.to_string()), None::<String>)),
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
    python::BenchError::new_err((for_python(&error.to_string()), error.advice().map(for_python), places))
}

/// A map that cannot be made or read, or has no value at a point.
pub fn map(message: &str) -> PyErr {
    python::MapError::new_err((for_python(message), None::<String>))
}

/// A boundary value problem without a solution.
pub fn bvp(error: &SolveError) -> PyErr {
    python::SolveError::new_err((error.to_string(), Some(bvp_advice(error).to_owned())))
}

/// Tolerances below which rounding is what stands in the way.
const NEAR_ROUNDING: f64 = 1e-12;

/// What to try in `sheave.bvp.solve`, where the solver's own advice is of things that Python has under other names or
/// not at all.
fn bvp_advice(error: &SolveError) -> &'static str {
    match error {
        SolveError::Newton { error: NewtonError::NonFinite(_), .. } => {
            "The guess, or every step from it, leaves the domain of the equations. Guess values inside it, or rewrite \
             f so that it is defined nearby. At an end at which the equations are singular, use order=8 or \
             order=\"gauss\", which need no value there, or give the limit."
        }
        SolveError::Newton { error: NewtonError::Singular { empty_equations, .. }, .. }
            if empty_equations.is_empty() =>
        {
            "The boundary equations do not determine the components named. A phase or scale may be free (add a \
             condition), a condition may be stated twice, or the guess may be at rest, where no period and no \
             eigenvalue is determined (guess a larger amplitude)."
        }
        SolveError::Newton { error: NewtonError::Overflow, .. } => {
            "The guess, or an iterate, is far too large for the equations, as an exponential of hundreds is: guess \
             smaller values, or scale the equations."
        }
        SolveError::Newton { error: NewtonError::Stalled { .. }, .. } => {
            "There may be no solution near the guess, or the equations may have a kink. Improve the guess, or come \
             from the solution for an easier parameter."
        }
        SolveError::Newton { error: NewtonError::IterationLimit { .. }, .. } => {
            "The iteration was still moving: improve the guess, or come from the solution for an easier parameter."
        }
        SolveError::MeshLimit { tolerance, .. } if *tolerance < NEAR_ROUNDING => error.advice(),
        SolveError::MeshLimit { because: MeshBound::Rounding, .. } => error.advice(),
        SolveError::MeshLimit { because: MeshBound::Meshes { .. }, .. } => {
            "Begin with a finer mesh where the defect is, or come from the solution for an easier parameter."
        }
        SolveError::MeshLimit { defect, tolerance, .. } if *defect > 1e3 * tolerance => {
            "The solution varies faster than the mesh can resolve: a layer, a singularity, or a spurious solution of a \
             coarse mesh. Come from the solution for a parameter at which it is wider, begin with a finer mesh where \
             the layer is, or allow more nodes (max_nodes)."
        }
        SolveError::MeshLimit { .. } => {
            "Allow more nodes (max_nodes), use a higher order, or ask for less; near 1e-12 rounding is the limit. A \
             kink in f costs many nodes."
        }
        SolveError::Boundary { .. } => "Scale the boundary equation or its states, or loosen bc_tol.",
        SolveError::Inaccurate { because: Shortfall::Rounding, .. } => {
            "The problem amplifies rounding errors: ask for less, scale its equations, or state the solution in terms \
             that are not small differences of large ones."
        }
        SolveError::Inaccurate { .. } => {
            "Allow more nodes (max_nodes), or use a higher order; an error estimate near 1 means that the solution may \
             be spurious."
        }
        SolveError::WorkLimit { .. } => {
            "Allow more work (work_limit), improve the guess, or come from the solution for an easier parameter; what \
             is slow to converge may have no solution."
        }
        other => other.advice(),
    }
}
