//! The continuous extension of the collocation solution, and its defect.
//!
//! On an interval, with `σ = (s - t_j)/h` and H the cubic Hermite interpolant of node values and slopes,
//!
//! ```text
//! S(σ) = H(σ) + σ²(1-σ)² [α + β (σ - 1/2)]
//! ```
//!
//! is continuously differentiable for any α, β. Order 4: β = 0, and α from the slopes at two points (bootstrapping
//! as in W. H. Enright and P. H. Muir, SIAM J. Sci. Comput. 17 (1996) 479-497), so that the defect is O(h⁴).
//! Order 6: S takes at the middle the value
//! `(y_0 + y_1)/2 + h [(f_0 - f_1)/24 + (K_3 - K_4)/6]`, in which the O(h⁴) errors of the stages K_3 and K_4 at
//! 1/4 and 3/4 cancel, and the slope there; both are accurate to O(h⁶), and the defect is O(h⁵).

use super::evaluate::Stages;
use super::{Iterate, Scales, System};
use crate::error::NonFinite;
use crate::linear::scalar::W;
use crate::problem::{Points, Problem};
use crate::stats::Stats;
use crate::tableau::{QUARTIC_OFFSET, QUARTIC_SLOPE};

/// α and β of all intervals of a region, component by component in working order.
#[derive(Debug, Clone)]
pub(crate) struct Extension {
    pub alpha: Vec<f64>,
    pub beta: Vec<f64>,
}

/// Weights of `y_0`, `y_1 - y_0`, `h f_0`, `h f_1`, `α`, `β` in S and in dS/dσ at one σ.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Basis {
    pub rise: f64,
    pub left: f64,
    pub right: f64,
    pub alpha: f64,
    pub beta: f64,
}

impl Basis {
    /// Weights in S; that of `y_0` is 1.
    #[inline]
    pub(crate) fn value(x: f64) -> Self {
        let z = 1.0 - x;
        let bump = x * x * z * z;
        Self { rise: x * x * (3.0 - 2.0 * x), left: x * z * z, right: -x * x * z, alpha: bump, beta: bump * (x - 0.5) }
    }

    /// Weights in dS/dσ; that of `y_0` is 0.
    #[inline]
    pub(crate) fn slope(x: f64) -> Self {
        let z = 1.0 - x;
        let bump = 2.0 * x * z * (1.0 - 2.0 * x);
        Self {
            rise: 6.0 * x * z,
            left: z * (1.0 - 3.0 * x),
            right: -x * (2.0 - 3.0 * x),
            alpha: bump,
            beta: bump * (x - 0.5) + x * x * z * z,
        }
    }
}

/// Defects of one region, one an interval, in the mesh's order.
#[derive(Debug, Clone, Default)]
pub(crate) struct Defects {
    /// Root mean square over the interval of `|S' - f| ℓ / (Y + |f| ℓ)`, largest over states: Y the state's typical
    /// magnitude, ℓ the region's length.
    pub relative: Vec<f64>,
    /// What the interval's defect can move a state by, relative to its typical magnitude: `h |S' - f| / Y`.
    pub contribution: Vec<f64>,
    /// State of the largest relative defect.
    pub state: Vec<usize>,
}

/// Points and results of one evaluation at the same σ in all intervals.
struct Sample {
    s: Vec<f64>,
    y: Vec<f64>,
    f: Vec<f64>,
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
    pub(crate) fn extension(&self, stats: &mut Stats) -> Result<Extension, NonFinite> {
        let len = self.n() * self.intervals();
        let mut extension = Extension { alpha: vec![0.0; len], beta: vec![0.0; len] };
        if self.system.tableau.order == 6 {
            self.match_middle(&mut extension, stats)?;
            return Ok(extension);
        }
        for (sigma, sign) in [(0.5 - QUARTIC_OFFSET, 1.0), (0.5 + QUARTIC_OFFSET, -1.0)] {
            let sample = self.sample(None, sigma, stats)?;
            let basis = Basis::slope(sigma);
            for i in 0..self.n() {
                for p in 0..self.intervals() {
                    let missing = self.h()[p] * sample.f[i * self.intervals() + p] - self.at(None, &basis, i, p);
                    extension.alpha[i * self.intervals() + p] += 0.5 * sign * missing / QUARTIC_SLOPE;
                }
            }
        }
        Ok(extension)
    }

    /// Value and slope at the middle of each interval, to O(h⁶).
    fn match_middle(&self, extension: &mut Extension, stats: &mut Stats) -> Result<(), NonFinite> {
        let intervals = self.intervals();
        let (value, slope) = (Basis::value(0.5), Basis::slope(0.5));
        for i in 0..self.n() {
            let y = &self.x.y[self.region][i * self.nodes()..];
            let stage = |stage| self.stages.slope(stage, i, intervals);
            let (f0, f1, f3, f4) = (stage(0), stage(1), stage(2), stage(3));
            for p in 0..intervals {
                let rise = self.h()[p] * ((f0[p] - f1[p]) / 24.0 + (f3[p] - f4[p]) / 6.0);
                let rise = 0.5 * (y[p + W] - y[p]) + rise;
                extension.alpha[i * intervals + p] = (rise - self.at(None, &value, i, p)) / value.alpha;
            }
        }
        let sample = self.sample(Some(extension), 0.5, stats)?;
        for i in 0..self.n() {
            for p in 0..intervals {
                let missing = self.h()[p] * sample.f[i * intervals + p] - self.at(None, &slope, i, p);
                extension.beta[i * intervals + p] = missing / slope.beta;
            }
        }
        Ok(())
    }

    fn n(&self) -> usize {
        self.system.plan.regions[self.region].n
    }

    fn nodes(&self) -> usize {
        self.system.grids[self.region].node_stride()
    }

    fn intervals(&self) -> usize {
        self.system.grids[self.region].interval_stride()
    }

    fn h(&self) -> &[f64] {
        &self.system.grids[self.region].h
    }

    /// The weighted sum of a basis (without `y_0`), component `i`, interval `p`. Without extension: of the cubic.
    #[inline]
    fn at(&self, extension: Option<&Extension>, basis: &Basis, i: usize, p: usize) -> f64 {
        let y = &self.x.y[self.region][i * self.nodes()..];
        let f = &self.stages.nodes.f[i * self.nodes()..];
        let cubic = basis.rise * (y[p + W] - y[p]) + self.h()[p] * (basis.left * f[p] + basis.right * f[p + W]);
        extension.map_or(cubic, |extension| {
            let at = i * self.intervals() + p;
            cubic + basis.alpha * extension.alpha[at] + basis.beta * extension.beta[at]
        })
    }

    /// S and f(S) at one σ in all intervals. Without extension: of the cubic.
    fn sample(&self, extension: Option<&Extension>, sigma: f64, stats: &mut Stats) -> Result<Sample, NonFinite> {
        let intervals = self.intervals();
        let basis = Basis::value(sigma);
        let grid = &self.system.grids[self.region];
        let rows = self.system.plan.regions[self.region].rows;
        let mut sample = Sample {
            s: (0..intervals).map(|p| grid.s[p] + sigma * grid.h[p]).collect(),
            y: vec![0.0; self.n() * intervals],
            f: vec![0.0; rows * intervals],
        };
        for i in 0..self.n() {
            for p in 0..intervals {
                sample.y[i * intervals + p] =
                    self.x.y[self.region][i * self.nodes() + p] + self.at(extension, &basis, i, p);
            }
        }
        let at = Points { len: intervals, stride: intervals, s: &sample.s, y: &sample.y };
        stats.rhs_points += intervals;
        self.system.problem.rhs(self.region, &at, &self.x.constants, &mut sample.f);
        self.system.check_values(self.region, &at, &sample.f)?;
        Ok(sample)
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
        let (mut relative, mut absolute) = (vec![0.0; n * intervals], vec![0.0; n * intervals]);
        for &(sigma, weight) in self.system.tableau.samples {
            let sample = self.sample(Some(extension), sigma, stats)?;
            let basis = Basis::slope(sigma);
            for (i, scale) in scales.states[self.region].iter().enumerate() {
                for p in 0..intervals {
                    let f = sample.f[i * intervals + p];
                    // Padding has no length and no defect.
                    let h = grid.h[p];
                    let defect = if h > 0.0 { self.at(Some(extension), &basis, i, p) / h - f } else { 0.0 };
                    let fraction = defect * length / (scale + f.abs() * length);
                    relative[i * intervals + p] += weight * fraction * fraction;
                    absolute[i * intervals + p] += weight * (defect * h / scale) * (defect * h / scale);
                }
            }
        }
        let mut defects = Defects::default();
        for j in 0..grid.intervals() {
            let p = grid.position(j);
            let state = (0..n).max_by(|&i, &l| relative[i * intervals + p].total_cmp(&relative[l * intervals + p]));
            let state = state.unwrap_or(0);
            let contribution = (0..n).map(|i| absolute[i * intervals + p]).fold(0.0, f64::max);
            defects.relative.push(relative[state * intervals + p].sqrt());
            defects.contribution.push(contribution.sqrt());
            defects.state.push(state);
        }
        Ok(defects)
    }
}
