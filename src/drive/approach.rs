//! From one solution to the answer of another question.

use solver::Guess;
use solver::continuation::{Path, PathOptions, Ramp, follow_observed};

use super::belt::BeltProblem;
use super::budget::Budget;
use super::correct::{corrected, relaxed};
use super::failure::Failure;
use super::position::Position;
use super::question::{Known, Question, Swap};
use super::solved::{Solved, accepted};
use super::start::{flow_at, inertia};
use crate::cancel::is_cancelled;
use crate::case::ModelChoices;
use crate::model::{Constant, Constants};

/// Follows the solution `from` while given constants and prescribed outputs go from the values they have there to those
/// of `question`: the slip threshold geometrically, all others linearly. Both must be of one model.
pub(super) fn approach(
    model: &ModelChoices,
    from: &Solved,
    question: &Question,
    options: &PathOptions,
    budget: &mut Budget,
) -> Result<Solved, Failure> {
    let (belt, start) = (posed(model, question)?, start(from, question)?);
    let mut path = Ramp::new();
    for ((_, asked), index) in question.conditions().zip(Constant::ALL.len()..) {
        let here = start.constants.get(index).copied().unwrap_or(f64::NAN);
        path = path.linear(index, here, asked);
    }
    let first_law = Constant::ALL.len() + question.conditions().count();
    for (_, index) in question.closings.iter().zip(first_law..) {
        let here = start.constants.get(index).copied().unwrap_or(f64::NAN);
        path = path.linear(index, here, 0.0);
    }
    let unknowns = question.unknowns();
    for constant in Constant::ALL.into_iter().filter(|constant| !unknowns.contains(constant)) {
        let index = constant.index();
        let Some(&here) = start.constants.get(index) else { continue };
        let there = asked(question, constant);
        path = match constant {
            _ if here == there => path,
            Constant::SlipThreshold => path.geometric(index, here, there),
            _ => path.linear(index, here, there),
        };
    }
    let unknowns: Vec<usize> = unknowns.into_iter().map(Constant::index).collect();
    let path = RatioPath { ramp: path, free: unknowns.contains(&Constant::SpeedRatio.index()) };
    let relaxed = PathOptions { solve: relaxed(&options.solve), ..options.clone() };
    let followed = match follow_observed(&belt, &start, &path, &unknowns, &relaxed, budget) {
        Ok(followed) => followed,
        Err(_) if is_cancelled() => return Err(Failure::Cancelled),
        Err(error) => {
            let begun = (&from.solution, start.constants.as_slice());
            let last = error.last.as_deref().map_or(begun, |last| (last, last.constants()));
            return Err(Failure::approaching(&belt, question, last, error.cause));
        }
    };
    let mut stats = from.stats;
    stats += *followed.solution.stats();
    let continuation_steps = from.continuation_steps + accepted(&followed);
    match corrected(&belt, followed.solution, &options.solve, !question.is_ordinary(), &mut stats, budget) {
        Ok(solution) => {
            Ok(Solved { question: question.clone(), belt, stats, continuation_steps, solution, route: None })
        }
        Err((last, cause)) => Err(Failure::approaching(&belt, question, (&last, last.constants()), Box::new(cause))),
    }
}

/// The problem that a question poses.
pub(super) fn posed(model: &ModelChoices, question: &Question) -> Result<BeltProblem, Failure> {
    let prescribed: Vec<_> = question.conditions().collect();
    let belt = BeltProblem::prescribing(model, &question.constants, &prescribed)?.ok_or(Failure::NoEquations)?;
    Ok(belt.closed(&question.closings)?)
}

/// A solution as the start of a question's problem: every prescribed output at the value that it has there.
pub(super) fn start(from: &Solved, question: &Question) -> Result<Guess, Failure> {
    Ok(Guess { constants: Position::of(from, question)?.vector(), ..Guess::from(&from.solution) })
}

/// The value of a given constant: as the question has it, or prescribed.
fn asked(question: &Question, constant: Constant) -> f64 {
    let prescribes = |swap: &&Swap| swap.known == Known::Constant(constant);
    question.swaps.iter().find(prescribes).map_or(question.constants[constant], |swap| swap.value)
}

/// A path on which radii may move. What counts on the secondary is σ R_S/R_P, the belt's speed over the rim's, to a
/// share of the slip threshold: it, rather than σ, is predicted linearly.
struct RatioPath {
    ramp: Ramp,
    /// Whether the speed ratio is unknown.
    free: bool,
}

impl Path for RatioPath {
    fn constants(&self, lambda: f64, constants: &mut [f64]) {
        self.ramp.constants(lambda, constants);
    }

    fn slope(&self, lambda: f64, slope: &mut [f64]) {
        self.ramp.slope(lambda, slope);
    }

    fn bend(&self, from: &[f64], predicted: &mut [f64]) {
        let place = [Constant::SpeedRatio, Constant::SecondaryRadius, Constant::PrimaryRadius].map(Constant::index);
        let [Some(sigma), Some(secondary), Some(primary)] = place.map(|at| Some((*from.get(at)?, *predicted.get(at)?)))
        else {
            return;
        };
        let change = |(from, to): (f64, f64)| (to - from) / from;
        let change_of_speed = 1.0 + change(sigma) + change(secondary) - change(primary);
        let bent = change_of_speed * (sigma.0 * secondary.0 / primary.0) * primary.1 / secondary.1;
        if let Some(sigma) = predicted.get_mut(Constant::SpeedRatio.index()).filter(|_| self.free && bent.is_finite()) {
            *sigma = bent;
        }
        if self.free
            && change(sigma) > LARGE_RISE
            && let (Ok(here), Ok(there)) = (Constants::try_from(from), Constants::try_from(&*predicted))
            && let Some(flow) = flow_that_keeps_up(&here, &there)
            && let Some(predicted) = predicted.get_mut(Constant::Flow.index())
        {
            *predicted = flow;
        }
    }
}

/// Rise of the speed ratio in one step, relative, from which on the belt's mass flow is predicted by
/// [`flow_that_keeps_up`].
const LARGE_RISE: f64 = 1e-2;

/// The mass flow with which V/σ, the belt's speed over that of the secondary's rim, is what the tangent says: it too
/// counts to a share of the slip threshold, and where the secondary runs away, the belt that it drives is stretched by
/// its own inertia, so that V(g) bends. Nothing where what V depends on is moved as well.
fn flow_that_keeps_up(here: &Constants, there: &Constants) -> Option<f64> {
    let given = [
        Constant::LongitudinalStiffness,
        Constant::MassPerLength,
        Constant::PrimaryRadius,
        Constant::SecondaryRadius,
        Constant::PrimarySpeed,
    ];
    if given.into_iter().any(|constant| here[constant] != there[constant]) {
        return None;
    }
    let inertia = inertia(here);
    let stretch = |at: &Constants| 1.0 + at[Constant::SlackTension] / at[Constant::LongitudinalStiffness];
    let (flow, sigma, stretched) = (here[Constant::Flow], here[Constant::SpeedRatio], stretch(here));
    let (flow_there, sigma_there, stretched_there) =
        (there[Constant::Flow], there[Constant::SpeedRatio], stretch(there));
    // ln V(g) = ln g + ln(1 + T/EA) − ln(1 − c g²), with c = m_o (R_P ω_P)²/EA, and its change on the tangent.
    let slope = (1.0 + inertia * flow * flow) / (1.0 - inertia * flow * flow);
    let change = slope * (flow_there - flow) / flow + (stretched_there - stretched) / stretched;
    let speed = flow * stretched / (1.0 - inertia * flow * flow);
    let there = speed / sigma * (1.0 + change - (sigma_there - sigma) / sigma) * sigma_there;
    let flow = flow_at(there, inertia, stretched_there);
    flow.is_finite().then_some(flow)
}
