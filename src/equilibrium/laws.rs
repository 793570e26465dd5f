//! The laws that close a drive: engine and actuators as boundary equations.

use crate::actuator::{PrimaryActuator, SecondaryActuator, Shift, travel, travel_by_radius};
use crate::drive::{Argument, Constant, Law, Output};
use crate::powertrain::Engine;

/// M_in = engine(ω_P).
#[derive(Debug, Clone)]
pub struct EngineLaw {
    /// The engine.
    pub engine: Engine,
}

impl Law for EngineLaw {
    fn name(&self) -> &'static str {
        "torque of the belt less that of the engine"
    }

    fn arguments(&self) -> &[Argument] {
        &[Argument::Constant(Constant::PrimaryTorque), Argument::Constant(Constant::PrimarySpeed)]
    }

    fn scale(&self) -> f64 {
        self.engine.torque.values().iter().fold(0.0, |largest, value| value.abs().max(largest))
    }

    fn residual(&self, at: &[f64], partials: &mut [f64]) -> f64 {
        let ([torque, speed], [by_torque, by_speed]) = (at, partials) else { return f64::NAN };
        let engine = self.engine.torque(*speed);
        (*by_torque, *by_speed) = (1.0, -engine.by_speed);
        torque - engine.value
    }
}

/// A_P = F_P(ω_P, s_P), with the travel s_P = 2 tan β (R_P − R_P0).
#[derive(Debug, Clone)]
pub struct PrimaryLaw {
    /// What presses.
    pub actuator: PrimaryActuator,
    /// Which way its sheave moves.
    pub shift: Shift,
    /// R_P0, m.
    pub start_radius: f64,
    /// A typical force, N.
    pub scale: f64,
}

impl Law for PrimaryLaw {
    fn name(&self) -> &'static str {
        "axial force of the belt on the primary less that of its actuator"
    }

    fn arguments(&self) -> &[Argument] {
        &[
            Argument::Output(Output::PrimaryAxialForce),
            Argument::Constant(Constant::PrimarySpeed),
            Argument::Constant(Constant::PrimaryRadius),
            Argument::Constant(Constant::HalfAngle),
        ]
    }

    fn scale(&self) -> f64 {
        self.scale
    }

    fn residual(&self, at: &[f64], partials: &mut [f64]) -> f64 {
        let [axial, speed, radius, half_angle] = *at else { return f64::NAN };
        let [by_axial, by_speed, by_radius, by_angle] = partials else { return f64::NAN };
        let at = travel(half_angle, self.start_radius, radius);
        let Ok(Some(force)) = self.actuator.force(speed, at, self.shift) else { return f64::NAN };
        *by_axial = 1.0;
        *by_speed = -force.by_drive;
        *by_radius = -force.by_travel * travel_by_radius(half_angle);
        *by_angle = -force.by_travel * travel_by_angle(half_angle, self.start_radius, radius);
        axial - force.value
    }
}

/// A_S = F_S(M_S, s_S), with the opening s_S = 2 tan β (R_S0 − R_S).
#[derive(Debug, Clone)]
pub struct SecondaryLaw {
    /// What presses.
    pub actuator: SecondaryActuator,
    /// Which way its sheave moves.
    pub shift: Shift,
    /// R_S0, m.
    pub closed_radius: f64,
    /// A typical force, N.
    pub scale: f64,
}

impl Law for SecondaryLaw {
    fn name(&self) -> &'static str {
        "axial force of the belt on the secondary less that of its actuator"
    }

    fn arguments(&self) -> &[Argument] {
        &[
            Argument::Output(Output::SecondaryAxialForce),
            Argument::Output(Output::SecondaryTorque),
            Argument::Constant(Constant::SecondaryRadius),
            Argument::Constant(Constant::HalfAngle),
        ]
    }

    fn scale(&self) -> f64 {
        self.scale
    }

    fn residual(&self, at: &[f64], partials: &mut [f64]) -> f64 {
        let [axial, torque, radius, half_angle] = *at else { return f64::NAN };
        let [by_axial, by_torque, by_radius, by_angle] = partials else { return f64::NAN };
        let opening = travel(half_angle, radius, self.closed_radius);
        let Ok(force) = self.actuator.force(torque, opening, self.shift) else { return f64::NAN };
        *by_axial = 1.0;
        *by_torque = -force.by_drive;
        *by_radius = force.by_travel * travel_by_radius(half_angle);
        *by_angle = -force.by_travel * travel_by_angle(half_angle, radius, self.closed_radius);
        axial - force.value
    }
}

/// Derivative of the travel 2 tan β (R − R_0) with respect to β.
fn travel_by_angle(half_angle: f64, start: f64, radius: f64) -> f64 {
    2.0 * (radius - start) / libm::cos(half_angle).powi(2)
}
