//! What can be wrong with a case, and where.

use super::geometry::NoRadii;
use super::keys::Key;
use crate::model::IllPosed;
use crate::quantity::{Dimension, QuantityError};
use crate::text::{printable, printable_in_place};
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

/// A text that says something about a case: a file, or an argument.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Source {
    /// The file's name, or the option's.
    pub name: String,
    /// The whole text.
    pub text: String,
    /// The same, with nothing in it that a terminal would act on.
    shown: String,
}

/// Bytes of a line that are shown whole.
const WHOLE_LINE: usize = 400;
/// Bytes that are shown of a longer one, before and from the place that is meant.
const EXCERPT: (usize, usize) = (60, 180);

impl Source {
    /// A text with its name.
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Self {
        let text = text.into();
        Self { name: name.into(), shown: printable_in_place(&text).into_owned(), text }
    }

    /// The whole text with nothing in it that a terminal would act on, each byte in its place.
    pub fn shown_text(&self) -> &str {
        &self.shown
    }

    /// What is shown around a place: nothing else than the part of its line, if that line or one beside it is too long.
    pub fn excerpt(&self, place: usize) -> Option<Range<usize>> {
        let start = self.text.get(..place)?.rfind('\n').map_or(0, |at| at + 1);
        let end = self.text.get(place..)?.find('\n').map_or(self.text.len(), |at| place + at);
        let before = self.text.get(..start)?.lines().next_back().map_or(0, str::len);
        let after = self.text.get(end..)?.lines().nth(1).map_or(0, str::len);
        if before.max(after).max(end - start) <= WHOLE_LINE {
            return None;
        }
        let boundary = |at: usize, up: bool| {
            let mut at = at.clamp(start, end);
            while !self.text.is_char_boundary(at) {
                at = if up { at + 1 } else { at - 1 };
            }
            at
        };
        Some(boundary(place.saturating_sub(EXCERPT.0), true)..boundary(place.saturating_add(EXCERPT.1), false))
    }

    /// The part of `span` that is shown; nothing if none of it is.
    pub fn shown(&self, span: Range<usize>) -> Option<Range<usize>> {
        let Some(excerpt) = self.excerpt(span.start) else { return Some(span) };
        let (start, end) = (span.start.max(excerpt.start), span.end.min(excerpt.end));
        (start <= end).then_some(start..end)
    }
}

/// Where something was said: byte ranges in a source.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// The text.
    pub source: Arc<Source>,
    /// The key.
    pub key: Range<usize>,
    /// The value, or what is wrong if there is none.
    pub value: Range<usize>,
}

impl Place {
    /// The value as written.
    pub fn given(&self) -> &str {
        self.source.text.get(self.value.clone()).unwrap_or_default()
    }

    /// From the key to the end of the value.
    fn whole(&self) -> Range<usize> {
        self.key.start.min(self.value.start)..self.value.end.max(self.key.end)
    }
}

/// What is wrong with a case.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CaseProblem {
    /// The case file cannot be read.
    #[error("cannot read the case file `{path}`: {reason}")]
    Read {
        /// As given.
        path: String,
        /// The system's words.
        reason: String,
    },
    /// The case file is not TOML.
    #[error("this is not valid TOML: {message}")]
    Syntax {
        /// The parser's words.
        message: String,
    },
    /// A setting without `=`.
    #[error("`{text}` sets nothing: expected KEY=VALUE, such as `operating_point.slack_tension=\"120 N\"`")]
    Assignment {
        /// As given.
        text: String,
    },
    /// A key that does not exist.
    #[error("unknown key `{path}`{}", nearest.map(|key| format!(": expected a key such as \
        `{}`", key.path())).unwrap_or_default())]
    UnknownKey {
        /// As given, with dots.
        path: String,
        /// A known key that looks similar.
        nearest: Option<Key>,
    },
    /// A section that is not a table, or a value that is no number, string or name.
    #[error("`{path}` is {given}: expected {expected}")]
    Type {
        /// Key or section.
        path: String,
        /// Kind of value given.
        given: &'static str,
        /// What is expected.
        expected: String,
    },
    /// A text that is no quantity, or one with a unit of another dimension, or one that is not finite.
    #[error("`{}` = {given}: {reason}; expected {}", key.path(), key.entry().expected())]
    Quantity {
        /// The key.
        key: Key,
        /// As given.
        given: String,
        /// What is wrong with it.
        reason: QuantityError,
    },
    /// A table in place of a number that is none.
    #[error("the table `{}`: {reason}; expected {}, {expected}", key.path(), key.entry().expected())]
    Table {
        /// The key.
        key: Key,
        /// What is wrong with it.
        reason: String,
        /// What a table of this key looks like.
        expected: &'static str,
    },
    /// A quantity out of its range.
    #[error("`{}` = {given} is out of range: expected {}", key.path(), key.entry().expected())]
    OutOfRange {
        /// The key.
        key: Key,
        /// As given.
        given: String,
        /// The bare number would be in range if it had this unit.
        unit_missing: Option<&'static str>,
    },
    /// A bare number for a speed that is surely in rpm.
    #[error("`{}` = {given} is a bare number, in SI units {given} rad/s: more than any belt drive's speed; expected \
        {}", key.path(), key.entry().expected())]
    BareSpeed {
        /// The key.
        key: Key,
        /// As given.
        given: String,
    },
    /// A name that cannot be chosen.
    #[error("`{}` = {given}: expected {}", key.path(), key.entry().expected())]
    UnknownChoice {
        /// The key.
        key: Key,
        /// As given.
        given: String,
    },
    /// Two keys that cannot be given together.
    #[error("`{}` and `{}` are both given: {reason}", first.path(), second.path())]
    Conflict {
        /// The key that is named first.
        first: Key,
        /// The key that is one too many.
        second: Key,
        /// Why not both.
        reason: &'static str,
    },
    /// Something is missing that another key calls for.
    #[error("`{}` = {given}: {missing}", key.path())]
    Missing {
        /// The key that calls for it.
        key: Key,
        /// Its value.
        given: String,
        /// What is missing.
        missing: &'static str,
    },
    /// Another key is missing that a key calls for.
    #[error(
        "{} needs `{}` as well: {}; expected {}",
        told(*key, given.as_deref()), needs.path(), needs.entry().doc, needs.entry().expected()
    )]
    Needs {
        /// The key that calls for it.
        key: Key,
        /// Its value, if it was given.
        given: Option<String>,
        /// The key that is missing.
        needs: Key,
    },
    /// A part that cannot work.
    #[error("`{}`: {reason}", key.path())]
    Part {
        /// The key at fault.
        key: Key,
        /// What is wrong.
        reason: String,
    },
    /// The pulleys overlap.
    #[error(
        "the pulleys overlap: `drive.primary_radius` = {primary} m and `drive.secondary_radius` = {secondary} m; \
         expected a sum below `drive.center_distance` = {center_distance} m"
    )]
    Overlap {
        /// R_P, m.
        primary: f64,
        /// R_S, m.
        secondary: f64,
        /// L_c, m.
        center_distance: f64,
    },
    /// No radii satisfy (6.12).
    #[error("`{}` = {given}: with `belt.length` = {length} m and `drive.center_distance` = {center_distance} m \
        {reason}", key.path())]
    NoRadii {
        /// The key from which the radii follow.
        key: Key,
        /// Its value.
        given: String,
        /// L_belt, m.
        length: f64,
        /// L_c, m.
        center_distance: f64,
        /// Why not.
        reason: NoRadii,
    },
    /// A constant that is to be found for an output, not understood.
    #[error("the swap `{text}` is not understood: {reason}")]
    Swap {
        /// As given.
        text: String,
        /// What is wrong with it.
        reason: String,
    },
    /// A question that has no answer whatever the numbers.
    #[error(transparent)]
    IllPosed(IllPosed),
}

/// A key with its value, if it was given.
fn told(key: Key, given: Option<&str>) -> String {
    given.map_or_else(|| format!("`{}`", key.path()), |given| format!("`{}` = {given}", key.path()))
}

impl CaseProblem {
    /// Whether belt and pulleys do not fit: a drive with other numbers might.
    pub const fn is_of_geometry(&self) -> bool {
        matches!(self, Self::Overlap { .. } | Self::NoRadii { .. })
    }

    /// What to do about it, if there is more to say than the message says.
    fn advice(&self) -> Option<String> {
        match self {
            Self::UnknownKey { path, .. } if path == "sweep" => {
                Some("this is a study file: `sheave sweep FILE` solves it at every point".into())
            }
            Self::UnknownKey { path, .. } => Some(keys_near(path)),
            Self::BareSpeed { given, .. } => {
                Some(format!("did you mean \"{given} rpm\"? If not, write \"{given} rad/s\""))
            }
            Self::OutOfRange { given, unit_missing: Some(unit), .. } => {
                Some(format!("a bare number is in SI units; did you mean \"{given} {unit}\"?"))
            }
            Self::Quantity { reason: QuantityError::Dimension { given, expected }, .. } => pounds(*given, *expected),
            Self::Quantity { reason: QuantityError::UnknownUnit { .. }, .. } => {
                let units: Vec<_> = crate::quantity::symbols().collect();
                Some(format!("known units, SI prefixes and their products aside: {}", units.join(" ")))
            }
            _ => None,
        }
    }
}

/// Pounds of mass where pounds of force were meant.
fn pounds(given: Dimension, expected: Dimension) -> Option<String> {
    let acceleration = Dimension::new(1, 0, -2, 0);
    (given.times(acceleration, 1) == Some(expected))
        .then(|| "\"lb\" and \"kg\" are masses; a force is in \"lbf\", \"kgf\" or \"N\"".to_owned())
}

/// The keys among which the one written was probably meant to be.
fn keys_near(path: &str) -> String {
    use super::keys::{TABLE, sections};
    let section = path.rsplit_once('.').map_or(path, |(section, _)| section);
    let keys: Vec<_> = TABLE.iter().filter(|entry| entry.section() == section).collect();
    if keys.is_empty() {
        // The distance takes time with the length of both.
        let short = section.len() < 40;
        if let Some(near) = sections().find(|known| short && strsim::damerau_levenshtein(known, section) <= 2) {
            return format!("did you mean the section [{near}]?");
        }
        let sections: Vec<_> = sections().map(|section| format!("[{section}]")).collect();
        return format!("a case has the key `edition` and the sections {}", sections.join(" "));
    }
    let names: Vec<_> = keys.iter().map(|entry| entry.name()).collect();
    format!("the keys of [{section}] are {}", names.join(", "))
}

/// A [`CaseProblem`] with the places it is about.
///
/// Displays as one line that names the key, what was given and what is expected. [`CaseError::places`] says where,
/// [`CaseError::hint`] what to do about it. With the feature `cli` it is a `miette::Diagnostic`, which underlines the
/// place in the case file or the argument.
#[derive(Debug, Clone, PartialEq)]
pub struct CaseError(Box<Inner>);

#[derive(Debug, Clone, PartialEq)]
struct Inner {
    problem: CaseProblem,
    /// The first is the one at fault.
    places: Vec<Place>,
    /// What else is wrong with the same text.
    others: Vec<CaseError>,
}

/// Other mistakes of one text that are kept: more help nobody.
const MOST_OTHERS: usize = 19;

impl CaseError {
    /// A problem, the place at fault, then others that have to do with it.
    pub(crate) fn new(problem: CaseProblem, places: impl IntoIterator<Item = Place>) -> Self {
        Self(Box::new(Inner { problem, places: places.into_iter().collect(), others: Vec::new() }))
    }

    /// One error for all that is wrong with a text, the first with the others behind it; none if nothing is.
    pub(crate) fn all(errors: Vec<Self>) -> Option<Self> {
        let mut errors = errors.into_iter();
        let mut first = errors.next()?;
        first.0.others.extend(errors.take(MOST_OTHERS));
        Some(first)
    }

    /// Each mistake of the text as an error of its own, this one first.
    pub fn into_each(mut self) -> Vec<Self> {
        let others = std::mem::take(&mut self.0.others);
        [self].into_iter().chain(others).collect()
    }

    /// What else is wrong with the same text.
    pub fn others(&self) -> &[Self] {
        &self.0.others
    }

    /// A text that cannot be read.
    pub fn unreadable(name: &str, error: &std::io::Error) -> Self {
        Self::new(CaseProblem::Read { path: name.into(), reason: error.to_string() }, [])
    }

    /// What is wrong.
    pub fn problem(&self) -> &CaseProblem {
        &self.0.problem
    }

    /// Where: the place at fault, then others that have to do with it; none for what no text says.
    pub fn places(&self) -> &[Place] {
        &self.0.places
    }

    /// What to do about it, where there is more to say than the message says.
    pub fn hint(&self) -> Option<String> {
        let hint = match (&self.0.problem, self.places()) {
            (CaseProblem::Conflict { first, second, .. }, [one, other, ..]) if one.source != other.source => {
                let [one, other] = [one, other].map(|place| &place.source.name);
                Some(format!("leave out `{}` ({one}) or `{}` ({other})", first.path(), second.path()))
            }
            (CaseProblem::Conflict { first, second, .. }, _) => {
                Some(format!("leave out `{}` or `{}`", first.path(), second.path()))
            }
            (problem, _) => problem.advice(),
        };
        Some(printable(&hint?).into_owned())
    }

    /// What to underline of a place.
    pub fn span(&self, place: &Place) -> Range<usize> {
        match self.0.problem {
            CaseProblem::UnknownKey { .. } => place.key.clone(),
            CaseProblem::Conflict { .. } => place.whole(),
            _ if place.value.is_empty() => place.whole(),
            _ => place.value.clone(),
        }
    }

    /// What to write beside the underlined text of the place with this number.
    pub fn label(&self, index: usize) -> &'static str {
        match (&self.0.problem, index) {
            (CaseProblem::Syntax { .. } | CaseProblem::Assignment { .. }, _) => "here",
            (CaseProblem::UnknownKey { .. }, _) => "no such key",
            (CaseProblem::Type { .. }, _) => "wrong type",
            (CaseProblem::Table { .. }, _) => "not such a table",
            (CaseProblem::Quantity { reason, .. }, _) => match reason {
                QuantityError::NotFinite => "not finite",
                QuantityError::Dimension { .. } => "wrong dimension",
                QuantityError::UnknownUnit { .. } => "unknown unit",
                _ => "not a quantity",
            },
            (CaseProblem::OutOfRange { .. }, _) => "out of range",
            (CaseProblem::BareSpeed { .. }, _) => "rad/s",
            (CaseProblem::UnknownChoice { .. }, _) => "no such choice",
            (CaseProblem::Conflict { .. }, 0) => "this",
            (CaseProblem::Conflict { .. }, _) => "and this",
            (CaseProblem::Missing { .. }, _) => "asks for more",
            (CaseProblem::Needs { .. }, _) => "asks for more",
            (CaseProblem::Part { .. }, _) => "cannot work",
            (CaseProblem::Overlap { .. }, _) => "does not fit",
            (CaseProblem::NoRadii { .. }, 0) => "no radii exist",
            (CaseProblem::NoRadii { .. }, _) => "with this",
            (CaseProblem::Swap { .. }, _) => "here",
            (CaseProblem::IllPosed(_), _) => "with this",
            (CaseProblem::Read { .. }, _) => "cannot be read",
        }
    }
}

impl fmt::Display for CaseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&printable(&self.0.problem.to_string()))?;
        self.0.others.iter().try_for_each(|other| write!(f, "; {other}"))
    }
}

impl std::error::Error for CaseError {}
