//! How far the continuous extension is from meeting the equations.

use super::Scales;
use super::interpolant::{Extended, Extension, Pieces, Sampled};
use crate::basis::Basis;
use crate::error::NonFinite;
use crate::linear::memory::Numbers;
use crate::linear::scalar::{Lane, Scalar, W};
use crate::linear::simd::{Job, by_components, vectorised};
use crate::problem::Problem;
use crate::stats::Stats;
use crate::tableau::MOST_PLACES;

/// Relative error of a difference of node values.
const ROUNDING: f64 = 8.0 * f64::EPSILON;
/// The collocation polynomial of order 8 is not corrected where its defect is as large as this: the mesh will be
/// refined, and it says well enough where,
const ROUGH: f64 = 0.3;
/// if defects are held to no more than this.
const LARGEST_LIMIT: f64 = 0.03;

/// What the finer rule of an integral is taken to be wrong by where an interval does not resolve the integrand at all,
/// as a share of how that varies.
const DOUBT: f64 = 0.25;

/// Defects of one region, one an interval, in the mesh's order.
#[derive(Debug, Clone, Default)]
pub(crate) struct Defects {
    /// Root mean square over the interval of `|S' - f| ℓ / (Y + F ℓ)`, largest over states: Y the state's typical
    /// magnitude, ℓ the region's length, F the larger of |f| and of the size of f's terms, `Σ |∂f/∂y| |y|`, at the
    /// nodes: where large terms nearly cancel, they cannot be met better than they are known. On rough meshes of order
    /// 8 that of the collocation polynomial.
    pub relative: Numbers,
    /// What the interval's defect can move a state by, relative to its typical magnitude: `h |S' - f| / Y`.
    pub contribution: Numbers,
    /// What rounding alone may make of the relative defect: the slope is a difference of values over an interval.
    pub rounding: Numbers,
    /// State of the largest relative defect.
    pub state: Vec<usize>,
    /// `∫ (S' - f) ds` of each state, and the error of each integral, per interval: `rows * interval_stride`, in
    /// working order. Empty on rough meshes of orders 6 and 8, as are the samples.
    pub integrated: Numbers,
    /// What the error of each integral, which is one difference of two rules, may be wrong by, per interval: rows as
    /// those of the integrals in `integrated`, never negative. Empty where that is.
    pub doubts: Numbers,
    /// f(S) at the samples, in the order of the method's.
    pub samples: Vec<Sampled>,
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

/// Adds samples to a tally.
struct Count<'a> {
    pieces: Pieces<'a>,
    sampled: &'a Sampled,
    /// S' at each place, and the weight of the sample.
    places: &'a [(Basis, f64)],
    tally: &'a mut Tally,
    /// Y of each state.
    scales: &'a [f64],
    /// ℓ.
    length: f64,
    /// Where `h (f - S')` is to go, place by place, state by state; empty if it is not wanted.
    lacking: &'a mut [f64],
}

impl Job for Count<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self { pieces, sampled, places, tally, scales, length, lacking } = self;
        let (lacking, steps) = (lacking.as_chunks_mut::<W>().0, pieces.steps);
        let relative = tally.relative.as_chunks_mut::<W>().0.chunks_exact_mut(steps);
        let absolute = tally.absolute.as_chunks_mut::<W>().0.chunks_exact_mut(steps);
        let terms = tally.terms.as_chunks::<W>().0.chunks_exact(steps);
        for (i, (((relative, absolute), terms), &scale)) in relative.zip(absolute).zip(terms).zip(scales).enumerate() {
            for t in 0..steps {
                let (h, terms, piece) = (pieces.length(t), Lane(terms[t]), pieces.piece(i, t));
                for (place, (basis, weight)) in places.iter().enumerate() {
                    let (f, rise) = (sampled.slope(i, place, t), piece.weigh(basis));
                    if let Some(lacking) = lacking.get_mut((place * scales.len() + i) * steps + t) {
                        *lacking = (h * f - rise).0;
                    }
                    // Padding has no length and no defect.
                    let defect = rise.zip(h, |rise, h| if h > 0.0 { rise / h } else { 0.0 });
                    let defect = defect - f.zip(h, |f, h| if h > 0.0 { f } else { 0.0 });
                    let size = f.abs().zip(terms, f64::max);
                    let fraction = defect.times(length).zip(size, |defect, size| defect / (scale + size * length));
                    let moved = (defect * h).map(|moved| moved / scale);
                    relative[t] = (Lane(relative[t]) + fraction.times(*weight) * fraction).0;
                    absolute[t] = (Lane(absolute[t]) + moved.times(*weight) * moved).0;
                }
            }
        }
    }
}

/// `Σ |∂f/∂y| |y|` of each state at the nodes, from the entries of the derivatives.
struct Terms<'a> {
    pattern: &'a [(usize, usize)],
    dy: &'a [f64],
    y: &'a [f64],
    /// Vectors a component.
    nodes: usize,
    out: &'a mut [f64],
}

impl Job for Terms<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let (dy, y, out) = (self.dy.as_chunks::<W>().0, self.y.as_chunks::<W>().0, self.out.as_chunks_mut::<W>().0);
        let n = out.len() / self.nodes;
        for (&(row, state), dy) in self.pattern.iter().zip(dy.chunks_exact(self.nodes)).filter(|((row, _), _)| *row < n)
        {
            let (y, out) = (&y[state * self.nodes..][..self.nodes], &mut out[row * self.nodes..][..self.nodes]);
            for (out, (dy, y)) in out.iter_mut().zip(dy.iter().zip(y)) {
                *out = (Lane(*out) + (Lane(*dy) * Lane(*y)).abs()).0;
            }
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
        let (states, mut tally) = (&scales.states[self.region], self.tally());
        if !self.system.tableau.coupled {
            let extension = self.bootstrapped(stats)?;
            let defects = self.defects(&extension, states, tally, limit, stats)?;
            return Ok((extension, defects));
        }
        let mut extension = self.collocation_polynomial();
        let lacking = self.lacking(&extension, states, &mut tally, stats)?;
        if limit <= LARGEST_LIMIT && tally.exceeds(ROUGH, limit) {
            let defects = self.concluded(tally, states);
            return Ok((extension, defects));
        }
        tally.clear();
        self.correct(&mut extension, states, &lacking);
        let defects = self.defects(&extension, states, tally, limit, stats)?;
        Ok((extension, defects))
    }

    /// What is known of the solution between the nodes without evaluating the equations there.
    pub(crate) fn unjudged(&self) -> Extension {
        if self.system.tableau.coupled { self.collocation_polynomial() } else { self.flat() }
    }

    fn defects(
        &self,
        extension: &Extension,
        scales: &[f64],
        mut tally: Tally,
        limit: f64,
        stats: &mut Stats,
    ) -> Result<Defects, NonFinite> {
        let (all, first) = (self.system.tableau.samples, self.system.tableau.first_samples);
        let at_once = if limit <= LARGEST_LIMIT { first } else { all.len() };
        let mut samples = Vec::with_capacity(all.len().div_ceil(at_once));
        for part in all.chunks(at_once) {
            samples.push(self.counted(Some(extension), part, scales, &mut tally, &mut [], stats)?);
            if samples.len() == 1 && at_once < all.len() && tally.exceeds(ROUGH, limit) {
                tally.weigh_by(part.iter().map(|sample| sample.1).sum());
                return Ok(self.concluded(tally, scales));
            }
        }
        tally.weigh_by(1.0);
        let (integrated, doubts) = (self.integrated(&samples), self.doubts(&samples));
        Ok(Defects { integrated, doubts, samples, ..self.concluded(tally, scales) })
    }

    /// Takes samples at places of given weights and adds them to a tally; `h (f - S')` goes to `lacking`, place by
    /// place and state by state, unless that is empty.
    pub(super) fn counted(
        &self,
        extension: Option<&Extension>,
        samples: &[(f64, f64)],
        scales: &[f64],
        tally: &mut Tally,
        lacking: &mut [f64],
        stats: &mut Stats,
    ) -> Result<Sampled, NonFinite> {
        let (mut sigmas, mut places) = ([0.0; MOST_PLACES], [(Basis::slope(0.0), 0.0); MOST_PLACES]);
        for ((sigma, place), sample) in sigmas.iter_mut().zip(&mut places).zip(samples) {
            (*sigma, *place) = (sample.0, (Basis::slope(sample.0), sample.1));
        }
        let sampled = self.sampled(extension, &sigmas[..samples.len()], stats)?;
        let (a, b) = self.system.layout.regions[self.region].interval;
        vectorised(Count {
            pieces: self.pieces(extension),
            sampled: &sampled,
            places: &places[..samples.len()],
            tally,
            scales,
            length: b - a,
            lacking,
        });
        Ok(sampled)
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
        let mut states = Vec::with_capacity(count);
        grid.each(count, |p| states.push(state[p]));
        Defects {
            relative: grid.in_order(count, |p| (most[p] / weight).sqrt()),
            contribution: grid.in_order(count, |p| (contribution[p] / weight).sqrt()),
            rounding: grid.in_order(count, |p| rounding[p]),
            state: states,
            ..Defects::default()
        }
    }

    /// What rounding of the node values may make of the relative defects: the largest over states, one an interval. It
    /// is large where intervals are short although the solution hardly varies on them, and small in a layer.
    fn rounding(&self, terms: &[f64], scales: &[f64]) -> Numbers {
        let (a, b) = self.system.layout.regions[self.region].interval;
        let (cubic, terms) = (self.pieces(None), terms.as_chunks::<W>().0);
        let mut out = Numbers::unset(self.intervals());
        by_components(&mut out, cubic.steps, |_, t| {
            let (h, mut most) = (cubic.length(t), Lane::ZERO);
            for (i, &scale) in scales.iter().enumerate() {
                let [y0, y1] = cubic.values(i, t).map(Scalar::abs);
                let slope = y0.zip(y1, f64::max).zip(h, |y, h| if h > 0.0 { y / h } else { 0.0 });
                let rounding = slope.zip(Lane(terms[i * cubic.steps + t]), |slope, terms| {
                    ROUNDING * slope * (b - a) / (scale + terms * (b - a))
                });
                most = most.zip(rounding, f64::max);
            }
            most
        });
        out
    }

    /// An empty tally.
    pub(super) fn tally(&self) -> Tally {
        let (n, steps) = (self.n(), self.steps());
        let mut at_nodes = Numbers::zeros(n * (steps + 1) * W);
        let pattern = &self.system.layout.regions[self.region].state_pattern;
        let (dy, y) = (&self.stages.nodes.dy, &self.x.y[self.region]);
        vectorised(Terms { pattern, dy, y, nodes: steps + 1, out: &mut at_nodes });
        let (mut terms, at_nodes) = (Numbers::unset(n * steps * W), at_nodes.as_chunks::<W>().0);
        by_components(&mut terms, steps, |i, t| {
            let at = i * (steps + 1) + t;
            Lane(at_nodes[at]).zip(Lane(at_nodes[at + 1]), f64::max)
        });
        let (relative, absolute) = (Numbers::zeros(terms.len()), Numbers::zeros(terms.len()));
        Tally { relative, absolute, terms, weight: 0.0 }
    }

    /// The continuous extension of order 4 and what its defects integrate to, nothing else of them, by the samples of
    /// so many parts of each interval: where the right-hand side has a kink, those of the whole interval are too few.
    ///
    /// # Errors
    /// The right-hand side is undefined between the collocation points.
    pub(crate) fn integrated_finely(&self, parts: usize, stats: &mut Stats) -> Result<(Extension, Defects), NonFinite> {
        let (extension, samples) = (self.bootstrapped(stats)?, self.system.tableau.samples);
        let mut sum = Numbers::zeros(self.rows() * self.intervals());
        for part in 0..parts {
            let mut places = [0.0; MOST_PLACES];
            for (place, (sigma, _)) in places.iter_mut().zip(samples) {
                *place = (part as f64 + sigma) / parts as f64;
            }
            let sampled = [self.sampled(Some(&extension), &places[..samples.len()], stats)?];
            let integrated = self.integrated(&sampled);
            sum.iter_mut().zip(&integrated).for_each(|(sum, part)| *sum += part / parts as f64);
        }
        Ok((extension, Defects { integrated: sum, ..Defects::default() }))
    }

    /// From f at the samples, all rows: what the defects of the states, and the quadrature of the integrals, amount to.
    fn integrated(&self, samples: &[Sampled]) -> Numbers {
        let (n, intervals, cubic) = (self.n(), self.intervals(), self.pieces(None));
        let weights = || self.system.tableau.samples.iter().map(|sample| sample.1);
        let mean = |row: usize, t: usize| Sampled::weighted(samples, weights(), row, t);
        let mut out = Numbers::unset(self.rows() * intervals);
        let (states, integrals) = out.split_at_mut(n * intervals);
        by_components(states, cubic.steps, |i, t| {
            let [left, right] = cubic.values(i, t);
            right - left - cubic.length(t) * mean(i, t)
        });
        if !integrals.is_empty() {
            let rules = self.system.interval_integrals(self.region, self.stages);
            let rules = rules.as_chunks::<W>().0;
            by_components(integrals, cubic.steps, |k, t| {
                Lane(rules[k * cubic.steps + t]) - cubic.length(t) * mean(n + k, t)
            });
        }
        out
    }

    /// See [`Defects::doubts`]. The difference of two rules may vanish although neither is right: what one misses of a
    /// peak within the interval may be what the other does. The integrand is then not met, from sample to sample, by
    /// the polynomial through its values at the stages. What this lacks there, against how the integrand varies, says
    /// how well the interval resolves it, and the square of that how far the finer rule is to be trusted: where an
    /// interval is short enough, it falls faster than the difference of the rules.
    fn doubts(&self, samples: &[Sampled]) -> Numbers {
        let (n, steps) = (self.n(), self.steps());
        let mut out = Numbers::unset((self.rows() - n) * self.intervals());
        if out.is_empty() {
            return out;
        }
        let (tableau, cubic, views) = (self.system.tableau, self.pieces(None), self.stages.views(steps));
        let (weights, at_samples) = (|| tableau.samples.iter().map(|sample| sample.1), tableau.at_samples());
        by_components(&mut out, steps, |k, t| {
            let (row, mean) = (n + k, Sampled::weighted(samples, weights(), n + k, t));
            let (mut missed, mut varied) = (Lane::ZERO, Lane::ZERO);
            let at = samples.iter().flat_map(|sampled| (0..sampled.places).map(move |place| (sampled, place)));
            for (((sampled, place), weight), of_stages) in at.zip(weights()).zip(at_samples) {
                let value = sampled.slope(row, place, t);
                let stages = views.iter().zip(of_stages).take(tableau.stages());
                let between = stages.fold(Lane::ZERO, |sum, (view, weight)| sum + view.f(row, t).times(*weight));
                missed += (value - between).abs().times(weight);
                varied += (value - mean).abs().times(weight);
            }
            let share = missed.zip(varied, |missed, varied| if missed < varied { missed / varied } else { 1.0 });
            (cubic.length(t) * share * share * varied).times(DOUBT)
        });
        out
    }
}
