//! Cases: what a user writes, and what the solver is given.
//!
//! A [`Case`] is sparse and remembers where everything was written. [`Case::resolve`] fills in the base case
//! (Table 6.1) and the edition's choices, checks what holds between keys, and gives a [`Resolved`] case: plain data,
//! SI. All keys, with their units, ranges, defaults and meaning, stand in [`TABLE`].
//!
//! ```
//! use sheave::case::Case;
//! let mut case = Case::from_toml("my.toml", "[drive]\nratio = 1.2")?;
//! case.set("operating_point.slack_tension", "120 N")?;
//! let resolved = case.resolve()?;
//! assert!(resolved.drive.secondary_radius > resolved.drive.primary_radius);
//! # Ok::<(), sheave::case::CaseError>(())
//! ```
//!
//! # Rules between keys
//! - `drive.ratio` stands in place of both radii; beside one of them it is an error.
//! - Each slot of the operating point (speed, load, clamp) is filled by one key; two are an error, except that with
//!   `drive.free = "both"` there must be exactly one key more.
//! - A radius that is free must not be given. With `drive.ratio` and one free radius, the other comes from the ratio,
//!   and the free one starts there.
//! - `model.*` overrides any edition's choices, one by one: `published` with `model.ends = "zero"` keeps the printed
//!   spans only. The printed end conditions exist for linearised shear only; a string takes no choice but its friction
//!   law.
//! - `swap = ["belt.bending_stiffness for efficiency.overall = 0.96"]` at the top makes any given constant unknown and
//!   prescribes any output in its place; the constant's own key says where the search starts.
//! - Setting a key replaces what was given for that key, never for another of its slot: [`Case::unset`] and
//!   [`Case::make_room`] do that.
//! - `belt.length` beside both radii: the radii hold. A belt that differs from their pitch length (6.12) by more than
//!   [`PITCH_TOLERANCE`] of it is remarked upon, see [`Case::remarks`].

#[cfg(feature = "cli")]
mod diagnostic;
mod error;
mod fits;
pub mod geometry;
mod given;
mod grid;
mod keys;
mod loss_tangent;
mod losses;
mod names;
mod operating;
mod parts;
mod place;
mod posed;
mod range;
pub(crate) mod raw;
mod read;
mod resolve;
#[cfg(feature = "schema")]
mod schema;
mod setting;
mod swap;
mod tables;
mod text;
mod thermal;
mod value;

pub use crate::model::{Bending, Choice, Edition, Ends, Free, Friction, Include, ModelChoices, Shear, Spans};
pub use error::{CaseError, CaseProblem};
pub use fits::PITCH_TOLERANCE;
pub use given::Case;
pub use grid::{Grid, GridError, Rated};
pub use keys::{Entry, Key, TABLE, ValueKind, is_section, sections};
pub use loss_tangent::LossTangent;
pub use losses::Losses;
pub use names::{constant_label, output_axis_label, output_label};
pub use operating::{Clamp, Fourth, Load, Margin, OperatingPoint, Speed};
pub use parts::{Actuation, Parts};
pub use place::{Place, Placed, Source};
pub use range::{Range, RangeEnd};
pub use resolve::{BeltProperties, Drive, Resolved, Sheave};
pub use setting::Setting;
pub use swap::GivenSwap;
pub use tables::Over;
pub use thermal::{Softened, Stiffnesses, Surface, Thermal};
