//! The belt pulley of [`small::pulley`](crate::small::pulley), a component, beside the full model: what Euler's
//! relation makes of the tensions that the full model finds.

use super::{Outcome, Pulley};
use crate::formula::Inputs;
use crate::model::{Constant, Constants, InternalError};
use crate::small::pulley::{BeltPulley, BeltType, Branch, Direction, Ports, Shaft};
use generated::{BELT_PULLEY_LIMITS, BeltPulleyLimit, BeltPulleyLimitInput};
use serde::Serialize;

/// Force below which the component counts a branch as slack, N: far below any tension of a drive.
const FORCE_THRESHOLD: f64 = 1e-3;

/// Both pulleys of a drive.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Comparison {
    /// The driving pulley.
    pub primary: PulleyComparison,
    /// The driven pulley.
    pub secondary: PulleyComparison,
}

/// One pulley of the full model, and the same as a component.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct PulleyComparison {
    /// Tractive tension of the tight span in the full model, N.
    pub tight_tension: f64,
    /// Tractive tension of the slack span in the full model, N.
    pub slack_tension: f64,
    /// Their ratio in the full model.
    pub tension_ratio: f64,
    /// Wrap angle in the full model, rad; the component's, too.
    pub wrap_angle: f64,
    /// f or f', the component's coefficient of friction; `None` for an ideal belt.
    pub effective_coefficient: Option<f64>,
    /// e^(f θ), the largest ratio of the component; `None` for an ideal belt.
    pub largest_ratio: Option<f64>,
    /// ln(ratio)/(f θ), the share of the component's friction that the full model's tensions take; 0 for an ideal belt.
    pub share: f64,
    /// Size of V_rel at which the component carries the full model's tensions, m/s; `None` where its friction does not
    /// suffice at any speed.
    pub sliding_speed: Option<f64>,
    /// Smallest sliding speed in the full model, m/s.
    pub full_min_sliding_speed: f64,
    /// Largest sliding speed in the full model, m/s.
    pub full_max_sliding_speed: f64,
    /// The component's torque at the full model's tensions, N·m; into the primary, out of the secondary.
    pub torque: f64,
    /// Torque of the full model, N·m.
    pub full_torque: f64,
    /// Power that the component loses to friction, W; `None` as the sliding speed.
    pub friction_loss: Option<f64>,
    /// Power that the full model loses to friction on this pulley, W.
    pub full_friction_loss: f64,
}

/// What grips in the component.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Grip {
    /// No slip.
    Ideal,
    /// The sheave's coefficient of friction on the circumference.
    Flat,
    /// The sheave's coefficient of friction on both faces of its groove.
    V,
}

impl Grip {
    fn belt(self, outcome: &Outcome) -> BeltType {
        let sheave = &outcome.result.inputs.sheave;
        let friction_coefficient = sheave.friction_coefficient;
        match self {
            Self::Ideal => BeltType::Ideal,
            Self::Flat => BeltType::Flat { friction_coefficient },
            Self::V => BeltType::V { friction_coefficient, sheave_angle: 2.0 * sheave.half_angle },
        }
    }
}

/// Compares both pulleys of a solved drive with the component, whose friction velocity threshold is the case's: with
/// `viscous-coulomb` friction the speed at which that reaches its coefficient, with `tanh` the same law.
///
/// # Errors
/// None, unless this program is broken.
pub fn compare(outcome: &Outcome, grip: Grip) -> Result<Comparison, InternalError> {
    let result = &outcome.result;
    let belt = grip.belt(outcome);
    // From the solution: a radius may have been solved for.
    let constants = Constants::try_from(outcome.solved.solution.constants())?;
    Ok(Comparison {
        primary: pulley(outcome, belt, &result.primary, constants[Constant::PrimaryRadius], 1.0),
        secondary: pulley(outcome, belt, &result.secondary, constants[Constant::SecondaryRadius], -1.0),
    })
}

/// `sign`: of the torque of a pulley that drives the belt.
fn pulley(outcome: &Outcome, belt: BeltType, full: &Pulley, radius: f64, sign: f64) -> PulleyComparison {
    let inputs = &outcome.result.inputs;
    let component = BeltPulley {
        belt,
        direction: Direction::Opposite,
        radius,
        wrap_angle: full.wrap_angle,
        mass_per_length: inputs.belt.mass_per_length,
        inertia: 0.0,
        bearing_damping: 0.0,
        velocity_threshold: inputs.sheave.slip_threshold,
        force_threshold: FORCE_THRESHOLD,
    };
    let ideal = belt == BeltType::Ideal;
    let coefficient = component.effective_coefficient();
    // In engine braking it is the secondary that drives.
    let driving = full.entry_tension >= full.exit_tension;
    let (tight_tension, slack_tension) = match driving {
        true => (full.entry_tension, full.exit_tension),
        false => (full.exit_tension, full.entry_tension),
    };
    let limits = Inputs::new(&BELT_PULLEY_LIMITS).with(&[
        (BeltPulleyLimitInput::FrictionCoefficient, coefficient),
        (BeltPulleyLimitInput::WrapAngle, full.wrap_angle),
        (BeltPulleyLimitInput::TightTension, tight_tension),
        (BeltPulleyLimitInput::SlackTension, slack_tension),
        (BeltPulleyLimitInput::VelocityThreshold, component.velocity_threshold),
    ]);
    let outputs = limits.outputs();
    let share = outputs.get(BeltPulleyLimit::Share);
    let creep = (share < 1.0).then(|| outputs.get(BeltPulleyLimit::Creep));
    // Branch A is where the belt enters; on the driving pulley the belt is slower than the rim.
    let ports = ports(&component, full, creep.unwrap_or(0.0) * if driving { -1.0 } else { 1.0 });
    let behaviour = component.behaviour(&ports);
    let torque = -component.residuals(&ports)[2];
    PulleyComparison {
        tight_tension,
        slack_tension,
        tension_ratio: outputs.get(BeltPulleyLimit::TensionRatio),
        wrap_angle: full.wrap_angle,
        effective_coefficient: (!ideal).then_some(coefficient),
        largest_ratio: (!ideal).then(|| outputs.get(BeltPulleyLimit::LargestRatio)),
        share,
        sliding_speed: creep,
        full_min_sliding_speed: full.min_sliding_speed,
        full_max_sliding_speed: full.max_sliding_speed,
        torque: if driving { sign * torque.abs() } else { -sign * torque.abs() },
        full_torque: full.torque,
        friction_loss: creep.map(|_| behaviour.friction_loss),
        full_friction_loss: full.friction_loss,
    }
}

/// The component's ports at the full model's tensions and speed, the belt sliding at `slip` m/s, without a torque.
fn ports(component: &BeltPulley, full: &Pulley, slip: f64) -> Ports {
    let velocity = full.speed * component.radius + slip;
    let resting = Branch { velocity, tension: 0.0 };
    let shaft = Shaft { speed: full.speed, acceleration: 0.0, torque: 0.0 };
    let bare = Ports { a: Branch { velocity: -velocity, ..resting }, b: resting, s: shaft };
    let lift_off = component.behaviour(&bare).centrifugal_tension;
    Ports {
        a: Branch { velocity: -velocity, tension: full.entry_tension + lift_off },
        b: Branch { velocity, tension: full.exit_tension + lift_off },
        s: shaft,
    }
}
