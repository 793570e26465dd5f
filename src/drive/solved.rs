//! A drive that has been solved.

use solver::continuation::Followed;
use solver::{Solution, Stats};

use super::belt::BeltProblem;
use super::question::Question;
use super::route::Route;
use crate::model::Constant;

/// A solved drive.
#[derive(Debug, Clone)]
pub struct Solved {
    /// What was asked.
    pub question: Question,
    /// The problem.
    pub belt: BeltProblem,
    /// Its solution.
    pub solution: Solution,
    /// Work over all continuation steps.
    pub stats: Stats,
    /// Continuation steps in all.
    pub continuation_steps: usize,
    /// The route from the start on which it was found, if it was found from nothing.
    pub route: Option<Route>,
}

impl Solved {
    /// A constant of the drive, given or found; SI.
    pub fn constant(&self, constant: Constant) -> f64 {
        self.solution.constants().get(constant.index()).copied().unwrap_or(f64::NAN)
    }
}

/// Steps that were accepted.
pub(super) fn accepted(followed: &Followed) -> usize {
    followed.steps.iter().filter(|step| step.accepted).count()
}
