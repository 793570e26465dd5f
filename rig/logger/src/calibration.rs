//! From the converter's value to the torque at the secondary: a straight line fitted to known loads (thesis, (9.1)).

use serde::{Deserialize, Serialize};

/// ADC = slope · T + intercept.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Calibration {
    /// Counts for each N·m at the secondary.
    pub slope: f64,
    /// Counts at no torque.
    pub intercept: f64,
    /// Coefficient of determination of the fit.
    pub r_squared: f64,
    /// Half of the 95 % confidence interval of the slope, counts for each N·m; NaN where fewer than three values were
    /// fitted.
    pub slope_interval: f64,
    /// Half of the 95 % confidence interval of the intercept, counts.
    pub intercept_interval: f64,
}

/// Why a calibration cannot be made.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum CalibrationError {
    /// Too little to fit a line to.
    #[error("a calibration needs readings at two different loads at least; {loads} were given: add another weight")]
    TooFewLoads {
        /// Different loads given.
        loads: usize,
    },
    /// The converter gives the same value whatever the load.
    #[error("the converter's value does not change with the load: check bridge, amplifier and slip ring")]
    NoResponse,
}

impl Calibration {
    /// The calibration of the thesis, (9.1); the intervals were not published.
    pub const THESIS: Self = Self {
        slope: 108.19,
        intercept: 35_145.0,
        r_squared: 0.9997,
        slope_interval: f64::NAN,
        intercept_interval: f64::NAN,
    };

    /// Least squares over pairs of torque at the secondary (N·m) and converter value.
    ///
    /// # Errors
    /// If the loads do not differ, or the values do not.
    pub fn fit(readings: &[(f64, u16)]) -> Result<Self, CalibrationError> {
        let mut loads: Vec<f64> = readings.iter().map(|reading| reading.0).filter(|load| load.is_finite()).collect();
        loads.sort_by(f64::total_cmp);
        loads.dedup();
        if loads.len() < 2 {
            return Err(CalibrationError::TooFewLoads { loads: loads.len() });
        }
        let finite =
            || readings.iter().filter(|(load, _)| load.is_finite()).map(|(load, value)| (*load, f64::from(*value)));
        let count = finite().count() as f64;
        let (mean_load, mean_value) =
            (finite().map(|r| r.0).sum::<f64>() / count, finite().map(|r| r.1).sum::<f64>() / count);
        let xx: f64 = finite().map(|(x, _)| (x - mean_load).powi(2)).sum();
        let xy: f64 = finite().map(|(x, y)| (x - mean_load) * (y - mean_value)).sum();
        let yy: f64 = finite().map(|(_, y)| (y - mean_value).powi(2)).sum();
        let slope = xy / xx;
        if yy == 0.0 || slope == 0.0 {
            return Err(CalibrationError::NoResponse);
        }
        let intercept = mean_value - slope * mean_load;
        let residual = (yy - slope * xy).max(0.0);
        // Hundreds of readings: Student's t is the normal distribution's 1.96.
        let spread = if count > 2.0 { 1.96 * (residual / (count - 2.0)).sqrt() } else { f64::NAN };
        Ok(Self {
            slope,
            intercept,
            r_squared: 1.0 - residual / yy,
            slope_interval: spread / xx.sqrt(),
            intercept_interval: spread * (1.0 / count + mean_load * mean_load / xx).sqrt(),
        })
    }

    /// Torque at the secondary, N·m, for a converter value.
    #[must_use]
    pub fn torque(&self, value: u16) -> f64 {
        (f64::from(value) - self.intercept) / self.slope
    }
}

/// Reads the last row of a file such as the thesis's `cal_values.csv`: slope, intercept, R², and, where this program
/// wrote it, half of the intervals of slope and intercept.
#[must_use]
pub fn last_of_csv(text: &str) -> Option<Calibration> {
    let row = text.lines().rev().find(|line| !line.trim().is_empty())?;
    let mut numbers = row.split(',').map(|field| field.trim().parse::<f64>().ok().filter(|value| value.is_finite()));
    let (slope, intercept, r_squared) = (numbers.next()??, numbers.next()??, numbers.next()??);
    let (slope_interval, intercept_interval) = match (numbers.next().flatten(), numbers.next().flatten()) {
        (Some(slope), Some(intercept)) => (slope, intercept),
        _ => (f64::NAN, f64::NAN),
    };
    (slope != 0.0).then_some(Calibration { slope, intercept, r_squared, slope_interval, intercept_interval })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_known_line_is_found_with_an_interval_that_holds_it() {
        let readings: Vec<(f64, u16)> = (0..2000)
            .map(|place| {
                let load = f64::from(place / 500) * 10.0;
                let noise = f64::from(place * 7919 % 101 - 50);
                (load, (108.19 * load + 35_145.0 + noise).round() as u16)
            })
            .collect();
        let fit = Calibration::fit(&readings).unwrap();
        assert!((fit.slope - 108.19).abs() < fit.slope_interval, "{fit:?}");
        assert!((fit.intercept - 35_145.0).abs() < fit.intercept_interval, "{fit:?}");
        assert!(fit.r_squared > 0.999 && fit.slope_interval < 0.2);
        assert!((fit.torque(36_227) - 10.0).abs() < 0.05);
    }

    #[test]
    fn what_cannot_be_fitted_says_why() {
        assert_eq!(Calibration::fit(&[(5.0, 3), (5.0, 4)]), Err(CalibrationError::TooFewLoads { loads: 1 }));
        assert_eq!(Calibration::fit(&[(5.0, 3), (6.0, 3)]), Err(CalibrationError::NoResponse));
        assert_eq!(last_of_csv("1,2\nnan,3,1\n"), None);
        let last = last_of_csv("1,2,3\n108.188097293,35144.7019735,0.999727300946\n\n").unwrap();
        assert!((last.slope - 108.188_097_293).abs() < 1e-12);
    }
}
