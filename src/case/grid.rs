//! A quantity measured at some temperatures, at some frequencies, or at both.

use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};
use std::fmt;

/// Values over frequency and temperature, or over one of both.
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    /// Frequencies, Hz, increasing; none if the values are those of all frequencies.
    frequencies: Vec<f64>,
    /// Temperatures, K, increasing; none if the values are those of all temperatures.
    temperatures: Vec<f64>,
    /// A row for each frequency, in it a value for each temperature, SI; one row, or one value a row, without these.
    values: Vec<Vec<f64>>,
}

/// What is wrong with a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum GridError {
    /// Neither frequencies nor temperatures.
    #[error("a table needs `temperature`, `frequency` or both")]
    Empty,
    /// Frequencies or temperatures that do not increase, or are not positive.
    #[error("`{axis}` has to increase from above zero, and number {number} of it does not")]
    Order {
        /// Which of them.
        axis: &'static str,
        /// Counted from 1.
        number: usize,
    },
    /// Another number of rows than frequencies.
    #[error("`value` has {given} rows: expected {expected}, one for each frequency")]
    Rows {
        /// How many it has.
        given: usize,
        /// How many frequencies there are.
        expected: usize,
    },
    /// Another number of values than temperatures.
    #[error("row {row} of `value` has {given} values: expected {expected}, one for each temperature")]
    Columns {
        /// Counted from 1.
        row: usize,
        /// How many it has.
        given: usize,
        /// How many temperatures there are.
        expected: usize,
    },
    /// A value that is negative or no finite number.
    #[error("value {column} of row {row} is not a finite number from zero on")]
    Value {
        /// Counted from 1.
        row: usize,
        /// Counted from 1.
        column: usize,
    },
}

/// A value and its derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rated {
    /// The value.
    pub value: f64,
    /// Its derivative by the frequency, s.
    pub by_frequency: f64,
    /// Its derivative by the temperature, 1/K.
    pub by_temperature: f64,
}

/// Where a value lies among increasing places: the interval, and the share of the way through it; that is beyond 0 to 1
/// beyond the places.
fn place(places: &[f64], at: f64) -> (usize, f64, f64) {
    let last = places.len().saturating_sub(2);
    let interval = places.iter().skip(1).take(last).filter(|place| **place <= at).count();
    match (places.get(interval), places.get(interval + 1)) {
        (Some(&low), Some(&high)) => (interval, (at - low) / (high - low), 1.0 / (high - low)),
        _ => (0, 0.0, 0.0),
    }
}

/// As [`place`], but at the nearest of the places for a value beyond them.
fn nearest(places: &[f64], at: f64) -> (usize, f64, f64) {
    match place(places, at) {
        (interval, share, rate) if (0.0..=1.0).contains(&share) => (interval, share, rate),
        (interval, share, _) => (interval, share.clamp(0.0, 1.0), 0.0),
    }
}

impl Grid {
    /// From frequencies in Hz and temperatures in K, both increasing, and a row of values for each frequency, with a
    /// value for each temperature. Either may be empty; then there is one row, or one value a row.
    ///
    /// # Errors
    /// [`GridError`].
    pub fn new(frequencies: Vec<f64>, temperatures: Vec<f64>, values: Vec<Vec<f64>>) -> Result<Self, GridError> {
        if frequencies.is_empty() && temperatures.is_empty() {
            return Err(GridError::Empty);
        }
        for (axis, places) in [("frequency", &frequencies), ("temperature", &temperatures)] {
            let before = |at: usize| at.checked_sub(1).and_then(|at| places.get(at)).copied().unwrap_or(0.0);
            let wrong = |(at, place): &(usize, &f64)| !(place.is_finite() && **place > before(*at));
            if let Some((at, _)) = places.iter().enumerate().find(wrong) {
                return Err(GridError::Order { axis, number: at + 1 });
            }
        }
        let (rows, columns) = (frequencies.len().max(1), temperatures.len().max(1));
        if values.len() != rows {
            return Err(GridError::Rows { given: values.len(), expected: rows });
        }
        for (row, cells) in (1..).zip(&values) {
            if cells.len() != columns {
                return Err(GridError::Columns { row, given: cells.len(), expected: columns });
            }
            if let Some(at) = cells.iter().position(|value| !(value.is_finite() && *value >= 0.0)) {
                return Err(GridError::Value { row, column: at + 1 });
            }
        }
        Ok(Self { frequencies, temperatures, values })
    }

    /// The value at a frequency in Hz and a temperature in K: linear in the logarithm of the frequency and in the
    /// temperature between those given, and beyond them as at the nearest.
    pub fn at(&self, frequency: f64, temperature: f64) -> Rated {
        let logarithms: Vec<f64> = self.frequencies.iter().map(|frequency| libm::log(*frequency)).collect();
        let (row, share, per_log) = nearest(&logarithms, libm::log(frequency));
        let (column, across, per_kelvin) = nearest(&self.temperatures, temperature);
        let corner = |i: usize, j: usize| {
            let row = self.values.get(row + i).or(self.values.last())?;
            row.get(column + j).or(row.last()).copied()
        };
        let corner = |i: usize, j: usize| corner(i, j).unwrap_or(f64::NAN);
        let (low, high) = ((corner(0, 0), corner(0, 1)), (corner(1, 0), corner(1, 1)));
        let at = |(cold, warm): (f64, f64)| cold + across * (warm - cold);
        Rated {
            value: at(low) + share * (at(high) - at(low)),
            by_frequency: (at(high) - at(low)) * per_log / frequency,
            by_temperature: ((low.1 - low.0) * (1.0 - share) + (high.1 - high.0) * share) * per_kelvin,
        }
    }

    /// The natural logarithm of the value at a temperature in K, in the first row, and its derivative: linear between
    /// the temperatures given, and beyond them on along the nearest interval.
    pub fn logarithm(&self, temperature: f64) -> (f64, f64) {
        let (column, share, per_kelvin) = place(&self.temperatures, temperature);
        let row = self.values.first().map(Vec::as_slice).unwrap_or_default();
        let at = |column: usize| row.get(column).or(row.last()).map_or(f64::NAN, |value| libm::log(*value));
        let rise = at(column + 1) - at(column);
        (at(column) + share * rise, rise * per_kelvin)
    }

    /// The largest value.
    pub fn largest(&self) -> f64 {
        self.values.iter().flatten().copied().fold(0.0, f64::max)
    }

    /// The lowest and the highest temperature, K; nothing for values that are those of all temperatures.
    pub fn temperatures(&self) -> Option<(f64, f64)> {
        Some((*self.temperatures.first()?, *self.temperatures.last()?))
    }
}

/// The keys of a table in a case file.
pub(super) const KEYS: [&str; 3] = ["frequency", "temperature", "value"];

/// SI, as a case file reads it again.
impl Serialize for Grid {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let [frequency, temperature, value] = KEYS;
        let mut map = serializer.serialize_map(None)?;
        if !self.frequencies.is_empty() {
            map.serialize_entry(frequency, &self.frequencies)?;
        }
        if !self.temperatures.is_empty() {
            map.serialize_entry(temperature, &self.temperatures)?;
        }
        let flat: Vec<f64> = self.values.iter().flatten().copied().collect();
        match self.frequencies.is_empty() || self.temperatures.is_empty() {
            true => map.serialize_entry(value, &flat)?,
            false => map.serialize_entry(value, &self.values)?,
        }
        map.end()
    }
}

/// As TOML, SI.
impl fmt::Display for Grid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [frequency, temperature, value] = KEYS;
        f.write_str("{ ")?;
        if !self.frequencies.is_empty() {
            write!(f, "{frequency} = {:?}, ", self.frequencies)?;
        }
        if !self.temperatures.is_empty() {
            write!(f, "{temperature} = {:?}, ", self.temperatures)?;
        }
        let flat: Vec<f64> = self.values.iter().flatten().copied().collect();
        match self.frequencies.is_empty() || self.temperatures.is_empty() {
            true => write!(f, "{value} = {flat:?} }}"),
            false => write!(f, "{value} = {:?} }}", self.values),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_is_linear_between_its_places_and_even_beyond() {
        let values = vec![vec![0.10, 0.20], vec![0.14, 0.16]];
        let grid = Grid::new(vec![10.0, 1000.0], vec![300.0, 340.0], values).expect("a table");
        let near = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-12, "{found} and {expected}");
        near(grid.at(10.0, 300.0).value, 0.10);
        near(grid.at(100.0, 300.0).value, 0.12);
        near(grid.at(100.0, 320.0).value, 0.15);
        near(grid.at(1.0, 400.0).value, 0.20);
        near(grid.at(1e6, 0.0).value, 0.14);
        let (f, t, e) = (70.0, 311.0, 1e-4);
        let rated = grid.at(f, t);
        let by = |plus: Rated, minus: Rated| (plus.value - minus.value) / (2.0 * e);
        assert!((rated.by_frequency - by(grid.at(f + e, t), grid.at(f - e, t))).abs() < 1e-9);
        assert!((rated.by_temperature - by(grid.at(f, t + e), grid.at(f, t - e))).abs() < 1e-9);
        assert_eq!(grid.at(1.0, 400.0).by_frequency, 0.0);
        assert_eq!(grid.at(1.0, 400.0).by_temperature, 0.0);
        let one = Grid::new(vec![10.0], vec![300.0], vec![vec![0.1]]).expect("a table of one value");
        assert_eq!(one.at(55.0, 350.0), Rated { value: 0.1, by_frequency: 0.0, by_temperature: 0.0 });
        let of_temperature = Grid::new(vec![], vec![300.0, 340.0], vec![vec![0.1, 0.2]]).expect("a table");
        near(of_temperature.at(55.0, 310.0).value, 0.125);
        let of_frequency = Grid::new(vec![10.0, 1000.0], vec![], vec![vec![0.1], vec![0.2]]).expect("a table");
        near(of_frequency.at(100.0, 310.0).value, 0.15);
    }

    #[test]
    fn logarithms_are_linear_in_the_temperature_and_go_on_beyond() {
        let grid = Grid::new(vec![], vec![298.15, 333.15, 353.15], vec![vec![140.1, 90.45, 80.0]]).expect("a table");
        let near = |found: f64, expected: f64| assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
        near(grid.logarithm(298.15).0.exp(), 140.1);
        near(grid.logarithm(315.65).0.exp(), (140.1_f64 * 90.45).sqrt());
        near(grid.logarithm(263.15).0.exp(), 140.1 * 140.1 / 90.45);
        near(grid.logarithm(393.15).0.exp(), 80.0 * (80.0_f64 / 90.45).powi(2));
        for t in [250.0, 310.0, 340.0, 400.0] {
            let (_, rate) = grid.logarithm(t);
            let difference = (grid.logarithm(t + 1e-3).0 - grid.logarithm(t - 1e-3).0) / 2e-3;
            assert!((rate - difference).abs() < 1e-9, "{t}: {rate} {difference}");
        }
        let one = Grid::new(vec![], vec![300.0], vec![vec![2.0]]).expect("a table of one value");
        assert_eq!(one.logarithm(350.0), (2.0_f64.ln(), 0.0));
    }

    #[test]
    fn what_is_no_table_is_refused() {
        let wrong = |frequencies: &[f64], temperatures: &[f64], values: &[&[f64]]| {
            let values = values.iter().map(|row| row.to_vec()).collect();
            Grid::new(frequencies.into(), temperatures.into(), values).expect_err("no table").to_string()
        };
        assert!(wrong(&[10.0, 10.0], &[300.0], &[&[0.1], &[0.1]]).contains("`frequency` has to increase"));
        assert!(wrong(&[-1.0], &[300.0], &[&[0.1]]).contains("number 1"));
        assert!(wrong(&[1.0], &[300.0, f64::NAN], &[&[0.1, 0.1]]).contains("number 2"));
        assert!(wrong(&[1.0], &[300.0], &[&[-0.1]]).contains("value 1 of row 1"));
        assert!(wrong(&[1.0], &[300.0, 310.0], &[&[0.1]]).contains("has 1 values: expected 2"));
        assert!(wrong(&[1.0, 2.0], &[300.0], &[&[0.1]]).contains("has 1 rows: expected 2"));
        assert!(wrong(&[], &[], &[&[0.1]]).contains("needs"));
    }

    #[test]
    fn what_is_written_is_toml() {
        let grid = Grid::new(vec![10.0, 1e3], vec![298.15], vec![vec![0.1], vec![0.2]]).expect("a table");
        assert_eq!(grid.to_string(), "{ frequency = [10.0, 1000.0], temperature = [298.15], value = [[0.1], [0.2]] }");
        let text = serde_json::to_string(&grid).expect("numbers");
        assert_eq!(text, "{\"frequency\":[10.0,1000.0],\"temperature\":[298.15],\"value\":[[0.1],[0.2]]}");
    }
}
