//! The main loop: solve on a mesh, measure the defect, improve the mesh.

use crate::collocation::grid::Grid;
use crate::collocation::interpolant::{Defects, Extended, Extension};
use crate::collocation::plan::Plan;
use crate::collocation::{Iterate, System};
use crate::error::{NewtonError, SolveError};
use crate::guess::{Guess, RegionGuess};
use crate::newton::{self, Converged, Limits};
use crate::observer::{Event, Observer, Silent};
use crate::options::Options;
use crate::problem::{Layout, Problem};
use crate::refine::{Measure, Verdict, measure, verdict};
use crate::solution::{MeshRecord, RegionSolution, Solution};
use crate::stats::Stats;
use std::sync::Arc;

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
    let mut run = Run::new(problem, plan, options, observer);
    let grids = guess.grids();
    let x = guess.iterate(&grids);
    let solved = run.refine(Start { grids, x })?;
    run.finish(&solved)
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

/// Where Newton's iteration is to start.
pub(crate) struct Start {
    pub grids: Vec<Grid>,
    pub x: Iterate,
}

/// What Newton's iteration and the measurement of the defect left, on meshes that pass.
pub(crate) struct Solved<'a, P: Problem + ?Sized> {
    pub system: System<'a, P>,
    pub converged: Converged,
    pub measured: Measured,
}

/// A converged iterate, measured.
pub(crate) struct Measured {
    pub extensions: Vec<Extension>,
    defects: Vec<Defects>,
    pub measures: Vec<Measure>,
}

/// One solve, or the solves of one continuation: what they share, and what they have cost so far.
pub(crate) struct Run<'a, 'o, P: Problem + ?Sized> {
    problem: &'a P,
    layout: &'a Layout,
    plan: Arc<Plan>,
    pub options: &'o Options,
    pub observer: &'o mut dyn Observer,
    pub stats: Stats,
    pub history: Vec<MeshRecord>,
    /// Newton's first contraction on the first mesh of the last solve; infinite if it failed.
    pub contraction: f64,
}

impl<'a, 'o, P: Problem + ?Sized> Run<'a, 'o, P> {
    pub(crate) fn new(problem: &'a P, plan: Plan, options: &'o Options, observer: &'o mut dyn Observer) -> Self {
        let layout = problem.layout();
        Self {
            problem,
            layout,
            plan: Arc::new(plan),
            options,
            observer,
            stats: Stats::default(),
            history: Vec::new(),
            contraction: 0.0,
        }
    }

    /// Solves and improves the meshes until they pass.
    pub(crate) fn refine(&mut self, mut start: Start) -> Result<Solved<'a, P>, SolveError> {
        let (mut rescues, mut coarsened) = (0, false);
        for attempt in 0..self.options.max_meshes {
            let Start { grids, x } = start;
            let system = self.system(grids);
            self.stats.meshes += 1;
            let before = self.stats.newton_iterations;
            let outcome = newton::solve(&system, &x, self.limits(), &mut self.stats, self.observer);
            if attempt == 0 {
                self.contraction = outcome.as_ref().map_or(f64::INFINITY, |converged| converged.contraction);
            }
            let converged = match outcome {
                Ok(converged) => converged,
                Err(error) => {
                    self.record(&system, before, vec![f64::INFINITY; system.grids.len()]);
                    start = self.rescue(Start { grids: system.grids, x }, error, &mut rescues)?;
                    continue;
                }
            };
            let measured = self.measured(&system, &converged)?;
            self.record(&system, before, measured.measures.iter().map(|measure| measure.largest).collect());
            let defect = measured.measures.iter().fold(0.0, |max: f64, measure| max.max(measure.largest));
            let intervals = intervals(&system.grids);
            if self.observer.notify(&Event::Mesh { intervals, defect }).is_break() {
                return Err(SolveError::Cancelled);
            }
            match self.next_meshes(&system, &measured, coarsened)? {
                None => return Ok(Solved { system, converged, measured }),
                Some((meshes, coarser)) => {
                    coarsened |= coarser;
                    start = transfer(&Solved { system, converged, measured }, meshes);
                }
            }
        }
        Err(self.out_of_meshes())
    }

    fn system(&self, grids: Vec<Grid>) -> System<'a, P> {
        System {
            problem: self.problem,
            layout: self.layout,
            plan: self.plan.clone(),
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
    fn rescue(&self, start: Start, error: NewtonError, rescues: &mut usize) -> Result<Start, SolveError> {
        if error == NewtonError::Cancelled {
            return Err(SolveError::Cancelled);
        }
        let largest = start.grids.iter().map(Grid::intervals).max().unwrap_or(0);
        let hopeless = match &error {
            NewtonError::Singular { empty_equations, .. } => !empty_equations.is_empty(),
            NewtonError::NonFinite(_) => true,
            _ => false,
        };
        if hopeless || *rescues >= self.options.rescues || 2 * largest > self.options.max_intervals {
            return Err(SolveError::Newton { error, intervals: intervals(&start.grids) });
        }
        *rescues += 1;
        Ok(halved(&start))
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
                intervals: intervals(&system.grids),
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

    /// The solution, if its boundary residuals too meet their tolerance.
    pub(crate) fn finish(&self, solved: &Solved<'_, P>) -> Result<Solution, SolveError> {
        let Solved { converged, measured, .. } = solved;
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
            regions: solved.regions(),
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

/// Intervals of all regions.
pub(crate) fn intervals(grids: &[Grid]) -> usize {
    grids.iter().map(Grid::intervals).sum()
}

impl<P: Problem + ?Sized> Solved<'_, P> {
    pub(crate) fn regions(&self) -> Vec<RegionSolution> {
        let Converged { x, work, .. } = &self.converged;
        let regions = self.measured.extensions.iter().enumerate();
        regions.map(|(region, extension)| RegionSolution::new(&self.system, region, x, work, extension)).collect()
    }
}

/// The solution on other meshes.
pub(crate) fn transfer<P: Problem + ?Sized>(solved: &Solved<'_, P>, meshes: Vec<Vec<f64>>) -> Start {
    let regions = solved.regions().iter().zip(meshes).map(|(old, mesh)| old.sampled(mesh)).collect();
    let guess = Guess { regions, constants: solved.converged.x.constants.clone() };
    let grids = guess.grids();
    Start { x: guess.iterate(&grids), grids }
}

/// Halves every interval, states interpolated linearly.
fn halved(start: &Start) -> Start {
    let halve = |values: &[f64]| -> Vec<f64> {
        let pairs = values.windows(2).flat_map(|pair| [pair[0], 0.5 * (pair[0] + pair[1])]);
        pairs.chain(values.last().copied()).collect()
    };
    let regions = start.grids.iter().zip(&start.x.y).map(|(grid, y)| RegionGuess {
        mesh: halve(&grid.mesh),
        states: y.chunks_exact(grid.node_stride()).map(|y| halve(&grid.unpack(y))).collect(),
    });
    let guess = Guess { regions: regions.collect(), constants: start.x.constants.clone() };
    let grids = guess.grids();
    Start { x: guess.iterate(&grids), grids }
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
