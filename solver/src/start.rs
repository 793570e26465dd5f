//! Where Newton's iteration starts: a guess, or a solution carried to other meshes.

use crate::collocation::Iterate;
use crate::collocation::coupled::interpolated;
use crate::collocation::grid::Grid;
use crate::guess::{Guess, RegionGuess};
use crate::measure::Solved;
use crate::mesh::split;
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
    let old = solved.regions();
    let regions = old.iter().zip(meshes).map(|(old, mesh)| old.sampled(mesh)).collect();
    let mut start = Start::from(&Guess { regions, constants: solved.converged.x.constants.clone() });
    if tableau.coupled {
        let inner = old.iter().zip(&start.grids).map(|(old, grid)| old.sampled_inside(grid, tableau));
        start.x.inner = inner.collect();
    }
    start
}

/// A guess on the meshes of a solution that is near: where inner stages are unknowns, they are those of the solution,
/// moved as the nodes beside them are.
pub(crate) fn near(solution: &Solution, guess: &Guess) -> Start {
    let (mut start, tableau) = (Start::from(guess), solution.order().tableau());
    if tableau.coupled {
        let old = Guess::from(solution).iterate(&start.grids);
        for (index, (grid, region)) in start.grids.iter().zip(solution.regions()).enumerate() {
            let moved: Vec<f64> = start.x.y[index].iter().zip(&old.y[index]).map(|(new, old)| new - old).collect();
            let mut inner = region.sampled_inside(grid, tableau);
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
    solved.system.grids.iter().map(|grid| split(&grid.mesh, &vec![2; grid.intervals()])).collect()
}

/// Halves every interval, states interpolated linearly.
pub(crate) fn halved(start: &Start) -> Start {
    let halve = |values: &[f64]| -> Vec<f64> {
        let pairs = values.windows(2).flat_map(|pair| [pair[0], 0.5 * (pair[0] + pair[1])]);
        pairs.chain(values.last().copied()).collect()
    };
    let regions = start.grids.iter().zip(&start.x.y).map(|(grid, y)| RegionGuess {
        mesh: halve(&grid.mesh),
        states: y.chunks_exact(grid.node_stride()).map(|y| halve(&grid.unpack(y))).collect(),
    });
    Start::from(&Guess { regions: regions.collect(), constants: start.x.constants.clone() })
}

impl From<&Guess> for Start {
    fn from(guess: &Guess) -> Self {
        let grids = guess.grids();
        Self { x: guess.iterate(&grids), grids }
    }
}

impl RegionSolution {
    /// The solution at other nodes; old nodes keep their values exactly.
    pub(crate) fn sampled(&self, mesh: Vec<f64>) -> RegionGuess {
        let states = self.eval_along(&mesh);
        RegionGuess { mesh, states }
    }

    /// The solution at the inner stages of a mesh, as [`Iterate::inner`] stands.
    fn sampled_inside(&self, grid: &Grid, tableau: &Tableau) -> Vec<f64> {
        let (len, states, stages) = (grid.interval_stride(), self.states(), tableau.unknown_stages());
        let mut order: Vec<usize> = (0..stages).collect();
        order.sort_by(|&a, &b| tableau.c[a + 2].total_cmp(&tableau.c[b + 2]));
        let inside = |pair: &[f64]| {
            let (s, h) = (pair[0], pair[1] - pair[0]);
            order.iter().map(move |stage| s + tableau.c[stage + 2] * h)
        };
        let places: Vec<f64> = grid.mesh.windows(2).flat_map(inside).collect();
        let mut out = vec![0.0; stages * states * len];
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
