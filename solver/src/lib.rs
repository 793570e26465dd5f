//! Boundary value problems for ordinary differential equations in several regions, with unknown constants and
//! integral conditions, by collocation.

// Negated comparisons are meant: NaN must fail.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

mod collocation;
mod conditioning;
pub mod continuation;
pub mod error;
mod guess;
mod linear;
mod linearisation;
mod measure;
pub mod mesh;
pub mod model;
mod newton;
mod observer;
mod options;
pub mod problem;
mod refine;
mod run;
mod solution;
mod solve;
mod stats;
mod tableau;

pub use conditioning::Conditioning;
pub use error::{Component, GuessError, NewtonError, NonFinite, SolveError};
pub use guess::{Guess, RegionGuess};
pub use linearisation::{Functional, Linearisation, Tangent, TangentRegion};
pub use observer::{Event, Observer, Silent};
pub use options::{Control, Options, Order};
pub use problem::{Constant, Layout, LayoutError, Points, Problem, Region, Scope, State};
pub use solution::{MeshRecord, RegionSolution, Solution};
pub use solve::{solve, solve_observed};
pub use stats::Stats;
