//! How far the continuous extension is from meeting the equations.

use super::Scales;
use super::interpolant::{Basis, Extended, Extension, Sample};
use crate::error::NonFinite;
use crate::linear::memory::Numbers;
use crate::linear::scalar::{Lane, Scalar, W};
use crate::linear::simd::{Job, elementwise, vectorised};
use crate::problem::Problem;
use crate::stats::Stats;

/// Relative error of a difference of node values.
const ROUNDING: f64 = 8.0 * f64::EPSILON;
/// The samples of order 6, and those of any, in the order in which they are taken.
const INNER_FIRST: [usize; 4] = [1, 2, 0, 3];
const IN_TURN: [usize; 6] = [0, 1, 2, 3, 4, 5];
/// The collocation polynomial of order 8 is not corrected where its defect is as large as this: the mesh will be
/// refined, and it says well enough where,
const ROUGH: f64 = 0.3;
/// if defects are held to no more than this.
const LARGEST_LIMIT: f64 = 0.03;

/// Defects of one region, one an interval, in the mesh's order.
#[derive(Debug, Clone, Default)]
pub(crate) struct Defects {
    /// Root mean square over the interval of `|S' - f| ℓ / (Y + F ℓ)`, largest over states: Y the state's typical
    /// magnitude, ℓ the region's length, F the larger of |f| and of the size of f's terms, `Σ |∂f/∂y| |y|`, at the
    /// nodes: where large terms nearly cancel, they cannot be met better than they are known. On rough meshes of order
    /// 8 that of the collocation polynomial.
    pub relative: Vec<f64>,
    /// What the interval's defect can move a state by, relative to its typical magnitude: `h |S' - f| / Y`.
    pub contribution: Vec<f64>,
    /// What rounding alone may make of the relative defect: the slope is a difference of values over an interval.
    pub rounding: Vec<f64>,
    /// State of the largest relative defect.
    pub state: Vec<usize>,
    /// `∫ (S' - f) ds` of each state, and the error of each integral, per interval: `rows * interval_stride`, in
    /// working order. Empty on rough meshes of orders 6 and 8, as are the samples.
    pub integrated: Numbers,
    /// f(S) at one sample after the other, each `rows * interval_stride`, in working order.
    pub samples: Numbers,
}

/// Weighted squares of the defects at the samples taken so far, by states and intervals in working order.
pub(super) struct Tally {
    /// Of relative defects.
    relative: Numbers,
    /// Of contributions.
    absolute: Numbers,
    /// `Σ |∂f/∂y| |y|` of each state, the larger of both nodes.
    terms: Numbers,
    /// Sum of the weights.
    weight: f64,
}

impl Tally {
    /// Whether the defect of an interval exceeds `least`, and moves a state by more than the limit, so that nothing
    /// excuses it.
    pub(super) fn exceeds(&self, least: f64, limit: f64) -> bool {
        let (least, limit) = (least * least, limit * limit);
        self.relative.iter().zip(&self.absolute).any(|(&relative, &absolute)| relative > least && absolute > limit)
    }

    /// Says what the weights of the samples come to.
    pub(super) fn weigh_by(&mut self, weight: f64) {
        self.weight = weight;
    }

    /// Forgets the samples.
    fn clear(&mut self) {
        self.relative.fill(0.0);
        self.absolute.fill(0.0);
        self.weight = 0.0;
    }
}

/// Adds one sample of one state to a tally.
struct Count<'a> {
    /// h S'.
    rise: &'a [f64],
    f: &'a [f64],
    h: &'a [f64],
    terms: &'a [f64],
    relative: &'a mut [f64],
    absolute: &'a mut [f64],
    weight: f64,
    /// Y.
    scale: f64,
    /// ℓ.
    length: f64,
}

impl Count<'_> {
    fn vectorised(self) {
        vectorised(self);
    }
}

impl<'a> Job for Count<'a> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let (relative, _) = self.relative.as_chunks_mut::<W>();
        let steps = relative.len();
        let lanes = |values: &'a [f64]| &values.as_chunks::<W>().0[..steps];
        let (rise, f, h, terms) = (lanes(self.rise), lanes(self.f), lanes(self.h), lanes(self.terms));
        let absolute = &mut self.absolute.as_chunks_mut::<W>().0[..steps];
        for t in 0..steps {
            // Padding has no length and no defect.
            let (h, f) = (Lane(h[t]), Lane(f[t]));
            let defect = Lane(rise[t]).zip(h, |rise, h| if h > 0.0 { rise / h } else { 0.0 });
            let defect = defect - f.zip(h, |f, h| if h > 0.0 { f } else { 0.0 });
            let size = f.abs().zip(Lane(terms[t]), f64::max);
            let fraction =
                defect.times(self.length).zip(size, |defect, size| defect / (self.scale + size * self.length));
            let moved = (defect * h).map(|moved| moved / self.scale);
            relative[t] = (Lane(relative[t]) + fraction.times(self.weight) * fraction).0;
            absolute[t] = (Lane(absolute[t]) + moved.times(self.weight) * moved).0;
        }
    }
}

impl<P: Problem + ?Sized> Extended<'_, '_, P> {
    /// The continuous extension and its defects, which are to be no larger than `limit`: where they are far larger,
    /// less is spent on knowing them.
    ///
    /// # Errors
    /// The right-hand side is undefined between the collocation points.
    pub(crate) fn judged(
        &self,
        scales: &Scales,
        limit: f64,
        stats: &mut Stats,
    ) -> Result<(Extension, Defects), NonFinite> {
        let states = &scales.states[self.region];
        let (mut sample, mut tally) = (self.room(), self.tally());
        let mut extension = self.no_extension();
        if self.system.tableau.coupled {
            let mut points = self.collocated(&mut extension, states, &mut tally, &mut sample, stats)?;
            if limit <= LARGEST_LIMIT && tally.exceeds(ROUGH, limit) {
                let defects = self.concluded(tally, states);
                return Ok((extension, defects));
            }
            tally.clear();
            self.correct(&mut extension, states, &mut points);
        } else {
            self.bootstrapped(&mut extension, &mut sample, stats)?;
        }
        let defects = self.defects(&extension, states, (tally, sample), limit, stats)?;
        Ok((extension, defects))
    }

    /// What is known of the solution between the nodes without evaluating the equations there.
    pub(crate) fn unjudged(&self) -> Extension {
        let mut extension = self.no_extension();
        if self.system.tableau.coupled {
            self.collocate(&mut extension);
        }
        extension
    }

    fn defects(
        &self,
        extension: &Extension,
        scales: &[f64],
        (mut tally, mut sample): (Tally, Sample),
        limit: f64,
        stats: &mut Stats,
    ) -> Result<Defects, NonFinite> {
        let intervals = self.intervals();
        let (all, rows) = (self.system.tableau.samples, self.system.plan.regions[self.region].rows);
        let (mut samples, mut rise) = (Numbers::zeros(all.len() * rows * intervals), Numbers::zeros(intervals));
        // Two samples tell where a mesh is rough, and say well enough where.
        let early = self.system.tableau.order == 6 && limit <= LARGEST_LIMIT;
        let (mut taken, turns): (f64, &[usize]) = (0.0, if early { &INNER_FIRST } else { &IN_TURN[..all.len()] });
        for (count, &k) in turns.iter().enumerate() {
            if early && count == 2 && tally.exceeds(ROUGH, limit) {
                tally.weigh_by(taken);
                return Ok(self.concluded(tally, scales));
            }
            let ((sigma, weight), f) = (all[k], &mut samples[k * rows * intervals..(k + 1) * rows * intervals]);
            taken += weight;
            self.sample(Some(extension), sigma, (&mut sample, &mut *f), stats)?;
            let basis = Basis::slope(sigma);
            for (i, &scale) in scales.iter().enumerate() {
                self.weigh(Some(extension), &basis, i, &mut rise);
                self.count(&mut tally, i, scale, weight, &rise, f);
            }
        }
        tally.weigh_by(1.0);
        let integrated = self.integrated(&samples);
        Ok(Defects { integrated, samples, ..self.concluded(tally, scales) })
    }

    /// Adds a sample of state `i`, `rise`: h S' there.
    pub(super) fn count(&self, tally: &mut Tally, i: usize, scale: f64, weight: f64, rise: &[f64], f: &[f64]) {
        let row = i * rise.len()..(i + 1) * rise.len();
        let (a, b) = self.system.layout.regions[self.region].interval;
        let Tally { relative, absolute, terms, .. } = tally;
        let count = Count {
            rise,
            f: &f[row.clone()],
            h: self.h(),
            terms: &terms[row.clone()],
            relative: &mut relative[row.clone()],
            absolute: &mut absolute[row],
            weight,
            scale,
            length: b - a,
        };
        count.vectorised();
    }

    /// What the samples say, in the mesh's order.
    fn concluded(&self, tally: Tally, scales: &[f64]) -> Defects {
        let Tally { mut relative, mut absolute, terms, weight } = tally;
        let (grid, intervals) = (&self.system.grids[self.region], self.intervals());
        let (count, rounding) = (grid.intervals(), self.rounding(&terms, scales));
        let (most, others) = relative.split_at_mut(intervals);
        let (contribution, contributions) = absolute.split_at_mut(intervals);
        let mut state = vec![0; intervals];
        for (i, (others, contributions)) in
            others.chunks_exact(intervals).zip(contributions.chunks_exact(intervals)).enumerate()
        {
            for p in 0..intervals {
                // Written so that a NaN stays.
                let smaller = others[p] < most[p] || most[p].is_nan();
                (most[p], state[p]) = if smaller { (most[p], state[p]) } else { (others[p], i + 1) };
                contribution[p] = contribution[p].max(contributions[p]);
            }
        }
        let room = || Vec::with_capacity(count);
        let (mut largest, mut contributed, mut floors, mut states) =
            (room(), room(), room(), Vec::with_capacity(count));
        grid.each(count, |p| {
            largest.push((most[p] / weight).sqrt());
            contributed.push((contribution[p] / weight).sqrt());
            floors.push(rounding[p]);
            states.push(state[p]);
        });
        Defects { relative: largest, contribution: contributed, rounding: floors, state: states, ..Defects::default() }
    }

    /// What rounding of the node values may make of the relative defects: the largest over states, one an interval. It
    /// is large where intervals are short although the solution hardly varies on them, and small in a layer.
    fn rounding(&self, terms: &[f64], scales: &[f64]) -> Numbers {
        let intervals = self.intervals();
        let (a, b) = self.system.layout.regions[self.region].interval;
        let length = b - a;
        let mut out = Numbers::zeros(intervals);
        for (i, &scale) in scales.iter().enumerate() {
            let (y0, y1) = self.values(i);
            let terms = &terms[i * intervals..(i + 1) * intervals];
            elementwise(&mut out, [y0, y1, self.h(), terms], |most: f64, [y0, y1, h, terms]| {
                let slope = if h > 0.0 { y0.abs().max(y1.abs()) / h } else { 0.0 };
                most.max(ROUNDING * slope * length / (scale + terms * length))
            });
        }
        out
    }

    /// An empty tally.
    fn tally(&self) -> Tally {
        let (n, nodes, intervals) = (self.n(), self.nodes(), self.intervals());
        let mut at_nodes = Numbers::zeros(n * nodes);
        let pattern = &self.system.layout.regions[self.region].state_pattern;
        for (entry, &(row, state)) in pattern.iter().enumerate().filter(|(_, (row, _))| *row < n) {
            let dy = &self.stages.nodes.dy[entry * nodes..(entry + 1) * nodes];
            let y = &self.x.y[self.region][state * nodes..(state + 1) * nodes];
            let out = &mut at_nodes[row * nodes..(row + 1) * nodes];
            elementwise(out, [dy, y], |sum, [dy, y]| sum + (dy * y).abs());
        }
        let mut terms = Numbers::zeros(n * intervals);
        for (terms, at_nodes) in terms.chunks_exact_mut(intervals).zip(at_nodes.chunks_exact(nodes)) {
            elementwise(terms, [at_nodes, &at_nodes[W..]], |_, [left, right]| left.max(right));
        }
        Tally { relative: Numbers::zeros(n * intervals), absolute: Numbers::zeros(n * intervals), terms, weight: 0.0 }
    }

    /// From f at the samples, all rows: what the defects of the states, and the quadrature of the integrals, amount to.
    fn integrated(&self, samples: &[f64]) -> Numbers {
        let (n, intervals) = (self.n(), self.intervals());
        let rules = self.system.interval_integrals(self.region, self.stages);
        let mut means = Numbers::zeros(self.system.plan.regions[self.region].rows * intervals);
        for (f, &(_, weight)) in samples.chunks_exact(means.len()).zip(self.system.tableau.samples) {
            elementwise(&mut means, [f], |mean, [f]| mean + weight * f);
        }
        for (row, out) in means.chunks_exact_mut(intervals).enumerate() {
            if row < n {
                let (left, right) = self.values(row);
                elementwise(out, [left, right, self.h()], |mean, [left, right, h]| right - left - h * mean);
            } else {
                let rule = &rules[(row - n) * intervals..];
                elementwise(out, [rule, self.h()], |mean, [rule, h]| rule - h * mean);
            }
        }
        means
    }
}
