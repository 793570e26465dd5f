//! The Newton matrix, factored: each region eliminated to its two ends, then one dense system for ends and constants.

mod region;

use super::assemble::Assembly;
use super::coupled::{Coupling, Inward, Outward, scaled};
use super::evaluate::Work;
use super::plan::RegionPlan;
use super::{Correction, Scales, System};
use crate::by_region::ByRegion;
use crate::linear::chain::{Block, Chain};
use crate::linear::dense::Lu;
use crate::linear::memory::{Lanes, Numbers};
use crate::linear::scalar::{Lane, Scalar, W};
use crate::orientation::{Determinant, Orientation};
use crate::problem::Problem;
use nalgebra::DMatrix;
use region::{Backward, FactorRegion, Forward};

/// One region: the stretches side by side, then the stretches one after another.
#[derive(Debug, Clone)]
pub(crate) struct RegionFactor {
    pub lanes: Chain<Lane>,
    pub top: Chain<f64>,
    /// What the interval equations were multiplied by, `steps * n`.
    pub row_scale: Lanes,
    /// Of the inner stages whose states are unknowns.
    pub coupling: Coupling,
    /// What is kept of them, interval by interval; empty if there are none.
    pub coupled: Lanes,
}

/// Right-hand sides in dimensionless equations.
#[derive(Debug, Clone, Default)]
pub(crate) struct Rhs {
    /// Interval equations, `steps * n` a region, before [`RegionFactor::row_scale`].
    pub regions: ByRegion<Lanes>,
    /// Stage equations, where the inner stages' states are unknowns: `steps * m` a region. Empty where they are met.
    pub inner: ByRegion<Lanes>,
    /// What the integrals change by beside what the states and unknowns do to them, per region, active ones.
    pub integrals: ByRegion<Numbers>,
    /// Boundary equations.
    pub boundary: Numbers,
}

/// A factored Newton matrix. Holds no reference to the problem; solves any number of right-hand sides.
#[derive(Debug, Clone)]
pub(crate) struct Factorisation {
    pub scales: Scales,
    pub regions: Vec<RegionFactor>,
    pub border: Lu,
    /// By rows: the regions' reduced equations, then the boundary equations, in all ends and unknowns, dimensionless.
    pub dense: Vec<f64>,
    /// `(equation, region, active integral, derivative)`.
    pub integral_entries: Vec<(usize, usize, usize, f64)>,
}

impl Factorisation {
    /// Memory for [`factor`](Self::factor).
    pub(crate) fn new<P: Problem + ?Sized>(system: &System<'_, P>) -> Self {
        let regions = system.plan.regions.iter().zip(&system.grids).map(|(plan, grid)| {
            let coupling = Coupling::new(system.tableau, plan);
            let kept = coupling.len();
            RegionFactor {
                lanes: Chain::new(plan.sizes(), grid.steps),
                top: Chain::new(plan.sizes(), W),
                row_scale: Lanes::unset(grid.steps * plan.n),
                coupling,
                coupled: Lanes::unset(grid.steps * kept),
            }
        });
        Self {
            scales: Scales { states: ByRegion::default(), constants: Vec::new() },
            regions: regions.collect(),
            border: Lu::default(),
            dense: Vec::new(),
            integral_entries: Vec::new(),
        }
    }

    /// Factors the matrix whose derivatives `work` holds. The rank may be deficient: see [`rank`](Self::rank).
    pub(crate) fn factor<P: Problem + ?Sized>(&mut self, system: &System<'_, P>, work: &Work, scales: Scales) {
        self.condense(system, work, scales);
        self.border.factor(columns(system), &self.dense);
    }

    /// Eliminates the regions' interiors: what is left is [`dense`](Self::dense).
    pub(crate) fn condense<P: Problem + ?Sized>(&mut self, system: &System<'_, P>, work: &Work, scales: Scales) {
        self.scales = scales;
        for (region, factor) in self.regions.iter_mut().enumerate() {
            let stages = &work.regions[region];
            factor.coupling.adapt(stages, &system.grids[region], system.tableau);
            let assembly = Assembly::new(system, region, stages, &self.scales);
            FactorRegion { assembly, n: system.plan.regions[region].n, factor }.vectorised();
        }
        self.assemble_dense(system, work);
    }

    fn assemble_dense<P: Problem + ?Sized>(&mut self, system: &System<'_, P>, work: &Work) {
        let size = columns(system);
        let first_unknown = size - system.plan.unknowns.len();
        self.dense.clear();
        self.dense.resize((system.plan.states() + system.layout.equations.len()) * size, 0.0);
        let mut row = 0;
        for (plan, factor) in system.plan.regions.iter().zip(&self.regions) {
            let (n, end) = (plan.n, factor.top.end());
            for i in 0..n {
                let out = &mut self.dense[(row + i) * size..(row + i + 1) * size];
                for j in 0..n {
                    out[plan.first_end + j] = end.a[j * n + i];
                    out[plan.first_end + n + j] = end.b[j * n + i];
                }
                for (j, &column) in plan.columns.iter().enumerate() {
                    out[first_unknown + column] = end.c[j * n + i];
                }
            }
            row += n;
        }
        self.assemble_boundary(system, work, row, first_unknown);
    }

    fn assemble_boundary<P: Problem + ?Sized>(
        &mut self,
        system: &System<'_, P>,
        work: &Work,
        first_row: usize,
        first_unknown: usize,
    ) {
        let layout = system.layout;
        let size = columns(system);
        let (ends, integrals) = (layout.ends(), layout.integrals());
        let input_scale = input_scales(&self.scales);
        self.integral_entries.clear();
        for (&(equation, input), &value) in layout.boundary_pattern.iter().zip(&work.dz) {
            let out = &mut self.dense[(first_row + equation) * size..(first_row + equation + 1) * size];
            if input < ends {
                out[input] += value * input_scale[input];
            } else if input < ends + integrals {
                let Some((region, k)) = locate_integral(&system.plan.regions, input - ends) else { continue };
                self.integral_entries.push((equation, region, k, value));
                add_integral(
                    &system.plan.regions[region],
                    &self.regions[region].top.end(),
                    k,
                    value,
                    first_unknown,
                    out,
                );
            } else {
                let constant = input - ends - integrals;
                if let Some(u) = system.plan.unknowns.iter().position(|&index| index == constant) {
                    out[first_unknown + u] += value * self.scales.constants[constant];
                }
            }
        }
    }

    /// Rank of the dense system and its size.
    pub(crate) fn rank(&self) -> (usize, usize) {
        (self.border.rank(), self.border.size())
    }

    /// The same, for singular values that count as zero where they are smaller than so many times the largest.
    pub(crate) fn rank_to(&self, least: f64) -> (usize, usize) {
        (self.border.rank_to(least), self.border.size())
    }

    /// Sign of the determinant of the linearised problem; none if that is singular.
    ///
    /// With B the coefficients of an interval's right node, `[Q 0; A B]` becomes `[R F; 0 Q']` by n reflections, so
    /// that the sign of det Q' is that of `(-1)^n det Q det B det R`; det B is positive on intervals that resolve the
    /// solution. The reduced equations `P u_0 + Q u_N = r` are Q times `u_N - Φ u_0 = ...`: the sign of the dense
    /// system's determinant over those of det Q is that of the boundary conditions' for the problem itself, whatever
    /// the mesh.
    pub(crate) fn orientation(&self) -> Option<Orientation> {
        Orientation::of(self.signed(self.border.determinant_sign()))
    }

    /// The determinant in a form that does not depend on the mesh, once that resolves the solution: the volume that the
    /// rows of the dense system span, over that of the regions' rows alone. The reduced equations of a region have the
    /// ends and constants of all solutions of its differential equations for null space, by whatever matrix they are
    /// multiplied: what is left is the angle between that space and that of the boundary conditions, times the size of
    /// their gradients.
    pub(crate) fn determinant<P: Problem + ?Sized>(&self, system: &System<'_, P>) -> Determinant {
        let (states, size) = (system.plan.states(), columns(system));
        let logarithm = self.border.determinant_logarithm() - volume_logarithm(states, size, &self.dense);
        Determinant { orientation: self.orientation(), logarithm }
    }

    /// What the interior's elimination makes of the sign of the dense system's determinant.
    fn signed(&self, mut sign: f64) -> f64 {
        for region in &self.regions {
            let lanes = region.lanes.inverse_pivots().flat_map(|lane| lane.0.iter());
            let positive = lanes.chain(region.top.inverse_pivots()).filter(|pivot| **pivot > 0.0).count();
            if positive % 2 == 1 {
                sign = -sign;
            }
        }
        sign
    }

    /// A dimensionless direction in ends and unknowns that the singular dense system does not see.
    pub(crate) fn null_vector(&self) -> Vec<f64> {
        self.border.null_vector()
    }

    /// Whether no unknown enters the equation of this dense row.
    pub(crate) fn row_is_empty(&self, row: usize) -> bool {
        let size = self.border.size();
        self.dense[row * size..(row + 1) * size].iter().all(|&value| value == 0.0)
    }

    /// Solves for the correction that cancels the residual in `work`.
    pub(crate) fn newton_correction<P: Problem + ?Sized>(&self, system: &System<'_, P>, work: &Work) -> Correction {
        let regions = system.grids.iter().zip(&work.regions).zip(&self.scales.states).map(|((grid, stages), d)| {
            let n = d.len();
            let (phi, _) = stages.phi.as_chunks::<W>();
            let mut rhs = Lanes::unset(grid.steps * n);
            for (i, scale) in d.iter().enumerate() {
                for (out, phi) in rhs.chunks_exact_mut(n).zip(&phi[i * grid.steps..]) {
                    out[i] = Lane(*phi).times(-1.0 / scale);
                }
            }
            rhs
        });
        let rhs = Rhs {
            regions: regions.collect(),
            inner: self.stage_rhs(work),
            integrals: system.plan.regions.iter().map(|plan| Numbers::zeros(plan.active.len())).collect(),
            boundary: Numbers::collected(work.g.len(), work.g.iter().map(|g| -g)),
        };
        self.solve(system, rhs)
    }

    /// Minus the residuals of the stage equations in `work`; empty if there are none.
    fn stage_rhs(&self, work: &Work) -> ByRegion<Lanes> {
        let coupled = self.regions.iter().zip(&work.regions).zip(&self.scales.states);
        let coupled = coupled.filter(|((factor, _), _)| factor.coupling.m > 0);
        coupled.map(|((factor, stages), d)| scaled(&stages.psi, d, factor.coupling.m, -1.0)).collect()
    }

    /// The change of the inner stages' states that cancels the residuals of the stage equations in `work`, the nodes
    /// given.
    pub(crate) fn stage_correction<P: Problem + ?Sized>(&self, system: &System<'_, P>, work: &Work) -> ByRegion<Lanes> {
        let mut inner = self.stage_rhs(work);
        for ((inner, factor), (grid, plan)) in
            inner.iter_mut().zip(&self.regions).zip(system.grids.iter().zip(&system.plan.regions))
        {
            let mut rhs = Lanes::zeros(grid.steps * plan.n);
            Inward { coupling: &factor.coupling, coupled: &factor.coupled, inner, rhs: &mut rhs, functionals: &mut [] }
                .vectorised();
        }
        inner
    }

    /// Solves one linear system.
    pub(crate) fn solve<P: Problem + ?Sized>(&self, system: &System<'_, P>, mut rhs: Rhs) -> Correction {
        for (((inner, factor), lanes), functionals) in
            rhs.inner.iter_mut().zip(&self.regions).zip(&mut rhs.regions).zip(&mut rhs.integrals)
        {
            Inward { coupling: &factor.coupling, coupled: &factor.coupled, inner, rhs: lanes, functionals }
                .vectorised();
        }
        let (mut dense, mut row) = (Numbers::unset(self.border.size()), 0);
        let mut tops: ByRegion<Numbers> = ByRegion::default();
        for (factor, (lanes, functionals)) in
            self.regions.iter().zip(rhs.regions.iter_mut().zip(rhs.integrals.iter_mut()))
        {
            let top = Forward { factor, rhs: lanes, functionals }.vectorised();
            let reduced = &top[top.len() - factor.lanes.sizes().n..];
            dense[row..row + reduced.len()].copy_from_slice(reduced);
            row += reduced.len();
            tops.push(top);
        }
        for &(equation, region, k, value) in &self.integral_entries {
            rhs.boundary[equation] -= value * rhs.integrals[region][k];
        }
        dense[row..].copy_from_slice(&rhs.boundary);
        self.border.solve(&mut dense);
        self.interiors(system, &rhs.regions, &tops, &dense, rhs.inner)
    }

    /// The direction that a singular matrix does not see, its largest end or unknown 1.
    pub(crate) fn null_correction<P: Problem + ?Sized>(&self, system: &System<'_, P>) -> Correction {
        let grids = system.grids.iter().zip(&system.plan.regions);
        let rhs: ByRegion<Lanes> = grids.map(|(grid, plan)| Lanes::zeros(grid.steps * plan.n)).collect();
        let tops: ByRegion<Numbers> = system.plan.regions.iter().map(|plan| Numbers::zeros(W * plan.n)).collect();
        self.interiors(system, &rhs, &tops, &self.null_vector(), ByRegion::default())
    }

    /// All nodes, from the ends and unknowns and from what elimination has left of the right-hand sides.
    fn interiors<P: Problem + ?Sized>(
        &self,
        system: &System<'_, P>,
        rhs: &[Lanes],
        tops: &[Numbers],
        dense: &[f64],
        mut inner: ByRegion<Lanes>,
    ) -> Correction {
        if inner.is_empty() && system.tableau.coupled {
            let sizes = self.regions.iter().zip(&system.grids);
            inner = sizes.map(|(factor, grid)| Lanes::zeros(grid.steps * factor.coupling.m)).collect();
        }
        let (all_ends, c) = dense.split_at(2 * system.plan.states());
        let mut u = ByRegion::default();
        for (region, plan) in system.plan.regions.iter().enumerate() {
            let grid = &system.grids[region];
            let mut nodes = Lanes::unset((grid.steps + 1) * plan.n);
            let constants = Numbers::collected(plan.columns.len(), plan.columns.iter().map(|&column| c[column]));
            let ends = &all_ends[plan.first_end..plan.first_end + 2 * plan.n];
            let (first, last) = ends.split_at(plan.n);
            let backward = Backward {
                factor: &self.regions[region],
                rhs: &rhs[region],
                top: &tops[region],
                constants: &constants,
                first,
                last,
                u: &mut nodes,
            };
            backward.vectorised();
            repeat_last(grid, last, &mut nodes);
            if let Some(inner) = inner.get_mut(region) {
                let RegionFactor { coupling, coupled, .. } = &self.regions[region];
                Outward { coupling, coupled, u: &nodes, constants: &constants, inner }.vectorised();
            }
            u.push(nodes);
        }
        Correction { u, inner, c: c.to_vec() }
    }
}

/// Logarithm of the volume that the first rows of a matrix span, which is given by rows of `columns` entries.
fn volume_logarithm(rows: usize, columns: usize, matrix: &[f64]) -> f64 {
    let transposed = DMatrix::from_column_slice(columns, rows, &matrix[..rows * columns]);
    transposed.qr().unpack_r().diagonal().iter().map(|r| libm::log(r.abs())).sum()
}

/// Ends and unknowns.
fn columns<P: Problem + ?Sized>(system: &System<'_, P>) -> usize {
    2 * system.plan.states() + system.plan.unknowns.len()
}

/// Padding holds the last node, exactly.
fn repeat_last(grid: &super::grid::Grid, last: &[f64], nodes: &mut [Lane]) {
    let n = last.len();
    for j in grid.intervals()..grid.steps * W {
        let p = grid.position(j);
        for i in 0..n {
            nodes[p / W * n + i].0[p % W] = last[i];
        }
    }
    for l in (0..W).filter(|l| (l + 1) * grid.steps >= grid.intervals()) {
        for i in 0..n {
            nodes[grid.steps * n + i].0[l] = last[i];
        }
    }
}

/// Typical magnitudes of all ends.
pub(crate) fn input_scales(scales: &Scales) -> Numbers {
    let mut out = Numbers::unset(scales.states.iter().map(|d| 2 * d.len()).sum());
    let mut rest = &mut out[..];
    for d in &scales.states {
        let (first, last);
        (first, rest) = rest.split_at_mut(d.len());
        (last, rest) = rest.split_at_mut(d.len());
        first.copy_from_slice(d);
        last.copy_from_slice(d);
    }
    out
}

/// Region and active index of a global integral.
pub(crate) fn locate_integral(regions: &[RegionPlan], integral: usize) -> Option<(usize, usize)> {
    regions.iter().enumerate().find_map(|(region, plan)| {
        let local = integral.checked_sub(plan.first_integral)?;
        plan.active.iter().position(|&active| active == local).map(|k| (region, k))
    })
}

/// Adds `value` times the reduced functional of integral `k` to a dense row.
fn add_integral(plan: &RegionPlan, end: &Block<&[f64]>, k: usize, value: f64, first_unknown: usize, out: &mut [f64]) {
    let (n, p) = (plan.n, plan.columns.len());
    for i in 0..n {
        out[plan.first_end + i] += value * end.fa[k * n + i];
        out[plan.first_end + n + i] += value * end.fb[k * n + i];
    }
    for (j, &column) in plan.columns.iter().enumerate() {
        out[first_unknown + column] += value * end.fc[k * p + j];
    }
}
