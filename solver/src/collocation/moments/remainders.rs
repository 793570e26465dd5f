//! What the method's quadrature misses of the defect's effect.

use super::{Component, SampledExtension};
use crate::collocation::defect::Defects;
use crate::collocation::interpolant::{Extended, Extension};
use crate::collocation::open_ends::OpenLanes;
use crate::collocation::stages::{MOST_STAGES, View};
use crate::linear::memory::Lanes;
use crate::linear::scalar::{Lane, Scalar, W};
use crate::linear::simd::{Job, vectorised};
use crate::problem::Problem;
use crate::tableau::{Difference, Differences, Tableau};

impl<P: Problem + ?Sized> Extended<'_, '_, P> {
    /// Adds to right-hand sides of the linearised interval equations, and of each integral's, what the method's
    /// quadrature at the stages misses of `∫ f_y D ds`: D is a polynomial of too high a degree for it. Without that a
    /// fixed part of the error is missed, however short the intervals.
    pub(crate) fn add_remainders(
        &self,
        extension: &Extension,
        defects: &Defects,
        scales: &[f64],
        integrated: &mut [f64],
    ) {
        let tableau = self.system.tableau;
        vectorised(AddRemainders {
            remainders: &tableau.differences().remainders,
            sampled: self.sampled_extension(extension, defects),
            views: self.stages.views(self.steps()),
            pattern: &self.system.layout.regions[self.region].state_pattern,
            scales,
            open: OpenLanes::all(self.stages, &self.system.grids[self.region], tableau),
            tableau,
            integrated: integrated.as_chunks_mut::<W>().0,
        });
    }
}

/// See [`Extended::add_remainders`].
struct AddRemainders<'a> {
    /// One a stage.
    remainders: &'a [Difference],
    sampled: SampledExtension<'a>,
    views: [View<'a>; MOST_STAGES],
    pattern: &'a [(usize, usize)],
    /// Typical magnitudes of the states.
    scales: &'a [f64],
    /// Where intervals have an open end.
    open: Vec<OpenLanes>,
    tableau: &'static Tableau,
    integrated: &'a mut [[f64; W]],
}

/// The stage in the middle of the interval, at orders 6 and 8.
const MIDDLE: usize = 4;
/// What is added is the first term of a series in `h f_y`. It counts in full where the square of that is small beside
/// this, and where it is large not at all.
const LARGE: f64 = 4.0;

impl Job for AddRemainders<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let (n, steps) = (self.scales.len(), self.sampled.pieces.steps);
        // Two values a state, and one a stage and state.
        let mut room = Lanes::unset((2 + self.remainders.len()) * n);
        let (sizes, weighed) = room.split_at_mut(2 * n);
        for t in 0..steps {
            let part = self.size(t, sizes).map(|size| 1.0 / (1.0 + (size / LARGE) * (size / LARGE)));
            let factor = part * self.sampled.pieces.length(t);
            for i in 0..n {
                let component = self.sampled.component(i, t);
                for (stage, remainder) in self.remainders.iter().enumerate() {
                    weighed[stage * n + i] = factor * component.difference(remainder);
                }
                if let Some(open) = self.open.iter().find(|open| open.t == t) {
                    self.take_off_followed(open, &component, factor, weighed[i..].iter_mut().step_by(n));
                }
            }
            for (entry, &(row, state)) in self.pattern.iter().enumerate() {
                let out = &mut self.integrated[row * steps + t];
                let mut sum = Lane(*out);
                for (view, weighed) in self.views.iter().zip(weighed.chunks_exact(n)) {
                    sum += view.dy(entry, t) * weighed[state];
                }
                *out = sum.0;
            }
        }
    }
}

impl AddRemainders<'_> {
    /// Takes off what the method's `b D` at an open end is: that of the stages which the slope there follows. D is 0 at
    /// the left node.
    #[inline(always)]
    fn take_off_followed<'b>(
        &self,
        open: &OpenLanes,
        component: &Component,
        factor: Lane,
        weighed: impl Iterator<Item = &'b mut Lane>,
    ) {
        let Differences { inside, right, .. } = self.tableau.differences();
        let differences = std::iter::once(right).chain(inside);
        for (stage, (weighed, difference)) in weighed.skip(1).zip(differences).enumerate() {
            let mut followed = Lane::ZERO;
            for (side, weights) in open.nodes.iter().enumerate() {
                let own = if side == stage + 1 { Lane::ONE } else { Lane::ZERO };
                followed += (weights[stage + 1] - own).times(self.tableau.b[side]);
            }
            *weighed -= factor * followed * component.difference(difference);
        }
    }

    /// A bound of the norm of `(h f_y)²` in typical magnitudes on interval `t` of every stretch. `room`: two values a
    /// state.
    #[inline(always)]
    fn size(&self, t: usize, room: &mut [Lane]) -> Lane {
        let (h, (once, twice)) = (self.sampled.pieces.length(t), room.split_at_mut(self.scales.len()));
        once.fill(Lane::ZERO);
        twice.fill(Lane::ZERO);
        let entries = || self.pattern.iter().enumerate().filter(|(_, (row, _))| *row < self.scales.len());
        let entry = |entry: usize, row: usize, state: usize| {
            (h * self.views[MIDDLE].dy(entry, t)).abs().times(self.scales[state] / self.scales[row])
        };
        for (at, &(row, state)) in entries() {
            once[row] += entry(at, row, state);
        }
        for (at, &(row, state)) in entries() {
            twice[row] += entry(at, row, state) * once[state];
        }
        twice.iter().fold(Lane::ZERO, |most, size| most.zip(*size, f64::max))
    }
}
