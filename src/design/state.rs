//! A solved drive in a few numbers.

use serde::{Deserialize, Serialize};

use crate::drive::Solved;
use crate::model::{InternalError, Output};

/// Where a drive stands: torque, clamp, speeds and efficiency. SI, ratios as fractions.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct DriveState {
    /// Torque into the primary, N·m.
    pub primary_torque: f64,
    /// Torque out of the secondary, N·m.
    pub secondary_torque: f64,
    /// Tractive tension at the exit of the primary, N.
    pub slack_tension: f64,
    /// Tractive tension at the entry of the primary, N.
    pub tight_tension: f64,
    /// Axial force on the primary, N.
    pub primary_axial_force: f64,
    /// Axial force on the secondary, N.
    pub secondary_axial_force: f64,
    /// ω_S/ω_P.
    pub speed_ratio: f64,
    /// ω_S R_S/(ω_P R_P) (6.7); in engine braking, with negative torque, its reciprocal: of the driven pulley over the
    /// driving one.
    pub speed_efficiency: f64,
    /// Power out over power in (6.9); in engine braking its reciprocal.
    pub overall_efficiency: f64,
}

impl DriveState {
    /// Of a solution.
    ///
    /// # Errors
    /// None, unless this program is broken.
    pub fn of(solved: &Solved) -> Result<Self, InternalError> {
        let outputs = solved.belt.output_values(&solved.solution)?;
        let value = |output| outputs.get(output);
        let torque = value(Output::PrimaryTorque)?;
        let driven = |efficiency: f64| if torque < 0.0 { 1.0 / efficiency } else { efficiency };
        Ok(Self {
            primary_torque: torque,
            secondary_torque: value(Output::SecondaryTorque)?,
            slack_tension: value(Output::PrimaryExitTension)?,
            tight_tension: value(Output::PrimaryEntryTension)?,
            primary_axial_force: value(Output::PrimaryAxialForce)?,
            secondary_axial_force: value(Output::SecondaryAxialForce)?,
            speed_ratio: value(Output::SecondarySpeed)? / value(Output::PrimarySpeed)?,
            speed_efficiency: driven(value(Output::EfficiencySpeed)?),
            overall_efficiency: driven(value(Output::EfficiencyOverall)?),
        })
    }
}
