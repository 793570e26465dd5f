//! Why there is no solution. Names, not indices.

use crate::problem::{Layout, LayoutError, Points};
use crate::solution::Shortfall;
use std::fmt;
use thiserror::Error;

/// A value that is not finite, and where it arose.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{quantity} is {value}{}", Place(.region, .position))]
pub struct NonFinite {
    /// Which row: a state's right-hand side, an integrand, a boundary equation, or a derivative.
    pub quantity: String,
    /// Region, unless a boundary equation is meant.
    pub region: Option<String>,
    /// Independent variable, unless a boundary equation is meant.
    pub position: Option<f64>,
    /// NaN or an infinity.
    pub value: f64,
    /// States at that point, by name.
    pub states: Vec<(String, f64)>,
}

struct Place<'a>(&'a Option<String>, &'a Option<f64>);

impl fmt::Display for Place<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(region) = self.0 {
            write!(f, " in region {region}")?;
        }
        self.1.map_or(Ok(()), |position| write!(f, " at {}", shown(position)))
    }
}

/// A position as people read it: to eight digits, without the noise of the mesh's arithmetic beyond them.
pub(crate) fn shown(position: f64) -> f64 {
    format!("{position:.7e}").parse().unwrap_or(position)
}

impl NonFinite {
    pub(crate) fn value(layout: &Layout, region: usize, at: &Points<'_>, f: &[f64]) -> Self {
        let (row, point, value) = locate(at, f);
        let region = &layout.regions[region];
        let n = region.states.len();
        let quantity = if row < n {
            format!("the right-hand side of {}", region.states[row].name)
        } else {
            format!("the integrand of {}", region.integrals[row - n])
        };
        Self::at_point(region, quantity, at, point, value)
    }

    pub(crate) fn derivative(layout: &Layout, region: usize, at: &Points<'_>, dy: &[f64]) -> Self {
        let (entry, point, value) = locate(at, dy);
        let region = &layout.regions[region];
        let (row, state) = region.state_pattern[entry];
        let n = region.states.len();
        let of = if row < n {
            format!("the right-hand side of {}", region.states[row].name)
        } else {
            format!("the integrand of {}", region.integrals[row - n])
        };
        let quantity = format!("the derivative of {of} with respect to {}", region.states[state].name);
        Self::at_point(region, quantity, at, point, value)
    }

    fn at_point(region: &crate::problem::Region, quantity: String, at: &Points<'_>, point: usize, value: f64) -> Self {
        let states = region.states.iter().enumerate();
        Self {
            quantity,
            region: Some(region.name.clone()),
            position: at.s.get(point).copied(),
            value,
            states: states.map(|(i, state)| (state.name.clone(), at.y[i * at.stride + point])).collect(),
        }
    }

    pub(crate) fn boundary(layout: &Layout, equation: usize) -> Self {
        Self::boundary_named(format!("the boundary equation {}", layout.equations[equation]))
    }

    pub(crate) fn boundary_derivative(layout: &Layout, entry: usize) -> Self {
        let (equation, input) = layout.boundary_pattern[entry];
        let equation = &layout.equations[equation];
        let input = layout.input_name(input);
        Self::boundary_named(format!("the derivative of the boundary equation {equation} with respect to {input}"))
    }

    fn boundary_named(quantity: String) -> Self {
        Self { quantity, region: None, position: None, value: f64::NAN, states: Vec::new() }
    }
}

/// Component, point and value of the first entry that is not finite.
fn locate(at: &Points<'_>, values: &[f64]) -> (usize, usize, f64) {
    let found = values.iter().enumerate().find(|(_, value)| !value.is_finite());
    found.map_or((0, 0, f64::NAN), |(index, &value)| (index / at.stride, index % at.stride, value))
}

/// A component of an unknown: how messages name it.
#[derive(Debug, Clone, PartialEq)]
pub struct Component {
    /// `"theta at the entry of contact"`, `"constant Phi"`, ...
    pub name: String,
    /// In units of the component's typical magnitude.
    pub value: f64,
}

impl fmt::Display for Component {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ({:+.2e})", self.name, self.value)
    }
}

pub(crate) fn listed(components: &[Component]) -> String {
    components.iter().map(Component::to_string).collect::<Vec<_>>().join(", ")
}

/// How Newton's iteration ended without a solution.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum NewtonError {
    /// The equations are undefined at the initial guess, or wherever the iteration could go.
    #[error("the equations are undefined: {0}")]
    NonFinite(NonFinite),
    /// The linearised equations do not determine all unknowns.
    #[error(
        "the linearised equations have rank {rank} of {size}; the direction they leave undetermined is mostly {}",
        listed(.null_vector)
    )]
    Singular {
        /// Rank of the system for ends and constants.
        rank: usize,
        /// Its size.
        size: usize,
        /// Largest components of the null vector.
        null_vector: Vec<Component>,
        /// Boundary equations that do not depend on any unknown.
        empty_equations: Vec<String>,
    },
    /// No step, however short, brings the iterate closer to a solution.
    #[error(
        "Newton's iteration stalled after {iterations} iterations: damping {damping:.1e}, \
         correction {correction:.1e}, largest in {}", listed(.largest)
    )]
    Stalled {
        /// Iterations done.
        iterations: usize,
        /// The damping factor last tried.
        damping: f64,
        /// Size of the correction, relative to typical magnitudes.
        correction: f64,
        /// Its largest components.
        largest: Vec<Component>,
    },
    /// The iteration still moved when it had to stop.
    #[error(
        "Newton's iteration did not converge in {iterations} iterations: correction {correction:.1e}, \
         largest in {}", listed(.largest)
    )]
    IterationLimit {
        /// Iterations done.
        iterations: usize,
        /// Size of the correction, relative to typical magnitudes.
        correction: f64,
        /// Its largest components.
        largest: Vec<Component>,
    },
}

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
         most in {state}: the mesh of {intervals} intervals may not grow further", shown(*.position)
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
        )
    }

    /// What to try.
    pub fn advice(&self) -> &'static str {
        match self {
            Self::Newton { error, .. } => error.advice(),
            Self::MeshLimit { defect, tolerance, .. } if *defect > 1e3 * tolerance => {
                "The solution varies faster than the mesh can resolve: a layer, a singularity, or a spurious solution of a \
                 coarse mesh. Continue in the parameter that makes it thin, begin with a finer mesh where the layer is, or \
                 allow more intervals."
            }
            Self::MeshLimit { .. } => {
                "Allow more intervals, use order six, or ask for less; near 1e-12 rounding is the limit. A kink in the \
                 right-hand side costs many intervals: make its place the end of a region."
            }
            Self::Boundary { .. } => "Scale the boundary equation or its states, or loosen boundary_tolerance.",
            Self::Count { .. } => {
                "Each unknown constant needs one boundary equation more; a region needs as many as it has states."
            }
            Self::Steps { .. } => {
                "Allow more steps, or resume from the last solution; longer steps need a looser contraction."
            }
            Self::Layout(_) | Self::Guess(_) | Self::Unknowns { .. } | Self::Option { .. } => "Correct the input.",
            Self::Inaccurate { because: Shortfall::Rounding, .. } => {
                "The problem amplifies rounding errors: ask for less, scale its equations, or state the solution in terms that \
                 are not small differences of large ones. To have the solution as it is, set accept_inaccurate."
            }
            Self::Inaccurate { .. } => {
                "Allow more intervals and meshes, or use order six; an error estimate near 1 means that the solution may be \
                 spurious. To have the solution as it is, set accept_inaccurate."
            }
            Self::WorkLimit { .. } => {
                "Allow more work, improve the guess, or continue from an easier parameter; what is slow to converge may have \
                 no solution."
            }
            Self::Cancelled => "Nothing: the caller asked for it.",
        }
    }

    /// Whether the call was stopped from outside or by its work limit, so that nothing else is to be tried.
    pub(crate) fn is_interruption(&self) -> bool {
        matches!(self, Self::Cancelled | Self::WorkLimit { .. })
    }
}

impl NewtonError {
    /// What to try.
    pub fn advice(&self) -> &'static str {
        match self {
            Self::NonFinite(_) => {
                "The guess, or every step from it, leaves the domain of the equations. Guess values inside it, or rewrite the \
                 right-hand side so that it is defined nearby; at a singular end give the limit."
            }
            Self::Singular { empty_equations, .. } if !empty_equations.is_empty() => {
                "A boundary equation depends on no unknown: correct it."
            }
            Self::Singular { .. } => {
                "The boundary equations do not determine the components named. A phase or scale may be free (add a condition), a \
                 condition may be stated twice, or the branch turns round here: trace it by arclength."
            }
            Self::Stalled { .. } => {
                "There may be no solution near the guess, or the equations may have a kink. Improve the guess, continue from an \
                 easier parameter, or use solve_automatically."
            }
            Self::IterationLimit { .. } => {
                "The iteration was still moving: allow more iterations, improve the guess, or continue from an easier parameter."
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::shown;

    #[test]
    fn positions_are_shown_without_noise() {
        let wanted = [
            (3.0 * 0.0125 + f64::EPSILON, "0.0375"),
            (1.0 - 1e-7, "0.9999999"),
            (0.0, "0"),
            (-1e-12, "-0.000000000001"),
        ];
        for (position, text) in wanted {
            assert_eq!(shown(position).to_string(), text);
        }
    }
}
