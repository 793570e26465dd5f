//! What the defect does to the inner stages: right-hand sides of the linearised equations for the error.
//!
//! The error `ε = S - y` of the continuous extension S has `ε' = f_y ε + S' - f(S)`, which is rough where S is not the
//! solution. As smooth as a method takes a solution to be is `S̃ = y_0 + ∫ f(S) ds`. At each stage S̃ - S is had by
//! quadrature from f(S) at the places where the defect was sampled.

use super::defect::Defects;
use super::interpolant::{Basis, Extended, Extension, MOST_PLACES, Pieces, Sampled};
use super::stages::{MOST_STAGES, View};
use crate::linear::memory::{Lanes, Numbers};
use crate::linear::scalar::{Lane, Scalar, W};
use crate::linear::simd::{Job, by_components, vectorised};
use crate::problem::Problem;
use crate::tableau::{Remainder, Tableau};

/// `S̃ - S` at the stages.
#[derive(Clone, Copy)]
struct Improvement<'a> {
    pieces: Pieces<'a>,
    samples: &'a [Sampled],
    /// Weights of the slopes at both nodes, then of the samples, in the integral from 0 to each stage.
    weights: &'a [Vec<f64>],
}

impl Improvement<'_> {
    /// At a stage with this basis: component `i`, interval `t` of every stretch.
    #[inline(always)]
    fn at(&self, stage: usize, basis: &Basis, i: usize, t: usize) -> Lane {
        let ([f0, f1], weights) = (self.pieces.slopes(i, t), &self.weights[stage]);
        let ends = f0.times(weights[0]) + f1.times(weights[1]);
        let mean = Sampled::weighted(ends, self.samples, weights[2..].iter().copied(), i, t);
        self.pieces.length(t) * mean - self.pieces.weigh(basis, i, t)
    }
}

impl<P: Problem + ?Sized> Extended<'_, '_, P> {
    fn improvement<'b>(&'b self, extension: &'b Extension, defects: &'b Defects) -> Improvement<'b> {
        let weights = self.system.tableau.partial_integrals();
        Improvement { pieces: self.pieces(Some(extension)), samples: &defects.samples, weights }
    }

    /// What the defect moves the inner stages by where their states are unknowns, `∫_0^c (S' - f(S)) ds - c ∫_0^1
    /// (S' - f(S)) ds`, as [`Iterate::inner`](super::Iterate::inner) stands: right-hand sides of the linearised stage
    /// equations.
    pub(crate) fn moments(&self, extension: &Extension, defects: &Defects) -> Numbers {
        let (tableau, len) = (self.system.tableau, self.n() * self.intervals());
        let improvement = self.improvement(extension, defects);
        let (steps, whole) = (improvement.pieces.steps, defects.integrated.as_chunks::<W>().0);
        let mut out = Numbers::unset(tableau.unknown_stages() * len);
        for (stage, out) in out.chunks_exact_mut(len).enumerate() {
            let (stage, c) = (stage + 2, tableau.c[stage + 2]);
            let basis = Basis::value(c);
            by_components(out, steps, |i, t| {
                -improvement.at(stage, &basis, i, t) - Lane(whole[i * steps + t]).times(c)
            });
        }
        out
    }

    /// Right-hand sides of the linearised interval equations, and of each integral's, for the error `ε = S - y` at the
    /// nodes: as [`Defects::integrated`], J, but with what the defect does to the inner stages, as order 6 needs.
    ///
    /// With `e = S̃ - y`, of which `e' = f_y ε`, `e_0 = ε_0` and `e_1 = ε_1 - J`, the stages of e are those of the
    /// method, and `ε = e + S - S̃` there: all that the nodes' errors do not know of is in
    /// `X_r = S - S̃ - v_r J + h Σ_k x_rk f_y X_k`. The derivatives are those at the stages: nothing is evaluated anew.
    pub(crate) fn improved(&self, extension: &Extension, defects: &Defects) -> Numbers {
        let (tableau, n, rows) = (self.system.tableau, self.n(), self.rows());
        let mut integrated = defects.integrated.clone();
        let mut slopes = Lanes::unset((tableau.stages() - 2) * rows);
        let improve = Improve {
            tableau,
            improvement: self.improvement(extension, defects),
            views: self.stages.views(self.steps()),
            pattern: &self.system.layout.regions[self.region].state_pattern,
            chained: &self.stages.chained,
            jumps: defects.integrated.as_chunks::<W>().0,
            rows,
            rises: &mut Lanes::unset(n),
            moved: &mut Lanes::unset(n),
            slopes: &mut slopes,
            integrated: integrated.as_chunks_mut::<W>().0,
        };
        vectorised(improve);
        integrated
    }

    /// Adds to right-hand sides of the linearised interval equations, and of each integral's, what the method's
    /// quadrature at the stages misses of `∫ f_y (S - S̃) ds`: S - S̃ is a polynomial of too high a degree for it. Without
    /// that a fixed part of the error is missed, however short the intervals.
    pub(crate) fn add_remainders(
        &self,
        extension: &Extension,
        defects: &Defects,
        scales: &[f64],
        integrated: &mut [f64],
    ) {
        vectorised(AddRemainders {
            remainders: self.system.tableau.remainders(),
            pieces: self.pieces(Some(extension)),
            samples: &defects.samples,
            views: self.stages.views(self.steps()),
            pattern: &self.system.layout.regions[self.region].state_pattern,
            scales,
            room: [(); 2].map(|()| Lanes::unset(self.n())),
            weighed: &mut Lanes::unset(self.system.tableau.stages() * self.n()),
            integrated: integrated.as_chunks_mut::<W>().0,
        });
    }
}

/// See [`Extended::add_remainders`].
struct AddRemainders<'a> {
    /// One a stage.
    remainders: &'a [Remainder],
    pieces: Pieces<'a>,
    samples: &'a [Sampled],
    views: [View<'a>; MOST_STAGES],
    pattern: &'a [(usize, usize)],
    /// Typical magnitudes of the states.
    scales: &'a [f64],
    /// One value a state.
    room: [Lanes; 2],
    /// One value a stage and state.
    weighed: &'a mut [Lane],
    integrated: &'a mut [[f64; W]],
}

/// The stage in the middle of the interval, at orders 6 and 8.
const MIDDLE: usize = 4;

impl Job for AddRemainders<'_> {
    type Output = ();

    #[inline(always)]
    fn run(mut self) {
        let (n, steps) = (self.scales.len(), self.pieces.steps);
        for t in 0..steps {
            let h = self.pieces.length(t);
            // The first term of a series in h f_y: it counts where that is small.
            let part = self.size(t).map(|size| 1.0 / (1.0 + (size / 4.0) * (size / 4.0)));
            for i in 0..n {
                let parts = self.pieces.parts(i, t);
                let [f0, f1] = self.pieces.slopes(i, t);
                let mut slopes = [Lane::ZERO; 2 + MOST_PLACES];
                slopes[..2].copy_from_slice(&[f0, f1]);
                let sampled = self.samples.iter().flat_map(|sampled| (0..sampled.places).map(move |at| (sampled, at)));
                for (slope, (sampled, place)) in slopes[2..].iter_mut().zip(sampled) {
                    *slope = sampled.slope(i, place, t);
                }
                for (stage, remainder) in self.remainders.iter().enumerate() {
                    let mean = weighted(&slopes, &remainder.slopes);
                    let sum = weighted(&parts, &remainder.basis.weights()) + h * mean;
                    self.weighed[stage * n + i] = part * h * sum;
                }
            }
            for (entry, &(row, state)) in self.pattern.iter().enumerate() {
                let out = &mut self.integrated[row * steps + t];
                let mut sum = Lane(*out);
                for (view, weighed) in self.views.iter().zip(self.weighed.chunks_exact(n)) {
                    sum += view.dy(entry, t) * weighed[state];
                }
                *out = sum.0;
            }
        }
    }
}

#[inline(always)]
fn weighted<const N: usize>(values: &[Lane; N], weights: &[f64; N]) -> Lane {
    values.iter().zip(weights).fold(Lane::ZERO, |sum, (value, weight)| sum + value.times(*weight))
}

impl AddRemainders<'_> {
    /// A bound of the norm of `(h f_y)²` in typical magnitudes on interval `t` of every stretch.
    #[inline(always)]
    fn size(&mut self, t: usize) -> Lane {
        let (h, [once, twice]) = (self.pieces.length(t), &mut self.room);
        once.fill(Lane::ZERO);
        twice.fill(Lane::ZERO);
        let entries = || self.pattern.iter().enumerate().filter(|(_, (row, _))| *row < self.scales.len());
        let entry = |entry: usize, row: usize, state: usize| {
            (h * self.views[MIDDLE].dy(entry, t)).abs().times(self.scales[state] / self.scales[row])
        };
        for (at, &(row, state)) in entries() {
            once[row] += entry(at, row, state);
        }
        for (at, &(row, state)) in entries() {
            twice[row] += entry(at, row, state) * once[state];
        }
        twice.iter().fold(Lane::ZERO, |most, size| most.zip(*size, f64::max))
    }
}

/// See [`Extended::improved`].
struct Improve<'a> {
    tableau: &'static Tableau,
    improvement: Improvement<'a>,
    /// Values at the stages.
    views: [View<'a>; MOST_STAGES],
    pattern: &'a [(usize, usize)],
    chained: &'a [(usize, usize)],
    /// J, row by row.
    jumps: &'a [[f64; W]],
    rows: usize,
    /// S̃ - S and X at one stage, and f_y X at one stage after the other.
    rises: &'a mut [Lane],
    moved: &'a mut [Lane],
    slopes: &'a mut [Lane],
    /// What is wanted; J on entry.
    integrated: &'a mut [[f64; W]],
}

impl Job for Improve<'_> {
    type Output = ();

    #[inline(always)]
    fn run(mut self) {
        for t in 0..self.improvement.pieces.steps {
            self.improve(t);
        }
    }
}

impl Improve<'_> {
    /// Interval `t` of every stretch.
    #[inline(always)]
    fn improve(&mut self, t: usize) {
        let (tableau, steps) = (self.tableau, self.improvement.pieces.steps);
        let (h, jumps) = (self.improvement.pieces.length(t), self.jumps);
        let jump = |state: usize| Lane(jumps[state * steps + t]);
        for &(u, v) in self.chained {
            // v counts half at either node, at the right one with e_1; the integral of S̃ - S is that of its stages.
            self.add(u, h.times(tableau.b[1] - 0.5) * jump(v), t);
        }
        for stage in 2..tableau.stages() {
            let (basis, v_r, b) = (Basis::value(tableau.c[stage]), tableau.v[stage], tableau.b[stage]);
            for i in 0..self.rises.len() {
                self.rises[i] = self.improvement.at(stage, &basis, i, t);
            }
            for &(u, v) in self.chained {
                self.add(u, -(h.times(b) * self.rises[v]), t);
            }
            let (known, slopes) = self.slopes.split_at_mut((stage - 2) * self.rows);
            for (i, moved) in self.moved.iter_mut().enumerate() {
                *moved = -self.rises[i] - jump(i).times(v_r);
                for (slopes, &x) in known.chunks_exact(self.rows).zip(tableau.x[stage].iter().skip(2)) {
                    *moved += h.times(x) * slopes[i];
                }
            }
            if let Some(odd) = tableau.odd_part(stage) {
                for &(u, v) in self.chained {
                    self.moved[u] += ((h * jump(v)).times(6.0) - jump(u).times(12.0)).times(odd);
                }
            }
            let (slopes, view) = (&mut slopes[..self.rows], self.views[stage]);
            slopes.fill(Lane::ZERO);
            for (entry, &(row, state)) in self.pattern.iter().enumerate() {
                slopes[row] += view.dy(entry, t) * self.moved[state];
            }
            for row in 0..self.rows {
                let twice = self.chained.iter().find(|(u, _)| *u == row);
                let (weight, from) =
                    twice.map_or((h.times(b), row), |&(_, v)| ((h * h).times(tableau.twice_integrated(stage)), v));
                let slope = self.slopes[(stage - 2) * self.rows + from];
                self.add(row, weight * slope, t);
            }
        }
    }

    #[inline(always)]
    fn add(&mut self, row: usize, value: Lane, t: usize) {
        let out = &mut self.integrated[row * self.improvement.pieces.steps + t];
        *out = (Lane(*out) + value).0;
    }
}
