//! The main loop: solve on a mesh, measure the defect, improve the mesh.

use crate::budget::Budget;
use crate::collocation::System;
use crate::collocation::evaluate::Derivatives;
use crate::collocation::grid::Grid;
use crate::collocation::plan::Plan;
use crate::error::{NewtonError, SolveError};
use crate::magnitude::Magnitudes;
use crate::measure::{Solved, intervals};
use crate::newton::{self, Converged, Limits};
use crate::observer::{Event, Observer};
use crate::options::{Control, Options};
use crate::orientation::{BranchCheck, Orientation};
use crate::phase::{Action, Finding, action, phase_after};
use crate::problem::{Layout, Problem};
use crate::progress::{Found, Next, Progress, Rescue, measured};
use crate::refine::{Measure, Rounding, Verdict, Wish, verdict};
use crate::solution::{Accuracy, MeshRecord, Shortfall, Solution};
use crate::start::{Start, halved, transfer};
use crate::stats::Stats;
use std::sync::Arc;

/// Defects are held to no less than this: each is known to a few units in the last place at best.
const LEAST_TARGET: f64 = 8.0 * f64::EPSILON;
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
    /// Whether the last solve's solution is the one that its start leads to.
    pub check: BranchCheck,
    orientation: Option<Orientation>,
    /// Why the last solve ended if not for a small estimated error.
    shortfall: Shortfall,
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
            check: BranchCheck::Kept,
            orientation: None,
            shortfall: Shortfall::Uncontrolled,
        }
    }

    /// Solves and improves the meshes until they pass: see [`phase`](crate::phase).
    pub(crate) fn refine(&mut self, mut start: Start) -> Result<Solved<'a, P>, SolveError> {
        let mut progress = Progress::new(self.options, &start);
        self.shortfall = Shortfall::Uncontrolled;
        (self.check, self.orientation) = (BranchCheck::Kept, None);
        for _ in 0..self.options.max_meshes {
            let found = self.solve_on(start, &mut progress)?;
            let finding = self.judge(&found, &progress);
            let action = action(progress.phase, finding);
            start = match self.act(action, found, &mut progress)? {
                Next::On(start) => start,
                Next::Done(solved) => return Ok(*solved),
            };
            progress.phase = phase_after(progress.phase, action);
            progress.first = false;
        }
        progress.fallback.ok_or_else(|| self.out_of_meshes())
    }

    /// What has been found on the present meshes.
    fn judge(&mut self, found: &Found<'a, P>, progress: &Progress<'a, P>) -> Finding {
        let Found::Solved(solved) = found else { return Finding::Failed };
        let measures = measured(solved, progress.target, progress.rounding());
        if measures.iter().any(|measure| !(measure.largest <= progress.target)) {
            return Finding::Rough;
        }
        if solved.converged.stagnated.is_some() {
            return Finding::Unconverged;
        }
        let known = self.keep && progress.first && solved.converged.at_once;
        if known && self.options.accept_inaccurate {
            self.shortfall = Shortfall::WarmStart;
            return Finding::Good;
        }
        if self.options.control == Control::Error && !(solved.error_estimate(&mut self.stats) <= self.options.tolerance)
        {
            return Finding::Inaccurate;
        }
        let coarser = |verdict: &Verdict| matches!(verdict, Verdict::Coarsen(_));
        let oversized = !known && self.verdicts(solved, &measures, progress).iter().any(coarser);
        if oversized { Finding::Oversized } else { Finding::Good }
    }

    /// Does what the table says.
    fn act(
        &mut self,
        action: Action,
        found: Found<'a, P>,
        progress: &mut Progress<'a, P>,
    ) -> Result<Next<'a, P>, SolveError> {
        let solved = match found {
            Found::Solved(solved) => solved,
            Found::Failed(start, error) => return self.rescued(action, *start, error, progress),
            Found::Undefined(error) => return progress.fallback.take().map(Next::done).ok_or(error),
        };
        match action {
            Action::Accept => Ok(Next::Done(solved)),
            Action::FallBack => progress.fallback.take().map(Next::done).ok_or_else(|| self.out_of_meshes()),
            Action::GiveUp | Action::Rescue => {
                let intervals = intervals(&solved.system.grids);
                let failed = |error| SolveError::Newton { error, intervals };
                let error = solved.converged.stagnated.map_or_else(|| self.out_of_meshes(), failed);
                progress.fallback.take().map(Next::done).ok_or(error)
            }
            Action::Refine => {
                let measures = measured(&solved, progress.target, progress.rounding());
                progress.note(measures.iter().fold(0.0, |max: f64, measure| max.max(measure.largest)));
                if progress.is_stuck()
                    && let Some(fallback) = progress.fallback.take()
                {
                    self.shortfall = Shortfall::Rounding;
                    return Ok(Next::done(fallback));
                }
                match self.refined(&solved, &measures, progress) {
                    Ok(meshes) => {
                        let start = transfer(&solved, meshes);
                        progress.coarser = Some(*solved);
                        Ok(Next::On(start))
                    }
                    Err(error) => progress.fallback.take().map(Next::done).ok_or(error),
                }
            }
            Action::Tighten => Ok(self.tightened(solved, progress)),
            Action::Coarsen => {
                let measures = measured(&solved, progress.target, progress.rounding());
                let verdicts = self.verdicts(&solved, &measures, progress).into_iter();
                let meshes = verdicts.zip(&solved.system.grids).map(|(verdict, grid)| match verdict {
                    Verdict::Coarsen(mesh) => mesh,
                    Verdict::Keep | Verdict::Refine(_) | Verdict::Exhausted => grid.mesh.clone(),
                });
                let start = transfer(&solved, meshes.collect());
                progress.fallback = Some(*solved);
                Ok(Next::On(start))
            }
        }
    }

    /// A guess that was a solution, without its negligible correction if that makes a defect exceed the tolerance:
    /// where the equations are stiff, they tell more of a solution than the tolerance of Newton's iteration.
    fn unless_worse(&mut self, mut solved: Solved<'a, P>, origin: Start) -> Result<Solved<'a, P>, SolveError> {
        let tolerance = self.options.tolerance;
        if measured(&solved, tolerance, Rounding::Counted).iter().all(|measure| measure.largest <= tolerance) {
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
    ///
    /// # Errors
    /// Only those that end the solve at once.
    fn solve_on(&mut self, start: Start, progress: &mut Progress<'a, P>) -> Result<Found<'a, P>, SolveError> {
        let Start { grids, x } = start;
        let system = self.system(grids);
        self.stats.meshes += 1;
        let before = self.stats.newton_iterations;
        let limits = self.limits(progress.rescue.insistent);
        let outcome = newton::solve(&system, &x, limits, &mut self.stats, self.observer, self.budget);
        if progress.first {
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
                self.check = self.check.and(BranchCheck::Strayed { at: 0.0 });
                return match failure {
                    newton::Failure::Newton(error) => {
                        Ok(Found::Failed(Box::new(Start { grids: system.grids, x }), error))
                    }
                    newton::Failure::Interrupted(error) => Err(error),
                };
            }
        };
        let orientation = converged.factorisation.orientation();
        let check = BranchCheck::of_iteration(converged.contraction, converged.full_steps);
        self.check = self.check.and(check).across(self.orientation, orientation);
        self.orientation = orientation.or(self.orientation);
        let solved = match Solved::new(system, converged, &mut self.stats) {
            Ok(solved) => solved,
            Err(error) => return Ok(Found::Undefined(error)),
        };
        let measures = measured(&solved, self.options.tolerance, Rounding::Counted);
        record.defects = measures.iter().map(|measure| measure.largest).collect();
        let defect = record.defects.iter().fold(0.0, |max: f64, defect| max.max(*defect));
        self.history.push(record);
        let event = Event::Mesh { intervals: intervals(&solved.system.grids), defect };
        self.budget.notify(self.observer, &event, &self.stats)?;
        let solved = match progress.rescue.origin.take() {
            Some(origin) if progress.first && solved.converged.at_once => self.unless_worse(solved, origin)?,
            _ => solved,
        };
        Ok(Found::Solved(Box::new(solved)))
    }

    fn system(&self, grids: Vec<Grid>) -> System<'a, P> {
        let (plan, tableau) = (self.plan.clone(), self.options.order.tableau());
        let magnitudes = Magnitudes::new(self.layout, self.options);
        System { problem: self.problem, layout: self.layout, plan, tableau, magnitudes, grids }
    }

    fn limits(&self, insistent: bool) -> Limits {
        Limits {
            tolerance: self.options.newton_tolerance(),
            stagnation: self.options.stagnation_tolerance(),
            iterations: self.options.max_iterations,
            smallest_damping: self.options.smallest_damping,
            insistent,
        }
    }

    /// A failed iteration may succeed on other meshes, or if it does not insist on progress.
    fn rescued(
        &self,
        action: Action,
        failed: Start,
        error: NewtonError,
        progress: &mut Progress<'a, P>,
    ) -> Result<Next<'a, P>, SolveError> {
        if action == Action::Rescue
            && let Some(start) = progress.doubled()
        {
            return Ok(Next::On(start));
        }
        if let Some(fallback) = progress.fallback.take() {
            return Ok(Next::done(fallback));
        }
        let largest = failed.grids.iter().map(Grid::intervals).max().unwrap_or(0);
        let hopeless = match &error {
            NewtonError::Singular { empty_equations, .. } => !empty_equations.is_empty(),
            NewtonError::NonFinite(_) => true,
            NewtonError::Stalled { .. } | NewtonError::IterationLimit { .. } => false,
        };
        let rescue = &mut progress.rescue;
        if !hopeless && rescue.halvings < self.options.rescues && 2 * largest <= self.options.max_intervals {
            rescue.halvings += 1;
            return Ok(Next::On(halved(&failed)));
        }
        match rescue.origin.take() {
            Some(origin) if !hopeless => {
                *rescue = Rescue { halvings: 0, insistent: false, origin: None };
                Ok(Next::On(origin))
            }
            _ => Err(SolveError::Newton { error, intervals: intervals(&failed.grids) }),
        }
    }

    /// Finer meshes where the defects are too large.
    ///
    /// # Errors
    /// The region whose mesh may not be finer; where defects are held to less than the tolerance, only if no region's
    /// may.
    fn refined(
        &self,
        solved: &Solved<'a, P>,
        measures: &[Measure],
        progress: &Progress<'a, P>,
    ) -> Result<Vec<Vec<f64>>, SolveError> {
        let tighter = progress.target < self.options.tolerance;
        let (mut meshes, mut refused, mut changed) = (Vec::new(), None, false);
        for (region, verdict) in self.verdicts(solved, measures, progress).into_iter().enumerate() {
            let old = &solved.system.grids[region].mesh;
            meshes.push(match verdict {
                Verdict::Keep | Verdict::Coarsen(_) => old.clone(),
                Verdict::Refine(mesh) => {
                    changed = true;
                    mesh
                }
                Verdict::Exhausted => {
                    refused = refused.or(Some(region));
                    old.clone()
                }
            });
        }
        match refused {
            Some(region) if !(tighter && changed) => Err(self.exhausted(region, solved, &measures[region])),
            _ => Ok(meshes),
        }
    }

    fn verdicts(&self, solved: &Solved<'a, P>, measures: &[Measure], progress: &Progress<'a, P>) -> Vec<Verdict> {
        let wish = Wish {
            tolerance: progress.target,
            order: self.options.order.tableau().defect_order,
            max_intervals: self.options.max_intervals,
            split_few: progress.split_few(),
        };
        let regions = solved.system.grids.iter().zip(measures);
        regions.map(|(grid, measure)| verdict(&grid.mesh, measure, &wish)).collect()
    }

    /// Holds the defects to less, in the measure in which the error exceeds the tolerance.
    fn tightened(&mut self, solved: Box<Solved<'a, P>>, progress: &mut Progress<'a, P>) -> Next<'a, P> {
        let error = solved.error_estimate(&mut self.stats);
        self.shortfall = Shortfall::Rounding;
        progress.stalled = if error <= PROGRESS * progress.error { 0 } else { progress.stalled + 1 };
        let better = error < progress.error;
        progress.error = progress.error.min(error);
        if progress.stalled < PATIENCE
            && let Some(start) = self.tighter(&solved, error, progress)
        {
            progress.coarser = None;
            if better {
                progress.fallback = Some(*solved);
                progress.fallback_doubled &= progress.stalled > 0;
            }
            return Next::On(start);
        }
        match progress.fallback.take() {
            Some(fallback) if !better => Next::done(fallback),
            _ => Next::Done(solved),
        }
    }

    /// Meshes for the largest defects below the present ones that ask for others; none if rounding or the limits of the
    /// meshes stand in the way.
    fn tighter(&mut self, solved: &Solved<'a, P>, error: f64, progress: &mut Progress<'a, P>) -> Option<Start> {
        let measures = measured(solved, progress.target, progress.rounding());
        let largest = measures.iter().fold(0.0, |max: f64, measure| max.max(measure.largest));
        let mut target = (0.5 * largest * self.options.tolerance / error).min(0.5 * progress.target);
        while progress.target > LEAST_TARGET {
            progress.target = target.max(LEAST_TARGET);
            target *= 0.5;
            let measures = measured(solved, progress.target, progress.rounding());
            if measures.iter().all(|measure| measure.largest <= progress.target) {
                continue;
            }
            // What ends the solve from here on is that finer meshes are not had.
            self.shortfall = Shortfall::Mesh;
            return self.refined(solved, &measures, progress).ok().map(|meshes| transfer(solved, meshes));
        }
        None
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

    fn solution(&self, solved: &Solved<'_, P>, error_estimate: f64) -> Solution {
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
            order: self.options.order,
            max_defect: measures.iter().fold(0.0, |max, measure| max.max(measure.largest)),
            max_boundary_residual: solved.worst_boundary_residual().0,
            error_estimate,
            accuracy,
            orientation: solved.converged.factorisation.orientation(),
            branch_check: self.check,
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
