//! The ground that everything else stands on: editions of the equations and what they choose, the constants of a drive,
//! its outputs, and the error for what must not happen. It knows neither case files nor solutions.

mod choice;
mod constants;
mod error;
mod posed;

pub use choice::{
    Bending, Choice, Edition, Ends, FlyweightKind, Free, Friction, HelixAngleFrom, Include, ModelChoices,
    SecondaryKind, Shear, Spans,
};
pub use constants::Constants;
pub use error::InternalError;
pub use generated::{BeltTheory, Constant, Field, Integral, Output, RegionConstant, State, UnknownOutput};
pub use posed::IllPosed;
