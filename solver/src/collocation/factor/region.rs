//! One region, eliminated and solved for: several stretches of it side by side in vector registers.

use super::RegionFactor;
use crate::collocation::assemble::{Assembly, Inner};
use crate::collocation::coupled::Coupling;
use crate::linear::chain::{Block, Intervals, Reduced};
use crate::linear::memory::{Lanes, Numbers};
use crate::linear::reflect::Rows;
use crate::linear::scalar::{Lane, W};
use crate::linear::simd::{RowsJob, vectorised_rows};

pub(super) struct FactorRegion<'a, 'b> {
    pub(super) assembly: Assembly<'a>,
    pub(super) n: usize,
    pub(super) factor: &'b mut RegionFactor,
}

impl FactorRegion<'_, '_> {
    /// Not generic, so that it is compiled here once and not with every problem; the others likewise.
    pub(super) fn vectorised(self) {
        vectorised_rows(self.n, self);
    }
}

impl RowsJob for FactorRegion<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run<R: Rows>(self, rows: R) {
        factor_region(rows, self.assembly, self.factor)
    }
}

#[inline(always)]
fn factor_region<R: Rows>(rows: R, assembly: Assembly<'_>, factor: &mut RegionFactor) {
    let RegionFactor { lanes, top, row_scale, coupling, coupled } = factor;
    lanes.factor(rows, Stretches { assembly, row_scale, coupling, coupled });
    top.factor(rows, Reduced(lanes.end()));
}

/// The intervals of all stretches, side by side.
struct Stretches<'a, 'b> {
    assembly: Assembly<'a>,
    row_scale: &'b mut [Lane],
    coupling: &'b Coupling,
    coupled: &'b mut [Lane],
}

impl Intervals<Lane> for Stretches<'_, '_> {
    #[inline(always)]
    fn fill<R: Rows>(&mut self, rows: R, t: usize, block: &mut Block<&mut [Lane]>) {
        let n = rows.n();
        let len = self.coupling.len();
        let inner = Inner { coupling: self.coupling, kept: &mut self.coupled[t * len..(t + 1) * len] };
        self.assembly.fill(rows, t, block, &mut self.row_scale[t * n..(t + 1) * n], inner);
    }
}

pub(super) struct Forward<'a> {
    pub(super) factor: &'a RegionFactor,
    pub(super) rhs: &'a mut [Lane],
    pub(super) functionals: &'a mut [f64],
}

impl Forward<'_> {
    pub(super) fn vectorised(self) -> Numbers {
        vectorised_rows(self.factor.lanes.sizes().n, self)
    }
}

impl RowsJob for Forward<'_> {
    /// What the region contributes to the dense system: `n` values; and the stretches' right-hand sides.
    type Output = Numbers;

    #[inline(always)]
    fn run<R: Rows>(self, rows: R) -> Numbers {
        forward_region(rows, self)
    }
}

#[inline(always)]
fn forward_region<R: Rows>(rows: R, job: Forward<'_>) -> Numbers {
    let n = rows.n();
    for (rhs, scale) in job.rhs.iter_mut().zip(&job.factor.row_scale) {
        *rhs = *rhs * *scale;
    }
    let mut lane_sums = Lanes::zeros(job.functionals.len());
    job.factor.lanes.forward(rows, job.rhs, &mut lane_sums);
    for (sum, lane) in job.functionals.iter_mut().zip(&lane_sums) {
        *sum += lane.0.iter().sum::<f64>();
    }
    let last = &job.rhs[job.rhs.len() - n..];
    let mut top = Numbers::unset(W * n);
    for (i, lane) in last.iter().enumerate() {
        for l in 0..W {
            top[l * n + i] = lane.0[l];
        }
    }
    job.factor.top.forward(rows, &mut top, job.functionals);
    top
}

pub(super) struct Backward<'a> {
    pub(super) factor: &'a RegionFactor,
    pub(super) rhs: &'a [Lane],
    pub(super) top: &'a [f64],
    pub(super) constants: &'a [f64],
    pub(super) first: &'a [f64],
    pub(super) last: &'a [f64],
    pub(super) u: &'a mut [Lane],
}

impl Backward<'_> {
    pub(super) fn vectorised(self) {
        vectorised_rows(self.factor.lanes.sizes().n, self);
    }
}

impl RowsJob for Backward<'_> {
    type Output = ();

    #[inline(always)]
    fn run<R: Rows>(self, rows: R) {
        backward_region(rows, self)
    }
}

#[inline(always)]
fn backward_region<R: Rows>(rows: R, job: Backward<'_>) {
    let n = rows.n();
    let mut interfaces = Numbers::unset((W + 1) * n);
    interfaces[..n].copy_from_slice(job.first);
    interfaces[W * n..].copy_from_slice(job.last);
    job.factor.top.backward(rows, job.top, job.constants, &mut interfaces);
    let end = job.u.len() - n;
    for i in 0..n {
        for l in 0..W {
            job.u[i].0[l] = interfaces[l * n + i];
            job.u[end + i].0[l] = interfaces[(l + 1) * n + i];
        }
    }
    let constants = Lanes::collected(job.constants.len(), job.constants.iter().map(|&c| Lane([c; W])));
    job.factor.lanes.backward(rows, job.rhs, &constants, job.u);
}
