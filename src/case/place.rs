//! Texts that users give, places in them, and errors that have such a place.

use crate::text::{printable, printable_in_place};
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

/// A text that a user gave: a file, or an argument.
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
    pub(crate) fn whole(&self) -> Range<usize> {
        self.key.start.min(self.value.start)..self.value.end.max(self.key.end)
    }
}

/// What is wrong (`P`) with the place in a file or an argument where it is said, if a text says it. Displays as one
/// line; with the feature `cli` it is a `miette::Diagnostic`, which underlines the place.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed<P>(Box<Inner<P>>);

#[derive(Debug, Clone, PartialEq)]
struct Inner<P> {
    problem: P,
    place: Option<Place>,
    advice: Option<String>,
}

impl<P> Placed<P> {
    pub(crate) fn new(problem: P, place: Option<Place>) -> Self {
        Self(Box::new(Inner { problem, place, advice: None }))
    }

    /// With advice on what to try.
    #[cfg(feature = "bench")]
    #[must_use]
    pub(crate) fn advise(mut self, advice: impl Into<String>) -> Self {
        self.0.advice = Some(advice.into());
        self
    }

    /// What is wrong.
    pub fn problem(&self) -> &P {
        &self.0.problem
    }

    /// Where, if a text says it.
    pub fn place(&self) -> Option<&Place> {
        self.0.place.as_ref()
    }

    /// What to try, if there is more to say than the message says.
    pub fn advice(&self) -> Option<&str> {
        self.0.advice.as_deref()
    }
}

impl<P> From<P> for Placed<P> {
    fn from(problem: P) -> Self {
        Self::new(problem, None)
    }
}

impl<P: fmt::Display> fmt::Display for Placed<P> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&printable(&self.problem().to_string()))
    }
}

impl<P: fmt::Debug + fmt::Display> std::error::Error for Placed<P> {}
