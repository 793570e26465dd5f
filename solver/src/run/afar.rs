//! A guess on fine meshes that is far from the solution: most of the way is gone on coarse ones.

use super::{MANY, Run};
use crate::collocation::Iterate;
use crate::collocation::grid::{Grid, intervals};
use crate::error::SolveError;
use crate::mesh::thinned;
use crate::newton::Far;
use crate::options::{Control, Options};
use crate::problem::Problem;
use crate::progress::{Progress, measured};
use crate::refine::FEWEST;
use crate::start::{Start, on, transfer};

/// When a guess is far: what follows takes many iterations.
const FAR: Far = Far { correction: 0.1, iterations: 3 };
/// What the coarse meshes are to meet. For a tighter tolerance, meshes are as many times as fine as its order says.
const ROUGH: f64 = 1e-3;

impl<'a, P: Problem + ?Sized> Run<'a, '_, P> {
    /// When the iteration from a guess is given up for one on coarse meshes.
    pub(super) fn far(&self, grids: &[Grid]) -> Option<Far> {
        let worthwhile = self.from_afar && intervals(grids) >= MANY && self.stride() >= 2;
        worthwhile.then_some(FAR)
    }

    /// Of so many nodes one is enough for [`ROUGH`].
    fn stride(&self) -> usize {
        libm::pow(ROUGH / self.options.tolerance, 1.0 / self.tableau().defect_order) as usize
    }

    /// The solution on coarse meshes, on finer ones as its defects ask for; where none is found, the guess again.
    /// `nearer`: how far the iteration from the guess has come.
    ///
    /// # Errors
    /// Only those that end the solve at once.
    pub(super) fn approached(
        &mut self,
        guess: Start,
        nearer: Iterate,
        progress: &mut Progress<'a, P>,
    ) -> Result<Start, SolveError> {
        self.from_afar = false;
        let stride = self.stride();
        let nearer = Start { grids: guess.grids.clone(), x: nearer };
        let coarse = on(&nearer, guess.grids.iter().map(|grid| thinned(&grid.mesh, stride, FEWEST)).collect());
        let options =
            Options { control: Control::Defect, rescues: 0, other_orders: false, ..self.options.loosened(ROUGH) };
        let mut run = Run::new(self.problem, (*self.plan).clone(), &options, &mut *self.observer, self.budget);
        (run.stats, run.history) = (self.stats, std::mem::take(&mut self.history));
        let outcome = run.refine(coarse);
        let (check, orientation) = (run.check, run.orientation);
        // What is counted here is charged here.
        (self.stats, self.history) = (std::mem::take(&mut run.stats), std::mem::take(&mut run.history));
        drop(run);
        match outcome {
            Ok(solved) => {
                (self.check, self.orientation) = (self.check.and(check), orientation);
                let target = progress.target;
                let measures = measured(&solved, target, progress.rounding());
                match self.refined(&solved, &measures, target, progress) {
                    Ok(meshes) => Ok(transfer(&solved, meshes)),
                    Err(_) => Ok(Start { grids: solved.system.grids, x: solved.converged.x }),
                }
            }
            Err(error @ (SolveError::Cancelled | SolveError::WorkLimit { .. })) => Err(error),
            Err(_) => Ok(guess),
        }
    }
}
