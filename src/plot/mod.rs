//! Figures: what a solution or a study looks like, as SVG and PNG, in one style.
//!
//! A [`Figure`] is data: axes with symbols and units, and series. With the feature `figures`, `Figure::svg` and
//! `Figure::png` draw it, dark on white, so that it reads in print and on a page of any colour. [`drive`] makes the
//! figures of one solution.
//!
//! ```
//! use sheave::plot::{Axis, Figure, Series};
//! let line = Series::line("η", vec![(0.7, 0.95), (1.7, 0.97)]);
//! let figure = Figure::new("efficiency", "Overall efficiency", Axis::new("R_{S}/R_{P}"), Axis::new("η"), vec![line]);
//! # #[cfg(feature = "figures")]
//! assert!(figure.svg().is_ok_and(|text| text.starts_with("<svg")));
//! ```

#[cfg(feature = "figures")]
mod canvas;
mod drive;
mod figure;
#[cfg(feature = "figures")]
mod path;
#[cfg(feature = "figures")]
mod render;
mod stack;
#[cfg(feature = "figures")]
mod ticks;
mod trajectory;

pub use drive::drive;
pub use figure::{Axis, Figure, Look, Mark, Series};
#[cfg(feature = "figures")]
pub use render::PlotError;
pub use stack::Stack;
pub use trajectory::{Path, Rim, Trajectory};
