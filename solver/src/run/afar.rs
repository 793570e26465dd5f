//! A guess on fine meshes that is far from the solution: most of the way is gone on coarse ones.

use super::Run;
use crate::collocation::grid::Grid;
use crate::error::SolveError;
use crate::measure::intervals;
use crate::mesh::thinned;
use crate::options::{Control, Options};
use crate::problem::Problem;
use crate::refine::FEWEST;
use crate::start::{Start, on};

/// A first correction of more than this, in typical magnitudes, says that a guess is far: what follows takes many
/// iterations.
const FAR: f64 = 0.1;
/// What the coarse meshes are to meet. For a tighter tolerance, meshes are as many times as fine as its order says.
const ROUGH: f64 = 1e-3;
/// Fewer intervals, all regions together, are no trouble.
const MANY: usize = 200;

impl<P: Problem + ?Sized> Run<'_, '_, P> {
    /// The size of a first correction at which the iteration from a guess is given up for one on coarse meshes.
    pub(super) fn far(&self, grids: &[Grid]) -> f64 {
        let worthwhile = self.from_afar && intervals(grids) >= MANY && self.stride() >= 2;
        if worthwhile { FAR } else { f64::INFINITY }
    }

    /// Of so many nodes one is enough for [`ROUGH`].
    fn stride(&self) -> usize {
        libm::pow(ROUGH / self.options.tolerance, 1.0 / self.tableau().defect_order) as usize
    }

    /// The solution on coarse meshes; where none is found, the guess again.
    ///
    /// # Errors
    /// Only those that end the solve at once.
    pub(super) fn approached(&mut self, guess: Start) -> Result<Start, SolveError> {
        self.from_afar = false;
        let stride = self.stride();
        let coarse = on(&guess, guess.grids.iter().map(|grid| thinned(&grid.mesh, stride, FEWEST)).collect());
        let options =
            Options { control: Control::Defect, rescues: 0, other_orders: false, ..self.options.loosened(ROUGH) };
        let mut run = Run::new(self.problem, (*self.plan).clone(), &options, &mut *self.observer, self.budget);
        (run.stats, run.history) = (self.stats, std::mem::take(&mut self.history));
        let outcome = run.refine(coarse);
        let (check, orientation) = (run.check, run.orientation);
        // What is counted here is charged here.
        (self.stats, self.history) = (std::mem::take(&mut run.stats), std::mem::take(&mut run.history));
        match outcome {
            Ok(solved) => {
                (self.check, self.orientation) = (self.check.and(check), orientation);
                Ok(Start { grids: solved.system.grids, x: solved.converged.x })
            }
            Err(error @ (SolveError::Cancelled | SolveError::WorkLimit { .. })) => Err(error),
            Err(_) => Ok(guess),
        }
    }
}
