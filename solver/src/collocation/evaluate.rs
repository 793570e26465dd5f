//! The residual of the collocation equations, and the derivatives at all stages.

use super::roles::Roles;
use super::stages::{Batch, Held, MOST_STAGES, Stages, View, second_order};
use super::{Iterate, Scales, System};
use crate::error::NonFinite;
use crate::linear::memory::Numbers;
use crate::linear::scalar::{Lane, Scalar, W};
use crate::linear::simd::{Job, elementwise, largest_number, vectorised};
use crate::problem::{Points, Problem, Scope};
use crate::stats::Stats;
use crate::tableau::Tableau;
use std::sync::Arc;

/// Residuals of intervals and stages, in typical magnitudes, that are due to rounding: each is a sum of a few terms.
const ROUNDED: f64 = 64.0 * f64::EPSILON;

/// Everything a residual evaluation leaves behind; reused from call to call.
#[derive(Debug, Clone)]
pub(crate) struct Work {
    pub regions: Vec<Stages>,
    pub ends: Numbers,
    pub integrals: Numbers,
    /// Boundary residuals.
    pub g: Numbers,
    /// Entries of the boundary pattern.
    pub dz: Numbers,
}

impl Work {
    /// Whether a right-hand side has been found undefined at an end, and forgiven.
    pub(crate) fn has_open_ends(&self) -> bool {
        self.regions.iter().any(|stages| stages.nodes.undefined != [false; 2])
    }
}

/// Whether derivatives are wanted, and which.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Derivatives {
    None,
    /// As the plan needs them.
    Planned,
    /// With respect to all constants.
    All,
}

impl<P: Problem + ?Sized> System<'_, P> {
    /// Memory for [`evaluate`](Self::evaluate).
    pub(crate) fn work(&self) -> Work {
        let regions = self.plan.regions.iter().zip(&self.grids).map(|(plan, grid)| {
            let batch = |stride: usize, points: usize| Batch {
                s: Numbers::unset(points),
                y: Numbers::unset(plan.n * points),
                f: Numbers::unset(plan.rows * stride),
                held: None,
                undefined: [false; 2],
                dy: Numbers::unset(plan.state_nonzeros * stride),
                dc: Numbers::unset(plan.constant_nonzeros * stride),
            };
            let (len, mut places) = (grid.interval_stride(), self.tableau.c[2..].iter());
            let inner = self.tableau.batches.iter().map(|&count| {
                let mut batch = batch(count * len, count * len);
                for (s, &c) in batch.s.chunks_exact_mut(len).zip(&mut places) {
                    elementwise(s, [&grid.s, &grid.h], |_, [s, h]| s + c * h);
                }
                batch
            });
            let inner = inner.collect();
            let psi = Numbers::unset(self.tableau.unknown_stages() * plan.n * len);
            let (nodes, phi) = (batch(grid.node_stride(), 0), Numbers::unset(plan.n * len));
            Stages { nodes, inner, phi, psi, chained: Vec::new(), roles: Arc::default() }
        });
        Work {
            regions: regions.collect(),
            ends: Numbers::zeros(self.layout.ends()),
            integrals: Numbers::zeros(self.layout.integrals()),
            g: Numbers::zeros(self.layout.equations.len()),
            dz: Numbers::zeros(self.layout.boundary_pattern.len()),
        }
    }

    /// Residual at `x`, with derivatives if wanted.
    ///
    /// # Errors
    /// The first value that is not finite.
    pub(crate) fn evaluate(
        &self,
        x: &Iterate,
        derivatives: Derivatives,
        work: &mut Work,
        stats: &mut Stats,
    ) -> Result<(), NonFinite> {
        for region in 0..self.grids.len() {
            self.evaluate_region(region, x, derivatives, work, stats)?;
            self.residuals(region, x, &mut work.regions[region]);
        }
        if derivatives == Derivatives::None {
            return self.evaluate_boundary(x, work);
        }
        let Work { ends, integrals, g, dz, .. } = work;
        self.problem.boundary_jacobian(ends, integrals, &x.constants, g, dz);
        match dz.iter().position(|value| !value.is_finite()) {
            Some(at) => Err(NonFinite::boundary_derivative(self.layout, at)),
            None => self.check_boundary(g),
        }
    }

    /// As [`evaluate`](Self::evaluate), without derivatives and without the residuals of intervals and stages.
    ///
    /// # Errors
    /// As [`evaluate`](Self::evaluate).
    pub(crate) fn evaluate_values(&self, x: &Iterate, work: &mut Work, stats: &mut Stats) -> Result<(), NonFinite> {
        for region in 0..self.grids.len() {
            self.evaluate_region(region, x, Derivatives::None, work, stats)?;
        }
        self.evaluate_boundary(x, work)
    }

    /// Whether the residuals of all intervals and stages are no larger than rounding makes them.
    pub(crate) fn is_rounded(&self, work: &Work, scales: &Scales) -> bool {
        work.regions.iter().zip(&scales.states).zip(&self.grids).all(|((stages, scales), grid)| {
            let (len, scales) = (grid.interval_stride(), scales.iter().cycle());
            let phi = stages.phi.chunks_exact(len).zip(scales.clone());
            // Written so that a NaN is none.
            phi.chain(stages.psi.chunks_exact(len).zip(scales))
                .all(|(row, scale)| largest_number(row) <= ROUNDED * scale)
        })
    }

    /// The right-hand side at the nodes alone, and the boundary equations where there are no integrals.
    ///
    /// # Errors
    /// As [`evaluate`](Self::evaluate).
    pub(crate) fn evaluate_nodes(&self, x: &Iterate, work: &mut Work, stats: &mut Stats) -> Result<(), NonFinite> {
        for (region, stages) in work.regions.iter_mut().enumerate() {
            self.call_nodes(region, x, Derivatives::None, stages, stats)?;
            self.copy_ends(region, x, &mut work.ends);
        }
        self.evaluate_boundary(x, work)
    }

    fn call_nodes(
        &self,
        region: usize,
        x: &Iterate,
        derivatives: Derivatives,
        stages: &mut Stages,
        stats: &mut Stats,
    ) -> Result<(), NonFinite> {
        let grid = &self.grids[region];
        let stride = grid.node_stride();
        let at = Points { len: stride, stride, s: &grid.s, y: &x.y[region] };
        self.call(region, at, &x.constants, derivatives, &mut stages.nodes, stats)
    }

    /// The boundary equations alone, at the ends and integrals that are held.
    pub(crate) fn evaluate_boundary(&self, x: &Iterate, work: &mut Work) -> Result<(), NonFinite> {
        let Work { ends, integrals, g, .. } = work;
        self.problem.boundary(ends, integrals, &x.constants, g);
        self.check_boundary(g)
    }

    fn check_boundary(&self, g: &[f64]) -> Result<(), NonFinite> {
        match g.iter().position(|value| !value.is_finite()) {
            Some(equation) => Err(NonFinite::boundary(self.layout, equation)),
            None => Ok(()),
        }
    }

    fn evaluate_region(
        &self,
        region: usize,
        x: &Iterate,
        derivatives: Derivatives,
        work: &mut Work,
        stats: &mut Stats,
    ) -> Result<(), NonFinite> {
        let stages = &mut work.regions[region];
        self.call_nodes(region, x, derivatives, stages, stats)?;
        if self.tableau.has_odd_parts() && derivatives != Derivatives::None {
            stages.chained = self.chained(region, &x.y[region], &stages.nodes);
        }
        let mut stage = 2;
        for index in 0..stages.inner.len() {
            // The stages of one batch depend on those before it alone, so that they can do without it.
            let mut batch = std::mem::take(&mut stages.inner[index]);
            let places = self.tableau.batches[index];
            if self.tableau.coupled {
                self.copy_inner(region, x, &mut batch.y);
            } else {
                for place in 0..places {
                    self.stage_points(region, stage + place, (&x.y[region], stages), &mut batch.y, (place, places));
                    self.add_odd_parts(region, stage + place, (&x.y[region], stages), &mut batch.y, (place, places));
                }
            }
            stage += places;
            let (s, y) = (std::mem::take(&mut batch.s), std::mem::take(&mut batch.y));
            let at = Points { len: s.len(), stride: s.len(), s: &s, y: &y };
            let outcome = self.call(region, at, &x.constants, derivatives, &mut batch, stats);
            (batch.s, batch.y) = (s, y);
            stages.inner[index] = batch;
            outcome?;
        }
        if stages.nodes.undefined != [false; 2] {
            stages.extrapolate(&self.grids[region], self.tableau, derivatives);
        }
        if self.tableau.coupled && derivatives != Derivatives::None {
            let batches = std::iter::once(&stages.nodes).chain(&stages.inner);
            let found = second_order(&self.layout.regions[region], &self.plan.regions[region], batches);
            stages.roles = Arc::new(Roles::new(self.plan.regions[region].n, &found));
        }
        self.integrate(region, work);
        self.copy_ends(region, x, &mut work.ends);
        Ok(())
    }

    /// The states at coupled inner stages, from stage by stage to component by component.
    fn copy_inner(&self, region: usize, x: &Iterate, out: &mut [f64]) {
        let (n, len) = (self.plan.regions[region].n, self.grids[region].interval_stride());
        let places = out.len() / (n * len);
        for (at, values) in x.inner[region].chunks_exact(len).enumerate() {
            let (place, i) = (at / n, at % n);
            out[(i * places + place) * len..][..len].copy_from_slice(values);
        }
    }

    /// `y_1 - y_0 - h Σ b K` of all intervals, and where inner stages are unknowns `Y - (1 - v) y_0 - v y_1 - h Σ x K`
    /// of these.
    fn residuals(&self, region: usize, x: &Iterate, stages: &mut Stages) {
        let (grid, y) = (&self.grids[region], &x.y[region]);
        let (mut phi, mut psi) = (std::mem::take(&mut stages.phi), std::mem::take(&mut stages.psi));
        let views = stages.views(grid.steps);
        let whole = Advance { y, h: &grid.h, factors: [-1.0, 1.0], sign: -1.0, place: (0, 1), out: &mut phi };
        advance(&views, self.tableau.b, whole);
        let (nodes, intervals) = (grid.node_stride(), grid.interval_stride());
        for &(u, v) in &stages.chained {
            let ends = [&y[u * nodes..][..intervals], &y[u * nodes + W..][..intervals]];
            self.integrate_twice((u, v), stages, &mut phi[u * intervals..][..intervals], ends, &grid.h);
        }
        if self.tableau.coupled {
            vectorised(StageResiduals {
                tableau: self.tableau,
                views,
                h: grid.h.as_chunks::<W>().0,
                y: y.as_chunks::<W>().0,
                inner: x.inner[region].as_chunks::<W>().0,
                out: psi.as_chunks_mut::<W>().0,
            });
        }
        (stages.phi, stages.psi) = (phi, psi);
    }

    /// See [`Stages::chained`].
    fn chained(&self, region: usize, y: &[f64], nodes: &Batch) -> Vec<(usize, usize)> {
        let stride = self.grids[region].node_stride();
        let mut found = second_order(&self.layout.regions[region], &self.plan.regions[region], std::iter::once(nodes));
        found.retain(|&(u, v)| nodes.f[u * stride..][..stride] == y[v * stride..][..stride]);
        found
    }

    /// `(1 - v) y_0 + v y_1 + h Σ x K` of one stage, all intervals, to one place of several of a batch.
    fn stage_points(
        &self,
        region: usize,
        stage: usize,
        (y, stages): (&[f64], &Stages),
        out: &mut [f64],
        place: (usize, usize),
    ) {
        let (grid, v) = (&self.grids[region], self.tableau.v[stage]);
        let whole = Advance { y, h: &grid.h, factors: [1.0 - v, v], sign: 1.0, place, out };
        advance(&stages.views(grid.steps), self.tableau.x[stage], whole);
    }

    /// See [`ODD`](crate::tableau::ODD).
    fn add_odd_parts(
        &self,
        region: usize,
        stage: usize,
        (y, stages): (&[f64], &Stages),
        out: &mut [f64],
        (place, places): (usize, usize),
    ) {
        let Some(odd) = self.tableau.odd_part(stage) else { return };
        let grid = &self.grids[region];
        let (nodes, len) = (grid.node_stride(), grid.interval_stride());
        for &(u, v) in &stages.chained {
            let (left, right) = (&y[u * nodes..][..len], &y[u * nodes + W..][..len]);
            let slope = |stage, row| stages.slope(stage, row, len);
            let inputs = [&grid.h, left, right, slope(0, u), slope(1, u), slope(0, v), slope(1, v)];
            elementwise(&mut out[(u * places + place) * len..][..len], inputs, |point, [h, u0, u1, v0, v1, k0, k1]| {
                point + odd * (12.0 * (u1 - u0) + h * (h * (k1 - k0) - 6.0 * (v0 + v1)))
            });
        }
    }

    /// The interval residuals of a state whose derivative is another: see [`ODD`](crate::tableau::ODD).
    fn integrate_twice(
        &self,
        (u, v): (usize, usize),
        stages: &Stages,
        phi: &mut [f64],
        [left, right]: [&[f64]; 2],
        h: &[f64],
    ) {
        let twice = [0, 2].map(|stage| self.tableau.twice_integrated(stage));
        let slope = |stage, row| stages.slope(stage, row, h.len());
        let [k0, k1, k2, k3] = [0, 1, 2, 3].map(|stage| slope(stage, v));
        let inputs = [left, right, slope(0, u), slope(1, u), k0, k1, k2, k3, h];
        elementwise(phi, inputs, |_, [u0, u1, v0, v1, k0, k1, k2, k3, h]| {
            u1 - u0 - h * (0.5 * (v0 + v1) + h * (twice[0] * (k0 - k1) + twice[1] * (k2 - k3)))
        });
    }

    /// The integrals that boundary equations depend on.
    fn integrate(&self, region: usize, work: &mut Work) {
        let plan = &self.plan.regions[region];
        let h = &self.grids[region].h;
        let mut sums = Numbers::unset(if plan.active.is_empty() { 0 } else { h.len() });
        for &integral in &plan.active {
            sums.fill(0.0);
            add_slopes(self.tableau.b, &work.regions[region], plan.n + integral, &mut sums);
            work.integrals[plan.first_integral + integral] = sums.iter().zip(h).map(|(sum, h)| sum * h).sum();
        }
    }

    /// Integrals over each interval, `k * interval_stride`, from the last evaluation.
    pub(crate) fn interval_integrals(&self, region: usize, stages: &Stages) -> Vec<f64> {
        let plan = &self.plan.regions[region];
        let h = &self.grids[region].h;
        let mut out = vec![0.0; (plan.rows - plan.n) * h.len()];
        for (k, sums) in out.chunks_exact_mut(h.len()).enumerate() {
            add_slopes(self.tableau.b, stages, plan.n + k, sums);
            elementwise(sums, [h], |sum, [h]| sum * h);
        }
        out
    }

    fn copy_ends(&self, region: usize, x: &Iterate, ends: &mut [f64]) {
        let plan = &self.plan.regions[region];
        let grid = &self.grids[region];
        for i in 0..plan.n {
            ends[plan.first_end + i] = x.y[region][i * grid.node_stride()];
            ends[plan.first_end + plan.n + i] = x.y[region][i * grid.node_stride() + grid.last()];
        }
    }

    fn call(
        &self,
        region: usize,
        at: Points<'_>,
        constants: &[f64],
        derivatives: Derivatives,
        batch: &mut Batch,
        stats: &mut Stats,
    ) -> Result<(), NonFinite> {
        let scope = match derivatives {
            Derivatives::None if batch.held.is_some() => {
                self.follow(region, &at, constants, batch);
                return self.check_values(region, &at, &batch.f);
            }
            Derivatives::None => {
                stats.rhs_points += at.len;
                self.problem.rhs(region, &at, constants, &mut batch.f);
                let undefined = self.forgiven(region, &at, &mut batch.f)?;
                batch.note_undefined(undefined);
                return Ok(());
            }
            Derivatives::Planned => self.plan.regions[region].scope,
            Derivatives::All => Scope::All,
        };
        stats.jacobian_points += at.len;
        batch.held = None;
        self.problem.rhs_jacobian(region, &at, constants, scope, &mut batch.f, &mut batch.dy, &mut batch.dc);
        // What the scope leaves out has not been written.
        let pattern = &self.layout.regions[region];
        let entries = if scope == Scope::All { pattern.constant_pattern.len() } else { pattern.default_entries };
        let by_constants = &mut batch.dc[..entries * at.stride];
        let undefined = self.forgive_ends(region, &at, [&mut batch.f, &mut batch.dy, by_constants]);
        batch.note_undefined(undefined);
        self.check_values(region, &at, &batch.f)?;
        if !finite(&batch.dy) {
            return Err(NonFinite::derivative(self.layout, region, &at, &batch.dy));
        }
        if self.linear {
            batch.held = Some(Held::at(at.y, constants));
        }
        Ok(())
    }

    /// Values of which those at an end are forgiven that are not finite there: whether they are so at the left and at
    /// the right end.
    ///
    /// # Errors
    /// As [`check_values`](Self::check_values), of what is not forgiven.
    pub(super) fn forgiven(&self, region: usize, at: &Points<'_>, f: &mut [f64]) -> Result<[bool; 2], NonFinite> {
        if finite(f) {
            return Ok([false; 2]);
        }
        let undefined = self.forgive_ends(region, at, [&mut *f]);
        self.check_values(region, at, f).map(|()| undefined)
    }

    /// # Errors
    /// Names the first row and point that are not finite.
    pub(crate) fn check_values(&self, region: usize, at: &Points<'_>, f: &[f64]) -> Result<(), NonFinite> {
        if finite(f) { Ok(()) } else { Err(NonFinite::value(self.layout, region, at, f)) }
    }
}

/// Of numbers, as many as are a multiple of `W`.
pub(super) fn finite(values: &[f64]) -> bool {
    vectorised(Finite(values.as_chunks::<W>().0))
}

struct Finite<'a>(&'a [[f64; W]]);

impl Job for Finite<'_> {
    type Output = bool;

    #[inline(always)]
    fn run(self) -> bool {
        // x * 0 is 0 for a finite x and NaN otherwise.
        let mut sums = [Lane::ZERO; 2];
        let (pairs, last) = self.0.as_chunks::<2>();
        for pair in pairs {
            sums[0] += Lane(pair[0]).times(0.0);
            sums[1] += Lane(pair[1]).times(0.0);
        }
        for lane in last {
            sums[0] += Lane(*lane).times(0.0);
        }
        (sums[0] + sums[1]).0.iter().sum::<f64>() == 0.0
    }
}

fn add_slopes(weights: &[f64], stages: &Stages, row: usize, out: &mut [f64]) {
    for (stage, &weight) in weights.iter().enumerate() {
        if weight != 0.0 {
            let slopes = stages.slope(stage, row, out.len());
            elementwise(out, [slopes], |out, [slope]| out + weight * slope);
        }
    }
}

/// What the states at coupled inner stages lack of what the slopes say.
struct StageResiduals<'a> {
    tableau: &'static Tableau,
    views: [View<'a>; MOST_STAGES],
    h: &'a [[f64; W]],
    /// At the nodes, component by component.
    y: &'a [[f64; W]],
    /// At the inner stages, stage by stage.
    inner: &'a [[f64; W]],
    out: &'a mut [[f64; W]],
}

impl Job for StageResiduals<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self { tableau, views, h, y, inner, out } = self;
        let (steps, n) = (h.len(), y.len() / (h.len() + 1));
        for (stage, out) in out.chunks_exact_mut(n * steps).enumerate() {
            let v = tableau.v[stage + 2];
            let mut weights = [0.0; MOST_STAGES];
            weights.copy_from_slice(tableau.x[stage + 2]);
            for (i, out) in out.chunks_exact_mut(steps).enumerate() {
                let (y, inner) = (&y[i * (steps + 1)..][..steps + 1], &inner[(stage * n + i) * steps..][..steps]);
                let mut slopes: [&[[f64; W]]; MOST_STAGES] = [&[]; MOST_STAGES];
                slopes.iter_mut().zip(&views).for_each(|(slopes, view)| *slopes = view.row(i, steps));
                for t in 0..steps {
                    let mut sum = Lane::ZERO;
                    for (slopes, weight) in slopes.iter().zip(weights) {
                        sum += Lane(slopes[t]).times(weight);
                    }
                    let ends = Lane(y[t]).times(1.0 - v) + Lane(y[t + 1]).times(v);
                    out[t] = (Lane(inner[t]) - (ends + Lane(h[t]) * sum)).0;
                }
            }
        }
    }
}

/// What [`advance`] makes of the slopes.
struct Advance<'a> {
    /// At the nodes, component by component.
    y: &'a [f64],
    h: &'a [f64],
    /// Of both nodes.
    factors: [f64; 2],
    sign: f64,
    /// Which place of how many `out` has for each component.
    place: (usize, usize),
    out: &'a mut [f64],
}

/// `factors · (y_0, y_1) + sign h Σ w K` of all components, all intervals, at once.
fn advance(views: &[View<'_>; MOST_STAGES], weights: &[f64], advance: Advance<'_>) {
    let (mut used, mut count) = ([(0, 0.0); MOST_STAGES], 0);
    for (stage, &weight) in weights.iter().enumerate().filter(|(_, weight)| **weight != 0.0) {
        used[count] = (stage, weight);
        count += 1;
    }
    match count {
        2 => vectorised(Sum { advance, views, used: [used[0], used[1]] }),
        3 => vectorised(Sum { advance, views, used: [used[0], used[1], used[2]] }),
        4 => vectorised(Sum { advance, views, used: [used[0], used[1], used[2], used[3]] }),
        _ => vectorised(Sum { advance, views, used }),
    }
}

struct Sum<'a, const S: usize> {
    advance: Advance<'a>,
    views: &'a [View<'a>; MOST_STAGES],
    /// Stages and their weights; fewer are filled up by the first node's, with the weight 0.
    used: [(usize, f64); S],
}

impl<const S: usize> Job for Sum<'_, S> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Advance { y, h, factors, sign, place: (place, places), out } = self.advance;
        let (y, h, out) = (y.as_chunks::<W>().0, h.as_chunks::<W>().0, out.as_chunks_mut::<W>().0);
        let steps = h.len();
        for (i, out) in out.chunks_exact_mut(places * steps).enumerate() {
            let out = &mut out[place * steps..][..steps];
            let y = &y[i * (steps + 1)..][..steps + 1];
            let mut slopes: [&[[f64; W]]; S] = [&[]; S];
            for (slopes, (stage, _)) in slopes.iter_mut().zip(&self.used) {
                *slopes = self.views[*stage].row(i, steps);
            }
            for t in 0..steps {
                let mut sum = Lane::ZERO;
                for (slopes, (_, weight)) in slopes.iter().zip(&self.used) {
                    sum += Lane(slopes[t]).times(*weight);
                }
                let ends = Lane(y[t]).times(factors[0]) + Lane(y[t + 1]).times(factors[1]);
                out[t] = (ends + Lane(h[t]).times(sign) * sum).0;
            }
        }
    }
}
