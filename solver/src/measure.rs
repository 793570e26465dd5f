//! How good a converged iterate is: its defects, and the error they cause.

mod quadrature;

use crate::by_region::ByRegion;
use crate::collocation::coupled::scaled;
use crate::collocation::defect::Defects;
use crate::collocation::evaluate::{Derivatives, Work};
use crate::collocation::factor::{Factorisation, Rhs};
use crate::collocation::grid::{Grid, intervals};
use crate::collocation::interpolant::{Extended, Extension};
use crate::collocation::{Correction, Iterate, System};
use crate::error::{NewtonError, NonFinite, SolveError};
use crate::guess::RegionGuess;
use crate::linear::memory::{Lanes, Numbers};
use crate::linear::scalar::{Lane, Scalar, W};
use crate::newton::Converged;
use crate::problem::Problem;
use crate::refine::{Measure, Rounding};
use crate::rows::Rows;
use crate::solution::RegionSolution;
use crate::stats::Stats;
use std::cell::{OnceCell, RefCell};
use std::rc::Rc;

/// Change of the slopes at the nodes times the length of an interval, over the estimated error, up to which that error
/// is taken off: where a slope changes by so much, Hermite's cubic moves by 4/27 of it times the length, which is half
/// of the error.
const BULGE: f64 = 3.0;

/// What Newton's iteration left on one set of meshes, with its continuous extension and defects.
pub(crate) struct Solved<'a, P: Problem + ?Sized> {
    pub system: System<'a, P>,
    pub converged: Converged,
    pub extensions: Vec<Extension>,
    pub defects: Vec<Defects>,
    /// The estimated error, once it has been asked for, and its largest component.
    estimate: OnceCell<(Error, f64)>,
    /// See [`worst_boundary_residual`](Self::worst_boundary_residual).
    boundary: OnceCell<(f64, usize)>,
    /// See [`expect_error`](Self::expect_error).
    least_error: f64,
    /// See [`is_corrected`](Self::is_corrected).
    corrected: bool,
    /// The defects as last measured.
    pub measures: RefCell<Option<Measures>>,
}

/// A converged iterate that cannot be judged: the right-hand side is undefined between its collocation points.
pub(crate) struct Undefined {
    pub grids: Vec<Grid>,
    pub x: Iterate,
    pub error: NonFinite,
}

impl From<Box<Undefined>> for SolveError {
    fn from(found: Box<Undefined>) -> Self {
        undefined(&found.grids)(found.error)
    }
}

/// What defects were held to, and what they are then: one a region.
pub(crate) struct Measures {
    pub target: f64,
    pub rounding: Rounding,
    pub all: Rc<[Measure]>,
}

impl<'a, P: Problem + ?Sized> Solved<'a, P> {
    /// `limit`: what defects may be at most. Where they are far larger, less is spent on knowing them.
    ///
    /// # Errors
    /// The right-hand side is undefined between the collocation points.
    pub(crate) fn new(
        system: System<'a, P>,
        converged: Converged,
        limit: f64,
        stats: &mut Stats,
    ) -> Result<Self, Box<Undefined>> {
        let (extensions, defects) = match judged(&system, &converged, limit, stats) {
            Ok(judged) => judged,
            Err(error) => return Err(Box::new(Undefined { grids: system.grids, x: converged.x, error })),
        };
        let (estimate, boundary, measures) = (OnceCell::new(), OnceCell::new(), RefCell::new(None));
        let (least_error, corrected) = (0.0, false);
        Ok(Self { system, converged, extensions, defects, estimate, boundary, least_error, corrected, measures })
    }

    pub(crate) fn regions(&self) -> Vec<RegionSolution> {
        let Converged { x, work, .. } = &self.converged;
        let error = self.estimate.get().filter(|_| self.corrected);
        let regions = self.extensions.iter().enumerate().map(|(region, extension)| {
            let errors = error.map(|(error, _)| &error.integrals[region]);
            RegionSolution::new(&self.system, region, (x, work), (extension, &self.defects[region].relative), errors)
        });
        regions.collect()
    }

    /// Meshes and states.
    pub(crate) fn guess(&self) -> Vec<RegionGuess> {
        let regions = self
            .system
            .grids
            .iter()
            .zip(&self.converged.x.y)
            .map(|(grid, y)| RegionGuess { mesh: grid.mesh.clone(), states: grid.unpack(y).to_vecs() });
        regions.collect()
    }

    /// Estimated error at the nodes and in the constants, largest component relative to typical magnitudes.
    ///
    /// The continuous extension S has the error `e = S - y` with `e' = f_y e + (S' - f(S))` to first order; the
    /// collocation equations linearised at S, solved for the integrals of the defect over the intervals, give e.
    ///
    /// Computed once.
    pub(crate) fn error_estimate(&self, stats: &mut Stats) -> f64 {
        self.estimated_error(stats).1.max(self.least_error)
    }

    /// What equations that are each off by a part `by` of their terms, of either sign as errors come, change the
    /// solution by at least, in typical magnitudes: to first order; infinite where nothing is determined.
    pub(crate) fn reaction(&self, by: f64, stats: &mut Stats) -> f64 {
        let Converged { work, factorisation, .. } = &self.converged;
        let system = &self.system;
        let sizes = system.boundary_sizes(work, &factorisation.scales);
        let boundary = Numbers::collected(sizes.len(), sizes.iter().map(|size| by * size.terms));
        let mut rhs = Rhs { boundary, ..Rhs::default() };
        for (grid, plan) in system.grids.iter().zip(&system.plan.regions) {
            let mut lanes = Lanes::unset(grid.steps * plan.n);
            for (at, lane) in lanes.iter_mut().enumerate() {
                *lane = Lane(std::array::from_fn(|l| if is_odd_one(at * W + l) { -by } else { by }));
            }
            rhs.regions.push(lanes);
            rhs.integrals.push(Numbers::zeros(plan.active.len()));
        }
        stats.linear_solves += 1;
        let largest = self.converged.largest(system, &factorisation.solve(system, rhs));
        if largest.is_finite() { largest } else { f64::INFINITY }
    }

    /// An error that the estimate knows nothing of: it is no less than this from here on.
    pub(crate) fn expect_error(&mut self, error: f64) {
        self.least_error = error;
    }

    fn estimated_error(&self, stats: &mut Stats) -> &(Error, f64) {
        self.estimate.get_or_init(|| {
            let (error, largest) = self.error(&[], stats);
            let largest = self.with_quadrature(&error, largest, stats);
            (error, largest)
        })
    }

    /// As [`error_estimate`](Self::error_estimate), what it would be if all defects that exceed `target`, by which they
    /// are measured, were no larger than that.
    pub(crate) fn foreseen_error(&self, measures: &[Measure], target: f64, stats: &mut Stats) -> f64 {
        let left: ByRegion<Numbers> =
            self.system.grids.iter().zip(measures).map(|(grid, measure)| measure.left(grid, target)).collect();
        self.error(&left, stats).1
    }

    /// What the defects cause, as much of them as `left` says (see [`Error::of`]), and its largest component.
    fn error(&self, left: &[Numbers], stats: &mut Stats) -> (Error, f64) {
        let Converged { x, work, factorisation, .. } = &self.converged;
        let judged = (&self.extensions[..], &self.defects[..]);
        let error = Error::of(&self.system, (x, work), factorisation, judged, left, stats);
        let largest = self.converged.largest(&self.system, &error.correction);
        (error, largest)
    }

    /// Takes the estimated error off the solution, unless its boundary residuals exceed `limit` then, the right-hand
    /// side is undefined there, or slopes at the nodes change by so much that what is between them moves farther than
    /// the nodes. Where equations are stiff it may: the estimate is then an upper bound rather than the error. What is
    /// between the nodes moves with them; defects stay what they were.
    ///
    /// # Errors
    /// The right-hand side cannot be evaluated again at the solution that was found.
    pub(crate) fn correct(&mut self, limit: f64, stats: &mut Stats) -> Result<(), NonFinite> {
        let estimate = self.error_estimate(stats);
        let (error, _) = self.estimated_error(stats);
        let Converged { x, work, factorisation, .. } = &self.converged;
        let corrected = self.system.stepped(x, &factorisation.scales, -1.0, &error.correction);
        let slopes: ByRegion<Numbers> = work.regions.iter().map(|stages| stages.nodes.f.clone()).collect();
        let found = std::mem::replace(&mut self.converged.x, corrected);
        self.corrected = true;
        if self.evaluate(stats).is_ok()
            && self.bulge(&slopes) <= BULGE * estimate
            && self.worst_boundary_residual().0 <= limit
        {
            return Ok(());
        }
        self.converged.x = found;
        self.corrected = false;
        self.evaluate(stats)
    }

    /// By how much the slopes at the nodes have changed from `before`, times the length of the longer interval beside:
    /// the largest, in typical magnitudes.
    fn bulge(&self, before: &[Numbers]) -> f64 {
        let (system, scales) = (&self.system, self.converged.scales());
        let mut largest = 0.0_f64;
        for (region, before) in before.iter().enumerate() {
            let (grid, now) = (&system.grids[region], &self.converged.work.regions[region].nodes.f);
            let stride = grid.node_stride();
            let states = before.chunks_exact(stride).zip(now.chunks_exact(stride));
            for ((before, now), scale) in states.zip(&scales.states[region]) {
                let change = |at: usize| (now[at] - before[at]).abs();
                let moved = grid.h.iter().enumerate().map(|(at, h)| h * change(at).max(change(at + W)) / scale);
                largest = moved.fold(largest, f64::max);
            }
        }
        largest
    }

    /// The equations at the solution as it stands.
    fn evaluate(&mut self, stats: &mut Stats) -> Result<(), NonFinite> {
        let (system, Converged { x, work, .. }) = (&self.system, &mut self.converged);
        self.boundary = OnceCell::new();
        if system.layout.integrals() == 0 && !work.has_open_ends() {
            return system.evaluate_nodes(x, work, stats);
        }
        system.evaluate(x, Derivatives::None, work, stats)?;
        let Some((error, _)) = self.estimate.get().filter(|_| self.corrected) else { return Ok(()) };
        for (plan, errors) in system.plan.regions.iter().zip(&error.integrals) {
            for &k in &plan.active {
                work.integrals[plan.first_integral + k] -= errors.row(k).iter().sum::<f64>();
            }
        }
        system.evaluate_boundary(x, work)
    }

    /// Whether the estimated error has been taken off.
    pub(crate) fn is_corrected(&self) -> bool {
        self.corrected
    }

    /// Boundary residuals relative to the largest term of their equations: the worst, and whose it is.
    pub(crate) fn worst_boundary_residual(&self) -> (f64, usize) {
        *self.boundary.get_or_init(|| self.worst_residual())
    }

    fn worst_residual(&self) -> (f64, usize) {
        let residuals = self.system.boundary_residuals(&self.converged.work, self.converged.scales());
        let worst = residuals.enumerate().max_by(|a, b| a.1.total_cmp(&b.1));
        worst.map_or((0.0, 0), |(equation, residual)| (residual, equation))
    }
}

/// The continuous extensions of all regions and their defects.
fn judged<P: Problem + ?Sized>(
    system: &System<'_, P>,
    converged: &Converged,
    limit: f64,
    stats: &mut Stats,
) -> Result<(Vec<Extension>, Vec<Defects>), NonFinite> {
    let (count, scales) = (system.grids.len(), converged.scales());
    let (mut extensions, mut defects) = (Vec::with_capacity(count), Vec::with_capacity(count));
    for (region, stages) in converged.work.regions.iter().enumerate() {
        let extended = Extended { system, region, x: &converged.x, stages };
        let (extension, defect) = extended.judged(scales, limit, stats)?;
        extensions.push(extension);
        defects.push(defect);
    }
    Ok((extensions, defects))
}

/// The estimated error of what the collocation equations were solved for; see [`Solved::error_estimate`].
pub(crate) struct Error {
    /// In the unknowns, scaled.
    pub correction: Correction,
    /// What the defects of the integrals themselves add to the error of each, region by region: a row an integral, in
    /// working order over each interval.
    pub integrals: ByRegion<Rows>,
}

impl Error {
    /// `left`: a factor on the defects of each interval, in working order, region by region; none are 1.
    pub(crate) fn of<P: Problem + ?Sized>(
        system: &System<'_, P>,
        (x, work): (&Iterate, &Work),
        factorisation: &Factorisation,
        (extensions, defects): (&[Extension], &[Defects]),
        left: &[Numbers],
        stats: &mut Stats,
    ) -> Self {
        let mut rhs = Rhs { boundary: work.g.clone(), ..Rhs::default() };
        let mut integrals = ByRegion::default();
        for (region, defects) in defects.iter().enumerate() {
            let extended = Extended { system, region, x, stages: &work.regions[region] };
            let (grid, plan) = (&system.grids[region], &system.plan.regions[region]);
            let scales = &factorisation.scales.states[region];
            let mut integrated = defects.integrated.clone();
            if system.tableau.coupled {
                // The stages follow the defects as their equations say.
                let mut moments = extended.moments(&extensions[region], defects);
                reduce(&mut moments, left.get(region));
                let m = factorisation.regions[region].coupling.m;
                rhs.inner.push(scaled(&moments, scales, m, 1.0));
            } else if system.tableau.order > 4 {
                extended.add_stages(&extensions[region], defects, &mut integrated);
            }
            if system.tableau.order > 4 {
                extended.add_remainders(&extensions[region], defects, scales, &mut integrated);
            }
            reduce(&mut integrated, left.get(region));
            let len = grid.interval_stride();
            let mut lanes = Lanes::unset(grid.steps * plan.n);
            for (i, scale) in scales.iter().enumerate() {
                let integrated = integrated[i * len..(i + 1) * len].as_chunks::<W>().0;
                for (out, integrated) in lanes.chunks_exact_mut(plan.n).zip(integrated) {
                    out[i] = Lane(*integrated).times(1.0 / scale);
                }
            }
            rhs.regions.push(lanes);
            let mut parts = integrated[plan.n * len..].to_vec();
            if system.plan.by_quadrature {
                let first = parts.len().saturating_sub(len);
                parts[first..].fill(0.0);
            }
            let parts = Rows::new(parts, len);
            let sums = plan.active.iter().map(|&k| parts.row(k).iter().sum());
            rhs.integrals.push(Numbers::collected(plan.active.len(), sums));
            integrals.push(parts);
        }
        stats.linear_solves += 1;
        Self { correction: factorisation.solve(system, rhs), integrals }
    }
}

/// The larger of two numbers; NaN if one of them is.
fn larger(a: f64, b: f64) -> f64 {
    if b > a || b.is_nan() { b } else { a }
}

/// One half of all numbers, without order: by a bit of their multiples of the golden ratio.
fn is_odd_one(number: usize) -> bool {
    (number as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 40 & 1 == 1
}

/// Multiplies what is one for each interval, row by row.
fn reduce(rows: &mut [f64], left: Option<&Numbers>) {
    let Some(left) = left else { return };
    for row in rows.chunks_exact_mut(left.len()) {
        row.iter_mut().zip(left).for_each(|(value, left)| *value *= left);
    }
}

/// What is said on these meshes where the right-hand side is undefined.
pub(crate) fn undefined(grids: &[Grid]) -> impl Fn(NonFinite) -> SolveError {
    |error| SolveError::Newton { error: NewtonError::NonFinite(error), intervals: intervals(grids) }
}
