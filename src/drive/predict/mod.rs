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
pub(super) use path::{PathPiece, Waypoint};

/// Solutions of which a prediction makes use: the one that is left, and those before it.
pub const TRAIL: usize = 4;

/// The nodes on which a prediction stands, of those of the solution that is left.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Nodes {
    /// As many as a tolerance asks for.
    For(f64),
    /// All.
    All,
}

/// The guess at the end of a piece of path: where the solutions before it tell enough, from them alone, else by the
/// tangent there.
///
/// # Errors
/// [`SolveError`] where the problem has no tangent at the solution that is left.
pub(super) fn predicted(belt: &BeltProblem, path: &PathPiece<'_>, nodes: Nodes) -> Result<Guess, SolveError> {
    let limit = match nodes {
        Nodes::For(tolerance) => thin::SHARE * tolerance,
        Nodes::All => f64::NEG_INFINITY,
    };
    let kept = thin::kept(&path.from.solution, limit);
    match parabola::predicted(belt, path, &kept) {
        Some(guess) => Ok(guess),
        None => tangents::predicted(belt, path, &kept),
    }
}
