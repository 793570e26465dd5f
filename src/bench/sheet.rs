//! Reading a TOML file of measured quantities against a table of its keys.

use super::error::{BenchError, BenchProblem};
use crate::case::raw::{Raw, in_order, kind, raw};
use crate::case::{Place, Range, Source};
use crate::quantity::{self, Dimension, QuantityError, Unit, on_shifted_scale};
use crate::text::quoted;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;
use std::sync::Arc;
use toml::de::{DeTable, DeValue};

/// What values a key takes.
#[derive(Debug, Clone, Copy)]
pub enum QuantityKind {
    /// A number with a unit, or a bare number in SI; range and example in that unit.
    Quantity {
        /// Unit in which people read it.
        unit: Unit,
        /// Allowed values.
        range: Range,
    },
    /// A force per linear density, or a length that gravity turns into one.
    SpecificModulus,
    /// A temperature: `"60 degC"`, `"140 degF"`, `"333.15 K"`; a bare number is in kelvin.
    Temperature,
    /// A text.
    Text,
    /// Pairs of lengths.
    Outline,
}

/// What is known of a key.
#[derive(Debug, Clone, Copy)]
pub struct Entry {
    /// Its name with its section: `bending.radius`.
    pub path: &'static str,
    /// What values it takes.
    pub kind: QuantityKind,
    /// A value that could be written.
    pub example: &'static str,
    /// What it means, in one line.
    pub doc: &'static str,
}

/// A value that was given, in SI.
#[derive(Debug, Clone, PartialEq)]
enum Value {
    Number(f64, Dimension),
    Text(String),
    Outline(Vec<(f64, f64)>),
}

/// A file as it was read: every value checked against the table. Keys of an array of tables carry the table's number,
/// from 0: `rubber.test.0.temperature`.
#[derive(Debug, Clone)]
pub struct Sheet {
    table: &'static [Entry],
    source: Arc<Source>,
    given: BTreeMap<String, (Value, Place)>,
}

/// Tables in a row that a file may have; more are a mistake.
const TABLES: usize = 1000;

impl Entry {
    /// What is expected as a value, in words.
    pub fn expected(&self) -> String {
        let what = match self.kind {
            QuantityKind::Quantity { unit, range } => {
                let words = range.words(unit.symbol).to_string();
                format!("{} {words}", unit.scale.dimension).trim_end().to_owned()
            }
            QuantityKind::SpecificModulus => {
                "a force per linear density, or a length that gravity turns into one".into()
            }
            QuantityKind::Temperature => "a temperature above 0 K".into(),
            QuantityKind::Text => "a text".into(),
            QuantityKind::Outline => "a list of pairs of lengths".into(),
        };
        format!("{what}, such as {}", self.example)
    }

    fn read(&self, path: &str, value: &DeValue<'_>, given: &str) -> Result<Value, BenchProblem> {
        match (self.kind, value) {
            (QuantityKind::Text, DeValue::String(text)) => Ok(Value::Text(text.to_string())),
            (QuantityKind::Text, other) => Err(self.wrong_type(path, kind(other))),
            (QuantityKind::Outline, DeValue::Array(pairs)) => {
                let length = |value: &DeValue<'_>| match number(raw(value), Dimension::LENGTH) {
                    Some(Ok(si)) => Ok(si),
                    Some(Err(reason)) => Err(self.invalid(path, given, reason)),
                    None => Err(self.wrong_type(path, kind(value))),
                };
                let pair = |pair: &DeValue<'_>| match pair.as_array().map(|array| array.iter().collect::<Vec<_>>()) {
                    Some(items) => match items.as_slice() {
                        [x, y] => Ok((length(x.get_ref())?, length(y.get_ref())?)),
                        _ => Err(self.wrong_type(path, "a list with items that are not pairs")),
                    },
                    None => Err(self.wrong_type(path, "a list with items that are not pairs")),
                };
                pairs.iter().map(|item| pair(item.get_ref())).collect::<Result<_, _>>().map(Value::Outline)
            }
            (QuantityKind::Outline, other) => Err(self.wrong_type(path, kind(other))),
            (QuantityKind::Temperature, value) => match raw(value) {
                Raw::Text(text) => temperature(&text).map_err(|reason| self.unusable(path, &reason)),
                Raw::Number(number) => temperature(&number.to_string()).map_err(|reason| self.unusable(path, &reason)),
                Raw::List(_) => Err(self.wrong_type(path, "an array")),
                Raw::Other(kind) => Err(self.wrong_type(path, kind)),
            }
            .map(|si| Value::Number(si, Dimension::NONE)),
            (QuantityKind::SpecificModulus, value) => self.specific_modulus(path, value, given),
            (QuantityKind::Quantity { unit, range }, value) => match number(raw(value), unit.scale.dimension) {
                Some(Ok(si)) if range.contains(si, |bound| unit.to_si(bound)) => {
                    Ok(Value::Number(si, unit.scale.dimension))
                }
                Some(Ok(_)) => Err(self.out_of_range(path, given)),
                Some(Err(reason)) => Err(self.invalid(path, given, reason)),
                None => Err(self.wrong_type(path, kind(value))),
            },
        }
    }

    fn specific_modulus(&self, path: &str, value: &DeValue<'_>, given: &str) -> Result<Value, BenchProblem> {
        let specific = Dimension::new(2, 0, -2, 0);
        let DeValue::String(text) = value else {
            return Err(self.wrong_type(path, kind(value)));
        };
        let read = quantity::parse(text).map_err(|reason| self.invalid(path, given, reason))?;
        let known = [specific, Dimension::LENGTH].contains(&read.dimension);
        match known {
            _ if read.si <= 0.0 => Err(self.out_of_range(path, given)),
            true => Ok(Value::Number(read.si, read.dimension)),
            false => {
                let reason = QuantityError::Dimension { given: read.dimension, expected: specific };
                Err(self.invalid(path, given, reason))
            }
        }
    }

    fn wrong_type(&self, path: &str, given: &'static str) -> BenchProblem {
        BenchProblem::Type { path: path.into(), given, expected: self.expected() }
    }

    fn invalid(&self, path: &str, given: &str, reason: QuantityError) -> BenchProblem {
        BenchProblem::Quantity { path: path.into(), given: given.into(), reason, expected: self.expected() }
    }

    fn unusable(&self, path: &str, reason: &str) -> BenchProblem {
        BenchProblem::Unusable { path: path.into(), reason: format!("{reason}; expected {}", self.expected()) }
    }

    fn out_of_range(&self, path: &str, given: &str) -> BenchProblem {
        BenchProblem::OutOfRange { path: path.into(), given: given.into(), expected: self.expected() }
    }
}

/// A number in SI; `None` for what is neither text nor number.
fn number(raw: Raw<'_>, dimension: Dimension) -> Option<Result<f64, QuantityError>> {
    match raw {
        Raw::Text(text) => Some(quantity::parse(&text).and_then(|quantity| quantity.expect(dimension))),
        Raw::Number(si) if si.is_finite() => Some(Ok(si)),
        Raw::Number(_) => Some(Err(QuantityError::NotFinite)),
        Raw::List(_) | Raw::Other(_) => None,
    }
}

/// A temperature in kelvin: a number and `degC`, `°C`, `degF`, `°F` or `K`; a bare number is in kelvin.
///
/// # Errors
/// What is wrong with the text.
pub fn temperature(text: &str) -> Result<f64, String> {
    let text = text.trim();
    let end = text.find(|c: char| !(c.is_ascii_digit() || "+-.eE".contains(c))).unwrap_or(text.len());
    let (number, unit) = text.split_at(end);
    let number: f64 = number.parse().map_err(|_| format!("`{text}` does not begin with a number"))?;
    let kelvin = match unit.trim() {
        "" | "K" => Some(number),
        // As sheets of measurements have them.
        "C" => on_shifted_scale(number, "degC"),
        "F" => on_shifted_scale(number, "degF"),
        unit => on_shifted_scale(number, unit),
    };
    let Some(kelvin) = kelvin else {
        return Err(format!("`{}` is no unit of temperature: degC, degF or K", unit.trim()));
    };
    match kelvin {
        kelvin if !(kelvin.is_finite() && kelvin > 0.0) => Err(format!("`{text}` is not above absolute zero")),
        // Nobody tests rubber there: a bare number was meant in degrees Celsius.
        kelvin if unit.trim().is_empty() && kelvin < 150.0 => {
            Err(format!("a bare number is in kelvin, and {number} K is no belt's; did you mean `{number} degC`?"))
        }
        kelvin => Ok(kelvin),
    }
}

impl Sheet {
    /// Reads a file.
    ///
    /// # Errors
    /// [`BenchProblem::Read`], else as [`Sheet::parse`].
    pub fn read(path: &Path, table: &'static [Entry]) -> Result<Self, BenchError> {
        let text = std::fs::read_to_string(path).map_err(|error| BenchError::read(path, &error))?;
        Self::parse(&path.display().to_string(), &text, table)
    }

    /// Reads the text of a file; `name` is shown in errors.
    ///
    /// # Errors
    /// The first thing that is wrong: see [`BenchProblem`].
    pub fn parse(name: &str, text: &str, table: &'static [Entry]) -> Result<Self, BenchError> {
        let source = Arc::new(Source::new(name, text));
        let document = DeTable::parse(text).map_err(|error| {
            let span = error.span().unwrap_or(0..0);
            let message = error.message().trim().replace('\n', ", ");
            let place = Place { source: source.clone(), key: span.clone(), value: span };
            BenchError::new(BenchProblem::Syntax { message }, Some(place))
        })?;
        let mut sheet = Self { table, source, given: BTreeMap::new() };
        sheet.add(document.get_ref(), "", "")?;
        Ok(sheet)
    }

    /// Adds the keys of a table; `name` is its path, `numbered` the same with the numbers of tables in arrays.
    fn add(&mut self, table: &DeTable<'_>, name: &str, numbered: &str) -> Result<(), BenchError> {
        let joined = |parent: &str, key: &str| {
            if parent.is_empty() { key.to_owned() } else { format!("{parent}.{key}") }
        };
        for (key, value) in in_order(table) {
            let (path, full) = (joined(name, key.get_ref()), joined(numbered, key.get_ref()));
            let place = Place { source: self.source.clone(), key: key.span(), value: value.span() };
            let inside = self.table.iter().any(|entry| entry.path.starts_with(&format!("{path}.")));
            match value.get_ref() {
                DeValue::Table(table) if inside => self.add(table, &path, &full)?,
                DeValue::Array(array) if inside && array.iter().all(|item| item.get_ref().is_table()) => {
                    if array.len() > TABLES {
                        let reason = format!("{} tables, and no more than {TABLES} are expected", array.len());
                        return Err(BenchError::new(BenchProblem::Unusable { path, reason }, Some(place)));
                    }
                    for (at, item) in array.iter().enumerate() {
                        if let Some(table) = item.get_ref().as_table() {
                            self.add(table, &path, &format!("{full}.{at}"))?;
                        }
                    }
                }
                other if inside => {
                    let problem = BenchProblem::Type { path, given: kind(other), expected: "a table of keys".into() };
                    return Err(BenchError::new(problem, Some(place)));
                }
                other => self.insert(&path, full, other, place)?,
            }
        }
        Ok(())
    }

    fn insert(&mut self, path: &str, full: String, value: &DeValue<'_>, place: Place) -> Result<(), BenchError> {
        let Some(entry) = self.table.iter().find(|entry| entry.path == path) else {
            let place = Place { value: place.key.clone(), ..place };
            return Err(BenchError::new(
                BenchProblem::UnknownKey { path: quoted(path).into_owned(), known: self.near(path) },
                Some(place),
            ));
        };
        let given = quoted(place.given().trim()).into_owned();
        match entry.read(&full, value, &given) {
            Ok(value) => {
                self.given.insert(full, (value, place));
                Ok(())
            }
            Err(problem) => Err(BenchError::new(problem, Some(place))),
        }
    }

    /// The keys among which the one written was probably meant to be.
    fn near(&self, path: &str) -> String {
        let section = path.split('.').next().unwrap_or_default();
        let near = |entry: &&Entry| entry.path.split('.').next() == Some(section) && path.contains('.');
        let keys: Vec<&str> = self.table.iter().filter(near).map(|entry| entry.path).collect();
        if !keys.is_empty() {
            return format!("one of {}", keys.join(", "));
        }
        let mut sections: Vec<&str> = self.table.iter().filter_map(|entry| entry.path.split('.').next()).collect();
        sections.dedup();
        format!("one of the sections {}", sections.join(", "))
    }

    /// Whether anything of a section was given.
    pub fn has(&self, section: &str) -> bool {
        let inside =
            |path: &String| path.strip_prefix(section).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'));
        self.given.keys().any(inside)
    }

    /// How many tables an array of tables has.
    pub fn count(&self, list: &str) -> usize {
        let number =
            |path: &String| path.strip_prefix(list)?.strip_prefix('.')?.split('.').next()?.parse::<usize>().ok();
        self.given.keys().filter_map(number).max().map_or(0, |last| last + 1)
    }

    /// A quantity in SI, if it was given.
    pub fn get(&self, path: &str) -> Option<f64> {
        match self.given.get(path)? {
            (Value::Number(si, _), _) => Some(*si),
            (Value::Text(_) | Value::Outline(_), _) => None,
        }
    }

    /// The dimension of a quantity that may be of several.
    pub fn dimension(&self, path: &str) -> Option<Dimension> {
        match self.given.get(path)? {
            (Value::Number(_, dimension), _) => Some(*dimension),
            (Value::Text(_) | Value::Outline(_), _) => None,
        }
    }

    /// A text, if it was given.
    pub fn text(&self, path: &str) -> Option<&str> {
        match self.given.get(path)? {
            (Value::Text(text), _) => Some(text),
            (Value::Number(..) | Value::Outline(_), _) => None,
        }
    }

    /// Pairs of lengths, m.
    pub fn outline(&self, path: &str) -> &[(f64, f64)] {
        match self.given.get(path) {
            Some((Value::Outline(pairs), _)) => pairs,
            Some((Value::Number(..) | Value::Text(_), _)) | None => &[],
        }
    }

    /// A quantity that must be given, in SI.
    ///
    /// # Errors
    /// [`BenchProblem::Missing`].
    pub fn need(&self, path: &str) -> Result<f64, BenchError> {
        self.get(path).ok_or_else(|| self.missing(path))
    }

    /// That a key is missing.
    pub fn missing(&self, path: &str) -> BenchError {
        let plain: Vec<&str> = path.split('.').filter(|part| part.parse::<usize>().is_err()).collect();
        let plain = plain.join(".");
        let entry = self.table.iter().find(|entry| entry.path == plain);
        let expected = entry.map_or_else(|| "a value".to_owned(), Entry::expected);
        BenchProblem::Missing { path: path.into(), expected }.into()
    }

    /// That a value cannot be used.
    pub fn unusable(&self, path: &str, reason: impl Into<String>) -> BenchError {
        let place = self.given.get(path).map(|(_, place)| place.clone());
        BenchError::new(BenchProblem::Unusable { path: path.into(), reason: reason.into() }, place)
    }

    /// All numbers that were given, in SI, by their keys with dots.
    pub fn inputs(&self) -> BTreeMap<&str, f64> {
        self.given
            .iter()
            .filter_map(|(path, (value, _))| match value {
                Value::Number(si, _) => Some((path.as_str(), *si)),
                Value::Text(_) | Value::Outline(_) => None,
            })
            .collect()
    }
}

/// The keys of a table for people to read.
pub fn keys(table: &[Entry]) -> String {
    let mut text = String::new();
    let mut section = "";
    for entry in table {
        let (head, name) = entry.path.rsplit_once('.').unwrap_or(("", entry.path));
        if head != section {
            section = head;
            let _ = writeln!(text, "\n[{section}]"); // writing to a string does not fail
        }
        let _ = writeln!(text, "  {name:<22} {:<22} {}", entry.example, entry.doc);
    }
    text
}
