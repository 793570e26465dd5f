//! Branch points of even multiplicity: the determinant touches zero there, and keeps its sign.
//!
//! They are common where a problem is symmetric: on a ring a pattern may stand anywhere, so that its sine and its
//! cosine branch off at one place; of two members that are alike either may buckle. No sign tells them, but the
//! determinant does, which steps resolve: it has an extremum, and that is zero. Rounding and the mesh take the zero
//! apart, into two, real or complex, which come together again as the mesh is made finer.

use super::finer::{HALVINGS, REACH, SHRINKS};
use super::location::{APART, Known, Polynomial, relative_to};
use super::near::Span;
use super::places::DISTANCE;
use super::{Advanced, Care, Reference, Tracer};
use crate::error::SolveError;
use crate::orientation::Determinant;

/// Where the determinant touches zero.
pub(super) struct Touch {
    /// Distance from the point before, on the mesh on which it is met: it may be beyond the step's ends.
    pub met: f64,
    /// Distance on the mesh of the point.
    pub at: f64,
    /// How far its two zeros are from there, real or complex, on that mesh.
    width: f64,
    pub point: Reference,
}

/// An extremum is looked at if the determinant is no more than this part there of what it is at the larger of the
/// step's ends,
const DEEP: f64 = 0.05;
/// and no farther outside of the step than this part of it.
const OUTSIDE: f64 = 0.05;
/// Extrema are sought at so many places.
const PLACES: i32 = 64;
/// Looks for one place at most.
const LOOKS: usize = 12;
/// Each look finds no more than this part of the determinant that the one before did, or there is no zero.
const LOWER: f64 = 0.5;
/// A place has settled that changes by no more than this part of the step.
const SETTLED: f64 = 1e-7;
/// Zeros are one that are no farther from the extremum between them than this part of the step.
const NARROW: f64 = 1e-3;
/// Those farther from it, up to this part, are one if they come together on finer meshes.
const ROUGHLY: f64 = 0.05;
/// On a mesh whose intervals are halved the determinant is first looked at so far from where the zero was, in parts of
/// the step.
const FIRST: [f64; 3] = [1e-2, -1e-2, 2e-2];
/// The polynomial goes through so many of the last looks at most.
const MOST: usize = 5;
/// Newton steps to an extremum of a polynomial at most.
const STEPS: usize = 30;

/// What an extremum is.
pub(super) enum Extremum {
    /// The determinant touches zero.
    Touches(Box<Touch>),
    /// It lies between two zeros.
    Between(f64),
    /// Neither, as far as can be told.
    Neither,
}

/// What is known of the determinant about an extremum.
struct Valley {
    /// In the order in which it was found.
    known: Vec<Known>,
}

/// An extremum.
#[derive(Debug, Clone, Copy)]
struct Bottom {
    at: f64,
    /// How far the determinant's zeros are from there,
    width: f64,
    /// and whether they are real.
    are_real: bool,
}

impl Valley {
    fn add(&mut self, at: f64, value: f64) {
        self.known.push(Known { at, value, slope: None });
    }

    /// The extremum of the polynomial through the last looks that is next to the smallest value of them; none if there
    /// is none that is a minimum of magnitude.
    fn bottom(&self) -> Option<Bottom> {
        let last = &self.known[self.known.len().saturating_sub(MOST)..];
        let smaller = |a: Known, b: Known| if b.value.abs() < a.value.abs() { b } else { a };
        let lowest = last.iter().copied().reduce(smaller)?;
        let polynomial = Polynomial::through(last);
        let mut at = lowest.at;
        for _ in 0..STEPS {
            let (_, slope, curvature) = polynomial.at_with_curvature(at);
            let change = slope / curvature;
            at -= change;
            if change.abs() <= f64::EPSILON * at.abs() {
                break;
            }
        }
        let (value, _, curvature) = polynomial.at_with_curvature(at);
        let sign = last.iter().map(|known| known.value).reduce(|a, b| if b.abs() > a.abs() { b } else { a })?;
        let width = libm::sqrt(2.0 * (value / curvature).abs());
        let are_real = value * sign < 0.0;
        (curvature * sign > 0.0 && at.is_finite() && width.is_finite()).then_some(Bottom { at, width, are_real })
    }
}

/// Places in a step, and a little outside, where a polynomial has an extremum at which it may touch zero: where its
/// magnitude is smallest, or where it has just changed its sign.
pub(super) fn valleys(polynomial: &Polynomial, step: f64) -> Vec<f64> {
    let value = |part: f64| polynomial.at(part * step).0;
    let ends = [value(0.0), value(1.0)];
    let larger = if ends[1].abs() > ends[0].abs() { ends[1] } else { ends[0] };
    let parts = (0..=PLACES).map(|k| f64::from(k) / f64::from(PLACES) * (1.0 + 2.0 * OUTSIDE) - OUTSIDE);
    let known: Vec<(f64, f64)> = parts.map(|part| (part * step, value(part) * larger.signum())).collect();
    let is_valley = |three: &&[(f64, f64)]| {
        let [before, here, after] = [0, 1, 2].map(|i| three[i].1);
        here <= before && here < after && here.abs() <= DEEP * larger.abs()
    };
    known.windows(3).filter(is_valley).map(|three| three[1].0).collect()
}

/// Whether a place is in a step, or a little outside.
fn is_near(at: f64, step: f64) -> bool {
    at >= -2.0 * OUTSIDE * step && at <= (1.0 + 2.0 * OUTSIDE) * step
}

impl Tracer<'_, '_> {
    /// What the extremum of the determinant next to a place in a step is. What is seen of it is known from then on.
    pub(super) fn extremum(
        &mut self,
        span: Span<'_>,
        known: &mut Vec<(f64, Determinant)>,
        place: f64,
    ) -> Result<Extremum, SolveError> {
        let Span { here, step, next, .. } = span;
        let unit = next.point.determinant;
        let mut valley = Valley { known: relative_to(&unit, known) };
        let mut seen: Vec<(f64, Advanced)> = Vec::new();
        let (mut at, mut least) = (place, f64::INFINITY);
        let mut bottom = None;
        for _ in 0..LOOKS {
            let side = if seen.last().is_some_and(|(last, _)| *last > at) { -1.0 } else { 1.0 };
            let beside = at + side * DISTANCE * step;
            let near = span.around(&seen, beside);
            let look = match self.look(span, beside, near, Care::Glance) {
                Err(cause) if cause.is_interruption() => return Err(cause),
                Err(_) => return Ok(Extremum::Neither),
                Ok(look) => look,
            };
            let value = look.point.determinant.relative(&unit);
            // Looks that are close to each other would tell of their rounding.
            if known.iter().all(|(other, _)| (other - beside).abs() > APART * step) {
                known.push((beside, look.point.determinant));
            }
            valley.add(beside, value);
            seen.push((beside, look));
            let Some(found) = valley.bottom().filter(|found| is_near(found.at, step)) else {
                return Ok(Extremum::Neither);
            };
            let change = (found.at - at).abs();
            at = found.at;
            if change <= SETTLED * step {
                bottom = Some(found);
                break;
            }
            if !(value.abs() <= LOWER * least) {
                return Ok(Extremum::Neither);
            }
            least = value.abs();
        }
        let settles = self.options.settle_branch_points;
        let widest = if settles { ROUGHLY } else { NARROW } * step;
        let Some(bottom) = bottom else { return Ok(Extremum::Neither) };
        if bottom.width <= widest {
            let touch = match self.on_branch(span, bottom, &seen) {
                Err(cause) if cause.is_interruption() => return Err(cause),
                Err(_) => None,
                Ok(touch) if settles => self.settled_touch((here, step), touch)?,
                Ok(touch) => Some(touch),
            };
            if let Some(touch) = touch {
                return Ok(Extremum::Touches(Box::new(touch)));
            }
        }
        let within = bottom.are_real && bottom.at > 0.0 && bottom.at < step;
        Ok(if within { Extremum::Between(bottom.at) } else { Extremum::Neither })
    }

    /// The point where the determinant touches zero, by way of one beside it.
    fn on_branch(&mut self, span: Span<'_>, bottom: Bottom, seen: &[(f64, Advanced)]) -> Result<Touch, SolveError> {
        let beside = bottom.at + DISTANCE * span.step;
        let near = span.around(seen, beside);
        let judged = self.look(span, beside, near, Care::Between)?;
        let point = self.moved(&judged.point, judged.speed * (bottom.at - beside))?;
        Ok(Touch { met: bottom.at, at: bottom.at, width: bottom.width, point })
    }

    /// A branch point that is not found anew on halved intervals, where the determinant touches zero on finer ones: its
    /// place and the point there.
    pub(super) fn settled_as_touch(
        &mut self,
        (here, step): (&Reference, f64),
        (place, point): (f64, &Reference),
    ) -> Result<Option<(f64, Reference)>, SolveError> {
        let touch = Touch { met: place, at: place, width: f64::INFINITY, point: point.clone() };
        let touch = self.settled_touch((here, step), touch)?;
        Ok(touch.filter(|touch| touch.point.is_settled).map(|touch| (touch.at, touch.point)))
    }

    /// One as exact as the tolerance asks; none if its zeros do not come together.
    fn settled_touch(
        &mut self,
        (here, step): (&Reference, f64),
        mut touch: Touch,
    ) -> Result<Option<Touch>, SolveError> {
        let parameter = self.parameter;
        let tolerance = self.location_tolerance(&touch.point);
        let apart = |touch: &Touch| touch.width * touch.point.direction.constants[parameter].abs();
        for _ in 0..HALVINGS {
            if !self.can_be_halved(&touch.point) {
                break;
            }
            let finer = match self.touch_on_halved((here, step), &touch) {
                Err(cause) if cause.is_interruption() => return Err(cause),
                // What was found on the coarser mesh stands.
                Err(_) | Ok(None) => break,
                Ok(Some(finer)) => finer,
            };
            let change = (finer.point.value(parameter) - touch.point.value(parameter)).abs();
            let before = std::mem::replace(&mut touch, finer);
            let is_one = apart(&touch) <= tolerance;
            // Two zeros that come together do so with the methods' orders, which are four and more.
            let stay_apart = !is_one && touch.width > 0.5 * before.width;
            touch.point.is_settled = is_one && change <= SHRINKS * tolerance;
            if stay_apart || touch.point.is_settled {
                break;
            }
        }
        Ok((apart(&touch) <= tolerance).then_some(touch))
    }

    /// The same on halved intervals; none if it is not there.
    fn touch_on_halved(&mut self, (here, step): (&Reference, f64), touch: &Touch) -> Result<Option<Touch>, SolveError> {
        let (place, reach) = (touch.at, REACH.max(step));
        let first = self.on_halved((here, reach), (place, &touch.point), FIRST[0] * step)?;
        let unit = here.determinant;
        let settled = (SETTLED * step).max(self.settled_distance());
        let mut valley = Valley { known: Vec::new() };
        valley.add(place + FIRST[0] * step, first.point.determinant.relative(&unit));
        let mut last = (place + FIRST[0] * step, first);
        let mut bottom: Option<Bottom> = None;
        for look in 1..LOOKS {
            let next = match (FIRST.get(look), bottom) {
                (Some(beside), _) => place + beside * step,
                (None, Some(bottom)) => bottom.at + DISTANCE * step,
                (None, None) => return Ok(None),
            };
            let near = (last.1.near(last.0), None);
            let found = self.advance_from(here, next, near, Care::Glance)?;
            let found = self.between(found, touch.point.solution.constants(), reach)?;
            valley.add(next, found.point.determinant.relative(&unit));
            last = (next, found);
            let before = bottom;
            bottom = valley.bottom().filter(|bottom| (bottom.at - place).abs() <= reach);
            let change = before.zip(bottom).map_or(f64::INFINITY, |(before, now)| (now.at - before.at).abs());
            if let Some(bottom) = bottom.filter(|_| change <= settled) {
                let near = last.1.near(last.0);
                let judged = self.advance_from(here, last.0, (near, None), Care::Between)?;
                let point = self.moved(&judged.point, judged.speed * (bottom.at - last.0))?;
                return Ok(Some(Touch { met: touch.met, at: bottom.at, width: bottom.width, point }));
            }
        }
        Ok(None)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn known(places: &[f64], f: impl Fn(f64) -> f64) -> Vec<Known> {
        places.iter().map(|&at| Known { at, value: f(at), slope: None }).collect()
    }

    /// Three looks more, each where the extremum is said to be.
    fn bottom(places: &[f64], f: impl Fn(f64) -> f64 + Copy) -> Option<Bottom> {
        let mut valley = Valley { known: known(places, f) };
        for _ in 0..3 {
            let at = valley.bottom()?.at + 1e-4;
            valley.add(at, f(at));
        }
        valley.bottom()
    }

    #[test]
    fn a_double_zero_is_told_from_two_real_and_two_complex_ones() {
        let places = [-0.5, 0.0, 0.5, 1.0];
        for sign in [1.0, -1.0] {
            let with = |rest: f64| move |x: f64| sign * ((x - 0.3) * (x - 0.3) + rest) * (0.4 * x).exp();
            let double = bottom(&places, with(0.0)).expect("an extremum");
            assert!((double.at - 0.3).abs() < 1e-9 && double.width < 1e-6, "{double:?}");
            let complex = bottom(&places, with(1e-4)).expect("an extremum");
            assert!((complex.width - 1e-2).abs() < 1e-4 && !complex.are_real, "{complex:?}");
            let real = bottom(&places, with(-1e-4)).expect("an extremum");
            assert!((real.width - 1e-2).abs() < 1e-4 && real.are_real, "{real:?}");
        }
        assert!(bottom(&places, |x| 1.0 - x * x).is_none(), "the largest value");
    }

    #[test]
    fn extrema_are_looked_at_where_the_function_may_touch_zero() {
        let places =
            |f: &dyn Fn(f64) -> f64| valleys(&Polynomial::through(&known(&[-1.0, 0.0, 0.3, 0.6, 1.0], f)), 1.0);
        let near = |found: &[f64], wanted: &[f64]| {
            found.len() == wanted.len() && found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 0.02)
        };
        assert!(near(&places(&|x| (x - 0.4).powi(2)), &[0.4]));
        assert!(near(&places(&|x| 0.01 - (x - 0.4).powi(2)), &[0.4]), "between two zeros that are close");
        assert!(near(&places(&|x| -((x - 0.2) * (x - 0.7)).powi(2)), &[0.2, 0.7]));
        assert!(near(&places(&|x| (x - 1.02).powi(2)), &[1.02]), "a little outside");
        for none in [places(&|x| 0.1 + (x - 0.4).powi(2)), places(&|x| x - 0.4), places(&|x| (x + 0.5).powi(2))] {
            assert!(none.is_empty(), "{none:?}");
        }
    }
}
