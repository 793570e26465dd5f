//! The belt drive.

pub mod case;
pub mod quantity;
