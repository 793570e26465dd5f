//! Why Newton's iteration failed: values that are not finite, matrices that determine too little, corrections too
//! large.

use crate::problem::{Layout, Points, Region};
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

/// What a row of the kernel is.
pub(crate) fn quantity(region: &Region, row: usize) -> String {
    match row.checked_sub(region.states.len()) {
        None => format!("the right-hand side of {}", region.states[row].name),
        Some(integral) => format!("the integrand of {}", region.integrals[integral]),
    }
}

impl NonFinite {
    pub(crate) fn value(layout: &Layout, region: usize, at: &Points<'_>, f: &[f64]) -> Self {
        let (row, point, value) = locate(at, f);
        let region = &layout.regions[region];
        Self::at_point(region, quantity(region, row), at, point, value)
    }

    pub(crate) fn derivative(layout: &Layout, region: usize, at: &Points<'_>, dy: &[f64]) -> Self {
        let (entry, point, value) = locate(at, dy);
        let region = &layout.regions[region];
        let (row, state) = region.state_pattern[entry];
        let (of, state) = (quantity(region, row), &region.states[state].name);
        let quantity = format!("the derivative of {of} with respect to {state}");
        Self::at_point(region, quantity, at, point, value)
    }

    fn at_point(region: &Region, quantity: String, at: &Points<'_>, point: usize, value: f64) -> Self {
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
    /// Coefficients of the linearised equations are not finite: the iterate is so large that they overflow.
    #[error("the linearised equations overflow: their coefficients are not finite")]
    Overflow,
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

impl NewtonError {
    /// What to try.
    pub fn advice(&self) -> &'static str {
        match self {
            Self::NonFinite(_) => {
                "The guess, or every step from it, leaves the domain of the equations. Guess values inside it, or \
                 rewrite the right-hand side so that it is defined nearby. At an end at which the equations are \
                 singular, use Order::Eight, which needs no value there (as Order::SixGauss), state S y/(x - a) by \
                 Bvp::singular_term, or give the limit. solve_automatically comes from a problem that the guess \
                 solves."
            }
            Self::Singular { empty_equations, .. } if !empty_equations.is_empty() => {
                "A boundary equation depends on no unknown: correct it. If derivatives are differences, it may only \
                 seem so: where values are very large, state their sizes by Bvp::typical."
            }
            Self::Singular { .. } => {
                "The boundary equations do not determine the components named. A phase or scale may be free (add a \
                 condition), a condition may be stated twice, the iteration may have come to rest, where no period and \
                 no eigenvalue is determined (guess a larger amplitude), or the branch turns round here: trace it by \
                 arclength."
            }
            Self::Overflow => {
                "The guess, or an iterate, is far too large for the equations, as an exponential of hundreds is: guess \
                 smaller values, scale the equations, or use solve_automatically."
            }
            Self::Stalled { .. } => {
                "There may be no solution near the guess, or the equations may have a kink. Improve the guess, \
                 continue from an easier parameter, or use solve_automatically. If derivatives are written by hand, \
                 check_derivatives says whether they are right."
            }
            Self::IterationLimit { .. } => {
                "The iteration was still moving: allow more iterations, improve the guess, continue from an easier \
                 parameter, or use solve_automatically."
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
