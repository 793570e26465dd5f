//! The way down in the slip threshold, with the contacts divided as the sliding speeds ask for.
//!
//! A step moves the threshold by a factor, with the pieces that there are. Where |v| contradicts the branch of a piece,
//! or a step is lost because a piece is about to vanish, other divisions are tried, the one that |v| asks for first:
//! the first that its own solution bears out is gone on with. Where none is, the step is made shorter, and it is looked
//! closer; then the drive's own problem is solved for a short step, on a mesh with nodes at the joints.

use solver::continuation::{Followed, PathError, PathOptions, Ramp, follow_observed};
use solver::{Control, Guess, Options, Solution, SolveError, Stats};

use super::division::Division;
use super::held::Held;
use super::problem::Kinked;
use crate::drive::belt::BeltProblem;
use crate::drive::budget::Budget;
use crate::drive::tuning::{KINK_TOLERANCE, LARGEST_CONTRADICTION, LEAST_CONTRADICTION, THRESHOLD_STEP};
use crate::model::{Constant, Constants};

/// A shorter step than this factor on the slip threshold is of no use.
const SHORTEST: f64 = 0.9997;
/// Factor on the slip threshold of a step of the drive's own problem, and the shortest step after which it is taken.
const OWN_STEP: f64 = 0.95;
const OWN_FROM: f64 = 0.99;
/// Factors on the slip threshold at which another division is tried: one about to change may be settled farther on.
const FARTHER: [f64; 2] = [1.0, 0.9];
/// What looking closer leaves of the share by which |v| may contradict a branch of the law.
const CLOSER: f64 = 0.3;
/// Newton's tolerance: where the belt adheres, θ and x count to a share of the slip threshold.
const NEWTON_TOLERANCE: f64 = 1e-8;
/// Limits of Newton's iteration: what takes more is lost.
const ITERATIONS: usize = 20;
const SMALLEST_DAMPING: f64 = 1e-3;
/// The first contraction of Newton's iteration that parts of a step aim at, and how many there may be.
const CONTRACTION: f64 = 0.35;
const STEPS: usize = 100;
/// The smallest part of a step.
const SMALLEST_PART: f64 = 3e-2;
/// Mesh intervals of a piece.
const INTERVALS: usize = 2000;

/// The way from a solution to the slip threshold of a case.
pub(in crate::drive) struct Descent<'a, 'b> {
    own: &'a BeltProblem,
    goal: f64,
    path: PathOptions,
    budget: &'b mut Budget,
    stats: Stats,
    steps: usize,
}

/// Where it led.
pub(in crate::drive) struct Descended {
    /// A guess for the drive's own problem, with a node at every joint.
    pub guess: Guess,
    /// Why it is not at the case's slip threshold, if it is not.
    pub lost: Option<Box<SolveError>>,
    /// Work of the steps that were accepted, and their number.
    pub stats: Stats,
    pub steps: usize,
}

/// A step of the divided problem.
struct Step<'a> {
    there: Held<'a>,
    /// Why it did not get where it was to go.
    lost: Option<Box<SolveError>>,
}

impl<'a, 'b> Descent<'a, 'b> {
    /// To the slip threshold of `target`, with the solver's options of the case.
    pub fn new(own: &'a BeltProblem, target: &Constants, solver: &Options, budget: &'b mut Budget) -> Self {
        let solve = Options {
            tolerance: KINK_TOLERANCE.min(solver.tolerance),
            newton_tolerance: Some(NEWTON_TOLERANCE.min(0.01 * solver.tolerance)),
            control: Control::Defect,
            max_iterations: ITERATIONS,
            smallest_damping: SMALLEST_DAMPING,
            max_intervals: INTERVALS,
            rescues: 0,
            ..solver.clone()
        };
        let path = PathOptions {
            tolerance: KINK_TOLERANCE,
            max_iterations: ITERATIONS,
            first_step: 1.0,
            smallest_step: SMALLEST_PART,
            max_steps: STEPS,
            contraction: CONTRACTION,
            solve,
            ..PathOptions::default()
        };
        let goal = target[Constant::SlipThreshold];
        Self { own, goal, path, budget, stats: Stats::default(), steps: 0 }
    }

    /// From a solution of the drive's own problem. `None` if the belt does not tell how it slides.
    pub fn follow(mut self, from: Solution) -> Option<Descended> {
        let mut here = Held::whole(self.own, from);
        let (mut factor, mut clear) = (THRESHOLD_STEP, LARGEST_CONTRADICTION);
        let mut lost = None;
        while here.threshold() > self.goal * (1.0 + 1e-12) {
            if self.budget.is_spent() || factor > SHORTEST {
                lost = lost.or_else(|| Some(Box::new(SolveError::Cancelled)));
                break;
            }
            let division = here.asked(clear)?;
            let next = self.farther(&here, factor);
            let before = here.threshold();
            let Some(step) = self.step(&here, &division, next, &mut lost) else {
                (here, factor, clear) = self.closer(here, factor, clear, &mut lost);
                continue;
            };
            let asked = step.there.asked(clear)?;
            let mut candidates = Vec::new();
            let there = step.there;
            let found = if asked.structure() == division.structure() {
                here = there;
                if step.lost.is_none() {
                    (factor, clear) = ((factor * factor).max(THRESHOLD_STEP), LARGEST_CONTRADICTION);
                    continue;
                }
                if here.threshold() < before {
                    factor = factor.sqrt();
                }
                candidates.extend(here.division().map_or_else(Vec::new, |division| division.swapped(here.layer())));
                candidates.extend(asked.without_slivers());
                candidates.extend(here.flipped());
                self.settled(&here, &candidates, clear, &mut lost)
            } else {
                candidates.extend([asked.clone()].into_iter().chain(asked.without_slivers()));
                candidates.extend(there.division().map_or_else(Vec::new, |division| division.swapped(there.layer())));
                self.settled(&there, &candidates, clear, &mut lost)
            };
            match found {
                Some(found) => (here, clear) = (found, LARGEST_CONTRADICTION),
                None => (here, factor, clear) = self.closer(here, factor, clear, &mut lost),
            }
        }
        let arrived = here.threshold() <= self.goal * (1.0 + 1e-12);
        let lost = if arrived { None } else { lost };
        Some(Descended { guess: here.own_guess(), lost, stats: self.stats, steps: self.steps })
    }

    /// The slip threshold a step farther on.
    fn farther(&self, here: &Held<'_>, factor: f64) -> f64 {
        (here.threshold() * factor).max(self.goal)
    }

    /// A step with the contacts divided: where it got, and why no farther. Nothing if it got nowhere.
    fn step(
        &mut self,
        here: &Held<'a>,
        division: &Division,
        next: f64,
        lost: &mut Option<Box<SolveError>>,
    ) -> Option<Step<'a>> {
        let structure = division.structure();
        let same = here.division().is_some_and(|held| held.structure() == structure);
        let guess = if same { Guess::from(&here.solution) } else { here.guess(division) };
        let constants = Constants::try_from(here.constants()).ok()?;
        let kinked = Kinked::new(here.own(), &structure, &constants)?;
        let ramp = Ramp::new().geometric(Constant::SlipThreshold.index(), here.threshold(), next);
        let followed = follow_observed(&kinked, &guess, &ramp, &kinked.unknowns(), &self.path, self.budget);
        let (solution, failed) = self.counted(followed, lost)?;
        Some(Step { there: Held::divided(self.own, &kinked, division, solution), lost: failed })
    }

    /// What a continuation has found, and why not more.
    fn counted(
        &mut self,
        followed: Result<Followed, PathError>,
        lost: &mut Option<Box<SolveError>>,
    ) -> Option<(Solution, Option<Box<SolveError>>)> {
        let (solution, steps, failed) = match followed {
            Ok(followed) => (followed.solution, followed.steps, None),
            Err(error) => {
                *lost = Some(error.cause.clone());
                (*error.last?, error.steps, Some(error.cause))
            }
        };
        self.stats += *solution.stats();
        self.steps += steps.iter().filter(|step| step.accepted).count();
        Some((solution, failed))
    }

    /// The solution of the first of other divisions that it bears out itself.
    fn settled(
        &mut self,
        here: &Held<'a>,
        candidates: &[Division],
        clear: f64,
        lost: &mut Option<Box<SolveError>>,
    ) -> Option<Held<'a>> {
        for factor in FARTHER {
            for candidate in candidates {
                if self.budget.is_spent() {
                    return None;
                }
                let next = self.farther(here, factor);
                if let Some(Step { there, lost: None }) = self.step(here, candidate, next, lost)
                    && there.asked(clear)?.structure() == candidate.structure()
                {
                    return Some(there);
                }
            }
        }
        None
    }

    /// A shorter step, and a closer look; at last a short step of the drive's own problem.
    fn closer(
        &mut self,
        here: Held<'a>,
        factor: f64,
        clear: f64,
        lost: &mut Option<Box<SolveError>>,
    ) -> (Held<'a>, f64, f64) {
        let shorter = (factor.sqrt(), (CLOSER * clear).max(LEAST_CONTRADICTION));
        if factor <= OWN_FROM || self.budget.is_spent() {
            return (here, shorter.0, shorter.1);
        }
        let next = self.farther(&here, OWN_STEP);
        let ramp = Ramp::new().geometric(Constant::SlipThreshold.index(), here.threshold(), next);
        let unknowns: Vec<usize> = (0..Constant::UNKNOWN).collect();
        let mut path = self.path.clone();
        path.solve.newton_tolerance = None;
        let followed = follow_observed(self.own, &here.own_guess(), &ramp, &unknowns, &path, self.budget);
        match self.counted(followed, lost) {
            Some((solution, _)) if solution.constants()[Constant::SlipThreshold.index()] < here.threshold() => {
                (Held::whole(self.own, solution), factor, clear)
            }
            _ => (here, shorter.0, shorter.1),
        }
    }
}
