//! Solves with the transpose of the held factorisation: from weights on the unknowns to weights on the equations.

use super::factor::{Factorisation, RegionFactor, Rhs};
use super::{Correction, System};
use crate::by_region::ByRegion;
use crate::linear::memory::{Lanes, Numbers};
use crate::linear::reflect::Rows;
use crate::linear::scalar::{Lane, W};
use crate::linear::simd::{RowsJob, vectorised_rows};
use crate::problem::Problem;

/// A linear functional of a solution's change, in dimensionless unknowns.
#[derive(Debug, Clone)]
pub(crate) struct Weights {
    /// On nodes and unknown constants. A node's weight stands once in working order; that of the last node at the very
    /// end.
    pub unknowns: Correction,
    /// On the changes of active integrals, per region.
    pub integrals: ByRegion<Numbers>,
}

struct Backward<'a> {
    factor: &'a RegionFactor,
    u: &'a mut [Lane],
    constants: &'a mut [f64],
    rhs: &'a mut [Lane],
    /// `W * n`.
    top: &'a mut [f64],
}

impl Backward<'_> {
    fn vectorised(self) -> Vec<f64> {
        vectorised_rows(self.factor.lanes.sizes().n, self)
    }
}

impl RowsJob for Backward<'_> {
    /// Weights on the first and last node.
    type Output = Vec<f64>;

    #[inline(always)]
    fn run<R: Rows>(self, rows: R) -> Vec<f64> {
        backward_region(rows, self)
    }
}

#[inline(always)]
fn backward_region<R: Rows>(rows: R, job: Backward<'_>) -> Vec<f64> {
    let n = rows.n();
    let mut constants = Lanes::zeros(job.constants.len());
    job.factor.lanes.backward_transposed(rows, job.rhs, &mut constants, job.u);
    for (sum, lane) in job.constants.iter_mut().zip(&constants) {
        *sum += lane.0.iter().sum::<f64>();
    }
    let mut interfaces = vec![0.0; (W + 1) * n];
    let end = job.u.len() - n;
    for i in 0..n {
        for l in 0..W {
            interfaces[l * n + i] += job.u[i].0[l];
            interfaces[(l + 1) * n + i] += job.u[end + i].0[l];
        }
    }
    job.factor.top.backward_transposed(rows, job.top, job.constants, &mut interfaces);
    interfaces.drain(n..W * n);
    interfaces
}

struct Forward<'a> {
    factor: &'a RegionFactor,
    rhs: &'a mut [Lane],
    top: &'a mut [f64],
    functionals: &'a [f64],
}

impl Forward<'_> {
    fn vectorised(self) {
        vectorised_rows(self.factor.lanes.sizes().n, self);
    }
}

impl RowsJob for Forward<'_> {
    type Output = ();

    #[inline(always)]
    fn run<R: Rows>(self, rows: R) {
        forward_region(rows, self)
    }
}

#[inline(always)]
fn forward_region<R: Rows>(rows: R, job: Forward<'_>) {
    let n = rows.n();
    job.factor.top.forward_transposed(rows, job.top, job.functionals);
    let last = job.rhs.len() - n;
    for i in 0..n {
        job.rhs[last + i] = Lane(std::array::from_fn(|l| job.top[l * n + i]));
    }
    let functionals = Lanes::collected(job.functionals.len(), job.functionals.iter().map(|&weight| Lane([weight; W])));
    job.factor.lanes.forward_transposed(rows, job.rhs, &functionals);
    for (rhs, scale) in job.rhs.iter_mut().zip(&job.factor.row_scale) {
        *rhs = *rhs * *scale;
    }
}

impl Factorisation {
    /// The weights `m` with `m · rhs = w · solve(rhs)` for every right-hand side.
    pub(crate) fn solve_transposed<P: Problem + ?Sized>(&self, system: &System<'_, P>, mut w: Weights) -> Rhs {
        let mut dense = Vec::new();
        let mut c = w.unknowns.c.clone();
        let (mut lanes, mut tops) = (ByRegion::default(), Vec::new());
        for (region, plan) in system.plan.regions.iter().enumerate() {
            let factor = &self.regions[region];
            let mut rhs = Lanes::zeros(system.grids[region].steps * plan.n);
            let mut top = vec![0.0; W * plan.n];
            let mut constants = vec![0.0; plan.columns.len()];
            let u = &mut w.unknowns.u[region];
            let backward = Backward { factor, u, constants: &mut constants, rhs: &mut rhs, top: &mut top };
            let mut ends = backward.vectorised();
            factor.add_functionals(plan.n, &w.integrals[region], &mut ends, &mut constants);
            for (&column, weight) in plan.columns.iter().zip(&constants) {
                c[column] += weight;
            }
            dense.extend(ends);
            lanes.push(rhs);
            tops.push(top);
        }
        dense.extend(c);
        self.border.solve_transposed(&mut dense);
        let boundary = dense.split_off(system.plan.states());
        for &(equation, region, k, value) in &self.integral_entries {
            w.integrals[region][k] -= value * boundary[equation];
        }
        let mut reduced = dense.as_slice();
        for (region, plan) in system.plan.regions.iter().enumerate() {
            let (mine, rest) = reduced.split_at(plan.n);
            reduced = rest;
            let top = &mut tops[region];
            let last = top.len() - plan.n;
            top[last..].copy_from_slice(mine);
            let functionals = &w.integrals[region];
            Forward { factor: &self.regions[region], rhs: &mut lanes[region], top, functionals }.vectorised();
        }
        Rhs { regions: lanes, inner: ByRegion::default(), integrals: w.integrals, boundary: boundary.into() }
    }
}

impl RegionFactor {
    /// Weights on integrals as weights on ends and constants: `ends` holds first and last node.
    fn add_functionals(&self, n: usize, weights: &[f64], ends: &mut [f64], constants: &mut [f64]) {
        let end = self.top.end();
        let p = constants.len();
        for (k, weight) in weights.iter().enumerate() {
            for i in 0..n {
                ends[i] += weight * end.fa[k * n + i];
                ends[n + i] += weight * end.fb[k * n + i];
            }
            for (j, constant) in constants.iter_mut().enumerate() {
                *constant += weight * end.fc[k * p + j];
            }
        }
    }
}
