//! Derivative of the collocation equations along a direction in the constants.

use super::evaluate::{Batch, Stages, Work};
use super::factor::Rhs;
use super::plan::RegionPlan;
use super::{Scales, System};
use crate::linear::scalar::{Lane, Scalar, W};
use crate::problem::{Problem, Region};

impl<P: Problem + ?Sized> System<'_, P> {
    /// `-∂F/∂c · direction` in dimensionless equations, `direction` over all constants: the right-hand side whose
    /// solution is the tangent of the solution along that direction. `work` must hold derivatives with respect to
    /// all constants.
    pub(crate) fn parameter_rhs(&self, work: &Work, scales: &Scales, direction: &[f64]) -> Rhs {
        let mut rhs = Rhs { regions: Vec::new(), integrals: Vec::new(), boundary: vec![0.0; work.g.len()] };
        for (index, region) in self.layout.regions.iter().enumerate() {
            let (lanes, integrals) = self.region_rhs(index, region, &work.regions[index], scales, direction);
            rhs.regions.push(lanes);
            rhs.integrals.push(integrals);
        }
        let first = self.layout.ends() + self.layout.integrals();
        for (&(equation, input), &value) in self.layout.boundary_pattern.iter().zip(&work.dz) {
            if let Some(&rate) = input.checked_sub(first).and_then(|constant| direction.get(constant)) {
                rhs.boundary[equation] -= value * rate;
            }
        }
        rhs
    }

    fn region_rhs(
        &self,
        index: usize,
        region: &Region,
        stages: &Stages,
        scales: &Scales,
        direction: &[f64],
    ) -> (Vec<Lane>, Vec<f64>) {
        let (plan, grid) = (&self.plan.regions[index], &self.grids[index]);
        let (n, len) = (plan.n, grid.interval_stride());
        let sums = self.weighted_rates(region, plan, stages, &grid.h, direction);
        let mut lanes = vec![Lane::ZERO; grid.steps * n];
        for (i, scale) in scales.states[index].iter().enumerate() {
            let (rates, _) = sums[i * len..(i + 1) * len].as_chunks::<W>();
            for (out, rate) in lanes.chunks_exact_mut(n).zip(rates) {
                out[i] = Lane(*rate).times(1.0 / scale);
            }
        }
        let integral = |&k: &usize| sums[(n + k) * len..(n + k + 1) * len].iter().sum();
        (lanes, plan.active.iter().map(integral).collect())
    }

    /// `h Σ b dK` of all rows, integrands included: `rows * interval_stride`.
    fn weighted_rates(
        &self,
        region: &Region,
        plan: &RegionPlan,
        stages: &Stages,
        h: &[f64],
        direction: &[f64],
    ) -> Vec<f64> {
        let (n, rows, len) = (plan.n, plan.rows, h.len());
        let mut rates = vec![0.0; self.tableau.stages() * rows * len];
        let mut sums = vec![0.0; rows * len];
        let mut shift = vec![0.0; n * len];
        for stage in 0..self.tableau.stages() {
            let (known, rest) = rates.split_at_mut(stage * rows * len);
            let out = &mut rest[..rows * len];
            let (batch, stride, offset) = stages.batch(stage, len);
            explicit_rates(region, batch, stride, offset, direction, out);
            shift.fill(0.0);
            for (earlier, &weight) in self.tableau.x[stage].iter().enumerate().filter(|(_, weight)| **weight != 0.0) {
                let earlier = &known[earlier * rows * len..];
                for i in 0..n {
                    for p in 0..len {
                        shift[i * len + p] += weight * h[p] * earlier[i * len + p];
                    }
                }
            }
            if self.tableau.x[stage].iter().any(|&weight| weight != 0.0) {
                chain(region, batch, stride, offset, &shift, out);
            }
            let b = self.tableau.b[stage];
            for (sums, out) in sums.chunks_exact_mut(len).zip(out.chunks_exact(len)) {
                for p in 0..len {
                    sums[p] += b * h[p] * out[p];
                }
            }
        }
        sums
    }
}

impl Stages {
    /// The batch of a stage, its stride, and where its first interval stands.
    fn batch(&self, stage: usize, len: usize) -> (&Batch, usize, usize) {
        match stage {
            0 => (&self.nodes, len + W, 0),
            1 => (&self.nodes, len + W, W),
            _ => (&self.inner[stage - 2], len, 0),
        }
    }
}

fn explicit_rates(region: &Region, batch: &Batch, stride: usize, offset: usize, direction: &[f64], out: &mut [f64]) {
    let len = out.len() / region.rows();
    for (entry, &(row, constant)) in region.constant_pattern.iter().enumerate() {
        let rate = direction[constant];
        if rate != 0.0 {
            let values = &batch.dc[entry * stride + offset..][..len];
            out[row * len..(row + 1) * len].iter_mut().zip(values).for_each(|(out, value)| *out += rate * value);
        }
    }
}

/// `out += J shift`.
fn chain(region: &Region, batch: &Batch, stride: usize, offset: usize, shift: &[f64], out: &mut [f64]) {
    let len = out.len() / region.rows();
    for (entry, &(row, state)) in region.state_pattern.iter().enumerate() {
        let values = &batch.dy[entry * stride + offset..][..len];
        let shift = &shift[state * len..(state + 1) * len];
        let out = &mut out[row * len..(row + 1) * len];
        for p in 0..len {
            out[p] += values[p] * shift[p];
        }
    }
}
