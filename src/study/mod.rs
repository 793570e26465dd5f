//! Studies: one case solved over a grid of any of its keys.
//!
//! A [`Study`] is a case and some [`Axis`]; its points are numbered in input order, the last axis running fastest.
//! [`run`] solves them on several threads and hands over one [`Row`] a point; [`Journal`] keeps rows as they come, so
//! that whatever ends the program loses none; [`Table`] is the finished study, and [`Rows`] what its writers need of
//! one.
//!
//! Every point's row is a function of the study alone. Points are solved in chains of neighbours along the last axis,
//! each started from the solution before it; where the chains begin depends on nothing but the grid, so the number
//! of threads and interruptions change nothing.
//!
//! ```
//! use sheave::case::Case;
//! use sheave::drive::SolveOptions;
//! use sheave::study::{Axis, Study, table};
//! let axes = [Axis::parse("operating_point.slack_tension=100 N..200 N:3")?];
//! let study = Study::new(Case::base(), axes, SolveOptions { tolerance: 1e-3, ..SolveOptions::default() })?;
//! let table = table(&study, Some(1))?;
//! assert_eq!(table.rows.len(), 3);
//! assert!(table.number(2, "primary.axial_force") > table.number(0, "primary.axial_force"));
//! # Ok::<(), sheave::study::StudyError>(())
//! ```

mod axis;
mod error;
mod file;
mod journal;
#[cfg(feature = "parquet")]
mod parquet;
mod plan;
mod row;
mod rows;
mod run;
mod stream;
mod tasks;
pub mod thesis;
mod write;

pub use axis::{Axis, DEFAULT_POINTS, MAX_POINTS};
pub use error::StudyError;
pub use file::StudyFile;
pub use journal::{Journal, JournalError, Journaled, set_aside, sync_folder};
#[cfg(feature = "parquet")]
pub use parquet::{write_parquet, write_parquet_with};
pub use plan::{GridPoint, Study};
pub use row::{Cell, Columns, Row, Table, TableBuilder};
pub use rows::{Rows, StoredRows, holds_text};
pub use run::{each, run, table, tables, visit};
pub use stream::Stream;
pub use write::{Format, write_csv, write_json};
