//! Which meshes to go on with: finer ones where defects are too large, halved ones where Newton's iteration failed.

use super::{LEAST_TARGET, MANY, PATIENCE, PROGRESS, Run};
use crate::accuracy::Shortfall;
use crate::by_region::ByRegion;
use crate::collocation::evaluate::Derivatives;
use crate::collocation::grid::{Grid, intervals};
use crate::error::{MeshBound, NewtonError, SolveError};
use crate::layers::{Fineness, graded};
use crate::measure::Solved;
use crate::mesh::{distinct, split};
use crate::options::{Control, Order};
use crate::phase::{Action, Phase};
use crate::problem::Problem;
use crate::progress::{Failed, Next, Progress, measured};
use crate::refine::{ASYMPTOTIC, Measure, Verdict, Wish, verdict};
use crate::start::{Start, halved, on, transfer};

/// Quadrature is the larger part of an error of which it alone would cause this share.
const LARGER_PART: f64 = 0.5;
/// Where few intervals are too long, defects aim at this share of what they are held to.
const AHEAD: f64 = 0.5;

impl<'a, P: Problem + ?Sized> Run<'a, '_, P> {
    /// A failed iteration may succeed on other meshes, or if it does not insist on progress.
    pub(super) fn rescued(
        &mut self,
        action: Action,
        Failed { start: failed, error, converged }: Failed,
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
        let own = self.order == self.options.order;
        if own && matches!(error, NewtonError::NonFinite(_)) {
            progress.rescue.undefined = Some(error.clone());
        }
        let largest = failed.grids.iter().map(Grid::intervals).max().unwrap_or(0);
        let hopeless = match &error {
            NewtonError::Singular { empty_equations, .. } => !empty_equations.is_empty(),
            // What another order runs into says nothing of the next attempt.
            NewtonError::NonFinite(_) | NewtonError::Overflow => !converged && !self.options.other_orders && own,
            NewtonError::Stalled { .. } | NewtonError::IterationLimit { .. } => false,
        };
        if progress.first
            && !hopeless
            && !converged
            && let Some(start) = self.layered(&failed, progress)
        {
            return Ok(Next::On(start));
        }
        let rescue = &mut progress.rescue;
        // What is undefined on the way from a guess is so on halved meshes, too; another order goes another way.
        // Between the collocation points of a solution it is nearer to what is at them on finer meshes.
        let undefined = matches!(error, NewtonError::NonFinite(_));
        let useless = undefined && self.options.other_orders && !converged;
        let halvings = if useless { 0 } else { self.options.rescues };
        if !hopeless && rescue.halvings < halvings && 2 * largest <= self.options.max_intervals {
            rescue.halvings += 1;
            return Ok(Next::On(halved(&failed)));
        }
        if !hopeless
            && let Some(origin) = rescue.origin.clone()
            && let Some(start) = self.layered(&origin, progress)
        {
            progress.rescue.halvings = 0;
            return Ok(Next::On(start));
        }
        let rescue = &mut progress.rescue;
        if !hopeless
            && let (Some(origin), Some((&(order, insistent), attempts))) =
                (&rescue.origin, rescue.attempts.split_first())
        {
            let mut start = origin.clone();
            start.x.inner = ByRegion::default();
            (rescue.halvings, rescue.insistent, rescue.attempts) = (0, insistent, attempts);
            self.order = order;
            return Ok(Next::On(start));
        }
        if undefined
            && self.options.other_orders
            && let Some(finer) = rescue.again(self.options)
        {
            self.order = self.options.order;
            return Ok(Next::On(finer));
        }
        // Where the order that is wanted found something undefined, too: another may not have asked for it.
        let error = rescue.undefined.take().filter(|_| undefined && !own).unwrap_or(error);
        Err(SolveError::Newton { error, intervals: intervals(&failed.grids) })
    }

    /// A guess on meshes for the layers that there may be beside it; none if that are no others, or not known.
    fn layered(&mut self, guess: &Start, progress: &mut Progress<'a, P>) -> Option<Start> {
        let wanted = self.options.other_orders && self.options.rescues > 0;
        if !wanted || std::mem::replace(&mut progress.rescue.layers_sought, true) {
            return None;
        }
        let (system, mut x) = (self.system(guess.grids.clone()), guess.x.clone());
        let mut work = system.work();
        system.complete(&mut x, &mut self.stats);
        system.evaluate(&x, Derivatives::Planned, &mut work, &mut self.stats).ok()?;
        let most = self.options.max_intervals;
        let rough = Fineness::rough(self.order);
        let mut meshes = Vec::with_capacity(system.grids.len());
        for (region, layers) in progress.layers.iter_mut().enumerate() {
            let (mesh, found) = graded(&system, region, &work, most, rough).unzip();
            *layers = found.or(layers.take());
            meshes.push(mesh);
        }
        if meshes.iter().all(Option::is_none) {
            return None;
        }
        let kept = |(mesh, grid): (Option<Vec<f64>>, &Grid)| mesh.unwrap_or_else(|| grid.mesh.clone());
        let start = on(guess, meshes.into_iter().zip(&system.grids).map(kept).collect());
        progress.rescue.origin = Some(start.clone());
        Some(start)
    }

    /// Finer meshes where the defects exceed `target`, by which they are measured. Where they do that everywhere, once
    /// in a solve, finer ones where layers may be.
    ///
    /// # Errors
    /// The region whose mesh may not be finer; where defects are held to less than the tolerance, only if no region's
    /// may.
    pub(super) fn refined(
        &self,
        solved: &Solved<'a, P>,
        measures: &[Measure],
        target: f64,
        progress: &mut Progress<'a, P>,
    ) -> Result<Vec<Vec<f64>>, SolveError> {
        let tighter = target < self.options.tolerance;
        let (mut meshes, mut refused, mut changed) = (Vec::new(), None, false);
        for (region, measure) in measures.iter().enumerate() {
            let old = &solved.system.grids[region].mesh;
            let failing = !(measure.largest <= target);
            let graded = if failing { self.graded(solved, region, measure, target, progress) } else { None };
            let verdict = match graded {
                Some(mesh) => Verdict::Refine(mesh),
                None => self.verdict(solved, region, measure, target, progress),
            };
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
            Some(region) if !(tighter && changed) => {
                let because = MeshBound::Intervals { most: self.options.max_intervals };
                Err(self.exhausted(region, solved, &measures[region], because))
            }
            _ => Ok(meshes),
        }
    }

    /// Meshes for what defects aim at: less than they are held to, where an error is foreseen that exceeds the
    /// tolerance. Where those are not to be had, for what they are held to.
    ///
    /// # Errors
    /// As [`refined`](Self::refined).
    pub(super) fn aimed(
        &mut self,
        solved: &Solved<'a, P>,
        measures: &[Measure],
        progress: &mut Progress<'a, P>,
    ) -> Result<Vec<Vec<f64>>, SolveError> {
        let target = progress.target;
        if progress.phase == Phase::Search {
            progress.aim = progress.aim.or_else(|| self.foreseen(solved, measures, target));
            let aim = progress.aim.unwrap_or(target).min(ahead(solved, measures, target, progress));
            if aim < target {
                let measures = measured(solved, aim, progress.rounding_at(aim));
                if let Ok(meshes) = self.refined(solved, &measures, aim, progress) {
                    return Ok(meshes);
                }
            }
        }
        self.refined(solved, measures, target, progress)
    }

    /// What defects have to aim at so that the error will meet the tolerance. It is known before they meet it
    /// themselves, where few intervals are still too long: what the others cause stays, and those are to be no worse.
    /// None where it cannot be told yet, or where a mesh more costs little.
    fn foreseen(&mut self, solved: &Solved<'a, P>, measures: &[Measure], target: f64) -> Option<f64> {
        let worthwhile = self.options.control == Control::Error && intervals(&solved.system.grids) >= MANY;
        let known = solved.defects.iter().all(|defects| !defects.samples.is_empty());
        if !worthwhile || !known || !exceed_on_few(measures, target) {
            return None;
        }
        let excess = solved.foreseen_error(measures, target, &mut self.stats) / self.options.tolerance;
        Some(if excess > 1.0 && excess.is_finite() { (0.5 * target / excess).max(LEAST_TARGET) } else { target })
    }

    /// A mesh for the layers that a region may have, unless defects tell where its mesh is to be finer. Where the
    /// problem is linear it is to resolve them to `target`.
    fn graded(
        &self,
        solved: &Solved<'a, P>,
        region: usize,
        measure: &Measure,
        target: f64,
        progress: &mut Progress<'a, P>,
    ) -> Option<Vec<f64>> {
        if progress.layers[region].is_some() || !measure.is_rough_throughout() {
            return None;
        }
        let linear = solved.converged.seems_linear();
        let fineness = if linear { Fineness::for_defects(self.order, target) } else { Fineness::rough(self.order) };
        let (work, most) = (&solved.converged.work, self.options.max_intervals);
        let (mesh, layers) = graded(&solved.system, region, work, most, fineness).unzip();
        progress.layers[region] = Some(layers.unwrap_or_default());
        mesh
    }

    /// What the mesh of one region should become, by its defects, measured by `target`.
    pub(super) fn verdict(
        &self,
        solved: &Solved<'a, P>,
        region: usize,
        measure: &Measure,
        target: f64,
        progress: &Progress<'a, P>,
    ) -> Verdict {
        let wish = Wish {
            tolerance: target,
            order: self.tableau().defect_order,
            max_intervals: self.options.max_intervals,
            split_few: progress.split_few(),
            shrink: self.order != Order::Four && !progress.shrunk,
            linear: solved.converged.seems_linear(),
            layers: progress.layers[region].as_deref().unwrap_or_default(),
        };
        verdict(&solved.system.grids[region].mesh, measure, &wish)
    }

    /// Holds the defects to less, in the measure in which the error exceeds the tolerance.
    pub(super) fn tightened(&mut self, solved: Box<Solved<'a, P>>, progress: &mut Progress<'a, P>) -> Next<'a, P> {
        let error = solved.error_estimate(&mut self.stats);
        self.shortfall = Shortfall::Rounding;
        progress.stalled = if error <= PROGRESS * progress.error { 0 } else { progress.stalled + 1 };
        let better = error < progress.error;
        progress.error = progress.error.min(error);
        if progress.stalled < PATIENCE
            && let Some(start) =
                self.finer_for_integrals(&solved, error, progress).or_else(|| self.tighter(&solved, error, progress))
        {
            progress.tolerance_met();
            if better {
                progress.fallback = Some(*solved);
                progress.fallback_doubled &= progress.stalled > 0;
            }
            return Next::On(start);
        }
        let best = match progress.fallback.take() {
            Some(fallback) if !better => fallback,
            _ => *solved,
        };
        if progress.stalled < PATIENCE {
            return Next::done(best);
        }
        self.doubled_or_done(best, progress)
    }

    /// Meshes that are finer where the quadrature of integrals is not good enough, of which defects say nothing; none
    /// if it is, or if meshes may not have so many intervals.
    fn finer_for_integrals(
        &mut self,
        solved: &Solved<'a, P>,
        error: f64,
        progress: &mut Progress<'a, P>,
    ) -> Option<Start> {
        let pieces = self.pieces_for_integrals(solved, error)?;
        self.shortfall = Shortfall::Mesh;
        let grids = solved.system.grids.iter().zip(&pieces);
        let meshes: Vec<Vec<f64>> = grids.map(|(grid, pieces)| distinct(split(&grid.mesh, pieces))).collect();
        let finer = meshes.iter().zip(&solved.system.grids).any(|(mesh, grid)| mesh.len() > grid.mesh.len());
        if !finer || meshes.iter().any(|mesh| mesh.len() > self.options.max_intervals + 1) {
            return None;
        }
        progress.for_integrals = true;
        Some(transfer(solved, meshes))
    }

    /// Into how many parts each interval is to be divided, region by region, where the estimated `error` exceeds the
    /// tolerance because of quadrature: because of the error of an integral itself, or of what that does to the
    /// solution through the conditions that use the integral, as long as this is the larger part. None where no
    /// interval is to be divided.
    fn pieces_for_integrals(&mut self, solved: &Solved<'a, P>, error: f64) -> Option<Vec<Vec<usize>>> {
        let (tolerance, order) = (self.options.tolerance, self.order.number() as f64);
        let mut errors = solved.quadrature_errors(&mut self.stats);
        let counted = self.options.integrals && errors.iter().any(|errors| !(errors.largest() <= tolerance));
        let effect = solved.quadrature_effect(&errors, &mut self.stats);
        if effect >= LARGER_PART * error {
            solved.weigh(&mut errors, &mut self.stats);
        } else if !counted {
            return None;
        }
        let grids = errors.iter().zip(&solved.system.grids);
        let pieces: Vec<Vec<usize>> =
            grids.map(|(errors, grid)| errors.pieces(grid.intervals(), tolerance, order)).collect();
        pieces.iter().flatten().any(|pieces| *pieces > 1).then_some(pieces)
    }

    /// See [`Progress::doubled_or_done`]; what stands in the way of a smaller error is noted. It is not rounding where
    /// quadrature is what the error is due to.
    pub(super) fn doubled_or_done(&mut self, best: Solved<'a, P>, progress: &mut Progress<'a, P>) -> Next<'a, P> {
        let error = best.error_estimate(&mut self.stats);
        let by_quadrature = self.pieces_for_integrals(&best, error).is_some();
        let (next, shortfall) = progress.doubled_or_done(best);
        self.shortfall = if by_quadrature { Shortfall::Mesh } else { shortfall };
        next
    }

    /// Meshes for the largest defects below the present ones that ask for others; none if rounding or the limits of the
    /// meshes stand in the way.
    pub(super) fn tighter(
        &mut self,
        solved: &Solved<'a, P>,
        error: f64,
        progress: &mut Progress<'a, P>,
    ) -> Option<Start> {
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
            return self
                .refined(solved, &measures, progress.target, progress)
                .ok()
                .map(|meshes| transfer(solved, meshes));
        }
        None
    }
}

/// Whether all that is left is to split few intervals: all defects are in the asymptotic regime, and few exceed
/// `target`, by which they are measured.
fn exceed_on_few(measures: &[Measure], target: f64) -> bool {
    measures.iter().all(|measure| measure.largest <= ASYMPTOTIC && measure.exceeds_on_few(target))
}

/// What defects aim at where only few intervals are too long: less than they are held to, for those that just pass now
/// are the next to fail, and a mesh more costs as much as many intervals more.
fn ahead<P: Problem + ?Sized>(
    solved: &Solved<'_, P>,
    measures: &[Measure],
    target: f64,
    progress: &Progress<'_, P>,
) -> f64 {
    let aim = (AHEAD * target).max(LEAST_TARGET);
    let few = exceed_on_few(measures, target) && exceed_on_few(&measured(solved, aim, progress.rounding_at(aim)), aim);
    if few { aim } else { target }
}
