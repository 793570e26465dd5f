//! Forty-eight two-point, multi-point, eigenvalue and fold problems with reference values.
//!
//! Equations here; reference values and their provenance in `tests/data/bvp-testset.json`.

pub mod catalogue;
pub mod folds;
pub mod linear;
pub mod nonlinear;
pub mod run;
pub mod special;
pub mod structured;

use catalogue::Case;

/// Every problem that is solved at given parameters; those whose reference is a fold are in [`folds`].
pub fn cases() -> Vec<Case> {
    linear::cases().into_iter().chain(nonlinear::cases()).chain(structured::cases()).collect()
}

/// The problems whose reference is a fold.
pub fn folds() -> Vec<Case> {
    nonlinear::fold_cases()
}
