//! The interval equations of equations of second order and nothing else, at coupled inner stages: what
//! [`Assembly::linearise`] and its kind do for any equations, with all sizes known when compiled.

use super::{Assembly, Inner};
use crate::collocation::coupled::{COUPLED, Parts};
use crate::linear::chain::Block;
use crate::linear::qr;
use crate::linear::scalar::{Lane, Scalar};
use crate::linear::simd::{Job, vectorised};

/// One interval of every stretch. It is compiled once, and not for every number of states as what it is called from.
pub(super) struct Pairs<'a, 'b> {
    pub assembly: &'a Assembly<'b>,
    pub t: usize,
    pub inner: Inner<'a>,
    pub block: &'a mut Block<Lane>,
}

impl Pairs<'_, '_> {
    /// Whether there is a function for a region of this kind.
    pub(super) fn fits(assembly: &Assembly<'_>, inner: &Inner<'_>) -> bool {
        let (n, roles) = (assembly.plan.n, &inner.coupling.roles);
        let paired = roles.unknowns.len() == roles.integrals.len() && (n == 2 || n == 4);
        paired && assembly.plan.active.is_empty() && assembly.plan.columns.is_empty()
    }

    #[inline(never)]
    pub(super) fn vectorised(self) {
        vectorised(self);
    }
}

impl Job for Pairs<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        match self.assembly.plan.n {
            2 => self.linearise::<1, 2, 3>(),
            _ => self.linearise::<2, 4, 6>(),
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

impl Pairs<'_, '_> {
    /// `Q` equations of second order, `N` states, `M` unknowns at the inner stages.
    #[inline(always)]
    fn linearise<const Q: usize, const N: usize, const M: usize>(self) {
        let Self { assembly, t, inner: Inner { coupling, kept }, block } = self;
        let (tableau, weights, h) = (assembly.tableau, coupling.weights, Lane(assembly.h[t]));
        // v of each equation, and the u that it is the derivative of.
        let (mut v, mut u) = ([0; Q], [0; Q]);
        for (r, &unknown) in coupling.roles.unknowns.iter().enumerate().take(Q) {
            v[r] = unknown;
            let found = coupling.roles.integrals.iter().find(|(_, of)| *of == unknown);
            u[r] = found.map_or(unknown, |&(integral, _)| integral);
        }
        let rise: [Lane; Q] = std::array::from_fn(|r| h.times(assembly.magnitudes[v[r]] / assembly.magnitudes[u[r]]));
        let slopes: [Slopes<Q>; COUPLED + 2] = std::array::from_fn(|stage| {
            let mut jacobian = [[Lane::ZERO; N]; N];
            for entry in &assembly.states {
                jacobian[entry.row][entry.column] += assembly.views[stage].dy(entry.from, t).times(entry.factor) * h;
            }
            let rows = |columns: [usize; Q]| v.map(|row| columns.map(|column| jacobian[row][column]));
            Slopes { by_integrals: rows(u), by_unknowns: rows(v) }
        });
        let inner: [Slopes<Q>; COUPLED] = std::array::from_fn(|j| slopes[j + 2]);
        let Parts { qr, moves, slopes: kept_slopes } = coupling.parts_mut(kept);
        kept_slopes.fill(Lane::ZERO);
        for (j, slopes) in inner.iter().enumerate() {
            let b = tableau.b[j + 2];
            for r in 0..Q {
                kept_slopes[(j * N + v[r]) * N + u[r]] = rise[r].times(b);
                for c in 0..Q {
                    kept_slopes[(j * N + u[c]) * N + v[r]] = slopes.by_integrals[r][c].times(b);
                    kept_slopes[(j * N + v[c]) * N + v[r]] = slopes.by_unknowns[r][c].times(b);
                }
            }
        }
        let matrix = qr::matrix(M, qr);
        for l in 0..COUPLED {
            for c in 0..Q {
                for i in 0..COUPLED {
                    for r in 0..Q {
                        let mut twice = Lane::ZERO;
                        for j in 0..COUPLED {
                            twice += inner[j].by_integrals[r][c].times(weights[i][j] * weights[j][l]);
                        }
                        let moved = inner[l].by_unknowns[r][c].times(weights[i][l]) + twice * rise[c];
                        let same = if (l, c) == (i, r) { Lane::ONE } else { Lane::ZERO };
                        matrix[(l * Q + c) * M + i * Q + r] = same - moved;
                    }
                }
            }
        }
        qr::factor(M, qr);
        for side in 0..2 {
            let out = if side == 0 { &mut block.a } else { &mut block.b };
            for q in 0..N {
                let column = &mut moves[(side * N + q) * COUPLED * N..][..COUPLED * N];
                // What moves when state q of the node does, first of it alone: u and v at the inner stages.
                let (mut by_u, mut by_v) = ([[Lane::ZERO; Q]; COUPLED], [Lane::ZERO; M]);
                let is_v: [bool; Q] = v.map(|row| row == q);
                let node: [Lane; Q] = std::array::from_fn(|r| {
                    let of = |c: usize| u[c] == q;
                    let by = &slopes[side];
                    (0..Q).fold(Lane::ZERO, |sum, c| match (of(c), is_v[c]) {
                        (true, _) => sum + by.by_integrals[r][c],
                        (_, true) => sum + by.by_unknowns[r][c],
                        _ => sum,
                    })
                });
                for i in 0..COUPLED {
                    let (x, share) = (tableau.x[i + 2][side], tableau.v[i + 2]);
                    let share = if side == 0 { 1.0 - share } else { share };
                    for r in 0..Q {
                        let risen = if is_v[r] { rise[r].times(x) } else { Lane::ZERO };
                        by_u[i][r] = if u[r] == q { risen + Lane::ONE.times(share) } else { risen };
                        let moved = node[r].times(x);
                        by_v[i * Q + r] = if is_v[r] { moved + Lane::ONE.times(share) } else { moved };
                    }
                }
                for j in 0..COUPLED {
                    for r in 0..Q {
                        let mut moved = Lane::ZERO;
                        for c in 0..Q {
                            moved += inner[j].by_integrals[r][c] * by_u[j][c];
                        }
                        for i in 0..COUPLED {
                            by_v[i * Q + r] += moved.times(weights[i][j]);
                        }
                    }
                }
                qr::solve(M, qr, &mut by_v);
                for i in 0..COUPLED {
                    for r in 0..Q {
                        let mut risen = Lane::ZERO;
                        for j in 0..COUPLED {
                            risen += by_v[j * Q + r].times(weights[i][j]);
                        }
                        by_u[i][r] += risen * rise[r];
                        (column[i * N + u[r]], column[i * N + v[r]]) = (by_u[i][r], by_v[i * Q + r]);
                    }
                }
                let same = Lane::ONE.times(if side == 0 { -1.0 } else { 1.0 });
                for r in 0..Q {
                    let own = Lane::ONE.times(if is_v[r] { tableau.b[side] } else { 0.0 });
                    let (mut once, mut twice) = (own, node[r].times(tableau.b[side]));
                    for j in 0..COUPLED {
                        let b = tableau.b[j + 2];
                        once += by_v[j * Q + r].times(b);
                        for c in 0..Q {
                            let moved =
                                inner[j].by_integrals[r][c] * by_u[j][c] + inner[j].by_unknowns[r][c] * by_v[j * Q + c];
                            twice += moved.times(b);
                        }
                    }
                    let place = |row: usize| if row == q { same } else { Lane::ZERO };
                    out[q * N + u[r]] = place(u[r]) - rise[r] * once;
                    out[q * N + v[r]] = place(v[r]) - twice;
                }
            }
        }
    }
}
