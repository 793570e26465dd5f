//! The linearised problem without its interiors: what ends, integrals and constants do when a constant moves.

use crate::collocation::System;
use crate::collocation::evaluate::Derivatives;
use crate::collocation::factor::{Factorisation, input_scales};
use crate::collocation::grid::intervals;
use crate::collocation::plan::Plan;
use crate::error::SolveError;
use crate::guess::Guess;
use crate::magnitude::Magnitudes;
use crate::measure::undefined;
use crate::problem::Problem;
use crate::solution::Solution;
use crate::solve::check;
use crate::stats::Stats;
use std::sync::Arc;

/// Derivatives of all the boundary equations' inputs (ends, integrals, constants) with respect to every given constant.
///
/// One elimination carries all constants as columns, given or unknown (static condensation); the small dense system it
/// leaves is factored once, and each given constant is one more right-hand side of it. No interior node is computed:
/// where those are wanted, [`Linearisation::sensitivity`](crate::Linearisation::sensitivity) has them, for one constant
/// at a time and at several times the cost.
#[derive(Debug, Clone, PartialEq)]
pub struct Condensation {
    /// One for each constant; none for an unknown one.
    rates: Vec<Option<Vec<f64>>>,
    stats: Stats,
}

impl Condensation {
    /// Evaluates all derivatives at the solution and condenses them.
    ///
    /// # Errors
    /// The solution is not one of this problem's, or its Newton matrix is singular (as at a fold).
    pub fn new<P: Problem + ?Sized>(problem: &P, solution: &Solution) -> Result<Self, SolveError> {
        let layout = problem.layout();
        let guess = Guess::from(solution);
        check(layout, &guess, solution.unknowns(), &Default::default())?;
        let grids = guess.grids();
        let mut x = guess.iterate(&grids);
        let plan = Arc::new(Plan::complete(layout));
        let magnitudes = Magnitudes::stated(layout);
        let mut system =
            System { problem, layout, plan, linear: false, tableau: solution.order().tableau(), magnitudes, grids };
        let (mut work, mut stats) = (system.work(), Stats::default());
        system.complete(&mut x, &mut stats);
        system.evaluate(&x, Derivatives::All, &mut work, &mut stats).map_err(undefined(&system.grids))?;
        let mut factorisation = Factorisation::new(&system);
        factorisation.condense(&system, &work, system.scales(&x));
        stats.factorisations += 1;
        let right = factorisation.split(2 * system.plan.states(), solution.unknowns());
        let (rank, size) = factorisation.rank();
        if rank < size {
            // Its messages name the unknowns.
            system.plan = Arc::new(Plan::new(layout, solution.unknowns()));
            let error = factorisation.singular(&system, rank);
            return Err(SolveError::Newton { error, intervals: intervals(&system.grids) });
        }
        let rates = right.into_iter().enumerate().map(|(constant, column)| {
            let moved = column.map(|mut column| {
                factorisation.border.solve(&mut column);
                column
            });
            moved.map(|moved| factorisation.input_rates(&system, solution.unknowns(), constant, &moved))
        });
        let rates: Vec<_> = rates.collect();
        stats.linear_solves += rates.iter().flatten().count();
        Ok(Self { rates, stats })
    }

    /// Rates of ends, integrals and constants, in the order of the boundary equations' inputs, when a given constant
    /// moves at the rate 1. `None` if the constant is unknown, or is none.
    pub fn rates(&self, constant: usize) -> Option<&[f64]> {
        self.rates.get(constant)?.as_deref()
    }

    /// What it cost.
    pub fn stats(&self) -> &Stats {
        &self.stats
    }
}

impl Factorisation {
    /// Factors the columns of ends and unknowns of a dense system in all constants; answers those of the given
    /// constants, negated, one for each constant.
    fn split(&mut self, ends: usize, unknowns: &[usize]) -> Vec<Option<Vec<f64>>> {
        let (size, width) = (ends + unknowns.len(), ends + self.scales.constants.len());
        let given = |constant: usize| !unknowns.contains(&constant);
        let column = |constant: usize| self.dense.chunks_exact(width).map(|row| -row[ends + constant]).collect();
        let right = (0..width - ends).map(|constant| given(constant).then(|| column(constant))).collect();
        let unknown = |row: &[f64]| unknowns.iter().map(|&constant| row[ends + constant]).collect::<Vec<f64>>();
        let rows = self.dense.chunks_exact(width);
        self.dense = rows.flat_map(|row| row[..ends].iter().copied().chain(unknown(row))).collect();
        self.border.factor(size, &self.dense);
        right
    }

    /// Rates of all inputs from those of ends and unknowns, dimensionless, along a given constant.
    fn input_rates<P: Problem + ?Sized>(
        &self,
        system: &System<'_, P>,
        unknowns: &[usize],
        constant: usize,
        moved: &[f64],
    ) -> Vec<f64> {
        let scales = &self.scales.constants;
        let (ends, moved_unknowns) = moved.split_at(2 * system.plan.states());
        let mut constants = vec![0.0; scales.len()];
        constants[constant] = 1.0;
        for (&unknown, moved) in unknowns.iter().zip(moved_unknowns) {
            constants[unknown] = *moved;
        }
        let mut rates: Vec<f64> =
            ends.iter().zip(&input_scales(&self.scales)).map(|(end, scale)| end * scale).collect();
        for (plan, factor) in system.plan.regions.iter().zip(&self.regions) {
            let (n, p, end) = (plan.n, plan.columns.len(), factor.top.end());
            let (first, last) = ends[plan.first_end..][..2 * n].split_at(n);
            let here: Vec<f64> = plan.columns.iter().map(|&column| constants[column]).collect();
            rates.extend((0..plan.active.len()).map(|k| {
                dot(&end.fa[k * n..][..n], first) + dot(&end.fb[k * n..][..n], last) + dot(&end.fc[k * p..][..p], &here)
            }));
        }
        rates.extend(constants.iter().zip(scales).map(|(rate, scale)| rate * scale));
        rates.iter_mut().for_each(|rate| *rate /= scales[constant]);
        rates
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
