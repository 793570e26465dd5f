//! What quadrature adds to the errors of integrals, and does to the solution through the conditions that use them.

use super::{Error, Solved, larger};
use crate::collocation::System;
use crate::collocation::defect::Defects;
use crate::collocation::factor::Rhs;
use crate::collocation::stages::Stages;
use crate::linear::memory::{Lanes, Numbers};
use crate::magnitude::Magnitude;
use crate::newton::Converged;
use crate::problem::Problem;
use crate::rows::Rows;
use crate::stats::Stats;

/// What an integral may be wrong by is followed into the solution where it is more than this share of its error.
const DOUBTED: f64 = 0.1;
/// Errors of the integral over an interval that are no more than this part of it, or of what it is on average, are
/// rounding.
const QUADRATURE_ROUNDING: f64 = 16.0 * f64::EPSILON;
/// Share of the tolerance at which the errors of integrals aim.
const QUADRATURE_GOAL: f64 = 0.5;
/// Parts into which an interval is divided for them at most.
const MOST_PARTS: f64 = 4.0;

/// Which part of the errors of integrals.
#[derive(Clone, Copy)]
enum Part {
    /// All of them.
    All,
    /// What they may be wrong by.
    Doubted,
    /// Those of one integral.
    Of { region: usize, k: usize },
}

/// What quadrature adds to the errors of a region's integrals.
pub(crate) struct Quadrature {
    /// One an integral.
    rows: Vec<QuadratureRow>,
}

/// What quadrature adds to the error of one integral, over the integral's typical magnitude.
struct QuadratureRow {
    /// That magnitude.
    scale: f64,
    /// How much more than itself the error of this integral is to count.
    weight: f64,
    /// Interval by interval in the mesh's order: the larger of its error and of what that may be wrong by; 0 where it
    /// is not told from rounding.
    intervals: Numbers,
    /// All intervals together, signs counted.
    sum: f64,
    /// What all of them may be wrong by.
    doubt: f64,
}

impl QuadratureRow {
    fn size(&self) -> f64 {
        self.sum.abs() + self.doubt
    }
}

impl Quadrature {
    fn of<P: Problem + ?Sized>(
        system: &System<'_, P>,
        region: usize,
        stages: &Stages,
        (errors, defects): (&Rows, &Defects),
        magnitude: Magnitude,
    ) -> Self {
        let (grid, plan) = (&system.grids[region], &system.plan.regions[region]);
        // What is known by quadrature alone, by definition, has no error.
        let integrals = plan.rows - plan.n - usize::from(system.plan.by_quadrature);
        if integrals == 0 {
            return Self { rows: Vec::new() };
        }
        let (values, count, stride) =
            (system.interval_integrals(region, stages), grid.intervals(), grid.interval_stride());
        let rows = values.chunks_exact(stride).take(integrals).enumerate().map(|(k, values)| {
            let (mut sum, mut largest) = (0.0_f64, 0.0_f64);
            for value in grid.in_order(count, |p| values[p]).iter() {
                sum += value;
                largest = largest.max(sum.abs());
            }
            let (scale, errors) = (magnitude.of(largest), errors.row(k));
            let doubts = defects.doubts.get(k * stride..).unwrap_or_default();
            let doubt = |p: usize| doubts.get(p).copied().unwrap_or(0.0);
            let even = largest / count as f64;
            let intervals = grid.in_order(count, |p| {
                let error = larger(errors[p].abs(), doubt(p));
                let told = !(error <= QUADRATURE_ROUNDING * values[p].abs().max(even));
                if told { error / scale } else { 0.0 }
            });
            let total = |of: &dyn Fn(usize) -> f64| grid.in_order(count, |p| of(p) / scale).iter().sum::<f64>();
            QuadratureRow { scale, weight: 1.0, intervals, sum: total(&|p| errors[p]), doubt: total(&doubt) }
        });
        Self { rows: rows.collect() }
    }

    /// The largest error of an integral.
    pub(crate) fn largest(&self) -> f64 {
        self.rows.iter().map(QuadratureRow::size).fold(0.0, larger)
    }

    /// Whether an integral may be wrong by more than a small part of its error.
    fn is_doubted(&self) -> bool {
        self.rows.iter().any(|row| row.doubt > DOUBTED * row.sum.abs())
    }

    /// Into how many parts each of so many intervals is to be divided for the errors of integrals, as they are weighed,
    /// to be no more than `tolerance`, by a rule whose error falls with this power of the length.
    pub(crate) fn pieces(&self, intervals: usize, tolerance: f64, order: f64) -> Vec<usize> {
        let goal = QUADRATURE_GOAL * tolerance / intervals as f64;
        let pieces = |j: usize| {
            let errors = self.rows.iter().filter_map(|row| Some(row.weight * row.intervals.get(j)?));
            let largest = errors.fold(0.0, larger);
            if largest > goal {
                libm::pow(largest / goal, 1.0 / order).ceil().clamp(2.0, MOST_PARTS) as usize
            } else {
                1
            }
        };
        (0..intervals).map(pieces).collect()
    }
}

impl<P: Problem + ?Sized> Solved<'_, P> {
    /// An estimated error, of which `largest` is what defects cause, with what quadrature adds to it.
    pub(super) fn with_quadrature(&self, error: &Error, largest: f64, stats: &mut Stats) -> f64 {
        let Some(magnitude) = self.system.magnitudes.integrals else { return largest };
        let all = self.quadrature(error, magnitude);
        let doubted = all.iter().any(Quadrature::is_doubted);
        let doubted = if doubted { self.effect(&all, Part::Doubted, stats) } else { 0.0 };
        let quadrature = all.iter().map(Quadrature::largest).fold(0.0, larger);
        larger(largest + doubted, quadrature)
    }

    /// What quadrature adds to the errors of integrals, in typical magnitudes; one a region, none where there are no
    /// integrals.
    pub(crate) fn quadrature_errors(&self, stats: &mut Stats) -> Vec<Quadrature> {
        let magnitude = self.system.magnitudes.integrals.unwrap_or_else(|| Magnitude::stated(None));
        let (error, _) = self.estimated_error(stats);
        self.quadrature(error, magnitude)
    }

    /// What the errors of quadrature do to the solution, through the conditions that use integrals: the largest
    /// component, in typical magnitudes.
    pub(crate) fn quadrature_effect(&self, all: &[Quadrature], stats: &mut Stats) -> f64 {
        if all.is_empty() { 0.0 } else { self.effect(all, Part::All, stats) }
    }

    /// Weighs the errors of each integral by what they do to the solution, where that is more than they are themselves:
    /// all together it is no more than the tolerance then if those of each are.
    pub(crate) fn weigh(&self, all: &mut [Quadrature], stats: &mut Stats) {
        let (mut sum, mut most, mut effects) = (0.0, 0.0_f64, Vec::new());
        for region in 0..all.len() {
            for k in 0..all[region].rows.len() {
                let effect = self.effect(all, Part::Of { region, k }, stats);
                (sum, most) = (sum + effect, most.max(effect));
                effects.push(effect);
            }
        }
        let share = if sum > most && most > 0.0 { sum / most } else { 1.0 };
        for (row, effect) in all.iter_mut().flat_map(|quadrature| &mut quadrature.rows).zip(effects) {
            let weight = share * effect / row.size();
            row.weight = if weight.is_finite() { weight.max(1.0) } else { 1.0 };
        }
    }

    /// The solution's largest component, in typical magnitudes, where integrals change by a part of their errors.
    fn effect(&self, all: &[Quadrature], part: Part, stats: &mut Stats) -> f64 {
        let (system, Converged { work, factorisation, .. }) = (&self.system, &self.converged);
        let mut rhs = Rhs { boundary: Numbers::zeros(work.g.len()), ..Rhs::default() };
        let regions = system.grids.iter().zip(&system.plan.regions).zip(all);
        for (region, ((grid, plan), quadrature)) in regions.enumerate() {
            rhs.regions.push(Lanes::zeros(grid.steps * plan.n));
            let change = |&k: &usize| {
                quadrature.rows.get(k).map_or(0.0, |row| match part {
                    Part::All => row.scale * (row.sum + row.doubt.copysign(row.sum)),
                    Part::Doubted => row.scale * row.doubt,
                    Part::Of { region: of, k: only } if (of, only) == (region, k) => row.scale * row.size(),
                    Part::Of { .. } => 0.0,
                })
            };
            rhs.integrals.push(Numbers::collected(plan.active.len(), plan.active.iter().map(change)));
        }
        if rhs.integrals.iter().flat_map(|changes| changes.iter()).all(|change| *change == 0.0) {
            return 0.0;
        }
        stats.linear_solves += 1;
        self.converged.largest(system, &factorisation.solve(system, rhs))
    }

    fn quadrature(&self, error: &Error, magnitude: Magnitude) -> Vec<Quadrature> {
        if self.system.layout.integrals() == 0 {
            return Vec::new();
        }
        let regions = self.converged.work.regions.iter().zip(&error.integrals).zip(&self.defects).enumerate();
        let of = |(region, ((stages, errors), defects))| {
            Quadrature::of(&self.system, region, stages, (errors, defects), magnitude)
        };
        regions.map(of).collect()
    }
}
