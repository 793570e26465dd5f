//! The enums by which callers name quantities: derived anew at build time, or as committed in `golden/`.

use std::fmt;
use std::str::FromStr;

use crate::sets::BeltTheory;
use crate::types::{Dimension, Identity, Symbol};

#[cfg(feature = "regenerate")]
include!(concat!(env!("OUT_DIR"), "/vocabulary.rs"));
#[cfg(not(feature = "regenerate"))]
include!(concat!(env!("CARGO_MANIFEST_DIR"), "/golden/vocabulary.rs"));

impl Constant {
    /// How many of [`Self::ALL`], from the front, are unknown unless a question says otherwise.
    pub const UNKNOWN: usize = Self::SlackLength as usize + 1;
}

/// A name that no output has.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnknownOutput {
    /// As given.
    pub name: String,
}

impl fmt::Display for UnknownOutput {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "unknown output `{}`: expected one of a result, such as `{}`",
            self.name,
            Output::EfficiencyOverall.name()
        )
    }
}

impl std::error::Error for UnknownOutput {}

/// Reads the name that an output has in the result object: `primary.axial_force`.
impl FromStr for Output {
    type Err = UnknownOutput;

    fn from_str(name: &str) -> Result<Self, UnknownOutput> {
        let named = |output: &Self| output.name() == name;
        Self::ALL.into_iter().find(named).ok_or_else(|| UnknownOutput { name: name.to_owned() })
    }
}
