//! What each part does to the shift speed, exactly: from the linearisation of the one problem at its solution.
//!
//! Where a part changes by dp, its law changes by ∂law/∂p dp, which is the same as a target that moves by the
//! opposite; how everything else follows a target is one column of the condensed linearisation. Where the belt is as
//! warm as its losses make it, its temperature follows too, and its stiffnesses with that.

use serde::Serialize;
use solver::{Condensation, Problem};

use super::error::EquilibriumError;
use super::phase::{Phase, Stop};
use super::point::Equilibrium;
use crate::actuator::{AngleFrom, Mechanism, PrimaryActuator, SecondaryActuator, Spring};
use crate::case::{Key, Resolved};
use crate::drive::{Constant, Failure, Output};
use crate::losses::warming;
use crate::result::DriveResult;

/// What one part does.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct PartSensitivity {
    /// Its key in the case file.
    #[serde(serialize_with = "as_path")]
    #[cfg_attr(feature = "schema", schemars(with = "String"))]
    pub key: Key,
    /// Derivative of the primary's speed at the same speed of the secondary, rad/s over the key's SI unit.
    pub primary_speed: f64,
    /// Derivative of the ratio R_S/R_P at the same speed of the secondary, over the key's SI unit.
    pub ratio: f64,
    /// Derivative of the primary's speed at the same ratio, rad/s over the key's SI unit: how the shift line moves.
    /// Nothing at a stop, where the ratio does not follow the speed.
    pub shift_speed: Option<f64>,
}

fn as_path<S: serde::Serializer>(key: &Key, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(key.path())
}

/// The laws of a phase, in the order of their targets.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Law {
    Engine,
    Primary,
    Secondary,
}

const fn laws(phase: Phase) -> &'static [Law] {
    match phase {
        Phase::Shift => &[Law::Engine, Law::Primary, Law::Secondary],
        Phase::Low | Phase::High(Stop::SecondaryOpen | Stop::SecondaryClosed) => &[Law::Engine, Law::Primary],
        Phase::High(Stop::PrimaryClosed) | Phase::Held => &[Law::Engine, Law::Secondary],
    }
}

/// Rates of speed and ratio along one given constant of the solution.
struct Rates {
    speed: f64,
    ratio: f64,
}

/// What each part of a drive does to its equilibrium, where `belt` is what the belt does in it.
///
/// # Errors
/// [`EquilibriumError::Failure`] where the equations are singular, as at a limit.
pub fn sensitivities(
    case: &Resolved,
    at: &Equilibrium,
    belt: &DriveResult<Resolved>,
) -> Result<Vec<PartSensitivity>, EquilibriumError> {
    let solved = &at.solved;
    let failed = |failure| EquilibriumError::Failure { phase: at.phase, failure: Box::new(failure), sharp: false };
    let condensation = Condensation::new(&solved.belt, &solved.solution);
    let condensation = condensation.map_err(|error| failed(Failure::Sensitivities(error)))?;
    let warm = case.thermal.zip(belt.belt.temperature);
    let warming = warm.map(|(thermal, kelvin)| warming(case, &thermal, solved, kelvin, belt.solver.tolerance));
    let warming = warming.transpose().map_err(failed)?;
    let layout = solved.belt.layout();
    let first = layout.ends() + layout.integrals();
    let (primary, secondary) = (solved.constant(Constant::PrimaryRadius), solved.constant(Constant::SecondaryRadius));
    let as_warm = |constant: usize| {
        let rates = condensation.rates(constant)?;
        let rate = |of: Constant| rates.get(first + of.index()).copied();
        let ratio = rate(Constant::SecondaryRadius)? / primary
            - secondary * rate(Constant::PrimaryRadius)? / (primary * primary);
        Some(Rates { speed: rate(Constant::PrimarySpeed)?, ratio })
    };
    // The temperature following.
    let along = |constant: usize| {
        let mut rates = as_warm(constant)?;
        if let Some(warming) = &warming {
            let by_constant = warming.by_constant.get(constant)?;
            for (stiffness, softened) in &warming.softened {
                let (stiffer, by) = (as_warm(stiffness.index())?, softened.by_temperature * by_constant);
                rates.speed += stiffer.speed * by;
                rates.ratio += stiffer.ratio * by;
            }
        }
        Some(rates)
    };
    // Targets follow the constants: first those of prescribed outputs, of which one is the secondary's speed.
    let prescribed: Vec<Output> = solved.belt.prescribed().collect();
    let targets = Constant::ALL.len() + prescribed.len();
    let by_secondary = prescribed
        .iter()
        .position(|output| *output == Output::SecondarySpeed)
        .and_then(|at| along(Constant::ALL.len() + at));
    let mut found = Vec::new();
    for (key, law, by_part) in part_rates(case, at)? {
        let Some(place) = laws(at.phase).iter().position(|other| *other == law) else { continue };
        let Some(target) = along(targets + place) else { continue };
        let (primary_speed, ratio) = (-by_part * target.speed, -by_part * target.ratio);
        let shift_speed = by_secondary
            .as_ref()
            .filter(|_| at.phase == Phase::Shift)
            .map(|speed| primary_speed - speed.speed * ratio / speed.ratio);
        found.push(PartSensitivity { key, primary_speed, ratio, shift_speed });
    }
    Ok(found)
}

/// Derivatives of the laws with respect to each part that the case has, SI.
fn part_rates(case: &Resolved, at: &Equilibrium) -> Result<Vec<(Key, Law, f64)>, EquilibriumError> {
    let told = |error| EquilibriumError::Actuator { phase: at.phase, error };
    let mut rates = Vec::new();
    if let Some(engine) = &case.parts.engine {
        rates.push((Key::Throttle, Law::Engine, -engine.torque(at.primary_speed()).by_throttle));
    }
    let Some(actuation) = &case.parts.actuation else { return Ok(rates) };
    if let PrimaryActuator::Flyweights { flyweights, spring } = &actuation.primary {
        let shift = at.direction.primary();
        let force = flyweights.force(at.primary_speed(), at.primary_travel, shift).map_err(told)?;
        let friction = match flyweights.mechanism {
            Mechanism::Coefficient { .. } => Key::FlyweightLost,
            Mechanism::Ramp { .. } | Mechanism::RollerArm(_) | Mechanism::CamArm(_) => Key::FlyweightFriction,
        };
        rates.push((Key::FlyweightMass, Law::Primary, -force.by_mass));
        if shift.sign() != 0.0 {
            rates.push((friction, Law::Primary, -force.by_friction));
        }
        if let Some(spring) = spring {
            let keys = [
                Key::PrimarySpringRate,
                Key::PrimarySpringPreload,
                Key::PrimarySpringFree,
                Key::PrimarySpringInstalled,
            ];
            // The spring stands against the flyweights.
            let by = of_spring(case, spring, at.primary_travel, keys).map_err(told)?;
            rates.extend(by.into_iter().map(|(key, by)| (key, Law::Primary, by)));
        }
    }
    if let SecondaryActuator::Helix { helix, spring } = &actuation.secondary {
        let shift = at.direction.secondary();
        let torque = at.output(Output::SecondaryTorque)?;
        let force = helix.force(torque, at.secondary_travel, shift).map_err(told)?;
        let sign = match actuation.angle_from {
            AngleFrom::Rotation => 1.0,
            AngleFrom::Axis => -1.0,
        };
        let angle = if case.parts.has(Key::HelixAngles) { Key::HelixAngles } else { Key::HelixAngle };
        rates.push((angle, Law::Secondary, -sign * force.by_angle));
        if helix.torsion_rate > 0.0 {
            rates.push((Key::TorsionRate, Law::Secondary, -force.by_torsion_rate));
            rates.push((Key::Pretension, Law::Secondary, -force.by_pretension));
        }
        rates.push((Key::TorqueShare, Law::Secondary, -force.by_share));
        if shift.sign() != 0.0 {
            rates.push((Key::HelixFriction, Law::Secondary, -force.by_friction));
        }
        if let Some(spring) = spring {
            let keys = [
                Key::SecondarySpringRate,
                Key::SecondarySpringPreload,
                Key::SecondarySpringFree,
                Key::SecondarySpringInstalled,
            ];
            let by = of_spring(case, spring, at.secondary_travel, keys).map_err(told)?;
            rates.extend(by.into_iter().map(|(key, by)| (key, Law::Secondary, -by)));
        }
    }
    Ok(rates)
}

/// Derivatives of a spring's force with respect to the keys that give it: with a free length, a stiffer spring is also
/// preloaded more.
fn of_spring(
    case: &Resolved,
    spring: &Spring,
    travel: f64,
    keys: [Key; 4],
) -> Result<Vec<(Key, f64)>, crate::actuator::ActuatorError> {
    let [rate, preload, free, installed] = keys;
    let force = spring.force(travel)?;
    if !case.parts.has(free) {
        return Ok(vec![(rate, force.by_rate), (preload, force.by_preload)]);
    }
    let squeezed = spring.preload / spring.rate;
    Ok(vec![
        (rate, force.by_rate + squeezed * force.by_preload),
        (free, spring.rate * force.by_preload),
        (installed, -spring.rate * force.by_preload),
    ])
}
