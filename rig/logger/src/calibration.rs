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

/// What to do where the converter's value hardly follows the load, or not at all.
const NO_RESPONSE: &str = "check bridge, amplifier and slip ring, or hang heavier weights";

/// Why a calibration cannot be made.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum CalibrationError {
    /// Too little to fit a line to.
    #[error("a calibration needs readings at two different loads at least; {loads} were given: add another weight")]
    TooFewLoads {
        /// Different loads given.
        loads: usize,
    },
    /// The converter gives the same value whatever the load.
    #[error("the converter's value does not change with the load: {NO_RESPONSE}")]
    NoResponse,
    /// What the value changes by with the load is not told from its noise.
    #[error(
        "the slope is {slope:.3} ± {interval:.3} counts for each N·m (95 % interval), which may as well be none: the \
         converter's value does not follow the load beyond its noise: {NO_RESPONSE}"
    )]
    Uncertain {
        /// Counts for each N·m.
        slope: f64,
        /// Half of its 95 % interval.
        interval: f64,
    },
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
    /// If the loads do not differ, the values do not, or the 95 % interval of the slope holds zero.
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
        let slope_interval = spread / xx.sqrt();
        if may_be_none(slope, slope_interval) {
            return Err(CalibrationError::Uncertain { slope, interval: slope_interval });
        }
        Ok(Self {
            slope,
            intercept,
            r_squared: 1.0 - residual / yy,
            slope_interval,
            intercept_interval: spread * (1.0 / count + mean_load * mean_load / xx).sqrt(),
        })
    }

    /// Torque at the secondary, N·m, for a converter value.
    #[must_use]
    pub fn torque(&self, value: u16) -> f64 {
        self.torque_at(f64::from(value))
    }

    /// Torque at the secondary, N·m, for a converter value or a mean of several.
    #[must_use]
    pub fn torque_at(&self, value: f64) -> f64 {
        (value - self.intercept) / self.slope
    }
}

/// Whether the interval of a slope holds zero; one that is not known, NaN, does not.
fn may_be_none(slope: f64, interval: f64) -> bool {
    interval >= slope.abs()
}

/// Why a file's last row is no calibration.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum RowError {
    /// There is no row.
    #[error("a row slope,intercept,R² was expected, and no row is there")]
    NoRow,
    /// Fields are missing or left over.
    #[error(
        "the last row, '{given}', has {fields} fields; three were expected (slope,intercept,R²), or the six of this \
         program (with half of both intervals and a time): it is cut off, or two rows stand on one line"
    )]
    Fields {
        /// The row.
        given: String,
        /// Its fields.
        fields: usize,
    },
    /// The row has fewer digits or fields than were written, for all that can be known.
    #[error(
        "the last row, '{given}', has three fields and no line end: its last field may be cut off; end the line if it \
         is whole"
    )]
    NoLineEnd {
        /// The row.
        given: String,
    },
    /// The slope is not told from none.
    #[error(
        "the last row, '{given}': the slope's 95 % interval holds zero, so that the converter's value did not follow \
         the load beyond its noise: {NO_RESPONSE}, and calibrate again"
    )]
    Uncertain {
        /// The row.
        given: String,
    },
    /// A field cannot be what it stands for.
    #[error("the last row, '{given}': {what} was expected, '{field}' was found")]
    Field {
        /// The row.
        given: String,
        /// What was expected.
        what: &'static str,
        /// What stands there.
        field: String,
    },
}

/// Reads the last row of a file such as the thesis's `cal_values.csv`: slope, intercept, R², and, where this program
/// wrote it, half of the intervals of slope and intercept and the time in seconds since 1970.
///
/// # Errors
/// If that row is not whole, its numbers are those of no line, or its interval says that the slope may be none.
pub fn last_of_csv(text: &str) -> Result<Calibration, RowError> {
    let last = text.split_inclusive('\n').rev().find(|line| !line.trim().is_empty()).ok_or(RowError::NoRow)?;
    let given = || last.trim().to_owned();
    let fields: Vec<&str> = last.split(',').map(str::trim).collect();
    let (line, intervals) = match *fields.as_slice() {
        [slope, intercept, r_squared] => ([slope, intercept, r_squared], None),
        [slope, intercept, r_squared, of_slope, of_intercept, seconds] => {
            ([slope, intercept, r_squared], Some([of_slope, of_intercept, seconds]))
        }
        _ => return Err(RowError::Fields { given: given(), fields: fields.len() }),
    };
    let number = |field: &str, what: &'static str, holds: fn(f64) -> bool| {
        let wrong = || RowError::Field { given: given(), what, field: field.to_owned() };
        field.parse::<f64>().ok().filter(|value| holds(*value)).ok_or_else(wrong)
    };
    let [slope, intercept, r_squared] = line;
    let slope = number(slope, "a slope that is a number and not zero", |value| value.is_finite() && value != 0.0)?;
    let intercept = number(intercept, "an intercept that is a number", f64::is_finite)?;
    let r_squared = number(r_squared, "an R² above 0 and at most 1", |value| value > 0.0 && value <= 1.0)?;
    let Some([of_slope, of_intercept, seconds]) = intervals else {
        if !last.ends_with('\n') {
            return Err(RowError::NoLineEnd { given: given() });
        }
        let unknown = f64::NAN;
        return Ok(Calibration { slope, intercept, r_squared, slope_interval: unknown, intercept_interval: unknown });
    };
    // Two readings have no interval: NaN.
    let half = |field, what| number(field, what, |value| value.is_nan() || (value.is_finite() && value >= 0.0));
    let slope_interval = half(of_slope, "half of the slope's interval, not negative,")?;
    let intercept_interval = half(of_intercept, "half of the intercept's interval, not negative,")?;
    // Nothing is computed from the time: one that lost digits spoils nothing, but it shows that all before is whole.
    number(seconds, "a time in seconds since 1970", |value| value.is_finite() && value >= 0.0)?;
    if may_be_none(slope, slope_interval) {
        return Err(RowError::Uncertain { given: given() });
    }
    Ok(Calibration { slope, intercept, r_squared, slope_interval, intercept_interval })
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
        assert!(matches!(last_of_csv("1,2\nnan,3,1\n"), Err(RowError::Field { .. })));
        assert_eq!(last_of_csv(" \n\n"), Err(RowError::NoRow));
        let last = last_of_csv("1,2,3\n108.188097293,35144.7019735,0.999727300946\n\n").unwrap();
        assert!((last.slope - 108.188_097_293).abs() < 1e-12);
    }

    #[test]
    fn a_slope_that_may_be_none_is_refused_in_a_fit_and_in_a_file() {
        // Weights of 1 g under noise of some counts, then under 1 kg.
        let readings = |step: f64| -> Vec<(f64, u16)> {
            let noise = |place: u16| f64::from(u32::from(place) * 7919 % 17) - 8.0;
            let value = |place: u16| (108.19 * step * f64::from(place / 500) + 35_145.0 + noise(place)).round() as u16;
            (0..1000).map(|place| (step * f64::from(place / 500), value(place))).collect()
        };
        let error = Calibration::fit(&readings(6.2e-4)).unwrap_err();
        assert!(matches!(error, CalibrationError::Uncertain { slope, interval } if interval > slope.abs()), "{error}");
        assert!(error.to_string().contains("slip ring, or hang heavier weights"), "{error}");
        let fit = Calibration::fit(&readings(0.62)).unwrap();
        assert!(fit.slope_interval < 2.0, "{fit:?}");
        // Two readings have no interval, and are a line all the same.
        assert!(Calibration::fit(&[(0.0, 35_145), (1.0, 35_253)]).is_ok());
        for (row, is) in [
            ("463.1,35145.2,0.001,910.4,0.4,1700000000\n", false),
            ("-463.1,35145.2,0.5,463.1,0.4,1700000000\n", false),
            ("-463.1,35145.2,0.5,463.0,0.4,1700000000\n", true),
            ("108.19,35145,1,NaN,NaN,1700000000\n", true),
            ("463.1,35145.2,0.001\n", true),
        ] {
            let read = last_of_csv(row);
            assert_eq!(read.is_ok(), is, "{row}");
            let Err(error) = read else { continue };
            assert!(error.to_string().contains("interval holds zero"), "{error}");
        }
    }

    #[test]
    fn a_row_that_is_not_whole_is_no_calibration() {
        let whole = "107.5,35100.2,0.9997,0.05,1.5,1700000000\n";
        assert_eq!(last_of_csv(whole).map(|last| (last.slope, last.slope_interval)), Ok((107.5, 0.05)));
        // Cut at any byte it is refused until the last field has begun, and then it is the same line.
        for cut in 0..whole.len() {
            let text = format!("50,30000,0.9997,0.05,1.5,1600000000\n{}", &whole[..cut]);
            let expected = match cut {
                0 => Ok(50.0),
                cut if cut <= "107.5,35100.2,0.9997,0.05,1.5,".len() => Err(()),
                _ => Ok(107.5),
            };
            assert_eq!(last_of_csv(&text).map(|last| last.slope).map_err(drop), expected, "{text}");
        }
        for (row, wanted) in [
            ("50,30000,0.9997,0.05,1.5,1700000000107.5,35100.2,0.9997,0.05,1.5,1700000001\n", "11 fields"),
            ("107.5,35100.2,0\n", "R²"),
            ("107.5,35100.2,1.5\n", "R²"),
            ("107.5,35100.2,0.9997,-1,1.5,7\n", "slope's interval"),
            ("107.5,35100.2,0.9997\n0,35100.2,0.9997\n", "not zero"),
            ("107.5,35100.2,0.9", "no line end"),
        ] {
            let error = last_of_csv(row).unwrap_err().to_string();
            assert!(error.contains(wanted), "{error}");
        }
    }
}
