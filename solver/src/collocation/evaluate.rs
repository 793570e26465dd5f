//! The residual of the collocation equations, and the derivatives at all stages.

use super::{Iterate, System};
use crate::error::NonFinite;
use crate::linear::memory::Numbers;
use crate::linear::scalar::{Lane, Scalar, W};
use crate::linear::simd::{Job, elementwise, vectorised};
use crate::problem::{Points, Problem, Scope};
use crate::stats::Stats;

/// Values of one batch of points.
#[derive(Debug, Clone, Default)]
pub(crate) struct Batch {
    pub s: Numbers,
    pub y: Numbers,
    /// Right-hand side and integrands.
    pub f: Numbers,
    pub dy: Numbers,
    pub dc: Numbers,
}

/// Values of one region at all its stages.
#[derive(Debug, Clone)]
pub(crate) struct Stages {
    /// Stages 0 and 1 (`s` and `y` unused: they are the grid's and the iterate's).
    pub nodes: Batch,
    /// Stages 2, 3, ...
    pub inner: Vec<Batch>,
    /// Interval residuals `y_1 - y_0 - h Σ b K`, `n * interval_stride`.
    pub phi: Numbers,
    /// Residuals of the stage equations, as [`Iterate::inner`] stands; empty if that is.
    pub psi: Numbers,
    /// States whose derivative is another state and nothing else, with that state: at all nodes where derivatives were
    /// last evaluated. Only at order 6: see [`ODD`](crate::tableau::ODD).
    pub chained: Vec<(usize, usize)>,
    /// The same for coupled inner stages, as far as the derivatives at all nodes and stages say: see
    /// [`Role`](super::coupled::Role).
    pub second_order: Vec<(usize, usize)>,
}

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

/// Whether derivatives are wanted, and which.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Derivatives {
    None,
    /// As the plan needs them.
    Planned,
    /// With respect to all constants.
    All,
}

impl Stages {
    /// Slopes of one stage and row, one an interval.
    #[inline]
    pub(crate) fn slope(&self, stage: usize, row: usize, intervals: usize) -> &[f64] {
        match stage {
            0 => &self.nodes.f[row * (intervals + W)..][..intervals],
            1 => &self.nodes.f[row * (intervals + W) + W..][..intervals],
            _ => &self.inner[stage - 2].f[row * intervals..][..intervals],
        }
    }

    /// Slopes of all stages, in vectors.
    pub(crate) fn slopes(&self, steps: usize) -> Slopes<'_> {
        let nodes = self.nodes.f.as_chunks::<W>().0;
        let mut stages = [(nodes, steps + 1); MOST_STAGES];
        stages[1].0 = &nodes[1..];
        for (stage, batch) in stages[2..].iter_mut().zip(&self.inner) {
            *stage = (batch.f.as_chunks::<W>().0, steps);
        }
        Slopes { stages }
    }
}

/// Slopes of all stages, a vector of intervals at a time.
#[derive(Clone, Copy)]
pub(crate) struct Slopes<'a> {
    /// With the number of vectors a row.
    stages: [(&'a [[f64; W]], usize); MOST_STAGES],
}

impl Slopes<'_> {
    /// That of one row at one stage of interval `t` of every stretch.
    #[inline(always)]
    pub(crate) fn of(&self, stage: usize, row: usize, t: usize) -> Lane {
        let (values, steps) = self.stages[stage];
        Lane(values[row * steps + t])
    }
}

impl<P: Problem + ?Sized> System<'_, P> {
    /// Memory for [`evaluate`](Self::evaluate).
    pub(crate) fn work(&self) -> Work {
        let regions = self.plan.regions.iter().zip(&self.grids).map(|(plan, grid)| {
            let batch = |stride: usize, own_points: bool| Batch {
                s: Numbers::zeros(if own_points { stride } else { 0 }),
                y: Numbers::zeros(if own_points { plan.n * stride } else { 0 }),
                f: Numbers::zeros(plan.rows * stride),
                dy: Numbers::zeros(plan.state_nonzeros * stride),
                dc: Numbers::zeros(plan.constant_nonzeros * stride),
            };
            let stride = grid.interval_stride();
            let at = |c: f64| {
                let mut batch = batch(stride, true);
                elementwise(&mut batch.s, [&grid.s, &grid.h], |_, [s, h]| s + c * h);
                batch
            };
            let inner = self.tableau.c[2..].iter().map(|&c| at(c)).collect();
            let psi = Numbers::zeros(self.tableau.unknown_stages() * plan.n * stride);
            let (nodes, phi) = (batch(grid.node_stride(), false), Numbers::zeros(plan.n * stride));
            Stages { nodes, inner, phi, psi, chained: Vec::new(), second_order: Vec::new() }
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
            self.evaluate_region(region, x, derivatives, &mut work.regions[region], stats)?;
            self.integrate(region, work);
            self.copy_ends(region, x, &mut work.ends);
        }
        let Work { ends, integrals, g, dz, .. } = work;
        if derivatives == Derivatives::None {
            self.problem.boundary(ends, integrals, &x.constants, g);
        } else {
            self.problem.boundary_jacobian(ends, integrals, &x.constants, g, dz);
            if let Some(at) = dz.iter().position(|value| !value.is_finite()) {
                return Err(NonFinite::boundary_derivative(self.layout, at));
            }
        }
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
        stages: &mut Stages,
        stats: &mut Stats,
    ) -> Result<(), NonFinite> {
        let grid = &self.grids[region];
        let stride = grid.node_stride();
        let at = Points { len: stride, stride, s: &grid.s, y: &x.y[region] };
        self.call(region, at, &x.constants, derivatives, &mut stages.nodes, stats)?;
        if self.tableau.has_odd_parts() && derivatives != Derivatives::None {
            stages.chained = self.chained(region, &x.y[region], &stages.nodes);
        }
        for stage in 2..self.tableau.stages() {
            let mut batch = std::mem::take(&mut stages.inner[stage - 2]);
            let stride = grid.interval_stride();
            if self.tableau.coupled {
                let first = (stage - 2) * batch.y.len();
                let len = batch.y.len();
                batch.y.copy_from_slice(&x.inner[region][first..first + len]);
            } else {
                self.stage_points(region, stage, &x.y[region], stages, &mut batch.y);
                self.add_odd_parts(region, stage, &x.y[region], stages, &mut batch.y);
            }
            let (s, y) = (std::mem::take(&mut batch.s), std::mem::take(&mut batch.y));
            let at = Points { len: stride, stride, s: &s, y: &y };
            let outcome = self.call(region, at, &x.constants, derivatives, &mut batch, stats);
            (batch.s, batch.y) = (s, y);
            stages.inner[stage - 2] = batch;
            outcome?;
        }
        self.interval_residuals(region, &x.y[region], stages);
        if self.tableau.coupled {
            self.stage_residuals(region, x, stages);
            if derivatives != Derivatives::None {
                let batches: Vec<&Batch> = std::iter::once(&stages.nodes).chain(&stages.inner).collect();
                stages.second_order = self.second_order(region, &batches);
            }
        }
        Ok(())
    }

    /// `Y - (1 - v) y_0 - v y_1 - h Σ x K` of all inner stages.
    fn stage_residuals(&self, region: usize, x: &Iterate, stages: &mut Stages) {
        let len = stages.phi.len();
        let mut psi = std::mem::take(&mut stages.psi);
        for (stage, out) in psi.chunks_exact_mut(len).enumerate() {
            self.stage_points(region, stage + 2, &x.y[region], stages, out);
            elementwise(out, [&x.inner[region][stage * len..]], |point, [y]| y - point);
        }
        stages.psi = psi;
    }

    /// See [`Stages::chained`].
    fn chained(&self, region: usize, y: &[f64], nodes: &Batch) -> Vec<(usize, usize)> {
        let stride = self.grids[region].node_stride();
        let mut found = self.second_order(region, &[nodes]);
        found.retain(|&(u, v)| nodes.f[u * stride..][..stride] == y[v * stride..][..stride]);
        found
    }

    /// States whose derivative depends on another state alone, with slope 1, as the derivatives in the batches say; no
    /// two on the same.
    fn second_order(&self, region: usize, batches: &[&Batch]) -> Vec<(usize, usize)> {
        let layout = &self.layout.regions[region];
        let are = |of: fn(&Batch) -> &[f64], entry: usize, count: usize, value: f64| {
            batches.iter().all(|batch| {
                let stride = of(batch).len() / count;
                of(batch)[entry * stride..][..stride].iter().all(|found| *found == value)
            })
        };
        let (states, constants) = (&layout.state_pattern, &layout.constant_pattern);
        let by_state = |entry: usize, value: f64| are(|batch| &batch.dy, entry, states.len(), value);
        let by_constant = |entry: usize| are(|batch| &batch.dc, entry, constants.len(), 0.0);
        // The only argument that a row depends on, if that is another state, with slope 1.
        let only = |row: usize| {
            let of_row = |(_, at): &(usize, &(usize, usize))| at.0 == row;
            let mut arguments = states.iter().enumerate().filter(of_row).filter(|(entry, _)| !by_state(*entry, 0.0));
            let (entry, &(_, state)) = arguments.next()?;
            let mut constants = constants.iter().enumerate().filter(of_row);
            let alone = arguments.next().is_none() && constants.all(|(entry, _)| by_constant(entry));
            (alone && state != row && by_state(entry, 1.0)).then_some(state)
        };
        let mut found: Vec<(usize, usize)> = Vec::new();
        for u in 0..self.plan.regions[region].n {
            if let Some(v) = only(u)
                && found.iter().all(|&(_, other)| other != v)
            {
                found.push((u, v));
            }
        }
        found
    }

    /// `(1 - v) y_0 + v y_1 + h Σ x K` of one stage, all intervals.
    fn stage_points(&self, region: usize, stage: usize, y: &[f64], stages: &Stages, out: &mut [f64]) {
        let (grid, v) = (&self.grids[region], self.tableau.v[stage]);
        let slopes = stages.slopes(grid.steps);
        advance(&slopes, self.tableau.x[stage], Advance { y, h: &grid.h, factors: [1.0 - v, v], sign: 1.0, out });
    }

    /// `y_1 - y_0 - h Σ b K`.
    fn interval_residuals(&self, region: usize, y: &[f64], stages: &mut Stages) {
        let grid = &self.grids[region];
        let mut phi = std::mem::take(&mut stages.phi);
        let slopes = stages.slopes(grid.steps);
        let whole = Advance { y, h: &grid.h, factors: [-1.0, 1.0], sign: -1.0, out: &mut phi };
        advance(&slopes, self.tableau.b, whole);
        let (nodes, intervals) = (grid.node_stride(), grid.interval_stride());
        for &(u, v) in &stages.chained {
            let ends = [&y[u * nodes..][..intervals], &y[u * nodes + W..][..intervals]];
            self.integrate_twice((u, v), stages, &mut phi[u * intervals..][..intervals], ends, &grid.h);
        }
        stages.phi = phi;
    }

    /// See [`ODD`](crate::tableau::ODD).
    fn add_odd_parts(&self, region: usize, stage: usize, y: &[f64], stages: &Stages, out: &mut [f64]) {
        let Some(odd) = self.tableau.odd_part(stage) else { return };
        let grid = &self.grids[region];
        let (nodes, len) = (grid.node_stride(), grid.interval_stride());
        for &(u, v) in &stages.chained {
            let (left, right) = (&y[u * nodes..][..len], &y[u * nodes + W..][..len]);
            let slope = |stage, row| stages.slope(stage, row, len);
            let inputs = [&grid.h, left, right, slope(0, u), slope(1, u), slope(0, v), slope(1, v)];
            elementwise(&mut out[u * len..][..len], inputs, |point, [h, u0, u1, v0, v1, k0, k1]| {
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

    fn integrate(&self, region: usize, work: &mut Work) {
        let plan = &self.plan.regions[region];
        if plan.n == plan.rows {
            return;
        }
        let h = &self.grids[region].h;
        let mut sums = vec![0.0; h.len()];
        for row in plan.n..plan.rows {
            sums.fill(0.0);
            add_slopes(self.tableau.b, &work.regions[region], row, &mut sums);
            work.integrals[plan.first_integral + row - plan.n] = sums.iter().zip(h).map(|(sum, h)| sum * h).sum();
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
            Derivatives::None => {
                stats.rhs_points += at.len;
                self.problem.rhs(region, &at, constants, &mut batch.f);
                return self.check_values(region, &at, &batch.f);
            }
            Derivatives::Planned => self.plan.regions[region].scope,
            Derivatives::All => Scope::All,
        };
        stats.jacobian_points += at.len;
        self.problem.rhs_jacobian(region, &at, constants, scope, &mut batch.f, &mut batch.dy, &mut batch.dc);
        self.check_values(region, &at, &batch.f)?;
        if !finite(&batch.dy) {
            return Err(NonFinite::derivative(self.layout, region, &at, &batch.dy));
        }
        Ok(())
    }

    /// # Errors
    /// Names the first row and point that are not finite.
    pub(crate) fn check_values(&self, region: usize, at: &Points<'_>, f: &[f64]) -> Result<(), NonFinite> {
        if finite(f) { Ok(()) } else { Err(NonFinite::value(self.layout, region, at, f)) }
    }
}

fn finite(values: &[f64]) -> bool {
    // x * 0 is 0 for a finite x and NaN otherwise.
    let mut sums = [0.0; 8];
    let (chunks, rest) = values.as_chunks::<8>();
    for chunk in chunks {
        for (sum, x) in sums.iter_mut().zip(chunk) {
            *sum += x * 0.0;
        }
    }
    sums.iter().sum::<f64>() == 0.0 && rest.iter().all(|x| x.is_finite())
}

fn add_slopes(weights: &[f64], stages: &Stages, row: usize, out: &mut [f64]) {
    for (stage, &weight) in weights.iter().enumerate() {
        if weight != 0.0 {
            let slopes = stages.slope(stage, row, out.len());
            elementwise(out, [slopes], |out, [slope]| out + weight * slope);
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
    out: &'a mut [f64],
}

/// `factors · (y_0, y_1) + sign h Σ w K` of all components, all intervals, at once.
fn advance(slopes: &Slopes<'_>, weights: &[f64], advance: Advance<'_>) {
    let (mut used, mut count) = ([(0, 0.0); MOST_STAGES], 0);
    for (stage, &weight) in weights.iter().enumerate().filter(|(_, weight)| **weight != 0.0) {
        used[count] = (stage, weight);
        count += 1;
    }
    match count {
        2 => vectorised(Sum { advance, slopes, used: [used[0], used[1]] }),
        3 => vectorised(Sum { advance, slopes, used: [used[0], used[1], used[2]] }),
        4 => vectorised(Sum { advance, slopes, used: [used[0], used[1], used[2], used[3]] }),
        _ => vectorised(Sum { advance, slopes, used }),
    }
}

/// Stages of a method at most; fewer are filled up by the first node's, with the weight 0.
pub(super) const MOST_STAGES: usize = 5;

struct Sum<'a, const S: usize> {
    advance: Advance<'a>,
    slopes: &'a Slopes<'a>,
    /// Stages and their weights.
    used: [(usize, f64); S],
}

impl<const S: usize> Job for Sum<'_, S> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Advance { y, h, factors, sign, out } = self.advance;
        let (y, h, out) = (y.as_chunks::<W>().0, h.as_chunks::<W>().0, out.as_chunks_mut::<W>().0);
        let steps = h.len();
        for (i, out) in out.chunks_exact_mut(steps).enumerate() {
            let y = &y[i * (steps + 1)..][..steps + 1];
            let slopes = self.used.map(|(stage, weight)| {
                let (values, stride) = self.slopes.stages[stage];
                (&values[i * stride..][..steps], weight)
            });
            for t in 0..steps {
                let mut sum = Lane::ZERO;
                for (slope, weight) in &slopes {
                    sum += Lane(slope[t]).times(*weight);
                }
                let ends = Lane(y[t]).times(factors[0]) + Lane(y[t + 1]).times(factors[1]);
                out[t] = (ends + Lane(h[t]).times(sign) * sum).0;
            }
        }
    }
}
