//! Rubber V-belt CVTs, computed: a [`case`] is solved by the [`drive`], and its [`result`] says what the belt does; a
//! [`study`] does so over a grid, [`design`] finds its limits and its best clamp; [`plot`] and [`report`] show it. [`small`]
//! models stand beside the full one; [`actuator`]s press the sheaves together. `bench` (a feature) leads from measurements to what a case needs, and from logs to a comparison.

pub mod actuator;
#[cfg(feature = "bench")]
pub mod bench;
pub mod case;
pub mod clock;
pub mod design;
pub mod drive;
pub mod losses;
pub mod model;
pub mod plot;
pub mod quantity;
#[cfg(feature = "figures")]
pub mod report;
pub mod result;
pub mod small;
pub mod study;
pub mod text;
mod threads;
