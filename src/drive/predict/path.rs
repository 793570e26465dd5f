//! Solutions along a path.

use std::borrow::Cow;

use solver::Solution;

use crate::drive::belt::BeltProblem;
use crate::drive::failure::Failure;
use crate::drive::position::Position;
use crate::drive::question::Question;
use crate::drive::solved::Solved;
use crate::model::InternalError;

/// Solutions of which a prediction makes use: the one that is left, and those before it.
pub const TRAIL: usize = 4;

/// Cosine of the angle between two steps beyond which the path counts as turning.
const STRAIGHT: f64 = 0.98;
/// A step back, in steps ahead, too short to tell a bend.
const SHORTEST_BACK: f64 = 0.2;

/// A solution on a path, and where it stands.
#[derive(Debug, Clone)]
pub(in crate::drive) struct Waypoint<'a> {
    pub solution: Cow<'a, Solution>,
    pub position: Position,
}

impl<'a> Waypoint<'a> {
    /// A solution of another question, on the way to the answer of this one.
    ///
    /// # Errors
    /// As [`Position::of`].
    pub fn of(solved: &'a Solved, question: &Question) -> Result<Self, Failure> {
        Ok(Self { solution: Cow::Borrowed(&solved.solution), position: Position::of(solved, question)? })
    }

    /// A solution of the question's own problem.
    ///
    /// # Errors
    /// As [`Position::within`].
    pub fn within(solution: Solution) -> Result<Self, InternalError> {
        let position = Position::within(&solution)?;
        Ok(Self { solution: Cow::Owned(solution), position })
    }
}

/// A piece of the path from one solution to another.
#[derive(Debug, Clone, Copy)]
pub(in crate::drive) struct PathPiece<'a> {
    /// The solutions before the one that is left, the nearest first.
    pub before: &'a [Waypoint<'a>],
    /// The solution that is left.
    pub from: &'a Waypoint<'a>,
    /// Where it is to go; unknown constants are not read.
    pub to: &'a Position,
    /// Indices of the unknown constants.
    pub unknowns: &'a [usize],
    /// Whether the belt resists bending.
    pub bends: bool,
}

/// How the distance of two values is measured, both of what is given or asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Measure {
    /// By their difference.
    Linear,
    /// By their logarithms, unless their signs differ: twice as much is as far wherever one starts.
    Logarithmic,
}

impl Measure {
    /// From `here` to `there`; to first order, their difference.
    fn apart(self, here: f64, there: f64) -> f64 {
        match self {
            Self::Logarithmic if there / here > 0.0 => here * libm::log(there / here),
            _ => there - here,
        }
    }
}

impl PathPiece<'_> {
    /// How far behind the solution that is left another lies, in steps ahead; `None` if the path turns there, or where
    /// the two are too close to tell a bend.
    pub(super) fn back(&self, belt: &BeltProblem, to: &Waypoint<'_>, measure: Measure) -> Option<f64> {
        let here = &self.from.position;
        let (mut ahead, mut behind, mut product) = (0.0, 0.0, 0.0);
        let ends = to.position.vector().into_iter().zip(self.to.vector());
        let moves = here.vector().into_iter().zip(here.magnitudes(belt)).zip(ends);
        for (_, ((here, size), (back, to))) in moves.enumerate().filter(|(at, _)| !self.unknowns.contains(at)) {
            let (a, b) = (measure.apart(here, to) / size, measure.apart(here, back) / size);
            (ahead, behind, product) = (ahead + a * a, behind + b * b, product + a * b);
        }
        let back = (behind / ahead).sqrt();
        (product < -STRAIGHT * (ahead * behind).sqrt() && back > SHORTEST_BACK).then_some(back)
    }

    /// How far behind the solution that is left the solutions before it lie, in steps ahead, as far as they lie on one
    /// line with it, each far enough from the next.
    pub(super) fn all_back(&self, belt: &BeltProblem, measure: Measure) -> Vec<f64> {
        let mut last = 0.0;
        let apart = |back: &f64| {
            let apart = back - last > SHORTEST_BACK;
            last = *back;
            apart
        };
        self.before.iter().map_while(|point| self.back(belt, point, measure)).take_while(apart).collect()
    }
}

/// The states of a region of a solution at some places.
pub(super) fn states_at(solution: &Solution, region: usize, places: &[f64]) -> Option<Vec<Vec<f64>>> {
    let part = solution.regions().get(region)?;
    Some(part.eval_many(places).chunks_exact(places.len().max(1)).map(<[f64]>::to_vec).collect())
}

/// a + h b
pub(super) fn sum(a: &[f64], h: f64, b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a + h * b).collect()
}
