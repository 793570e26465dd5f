//! The search for the equilibrium of a drive: from nothing, or from one nearby.

use super::error::EquilibriumError;
use super::estimate::{Estimate, elsewhere};
use super::phase::Direction;
use super::point::Equilibrium;
use super::question::{Given, Whole, start};
use crate::case::Resolved;
use crate::drive::{SolveOptions, solve_question};
use crate::model::Output;

/// Share of the speed by which two states of a belt that slips are two.
const JUMP: f64 = 0.03;
/// Shares of the secondary's speed from which an equilibrium is followed where none is found from nothing, and steps.
const SLOWER: [f64; 2] = [0.9, SLOWEST];
pub(super) const SLOWEST: f64 = 0.75;
const SLOWER_STEPS: u32 = 3;
/// By what the secondary's speed changes with each step towards one at which the belt slips as a clutch does, and steps
/// at most: down to a hundredth of the speed at which the primary closes.
const CLUTCH_STEP: f64 = 0.8;
const CLUTCH_STEPS: i32 = 21;

/// The equilibrium of a drive whose secondary turns at `secondary_speed` in rad/s, from nothing. Of the case, belt,
/// sheaves, center distance, actuators and engine count; its operating point and its radii do not. Where the search
/// comes to one at which the belt slips, it looks elsewhere for another that holds: a drive may have both. Where it
/// comes to none, it goes on from a slower secondary.
///
/// # Errors
/// See [`EquilibriumError`].
pub fn equilibrium(
    case: &Resolved,
    secondary_speed: f64,
    direction: Direction,
    options: &SolveOptions,
) -> Result<Equilibrium, EquilibriumError> {
    let mut error = match at_speed(case, secondary_speed, direction, options) {
        Err(
            error @ (EquilibriumError::Failure { .. }
            | EquilibriumError::Implausible { .. }
            | EquilibriumError::Cycle(_)),
        ) if !error.is_bad_input() && !error.is_cancelled() => error,
        done => return done,
    };
    let whole = Whole::new(case, Given::SecondarySpeed(secondary_speed), direction)?;
    for share in SLOWER {
        let Ok(near) = at_speed(case, share * secondary_speed, direction, options) else { continue };
        let left = |step: u32| 1.0 - f64::from(step) / f64::from(SLOWER_STEPS);
        let speeds = (1..=SLOWER_STEPS).map(|step| secondary_speed * libm::pow(share, left(step)));
        match whole.along(near, speeds, options) {
            Err(other) if !other.is_cancelled() => error = error.or_explained(other),
            done => return done,
        }
    }
    Err(error)
}

/// As [`equilibrium`], by starts at the speed itself alone.
pub(super) fn at_speed(
    case: &Resolved,
    secondary_speed: f64,
    direction: Direction,
    options: &SolveOptions,
) -> Result<Equilibrium, EquilibriumError> {
    let whole = Whole::new(case, Given::SecondarySpeed(secondary_speed), direction)?;
    let near = whole.rough();
    match whole.in_reach(&near) {
        Ok(()) => {}
        Err(open @ EquilibriumError::Disengaged { .. }) => return engaging(&whole, secondary_speed, open, options),
        Err(error) => return Err(error),
    }
    let from = |near: &Estimate| {
        let question = whole.question(near.phase, &start(case, near));
        let solved = solve_question(&case.model, &question, options);
        whole.settle(whole.read(solved.map_err(|failure| whole.failed(near.phase, failure))?, near.phase)?, options)
    };
    let first = match from(&near) {
        Ok(found) if found.is_sound()? => return Ok(found),
        Err(error) if error.is_bad_input() || error.is_cancelled() => return Err(error),
        other => other,
    };
    // A start may lead nowhere, or to a belt that slips or is pushed, because the drive is not where it was taken to
    // be.
    let mut best = first;
    for other in elsewhere(case, whole.actuation, whole.engine, secondary_speed, direction) {
        match from(&other) {
            Ok(found) if found.is_sound()? => return Ok(found),
            Ok(found) => {
                if best.as_ref().map_or(Ok(true), |best| loses_less(&found, best))? {
                    best = Ok(found);
                }
            }
            Err(error) if error.is_cancelled() => return Err(error),
            Err(other) => best = best.map_err(|error| error.or_explained(other)),
        }
    }
    best
}

/// Whether a belt loses clearly less of the speed than another one.
fn loses_less(found: &Equilibrium, other: &Equilibrium) -> Result<bool, EquilibriumError> {
    Ok(found.output(Output::EfficiencySpeed)? > other.output(Output::EfficiencySpeed)? + JUMP)
}

/// As [`equilibrium`], from that of a case nearby: other parts, or another speed. Where that leads nowhere, as it may
/// across a stop, from nothing; so too where it leads to a belt that slips, and slips more than it did, or to one that
/// is pushed and was not: the better of both is told.
///
/// # Errors
/// See [`EquilibriumError`].
pub fn equilibrium_from(
    near: &Equilibrium,
    case: &Resolved,
    secondary_speed: f64,
    direction: Direction,
    options: &SolveOptions,
) -> Result<Equilibrium, EquilibriumError> {
    let whole = Whole::new(case, Given::SecondarySpeed(secondary_speed), direction)?;
    let unsound = match whole.settle_from(&near.solved, near.phase, options) {
        Ok(found) if found.is_sound()? => return Ok(found),
        Ok(found) if (found.is_taut() || !near.is_taut()) && (found.holds()? || !loses_less(near, &found)?) => {
            return Ok(found);
        }
        Ok(found) => found,
        Err(error) if error.is_bad_input() || error.is_cancelled() => return Err(error),
        // What became of the state nearby says more than what starts that were guessed came to.
        Err(error) => {
            return at_speed(case, secondary_speed, direction, options).map_err(|other| match other {
                EquilibriumError::Failure { .. } => error.or_explained(other),
                other => other,
            });
        }
    };
    match at_speed(case, secondary_speed, direction, options) {
        Ok(found) if found.is_sound()? || loses_less(&found, &unsound)? => Ok(found),
        Err(error) if error.is_cancelled() => Err(error),
        Ok(_) | Err(_) => Ok(unsound),
    }
}

/// The equilibrium of a drive whose primary would be open if the belt did not slip: the engine runs away from the
/// secondary until it closes the primary on the belt, which slips as a clutch does. It is sought from a faster
/// secondary, at which the primary is closed, by steps; where those lead nowhere, the primary is told to be `open`.
fn engaging(
    whole: &Whole<'_>,
    secondary_speed: f64,
    open: EquilibriumError,
    options: &SolveOptions,
) -> Result<Equilibrium, EquilibriumError> {
    let speeds: Vec<f64> = (1..=CLUTCH_STEPS).map(|step| secondary_speed / CLUTCH_STEP.powi(step)).collect();
    let closed = speeds.iter().position(|speed| {
        let faster = whole.at(*speed);
        faster.in_reach(&faster.rough()).is_ok()
    });
    let Some((slower, &[closed, ..])) = closed.and_then(|closed| speeds.split_at_checked(closed)) else {
        return Err(open);
    };
    let speeds = slower.iter().rev().chain([&secondary_speed]).copied();
    let found =
        at_speed(whole.case, closed, whole.direction, options).and_then(|near| whole.along(near, speeds, options));
    found.map_err(|error| if error.is_cancelled() { error } else { open })
}
