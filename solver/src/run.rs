//! The main loop: solve on a mesh, measure the defect, improve the mesh.

use crate::budget::Budget;
use crate::collocation::System;
use crate::collocation::evaluate::Derivatives;
use crate::collocation::grid::Grid;
use crate::collocation::plan::Plan;
use crate::error::{NewtonError, SolveError};
use crate::measure::{Solved, intervals};
use crate::newton::{self, Converged, Limits};
use crate::observer::{Event, Observer};
use crate::options::{Control, Options};
use crate::problem::{Layout, Problem};
use crate::refine::{Measure, Verdict, measure, verdict};
use crate::solution::{Accuracy, MeshRecord, Shortfall, Solution};
use crate::start::{Start, halved, transfer, twice};
use crate::stats::Stats;
use std::sync::Arc;

/// A defect is a difference of slopes: on N intervals it is known to about N times this.
const ROUNDING: f64 = 8.0 * f64::EPSILON;
/// Defects held to less must bring the estimated error below this fraction of the least so far,
const PROGRESS: f64 = 0.7;
/// once in so many meshes, or what is left of it is due to rounding.
const PATIENCE: usize = 3;

/// One solve, or the solves of one continuation: what they share, and what they have cost so far.
pub(crate) struct Run<'a, 'o, P: Problem + ?Sized> {
    problem: &'a P,
    layout: &'a Layout,
    plan: Arc<Plan>,
    pub options: &'o Options,
    pub observer: &'o mut dyn Observer,
    pub budget: &'o Budget,
    pub stats: Stats,
    pub history: Vec<MeshRecord>,
    /// Newton's first contraction on the first mesh of the last solve; infinite if it failed.
    pub contraction: f64,
    /// Whether a guess that is a solution already keeps its mesh, whatever its estimated error.
    pub keep: bool,
    /// Why the last solve ended if not for a small estimated error.
    shortfall: Shortfall,
}

/// State of one solve.
struct Progress<'a, P: Problem + ?Sized> {
    rescue: Rescue,
    /// What defects are held to at present.
    target: f64,
    /// A solution that meets the tolerance, while a better one, or one on coarser meshes, is sought.
    fallback: Option<Solved<'a, P>>,
    /// Least estimated error so far that exceeds the tolerance: the fallback's.
    error: f64,
    /// Meshes since it last fell.
    vain: usize,
    coarsening: bool,
    /// The solution that the present meshes were made from, while the tolerance is not met.
    coarser: Option<Solved<'a, P>>,
    fallback_doubled: bool,
}

impl<P: Problem + ?Sized> Progress<'_, P> {
    /// Where refined meshes have lost a solution: the one they were made from, on its own meshes doubled; once.
    fn doubled(&mut self) -> Option<Start> {
        if self.coarsening {
            return None;
        }
        if let Some(coarser) = self.coarser.take() {
            return Some(transfer(&coarser, twice(&coarser)));
        }
        let fallback = self.fallback.as_ref().filter(|_| !self.fallback_doubled)?;
        self.fallback_doubled = true;
        Some(transfer(fallback, twice(fallback)))
    }
}

/// What is tried when Newton's iteration fails: halved meshes, then the same again boldly.
struct Rescue {
    halvings: usize,
    bold: bool,
    /// The guess, as long as no mesh has brought convergence.
    origin: Option<Start>,
}

/// What to do about a solution whose defects meet their target.
enum Next {
    Accept,
    /// The fallback is the better one.
    Fallback,
    Remesh(Vec<Vec<f64>>),
    /// The fallback may remain the better one.
    Tighten(Vec<Vec<f64>>),
}

impl<'a, 'o, P: Problem + ?Sized> Run<'a, 'o, P> {
    pub(crate) fn new(
        problem: &'a P,
        plan: Plan,
        options: &'o Options,
        observer: &'o mut dyn Observer,
        budget: &'o Budget,
    ) -> Self {
        Self {
            problem,
            layout: problem.layout(),
            plan: Arc::new(plan),
            options,
            observer,
            budget,
            stats: Stats::default(),
            history: Vec::new(),
            contraction: 0.0,
            keep: true,
            shortfall: Shortfall::Uncontrolled,
        }
    }

    /// Solves and improves the meshes until they pass.
    pub(crate) fn refine(&mut self, mut start: Start) -> Result<Solved<'a, P>, SolveError> {
        let origin = (self.options.rescues > 0).then(|| start.clone());
        let rescue = Rescue { halvings: 0, bold: false, origin };
        let (target, error) = (self.options.tolerance, f64::INFINITY);
        let mut progress = Progress {
            rescue,
            target,
            fallback: None,
            error,
            vain: 0,
            coarsening: false,
            coarser: None,
            fallback_doubled: false,
        };
        self.shortfall = Shortfall::Uncontrolled;
        for attempt in 0..self.options.max_meshes {
            let solved = match self.solve_on(start, attempt == 0, progress.rescue.bold) {
                Ok(solved) => solved,
                Err(Stop::Error(error)) if error.is_interruption() => return Err(error),
                Err(Stop::Error(error)) => return progress.fallback.ok_or(error),
                Err(Stop::Newton(failed, error)) => {
                    if let Some(meshes) = progress.doubled() {
                        start = meshes;
                        continue;
                    }
                    if let Some(fallback) = progress.fallback {
                        return Ok(fallback);
                    }
                    start = self.rescued(*failed, error, &mut progress.rescue)?;
                    continue;
                }
            };
            let solved = match progress.rescue.origin.take() {
                Some(origin) if attempt == 0 && solved.converged.at_once => self.unless_worse(solved, origin)?,
                _ => solved,
            };
            let measures = measured(&solved, progress.target);
            let passes = measures.iter().all(|measure| measure.largest <= progress.target);
            if progress.coarsening && !passes {
                return progress.fallback.ok_or_else(|| self.out_of_meshes());
            }
            if !passes {
                start = match self.refined(&solved, &measures, progress.target) {
                    Ok(meshes) => transfer(&solved, meshes),
                    Err(error) => return progress.fallback.ok_or(error),
                };
                progress.coarser = Some(solved);
                continue;
            }
            if let Some(error) = solved.converged.stagnated.clone() {
                let intervals = intervals(&solved.system.grids);
                return progress.fallback.ok_or(SolveError::Newton { error, intervals });
            }
            let again = self.keep && attempt == 0 && solved.converged.at_once;
            match self.improve(&solved, again, &mut progress) {
                Next::Accept => return Ok(solved),
                Next::Fallback => return Ok(progress.fallback.unwrap_or(solved)),
                Next::Remesh(meshes) => {
                    start = transfer(&solved, meshes);
                    progress.fallback = Some(solved);
                }
                Next::Tighten(meshes) => {
                    start = transfer(&solved, meshes);
                    progress.coarser = None;
                    if progress.vain == 0 {
                        (progress.fallback, progress.fallback_doubled) = (Some(solved), false);
                    }
                }
            }
        }
        progress.fallback.ok_or_else(|| self.out_of_meshes())
    }

    /// A guess that was a solution, without its negligible correction if that makes a defect exceed the tolerance: where
    /// the equations are stiff, they tell more of a solution than the tolerance of Newton's iteration.
    fn unless_worse(&mut self, mut solved: Solved<'a, P>, origin: Start) -> Result<Solved<'a, P>, SolveError> {
        let tolerance = self.options.tolerance;
        if measured(&solved, tolerance).iter().all(|measure| measure.largest <= tolerance) {
            return Ok(solved);
        }
        let converged = &mut solved.converged;
        converged.x = origin.x;
        let evaluated = solved.system.evaluate(&converged.x, Derivatives::None, &mut converged.work, &mut self.stats);
        evaluated.map_err(|error| SolveError::Newton {
            error: NewtonError::NonFinite(error),
            intervals: intervals(&solved.system.grids),
        })?;
        Solved::new(solved.system, solved.converged, &mut self.stats)
    }

    /// Newton's iteration on one set of meshes.
    fn solve_on(&mut self, start: Start, first: bool, bold: bool) -> Result<Solved<'a, P>, Stop> {
        let Start { grids, x } = start;
        let system = self.system(grids);
        self.stats.meshes += 1;
        let before = self.stats.newton_iterations;
        let outcome = newton::solve(&system, &x, self.limits(bold), &mut self.stats, self.observer, self.budget);
        if first {
            self.contraction = outcome.as_ref().map_or(f64::INFINITY, |converged| converged.contraction);
        }
        let mut record = MeshRecord {
            intervals: system.grids.iter().map(Grid::intervals).collect(),
            defects: vec![f64::INFINITY; system.grids.len()],
            newton_iterations: self.stats.newton_iterations - before,
        };
        let converged = match outcome {
            Ok(converged) => converged,
            Err(failure) => {
                self.history.push(record);
                return Err(match failure {
                    newton::Failure::Newton(error) => Stop::Newton(Box::new(Start { grids: system.grids, x }), error),
                    newton::Failure::Interrupted(error) => Stop::Error(error),
                });
            }
        };
        let solved = Solved::new(system, converged, &mut self.stats).map_err(Stop::Error)?;
        record.defects = measured(&solved, self.options.tolerance).iter().map(|measure| measure.largest).collect();
        let defect = record.defects.iter().fold(0.0, |max: f64, defect| max.max(*defect));
        self.history.push(record);
        let event = Event::Mesh { intervals: intervals(&solved.system.grids), defect };
        self.budget.notify(self.observer, &event, &self.stats).map_err(Stop::Error)?;
        Ok(solved)
    }

    fn system(&self, grids: Vec<Grid>) -> System<'a, P> {
        let (plan, tableau) = (self.plan.clone(), self.options.order.tableau());
        System { problem: self.problem, layout: self.layout, plan, tableau, grids }
    }

    fn limits(&self, bold: bool) -> Limits {
        Limits {
            tolerance: self.options.newton_tolerance(),
            stagnation: self.options.stagnation_tolerance(),
            iterations: self.options.max_iterations,
            smallest_damping: self.options.smallest_damping,
            bold,
        }
    }

    /// A failed iteration may succeed on finer meshes, or boldly.
    fn rescued(&self, failed: Start, error: NewtonError, rescue: &mut Rescue) -> Result<Start, SolveError> {
        let largest = failed.grids.iter().map(Grid::intervals).max().unwrap_or(0);
        let hopeless = match &error {
            NewtonError::Singular { empty_equations, .. } => !empty_equations.is_empty(),
            NewtonError::NonFinite(_) => true,
            _ => false,
        };
        if !hopeless && rescue.halvings < self.options.rescues && 2 * largest <= self.options.max_intervals {
            rescue.halvings += 1;
            return Ok(halved(&failed));
        }
        match rescue.origin.take() {
            Some(origin) if !hopeless => {
                *rescue = Rescue { halvings: 0, bold: true, origin: None };
                Ok(origin)
            }
            _ => Err(SolveError::Newton { error, intervals: intervals(&failed.grids) }),
        }
    }

    /// Finer meshes where the defects are too large.
    fn refined(&self, solved: &Solved<'a, P>, measures: &[Measure], target: f64) -> Result<Vec<Vec<f64>>, SolveError> {
        let mut meshes = Vec::new();
        for (region, verdict) in self.verdicts(solved, measures, target).into_iter().enumerate() {
            meshes.push(match verdict {
                Verdict::Keep | Verdict::Coarsen(_) => solved.system.grids[region].mesh.clone(),
                Verdict::Refine(mesh) => mesh,
                Verdict::Exhausted => return Err(self.exhausted(region, solved, &measures[region])),
            });
        }
        Ok(meshes)
    }

    fn verdicts(&self, solved: &Solved<'a, P>, measures: &[Measure], target: f64) -> Vec<Verdict> {
        let order = self.options.order.tableau().defect_order;
        let most = self.options.max_intervals;
        let regions = solved.system.grids.iter().zip(measures);
        regions.map(|(grid, measure)| verdict(&grid.mesh, measure, target, order, most)).collect()
    }

    /// Defects meet their target: is the estimated error small enough, are the meshes not far too fine?
    fn improve(&mut self, solved: &Solved<'a, P>, again: bool, progress: &mut Progress<'a, P>) -> Next {
        if again {
            self.shortfall = Shortfall::WarmStart;
            return Next::Accept;
        }
        let tolerance = self.options.tolerance;
        if self.options.control == Control::Error {
            let error = solved.error_estimate(&mut self.stats);
            if !(error <= tolerance) {
                if progress.coarsening {
                    return Next::Fallback;
                }
                return self.tightened(solved, error, progress);
            }
        }
        let verdicts = self.verdicts(solved, &measured(solved, progress.target), progress.target);
        if !verdicts.iter().any(|verdict| matches!(verdict, Verdict::Coarsen(_))) {
            return Next::Accept;
        }
        progress.coarsening = true;
        let meshes = verdicts.into_iter().zip(&solved.system.grids).map(|(verdict, grid)| match verdict {
            Verdict::Coarsen(mesh) => mesh,
            _ => grid.mesh.clone(),
        });
        Next::Remesh(meshes.collect())
    }

    /// Holds the defects to less, in the measure in which the error exceeds the tolerance.
    fn tightened(&mut self, solved: &Solved<'a, P>, error: f64, progress: &mut Progress<'a, P>) -> Next {
        self.shortfall = Shortfall::Rounding;
        progress.vain = if error <= PROGRESS * progress.error { 0 } else { progress.vain + 1 };
        let best = if error < progress.error { Next::Accept } else { Next::Fallback };
        progress.error = progress.error.min(error);
        if progress.vain >= PATIENCE {
            return best;
        }
        let largest = measured(solved, progress.target).iter().fold(0.0, |max: f64, measure| max.max(measure.largest));
        let mut target = (0.5 * largest * self.options.tolerance / error).min(0.5 * progress.target);
        let intervals = solved.system.grids.iter().map(Grid::intervals).max().unwrap_or(0);
        let floor = ROUNDING * intervals as f64;
        while progress.target > floor {
            progress.target = target.max(floor);
            target *= 0.5;
            let measures = measured(solved, progress.target);
            if measures.iter().all(|measure| measure.largest <= progress.target) {
                continue;
            }
            // What ends the solve from here on is that finer meshes are not had.
            self.shortfall = Shortfall::Mesh;
            return match self.refined(solved, &measures, progress.target) {
                Ok(meshes) => Next::Tighten(meshes),
                Err(_) => best,
            };
        }
        best
    }

    fn exhausted(&self, region: usize, solved: &Solved<'a, P>, measure: &Measure) -> SolveError {
        let (names, grid) = (&self.layout.regions[region], &solved.system.grids[region]);
        let state = solved.defects[region].state.get(measure.worst).and_then(|&state| names.states.get(state));
        SolveError::MeshLimit {
            region: names.name.clone(),
            position: grid.mesh[measure.worst],
            state: state.map_or_else(String::new, |state| state.name.clone()),
            defect: measure.largest,
            tolerance: self.options.tolerance,
            intervals: grid.intervals(),
        }
    }

    fn out_of_meshes(&self) -> SolveError {
        let (defects, counts) = self.history.last().map_or((&[][..], &[][..]), |last| (&last.defects, &last.intervals));
        let worst = (0..defects.len()).max_by(|&i, &j| defects[i].total_cmp(&defects[j])).unwrap_or(0);
        let region = self.layout.regions.get(worst);
        SolveError::MeshLimit {
            region: region.map_or_else(String::new, |region| region.name.clone()),
            position: region.map_or(f64::NAN, |region| region.interval.0),
            state: "one of its states".to_owned(),
            defect: defects.get(worst).copied().unwrap_or(f64::NAN),
            tolerance: self.options.tolerance,
            intervals: counts.get(worst).copied().unwrap_or(0),
        }
    }

    /// A solution known to be one, without an iteration; its error is not estimated.
    pub(crate) fn as_it_stands(&mut self, Start { grids, x }: Start) -> Result<Solution, SolveError> {
        let system = self.system(grids);
        let mut work = system.work();
        system.evaluate(&x, Derivatives::Planned, &mut work, &mut self.stats).map_err(|error| SolveError::Newton {
            error: NewtonError::NonFinite(error),
            intervals: intervals(&system.grids),
        })?;
        let converged = Converged::known(&system, x, work);
        let solved = Solved::new(system, converged, &mut self.stats)?;
        Ok(self.solution(&solved, f64::NAN))
    }

    /// The solution, if its boundary residuals too meet their tolerance.
    pub(crate) fn finish(&mut self, solved: &Solved<'_, P>) -> Result<Solution, SolveError> {
        let (residual, equation) = solved.worst_boundary_residual();
        let tolerance = self.options.boundary_tolerance();
        if !(residual <= tolerance) {
            return Err(SolveError::Boundary { equation, residual, tolerance });
        }
        let error_estimate = solved.error_estimate(&mut self.stats);
        Ok(self.solution(solved, error_estimate))
    }

    fn solution(&self, solved: &Solved<'_, P>, error_estimate: f64) -> Solution {
        let measures = measured(solved, self.options.tolerance);
        let accuracy = if error_estimate <= self.options.tolerance {
            Accuracy::Met
        } else {
            Accuracy::Short { estimate: error_estimate, tolerance: self.options.tolerance, because: self.shortfall }
        };
        Solution {
            regions: solved.regions(),
            constants: solved.converged.x.constants.clone(),
            unknowns: self.plan.unknowns.clone(),
            order: self.options.order,
            max_defect: measures.iter().fold(0.0, |max, measure| max.max(measure.largest)),
            max_boundary_residual: solved.worst_boundary_residual().0,
            error_estimate,
            accuracy,
            stats: self.stats,
            history: self.history.clone(),
        }
    }
}

/// What a run has cost stands against the budget of the call it belongs to.
impl<P: Problem + ?Sized> Drop for Run<'_, '_, P> {
    fn drop(&mut self) {
        self.budget.charge(&self.stats);
    }
}

/// Why there is no converged iterate on a set of meshes.
enum Stop {
    Newton(Box<Start>, NewtonError),
    Error(SolveError),
}

fn measured<P: Problem + ?Sized>(solved: &Solved<'_, P>, target: f64) -> Vec<Measure> {
    solved.defects.iter().map(|defects| measure(defects, target)).collect()
}
