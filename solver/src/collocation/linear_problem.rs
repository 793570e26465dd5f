//! Right-hand sides that are linear, as the problem says or an iteration has shown: what they are where an iterate is
//! taken to follows from their derivatives.

use super::evaluate::Work;
use super::plan::{Plan, RegionPlan};
use super::stages::Batch;
use super::{Iterate, System};
use crate::error::{SolveError, quantity};
use crate::linear::memory::Numbers;
use crate::linear::scalar::{Lane, W};
use crate::linear::simd::{Job, elementwise, largest_number, vectorised};
use crate::problem::{Layout, Points, Problem, Region, Scope};
use crate::stats::Stats;

/// A linear right-hand side is what its derivatives lead to, but for this fraction of its largest terms.
const SAME: f64 = 1e-6;

/// Whether all derivatives that matter are asked for, should a problem be linear. Of an integral that no boundary
/// equation depends on, those by constants may not be.
pub(crate) fn has_all_derivatives(layout: &Layout, plan: &Plan) -> bool {
    let known = |(region, part): (&Region, &RegionPlan)| {
        let others = &region.constant_pattern[region.default_entries..];
        part.scope == Scope::All || !others.iter().any(|(_, constant)| plan.unknowns.contains(constant))
    };
    layout.regions.iter().zip(&plan.regions).all(known)
}

impl<P: Problem + ?Sized> System<'_, P> {
    /// Takes the values of a batch from where they are held to these states and constants.
    pub(super) fn follow(&self, region: usize, at: &Points<'_>, constants: &[f64], batch: &mut Batch) {
        let Batch { f, dy, dc, held: Some(held), .. } = batch else { return };
        let Region { state_pattern: pattern, constant_pattern, .. } = &self.layout.regions[region];
        held.passed(at.stride);
        vectorised(Follow { pattern, f, dy, before: &mut held.y, now: at.y, steps: at.stride / W });
        for (entry, &(row, constant)) in constant_pattern.iter().enumerate() {
            let change = constants[constant] - held.constants[constant];
            if change != 0.0 {
                let of = |index: usize| index * at.stride..(index + 1) * at.stride;
                elementwise(&mut f[of(row)], [&dc[of(entry)]], |f, [dc]| f + dc * change);
            }
        }
        held.constants.copy_from_slice(constants);
    }

    /// Whether the right-hand side, evaluated once more at the stages of an iterate, is what its derivatives have led
    /// to.
    ///
    /// # Errors
    /// [`SolveError::NotLinear`], where it is not.
    pub(crate) fn check_linear(&self, x: &Iterate, work: &Work, stats: &mut Stats) -> Result<(), SolveError> {
        for (region, (stages, grid)) in work.regions.iter().zip(&self.grids).enumerate() {
            let nodes = Points { len: grid.node_stride(), stride: grid.node_stride(), s: &grid.s, y: &x.y[region] };
            self.check_batch(region, &nodes, &x.constants, &stages.nodes, stats)?;
            for batch in &stages.inner {
                let at = Points { len: batch.s.len(), stride: batch.s.len(), s: &batch.s, y: &batch.y };
                self.check_batch(region, &at, &x.constants, batch, stats)?;
            }
        }
        Ok(())
    }

    fn check_batch(
        &self,
        region: usize,
        at: &Points<'_>,
        constants: &[f64],
        batch: &Batch,
        stats: &mut Stats,
    ) -> Result<(), SolveError> {
        let (layout, stride) = (&self.layout.regions[region], at.stride);
        let mut found = Numbers::unset(batch.f.len());
        stats.rhs_points += at.len;
        self.problem.rhs(region, at, constants, &mut found);
        // The largest term of each row anywhere: where there are layers, that is what rounding is relative to.
        let mut terms: Vec<f64> = found.chunks_exact(stride).map(largest_number).collect();
        let passed = batch.held.as_ref().map_or(&[][..], |held| &held.largest);
        for (dy, &(row, state)) in batch.dy.chunks_exact(stride).zip(&layout.state_pattern) {
            let now = largest_number(&at.y[state * stride..][..stride]);
            let largest = passed.get(state).map_or(now, |&passed| now.max(passed));
            terms[row] = terms[row].max(largest_number(dy) * largest);
        }
        let (a, b) = layout.interval;
        let is_undefined = |s: f64| (batch.undefined[0] && s == a) || (batch.undefined[1] && s == b);
        for (row, largest) in terms.into_iter().enumerate() {
            let values = found[row * stride..][..at.len].iter().zip(&batch.f[row * stride..]);
            for (&position, (&found, &expected)) in at.s.iter().zip(values) {
                // Where it is undefined, who needs its values says so.
                if (found - expected).abs() > SAME * largest && !is_undefined(position) {
                    let (quantity, region) = (quantity(layout, row), layout.name.clone());
                    return Err(SolveError::NotLinear { quantity, region, position, found, expected });
                }
            }
        }
        Ok(())
    }
}

/// From states `before` to those `now`, which take their place; `steps` vectors a row, state or entry.
struct Follow<'a> {
    pattern: &'a [(usize, usize)],
    f: &'a mut [f64],
    dy: &'a [f64],
    before: &'a mut [f64],
    now: &'a [f64],
    steps: usize,
}

impl Job for Follow<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self { pattern, f, dy, before, now, steps } = self;
        let (f, dy) = (f.as_chunks_mut::<W>().0, dy.as_chunks::<W>().0);
        let (was, is) = (before.as_chunks::<W>().0, now.as_chunks::<W>().0);
        for (dy, &(row, state)) in dy.chunks_exact(steps).zip(pattern) {
            let moved = was[state * steps..][..steps].iter().zip(&is[state * steps..][..steps]);
            for ((f, dy), (was, is)) in f[row * steps..][..steps].iter_mut().zip(dy).zip(moved) {
                *f = (Lane(*f) + Lane(*dy) * (Lane(*is) - Lane(*was))).0;
            }
        }
        before.copy_from_slice(&now[..before.len()]);
    }
}
