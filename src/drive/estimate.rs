//! What an operating point does not give, estimated: where the search for it starts.

use std::f64::consts::PI;

use crate::case::{Clamp, Load, Resolved, Speed};
use crate::model::{Constant, Constants};
use crate::small::init::{self, SimpleDrive, Situation};

/// Axial force of the full belt over that of the simple drive at the same tensions, primary and secondary: the one
/// sinks into its groove and friction holds part of it up, the other does not.
const FRICTION_SHARES: (f64, f64) = (0.35, 0.5);
/// Smallest v_0/(R_P ω_P) with which a straight belt is started: one that is stretched more does not start at its
/// tension.
const LEAST_FLOW: f64 = 0.98;
/// Share of the axial force of a frictionless wedge, Φ T/(2 tan β), that a belt exerts which friction holds up.
const AXIAL_SHARE: f64 = 0.5;
/// Overall efficiency, to guess a torque from the other.
pub(super) const EFFICIENCY: f64 = 0.95;
/// Slack tension of a start over M_in/R_P: at least this, for a looser belt may slip.
const LEAST_TENSION: f64 = 0.35;
/// M_in over R_P and slack tension, when nothing says how large the torque is.
const TORQUE: f64 = 1.5;

/// What the operating point does not give, near what it prescribes: in one of the seven situations as the simple drive
/// has it, where that has a state; else by rules of thumb.
pub(super) fn estimate(constants: &mut Constants, case: &Resolved) {
    by_rules(constants, case);
    by_simple_drive(constants, case);
}

/// Speeds, belt speed and slack tension of the simple drive, as far as they are the better estimates.
fn by_simple_drive(constants: &mut Constants, case: &Resolved) -> Option<()> {
    let mut simple = case.clone();
    let (primary, secondary) = FRICTION_SHARES;
    simple.operating_point.clamp = match case.operating_point.clamp {
        Clamp::PrimaryAxialForce(force) => Clamp::PrimaryAxialForce(force / primary),
        Clamp::SecondaryAxialForce(force) => Clamp::SecondaryAxialForce(force / secondary),
        Clamp::SlackTension(_) | Clamp::TightTension(_) => return None,
    };
    let situation = Situation::of_case(&simple, false).ok()?;
    let state = init::solve(&SimpleDrive::of_case(&simple), situation).ok()?;
    constants[Constant::PrimarySpeed] = state.input_speed;
    let flow = state.belt_speed / (constants[Constant::PrimaryRadius] * state.input_speed);
    if flow > LEAST_FLOW {
        constants[Constant::SpeedRatio] = state.output_speed / state.input_speed;
        constants[Constant::Flow] = flow;
    }
    // For two speeds its torque is several times too large, as the full belt loses most of its speed by sinking into
    // the groove; for the other torque, the rule counts losses that it does not have.
    if !matches!(situation, Situation::Three { .. } | Situation::Four { .. }) {
        let least = LEAST_TENSION * constants[Constant::PrimaryTorque] / constants[Constant::PrimaryRadius];
        constants[Constant::SlackTension] = state.slack_tension.max(least);
    }
    Some(())
}

/// Speed, torque and slack tension of the operating point: as given, or near what is prescribed in their place.
fn by_rules(constants: &mut Constants, case: &Resolved) {
    let point = &case.operating_point;
    let (primary, secondary) = (constants[Constant::PrimaryRadius], constants[Constant::SecondaryRadius]);
    constants[Constant::PrimarySpeed] = match (point.speed, point.load) {
        (Speed::Primary(speed), _) => speed,
        (Speed::Secondary(speed), Load::SpeedRatio(ratio)) => speed / ratio,
        (Speed::Secondary(speed), _) => speed * secondary / primary,
    };
    let torque = match point.load {
        Load::PrimaryTorque(torque) => Some(torque),
        Load::SecondaryTorque(torque) => Some(torque * primary / secondary / EFFICIENCY),
        Load::SecondarySpeed(_) | Load::SpeedRatio(_) => None,
    };
    let tension = tension(point.clamp, torque, primary, case.sheave.half_angle);
    constants[Constant::SlackTension] = tension;
    constants[Constant::PrimaryTorque] = torque.unwrap_or(TORQUE * tension * primary);
}

/// Slack tension near which the clamp has its value.
fn tension(clamp: Clamp, torque: Option<f64>, radius: f64, half_angle: f64) -> f64 {
    // Half the difference of tensions that the torque makes, over the mean tension if there is no torque to go by.
    let mean_of = |force: f64| 2.0 * libm::tan(half_angle) * force / (AXIAL_SHARE * PI);
    let below = |mean: f64| torque.map_or(mean / (1.0 + 0.5 * TORQUE), |torque| mean - 0.5 * torque / radius);
    let least = torque.map_or(0.0, |torque| LEAST_TENSION * torque / radius);
    match clamp {
        Clamp::SlackTension(tension) => tension,
        Clamp::TightTension(tension) => {
            torque.map_or(tension / (1.0 + TORQUE), |torque| tension - torque / radius).max(least)
        }
        Clamp::PrimaryAxialForce(force) | Clamp::SecondaryAxialForce(force) => below(mean_of(force)).max(least),
    }
}
