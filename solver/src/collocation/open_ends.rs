//! Ends of a region at which the right-hand side need not be defined.
//!
//! Collocation at Gauss points gives slopes at the nodes no weight, so that an equation may be singular at an end of
//! its region: `2 u'/x` where u' vanishes is 0/0 there, and a slope may be infinite. Values at such an end are wanted
//! all the same, for the extension between the nodes: those of the polynomials through the inner stages of the interval
//! beside it stand in for them. Intervals of length zero, with which stretches are filled up, lie on the right end; of
//! what is undefined there nothing is wanted. (An extension of degree 7 there, with the slope at the end free, that
//! misses the equations least, was tried: it is better where solutions are smooth, worse where they are not, and meshes
//! are no coarser for it, all together.)

use super::System;
use super::evaluate::Derivatives;
use super::grid::Grid;
use super::stages::Stages;
use crate::problem::{Points, Problem};
use crate::tableau::{COUPLED, Tableau, lagrange};

impl<P: Problem + ?Sized> System<'_, P> {
    /// If the method needs no values at the ends of the region: zeros in place of all of them, each rows of `at.stride`,
    /// at an end where one is not finite; whether it is so at the left and at the right end.
    pub(super) fn forgive_ends<const N: usize>(
        &self,
        region: usize,
        at: &Points<'_>,
        mut values: [&mut [f64]; N],
    ) -> [bool; 2] {
        let (a, b) = self.layout.regions[region].interval;
        let mut undefined = [false; 2];
        if !self.tableau.has_open_ends() {
            return undefined;
        }
        for (p, &s) in at.s.iter().enumerate().filter(|(_, s)| **s == a || **s == b) {
            let column = |values: &&mut [f64]| values.iter().skip(p).step_by(at.stride).all(|value| value.is_finite());
            if !values.iter().all(column) {
                undefined[usize::from(s == b)] = true;
                let each = values.iter_mut().flat_map(|values| values.iter_mut().skip(p).step_by(at.stride));
                each.for_each(|value| *value = 0.0);
            }
        }
        undefined
    }
}

/// Working position of the interval beside an end.
fn beside(grid: &Grid, end: usize) -> usize {
    if end == 0 { 0 } else { grid.position(grid.intervals() - 1) }
}

impl Stages {
    /// Values at undefined ends from those at the inner stages of the intervals beside them.
    pub(super) fn extrapolate(&mut self, grid: &Grid, tableau: &Tableau, derivatives: Derivatives) {
        let (undefined, len, nodes) = (self.nodes.undefined, grid.interval_stride(), grid.node_stride());
        let inner = &self.inner[0];
        for (end, place) in [(0, 0.0), (1, 1.0)].into_iter().filter(|(end, _)| undefined[*end]) {
            let weights: [f64; COUPLED] = std::array::from_fn(|k| lagrange(&tableau.c[2..], k, place));
            let beside = beside(grid, end);
            let mut rows = vec![(&mut self.nodes.f, &inner.f)];
            if derivatives != Derivatives::None {
                rows.extend([(&mut self.nodes.dy, &inner.dy), (&mut self.nodes.dc, &inner.dc)]);
            }
            for (at_nodes, inside) in rows {
                for (row, inside) in at_nodes.chunks_exact_mut(nodes).zip(inside.chunks_exact(COUPLED * len)) {
                    let value = (0..COUPLED).map(|k| weights[k] * inside[k * len + beside]).sum();
                    // Padding repeats the last node.
                    for p in (0..nodes).filter(|p| grid.index(*p) == end * grid.intervals()) {
                        row[p] = value;
                    }
                }
            }
        }
    }
}
