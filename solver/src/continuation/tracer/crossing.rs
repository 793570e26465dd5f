//! From a branch point onto the branch that crosses there.

use super::Tracer;
use crate::continuation::arclength::{Direction, Reference, normalise};
use crate::continuation::branch::{BranchPoint, PointKind};
use crate::error::SolveError;
use crate::guess::Guess;
use crate::linearisation::Linearisation;
use crate::orientation::Determinant;

impl Tracer<'_, '_> {
    /// The branch point with the direction in which the crossing branch leaves it, to first order and but for a part
    /// along the branch that is known: the null vector of the equations at the parameter's value.
    ///
    /// Pseudo-arclength in that direction has solutions of both branches; the one near the predicted point is on the
    /// crossing branch, since the known one goes elsewhere at the same rate (H. B. Keller, as in
    /// [`arclength`](crate::continuation::arclength), method III).
    pub(in crate::continuation) fn crossing(&mut self, at: &BranchPoint, sign: f64) -> Result<Reference, SolveError> {
        if at.kind != PointKind::BranchPoint {
            return Err(SolveError::Option { name: "point", value: at.parameter, expected: "a branch point" });
        }
        self.check(&Guess::from(&at.solution))?;
        let (tangent, stats) = Linearisation::least_determined(self.problem, &at.solution)?;
        self.budget.charge(&stats);
        self.stats += stats;
        let signed = |values: &Vec<f64>| values.iter().map(|value| sign * value).collect();
        let direction = Direction {
            states: tangent.regions.iter().map(|region| region.states.iter().map(signed).collect()).collect(),
            constants: signed(&tangent.constants),
        };
        let mut reference = Reference::new(at.solution.clone(), direction, Determinant::UNKNOWN);
        normalise(self.problem.layout(), &mut reference);
        Ok(reference)
    }
}
