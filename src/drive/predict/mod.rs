//! A guess for a drive near one that is solved.

mod moved;
mod parabola;
mod path;
mod scale;
mod sliding;
mod tangents;
mod thin;

use solver::{Guess, SolveError};

use super::belt::BeltProblem;
pub use path::TRAIL;
pub(super) use path::{PathPiece, Waypoint};

/// The guess at the end of a piece of path, on as many of the nodes of its first solution as `tolerance` asks for:
/// where the solutions before it tell enough, from them alone, else by the tangent there.
///
/// A belt without bending stiffness keeps all nodes: without some that its tolerance does not ask for, it is lost on
/// any step of more than a hundredth.
///
/// # Errors
/// [`SolveError`] where the problem has no tangent at the solution that is left.
pub(super) fn predicted(belt: &BeltProblem, path: &PathPiece<'_>, tolerance: f64) -> Result<Guess, SolveError> {
    let limit = if path.bends { thin::SHARE * tolerance } else { f64::NEG_INFINITY };
    let kept = thin::kept(&path.from.solution, limit);
    match parabola::predicted(belt, path, &kept) {
        Some(guess) => Ok(guess),
        None => tangents::predicted(belt, path, &kept),
    }
}
