//! Why a pulley has no state.

/// Why a pulley has no state.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PulleyError {
    /// A parameter or a known variable out of its range.
    #[error("`{what}` = {given} {unit}: expected {expected}")]
    Parameter {
        /// Which.
        what: &'static str,
        /// Its value.
        given: f64,
        /// Its SI unit.
        unit: &'static str,
        /// What it should be.
        expected: &'static str,
    },
    /// An ideal belt does not slip, whatever its tensions.
    #[error("an ideal belt leaves both tensions open: expected a flat or a V-belt")]
    Ideal,
    /// Newton's method did not end.
    #[error("no tension was found in {steps} steps of Newton's method")]
    NotConverged {
        /// Steps taken.
        steps: usize,
    },
}

pub(super) fn check(
    what: &'static str,
    unit: &'static str,
    given: f64,
    fits: bool,
    expected: &'static str,
) -> Result<(), PulleyError> {
    if given.is_finite() && fits { Ok(()) } else { Err(PulleyError::Parameter { what, given, unit, expected }) }
}
