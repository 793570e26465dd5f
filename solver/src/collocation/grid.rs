//! A region's mesh, in the order in which several stretches of it are worked on side by side.
//!
//! `N` intervals are cut into `W` stretches of `steps` consecutive intervals, padded at the end with intervals of
//! length zero. Interval `t` of stretch `l` stands at `t * W + l`, so that one vector holds interval `t` of
//! every stretch. Nodes likewise, in `steps + 1` rows: the last row repeats the first of the next stretch, which
//! makes the right node of the interval at `p` stand at `p + W`.

use crate::linear::memory::Numbers;
use crate::linear::scalar::W;
use crate::rows::Rows;

#[derive(Debug, Clone)]
pub(crate) struct Grid {
    /// The user's view: `N + 1` increasing nodes.
    pub mesh: Vec<f64>,
    /// Intervals in each stretch.
    pub steps: usize,
    /// Node positions in working order, `(steps + 1) * W`.
    pub s: Numbers,
    /// Interval lengths in working order, `steps * W`.
    pub h: Numbers,
    /// `1 / (N + 1)` where a node stands first in working order, 0 where it is repeated.
    pub weight: Numbers,
}

impl Grid {
    /// `mesh`: at least two increasing nodes.
    pub(crate) fn new(mesh: Vec<f64>) -> Self {
        let steps = (mesh.len() - 1).div_ceil(W);
        let (s, h, weight) = (Numbers::default(), Numbers::default(), Numbers::zeros((steps + 1) * W));
        let mut grid = Self { steps, s, h, weight, mesh };
        grid.s = grid.pack(&grid.mesh);
        let weight = 1.0 / grid.mesh.len() as f64;
        // Padding is at the end of a stretch.
        let nodes = grid.mesh.len();
        for l in 0..W {
            let left = nodes.saturating_sub(l * steps).min(steps);
            (0..left).for_each(|t| grid.weight[t * W + l] = weight);
        }
        if nodes > W * steps {
            let last = grid.last();
            grid.weight[last] = weight;
        }
        grid.h = (0..steps * W).map(|p| grid.s[p + W] - grid.s[p]).collect();
        grid
    }

    pub(crate) fn intervals(&self) -> usize {
        self.mesh.len() - 1
    }

    /// Distance between components of node arrays.
    pub(crate) fn node_stride(&self) -> usize {
        (self.steps + 1) * W
    }

    /// Distance between components of interval arrays.
    pub(crate) fn interval_stride(&self) -> usize {
        self.steps * W
    }

    /// Working position of interval or node `j < N`; for node `N` see [`last`](Self::last).
    #[inline]
    pub(crate) fn position(&self, j: usize) -> usize {
        (j % self.steps) * W + j / self.steps
    }

    /// Working position of node `j <= N`.
    #[inline]
    pub(crate) fn node(&self, j: usize) -> usize {
        if j >= self.steps * W { self.last() } else { self.position(j) }
    }

    /// All nodes or, but for the last, intervals with their working positions, in the mesh's order; padding follows.
    pub(crate) fn positions(&self) -> impl Iterator<Item = (usize, usize)> + use<> {
        let (steps, last) = (self.steps, self.last());
        let stretches = (0..W).flat_map(move |l| (0..steps).map(move |t| t * W + l));
        stretches.chain(std::iter::once(last)).enumerate()
    }

    /// Working positions of the first `count` intervals, in the mesh's order.
    #[inline]
    pub(crate) fn each(&self, count: usize, mut f: impl FnMut(usize)) {
        for l in 0..W {
            let left = count.saturating_sub(l * self.steps).min(self.steps);
            (0..left).for_each(|t| f(t * W + l));
        }
    }

    /// Which interval or node a working position holds; padding answers with the last.
    pub(crate) fn index(&self, p: usize) -> usize {
        (p % W * self.steps + p / W).min(self.intervals())
    }

    /// Working position of the end of the last stretch.
    pub(crate) fn last(&self) -> usize {
        self.node_stride() - 1
    }

    /// One component at the nodes, into working order.
    pub(crate) fn pack(&self, values: &[f64]) -> Numbers {
        (0..self.node_stride()).map(|p| values[self.index(p)]).collect()
    }

    /// Components at the nodes, out of working order.
    pub(crate) fn unpack(&self, values: &[f64]) -> Rows {
        self.rows_in_order(values, self.node_stride(), self.mesh.len())
    }

    /// Components of the intervals, out of working order.
    pub(crate) fn unpack_intervals(&self, values: &[f64]) -> Rows {
        self.rows_in_order(values, self.interval_stride(), self.intervals())
    }

    /// A number for each of the first `count` intervals, by their working positions, in the mesh's order.
    pub(crate) fn in_order(&self, count: usize, of: impl Fn(usize) -> f64) -> Numbers {
        let (mut out, mut j) = (Numbers::unset(count), 0);
        self.each(count, |p| {
            out[j] = of(p);
            j += 1;
        });
        out
    }

    /// `count` values of each component, `stride` in working order.
    fn rows_in_order(&self, values: &[f64], stride: usize, count: usize) -> Rows {
        let mut out = Vec::with_capacity(values.len() / stride * count);
        for values in values.chunks_exact(stride) {
            let lanes = values.as_chunks::<W>().0;
            for l in 0..W {
                let left = count.saturating_sub(l * self.steps).min(self.steps);
                out.extend(lanes[..left].iter().map(|lane| lane[l]));
            }
            if count > W * self.steps {
                out.push(values[self.last()]);
            }
        }
        Rows::new(out, count)
    }

    /// As [`pack`](Self::pack), all components one after the other.
    pub(crate) fn pack_all(&self, components: &[Vec<f64>]) -> Numbers {
        let stride = self.node_stride();
        let values = components.iter().flat_map(|values| (0..stride).map(|p| values[self.index(p)]));
        Numbers::collected(components.len() * stride, values)
    }
}

/// Intervals of all regions.
pub(crate) fn intervals(grids: &[Grid]) -> usize {
    grids.iter().map(Grid::intervals).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn working_order_is_undone() {
        for intervals in 1..40 {
            let mesh: Vec<f64> = (0..=intervals).map(|j| (j * j + 1) as f64).collect();
            let grid = Grid::new(mesh.clone());
            assert_eq!(grid.unpack(&grid.s).row(0), mesh);
            let lengths: Vec<f64> = mesh.windows(2).map(|pair| pair[1] - pair[0]).collect();
            assert_eq!(grid.unpack_intervals(&grid.h).row(0), lengths);
            assert_eq!(grid.h.iter().sum::<f64>(), mesh[intervals] - mesh[0]);
        }
    }
}
