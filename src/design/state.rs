//! A solved drive in a few numbers.

use serde::{Deserialize, Serialize};

use crate::drive::Solved;
use crate::result::Outputs;

/// Where a drive stands: torque, clamp, speeds and efficiency. SI, ratios as fractions.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct State {
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
    /// ω_S R_S/(ω_P R_P) (6.7).
    pub speed_efficiency: f64,
    /// Power out over power in (6.9).
    pub overall_efficiency: f64,
}

impl State {
    /// Of a solution.
    pub fn of(solved: &Solved) -> Self {
        let outputs = Outputs::new(&solved.belt, &solved.solution);
        let value = |region: &str, key: &str| outputs.get(region, key);
        Self {
            primary_torque: value("primary", "torque"),
            secondary_torque: value("secondary", "torque"),
            slack_tension: value("primary", "exit_tension"),
            tight_tension: value("primary", "entry_tension"),
            primary_axial_force: value("primary", "axial_force"),
            secondary_axial_force: value("secondary", "axial_force"),
            speed_ratio: value("secondary", "speed") / value("primary", "speed"),
            speed_efficiency: value("efficiency", "speed"),
            overall_efficiency: value("efficiency", "overall"),
        }
    }
}
