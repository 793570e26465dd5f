//! The continuous extension of the collocation solution, and its defect.
//!
//! On an interval, with `σ = (s - t_j)/h` and H the cubic Hermite interpolant of node values and slopes,
//!
//! ```text
//! S(σ) = H(σ) + σ²(1-σ)² [α + β τ + γ τ² + δ τ³],      τ = σ - 1/2
//! ```
//!
//! is continuously differentiable for any α, β, γ, δ; the last two are for order 8 alone. Order 4: β = 0, and α from
//! the slopes at two points (bootstrapping as in W. H. Enright and P. H. Muir, SIAM J. Sci. Comput. 17 (1996)
//! 479-497), so that the defect is O(h⁴). Order 6: S takes at the middle the value `(y_0 + y_1)/2 + h [(f_0 - f_1)/24
//! + (K_3 - K_4)/6]`, in which the O(h⁴) errors of the stages K_3 and K_4 at 1/4 and 3/4 cancel, and the slope there;
//! both are accurate to O(h⁶), and the defect is O(h⁵). Order 8: see [`corrected`](super::corrected).

use super::defect::Defects;
use super::evaluate::Stages;
use super::{Iterate, System};
use crate::error::NonFinite;
use crate::linear::memory::Numbers;
use crate::linear::scalar::W;
use crate::linear::simd::elementwise;
use crate::problem::{Points, Problem};
use crate::stats::Stats;
use crate::tableau::{QUARTIC_OFFSET, QUARTIC_SLOPE};

/// α, β, γ, δ of all intervals of a region, component by component in working order.
#[derive(Debug, Clone)]
pub(crate) struct Extension {
    pub alpha: Numbers,
    pub beta: Numbers,
    /// Empty below order 8, as is δ.
    pub gamma: Numbers,
    pub delta: Numbers,
}

/// Weights of `y_0`, `y_1 - y_0`, `h f_0`, `h f_1`, `α`, `β`, `γ`, `δ` in S and in its derivatives at one σ.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Basis {
    pub rise: f64,
    pub left: f64,
    pub right: f64,
    pub alpha: f64,
    pub beta: f64,
    pub gamma: f64,
    pub delta: f64,
}

impl Basis {
    /// Weights in S; that of `y_0` is 1.
    #[inline]
    pub(crate) fn value(x: f64) -> Self {
        let z = 1.0 - x;
        let (bump, t) = (x * x * z * z, x - 0.5);
        Self {
            rise: x * x * (3.0 - 2.0 * x),
            left: x * z * z,
            right: -x * x * z,
            alpha: bump,
            beta: bump * t,
            gamma: bump * t * t,
            delta: bump * t * t * t,
        }
    }

    /// Weights in dS/dσ; that of `y_0` is 0.
    #[inline]
    pub(crate) fn slope(x: f64) -> Self {
        let z = 1.0 - x;
        let (value, bump, t) = (x * x * z * z, 2.0 * x * z * (1.0 - 2.0 * x), x - 0.5);
        Self {
            rise: 6.0 * x * z,
            left: z * (1.0 - 3.0 * x),
            right: -x * (2.0 - 3.0 * x),
            alpha: bump,
            beta: bump * t + value,
            gamma: bump * t * t + 2.0 * value * t,
            delta: bump * t * t * t + 3.0 * value * t * t,
        }
    }

    /// Weights in d²S/dσ²; that of `y_0` is 0.
    pub(crate) fn curvature(x: f64) -> Self {
        let (slope, curvature) = (2.0 * x * (1.0 - x) * (1.0 - 2.0 * x), 2.0 - 12.0 * x * (1.0 - x));
        let (value, t) = (x * x * (1.0 - x) * (1.0 - x), x - 0.5);
        Self {
            rise: 6.0 - 12.0 * x,
            left: 6.0 * x - 4.0,
            right: 6.0 * x - 2.0,
            alpha: curvature,
            beta: curvature * t + 2.0 * slope,
            gamma: curvature * t * t + 4.0 * slope * t + 2.0 * value,
            delta: curvature * t * t * t + 6.0 * slope * t * t + 6.0 * value * t,
        }
    }
}

/// Points of one evaluation at the same σ in all intervals; reused from one to the next.
pub(super) struct Sample {
    s: Numbers,
    y: Numbers,
}

/// One region at a converged iterate.
pub(crate) struct Extended<'a, 'p, P: Problem + ?Sized> {
    pub system: &'a System<'p, P>,
    pub region: usize,
    pub x: &'a Iterate,
    pub stages: &'a Stages,
}

impl<P: Problem + ?Sized> Extended<'_, '_, P> {
    /// An extension that adds nothing to the cubic.
    pub(super) fn no_extension(&self) -> Extension {
        let len = self.n() * self.intervals();
        Extension {
            alpha: Numbers::zeros(len),
            beta: Numbers::zeros(len),
            gamma: Numbers::default(),
            delta: Numbers::default(),
        }
    }

    /// That of order 4 or 6: see the module's head.
    ///
    /// # Errors
    /// The right-hand side is undefined between the collocation points.
    pub(super) fn bootstrapped(
        &self,
        extension: &mut Extension,
        sample: &mut Sample,
        stats: &mut Stats,
    ) -> Result<(), NonFinite> {
        if self.system.tableau.order == 6 {
            return self.match_middle(extension, sample, stats);
        }
        let intervals = self.intervals();
        let (mut slope, mut f) = (Numbers::zeros(intervals), self.room_of_slopes());
        for (sigma, sign) in [(0.5 - QUARTIC_OFFSET, 1.0), (0.5 + QUARTIC_OFFSET, -1.0)] {
            self.sample(None, sigma, (&mut *sample, &mut f), stats)?;
            let basis = Basis::slope(sigma);
            for (i, alpha) in extension.alpha.chunks_exact_mut(intervals).enumerate() {
                self.weigh(None, &basis, i, &mut slope);
                elementwise(alpha, [self.h(), &f[i * intervals..], &slope], |alpha, [h, f, slope]| {
                    alpha + 0.5 * sign * (h * f - slope) / QUARTIC_SLOPE
                });
            }
        }
        Ok(())
    }

    /// Value and slope at the middle of each interval, to O(h⁶).
    fn match_middle(&self, extension: &mut Extension, sample: &mut Sample, stats: &mut Stats) -> Result<(), NonFinite> {
        let intervals = self.intervals();
        let (value, slope) = (Basis::value(0.5), Basis::slope(0.5));
        let mut cubic = Numbers::zeros(intervals);
        for (i, alpha) in extension.alpha.chunks_exact_mut(intervals).enumerate() {
            let stage = |stage| self.stages.slope(stage, i, intervals);
            let (y0, y1) = self.values(i);
            self.weigh(None, &value, i, &mut cubic);
            elementwise(alpha, [stage(0), stage(1), stage(2), stage(3), self.h()], |_, [f0, f1, f3, f4, h]| {
                h * ((f0 - f1) / 24.0 + (f3 - f4) / 6.0)
            });
            elementwise(alpha, [y0, y1, &cubic], |rise, [y0, y1, cubic]| {
                (0.5 * (y1 - y0) + rise - cubic) / value.alpha
            });
        }
        let mut f = self.room_of_slopes();
        self.sample(Some(extension), 0.5, (sample, &mut f), stats)?;
        for i in 0..self.n() {
            self.weigh(Some(extension), &slope, i, &mut cubic);
            let beta = &mut extension.beta[i * intervals..(i + 1) * intervals];
            elementwise(beta, [self.h(), &f[i * intervals..], &cubic], |_, [h, f, known]| (h * f - known) / slope.beta);
        }
        Ok(())
    }

    pub(super) fn n(&self) -> usize {
        self.system.plan.regions[self.region].n
    }

    pub(super) fn nodes(&self) -> usize {
        self.system.grids[self.region].node_stride()
    }

    pub(super) fn intervals(&self) -> usize {
        self.system.grids[self.region].interval_stride()
    }

    pub(super) fn h(&self) -> &[f64] {
        &self.system.grids[self.region].h
    }

    /// Component `i` at the left and right nodes of all intervals.
    pub(super) fn values(&self, i: usize) -> (&[f64], &[f64]) {
        let y = &self.x.y[self.region][i * self.nodes()..(i + 1) * self.nodes()];
        (&y[..self.intervals()], &y[W..])
    }

    /// The weighted sums of a basis (without `y_0`), component `i`, all intervals. Without extension: of the cubic.
    pub(super) fn weigh(&self, extension: Option<&Extension>, basis: &Basis, i: usize, out: &mut [f64]) {
        self.weigh_from(0.0, extension, basis, i, out);
    }

    /// The same, and `y_0` with a weight of its own.
    fn weigh_from(&self, start: f64, extension: Option<&Extension>, basis: &Basis, i: usize, out: &mut [f64]) {
        let (y0, y1) = self.values(i);
        let (f0, f1, h) = (self.stages.slope(0, i, out.len()), self.stages.slope(1, i, out.len()), self.h());
        let first = i * out.len();
        let cubic = |y0: f64, y1: f64, f0: f64, f1: f64, h: f64| {
            basis.rise * (y1 - y0) + h * (basis.left * f0 + basis.right * f1)
        };
        // y_0 is by far the largest, and comes last: what is rounded then is rounded once.
        match extension {
            None => {
                elementwise(out, [y0, y1, f0, f1, h], |_, [y0, y1, f0, f1, h]| start * y0 + cubic(y0, y1, f0, f1, h))
            }
            Some(Extension { alpha, beta, delta, .. }) if delta.is_empty() => {
                let inputs = [y0, y1, f0, f1, h, &alpha[first..], &beta[first..]];
                elementwise(out, inputs, |_, [y0, y1, f0, f1, h, alpha, beta]| {
                    start * y0 + (cubic(y0, y1, f0, f1, h) + basis.alpha * alpha + basis.beta * beta)
                });
            }
            Some(Extension { alpha, beta, gamma, delta }) => {
                let bump = [&alpha[first..], &beta[first..], &gamma[first..], &delta[first..]];
                let inputs = [y0, y1, f0, f1, h, bump[0], bump[1], bump[2], bump[3]];
                elementwise(out, inputs, |_, [y0, y1, f0, f1, h, alpha, beta, gamma, delta]| {
                    let quintic = cubic(y0, y1, f0, f1, h) + basis.alpha * alpha + basis.beta * beta;
                    start * y0 + (quintic + basis.gamma * gamma + basis.delta * delta)
                });
            }
        }
    }

    /// Room for [`sample`](Self::sample).
    pub(super) fn room(&self) -> Sample {
        let (intervals, n) = (self.intervals(), self.n());
        Sample { s: Numbers::zeros(intervals), y: Numbers::zeros(n * intervals) }
    }

    /// Room for f at one sample, all rows.
    pub(super) fn room_of_slopes(&self) -> Numbers {
        Numbers::zeros(self.system.plan.regions[self.region].rows * self.intervals())
    }

    /// S and f(S) at one σ in all intervals. Without extension: of the cubic.
    pub(super) fn sample(
        &self,
        extension: Option<&Extension>,
        sigma: f64,
        (sample, f): (&mut Sample, &mut [f64]),
        stats: &mut Stats,
    ) -> Result<(), NonFinite> {
        let (basis, intervals) = (Basis::value(sigma), self.intervals());
        for (i, y) in sample.y.chunks_exact_mut(intervals).enumerate() {
            self.weigh_from(1.0, extension, &basis, i, y);
        }
        let grid = &self.system.grids[self.region];
        elementwise(&mut sample.s, [&grid.s, &grid.h], |_, [s, h]| s + sigma * h);
        let at = Points { len: intervals, stride: intervals, s: &sample.s, y: &sample.y };
        stats.rhs_points += intervals;
        self.system.problem.rhs(self.region, &at, &self.x.constants, f);
        self.system.check_values(self.region, &at, f)
    }

    /// Right-hand sides of the linearised interval equations, and of each integral's, for the error `ε = S - y` at the
    /// nodes: as [`Defects::integrated`], J, but with what the defect does to the inner stages, as order 6 needs.
    ///
    /// `ε' = f_y ε + S' - f(S)` is rough where S is not the solution. As smooth as the method takes a solution to be is
    /// `e = S̃ - y` with `S̃ = y_0 + ∫ f(S) ds`, of which `e' = f_y ε`, `e_0 = ε_0` and `e_1 = ε_1 - J`. Its stages are
    /// those of the method, and `ε = e + S - S̃` there: all that the nodes' errors do not know of is in
    /// `X_r = S - S̃ - v_r J + h Σ_k x_rk f_y X_k`. The derivatives are those at the stages: nothing is evaluated anew.
    pub(crate) fn improved(&self, extension: &Extension, defects: &Defects) -> Numbers {
        let (tableau, n, len) = (self.system.tableau, self.n(), self.intervals());
        let rows = self.system.plan.regions[self.region].rows;
        let pattern = &self.system.layout.regions[self.region].state_pattern;
        let (h, jump) = (self.h(), |state: usize| &defects.integrated[state * len..][..len]);
        let mut integrated = defects.integrated.clone();
        for &(u, v) in &self.stages.chained {
            // v counts half at either node, at the right one with e_1; the integral of S̃ - S is that of its stages.
            let weight = tableau.b[1] - 0.5;
            elementwise(&mut integrated[u * len..][..len], [jump(v), h], |sum, [jump, h]| sum + weight * h * jump);
        }
        // X, and f_y X of the stages so far.
        let (mut moved, mut slopes) = (Numbers::zeros(n * len), Vec::<Numbers>::new());
        for stage in 2..tableau.stages() {
            let v_r = tableau.v[stage];
            self.improvement(extension, defects, stage, &mut moved);
            for &(u, v) in &self.stages.chained {
                let out = &mut integrated[u * len..][..len];
                elementwise(out, [&moved[v * len..], h], |sum, [rise, h]| sum - tableau.b[stage] * h * rise);
            }
            for (state, moved) in moved.chunks_exact_mut(len).enumerate() {
                elementwise(moved, [jump(state)], |rise, [jump]| -rise - v_r * jump);
                for (slopes, &x) in slopes.iter().zip(tableau.x[stage].iter().skip(2)) {
                    elementwise(moved, [&slopes[state * len..], h], |moved, [slope, h]| moved + x * h * slope);
                }
            }
            if let Some(odd) = tableau.odd_part(stage) {
                for &(u, v) in &self.stages.chained {
                    elementwise(&mut moved[u * len..][..len], [jump(u), jump(v), h], |moved, [below, above, h]| {
                        moved + odd * (6.0 * h * above - 12.0 * below)
                    });
                }
            }
            let mut slope = Numbers::zeros(rows * len);
            let dy = &self.stages.inner[stage - 2].dy;
            for (entry, &(row, state)) in pattern.iter().enumerate() {
                let inputs = [&dy[entry * len..], &moved[state * len..]];
                elementwise(&mut slope[row * len..][..len], inputs, |sum, [dy, moved]| sum + dy * moved);
            }
            for (row, out) in integrated.chunks_exact_mut(len).enumerate() {
                if let Some(&(_, v)) = self.stages.chained.iter().find(|(u, _)| *u == row) {
                    let weight = tableau.twice_integrated(stage);
                    elementwise(out, [&slope[v * len..], h], |sum, [slope, h]| sum + weight * h * slope * h);
                } else {
                    let weight = tableau.b[stage];
                    elementwise(out, [&slope[row * len..], h], |sum, [slope, h]| sum + weight * h * slope);
                }
            }
            slopes.push(slope);
        }
        integrated
    }

    /// What the defect moves the inner stages by, `∫_0^c (S' - f(S)) ds - c ∫_0^1 (S' - f(S)) ds`, as
    /// [`Iterate::inner`] stands: right-hand sides of the linearised stage equations.
    pub(crate) fn moments(&self, extension: &Extension, defects: &Defects) -> Numbers {
        let tableau = self.system.tableau;
        let len = self.n() * self.intervals();
        let mut out = Numbers::zeros(tableau.unknown_stages() * len);
        for (stage, out) in out.chunks_exact_mut(len).enumerate() {
            let c = tableau.c[stage + 2];
            self.improvement(extension, defects, stage + 2, out);
            elementwise(out, [&defects.integrated], |improvement, [whole]| -improvement - c * whole);
        }
        out
    }

    /// `S̃ - S` at one stage of all intervals. The samples are even in number.
    fn improvement(&self, extension: &Extension, defects: &Defects, stage: usize, out: &mut [f64]) {
        let intervals = self.intervals();
        let rows = self.system.plan.regions[self.region].rows * intervals;
        let Some(weights) = self.system.tableau.partial_integrals().get(stage) else { return };
        let basis = Basis::value(self.system.tableau.c[stage]);
        let mut known = Numbers::zeros(intervals);
        for (i, out) in out.chunks_exact_mut(intervals).enumerate() {
            let span = i * intervals..(i + 1) * intervals;
            let (f0, f1) = (self.stages.slope(0, i, intervals), self.stages.slope(1, i, intervals));
            self.weigh(Some(extension), &basis, i, &mut known);
            let (left, right) = (weights[0], weights[1]);
            if let [a, b, c, d] = weights[2..] {
                // The same in one pass, for the four samples of order 6.
                let sample = |k: usize| &defects.samples[k * rows..][span.clone()];
                let inputs = [f0, f1, sample(0), sample(1), sample(2), sample(3), self.h(), &known];
                elementwise(out, inputs, |_, [f0, f1, s, t, u, v, h, known]| {
                    h * (left * f0 + right * f1 + a * s + b * t + c * u + d * v) - known
                });
                continue;
            }
            elementwise(out, [f0, f1], |_, [f0, f1]| left * f0 + right * f1);
            for (pair, weights) in defects.samples.chunks_exact(2 * rows).zip(weights[2..].chunks_exact(2)) {
                let pair = [&pair[span.clone()], &pair[rows..][span.clone()]];
                elementwise(out, pair, |sum, [f, g]| sum + weights[0] * f + weights[1] * g);
            }
            elementwise(out, [self.h(), &known], |mean, [h, known]| h * mean - known);
        }
    }
}
