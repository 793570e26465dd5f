//! Launch: a vehicle from standstill to its top speed, quasi-statically along the shift curve of its drive.
//!
//! At every speed of the vehicle the drive is in the equilibrium that it has there; what the secondary delivers beyond
//! the road's resistance accelerates the vehicle. Inertia of engine and pulleys, and the time that the sheaves take to
//! move, are left out.
//!
//! **The clutch.** Slower than at take-off, where the belt carries the engine's torque without gross slip, the belt
//! slips on the primary: outside the belt model. There the engine is taken to run as at take-off, at its speed and
//! torque; a slipping clutch passes torque undiminished and loses speed, so that the secondary delivers the torque that
//! it has at take-off, and what the engine gives beyond becomes heat.

mod curve;
mod figure;
mod run;
mod table;

pub use curve::{Delivered, LaunchCurve, LaunchError};
pub use figure::launch_figures;
pub use run::{Energy, Launch, LaunchOptions, LaunchPhase, LaunchPoint, Mark, launch};
pub use table::{launch_summary, launch_table};
