//! From the bench to the model: [`belt`] properties from material tests, [`radii`] of a belt around two pulleys,
//! operating points from the logs of a dynamometer ([`dyno`]), how they [`compare`] with the model, and data [`made`]
//! from it.
//!
//! Formulae that reduce measurements stand here, each once and with its source; the equations of the belt do not.

pub mod belt;
mod cells;
pub mod compare;
pub mod dyno;
pub mod engine;
mod error;
pub mod made;
mod page;
pub mod radii;
mod sheet;
mod statistics;

pub use error::{BenchError, BenchProblem};
pub use page::{PageTable, page};
pub use sheet::{Entry, QuantityKind, keys, temperature};
pub use statistics::{Average, CONFIDENCE, Line, student};
