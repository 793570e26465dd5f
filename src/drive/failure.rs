//! Why there is no solution.

use solver::{Solution, SolveError};
use thiserror::Error;

use super::belt::BeltProblem;
use super::question::{Known, Question};
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
    #[error("no solution was found for the start, a straight belt under a small torque: {0}")]
    Start(Box<SolveError>),
    /// The equations are singular at the solution.
    #[error("the solution has no derivatives: {0}")]
    Sensitivities(SolveError),
    /// The path from the start to the case was lost.
    #[error(
        "the solution was lost at primary torque {torque:.4} N·m, slip threshold {slip_threshold:.3e} m/s, slack tension \
         {slack_tension:.4} N: {cause}"
    )]
    Lost {
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
        "{} cannot be reached: the solution was lost at {}, where the primary torque is {torque:.4} N·m and the slack \
         tension {slack_tension:.4} N: {cause}", asked(.reached), had(.reached)
    )]
    Unreached {
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
        "the balance of the belt's heat has no end: at {temperature:.1} K it is still warming or cooling; give a larger \
         `thermal.heat_transfer`, or smaller softenings"
    )]
    Temperature {
        /// Temperature reached, K.
        temperature: f64,
    },
    /// No clamp that was tried leaves the margin against slip that is asked for.
    #[error(
        "no clamp was found at which {:.1} % of the friction at hand is used: at a slack tension of {slack_tension:.1} N it is \
         {:.1} %, and nearer no solution was found", 100.0 * asked, 100.0 * used
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
    /// A margin against slip, which `result::run` solves for, given to a solve of one problem.
    #[error("a margin against slip is prescribed: a single boundary value problem has none")]
    MarginGiven,
}

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

    /// What to try, where there is more to say than the message says.
    pub const fn hint(&self) -> Option<&'static str> {
        match self {
            Self::NoEquations
            | Self::Internal(_)
            | Self::NoStart
            | Self::IllPosed(_)
            | Self::Sensitivities(_)
            | Self::MarginGiven
            | Self::Temperature { .. } => None,
            Self::Start(_) => Some("look for a value in the wrong unit: `inputs` has what was understood, in SI"),
            Self::Lost { .. } | Self::Unreached { .. } => Some(
                "the belt may slip grossly: `sheave limit` finds the largest torque for a clamp and the smallest clamp for \
                 a torque",
            ),
            Self::Margin { .. } => Some("`sheave limit` finds the smallest clamp that carries the torque"),
        }
    }

    /// That of two failures which came closer to the case: with the case's own friction if possible, then with less
    /// tension, for it is loose belts that are lost.
    pub(super) fn farther(first: Option<Self>, second: Self) -> Self {
        let key = |failure: &Self| match failure {
            Self::Unreached { .. } => (-1.0, 0.0),
            Self::Lost { slip_threshold, slack_tension, .. } => (*slip_threshold, *slack_tension),
            _ => (f64::INFINITY, f64::INFINITY),
        };
        match first {
            Some(first) if key(&first) <= key(&second) => first,
            _ => second,
        }
    }

    /// Of a path that was lost at the solution `last`.
    pub(super) fn of(last: Option<&Solution>, cause: Box<SolveError>) -> Self {
        let Some(last) = last else { return Self::Start(cause) };
        match Constants::try_from(last.constants()) {
            Err(error) => error.into(),
            Ok(constants) => Self::Lost {
                torque: constants[Constant::PrimaryTorque],
                slip_threshold: constants[Constant::SlipThreshold],
                slack_tension: constants[Constant::SlackTension],
                cause,
            },
        }
    }

    /// Of a path on which what `question` prescribes was approached.
    pub(super) fn approaching(
        belt: &BeltProblem,
        question: &Question,
        last: Option<&Solution>,
        cause: Box<SolveError>,
    ) -> Self {
        let Some(last) = last.filter(|_| !question.is_ordinary()) else { return Self::of(last, cause) };
        let constants = match Constants::try_from(last.constants()) {
            Ok(constants) => constants,
            Err(error) => return error.into(),
        };
        let targets = last.constants().get(Constant::ALL.len()..).unwrap_or_default();
        let target = |known: Known| match known {
            Known::Constant(constant) => Ok(constants[constant]),
            Known::Output(output) => {
                let at = belt.prescribed().position(|other| other == output);
                at.and_then(|at| targets.get(at)).copied().ok_or(InternalError::Output(output))
            }
        };
        let reached = question
            .swaps
            .iter()
            .map(|swap| Ok(Reached { name: swap.known.name(), value: target(swap.known)?, asked: swap.value }));
        // Laws are met at zero.
        let laws = targets.iter().skip(question.conditions().count()).zip(&question.closings);
        let laws = laws
            .map(|(target, closing)| Ok(Reached { name: closing.law.name().to_owned(), value: *target, asked: 0.0 }));
        match reached.chain(laws).collect::<Result<_, InternalError>>() {
            Err(error) => error.into(),
            Ok(reached) => Self::Unreached {
                reached,
                torque: constants[Constant::PrimaryTorque],
                slack_tension: constants[Constant::SlackTension],
                cause,
            },
        }
    }
}
