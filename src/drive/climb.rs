//! The path along a route, from the easy drive at its beginning to the case.

use solver::continuation::{Ramp, follow_observed};
use solver::{Guess, Solution, SolveError, Stats};

use super::belt::BeltProblem;
use super::blend::Blend;
use super::budget::Budget;
use super::correct::{corrected, relaxed};
use super::failure::Failure;
use super::kinks::Descent;
use super::options::{SolveOptions, path_options, rough};
use super::route::Route;
use super::solved::accepted;
use super::start;
use crate::cancel::is_cancelled;
use crate::case::ModelChoices;
use crate::model::{Constant, Constants};

/// Factor on the tolerance of the path where the path is followed on finer meshes.
const FINER: f64 = 0.1;
/// Share of a route's work that its first path may take, where there is another way to go on.
const SHARE: f64 = 0.8;
/// The same where nothing but the last solution is to be told.
const MOST: f64 = 0.95;
/// How far the end of the path may be from a place where it was lost, for a try to get there at once: factors on slip
/// threshold and slack tension, and the rest of the torque on the primary's radius over the slack tension.
const LEAP_THRESHOLD: f64 = 10.0;
const LEAP_TENSION: f64 = 2.0;
const LEAP_PULL: f64 = 0.5;

/// Follows the stages of a route; where the path is lost, it goes on from there once more, on finer meshes.
pub(super) fn climb(
    model: &ModelChoices,
    belt: &BeltProblem,
    route: Route,
    target: &Constants,
    options: &SolveOptions,
    budget: &mut Budget,
) -> Result<(Solution, Stats, usize), Failure> {
    let mut climb = Climb { model, belt, route, target, options, stats: Stats::default(), steps: 0 };
    // What short steps do not reach, a leap may: something is left for it. A string has only the one path.
    let share = if model.bending.is_some() { SHARE } else { 1.0 };
    let given = budget.part((share * budget.left() as f64) as usize);
    let mut part = given;
    let smoothed = route.smoothed(model, target);
    let followed = match &smoothed {
        None if route == Route::Kinks => climb.descend(&mut part),
        Some((model, target)) => climb.smooth(model, target, &mut part),
        None => {
            let begin = route.begin(target);
            climb.follow(start::guess(belt, &begin), &begin, Mesh::Coarse, &mut part)
        }
    };
    budget.take(&given, &part);
    let lost = match followed {
        Ok(solution) => return Ok((solution, climb.stats, climb.steps)),
        Err(lost) => lost,
    };
    let Some(last) = lost.last.filter(|_| model.bending.is_some() && !budget.is_spent()) else {
        return Err(match (&smoothed, lost.failure) {
            // Where friction was another, what was reached says nothing of the case.
            (Some(_), Failure::Lost { cause, .. }) => climb.lost(None, cause).failure,
            (_, failure) => failure,
        });
    };
    if let Some(solution) = climb.leap(&last, budget) {
        return Ok((solution, climb.stats, climb.steps));
    }
    let again = match climb.follow(Guess::from(&*last), &Constants::of(&last), Mesh::Fine, budget) {
        Ok(solution) => return Ok((solution, climb.stats, climb.steps)),
        Err(again) => again,
    };
    match again.last.and_then(|last| climb.leap(&last, budget)) {
        Some(solution) => Ok((solution, climb.stats, climb.steps)),
        // Where friction was another, what was reached says nothing of the case.
        None if smoothed.is_some() => Err(again.failure),
        None => Err(Failure::farther(Some(lost.failure), again.failure, target)),
    }
}

/// Whether a place on the path is so near its end that Newton's iteration may get there at once.
fn is_near(here: &Constants, target: &Constants) -> bool {
    let factor = |constant: Constant| libm::log(here[constant] / target[constant]).abs();
    let pull =
        (here[Constant::PrimaryTorque] - target[Constant::PrimaryTorque]).abs() / target[Constant::PrimaryRadius];
    here[Constant::BendingStiffness] == target[Constant::BendingStiffness]
        && here[Constant::MassPerLength] == target[Constant::MassPerLength]
        && factor(Constant::SlipThreshold) <= libm::log(LEAP_THRESHOLD)
        && factor(Constant::SlackTension) <= libm::log(LEAP_TENSION)
        && pull <= LEAP_PULL * target[Constant::SlackTension]
}

/// How fine the meshes of the path are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Mesh {
    Coarse,
    Fine,
}

/// The path along a route.
struct Climb<'a> {
    model: &'a ModelChoices,
    belt: &'a BeltProblem,
    route: Route,
    target: &'a Constants,
    options: &'a SolveOptions,
    stats: Stats,
    steps: usize,
}

/// Where the path was lost, and why.
struct Lost {
    last: Option<Box<Solution>>,
    failure: Failure,
}

impl Climb<'_> {
    /// The end of the path from a place near it, in one step, on meshes that are halved where Newton's iteration fails:
    /// where the belt adheres on a sliver, steps along the path become too short to be of use.
    fn leap(&mut self, last: &Solution, budget: &mut Budget) -> Option<Solution> {
        if !is_near(&Constants::of(last), self.target) || budget.is_spent() || is_cancelled() {
            return None;
        }
        let mut guess = Guess::from(last);
        let given = guess.constants.iter_mut().zip(&self.target.0).skip(Constant::UNKNOWN);
        given.for_each(|(here, there)| *here = *there);
        let unknowns: Vec<usize> = (0..Constant::UNKNOWN).collect();
        let (rough, solver) = (rough(self.options), self.options.solver());
        let near = solver::solve_observed(self.belt, &guess, &unknowns, &relaxed(&rough), budget).ok()?;
        self.stats += *near.stats();
        let found =
            solver::solve_observed(self.belt, &Guess::from(&near), &unknowns, &relaxed(&solver), budget).ok()?;
        self.stats += *found.stats();
        self.steps += 1;
        corrected(self.belt, found, &solver, false, &mut self.stats, budget).ok()
    }

    /// Follows the route with another friction law, as far as that goes: what was found last is where the path of the
    /// case's own begins. Its failure is only heard of where no work is left for that.
    fn smooth(&mut self, model: &ModelChoices, target: &Constants, budget: &mut Budget) -> Result<Solution, Lost> {
        let Some(belt) = BeltProblem::new(model, target) else {
            return Err(Lost { last: None, failure: Failure::NoEquations });
        };
        let tolerance = self.route.tolerance(self.model).unwrap_or_else(|| rough(self.options).tolerance);
        let options = SolveOptions { tolerance, ..*self.options };
        let begin = self.route.begin(target);
        let (stats, steps) = (self.stats, self.steps);
        let mut climb = Climb { model, belt: &belt, target, options: &options, route: self.route, stats, steps };
        let followed = climb.follow(start::guess(&belt, &begin), &begin, Mesh::Coarse, budget);
        (self.stats, self.steps) = (climb.stats, climb.steps);
        match followed {
            Ok(end) if self.model.bending.is_none() => self.sharpen(&end, budget),
            Ok(end) => Err(self.lost(Some(Box::new(end)), Box::new(SolveError::Cancelled))),
            Err(lost) => Err(lost),
        }
    }

    /// To the case's torque and tension at the slip threshold of the start, and from there down in the threshold with
    /// the kinks of the friction law at nodes; at last the drive's own problem on the mesh that this leaves.
    fn descend(&mut self, budget: &mut Budget) -> Result<Solution, Lost> {
        let begin = self.route.begin(self.target);
        let mut eased = self.target.clone();
        eased[Constant::SlipThreshold] = begin[Constant::SlipThreshold];
        let options = SolveOptions { tolerance: rough(self.options).tolerance, ..*self.options };
        let (stats, steps) = (self.stats, self.steps);
        let mut climb = Climb { target: &eased, options: &options, stats, steps, ..*self };
        let followed = climb.follow(start::guess(self.belt, &begin), &begin, Mesh::Coarse, budget);
        (self.stats, self.steps) = (climb.stats, climb.steps);
        let from = followed?;
        let solver = self.options.solver();
        // Something is left to tell what was reached last.
        let given = budget.part((MOST * budget.left() as f64) as usize);
        let mut part = given;
        let down = Descent::new(self.belt, self.target, &solver, &mut part).follow(from);
        budget.take(&given, &part);
        let Some(down) = down else { return Err(Lost { last: None, failure: Failure::NoEquations }) };
        self.stats += down.stats;
        self.steps += down.steps;
        let unknowns: Vec<usize> = (0..Constant::UNKNOWN).collect();
        let found = solver::solve_observed(self.belt, &down.guess, &unknowns, &relaxed(&solver), budget);
        if let Some(cause) = down.lost {
            return Err(self.lost(found.ok().map(Box::new), cause));
        }
        let solution = found.map_err(|cause| self.lost(None, Box::new(cause)))?;
        self.stats += *solution.stats();
        corrected(self.belt, solution, &solver, false, &mut self.stats, budget)
            .map_err(|(last, cause)| self.lost(Some(last), Box::new(cause)))
    }

    /// From a solution under the smooth law to the case's own, for a belt without bending stiffness: the smooth law's
    /// weight goes to zero, on meshes that suit the kinks as they arise.
    fn sharpen(&mut self, end: &Solution, budget: &mut Budget) -> Result<Solution, Lost> {
        // What was reached under another law says nothing of the case.
        let lost = |climb: &Self, cause| climb.lost(None, cause);
        let Some(blend) = Blend::new(self.belt, self.model, self.target) else {
            return Err(Lost { last: None, failure: Failure::NoEquations });
        };
        let unknowns: Vec<usize> = (0..Constant::UNKNOWN).collect();
        let solver = self.options.solver();
        let mut options = path_options(self.model, relaxed(&solver));
        options.solve.tolerance = options.tolerance;
        let path = Ramp::new().linear(blend.weight(), 1.0, 0.0);
        let followed = follow_observed(&blend, &blend.begin(end), &path, &unknowns, &options, budget)
            .map_err(|error| lost(self, error.cause))?;
        self.stats += *followed.solution.stats();
        self.steps += accepted(&followed);
        let guess = blend.end(&followed.solution);
        let solution = solver::solve_observed(self.belt, &guess, &unknowns, &relaxed(&solver), budget)
            .map_err(|cause| lost(self, Box::new(cause)))?;
        self.stats += *solution.stats();
        corrected(self.belt, solution, &solver, false, &mut self.stats, budget)
            .map_err(|(_, cause)| lost(self, Box::new(cause)))
    }

    fn lost(&self, last: Option<Box<Solution>>, cause: Box<SolveError>) -> Lost {
        Lost { failure: Failure::of(self.belt, self.target, last.as_deref(), cause), last }
    }

    /// Follows the stages from a guess whose given constants are those of `begin`.
    fn follow(&mut self, guess: Guess, begin: &Constants, mesh: Mesh, budget: &mut Budget) -> Result<Solution, Lost> {
        let stages = self.route.stages(begin, self.target);
        let unknowns: Vec<usize> = (0..Constant::UNKNOWN).collect();
        let (count, mut guess, mut found) = (stages.len(), guess, None::<Solution>);
        for (index, path) in stages.into_iter().enumerate() {
            let solver = if index + 1 == count { self.options.solver() } else { rough(self.options) };
            let mut options = path_options(self.model, relaxed(&solver));
            options.tolerance =
                self.route.tolerance(self.model).map_or(options.tolerance, |fine| fine.min(options.tolerance));
            if mesh == Mesh::Fine {
                options.tolerance *= FINER;
                options.max_iterations *= 2;
            }
            let followed = follow_observed(self.belt, &guess, &path, &unknowns, &options, budget);
            // What was found on the stages before is as good a place to go on from.
            let followed = match followed {
                Ok(followed) => followed,
                Err(error) => return Err(self.lost(error.last.or(found.map(Box::new)), error.cause)),
            };
            self.stats += *followed.solution.stats();
            let steps = accepted(&followed);
            self.steps += steps;
            let corrected = corrected(self.belt, followed.solution, &solver, false, &mut self.stats, budget);
            let solution = match corrected {
                Ok(solution) => solution,
                Err((last, cause)) => return Err(self.lost(Some(last), Box::new(cause))),
            };
            let here = Constants::of(&solution);
            tracing::info!(
                "stage {} of {count} in {} steps: {:.3} N·m, {:.2} N of slack tension, slip threshold {:.1e} m/s, {} \
                intervals",
                index + 1,
                steps,
                here[Constant::PrimaryTorque],
                here[Constant::SlackTension],
                here[Constant::SlipThreshold],
                solution.intervals(),
            );
            guess = Guess::from(&solution);
            found = Some(solution);
        }
        found.ok_or(Lost { last: None, failure: Failure::NoEquations })
    }
}
