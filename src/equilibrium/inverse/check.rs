//! The drive with the profiles in it, solved forward.

use serde::Serialize;

use super::InverseOptions;
use super::error::InverseError;
use super::points::InversePoint;
use crate::actuator::Profile;
use crate::case::Case;
use crate::equilibrium::{Direction, Equilibrium, EquilibriumError, Phase, equilibrium, equilibrium_from};
use crate::model::Constant;
use crate::result::slip_reserve;

/// One place, SI.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CheckPoint {
    /// Speed of the secondary.
    pub secondary_speed: f64,
    /// Speed of the primary, found.
    pub primary_speed: f64,
    /// R_S/R_P, found.
    pub ratio: f64,
    /// Share of the friction at hand that is left over.
    pub slip_reserve: f64,
}

/// How well the profiles hold the engine at the target, by full solutions of the drive between the places at which they
/// were made; rad/s.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Check {
    /// Largest difference of the engine's speed from the target.
    pub largest_deviation: f64,
    /// Root of the mean square of the differences.
    pub rms_deviation: f64,
    /// The places.
    pub points: Vec<CheckPoint>,
}

/// Solves the drive at places between those of the profile.
pub(super) fn check(case: &Case, made: &[InversePoint], options: &InverseOptions) -> Result<Check, InverseError> {
    // Parts that lock, that the roller leaves, that a spring does not allow are refused here.
    let mut resolved = case.resolve()?;
    resolved.thermal = None;
    let travels = made.iter().map(|point| point.primary_travel).collect();
    let speeds = made.iter().map(|point| point.secondary_speed).collect();
    let speeds = Profile::new(travels, speeds).map_err(|error| InverseError::Actuator { error: error.into() })?;
    let (from, to) = speeds.domain();
    let count = options.checked;
    // Off the points of the profile, whose number is not that of these intervals.
    let at = |i: usize| speeds.at(from + (to - from) * (i as f64 + 0.5) / count as f64).value;
    // From the middle to both ends.
    let middle = count / 2;
    let order: Vec<usize> = (middle..count).chain((0..middle).rev()).collect();
    let mut found: Vec<(usize, CheckPoint)> = Vec::new();
    let mut near: Option<Equilibrium> = None;
    let mut first = None;
    for i in order {
        if i + 1 == middle {
            near = first.clone();
        }
        let solved = solve(near.as_ref(), &resolved, at(i), options.direction, options)?;
        found.push((i, read(&solved)?));
        _ = first.get_or_insert_with(|| solved.clone());
        near = Some(solved);
    }
    found.sort_by_key(|(i, _)| *i);
    let points: Vec<CheckPoint> = found.into_iter().map(|(_, point)| point).collect();
    let misses = || points.iter().map(|point| point.primary_speed - options.target);
    let largest_deviation = misses().map(f64::abs).fold(0.0, f64::max);
    let rms_deviation = (misses().map(|miss| miss * miss).sum::<f64>() / points.len() as f64).sqrt();
    Ok(Check { largest_deviation, rms_deviation, points })
}

fn solve(
    near: Option<&Equilibrium>,
    case: &crate::case::Resolved,
    speed: f64,
    direction: Direction,
    options: &InverseOptions,
) -> Result<Equilibrium, EquilibriumError> {
    match near {
        Some(near) => equilibrium_from(near, case, speed, direction, &options.solve),
        None => equilibrium(case, speed, direction, &options.solve),
    }
}

fn read(found: &Equilibrium) -> Result<CheckPoint, InverseError> {
    debug_assert!(found.phase != Phase::Held, "a drive with flyweights holds no position");
    Ok(CheckPoint {
        secondary_speed: found.output(crate::model::Output::SecondarySpeed)?,
        primary_speed: found.primary_speed(),
        ratio: found.solved.constant(Constant::SecondaryRadius) / found.solved.constant(Constant::PrimaryRadius),
        slip_reserve: slip_reserve(&found.solved)?,
    })
}
