//! The two solutions that a prescribed axial force may have: as the slack tension falls, an axial force falls to a
//! least value and may rise again.

use solver::Linearisation;

use super::curve::{End, trace};
use super::failure::Failure;
use super::options::SolveOptions;
use super::question::Known;
use super::solved::Solved;
use super::warm::step_to_question;
use crate::case::ModelChoices;
use crate::model::{Constant, Output};

/// Which of two solutions is meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Branch {
    /// The one of higher slack tension, with more friction in reserve: the one that a drive which was clamped before it
    /// was loaded comes to.
    #[default]
    Tight,
    /// The one of lower slack tension.
    Loose,
}

impl Branch {
    /// Name in messages and on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Tight => "tight",
            Self::Loose => "loose",
        }
    }
}

/// Share by which slack tensions differ that are not the same.
const DISTINCT: f64 = 1e-3;
/// Share of the axial force above the given one at which the curve back to it ends.
const BEYOND: f64 = 1e-6;
/// Share of the work limit that the search for another solution may take.
const WORK_SHARE: usize = 8;

/// The axial force in whose place the slack tension is found, with its place among the outputs that are prescribed.
fn axial_force(solved: &Solved) -> Option<(usize, Output, f64)> {
    let is_force = |output: Output| matches!(output, Output::PrimaryAxialForce | Output::SecondaryAxialForce);
    let (output, value) = solved.question.swaps.iter().find_map(|swap| match swap.known {
        Known::Output(output) if swap.free == Constant::SlackTension && is_force(output) => Some((output, swap.value)),
        _ => None,
    })?;
    let at = solved.belt.prescribed().position(|other| other == output)?;
    Some((at, output, value))
}

/// On which side of the least axial force a solution for a prescribed one lies; nothing for other solutions.
///
/// # Errors
/// [`Failure::Sensitivities`] at the least force itself.
pub fn branch(solved: &Solved) -> Result<Option<Branch>, Failure> {
    let Some((at, ..)) = axial_force(solved) else { return Ok(None) };
    let linearisation = Linearisation::new(&solved.belt, &solved.solution).map_err(Failure::Sensitivities)?;
    let rates = linearisation.sensitivity(Constant::ALL.len() + at).constants;
    let falling = rates.get(Constant::SlackTension.index()).is_some_and(|rate| *rate < 0.0);
    Ok(Some(if falling { Branch::Loose } else { Branch::Tight }))
}

/// The other solution for a prescribed axial force, if the curve of solutions turns and comes back to it.
///
/// # Errors
/// [`Failure::NoEquations`], [`Failure::Cancelled`]. A curve that is lost before it comes back has no other solution to
/// show.
pub fn other_solution(
    model: &ModelChoices,
    solved: &Solved,
    options: &SolveOptions,
) -> Result<Option<Solved>, Failure> {
    let Some((_, output, value)) = axial_force(solved) else { return Ok(None) };
    let mut plain = solved.clone();
    plain.question.swaps.retain(|swap| swap.free != Constant::SlackTension);
    plain.question.constants[Constant::SlackTension] = solved.constant(Constant::SlackTension);
    let end = End { output, value: value * (1.0 + BEYOND), rising: true };
    let search = SolveOptions { work_limit: options.work_limit / WORK_SHARE, ..*options };
    let curve = trace(model, &plain, (Constant::SlackTension, output), false, end, &search)?;
    match (curve.lost, curve.points.last()) {
        (Some(Failure::Cancelled), _) => Err(Failure::Cancelled),
        (None, Some((_, near))) => {
            let Ok(other) = step_to_question(near, model, &solved.question, options) else { return Ok(None) };
            let [here, there] = [solved, &other].map(|solved| solved.constant(Constant::SlackTension));
            Ok(((there - here).abs() > DISTINCT * here.abs()).then_some(other))
        }
        _ => Ok(None),
    }
}
