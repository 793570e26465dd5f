//! Following solutions through changes of the constants.
//!
//! - [`follow`]: along a given path, from its start to its end.
//! - [`trace`](fn@trace): a branch in one constant, through folds, with events.
//! - [`trace_crossing`]: from a branch point onto the branch that crosses there.
//! - [`solve_automatically`]: whatever way leads to a solution where Newton's iteration fails from the guess.
//! - [`Checkpoint`]: where a continuation stands, for a later process.

mod arclength;
mod automatic;
mod branch;
mod checkpoint;
mod homotopy;
mod natural;
mod path;
mod trace;
mod tracer;

pub use arclength::Direction;
pub use automatic::{Automatic, How, Stiffness, solve_automatically, solve_automatically_observed};
pub use branch::{Branch, BranchError, BranchOptions, BranchPoint, EventFunction, PointKind, Side};
pub use checkpoint::{Checkpoint, CheckpointError, Saved};
pub use natural::{Followed, PathError, PathOptions, StepRecord, follow, follow_observed, resume_follow};
pub use path::{Path, Ramp};
pub use trace::{resume_trace, trace, trace_crossing, trace_crossing_observed, trace_observed};
