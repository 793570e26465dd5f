//! Where the belt begins to slide, and how such places move from one drive to the next.
//!
//! There friction reaches its full strength within one slip threshold: solutions have a kink, and meshes are fine. What
//! is predicted at a place that the kink passes over belongs to neither side of it. So solutions are compared, and
//! predicted, at places that move with the kinks, and the mesh goes with them.

use solver::RegionSolution;

use crate::drive::belt::BeltProblem;
use crate::drive::region::RegionId;
use crate::model::{Constant, Field};

/// A piece between two kinks may become so many times as long or as short; beyond that they have not moved, but come
/// and gone.
const MOST_STRETCHED: f64 = 4.0;

/// How far each place of a contact moves in one step ahead, if kinks move on as they have to where they are `now` from
/// where they were `then`, `back` such steps behind. The ends stay. Nothing where kinks of the two do not belong
/// together one by one.
pub(super) fn drift(mesh: &[f64], then: &[f64], now: &[f64], back: f64) -> Option<Vec<f64>> {
    if then.len() != now.len() {
        return None;
    }
    let rates: Vec<f64> = then.iter().zip(now).map(|(then, now)| (now - then) / back).collect();
    spread(mesh, now, &rates, &[1.0, -back])
}

/// The same where all that is known is to where each kink moves.
pub(super) fn drift_to(mesh: &[f64], now: &[f64], next: &[f64]) -> Option<Vec<f64>> {
    let rates: Vec<f64> = now.iter().zip(next).map(|(now, next)| next - now).collect();
    spread(mesh, now, &rates, &[1.0])
}

/// The rates of kinks spread over all places, linear between them; nothing where so many `steps` on a piece would be
/// too long or too short.
fn spread(mesh: &[f64], kinks: &[f64], rates: &[f64], steps: &[f64]) -> Option<Vec<f64>> {
    if kinks.is_empty() {
        return None;
    }
    let (first, last) = (*mesh.first()?, *mesh.last()?);
    let inner = kinks.iter().copied().zip(rates.iter().copied());
    let knots: Vec<(f64, f64)> = std::iter::once((first, 0.0)).chain(inner).chain([(last, 0.0)]).collect();
    let moderate = |pair: &[(f64, f64)]| {
        let (length, growth) = (pair[1].0 - pair[0].0, pair[1].1 - pair[0].1);
        let held =
            |steps: &f64| (1.0 / MOST_STRETCHED..=MOST_STRETCHED).contains(&((length + steps * growth) / length));
        steps.iter().all(held)
    };
    let drift = |s: &f64| {
        let after = knots.partition_point(|(knot, _)| knot <= s).clamp(1, knots.len() - 1);
        let ((a, x), (b, y)) = (knots[after - 1], knots[after]);
        x + (y - x) * (s - a) / (b - a)
    };
    knots.windows(2).all(moderate).then(|| mesh.iter().map(drift).collect())
}

/// Where the sliding speed passes the slip threshold along a contact.
pub(super) fn kinks(
    belt: &BeltProblem,
    region: RegionId,
    part: &RegionSolution,
    constants: &[f64],
) -> Option<Vec<f64>> {
    let states: Vec<f64> = (0..part.states()).flat_map(|state| part.state(state)).copied().collect();
    Some(zeros(part.mesh(), &beyond_threshold(belt, region, &states, constants)?))
}

/// By how much the sliding speed exceeds the slip threshold at places of a contact, m/s, from its states, state by
/// state; nothing for a kernel that has no sliding speed.
pub(super) fn beyond_threshold(
    belt: &BeltProblem,
    region: RegionId,
    states: &[f64],
    constants: &[f64],
) -> Option<Vec<f64>> {
    let threshold = constants.get(Constant::SlipThreshold.index())?;
    let speeds = belt.field(region, Field::SlidingSpeed, states, constants)?;
    Some(speeds.iter().map(|speed| speed - threshold).collect())
}

/// Where a function changes its sign, linear between its samples.
pub(super) fn zeros(s: &[f64], values: &[f64]) -> Vec<f64> {
    let zero = |(s, v): (&[f64], &[f64])| {
        let crossed = (v[0] < 0.0) != (v[1] < 0.0);
        crossed.then(|| s[0] + (s[1] - s[0]) * v[0] / (v[0] - v[1])).filter(|zero| zero.is_finite())
    };
    s.windows(2).zip(values.windows(2)).filter_map(zero).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nodes_move_with_the_kinks_and_the_ends_stay() {
        let mesh = [0.0, 0.2, 0.3, 0.5, 0.6, 0.8, 1.0];
        // Half a step back, so twice as far ahead.
        let moved = drift(&mesh, &[0.28, 0.61], &[0.3, 0.6], 0.5).expect("they belong together");
        for (found, expected) in moved.iter().zip([0.0, 2.0 / 3.0 * 0.04, 0.04, 0.0, -0.02, -0.01, 0.0]) {
            assert!((found - expected).abs() < 1e-12, "{moved:?}");
        }
        // Ahead alone: the same kinks; one piece may be longer than a step back would leave it.
        let moved = drift_to(&mesh, &[0.3, 0.6], &[0.34, 0.58]).expect("they stay apart");
        for (found, expected) in moved.iter().zip([0.0, 2.0 / 3.0 * 0.04, 0.04, 0.0, -0.02, -0.01, 0.0]) {
            assert!((found - expected).abs() < 1e-12, "{moved:?}");
        }
        assert!(
            drift_to(&mesh, &[0.2, 0.3], &[0.2, 0.4]).is_some()
                && drift(&mesh, &[0.2, 0.2], &[0.2, 0.3], 1.0).is_none()
        );
        assert_eq!(drift_to(&mesh, &[0.3, 0.6], &[0.6, 0.5]), None);
        assert_eq!(drift_to(&mesh, &[], &[]), None);
        // One that is new, none at all, two that would pass each other, one that would pass the end.
        for (then, now) in [(&[0.3][..], &[0.3, 0.6][..]), (&[], &[]), (&[0.2, 0.6], &[0.4, 0.5]), (&[0.5], &[0.9])] {
            assert_eq!(drift(&mesh, then, now, 1.0), None, "{then:?} {now:?}");
        }
    }

    #[test]
    fn zeros_are_found_between_samples() {
        let s = [0.0, 0.25, 0.5, 1.0];
        assert_eq!(zeros(&s, &[-1.0, -0.5, 0.5, -0.5]), [0.375, 0.75]);
        assert!(zeros(&s, &[1.0, 2.0, 3.0, f64::NAN]).is_empty());
    }
}
