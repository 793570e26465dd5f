//! A guess for a drive near one that is solved.

mod moved;
mod nodes;
mod parabola;
mod path;
mod scale;
mod sliding;
mod tangents;

use solver::{Guess, SolveError};

use super::belt::BeltProblem;
pub use path::TRAIL;
pub(super) use path::{PathPiece, Waypoint};

/// The guess at the end of a piece of path, on as many of the nodes of its first solution as `tolerance` asks for, and
/// some more where that foresees that they will not do: where the solutions before it tell enough, from them alone,
/// else by the tangent there.
///
/// A belt without bending stiffness keeps all nodes: without some that its tolerance does not ask for, it is lost on
/// any step of more than a hundredth.
///
/// # Errors
/// [`SolveError`] where the problem has no tangent at the solution that is left.
pub(super) fn predicted(belt: &BeltProblem, path: &PathPiece<'_>, tolerance: f64) -> Result<Guess, SolveError> {
    match parabola::predicted(belt, path, tolerance) {
        Some(guess) => Ok(guess),
        None => tangents::predicted(belt, path, tolerance),
    }
}
