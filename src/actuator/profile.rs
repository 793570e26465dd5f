//! Tables that become smooth curves: flyweights, ramps, helices and engines as they are measured.
//!
//! Between its points a profile is the monotone piecewise cubic of F. N. Fritsch and J. Butland, "A method for
//! constructing local monotone piecewise cubic interpolants", SIAM J. Sci. Stat. Comput. 5 (1984) 300: no wiggle that
//! the table does not have, a continuous first derivative, so that Newton's method and exact sensitivities can use it.
//! Beyond its ends it goes on as a straight line.

use serde::{Deserialize, Serialize};
use thiserror::Error;

/// Why points make no profile.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ProfileError {
    /// Fewer than two points.
    #[error("a profile has {points} points: expected two at the least")]
    TooFew {
        /// How many there are.
        points: usize,
    },
    /// The two columns differ in length.
    #[error("{places} places and {values} values: expected as many of each")]
    Lengths {
        /// Places.
        places: usize,
        /// Values.
        values: usize,
    },
    /// A number is not finite.
    #[error("point {point} is ({place}, {value}): expected finite numbers")]
    NotFinite {
        /// Which point, from 1.
        point: usize,
        /// Its place.
        place: f64,
        /// Its value.
        value: f64,
    },
    /// Places do not increase.
    #[error("point {point} stands at {place}, not beyond the one before it at {before}: expected increasing places")]
    Order {
        /// Which point, from 1.
        point: usize,
        /// Its place.
        place: f64,
        /// The place before it.
        before: f64,
    },
}

/// A curve at one place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jet {
    /// Its value.
    pub value: f64,
    /// Its first derivative, continuous.
    pub slope: f64,
    /// Its second derivative, which jumps at the table's points.
    pub curvature: f64,
}

/// A smooth curve through the points of a table.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(try_from = "Points", into = "Points")]
pub struct Profile {
    places: Vec<f64>,
    values: Vec<f64>,
    slopes: Vec<f64>,
}

/// A profile as it is written: its points.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Points {
    places: Vec<f64>,
    values: Vec<f64>,
}

impl TryFrom<Points> for Profile {
    type Error = ProfileError;

    fn try_from(points: Points) -> Result<Self, ProfileError> {
        Self::new(points.places, points.values)
    }
}

impl From<Profile> for Points {
    fn from(profile: Profile) -> Self {
        Self { places: profile.places, values: profile.values }
    }
}

impl Profile {
    /// The curve through `values` at increasing `places`, two at the least.
    ///
    /// # Errors
    /// [`ProfileError`] names the point that is at fault.
    pub fn new(places: Vec<f64>, values: Vec<f64>) -> Result<Self, ProfileError> {
        if places.len() != values.len() {
            return Err(ProfileError::Lengths { places: places.len(), values: values.len() });
        }
        if places.len() < 2 {
            return Err(ProfileError::TooFew { points: places.len() });
        }
        for (point, (&place, &value)) in (1..).zip(places.iter().zip(&values)) {
            if !place.is_finite() || !value.is_finite() {
                return Err(ProfileError::NotFinite { point, place, value });
            }
        }
        for (point, pair) in (2..).zip(places.windows(2)) {
            if let &[before, place] = pair
                && place <= before
            {
                return Err(ProfileError::Order { point, place, before });
            }
        }
        let slopes = slopes(&places, &values);
        Ok(Self { places, values, slopes })
    }

    /// The straight line through `value` at `place` with `slope`.
    pub fn line(place: f64, value: f64, slope: f64) -> Self {
        Self { places: vec![place, place + 1.0], values: vec![value, value + slope], slopes: vec![slope; 2] }
    }

    /// First and last place of the table.
    pub fn domain(&self) -> (f64, f64) {
        let [first, .., last] = self.places.as_slice() else { return (0.0, 0.0) };
        (*first, *last)
    }

    /// Places of the table, increasing.
    pub fn places(&self) -> &[f64] {
        &self.places
    }

    /// Values of the table.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// The curve at a place.
    pub fn at(&self, place: f64) -> Jet {
        let (first, last) = self.domain();
        let end = |at: usize| {
            let (value, slope) = (self.values[at], self.slopes[at]);
            Jet { value: value + slope * (place - self.places[at]), slope, curvature: 0.0 }
        };
        if place <= first {
            return end(0);
        }
        if place >= last {
            return end(self.places.len() - 1);
        }
        let right = self.places.partition_point(|other| *other <= place);
        let left = right - 1;
        let width = self.places[right] - self.places[left];
        let t = (place - self.places[left]) / width;
        let (a, b) = (self.values[left], self.values[right]);
        let (da, db) = (self.slopes[left] * width, self.slopes[right] * width);
        // Cubic Hermite form, and its derivative.
        let secant = b - a;
        let (c, d) = (3.0 * secant - 2.0 * da - db, da + db - 2.0 * secant);
        Jet {
            value: a + t * (da + t * (c + t * d)),
            slope: (da + t * (2.0 * c + 3.0 * t * d)) / width,
            curvature: (2.0 * c + 6.0 * t * d) / (width * width),
        }
    }

    /// Integral from the first place of the table to `place`.
    pub fn integral(&self, place: f64) -> f64 {
        // Simpson's rule is exact for cubics, and straight lines continue the ends.
        let part = |from: f64, to: f64| {
            let middle = 0.5 * (from + to);
            (to - from) / 6.0 * (self.at(from).value + 4.0 * self.at(middle).value + self.at(to).value)
        };
        let (first, last) = self.domain();
        let inside = place.clamp(first, last);
        let cut = self.places.partition_point(|other| *other < inside).max(1);
        let whole: f64 = self.places[..cut].windows(2).map(|pair| part(pair[0], pair[1])).sum();
        whole + part(self.places[cut - 1], inside) + if place == inside { 0.0 } else { part(inside, place) }
    }
}

/// Slopes at the points: the weighted harmonic mean of the neighbouring secants where these have one sign, else zero;
/// at the ends the three-point formula, limited so that the curve stays monotone.
fn slopes(places: &[f64], values: &[f64]) -> Vec<f64> {
    let widths: Vec<f64> = places.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let secants: Vec<f64> = values.windows(2).zip(&widths).map(|(pair, width)| (pair[1] - pair[0]) / width).collect();
    let count = places.len();
    if count == 2 {
        return vec![secants[0]; 2];
    }
    let inner = |i: usize| {
        let (before, after) = (secants[i - 1], secants[i]);
        if before * after <= 0.0 {
            return 0.0;
        }
        let (first, second) = (2.0 * widths[i] + widths[i - 1], widths[i] + 2.0 * widths[i - 1]);
        (first + second) / (first / before + second / after)
    };
    let end = |width: f64, next_width: f64, secant: f64, next: f64| {
        let slope = ((2.0 * width + next_width) * secant - width * next) / (width + next_width);
        if slope * secant <= 0.0 {
            0.0
        } else if secant * next <= 0.0 && slope.abs() > 3.0 * secant.abs() {
            3.0 * secant
        } else {
            slope
        }
    };
    let mut slopes = vec![end(widths[0], widths[1], secants[0], secants[1])];
    slopes.extend((1..count - 1).map(inner));
    slopes.push(end(widths[count - 2], widths[count - 3], secants[count - 2], secants[count - 3]));
    slopes
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// SciPy 1.17: `p = scipy.interpolate.PchipInterpolator([0, 1, 2.5, 4, 5], [0, 2, 2.5, 1, 3])`; place, `p`, its
    /// derivative and its integral from 0.
    #[test]
    fn it_is_what_scipy_interpolates() {
        let table = Profile::new(vec![0.0, 1.0, 2.5, 4.0, 5.0], vec![0.0, 2.0, 2.5, 1.0, 3.0]).unwrap();
        for (place, value, slope, integral) in [
            (0.0, 0.0, 2.666666666666667, 0.0),
            (0.4, 1.0304, 2.368, 0.2100622222222223),
            (1.0, 2.0, 0.6, 1.172222222222222),
            (1.9, 2.4104, 0.288, 3.177962222222222),
            (3.1, 1.972, -1.44, 6.044522222222222),
            (4.6, 1.8352, 2.496, 8.060402222222221),
            (5.0, 3.0, 3.2, 9.018055555555554),
        ] {
            let jet = table.at(place);
            let found = [jet.value, jet.slope, table.integral(place)];
            for (found, scipy) in found.into_iter().zip([value, slope, integral]) {
                assert!((found - scipy).abs() < 1e-13, "at {place}: {found}, SciPy {scipy}");
            }
        }
    }

    #[test]
    fn a_straight_table_gives_a_straight_line() {
        let line = Profile::new(vec![0.0, 0.5, 2.0], vec![1.0, 2.0, 5.0]).unwrap();
        for place in [-3.0, 0.0, 0.3, 1.7, 9.0] {
            let Jet { value, slope, .. } = line.at(place);
            assert!(
                (value - (1.0 + 2.0 * place)).abs() < 1e-14 && (slope - 2.0).abs() < 1e-14,
                "{place}: {value}, {slope}"
            );
        }
        assert!((line.integral(2.0) - 6.0).abs() < 1e-14 && (line.integral(-1.0) + 0.0).abs() < 1e-14);
    }

    #[test]
    fn what_is_wrong_with_a_table_is_said() {
        let error =
            |places: &[f64], values: &[f64]| Profile::new(places.into(), values.into()).unwrap_err().to_string();
        assert_eq!(error(&[0.0], &[1.0]), "a profile has 1 points: expected two at the least");
        assert_eq!(error(&[0.0, 1.0], &[1.0]), "2 places and 1 values: expected as many of each");
        assert!(error(&[0.0, 1.0, 1.0], &[1.0; 3]).starts_with("point 3 stands at 1, not beyond the one before it"));
        assert!(error(&[0.0, f64::NAN], &[1.0; 2]).contains("finite"));
    }

    proptest! {
        #[test]
        fn monotone_tables_give_monotone_curves(steps in prop::collection::vec((0.1f64..2.0, 0.0f64..3.0), 2..9)) {
            let mut at = (0.0, 0.0);
            let points: Vec<(f64, f64)> = steps.iter().map(|(x, y)| { at = (at.0 + x, at.1 + y); at }).collect();
            let (places, values): (Vec<f64>, Vec<f64>) = points.iter().copied().unzip();
            let profile = Profile::new(places.clone(), values).unwrap();
            for (place, value) in points {
                prop_assert!((profile.at(place).value - value).abs() < 1e-12);
            }
            let (first, last) = profile.domain();
            let mut before = f64::NEG_INFINITY;
            for i in 0..=200 {
                let place = first + (last - first) * f64::from(i) / 200.0;
                let Jet { value, slope, .. } = profile.at(place);
                prop_assert!(value >= before - 1e-12 && slope >= -1e-12, "{} {}", value, slope);
                before = value;
                let h = 1e-6;
                let difference = (profile.at(place + h).value - profile.at(place - h).value) / (2.0 * h);
                prop_assert!((difference - slope).abs() < 1e-4 * (1.0 + slope.abs()), "{} {}", difference, slope);
                let area = (profile.integral(place + h) - profile.integral(place - h)) / (2.0 * h);
                prop_assert!((area - value).abs() < 1e-6 * (1.0 + value.abs()), "{} {}", area, value);
            }
        }
    }
}
