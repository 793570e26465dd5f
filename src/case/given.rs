//! A case as it was written: sparse, with the places where things stand.

use super::error::{CaseError, CaseProblem};
use super::grid::Grid;
use super::keys::{Key, ValueKind};
use super::place::{Place, Source};
use super::raw::{Raw, raw};
use super::setting::Setting;
use super::swap::{self, GivenSwap};
use super::tables::{Over, Reader};
use super::value::{choice_value, list_value, quantity_value};
use crate::quantity::Dimension;
use crate::text::{quoted, unquoted};
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;
use toml::de::DeValue;

/// The key at the top of a file under which constants are made unknown for outputs.
pub(super) const SWAP: &str = "swap";

/// What the user has given; the base case's values apply to all other keys.
#[derive(Debug, Clone, Default)]
pub struct Case {
    given: BTreeMap<Key, Given>,
    /// Constants that are found for outputs that are prescribed, in the order of the text.
    pub(super) swaps: Vec<(GivenSwap, Place)>,
}

/// Cases are equal that give the same keys the same values, and make the same constants unknown, wherever and however
/// it was written.
impl PartialEq for Case {
    fn eq(&self, other: &Self) -> bool {
        let same = |((key, given), (other_key, other)): ((&Key, &Given), (&Key, &Given))| {
            key == other_key && given.value == other.value
        };
        let values = self.given.len() == other.given.len() && self.given.iter().zip(&other.given).all(same);
        values && self.swaps().eq(other.swaps())
    }
}

/// One key that was given.
#[derive(Debug, Clone)]
pub(super) struct Given {
    pub(super) value: Value,
    pub(super) place: Place,
}

/// A checked value.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Value {
    /// In SI.
    Quantity(f64),
    /// In SI.
    List(Vec<f64>),
    /// One of the key's choices.
    Choice(&'static str),
    /// Values in SI over temperature or frequency.
    Table(Grid),
}

impl Case {
    /// The built-in base case (Table 6.1): nothing given.
    pub fn base() -> Self {
        Self::default()
    }

    /// Sets a key by its name with dots, in place of what was given for it before. The value is written as in a case
    /// file, quotes may be left out: `set("operating_point.slack_tension", "120 N")`.
    ///
    /// # Errors
    /// An unknown key, or a value that it does not take: see [`CaseProblem`]; the case is left as it was.
    pub fn set(&mut self, key: &str, value: &str) -> Result<(), CaseError> {
        self.argument("--set", format!("{key}={value}"), key.len())
    }

    /// As [`Case::set`], with the name of where it was said, which errors show.
    ///
    /// # Errors
    /// As [`Case::set`].
    pub fn set_from(&mut self, source: &str, key: &str, value: &str) -> Result<(), CaseError> {
        self.argument(source, format!("{key}={value}"), key.len())
    }

    /// Sets a key from the text `KEY=VALUE`, as [`Case::set`] does.
    ///
    /// # Errors
    /// As [`Case::set`], and [`CaseProblem::Assignment`] for a text without a key or without `=`.
    pub fn assign(&mut self, assignment: &str) -> Result<(), CaseError> {
        let equals = assignment.find('=').filter(|equals| !assignment[..*equals].trim().is_empty());
        if let Some(equals) = equals {
            return self.argument("--set", assignment.into(), equals);
        }
        let source = Arc::new(Source::new("--set", assignment));
        let (whole, text) = (0..assignment.len(), quoted(assignment).into_owned());
        let place = Place { source, key: whole.clone(), value: whole };
        Err(CaseError::new(CaseProblem::Assignment { text }, [place]))
    }

    /// Sets a quantity to a value in SI units, as [`Case::set`] does.
    ///
    /// # Errors
    /// As [`Case::set`].
    pub fn set_si(&mut self, key: Key, value: f64) -> Result<(), CaseError> {
        self.put("--set", key, &Setting::Number(value))
    }

    /// Sets a list of quantities to values in SI units, as [`Case::set`] does.
    ///
    /// # Errors
    /// As [`Case::set`].
    pub fn set_list(&mut self, key: Key, values: &[f64]) -> Result<(), CaseError> {
        self.put("--set", key, &Setting::List(values.to_vec()))
    }

    /// Sets a key to what it was decided to be, with the name of where it was, which errors show.
    ///
    /// # Errors
    /// As [`Case::set`].
    pub(crate) fn put(&mut self, source: &str, key: Key, setting: &Setting) -> Result<(), CaseError> {
        // In words: a bare number that is surely in rpm is refused.
        let unit = match key.entry().kind {
            ValueKind::Quantity { unit, .. } | ValueKind::List { unit, .. }
                if unit.scale.dimension == Dimension::ANGULAR_SPEED =>
            {
                " rad/s"
            }
            _ => "",
        };
        let text = match setting {
            Setting::Number(value) => format!("{value:e}{unit}"),
            Setting::List(values) => {
                values.iter().map(|value| format!("{value:e}{unit}")).collect::<Vec<_>>().join(", ")
            }
            Setting::Name(name) => (*name).to_owned(),
            Setting::Table(grid) => grid.to_string(),
        };
        self.set_from(source, key.path(), &text)
    }

    /// Takes a key out of the case, so that the base case's value or another key of its slot applies.
    ///
    /// # Errors
    /// [`CaseProblem::UnknownKey`].
    pub fn unset(&mut self, key: &str) -> Result<(), CaseError> {
        let source = Arc::new(Source::new("--unset", key));
        let whole = 0..key.len();
        let known = known(key, &Place { source, key: whole.clone(), value: whole })?;
        self.given.remove(&known);
        Ok(())
    }

    /// Takes a key out of the case.
    pub(super) fn remove(&mut self, key: Key) {
        self.given.remove(&key);
    }

    /// Whether the key was given.
    pub fn has(&self, key: Key) -> bool {
        self.given.contains_key(&key)
    }

    /// The keys that were given, in the order of the table.
    pub fn keys(&self) -> impl Iterator<Item = Key> + '_ {
        self.given.keys().copied()
    }

    /// Constants that are to be found for outputs, in the order in which they were given.
    pub fn swaps(&self) -> impl Iterator<Item = &GivenSwap> {
        self.swaps.iter().map(|(swap, _)| swap)
    }

    /// The keys that were given, with their values, in the order of the table.
    pub fn settings(&self) -> impl Iterator<Item = (Key, Setting)> + '_ {
        self.given.iter().map(|(key, given)| match &given.value {
            Value::Quantity(si) => (*key, Setting::Number(*si)),
            Value::List(values) => (*key, Setting::List(values.clone())),
            Value::Choice(name) => (*key, Setting::Name(name)),
            Value::Table(grid) => (*key, Setting::Table(grid.clone())),
        })
    }

    /// One `KEY=VALUE` text, with `equals` the place of its `=`.
    fn argument(&mut self, option: &str, text: String, equals: usize) -> Result<(), CaseError> {
        let value_start = (equals + 1).min(text.len());
        let (key, value) = (text.get(..equals).unwrap_or_default(), text.get(value_start..).unwrap_or_default());
        let (key, value) = (key.trim().to_owned(), unquoted(value.trim()).to_owned());
        let range = trimmed(&text, 0..equals);
        let place = Place {
            key: range,
            value: trimmed(&text, value_start..text.len()),
            source: Arc::new(Source::new(option, text)),
        };
        // Tables and arrays are written as a file has them.
        if value.starts_with(['{', '['])
            && let Ok(parsed) = DeValue::parse(&value)
        {
            let start = place.value.start;
            return self.insert_value(&key, parsed.get_ref(), place, start);
        }
        self.insert(&key, Raw::Text(value.into()), place)
    }

    /// As `insert`, for a value that may be a table; `offset` is what spans within it are short of their places.
    pub(super) fn insert_value(
        &mut self,
        path: &str,
        value: &DeValue<'_>,
        place: Place,
        offset: usize,
    ) -> Result<(), CaseError> {
        match (value, known(path, &place)) {
            (DeValue::Table(table), Ok(key)) if key.over() != Over::Nothing => {
                let grid = Reader { key, place: &place, offset }.read(table)?;
                self.given.insert(key, Given { value: Value::Table(grid), place });
                Ok(())
            }
            _ => self.insert(path, raw(value), place),
        }
    }

    /// Checks one key and its value, and keeps it.
    pub(super) fn insert(&mut self, path: &str, raw: Raw<'_>, place: Place) -> Result<(), CaseError> {
        let key = known(path, &place)?;
        let given = if place.given().is_empty() { "nothing".into() } else { quoted(place.given()) };
        let given = given.as_ref();
        let value = match key.entry().kind {
            ValueKind::Quantity { .. } => quantity_value(key, raw, given).map(Value::Quantity),
            ValueKind::List { unit, range, .. } => list_value(key, unit, range, raw, given).map(Value::List),
            ValueKind::Choice { choices, .. } => choice_value(key, choices, raw, given).map(Value::Choice),
        };
        match value {
            Ok(value) => {
                self.given.insert(key, Given { value, place });
                Ok(())
            }
            Err(problem) => Err(CaseError::new(problem, [place])),
        }
    }

    pub(super) fn given(&self, key: Key) -> Option<&Given> {
        self.given.get(&key)
    }

    /// The quantity given for `key`, in SI.
    pub(super) fn quantity(&self, key: Key) -> Option<f64> {
        match self.given(key)?.value {
            Value::Quantity(si) => Some(si),
            Value::List(_) | Value::Choice(_) | Value::Table(_) => None,
        }
    }

    /// The list given for `key`, in SI.
    pub(super) fn list(&self, key: Key) -> Option<&[f64]> {
        match &self.given(key)?.value {
            Value::List(values) => Some(values),
            Value::Quantity(_) | Value::Choice(_) | Value::Table(_) => None,
        }
    }

    /// The table given for `key`.
    pub(super) fn table(&self, key: Key) -> Option<&Grid> {
        match &self.given(key)?.value {
            Value::Table(grid) => Some(grid),
            Value::List(_) | Value::Quantity(_) | Value::Choice(_) => None,
        }
    }

    /// The name given for `key`.
    pub(super) fn choice(&self, key: Key) -> Option<&'static str> {
        match self.given(key)?.value {
            Value::Choice(name) => Some(name),
            Value::Quantity(_) | Value::List(_) | Value::Table(_) => None,
        }
    }

    /// The quantity given for `key`, or the base case's; not a number where neither exists, which no caller asks for.
    pub(super) fn value(&self, key: Key) -> f64 {
        self.quantity(key).or(key.entry().base()).unwrap_or(f64::NAN)
    }

    pub(super) fn conflict(&self, first: Key, second: Key, reason: &'static str) -> CaseError {
        CaseError::new(CaseProblem::Conflict { first, second, reason }, self.places([first, second]))
    }

    pub(super) fn missing(&self, key: Key, missing: &'static str) -> CaseError {
        CaseError::new(CaseProblem::Missing { key, given: self.written(key), missing }, self.places([key]))
    }

    /// The places of those keys that were given.
    pub(super) fn places(&self, keys: impl IntoIterator<Item = Key>) -> Vec<Place> {
        keys.into_iter().filter_map(|key| Some(self.given(key)?.place.clone())).collect()
    }

    /// The value of `key` as it was written; its default's text if it was not.
    pub(super) fn written(&self, key: Key) -> String {
        match self.given(key) {
            Some(given) => given.place.given().to_owned(),
            None => key.entry().example(),
        }
    }

    /// Makes a constant unknown and prescribes an output, from a text such as
    /// `belt.bending_stiffness for efficiency.overall = 0.96`. The constant's own key says where the search starts.
    ///
    /// # Errors
    /// [`CaseProblem::Swap`].
    pub fn swap(&mut self, text: &str) -> Result<(), CaseError> {
        let source = Arc::new(Source::new("--swap", text));
        let whole = 0..text.len();
        self.add_swap(text, Place { source, key: whole.clone(), value: whole })
    }

    pub(super) fn add_swap(&mut self, text: &str, place: Place) -> Result<(), CaseError> {
        match swap::read(text) {
            Ok(swap) => {
                self.swaps.push((swap, place));
                Ok(())
            }
            Err(reason) => Err(CaseError::new(CaseProblem::Swap { text: quoted(text).into_owned(), reason }, [place])),
        }
    }
}

fn known(path: &str, place: &Place) -> Result<Key, CaseError> {
    Key::from_path(path).ok_or_else(|| {
        let (path, nearest) = (quoted(path).into_owned(), Key::nearest(path));
        CaseError::new(CaseProblem::UnknownKey { path, nearest }, [place.clone()])
    })
}

/// The range without the blanks at its ends.
fn trimmed(text: &str, range: Range<usize>) -> Range<usize> {
    let part = text.get(range.clone()).unwrap_or_default();
    let start = range.start + (part.len() - part.trim_start().len());
    start..start + part.trim().len()
}
