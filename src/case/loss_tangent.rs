//! Loss over storage modulus, tan δ: a number, or a table over frequency and temperature.

use super::grid::{Grid, Rated};

/// tan δ of a material.
#[derive(Debug, Clone, PartialEq)]
pub enum LossTangent {
    /// The same at all frequencies and temperatures.
    Constant(f64),
    /// As measured at some frequencies and temperatures.
    Table(Grid),
}

impl LossTangent {
    /// At a frequency in Hz and a temperature in K.
    pub fn at(&self, frequency: f64, temperature: f64) -> Rated {
        match self {
            Self::Constant(value) => Rated { value: *value, by_frequency: 0.0, by_temperature: 0.0 },
            Self::Table(grid) => grid.at(frequency, temperature),
        }
    }

    /// The largest of all frequencies and temperatures.
    pub fn largest(&self) -> f64 {
        match self {
            Self::Constant(value) => *value,
            Self::Table(grid) => grid.largest(),
        }
    }

    /// Whether nothing is lost at any frequency and temperature.
    pub fn is_zero(&self) -> bool {
        self.largest() == 0.0
    }
}
