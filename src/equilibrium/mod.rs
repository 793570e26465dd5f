//! The equilibrium of a whole drive: belt, actuators and engine as one boundary value problem.
//!
//! A CVT has no operating point of its own to choose: flyweights, springs and a helix press, the belt pushes back, and
//! the drive settles where both agree. Of a drive whose secondary turns at a given speed, five constants are found that
//! are otherwise given, each with a boundary equation of its own beside those of the belt:
//!
//! | found | by |
//! |---|---|
//! | radius on the primary R_P | the belt closes: its unstretched length is what it is |
//! | radius on the secondary R_S | A_S = F_S(M_S, s_S): springs and helix balance the belt on the secondary |
//! | slack tension T_slack | A_P = F_P(ω_P, s_P): flyweights and spring balance it on the primary |
//! | torque M_in | M_in = engine(ω_P) |
//! | speed ω_P | the secondary's speed |
//!
//! At a stop one radius is given and the law of the pulley that rests there falls away; the stop carries the
//! difference of the two forces, which cannot be negative. Which of these holds is decided by complementarity: a state
//! is left where its stop would have to pull, or where the sheave would pass its stop.
//!
//! The laws stand beside the prescribed outputs in [`crate::drive::Law`]; their exact derivatives are part of Newton's
//! matrix.

mod curve;
mod ends;
mod error;
mod estimate;
mod figure;
mod heat;
#[cfg(feature = "ode")]
pub mod inverse;
mod laws;
mod phase;
mod point;
mod question;
mod ratio;
mod remarks;
mod report;
mod search;
mod sensitivity;
mod table;
mod walk;

pub use curve::{Landmark, ShiftBranch, ShiftOptions, ShiftPoint, engagement_speed};
pub use error::EquilibriumError;
pub use figure::{ShiftCurve, shift_figures};
pub use heat::equilibrium_outcome;
pub use laws::{EngineLaw, PrimaryLaw, SecondaryLaw};
pub use phase::{Direction, Phase, ReportedPhase, Stop, UnknownDirection};
pub use point::{ARRIVING, Equilibrium, Forces};
pub use question::has_all_parts;
pub(crate) use ratio::AtRatio;
pub use remarks::{beyond_engine, beyond_travel, over_curve, unused_keys};
pub use report::{DriveReport, SLIPPING};
pub use search::{equilibrium, equilibrium_from};
pub use sensitivity::{PartSensitivity, sensitivities};
pub use table::{DataError, Deviation, Measured, deviation, read_measured, shift_table};
pub use walk::{ShiftWalk, shift_branch, shift_branches};
