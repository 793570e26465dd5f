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

use super::evaluate::Stages;
use super::{Iterate, Scales, System};
use crate::error::NonFinite;
use crate::linear::scalar::W;
use crate::linear::simd::elementwise;
use crate::problem::{Points, Problem};
use crate::stats::Stats;
use crate::tableau::{QUARTIC_OFFSET, QUARTIC_SLOPE};

/// Relative error of a difference of node values.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// α, β, γ, δ of all intervals of a region, component by component in working order.
#[derive(Debug, Clone)]
pub(crate) struct Extension {
    pub alpha: Vec<f64>,
    pub beta: Vec<f64>,
    /// Empty below order 8, as is δ.
    pub gamma: Vec<f64>,
    pub delta: Vec<f64>,
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

/// Defects of one region, one an interval, in the mesh's order.
#[derive(Debug, Clone, Default)]
pub(crate) struct Defects {
    /// Root mean square over the interval of `|S' - f| ℓ / (Y + F ℓ)`, largest over states: Y the state's typical
    /// magnitude, ℓ the region's length, F the larger of |f| and of the size of f's terms, `Σ |∂f/∂y| |y|`, at the
    /// nodes: where large terms nearly cancel, they cannot be met better than they are known.
    pub relative: Vec<f64>,
    /// What the interval's defect can move a state by, relative to its typical magnitude: `h |S' - f| / Y`.
    pub contribution: Vec<f64>,
    /// What rounding alone may make of the relative defect: the slope is a difference of values over an interval.
    pub rounding: Vec<f64>,
    /// State of the largest relative defect.
    pub state: Vec<usize>,
    /// `∫ (S' - f) ds` of each state, and the error of each integral, per interval: `rows * interval_stride`, in
    /// working order.
    pub integrated: Vec<f64>,
    /// f(S) of the states at each sample, `n * interval_stride`, in working order.
    pub samples: Vec<Vec<f64>>,
}

/// Points and results of one evaluation at the same σ in all intervals; reused from one to the next.
pub(super) struct Sample {
    s: Vec<f64>,
    y: Vec<f64>,
    pub(super) f: Vec<f64>,
}

/// One region at a converged iterate.
pub(crate) struct Extended<'a, 'p, P: Problem + ?Sized> {
    pub system: &'a System<'p, P>,
    pub region: usize,
    pub x: &'a Iterate,
    pub stages: &'a Stages,
}

impl<P: Problem + ?Sized> Extended<'_, '_, P> {
    /// # Errors
    /// The right-hand side is undefined between the collocation points.
    pub(crate) fn extension(&self, scales: &Scales, stats: &mut Stats) -> Result<Extension, NonFinite> {
        let len = self.n() * self.intervals();
        let mut extension =
            Extension { alpha: vec![0.0; len], beta: vec![0.0; len], gamma: Vec::new(), delta: Vec::new() };
        if self.system.tableau.coupled {
            self.correct(&mut extension, &scales.states[self.region], stats)?;
            return Ok(extension);
        }
        if self.system.tableau.order == 6 {
            self.match_middle(&mut extension, stats)?;
            return Ok(extension);
        }
        let intervals = self.intervals();
        let mut slope = vec![0.0; intervals];
        let mut sample = self.room();
        for (sigma, sign) in [(0.5 - QUARTIC_OFFSET, 1.0), (0.5 + QUARTIC_OFFSET, -1.0)] {
            self.sample(None, sigma, &mut sample, stats)?;
            let basis = Basis::slope(sigma);
            for (i, alpha) in extension.alpha.chunks_exact_mut(intervals).enumerate() {
                self.weigh(None, &basis, i, &mut slope);
                elementwise(alpha, [self.h(), &sample.f[i * intervals..], &slope], |alpha, [h, f, slope]| {
                    alpha + 0.5 * sign * (h * f - slope) / QUARTIC_SLOPE
                });
            }
        }
        Ok(extension)
    }

    /// Value and slope at the middle of each interval, to O(h⁶).
    fn match_middle(&self, extension: &mut Extension, stats: &mut Stats) -> Result<(), NonFinite> {
        let intervals = self.intervals();
        let (value, slope) = (Basis::value(0.5), Basis::slope(0.5));
        let mut cubic = vec![0.0; intervals];
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
        let mut sample = self.room();
        self.sample(Some(extension), 0.5, &mut sample, stats)?;
        for i in 0..self.n() {
            self.weigh(Some(extension), &slope, i, &mut cubic);
            let beta = &mut extension.beta[i * intervals..(i + 1) * intervals];
            elementwise(beta, [self.h(), &sample.f[i * intervals..], &cubic], |_, [h, f, known]| {
                (h * f - known) / slope.beta
            });
        }
        Ok(())
    }

    pub(super) fn n(&self) -> usize {
        self.system.plan.regions[self.region].n
    }

    fn nodes(&self) -> usize {
        self.system.grids[self.region].node_stride()
    }

    pub(super) fn intervals(&self) -> usize {
        self.system.grids[self.region].interval_stride()
    }

    pub(super) fn h(&self) -> &[f64] {
        &self.system.grids[self.region].h
    }

    /// Component `i` at the left and right nodes of all intervals.
    fn values(&self, i: usize) -> (&[f64], &[f64]) {
        let y = &self.x.y[self.region][i * self.nodes()..(i + 1) * self.nodes()];
        (&y[..self.intervals()], &y[W..])
    }

    /// The weighted sums of a basis (without `y_0`), component `i`, all intervals. Without extension: of the cubic.
    pub(super) fn weigh(&self, extension: Option<&Extension>, basis: &Basis, i: usize, out: &mut [f64]) {
        let (y0, y1) = self.values(i);
        let (f0, f1) = (self.stages.slope(0, i, out.len()), self.stages.slope(1, i, out.len()));
        elementwise(out, [y0, y1, f0, f1, self.h()], |_, [y0, y1, f0, f1, h]| {
            basis.rise * (y1 - y0) + h * (basis.left * f0 + basis.right * f1)
        });
        if let Some(Extension { alpha, beta, gamma, delta }) = extension {
            let first = i * out.len();
            elementwise(out, [&alpha[first..], &beta[first..]], |cubic, [alpha, beta]| {
                cubic + basis.alpha * alpha + basis.beta * beta
            });
            if !delta.is_empty() {
                elementwise(out, [&gamma[first..], &delta[first..]], |quintic, [gamma, delta]| {
                    quintic + basis.gamma * gamma + basis.delta * delta
                });
            }
        }
    }

    /// Room for [`sample`](Self::sample).
    pub(super) fn room(&self) -> Sample {
        let (intervals, plan) = (self.intervals(), &self.system.plan.regions[self.region]);
        Sample { s: vec![0.0; intervals], y: vec![0.0; plan.n * intervals], f: vec![0.0; plan.rows * intervals] }
    }

    /// S and f(S) at one σ in all intervals. Without extension: of the cubic.
    pub(super) fn sample(
        &self,
        extension: Option<&Extension>,
        sigma: f64,
        sample: &mut Sample,
        stats: &mut Stats,
    ) -> Result<(), NonFinite> {
        let (basis, intervals) = (Basis::value(sigma), self.intervals());
        for (i, y) in sample.y.chunks_exact_mut(intervals).enumerate() {
            self.weigh(extension, &basis, i, y);
            elementwise(y, [self.values(i).0], |rise, [y0]| y0 + rise);
        }
        let grid = &self.system.grids[self.region];
        elementwise(&mut sample.s, [&grid.s, &grid.h], |_, [s, h]| s + sigma * h);
        let at = Points { len: intervals, stride: intervals, s: &sample.s, y: &sample.y };
        stats.rhs_points += intervals;
        self.system.problem.rhs(self.region, &at, &self.x.constants, &mut sample.f);
        self.system.check_values(self.region, &at, &sample.f)
    }

    /// # Errors
    /// The right-hand side is undefined between the collocation points.
    pub(crate) fn defects(
        &self,
        extension: &Extension,
        scales: &Scales,
        stats: &mut Stats,
    ) -> Result<Defects, NonFinite> {
        let (n, intervals) = (self.n(), self.intervals());
        let grid = &self.system.grids[self.region];
        let (a, b) = self.system.layout.regions[self.region].interval;
        let length = b - a;
        let terms = self.terms();
        let (mut relative, mut absolute) = (vec![0.0; n * intervals], vec![0.0; n * intervals]);
        let mut means = vec![0.0; self.system.plan.regions[self.region].rows * intervals];
        let (mut samples, mut sample, mut defect) = (Vec::new(), self.room(), vec![0.0; intervals]);
        for &(sigma, weight) in self.system.tableau.samples {
            self.sample(Some(extension), sigma, &mut sample, stats)?;
            elementwise(&mut means, [&sample.f], |mean, [f]| mean + weight * f);
            let basis = Basis::slope(sigma);
            for (i, &scale) in scales.states[self.region].iter().enumerate() {
                let row = i * intervals..(i + 1) * intervals;
                let f = &sample.f[row.clone()];
                self.weigh(Some(extension), &basis, i, &mut defect);
                // Padding has no length and no defect.
                elementwise(&mut defect, [&grid.h, f], |rise, [h, f]| if h > 0.0 { rise / h - f } else { 0.0 });
                elementwise(
                    &mut relative[row.clone()],
                    [&defect, f, &terms[row.clone()]],
                    |sum, [defect, f, terms]| {
                        let fraction = defect * length / (scale + f.abs().max(terms) * length);
                        sum + weight * fraction * fraction
                    },
                );
                elementwise(&mut absolute[row], [&defect, &grid.h], |sum, [defect, h]| {
                    sum + weight * (defect * h / scale) * (defect * h / scale)
                });
            }
            samples.push(sample.f[..n * intervals].to_vec());
        }
        let rounding = self.rounding(&terms, scales);
        let mut defects = Defects { integrated: self.integrated(means), samples, ..Defects::default() };
        for j in 0..grid.intervals() {
            let p = grid.position(j);
            let state = (0..n).max_by(|&i, &l| relative[i * intervals + p].total_cmp(&relative[l * intervals + p]));
            let state = state.unwrap_or(0);
            let contribution = (0..n).map(|i| absolute[i * intervals + p]).fold(0.0, f64::max);
            defects.relative.push(relative[state * intervals + p].sqrt());
            defects.contribution.push(contribution.sqrt());
            defects.rounding.push(rounding[p]);
            defects.state.push(state);
        }
        Ok(defects)
    }

    /// What rounding of the node values may make of the relative defects: the largest over states, one an interval. It
    /// is large where intervals are short although the solution hardly varies on them, and small in a layer.
    fn rounding(&self, terms: &[f64], scales: &Scales) -> Vec<f64> {
        let intervals = self.intervals();
        let (a, b) = self.system.layout.regions[self.region].interval;
        let length = b - a;
        let mut out = vec![0.0; intervals];
        for (i, &scale) in scales.states[self.region].iter().enumerate() {
            let (y0, y1) = self.values(i);
            let terms = &terms[i * intervals..(i + 1) * intervals];
            elementwise(&mut out, [y0, y1, self.h(), terms], |most: f64, [y0, y1, h, terms]| {
                let slope = if h > 0.0 { y0.abs().max(y1.abs()) / h } else { 0.0 };
                most.max(ROUNDING * slope * length / (scale + terms * length))
            });
        }
        out
    }

    /// `Σ |∂f/∂y| |y|` of each state, the larger of both nodes: `n * intervals`.
    fn terms(&self) -> Vec<f64> {
        let (n, nodes, intervals) = (self.n(), self.nodes(), self.intervals());
        let mut at_nodes = vec![0.0; n * nodes];
        let pattern = &self.system.layout.regions[self.region].state_pattern;
        for (entry, &(row, state)) in pattern.iter().enumerate().filter(|(_, (row, _))| *row < n) {
            let dy = &self.stages.nodes.dy[entry * nodes..(entry + 1) * nodes];
            let y = &self.x.y[self.region][state * nodes..(state + 1) * nodes];
            let out = &mut at_nodes[row * nodes..(row + 1) * nodes];
            elementwise(out, [dy, y], |sum, [dy, y]| sum + (dy * y).abs());
        }
        let larger = |terms: &[f64]| -> Vec<f64> { (0..intervals).map(|p| terms[p].max(terms[p + W])).collect() };
        at_nodes.chunks_exact(nodes).flat_map(larger).collect()
    }

    /// From the means of f over the intervals: what the defects of the states, and the quadrature of the integrals,
    /// amount to.
    fn integrated(&self, mut means: Vec<f64>) -> Vec<f64> {
        let (n, intervals) = (self.n(), self.intervals());
        let rules = self.system.interval_integrals(self.region, self.stages);
        for (row, out) in means.chunks_exact_mut(intervals).enumerate() {
            let y = self.x.y[self.region].get(row * self.nodes()..).unwrap_or_default();
            for p in 0..intervals {
                let rise = if row < n { y[p + W] - y[p] } else { rules[(row - n) * intervals + p] };
                out[p] = rise - self.h()[p] * out[p];
            }
        }
        means
    }

    /// `∫ (S̃' - f(S̃)) ds` of each state, and the error of each integral, per interval, with
    /// `S̃ = y_0 + ∫ f(S) ds`: as [`Defects::integrated`], but from an extension that is one order better, as order 6
    /// needs. To first order `f(S̃) = f(S) + ∂f/∂y (S̃ - S)`, with the derivatives at the stages, by the method's own
    /// quadrature: nothing is evaluated anew.
    pub(crate) fn improved(&self, extension: &Extension, defects: &Defects) -> Vec<f64> {
        let (nodes, intervals) = (self.nodes(), self.intervals());
        let mut integrated = defects.integrated.clone();
        let tableau = self.system.tableau;
        let mut difference = vec![0.0; self.n() * intervals];
        // S̃ = S at the first stage, the left node.
        for (stage, (&c, &b)) in tableau.c.iter().zip(tableau.b).enumerate().skip(1) {
            self.improvement(extension, defects, c, &mut difference);
            // Node values stand one vector further on than those of the interval to their left.
            let (batch, stride, offset) = match stage {
                1 => (&self.stages.nodes, nodes, W),
                _ => (&self.stages.inner[stage - 2], intervals, 0),
            };
            let pattern = &self.system.layout.regions[self.region].state_pattern;
            for (entry, &(row, state)) in pattern.iter().enumerate() {
                let dy = &batch.dy[entry * stride + offset..][..intervals];
                let difference = &difference[state * intervals..(state + 1) * intervals];
                let out = &mut integrated[row * intervals..(row + 1) * intervals];
                elementwise(out, [dy, difference, self.h()], |sum, [dy, difference, h]| sum - b * h * dy * difference);
            }
        }
        integrated
    }

    /// What the defect moves the inner stages by, `∫_0^c (S' - f(S)) ds - c ∫_0^1 (S' - f(S)) ds`, as
    /// [`Iterate::inner`] stands: right-hand sides of the linearised stage equations.
    pub(crate) fn moments(&self, extension: &Extension, defects: &Defects) -> Vec<f64> {
        let tableau = self.system.tableau;
        let len = self.n() * self.intervals();
        let mut out = vec![0.0; tableau.unknown_stages() * len];
        for (out, &c) in out.chunks_exact_mut(len).zip(&tableau.c[2..]) {
            self.improvement(extension, defects, c, out);
            elementwise(out, [&defects.integrated], |improvement, [whole]| -improvement - c * whole);
        }
        out
    }

    /// `S̃ - S` at one σ in all intervals.
    fn improvement(&self, extension: &Extension, defects: &Defects, sigma: f64, out: &mut [f64]) {
        let intervals = self.intervals();
        let weights = partial_integrals(self.system.tableau.samples, sigma);
        let basis = Basis::value(sigma);
        let mut known = vec![0.0; intervals];
        for (i, out) in out.chunks_exact_mut(intervals).enumerate() {
            let span = i * intervals..(i + 1) * intervals;
            let (f0, f1) = (self.stages.slope(0, i, intervals), self.stages.slope(1, i, intervals));
            let (left, right) = (weights[0], weights[weights.len() - 1]);
            elementwise(out, [f0, f1], |_, [f0, f1]| left * f0 + right * f1);
            for (sample, &weight) in defects.samples.iter().zip(&weights[1..]) {
                elementwise(out, [&sample[span.clone()]], |sum, [f]| sum + weight * f);
            }
            self.weigh(Some(extension), &basis, i, &mut known);
            elementwise(out, [self.h(), &known], |mean, [h, known]| h * mean - known);
        }
    }
}

/// Weights that integrate the polynomial through 0, the samples and 1 from 0 to `end`. The samples are the points of a
/// Gauss rule, which is exact for these integrals.
fn partial_integrals(samples: &[(f64, f64)], end: f64) -> Vec<f64> {
    let nodes: Vec<f64> =
        std::iter::once(0.0).chain(samples.iter().map(|sample| sample.0)).chain(std::iter::once(1.0)).collect();
    let lagrange = |k: usize, x: f64| -> f64 {
        let others = nodes.iter().enumerate().filter(|&(i, _)| i != k);
        others.map(|(_, node)| (x - node) / (nodes[k] - node)).product()
    };
    let integral = |k: usize| samples.iter().map(|(x, weight)| end * weight * lagrange(k, end * x)).sum();
    (0..nodes.len()).map(integral).collect()
}
