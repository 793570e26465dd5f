//! What drives the belt and what it drives: an engine and a vehicle.

mod engine;
mod vehicle;

pub use engine::{Engine, EngineTorque, Governor};
pub use vehicle::{Load, Vehicle};
