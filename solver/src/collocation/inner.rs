//! States at inner stages that are unknowns: interpolated between the nodes, and solved for where those are given.

use super::evaluate::{Derivatives, Work};
use super::factor::Factorisation;
use super::grid::Grid;
use super::{Iterate, System};
use crate::basis::Basis;
use crate::linear::memory::{Lanes, Numbers};
use crate::linear::scalar::W;
use crate::linear::simd::{largest, largest_number};
use crate::mesh;
use crate::problem::{Points, Problem};
use crate::stats::Stats;
use crate::tableau::Tableau;

/// Corrections with one matrix at most,
const ROUNDS: usize = 12;
/// and matrices, where the stage equations are solved for given nodes.
const MATRICES: usize = 4;
/// Stage equations are met if no state would change by more than this, in typical magnitudes,
const MET: f64 = 1e-14;
/// and as well as rounding lets them be if it would not by more than this.
const NEARLY_MET: f64 = 1e-9;
/// Slopes that the right-hand side has at the nodes are believed where they move a state by no more than this, in its
/// largest magnitude, from what the neighbouring nodes say.
const BELIEVED: f64 = 0.3;

/// How far the stage equations have been solved.
pub(crate) enum Settled {
    Met,
    /// Not far enough; the size of the first change.
    From(f64),
}

impl<P: Problem + ?Sized> System<'_, P> {
    /// States at the inner stages, if they are unknowns and nothing is known of them: by cubics between the nodes.
    /// Whether it was so. (Between zeros those are zero, whatever the slopes are.)
    pub(crate) fn interpolate(&self, x: &mut Iterate, stats: &mut Stats) -> bool {
        let missing = self.tableau.coupled && x.inner.is_empty();
        if missing {
            let regions = self.grids.iter().zip(&x.y).enumerate().map(|(region, (grid, y))| {
                let len = grid.node_stride();
                if largest_number(y) == 0.0 {
                    return Numbers::zeros(self.tableau.unknown_stages() * y.len() / len * grid.interval_stride());
                }
                if self.linear {
                    // Whatever is guessed, the first correction leads to the solution.
                    return interpolated(self.tableau, grid, y, None);
                }
                let at = Points { len, stride: len, s: &grid.s, y };
                let mut f = Numbers::unset(self.layout.regions[region].rows() * len);
                stats.rhs_points += len;
                self.problem.rhs(region, &at, &x.constants, &mut f);
                interpolated(self.tableau, grid, y, Some(&f))
            });
            x.inner = regions.collect();
        }
        missing
    }

    /// As [`interpolate`](Self::interpolate), then solves the stage equations for given nodes.
    pub(crate) fn complete(&self, x: &mut Iterate, stats: &mut Stats) {
        if self.interpolate(x, stats) {
            self.meet(x, f64::INFINITY, stats);
        }
    }

    /// Solves the stage equations for given nodes, unless that would at first change a state by `limit` typical
    /// magnitudes or more, or does not converge: then nothing is done.
    pub(crate) fn meet(&self, x: &mut Iterate, mut limit: f64, stats: &mut Stats) {
        let (origin, mut work, mut factorisation) = (x.inner.clone(), self.work(), Factorisation::new(self));
        for _ in 0..MATRICES {
            // What is undefined here is so where the iteration starts, which will say so.
            if self.evaluate(x, Derivatives::Planned, &mut work, stats).is_err() {
                break;
            }
            factorisation.condense(self, &work, self.scales(x));
            match self.settle(&factorisation, x, &mut work, limit, stats) {
                Settled::Met => return,
                Settled::From(size) if size < limit => limit = 0.5 * size,
                Settled::From(_) => break,
            }
        }
        x.inner = origin;
    }

    /// Solves the stage equations for given nodes, with the factors held, as long as every change is less than half the
    /// one before. `work` holds the residual at `x`.
    pub(crate) fn settle(
        &self,
        factorisation: &Factorisation,
        x: &mut Iterate,
        work: &mut Work,
        limit: f64,
        stats: &mut Stats,
    ) -> Settled {
        let (mut first, mut last) = (None, limit);
        for _ in 0..ROUNDS {
            let changes = factorisation.stage_correction(self, work);
            let size = largest(changes.iter().map(|lanes| &lanes[..]), &[]);
            let from = *first.get_or_insert(size);
            if size <= MET {
                return Settled::Met;
            }
            if !(size < last) {
                return if last <= NEARLY_MET { Settled::Met } else { Settled::From(from) };
            }
            last = 0.5 * size;
            let before = x.inner.clone();
            self.step_inner(x, &factorisation.scales.states, 1.0, &changes);
            if self.evaluate(x, Derivatives::None, work, stats).is_err() {
                x.inner = before;
                return Settled::From(from);
            }
        }
        Settled::From(first.unwrap_or(limit))
    }

    /// `x.inner += factor * scale * inner`.
    pub(super) fn step_inner(&self, x: &mut Iterate, scales: &[Numbers], factor: f64, inner: &[Lanes]) {
        for ((values, changes), d) in x.inner.iter_mut().zip(inner).zip(scales) {
            let m = self.tableau.unknown_stages() * d.len();
            let steps = changes.len() / m;
            for (row, values) in values.as_chunks_mut::<W>().0.chunks_exact_mut(steps).enumerate() {
                let factor = factor * d[row % d.len()];
                for (values, changes) in values.iter_mut().zip(changes.chunks_exact(m)) {
                    for (value, change) in values.iter_mut().zip(changes[row].0) {
                        *value += factor * change;
                    }
                }
            }
        }
    }
}

/// By cubics with the slopes of parabolas through neighbouring nodes, or with `f` (component by component in working
/// order) where those are to be believed.
pub(crate) fn interpolated(tableau: &Tableau, grid: &Grid, y: &[f64], f: Option<&[f64]>) -> Numbers {
    let (len, mesh, stride) = (grid.interval_stride(), &grid.mesh, grid.node_stride());
    let (states, intervals) = (y.len() / stride, grid.intervals());
    let mut out = Numbers::unset(tableau.unknown_stages() * states * len);
    let (values, given) = (grid.unpack(y), f.map(|f| grid.unpack(&f[..y.len()])));
    // Of each interval, what slopes at its ends come to over it.
    let mut rises: Vec<[f64; 2]> = Vec::with_capacity(intervals);
    for (i, values) in values.iter().enumerate() {
        let size = values.iter().fold(0.0, |size: f64, y| size.max(y.abs()));
        let given = given.as_ref().map(|given| given.row(i));
        let mut left = mesh::slope(mesh, values, 0);
        rises.clear();
        rises.extend(mesh.windows(2).enumerate().map(|(j, ends)| {
            let right = mesh::slope(mesh, values, j + 1);
            let of = |slopes: [f64; 2]| slopes.map(|slope| (ends[1] - ends[0]) * slope);
            let own = of([std::mem::replace(&mut left, right), right]);
            let near = |given: &[f64; 2]| own.iter().zip(given).all(|(a, b)| (a - b).abs() <= BELIEVED * size);
            given.map(|given| of([given[j], given[j + 1]])).filter(near).unwrap_or(own)
        }));
        for (stage, &c) in tableau.c[2..].iter().enumerate() {
            let basis = Basis::value(c);
            let out = &mut out[(stage * states + i) * len..][..len];
            // Padding repeats the last node.
            out.fill(values[intervals]);
            let mut places = values.windows(2).zip(&rises);
            grid.each(intervals, |p| {
                if let Some((y, [left, right])) = places.next() {
                    out[p] = y[0] + basis.rise * (y[1] - y[0]) + basis.left * left + basis.right * right;
                }
            });
        }
    }
    out
}
