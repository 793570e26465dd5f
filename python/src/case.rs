//! Cases: read from files, texts and dictionaries, and changed key by key.

use crate::{convert, error};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyInt, PyList, PyMapping, PyString, PyTuple};
use sheave::case::{self, CaseError, Key, Resolved, TABLE, ValueKind};
use sheave::study::{Axis, StudyFile};
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// How messages name what a call gives by itself.
const ARGUMENT: &str = "argument";
/// How messages name a case file given as text.
const TEXT: &str = "case";

/// A case: what is given of a drive, every key optional; the base case of the thesis (Table 6.1) applies to all others.
///
/// A quantity is a text with a unit ("120 N"), a number in SI units, or a quantity of pint. Keys are named as in a case
/// file ("operating_point.slack_tension"), or by their last part alone where that says which ("slack_tension").
#[pyclass(frozen, eq, module = "sheave")]
#[derive(Clone, PartialEq)]
pub struct Case(pub case::Case);

#[pymethods]
impl Case {
    /// From a path, the text of a case file, a dictionary, another case, or nothing: the base case; then the keys.
    #[new]
    #[pyo3(signature = (case=None, /, **keys))]
    fn new(py: Python<'_>, case: Option<&Bound<'_, PyAny>>, keys: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
        read(py, case, keys).map(Self)
    }

    /// The case with some keys set in place of what was given for them. A key takes the place of those that say the
    /// same in another way: the ratio that of both radii, an axial force that of a tension.
    #[pyo3(name = "with_", signature = (keys=None, /, **more))]
    fn with_keys(
        &self,
        py: Python<'_>,
        keys: Option<&Bound<'_, PyAny>>,
        more: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let mut case = self.0.clone();
        if let Some(keys) = keys {
            let dict = dictionary(keys)?.ok_or_else(|| {
                let kind = keys.get_type();
                PyTypeError::new_err(format!("with_: expected a dictionary of keys, or keys by name, not {kind}"))
            })?;
            set(py, &mut case, &settings(&dict)?)?;
        }
        if let Some(more) = more {
            set(py, &mut case, &settings(more)?)?;
        }
        Ok(Self(case))
    }

    /// The case without some of its keys.
    #[pyo3(signature = (*keys))]
    fn without(&self, py: Python<'_>, keys: Vec<String>) -> PyResult<Self> {
        let mut case = self.0.clone();
        for name in keys {
            case.unset(&path_of(&name)?).map_err(|error| error::case(py, &error))?;
        }
        Ok(Self(case))
    }

    /// The case with a constant made unknown and an output prescribed in its place:
    /// `swap("belt.bending_stiffness for efficiency.overall = 0.96")`.
    fn swap(&self, py: Python<'_>, text: &str) -> PyResult<Self> {
        let mut case = self.0.clone();
        case.swap(text).map_err(|error| error::case(py, &error))?;
        Ok(Self(case))
    }

    /// What was given, by key, in SI units.
    #[getter]
    fn given<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for (key, setting) in self.0.settings() {
            dict.set_item(key.path(), convert::object(py, &setting)?)?;
        }
        Ok(dict)
    }

    /// The case with everything filled in, resolved to SI units, as `inputs` of a result has it.
    ///
    /// Raises CaseError where what is given does not go together.
    fn resolve<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        convert::object(py, &resolved(py, &self.0)?)
    }

    /// What is worth knowing of the case before it is solved.
    #[getter]
    fn remarks(&self) -> Vec<String> {
        self.0.remarks()
    }

    fn __repr__(&self) -> String {
        let value = |setting| match setting {
            case::Setting::Number(si) => si.to_string(),
            case::Setting::List(numbers) => format!("{numbers:?}"),
            case::Setting::Name(name) => format!("\"{name}\""),
            case::Setting::Table(table) => format!("\"{table}\""),
        };
        let given = self.0.settings().map(|(key, setting)| format!("\"{}\": {}", key.path(), value(setting)));
        let given = given.collect::<Vec<_>>().join(", ");
        let swaps: String = self.0.swaps().map(|swap| format!(".swap(\"{swap}\")")).collect();
        format!("Case({{{given}}}){swaps}")
    }

    /// Made anew from what was given; the places of errors are then those of arguments.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
        let py = slf.py();
        let rebuild = py.import("sheave._sheave")?.getattr("rebuild_case")?;
        let case = &slf.get().0;
        let swaps: Vec<String> = case.swaps().map(ToString::to_string).collect();
        let given = PyDict::new(py);
        for (key, setting) in case.settings() {
            match setting {
                // As text, which the case reads again.
                case::Setting::Table(table) => given.set_item(key.path(), table.to_string())?,
                other => given.set_item(key.path(), convert::object(py, &other)?)?,
            }
        }
        Ok((rebuild, (given, swaps).into_pyobject(py)?.into_any()))
    }
}

/// A case from what another had given, in SI units, and its exchanges: for `pickle`.
#[pyfunction]
pub fn rebuild_case(py: Python<'_>, given: &Bound<'_, PyDict>, swaps: Vec<String>) -> PyResult<Case> {
    let mut case = case::Case::base();
    for (path, value) in given {
        let path: String = path.extract()?;
        let set = match (Key::from_path(&path), value.extract::<f64>(), value.extract::<Vec<f64>>()) {
            (Some(key), Ok(number), _) => case.set_si(key, number),
            (Some(key), _, Ok(numbers)) => case.set_list(key, &numbers),
            _ => case.set_from(ARGUMENT, &path, &text_of(&path, &value)?),
        };
        set.map_err(|error| error::case(py, &error))?;
    }
    for text in swaps {
        case.swap(&text).map_err(|error| error::case(py, &error))?;
    }
    Ok(Case(case))
}

/// All keys of a case file: name, unit in which people read it, default in SI units (None where there is none), range
/// or choices, and meaning.
#[pyfunction]
pub fn keys(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    let rows = TABLE.iter().map(|entry| {
        let (unit, choices) = match entry.kind {
            ValueKind::Quantity { unit, .. } | ValueKind::List { unit, .. } => (unit.symbol, Vec::new()),
            ValueKind::Choice { choices, .. } => ("", choices.iter().map(|choice| choice.name).collect()),
        };
        serde_json::json!({
            "key": entry.path, "unit": unit, "default": entry.base(), "choices": choices,
            "expected": entry.expected(), "meaning": entry.doc,
        })
    });
    convert::object(py, &rows.collect::<Vec<_>>())
}

/// The case that a call is about: what its first argument says, changed by its keys.
///
/// # Errors
/// `CaseError`; `TypeError` for what says nothing of a case.
pub fn read(py: Python<'_>, case: Option<&Bound<'_, PyAny>>, keys: Option<&Bound<'_, PyDict>>) -> PyResult<case::Case> {
    let mut read = match case {
        None => case::Case::base(),
        Some(given) => one(py, given)?,
    };
    if let Some(keys) = keys {
        set(py, &mut read, &settings(keys)?)?;
    }
    Ok(read)
}

fn one(py: Python<'_>, given: &Bound<'_, PyAny>) -> PyResult<case::Case> {
    let read = match written(py, given)? {
        Written::Made(case) => return Ok(case),
        Written::Content(text) => case::Case::from_toml(TEXT, &text),
        Written::Path(path) => case::Case::read(&path),
    };
    read.map_err(|error| error::case(py, &error))
}

/// As [`read`], of what may also be a study file: with what that varies.
///
/// # Errors
/// As [`read`], and `StudyError`.
pub fn read_study(
    py: Python<'_>,
    case: Option<&Bound<'_, PyAny>>,
    keys: Option<&Bound<'_, PyDict>>,
) -> PyResult<(case::Case, Vec<Axis>)> {
    let read = match case.map(|given| written(py, given)).transpose()? {
        None => Ok(StudyFile { case: case::Case::base(), axes: Vec::new() }),
        Some(Written::Made(case)) => Ok(StudyFile { case, axes: Vec::new() }),
        Some(Written::Content(text)) => StudyFile::from_toml(TEXT, &text),
        Some(Written::Path(path)) => StudyFile::read(&path),
    };
    let StudyFile { mut case, axes } = read.map_err(|error| error::study(py, &error))?;
    if let Some(keys) = keys {
        set(py, &mut case, &settings(keys)?)?;
    }
    Ok((case, axes))
}

/// What a call is about, as far as it is read.
enum Written {
    /// A case.
    Made(case::Case),
    /// The text of a file.
    Content(String),
    /// The name of one.
    Path(PathBuf),
}

fn written(py: Python<'_>, given: &Bound<'_, PyAny>) -> PyResult<Written> {
    if let Ok(case) = given.cast::<Case>() {
        return Ok(Written::Made(case.get().0.clone()));
    }
    if let Some(keys) = dictionary(given)? {
        let mut case = case::Case::base();
        set(py, &mut case, &settings(&keys)?)?;
        return Ok(Written::Made(case));
    }
    match given.cast::<PyString>() {
        Ok(text) if is_content(text.to_str()?) => Ok(Written::Content(text.to_str()?.to_owned())),
        _ => given.extract().map(Written::Path).map_err(|_| {
            let kind = given.get_type();
            PyTypeError::new_err(format!(
                "a case is a path, the text of a case file, a dictionary of keys or a Case, not {kind}"
            ))
        }),
    }
}

/// A mapping of any type as a dictionary; none for what is no mapping.
///
/// # Errors
/// What the mapping raises.
pub fn dictionary<'py>(given: &Bound<'py, PyAny>) -> PyResult<Option<Bound<'py, PyDict>>> {
    if let Ok(dict) = given.cast::<PyDict>() {
        return Ok(Some(dict.clone()));
    }
    let Ok(mapping) = given.cast::<PyMapping>() else { return Ok(None) };
    let dict = PyDict::new(given.py());
    dict.update(mapping)?;
    Ok(Some(dict))
}

/// Whether a text is the content of a case file, not the name of one: it has a line's end, or an assignment in its only
/// line. Names may have "=" in them, too: those of files that are there, and whatever ends in .toml, as no assignment
/// does.
pub fn is_content(text: &str) -> bool {
    text.contains('\n') || text.contains('=') && !text.ends_with(".toml") && !Path::new(text).is_file()
}

/// A key's name, and its value as a case file has it.
pub type Settings = Vec<(String, String)>;

/// What a dictionary sets: keys with dots, or sections as dictionaries of their own.
///
/// # Errors
/// `TypeError` for a value that is no quantity and no name.
pub fn settings(keys: &Bound<'_, PyDict>) -> PyResult<Settings> {
    let mut settings = Settings::new();
    add(&mut settings, "", keys)?;
    Ok(settings)
}

/// Those of one section, whose name with its dot is `prefix`.
fn add(settings: &mut Settings, prefix: &str, keys: &Bound<'_, PyDict>) -> PyResult<()> {
    for (name, value) in keys {
        let kind = name.get_type();
        let name: String = name.extract().map_err(|_| {
            PyTypeError::new_err(format!("a key is a text, such as \"slack_tension\", not {name} ({kind})"))
        })?;
        let name = format!("{prefix}{name}");
        match dictionary(&value)? {
            // A table of values, over temperature or frequency.
            Some(table) if path_of(&name).is_ok_and(|path| Key::from_path(&path).is_some()) => {
                let entry = |(key, value): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
                    let key: String = key.extract()?;
                    Ok(format!("{key} = {}", in_toml(text_of(&name, &value)?)))
                };
                let entries = table.iter().map(entry).collect::<PyResult<Vec<_>>>()?;
                settings.push((name, format!("{{ {} }}", entries.join(", "))));
            }
            Some(section) => add(settings, &format!("{name}."), &section)?,
            None if value.is_none() => {}
            None => {
                let text = text_of(&name, &value)?;
                settings.push((name, text));
            }
        }
    }
    Ok(())
}

/// Sets keys, each of them once; those that say the same in another way make room.
fn set(py: Python<'_>, case: &mut case::Case, settings: &Settings) -> PyResult<()> {
    let (mut paths, mut named) = (Vec::with_capacity(settings.len()), HashMap::new());
    for (name, _) in settings {
        let path = path_of(name)?;
        if let Some(first) = named.insert(path.clone(), name)
            && Key::from_path(&path).is_some()
        {
            return Err(error::case_message(&twice(first, name), None));
        }
        paths.push(path);
    }
    let known: Vec<Key> = paths.iter().filter_map(|path| Key::from_path(path)).collect();
    case.make_room(&known);
    for (path, (_, value)) in paths.iter().zip(settings) {
        case.set_from(ARGUMENT, path, value).map_err(|error| error::case(py, &error))?;
    }
    Ok(())
}

/// What is wrong with two names of one key.
pub fn twice(first: &str, second: &str) -> String {
    if first == second {
        format!("`{first}` is given twice: expected it once")
    } else {
        format!("`{first}` and `{second}` are the same key, which is given twice: expected one of them")
    }
}

/// A key's name with dots, as keyword arguments cannot have them.
pub fn with_dots(name: &str) -> String {
    if name.contains('.') { name.to_owned() } else { name.replace("__", ".") }
}

/// The whole name of a key that may be given by its last part; unknown names stay as they are, for the case to refuse.
///
/// # Errors
/// `ValueError` for a last part that several keys have.
pub fn path_of(name: &str) -> PyResult<String> {
    let path = with_dots(name);
    if path.contains('.') || Key::from_path(name).is_some() {
        return Ok(path);
    }
    let mut named = TABLE.iter().filter(|entry| entry.name() == name);
    match (named.next(), named.next()) {
        (Some(entry), None) => Ok(entry.path.to_owned()),
        (Some(one), Some(other)) => Err(PyValueError::new_err(format!(
            "`{name}` is a key of several sections: write `{}` or `{}`",
            one.path, other.path
        ))),
        (None, _) => Ok(name.to_owned()),
    }
}

/// A value as a case file has it: a text as it is, a number in SI units, a quantity of pint with its unit.
///
/// # Errors
/// `TypeError` for anything else.
pub fn text_of(name: &str, value: &Bound<'_, PyAny>) -> PyResult<String> {
    if let Ok(text) = value.cast::<PyString>() {
        return Ok(text.to_str()?.to_owned());
    }
    let wrong = || {
        let kind = value.get_type();
        PyTypeError::new_err(format!(
            "`{name}`: a value is a text with a unit (\"120 N\"), a number in SI units or a quantity of pint, not \
             {kind}"
        ))
    };
    if let Some(items) = items(value)? {
        let items = items.iter().map(|item| Ok(in_toml(text_of(name, item)?)));
        return Ok(format!("[{}]", items.collect::<PyResult<Vec<_>>>()?.join(", ")));
    }
    if is_no_number(value)? {
        return Err(wrong());
    }
    if value.hasattr("to_base_units")? {
        let text = value.py().import("sheave.units")?.call_method1("text", (value,))?;
        return text.extract();
    }
    let number: f64 = value.extract().map_err(|_| wrong())?;
    Ok(format!("{number:e}"))
}

/// The items of a list, a tuple, an array or a quantity with an array; none for anything else.
///
/// # Errors
/// What the value raises.
pub fn items<'py>(value: &Bound<'py, PyAny>) -> PyResult<Option<Vec<Bound<'py, PyAny>>>> {
    let array = value.hasattr("tolist")? && value.hasattr("ndim")?;
    let listed = value.is_instance_of::<PyList>() || value.is_instance_of::<PyTuple>();
    if listed || array && value.getattr("ndim")?.extract::<usize>()? > 0 {
        return value.try_iter()?.collect::<PyResult<_>>().map(Some);
    }
    Ok(None)
}

/// Whether a value would pass for a number and is none: a truth, a time or a complex number, of Python or of an array.
///
/// # Errors
/// What the value raises.
pub fn is_no_number(value: &Bound<'_, PyAny>) -> PyResult<bool> {
    if value.is_exact_instance_of::<PyFloat>() || value.is_exact_instance_of::<PyInt>() {
        return Ok(false);
    }
    if value.is_instance_of::<PyBool>() {
        return Ok(true);
    }
    let kind = value.getattr_opt("dtype")?.map(|kind| kind.getattr_opt("kind")).transpose()?.flatten();
    if let Some(kind) = kind {
        // As numpy and pandas name truths, durations, times and complex numbers.
        return Ok(["b", "m", "M", "c"].contains(&kind.str()?.to_str()?));
    }
    if value.hasattr("to_base_units")? {
        return value.getattr_opt("magnitude")?.map_or(Ok(false), |magnitude| is_no_number(&magnitude));
    }
    // Of other packages' arrays, of which the value is one without dimensions.
    match value.getattr_opt("tolist")? {
        Some(plain) => Ok(plain.call0()?.is_instance_of::<PyBool>()),
        None => Ok(false),
    }
}

/// A value's text within an array or a table: in quotes, unless it is a number or an array.
fn in_toml(text: String) -> String {
    if text.starts_with('[') || text.parse::<f64>().is_ok() { text } else { format!("{text:?}") }
}

/// The case of a call that prescribes no output of the belt, in whose place a constant would be found.
///
/// # Errors
/// As [`read`]; `CaseError` for a case with an exchange.
pub fn read_unswapped(
    py: Python<'_>,
    function: &str,
    case: Option<&Bound<'_, PyAny>>,
    keys: Option<&Bound<'_, PyDict>>,
) -> PyResult<case::Case> {
    let case = read(py, case, keys)?;
    if let Some(swap) = case.swaps().next() {
        return Err(error::case_message(
            &format!(
                "swap \"{swap}\": `sheave.{function}` prescribes no output of the belt; expected a case without swap, \
                 or solve, sweep, limit or optimum"
            ),
            None,
        ));
    }
    Ok(case)
}

/// Values of a key in SI units, each given by itself: a number, a text with a unit, or a quantity of pint.
///
/// # Errors
/// `StudyError`, `CaseError`; `TypeError` for a value that is none.
pub fn values(py: Python<'_>, name: &str, key: Key, given: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
    // Of each by itself: in one text, a number without a unit has that of the last.
    let value = |item: PyResult<Bound<'_, PyAny>>| {
        let item = item?;
        let text = text_of(name, &item)?;
        if let Ok(number) = text.parse::<f64>()
            && !item.is_instance_of::<PyString>()
        {
            return Ok(number);
        }
        if text.contains([',', '&']) || text.contains("..") {
            return Err(PyValueError::new_err(format!("over: `{name}` = {text}: expected one value an item")));
        }
        let axis = Axis::parse(&format!("{}={text}", key.path())).map_err(|error| error::study(py, &error))?;
        let first = axis.at(0).find_map(|(_, setting)| match setting {
            case::Setting::Number(number) => Some(number),
            _ => None,
        });
        first.ok_or_else(|| PyValueError::new_err(format!("over: `{name}` = {text}: expected a quantity")))
    };
    let none = || {
        let kind = given.get_type();
        PyTypeError::new_err(format!(
            "over: `{name}`: expected a range or values as text, or several values, not {kind}"
        ))
    };
    if dictionary(given)?.is_some() {
        return Err(none());
    }
    let values = given.try_iter().map_err(|_| none())?.map(value).collect::<PyResult<Vec<_>>>()?;
    if values.is_empty() {
        return Err(PyValueError::new_err(format!("over: `{name}` has no values")));
    }
    Ok(values)
}

/// The case resolved, and fit for the solver.
///
/// # Errors
/// `CaseError`.
pub fn resolved(py: Python<'_>, case: &case::Case) -> PyResult<Resolved> {
    let posed = || -> Result<Resolved, CaseError> {
        let resolved = case.resolve()?;
        case.check_posed(&resolved)?;
        Ok(resolved)
    };
    posed().map_err(|error| error::case(py, &error))
}
