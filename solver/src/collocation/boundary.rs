//! How large the terms of the boundary equations are: what their residuals are measured by.

use super::evaluate::Work;
use super::factor::input_scales;
use super::{Scales, System};
use crate::linear::scalar::W;
use crate::problem::Problem;

/// Sums of this many terms, more or less, carry rounding errors of so many units in the last place.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Size of one boundary equation.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct EquationSize {
    /// Its largest term: derivative times typical magnitude of the input. That of an integral is `∫ |q| ds`, since an
    /// integral that vanishes is still a sum of terms that do not.
    pub terms: f64,
    /// What rounding alone may leave of it.
    rounding: f64,
}

impl EquationSize {
    /// A residual relative to the equation's largest term; 0 if rounding explains it.
    pub(crate) fn relative(&self, residual: f64) -> f64 {
        if residual.abs() <= self.rounding { 0.0 } else { residual.abs() / self.terms }
    }
}

/// Size of one integral.
#[derive(Debug, Clone, Copy, Default)]
struct IntegralSize {
    /// `∫ |q| ds`.
    found: f64,
    /// `∫ Σ |∂q/∂y_i| Y_i ds`: what it would be if all states had their typical magnitudes.
    typical: f64,
}

impl<P: Problem + ?Sized> System<'_, P> {
    /// Sizes of all boundary equations at the iterate whose values `work` holds.
    pub(crate) fn boundary_sizes(&self, work: &Work, scales: &Scales) -> Vec<EquationSize> {
        let layout = self.layout;
        let (ends, integrals) = (layout.ends(), layout.integrals());
        let input_scale = input_scales(scales);
        let integral_sizes = self.integral_sizes(work, scales);
        let mut sizes = vec![EquationSize::default(); layout.equations.len()];
        for (&(equation, input), value) in layout.boundary_pattern.iter().zip(&work.dz) {
            let (found, typical) = if input < ends {
                (input_scale[input], input_scale[input])
            } else if input < ends + integrals {
                let size = integral_sizes[input - ends];
                (size.found, size.typical.max(size.found))
            } else {
                let scale = scales.constants[input - ends - integrals];
                (scale, scale)
            };
            let size = &mut sizes[equation];
            size.terms = size.terms.max(value.abs() * found);
            size.rounding = size.rounding.max(value.abs() * typical * ROUNDING);
        }
        sizes
    }

    /// Boundary residuals relative to the largest term of their equations, at the iterate whose values `work` holds.
    pub(crate) fn boundary_residuals(&self, work: &Work, scales: &Scales) -> impl Iterator<Item = f64> {
        let sizes = self.boundary_sizes(work, scales);
        work.g.iter().zip(sizes).map(|(&residual, size)| size.relative(residual))
    }

    fn integral_sizes(&self, work: &Work, scales: &Scales) -> Vec<IntegralSize> {
        let mut sizes = vec![IntegralSize::default(); self.layout.integrals()];
        for (index, plan) in self.plan.regions.iter().enumerate() {
            let (stages, grid) = (&work.regions[index], &self.grids[index]);
            let (intervals, nodes) = (grid.interval_stride(), grid.node_stride());
            for &k in &plan.active {
                let size = &mut sizes[plan.first_integral + k];
                for (stage, b) in self.tableau.b.iter().enumerate() {
                    let q = stages.slope(stage, plan.n + k, intervals);
                    size.found += q.iter().zip(&grid.h).map(|(q, h)| b.abs() * h * q.abs()).sum::<f64>();
                }
                let entries = self.layout.regions[index].state_pattern.iter().enumerate();
                for (entry, &(_, state)) in entries.filter(|(_, (row, _))| *row == plan.n + k) {
                    let dy = &stages.nodes.dy[entry * nodes..(entry + 1) * nodes];
                    let ends = dy.iter().zip(&dy[W..]);
                    let mean = ends.zip(&grid.h).map(|((left, right), h)| 0.5 * h * (left.abs() + right.abs()));
                    size.typical += scales.states[index][state] * mean.sum::<f64>();
                }
            }
        }
        sizes
    }
}
