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

use super::stages::Stages;
use super::{Iterate, System};
use crate::basis::{Basis, PARTS};
use crate::error::NonFinite;
use crate::linear::memory::Numbers;
use crate::linear::scalar::{Lane, Scalar, W};
use crate::linear::simd::{Job, by_components, vectorised};
use crate::problem::{Points, Problem};
use crate::stats::Stats;
use crate::tableau::{MOST_PLACES, QUARTIC_OFFSET, QUARTIC_SLOPE};

/// α, β, γ, δ of all intervals of a region, component by component in working order.
#[derive(Debug, Clone)]
pub(crate) struct Extension {
    pub alpha: Numbers,
    pub beta: Numbers,
    /// Empty below order 8, as is δ.
    pub gamma: Numbers,
    pub delta: Numbers,
}

/// What a continuous extension is made of, a vector of intervals at a time: interval `t` of every stretch.
#[derive(Clone, Copy)]
pub(super) struct Pieces<'a> {
    /// Vectors a component.
    pub steps: usize,
    /// Node values and slopes, `steps + 1` vectors a component.
    y: &'a [[f64; W]],
    f: &'a [[f64; W]],
    /// Lengths.
    h: &'a [[f64; W]],
    /// α and β; empty where neither is known.
    lower: [&'a [[f64; W]]; 2],
    /// γ and δ; empty where there are none.
    higher: [&'a [[f64; W]]; 2],
}

/// The same, of one component on interval `t` of every stretch.
pub(super) struct Piece {
    /// Values and slopes at both nodes.
    y: [Lane; 2],
    f: [Lane; 2],
    /// h.
    length: Lane,
    /// α and β, and γ and δ, where there are any.
    lower: Option<[Lane; 2]>,
    higher: Option<[Lane; 2]>,
}

impl Piece {
    /// The weighted sum of a basis, without `y_0`.
    #[inline(always)]
    pub(super) fn weigh(&self, basis: &Basis) -> Lane {
        let ([y0, y1], [f0, f1]) = (self.y, self.f);
        let slopes = self.length * (f0.times(basis.left) + f1.times(basis.right));
        let mut sum = (y1 - y0).times(basis.rise) + slopes;
        if let Some([alpha, beta]) = self.lower {
            sum = sum + alpha.times(basis.alpha) + beta.times(basis.beta);
        }
        if let Some([gamma, delta]) = self.higher {
            sum = sum + gamma.times(basis.gamma) + delta.times(basis.delta);
        }
        sum
    }
}

impl Pieces<'_> {
    /// All that is known of component `i`.
    #[inline(always)]
    pub(super) fn piece(&self, i: usize, t: usize) -> Piece {
        let at = i * self.steps + t;
        let pair = |[first, second]: [&[[f64; W]]; 2]| Some([Lane(*first.get(at)?), Lane(*second.get(at)?)]);
        let (lower, higher) = (pair(self.lower), pair(self.higher));
        Piece { y: self.values(i, t), f: self.slopes(i, t), length: self.length(t), lower, higher }
    }

    /// h.
    #[inline(always)]
    pub(super) fn length(&self, t: usize) -> Lane {
        Lane(self.h[t])
    }

    /// Component `i` at both nodes.
    #[inline(always)]
    pub(super) fn values(&self, i: usize, t: usize) -> [Lane; 2] {
        let at = i * (self.steps + 1) + t;
        [Lane(self.y[at]), Lane(self.y[at + 1])]
    }

    /// Its slopes there.
    #[inline(always)]
    pub(super) fn slopes(&self, i: usize, t: usize) -> [Lane; 2] {
        let at = i * (self.steps + 1) + t;
        [Lane(self.f[at]), Lane(self.f[at + 1])]
    }

    /// What S is made of, without `y_0`, of component `i`: as [`Basis::weights`].
    #[inline(always)]
    pub(super) fn parts(&self, i: usize, t: usize) -> [Lane; PARTS] {
        let ([y0, y1], [f0, f1], h, at) = (self.values(i, t), self.slopes(i, t), self.length(t), i * self.steps + t);
        let term = |values: &[[f64; W]]| values.get(at).map_or(Lane::ZERO, |value| Lane(*value));
        let ([alpha, beta], [gamma, delta]) = (self.lower.map(term), self.higher.map(term));
        [y1 - y0, h * f0, h * f1, alpha, beta, gamma, delta]
    }

    /// The weighted sum of a basis, without `y_0`, of component `i`.
    #[inline(always)]
    pub(super) fn weigh(&self, basis: &Basis, i: usize, t: usize) -> Lane {
        self.piece(i, t).weigh(basis)
    }
}

/// The right-hand side at the same places of all intervals.
#[derive(Debug, Clone)]
pub(crate) struct Sampled {
    /// How many.
    pub places: usize,
    /// Vectors a place and row.
    steps: usize,
    /// Row by row, place by place in working order.
    f: Numbers,
}

impl Sampled {
    /// One row at one place of interval `t` of every stretch.
    #[inline(always)]
    pub(super) fn slope(&self, row: usize, place: usize, t: usize) -> Lane {
        Lane(self.f.as_chunks::<W>().0[(row * self.places + place) * self.steps + t])
    }

    /// One row at all places of all samples with these weights.
    #[inline(always)]
    pub(super) fn weighted(samples: &[Self], mut weights: impl Iterator<Item = f64>, row: usize, t: usize) -> Lane {
        let mut sum = Lane::ZERO;
        for sampled in samples {
            for (place, weight) in (0..sampled.places).zip(&mut weights) {
                sum += sampled.slope(row, place, t).times(weight);
            }
        }
        sum
    }
}

/// Where the right-hand side is to be evaluated.
struct Places<'a> {
    pieces: Pieces<'a>,
    /// Nodes.
    nodes: &'a [f64],
    /// σ of each, and the basis there.
    bases: &'a [(f64, Basis)],
    /// Place by place in working order, component by component those of y.
    s: &'a mut [f64],
    y: &'a mut [f64],
}

impl Job for Places<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self { pieces, nodes, bases, s, y } = self;
        let (nodes, steps) = (nodes.as_chunks::<W>().0, pieces.steps);
        for ((sigma, _), s) in bases.iter().zip(s.as_chunks_mut::<W>().0.chunks_exact_mut(steps)) {
            for (t, s) in s.iter_mut().enumerate() {
                *s = (Lane(nodes[t]) + pieces.length(t).times(*sigma)).0;
            }
        }
        for (i, y) in y.as_chunks_mut::<W>().0.chunks_exact_mut(bases.len() * steps).enumerate() {
            for t in 0..steps {
                let piece = pieces.piece(i, t);
                for ((_, basis), y) in bases.iter().zip(y.chunks_exact_mut(steps)) {
                    // y_0 is by far the largest, and comes last: what is rounded then is rounded once.
                    y[t] = (piece.y[0] + piece.weigh(basis)).0;
                }
            }
        }
    }
}

/// One region at a converged iterate.
pub(crate) struct Extended<'a, 'p, P: Problem + ?Sized> {
    pub system: &'a System<'p, P>,
    pub region: usize,
    pub x: &'a Iterate,
    pub stages: &'a Stages,
}

impl<P: Problem + ?Sized> Extended<'_, '_, P> {
    /// That of order 4 or 6: see the module's head.
    ///
    /// # Errors
    /// The right-hand side is undefined between the collocation points.
    pub(super) fn bootstrapped(&self, stats: &mut Stats) -> Result<Extension, NonFinite> {
        if self.system.tableau.order == 6 {
            return self.match_middle(stats);
        }
        let places = [0.5 - QUARTIC_OFFSET, 0.5 + QUARTIC_OFFSET];
        let (cubic, sampled, bases) =
            (self.pieces(None), self.sampled(None, &places, stats)?, places.map(Basis::slope));
        let mut extension = self.flat();
        by_components(&mut extension.alpha, cubic.steps, |i, t| {
            let mut sum = Lane::ZERO;
            for (k, (basis, sign)) in bases.iter().zip([1.0, -1.0]).enumerate() {
                let lacking = cubic.length(t) * sampled.slope(i, k, t) - cubic.weigh(basis, i, t);
                sum += lacking.map(|lacking| 0.5 * sign * lacking / QUARTIC_SLOPE);
            }
            sum
        });
        Ok(extension)
    }

    /// Value and slope at the middle of each interval, to O(h⁶).
    fn match_middle(&self, stats: &mut Stats) -> Result<Extension, NonFinite> {
        let (value, slope) = (Basis::value(0.5), Basis::slope(0.5));
        let (mut extension, cubic) = (self.flat(), self.pieces(None));
        let stages = self.stages.views(cubic.steps);
        by_components(&mut extension.alpha, cubic.steps, |i, t| {
            let ([y0, y1], [f0, f1]) = (cubic.values(i, t), cubic.slopes(i, t));
            let (f3, f4) = (stages[2].f(i, t), stages[3].f(i, t));
            let rise = cubic.length(t) * ((f0 - f1).map(|f| f / 24.0) + (f3 - f4).map(|f| f / 6.0));
            ((y1 - y0).times(0.5) + rise - cubic.weigh(&value, i, t)).map(|lacking| lacking / value.alpha)
        });
        let (sampled, mut beta) = (self.sampled(Some(&extension), &[0.5], stats)?, self.flat_term());
        let quartic = self.pieces(Some(&extension));
        by_components(&mut beta, quartic.steps, |i, t| {
            let lacking = quartic.length(t) * sampled.slope(i, 0, t) - quartic.weigh(&slope, i, t);
            lacking.map(|lacking| lacking / slope.beta)
        });
        extension.beta = beta;
        Ok(extension)
    }

    /// An extension that adds nothing to the cubic.
    pub(super) fn flat(&self) -> Extension {
        let (gamma, delta) = (Numbers::default(), Numbers::default());
        Extension { alpha: self.flat_term(), beta: self.flat_term(), gamma, delta }
    }

    fn flat_term(&self) -> Numbers {
        Numbers::zeros(self.n() * self.intervals())
    }

    pub(super) fn n(&self) -> usize {
        self.system.plan.regions[self.region].n
    }

    /// States and integrals.
    pub(super) fn rows(&self) -> usize {
        self.system.plan.regions[self.region].rows
    }

    pub(super) fn steps(&self) -> usize {
        self.system.grids[self.region].steps
    }

    pub(super) fn intervals(&self) -> usize {
        self.system.grids[self.region].interval_stride()
    }

    pub(super) fn h(&self) -> &[f64] {
        &self.system.grids[self.region].h
    }

    /// Without extension: of the cubic.
    pub(super) fn pieces<'b>(&'b self, extension: Option<&'b Extension>) -> Pieces<'b> {
        let lanes = |values: &'b [f64]| values.as_chunks::<W>().0;
        let (lower, higher) = extension.map_or(([&[][..]; 2], [&[][..]; 2]), |extension| {
            let Extension { alpha, beta, gamma, delta } = extension;
            ([lanes(alpha), lanes(beta)], [lanes(gamma), lanes(delta)])
        });
        let (y, f) = (lanes(&self.x.y[self.region]), lanes(&self.stages.nodes.f));
        Pieces { steps: self.steps(), y, f, h: lanes(self.h()), lower, higher }
    }

    /// f(S) at the same places of all intervals. Without extension: of the cubic.
    pub(super) fn sampled(
        &self,
        extension: Option<&Extension>,
        places: &[f64],
        stats: &mut Stats,
    ) -> Result<Sampled, NonFinite> {
        let (count, len) = (places.len(), places.len() * self.intervals());
        let (mut s, mut y) = (Numbers::unset(len), Numbers::unset(self.n() * len));
        let mut bases = [(0.0, Basis::value(0.0)); MOST_PLACES];
        bases.iter_mut().zip(places).for_each(|(basis, &sigma)| *basis = (sigma, Basis::value(sigma)));
        let (pieces, nodes) = (self.pieces(extension), &self.system.grids[self.region].s);
        vectorised(Places { pieces, nodes, bases: &bases[..count], s: &mut s, y: &mut y });
        let mut f = Numbers::unset(self.rows() * len);
        let at = Points { len, stride: len, s: &s, y: &y };
        stats.rhs_points += len;
        self.system.problem.rhs(self.region, &at, &self.x.constants, &mut f);
        self.system.forgiven(self.region, &at, &mut f)?;
        Ok(Sampled { places: count, steps: self.steps(), f })
    }
}
