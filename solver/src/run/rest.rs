//! Solutions at rest: zero, or an equilibrium.
//!
//! An eigenvalue is what it is for solutions other than zero only, a period for what is no equilibrium. Where the
//! iteration came from, they were determined, so that it may end there all the same, with a constant that is arbitrary.

use super::Run;
use crate::collocation::System;
use crate::collocation::evaluate::Derivatives;
use crate::collocation::factor::Factorisation;
use crate::collocation::grid::intervals;
use crate::error::NewtonError;
use crate::newton::Converged;
use crate::problem::Problem;

/// Corrections of a solution at rest, each the square of the one before, until it is exact to rounding.
const CORRECTIONS: usize = 4;
/// Corrections no larger than this, in typical magnitudes, are rounding.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

impl<P: Problem + ?Sized> Run<'_, '_, P> {
    /// What a solution at rest leaves undetermined of the unknown constants, if it is one and does. What is left of the
    /// iteration's error seems to determine them, and is corrected first.
    pub(super) fn undetermined_at_rest(
        &mut self,
        system: &System<'_, P>,
        converged: &Converged,
    ) -> Option<NewtonError> {
        let unknowns = !self.plan.unknowns.is_empty();
        if !(self.needs_determined && unknowns && converged.rests(self.options.tolerance)) {
            return None;
        }
        let (mut x, mut work, mut factorisation) = (converged.x.clone(), system.work(), Factorisation::new(system));
        // What elimination makes of singular values that are zero.
        let least = intervals(&system.grids) as f64 * f64::EPSILON;
        for correction in 0..CORRECTIONS {
            // Corrections that lead to where nothing is defined say nothing.
            system.evaluate(&x, Derivatives::Planned, &mut work, &mut self.stats).ok()?;
            factorisation.factor(system, &work, system.scales(&x));
            self.stats.factorisations += 1;
            if let Err(error) = factorisation.determined_to(system, least) {
                return Some(error);
            }
            let dx = factorisation.newton_correction(system, &work);
            self.stats.linear_solves += 1;
            // Rounding may be all that the first finds, and seem to determine them still.
            if correction > 0 && !(system.largest(&dx) > ROUNDING) {
                return None;
            }
            x = system.stepped(&x, &factorisation.scales, 1.0, &dx);
        }
        // What is corrected by its own size each time is rounding about zero, and determines what zero does.
        system.evaluate(&x, Derivatives::Planned, &mut work, &mut self.stats).ok()?;
        factorisation.factor(system, &work, converged.factorisation.scales.clone());
        self.stats.factorisations += 1;
        factorisation.determined_to(system, least).err()
    }
}
