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

use super::defect::Tally;
use super::interpolant::{Basis, Extended, Extension, Pieces};
use super::roles::{Pairs, Role, Roles};
use super::stages::{MOST_STAGES, View};
use crate::error::NonFinite;
use crate::linear::memory::{Lanes, Numbers};
use crate::linear::qr;
use crate::linear::scalar::{Lane, Scalar, W};
use crate::linear::simd::{Job, vectorised};
use crate::problem::Problem;
use crate::stats::Stats;
use crate::tableau::{LOBATTO_OFFSET, Tableau};
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
    let mut out = [[1.0; STAGES]; POINTS];
    for (k, out) in out.iter_mut().enumerate() {
        for (j, weight) in out.iter_mut().enumerate() {
            for (i, c) in tableau.c.iter().enumerate().filter(|&(i, _)| i != j) {
                *weight *= (0.5 + offset(k) - c) / (tableau.c[j] - tableau.c[i]);
            }
        }
    }
    out
}

impl<P: Problem + ?Sized> Extended<'_, '_, P> {
    /// What the collocation polynomial S₅ lacks at the points: `h f(S₅) - S₅'` point by point, component by component in
    /// working order. Its defects are counted.
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
        let weights = POINT_WEIGHTS.get_or_init(|| PointWeights {
            of_stages: weights_of_stages(self.system.tableau),
            of_slopes: values_of_slopes(),
        });
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
        let bases = [0.5 - LOBATTO_OFFSET, 0.5 + LOBATTO_OFFSET].map(Basis::slope);
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
            let [low, high] = [0, 1].map(|k| cubic.length(t) * views[2 + k].f(i, t) - cubic.weigh(&bases[k], i, t));
            *alpha = (high - low).map(|odd| 0.5 * odd / bases[1].alpha).0;
            *beta = (high + low).map(|even| 0.5 * even / bases[1].beta).0;
        }
    }
}

/// What is the same in every solve.
struct PointWeights {
    /// See [`weights_of_stages`].
    of_stages: [[f64; STAGES]; POINTS],
    /// See [`values_of_slopes`].
    of_slopes: [[f64; POINTS]; POINTS],
}

static POINT_WEIGHTS: OnceLock<PointWeights> = OnceLock::new();

/// Solves for E at the points, interval by interval, and adds what has these values to α to δ.
struct Correct<'a> {
    pattern: &'a [(usize, usize)],
    /// Values at the stages.
    views: [View<'a>; STAGES],
    h: &'a [[f64; W]],
    scales: &'a [f64],
    weights: &'a PointWeights,
    /// What each state is in the equations for E.
    roles: &'a Roles,
    /// Point by point, component by component in working order: the slopes wanted of E.
    lacking: &'a [[f64; W]],
    /// α, β, γ, δ.
    bump: [&'a mut [[f64; W]]; 4],
}

impl Correct<'_> {
    /// Not generic, so that it is compiled once and not with every problem.
    #[inline(never)]
    fn vectorised(self) {
        vectorised(self);
    }

    /// Derivatives of one entry at the points, in vectors.
    #[inline(always)]
    fn derivatives(&self, entry: usize, t: usize) -> [Lane; POINTS] {
        let mut out = [Lane::ZERO; POINTS];
        for (stage, view) in self.views.iter().enumerate() {
            let known = view.dy(entry, t);
            for (out, weights) in out.iter_mut().zip(&self.weights.of_stages) {
                *out += known.times(weights[stage]);
            }
        }
        out
    }
}

impl Job for Correct<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        // Compiled once more each for one or two equations of second order and nothing else.
        if let Some(pairs) = self.roles.pairs::<1>() {
            self.solve_pairs::<1, 2, 4>(pairs);
        } else if let Some(pairs) = self.roles.pairs::<2>() {
            self.solve_pairs::<2, 4, 8>(pairs);
        } else {
            self.solve();
        }
    }
}

impl Correct<'_> {
    /// The slopes wanted of E, taken to the points: `values_of_slopes` times them, of state `i`.
    #[inline(always)]
    fn wanted(&self, i: usize, t: usize) -> [Lane; POINTS] {
        let (n, steps) = (self.scales.len(), self.h.len());
        let lacking: [Lane; POINTS] = std::array::from_fn(|l| Lane(self.lacking[(l * n + i) * steps + t]));
        self.weights.of_slopes.map(|weights| {
            let sum = lacking.iter().zip(weights).fold(Lane::ZERO, |sum, (slope, weight)| sum + slope.times(weight));
            sum.times(1.0 / self.scales[i])
        })
    }

    /// As [`solve`](Self::solve), where `Q` states are unknowns and the other `Q` of `N` their integrals; `M` unknowns
    /// at the points. All sizes are known when compiled.
    #[inline(always)]
    fn solve_pairs<const Q: usize, const N: usize, const M: usize>(mut self, pairs: Pairs<Q>) {
        let (Pairs { unknowns: v, integrals: u }, from_slopes) = (pairs, self.weights.of_slopes);
        let mut data = Lanes::unset(qr::room(M));
        for t in 0..self.h.len() {
            let h = Lane(self.h[t]);
            let rise: [Lane; Q] = std::array::from_fn(|r| h.times(self.scales[v[r]] / self.scales[u[r]]));
            let mut by_u = u.map(|state| self.wanted(state, t));
            let wanted = v.map(|state| self.wanted(state, t));
            let mut by_v: [Lane; M] = std::array::from_fn(|at| wanted[at % Q][at / Q]);
            let mut jacobian = [[[Lane::ZERO; POINTS]; N]; N];
            let unknown = |(_, (row, _)): &(usize, &(usize, usize))| v.contains(row);
            for (entry, &(row, state)) in self.pattern.iter().enumerate().filter(unknown) {
                let factor = h.times(self.scales[state] / self.scales[row]);
                for (sum, derivative) in jacobian[row][state].iter_mut().zip(self.derivatives(entry, t)) {
                    *sum += derivative * factor;
                }
            }
            let matrix = qr::matrix(M, &mut data);
            for r in 0..Q {
                for c in 0..Q {
                    let (by_integral, by_unknown) = (jacobian[v[r]][u[c]], jacobian[v[r]][v[c]]);
                    for k in 0..POINTS {
                        for j in 0..POINTS {
                            by_v[k * Q + r] += (by_integral[j] * by_u[c][j]).times(from_slopes[k][j]);
                        }
                        for l in 0..POINTS {
                            let mut twice = Lane::ZERO;
                            for j in 0..POINTS {
                                twice += by_integral[j].times(from_slopes[k][j] * from_slopes[j][l]);
                            }
                            let moved = by_unknown[l].times(from_slopes[k][l]) + twice * rise[c];
                            let same = if (k, r) == (l, c) { Lane::ONE } else { Lane::ZERO };
                            matrix[(l * Q + c) * M + k * Q + r] = same - moved;
                        }
                    }
                }
            }
            qr::factor(M, &mut data);
            qr::solve(M, &data, &mut by_v);
            for r in 0..Q {
                let unknown: [Lane; POINTS] = std::array::from_fn(|k| by_v[k * Q + r]);
                for (by_u, weights) in by_u[r].iter_mut().zip(from_slopes) {
                    for (unknown, weight) in unknown.iter().zip(weights) {
                        *by_u += (rise[r] * *unknown).times(weight);
                    }
                }
                self.add(u[r] * self.h.len() + t, by_u[r].map(|e| e.times(self.scales[u[r]])));
                self.add(v[r] * self.h.len() + t, unknown.map(|e| e.times(self.scales[v[r]])));
            }
        }
    }

    #[inline(always)]
    fn solve(mut self) {
        let (n, q, steps) = (self.scales.len(), self.roles.unknowns.len(), self.h.len());
        let m = POINTS * q;
        let (roles, from_slopes) = (self.roles, &self.weights.of_slopes);
        let (mut data, mut e, mut unknowns) = (Lanes::unset(qr::room(m)), Lanes::unset(POINTS * n), Lanes::unset(m));
        for t in 0..steps {
            let h = Lane(self.h[t]);
            for i in 0..n {
                for (k, wanted) in self.wanted(i, t).into_iter().enumerate() {
                    e[k * n + i] = wanted;
                }
            }
            self.assemble((q, n), t, h, qr::matrix(m, &mut data), &mut e);
            qr::factor(m, &mut data);
            for k in 0..POINTS {
                for (r, &row) in roles.unknowns.iter().enumerate() {
                    unknowns[k * q + r] = e[k * n + row];
                }
            }
            qr::solve(m, &data, &mut unknowns);
            for k in 0..POINTS {
                for (r, &row) in roles.unknowns.iter().enumerate() {
                    e[k * n + row] = unknowns[k * q + r];
                }
            }
            for &(u, v) in &roles.integrals {
                let rise = h.times(self.scales[v] / self.scales[u]);
                for (k, weights) in from_slopes.iter().enumerate() {
                    for (l, &weight) in weights.iter().enumerate() {
                        let risen = (rise * e[l * n + v]).times(weight);
                        e[k * n + u] += risen;
                    }
                }
            }
            for (i, &scale) in self.scales.iter().enumerate() {
                self.add(i * steps + t, [0, 1, 2, 3].map(|k| e[k * n + i].times(scale)));
            }
        }
    }

    /// The matrix of the equations for the unknowns among E at the points of one interval. What is known of the others,
    /// in `e`, goes to the right-hand sides there.
    #[inline(always)]
    fn assemble(&self, (q, n): (usize, usize), t: usize, h: Lane, matrix: &mut [Lane], e: &mut [Lane]) {
        let (m, roles, from_slopes) = (POINTS * q, self.roles, &self.weights.of_slopes);
        matrix.fill(Lane::ZERO);
        for i in 0..m {
            matrix[i * m + i] = Lane::ONE;
        }
        for (entry, &(row, state)) in self.pattern.iter().enumerate().filter(|(_, (row, _))| *row < n) {
            let Role::Unknown(r) = roles.of[row] else { continue };
            let factor = h.times(self.scales[state] / self.scales[row]);
            let derivatives = self.derivatives(entry, t).map(|derivative| derivative * factor);
            match roles.of[state] {
                Role::Unknown(column) => {
                    for (l, &value) in derivatives.iter().enumerate() {
                        for (k, weights) in from_slopes.iter().enumerate() {
                            matrix[(l * q + column) * m + k * q + r] -= value.times(weights[l]);
                        }
                    }
                }
                Role::IntegralOf(column) => {
                    let rise = h.times(self.scales[roles.unknowns[column]] / self.scales[state]);
                    for (j, &value) in derivatives.iter().enumerate() {
                        let (known, moved) = (value * e[j * n + state], value * rise);
                        for (k, weights) in from_slopes.iter().enumerate() {
                            e[k * n + row] += known.times(weights[j]);
                            let moved = moved.times(weights[j]);
                            for (l, &weight) in from_slopes[j].iter().enumerate() {
                                matrix[(l * q + column) * m + k * q + r] -= moved.times(weight);
                            }
                        }
                    }
                }
            }
        }
    }

    /// Adds what has the values `e` at the points.
    #[inline(always)]
    fn add(&mut self, at: usize, e: [Lane; POINTS]) {
        let square = OFFSETS.map(|t| t * t);
        // a + c τ² and b + d τ² at both offsets, and from them a, b, c, d.
        let bump = OFFSETS.map(|t| Basis::value(0.5 + t).alpha);
        let even = [0, 1].map(|k| (e[k + 2] + e[k]).map(|sum| 0.5 * sum / bump[k]));
        let odd = [0, 1].map(|k| (e[k + 2] - e[k]).map(|difference| 0.5 * difference / (bump[k] * OFFSETS[k])));
        let bend = |at: [Lane; 2]| (at[1] - at[0]).map(|rise| rise / (square[1] - square[0]));
        let (even_bend, odd_bend) = (bend(even), bend(odd));
        let [alpha, beta, gamma, delta] = &mut self.bump;
        alpha[at] = (Lane(alpha[at]) + even[0] - even_bend.times(square[0])).0;
        beta[at] = (Lane(beta[at]) + odd[0] - odd_bend.times(square[0])).0;
        (gamma[at], delta[at]) = (even_bend.0, odd_bend.0);
    }
}

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
