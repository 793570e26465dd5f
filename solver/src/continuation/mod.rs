//! Following solutions through changes of the constants.

mod natural;
mod path;

pub use natural::{Followed, PathError, PathOptions, StepRecord, follow, follow_observed};
pub use path::{Path, Ramp};
