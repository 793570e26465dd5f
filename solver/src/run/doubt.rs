//! Solutions of linear problems that only seem to be some.
//!
//! The determinant of a linear problem has one sign. Where two meshes have found different ones, the problem is nearly
//! singular: defects change what is left of the determinant by more than that is, and the error that is estimated with
//! it may be far too small; or rounding errors do.

use super::Run;
use crate::accuracy::Shortfall;
use crate::collocation::grid::Grid;
use crate::options::Control;
use crate::orientation::BranchCheck;
use crate::phase::Finding;
use crate::problem::Problem;
use crate::progress::Found;
use crate::start::{Start, transfer, twice};

/// What is to be thought of a solution that would do.
pub(super) enum Doubt {
    /// That it is one.
    None,
    /// That it is to be found anew, from here.
    Again(Start),
    /// That its error may be larger than what is estimated, for this reason, and cannot be made smaller.
    Inaccurate(Shortfall),
}

/// Rounding that changes a solution by this, in typical magnitudes, makes it none.
const DROWNED: f64 = 1e-4;

impl<P: Problem + ?Sized> Run<'_, '_, P> {
    /// Whether a linear problem's solution that would do is one. It is found anew on the meshes halved, if there may be
    /// `more` of them, as long as these have changed the sign of the determinant.
    pub(super) fn doubt(&mut self, found: &mut Found<'_, P>, finding: Finding, more: bool) -> Doubt {
        let Found::Solved(solved) = found else { return Doubt::None };
        let would_do = matches!(finding, Finding::Good | Finding::Oversized);
        let has_turned = matches!(self.check, BranchCheck::Turned { .. });
        if !(would_do && has_turned && solved.converged.linear && self.options.control == Control::Error) {
            return Doubt::None;
        }
        let rounding = solved.reaction(f64::EPSILON, &mut self.stats);
        if rounding > self.options.tolerance.max(DROWNED) {
            solved.expect_error(rounding);
            return Doubt::Inaccurate(Shortfall::Rounding);
        }
        if !self.turned {
            return Doubt::None;
        }
        let fits = |grid: &Grid| 2 * grid.intervals() <= self.options.max_intervals;
        if more && solved.system.grids.iter().all(fits) {
            return Doubt::Again(transfer(solved, twice(solved)));
        }
        solved.expect_error(1.0);
        Doubt::Inaccurate(Shortfall::Mesh)
    }
}
