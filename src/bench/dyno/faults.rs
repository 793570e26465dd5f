//! What was wrong with rows of a log, counted and named.

use serde::Serialize;
use std::fmt;

/// What can be wrong with a row, or had to be done about it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Fault {
    /// A line longer than any row.
    TooLong,
    /// Bytes that are no text.
    NotText,
    /// A row with fewer columns than the header or the format has.
    TooShort,
    /// A row with more cells than the header or the format has columns.
    TooWide,
    /// A cell that is no finite number.
    NotNumber,
    /// Time and values of the row before: the logger asked faster than the sensor answered.
    Duplicate,
    /// The time of the row before with other values.
    Contradiction,
    /// A time that neither the row before nor the row behind is near.
    OutOfSequence,
    /// A value that the sensor cannot have measured: a dropout, a rail.
    OutOfRange,
    /// A value far from its neighbours: an error of the transmission.
    Outlier,
    /// The rest of a file that could not be read.
    BrokenOff,
}

impl Fault {
    /// All of them.
    pub const ALL: [Self; 11] = [
        Self::TooLong,
        Self::NotText,
        Self::TooShort,
        Self::TooWide,
        Self::NotNumber,
        Self::Duplicate,
        Self::Contradiction,
        Self::OutOfSequence,
        Self::OutOfRange,
        Self::Outlier,
        Self::BrokenOff,
    ];

    /// In words, in the plural.
    pub fn words(self) -> &'static str {
        match self {
            Self::TooLong => "lines longer than any row",
            Self::NotText => "rows with bytes that are no text",
            Self::TooShort => "rows with too few columns",
            Self::TooWide => "rows with more cells than columns (numbers have decimal points, not commas)",
            Self::NotNumber => "cells that are no finite number",
            Self::Duplicate => "repetitions of the row before",
            Self::Contradiction => "rows with the time of the row before and other values",
            Self::OutOfSequence => "times out of sequence",
            Self::OutOfRange => "values out of the sensor's range",
            Self::Outlier => "outliers among their neighbours",
            Self::BrokenOff => "files broken off",
        }
    }
}

/// One kind of fault: how often, and where first.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Count {
    /// What.
    pub fault: Fault,
    /// How often.
    pub count: u64,
    /// Line of the first, counted from 1.
    pub first_line: u64,
}

/// The faults of one file.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(transparent)]
pub struct Faults {
    counts: Vec<Count>,
}

impl Faults {
    /// Counts one.
    pub fn add(&mut self, fault: Fault, line: u64) {
        match self.counts.iter_mut().find(|count| count.fault == fault) {
            Some(count) => count.count += 1,
            None => self.counts.push(Count { fault, count: 1, first_line: line }),
        }
    }

    /// How often a fault occurred.
    pub fn count(&self, fault: Fault) -> u64 {
        self.counts.iter().find(|count| count.fault == fault).map_or(0, |count| count.count)
    }

    /// Those that occurred.
    pub fn all(&self) -> &[Count] {
        &self.counts
    }

    /// All together.
    pub fn total(&self) -> u64 {
        self.counts.iter().map(|count| count.count).sum()
    }
}

impl fmt::Display for Faults {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (at, count) in self.counts.iter().enumerate() {
            let comma = if at == 0 { "" } else { ", " };
            write!(f, "{comma}{} {} (first in line {})", count.count, count.fault.words(), count.first_line)?;
        }
        Ok(())
    }
}
