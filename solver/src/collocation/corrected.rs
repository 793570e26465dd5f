//! The continuous extension of order 8: the collocation polynomial, corrected by collocation at more points.
//!
//! The collocation polynomial S₅, of degree 5, is accurate to O(h⁶). What it lacks is sought among
//! `E(σ) = σ²(1-σ)² [a + b τ + c τ² + d τ³]`, which change neither values nor slopes at the nodes, by collocation of
//! the linearised equations
//!
//! ```text
//! E'(σ_k) - h J(σ_k) E(σ_k) = h f(S₅(σ_k)) - S₅'(σ_k)
//! ```
//!
//! at the points σ_k that are neither an end nor the middle among the seven of Lobatto. Then `S = S₅ + E` is accurate
//! to O(h⁸) and its defect to O(h⁷), the leading term of which is a multiple of Lobatto's polynomial: odd, and as
//! small as can be. As the equations are solved, and slopes not evaluated one after the other, nothing is multiplied
//! by h J: where that is large, S follows what f asks of it between the nodes.

mod solve;

use super::defect::Tally;
use super::interpolant::{Extended, Extension, Pieces};
use super::stages::{MOST_STAGES, View};
use crate::basis::Basis;
use crate::error::NonFinite;
use crate::linear::memory::Numbers;
use crate::linear::scalar::{Scalar, W};
use crate::linear::simd::{Job, vectorised};
use crate::problem::Problem;
use crate::stats::Stats;
use crate::tableau::{Tableau, lagrange};
use solve::Correct;
use std::sync::OnceLock;

/// Offsets from the middle of the points of collocation, to both sides: Lobatto's seven are these, the ends and the
/// middle.
const OFFSETS: [f64; 2] = [0.234_424_396_735_357_1, 0.415_111_948_139_283_5];
/// Their weights in Lobatto's rule: at the ends and in the middle the collocation polynomial has no defect.
const WEIGHTS: [f64; 2] = [0.215_872_690_604_931_3, 0.138_413_023_680_782_97];
/// Points of collocation.
const POINTS: usize = 4;
/// Stages of the method whose derivatives are interpolated.
const STAGES: usize = MOST_STAGES;

/// τ of the points: [`OFFSETS`] to the left, then to the right.
fn offset(k: usize) -> f64 {
    if k < 2 { -OFFSETS[k] } else { OFFSETS[k - 2] }
}

/// a, b, c, d from the slopes at the points.
#[inline]
fn of_slopes(slopes: [f64; POINTS]) -> [f64; POINTS] {
    let basis = OFFSETS.map(|t| Basis::slope(0.5 + t));
    let odd = [0, 1].map(|k| 0.5 * (slopes[k + 2] - slopes[k]));
    let even = [0, 1].map(|k| 0.5 * (slopes[k + 2] + slopes[k]));
    let solved = |p: [f64; 2], q: [f64; 2], r: [f64; 2]| {
        let determinant = p[0] * q[1] - p[1] * q[0];
        [(r[0] * q[1] - r[1] * q[0]) / determinant, (p[0] * r[1] - p[1] * r[0]) / determinant]
    };
    let [a, c] = solved(basis.map(|basis| basis.alpha), basis.map(|basis| basis.gamma), odd);
    let [b, d] = solved(basis.map(|basis| basis.beta), basis.map(|basis| basis.delta), even);
    [a, b, c, d]
}

/// What values at the points follow from slopes of 1 at each of them.
fn values_of_slopes() -> [[f64; POINTS]; POINTS] {
    let mut out = [[0.0; POINTS]; POINTS];
    for l in 0..POINTS {
        let mut slopes = [0.0; POINTS];
        slopes[l] = 1.0;
        let [a, b, c, d] = of_slopes(slopes);
        for (k, out) in out.iter_mut().enumerate() {
            let basis = Basis::value(0.5 + offset(k));
            out[l] = basis.alpha * a + basis.beta * b + basis.gamma * c + basis.delta * d;
        }
    }
    out
}

/// Lagrange's weights of the stages at each point.
fn weights_of_stages(tableau: &Tableau) -> [[f64; STAGES]; POINTS] {
    std::array::from_fn(|k| std::array::from_fn(|stage| lagrange(tableau.c, stage, 0.5 + offset(k))))
}

impl<P: Problem + ?Sized> Extended<'_, '_, P> {
    /// What the collocation polynomial S₅ lacks at the points: `h f(S₅) - S₅'` point by point, component by component
    /// in working order. Its defects are counted.
    pub(super) fn lacking(
        &self,
        polynomial: &Extension,
        scales: &[f64],
        tally: &mut Tally,
        stats: &mut Stats,
    ) -> Result<Numbers, NonFinite> {
        let points = [0, 1, 2, 3].map(|k| (0.5 + offset(k), WEIGHTS[k % 2]));
        let mut lacking = Numbers::unset(POINTS * self.n() * self.intervals());
        self.counted(Some(polynomial), &points, scales, tally, &mut lacking, stats)?;
        tally.weigh_by(2.0 * (WEIGHTS[0] + WEIGHTS[1]));
        Ok(lacking)
    }

    /// From S₅ to S, α to δ; `lacking`: what S₅ lacks at the points.
    pub(super) fn correct(&self, extension: &mut Extension, scales: &[f64], lacking: &[f64]) {
        let tableau = self.system.tableau;
        let weights = PointWeights {
            of_stages: tableau.at_points.get_or_init(|| weights_of_stages(tableau)),
            of_slopes: OF_SLOPES.get_or_init(values_of_slopes),
        };
        let len = extension.alpha.len();
        (extension.gamma, extension.delta) = (Numbers::unset(len), Numbers::unset(len));
        let Extension { alpha, beta, gamma, delta } = extension;
        let pattern = &self.system.layout.regions[self.region].state_pattern;
        let bump: [&mut [f64]; 4] = [alpha, beta, gamma, delta];
        let bump = bump.map(|values| values.as_chunks_mut::<W>().0);
        let (lacking, h) = (lacking.as_chunks::<W>().0, self.h().as_chunks::<W>().0);
        let roles = &*self.stages.roles;
        Correct { pattern, views: self.stages.views(self.steps()), h, scales, weights, roles, lacking, bump }
            .vectorised();
    }

    /// The collocation polynomial: α and β from the slopes at the outer two of the inner stages.
    pub(super) fn collocation_polynomial(&self) -> Extension {
        let bases = [2, 3].map(|stage| Basis::slope(self.system.tableau.c[stage]));
        let (cubic, mut extension, views) = (self.pieces(None), self.flat(), self.stages.views(self.steps()));
        let Extension { alpha, beta, .. } = &mut extension;
        vectorised(Interpolate { cubic, views, bases, alpha, beta });
        extension
    }
}

/// α and β of the collocation polynomial.
struct Interpolate<'a> {
    cubic: Pieces<'a>,
    views: [View<'a>; STAGES],
    /// Weights in the slopes of the cubic at the outer two of the inner stages.
    bases: [Basis; 2],
    alpha: &'a mut [f64],
    beta: &'a mut [f64],
}

impl Job for Interpolate<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self { cubic, views, bases, alpha, beta } = self;
        let (alpha, beta) = (alpha.as_chunks_mut::<W>().0, beta.as_chunks_mut::<W>().0);
        for (at, (alpha, beta)) in alpha.iter_mut().zip(beta).enumerate() {
            let (i, t) = (at / cubic.steps, at % cubic.steps);
            let piece = cubic.piece(i, t);
            let (low, high) = (views[2].f(i, t), views[3].f(i, t));
            let low = cubic.length(t) * low - piece.weigh(&bases[0]);
            let high = cubic.length(t) * high - piece.weigh(&bases[1]);
            *alpha = (high - low).map(|odd| 0.5 * odd / bases[1].alpha).0;
            *beta = (high + low).map(|even| 0.5 * even / bases[1].beta).0;
        }
    }
}

/// What is the same in every solve.
#[derive(Clone, Copy)]
struct PointWeights {
    /// See [`weights_of_stages`].
    of_stages: &'static [[f64; STAGES]; POINTS],
    /// See [`values_of_slopes`].
    of_slopes: &'static [[f64; POINTS]; POINTS],
}

static OF_SLOPES: OnceLock<[[f64; POINTS]; POINTS]> = OnceLock::new();

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tableau::ORDER_8;

    #[test]
    fn values_follow_from_slopes_and_stages_determine_quartics() {
        let (a, b, c, d) = (0.3, -1.2, 2.5, 0.7);
        let weigh = |basis: Basis| basis.alpha * a + basis.beta * b + basis.gamma * c + basis.delta * d;
        let slopes = [0, 1, 2, 3].map(|k| weigh(Basis::slope(0.5 + offset(k))));
        for (found, wanted) in of_slopes(slopes).into_iter().zip([a, b, c, d]) {
            assert!((found - wanted).abs() < 1e-13, "{found} is not {wanted}");
        }
        for (k, weights) in values_of_slopes().into_iter().enumerate() {
            let value: f64 = weights.iter().zip(slopes).map(|(weight, slope)| weight * slope).sum();
            assert!((value - weigh(Basis::value(0.5 + offset(k)))).abs() < 1e-15);
        }
        for (k, weights) in weights_of_stages(&ORDER_8).into_iter().enumerate() {
            for power in 0..STAGES as i32 {
                let value: f64 = weights.iter().zip(ORDER_8.c).map(|(weight, c)| weight * c.powi(power)).sum();
                assert!((value - (0.5 + offset(k)).powi(power)).abs() < 1e-14);
            }
        }
    }

    /// The points, the ends and the middle are those of Lobatto: zeros of σ(1-σ) P₆'(2σ-1).
    #[test]
    fn points_are_lobattos() {
        for t in OFFSETS {
            let x = 2.0 * t;
            // P₆' = 21/8 x (33 x⁴ - 30 x² + 5).
            assert!((33.0 * x.powi(4) - 30.0 * x * x + 5.0).abs() < 1e-14);
        }
    }
}
