//! The test set of boundary value problems: its statements checked, and solved.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

// The bench of the same name uses the same problems, each its own part.
#[allow(dead_code)]
mod problems;
mod solve;
mod statements;
