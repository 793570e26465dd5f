//! From the bench to the model: [`belt`] properties from material tests, [`radii`] of a belt around two pulleys, operating
//! points from the logs of a dynamometer.
//!
//! Formulae that reduce measurements stand here, each once and with its source; the equations of the belt do not.

pub mod belt;
mod error;
mod page;
pub mod radii;
mod sheet;
mod statistics;

pub use error::{BenchError, Problem};
pub use page::{PageTable, page};
pub use sheet::{Entry, Kind, celsius, keys, temperature};
pub use statistics::{Average, CONFIDENCE, Line, student};
