//! The end of Newton's iteration: a last look at the boundary equations.
//!
//! The iteration ends by the size of its correction. Where the equations are stiff that says little of what is left of
//! a boundary equation over an integral: a friction force changes by its slope times a correction, and the slope is
//! large. Such an iterate is corrected further, with the matrix that is held.

use super::{Newton, NewtonError};
use crate::collocation::Iterate;
use crate::collocation::evaluate::Derivatives;
use crate::problem::Problem;

/// Corrections at most for the sake of the boundary equations.
const CORRECTIONS: usize = 4;
/// What each has to make of their largest residual, relative, to go on.
const CONTRACTION: f64 = 0.5;

impl<P: Problem + ?Sized> Newton<'_, '_, P> {
    /// The iterate whose residual is held, or a better one, whose residual is held then.
    ///
    /// # Errors
    /// [`NewtonError::NonFinite`], if the iterate given cannot be evaluated again.
    pub(super) fn closed(&mut self, mut x: Iterate) -> Result<Iterate, NewtonError> {
        let mut left = self.boundary_residual();
        for _ in 0..CORRECTIONS {
            if left <= self.limits.boundary {
                break;
            }
            let dx = self.correction();
            if !(self.system.largest(&dx) <= self.limits.tolerance) {
                break;
            }
            let trial = self.system.stepped(&x, &self.factorisation.scales, 1.0, &dx);
            let better = self.evaluate(&trial, Derivatives::None).is_ok() && {
                let residual = self.boundary_residual();
                let better = residual <= CONTRACTION * left;
                left = left.min(residual);
                better
            };
            if !better {
                self.evaluate(&x, Derivatives::None).map_err(NewtonError::NonFinite)?;
                break;
            }
            self.stats.simplified_corrections += 1;
            x = trial;
        }
        Ok(x)
    }

    /// The largest residual of the boundary equations, relative to the terms of its equation.
    pub(super) fn boundary_residual(&self) -> f64 {
        let scales = self.own.as_ref().map_or(&self.factorisation.scales, |own| &own.scales);
        self.system.boundary_residuals(&self.work, scales).fold(0.0, f64::max)
    }
}
