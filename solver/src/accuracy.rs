//! How good a solution is said to be.

use std::fmt;

/// Whether the estimated error of a solution meets the tolerance.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Accuracy {
    /// It does.
    Met,
    /// It does not, although the defects do: the problem amplifies them.
    Short {
        /// Estimated error: see [`Solution::error_estimate`](crate::Solution::error_estimate).
        #[cfg_attr(feature = "serde", serde(with = "crate::serialised::estimate"))]
        estimate: f64,
        /// What it was to meet.
        tolerance: f64,
        /// What stood in the way of a smaller error.
        because: Shortfall,
    },
}

/// Why a solution was not refined until its estimated error met the tolerance.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Shortfall {
    /// Only the defects were to meet the tolerance: [`Control::Defect`](crate::Control::Defect).
    Uncontrolled,
    /// The guess was a solution already, and was kept with its mesh, since inaccurate solutions are accepted.
    WarmStart,
    /// Finer meshes were not allowed, or could not be solved on.
    Mesh,
    /// Smaller defects would be rounding errors: the problem is ill-conditioned.
    Rounding,
}

impl fmt::Display for Shortfall {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Uncontrolled => "only the defects were held to the tolerance",
            Self::WarmStart => "the guess was a solution already, and was kept with its mesh",
            Self::Mesh => "finer meshes are not allowed, or could not be solved on",
            Self::Rounding => "smaller defects would be rounding errors",
        })
    }
}
