//! A problem on given meshes as a system of algebraic equations, and its linearisation.

pub(crate) mod assemble;
pub(crate) mod boundary;
mod corrected;
pub(crate) mod coupled;
pub(crate) mod defect;
pub(crate) mod evaluate;
pub(crate) mod factor;
pub(crate) mod grid;
pub(crate) mod inner;
pub(crate) mod interpolant;
pub(crate) mod linear_problem;
mod moments;
mod open_ends;
pub(crate) mod parameter;
pub(crate) mod plan;
pub(crate) mod roles;
pub(crate) mod stages;
pub(crate) mod transpose;

use crate::by_region::ByRegion;
use crate::linear::memory::{Lanes, Numbers};
use crate::linear::scalar::{Lane, Scalar, W};
use crate::linear::simd::{largest, largest_number};
use crate::magnitude::Magnitudes;
use crate::problem::{Layout, Problem};
use crate::tableau::Tableau;
use grid::Grid;
use plan::Plan;
use std::sync::Arc;

/// The collocation equations of a problem on one set of meshes.
pub(crate) struct System<'p, P: Problem + ?Sized> {
    pub problem: &'p P,
    pub layout: &'p Layout,
    pub plan: Arc<Plan>,
    /// Whether values of the right-hand side may be taken from its derivatives: see [`Problem::is_linear`].
    pub linear: bool,
    pub tableau: &'static Tableau,
    pub magnitudes: Magnitudes,
    pub grids: Vec<Grid>,
}

/// Values of all unknowns, and of the given constants: states component by component in working order.
#[derive(Debug, Clone)]
pub(crate) struct Iterate {
    /// Per region, `n * node_stride`.
    pub y: ByRegion<Numbers>,
    /// Where the inner stages' states are unknowns: per region, stage by stage, component by component,
    /// `m * interval_stride`. Else empty; also if nothing is known of them yet, see [`System::complete`].
    pub inner: ByRegion<Numbers>,
    /// All constants of the layout.
    pub constants: Vec<f64>,
}

/// Typical magnitudes, by which all unknowns and equations are made dimensionless.
#[derive(Debug, Clone)]
pub(crate) struct Scales {
    /// Per region, per state.
    pub states: ByRegion<Numbers>,
    /// All constants of the layout.
    pub constants: Vec<f64>,
}

/// A change of all unknowns in units of their scales: states node by node in working order.
#[derive(Debug, Clone)]
pub(crate) struct Correction {
    /// Per region, `(steps + 1) * n` vectors of lanes.
    pub u: ByRegion<Lanes>,
    /// Where the inner stages' states are unknowns: per region, interval by interval, `m` vectors of lanes. Else empty.
    pub inner: ByRegion<Lanes>,
    /// One for each unknown constant.
    pub c: Vec<f64>,
}

impl<P: Problem + ?Sized> System<'_, P> {
    /// Typical magnitudes at an iterate.
    pub(crate) fn scales(&self, x: &Iterate) -> Scales {
        let states = self.magnitudes.states.iter().zip(&x.y).map(|(magnitudes, y)| {
            let stride = y.len() / magnitudes.len();
            let found = y.chunks_exact(stride).map(largest_number);
            Numbers::collected(
                magnitudes.len(),
                magnitudes.iter().zip(found).map(|(magnitude, found)| magnitude.of(found)),
            )
        });
        let constants = self.magnitudes.constants.iter().zip(&x.constants);
        Scales { states: states.collect(), constants: constants.map(|(magnitude, c)| magnitude.of(c.abs())).collect() }
    }

    /// `x + factor * dx`.
    pub(crate) fn stepped(&self, x: &Iterate, scales: &Scales, factor: f64, dx: &Correction) -> Iterate {
        let mut next = x.clone();
        for (region, u) in dx.u.iter().enumerate() {
            let n = self.plan.regions[region].n;
            let rows = next.y[region].len() / n / W;
            let (chunks, _) = next.y[region].as_chunks_mut::<W>();
            for (i, scale) in scales.states[region].iter().enumerate() {
                let factor = factor * scale;
                for (y, u) in chunks[i * rows..(i + 1) * rows].iter_mut().zip(u.chunks_exact(n)) {
                    for (y, u) in y.iter_mut().zip(u[i].0) {
                        *y += factor * u;
                    }
                }
            }
        }
        self.step_inner(&mut next, &scales.states, factor, &dx.inner);
        for (&index, c) in self.plan.unknowns.iter().zip(&dx.c) {
            next.constants[index] += factor * scales.constants[index] * c;
        }
        next
    }

    /// Expresses a change in other scales.
    pub(crate) fn rescale(&self, dx: &mut Correction, from: &Scales, to: &Scales) {
        let inner = dx.inner.iter_mut().map(|lanes| &mut lanes[..]);
        // Of each region its nodes, and then, where there are any, its inner stages.
        let regions = dx.u.iter_mut().map(|lanes| &mut lanes[..]).zip(0..).chain(inner.zip(0..));
        for (values, region) in regions {
            let (from, to): (&[f64], &[f64]) = (&from.states[region], &to.states[region]);
            for values in values.chunks_exact_mut(from.len()) {
                for ((value, from), to) in values.iter_mut().zip(from).zip(to) {
                    *value = (*value).times(from / to);
                }
            }
        }
        for (&index, c) in self.plan.unknowns.iter().zip(&mut dx.c) {
            *c *= from.constants[index] / to.constants[index];
        }
    }

    /// Root of the mean square over nodes, summed over states and constants, per unknown of a node.
    pub(crate) fn norm(&self, dx: &Correction) -> f64 {
        self.norm_of(dx, |u, _| u, dx)
    }

    /// Norm of `a - factor * b`.
    pub(crate) fn distance(&self, a: &Correction, factor: f64, b: &Correction) -> f64 {
        self.norm_of(a, |a, b| a - factor * b, b)
    }

    fn norm_of(&self, a: &Correction, f: impl Fn(f64, f64) -> f64, b: &Correction) -> f64 {
        let mut sum: f64 = a.c.iter().zip(&b.c).map(|(&a, &b)| f(a, b).powi(2)).sum();
        let mut unknowns = a.c.len();
        for (region, grid) in self.grids.iter().enumerate() {
            let n = self.plan.regions[region].n;
            unknowns += n;
            let nodes = a.u[region].chunks_exact(n).zip(b.u[region].chunks_exact(n));
            let mut total = [0.0; W];
            for ((a, b), weight) in nodes.zip(grid.weight.as_chunks::<W>().0) {
                for (a, b) in a.iter().zip(b) {
                    for l in 0..W {
                        total[l] += weight[l] * f(a.0[l], b.0[l]).powi(2);
                    }
                }
            }
            sum += total.iter().sum::<f64>();
            if let (Some(a), Some(b)) = (a.inner.get(region), b.inner.get(region)) {
                unknowns += n;
                sum += self.inner_sum(region, a, b, &f);
            }
        }
        (sum / unknowns.max(1) as f64).sqrt()
    }

    /// Mean over the inner stages of the sums over intervals that [`norm_of`](Self::norm_of) is made of.
    fn inner_sum(&self, region: usize, a: &[Lane], b: &[Lane], f: impl Fn(f64, f64) -> f64) -> f64 {
        let stages = self.tableau.unknown_stages();
        let m = stages * self.plan.regions[region].n;
        let mut total = [0.0; W];
        let intervals = a.chunks_exact(m).zip(b.chunks_exact(m));
        for ((a, b), weight) in intervals.zip(self.grids[region].weight.as_chunks::<W>().0) {
            for (a, b) in a.iter().zip(b) {
                for l in 0..W {
                    total[l] += weight[l] * f(a.0[l], b.0[l]).powi(2);
                }
            }
        }
        total.iter().sum::<f64>() / stages as f64
    }

    /// Largest component; NaN if any is not finite.
    pub(crate) fn largest(&self, dx: &Correction) -> f64 {
        largest(dx.u.iter().chain(&dx.inner).map(|lanes| &lanes[..]), &dx.c)
    }
}

#[cfg(test)]
mod tests;
