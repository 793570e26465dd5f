//! How a run ends: with a solution, or with the error that says what is in the way.

use super::Run;
use crate::accuracy::{Accuracy, Shortfall};
use crate::collocation::System;
use crate::collocation::evaluate::Derivatives;
use crate::collocation::grid::intervals;
use crate::collocation::interpolant::Extended;
use crate::error::{MeshBound, SolveError};
use crate::measure::{Solved, undefined};
use crate::mesh::is_divisible;
use crate::newton::{self, Converged};
use crate::options::Control;
use crate::orientation::BranchCheck;
use crate::problem::Problem;
use crate::progress::{Found, measured};
use crate::refine::{Measure, Rounding};
use crate::solution::{RegionSolution, Solution};
use crate::start::Start;
use crate::stats::Stats;

impl<'a, P: Problem + ?Sized> Run<'a, '_, P> {
    /// The largest defect of a region, which no finer mesh is to be had for because of what is given, unless rounding
    /// is in the way already.
    pub(super) fn exhausted(
        &self,
        region: usize,
        solved: &Solved<'a, P>,
        measure: &Measure,
        because: MeshBound,
    ) -> SolveError {
        let Converged { x, work, .. } = &solved.converged;
        if self.said_linear
            && let Err(error) = solved.system.check_linear(x, work, &mut Stats::default())
        {
            return error;
        }
        let (names, grid) = (&self.layout.regions[region], &solved.system.grids[region]);
        let state = solved.defects[region].state.get(measure.worst).and_then(|&state| names.states.get(state));
        let rounded =
            grid.mesh.get(measure.worst..measure.worst + 2).is_some_and(|nodes| !is_divisible(nodes[0], nodes[1]));
        SolveError::MeshLimit {
            region: names.name.clone(),
            position: grid.mesh[measure.worst],
            state: state.map_or_else(String::new, |state| state.name.clone()),
            defect: measure.largest,
            tolerance: self.options.tolerance,
            intervals: grid.intervals(),
            because: if rounded { MeshBound::Rounding } else { because },
        }
    }

    /// Why what has been found on the last meshes there may be is no solution.
    pub(super) fn unsolved(&self, found: &Found<'a, P>) -> SolveError {
        match found {
            Found::Solved(solved) => self.too_rough(solved, MeshBound::Meshes { most: self.options.max_meshes }),
            Found::Failed(failed) => {
                SolveError::Newton { error: failed.error.clone(), intervals: intervals(&failed.start.grids) }
            }
        }
    }

    /// The largest defect of all regions, which no finer meshes are to be had for.
    pub(super) fn too_rough(&self, solved: &Solved<'a, P>, because: MeshBound) -> SolveError {
        let measures = measured(solved, self.options.tolerance, Rounding::Counted);
        let by_size = |&i: &usize, &j: &usize| measures[i].largest.total_cmp(&measures[j].largest);
        let worst = (0..measures.len()).max_by(by_size).unwrap_or(0);
        self.exhausted(worst, solved, &measures[worst], because)
    }

    /// A solution known to be one, without an iteration; its error is not estimated.
    pub(crate) fn as_it_stands(&mut self, Start { grids, mut x }: Start) -> Result<Solution, SolveError> {
        let system = self.system(grids);
        let mut work = system.work();
        system.complete(&mut x, &mut self.stats);
        system.evaluate(&x, Derivatives::Planned, &mut work, &mut self.stats).map_err(undefined(&system.grids))?;
        let converged = Converged::known(&system, x, work);
        let solved = Solved::new(system, converged, f64::INFINITY, &mut self.stats)?;
        Ok(self.solution(&solved, f64::NAN))
    }

    /// What the collocation equations say on the meshes of a start. Neither defects nor errors are known: NaN stands
    /// for them.
    pub(crate) fn unjudged(
        &mut self,
        Start { grids, x }: Start,
    ) -> Result<(Solution, System<'a, P>, Converged), SolveError> {
        let system = self.system(grids);
        self.stats.meshes += 1;
        let limits = self.limits(false);
        let outcome = newton::solve(&system, &x, limits, &mut self.stats, self.observer, self.budget);
        let failed = |error| SolveError::Newton { error, intervals: intervals(&system.grids) };
        let mut converged = match outcome {
            Ok(converged) => converged,
            Err(newton::Failure::Newton(error) | newton::Failure::Far(_, error)) => return Err(failed(error)),
            Err(newton::Failure::Interrupted(error)) => return Err(error),
        };
        if let Some(error) = converged.stagnated.take() {
            return Err(failed(error));
        }
        self.contraction = converged.contraction;
        self.check = BranchCheck::of_iteration(converged.contraction, converged.full_steps);
        let regions = (0..system.grids.len()).map(|region| {
            let stages = &converged.work.regions[region];
            let extension = Extended { system: &system, region, x: &converged.x, stages }.unjudged();
            RegionSolution::new(&system, region, (&converged.x, &converged.work), (&extension, &[]), None)
        });
        let (tolerance, because) = (self.options.tolerance, Shortfall::Uncontrolled);
        let solution = Solution {
            regions: regions.collect(),
            constants: converged.x.constants.clone(),
            unknowns: self.plan.unknowns.clone(),
            order: self.order,
            max_defect: f64::NAN,
            max_boundary_residual: f64::NAN,
            error_estimate: f64::NAN,
            accuracy: Accuracy::Short { estimate: f64::NAN, tolerance, because },
            corrected: false,
            orientation: converged.factorisation.orientation(),
            branch_check: self.check,
            stats: self.stats,
            history: Vec::new(),
        };
        Ok((solution, system, converged))
    }

    /// As [`finish`](Self::finish), less the estimated error where that is asked for and meets the tolerance: a larger
    /// estimate is not to be trusted so far.
    pub(crate) fn conclude(&mut self, mut solved: Solved<'_, P>) -> Result<Solution, SolveError> {
        let options = self.options;
        if options.defect_correction && solved.error_estimate(&mut self.stats) <= options.tolerance {
            let corrected = solved.correct(options.boundary_tolerance(), &mut self.stats);
            corrected.map_err(undefined(&solved.system.grids))?;
            self.budget.check(&self.stats)?;
        }
        self.finish(&solved)
    }

    /// The solution, if its boundary residuals too meet their tolerance.
    pub(crate) fn finish(&mut self, solved: &Solved<'_, P>) -> Result<Solution, SolveError> {
        let (residual, equation) = solved.worst_boundary_residual();
        let tolerance = self.options.boundary_tolerance();
        if !(residual <= tolerance) {
            let equation = self.layout.equations.get(equation).cloned().unwrap_or_default();
            return Err(SolveError::Boundary { equation, residual, tolerance });
        }
        let error_estimate = solved.error_estimate(&mut self.stats);
        let solution = self.solution(solved, error_estimate);
        match solution.accuracy {
            Accuracy::Short { estimate, tolerance, because }
                if self.options.control == Control::Error && !self.options.accept_inaccurate =>
            {
                Err(SolveError::Inaccurate { estimate, tolerance, because })
            }
            Accuracy::Met | Accuracy::Short { .. } => Ok(solution),
        }
    }

    pub(super) fn solution(&self, solved: &Solved<'_, P>, error_estimate: f64) -> Solution {
        let measures = measured(solved, self.options.tolerance, Rounding::Counted);
        let accuracy = if error_estimate <= self.options.tolerance {
            Accuracy::Met
        } else {
            Accuracy::Short { estimate: error_estimate, tolerance: self.options.tolerance, because: self.shortfall }
        };
        Solution {
            regions: solved.regions(),
            constants: solved.converged.x.constants.clone(),
            unknowns: self.plan.unknowns.clone(),
            order: self.order,
            max_defect: measures.iter().fold(0.0, |max, measure| max.max(measure.largest)),
            max_boundary_residual: solved.worst_boundary_residual().0,
            error_estimate,
            accuracy,
            corrected: solved.is_corrected(),
            orientation: solved.converged.factorisation.orientation(),
            branch_check: self.check,
            stats: self.stats,
            history: self.history.clone(),
        }
    }
}
