//! The search for a tune: among all combinations of a box of parts, those that hold the engine at a speed.
//!
//! A [`TunePlan`] is a drive and a [`PartsBox`]. Its [`map`](TunePlan::map) is of the belt alone, which no part
//! changes; on it, [`search`](TunePlan::search) balances flyweights, springs and helix of every combination against the
//! belt at points of the shift, by Newton's method for the engine's speed and the slack tension with the map's
//! derivatives. Points that the map does not tell are solved in full. The best are confirmed by full solutions: the
//! equilibrium of the whole drive at the same speeds of the secondary.

mod belongs;
mod drive;
mod error;
mod full;
mod parts;
mod screen;
mod search;
mod show;
mod unfit;

pub use error::{PartsProblem, TuneError};
pub use parts::{MAX_CANDIDATES, Part, PartKind, PartsBox};
pub use screen::{Screen, Work};
pub use search::{Confirmed, Merits, Ranking, Refused, Tune, TuneOptions, TunePlan};
pub use show::{pareto_figure, summary, table};
pub use unfit::{ShiftPoint, Unfit};
