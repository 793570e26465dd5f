//! Where Newton's iteration starts: a guess, or a solution carried to other meshes.

use crate::basis::Basis;
use crate::by_region::ByRegion;
use crate::collocation::Iterate;
use crate::collocation::grid::Grid;
use crate::collocation::inner::interpolated;
use crate::collocation::interpolant::Extension;
use crate::guess::{Guess, RegionGuess};
use crate::linear::memory::Numbers;
use crate::linear::scalar::W;
use crate::linear::simd::elementwise;
use crate::measure::Solved;
use crate::mesh;
use crate::newton::Converged;
use crate::problem::Problem;
use crate::solution::{RegionSolution, Solution};
use crate::tableau::Tableau;

/// Where Newton's iteration is to start.
#[derive(Clone)]
pub(crate) struct Start {
    pub grids: Vec<Grid>,
    pub x: Iterate,
}

/// The solution on other meshes.
pub(crate) fn transfer<P: Problem + ?Sized>(solved: &Solved<'_, P>, meshes: Vec<Vec<f64>>) -> Start {
    carried(solved, meshes, solved.system.tableau)
}

/// The same, for another method.
pub(crate) fn carried<P: Problem + ?Sized>(solved: &Solved<'_, P>, meshes: Vec<Vec<f64>>, tableau: &Tableau) -> Start {
    let Converged { x, work, .. } = &solved.converged;
    let grids: Vec<Grid> = meshes.into_iter().map(Grid::new).collect();
    let (mut y, mut inner) = (ByRegion::default(), ByRegion::default());
    for (region, new) in grids.iter().enumerate() {
        let old = Packed {
            grid: &solved.system.grids[region],
            states: solved.system.plan.regions[region].n,
            y: &x.y[region],
            f: &work.regions[region].nodes.f,
            extension: &solved.extensions[region],
        };
        let (nodes, stages) = old.sampled(new, tableau, solved.converged.linear);
        y.push(nodes);
        if tableau.coupled {
            inner.push(stages);
        }
    }
    Start { grids, x: Iterate { y, inner, constants: x.constants.clone() } }
}

/// A region's solution in working order.
struct Packed<'a> {
    grid: &'a Grid,
    states: usize,
    y: &'a [f64],
    /// Right-hand sides at the nodes.
    f: &'a [f64],
    extension: &'a Extension,
}

/// An interval: its index and its working position, by stretch and step.
#[derive(Default)]
struct Interval {
    index: usize,
    stretch: usize,
    step: usize,
}

impl Packed<'_> {
    /// At the nodes of another mesh and at the inner stages there that are unknowns, as an [`Iterate`] has them. Old
    /// nodes keep their values exactly. Where the problem is linear, one iteration leads from anywhere to its solution:
    /// between the nodes, straight lines do.
    fn sampled(&self, new: &Grid, tableau: &Tableau, linear: bool) -> (Numbers, Numbers) {
        let (nodes, len, stages) = (new.node_stride(), new.interval_stride(), tableau.unknown_stages());
        let (mut y, mut inner) = (Numbers::unset(self.states * nodes), Numbers::unset(stages * self.states * len));
        let mut order: Vec<usize> = if linear { Vec::new() } else { (0..stages).collect() };
        order.sort_by(|&a, &b| tableau.c[a + 2].total_cmp(&tableau.c[b + 2]));
        let mut interval = Interval::default();
        for (j, p) in new.positions() {
            // Padding repeats the last node.
            let s = new.mesh[j.min(new.intervals())];
            let length = if j < new.intervals() { new.mesh[j + 1] - s } else { 0.0 };
            self.write(s, &mut interval, &mut y[p..], nodes);
            if p < len {
                for &stage in &order {
                    let out = &mut inner[stage * self.states * len + p..];
                    self.write(s + tableau.c[stage + 2] * length, &mut interval, out, len);
                }
            }
        }
        // The last row repeats the first of the next stretch.
        for y in y.chunks_exact_mut(nodes) {
            y.copy_within(1..W, len);
        }
        if linear {
            for (stage, inner) in inner.chunks_exact_mut(self.states * len).enumerate() {
                let c = tableau.c[stage + 2];
                for (inner, y) in inner.chunks_exact_mut(len).zip(y.chunks_exact(nodes)) {
                    elementwise(inner, [&y[..len], &y[W..]], |_, [left, right]| left + c * (right - left));
                }
            }
        }
        (y, inner)
    }

    /// The states at `s`, which is not to the left of the interval given, each `stride` after the one before.
    fn write(&self, s: f64, interval: &mut Interval, out: &mut [f64], stride: usize) {
        let mesh = &self.grid.mesh;
        while interval.index + 1 < self.grid.intervals() && mesh[interval.index + 1] <= s {
            interval.index += 1;
            interval.step += 1;
            if interval.step == self.grid.steps {
                (interval.stretch, interval.step) = (interval.stretch + 1, 0);
            }
        }
        let (nodes, len) = (self.grid.node_stride(), self.grid.interval_stride());
        let p = interval.step * W + interval.stretch;
        let left = mesh[interval.index];
        let h = mesh[interval.index + 1] - left;
        let basis = Basis::value((s - left) / h);
        let Extension { alpha, beta, gamma, delta } = self.extension;
        // From here on all places of a state lie as far from those of the state before.
        let (y, f, alpha, beta) = (&self.y[p..], &self.f[p..], &alpha[p..], &beta[p..]);
        let higher = gamma.get(p..).zip(delta.get(p..)).filter(|_| !gamma.is_empty());
        for i in 0..self.states {
            let (node, at) = (i * nodes, i * len);
            let (y0, y1, f0, f1) = (y[node], y[node + W], f[node], f[node + W]);
            let mut rise = basis.rise * (y1 - y0)
                + h * (basis.left * f0 + basis.right * f1)
                + basis.alpha * alpha[at]
                + basis.beta * beta[at];
            if let Some((gamma, delta)) = higher {
                rise += basis.gamma * gamma[at] + basis.delta * delta[at];
            }
            out[i * stride] = y0 + rise;
        }
    }
}

/// A guess on the meshes of a solution that is near: where inner stages are unknowns, they are those of the solution,
/// `known` or as it is there, moved as the nodes beside them are.
pub(crate) fn near(solution: &Solution, known: &ByRegion<Numbers>, guess: &Guess) -> Start {
    let (mut start, tableau) = (Start::from(guess), solution.order().tableau());
    if tableau.coupled {
        let old = Guess::from(solution).iterate(&start.grids);
        for (index, (grid, region)) in start.grids.iter().zip(solution.regions()).enumerate() {
            let moved: Vec<f64> = start.x.y[index].iter().zip(&old.y[index]).map(|(new, old)| new - old).collect();
            let mut inner = known.get(index).cloned().unwrap_or_else(|| region.sampled_inside(grid, tableau));
            let moves = interpolated(tableau, grid, &moved, None);
            inner.iter_mut().zip(&moves).for_each(|(inner, moved)| *inner += moved);
            start.x.inner.push(inner);
        }
    }
    start
}

/// The meshes with every interval halved. Where a layer is barely resolved, splitting some intervals moves it by more
/// than its width, which Newton's iteration may not follow; splitting all moves it less.
pub(crate) fn twice<P: Problem + ?Sized>(solved: &Solved<'_, P>) -> Vec<Vec<f64>> {
    solved.system.grids.iter().map(|grid| mesh::halved(&grid.mesh)).collect()
}

/// On other meshes, states interpolated linearly.
pub(crate) fn on(start: &Start, meshes: Vec<Vec<f64>>) -> Start {
    let regions = start.grids.iter().zip(&start.x.y).zip(meshes).map(|((grid, y), mesh)| {
        let old = &grid.mesh;
        let along = |values: &[f64]| -> Vec<f64> {
            let mut j = 0;
            let at = mesh.iter().map(|&s| {
                while j + 2 < old.len() && old[j + 1] <= s {
                    j += 1;
                }
                let part = (s - old[j]) / (old[j + 1] - old[j]);
                values[j] + part * (values[j + 1] - values[j])
            });
            at.collect()
        };
        let states = grid.unpack(y).iter().map(along).collect();
        RegionGuess { mesh, states }
    });
    Start::from(&Guess { regions: regions.collect(), constants: start.x.constants.clone() })
}

/// Halves every interval, states interpolated linearly.
pub(crate) fn halved(start: &Start) -> Start {
    on(start, start.grids.iter().map(|grid| mesh::halved(&grid.mesh)).collect())
}

impl From<&Guess> for Start {
    fn from(guess: &Guess) -> Self {
        let grids = guess.grids();
        Self { x: guess.iterate(&grids), grids }
    }
}

impl RegionSolution {
    /// The solution at the inner stages of a mesh, as [`Iterate::inner`] stands.
    fn sampled_inside(&self, grid: &Grid, tableau: &Tableau) -> Numbers {
        let (len, states, stages) = (grid.interval_stride(), self.states(), tableau.unknown_stages());
        let mut order: Vec<usize> = (0..stages).collect();
        order.sort_by(|&a, &b| tableau.c[a + 2].total_cmp(&tableau.c[b + 2]));
        let inside = |pair: &[f64]| {
            let (s, h) = (pair[0], pair[1] - pair[0]);
            order.iter().map(move |stage| s + tableau.c[stage + 2] * h)
        };
        let places: Vec<f64> = grid.mesh.windows(2).flat_map(inside).collect();
        let mut out = Numbers::zeros(stages * states * len);
        for (i, values) in self.eval_along(&places).iter().enumerate() {
            for (k, &stage) in order.iter().enumerate() {
                let out = &mut out[(stage * states + i) * len..][..len];
                // Padding repeats the last node.
                out.fill(self.state(i)[self.intervals()]);
                (0..grid.intervals()).for_each(|j| out[grid.position(j)] = values[j * stages + k]);
            }
        }
        out
    }
}
