//! From a branch point onto the branch that crosses there.

use super::Tracer;
use crate::continuation::arclength::{Arclength, Direction, Reference, normalise};
use crate::continuation::branch::{BranchPoint, Side};
use crate::error::SolveError;
use crate::guess::Guess;
use crate::linearisation::Linearisation;
use crate::orientation::Determinant;

impl Tracer<'_, '_> {
    /// The branch point with the direction in which the crossing branch leaves it, but for a part along the branch that
    /// is known: what the equations and the distance along the known branch together leave undetermined.
    ///
    /// In that direction the known branch does not move to first order, so that pseudo-arclength in it has a solution
    /// of the crossing branch nearby, and none of the known one. (The null vector of the equations at the parameter's
    /// value will not do: where the solutions of both branches move with the parameter, it lies between the two.)
    /// H. B. Keller, as in [`arclength`](crate::continuation::arclength), method III.
    pub(in crate::continuation) fn crossing(&mut self, at: &BranchPoint, side: Side) -> Result<Reference, SolveError> {
        let sign = match side {
            Side::First => 1.0,
            Side::Second => -1.0,
        };
        let mut guess = Guess::from(&at.solution);
        self.check(&guess)?;
        let Some(known) = at.direction.clone().filter(|direction| direction.fits(&guess)) else {
            return Err(SolveError::Option { name: "point", value: at.parameter, expected: "a branch point" });
        };
        let known = Reference::new(at.solution.clone(), known, Determinant::UNKNOWN);
        let arclength = Arclength::new(self.problem, &known);
        // No distance from it.
        guess.constants.push(0.0);
        let order = at.solution.order();
        let (tangent, stats) = Linearisation::least_determined(&arclength, &guess, &self.extended, order)?;
        self.budget.charge(&stats);
        self.stats += stats;
        let signed = |values: &[f64]| values.iter().map(|value| sign * value).collect();
        let direction = Direction {
            states: tangent.regions.iter().map(|region| region.states.iter().map(|y| signed(y)).collect()).collect(),
            constants: signed(&tangent.constants[..at.solution.constants().len()]),
        };
        let mut reference = Reference::new(at.solution.clone(), direction, Determinant::UNKNOWN);
        reference.is_crossing = true;
        normalise(self.problem.layout(), &mut reference);
        Ok(reference)
    }
}
