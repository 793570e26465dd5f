//! The belt drive: the generated equations and the solver, joined.

mod approach;
mod ask;
mod belt;
mod budget;
mod closing;
mod correct;
mod curve;
mod estimate;
mod failure;
mod inputs;
mod model;
mod outputs;
mod posedness;
mod predict;
mod question;
mod region;
mod route;
mod solve;
mod solved;
mod start;
mod tuning;
mod warm;

pub use crate::model::{Constant, Constants, IllPosed, Output};
pub use belt::BeltProblem;
pub use closing::{Argument, Closing, Law};
pub use curve::{Curve, End, trace};
pub use failure::{Failure, Reached};
pub use inputs::inputs;
pub use outputs::{OutputGradients, OutputValues};
pub use question::{Known, Question, Swap};
pub use region::RegionId;
pub(crate) use region::Source;
pub use route::Route;
pub use solve::{SolveOptions, WORK_LIMIT, approach_question, solve, solve_question};
pub use solved::Solved;
pub use warm::{remoteness, solve_along, solve_from, solve_question_from};
