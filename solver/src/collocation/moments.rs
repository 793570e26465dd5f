//! What the defect does to the inner stages: right-hand sides of the linearised equations for the error.
//!
//! The error `ε = S - y` of the continuous extension S has `ε' = f_y ε + S' - f(S)`, which is rough where S is not the
//! solution. As smooth as a method takes a solution to be is `S̃ = y_0 + ∫ f(S) ds`. Where `D = S - S̃` is wanted it is
//! had by quadrature from f(S) at the places where the defect was sampled: see [`Difference`].

mod remainders;

use super::defect::Defects;
use super::interpolant::{Extended, Extension, Pieces, Sampled};
use super::stages::{MOST_STAGES, View};
use crate::basis::PARTS;
use crate::linear::memory::{Lanes, Numbers};
use crate::linear::scalar::{Lane, Scalar, W};
use crate::linear::simd::{Job, vectorised};
use crate::problem::Problem;
use crate::tableau::{Difference, MOST_PLACES, Tableau};

/// What S and S̃ are sampled of.
#[derive(Clone, Copy)]
struct SampledExtension<'a> {
    pieces: Pieces<'a>,
    samples: &'a [Sampled],
}

/// Of one component on interval `t` of every stretch.
struct Component {
    /// h.
    length: Lane,
    parts: [Lane; PARTS],
    /// f(S) at both nodes and the samples; 0 where there are fewer.
    slopes: [Lane; 2 + MOST_PLACES],
}

impl SampledExtension<'_> {
    #[inline(always)]
    fn component(&self, i: usize, t: usize) -> Component {
        let mut slopes = [Lane::ZERO; 2 + MOST_PLACES];
        slopes[..2].copy_from_slice(&self.pieces.slopes(i, t));
        let places = self.samples.iter().flat_map(|sampled| (0..sampled.places).map(move |place| (sampled, place)));
        for (slope, (sampled, place)) in slopes[2..].iter_mut().zip(places) {
            *slope = sampled.slope(i, place, t);
        }
        Component { length: self.pieces.length(t), parts: self.pieces.parts(i, t), slopes }
    }
}

impl Component {
    /// The weighted sum.
    #[inline(always)]
    fn difference(&self, of: &Difference) -> Lane {
        weighted(&self.parts, &of.parts) + self.length * weighted(&self.slopes, &of.slopes)
    }
}

#[inline(always)]
fn weighted<const N: usize>(values: &[Lane; N], weights: &[f64; N]) -> Lane {
    values.iter().zip(weights).fold(Lane::ZERO, |sum, (value, weight)| sum + value.times(*weight))
}

impl<P: Problem + ?Sized> Extended<'_, '_, P> {
    fn sampled_extension<'b>(&'b self, extension: &'b Extension, defects: &'b Defects) -> SampledExtension<'b> {
        SampledExtension { pieces: self.pieces(Some(extension)), samples: &defects.samples }
    }

    /// What the defect moves the inner stages by where their states are unknowns, `∫_0^c (S' - f(S)) ds - c ∫_0^1
    /// (S' - f(S)) ds`, as [`Iterate::inner`](super::Iterate::inner) stands: right-hand sides of the linearised stage
    /// equations.
    pub(crate) fn moments(&self, extension: &Extension, defects: &Defects) -> Numbers {
        let (tableau, n) = (self.system.tableau, self.n());
        let mut out = Numbers::unset(tableau.unknown_stages() * n * self.intervals());
        vectorised(Moments {
            tableau,
            sampled: self.sampled_extension(extension, defects),
            jumps: defects.integrated.as_chunks::<W>().0,
            n,
            out: out.as_chunks_mut::<W>().0,
        });
        out
    }

    /// Adds to [`Defects::integrated`], J, what the defect does to the inner stages, as order 6 needs: then it is the
    /// right-hand sides of the linearised interval equations, and of each integral's, for the error `ε = S - y` at the
    /// nodes.
    ///
    /// With `e = S̃ - y`, of which `e' = f_y ε`, `e_0 = ε_0` and `e_1 = ε_1 - J`, the stages of e are those of the
    /// method, and `ε = e + D` there: all that the nodes' errors do not know of is in
    /// `X_r = D_r - v_r J + h Σ_k x_rk f_y X_k`. The derivatives are those at the stages: nothing is evaluated anew.
    pub(crate) fn add_stages(&self, extension: &Extension, defects: &Defects, integrated: &mut [f64]) {
        let (tableau, n, rows) = (self.system.tableau, self.n(), self.rows());
        vectorised(AddStages {
            tableau,
            sampled: self.sampled_extension(extension, defects),
            views: self.stages.views(self.steps()),
            pattern: &self.system.layout.regions[self.region].state_pattern,
            chained: &self.stages.chained,
            jumps: defects.integrated.as_chunks::<W>().0,
            n,
            rows,
            differences: &mut Lanes::unset((tableau.stages() - 2) * n),
            moved: &mut Lanes::unset(n),
            slopes: &mut Lanes::unset((tableau.stages() - 2) * rows),
            integrated: integrated.as_chunks_mut::<W>().0,
        });
    }
}

/// See [`Extended::moments`].
struct Moments<'a> {
    tableau: &'static Tableau,
    sampled: SampledExtension<'a>,
    /// J, row by row.
    jumps: &'a [[f64; W]],
    n: usize,
    /// Stage by stage, state by state.
    out: &'a mut [[f64; W]],
}

impl Job for Moments<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self { tableau, sampled, jumps, n, out } = self;
        let (steps, differences) = (sampled.pieces.steps, &tableau.differences().inside);
        for i in 0..n {
            for t in 0..steps {
                let (component, jump) = (sampled.component(i, t), Lane(jumps[i * steps + t]));
                for ((stage, difference), c) in differences.iter().enumerate().zip(&tableau.c[2..]) {
                    out[(stage * n + i) * steps + t] = (component.difference(difference) - jump.times(*c)).0;
                }
            }
        }
    }
}

/// See [`Extended::add_stages`].
struct AddStages<'a> {
    tableau: &'static Tableau,
    sampled: SampledExtension<'a>,
    /// Values at the stages.
    views: [View<'a>; MOST_STAGES],
    pattern: &'a [(usize, usize)],
    chained: &'a [(usize, usize)],
    /// J, row by row.
    jumps: &'a [[f64; W]],
    n: usize,
    rows: usize,
    /// D at one inner stage after the other, X at one, and f_y X at one after the other.
    differences: &'a mut [Lane],
    moved: &'a mut [Lane],
    slopes: &'a mut [Lane],
    /// What is wanted; J on entry.
    integrated: &'a mut [[f64; W]],
}

impl Job for AddStages<'_> {
    type Output = ();

    #[inline(always)]
    fn run(mut self) {
        for t in 0..self.sampled.pieces.steps {
            self.add_interval(t);
        }
    }
}

impl AddStages<'_> {
    /// Interval `t` of every stretch.
    #[inline(always)]
    fn add_interval(&mut self, t: usize) {
        let (tableau, steps, n) = (self.tableau, self.sampled.pieces.steps, self.n);
        let (h, jumps) = (self.sampled.pieces.length(t), self.jumps);
        let jump = |state: usize| Lane(jumps[state * steps + t]);
        for &(u, v) in self.chained {
            // v counts half at either node, at the right one with e_1; the integral of D is that of its stages.
            self.add(u, h.times(tableau.b[1] - 0.5) * jump(v), t);
        }
        for i in 0..n {
            let component = self.sampled.component(i, t);
            for (stage, difference) in tableau.differences().inside.iter().enumerate() {
                self.differences[stage * n + i] = component.difference(difference);
            }
        }
        for stage in 2..tableau.stages() {
            let (v_r, b) = (tableau.v[stage], tableau.b[stage]);
            for &(u, v) in self.chained {
                self.add(u, h.times(b) * self.differences[(stage - 2) * n + v], t);
            }
            let (known, slopes) = self.slopes.split_at_mut((stage - 2) * self.rows);
            for (i, moved) in self.moved.iter_mut().enumerate() {
                *moved = self.differences[(stage - 2) * n + i] - jump(i).times(v_r);
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
        let out = &mut self.integrated[row * self.sampled.pieces.steps + t];
        *out = (Lane(*out) + value).0;
    }
}
