//! Why there is no solution. Names, not indices.

mod newton;

pub use newton::{Component, NewtonError, NonFinite};
pub(crate) use newton::{quantity, shown};

use crate::accuracy::Shortfall;
use crate::problem::LayoutError;
use thiserror::Error;

/// What is wrong with an initial guess.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum GuessError {
    /// Wrong number of regions, states or constants.
    #[error("{what}: {given} given, {expected} expected")]
    Shape {
        /// What is counted.
        what: String,
        /// As given.
        given: usize,
        /// As the layout says.
        expected: usize,
    },
    /// A mesh must have at least two nodes, increase, and span its region's interval.
    #[error("the mesh of region {region} {problem}")]
    Mesh {
        /// Region.
        region: String,
        /// What is wrong with it.
        problem: String,
    },
    /// A value is NaN or infinite.
    #[error("{0} is not finite in the guess")]
    NotFinite(String),
}

/// Below this tolerance defects are those of rounding where meshes are fine.
const NEAR_ROUNDING: f64 = 1e-12;

/// Why [`solve`](crate::solve()) has no solution to show.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum SolveError {
    /// The layout contradicts itself.
    #[error(transparent)]
    Layout(#[from] LayoutError),
    /// The guess does not fit the layout.
    #[error(transparent)]
    Guess(#[from] GuessError),
    /// There must be as many boundary equations as states and unknown constants together.
    #[error("{equations} boundary equations for {states} states and {unknowns} unknown constants")]
    Count {
        /// Boundary equations.
        equations: usize,
        /// States of all regions.
        states: usize,
        /// Unknown constants.
        unknowns: usize,
    },
    /// An unknown is not a constant of the layout, or is named twice.
    #[error("unknown constant {index} is out of range or named twice ({constants} constants)")]
    Unknowns {
        /// As given.
        index: usize,
        /// Constants of the layout.
        constants: usize,
    },
    /// There is no region of this index.
    #[error("there is no region {index}: the problem has {regions}, counted from 0")]
    Region {
        /// As given.
        index: usize,
        /// Regions of the layout.
        regions: usize,
    },
    /// Multipliers are asked for of a region that is a part of an orbit only.
    #[error("region {region} is no period by itself: boundary equation {equation} ties it to region {other}")]
    PartOfOrbit {
        /// The region.
        region: String,
        /// Name of the equation that depends on the ends of both.
        equation: String,
        /// The region that it is tied to.
        other: String,
    },
    /// An option makes no sense.
    #[error("option {name} = {value}: {expected}")]
    Option {
        /// Name of the option.
        name: &'static str,
        /// As given.
        value: f64,
        /// What is expected.
        expected: &'static str,
    },
    /// A continuation was not at its end after as many steps as it may take.
    #[error("not at the end of the path after {steps} steps")]
    Steps {
        /// Steps taken.
        steps: usize,
    },
    /// Between two points of a branch nothing was found where it was expected, however near they are.
    #[error(
        "between two points of the branch, what was found where the parameter is {at} lies on another part of it, or \
         on another branch"
    )]
    Astray {
        /// Value of the parameter.
        at: f64,
    },
    /// Newton's iteration failed.
    #[error("on a mesh of {intervals} intervals: {error}")]
    Newton {
        /// How it failed.
        error: NewtonError,
        /// Intervals of all regions.
        intervals: usize,
    },
    /// The tolerance would need a finer mesh than allowed.
    #[error(
        "the defect is {defect:.1e} for a tolerance of {tolerance:.1e} in region {region} at {}, \
         most in {state}: {because}", shown(*.position)
    )]
    MeshLimit {
        /// Region of the largest defect.
        region: String,
        /// Where.
        position: f64,
        /// In whose equation.
        state: String,
        /// Largest defect.
        defect: f64,
        /// Wanted.
        tolerance: f64,
        /// Intervals of that region.
        intervals: usize,
        /// What keeps its mesh from being made finer.
        because: MeshBound,
    },
    /// Newton converged, but a boundary equation is not met.
    #[error(
        "boundary equation {equation} is left with a residual of {residual:.1e} for a tolerance of {tolerance:.1e}"
    )]
    Boundary {
        /// Name.
        equation: String,
        /// Relative to the equation's largest term.
        residual: f64,
        /// Wanted.
        tolerance: f64,
    },
    /// A solution was found, but its estimated error exceeds the tolerance and could not be brought below it.
    #[error("the estimated error is {estimate:.1e} for a tolerance of {tolerance:.1e}: {because}")]
    Inaccurate {
        /// Estimated error, largest component relative to typical magnitudes.
        estimate: f64,
        /// Wanted.
        tolerance: f64,
        /// What stood in the way of a smaller error.
        because: Shortfall,
    },
    /// The right-hand side is not linear, although [`Problem::is_linear`](crate::Problem::is_linear) says so; or its
    /// derivatives are wrong.
    #[error(
        "the problem says that it is linear, but {quantity} in region {region} at {} is {found:.6e} where its \
         derivatives lead to {expected:.6e}", shown(*.position)
    )]
    NotLinear {
        /// Whose value it is: the right-hand side of a state, or an integrand.
        quantity: String,
        /// Region.
        region: String,
        /// Where.
        position: f64,
        /// As evaluated.
        found: f64,
        /// As the values elsewhere and the derivatives have it.
        expected: f64,
    },
    /// The work that the call was allowed is spent: [`Options::work_limit`](crate::Options::work_limit).
    #[error("the right-hand side was evaluated at {points} points: more than the work limit of {limit}")]
    WorkLimit {
        /// Points at which the right-hand side was evaluated.
        points: usize,
        /// As many were allowed.
        limit: usize,
    },
    /// The observer, or the holder of a [`Cancel`](crate::Cancel) handle, asked to stop.
    #[error("cancelled")]
    Cancelled,
}

/// What keeps a mesh from being made finer: see [`SolveError::MeshLimit`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum MeshBound {
    /// A region may have no more intervals: [`Options::max_intervals`](crate::Options::max_intervals).
    #[error("more than {most} intervals are not allowed")]
    Intervals {
        /// How many it may have.
        most: usize,
    },
    /// There may be no more meshes: [`Options::max_meshes`](crate::Options::max_meshes).
    #[error("more than {most} meshes are not allowed")]
    Meshes {
        /// How many there may be.
        most: usize,
    },
    /// The interval of the largest defect is so short that rounding would decide on the lengths of its parts.
    #[error("the interval there is about as short as the rounding of places allows")]
    Rounding,
}

impl SolveError {
    /// Whether no other way of solving can help: the input is wrong, the work is spent, or the caller asked to stop.
    pub fn is_final(&self) -> bool {
        !matches!(
            self,
            Self::Newton { .. }
                | Self::MeshLimit { .. }
                | Self::Boundary { .. }
                | Self::Inaccurate { .. }
                | Self::Steps { .. }
                | Self::Astray { .. }
        )
    }

    /// What to try.
    pub fn advice(&self) -> &'static str {
        match self {
            Self::Newton { error, .. } => error.advice(),
            Self::MeshLimit { tolerance, .. } if *tolerance < NEAR_ROUNDING => {
                "Rounding is what is left at such a tolerance: ask for 1e-12 at most, or use a higher order."
            }
            Self::MeshLimit { because: MeshBound::Rounding, .. } => {
                "The solution is not smooth there: beside an end, like a root or a logarithm, it is in another \
                 variable, as in t with x = t²; about a place within, make that the end of a region."
            }
            Self::MeshLimit { because: MeshBound::Meshes { .. }, .. } => {
                "Allow more meshes (max_meshes), begin with a finer mesh where the defect is, or continue from an \
                 easier parameter."
            }
            Self::MeshLimit { defect, tolerance, .. } if *defect > 1e3 * tolerance => {
                "The solution varies faster than the mesh can resolve: a layer, a singularity, or a spurious solution \
                 of a coarse mesh. Continue in the parameter that makes it thin, begin with a finer mesh where the \
                 layer is, or allow more intervals."
            }
            Self::MeshLimit { .. } => {
                "Allow more intervals, use a higher order, or ask for less; near 1e-12 rounding is the limit. A kink \
                 in the right-hand side costs many intervals: make its place the end of a region."
            }
            Self::Boundary { .. } => "Scale the boundary equation or its states, or loosen boundary_tolerance.",
            Self::Count { .. } => {
                "Each unknown constant needs one boundary equation more; a region needs as many as it has states."
            }
            Self::PartOfOrbit { .. } => "State the whole orbit in one region, whose interval is the period.",
            Self::Steps { .. } => {
                "Allow more steps, or resume from the last solution; longer steps need a looser contraction."
            }
            Self::Layout(_) | Self::Guess(_) | Self::Unknowns { .. } | Self::Region { .. } | Self::Option { .. } => {
                "Correct the input."
            }
            Self::Inaccurate { because: Shortfall::Rounding, .. } => {
                "The problem amplifies rounding errors: ask for less, scale its equations, or state the solution in \
                 terms that are not small differences of large ones. To have the solution as it is, set \
                 accept_inaccurate."
            }
            Self::Inaccurate { .. } => {
                "Allow more intervals and meshes, or use a higher order; an error estimate near 1 means that the \
                 solution may be spurious. To have the solution as it is, set accept_inaccurate."
            }
            Self::Astray { .. } => {
                "Other solutions are close: take shorter steps (largest_step, smallest_step), or finer meshes."
            }
            Self::WorkLimit { .. } => {
                "Allow more work, improve the guess, or continue from an easier parameter; what is slow to converge \
                 may have no solution."
            }
            Self::NotLinear { .. } => {
                "Do not say that it is linear if it has products, powers or other functions of states and unknown \
                 constants; if it has none, correct its derivatives."
            }
            Self::Cancelled => "Nothing: the caller asked for it.",
        }
    }

    /// Whether the call was stopped from outside or by its work limit, so that nothing else is to be tried.
    pub(crate) fn is_interruption(&self) -> bool {
        matches!(self, Self::Cancelled | Self::WorkLimit { .. })
    }
}
