//! Boundary value problems for ordinary differential equations in several regions, with unknown constants and
//! integral conditions, by collocation.

pub mod model;
pub mod problem;

pub use problem::{Constant, Layout, LayoutError, Points, Problem, Region, Scope, State};
