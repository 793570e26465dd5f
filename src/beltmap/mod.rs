//! Maps of a belt: what it does over ratio, torque, speed and clamp, as a table that is read between its nodes with a
//! known error.
//!
//! A [`MapPlan`] says what is mapped; [`MapPlan::build`] makes the [`BeltMap`]. Its nodes form a tensor grid, as lookup
//! tables have it, whose breakpoints lie closer where the belt's behaviour asks for it. At every node the solver gives
//! all quantities with their exact derivatives, and between nodes stands a cubic Hermite interpolant of both. In every
//! cell one more solution, which took no part in the construction, measures the error: breakpoints are added until it
//! is within what was asked for, and the [`Report`] says what it is.

mod axis;
mod build;
mod error;
mod estimate;
mod file;
mod hermite;
mod map;
#[cfg(feature = "netcdf")]
mod netcdf;
mod plan;
mod quantity;
mod record;
mod report;
mod utilization;

pub use axis::{FIRST_BREAKPOINTS, MAX_AXES, MapAxis};
pub use error::{MapError, MapFileError, Outside};
pub use file::MapFormat;
pub use map::{BeltMap, MapPoint};
pub use plan::{Keep, KeepNothing, MapOptions, MapPlan, Progress};
pub(crate) use quantity::holds;
pub use quantity::{Measure, Quantity};
pub use report::{ErrorReport, QuantityError, Report};
