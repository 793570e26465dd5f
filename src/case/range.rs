//! Ranges of values.

use std::fmt;

/// One end of a range, in the unit in which the quantity is shown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RangeEnd {
    /// No bound on this side.
    None,
    /// The bound itself is not allowed.
    Open(f64),
    /// The bound itself is allowed.
    Closed(f64),
}

/// The values allowed, in the unit in which the quantity is shown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// Lower end.
    pub low: RangeEnd,
    /// Upper end.
    pub high: RangeEnd,
}

impl Range {
    /// Every finite number, whatever its sign.
    pub const ANY: Self = Self { low: RangeEnd::None, high: RangeEnd::None };

    /// Above zero.
    pub const POSITIVE: Self = Self { low: RangeEnd::Open(0.0), high: RangeEnd::None };

    /// From `low` up to `high`, both allowed.
    pub const fn within(low: f64, high: f64) -> Self {
        Self { low: RangeEnd::Closed(low), high: RangeEnd::Closed(high) }
    }

    /// From zero up to and with `high`.
    pub const fn up_to(high: f64) -> Self {
        Self { low: RangeEnd::Closed(0.0), high: RangeEnd::Closed(high) }
    }

    /// Above zero, up to and with `high`.
    pub const fn positive_to(high: f64) -> Self {
        Self { low: RangeEnd::Open(0.0), high: RangeEnd::Closed(high) }
    }

    /// Above zero and below `high`.
    pub const fn positive_below(high: f64) -> Self {
        Self { low: RangeEnd::Open(0.0), high: RangeEnd::Open(high) }
    }

    /// Whether a value in SI lies within, `to_si` taking the bounds there.
    pub fn contains(&self, si: f64, to_si: impl Fn(f64) -> f64) -> bool {
        let above = match self.low {
            RangeEnd::None => true,
            RangeEnd::Open(low) => si > to_si(low),
            RangeEnd::Closed(low) => si >= to_si(low),
        };
        let below = match self.high {
            RangeEnd::None => true,
            RangeEnd::Open(high) => si < to_si(high),
            RangeEnd::Closed(high) => si <= to_si(high),
        };
        above && below
    }

    /// The range in words, with the unit's symbol behind each bound: `above 0 deg and below 45 deg`.
    pub fn words<'a>(&'a self, unit: &'a str) -> impl fmt::Display + 'a {
        Words { range: self, unit }
    }
}

struct Words<'a> {
    range: &'a Range,
    unit: &'a str,
}

impl fmt::Display for Words<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let space = if self.unit.is_empty() { "" } else { " " };
        let mut bound = |and: &str, word: &str, value: f64| write!(f, "{and}{word} {value}{space}{}", self.unit);
        let and = match self.range.low {
            RangeEnd::None => "",
            RangeEnd::Open(low) => bound("", "above", low).map(|()| " and ")?,
            RangeEnd::Closed(low) => bound("", "from", low).map(|()| " and ")?,
        };
        match self.range.high {
            RangeEnd::None if self.range.low == RangeEnd::None => write!(f, "of either sign"),
            RangeEnd::None => Ok(()),
            RangeEnd::Open(high) => bound(and, "below", high),
            RangeEnd::Closed(high) => bound(and, "up to", high),
        }
    }
}
