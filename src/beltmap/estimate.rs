//! How wrong a map is in each interval of each axis, as its own nodes tell: the cubic between two nodes against the
//! quintic that meets a third beyond them.

use super::hermite::quintic_less_cubic;
use super::map::BeltMap;
use super::quantity::Node;
use std::collections::BTreeMap;

/// Estimated errors, scaled as the report's.
#[derive(Debug)]
pub(super) struct Estimates {
    /// By axis, then by node: of the interval that begins there, the largest of all quantities; zero where unknown.
    at: Vec<Vec<f64>>,
    /// The largest by axis and interval.
    worst: BTreeMap<(usize, usize), f64>,
}

impl Estimates {
    pub fn new(map: &BeltMap) -> Self {
        let (shape, axes) = (&map.shape, map.axes.len());
        let largest = map.largest();
        let mut used = vec![false; shape.points()];
        map.cells().for_each(|cell| map.corners(cell).for_each(|node| used[node] = true));
        let mut estimates = Self { at: vec![vec![0.0; shape.points()]; axes], worst: BTreeMap::new() };
        for axis in 0..axes {
            let (places, stride) = (map.axes[axis].breakpoints(), shape.stride(axis));
            for node in 0..shape.points() {
                let place = shape.place(node, axis);
                if place + 1 >= places.len() || !used[node] || !used[node + stride] {
                    continue;
                }
                let point = |there: usize, quantity: usize| -> Option<[f64; 3]> {
                    let there_node = node + there * stride - place * stride;
                    let sample = map.nodes.get(there_node).and_then(Node::sample)?;
                    Some([places[there], sample.values[quantity], sample.slopes[quantity * axes + axis]])
                };
                let mut error = 0.0_f64;
                for (at, quantity) in map.quantities.iter().enumerate() {
                    let (Some(a), Some(b)) = (point(place, at), point(place + 1, at)) else { continue };
                    let beyond = [place.checked_sub(1), Some(place + 2).filter(|there| *there < places.len())];
                    let found = beyond.into_iter().flatten().filter_map(|there| point(there, at));
                    // What a node beyond a kink, or beside the slip limit, says counts only if both say it.
                    let found = found.map(|c| quintic_less_cubic(a, b, c).abs()).reduce(f64::min).unwrap_or(0.0);
                    error = error.max(found / quantity.scale(0.5 * (a[1] + b[1]), largest[at]));
                }
                estimates.at[axis][node] = error;
                let worst = estimates.worst.entry((axis, place)).or_default();
                *worst = worst.max(error);
            }
        }
        estimates
    }

    /// The largest.
    pub fn largest(&self) -> f64 {
        self.worst.values().copied().fold(0.0, f64::max)
    }

    /// Intervals whose error is above what is allowed, and at least a share of the largest: worst first.
    pub fn worst(&self, allowed: f64, share: f64) -> Vec<(usize, usize, f64)> {
        worst(
            self.worst.iter().filter(|(_, error)| **error > allowed).map(|(at, error)| (*at, *error)).collect(),
            share,
        )
    }

    /// The axis along which a cell is most wrong; where nothing says which, its longest in intervals of the first grid.
    pub fn axis_of(&self, map: &BeltMap, cell: usize) -> usize {
        let error = |axis: usize| {
            let bit = 1_usize << axis;
            let edges = map.corners(cell).enumerate().filter(|(corner, _)| corner & bit == 0);
            edges.map(|(_, node)| self.at[axis][node]).fold(0.0, f64::max)
        };
        let length = |axis: usize| {
            let (from, to) = map.axes[axis].range();
            let place = map.shape.place(cell, axis);
            (map.axes[axis].breakpoints()[place + 1] - map.axes[axis].breakpoints()[place]) / (to - from)
        };
        let key = |axis: &usize| (error(*axis), length(*axis));
        let better = |a: &usize, b: &usize| {
            let ((a, la), (b, lb)) = (key(a), key(b));
            a.total_cmp(&b).then(la.total_cmp(&lb))
        };
        (0..map.axes.len()).rev().max_by(better).unwrap_or(0)
    }
}

/// Of intervals with their errors, those at least a share of the largest: worst first.
pub(super) fn worst(of: BTreeMap<(usize, usize), f64>, share: f64) -> Vec<(usize, usize, f64)> {
    let largest = of.values().copied().fold(0.0, f64::max);
    let mut kept: Vec<(usize, usize, f64)> = of
        .into_iter()
        .filter(|(_, error)| *error >= share * largest)
        .map(|((axis, at), error)| (axis, at, error))
        .collect();
    kept.sort_by(|a, b| b.2.total_cmp(&a.2));
    kept
}
