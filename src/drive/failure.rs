//! Why there is no solution.

use solver::{Solution, SolveError};
use thiserror::Error;

use super::belt::BeltProblem;
use super::power::told;
use super::question::{Known, Question};
use super::trouble::Trouble;
use crate::model::{Constant, Constants, IllPosed, InternalError};

/// Why there is no solution.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum Failure {
    /// The equations of this model are not known.
    #[error("there are no equations for this choice of model")]
    NoEquations,
    /// What must not happen.
    #[error(transparent)]
    Internal(#[from] InternalError),
    /// A warm start without a solution to start from.
    #[error("there is no solution to start from")]
    NoStart,
    /// A question that has no answer whatever the numbers.
    #[error(transparent)]
    IllPosed(#[from] IllPosed),
    /// Newton's method failed on the straight belt under a small torque.
    #[error("no solution: {trouble}; not even a straight belt under a small torque was found to start from")]
    Start {
        /// What happened to the belt.
        trouble: Trouble,
        /// What the solver says.
        cause: Box<SolveError>,
    },
    /// The equations are singular at the solution.
    #[error("the solution has no derivatives: {0}")]
    Sensitivities(SolveError),
    /// The path from the start to the case was lost.
    #[error(
        "no solution: {trouble}; the last one found on the path has a primary torque of {torque:.4} N·m, a slack \
         tension of {slack_tension:.4} N and a slip threshold of {slip_threshold:.3e} m/s"
    )]
    Lost {
        /// What happened to the belt.
        trouble: Trouble,
        /// Primary torque reached, N·m.
        torque: f64,
        /// Slip threshold reached, m/s.
        slip_threshold: f64,
        /// Slack tension reached, N.
        slack_tension: f64,
        /// What the solver says of the next step.
        cause: Box<SolveError>,
    },
    /// From a solution nearby, what is prescribed could not be reached.
    #[error(
        "{} cannot be reached: {trouble}; the last solution on the path has {}, a primary torque of {torque:.4} N·m \
         and a slack tension of {slack_tension:.4} N", asked(.reached), had(.reached)
    )]
    Unreached {
        /// What happened to the belt.
        trouble: Trouble,
        /// What is prescribed.
        reached: Vec<Reached>,
        /// Primary torque there, N·m.
        torque: f64,
        /// Slack tension there, N.
        slack_tension: f64,
        /// What the solver says of the next step.
        cause: Box<SolveError>,
    },
    /// The belt's temperature does not settle.
    #[error(
        "the balance of the belt's heat has no end: at {temperature:.1} K it is still warming or cooling; give a \
         larger `thermal.heat_transfer`, or smaller softenings"
    )]
    Temperature {
        /// Temperature reached, K.
        temperature: f64,
    },
    /// No clamp that was tried leaves the margin against slip that is asked for.
    #[error(
        "no clamp was found at which {:.1} % of the friction at hand is used: at a slack tension of \
         {slack_tension:.1} N it is {:.1} %, and nearer no solution was found", 100.0 * asked, 100.0 * used
    )]
    Margin {
        /// Share asked for.
        asked: f64,
        /// Nearest share that was found.
        used: f64,
        /// Slack tension there, N.
        slack_tension: f64,
        /// Why there is none nearer.
        cause: Box<Failure>,
    },
    /// There is a solution, and not to the tolerance that is asked for.
    #[error("the tolerance of {asked:.0e} is not attained: this drive is solved to {attainable:.0e}")]
    Tolerance {
        /// As asked for.
        asked: f64,
        /// The tightest to which a solution was found.
        attainable: f64,
        /// What the solver says of a tighter one.
        cause: Box<SolveError>,
    },
    /// The solve was stopped from elsewhere: see [`cancellable`](crate::cancellable).
    #[error("cancelled: the solve was stopped before it had a solution")]
    Cancelled,
    /// A margin against slip, which `result::run` solves for, given to a solve of one problem.
    #[error("a margin against slip is prescribed: a single boundary value problem has none")]
    MarginGiven,
}

/// Relative difference of values that are the same.
const AT: f64 = 1e-9;

/// How far a prescribed value was approached, SI.
#[derive(Debug, Clone, PartialEq)]
pub struct Reached {
    /// Key, or output.
    pub name: String,
    /// The value where the solution was lost.
    pub value: f64,
    /// The value asked for.
    pub asked: f64,
}

fn asked(reached: &[Reached]) -> String {
    reached.iter().map(|at| format!("`{}` = {}", at.name, at.asked)).collect::<Vec<_>>().join(" with ")
}

fn had(reached: &[Reached]) -> String {
    reached.iter().map(|at| format!("`{}` = {:.6}", at.name, at.value)).collect::<Vec<_>>().join(", ")
}

impl Failure {
    /// Of a margin that was not met.
    pub(crate) fn margin(asked: f64, used: f64, slack_tension: f64, cause: Self) -> Self {
        Self::Margin { asked, used, slack_tension, cause: Box::new(cause) }
    }

    /// Whether the case is at fault rather than the search.
    pub const fn is_bad_input(&self) -> bool {
        matches!(self, Self::IllPosed(_))
    }

    /// Whether the solve was stopped from elsewhere, so that nothing else is to be tried.
    pub const fn is_cancelled(&self) -> bool {
        matches!(self, Self::Cancelled)
    }

    /// What happened to the belt, where a solution was sought and not found.
    pub fn trouble(&self) -> Option<Trouble> {
        match self {
            Self::Start { trouble, .. } | Self::Lost { trouble, .. } | Self::Unreached { trouble, .. } => {
                Some(*trouble)
            }
            Self::Margin { cause, .. } => cause.trouble(),
            Self::NoEquations
            | Self::Internal(_)
            | Self::NoStart
            | Self::IllPosed(_)
            | Self::Sensitivities(_)
            | Self::Temperature { .. }
            | Self::Tolerance { .. }
            | Self::Cancelled
            | Self::MarginGiven => None,
        }
    }

    /// Whether the path was followed to the question itself, and only the solution there is lacking.
    pub(super) fn is_at(&self, question: &Question) -> bool {
        let near = |here: f64, there: f64| (here - there).abs() <= AT * there.abs().max(f64::MIN_POSITIVE);
        let given = |constant: Constant, here: f64| near(here, question.constants[constant]);
        match self {
            Self::Lost { torque, slip_threshold, slack_tension, .. } => {
                given(Constant::PrimaryTorque, *torque)
                    && given(Constant::SlipThreshold, *slip_threshold)
                    && given(Constant::SlackTension, *slack_tension)
            }
            Self::Unreached { reached, .. } => reached.iter().all(|at| near(at.value, at.asked)),
            _ => false,
        }
    }

    /// What the solver met, in its own words: for whoever looks into the search rather than the belt.
    pub fn solver(&self) -> Option<&SolveError> {
        match self {
            Self::Start { cause, .. } | Self::Lost { cause, .. } | Self::Unreached { cause, .. } => Some(cause),
            Self::Tolerance { cause, .. } => Some(cause),
            Self::Sensitivities(cause) => Some(cause),
            Self::Margin { cause, .. } => cause.solver(),
            Self::NoEquations
            | Self::Internal(_)
            | Self::NoStart
            | Self::IllPosed(_)
            | Self::Temperature { .. }
            | Self::Cancelled
            | Self::MarginGiven => None,
        }
    }

    /// The likely cause and what to try, where there is more to say than the message says.
    pub fn hint(&self) -> Option<&'static str> {
        match self {
            Self::Margin { .. } => Some("`sheave limit` finds the smallest clamp that carries the torque"),
            Self::Tolerance { .. } => Some("ask for that tolerance, or for another order of the collocation"),
            Self::Start { trouble: Trouble::Unknown, .. } => {
                Some("look for a value in the wrong unit: `inputs` has what was understood, in SI")
            }
            other => other.trouble().map(Trouble::advice),
        }
    }

    /// That of two failures which came farther towards `target`: with the case's own friction if possible, then with
    /// its torque, then with its tension. Any place on the path tells more than that none was found.
    pub(super) fn farther(first: Option<Self>, second: Self, target: &Constants) -> Self {
        match first {
            Some(first) if first.remaining(target) <= second.remaining(target) => first,
            _ => second,
        }
    }

    /// What is left of the path to `target`, in the order in which it counts: factor on the slip threshold, share of
    /// the torque, factor on the slack tension.
    fn remaining(&self, target: &Constants) -> [f64; 3] {
        match self {
            // What is prescribed is sought from a solution that has the case's friction.
            Self::Unreached { .. } | Self::Tolerance { .. } => [-1.0; 3],
            Self::Lost { slip_threshold, torque, slack_tension, .. } => {
                let factor = |here: f64, constant: Constant| libm::log(here / target[constant]).abs();
                let torque = (torque - target[Constant::PrimaryTorque]).abs();
                [
                    factor(*slip_threshold, Constant::SlipThreshold),
                    torque / target[Constant::PrimaryTorque].abs().max(f64::MIN_POSITIVE),
                    factor(*slack_tension, Constant::SlackTension),
                ]
            }
            _ => [f64::INFINITY; 3],
        }
    }

    /// Of a way to `target` that was lost at the solution `last`.
    pub(super) fn of(belt: &BeltProblem, target: &Constants, last: Option<&Solution>, cause: Box<SolveError>) -> Self {
        let trouble = Trouble::of(belt, last, target, &cause);
        let Some(last) = last else { return Self::Start { trouble, cause } };
        match Constants::try_from(last.constants()) {
            Err(error) => error.into(),
            Ok(constants) => Self::Lost {
                trouble,
                torque: constants[Constant::PrimaryTorque],
                slip_threshold: constants[Constant::SlipThreshold],
                slack_tension: constants[Constant::SlackTension],
                cause,
            },
        }
    }

    /// Of a path on which what `question` prescribes was approached, up to the solution `last`, where the constants and
    /// then what is prescribed have these values.
    pub(super) fn approaching(
        belt: &BeltProblem,
        question: &Question,
        (last, values): (&Solution, &[f64]),
        cause: Box<SolveError>,
    ) -> Self {
        if question.is_ordinary() {
            return Self::of(belt, &question.constants, Some(last), cause);
        }
        let constants = match Constants::try_from(values) {
            Ok(constants) => constants,
            Err(error) => return error.into(),
        };
        let targets = values.get(Constant::ALL.len()..).unwrap_or_default();
        let target = |known: Known| match known {
            Known::Constant(constant) => Ok(constants[constant]),
            Known::Output(output) => {
                let at = belt.prescribed().position(|other| other == output);
                at.and_then(|at| targets.get(at)).copied().ok_or(InternalError::Output(output))
            }
        };
        let brakes = constants[Constant::PrimaryTorque] < 0.0;
        let told = |known: Known, value: f64| match known {
            Known::Output(output) => told(output, value, brakes),
            Known::Constant(_) => value,
        };
        let reached = question.swaps.iter().map(|swap| {
            let (value, asked) = (told(swap.known, target(swap.known)?), told(swap.known, swap.value));
            Ok(Reached { name: swap.known.name(), value, asked })
        });
        // Laws are met at zero.
        let laws = targets.iter().skip(question.conditions().count()).zip(&question.closings);
        let laws = laws
            .map(|(target, closing)| Ok(Reached { name: closing.law.name().to_owned(), value: *target, asked: 0.0 }));
        match reached.chain(laws).collect::<Result<_, InternalError>>() {
            Err(error) => error.into(),
            Ok(reached) => Self::Unreached {
                // What is not given is what it was there.
                trouble: Trouble::of(belt, Some(last), &constants, &cause),
                reached,
                torque: constants[Constant::PrimaryTorque],
                slack_tension: constants[Constant::SlackTension],
                cause,
            },
        }
    }
}

#[cfg(test)]
#[allow(clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]
mod tests {
    use super::*;
    use crate::case::Case;

    fn lost(slip_threshold: f64, torque: f64, slack_tension: f64) -> Failure {
        let cause = Box::new(SolveError::Cancelled);
        Failure::Lost { trouble: Trouble::Unknown, torque, slip_threshold, slack_tension, cause }
    }

    /// In whatever order the routes are tried, the failure that is shown is that of the place nearest the case: with
    /// its friction first, then its torque, then its tension, from above or from below.
    #[test]
    fn the_failure_of_the_place_nearest_the_case_is_kept() {
        let target = Question::of(&Case::base().resolve().expect("the base case")).constants;
        let [friction, torque, tension] =
            [Constant::SlipThreshold, Constant::PrimaryTorque, Constant::SlackTension].map(|given| target[given]);
        let start = || Failure::Start { trouble: Trouble::Work, cause: Box::new(SolveError::Cancelled) };
        let nearest_last = [
            start(),
            lost(1.0, torque, tension),
            lost(10.0 * friction, 0.1 * torque, 2.0 * tension),
            lost(friction, 0.5 * torque, tension),
            lost(friction, torque, 0.4 * tension),
            lost(friction, torque, 2.0 * tension),
            lost(friction, torque, tension),
        ];
        let key = |failure: &Failure| failure.to_string();
        for (at, far) in nearest_last.iter().enumerate() {
            for near in nearest_last.iter().skip(at + 1) {
                let copy = |failure: &Failure| match failure {
                    Failure::Lost { slip_threshold, torque, slack_tension, .. } => {
                        lost(*slip_threshold, *torque, *slack_tension)
                    }
                    _ => start(),
                };
                for (first, second) in [(far, near), (near, far)] {
                    let kept = Failure::farther(Some(copy(first)), copy(second), &target);
                    assert_eq!(key(&kept), key(near), "{} and {}", key(first), key(second));
                }
            }
        }
        // Of two that are as near, the first.
        let kept = Failure::farther(Some(lost(1.0, torque, 2.0 * tension)), lost(1.0, torque, 0.5 * tension), &target);
        assert_eq!(key(&kept), key(&lost(1.0, torque, 2.0 * tension)));
    }
}
