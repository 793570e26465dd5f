//! What most programs import: `use sheave::prelude::*;`.

pub use crate::case::{Case, CaseError, Edition, Key};
pub use crate::design::{ClampLimits, Limit, LimitOptions, Optimum};
pub use crate::drive::{Failure, SolveOptions};
pub use crate::facade::{Error, Sweep};
pub use crate::result::{DriveResult, Outcome, summary, warnings};
pub use crate::study::{Axis, Table};
pub use solver::Order;
