//! What is known of the simple drive once v_0 is.

use super::{ClosedForms, Derived, Given, SimpleDrive};
use serde::Serialize;
use std::fmt;

/// One of the two pulleys.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum PulleyId {
    /// The input, where the drive is driven; the primary of a case.
    Input,
    /// The output; the secondary of a case.
    Output,
}

impl fmt::Display for PulleyId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Input => "input",
            Self::Output => "output",
        })
    }
}

/// How a state was found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// In closed form: no torque is transmitted.
    Closed,
    /// By Newton's method.
    Newton {
        /// Steps taken.
        iterations: usize,
    },
}

/// A state of the simple drive, SI: rad/s, N·m, N, m/s, rad. Torques are those of the belt on the pulleys.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InitialState {
    /// ω_I.
    pub input_speed: f64,
    /// ω_O.
    pub output_speed: f64,
    /// M_I, negative where the input drives.
    pub input_torque: f64,
    /// M_O, positive where the input drives.
    pub output_torque: f64,
    /// F_CI.
    pub input_axial_force: f64,
    /// F_CO.
    pub output_axial_force: f64,
    /// v_0, the speed of the unstretched belt.
    pub belt_speed: f64,
    /// Φ_I = Φ_O, the angle on which the belt slides before it leaves a pulley.
    pub sliding_angle: f64,
    /// K, the longitudinal force at which the belt would lift off.
    pub lift_off_force: f64,
    /// L_Oin, the longitudinal force in the span from the input to the output.
    pub slack_force: f64,
    /// L_Iin, the longitudinal force in the span from the output to the input.
    pub tight_force: f64,
    /// Tractive tension in the span from the input to the output: the force less the momentum flow.
    pub slack_tension: f64,
    /// Tractive tension in the span from the output to the input.
    pub tight_tension: f64,
    /// How it was found.
    pub method: Method,
}

/// Why there is no state.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InitError {
    /// A value out of its range.
    #[error("`{what}` = {given} {unit}: expected {expected}")]
    Given {
        /// Which.
        what: &'static str,
        /// Its value.
        given: f64,
        /// Its SI unit.
        unit: &'static str,
        /// What it should be.
        expected: &'static str,
    },
    /// The operating point is none of the seven situations.
    #[error(
        "this operating point is none of the seven situations: expected `operating_point.primary_axial_force` or \
         `secondary_axial_force`, beside `primary_speed` with one of `primary_torque`, `secondary_torque`, \
         `secondary_speed`, `speed_ratio`, or beside `secondary_speed` with `primary_torque` and `primary_axial_force`"
    )]
    NoSituation,
    /// A radius is to be solved for.
    #[error("`drive.free`: the simple drive needs both radii: expected both of them or their ratio")]
    FreeRadius,
    /// The axial force is too small for the torque: the whole contact of a pulley slides.
    #[error(
        "the belt slides on all of the {pulley} pulley: its axial force {axial_force:.4} N is below the {smallest:.4} \
         N that a torque of {torque:.4} N·m takes there"
    )]
    GrossSlip {
        /// Which pulley.
        pulley: PulleyId,
        /// Its axial force, N.
        axial_force: f64,
        /// The smallest that carries the torque, N.
        smallest: f64,
        /// The torque on it, N·m.
        torque: f64,
    },
    /// The other pulley's contact is too short for the torque.
    #[error(
        "the belt slides on all of the {pulley} pulley: the torque takes a sliding angle of {:.2} deg, and the \
         contact is {:.2} deg long",
        sliding.to_degrees(),
        contact.to_degrees()
    )]
    ShortContact {
        /// Which pulley.
        pulley: PulleyId,
        /// Φ that the other pulley's axial force and the torque ask for, rad.
        sliding: f64,
        /// Contact angle, rad.
        contact: f64,
    },
    /// No belt speed keeps the belt tight.
    #[error("no belt speed carries a torque of {torque:.4} N·m: the belt would have to stretch to twice its length")]
    Overloaded {
        /// The torque on the output, N·m.
        torque: f64,
    },
    /// Newton's method did not end.
    #[error("Newton's method did not converge in {steps} steps")]
    NotConverged {
        /// Steps taken.
        steps: usize,
    },
}

pub(super) fn check_given(
    what: &'static str,
    unit: &'static str,
    given: f64,
    fits: impl Fn(f64) -> bool,
    expected: &'static str,
) -> Result<(), InitError> {
    if given.is_finite() && fits(given) { Ok(()) } else { Err(InitError::Given { what, given, unit, expected }) }
}

/// The whole contact of `pulley` slides.
pub(super) fn gross_slip(closed: &ClosedForms, pulley: PulleyId) -> InitError {
    let outputs = closed.outputs();
    let (force, smallest, torque) = match pulley {
        PulleyId::Output => (Given::OutputAxialForce, Derived::OutputSlipForce, Given::OutputTorque),
        PulleyId::Input => (Given::InputAxialForce, Derived::InputSlipForce, Given::InputTorque),
    };
    let (axial_force, smallest, torque) = (closed.get(force), outputs.get(smallest), closed.get(torque).abs());
    InitError::GrossSlip { pulley, axial_force, smallest, torque }
}

impl InitialState {
    /// Reads the state of a drive whose speeds, torques and v_0 are known; what was not given of the axial forces
    /// follows.
    pub(super) fn read(drive: &SimpleDrive, closed: &ClosedForms, method: Method) -> Result<Self, InitError> {
        let mut closed = closed.clone();
        let outputs = closed.outputs();
        for (given, computed) in [
            (Given::OutputAxialForce, Derived::OutputForceFromSpeeds),
            (Given::InputAxialForce, Derived::InputForceFromSpeeds),
        ] {
            if closed.get(given).is_nan() {
                closed.set(given, outputs.get(computed));
            }
        }
        // Zero but for rounding without a torque, or with a tiny one.
        let sliding_angle =
            if method == Method::Closed { 0.0 } else { outputs.get(Derived::OutputSlidingAngle).max(0.0) };
        for pulley in [PulleyId::Output, PulleyId::Input] {
            let contact = drive.contact_angle(pulley);
            if sliding_angle > contact {
                return Err(InitError::ShortContact { pulley, sliding: sliding_angle, contact });
            }
        }
        Ok(Self {
            input_speed: closed.get(Given::InputSpeed),
            output_speed: closed.get(Given::OutputSpeed),
            input_torque: closed.get(Given::InputTorque),
            output_torque: closed.get(Given::OutputTorque),
            input_axial_force: closed.get(Given::InputAxialForce),
            output_axial_force: closed.get(Given::OutputAxialForce),
            belt_speed: closed.get(Given::BeltSpeed),
            sliding_angle,
            lift_off_force: outputs.get(Derived::LiftOffForce),
            slack_force: outputs.get(Derived::SlackForce),
            tight_force: outputs.get(Derived::TightForce),
            slack_tension: outputs.get(Derived::SlackTension),
            tight_tension: outputs.get(Derived::TightTension),
            method,
        })
    }
}
