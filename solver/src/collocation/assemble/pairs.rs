//! The interval equations of equations of second order and nothing else, at coupled inner stages: what
//! [`Assembly::linearise`] and its kind do for any equations, with all sizes known when compiled.

use super::{Assembly, Inner};
use crate::collocation::coupled::{Coupling, Parts};
use crate::collocation::roles;
use crate::linear::chain::Block;
use crate::linear::qr;
use crate::linear::scalar::{Lane, Scalar};
use crate::linear::simd::{Job, vectorised};
use crate::tableau::{COUPLED, Tableau};

/// One interval of every stretch. It is compiled once, and not for every number of states as what it is called from.
pub(super) struct Pairs<'a, 'b, 'c> {
    pub assembly: &'a Assembly<'b>,
    pub t: usize,
    pub inner: Inner<'a>,
    pub block: &'a mut Block<&'c mut [Lane]>,
}

impl Pairs<'_, '_, '_> {
    /// Writes the equations, and what is kept of the inner stages, if the region is of this kind; else nothing. Whether
    /// it was so.
    #[inline(never)]
    pub(super) fn vectorised(self) -> bool {
        vectorised(self)
    }
}

impl Job for Pairs<'_, '_, '_> {
    type Output = bool;

    #[inline(always)]
    fn run(self) -> bool {
        let (plan, roles) = (self.assembly.plan, &self.inner.coupling.roles);
        if !plan.active.is_empty() || !plan.columns.is_empty() || self.inner.coupling.open(self.t).is_some() {
            return false;
        }
        if let Some(pairs) = roles.pairs::<1>() {
            self.linearise::<1, 2, 3>(pairs);
        } else if let Some(pairs) = roles.pairs::<2>() {
            self.linearise::<2, 4, 6>(pairs);
        } else {
            return false;
        }
        true
    }
}

impl Pairs<'_, '_, '_> {
    /// `Q` equations of second order, `N` states, `M` unknowns at the inner stages.
    #[inline(always)]
    fn linearise<const Q: usize, const N: usize, const M: usize>(self, pairs: roles::Pairs<Q>) {
        let Self { assembly, t, inner: Inner { coupling, kept }, block } = self;
        let equations = Equations::new::<N>(assembly, coupling, pairs, t);
        let Parts { qr, moves, slopes } = coupling.parts_mut(kept);
        equations.keep::<N>(slopes);
        equations.assemble::<M>(qr::matrix(M, qr));
        qr::factor(M, qr);
        for (side, out) in [&mut block.a, &mut block.b].into_iter().enumerate() {
            for c in 0..Q {
                for moving in [Moving { side, of: c, integral: true }, Moving { side, of: c, integral: false }] {
                    let state = if moving.integral { pairs.integrals[c] } else { pairs.unknowns[c] };
                    let (mut u, mut v) = equations.stages::<M>(moving);
                    qr::solve(M, qr, &mut v);
                    equations.integrate(&v, &mut u);
                    let moves = &mut moves[(side * N + state) * COUPLED * N..][..COUPLED * N];
                    for (r, (&integral, &unknown)) in pairs.integrals.iter().zip(&pairs.unknowns).enumerate() {
                        for i in 0..COUPLED {
                            (moves[i * N + integral], moves[i * N + unknown]) = (u[i][r], v[i * Q + r]);
                        }
                    }
                    equations.intervals::<M>(moving, (&u, &v), &mut out[state * N..(state + 1) * N]);
                }
            }
        }
    }
}

/// Derivatives of the slopes of the unknowns v, times h.
#[derive(Clone, Copy)]
struct Slopes<const Q: usize> {
    /// With respect to the integrals u.
    by_integrals: [[Lane; Q]; Q],
    /// With respect to the unknowns.
    by_unknowns: [[Lane; Q]; Q],
}

/// Which state of a node moves.
#[derive(Clone, Copy)]
struct Moving {
    /// The left node, or the right one.
    side: usize,
    /// Of which pair.
    of: usize,
    /// u or v.
    integral: bool,
}

/// One interval's linearised equations, `u' = v` and `v' = f(s, u, v)`.
struct Equations<'a, const Q: usize> {
    tableau: &'static Tableau,
    /// x_ij of the inner stages.
    weights: &'a [[f64; COUPLED]; COUPLED],
    pairs: roles::Pairs<Q>,
    /// What a slope of 1 of u, in units of v, comes to over the interval, in units of u.
    rise: [Lane; Q],
    /// At all stages.
    slopes: [Slopes<Q>; COUPLED + 2],
}

impl<'a, const Q: usize> Equations<'a, Q> {
    #[inline(always)]
    fn new<const N: usize>(assembly: &Assembly<'_>, coupling: &'a Coupling, pairs: roles::Pairs<Q>, t: usize) -> Self {
        let (h, d) = (Lane(assembly.h[t]), assembly.magnitudes);
        let roles::Pairs { unknowns, integrals } = pairs;
        let mut rise = [Lane::ZERO; Q];
        for (r, rise) in rise.iter_mut().enumerate() {
            *rise = h.times(d[unknowns[r]] / d[integrals[r]]);
        }
        let none = Slopes { by_integrals: [[Lane::ZERO; Q]; Q], by_unknowns: [[Lane::ZERO; Q]; Q] };
        let mut slopes = [none; COUPLED + 2];
        for (slopes, view) in slopes.iter_mut().zip(&assembly.views) {
            let mut jacobian = [[Lane::ZERO; N]; N];
            for entry in &assembly.states {
                jacobian[entry.row][entry.column] += view.dy(entry.from, t).times(entry.factor) * h;
            }
            for (r, &row) in unknowns.iter().enumerate() {
                for c in 0..Q {
                    slopes.by_integrals[r][c] = jacobian[row][integrals[c]];
                    slopes.by_unknowns[r][c] = jacobian[row][unknowns[c]];
                }
            }
        }
        Self { tableau: assembly.tableau, weights: &coupling.weights.x, pairs, rise, slopes }
    }

    /// Slopes at the inner stage `j`.
    #[inline(always)]
    fn inner(&self, j: usize) -> &Slopes<Q> {
        &self.slopes[j + 2]
    }

    /// `h b_j J_j`, as [`Parts::slopes`] is.
    #[inline(always)]
    fn keep<const N: usize>(&self, out: &mut [Lane]) {
        let roles::Pairs { unknowns, integrals } = self.pairs;
        out.fill(Lane::ZERO);
        for (j, out) in out.chunks_exact_mut(N * N).enumerate() {
            let b = self.tableau.b[j + 2];
            for r in 0..Q {
                out[unknowns[r] * N + integrals[r]] = self.rise[r].times(b);
                for c in 0..Q {
                    out[integrals[c] * N + unknowns[r]] = self.inner(j).by_integrals[r][c].times(b);
                    out[unknowns[c] * N + unknowns[r]] = self.inner(j).by_unknowns[r][c].times(b);
                }
            }
        }
    }

    /// The matrix of the stage equations, for the unknowns alone.
    #[inline(always)]
    fn assemble<const M: usize>(&self, matrix: &mut [Lane]) {
        for (l, c) in (0..COUPLED).flat_map(|l| (0..Q).map(move |c| (l, c))) {
            let column = &mut matrix[(l * Q + c) * M..][..M];
            for (i, weights) in self.weights.iter().enumerate() {
                for r in 0..Q {
                    let mut twice = Lane::ZERO;
                    for (j, (weight, next)) in weights.iter().zip(self.weights).enumerate() {
                        twice += self.inner(j).by_integrals[r][c].times(weight * next[l]);
                    }
                    let moved = self.inner(l).by_unknowns[r][c].times(weights[l]) + twice * self.rise[c];
                    column[i * Q + r] = if (l, c) == (i, r) { Lane::ONE - moved } else { -moved };
                }
            }
        }
    }

    /// What is known of u at the inner stages, and the right-hand sides of the equations for v.
    #[inline(always)]
    fn stages<const M: usize>(&self, moving: Moving) -> ([[Lane; Q]; COUPLED], [Lane; M]) {
        let (mut u, mut v) = ([[Lane::ZERO; Q]; COUPLED], [Lane::ZERO; M]);
        let slopes = self.moved(moving);
        for i in 0..COUPLED {
            let (x, right) = (self.tableau.x[i + 2][moving.side], self.tableau.v[i + 2]);
            let share = Lane::ONE.times(if moving.side == 0 { 1.0 - right } else { right });
            for r in 0..Q {
                v[i * Q + r] = slopes[r].times(x);
            }
            if moving.integral {
                u[i][moving.of] = share;
            } else {
                u[i][moving.of] = self.rise[moving.of].times(x);
                v[i * Q + moving.of] += share;
            }
        }
        for (j, u) in u.iter().enumerate() {
            for r in 0..Q {
                let mut moved = Lane::ZERO;
                for (slope, u) in self.inner(j).by_integrals[r].iter().zip(u) {
                    moved += *slope * *u;
                }
                for i in 0..COUPLED {
                    v[i * Q + r] += moved.times(self.weights[i][j]);
                }
            }
        }
        (u, v)
    }

    /// The slopes of v at a node when one of its states moves, times h.
    #[inline(always)]
    fn moved(&self, Moving { side, of, integral }: Moving) -> [Lane; Q] {
        let Slopes { by_integrals, by_unknowns } = &self.slopes[side];
        if integral { by_integrals.map(|row| row[of]) } else { by_unknowns.map(|row| row[of]) }
    }

    /// Adds what v at the inner stages makes of u there.
    #[inline(always)]
    fn integrate(&self, v: &[Lane], u: &mut [[Lane; Q]; COUPLED]) {
        for (u, weights) in u.iter_mut().zip(self.weights) {
            for (r, u) in u.iter_mut().enumerate() {
                let mut sum = Lane::ZERO;
                for (j, weight) in weights.iter().enumerate() {
                    sum += v[j * Q + r].times(*weight);
                }
                *u += sum * self.rise[r];
            }
        }
    }

    /// One column of the interval equations, for what moves at the node and at the inner stages.
    #[inline(always)]
    fn intervals<const M: usize>(&self, moving: Moving, (u, v): (&[[Lane; Q]; COUPLED], &[Lane; M]), out: &mut [Lane]) {
        let (slopes, b) = (self.moved(moving), &self.tableau.b);
        for (r, (&integral, &unknown)) in self.pairs.integrals.iter().zip(&self.pairs.unknowns).enumerate() {
            let own = moving.of == r;
            let node = if own && !moving.integral { b[moving.side] } else { 0.0 };
            let (mut once, mut twice) = (Lane::ONE.times(node), slopes[r].times(b[moving.side]));
            for (j, u) in u.iter().enumerate() {
                let Slopes { by_integrals, by_unknowns } = self.inner(j);
                let mut moved = Lane::ZERO;
                for c in 0..Q {
                    moved += by_integrals[r][c] * u[c] + by_unknowns[r][c] * v[j * Q + c];
                }
                once += v[j * Q + r].times(b[j + 2]);
                twice += moved.times(b[j + 2]);
            }
            let same = Lane::ONE.times(if moving.side == 0 { -1.0 } else { 1.0 });
            let place = |here: bool| if here { same } else { Lane::ZERO };
            out[integral] = place(own && moving.integral) - self.rise[r] * once;
            out[unknown] = place(own && !moving.integral) - twice;
        }
    }
}
