//! Boxes of parts, from files and dictionaries.

use crate::{case, error};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};
use sheave::case::{Key, is_section};
use sheave::tune::{PartsBox, TuneError};
use std::collections::HashMap;
use std::path::PathBuf;

/// How messages name a box of parts given as a dictionary.
const DICTIONARY: &str = "parts";

/// A box of parts from the path of its file or from a dictionary: inside what the library refuses.
///
/// # Errors
/// `CaseError` for a dictionary that is no box of parts; `TypeError` for what is neither.
pub fn read(given: &Bound<'_, PyAny>) -> PyResult<Result<PartsBox, TuneError>> {
    if let Some(kinds) = case::dictionary(given)? {
        return Ok(PartsBox::from_toml(DICTIONARY, &text(&kinds)?));
    }
    let path: PathBuf = given.extract().map_err(|_| {
        let kind = given.get_type();
        PyTypeError::new_err(format!("parts: expected the path of a file of parts or a dictionary, not {kind}"))
    })?;
    Ok(PartsBox::read(&path))
}

/// The text of the file that says the same as a dictionary.
fn text(kinds: &Bound<'_, PyDict>) -> PyResult<String> {
    let mut lines = Vec::new();
    for (kind, content) in kinds {
        let kind = name_of(&kind)?;
        let Some(content) = case::dictionary(&content)? else {
            let given = shown(&content);
            return Err(wrong(&format!(
                "`{kind}` = {given}: expected a dictionary of parts, or of one key of a case with a list of values"
            )));
        };
        lines.push(format!("[{}]", quoted(&kind)));
        let mut listed = HashMap::new();
        for (name, given) in &content {
            let name = name_of(&name)?;
            match case::dictionary(&given)? {
                Some(keys) if !is_section(&name) => lines.push(part(&kind, &name, &keys)?),
                Some(keys) => {
                    let mut leaves = Vec::new();
                    add(&format!("{name}."), &keys, &mut leaves)?;
                    for (name, given) in leaves {
                        lines.push(list(&kind, &name, &given, &mut listed)?);
                    }
                }
                None => lines.push(list(&kind, &name, &given, &mut listed)?),
            }
        }
    }
    Ok(lines.join("\n"))
}

/// The line of a part with the keys that it sets.
fn part(kind: &str, part: &str, keys: &Bound<'_, PyDict>) -> PyResult<String> {
    let place = format!("{kind}.{part}");
    let (mut leaves, mut names) = (Vec::new(), HashMap::new());
    add("", keys, &mut leaves)?;
    let mut settings = Vec::with_capacity(leaves.len());
    for (name, given) in &leaves {
        let path = path_of(keys.py(), &place, name)?;
        once(&place, &path, name, &mut names)?;
        // As in a case, what is None is not given.
        if !given.is_none() {
            // What is no key, the library refuses, and says which is meant.
            let known = Key::from_path(&path).is_some();
            let text = if known { value(&place, &path, given)? } else { quoted("") };
            settings.push(format!("{} = {text}", dotted(&path)));
        }
    }
    Ok(format!("{} = {{ {} }}", quoted(part), settings.join(", ")))
}

/// The line of a key with a list of its values.
fn list(kind: &str, name: &str, given: &Bound<'_, PyAny>, names: &mut HashMap<String, String>) -> PyResult<String> {
    let path = path_of(given.py(), kind, name)?;
    let Some(key) = Key::from_path(&path) else {
        let (given, near) = (shown(given), Key::suggestion(&path));
        return Err(wrong(&format!(
            "`{kind}`: `{name}` = {given}: expected a part with a dictionary of the keys that it sets, or a key of a \
             case with a list of values{near}"
        )));
    };
    once(kind, &path, name, names)?;
    let Some(items) = case::items(given)? else {
        let given = shown(given);
        let expected = key.entry().expected();
        return Err(wrong(&format!("`{kind}`: `{path}` = {given}: expected a list of values, each {expected}")));
    };
    let values = items.iter().map(|item| value(kind, &path, item)).collect::<PyResult<Vec<_>>>()?;
    Ok(format!("{} = [{}]", dotted(&path), values.join(", ")))
}

/// What a dictionary sets, by name: keys with dots, or sections as dictionaries of their own.
fn add<'py>(prefix: &str, keys: &Bound<'py, PyDict>, leaves: &mut Vec<(String, Bound<'py, PyAny>)>) -> PyResult<()> {
    for (name, given) in keys {
        let name = format!("{prefix}{}", name_of(&name)?);
        let is_key = Key::from_path(&name).is_some();
        match case::dictionary(&given)? {
            Some(section) if !is_key => add(&format!("{name}."), &section, leaves)?,
            _ => leaves.push((name, given)),
        }
    }
    Ok(())
}

/// A value as text in the file.
fn value(place: &str, path: &str, given: &Bound<'_, PyAny>) -> PyResult<String> {
    let text = case::text_of(path, given).map_err(|error| {
        if !error.is_instance_of::<PyTypeError>(given.py()) {
            return error;
        }
        let expected = Key::from_path(path).map_or_else(String::new, |key| key.entry().expected());
        let (given, kind) = (shown(given), given.get_type());
        wrong(&format!("`{place}`: `{path}` = {given}, {kind}: expected {expected}"))
    })?;
    // As a person writes it: it becomes the name of a part.
    match text.parse::<f64>() {
        Ok(number) if !given.is_instance_of::<PyString>() => Ok(quoted(&number.to_string())),
        _ => Ok(quoted(&text)),
    }
}

/// The whole name of a key, which may be shortened as elsewhere.
fn path_of(py: Python<'_>, place: &str, name: &str) -> PyResult<String> {
    case::path_of(name).map_err(|error| wrong(&format!("`{place}`: {}", error.value(py))))
}

/// # Errors
/// `CaseError` for a key that has been set by another name.
fn once(place: &str, path: &str, name: &str, names: &mut HashMap<String, String>) -> PyResult<()> {
    match names.insert(path.to_owned(), name.to_owned()) {
        Some(first) => Err(wrong(&format!("`{place}`: {}", case::twice(&first, name)))),
        None => Ok(()),
    }
}

fn name_of(name: &Bound<'_, PyAny>) -> PyResult<String> {
    name.extract().map_err(|_| wrong(&format!("{}: expected names of kinds, parts and keys as texts", shown(name))))
}

fn wrong(reason: &str) -> PyErr {
    error::case_message(&format!("{DICTIONARY}: {reason}"), None)
}

/// Characters of a value that a message shows.
const SHOWN: usize = 60;

/// What was given, as Python writes it, cut short where it is long.
fn shown(given: &Bound<'_, PyAny>) -> String {
    let whole = given.repr().map_or_else(|_| given.get_type().to_string(), |text| text.to_string());
    match whole.char_indices().nth(SHOWN) {
        Some((end, _)) => format!("{}...", &whole[..end]),
        None => whole,
    }
}

/// A key's name in a file, each of its words in quotes.
fn dotted(path: &str) -> String {
    path.split('.').map(quoted).collect::<Vec<_>>().join(".")
}

/// A text in quotes, as TOML has it.
fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for character in text.chars() {
        match character {
            '"' | '\\' => quoted.extend(['\\', character]),
            control if control.is_control() => quoted.push_str(&format!("\\U{:08X}", u32::from(control))),
            other => quoted.push(other),
        }
    }
    quoted.push('"');
    quoted
}
