//! The main loop: solve on a mesh, measure the defect, improve the mesh.

use crate::collocation::System;
use crate::collocation::grid::Grid;
use crate::collocation::interpolant::{Defects, Extended, Extension};
use crate::collocation::plan::Plan;
use crate::error::{NewtonError, SolveError};
use crate::guess::{Guess, RegionGuess};
use crate::newton::{self, Converged, Limits};
use crate::observer::{Event, Observer, Silent};
use crate::options::Options;
use crate::problem::{Layout, Problem};
use crate::refine::{Measure, Verdict, measure, verdict};
use crate::solution::{MeshRecord, RegionSolution, Solution};
use crate::stats::Stats;

/// Solves a boundary value problem from a guess, on meshes refined until the tolerance is met.
///
/// `unknowns`: which constants to find, as indices into the layout's constants; there must be as many boundary
/// equations as states and unknowns together. A warm start is [`Guess::from`] a solution.
///
/// # Errors
/// See [`SolveError`]. Success means that Newton's correction, the boundary residuals and the defects have all
/// met their tolerances on the solution's mesh.
pub fn solve<P: Problem + ?Sized>(
    problem: &P,
    guess: &Guess,
    unknowns: &[usize],
    options: &Options,
) -> Result<Solution, SolveError> {
    solve_observed(problem, guess, unknowns, options, &mut Silent)
}

/// As [`solve`], watched by an observer that may cancel it.
///
/// # Errors
/// As [`solve`], and [`SolveError::Cancelled`].
pub fn solve_observed<P: Problem + ?Sized>(
    problem: &P,
    guess: &Guess,
    unknowns: &[usize],
    options: &Options,
    observer: &mut dyn Observer,
) -> Result<Solution, SolveError> {
    let layout = problem.layout();
    check(layout, guess, unknowns, options)?;
    let plan = Plan::new(layout, unknowns);
    let mut run = Run { problem, layout, plan: &plan, options, observer, stats: Stats::default(), history: Vec::new() };
    run.refine(guess.clone())
}

/// # Errors
/// The first input that makes no sense.
pub(crate) fn check(layout: &Layout, guess: &Guess, unknowns: &[usize], options: &Options) -> Result<(), SolveError> {
    options.check()?;
    layout.check()?;
    guess.check(layout)?;
    let constants = layout.constants.len();
    for (i, &index) in unknowns.iter().enumerate() {
        if index >= constants || unknowns[..i].contains(&index) {
            return Err(SolveError::Unknowns { index, constants });
        }
    }
    let (equations, states) = (layout.equations.len(), layout.states());
    if equations != states + unknowns.len() {
        return Err(SolveError::Count { equations, states, unknowns: unknowns.len() });
    }
    Ok(())
}

struct Run<'a, P: Problem + ?Sized> {
    problem: &'a P,
    layout: &'a Layout,
    plan: &'a Plan,
    options: &'a Options,
    observer: &'a mut dyn Observer,
    stats: Stats,
    history: Vec<MeshRecord>,
}

/// A converged iterate, measured.
struct Measured {
    extensions: Vec<Extension>,
    defects: Vec<Defects>,
    measures: Vec<Measure>,
}

impl<'a, P: Problem + ?Sized> Run<'a, P> {
    fn refine(&mut self, mut guess: Guess) -> Result<Solution, SolveError> {
        let (mut rescues, mut coarsened) = (0, false);
        for _ in 0..self.options.max_meshes {
            let grids = guess.grids();
            let start = guess.iterate(&grids);
            let system = self.system(grids);
            self.stats.meshes += 1;
            let before = self.stats.newton_iterations;
            let converged = match newton::solve(&system, &start, self.limits(), &mut self.stats, self.observer) {
                Ok(converged) => converged,
                Err(error) => {
                    self.record(&system, before, vec![f64::INFINITY; system.grids.len()]);
                    guess = self.rescue(guess, error, &mut rescues)?;
                    continue;
                }
            };
            let measured = self.measured(&system, &converged)?;
            let defects: Vec<f64> = measured.measures.iter().map(|measure| measure.largest).collect();
            let event = Event::Mesh {
                intervals: system.grids.iter().map(Grid::intervals).sum(),
                defect: defects.iter().fold(0.0, |max, defect| max.max(*defect)),
            };
            self.record(&system, before, defects);
            if self.observer.notify(&event).is_break() {
                return Err(SolveError::Cancelled);
            }
            match self.next_meshes(&system, &measured, coarsened)? {
                None => return self.finish(&system, &converged, &measured),
                Some((meshes, coarser)) => {
                    coarsened |= coarser;
                    guess = self.transfer(&system, &converged, &measured, meshes);
                }
            }
        }
        Err(self.out_of_meshes(&guess))
    }

    fn system(&self, grids: Vec<Grid>) -> System<'a, P> {
        System {
            problem: self.problem,
            layout: self.layout,
            plan: self.plan,
            tableau: self.options.order.tableau(),
            grids,
        }
    }

    fn limits(&self) -> Limits {
        Limits {
            tolerance: self.options.newton_tolerance(),
            iterations: self.options.max_iterations,
            smallest_damping: self.options.smallest_damping,
            contraction: 1.0,
        }
    }

    fn record(&mut self, system: &System<'_, P>, before: usize, defects: Vec<f64>) {
        self.history.push(MeshRecord {
            intervals: system.grids.iter().map(Grid::intervals).collect(),
            defects,
            newton_iterations: self.stats.newton_iterations - before,
        });
    }

    /// A failed iteration may succeed on a finer mesh.
    fn rescue(&self, guess: Guess, error: NewtonError, rescues: &mut usize) -> Result<Guess, SolveError> {
        if error == NewtonError::Cancelled {
            return Err(SolveError::Cancelled);
        }
        let largest = guess.regions.iter().map(|region| region.mesh.len() - 1).max().unwrap_or(0);
        let hopeless = matches!(&error, NewtonError::Singular { empty_equations, .. } if !empty_equations.is_empty());
        if hopeless || *rescues >= self.options.rescues || 2 * largest > self.options.max_intervals {
            return Err(SolveError::Newton { error, intervals: guess.intervals() });
        }
        *rescues += 1;
        Ok(guess.halved())
    }

    fn measured(&mut self, system: &System<'_, P>, converged: &Converged) -> Result<Measured, SolveError> {
        let (mut extensions, mut defects) = (Vec::new(), Vec::new());
        for region in 0..system.grids.len() {
            let extended = Extended { system, region, x: &converged.x, stages: &converged.work.regions[region] };
            let extension = extended.extension(&mut self.stats);
            let measured = extension.and_then(|extension| {
                let defects = extended.defects(&extension, converged.scales(), &mut self.stats)?;
                Ok((extension, defects))
            });
            let (extension, defect) = measured.map_err(|error| SolveError::Newton {
                error: NewtonError::NonFinite(error),
                intervals: system.grids.iter().map(Grid::intervals).sum(),
            })?;
            extensions.push(extension);
            defects.push(defect);
        }
        let measures = defects.iter().map(|defects| measure(defects, self.options.tolerance)).collect();
        Ok(Measured { extensions, defects, measures })
    }

    /// New meshes, and whether one of them is coarser because the old was grossly too fine; `None` if all may stay.
    #[allow(clippy::type_complexity)]
    fn next_meshes(
        &self,
        system: &System<'_, P>,
        measured: &Measured,
        coarsened: bool,
    ) -> Result<Option<(Vec<Vec<f64>>, bool)>, SolveError> {
        let (mut changed, mut coarser) = (false, false);
        let mut meshes = Vec::new();
        for (region, (grid, measure)) in system.grids.iter().zip(&measured.measures).enumerate() {
            let Options { tolerance, max_intervals, .. } = *self.options;
            meshes.push(match verdict(&grid.mesh, measure, tolerance, system.tableau.defect_order, max_intervals) {
                Verdict::Coarsen(mesh) if !coarsened => {
                    (changed, coarser) = (true, true);
                    mesh
                }
                Verdict::Keep | Verdict::Coarsen(_) => grid.mesh.clone(),
                Verdict::Refine(mesh) => {
                    changed = true;
                    mesh
                }
                Verdict::Exhausted => return Err(self.exhausted(region, grid, measured)),
            });
        }
        Ok(changed.then_some((meshes, coarser)))
    }

    fn exhausted(&self, region: usize, grid: &Grid, measured: &Measured) -> SolveError {
        let (measure, defects) = (&measured.measures[region], &measured.defects[region]);
        let names = &self.layout.regions[region];
        let state = defects.state.get(measure.worst).and_then(|&state| names.states.get(state));
        SolveError::MeshLimit {
            region: names.name.clone(),
            position: grid.mesh[measure.worst],
            state: state.map_or_else(String::new, |state| state.name.clone()),
            defect: measure.largest,
            tolerance: self.options.tolerance,
            intervals: grid.intervals(),
        }
    }

    fn out_of_meshes(&self, guess: &Guess) -> SolveError {
        let last = self.history.last();
        let worst =
            last.and_then(|last| (0..last.defects.len()).max_by(|&i, &j| last.defects[i].total_cmp(&last.defects[j])));
        let region = worst.unwrap_or(0);
        SolveError::MeshLimit {
            region: self.layout.regions.get(region).map_or_else(String::new, |region| region.name.clone()),
            position: guess.regions.get(region).map_or(f64::NAN, |region| region.mesh[0]),
            state: "all states".to_owned(),
            defect: last.map_or(f64::NAN, |last| last.defects.iter().fold(0.0, |max, defect| max.max(*defect))),
            tolerance: self.options.tolerance,
            intervals: guess.intervals(),
        }
    }

    fn region_solutions(
        &self,
        system: &System<'_, P>,
        converged: &Converged,
        measured: &Measured,
    ) -> Vec<RegionSolution> {
        let regions = measured.extensions.iter().enumerate();
        regions
            .map(|(region, extension)| RegionSolution::new(system, region, &converged.x, &converged.work, extension))
            .collect()
    }

    fn transfer(
        &self,
        system: &System<'_, P>,
        converged: &Converged,
        measured: &Measured,
        meshes: Vec<Vec<f64>>,
    ) -> Guess {
        let old = self.region_solutions(system, converged, measured);
        let regions = old.iter().zip(meshes).map(|(old, mesh)| old.sampled(mesh));
        Guess { regions: regions.collect(), constants: converged.x.constants.clone() }
    }

    fn finish(
        &self,
        system: &System<'_, P>,
        converged: &Converged,
        measured: &Measured,
    ) -> Result<Solution, SolveError> {
        let scale = &converged.factorisation.boundary_scale;
        let relative = |(g, scale): (&f64, &f64)| if *g == 0.0 { 0.0 } else { g.abs() / scale };
        let residuals: Vec<f64> = converged.work.g.iter().zip(scale).map(relative).collect();
        let worst = (0..residuals.len()).max_by(|&i, &j| residuals[i].total_cmp(&residuals[j]));
        let largest = worst.map_or(0.0, |worst| residuals[worst]);
        let tolerance = self.options.boundary_tolerance();
        if !(largest <= tolerance) {
            let equation = worst.map_or_else(String::new, |worst| self.layout.equations[worst].clone());
            return Err(SolveError::Boundary { equation, residual: largest, tolerance });
        }
        Ok(Solution {
            regions: self.region_solutions(system, converged, measured),
            constants: converged.x.constants.clone(),
            unknowns: self.plan.unknowns.clone(),
            order: self.options.order,
            max_defect: measured.measures.iter().fold(0.0, |max, measure| max.max(measure.largest)),
            max_boundary_residual: largest,
            stats: self.stats,
            history: self.history.clone(),
        })
    }
}

impl RegionSolution {
    /// The solution at other nodes; old nodes keep their values exactly.
    pub(crate) fn sampled(&self, mesh: Vec<f64>) -> RegionGuess {
        let mut states = vec![Vec::with_capacity(mesh.len()); self.states()];
        let mut y = vec![0.0; self.states()];
        for &s in &mesh {
            self.eval_into(s, &mut y);
            states.iter_mut().zip(&y).for_each(|(values, y)| values.push(*y));
        }
        RegionGuess { mesh, states }
    }
}
