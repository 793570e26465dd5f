//! A case as it was written: sparse, with the places where things stand.

use super::error::{CaseError, CaseProblem};
use super::grid::Grid;
use super::keys::{Key, ValueKind};
use super::place::{Place, Source};
use super::raw::{Raw, in_order, kind, raw};
use super::resolve::Setting;
use super::swap::{self, GivenSwap};
use super::tables::{Over, Reader};
use crate::model::Choice;
use crate::quantity::{self, Quantity, QuantityError};
use crate::text::quoted;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A bare number above this is a speed in rpm, not in rad/s: 2000 rad/s are 19,100 rpm.
const FASTEST_BARE: f64 = 2000.0;

/// The key at the top of a file under which constants are made unknown for outputs.
pub(super) const SWAP: &str = "swap";

/// The key of a section under which a file with that section's keys is named.
const PART: &str = "file";

/// What the user has given; the base case's values apply to all other keys.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Case {
    given: BTreeMap<Key, Given>,
    /// Constants that are found for outputs that are prescribed, in the order of the text.
    pub(super) swaps: Vec<(GivenSwap, Place)>,
}

/// One key that was given.
#[derive(Debug, Clone, PartialEq)]
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

/// A text that is being read.
struct TextReader<'a> {
    source: &'a Arc<Source>,
    /// Where files of parts are looked for; empty within a part, which names no others.
    folder: &'a Path,
}

impl TextReader<'_> {
    fn place(&self, key: &Spanned<Cow<'_, str>>, value: &Spanned<DeValue<'_>>) -> Place {
        Place { source: self.source.clone(), key: key.span(), value: value.span() }
    }

    fn within_part(&self) -> bool {
        self.folder.as_os_str().is_empty()
    }
}

/// The folder of a file, in which the parts that it names are looked for; the present one for a text without a file.
fn folder_of(name: &str) -> PathBuf {
    let parent = Path::new(name).parent().filter(|parent| !parent.as_os_str().is_empty());
    parent.unwrap_or(Path::new(".")).to_owned()
}

/// Whether a name is that of a section, or of one that has sections within it.
fn is_section(name: &str) -> bool {
    let within =
        |section: &str| section.strip_prefix(name).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'));
    !name.is_empty() && super::keys::sections().any(within)
}

fn syntax(source: &Arc<Source>, error: &toml::de::Error) -> CaseError {
    let span = error.span().unwrap_or(0..0);
    let message = error.message().trim().replace('\n', ", ");
    CaseError::new(CaseProblem::Syntax { message }, [Place { source: source.clone(), key: span.clone(), value: span }])
}

impl Case {
    /// The built-in base case (Table 6.1): nothing given.
    pub fn base() -> Self {
        Self::default()
    }

    /// Reads a case file.
    ///
    /// # Errors
    /// [`CaseProblem::Read`] if the file cannot be read, else as [`Case::from_toml`].
    pub fn read(path: &Path) -> Result<Self, CaseError> {
        let name = path.display().to_string();
        match std::fs::read_to_string(path) {
            Ok(text) => Self::from_toml(&name, &text),
            Err(error) => Err(CaseError::unreadable(&name, &error)),
        }
    }

    /// Reads a case from the text of a case file; `name` is shown in errors.
    ///
    /// # Errors
    /// Everything that is wrong as far as one key alone is concerned, in the order of the text: see [`CaseProblem`] and
    /// [`CaseError::others`].
    pub fn from_toml(name: &str, text: &str) -> Result<Self, CaseError> {
        Self::from_text(name, text, &folder_of(name))
    }

    /// As [`Case::from_toml`], for a text that is not trusted with this computer's files: it names no parts in files of
    /// their own.
    ///
    /// # Errors
    /// As [`Case::from_toml`]; [`CaseProblem::UnknownKey`] for a key `file`.
    pub fn from_toml_alone(name: &str, text: &str) -> Result<Self, CaseError> {
        Self::from_text(name, text, Path::new(""))
    }

    fn from_text(name: &str, text: &str, folder: &Path) -> Result<Self, CaseError> {
        let mut case = Self::base();
        // What some editors put at the front of a file.
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let source = Arc::new(Source::new(name, text));
        let table = DeTable::parse(text).map_err(|error| syntax(&source, &error))?;
        let mut errors = Vec::new();
        let reader = TextReader { source: &source, folder };
        for (key, value) in in_order(table.get_ref()) {
            case.read_top(&reader, key, value, &mut errors);
        }
        CaseError::all(errors).map_or(Ok(case), Err)
    }

    /// A key at the top of a file: `edition`, or a section with its keys.
    fn read_top(
        &mut self,
        reader: &TextReader<'_>,
        key: &Spanned<Cow<'_, str>>,
        value: &Spanned<DeValue<'_>>,
        errors: &mut Vec<CaseError>,
    ) {
        let name = key.get_ref();
        let place = reader.place(key, value);
        if name == SWAP {
            errors.extend(self.read_swaps(reader.source, value, place).err());
            return;
        }
        if !is_section(name) {
            errors.extend(self.insert(name, raw(value.get_ref()), place).err());
            return;
        }
        let DeValue::Table(table) = value.get_ref() else {
            let (path, given) = (name.to_string(), kind(value.get_ref()));
            errors.push(CaseError::new(CaseProblem::Type { path, given, expected: "a table of keys".into() }, [place]));
            return;
        };
        self.read_section(reader, name, table, errors);
    }

    /// The keys of a section, and the sections within it; first those of the part that its key `file` names, so that
    /// what stands in the case itself takes their place.
    fn read_section(
        &mut self,
        reader: &TextReader<'_>,
        section: &str,
        table: &DeTable<'_>,
        errors: &mut Vec<CaseError>,
    ) {
        let entries = in_order(table);
        let is_file = |key: &Spanned<Cow<'_, str>>| key.get_ref() == PART;
        for (key, value) in entries.iter().filter(|(key, _)| is_file(key)) {
            self.read_part(reader, section, key, value, errors);
        }
        for (key, value) in entries.into_iter().filter(|(key, _)| !is_file(key)) {
            let path = format!("{section}.{}", key.get_ref());
            match value.get_ref() {
                DeValue::Table(table) if is_section(&path) => self.read_section(reader, &path, table, errors),
                _ => errors.extend(self.insert_value(&path, value.get_ref(), reader.place(key, value), 0).err()),
            }
        }
    }

    /// A part in a file of its own: the keys of the section that names it.
    fn read_part(
        &mut self,
        reader: &TextReader<'_>,
        section: &str,
        key: &Spanned<Cow<'_, str>>,
        value: &Spanned<DeValue<'_>>,
        errors: &mut Vec<CaseError>,
    ) {
        let place = reader.place(key, value);
        let DeValue::String(file) = value.get_ref() else {
            let (path, given) = (format!("{section}.{PART}"), kind(value.get_ref()));
            let expected = "the name of a file with the keys of this section, such as \"parts/spring.toml\"".to_owned();
            errors.push(CaseError::new(CaseProblem::Type { path, given, expected }, [place]));
            return;
        };
        if reader.within_part() {
            let (path, nearest) = (format!("{section}.{PART}"), None);
            errors.push(CaseError::new(CaseProblem::UnknownKey { path, nearest }, [place]));
            return;
        }
        let path = reader.folder.join(file.as_ref());
        let name = path.display().to_string();
        let text = match std::fs::read_to_string(&path) {
            Ok(text) => text,
            Err(error) => {
                errors.push(CaseError::new(CaseProblem::Read { path: name, reason: error.to_string() }, [place]));
                return;
            }
        };
        let text = text.strip_prefix('\u{feff}').unwrap_or(&text);
        let source = Arc::new(Source::new(name, text));
        match DeTable::parse(text) {
            Ok(table) => {
                let part = TextReader { source: &source, folder: Path::new("") };
                self.read_section(&part, section, table.get_ref(), errors);
            }
            Err(error) => errors.push(syntax(&source, &error)),
        }
    }

    /// The key `swap`: a list of texts.
    fn read_swaps(
        &mut self,
        source: &Arc<Source>,
        value: &Spanned<DeValue<'_>>,
        place: Place,
    ) -> Result<(), CaseError> {
        let wrong = |given, place| {
            let expected = "a list of texts, such as [\"belt.bending_stiffness for efficiency.overall = 0.96\"]".into();
            CaseError::new(CaseProblem::Type { path: SWAP.into(), given, expected }, [place])
        };
        let DeValue::Array(items) = value.get_ref() else { return Err(wrong(kind(value.get_ref()), place)) };
        for item in items.iter() {
            let place = Place { source: source.clone(), key: item.span(), value: item.span() };
            let DeValue::String(text) = item.get_ref() else { return Err(wrong(kind(item.get_ref()), place)) };
            self.add_swap(text, place)?;
        }
        Ok(())
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
        // In words: a bare number that is surely in rpm is refused.
        let unit = match key.entry().kind {
            ValueKind::Quantity { unit, .. } if unit.scale.dimension == quantity::Dimension::ANGULAR_SPEED => " rad/s",
            _ => "",
        };
        self.set(key.path(), &format!("{value:e}{unit}"))
    }

    /// Sets a list of quantities to values in SI units, as [`Case::set`] does.
    ///
    /// # Errors
    /// As [`Case::set`].
    pub fn set_list(&mut self, key: Key, values: &[f64]) -> Result<(), CaseError> {
        let unit = match key.entry().kind {
            ValueKind::List { unit, .. } if unit.scale.dimension == quantity::Dimension::ANGULAR_SPEED => " rad/s",
            _ => "",
        };
        let texts: Vec<String> = values.iter().map(|value| format!("{value:e}{unit}")).collect();
        self.set(key.path(), &texts.join(", "))
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
        // A table is written as a file has it.
        if value.starts_with('{')
            && let Ok(table) = DeValue::parse(&value)
        {
            let start = place.value.start;
            return self.insert_value(&key, table.get_ref(), place, start);
        }
        self.insert(&key, Raw::Text(value.into()), place)
    }

    /// As `insert`, for a value that may be a table; `offset` is what spans within it are short of their places.
    fn insert_value(&mut self, path: &str, value: &DeValue<'_>, place: Place, offset: usize) -> Result<(), CaseError> {
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
    fn insert(&mut self, path: &str, raw: Raw<'_>, place: Place) -> Result<(), CaseError> {
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

pub(super) fn quantity_value(key: Key, raw: Raw<'_>, given: &str) -> Result<f64, CaseProblem> {
    let entry = key.entry();
    let ValueKind::Quantity { unit, range, .. } = entry.kind else {
        return Err(CaseProblem::Type { path: entry.path.into(), given: "a quantity", expected: entry.expected() });
    };
    let invalid = |reason| CaseProblem::Quantity { key, given: given.into(), reason };
    let quantity = match raw {
        Raw::Text(text) => quantity::parse(&text).map_err(invalid)?,
        Raw::Number(si) if si.is_finite() => Quantity { si, dimension: quantity::Dimension::NONE, bare: true },
        Raw::Number(_) => return Err(invalid(QuantityError::NotFinite)),
        Raw::List(_) => {
            return Err(CaseProblem::Type { path: entry.path.into(), given: "an array", expected: entry.expected() });
        }
        Raw::Other(given) => {
            return Err(CaseProblem::Type { path: entry.path.into(), given, expected: entry.expected() });
        }
    };
    let si = quantity.expect(unit.scale.dimension).map_err(invalid)?;
    let allowed = |si| range.contains(si, |bound| unit.to_si(bound));
    let rpm = unit.scale.dimension == quantity::Dimension::ANGULAR_SPEED;
    if rpm && quantity.bare && si.abs() > FASTEST_BARE && allowed(unit.to_si(si)) {
        return Err(CaseProblem::BareSpeed { key, given: given.into() });
    }
    if allowed(si) {
        return Ok(si);
    }
    let unit_missing = (quantity.bare && allowed(unit.to_si(si))).then_some(unit.symbol);
    Err(CaseProblem::OutOfRange { key, given: given.into(), unit_missing })
}

/// Most numbers of a list: no measured curve needs more.
const LONGEST_LIST: usize = 10_000;

fn list_value(
    key: Key,
    unit: quantity::Unit,
    range: super::range::Range,
    raw: Raw<'_>,
    given: &str,
) -> Result<Vec<f64>, CaseProblem> {
    let entry = key.entry();
    let invalid = |reason| CaseProblem::Quantity { key, given: given.into(), reason };
    let values = match raw {
        Raw::Text(text) => quantity::parse_list(&text, unit.scale.dimension).map_err(invalid)?,
        Raw::List(items) if items.len() <= LONGEST_LIST => {
            let one = |item: Raw<'_>| match item {
                Raw::Text(text) => {
                    quantity::parse(&text).and_then(|quantity| quantity.expect(unit.scale.dimension)).map_err(invalid)
                }
                Raw::Number(si) if si.is_finite() => Ok(si),
                Raw::Number(_) => Err(invalid(QuantityError::NotFinite)),
                Raw::List(_) => Err(wrong(entry, "an array of arrays")),
                Raw::Other(given) => Err(wrong(entry, given)),
            };
            items.into_iter().map(one).collect::<Result<_, _>>()?
        }
        Raw::List(_) => return Err(wrong(entry, "a list of more than 10,000 numbers")),
        Raw::Number(_) => return Err(wrong(entry, "a number")),
        Raw::Other(given) => return Err(wrong(entry, given)),
    };
    if !values.iter().all(|si| range.contains(*si, |bound| unit.to_si(bound))) {
        return Err(CaseProblem::OutOfRange { key, given: given.into(), unit_missing: None });
    }
    Ok(values)
}

fn wrong(entry: &super::keys::Entry, given: &'static str) -> CaseProblem {
    CaseProblem::Type { path: entry.path.into(), given, expected: entry.expected() }
}

fn choice_value(key: Key, choices: &[Choice], raw: Raw<'_>, given: &str) -> Result<&'static str, CaseProblem> {
    let entry = key.entry();
    match raw {
        Raw::Text(text) => choices
            .iter()
            .find(|choice| choice.name == text)
            .map(|choice| choice.name)
            .ok_or_else(|| CaseProblem::UnknownChoice { key, given: given.into() }),
        Raw::Number(_) => {
            Err(CaseProblem::Type { path: entry.path.into(), given: "a number", expected: entry.expected() })
        }
        Raw::List(_) => {
            Err(CaseProblem::Type { path: entry.path.into(), given: "an array", expected: entry.expected() })
        }
        Raw::Other(given) => Err(CaseProblem::Type { path: entry.path.into(), given, expected: entry.expected() }),
    }
}

/// The text without one pair of quotes around it.
pub(super) fn unquoted(text: &str) -> &str {
    let inside = |quote| text.strip_prefix(quote)?.strip_suffix(quote);
    inside('"').or_else(|| inside('\'')).unwrap_or(text)
}

/// The range without the blanks at its ends.
fn trimmed(text: &str, range: Range<usize>) -> Range<usize> {
    let part = text.get(range.clone()).unwrap_or_default();
    let start = range.start + (part.len() - part.trim_start().len());
    start..start + part.trim().len()
}
