//! The linearised problem at a solution: sensitivities, forward and adjoint.

use crate::by_region::ByRegion;
use crate::collocation::coupled::unscaled;
use crate::collocation::evaluate::{Derivatives, Work};
use crate::collocation::factor::{Factorisation, Rhs, input_scales};
use crate::collocation::grid::intervals;
use crate::collocation::interpolant::Extended;
use crate::collocation::plan::Plan;
use crate::collocation::transpose::Weights;
use crate::collocation::{Correction, Iterate, System};
use crate::error::SolveError;
use crate::guess::Guess;
use crate::linear::memory::Lanes;
use crate::linear::scalar::{Lane, Scalar, W};
use crate::magnitude::Magnitudes;
use crate::measure::{Error, undefined};
use crate::newton::Converged;
use crate::options::Order;
use crate::orientation::Determinant;
use crate::problem::Problem;
use crate::solution::Solution;
use crate::solve::check;
use crate::stats::Stats;
use std::sync::Arc;

/// Parts of each interval by which the defects of order 4 are integrated for an estimated error.
const PARTS: usize = 8;

/// The equations linearised and factored at a solution. Each further question costs one linear solve or few.
pub struct Linearisation<'p, P: Problem + ?Sized> {
    pub(crate) system: System<'p, P>,
    pub(crate) x: Iterate,
    pub(crate) work: Work,
    pub(crate) factorisation: Factorisation,
    stats: Stats,
}

/// Rates of change of one region along a [`Tangent`].
#[derive(Debug, Clone, PartialEq)]
pub struct TangentRegion {
    /// State by state, at the nodes of the solution's mesh.
    pub states: Vec<Vec<f64>>,
    /// Of the integrals over the region.
    pub integrals: Vec<f64>,
}

/// Rates of change of a solution when given constants move.
#[derive(Debug, Clone, PartialEq)]
pub struct Tangent {
    /// One for each region.
    pub regions: Vec<TangentRegion>,
    /// All constants: the given move as was asked, the unknown follow.
    pub constants: Vec<f64>,
}

impl Tangent {
    /// Rates of the boundary equations' inputs: ends, integrals, constants.
    pub fn inputs(&self) -> Vec<f64> {
        let end = |exit: bool| move |y: &Vec<f64>| if exit { y.last() } else { y.first() }.copied().unwrap_or(0.0);
        let ends = self
            .regions
            .iter()
            .flat_map(|region| region.states.iter().map(end(false)).chain(region.states.iter().map(end(true))));
        let integrals = self.regions.iter().flat_map(|region| region.integrals.iter().copied());
        ends.chain(integrals).chain(self.constants.iter().copied()).collect()
    }
}

/// A function of the solution, by its gradient there.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Functional {
    /// With respect to the boundary equations' inputs: ends, integrals, constants.
    pub inputs: Vec<f64>,
    /// With respect to states at nodes: `(region, node, state, derivative)`.
    pub nodes: Vec<(usize, usize, usize, f64)>,
    /// With respect to integrals over single intervals: `(region, interval, integral, derivative)`.
    pub intervals: Vec<(usize, usize, usize, f64)>,
}

impl<'p, P: Problem + ?Sized> Linearisation<'p, P> {
    /// Evaluates all derivatives at the solution and factors the Newton matrix there.
    ///
    /// # Errors
    /// The solution is not one of this problem's, or its Newton matrix is singular (as at a fold).
    pub fn new(problem: &'p P, solution: &Solution) -> Result<Self, SolveError> {
        Self::near(problem, &Guess::from(solution), solution.unknowns(), solution.order())
    }

    /// As [`new`](Self::new), at states and constants that solve the equations with the constants `unknowns` unknown,
    /// whatever problem they were found for: one with fewer equations, or with others unknown.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn near(problem: &'p P, at: &Guess, unknowns: &[usize], order: Order) -> Result<Self, SolveError> {
        let (system, x) = Self::system_at(problem, at, unknowns, order)?;
        Self::at(system, x, Stats::default())
    }

    /// The direction that the equations determine least, where they may be singular: the right singular vector of the
    /// smallest singular value. Given constants stay. The rest is as in [`near`](Self::near).
    pub(crate) fn least_determined(
        problem: &'p P,
        at: &Guess,
        unknowns: &[usize],
        order: Order,
    ) -> Result<(Tangent, Stats), SolveError> {
        let found = Self::perhaps_singular_at(problem, at, unknowns, order)?;
        let direction = found.factorisation.null_correction(&found.system);
        Ok((found.unscaled(&direction, vec![0.0; found.x.constants.len()]), found.stats))
    }

    /// As [`near`](Self::near), whatever the rank of the Newton matrix.
    pub(crate) fn perhaps_singular_at(
        problem: &'p P,
        at: &Guess,
        unknowns: &[usize],
        order: Order,
    ) -> Result<Self, SolveError> {
        let (system, x) = Self::system_at(problem, at, unknowns, order)?;
        Self::perhaps_singular(system, x, Stats::default())
    }

    fn system_at(
        problem: &'p P,
        at: &Guess,
        unknowns: &[usize],
        order: Order,
    ) -> Result<(System<'p, P>, Iterate), SolveError> {
        let layout = problem.layout();
        check(layout, at, unknowns, &Default::default())?;
        let grids = at.grids();
        let x = at.iterate(&grids);
        let plan = Arc::new(Plan::new(layout, unknowns));
        let magnitudes = Magnitudes::stated(layout);
        let system = System { problem, layout, plan, linear: false, tableau: order.tableau(), magnitudes, grids };
        Ok((system, x))
    }

    pub(crate) fn at(system: System<'p, P>, x: Iterate, stats: Stats) -> Result<Self, SolveError> {
        let linearisation = Self::perhaps_singular(system, x, stats)?;
        let Self { system, factorisation, .. } = &linearisation;
        let failed = |error| SolveError::Newton { error, intervals: intervals(&system.grids) };
        factorisation.determined(system).map_err(failed)?;
        Ok(linearisation)
    }

    /// What Newton's iteration holds, where its first correction was negligible: the equations are factored at the
    /// solution already. Rates of integrals need derivatives that the iteration has not asked for.
    pub(crate) fn held(system: System<'p, P>, converged: Converged) -> Self {
        let Converged { x, work, factorisation, .. } = converged;
        Self { system, x, work, factorisation, stats: Stats::default() }
    }

    /// As [`at`](Self::at), whatever the rank of the Newton matrix.
    fn perhaps_singular(system: System<'p, P>, mut x: Iterate, mut stats: Stats) -> Result<Self, SolveError> {
        let mut work = system.work();
        system.complete(&mut x, &mut stats);
        system.evaluate(&x, Derivatives::All, &mut work, &mut stats).map_err(undefined(&system.grids))?;
        let mut factorisation = Factorisation::new(&system);
        factorisation.factor(&system, &work, system.scales(&x));
        stats.factorisations += 1;
        Ok(Self { system, x, work, factorisation, stats })
    }

    /// See [`Factorisation::determinant`].
    pub(crate) fn determinant(&self) -> Determinant {
        self.factorisation.determinant(&self.system)
    }

    /// What the linearisation cost.
    pub fn stats(&self) -> &Stats {
        &self.stats
    }

    /// d(solution)/dλ when the given constants move at the rates `direction` (one for each constant of the layout;
    /// entries of unknown constants are ignored).
    pub fn tangent(&self, direction: &[f64]) -> Tangent {
        let mut rates = direction.to_vec();
        rates.resize(self.x.constants.len(), 0.0);
        for &unknown in &self.system.plan.unknowns {
            rates[unknown] = 0.0;
        }
        let rhs = self.system.parameter_rhs(&self.work, &self.factorisation.scales, &rates);
        let dx = self.factorisation.solve(&self.system, rhs);
        self.unscaled(&dx, rates)
    }

    /// d(solution)/d(constant) of one given constant; of an unknown constant, zero.
    pub fn sensitivity(&self, constant: usize) -> Tangent {
        let mut direction = vec![0.0; self.x.constants.len()];
        if let Some(rate) = direction.get_mut(constant) {
            *rate = 1.0;
        }
        self.tangent(&direction)
    }

    /// Estimated error of the solution at its nodes, in its integrals and constants: what its defects and boundary
    /// residuals cause, to first order. It is what has to be taken off the solution. At order 4 the right-hand side is
    /// evaluated at 24 places of each interval for it: one with a kink has a defect that fewer places misjudge, by a
    /// third of it and more.
    ///
    /// # Errors
    /// The right-hand side is undefined where the estimate needs it.
    pub fn error(&self) -> Result<Tangent, SolveError> {
        let (mut stats, mut extensions, mut defects) = (Stats::default(), Vec::new(), Vec::new());
        for region in 0..self.system.grids.len() {
            let stages = &self.work.regions[region];
            let extended = Extended { system: &self.system, region, x: &self.x, stages };
            let known = match self.system.tableau.order {
                4 => extended.integrated_finely(PARTS, &mut stats),
                _ => extended.judged(&self.factorisation.scales, f64::INFINITY, &mut stats),
            };
            let (extension, defect) = known.map_err(undefined(&self.system.grids))?;
            defects.push(defect);
            extensions.push(extension);
        }
        let judged = (&extensions[..], &defects[..]);
        let error = Error::of(&self.system, (&self.x, &self.work), &self.factorisation, judged, &[], &mut stats);
        let mut tangent = self.unscaled(&error.correction, vec![0.0; self.x.constants.len()]);
        for (region, own) in tangent.regions.iter_mut().zip(&error.integrals) {
            region.integrals.iter_mut().zip(own.sums()).for_each(|(integral, own)| *integral += own);
        }
        Ok(tangent)
    }

    fn unscaled(&self, dx: &Correction, mut constants: Vec<f64>) -> Tangent {
        let scales = &self.factorisation.scales;
        for (&unknown, c) in self.system.plan.unknowns.iter().zip(&dx.c) {
            constants[unknown] = scales.constants[unknown] * c;
        }
        let regions = (0..self.system.grids.len()).map(|region| {
            let (grid, plan) = (&self.system.grids[region], &self.system.plan.regions[region]);
            let mut nodes = vec![0.0; plan.n * grid.node_stride()];
            for (i, (out, scale)) in nodes.chunks_exact_mut(grid.node_stride()).zip(&scales.states[region]).enumerate()
            {
                for (out, u) in out.as_chunks_mut::<W>().0.iter_mut().zip(dx.u[region].chunks_exact(plan.n)) {
                    *out = u[i].times(*scale).0;
                }
            }
            let stages = &self.work.regions[region];
            let m = self.factorisation.regions[region].coupling.m;
            let inner = dx.inner.get(region).map_or_else(Vec::new, |inner| unscaled(inner, &scales.states[region], m));
            let rates = self.system.weighted_rates(region, stages, Some(&nodes), &inner, &constants);
            let len = grid.interval_stride();
            TangentRegion {
                states: grid.unpack(&nodes).to_vecs(),
                integrals: rates.chunks_exact(len).skip(plan.n).map(|rates| rates.iter().sum()).collect(),
            }
        });
        Tangent { regions: regions.collect(), constants }
    }

    /// d(functional)/d(constant) for all given constants, by one transposed solve; zero for unknown constants.
    pub fn gradient(&self, functional: &Functional) -> Vec<f64> {
        let (layout, plan) = (self.system.layout, &self.system.plan);
        let mut inputs = functional.inputs.clone();
        inputs.resize(layout.inputs(), 0.0);
        let (ends, rest) = inputs.split_at(layout.ends());
        let (integrals, explicit) = rest.split_at(layout.integrals());
        let mut gradient = explicit.to_vec();
        let scales = &self.factorisation.scales;
        let mut u = ByRegion::default();
        for (region, plan) in plan.regions.iter().enumerate() {
            let grid = &self.system.grids[region];
            let mut nodes = self.integral_weights(region, integrals, &functional.intervals, &mut gradient);
            let stride = grid.node_stride();
            for i in 0..plan.n {
                nodes[i * stride] += ends[plan.first_end + i];
                nodes[i * stride + grid.last()] += ends[plan.first_end + plan.n + i];
            }
            for &(r, node, state, weight) in &functional.nodes {
                if r == region && node < grid.mesh.len() && state < plan.n {
                    let p = if node == grid.intervals() { grid.last() } else { grid.position(node) };
                    nodes[state * stride + p] += weight;
                }
            }
            u.push(packed(&nodes, &scales.states[region]));
        }
        let c = plan.unknowns.iter().map(|&unknown| gradient[unknown] * scales.constants[unknown]).collect();
        let active = |plan: &crate::collocation::plan::RegionPlan| {
            plan.active.iter().map(|&k| integrals[plan.first_integral + k]).collect()
        };
        let integrals = plan.regions.iter().map(active).collect();
        let multipliers = self.factorisation.solve_transposed(
            &self.system,
            Weights { unknowns: Correction { u, inner: ByRegion::default(), c }, integrals },
        );
        self.pull_back(&multipliers, &mut gradient);
        for &unknown in &plan.unknowns {
            gradient[unknown] = 0.0;
        }
        gradient
    }

    /// Weights on integrals that the Newton matrix does not hold, and on those over single intervals, as weights on
    /// nodes and constants.
    fn integral_weights(
        &self,
        region: usize,
        integrals: &[f64],
        intervals: &[(usize, usize, usize, f64)],
        gradient: &mut [f64],
    ) -> Vec<f64> {
        let (grid, plan) = (&self.system.grids[region], &self.system.plan.regions[region]);
        let len = grid.interval_stride();
        let mut weights = vec![0.0; plan.rows * len];
        for k in (0..plan.rows - plan.n).filter(|k| !plan.active.contains(k)) {
            weights[(plan.n + k) * len..(plan.n + k + 1) * len].fill(integrals[plan.first_integral + k]);
        }
        for &(_, interval, k, weight) in intervals.iter().filter(|(r, ..)| *r == region) {
            if interval < grid.intervals() && k < plan.rows - plan.n {
                weights[(plan.n + k) * len + grid.position(interval)] += weight;
            }
        }
        if weights.iter().all(|&weight| weight == 0.0) {
            return vec![0.0; plan.n * grid.node_stride()];
        }
        let factor = (&self.factorisation.regions[region], &self.factorisation.scales.states[region][..]);
        let mut nodes = self.system.pull_back(region, &self.work.regions[region], factor, &weights, gradient);
        // What stands on padding belongs to the last node.
        for component in nodes.chunks_exact_mut(grid.node_stride()) {
            for j in grid.intervals()..len {
                component[grid.last()] += std::mem::take(&mut component[grid.position(j)]);
            }
        }
        nodes
    }

    /// Adds `multipliers · (-∂F/∂c)` to a gradient over all constants.
    fn pull_back(&self, multipliers: &Rhs, gradient: &mut [f64]) {
        let layout = self.system.layout;
        for (region, plan) in self.system.plan.regions.iter().enumerate() {
            let len = self.system.grids[region].interval_stride();
            let mut weights = vec![0.0; plan.rows * len];
            for (i, scale) in self.factorisation.scales.states[region].iter().enumerate() {
                let out = weights[i * len..(i + 1) * len].as_chunks_mut::<W>().0;
                for (out, lanes) in out.iter_mut().zip(multipliers.regions[region].chunks_exact(plan.n)) {
                    *out = lanes[i].times(1.0 / scale).0;
                }
            }
            for (&k, &weight) in plan.active.iter().zip(&multipliers.integrals[region]) {
                weights[(plan.n + k) * len..(plan.n + k + 1) * len].fill(weight);
            }
            let factor = (&self.factorisation.regions[region], &self.factorisation.scales.states[region][..]);
            self.system.pull_back(region, &self.work.regions[region], factor, &weights, gradient);
        }
        let first = layout.ends() + layout.integrals();
        for (&(equation, input), &value) in layout.boundary_pattern.iter().zip(&self.work.dz) {
            if let Some(constant) = input.checked_sub(first) {
                gradient[constant] -= value * multipliers.boundary[equation];
            }
        }
    }

    /// Typical magnitudes of the boundary equations' ends, as the solver scales by.
    pub fn end_scales(&self) -> Vec<f64> {
        input_scales(&self.factorisation.scales).to_vec()
    }
}

/// Component by component weights, in dimensionless unknowns and node by node.
fn packed(nodes: &[f64], scales: &[f64]) -> Lanes {
    let (n, rows) = (scales.len(), nodes.len() / scales.len() / W);
    let lanes = nodes.as_chunks::<W>().0;
    (0..rows)
        .flat_map(|t| (0..n).map(move |i| (t, i)))
        .map(|(t, i)| Lane(lanes[i * rows + t]).times(scales[i]))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bvp::Bvp;
    use crate::options::{Options, Order};

    /// `u'' = -ω² u`, u = 0 at both ends: with Φ what takes the left end to the right one, the rows `[-Φ 1]` and those
    /// of the boundary conditions span the volume `Φ_12`, and the first alone `√det(1 + ΦΦᵀ)`.
    #[test]
    fn the_determinant_does_not_hang_on_the_mesh() {
        let omega = 4.0_f64;
        let (sine, cosine) = omega.sin_cos();
        let phi = [[cosine, sine / omega], [-omega * sine, cosine]];
        // det(1 + ΦΦᵀ) = 1 + Σ Φ_ij² + det² Φ, and det Φ = 1.
        let volume = (2.0 + phi.iter().flatten().map(|x| x * x).sum::<f64>()).sqrt();
        let exact = (phi[0][1].abs() / volume).ln();
        for order in [Order::Four, Order::Six, Order::Eight, Order::SixGauss] {
            for intervals in [20, 33, 64] {
                let rest = Bvp::new(
                    &["u", "slope"],
                    (0.0, 1.0),
                    move |_, y, _, f| (f[0], f[1]) = (y[1], -y[0] * omega * omega),
                    |a, b, _, g| (g[0], g[1]) = (a[0], b[0]),
                );
                let rest = rest.guess(intervals, |_, y| y.fill(0.0));
                let solution = rest.solve(&Options { order, ..Options::default() }).unwrap();
                let found = Linearisation::new(&rest, &solution).unwrap().determinant().logarithm;
                assert!((found - exact).abs() < 2e-3, "{order:?} {intervals}: {found} for {exact}");
            }
        }
    }
}
