//! What a designer asks beyond one operating point: how much torque a clamp carries, how little clamp a torque needs, and
//! which clamp wastes least.
//!
//! Torque, clamp and speed lie on one curve. As soon as slip shows in the speed efficiency ω_S R_S/(ω_P R_P), it is followed
//! in that, with the torque or the slack tension unknown, from an ordinary operating point to the stall of the secondary:
//! where torque or clamp has an extremum on the way, the speed efficiency has none, so that nothing is singular there
//! (docs/operating-points.md).

mod branch;
mod error;
mod limit;
mod map;
mod optimum;
mod state;

pub use branch::{Branch, BranchEnd, Parameter, Point};
pub use error::DesignError;
pub use limit::{ClampLimits, Kind, Limit, LimitOptions, largest_torque, smallest_clamps};
pub use map::{limit_figures, limit_map, limits, optimum_figures, optimum_map};
pub use optimum::{Bound, Optimum, optimum};
pub use state::State;
