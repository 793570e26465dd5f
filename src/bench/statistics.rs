//! Straight lines through measurements, quantiles, means of samples that depend on each other.

use super::error::{BenchError, BenchProblem};
use serde::Serialize;
use statrs::distribution::{ContinuousCDF, StudentsT};

/// Share of intervals that contain what they estimate.
pub const CONFIDENCE: f64 = 0.95;

/// y = `intercept` + `slope` x by ordinary least squares, in the units of the data.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Line {
    /// Rise of y per x.
    pub slope: f64,
    /// y at x = 0.
    pub intercept: f64,
    /// Coefficient of determination R².
    pub r_squared: f64,
    /// How many points the line was fitted to; 0 for a line taken from a file.
    pub points: usize,
    /// Standard error of the slope; `None` where it is not known.
    pub slope_error: Option<f64>,
    /// Standard error of the intercept.
    pub intercept_error: Option<f64>,
    /// Covariance of slope and intercept.
    pub covariance: Option<f64>,
    /// Standard deviation of the points about the line.
    pub scatter: Option<f64>,
}

impl Line {
    /// Fits a line.
    ///
    /// # Errors
    /// [`BenchProblem::Unusable`] for fewer than three points, or points that have one x in common.
    pub fn fit(name: &str, points: &[(f64, f64)]) -> Result<Self, BenchError> {
        let bad = |reason: &str| BenchError::from(BenchProblem::Unusable { path: name.into(), reason: reason.into() });
        let n = points.len() as f64;
        if points.len() < 3 {
            return Err(bad("a line with its uncertainty needs at least three points"));
        }
        let mean = |value: fn(&(f64, f64)) -> f64| points.iter().map(value).sum::<f64>() / n;
        let (mx, my) = (mean(|p| p.0), mean(|p| p.1));
        let sum = |value: &dyn Fn(f64, f64) -> f64| points.iter().map(|(x, y)| value(x - mx, y - my)).sum::<f64>();
        let (sxx, sxy, syy) = (sum(&|x, _| x * x), sum(&|x, y| x * y), sum(&|_, y| y * y));
        let spread = points.iter().map(|(x, _)| x.abs()).fold(0.0, f64::max);
        let spread_out = sxx > (1e-12 * spread).powi(2) * n;
        if !spread_out || !sxy.is_finite() || !syy.is_finite() {
            return Err(bad("all points have the same abscissa: no line can be laid through them"));
        }
        let slope = sxy / sxx;
        let intercept = my - slope * mx;
        let left = points.iter().map(|(x, y)| (y - intercept - slope * x).powi(2)).sum::<f64>();
        let variance = left / (n - 2.0);
        let slope_variance = variance / sxx;
        Ok(Self {
            slope,
            intercept,
            r_squared: if syy > 0.0 { 1.0 - left / syy } else { 1.0 },
            points: points.len(),
            slope_error: Some(slope_variance.sqrt()),
            intercept_error: Some((variance / n + mx * mx * slope_variance).sqrt()),
            covariance: Some(-mx * slope_variance),
            scatter: Some(variance.sqrt()),
        })
    }

    /// A line that somebody else has fitted.
    pub fn given(slope: f64, intercept: f64, r_squared: f64) -> Self {
        let (points, none) = (0, None);
        Self {
            slope,
            intercept,
            r_squared,
            points,
            slope_error: none,
            intercept_error: none,
            covariance: none,
            scatter: none,
        }
    }

    /// x at a y: the line read backwards.
    pub fn inverse(&self, y: f64) -> f64 {
        (y - self.intercept) / self.slope
    }

    /// Variance of [`Line::inverse`] that the line's own uncertainty causes; 0 where that is not known.
    pub fn inverse_variance(&self, y: f64) -> f64 {
        match (self.slope_error, self.intercept_error, self.covariance) {
            (Some(slope), Some(intercept), Some(covariance)) => {
                let x = self.inverse(y);
                (intercept.powi(2) + 2.0 * x * covariance + (x * slope).powi(2)) / self.slope.powi(2)
            }
            _ => 0.0,
        }
    }

    /// Half the width of the slope's confidence interval.
    pub fn slope_interval(&self) -> Option<f64> {
        Some(self.slope_error? * student(self.points.checked_sub(2)?))
    }
}

/// Quantile of Student's distribution for a two-sided interval of [`CONFIDENCE`]; infinite without degrees of freedom.
pub fn student(degrees: usize) -> f64 {
    match StudentsT::new(0.0, 1.0, degrees as f64) {
        Ok(distribution) => distribution.inverse_cdf(0.5 + CONFIDENCE / 2.0),
        Err(_) => f64::INFINITY,
    }
}

/// Mean of equally spaced samples, and its standard error.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Average {
    /// Mean.
    pub mean: f64,
    /// Standard deviation of the samples.
    pub deviation: f64,
    /// Standard error of the mean, from the scatter of the means of several parts: what repeats within a part, as
    /// firing does, cancels, and what drifts over the parts counts in full.
    pub error: f64,
    /// Measured samples; where they are denser than the uniform ones, these.
    pub samples: usize,
    /// Parts: the error has a degree of freedom less.
    pub parts: usize,
}

/// Parts into which samples are cut to estimate the error of their mean, if they are enough.
pub const BATCHES: usize = 10;
/// Measured samples that a part has at least. Values between two of them are made of both: what two parts have in
/// common at their border hides some of the scatter, the more the shorter the parts are.
const MEASURED: usize = 4;
/// Measured samples of which an average is made at least: those of two parts.
pub const LEAST_MEASURED: usize = 2 * MEASURED;

impl Average {
    /// Averages samples that are all measured; `None` for fewer than two in each of ten parts.
    pub fn of(samples: &[f64]) -> Option<Self> {
        Self::of_parts(samples, samples.len(), BATCHES)
    }

    /// Averages uniform samples that were interpolated between so many measured ones, in as many parts as these allow;
    /// `None` for fewer than eight measured ones, and for fewer than two uniform ones in each of ten parts.
    pub fn interpolated(samples: &[f64], measured: usize) -> Option<Self> {
        let parts = (measured / MEASURED).min(BATCHES);
        if measured < LEAST_MEASURED || samples.len() < 2 * BATCHES {
            return None;
        }
        Self::of_parts(samples, measured, parts)
    }

    fn of_parts(samples: &[f64], measured: usize, count: usize) -> Option<Self> {
        let size = samples.len() / count;
        if size < 2 {
            return None;
        }
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
        let spread = |values: &[f64], mean: f64| {
            (values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / (values.len() as f64 - 1.0)).sqrt()
        };
        let whole = mean(samples);
        // What does not fill a part stands at the end, and belongs to the last.
        let cut = |at: usize| if at == count { samples.len() } else { at * size };
        let parts: Vec<f64> = (0..count).filter_map(|at| samples.get(cut(at)..cut(at + 1))).map(mean).collect();
        let error = spread(&parts, mean(&parts)) / (count as f64).sqrt();
        let (deviation, measured) = (spread(samples, whole), measured.min(samples.len()));
        Some(Self { mean: whole, deviation, error, samples: measured, parts: count })
    }
}

/// Shares of which some are larger than they can be.
pub(super) struct AboveOne {
    /// How many are above one,
    pub count: usize,
    /// of how many.
    pub of: usize,
    /// The largest.
    pub largest: f64,
}

impl AboveOne {
    /// None if no share is above one.
    pub fn among(shares: impl Iterator<Item = f64>) -> Option<Self> {
        let shares: Vec<f64> = shares.collect();
        let above = || shares.iter().copied().filter(|share| *share > 1.0);
        let largest = above().reduce(f64::max)?;
        Some(Self { count: above().count(), of: shares.len(), largest })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_by_hand() {
        // Norris' first NIST reference data set is larger; this one is worked by hand: y = 1 + 2 x with residuals ±0.1.
        let line = Line::fit("test", &[(0.0, 1.1), (1.0, 2.9), (2.0, 4.9), (3.0, 7.1)]).unwrap();
        assert!((line.slope - 2.0).abs() < 1e-14 && (line.intercept - 1.0).abs() < 1e-14, "{line:?}");
        // s² = 0.04/2, s_slope² = s²/5, s_intercept² = s² (1/4 + 1.5²/5)
        assert!((line.slope_error.unwrap() - (0.02f64 / 5.0).sqrt()).abs() < 1e-14);
        assert!((line.intercept_error.unwrap() - (0.02f64 * 0.7).sqrt()).abs() < 1e-14);
        assert!((line.r_squared - (1.0 - 0.04 / 20.04)).abs() < 1e-14);
        assert!((line.inverse(5.0) - 2.0).abs() < 1e-14);
        // Var x at y = 5: (0.014 + 2·2·(−1.5·0.004) + 4·0.004)/4
        assert!((line.inverse_variance(5.0) - 0.0015).abs() < 1e-14);
        assert!(Line::fit("test", &[(1.0, 1.0), (1.0, 2.0), (1.0, 3.0)]).is_err());
        assert!(Line::fit("test", &[(1.0, 1.0), (2.0, 2.0)]).is_err());
    }

    #[test]
    fn quantiles_are_the_tabulated_ones() {
        for (degrees, tabulated) in [(1, 12.7062), (9, 2.26216), (30, 2.04227), (1000, 1.96234)] {
            assert!((student(degrees) - tabulated).abs() < 1e-4, "{degrees}: {}", student(degrees));
        }
        assert_eq!(student(0), f64::INFINITY);
    }

    #[test]
    fn what_repeats_within_a_part_does_not_count() {
        let ripple: Vec<f64> = (0..400).map(|at| 5.0 + (f64::from(at) * std::f64::consts::TAU / 8.0).sin()).collect();
        let average = Average::of(&ripple).unwrap();
        assert!((average.mean - 5.0).abs() < 1e-12 && average.error < 1e-12, "{average:?}");
        let drift: Vec<f64> = (0..400).map(f64::from).collect();
        assert!(Average::of(&drift).unwrap().error > 30.0);
        assert!(Average::of(&[1.0; 19]).is_none());
    }
}
