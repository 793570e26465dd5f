//! What a designer asks beyond one operating point: how much torque a clamp carries, how little clamp a torque needs,
//! and which clamp wastes least.
//!
//! Torque, clamp and speed lie on one curve. It is followed from an ordinary operating point by pseudo-arclength, in
//! what is sought, whose extrema are folds that the solver locates; and where the belt comes to rest, in the speed
//! efficiency ω_S R_S/(ω_P R_P), down to the stall of the secondary (docs/operating-points.md).

mod branch;
mod eased;
mod error;
mod limit;
mod map;
mod optimum;
mod state;
mod verdict;

pub use branch::{Branch, BranchEnd, BranchPoint, Parameter};
pub use eased::Easing;
pub use error::DesignError;
pub use limit::{ClampLimits, Limit, LimitKind, LimitOptions, largest_torque, smallest_clamps, smallest_slack_tension};
pub use map::{limit_figures, limit_map, limits, optimum_figures, optimum_map};
pub use optimum::{Optimum, OptimumPlace, optimum};
pub use state::DriveState;
pub use verdict::{Verdict, verdict};
