//! Measured operating points against the model, and constants of the model fitted to them.

mod actuator;
mod comparison;
pub mod fit;
mod measured;
mod model;
mod show;

pub use actuator::{Actuator, TABLE as ACTUATOR_KEYS};
pub use comparison::{Clamp, Compared, Comparison, Fit, FittedConstant, Options, Radii};
pub use fit::{Scale, scale};
pub use measured::{BadRow, Measured, Table, parse, read};
pub(super) use model::REPLACED;
pub use model::compare;
pub use show::{determined, figures, scale_interval, summary};

/// The key under which the engine's scale is fitted beside constants of the case.
pub const ENGINE_SCALE: &str = "engine.scale";
