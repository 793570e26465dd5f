//! One direction of the grid: a key, or several that go together, with their values.

use super::error::StudyError;
use crate::case::{Case, CaseError, Key, Setting, ValueKind};
use crate::quantity;
use crate::text::unquoted;

/// Points of a grid that is still believed to be meant.
pub const MAX_POINTS: usize = 1_000_000;

/// Points of a range whose number is not given.
pub const DEFAULT_POINTS: usize = 11;

/// Where errors say that a key or a value stands: it is called so on the command line and in a file's `[sweep]`.
pub(super) const SOURCE: &str = "over";

/// One direction of a study's grid.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    keys: Vec<Key>,
    /// One a point, each with a value for every key; point by point.
    values: Vec<Setting>,
}

impl Axis {
    /// Reads `KEY=FROM..TO[:N]` or `KEY=A,B,C`; several of these joined by `&` go together, value by value. Values are
    /// written as in a case file. One without a unit takes that of the last, if the last has one: `100..750 N`,
    /// `8,12,16 deg`. Both ends of a range are points of it; N is [`DEFAULT_POINTS`] when it is not given.
    ///
    /// # Errors
    /// What is wrong with it: see [`StudyError`].
    pub fn parse(text: &str) -> Result<Self, StudyError> {
        let mut axis: Option<Self> = None;
        for part in text.split('&') {
            let (key, values) = one(part.trim())?;
            match &mut axis {
                None => axis = Some(Self { keys: vec![key], values }),
                Some(axis) if axis.points() == values.len() => {
                    let old = axis.values.chunks(axis.keys.len()).zip(values);
                    axis.values = old.flat_map(|(point, value)| point.iter().cloned().chain([value])).collect();
                    axis.keys.push(key);
                }
                Some(axis) => {
                    let (first, second) = (axis.points(), values.len());
                    return Err(StudyError::Unlike { text: text.into(), first, second });
                }
            }
        }
        axis.ok_or_else(|| StudyError::Axis { text: text.into() })
    }

    /// The values, in SI, of a quantity.
    ///
    /// # Errors
    /// A value out of the key's range.
    pub fn of(key: Key, values: impl IntoIterator<Item = f64>) -> Result<Self, StudyError> {
        let values = values.into_iter().map(|value| {
            let setting = Setting::Number(value);
            Case::base().put(SOURCE, key, &setting)?;
            Ok(setting)
        });
        Ok(Self { keys: vec![key], values: values.collect::<Result<_, CaseError>>()? })
    }

    /// Several quantities that go together: `values` in SI, point by point, each point with one for every key.
    ///
    /// # Errors
    /// A value out of its key's range; values that are not as many for each key.
    pub fn together(keys: &[Key], values: &[f64]) -> Result<Self, StudyError> {
        if keys.is_empty() || !values.len().is_multiple_of(keys.len()) {
            let text = keys.iter().map(|key| key.path()).collect::<Vec<_>>().join(" & ");
            return Err(StudyError::Unlike { text, first: keys.len(), second: values.len() });
        }
        let values = keys.iter().cycle().zip(values).map(|(key, value)| {
            let setting = Setting::Number(*value);
            Case::base().put(SOURCE, *key, &setting)?;
            Ok(setting)
        });
        Ok(Self { keys: keys.to_vec(), values: values.collect::<Result<_, CaseError>>()? })
    }

    /// The keys that vary.
    pub fn keys(&self) -> &[Key] {
        &self.keys
    }

    /// Number of points; never zero.
    pub fn points(&self) -> usize {
        self.values.len() / self.keys.len().max(1)
    }

    /// Keys and values at a point; nothing beyond the last.
    pub fn at(&self, point: usize) -> impl Iterator<Item = (Key, Setting)> + '_ {
        let first = point.saturating_mul(self.keys.len());
        let values = self.values.get(first..).unwrap_or_default();
        self.keys.iter().copied().zip(values.iter().cloned())
    }

    /// Whether neighbours along the axis differ by numbers only.
    pub fn is_continuous(&self) -> bool {
        self.keys.iter().all(|key| matches!(key.entry().kind, ValueKind::Quantity { .. }))
    }
}

/// One key with its values.
fn one(text: &str) -> Result<(Key, Vec<Setting>), StudyError> {
    let none = || StudyError::Axis { text: text.into() };
    let (path, values) = text.split_once('=').ok_or_else(none)?;
    let (path, values) = (path.trim(), values.trim());
    if path.is_empty() || values.is_empty() {
        return Err(none());
    }
    let Some(key) = Key::from_path(path) else {
        // The case says what is wrong with it.
        Case::base().set_from(SOURCE, path, values)?;
        return Err(none());
    };
    let values = match values.split_once("..") {
        Some((from, rest)) => range(key, text, from, rest)?,
        None => list(key, values)?,
    };
    Ok((key, values))
}

/// `A,B,C`.
fn list(key: Key, text: &str) -> Result<Vec<Setting>, StudyError> {
    let texts: Vec<&str> = text.split(',').map(bare).collect();
    let ValueKind::Quantity { .. } = key.entry().kind else {
        let names = texts.iter().map(|text| {
            Case::base().set_from(SOURCE, key.path(), text)?;
            let ValueKind::Choice { choices, .. } = key.entry().kind else { return Err(StudyError::NoRange { key }) };
            let name = choices.iter().map(|choice| choice.name).find(|name| name == text);
            name.map(Setting::Name).ok_or(StudyError::NoRange { key })
        });
        return names.collect();
    };
    let unit = texts.last().map_or("", |last| unit_of(last));
    texts.iter().map(|text| Ok(Setting::Number(quantity_in(key, text, unit)?))).collect()
}

/// `FROM..TO[:N]`, with `rest` what stands behind the dots.
fn range(key: Key, text: &str, from: &str, rest: &str) -> Result<Vec<Setting>, StudyError> {
    let ValueKind::Quantity { .. } = key.entry().kind else { return Err(StudyError::NoRange { key }) };
    let (to, points) = match rest.rsplit_once(':') {
        None => (rest, DEFAULT_POINTS),
        Some((to, given)) => {
            let count = given.trim().parse().ok().filter(|count| (1..=MAX_POINTS).contains(count));
            (to, count.ok_or_else(|| StudyError::Count { text: text.into(), given: given.trim().into() })?)
        }
    };
    let (from, to) = (bare(from), bare(to));
    let unit = unit_of(to);
    let (from, to) = (quantity_in(key, from, unit)?, quantity_in(key, to, unit)?);
    let last = points.saturating_sub(1);
    let value = |point: usize| match point {
        0 => from,
        point if point == last => to,
        point => from + (to - from) * (point as f64 / last as f64),
    };
    Ok((0..points).map(|point| Setting::Number(value(point))).collect())
}

/// The value in SI, checked by the case; in `unit` if it has none of its own.
fn quantity_in(key: Key, text: &str, unit: &str) -> Result<f64, StudyError> {
    let whole = if unit_of(text).is_empty() { format!("{text}{unit}") } else { text.to_owned() };
    Case::base().set_from(SOURCE, key.path(), &whole)?;
    let read = quantity::parse(&whole).map(|quantity| quantity.si);
    read.map_err(|_| StudyError::Axis { text: format!("{}={text}", key.path()) })
}

/// What stands behind the number.
fn unit_of(text: &str) -> &str {
    /// No number is longer.
    const LONGEST: usize = 64;
    let ends = (0..=text.len().min(LONGEST)).rev().filter(|end| text.is_char_boundary(*end));
    let number = ends.into_iter().find(|end| text.get(..*end).is_some_and(|part| part.parse::<f64>().is_ok()));
    number.and_then(|end| text.get(end..)).map_or("", str::trim_end)
}

/// The text without blanks and one pair of quotes around it.
fn bare(text: &str) -> &str {
    unquoted(text.trim()).trim()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbers(text: &str) -> Vec<f64> {
        let axis = Axis::parse(text).unwrap_or_else(|error| panic!("{text}: {error}"));
        let number = |(_, setting): (Key, Setting)| match setting {
            Setting::Number(value) => value,
            other => panic!("{other:?} is no number"),
        };
        (0..axis.points()).flat_map(|point| axis.at(point).map(number).collect::<Vec<_>>()).collect()
    }

    #[test]
    fn ranges_and_lists_are_read_in_any_unit() {
        assert_eq!(numbers("drive.ratio=0.5..1.5:3"), [0.5, 1.0, 1.5]);
        assert_eq!(numbers("drive.ratio=1.5..0.5:3"), [1.5, 1.0, 0.5]);
        assert_eq!(numbers("drive.ratio=1..2:1"), [1.0]);
        assert_eq!(numbers("drive.ratio=1..2").len(), DEFAULT_POINTS);
        let tensions = [100.0, 200.0, 300.0];
        for text in ["100 N..300 N:3", "\"100 N\"..\"300 N\":3", "100..300 N:3", "100..300:3", "0.1 kN .. 300 N : 3"] {
            assert_eq!(numbers(&format!("operating_point.slack_tension={text}")), tensions, "{text}");
        }
        assert_eq!(numbers("operating_point.slack_tension= 100, 200 ,300 N"), tensions);
        assert_eq!(numbers("operating_point.slack_tension='100 N',0.2 kN,300"), tensions);
        assert_eq!(numbers("belt.length=800 mm,0.9 m&drive.center_distance=200,210 mm"), [0.8, 0.2, 0.9, 0.21]);
        assert_eq!(numbers("sheave.slip_threshold=1e-4..1e-3 m/s:2"), [1e-4, 1e-3]);
    }

    #[test]
    fn names_are_listed() {
        let axis = Axis::parse("edition=thesis,\"published\"").unwrap();
        assert_eq!(axis.at(1).collect::<Vec<_>>(), [(Key::Edition, Setting::Name("published"))]);
        assert!(!axis.is_continuous());
    }

    #[test]
    fn what_is_wrong_is_said() {
        let said = |text: &str| Axis::parse(text).map(|_| ()).unwrap_err().to_string();
        for text in ["", "drive.ratio", "=1,2", "drive.ratio="] {
            assert!(said(text).contains("KEY=FROM..TO"), "{text}");
        }
        assert!(said("drive.ration=1,2").contains("drive.ratio"));
        assert!(said("edition=thesis..published").contains("no ranges"));
        assert!(said("edition=thesi").contains("consistent"));
        for count in ["0", "-1", "2.5", "", "x", "1000000000000"] {
            assert!(said(&format!("drive.ratio=1..2:{count}")).contains("number of points"), "{count}");
        }
        assert!(said("drive.ratio=1..nan").contains("not a finite number"));
        assert!(said("drive.ratio=1,,2").contains("does not begin with a number"));
        assert!(said("belt.length=1 kg..2 kg").contains("a length"));
        assert!(said("sheave.half_angle=8..50 deg:2").contains("below 45 deg"));
        assert!(said("belt.length=1,2&drive.center_distance=0.2").contains("as many values"));
    }
}
