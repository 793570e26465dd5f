//! Ends of a region at which the right-hand side is not defined.
//!
//! An equation may be singular at an end of its region: `2 u'/x` where u' vanishes is 0/0 there, and a slope may be
//! infinite. Where inner stages are coupled such an end is open: the interval beside it is collocated at its other
//! stages alone, by a polynomial of one degree less. What that has for slope at the end stands in for the right-hand
//! side there, so that the equations of the method are what they are elsewhere; only in their derivatives does the
//! slope at the end follow the other stages, not the node. (At Gauss points slopes at the nodes have no weight, and
//! nothing is different but what is said of them.) Intervals of length zero, with which stretches are filled up, lie on
//! the right end; of what is undefined there nothing is wanted.
//!
//! (An extension of degree 7 beside such an end, with the slope there free, that misses the equations least, was tried:
//! it is better where solutions are smooth, worse where they are not, and meshes are no coarser for it, all together.)

use super::System;
use super::evaluate::{Derivatives, finite};
use super::grid::Grid;
use super::stages::{MOST_STAGES, Stages};
use crate::linear::scalar::{Lane, Scalar, W};
use crate::problem::{Points, Problem};
use crate::tableau::{COUPLED, Tableau};

/// An interval with an open end, or with two.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OpenInterval {
    /// Its working position.
    pub position: usize,
    /// Weights of the slopes at all stages in those at the left and at the right node: see
    /// [`slopes_at_nodes`](Tableau::slopes_at_nodes).
    pub nodes: [[f64; MOST_STAGES]; 2],
    /// Whether its ends are open.
    open: [bool; 2],
}

impl<P: Problem + ?Sized> System<'_, P> {
    /// If the method forgives it: zeros in place of all values, each rows of `at.stride`, at an end of the region where
    /// one is not finite; whether it is so at the left and at the right end.
    pub(super) fn forgive_ends<const N: usize>(
        &self,
        region: usize,
        at: &Points<'_>,
        mut values: [&mut [f64]; N],
    ) -> [bool; 2] {
        let (a, b) = self.layout.regions[region].interval;
        let mut undefined = [false; 2];
        if !self.tableau.forgives_ends() || values.iter().all(|values| finite(values)) {
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

impl Stages {
    /// The intervals with an open end, none, one or two.
    pub(super) fn open_intervals(&self, grid: &Grid, tableau: &Tableau) -> Vec<OpenInterval> {
        let ([left, right], last) = (self.nodes.undefined, grid.intervals() - 1);
        let ends = if last == 0 {
            [(0, [left, right]), (0, [false; 2])]
        } else {
            [(0, [left, false]), (last, [false, right])]
        };
        let open = ends.into_iter().filter(|(_, open)| *open != [false; 2]);
        let interval =
            |(j, open)| OpenInterval { position: grid.position(j), nodes: tableau.slopes_at_nodes(open), open };
        open.map(interval).collect()
    }

    /// Values at open ends from those at the other stages of the intervals beside them.
    pub(super) fn extrapolate(&mut self, grid: &Grid, tableau: &Tableau, derivatives: Derivatives) {
        let (len, stride) = (grid.interval_stride(), grid.node_stride());
        let intervals = self.open_intervals(grid, tableau);
        let (nodes, inner) = (&mut self.nodes, &mut self.inner[0]);
        let mut rows = vec![(&mut nodes.f, &mut inner.f)];
        if derivatives != Derivatives::None {
            rows.extend([(&mut nodes.dy, &mut inner.dy), (&mut nodes.dc, &mut inner.dc)]);
        }
        for (nodes, inner) in rows {
            for (nodes, inner) in nodes.chunks_exact_mut(stride).zip(inner.chunks_exact_mut(COUPLED * len)) {
                for interval in &intervals {
                    interval.extrapolate(grid, nodes, inner);
                }
            }
        }
    }
}

impl OpenInterval {
    /// One row of values at the nodes, from those at the inner stages.
    fn extrapolate(&self, grid: &Grid, nodes: &mut [f64], inner: &mut [f64]) {
        let (len, p) = (inner.len() / COUPLED, self.position);
        let mut values = [0.0; MOST_STAGES];
        (values[0], values[1]) = (nodes[p], nodes[p + W]);
        (0..COUPLED).for_each(|k| values[k + 2] = inner[k * len + p]);
        // What is the same at all of them is so here, to the last bit.
        let middle = values[MOST_STAGES - 1];
        let value = |weights: [f64; MOST_STAGES]| {
            middle + weights.iter().zip(values).map(|(weight, value)| weight * (value - middle)).sum::<f64>()
        };
        for (end, _) in self.open.iter().enumerate().filter(|(_, open)| **open) {
            let (value, node) = (value(self.nodes[end]), end * grid.intervals());
            for (q, out) in nodes.iter_mut().enumerate().filter(|(q, _)| grid.index(*q) == node) {
                *out = value;
                // Padding repeats the last node.
                if end == 1 && q < len {
                    (0..COUPLED).for_each(|k| inner[k * len + q] = value);
                }
            }
        }
    }

    /// Slopes at all stages, row by row, `len` values each: those at open ends follow the others.
    pub(super) fn follow(&self, rows: usize, slopes: &mut [f64]) {
        let at = |stage: usize, row: usize, len: usize| (stage * rows + row) * len + self.position;
        let len = slopes.len() / (MOST_STAGES * rows);
        for row in 0..rows {
            let at_node = self.nodes.map(|weights| {
                weights.iter().enumerate().map(|(stage, weight)| weight * slopes[at(stage, row, len)]).sum::<f64>()
            });
            at_node.iter().enumerate().for_each(|(side, value)| slopes[at(side, row, len)] = *value);
        }
    }

    /// The transpose of [`follow`](Self::follow): weights on slopes at open ends become weights on the others.
    pub(super) fn lead(&self, rows: usize, weights: &mut [f64]) {
        let at = |stage: usize, row: usize, len: usize| (stage * rows + row) * len + self.position;
        let len = weights.len() / (MOST_STAGES * rows);
        for row in 0..rows {
            let at_node = [0, 1].map(|side| std::mem::take(&mut weights[at(side, row, len)]));
            for stage in 0..MOST_STAGES {
                let of_nodes = self.nodes.iter().zip(at_node);
                weights[at(stage, row, len)] += of_nodes.map(|(nodes, weight)| nodes[stage] * weight).sum::<f64>();
            }
        }
    }
}

/// Interval `t` of every stretch, where one of these has an open end.
#[derive(Debug, Clone)]
pub(crate) struct OpenLanes {
    pub t: usize,
    /// As [`OpenInterval::nodes`]; of the others those of their own nodes.
    pub nodes: [[Lane; MOST_STAGES]; 2],
}

impl OpenLanes {
    /// All of them.
    pub(super) fn all(stages: &Stages, grid: &Grid, tableau: &Tableau) -> Vec<Self> {
        let mut all: Vec<Self> = Vec::new();
        for interval in stages.open_intervals(grid, tableau) {
            let (t, lane) = (interval.position / W, interval.position % W);
            let known = all.iter().position(|lanes| lanes.t == t);
            let index = known.unwrap_or_else(|| {
                let own = tableau.slopes_at_nodes([false; 2]);
                all.push(Self { t, nodes: own.map(|weights| weights.map(|weight| Lane([weight; W]))) });
                all.len() - 1
            });
            for (lanes, weights) in all[index].nodes.iter_mut().zip(interval.nodes) {
                lanes.iter_mut().zip(weights).for_each(|(lanes, weight)| lanes.0[lane] = weight);
            }
        }
        all
    }

    /// As [`OpenInterval::follow`], `size` values a stage, of this interval alone.
    #[inline(always)]
    pub(super) fn follow(&self, size: usize, slopes: &mut [Lane]) {
        for at in 0..size {
            let at_nodes = self.nodes.map(|weights| {
                let stages = weights.into_iter().enumerate();
                stages.fold(Lane::ZERO, |sum, (stage, weight)| sum + weight * slopes[stage * size + at])
            });
            at_nodes.into_iter().enumerate().for_each(|(side, value)| slopes[side * size + at] = value);
        }
    }
}
