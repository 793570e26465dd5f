//! Damped affine-invariant Newton iteration.
//!
//! P. Deuflhard, "Newton Methods for Nonlinear Problems", Springer 2004, algorithm NLEQ-ERR (section 3.3.2):
//! progress is measured by simplified corrections `Δx̄ = -J(x_k)⁻¹ F(x_k + λ Δx_k)` from the held factorisation
//! (natural monotonicity), which no scaling of the equations can change; the damping factor is predicted and corrected
//! from estimates of the affine-invariant Lipschitz constant.

mod closing;
mod converged;
mod names;

pub(crate) use converged::Converged;
use converged::OwnScales;
use converged::{FAR, LINEAR};

use crate::budget::Budget;
use crate::collocation::evaluate::{Derivatives, Work};
use crate::collocation::factor::Factorisation;
use crate::collocation::grid::intervals;
use crate::collocation::inner::Settled;
use crate::collocation::{Correction, Iterate, Scales, System};
use crate::error::{NewtonError, NonFinite, SolveError};
use crate::linear::simd::largest_number;
use crate::observer::{Event, Observer};
use crate::problem::Problem;
use crate::stats::Stats;

/// Natural monotonicity allows a full step to be repeated with the same matrix if it contracts this well.
const SIMPLIFIED_CONTRACTION: f64 = 0.25;
/// A factorisation costs about as much as so many simplified corrections.
const SIMPLIFIED_LIMIT: f64 = 4.0;

/// A last correction that is so much smaller than the tolerance of the iteration is not applied: the right-hand side
/// need not be evaluated once more then.
const NEGLIGIBLE: f64 = 1e-3;
/// Corrections are measured in the magnitudes of the last factored iterate. Those of the iterate that they lead to may
/// be far smaller, as after a step too far, or from a guess that is far too large, or far larger, as from a guess of
/// zero: beyond this factor they count.
const BY_FAR: f64 = 2.0;
/// Below this tolerance rounding is near, and every correction is applied.
const NEAR_ROUNDING: f64 = 1e-10;

/// Limits of the iteration.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Limits {
    /// Largest component of the last correction, relative to typical magnitudes.
    pub tolerance: f64,
    /// Largest residual of a boundary equation, relative to its largest term.
    pub boundary: f64,
    /// What ends the iteration if there is a better start for it than this one.
    pub far: Option<Far>,
    pub iterations: usize,
    pub smallest_damping: f64,
    /// Corrections of this size are accepted if smaller ones cannot be had.
    pub stagnation: f64,
    /// Whether every step must be progress. That can lead into a corner where the matrix is singular; a few steps that
    /// are none can lead out of it.
    pub insistent: bool,
    /// Whether the meshes are made for layers, which a linear problem's matrix may be singular for: see
    /// [`Newton::undetermined`].
    pub layers: bool,
}

/// What shows that an iteration has begun far from the solution: one of these is exceeded, or a step has to be damped.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Far {
    /// Largest component of the first correction, in typical magnitudes.
    pub correction: f64,
    /// Iterations, as long as the next one is not the last.
    pub iterations: usize,
}

/// An iteration that does not insist on progress tries every correction in full, halves it as long as that is no
/// progress, and takes this fraction of it whatever comes of it. Estimates of the Lipschitz constant are not used:
/// where it is needed, they mislead.
const FORCED_DAMPING: f64 = 1.0 / 16.0;

/// Below this size a correction that does not contract is taken for the effect of rounding or of a kink: the iterate is
/// good enough to measure the mesh with, if not for a solution.
const STAGNANT: f64 = 1e-3;

/// Where nothing is known of the states at inner stages, their equations are solved first if that changes no state by
/// more than this: a guess that is a solution at its nodes is one then. Else they are solved with all others.
const SETTLED_FROM: f64 = 0.3;

/// How often a singular matrix is stepped away from in one iteration.
const ESCAPES: usize = 6;
/// How often at most the step that led to one is shortened first,
const SHORTENED: usize = 3;
/// and the factor on it.
const SHORTER: f64 = 0.5;
/// How far to go along the direction that it does not see, in typical magnitudes; farther each time.
const NUDGE: f64 = 0.05;

struct Newton<'a, 'p, P: Problem + ?Sized> {
    system: &'a System<'p, P>,
    limits: Limits,
    stats: &'a mut Stats,
    observer: &'a mut dyn Observer,
    budget: &'a Budget,
    work: Work,
    factorisation: Factorisation,
    /// See [`Converged`].
    own: Option<OwnScales>,
    iteration: usize,
    contraction: Option<f64>,
    /// Largest component of the first correction.
    first: Option<f64>,
    /// How often a singular matrix has been stepped away from.
    escapes: usize,
    /// Whether no step has been damped.
    full_steps: bool,
    /// Where the first correction of a linear problem leads to, if that is not yet a solution.
    roughly: Option<Iterate>,
    /// What the matrix of a linear problem leaves undetermined, as far as rounding lets it be seen: layers that a mesh
    /// resolves where they are, and not beside them, hide boundary values from the other end. What corrections lead to
    /// is no solution, and says where the mesh is to be finer; a problem that is singular itself stays so there.
    undetermined: Option<NewtonError>,
}

/// The step that led to the present iterate.
struct Taken {
    from: Iterate,
    scales: Scales,
    dx: Correction,
    damping: f64,
}

/// A converged iterate.
struct Last {
    x: Iterate,
    /// Whether the residual held is that at `x`.
    evaluated: bool,
    /// Largest component of the last correction.
    size: f64,
}

/// How far a damped step got.
enum Step {
    /// The iterate converged.
    Done(Last),
    /// No damping factor makes progress.
    Stuck(NewtonError),
    /// A new iterate, the simplified correction there, and the damping factor that led to it.
    Moved { x: Iterate, simplified: Correction, damping: f64, contraction: f64 },
}

/// How far corrections with the held matrix got.
enum Simplified {
    Converged(Last),
    /// To an iterate at which a new matrix is due.
    Ended(Iterate),
}

/// Why there is no converged iterate.
pub(crate) enum Failure {
    /// The iteration cannot go on.
    Newton(NewtonError),
    /// The solution is farther away than the iteration is to go: the iterate that it was left at, and how far it is.
    Far(Box<Iterate>, NewtonError),
    /// The iteration must not go on: it was cancelled, or its work is spent.
    Interrupted(SolveError),
}

impl From<NewtonError> for Failure {
    fn from(error: NewtonError) -> Self {
        Self::Newton(error)
    }
}

/// Solves the collocation equations from `start`, which is left as it is.
///
/// # Errors
/// See [`Failure`].
pub(crate) fn solve<P: Problem + ?Sized>(
    system: &System<'_, P>,
    start: &Iterate,
    limits: Limits,
    stats: &mut Stats,
    observer: &mut dyn Observer,
    budget: &Budget,
) -> Result<Converged, Failure> {
    let newton = Newton {
        system,
        limits,
        stats,
        observer,
        budget,
        work: system.work(),
        factorisation: Factorisation::new(system),
        own: None,
        iteration: 0,
        contraction: None,
        first: None,
        escapes: 0,
        full_steps: true,
        roughly: None,
        undetermined: None,
    };
    newton.run(start.clone())
}

impl<P: Problem + ?Sized> Newton<'_, '_, P> {
    fn run(mut self, mut x: Iterate) -> Result<Converged, Failure> {
        // The last damping factor, correction and simplified correction: they predict the next damping factor.
        let mut before: Option<(f64, f64, Correction)> = None;
        let mut taken: Option<Taken> = None;
        let mut incomplete = self.system.interpolate(&mut x, self.stats);
        // Stages are settled first to tell a guess that is a solution at its nodes. Zero is hardly ever one, and where
        // it is, one correction says so of a linear problem.
        incomplete &= !self.system.linear || x.y.iter().any(|y| largest_number(y) > 0.0);
        loop {
            if let Err(error) = self.linearise(&x) {
                x = self.escape(&x, &mut taken, error)?;
                before = None;
                continue;
            }
            if std::mem::take(&mut incomplete)
                && let Err(error) = self.settle(&mut x)
            {
                x = self.escape(&x, &mut taken, error)?;
                continue;
            }
            let dx = self.correction();
            let (size, largest) = (self.system.norm(&dx), self.system.largest(&dx));
            if !largest.is_finite()
                && let Some(error) = self.undetermined.take()
            {
                x = self.escape(&x, &mut taken, error)?;
                continue;
            }
            self.first = self.first.or(Some(largest));
            self.announce(largest, before.as_ref().map_or(1.0, |before| before.0))?;
            if largest <= self.limits.tolerance {
                let x = self.system.stepped(&x, &self.factorisation.scales, 1.0, &dx);
                return self.finish(Last { x, evaluated: false, size: largest }, None);
            }
            if self.is_far(largest) {
                return Err(Failure::Far(Box::new(x), self.limit_reached(&dx)));
            }
            if self.iteration > self.limits.iterations {
                let error = self.limit_reached(&dx);
                return self.stagnate(x, &dx, error);
            }
            if let Some(x) = self.arrived(&x, &dx) {
                self.contraction = Some(0.0);
                return Ok(self.ended(x, None));
            }
            let damping = before.as_ref().map_or(1.0, |before| self.predict(before, &dx, size));
            match self.damped_step(&x, &dx, (size, largest), damping)? {
                Step::Done(last) if self.is_small(&last) => return self.finish(last, None),
                Step::Done(last) => (x, before, taken) = (last.x, None, None),
                Step::Stuck(error) => return self.stagnate(x, &dx, error),
                Step::Moved { damping, .. } if damping < 1.0 && self.limits.far.is_some() => {
                    return Err(Failure::Far(Box::new(x), self.limit_reached(&dx)));
                }
                Step::Moved { x: next, simplified, damping, contraction } => {
                    let (from, scales) = (std::mem::replace(&mut x, next), self.factorisation.scales.clone());
                    self.full_steps &= damping == 1.0;
                    taken = Some(Taken { from, scales, dx, damping });
                    if damping == 1.0 && contraction <= SIMPLIFIED_CONTRACTION {
                        match self.simplified_steps(x, &simplified, contraction)? {
                            Simplified::Converged(last) if self.is_small(&last) => return self.finish(last, None),
                            Simplified::Converged(Last { x: next, .. }) | Simplified::Ended(next) => x = next,
                        }
                        (before, taken) = (None, None);
                    } else {
                        before = Some((damping, size, simplified));
                    }
                }
            }
        }
    }

    /// Where to go on from an iterate whose matrix is singular: a shorter step to it; else along the direction that the
    /// matrix does not see, to one side and the other.
    ///
    /// # Errors
    /// The one given, if it is no accident of this iterate or if enough has been tried.
    fn escape(&mut self, x: &Iterate, taken: &mut Option<Taken>, error: NewtonError) -> Result<Iterate, Failure> {
        let accident = matches!(&error, NewtonError::Singular { rank, .. } if *rank > 0);
        if !accident || self.escapes >= ESCAPES {
            return Err(error.into());
        }
        self.escapes += 1;
        self.budget.check(self.stats).map_err(Failure::Interrupted)?;
        if self.escapes <= SHORTENED
            && let Some(taken) = taken
        {
            taken.damping *= SHORTER;
            return Ok(self.system.stepped(&taken.from, &taken.scales, taken.damping, &taken.dx));
        }
        let side = if self.escapes % 2 == 1 { 1.0 } else { -1.0 };
        let direction = self.factorisation.null_correction(self.system);
        let length = side * self.escapes as f64 * NUDGE / self.system.largest(&direction);
        Ok(self.system.stepped(x, &self.factorisation.scales, length, &direction))
    }

    fn linearise(&mut self, x: &Iterate) -> Result<(), NewtonError> {
        self.iteration += 1;
        self.stats.newton_iterations += 1;
        self.own = None;
        self.evaluate(x, Derivatives::Planned).map_err(NewtonError::NonFinite)?;
        let scales = self.system.scales(x);
        self.factorisation.factor(self.system, &self.work, scales);
        self.stats.factorisations += 1;
        let determined = self.factorisation.determined(self.system);
        let bearable = self.limits.layers && self.system.linear;
        let bearable = bearable && matches!(&determined, Err(NewtonError::Singular { rank, .. }) if *rank > 0);
        if !bearable {
            self.undetermined = None;
            return determined;
        }
        self.undetermined = determined.err();
        Ok(())
    }

    /// Solves the stage equations first, where nothing is known of the states at inner stages and that does not change
    /// much: see [`SETTLED_FROM`].
    fn settle(&mut self, x: &mut Iterate) -> Result<(), NewtonError> {
        let origin = x.inner.clone();
        let settled = self.system.settle(&self.factorisation, x, &mut self.work, SETTLED_FROM, self.stats);
        if let Settled::From(size) = settled {
            x.inner = origin;
            if size < SETTLED_FROM {
                // It needs more than one matrix.
                self.system.meet(x, SETTLED_FROM, self.stats);
                self.iteration -= 1;
                self.stats.newton_iterations -= 1;
                self.linearise(x)?;
            }
        }
        Ok(())
    }

    /// Whether a correction says that the iteration is better begun elsewhere.
    fn is_far(&self, largest: f64) -> bool {
        let slow = largest > self.limits.tolerance.sqrt();
        let far = |far: Far| self.iteration > far.iterations && slow || self.iteration == 1 && largest > far.correction;
        self.limits.far.is_some_and(far)
    }

    fn evaluate(&mut self, x: &Iterate, derivatives: Derivatives) -> Result<(), NonFinite> {
        self.system.evaluate(x, derivatives, &mut self.work, self.stats)
    }

    fn correction(&mut self) -> Correction {
        self.stats.linear_solves += 1;
        self.factorisation.newton_correction(self.system, &self.work)
    }

    /// Damping factor from the Lipschitz estimate of the last step; Deuflhard (3.50).
    fn predict(&self, before: &(f64, f64, Correction), dx: &Correction, size: f64) -> f64 {
        let (damping, last_size, simplified) = before;
        let change = self.system.distance(simplified, 1.0, dx);
        let estimate = last_size * self.system.norm(simplified) / (change * size) * damping;
        if estimate.is_finite() { estimate.min(1.0).max(self.limits.smallest_damping) } else { 1.0 }
    }

    /// Where the first correction leads to, if the problem is linear: to the solution, unless boundary equations are
    /// not met there, or the guess was so much larger that its rounding counts.
    fn arrived(&mut self, x: &Iterate, dx: &Correction) -> Option<Iterate> {
        if !self.system.linear || self.iteration > 1 || self.limits.tolerance < NEAR_ROUNDING {
            return None;
        }
        let x = self.system.stepped(x, &self.factorisation.scales, 1.0, dx);
        self.system.evaluate_values(&x, &mut self.work, self.stats).ok()?;
        let last = Last { x, evaluated: true, size: 0.0 };
        // The magnitudes of the solution first: boundary residuals are relative to them.
        let arrived = self.is_small(&last) && !self.own.as_ref().is_some_and(|own| own.smaller);
        if arrived && self.boundary_residual() <= self.limits.boundary {
            return Some(last.x);
        }
        self.roughly = Some(last.x);
        None
    }

    /// As much of a correction as is progress, at first as much as `first` says. Of the correction its norm and its
    /// largest component are given.
    fn damped_step(
        &mut self,
        x: &Iterate,
        dx: &Correction,
        (size, largest): (f64, f64),
        first: f64,
    ) -> Result<Step, Failure> {
        let mut damping = if self.limits.insistent { first } else { 1.0 };
        let mut reduced = false;
        let smallest = if largest <= STAGNANT { 0.01 } else { self.limits.smallest_damping };
        loop {
            if damping < smallest {
                return Ok(Step::Stuck(self.stalled(damping, dx)));
            }
            self.budget.check(self.stats).map_err(Failure::Interrupted)?;
            let trial = self.system.stepped(x, &self.factorisation.scales, damping, dx);
            if let Err(error) = self.evaluate(&trial, Derivatives::None) {
                if damping <= self.limits.smallest_damping {
                    return Err(NewtonError::NonFinite(error).into());
                }
                reduced = true;
                damping = (damping / 2.0).max(self.limits.smallest_damping);
                continue;
            }
            if damping == 1.0 && self.limits.tolerance >= NEAR_ROUNDING && self.is_met() {
                self.contraction = self.contraction.or(Some(0.0));
                return Ok(Step::Done(Last { x: trial, evaluated: true, size: 0.0 }));
            }
            let simplified = self.correction();
            let new_size = self.system.norm(&simplified);
            let contraction = new_size / size;
            let deviation = self.system.distance(&simplified, 1.0 - damping, dx);
            // Deuflhard (3.48): λ' = ½ ‖Δx‖ λ² / ‖Δx̄ - (1-λ) Δx‖.
            let estimate = 0.5 * size * damping * damping / deviation;
            if self.contraction.is_none() && damping == 1.0 {
                self.contraction = Some(contraction);
            }
            let forced = !self.limits.insistent && damping <= FORCED_DAMPING && contraction.is_finite();
            if !(contraction < 1.0 || forced) {
                reduced = true;
                let half = damping / 2.0;
                damping = match self.limits.insistent {
                    true if estimate.is_finite() => estimate.min(half).max(damping / 10.0),
                    _ => half,
                };
                continue;
            }
            let possible = if estimate.is_finite() { estimate.min(1.0) } else { 1.0 };
            if damping == 1.0 {
                let left = self.system.largest(&simplified);
                if left <= self.limits.tolerance {
                    return Ok(Step::Done(self.last(trial, &simplified, left)));
                }
            }
            if possible >= 4.0 * damping && !reduced {
                damping = possible;
                continue;
            }
            return Ok(Step::Moved { x: trial, simplified, damping, contraction });
        }
    }

    /// Whether the residual that is held is one of rounding: a further correction would be, too. So do linear problems
    /// end.
    fn is_met(&self) -> bool {
        let scales = &self.factorisation.scales;
        self.system.is_rounded(&self.work, scales)
            && self.system.boundary_residuals(&self.work, scales).all(|residual| residual == 0.0)
    }

    /// After the last correction, whose residual is held; `size`: its largest component.
    fn last(&self, x: Iterate, correction: &Correction, size: f64) -> Last {
        let Limits { tolerance, .. } = self.limits;
        if tolerance >= NEAR_ROUNDING && size <= NEGLIGIBLE * tolerance {
            return Last { x, evaluated: true, size };
        }
        Last { x: self.system.stepped(&x, &self.factorisation.scales, 1.0, correction), evaluated: false, size }
    }

    /// Whether the last correction is small beside the iterate that it led to, too: see [`BY_FAR`].
    fn is_small(&mut self, last: &Last) -> bool {
        let (held, found) = (&self.factorisation.scales, self.system.scales(&last.x));
        let states = held.states.iter().flatten().zip(found.states.iter().flatten());
        let ratios = states.chain(held.constants.iter().zip(&found.constants)).map(|(held, found)| held / found);
        let (least, largest) = ratios.fold((1.0, 1.0), |(least, most): (f64, f64), r| (least.min(r), most.max(r)));
        if largest > BY_FAR || least < 1.0 / BY_FAR {
            self.own = Some(OwnScales { scales: found, smaller: largest > BY_FAR });
        }
        largest <= BY_FAR || largest * last.size <= self.limits.tolerance
    }

    /// Further corrections with the held matrix, as long as fewer are needed than a new matrix costs.
    fn simplified_steps(
        &mut self,
        mut x: Iterate,
        first: &Correction,
        mut contraction: f64,
    ) -> Result<Simplified, Failure> {
        let mut dx = first.clone();
        loop {
            let (size, largest) = (self.system.norm(&dx), self.system.largest(&dx));
            let needed = libm::log(self.limits.tolerance / largest) / libm::log(contraction.max(1e-300));
            if !(needed <= SIMPLIFIED_LIMIT) {
                return Ok(Simplified::Ended(x));
            }
            self.budget.check(self.stats).map_err(Failure::Interrupted)?;
            let trial = self.system.stepped(&x, &self.factorisation.scales, 1.0, &dx);
            if self.evaluate(&trial, Derivatives::None).is_err() {
                return Ok(Simplified::Ended(x));
            }
            let next = self.correction();
            let rate = self.system.norm(&next) / size;
            if !(rate < 1.0) {
                return Ok(Simplified::Ended(x));
            }
            self.stats.simplified_corrections += 1;
            let left = self.system.largest(&next);
            if left <= self.limits.tolerance {
                return Ok(Simplified::Converged(self.last(trial, &next, left)));
            }
            if rate > SIMPLIFIED_CONTRACTION {
                return Ok(Simplified::Ended(trial));
            }
            (x, dx, contraction) = (trial, next, rate);
        }
    }

    /// The residual where the iteration ended, for integrals, boundary residuals and dense output.
    fn finish(mut self, last: Last, stagnated: Option<NewtonError>) -> Result<Converged, Failure> {
        let Last { x, evaluated, .. } = last;
        if !evaluated {
            self.evaluate(&x, Derivatives::None).map_err(NewtonError::NonFinite)?;
        }
        let x = if stagnated.is_none() { self.closed(x)? } else { x };
        Ok(self.ended(x, stagnated))
    }

    /// With all that is held, which is that of `x`.
    fn ended(self, x: Iterate, stagnated: Option<NewtonError>) -> Converged {
        let contraction = self.contraction.unwrap_or(0.0);
        Converged {
            x,
            work: self.work,
            factorisation: self.factorisation,
            own: self.own,
            contraction,
            linear: contraction <= LINEAR && self.first.is_some_and(|first| first >= FAR),
            at_once: self.iteration == 1 && self.contraction.is_none(),
            iterations: self.iteration,
            full_steps: self.full_steps && self.escapes == 0,
            stagnated: stagnated.or(self.undetermined),
        }
    }

    /// Ends the iteration at `x` for want of a better iterate. Of a linear problem what the first correction led to is
    /// as good as rounding allows on these meshes, and says where they are to be finer.
    fn stagnate(mut self, x: Iterate, dx: &Correction, error: NewtonError) -> Result<Converged, Failure> {
        let size = self.system.largest(dx);
        if size <= self.limits.stagnation {
            self.finish(Last { x, evaluated: false, size }, None)
        } else if size <= STAGNANT {
            self.finish(Last { x, evaluated: false, size }, Some(error))
        } else if let Some(x) = self.roughly.take() {
            self.finish(Last { x, evaluated: false, size }, Some(error))
        } else {
            Err(error.into())
        }
    }

    /// Says how large the largest component of a correction is, and what the last one was damped by.
    fn announce(&mut self, correction: f64, damping: f64) -> Result<(), Failure> {
        let event =
            Event::Newton { iteration: self.iteration, intervals: intervals(&self.system.grids), correction, damping };
        self.budget.notify(self.observer, &event, self.stats).map_err(Failure::Interrupted)
    }

    fn stalled(&self, damping: f64, dx: &Correction) -> NewtonError {
        NewtonError::Stalled {
            iterations: self.iteration,
            damping,
            correction: self.system.largest(dx),
            largest: self.system.largest_components(dx),
        }
    }

    fn limit_reached(&self, dx: &Correction) -> NewtonError {
        NewtonError::IterationLimit {
            iterations: self.limits.iterations,
            correction: self.system.largest(dx),
            largest: self.system.largest_components(dx),
        }
    }
}
