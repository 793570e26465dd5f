//! The belt drive.
