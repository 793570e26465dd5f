//! The dynamometer's logger: the same code on a real rig and on a simulated one.

pub mod calibrate;
pub mod calibration;
#[cfg(feature = "display")]
pub mod display;
pub mod hardware;
pub mod interlock;
pub mod journal;
pub mod old_runs;
pub mod replay;
pub mod runs;
pub mod session;
pub mod settle;
pub mod simulated;
pub mod steady;
pub mod watch;
pub mod web;
pub mod wired;
