//! The result object: what `solve --json` prints and what a row of a sweep flattens. SI units, ratios as fractions.

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

use super::sensitivity::Sensitivities;
use crate::losses::{Heat, Losses};

/// Version of the result object.
pub const SCHEMA: u32 = 1;

/// Everything a solved drive tells. Torques and powers are positive where the primary drives and the secondary
/// delivers; where the secondary drives, as in engine braking, both pulleys' are negative.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct DriveResult<I> {
    /// [`SCHEMA`].
    pub schema: u32,
    /// Name of the edition of the equations.
    pub edition: String,
    /// Whether defects and boundary residuals hold on the final mesh; always true of a result.
    pub converged: bool,
    /// The case, resolved to SI: what was asked, and beside it what was found for the keys in [`DriveResult::found`].
    pub inputs: I,
    /// What was found, SI, by key of the case file: for every key that was solved for in place of what was prescribed.
    /// Empty where nothing was.
    pub found: BTreeMap<String, f64>,
    /// The driving pulley.
    pub primary: Pulley,
    /// The driven pulley.
    pub secondary: Pulley,
    /// Span from the secondary to the primary.
    pub tight_span: Span,
    /// Span from the primary to the secondary.
    pub slack_span: Span,
    /// Efficiencies (6.7)–(6.9).
    pub efficiency: Efficiency,
    /// Share of the friction at hand that is not yet used: 1 less the larger [`Pulley::friction_utilization`]. It falls
    /// to about zero where the belt slips grossly; what torque is left above the present one, `design::largest_torque`
    /// says.
    pub slip_reserve: f64,
    /// The larger [`Pulley::friction_utilization`]: 1 less the slip reserve.
    pub friction_utilization: f64,
    /// The belt as a whole.
    pub belt: BeltResult,
    /// The energy audit.
    pub energy: Energy,
    /// Power that is lost besides friction, where it is told.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub losses: Option<Losses>,
    /// Heat, where the case says what cools the belt.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub thermal: Option<Heat>,
    /// How the solution was found.
    pub solver: SolverReport,
    /// Estimated errors of the outputs, SI, without sign, by the output's name: what the defects of the solution leave
    /// in each, to first order. Extremes along a contact or a span have none. Absent where none were asked for, as in a
    /// sweep, and where the equations are singular.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub uncertainty: Option<BTreeMap<String, f64>>,
    /// The other solution, where an axial force is prescribed that belongs to two.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub other_solution: Option<OtherSolution>,
    /// Derivatives of the outputs with respect to the given constants, if they were asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sensitivities: Option<Sensitivities>,
}

/// The other of two solutions for a prescribed axial force.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct OtherSolution {
    /// Tractive tension at the exit of the primary, N.
    pub slack_tension: f64,
    /// Share of the friction at hand that is used.
    pub friction_utilization: f64,
}

/// One pulley and its contact.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Pulley {
    /// Speed of rotation, rad/s.
    pub speed: f64,
    /// Torque, N·m (5.54): into the primary, out of the secondary; negative where the secondary drives.
    pub torque: f64,
    /// Power, W: into the primary, out of the secondary; negative where the secondary drives.
    pub power: f64,
    /// Axial force between the sheaves, N (5.58).
    pub axial_force: f64,
    /// Wrap angle Φ, rad.
    pub wrap_angle: f64,
    /// Angle of inclination θ where the belt enters, rad.
    pub entry_angle: f64,
    /// Angle of inclination θ where the belt leaves, rad.
    pub exit_angle: f64,
    /// Orientation angle C, rad (5.17)–(5.20).
    pub orientation_angle: f64,
    /// Largest radial penetration, m.
    pub max_penetration: f64,
    /// Smallest sliding speed, m/s.
    pub min_sliding_speed: f64,
    /// Largest sliding speed, m/s.
    pub max_sliding_speed: f64,
    /// Share of the wrap angle on which the belt slides more slowly than the slip threshold.
    pub adhesion_fraction: f64,
    /// Mean over the contact, weighted by pressure, of the friction that acts along the rim, over μ_k times the
    /// pressure: 0 without torque, 1 where all friction that this pressure permits drives or brakes the pulley.
    pub friction_utilization: f64,
    /// Nominal radius, m: as given, or as found where it was free.
    pub radius: f64,
    /// Where the axial force acts, m from the pulley's centre, towards the secondary's centre from the primary's (6.3).
    pub resultant_x: f64,
    /// Where the axial force acts, m from the pulley's centre, towards the tight span (6.4).
    pub resultant_y: f64,
    /// Moment of the axial force about the pulley's centre, N·m.
    pub binding_moment: f64,
    /// Power lost to friction, W.
    pub friction_loss: f64,
    /// Tractive tension where the belt enters, N.
    pub entry_tension: f64,
    /// Tractive tension where the belt leaves, N.
    pub exit_tension: f64,
}

/// One span.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Span {
    /// Arc length, m.
    pub arc_length: f64,
    /// Length when unloaded, m (5.56).
    pub unstretched_length: f64,
    /// Smallest tractive tension, N.
    pub min_tension: f64,
    /// Largest tractive tension, N.
    pub max_tension: f64,
}

/// Efficiencies as fractions, of the driven pulley over the driving one. The primary drives where both powers are
/// positive, the secondary where both are negative; where neither drives the other (no torque, or so little that both
/// pulleys only cover the belt's losses), there is no efficiency and all three are absent.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Efficiency {
    /// Rim speed of the driven pulley over that of the driving one, ω_S R_S/(ω_P R_P) (6.7) where the primary drives.
    pub speed: Option<f64>,
    /// Rim force of the driven pulley over that of the driving one, M_out R_P/(M_in R_S) (6.8) where the primary
    /// drives.
    pub torque: Option<f64>,
    /// Power out over power in (6.9): the product of the other two.
    pub overall: Option<f64>,
    /// The same with hysteresis, drag and gears taken off what arrives, where they are told.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub overall_with_losses: Option<f64>,
}

/// The belt as a whole.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct BeltResult {
    /// Mass flow G, kg/s (3.5).
    pub mass_flow: f64,
    /// Length of the loop when unloaded, m (5.55), (5.56).
    pub unstretched_length: f64,
    /// What the drive needs less what the belt has, m.
    pub length_error: f64,
    /// Temperature, K, where the case says what cools the belt.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub temperature: Option<f64>,
}

/// The energy audit: power in = power out + friction loss + strain energy flux, exactly for full shear with continuous
/// ends.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Energy {
    /// Power into the primary, W.
    pub power_in: f64,
    /// Power out of the secondary, W.
    pub power_out: f64,
    /// Power that friction turns to heat on both pulleys, W.
    pub friction_loss: f64,
    /// (power_in − power_out − friction_loss)/power_in; `None` without power in.
    pub imbalance: Option<f64>,
    /// Power that the belt's stretching takes from the energy of bending and squeezing, W: moment and pressure are
    /// given per stretched length, so that a piece of belt that grows shorter carries a little less.
    pub stretch_work: f64,
    /// (power_in − power_out − friction_loss − stretch_work)/power_in: what nothing accounts for; `None` without
    /// power in.
    pub closure: Option<f64>,
}

/// How the solution was found, and how well it holds.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SolverReport {
    /// Order of the collocation.
    pub order: usize,
    /// Relative tolerance on the defect.
    pub tolerance: f64,
    /// Intervals of the final meshes.
    pub mesh_intervals: MeshIntervals,
    /// Largest relative defect on the final meshes.
    pub max_residual: f64,
    /// Largest boundary residual, scaled.
    pub max_boundary_residual: f64,
    /// Newton iterations in all.
    pub newton_iterations: usize,
    /// Continuation steps in all.
    pub continuation_steps: usize,
    /// Seconds from the resolved case to the result, inside the process; nothing where the target has no clock.
    pub wall_time: Option<f64>,
}

/// Mesh intervals by region.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct MeshIntervals {
    /// Primary contact.
    pub primary: usize,
    /// Secondary contact.
    pub secondary: usize,
    /// Tight span.
    pub tight_span: usize,
    /// Slack span.
    pub slack_span: usize,
}
