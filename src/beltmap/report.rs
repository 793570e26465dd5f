//! How a map was made, and how accurate it is.

use super::quantity::Quantity;
use serde::{Deserialize, Serialize};

/// How a map was made, and how accurate it is.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// The error that was asked for: of forces, torques, speeds and radii over their size (at least a tenth of their
    /// largest on the map), of shares as they are.
    pub accuracy: f64,
    /// Whether the error at every check point is within it.
    pub reached: bool,
    /// The error at check points.
    pub error: ErrorReport,
    /// The same where the table is read by linear interpolation, without its derivatives.
    pub linear_error: ErrorReport,
    /// Solved points that took no part in the construction, at least one in each cell that has values.
    pub checks: usize,
    /// Points of the grid.
    pub nodes: usize,
    /// Nodes with a solution short of the slip limit.
    pub solved: usize,
    /// Nodes beyond the slip limit.
    pub slipping: usize,
    /// Nodes without a solution: far beyond the slip limit, or not found.
    pub unsolved: usize,
    /// Nodes without a drive.
    pub no_drive: usize,
    /// Cells of the grid.
    pub cells: usize,
    /// Cells that have values.
    pub usable_cells: usize,
    /// Speed efficiency below which a drive counts as slipping.
    pub least_speed_efficiency: f64,
    /// Relative tolerance of the solutions.
    pub tolerance: f64,
    /// Rounds of refinement.
    pub rounds: usize,
}

/// Errors at check points: each the largest of all quantities there.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct ErrorReport {
    /// The largest.
    pub largest: f64,
    /// Half of the check points have no larger one.
    pub median: f64,
    /// Nine in ten have no larger one.
    pub q90: f64,
    /// Ninety-nine in a hundred have no larger one.
    pub q99: f64,
    /// The largest of each quantity.
    pub by_quantity: Vec<QuantityError>,
}

/// The largest error of a quantity.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct QuantityError {
    /// Its name.
    pub name: String,
    /// The largest error.
    pub largest: f64,
}

impl ErrorReport {
    /// Of errors point by point, each with one a quantity.
    pub(super) fn of(quantities: &[Quantity], errors: &[Vec<f64>]) -> Self {
        let mut worst: Vec<f64> = errors.iter().map(|errors| errors.iter().copied().fold(0.0, f64::max)).collect();
        worst.sort_by(f64::total_cmp);
        let last = worst.len().saturating_sub(1);
        let quantile = |share: f64| worst.get((share * last as f64).ceil() as usize).copied().unwrap_or(f64::NAN);
        let of = |(at, quantity): (usize, &Quantity)| QuantityError {
            name: quantity.name().to_owned(),
            largest: errors.iter().filter_map(|errors| errors.get(at)).copied().fold(0.0, f64::max),
        };
        Self {
            largest: quantile(1.0),
            median: quantile(0.5),
            q90: quantile(0.9),
            q99: quantile(0.99),
            by_quantity: quantities.iter().enumerate().map(of).collect(),
        }
    }
}
