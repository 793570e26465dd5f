//! Right-hand sides, boundary residuals and their derivatives, as `eqgen` emits them.

mod types;

pub use types::{BoundaryKernel, Equation, RegionFn, RegionKernel, RegionOut, Symbol};
