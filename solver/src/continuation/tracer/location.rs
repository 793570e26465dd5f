//! Where between two points of a branch a watched function vanishes.
//!
//! The zero of the polynomial through all that is known is the next place to look at: values, and where there are any
//! the derivatives with respect to the step. A fold is where the derivative of such a polynomial for the parameter
//! vanishes. As long as the function changes its sign, so does the polynomial.

use crate::orientation::Determinant;

/// What is known of the function at one place.
#[derive(Debug, Clone, Copy)]
pub(super) struct Known {
    /// The place, by its distance from the last point along that point's tangent.
    pub at: f64,
    pub value: f64,
    /// Derivative with respect to `at`.
    pub slope: Option<f64>,
}

/// Looks that are closer to each other than this part of the step are one.
pub(super) const APART: f64 = 0.02;

/// What is sought.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sought {
    /// Where the value vanishes.
    Zero,
    /// Where the derivative does, which must be known everywhere.
    Extremum,
}

impl Sought {
    /// What is to vanish.
    fn of(self, known: &Known) -> f64 {
        match self {
            Self::Zero => known.value,
            Self::Extremum => known.slope.unwrap_or(f64::NAN),
        }
    }
}

/// A search that has the place between two others.
#[derive(Debug, Clone)]
pub(super) struct Search {
    sought: Sought,
    /// All that is known, in the order in which it was found.
    known: Vec<Known>,
    /// The places between which the function changes its sign, and its values there.
    bracket: [(f64, f64); 2],
    /// Lengths of the bracket before the last looks.
    lengths: Vec<f64>,
    /// How often in a row the bracket had to be halved because the polynomial had not made it shorter.
    slow: usize,
}

/// Places that the polynomial goes through at most: the last ones found.
const MOST: usize = 6;
/// In so many looks the bracket is halved at least.
const PATIENCE: usize = 3;
/// So often in a row the polynomial may be slow: after that it tells nothing of the function, as where that jumps.
const SLOW: usize = 2;
/// Steps to the zero of a polynomial at most.
const STEPS: usize = 100;

impl Search {
    /// Between two ends, with what is known of a place outside.
    pub(super) fn new(sought: Sought, outside: Option<Known>, ends: [Known; 2]) -> Self {
        let bracket = ends.map(|end| (end.at, sought.of(&end)));
        Self { sought, known: outside.into_iter().chain(ends).collect(), bracket, lengths: Vec::new(), slow: 0 }
    }

    /// Where to look next.
    pub(super) fn next(&mut self) -> f64 {
        let [(a, _), (b, _)] = self.bracket;
        let length = (b - a).abs();
        let before = self.lengths.len().checked_sub(PATIENCE).map(|index| self.lengths[index]);
        self.lengths.push(length);
        match before {
            Some(before) if length > 0.5 * before => {
                self.lengths.clear();
                self.slow += 1;
                return self.middle();
            }
            Some(_) => self.slow = 0,
            None => {}
        }
        self.zero()
    }

    /// The middle of the bracket.
    pub(super) fn middle(&self) -> f64 {
        let [(a, _), (b, _)] = self.bracket;
        0.5 * (a + b)
    }

    /// Whether the polynomial tells nothing of the function, so that halves find the place sooner.
    pub(super) fn is_slow(&self) -> bool {
        self.slow >= SLOW
    }

    /// The ends of the bracket.
    pub(super) fn ends(&self) -> [f64; 2] {
        self.bracket.map(|(at, _)| at)
    }

    /// Takes in what has been found. False if that is no number.
    pub(super) fn add(&mut self, found: Known) -> bool {
        let value = self.sought.of(&found);
        if !(value.is_finite() && found.value.is_finite()) {
            return false;
        }
        let [_, (_, last)] = self.bracket;
        let side = usize::from(value * last > 0.0 || (value == 0.0 && last == 0.0));
        self.bracket[side] = (found.at, value);
        self.known.push(found);
        true
    }

    /// The side of a place, 1 or -1, on which there is more room to the end of the bracket.
    pub(super) fn roomier(&self, place: f64) -> f64 {
        let [(a, _), (b, _)] = self.bracket;
        if (a.max(b) - place).abs() >= (place - a.min(b)).abs() { 1.0 } else { -1.0 }
    }

    /// Zero and slope of the straight line between the ends of the bracket.
    pub(super) fn secant(&self) -> (f64, f64) {
        let [(a, fa), (b, fb)] = self.bracket;
        let slope = (fb - fa) / (b - a);
        (if fa == fb { 0.5 * (a + b) } else { a - fa / slope }, slope)
    }

    /// The length of the bracket.
    pub(super) fn length(&self) -> f64 {
        (self.bracket[1].0 - self.bracket[0].0).abs()
    }

    /// The zero of the polynomial in the bracket: by secants that keep it, or by halves.
    fn zero(&self) -> f64 {
        let polynomial = Polynomial::through(&self.known[self.known.len().saturating_sub(MOST)..]);
        let function = |at: f64| match self.sought {
            Sought::Zero => polynomial.at(at).0,
            Sought::Extremum => polynomial.at(at).1,
        };
        let [(mut a, mut fa), (mut b, mut fb)] = self.bracket;
        let precision = f64::EPSILON * (a.abs() + b.abs());
        for step in 0..STEPS {
            if (b - a).abs() <= precision || fb == fa {
                break;
            }
            let secant = (a * fb - b * fa) / (fb - fa);
            let at = if step % 4 == 3 { 0.5 * (a + b) } else { secant };
            let f = function(at);
            if f == 0.0 || !f.is_finite() {
                return at;
            }
            // Illinois: see M. Dowell and P. Jarratt, BIT 11 (1971) 168-174.
            if f * fb < 0.0 {
                (a, fa) = (b, fb);
            } else {
                fa *= 0.5;
            }
            (b, fb) = (at, f);
        }
        b
    }
}

/// Determinants relative to the largest of them.
pub(super) fn relative(known: &[(f64, Determinant)]) -> Vec<Known> {
    let larger = |a: Determinant, b: Determinant| if b.logarithm > a.logarithm { b } else { a };
    let largest = known.iter().map(|(_, determinant)| *determinant).reduce(larger).unwrap_or(Determinant::UNKNOWN);
    relative_to(&largest, known)
}

/// Determinants relative to another.
pub(super) fn relative_to(unit: &Determinant, known: &[(f64, Determinant)]) -> Vec<Known> {
    let known = known.iter();
    known.map(|(at, determinant)| Known { at: *at, value: determinant.relative(unit), slope: None }).collect()
}

/// A polynomial in Newton's form, by divided differences; places where the derivative is known count twice.
pub(super) struct Polynomial {
    places: Vec<f64>,
    coefficients: Vec<f64>,
}

impl Polynomial {
    pub(super) fn through(known: &[Known]) -> Self {
        let (mut places, mut differences, mut slopes) = (Vec::new(), Vec::new(), Vec::new());
        for known in known {
            for slope in [Some(None), known.slope.map(Some)].into_iter().flatten() {
                places.push(known.at);
                differences.push(known.value);
                slopes.push(slope);
            }
        }
        let mut coefficients = Vec::with_capacity(places.len());
        for order in 1..=places.len() {
            coefficients.extend(differences.first());
            differences = (0..differences.len().saturating_sub(1))
                .map(|i| match slopes[i + 1] {
                    Some(slope) if order == 1 => slope,
                    _ => (differences[i + 1] - differences[i]) / (places[i + order] - places[i]),
                })
                .collect();
        }
        Self { places, coefficients }
    }

    /// Value and derivative.
    pub(super) fn at(&self, at: f64) -> (f64, f64) {
        let (value, slope, _) = self.at_with_curvature(at);
        (value, slope)
    }

    /// Value, derivative and second derivative.
    pub(super) fn at_with_curvature(&self, at: f64) -> (f64, f64, f64) {
        let terms = self.coefficients.iter().zip(&self.places).rev();
        terms.fold((0.0, 0.0, 0.0), |(value, slope, curvature), (coefficient, place)| {
            let from = at - place;
            (coefficient + from * value, value + from * slope, 2.0 * slope + from * curvature)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn known(at: f64, f: impl Fn(f64) -> (f64, f64), with_slope: bool) -> Known {
        let (value, slope) = f(at);
        Known { at, value, slope: with_slope.then_some(slope) }
    }

    #[test]
    fn a_polynomial_reproduces_what_it_goes_through() {
        let cubic = |x: f64| (2.0 - x + 3.0 * x * x * x, -1.0 + 9.0 * x * x);
        let polynomial = Polynomial::through(&[known(0.5, cubic, true), known(2.0, cubic, true)]);
        for x in [-1.0, 0.0, 0.7, 3.0] {
            let ((value, slope), (wanted, rate)) = (polynomial.at(x), cubic(x));
            assert!((value - wanted).abs() < 1e-12 && (slope - rate).abs() < 1e-12, "{x}");
        }
        let polynomial = Polynomial::through(&[0.0, 1.0, 2.0, 3.0].map(|x| known(x, cubic, false)));
        assert!((polynomial.at(5.0).0 - cubic(5.0).0).abs() < 1e-11);
    }

    fn looks(sought: Sought, f: impl Fn(f64) -> (f64, f64) + Copy, with_slope: bool, zero: f64) -> usize {
        let mut search = Search::new(sought, None, [0.0, 1.0].map(|at| known(at, f, with_slope)));
        for look in 1..60 {
            let at = search.next();
            if (at - zero).abs() < 1e-12 {
                return look;
            }
            assert!(search.add(known(at, f, with_slope)));
        }
        panic!("not found");
    }

    #[test]
    fn few_looks_are_needed_and_steep_functions_do_not_hold_it_up() {
        let sine = |x: f64| ((3.0 * x).sin() - 0.5, 3.0 * (3.0 * x).cos());
        let zero = 0.5_f64.asin() / 3.0;
        let smooth = |x: f64| (sine(0.6 * x).0, 0.6 * sine(0.6 * x).1);
        assert!(looks(Sought::Zero, smooth, true, zero / 0.6) <= 4);
        assert!(looks(Sought::Zero, smooth, false, zero / 0.6) <= 7);
        let hump = |x: f64| ((-(x - 0.3) * (x - 0.3)).exp(), -2.0 * (x - 0.3) * (-(x - 0.3) * (x - 0.3)).exp());
        assert!(looks(Sought::Extremum, hump, true, 0.3) <= 4);
        let jump = |x: f64| ((1e4 * (x - 0.123)).tanh(), 0.0);
        assert!(looks(Sought::Zero, jump, false, 0.123) <= 50);
        // What is only a sign is halved.
        let sign = |x: f64| (if x < 0.377 { -1.0 } else { 1.0 }, 0.0);
        let mut search = Search::new(Sought::Zero, None, [0.0, 1.0].map(|at| known(at, sign, false)));
        for _ in 0..60 {
            let at = search.next();
            search.add(known(at, sign, false));
        }
        assert!(search.length() < 1e-4, "{}", search.length());
        let mut search = Search::new(Sought::Zero, None, [0.0, 1.0].map(|at| known(at, sign, false)));
        for _ in 0..48 {
            let at = if search.is_slow() { search.middle() } else { search.next() };
            search.add(known(at, sign, false));
        }
        assert!(search.length() < 1e-10, "{}", search.length());
    }
}
