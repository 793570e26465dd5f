//! Reading a drive from a file and from arguments; quantities are written as in a case file.

use super::error::{SizeError, SizeProblem};
use super::keys::{Entry, IDLER, TABLE};
use super::{BeltDrive, Idler};
use crate::case::raw::{Raw, in_order, kind, raw};
use crate::case::{Place, Source};
use crate::quantity::{self, Dimension, Quantity, QuantityError};
use crate::text::{quoted, unquoted};
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;
use toml::de::{DeTable, DeValue};

const OUTPUT_DIAMETER: &str = "output.diameter";
const INPUT_DIAMETER: &str = "input.diameter";

/// A drive as it is being put together.
#[derive(Debug, Clone)]
struct Draft {
    drive: BeltDrive,
    /// Paths of the keys that were given.
    given: Vec<&'static str>,
}

impl BeltDrive {
    /// Reads a drive: the file if there is one, then settings `KEY=VALUE` in place of its values, then idlers
    /// `INERTIA,DIAMETER` beside its idlers.
    ///
    /// # Errors
    /// See [`SizeProblem`].
    pub fn read(file: Option<&Path>, settings: &[String], idlers: &[String]) -> Result<Self, SizeError> {
        let mut draft = Draft { drive: Self::new(f64::NAN), given: Vec::new() };
        if let Some(path) = file {
            let name = path.display().to_string();
            let text = std::fs::read_to_string(path);
            let text = text.map_err(|error| {
                SizeError::new(SizeProblem::Read { path: name.clone(), reason: error.to_string() }, None)
            })?;
            draft.add_toml(&name, &text)?;
        }
        settings.iter().try_for_each(|setting| draft.assign(setting))?;
        idlers.iter().try_for_each(|idler| draft.add_idler(idler))?;
        draft.finish()
    }

    /// Reads a drive from the text of a file; `name` is shown in errors.
    ///
    /// # Errors
    /// See [`SizeProblem`].
    pub fn from_toml(name: &str, text: &str) -> Result<Self, SizeError> {
        let mut draft = Draft { drive: Self::new(f64::NAN), given: Vec::new() };
        draft.add_toml(name, text)?;
        draft.finish()
    }
}

impl Draft {
    fn finish(self) -> Result<BeltDrive, SizeError> {
        let Self { mut drive, given } = self;
        if let Some(entry) = TABLE.iter().find(|entry| entry.path == INPUT_DIAMETER && !given.contains(&entry.path)) {
            let problem = SizeProblem::Missing { path: entry.path, expected: entry.expected() };
            return Err(SizeError::new(problem, None));
        }
        if !given.contains(&OUTPUT_DIAMETER) {
            drive.output_diameter = drive.input_diameter;
        }
        Ok(drive)
    }

    fn add_toml(&mut self, name: &str, text: &str) -> Result<(), SizeError> {
        let source = Arc::new(Source::new(name, text));
        let table = DeTable::parse(text).map_err(|error| {
            let span = error.span().unwrap_or(0..0);
            let message = error.message().trim().replace('\n', ", ");
            let place = Place { source: source.clone(), key: span.clone(), value: span };
            SizeError::new(SizeProblem::Syntax { message }, Some(place))
        })?;
        for (key, value) in in_order(table.get_ref()) {
            let section = key.get_ref();
            let place = Place { source: source.clone(), key: key.span(), value: value.span() };
            let tables = match value.get_ref() {
                DeValue::Table(table) => vec![table],
                DeValue::Array(array) if section == "idler" && array.iter().all(|idler| idler.get_ref().is_table()) => {
                    array.iter().filter_map(|idler| idler.get_ref().as_table()).collect()
                }
                other if section == "idler" || TABLE.iter().any(|entry| entry.section() == section) => {
                    let (path, given) = (section.to_string(), kind(other));
                    let expected = "a table of keys".to_owned();
                    return Err(SizeError::new(SizeProblem::Type { path, given, expected }, Some(place)));
                }
                _ => return Err(unknown(section, place)),
            };
            tables.into_iter().try_for_each(|table| self.add_section(section, table, &source))?;
        }
        Ok(())
    }

    fn add_section(&mut self, section: &str, table: &DeTable<'_>, source: &Arc<Source>) -> Result<(), SizeError> {
        let mut idler = Idler { inertia: 0.0, diameter: f64::NAN };
        for (key, value) in in_order(table) {
            let path = format!("{section}.{}", key.get_ref());
            let place = Place { source: source.clone(), key: key.span(), value: value.span() };
            let raw = raw(value.get_ref());
            if section == "idler" {
                read_into(&IDLER, &mut idler, &path, raw, place)?;
            } else {
                self.given.push(read_into(&TABLE, &mut self.drive, &path, raw, place)?);
            }
        }
        if section == "idler" {
            self.push(idler, None)?;
        }
        Ok(())
    }

    fn push(&mut self, idler: Idler, place: Option<Place>) -> Result<(), SizeError> {
        if let (true, [_, entry]) = (idler.diameter.is_nan(), &IDLER) {
            return Err(SizeError::new(SizeProblem::Missing { path: entry.path, expected: entry.expected() }, place));
        }
        self.drive.idlers.push(idler);
        Ok(())
    }

    fn assign(&mut self, setting: &str) -> Result<(), SizeError> {
        let source = Arc::new(Source::new("--set", setting));
        let (whole, text) = (0..setting.len(), setting.to_owned());
        let Some((key, value)) = setting.split_once('=').filter(|(key, _)| !key.trim().is_empty()) else {
            let place = Place { source, key: whole.clone(), value: whole };
            return Err(SizeError::new(SizeProblem::Assignment { text }, Some(place)));
        };
        let place = Place { source, key: 0..key.len(), value: key.len() + 1..setting.len() };
        if IDLER.iter().any(|entry| entry.path == key.trim()) {
            let path = key.trim().to_owned();
            return Err(SizeError::new(SizeProblem::IdlerKey { path }, Some(place)));
        }
        let value = Raw::Text(unquoted(value.trim()).into());
        self.given.push(read_into(&TABLE, &mut self.drive, key.trim(), value, place)?);
        Ok(())
    }

    fn add_idler(&mut self, text: &str) -> Result<(), SizeError> {
        let source = Arc::new(Source::new("--idler", text));
        let place = |value: Range<usize>| Place { source: source.clone(), key: 0..text.len(), value };
        let Some((inertia, diameter)) = text.split_once(',') else {
            return Err(SizeError::new(
                SizeProblem::IdlerText { text: quoted(text).into_owned() },
                Some(place(0..text.len())),
            ));
        };
        let mut idler = Idler { inertia: 0.0, diameter: f64::NAN };
        let second = inertia.len() + 1..text.len();
        read_into(&IDLER, &mut idler, "idler.inertia", Raw::Text(inertia.trim().into()), place(0..inertia.len()))?;
        read_into(&IDLER, &mut idler, "idler.diameter", Raw::Text(diameter.trim().into()), place(second.clone()))?;
        self.push(idler, Some(place(second)))
    }
}

/// Reads the value of a key into its place; the key's own path.
fn read_into<T>(
    table: &'static [Entry<T>],
    to: &mut T,
    path: &str,
    raw: Raw<'_>,
    place: Place,
) -> Result<&'static str, SizeError> {
    let Some(entry) = table.iter().find(|entry| entry.path == path) else { return Err(unknown(path, place)) };
    let (given, expected) = (quoted(place.given().trim()).into_owned(), entry.expected());
    let invalid = |reason, given: &str, expected: &str| SizeProblem::Quantity {
        path: entry.path,
        given: given.into(),
        reason,
        expected: expected.into(),
    };
    let read = match raw {
        Raw::Text(text) => quantity::parse(&text).map_err(|reason| invalid(reason, &given, &expected)),
        Raw::Number(si) if si.is_finite() => Ok(Quantity { si, dimension: Dimension::NONE, bare: true }),
        Raw::Number(_) => Err(invalid(QuantityError::NotFinite, &given, &expected)),
        Raw::List(_) => Err(SizeProblem::Type { path: path.into(), given: "an array", expected: expected.clone() }),
        Raw::Other(kind) => Err(SizeProblem::Type { path: path.into(), given: kind, expected: expected.clone() }),
    };
    let si = read.and_then(|quantity| {
        quantity.expect(entry.unit.scale.dimension).map_err(|reason| invalid(reason, &given, &expected))
    });
    match si {
        Ok(si) if entry.allows(si) => {
            *(entry.field)(to) = si;
            Ok(entry.path)
        }
        Ok(_) => Err(SizeError::new(SizeProblem::OutOfRange { path: entry.path, given, expected }, Some(place))),
        Err(problem) => Err(SizeError::new(problem, Some(place))),
    }
}

fn unknown(path: &str, place: Place) -> SizeError {
    let section = path.split('.').next().unwrap_or_default();
    let all = || TABLE.iter().map(|entry| entry.path).chain(IDLER.iter().map(|entry| entry.path));
    let near: Vec<&str> = all().filter(|known| known.split('.').next() == Some(section)).collect();
    let known = if near.is_empty() { all().collect::<Vec<_>>().join(", ") } else { near.join(", ") };
    let place = Place { value: place.key.clone(), ..place };
    SizeError::new(SizeProblem::UnknownKey { path: quoted(path).into_owned(), known }, Some(place))
}
