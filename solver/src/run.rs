//! The main loop: solve on a mesh, measure the defect, improve the mesh.

mod afar;
mod doubt;
mod meshes;
mod outcome;
mod rest;

use crate::accuracy::Shortfall;
use crate::budget::Budget;
use crate::collocation::evaluate::Derivatives;
use crate::collocation::grid::{Grid, intervals};
use crate::collocation::linear_problem::has_all_derivatives;
use crate::collocation::plan::Plan;
use crate::collocation::{Iterate, System};
use crate::error::{MeshBound, NewtonError, SolveError};
use crate::magnitude::Magnitudes;
use crate::measure::{Solved, Undefined, undefined};
use crate::mesh::split;
use crate::newton::{self, Converged, Limits};
use crate::observer::{Event, Observer};
use crate::options::{Control, Options, Order};
use crate::orientation::{BranchCheck, Orientation};
use crate::phase::{Action, Finding, Phase, action, phase_after};
use crate::problem::{Layout, Problem};
use crate::progress::{Failed, Found, Next, Progress, measured};
use crate::refine::{Measure, Rounding, Verdict};
use crate::solution::MeshRecord;
use crate::start::{Start, carried, transfer};
use crate::stats::Stats;
use crate::tableau::Tableau;
use doubt::Doubt;
use std::sync::Arc;

/// Defects are held to no less than this: each is known to a few units in the last place at best.
const LEAST_TARGET: f64 = 8.0 * f64::EPSILON;
/// Defects held to less must bring the estimated error below this fraction of the least so far,
const PROGRESS: f64 = 0.7;
/// once in so many meshes, or what is left of it is due to rounding.
const PATIENCE: usize = 3;
/// Defects that are to be smaller for the error's sake need not be if its estimate is below this fraction of the
/// tolerance, and not at the tolerance itself: where right-hand sides have kinks, an estimate may be off several times.
const SURELY: f64 = 0.1;
/// Fewer intervals, all regions together, are no trouble: what saves a mesh or an iteration on them is not worth its
/// own cost.
const MANY: usize = 200;
/// A problem that says that it is linear, or seems so, is believed on so many meshes; if the defects are too large on
/// that, too, it is seen whether it is.
const CHECKED: usize = 3;
/// Of a problem that only seems linear, little enough is left by a first step to be of no account at tolerances from
/// here on.
const LINEAR_ENOUGH: f64 = 1e-8;
/// The one correction that solves a linear problem leaves what its rounding is. Where equations are so stiff that this
/// is amplified beyond the tolerance, finer meshes hardly lower the defects, and a second correction does: one that is
/// no larger than this, in typical magnitudes, is the last.
const ROUNDED: f64 = 1e-14;
/// Defects of another order than wanted up to which it is gone on with.
const ROUGHLY: f64 = 1e-2;

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
    /// Newton iterations on that mesh; 0 if it failed.
    pub iterations: usize,
    /// Whether a guess that is a solution already keeps its mesh, whatever its estimated error.
    pub keep: bool,
    /// Whether meshes that are far finer than need be are made coarser.
    pub coarsen: bool,
    /// Whether a guess on fine meshes that is far from the solution is first brought near it on coarse ones.
    pub from_afar: bool,
    /// Whether a solution at rest that leaves constants undetermined is none: see [`rest`]. On a branch what is left
    /// undetermined is another matter, and looked for.
    pub needs_determined: bool,
    /// Whether the last solve's solution is the one that its start leads to.
    pub check: BranchCheck,
    orientation: Option<Orientation>,
    /// Whether that of the last meshes is not that of those before.
    turned: bool,
    /// Whether the problem says that it is linear: see [`Problem::is_linear`].
    said_linear: bool,
    /// Whether the problem is linear, as it says or as an iteration of this solve has shown.
    linear: bool,
    /// Whether what a linear right-hand side is may be taken from its derivatives, to this tolerance.
    follow: bool,
    /// Meshes of this solve on which it has been.
    meshes_followed: usize,
    /// That of the options, but while a start for it is sought with another.
    order: Order,
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
        let derivatives = has_all_derivatives(problem.layout(), &plan);
        let said_linear = derivatives && problem.is_linear(&plan.unknowns);
        let follow = derivatives && (said_linear || options.tolerance >= LINEAR_ENOUGH);
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
            iterations: 0,
            keep: true,
            coarsen: true,
            from_afar: false,
            needs_determined: true,
            check: BranchCheck::Kept,
            orientation: None,
            turned: false,
            said_linear,
            linear: said_linear,
            follow,
            meshes_followed: 0,
            order: options.order,
            shortfall: Shortfall::Uncontrolled,
        }
    }

    /// Solves and improves the meshes until they pass: see [`phase`](crate::phase).
    pub(crate) fn refine(&mut self, mut start: Start) -> Result<Solved<'a, P>, SolveError> {
        let mut progress = Progress::new(self.options, self.layout.regions.len());
        (self.shortfall, self.order) = (Shortfall::Uncontrolled, self.options.order);
        (self.check, self.orientation, self.linear) = (BranchCheck::Kept, None, self.said_linear);
        (self.meshes_followed, self.turned) = (0, false);
        let mut meshes = 0;
        loop {
            let mut found = self.solve_on(start, &mut progress)?;
            meshes += 1;
            if let Some(next) = self.promoted(&found, &progress) {
                start = next;
                progress.first = false;
                continue;
            }
            let mut finding = self.judge(&found, &progress);
            match self.doubt(&mut found, finding, meshes < self.options.max_meshes) {
                Doubt::None => {}
                _ if progress.phase == Phase::Coarsen => finding = Finding::Inaccurate,
                Doubt::Again(next) => {
                    start = next;
                    progress.first = false;
                    continue;
                }
                Doubt::Inaccurate(because) => (self.shortfall, finding) = (because, Finding::Good),
            }
            let action = action(progress.phase, finding);
            let is_last = meshes >= self.options.max_meshes && action != Action::Accept;
            let unsolved = is_last.then(|| self.unsolved(&found));
            start = match self.act(action, found, &mut progress)? {
                Next::On(start) => start,
                Next::Done(solved) => return Ok(*solved),
            };
            if let Some(error) = unsolved {
                return progress.fallback.ok_or(error);
            }
            progress.phase = phase_after(progress.phase, action);
            progress.first = false;
        }
    }

    /// What has been found with another order than wanted, as a start for that: once it is roughly right. A lower
    /// order than the one it was found with begins on shorter intervals.
    fn promoted(&mut self, found: &Found<'a, P>, progress: &Progress<'a, P>) -> Option<Start> {
        let Found::Solved(solved) = found else { return None };
        let enough = ROUGHLY.max(progress.target);
        let rough = || measured(solved, enough, Rounding::Counted).iter().any(|measure| !(measure.largest <= enough));
        if self.order == self.options.order || rough() {
            return None;
        }
        let pieces = self.order.number().div_ceil(self.options.order.number());
        self.order = self.options.order;
        let meshes = solved.system.grids.iter().map(|grid| {
            let pieces = if grid.intervals() * pieces <= self.options.max_intervals { pieces } else { 1 };
            split(&grid.mesh, &vec![pieces; grid.intervals()])
        });
        Some(carried(solved, meshes.collect(), self.tableau()))
    }

    /// What has been found on the present meshes.
    fn judge(&mut self, found: &Found<'a, P>, progress: &Progress<'a, P>) -> Finding {
        let Found::Solved(solved) = found else { return Finding::Failed };
        let meet = |target: f64| {
            measured(solved, target, progress.rounding_at(target)).iter().all(|measure| measure.largest <= target)
        };
        if !meet(progress.target) {
            // If they are held to less than the tolerance, that is for the error's sake.
            let tolerance = progress.tolerance;
            let enough = progress.target < tolerance
                && meet(tolerance)
                && solved.converged.stagnated.is_none()
                && solved.error_estimate(&mut self.stats) <= SURELY * tolerance;
            return if enough { Finding::Good } else { Finding::Rough };
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
        let measures = measured(solved, progress.target, progress.rounding());
        let coarser = |(region, measure): (usize, &Measure)| {
            matches!(self.verdict(solved, region, measure, progress.target, progress), Verdict::Coarsen(_))
        };
        let oversized = self.coarsen && !known && !progress.for_integrals && measures.iter().enumerate().any(coarser);
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
            Found::Failed(failed) => return self.rescued(action, *failed, progress),
        };
        // Where finer meshes would be the next to try, it is their intervals that are too many.
        let finer = MeshBound::Intervals { most: self.options.max_intervals };
        match action {
            Action::Accept => Ok(Next::Done(solved)),
            Action::FallBack => progress.fallback.take().map(Next::done).ok_or_else(|| self.too_rough(&solved, finer)),
            Action::GiveUp | Action::Rescue => {
                if action == Action::Rescue
                    && let Some(start) = progress.doubled()
                {
                    return Ok(Next::On(start));
                }
                let intervals = intervals(&solved.system.grids);
                let failed = |error| SolveError::Newton { error, intervals };
                let stagnated = solved.converged.stagnated.clone();
                let error = stagnated.map_or_else(|| self.too_rough(&solved, finer), failed);
                progress.fallback.take().map(Next::done).ok_or(error)
            }
            Action::Refine => {
                let measures = measured(&solved, progress.target, progress.rounding());
                progress.note(&measures);
                if progress.is_stuck()
                    && let Some(fallback) = progress.fallback.take()
                {
                    return Ok(self.doubled_or_done(fallback, progress));
                }
                match self.aimed(&solved, &measures, progress) {
                    Ok(meshes) => {
                        let count: usize = meshes.iter().map(|mesh| mesh.len() - 1).sum();
                        let start = transfer(&solved, meshes);
                        progress.refined_from(*solved, count);
                        Ok(Next::On(start))
                    }
                    Err(error) => progress.fallback.take().map(Next::done).ok_or(error),
                }
            }
            Action::Tighten => Ok(self.tightened(solved, progress)),
            Action::Coarsen => {
                let measures = measured(&solved, progress.target, progress.rounding());
                let meshes = measures.iter().enumerate().map(|(region, measure)| {
                    match self.verdict(&solved, region, measure, progress.target, progress) {
                        Verdict::Coarsen(mesh) => mesh,
                        Verdict::Keep | Verdict::Refine(_) | Verdict::Exhausted => {
                            solved.system.grids[region].mesh.clone()
                        }
                    }
                });
                let start = transfer(&solved, meshes.collect());
                progress.fallback = Some(*solved);
                Ok(Next::On(start))
            }
        }
    }

    /// A guess that was a solution, without its negligible correction if that makes a defect exceed the tolerance:
    /// where the equations are stiff, they tell more of a solution than the tolerance of Newton's iteration.
    fn unless_worse(&mut self, mut solved: Solved<'a, P>, origin: Iterate) -> Result<Solved<'a, P>, SolveError> {
        let tolerance = self.options.tolerance;
        if measured(&solved, tolerance, Rounding::Counted).iter().all(|measure| measure.largest <= tolerance) {
            return Ok(solved);
        }
        let converged = &mut solved.converged;
        let inner = std::mem::take(&mut converged.x.inner);
        converged.x = Iterate { inner, ..origin };
        let evaluated = solved.system.evaluate(&converged.x, Derivatives::None, &mut converged.work, &mut self.stats);
        evaluated.map_err(undefined(&solved.system.grids))?;
        Ok(Solved::new(solved.system, solved.converged, tolerance, &mut self.stats)?)
    }

    /// Newton's iteration on one set of meshes, and what is to be said of where it ends.
    ///
    /// # Errors
    /// Only those that end the solve at once.
    fn solve_on(&mut self, start: Start, progress: &mut Progress<'a, P>) -> Result<Found<'a, P>, SolveError> {
        let Start { grids, x } = start;
        let (system, before) = (self.system(grids), self.stats.newton_iterations);
        let factorisations = self.stats.factorisations;
        let outcome = self.iterated(&system, &x, progress);
        progress.rescue.begun |= self.stats.factorisations > factorisations;
        let record = MeshRecord {
            intervals: system.grids.iter().map(Grid::intervals).collect(),
            defects: vec![f64::INFINITY; system.grids.len()],
            newton_iterations: self.stats.newton_iterations - before,
        };
        match outcome {
            Ok(converged) => self.converged_on(system, converged, x, record, progress),
            Err(failure) => {
                self.history.push(record);
                self.failed_on(Start { grids: system.grids, x }, failure, progress)
            }
        }
    }

    fn iterated(
        &mut self,
        system: &System<'a, P>,
        x: &Iterate,
        progress: &Progress<'a, P>,
    ) -> Result<Converged, newton::Failure> {
        self.stats.meshes += 1;
        let far = if progress.first && !self.said_linear { self.far(&system.grids) } else { None };
        let layers = progress.layers.iter().flatten().any(|layers| !layers.is_empty());
        let mut limits = Limits { far, layers, ..self.limits(progress.rescue.insistent) };
        if self.linear && progress.is_lost_in_rounding() {
            limits.tolerance = limits.tolerance.min(ROUNDED);
        }
        let outcome = newton::solve(system, x, limits, &mut self.stats, self.observer, self.budget);
        if progress.first {
            self.contraction = outcome.as_ref().map_or(f64::INFINITY, |converged| converged.contraction);
            self.iterations = outcome.as_ref().map_or(0, |converged| converged.iterations);
        }
        let converged = outcome?;
        match self.undetermined_at_rest(system, &converged) {
            Some(error) => Err(error.into()),
            None => Ok(converged),
        }
    }

    /// `start`: where the iteration that failed began.
    ///
    /// # Errors
    /// As [`solve_on`](Self::solve_on).
    fn failed_on(
        &mut self,
        start: Start,
        failure: newton::Failure,
        progress: &mut Progress<'a, P>,
    ) -> Result<Found<'a, P>, SolveError> {
        match failure {
            newton::Failure::Far(nearer, _) => {
                let near = self.approached(start, *nearer, progress)?;
                self.solve_on(near, progress)
            }
            newton::Failure::Newton(error) => {
                self.check = self.check.and(BranchCheck::Strayed { at: 0.0 });
                if progress.first && self.options.rescues > 0 {
                    progress.rescue.origin = Some(start.clone());
                }
                Ok(Found::Failed(Box::new(Failed { start, error, converged: false })))
            }
            newton::Failure::Interrupted(error) => Err(error),
        }
    }

    /// `x`: where the iteration began.
    ///
    /// # Errors
    /// As [`solve_on`](Self::solve_on).
    fn converged_on(
        &mut self,
        system: System<'a, P>,
        mut converged: Converged,
        x: Iterate,
        mut record: MeshRecord,
        progress: &mut Progress<'a, P>,
    ) -> Result<Found<'a, P>, SolveError> {
        converged.linear |= self.linear;
        self.linear = converged.linear;
        let orientation = converged.factorisation.orientation();
        let check = BranchCheck::of_iteration(converged.contraction, converged.full_steps);
        self.check = self.check.and(check).across(self.orientation, orientation);
        self.turned = self.orientation.is_some_and(|before| orientation.is_some_and(|after| before != after));
        self.orientation = orientation.or(self.orientation);
        // What is known of a rough solution is where a nonlinear iteration starts on the next mesh.
        let limit = if converged.seems_linear() { self.options.tolerance } else { f64::INFINITY };
        let solved = match Solved::new(system, converged, limit, &mut self.stats) {
            Ok(solved) => solved,
            Err(undefined) => {
                let Undefined { grids, x: found, error } = *undefined;
                if progress.first && self.options.rescues > 0 {
                    progress.rescue.origin = Some(Start { grids: grids.clone(), x });
                }
                let (start, error) = (Start { grids, x: found }, NewtonError::NonFinite(error));
                return Ok(Found::Failed(Box::new(Failed { start, error, converged: true })));
            }
        };
        let measures = measured(&solved, self.options.tolerance, Rounding::Counted);
        record.defects = measures.iter().map(|measure| measure.largest).collect();
        let defect = record.defects.iter().fold(0.0, |max: f64, defect| max.max(*defect));
        self.history.push(record);
        let event = Event::Mesh { intervals: intervals(&solved.system.grids), defect };
        self.budget.notify(self.observer, &event, &self.stats)?;
        if solved.system.linear {
            self.believe(&solved, defect)?;
        }
        if !self.options.other_orders && self.order == self.options.order {
            progress.rescue.origin = None;
        }
        if progress.first && self.options.rescues > 0 {
            if solved.converged.at_once {
                return Ok(Found::Solved(Box::new(self.unless_worse(solved, x)?)));
            }
            if self.options.other_orders && !solved.converged.seems_linear() {
                progress.rescue.origin = Some(Start { grids: solved.system.grids.clone(), x });
            }
        }
        Ok(Found::Solved(Box::new(solved)))
    }

    /// Whether what has been taken from derivatives on this mesh, too, was so: asked where defects are too large on the
    /// last of [`CHECKED`] meshes on which the first correction led to a solution: where it does not, rounding is as
    /// large as what is looked for. What only seemed linear is taken for nonlinear from there on.
    ///
    /// # Errors
    /// [`SolveError::NotLinear`], if the problem says that it is linear, and is not.
    fn believe(&mut self, solved: &Solved<'a, P>, defect: f64) -> Result<(), SolveError> {
        if solved.converged.iterations > 1 {
            return Ok(());
        }
        self.meshes_followed += 1;
        if self.meshes_followed != CHECKED || defect <= self.options.tolerance {
            return Ok(());
        }
        match solved.system.check_linear(&solved.converged.x, &solved.converged.work, &mut self.stats) {
            Err(error) if self.said_linear => return Err(error),
            Err(_) => (self.linear, self.follow) = (false, false),
            Ok(()) => {}
        }
        Ok(())
    }

    fn tableau(&self) -> &'static Tableau {
        self.order.tableau()
    }

    fn system(&self, grids: Vec<Grid>) -> System<'a, P> {
        let (plan, tableau) = (self.plan.clone(), self.tableau());
        let magnitudes = Magnitudes::new(self.layout, self.options);
        let linear = self.linear && self.follow;
        System { problem: self.problem, layout: self.layout, plan, linear, tableau, magnitudes, grids }
    }

    fn limits(&self, insistent: bool) -> Limits {
        Limits {
            tolerance: self.options.newton_tolerance(),
            boundary: self.options.boundary_tolerance(),
            stagnation: self.options.stagnation_tolerance(),
            far: None,
            iterations: self.options.max_iterations,
            smallest_damping: self.options.smallest_damping,
            insistent,
            layers: false,
        }
    }
}

/// What a run has cost stands against the budget of the call it belongs to.
impl<P: Problem + ?Sized> Drop for Run<'_, '_, P> {
    fn drop(&mut self) {
        self.budget.charge(&self.stats);
    }
}
