//! How accurately a drive is solved, and how the path to it is followed.

use solver::continuation::PathOptions;
use solver::{Options, Order};

use crate::case::ModelChoices;

/// Tolerance on the path from the start to the case.
pub(super) const ROUGH_TOLERANCE: f64 = 1e-2;
/// The same for a belt without bending stiffness.
const STRING_TOLERANCE: f64 = 1e-3;
/// Newton iterations of a step on the path: where the belt adheres at 1e-5 m/s, kinks travel over the mesh for a while.
const PATH_ITERATIONS: usize = 25;
/// The same for a belt without bending stiffness.
const STRING_ITERATIONS: usize = 30;
/// Damping factor at which a step on the path counts as failed: shorter steps come sooner than such iterations end.
const PATH_DAMPING: f64 = 1e-3;
/// Intervals of a region on the path.
const PATH_INTERVALS: usize = 2000;
/// Smallest step on a stage of the path, as a share of the stage.
const SMALLEST_STEP: f64 = 1e-4;
/// Steps on a stage of the path, accepted or not.
const STAGE_STEPS: usize = 400;

/// Work of a solve, unless asked otherwise: Newton iterations, each counted once for every mesh interval. The base case
/// takes some thousands.
pub const WORK_LIMIT: usize = 6_000_000;

/// How accurately, and with what.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SolveOptions {
    /// Largest relative defect of the solution.
    pub tolerance: f64,
    /// Order of the collocation.
    pub order: Order,
    /// Whether derivatives of the outputs with respect to the given constants are wanted.
    pub sensitivities: bool,
    /// Work that a solve may take, over all that it tries: Newton iterations, each counted once for every interval of
    /// the mesh that it works on.
    pub work_limit: usize,
    /// Whether the errors of the outputs are estimated, and the solution refined until they hold to the tolerance.
    pub uncertainty: bool,
}

impl Default for SolveOptions {
    fn default() -> Self {
        Self { tolerance: 1e-6, order: Order::Four, sensitivities: false, uncertainty: true, work_limit: WORK_LIMIT }
    }
}

impl SolveOptions {
    /// For the solver. What is asked of a belt is that its defects meet the tolerance; where a design amplifies them,
    /// the solver's estimate of the error may exceed it all the same.
    pub(super) fn solver(&self) -> Options {
        let (tolerance, order) = (self.tolerance, self.order);
        let cancel = crate::cancel::current();
        // A drive has ways of its own to a solution; what fails on them are steps across the kinks of friction.
        let options = Options { tolerance, order, cancel, ..Options::default() };
        // Outputs have their own errors estimated, those of their integrals among them: see `accuracy`.
        Options { accept_inaccurate: true, integrals: false, other_orders: false, ..options }
    }
}

/// The solver's, on the path: as rough as that may be, on meshes that stay small.
pub(super) fn rough(options: &SolveOptions) -> Options {
    Options { tolerance: options.tolerance.max(ROUGH_TOLERANCE), max_intervals: PATH_INTERVALS, ..options.solver() }
}

/// How a stage of the path is followed, `solve` being for its end.
pub(super) fn path_options(model: &ModelChoices, solve: Options) -> PathOptions {
    let (tolerance, max_iterations) = match model.bending {
        Some(_) => (ROUGH_TOLERANCE, PATH_ITERATIONS),
        // Nothing smooths a string's way into the groove: coarse meshes miss it, and Newton's iteration takes its time.
        None => (STRING_TOLERANCE, STRING_ITERATIONS),
    };
    let solve = match model.bending {
        Some(_) => Options { smallest_damping: PATH_DAMPING, ..solve },
        None => solve,
    };
    PathOptions {
        solve,
        tolerance,
        max_iterations,
        smallest_step: SMALLEST_STEP,
        max_steps: STAGE_STEPS,
        ..PathOptions::default()
    }
}
