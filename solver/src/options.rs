//! What a solve may be told.

use crate::budget::Cancel;
use crate::error::SolveError;
use crate::tableau::{ORDER_4, ORDER_6, Tableau};

/// Order of the collocation method: of node values, dense output and integrals where the solution is smooth.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Order {
    /// Three-stage Lobatto IIIA: for right-hand sides with kinks, and for low accuracy.
    #[default]
    Four,
    /// Five-stage mono-implicit Runge-Kutta: fewer intervals where the solution is smooth.
    Six,
}

impl Order {
    /// As a number.
    pub fn number(self) -> usize {
        self.tableau().order
    }

    pub(crate) fn tableau(self) -> &'static Tableau {
        match self {
            Self::Four => &ORDER_4,
            Self::Six => &ORDER_6,
        }
    }
}

/// What the tolerance bounds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Control {
    /// The defect.
    Defect,
    /// The defect, and where that is not enough also the estimated true error: the defect is then held to less, as far
    /// as the mesh may grow and rounding allows. A solution whose error could not be brought down says so, and how
    /// inaccurate it is: [`Solution::accuracy`](crate::Solution::accuracy).
    #[default]
    Error,
}

/// Tolerances and limits.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// Order of the method.
    pub order: Order,
    /// What `tolerance` bounds.
    pub control: Control,
    /// Largest relative defect of the solution; see [`Solution::max_defect`](crate::Solution::max_defect).
    pub tolerance: f64,
    /// Largest boundary residual, relative to the largest term of its equation. Default: as `tolerance`.
    pub boundary_tolerance: Option<f64>,
    /// Largest component of the last Newton correction, relative to typical magnitudes. Default: a hundredth of
    /// `tolerance`, but at least 1e-13.
    pub newton_tolerance: Option<f64>,
    /// Newton iterations on one mesh.
    pub max_iterations: usize,
    /// Damping factor below which Newton's iteration counts as stalled.
    pub smallest_damping: f64,
    /// Intervals of one region.
    pub max_intervals: usize,
    /// Meshes in one solve.
    pub max_meshes: usize,
    /// How often meshes are halved when Newton's iteration fails on them. If that does not help, and unless this is 0,
    /// the iteration starts again without insisting on progress at every step.
    pub rescues: usize,
    /// Points at which the right-hand side may be evaluated, with its derivatives or without
    /// ([`Stats::points`](crate::Stats::points)), by the whole call: by all meshes of a solve, all steps of a continuation,
    /// all attempts of an automatic solve. Beyond it the call ends with [`SolveError::WorkLimit`]. Default: 1000 times
    /// `max_intervals`, which a few seconds suffice for.
    pub work_limit: Option<usize>,
    /// Ends the whole call from outside, with [`SolveError::Cancelled`]. Default: none.
    pub cancel: Option<Cancel>,
}

/// Points that each interval a region may have stands for in the default of the work limit.
const POINTS_PER_INTERVAL: usize = 1000;

impl Default for Options {
    fn default() -> Self {
        Self {
            order: Order::default(),
            control: Control::default(),
            tolerance: 1e-6,
            boundary_tolerance: None,
            newton_tolerance: None,
            max_iterations: 50,
            smallest_damping: 1e-5,
            max_intervals: 20_000,
            max_meshes: 40,
            rescues: 2,
            work_limit: None,
            cancel: None,
        }
    }
}

impl Options {
    /// The boundary tolerance in force.
    pub fn boundary_tolerance(&self) -> f64 {
        self.boundary_tolerance.unwrap_or(self.tolerance)
    }

    /// The Newton tolerance in force.
    pub fn newton_tolerance(&self) -> f64 {
        self.newton_tolerance.unwrap_or_else(|| (0.01 * self.tolerance).max(1e-13))
    }

    /// The work limit in force.
    pub fn work_limit(&self) -> usize {
        self.work_limit.unwrap_or_else(|| POINTS_PER_INTERVAL.saturating_mul(self.max_intervals))
    }

    /// Corrections of this size are accepted where rounding prevents smaller ones.
    pub(crate) fn stagnation_tolerance(&self) -> f64 {
        self.newton_tolerance.unwrap_or(0.1 * self.tolerance)
    }

    pub(crate) fn check(&self) -> Result<(), SolveError> {
        let positive = [
            ("tolerance", self.tolerance),
            ("boundary_tolerance", self.boundary_tolerance()),
            ("newton_tolerance", self.newton_tolerance()),
            ("smallest_damping", self.smallest_damping),
        ];
        for (name, value) in positive {
            if !(value.is_finite() && value > 0.0) {
                return Err(SolveError::Option { name, value, expected: "a positive number" });
            }
        }
        for (name, value) in [("max_iterations", self.max_iterations), ("max_meshes", self.max_meshes)] {
            if value == 0 {
                return Err(SolveError::Option { name, value: 0.0, expected: "at least 1" });
            }
        }
        Ok(())
    }
}
