//! The belt drive.

pub mod quantity;
