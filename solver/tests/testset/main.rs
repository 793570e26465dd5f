//! The test set of boundary value problems: its statements checked, and solved.

// The bench of the same name uses the same problems, each its own part.
#[allow(dead_code)]
mod problems;
mod solve;
mod statements;
