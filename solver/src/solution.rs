//! A converged solution: values, continuous extension, integrals, and what it cost.

use crate::accuracy::Accuracy;
use crate::basis::Basis;
use crate::collocation::evaluate::Work;
use crate::collocation::interpolant::Extension;
use crate::collocation::{Iterate, System};
use crate::options::Order;
use crate::orientation::{BranchCheck, Orientation};
use crate::problem::{Layout, Problem};
use crate::rows::Rows;
use crate::stats::Stats;

/// One region of a [`Solution`].
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(into = "crate::serialised::Region", try_from = "crate::serialised::Region"))]
pub struct RegionSolution {
    pub(crate) mesh: Vec<f64>,
    /// State by state, at the nodes.
    pub(crate) y: Rows,
    /// Right-hand sides at the nodes.
    pub(crate) f: Rows,
    /// Coefficients of the continuous extension, α to δ, one an interval; γ and δ are empty below order 8.
    pub(crate) extension: [Rows; 4],
    pub(crate) integrals: Vec<f64>,
    /// Integral by integral, from the start of the region to each node.
    pub(crate) cumulative: Rows,
    /// The largest relative defect of each interval; empty where none is known.
    pub(crate) defects: Vec<f64>,
}

impl RegionSolution {
    /// `defects`: the largest of each interval; none where they are not known. `errors`: what is to be taken off the
    /// integrals over each interval, a row an integral, in working order.
    pub(crate) fn new<P: Problem + ?Sized>(
        system: &System<'_, P>,
        region: usize,
        (x, work): (&Iterate, &Work),
        (extension, defects): (&Extension, &[f64]),
        errors: Option<&Rows>,
    ) -> Self {
        let (grid, plan) = (&system.grids[region], &system.plan.regions[region]);
        let (stages, nodes) = (&work.regions[region], plan.n * grid.node_stride());
        let mut parts = system.interval_integrals(region, stages);
        let errors = errors.into_iter().flat_map(Rows::iter).flatten();
        parts.iter_mut().zip(errors).for_each(|(part, error)| *part -= error);
        let parts = grid.unpack_intervals(&parts);
        let mut cumulative = Vec::with_capacity(parts.len() * grid.mesh.len());
        for parts in parts.iter() {
            let mut sum = 0.0;
            cumulative.push(sum);
            for part in parts {
                sum += part;
                cumulative.push(sum);
            }
        }
        let cumulative = Rows::new(cumulative, grid.mesh.len());
        let Extension { alpha, beta, gamma, delta } = extension;
        Self {
            mesh: grid.mesh.clone(),
            y: grid.unpack(&x.y[region][..nodes]),
            f: grid.unpack(&stages.nodes.f[..nodes]),
            extension: [alpha, beta, gamma, delta].map(|values| grid.unpack_intervals(values)),
            integrals: cumulative.iter().filter_map(|sums| sums.last().copied()).collect(),
            cumulative,
            defects: defects.to_vec(),
        }
    }

    /// The `N + 1` nodes.
    pub fn mesh(&self) -> &[f64] {
        &self.mesh
    }

    /// Number of intervals.
    pub fn intervals(&self) -> usize {
        self.mesh.len() - 1
    }

    /// Number of states.
    pub fn states(&self) -> usize {
        self.y.len()
    }

    /// State `i` at the nodes; empty if there is no such state.
    pub fn state(&self, i: usize) -> &[f64] {
        self.y.row(i)
    }

    /// Derivative of state `i` at the nodes; empty if there is no such state.
    pub fn slope(&self, i: usize) -> &[f64] {
        self.f.row(i)
    }

    /// Integrals over the region.
    pub fn integrals(&self) -> &[f64] {
        &self.integrals
    }

    /// Integral `k` from the region's start to each node; empty if there is no such integral.
    pub fn cumulative(&self, k: usize) -> &[f64] {
        self.cumulative.row(k)
    }

    /// States at `s`, by the continuous extension; outside the region the last polynomial goes on. Writes as many
    /// states as `y` has room for.
    pub fn eval_into(&self, s: f64, y: &mut [f64]) {
        let (j, h, sigma) = self.locate(s);
        let basis = Basis::value(sigma);
        for (i, y) in y.iter_mut().enumerate().take(self.states()) {
            *y = self.component(i).piece(j).at(&basis, h);
        }
    }

    /// States at `s`: see [`eval_into`](Self::eval_into).
    pub fn eval(&self, s: f64) -> Vec<f64> {
        let mut y = vec![0.0; self.states()];
        self.eval_into(s, &mut y);
        y
    }

    /// Derivatives of the states at `s`, of the continuous extension.
    pub fn eval_slope(&self, s: f64) -> Vec<f64> {
        let (j, h, sigma) = self.locate(s);
        let basis = Basis::slope(sigma);
        (0..self.states()).map(|i| self.component(i).piece(j).combine(&basis, h) / h).collect()
    }

    /// Second derivatives of the states at `s`, of the continuous extension; they jump at nodes, where those of the
    /// interval to the right are given. One order less accurate than [`eval_slope`](Self::eval_slope).
    pub fn eval_curvature(&self, s: f64) -> Vec<f64> {
        let (j, h, sigma) = self.locate(s);
        let basis = Basis::curvature(sigma);
        (0..self.states()).map(|i| self.component(i).piece(j).combine(&basis, h) / (h * h)).collect()
    }

    /// The largest defect of each interval, relative to the right-hand side: what the tolerance is held against (see
    /// [`Solution::max_defect`]). Where the right-hand side has a kink, one may exceed it on an interval so short that
    /// its integral is small. Empty where they are not known, as of a solution read from a file without them.
    pub fn defects(&self) -> &[f64] {
        &self.defects
    }

    /// States at many places, state by state: value `i * s.len() + j` is that of state `i` at `s[j]`. As
    /// [`eval_into`](Self::eval_into) for each place, to the same bits, and many times as fast where places increase.
    pub fn eval_many(&self, s: &[f64]) -> Vec<f64> {
        self.at_places(&self.places(s))
    }

    /// The same.
    pub(crate) fn at_places(&self, places: &[Place]) -> Vec<f64> {
        let mut values = vec![0.0; self.states() * places.len()];
        for (i, values) in values.chunks_exact_mut(places.len().max(1)).enumerate() {
            self.component(i).write(places, values);
        }
        values
    }

    /// State `i` at many places: as [`eval_many`](Self::eval_many), to the same bits. Empty if there is no such state.
    pub fn eval_state(&self, i: usize, s: &[f64]) -> Vec<f64> {
        if i >= self.states() {
            return Vec::new();
        }
        let mut values = vec![0.0; s.len()];
        self.component(i).write(&self.places(s), &mut values);
        values
    }

    /// The same, each state by itself.
    pub(crate) fn eval_along(&self, mesh: &[f64]) -> Vec<Vec<f64>> {
        let places = self.places(mesh);
        let along = |component: Component<'_>| {
            let mut values = vec![0.0; mesh.len()];
            component.write(&places, &mut values);
            values
        };
        (0..self.states()).map(|i| along(self.component(i))).collect()
    }

    /// Intervals, their lengths, and the weights of what stands there, for places in any order.
    pub(crate) fn places(&self, s: &[f64]) -> Vec<Place> {
        let mut nodes = self.nodes_before();
        let place = |&s: &f64| {
            let (interval, h, sigma) = self.place(nodes(s), s);
            Place { interval, h, sigma, basis: Basis::value(sigma) }
        };
        s.iter().map(place).collect()
    }

    /// Nodes at or before a place: counted on from those of the last, unless this one lies before it.
    fn nodes_before(&self) -> impl FnMut(f64) -> usize {
        let mut after = 0;
        move |s: f64| {
            if self.mesh[..after].last().is_some_and(|node| !(*node <= s)) {
                after = self.mesh.partition_point(|&node| node <= s);
            } else {
                after += self.mesh[after..].iter().take_while(|&&node| node <= s).count();
            }
            after
        }
    }

    /// Interval, its length, and the place in it.
    fn locate(&self, s: f64) -> (usize, f64, f64) {
        self.place(self.mesh.partition_point(|&node| node <= s), s)
    }

    /// The same, for a place behind so many nodes.
    fn place(&self, after: usize, s: f64) -> (usize, f64, f64) {
        let j = after.saturating_sub(1).min(self.mesh.len() - 2);
        let h = self.mesh[j + 1] - self.mesh[j];
        (j, h, (s - self.mesh[j]) / h)
    }

    fn component(&self, i: usize) -> Component<'_> {
        let extension = self.extension.each_ref().map(|rows| rows.row(i));
        Component { y: self.y.row(i), f: self.f.row(i), extension }
    }
}

/// What is known of one state.
struct Component<'a> {
    y: &'a [f64],
    f: &'a [f64],
    extension: [&'a [f64]; 4],
}

/// A place in its interval.
pub(crate) struct Place {
    pub interval: usize,
    /// The interval's length.
    h: f64,
    /// From 0 at the interval's start to 1 at its end.
    pub sigma: f64,
    basis: Basis,
}

/// What is known of one state on one interval.
struct Piece {
    y: [f64; 2],
    f: [f64; 2],
    /// Coefficients α and β of the extension.
    quintic: [f64; 2],
    /// Coefficients γ and δ, at order 8.
    further: Option<[f64; 2]>,
}

impl Component<'_> {
    /// On interval `j`.
    #[inline]
    fn piece(&self, j: usize) -> Piece {
        let Self { y, f, extension: [alpha, beta, gamma, delta] } = self;
        Piece {
            y: [y[j], y[j + 1]],
            f: [f[j], f[j + 1]],
            quintic: [alpha[j], beta[j]],
            further: gamma.get(j).zip(delta.get(j)).map(|(gamma, delta)| [*gamma, *delta]),
        }
    }

    /// Writes its values at some places.
    fn write(&self, places: &[Place], values: &mut [f64]) {
        let Some(first) = places.first() else { return };
        // Of many places in any order, what a piece is made of is put together once.
        if places.len() > self.y.len() {
            let pieces: Vec<Piece> = (0..self.y.len() - 1).map(|j| self.piece(j)).collect();
            for (value, place) in values.iter_mut().zip(places) {
                *value = pieces[place.interval].at(&place.basis, place.h);
            }
            return;
        }
        let (mut interval, mut piece) = (first.interval, self.piece(first.interval));
        for (value, place) in values.iter_mut().zip(places) {
            if place.interval != interval {
                (interval, piece) = (place.interval, self.piece(place.interval));
            }
            *value = piece.at(&place.basis, place.h);
        }
    }
}

impl Piece {
    /// Its value, `h` being the interval's length.
    #[inline]
    fn at(&self, basis: &Basis, h: f64) -> f64 {
        self.y[0] + self.combine(basis, h)
    }

    /// The weighted sum of a basis, without `y_0`.
    #[inline]
    fn combine(&self, basis: &Basis, h: f64) -> f64 {
        let Self { y, f, quintic: [alpha, beta], further } = self;
        let quintic = basis.rise * (y[1] - y[0])
            + h * (basis.left * f[0] + basis.right * f[1])
            + basis.alpha * alpha
            + basis.beta * beta;
        match further {
            Some([gamma, delta]) => quintic + basis.gamma * gamma + basis.delta * delta,
            None => quintic,
        }
    }
}

/// One mesh of a solve.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct MeshRecord {
    /// Intervals of each region.
    pub intervals: Vec<usize>,
    /// Largest defect of each region on that mesh; infinite if Newton's iteration failed. On a rough mesh of order 8 it
    /// is that of the collocation polynomial, which is larger than that of the extension.
    #[cfg_attr(feature = "serde", serde(with = "crate::serialised::defects"))]
    pub defects: Vec<f64>,
    /// Newton iterations on it.
    pub newton_iterations: usize,
}

/// What [`solve`](crate::solve()) found.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Solution {
    pub(crate) regions: Vec<RegionSolution>,
    pub(crate) constants: Vec<f64>,
    pub(crate) unknowns: Vec<usize>,
    pub(crate) order: Order,
    #[cfg_attr(feature = "serde", serde(with = "crate::serialised::estimate"))]
    pub(crate) max_defect: f64,
    #[cfg_attr(feature = "serde", serde(with = "crate::serialised::estimate"))]
    pub(crate) max_boundary_residual: f64,
    #[cfg_attr(feature = "serde", serde(with = "crate::serialised::estimate"))]
    pub(crate) error_estimate: f64,
    pub(crate) accuracy: Accuracy,
    #[cfg_attr(feature = "serde", serde(default))]
    pub(crate) corrected: bool,
    pub(crate) orientation: Option<Orientation>,
    pub(crate) branch_check: BranchCheck,
    pub(crate) stats: Stats,
    pub(crate) history: Vec<MeshRecord>,
}

impl Solution {
    /// The regions, in the layout's order.
    pub fn regions(&self) -> &[RegionSolution] {
        &self.regions
    }

    /// All constants, given and found.
    pub fn constants(&self) -> &[f64] {
        &self.constants
    }

    /// Which constants were unknown: indices into the layout's constants.
    pub fn unknowns(&self) -> &[usize] {
        &self.unknowns
    }

    /// Order of the method.
    pub fn order(&self) -> Order {
        self.order
    }

    /// Largest defect over all intervals, as held to the tolerance: per interval the root mean square of
    /// `|S' - f| ℓ / (Y + F ℓ)`, largest over states, with Y the state's typical magnitude, ℓ the region's length, and
    /// F the size of the right-hand side's terms, `max(|f|, Σ |∂f/∂y| |y|)`; intervals whose defects together cannot
    /// move a state by more than the tolerance are counted by that movement instead.
    pub fn max_defect(&self) -> f64 {
        self.max_defect
    }

    /// Largest boundary residual, each relative to the largest term of its equation.
    pub fn max_boundary_residual(&self) -> f64 {
        self.max_boundary_residual
    }

    /// Estimated true error at the nodes and in the constants found, and what quadrature adds to those of the
    /// integrals; largest component relative to typical magnitudes. To first order, from the defects and the linearised
    /// equations.
    pub fn error_estimate(&self) -> f64 {
        self.error_estimate
    }

    /// Whether [`error_estimate`](Self::error_estimate) meets the tolerance, and if not why.
    pub fn accuracy(&self) -> Accuracy {
        self.accuracy
    }

    /// Whether the estimated error has been taken off the solution: see
    /// [`Options::defect_correction`](crate::Options::defect_correction). Its defects and
    /// [`error_estimate`](Self::error_estimate) are those from before.
    pub fn is_corrected(&self) -> bool {
        self.corrected
    }

    /// Sign of the determinant of the problem linearised there; none if that is singular or not known.
    pub fn orientation(&self) -> Option<Orientation> {
        self.orientation
    }

    /// Whether this is known to be the solution that the guess leads to, where the problem has several; after a
    /// continuation, the one that the start of the path leads to.
    pub fn branch_check(&self) -> BranchCheck {
        self.branch_check
    }

    /// What it cost.
    pub fn stats(&self) -> &Stats {
        &self.stats
    }

    /// The meshes it took, the last being the solution's.
    pub fn history(&self) -> &[MeshRecord] {
        &self.history
    }

    /// Intervals of all regions.
    pub fn intervals(&self) -> usize {
        self.regions.iter().map(RegionSolution::intervals).sum()
    }

    /// Of a problem with one more integral in each region and more constants, the part that belongs to `layout`; the
    /// orientation does not.
    pub(crate) fn restricted(mut self, layout: &Layout, unknowns: &[usize]) -> Self {
        for (region, inner) in self.regions.iter_mut().zip(&layout.regions) {
            region.integrals.truncate(inner.integrals.len());
            region.cumulative.truncate(inner.integrals.len());
        }
        self.constants.truncate(layout.constants.len());
        self.unknowns = unknowns.to_vec();
        self.orientation = None;
        self
    }
}
