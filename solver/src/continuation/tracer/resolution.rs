//! Whether a step is short enough for the determinant to be known between its ends.
//!
//! Two branch points within one step leave the sign of the determinant as it was. In the form that does not depend on
//! the mesh the determinant is a smooth function of the arclength, and steps are taken that resolve it, as they resolve
//! the solution. The polynomial through the points before is extrapolated to a step's end, and must be right there;
//! where it is so only roughly, or the determinant is small there, the polynomial through the ends as well must be
//! right in the middle. The error there bounds what the polynomial through all of them may hide: a step ends between
//! the first two zeros that the determinant may have.
//!
//! A mesh that resolves the branch need not resolve what bifurcates from it, and then the determinant does depend on
//! it. A step that seems too long, and whose ends are on different meshes, is therefore judged on the mesh of its end
//! alone.
//!
//! What is smaller than the points of a branch are apart may still be missed: the zeros of functions that are known at
//! points alone are never certain.

use super::location::{APART, Known, Polynomial, relative};
use super::near::{Near, Span};
use super::touching::{Extremum, valleys};
use super::{Care, Tracer};
use crate::continuation::arclength::Reference;
use crate::error::SolveError;
use crate::orientation::Determinant;
use std::iter;

/// The determinants at the points before the last one.
#[derive(Debug, Default)]
pub(super) struct Passed {
    /// Arclength and determinant, the last ones first.
    last: [Option<(f64, Determinant)>; BEFORE],
}

/// Points before the last one that a polynomial goes through, at most.
const BEFORE: usize = 2;
/// Where the logarithm of the determinant is extrapolated as well as this, there is no zero.
const STEADY: f64 = 0.25;
/// All errors of polynomials are in parts of the largest determinant that they go through. A step is too long where the
/// error of extrapolation at its end is larger than this,
const LARGEST: f64 = 0.15;
/// or that of interpolation in its middle is larger than this.
const INTERPOLATED: f64 = 0.1;
/// It is looked at there if the error of extrapolation is larger than this,
const LOOKED_INTO: f64 = 0.03;
/// or the determinant smaller than this at one of the ends: extrapolation may be right there by chance.
const FALLEN: f64 = 0.5;
/// Where it is smaller than this at one of them, even a steady one is looked at, and beside the ends as well,
const SMALL: f64 = 0.1;
/// where the error of interpolation is to be no larger than this.
const CERTAIN: f64 = 0.025;
/// The error of extrapolation that the next step aims at.
const AIM: f64 = 0.1;
/// Inside a step the polynomial through its ends and its middle as well is taken to be so many times more exact than
/// the extrapolated one at its end, and no more: a look may by chance find what is expected.
const INSIDE: f64 = 8.0;
/// The polynomial is searched at so many places of a step,
const PLACES: i32 = 32;
/// and between the outermost and the ends at places that come nearer by halves so often.
const HALVINGS: i32 = 6;
/// Where the determinant may be zero on a longer stretch, in parts of the step, than this, it may cross zero there more
/// than once.
const WIDE: f64 = 0.2;
/// What is known of the determinant along a step.
pub(super) enum Resolved {
    /// Enough.
    Yes {
        /// The factor by which the next step may be longer, for the determinant to be known there, too.
        longer: f64,
        /// Distances and points at which it touches zero.
        touches: Vec<(f64, Reference)>,
    },
    /// Too little, or more zeros than one: the step is to be so long.
    Shorter(f64),
}

impl Passed {
    /// Leaves a point behind.
    pub(super) fn push(&mut self, arclength: f64, at: Determinant) {
        self.last.rotate_right(1);
        self.last[0] = Some((arclength, at));
    }
}

impl Tracer<'_, '_> {
    /// Whether the determinant is known along a step that begins at the arclength that is given.
    pub(super) fn resolved(&mut self, passed: &Passed, arclength: f64, span: Span<'_>) -> Result<Resolved, SolveError> {
        let Span { first: Near { point: here, .. }, step, next, .. } = span;
        let before = passed.last.iter().flatten().map(|(place, determinant)| (place - arclength, *determinant));
        let mut known: Vec<(f64, Determinant)> = before.collect();
        let can_extrapolate = known.len() == BEFORE;
        known.push((0.0, here.determinant));
        let end = (step, next.point.determinant);
        let extrapolated = error(&known, end);
        if !extrapolated.is_finite() {
            return Ok(Resolved::longer(f64::INFINITY));
        }
        // The error of a polynomial of degree `BEFORE` goes with a power one higher of the step.
        let longer = libm::pow(AIM / extrapolated.max(f64::MIN_POSITIVE), 1.0 / (BEFORE as f64 + 1.0));
        let is_steady = is_steady(&known, end);
        known.push(end);
        let least = relative(&known).iter().rev().take(2).map(|end| end.value.abs()).fold(f64::INFINITY, f64::min);
        let is_small = least < SMALL;
        if is_steady && !is_small {
            return Ok(Resolved::longer(longer.max(1.0)));
        }
        if can_extrapolate && extrapolated > LARGEST {
            return Ok(Resolved::Shorter(0.5 * step));
        }
        let mut bound = extrapolated;
        if !can_extrapolate || least < FALLEN || extrapolated > LOOKED_INTO {
            // What cannot be looked at is taken for what the ends say.
            let Some(look) = self.look_within(span, 0.5)? else { return Ok(Resolved::longer(1.0)) };
            let interpolated = error(&known, look);
            if interpolated > INTERPOLATED {
                return Ok(Resolved::Shorter(0.5 * step));
            }
            bound = interpolated.max(extrapolated / INSIDE);
            known.push(look);
            let beside_ends = beside_ends([here.determinant, look.1, end.1]).filter(|_| is_small);
            for part in beside_ends {
                let look = self.look_within(span, part)?;
                if look.is_some_and(|look| error(&known, look) > CERTAIN) {
                    return Ok(Resolved::Shorter(0.5 * step));
                }
            }
        }
        let mut touches = Vec::new();
        for place in valleys(&Polynomial::through(&relative(&known)), step) {
            match self.extremum(span, &mut known, place)? {
                Extremum::Between(zeros) => return Ok(Resolved::Shorter(zeros)),
                Extremum::Touches(touch) => touches.push(touch),
                Extremum::Neither => {}
            }
        }
        for touch in &touches {
            known = divided(&known, touch.met, step);
        }
        let shorter = between_zeros(&Polynomial::through(&relative(&known)), step, bound);
        let within = touches.into_iter().filter(|touch| touch.met >= 0.0 && touch.met < step);
        let touches = within.map(|touch| (touch.at.clamp(0.0, step), touch.point)).collect();
        Ok(shorter.map_or(Resolved::Yes { longer, touches }, Resolved::Shorter))
    }

    /// Place and determinant at a part of a step; none where there is no point of the branch to be found.
    fn look_within(&mut self, span: Span<'_>, part: f64) -> Result<Option<(f64, Determinant)>, SolveError> {
        let at = part * span.step;
        let near = (span.first, Some(span.next.near(span.step)));
        match self.look(span, at, near, Care::Glance) {
            Err(cause) if cause.is_interruption() => Err(cause),
            Err(_) => Ok(None),
            Ok(look) => Ok(Some((at, look.point.determinant))),
        }
    }
}

impl Resolved {
    fn longer(factor: f64) -> Self {
        Self::Yes { longer: factor, touches: Vec::new() }
    }
}

/// Parts of a step beside an end towards which the determinant falls from the middle without a change of its sign:
/// there it may touch zero, or cross it twice. By the determinants at the first end, in the middle and at the last end.
fn beside_ends([first, middle, last]: [Determinant; 3]) -> impl Iterator<Item = f64> {
    let falls = move |end: &Determinant| end.orientation == middle.orientation && end.logarithm < middle.logarithm;
    [(0.25, first), (0.75, last)].into_iter().filter(move |(_, end)| falls(end)).map(|(part, _)| part)
}

/// Determinants without their double zero at a place, as far as they are known away from it.
fn divided(known: &[(f64, Determinant)], place: f64, step: f64) -> Vec<(f64, Determinant)> {
    let away = known.iter().filter(|(at, _)| (at - place).abs() > APART * step);
    away.map(|&(at, determinant)| {
        let logarithm = determinant.logarithm - 2.0 * libm::log((at - place).abs());
        (at, Determinant { logarithm, ..determinant })
    })
    .collect()
}

/// Whether the determinant grows or decays along a step as it did between all points known before, the last at the end.
fn is_steady(known: &[(f64, Determinant)], end: (f64, Determinant)) -> bool {
    let same_sign = known.iter().all(|(_, determinant)| determinant.orientation == end.1.orientation);
    let known: Vec<Known> =
        known.iter().map(|(at, determinant)| Known { at: *at, value: determinant.logarithm, slope: None }).collect();
    let error = |known: &[Known]| (Polynomial::through(known).at(end.0).0 - end.1.logarithm).abs();
    match known[..] {
        [before, .., here] => same_sign && error(&known) < STEADY && error(&[before, here]) < STEADY,
        _ => false,
    }
}

/// The error of the polynomial through known determinants at another, in parts of the largest.
fn error(known: &[(f64, Determinant)], other: (f64, Determinant)) -> f64 {
    let all: Vec<(f64, Determinant)> = known.iter().copied().chain([other]).collect();
    match relative(&all).split_last() {
        Some((other, known)) => (Polynomial::through(known).at(other.at).0 - other.value).abs(),
        None => f64::NAN,
    }
}

/// A place in (0, step) between two zeros of the polynomial, or between two that its error may hide: at most
/// `bound` in the middle of the step, and none at its ends.
fn between_zeros(polynomial: &Polynomial, step: f64, bound: f64) -> Option<f64> {
    let halves = (0..HALVINGS).map(|k| libm::exp2(-f64::from(k)) / f64::from(PLACES));
    let inner = (2..PLACES - 1).map(|k| f64::from(k) / f64::from(PLACES));
    let parts = halves.clone().rev().chain(inner).chain(halves.map(|part| 1.0 - part));
    let parts = iter::once(0.0).chain(parts).chain(iter::once(1.0));
    let value = |part: f64| polynomial.at(part * step).0;
    // The last place where the sign is certain, and the value there.
    let (mut last, mut sign) = (0.0, value(0.0));
    // Where the polynomial may vanish since then: the place with the smallest value.
    let mut hidden: Option<(f64, f64)> = None;
    let mut crossed: Option<f64> = None;
    for part in parts {
        let here = value(part);
        if here.abs() < 4.0 * bound * part * (1.0 - part) {
            hidden = hidden.filter(|(_, least)| *least <= here.abs()).or(Some((part, here.abs())));
            continue;
        }
        let touched = hidden.take();
        let zero = if here * sign < 0.0 { Some(0.5 * (last + part)) } else { touched.map(|(place, _)| place) };
        if let Some(zero) = zero {
            match crossed {
                Some(first) => return Some(0.5 * (first + zero) * step),
                // Two of them.
                None if here * sign > 0.0 => return Some(zero * step),
                // Three of them, perhaps.
                None if part - last > WIDE => return Some(if last > 0.0 { last } else { 0.5 * part } * step),
                None => crossed = Some(zero),
            }
        }
        (last, sign) = (part, here);
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::orientation::Orientation;

    fn determinant(value: f64) -> Determinant {
        Determinant { orientation: Orientation::of(value), logarithm: value.abs().ln() }
    }

    fn at(places: &[f64], f: impl Fn(f64) -> f64) -> Vec<(f64, Determinant)> {
        places.iter().map(|place| (*place, determinant(f(*place)))).collect()
    }

    #[test]
    fn a_step_ends_between_the_first_two_zeros() {
        let places = [-2.0, -1.0, 0.0, 0.5, 1.0];
        let within = |f: &dyn Fn(f64) -> f64, bound: f64| {
            between_zeros(&Polynomial::through(&relative(&at(&places, f))), 1.0, bound)
        };
        assert!(within(&|x| (x - 0.4) * (x - 0.7), 0.0).is_some_and(|at| at > 0.4 && at < 0.7));
        let three = |x: f64| (x - 0.2) * (x - 0.6) * (x - 0.8);
        assert!(within(&three, 0.0).is_some_and(|at| at > 0.2 && at < 0.6));
        // One zero, or none.
        assert_eq!(within(&|x| x - 0.3, 1e-3), None);
        assert_eq!(within(&|x| 1.0 + x * x, 1e-2), None);
        // Two that the error may hide: closer than the places at which the polynomial is searched, or just not there.
        let close = |x: f64| (x - 0.503) * (x - 0.509);
        assert_eq!(within(&close, 0.0), None);
        assert!(within(&close, 1e-4).is_some_and(|at| (at - 0.506).abs() < 0.02));
        assert!(within(&|x| (x - 0.3).powi(2) + 1e-6, 1e-3).is_some_and(|at| (at - 0.3).abs() < 0.02));
        // One that may be three.
        assert!(within(&|x| (x - 0.52).powi(3), 1e-3).is_some_and(|at| at > 0.0 && at < 0.52));
    }

    #[test]
    fn a_double_zero_hides_no_other() {
        let without = |f: &dyn Fn(f64) -> f64| {
            let known = divided(&at(&[-1.0, 0.0, 0.401, 0.8, 1.0], f), 0.4, 1.0);
            between_zeros(&Polynomial::through(&relative(&known)), 1.0, 1e-3)
        };
        assert_eq!(without(&|x| (x - 0.4).powi(2)), None);
        assert_eq!(without(&|x| (x - 0.4).powi(2) * (x - 0.6)), None, "one zero");
        let three = without(&|x| (x - 0.4).powi(2) * (x - 0.1) * (x - 0.9));
        assert!(three.is_some_and(|at| at > 0.1 && at < 0.9), "{three:?}");
    }

    #[test]
    fn exponentials_are_steady_and_functions_with_zeros_are_not() {
        let places = [-1.5, -1.0, 0.0];
        let steady = |f: &dyn Fn(f64) -> f64| is_steady(&at(&places, f), (1.0, determinant(f(1.0))));
        assert!(steady(&|x: f64| (2.0 * x).exp()) && steady(&|x: f64| -(-0.7 * x).exp()));
        assert!(!steady(&|x| (x - 0.4) * (x - 0.7)) && !steady(&|x| x - 0.5));
        assert!(!is_steady(&at(&[0.0], |_| 1.0), (1.0, determinant(1.0))), "nothing is known before");
    }

    #[test]
    fn errors_do_not_hang_on_the_size_of_the_determinant() {
        let shifted = |by: f64| -> Vec<(f64, Determinant)> {
            let all = at(&[-1.0, 0.0, 1.0], |x| 2.0 + x * x);
            all.into_iter().map(|(x, d)| (x, Determinant { logarithm: d.logarithm + by, ..d })).collect()
        };
        let error = |all: &[(f64, Determinant)]| error(&all[..2], all[2]);
        assert!((error(&shifted(0.0)) - error(&shifted(5000.0))).abs() < 1e-9);
        assert!(error(&shifted(0.0)) > 0.1);
    }
}
