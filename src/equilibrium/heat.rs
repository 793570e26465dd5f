//! The temperature of the belt in the equilibrium of a drive.

use super::error::EquilibriumError;
use super::phase::Direction;
use super::point::Equilibrium;
use super::question::{Given, Whole};
use super::search::{at_speed, equilibrium, equilibrium_from};
use crate::case::Resolved;
use crate::clock::Stopwatch;
use crate::drive::{Failure, SolveOptions};
use crate::losses::{at_temperature, into_belt};
use crate::result::{BeltTemperature, Outcome, read_at};

/// Temperatures that are tried at most, and by how much two of them may differ in the end, K.
const TRIED: usize = 30;
const SETTLED: f64 = 1e-3;
/// Largest step between two of them, K.
const LARGEST_STEP: f64 = 50.0;

/// The equilibrium with the belt as warm as its losses make it, and what the belt does there; without heat in the case,
/// with the stiffnesses that are given. From the equilibrium of a drive nearby, or from nothing.
///
/// # Errors
/// See [`EquilibriumError`].
pub fn equilibrium_outcome(
    near: Option<&Equilibrium>,
    case: &Resolved,
    secondary_speed: f64,
    direction: Direction,
    options: &SolveOptions,
) -> Result<(Equilibrium, Outcome), EquilibriumError> {
    outcome_from(near, equilibrium, case, secondary_speed, direction, options)
}

/// As [`equilibrium_outcome`] from nothing, by starts at the speed itself alone.
pub(super) fn outcome_at_speed(
    case: &Resolved,
    secondary_speed: f64,
    direction: Direction,
    options: &SolveOptions,
) -> Result<(Equilibrium, Outcome), EquilibriumError> {
    outcome_from(None, at_speed, case, secondary_speed, direction, options)
}

/// Of an equilibrium nearby, or of what a search `from_nothing` finds.
fn outcome_from(
    near: Option<&Equilibrium>,
    from_nothing: fn(&Resolved, f64, Direction, &SolveOptions) -> Result<Equilibrium, EquilibriumError>,
    case: &Resolved,
    secondary_speed: f64,
    direction: Direction,
    options: &SolveOptions,
) -> Result<(Equilibrium, Outcome), EquilibriumError> {
    settled(near, case, options, &|near, case| match near {
        Some(near) => equilibrium_from(near, case, secondary_speed, direction, options),
        None => from_nothing(case, secondary_speed, direction, options),
    })
}

/// The equilibrium at an end of a phase with the belt as warm as its losses make it there, from one of the same drive.
pub(super) fn warm_corner(
    from: &Equilibrium,
    case: &Resolved,
    given: Given,
    direction: Direction,
    options: &SolveOptions,
) -> Result<Equilibrium, EquilibriumError> {
    if case.thermal.is_none() {
        return Whole::new(case, given, direction)?.corner(from, options);
    }
    let solve = |near: Option<&Equilibrium>, case: &Resolved| {
        Whole::new(case, given, direction)?.corner(near.unwrap_or(from), options)
    };
    settled(Some(from), case, options, &solve).map(|(found, _)| found)
}

/// What finds an equilibrium of a drive whose belt has the stiffnesses that are given, from one nearby or from nothing.
type SolveAt<'a> = dyn Fn(Option<&Equilibrium>, &Resolved) -> Result<Equilibrium, EquilibriumError> + 'a;

/// What `solve` finds with the belt as warm as its losses make it.
fn settled(
    near: Option<&Equilibrium>,
    case: &Resolved,
    options: &SolveOptions,
    solve: &SolveAt<'_>,
) -> Result<(Equilibrium, Outcome), EquilibriumError> {
    let start = Stopwatch::start();
    let Some(thermal) = case.thermal else {
        let found = solve(near, case)?;
        let outcome = read(&found, case, BeltTemperature::Reference, options, start)?;
        return Ok((found, outcome));
    };
    let mut temperature = thermal.reference;
    let mut before: Option<(f64, f64)> = None;
    let mut here = solve(near, &at_temperature(case, &thermal, temperature))?;
    for _ in 0..TRIED {
        let warm = at_temperature(case, &thermal, temperature);
        let heat = into_belt(&warm, &thermal, &here.solved, temperature, options.tolerance)?;
        let missing = thermal.ambient + heat / thermal.heat_transfer - temperature;
        if missing.abs() <= SETTLED {
            let outcome = read(&here, &warm, BeltTemperature::Held(temperature), options, start)?;
            return Ok((here, outcome));
        }
        // The secant of "balanced less temperature"; at first as if the heat did not depend on the temperature.
        let step = match before {
            Some((other, missed)) if missed != missing => -missing * (temperature - other) / (missing - missed),
            _ => missing,
        };
        before = Some((temperature, missing));
        temperature += if step.is_finite() { step.clamp(-LARGEST_STEP, LARGEST_STEP) } else { missing };
        here = solve(Some(&here), &at_temperature(case, &thermal, temperature))?;
    }
    let failure = Box::new(Failure::Temperature { temperature });
    Err(EquilibriumError::Failure { phase: here.phase, failure, sharp: false })
}

/// What the belt does in an equilibrium.
fn read(
    found: &Equilibrium,
    case: &Resolved,
    warmth: BeltTemperature,
    options: &SolveOptions,
    start: Stopwatch,
) -> Result<Outcome, EquilibriumError> {
    let mut posed = found.operating_case(case);
    // The temperature is that of the whole drive, not that of a belt at these radii and torque.
    posed.thermal = None;
    read_at(&posed, options, (found.solved.clone(), warmth), start).map_err(|failure| EquilibriumError::Failure {
        phase: found.phase,
        failure: Box::new(failure),
        sharp: false,
    })
}
