//! The belt drive: the generated equations and the solver, joined.

mod belt;
mod constants;
mod model;
mod predict;
mod region;
mod solve;
mod start;
mod warm;

pub use belt::Belt;
pub use constants::{Constant, Constants};
pub use region::RegionId;
pub use solve::{Failure, SolveOptions, Solved, given, solve};
pub use warm::{remoteness, solve_from};
