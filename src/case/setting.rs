//! The value of a key, decided.

use super::grid::Grid;
use serde::Serialize;

/// The value of a key.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Setting {
    /// In SI.
    Number(f64),
    /// In SI.
    List(Vec<f64>),
    /// One of the key's choices.
    Name(&'static str),
    /// A table in SI.
    Table(Grid),
}
