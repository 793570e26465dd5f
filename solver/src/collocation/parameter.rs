//! Derivatives of the collocation equations and integrals along a direction, and the transpose.

use super::coupled::{scaled, unscaled};
use super::evaluate::Work;
use super::factor::{RegionFactor, Rhs};
use super::stages::{Stage, Stages};
use super::{Scales, System};
use crate::linear::memory::{Lanes, Numbers};
use crate::linear::scalar::{Lane, Scalar, W};
use crate::linear::simd::elementwise;
use crate::problem::{Problem, Region};

impl<P: Problem + ?Sized> System<'_, P> {
    /// `-∂F/∂c · direction` in dimensionless equations, `direction` over all constants: the right-hand side whose
    /// solution is the tangent of the solution along that direction. `work` must hold derivatives with respect to
    /// all constants.
    pub(crate) fn parameter_rhs(&self, work: &Work, scales: &Scales, direction: &[f64]) -> Rhs {
        let mut rhs = Rhs { boundary: Numbers::zeros(work.g.len()), ..Rhs::default() };
        for (index, stages) in work.regions.iter().enumerate() {
            let (lanes, integrals) = self.region_rhs(index, stages, scales, direction);
            if self.tableau.coupled {
                rhs.inner.push(self.stage_rates(index, stages, &scales.states[index], direction));
            }
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

    fn region_rhs(&self, index: usize, stages: &Stages, scales: &Scales, direction: &[f64]) -> (Lanes, Numbers) {
        let (plan, grid) = (&self.plan.regions[index], &self.grids[index]);
        let (n, len) = (plan.n, grid.interval_stride());
        let sums = self.weighted_rates(index, stages, None, &[], direction);
        let mut lanes = Lanes::zeros(grid.steps * n);
        for (i, scale) in scales.states[index].iter().enumerate() {
            let (rates, _) = sums[i * len..(i + 1) * len].as_chunks::<W>();
            for (out, rate) in lanes.chunks_exact_mut(n).zip(rates) {
                out[i] = Lane(*rate).times(1.0 / scale);
            }
        }
        let integral = |&k: &usize| sums[(n + k) * len..(n + k + 1) * len].iter().sum();
        (lanes, plan.active.iter().map(integral).collect())
    }

    /// `h Σ x ∂f/∂c · direction` of all inner stages, in dimensionless stage equations.
    fn stage_rates(&self, index: usize, stages: &Stages, d: &[f64], direction: &[f64]) -> Lanes {
        let (region, h) = (&self.layout.regions[index], &self.grids[index].h);
        let (rows, len, m) = (region.rows(), h.len(), self.tableau.unknown_stages() * d.len());
        let mut out = vec![0.0; m * len];
        let mut rates = vec![0.0; rows * len];
        for stage in 0..self.tableau.stages() {
            let at = stages.stage(stage, len);
            rates.fill(0.0);
            explicit_rates(region, at, direction, &mut rates);
            for (out, x) in out.chunks_exact_mut(d.len() * len).zip(&self.tableau.x[2..]) {
                for (out, rates) in out.chunks_exact_mut(len).zip(rates.chunks_exact(len)) {
                    elementwise(out, [h, rates], |sum, [h, rate]| sum + x[stage] * h * rate);
                }
            }
        }
        scaled(&out, d, m, 1.0)
    }

    /// `h Σ b dK` of all rows, integrands included: `rows * interval_stride`, when the constants move at the rates
    /// `direction` and the nodes at `nodes` (component by component in working order), if they move at all. `inner`:
    /// the rates of the inner stages' states, as [`Iterate::inner`](super::Iterate::inner) stands, if they are
    /// unknowns.
    pub(crate) fn weighted_rates(
        &self,
        index: usize,
        stages: &Stages,
        nodes: Option<&[f64]>,
        inner: &[f64],
        direction: &[f64],
    ) -> Vec<f64> {
        let (region, h) = (&self.layout.regions[index], &self.grids[index].h);
        let (n, rows, len) = (region.states.len(), region.rows(), h.len());
        let mut rates = vec![0.0; self.tableau.stages() * rows * len];
        let mut sums = vec![0.0; rows * len];
        let mut shift = vec![0.0; n * len];
        for stage in 0..self.tableau.stages() {
            let (known, rest) = rates.split_at_mut(stage * rows * len);
            let out = &mut rest[..rows * len];
            let at = stages.stage(stage, len);
            explicit_rates(region, at, direction, out);
            shift.fill(0.0);
            let unknown = self.tableau.coupled && stage >= 2;
            if unknown && !inner.is_empty() {
                shift.copy_from_slice(&inner[(stage - 2) * n * len..][..n * len]);
            }
            if let Some(nodes) = nodes.filter(|_| !unknown) {
                let v = self.tableau.v[stage];
                for (shift, du) in shift.chunks_exact_mut(len).zip(nodes.chunks_exact(len + W)) {
                    elementwise(shift, [du, &du[W..]], |_, [left, right]| (1.0 - v) * left + v * right);
                }
            }
            let explicit = if unknown { &[][..] } else { self.tableau.x[stage] };
            for (earlier, &weight) in explicit.iter().enumerate().filter(|(_, weight)| **weight != 0.0) {
                let earlier = &known[earlier * rows * len..];
                for (shift, earlier) in shift.chunks_exact_mut(len).zip(earlier.chunks_exact(len)) {
                    elementwise(shift, [h, earlier], |shift, [h, earlier]| shift + weight * h * earlier);
                }
            }
            if let Some(odd) = self.tableau.odd_part(stage) {
                for &(u, v) in &stages.chained {
                    let slope = |stage: usize, row: usize| &known[(stage * rows + row) * len..][..len];
                    let shift = &mut shift[u * len..][..len];
                    let inputs = [h, slope(0, u), slope(1, u), slope(0, v), slope(1, v)];
                    elementwise(shift, inputs, |shift, [h, v0, v1, k0, k1]| {
                        shift + odd * h * (h * (k1 - k0) - 6.0 * (v0 + v1))
                    });
                    if let Some(du) = nodes.map(|nodes| &nodes[u * (len + W)..]) {
                        elementwise(shift, [du, &du[W..]], |shift, [left, right]| shift + 12.0 * odd * (right - left));
                    }
                }
            }
            if (stage >= 2 && !self.tableau.coupled) || nodes.is_some() {
                chain(region, at, &shift, out);
            }
        }
        for interval in stages.open_intervals(&self.grids[index], self.tableau) {
            interval.follow(rows, &mut rates);
        }
        for (rates, b) in rates.chunks_exact(rows * len).zip(self.tableau.b) {
            for (sums, rates) in sums.chunks_exact_mut(len).zip(rates.chunks_exact(len)) {
                elementwise(sums, [h, rates], |sum, [h, rate]| sum + b * h * rate);
            }
        }
        if self.tableau.has_odd_parts() {
            for &(u, v) in &stages.chained {
                let slope = |stage: usize, row: usize| &rates[(stage * rows + row) * len..][..len];
                let sums = &mut sums[u * len..][..len];
                elementwise(sums, [h, slope(0, u), slope(1, u)], |_, [h, v0, v1]| 0.5 * h * (v0 + v1));
                for stage in 0..self.tableau.stages() {
                    let weight = self.tableau.twice_integrated(stage);
                    elementwise(sums, [h, slope(stage, v)], |sum, [h, k]| sum + weight * h * h * k);
                }
            }
        }
        sums
    }

    /// The transpose of [`weighted_rates`](Self::weighted_rates): weights on all rows (`rows * interval_stride`) become
    /// weights on the nodes (component by component in working order) and are added to those on the constants. Stages
    /// whose states are unknowns follow nodes and constants as their equations say, which `factor` has factored, in
    /// units of `d`.
    pub(crate) fn pull_back(
        &self,
        index: usize,
        stages: &Stages,
        (factor, d): (&RegionFactor, &[f64]),
        weights: &[f64],
        constants: &mut [f64],
    ) -> Vec<f64> {
        let (region, h) = (&self.layout.regions[index], &self.grids[index].h);
        let (n, rows, len) = (region.states.len(), region.rows(), h.len());
        let mut nodes = vec![0.0; n * (len + W)];
        let mut rates = vec![0.0; self.tableau.stages() * rows * len];
        for (stage, &b) in rates.chunks_exact_mut(rows * len).zip(self.tableau.b) {
            for (out, weights) in stage.chunks_exact_mut(len).zip(weights.chunks_exact(len)) {
                elementwise(out, [h, weights], |_, [h, weight]| b * h * weight);
            }
        }
        if self.tableau.has_odd_parts() {
            for &(u, v) in &stages.chained {
                let weights = &weights[u * len..][..len];
                for (stage, rates) in rates.chunks_exact_mut(rows * len).enumerate() {
                    let (once, twice) = (if stage < 2 { 0.5 } else { 0.0 }, self.tableau.twice_integrated(stage));
                    elementwise(&mut rates[u * len..][..len], [h, weights], |_, [h, weight]| once * h * weight);
                    elementwise(&mut rates[v * len..][..len], [h, weights], |rate, [h, weight]| {
                        rate + twice * h * h * weight
                    });
                }
            }
        }
        let open = stages.open_intervals(&self.grids[index], self.tableau);
        let explicit = if self.tableau.coupled {
            open.iter().for_each(|interval| interval.lead(rows, &mut rates));
            self.pull_back_inner(index, stages, (factor, d), &mut rates, &mut nodes);
            open.iter().for_each(|interval| interval.lead(rows, &mut rates));
            for (stage, rates) in rates.chunks_exact(rows * len).enumerate().skip(2) {
                weigh_constants(region, stages.stage(stage, len), rates, constants);
            }
            2
        } else {
            self.tableau.stages()
        };
        let mut shift = vec![0.0; n * len];
        for stage in (0..explicit).rev() {
            let (known, rest) = rates.split_at_mut(stage * rows * len);
            let out = &rest[..rows * len];
            weigh_constants(region, stages.stage(stage, len), out, constants);
            shift.fill(0.0);
            weigh_states(region, stages.stage(stage, len), out, &mut shift);
            let v = self.tableau.v[stage];
            for (nodes, shift) in nodes.chunks_exact_mut(len + W).zip(shift.chunks_exact(len)) {
                for p in 0..len {
                    nodes[p] += (1.0 - v) * shift[p];
                    nodes[p + W] += v * shift[p];
                }
            }
            if let Some(odd) = self.tableau.odd_part(stage) {
                for &(u, v) in &stages.chained {
                    let shift = &shift[u * len..][..len];
                    for (side, sign) in [(0, -1.0), (1, 1.0)] {
                        let mut rates = |row: usize, by: f64, power: i32| {
                            let rates = &mut known[(side * rows + row) * len..][..len];
                            elementwise(rates, [h, shift], |rate, [h, shift]| rate + by * h.powi(power) * shift);
                        };
                        rates(u, -6.0 * odd, 1);
                        rates(v, sign * odd, 2);
                        let nodes = &mut nodes[u * (len + W) + side * W..][..len];
                        elementwise(nodes, [shift], |node, [shift]| node + 12.0 * sign * odd * shift);
                    }
                }
            }
            for (earlier, &weight) in self.tableau.x[stage].iter().enumerate().filter(|(_, weight)| **weight != 0.0) {
                let earlier = &mut known[earlier * rows * len..];
                for (earlier, shift) in earlier.chunks_exact_mut(len).zip(shift.chunks_exact(len)) {
                    elementwise(earlier, [h, shift], |earlier, [h, shift]| earlier + weight * h * shift);
                }
            }
        }
        nodes
    }

    /// From weights on the slopes of the inner stages, through the transposed stage equations, to weights on the nodes
    /// and on the slopes of all stages: both are added to.
    fn pull_back_inner(
        &self,
        index: usize,
        stages: &Stages,
        (factor, d): (&RegionFactor, &[f64]),
        rates: &mut [f64],
        nodes: &mut [f64],
    ) {
        let (region, h) = (&self.layout.regions[index], &self.grids[index].h);
        let (n, rows, len) = (d.len(), region.rows(), h.len());
        let m = self.tableau.unknown_stages() * n;
        let mut weights = vec![0.0; m * len];
        for (inner, weights) in weights.chunks_exact_mut(n * len).enumerate() {
            let slopes = &rates[(inner + 2) * rows * len..][..rows * len];
            weigh_states(region, stages.stage(inner + 2, len), slopes, weights);
        }
        // The factored equations are in units of d, their transposes in units of 1/d.
        let reciprocals: Vec<f64> = d.iter().map(|d| 1.0 / d).collect();
        let mut lanes = scaled(&weights, &reciprocals, m, 1.0);
        factor.coupling.solve_stages_transposed(&factor.coupled, &mut lanes);
        let weights = unscaled(&lanes, &reciprocals, m);
        for (inner, weights) in weights.chunks_exact(n * len).enumerate() {
            let (x, v) = (self.tableau.x[inner + 2], self.tableau.v[inner + 2]);
            for (nodes, weights) in nodes.chunks_exact_mut(len + W).zip(weights.chunks_exact(len)) {
                for p in 0..len {
                    nodes[p] += (1.0 - v) * weights[p];
                    nodes[p + W] += v * weights[p];
                }
            }
            for (rates, x) in rates.chunks_exact_mut(rows * len).zip(x) {
                for (rates, weights) in rates.chunks_exact_mut(len).zip(weights.chunks_exact(len)) {
                    elementwise(rates, [h, weights], |rate, [h, weight]| rate + x * h * weight);
                }
            }
        }
    }
}

/// `constants += (∂f/∂c)ᵀ weights`.
fn weigh_constants(region: &Region, Stage { batch, stride, first }: Stage<'_>, weights: &[f64], constants: &mut [f64]) {
    let len = weights.len() / region.rows();
    for (entry, &(row, constant)) in region.constant_pattern.iter().enumerate() {
        let values = &batch.dc[entry * stride + first..][..len];
        constants[constant] += weights[row * len..].iter().zip(values).map(|(a, b)| a * b).sum::<f64>();
    }
}

/// `states += Jᵀ weights`.
fn weigh_states(region: &Region, Stage { batch, stride, first }: Stage<'_>, weights: &[f64], states: &mut [f64]) {
    let len = weights.len() / region.rows();
    for (entry, &(row, state)) in region.state_pattern.iter().enumerate() {
        let values = &batch.dy[entry * stride + first..][..len];
        let (states, weights) = (&mut states[state * len..(state + 1) * len], &weights[row * len..(row + 1) * len]);
        elementwise(states, [values, weights], |sum, [value, weight]| sum + value * weight);
    }
}

fn explicit_rates(region: &Region, Stage { batch, stride, first }: Stage<'_>, direction: &[f64], out: &mut [f64]) {
    let len = out.len() / region.rows();
    for (entry, &(row, constant)) in region.constant_pattern.iter().enumerate() {
        let rate = direction[constant];
        if rate != 0.0 {
            let values = &batch.dc[entry * stride + first..][..len];
            elementwise(&mut out[row * len..(row + 1) * len], [values], |out, [value]| out + rate * value);
        }
    }
}

/// `out += J shift`.
fn chain(region: &Region, Stage { batch, stride, first }: Stage<'_>, shift: &[f64], out: &mut [f64]) {
    let len = out.len() / region.rows();
    for (entry, &(row, state)) in region.state_pattern.iter().enumerate() {
        let values = &batch.dy[entry * stride + first..][..len];
        let shift = &shift[state * len..(state + 1) * len];
        let out = &mut out[row * len..(row + 1) * len];
        elementwise(out, [values, shift], |out, [value, shift]| out + value * shift);
    }
}
