//! Loss over storage modulus, tan δ: a number, or a table over frequency and temperature.

/// tan δ of a material.
#[derive(Debug, Clone, PartialEq)]
pub enum LossTangent {
    /// The same at all frequencies and temperatures.
    Constant(f64),
    /// As measured at some frequencies and temperatures.
    Table(Grid),
}

/// Values over frequency and temperature: linear in the logarithm of the frequency and in the temperature between those
/// given, and beyond them as at the nearest.
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    /// Frequencies, Hz, increasing.
    frequencies: Vec<f64>,
    /// Temperatures, K, increasing.
    temperatures: Vec<f64>,
    /// Frequency by frequency, a value for each temperature.
    values: Vec<Vec<f64>>,
}

/// Where a value lies among increasing places: the interval, the share of the way through it, and how fast that share
/// grows.
fn place(places: &[f64], at: f64) -> (usize, f64, f64) {
    let last = places.len().saturating_sub(2);
    let interval = places.iter().skip(1).take(last).filter(|place| **place <= at).count();
    let (Some(&low), Some(&high)) = (places.get(interval), places.get(interval + 1)) else { return (0, 0.0, 0.0) };
    match (at - low) / (high - low) {
        share if (0.0..=1.0).contains(&share) => (interval, share, 1.0 / (high - low)),
        share => (interval, share.clamp(0.0, 1.0), 0.0),
    }
}

impl Grid {
    /// From frequencies in Hz and temperatures in K, both increasing, and frequency by frequency a value for each
    /// temperature; `None` if these are not so many, not in order, or not finite, or if a frequency is not positive.
    pub fn new(frequencies: Vec<f64>, temperatures: Vec<f64>, values: Vec<Vec<f64>>) -> Option<Self> {
        let in_order = |places: &[f64]| {
            !places.is_empty()
                && places.windows(2).all(|pair| pair[0] < pair[1])
                && places.iter().all(|p| p.is_finite())
        };
        let full = values.len() == frequencies.len()
            && values.iter().all(|row| row.len() == temperatures.len() && row.iter().all(|value| *value >= 0.0));
        let positive = frequencies.iter().all(|frequency| *frequency > 0.0);
        let valid = in_order(&frequencies) && in_order(&temperatures) && full && positive;
        valid.then_some(Self { frequencies, temperatures, values })
    }

    /// The value at a frequency in Hz and a temperature in K, with its derivatives by both.
    pub fn at(&self, frequency: f64, temperature: f64) -> Rated {
        let logarithms: Vec<f64> = self.frequencies.iter().map(|frequency| frequency.ln()).collect();
        let (row, share, per_log) = place(&logarithms, frequency.ln());
        let (column, across, per_kelvin) = place(&self.temperatures, temperature);
        let corner = |i: usize, j: usize| {
            let row = self.values.get(i).or(self.values.last())?;
            row.get(j).or(row.last()).copied()
        };
        let corner = |i: usize, j: usize| corner(row + i, column + j).unwrap_or(f64::NAN);
        let (low, high) = ((corner(0, 0), corner(0, 1)), (corner(1, 0), corner(1, 1)));
        let at = |(cold, warm): (f64, f64)| cold + across * (warm - cold);
        Rated {
            value: at(low) + share * (at(high) - at(low)),
            by_frequency: (at(high) - at(low)) * per_log / frequency,
            by_temperature: ((low.1 - low.0) * (1.0 - share) + (high.1 - high.0) * share) * per_kelvin,
        }
    }
}

/// tan δ and its derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rated {
    /// tan δ.
    pub value: f64,
    /// Its derivative by the frequency, s.
    pub by_frequency: f64,
    /// Its derivative by the temperature, 1/K.
    pub by_temperature: f64,
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
            Self::Table(grid) => grid.values.iter().flatten().copied().fold(0.0, f64::max),
        }
    }

    /// Whether nothing is lost at any frequency and temperature.
    pub fn is_zero(&self) -> bool {
        self.largest() == 0.0
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
    }

    #[test]
    fn what_is_no_table_is_refused() {
        assert!(Grid::new(vec![10.0, 10.0], vec![300.0], vec![vec![0.1], vec![0.1]]).is_none());
        assert!(Grid::new(vec![-1.0], vec![300.0], vec![vec![0.1]]).is_none());
        assert!(Grid::new(vec![1.0], vec![300.0], vec![vec![-0.1]]).is_none());
        assert!(Grid::new(vec![1.0], vec![300.0, 310.0], vec![vec![0.1]]).is_none());
        assert!(Grid::new(vec![], vec![300.0], vec![]).is_none());
    }
}
