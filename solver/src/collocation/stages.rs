//! Values of the right-hand side and its derivatives at the stages of all intervals of a region.

use super::plan::RegionPlan;
use super::roles::Roles;
use crate::linear::memory::Numbers;
use crate::linear::scalar::{Lane, W};
use crate::linear::simd::largest_number;
use crate::problem::Region;
use std::sync::Arc;

/// Stages of a method at most.
pub(crate) const MOST_STAGES: usize = 5;

/// What values of a right-hand side are those of: states, as in [`Batch::y`], and constants.
#[derive(Debug, Clone)]
pub(crate) struct Held {
    pub y: Numbers,
    pub constants: Numbers,
    /// The largest value of each state on the way: what is left of it is exact but for the rounding of that.
    pub largest: Numbers,
}

impl Held {
    pub(super) fn at(y: &[f64], constants: &[f64]) -> Self {
        Self { y: Numbers::of(y), constants: Numbers::of(constants), largest: Numbers::zeros(0) }
    }

    /// Notes how large the states are that are left for others; `stride` values each.
    pub(super) fn passed(&mut self, stride: usize) {
        let states = self.y.chunks_exact(stride).map(largest_number);
        if self.largest.is_empty() {
            self.largest = Numbers::collected(self.y.len() / stride, states);
        } else {
            self.largest.iter_mut().zip(states).for_each(|(largest, state)| *largest = largest.max(state));
        }
    }
}

/// Values of one batch of points: at the nodes, or at one place after the other of all intervals.
#[derive(Debug, Clone, Default)]
pub(crate) struct Batch {
    pub s: Numbers,
    pub y: Numbers,
    /// Right-hand side and integrands.
    pub f: Numbers,
    pub dy: Numbers,
    pub dc: Numbers,
    /// What f is that of, where the problem is linear and its derivatives are known: what it is elsewhere follows.
    pub held: Option<Held>,
    /// Whether values have been found undefined at the region's left and right end, where the method forgives it.
    pub undefined: [bool; 2],
}

impl Batch {
    /// Once undefined, an end stays so: equations do not change from one evaluation to the next.
    pub(super) fn note_undefined(&mut self, undefined: [bool; 2]) {
        self.undefined.iter_mut().zip(undefined).for_each(|(known, new)| *known |= new);
    }
}

/// Values of one region at all its stages.
#[derive(Debug, Clone)]
pub(crate) struct Stages {
    /// Stages 0 and 1 (`s` and `y` unused: they are the grid's and the iterate's).
    pub nodes: Batch,
    /// Stages 2, 3, ..., in the method's [`batches`](crate::tableau::Tableau::batches).
    pub inner: Vec<Batch>,
    /// Interval residuals `y_1 - y_0 - h Σ b K`, `n * interval_stride`.
    pub phi: Numbers,
    /// Residuals of the stage equations, as [`Iterate::inner`](super::Iterate::inner) stands; empty if that is.
    pub psi: Numbers,
    /// States whose derivative is another state and nothing else, with that state: at all nodes where derivatives were
    /// last evaluated. Only at order 6: see [`ODD`](crate::tableau::ODD).
    pub chained: Vec<(usize, usize)>,
    /// What each state is in the equations of coupled inner stages, as the derivatives at all nodes and stages say.
    pub roles: Arc<Roles>,
}

/// Where the values of one stage stand.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stage<'a> {
    pub batch: &'a Batch,
    /// From one row or entry to the next.
    pub stride: usize,
    /// Of the first interval.
    pub first: usize,
}

impl Stages {
    /// Where those of one stage stand.
    pub(crate) fn stage(&self, stage: usize, intervals: usize) -> Stage<'_> {
        let mut first = stage.saturating_sub(2) * intervals;
        for batch in self.inner.iter().filter(|_| stage >= 2) {
            let stride = batch.s.len();
            if first < stride {
                return Stage { batch, stride, first };
            }
            first -= stride;
        }
        Stage { batch: &self.nodes, stride: intervals + W, first: if stage == 1 { W } else { 0 } }
    }

    /// Slopes of one stage and row, one an interval.
    #[inline]
    pub(crate) fn slope(&self, stage: usize, row: usize, intervals: usize) -> &[f64] {
        let Stage { batch, stride, first } = self.stage(stage, intervals);
        &batch.f[row * stride + first..][..intervals]
    }

    /// All of them in vectors, `steps` a row; where the method has fewer, the rest repeat the first.
    pub(crate) fn views(&self, steps: usize) -> [View<'_>; MOST_STAGES] {
        let nodes = |first: usize| View::of(&self.nodes, (steps + 1) * W, first);
        let mut views = [nodes(0); MOST_STAGES];
        views[1] = nodes(W);
        let mut inner = views[2..].iter_mut();
        for batch in &self.inner {
            let (mut first, stride) = (0, batch.s.len());
            while first < stride
                && let Some(view) = inner.next()
            {
                *view = View::of(batch, stride, first);
                first += steps * W;
            }
        }
        views
    }
}

/// Values of one stage in vectors: interval `t` of every stretch.
#[derive(Clone, Copy)]
pub(crate) struct View<'a> {
    f: &'a [[f64; W]],
    dy: &'a [[f64; W]],
    dc: &'a [[f64; W]],
    /// Vectors from one row or entry to the next.
    stride: usize,
}

impl<'a> View<'a> {
    #[inline]
    fn of(batch: &'a Batch, stride: usize, first: usize) -> Self {
        let lanes = |values: &'a Numbers| values.get(first..).unwrap_or_default().as_chunks::<W>().0;
        Self { f: lanes(&batch.f), dy: lanes(&batch.dy), dc: lanes(&batch.dc), stride: stride / W }
    }

    /// Slope of one row.
    #[inline(always)]
    pub(crate) fn f(&self, row: usize, t: usize) -> Lane {
        Lane(self.f[row * self.stride + t])
    }

    /// Slopes of one row, all intervals.
    #[inline(always)]
    pub(crate) fn row(&self, row: usize, steps: usize) -> &'a [[f64; W]] {
        &self.f[row * self.stride..][..steps]
    }

    /// Derivative of one entry of the states' pattern.
    #[inline(always)]
    pub(crate) fn dy(&self, entry: usize, t: usize) -> Lane {
        Lane(self.dy[entry * self.stride + t])
    }

    /// Derivative of one entry of the constants' pattern.
    #[inline(always)]
    pub(crate) fn dc(&self, entry: usize, t: usize) -> Lane {
        Lane(self.dc[entry * self.stride + t])
    }
}

/// States whose derivative depends on another state, with slope 1, and on no other state and no unknown constant, as
/// the derivatives in the batches say; no two on the same.
pub(super) fn second_order<'a>(
    layout: &Region,
    plan: &RegionPlan,
    batches: impl Iterator<Item = &'a Batch> + Clone,
) -> Vec<(usize, usize)> {
    let are = |of: fn(&Batch) -> &[f64], entry: usize, count: usize, value: f64| {
        batches.clone().all(|batch| {
            let stride = of(batch).len() / count;
            of(batch)[entry * stride..][..stride].iter().all(|found| *found == value)
        })
    };
    let states = &layout.state_pattern;
    let by_state = |entry: usize, value: f64| are(|batch| &batch.dy, entry, states.len(), value);
    let by_constant = |entry: usize| are(|batch| &batch.dc, entry, plan.constant_nonzeros, 0.0);
    // The only argument that a row depends on, if that is another state, with slope 1.
    let only = |row: usize| {
        let of_row = |(_, at): &(usize, &(usize, usize))| at.0 == row;
        let mut arguments = states.iter().enumerate().filter(of_row).filter(|(entry, _)| !by_state(*entry, 0.0));
        let (entry, &(_, state)) = arguments.next()?;
        let mut constants = plan.constant_entries.iter().filter(|(_, at, _)| *at == row);
        let alone = arguments.next().is_none() && constants.all(|&(entry, ..)| by_constant(entry));
        (alone && state != row && by_state(entry, 1.0)).then_some(state)
    };
    let mut found: Vec<(usize, usize)> = Vec::new();
    for u in 0..layout.states.len() {
        if let Some(v) = only(u)
            && found.iter().all(|&(_, other)| other != v)
        {
            found.push((u, v));
        }
    }
    found
}
