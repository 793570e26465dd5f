//! LU with partial pivoting by the library that is faster for the size: see the table in the guide's section "Cost".

use super::{by_faer, by_nalgebra};

/// Unknowns up to which nalgebra is faster.
const FEW: usize = 20;

/// `P A = L U` of a square matrix.
#[derive(Debug, Clone)]
pub(super) enum Factors {
    Few(by_nalgebra::Factors),
    Many(by_faer::Factors),
}

impl Factors {
    /// Factors `a` (by rows, `n * n`) and says in `rows` which of its rows stands where; reuses earlier factors'
    /// memory.
    pub(super) fn of(n: usize, a: &[f64], rows: &mut Vec<usize>, earlier: Option<Self>) -> Self {
        if n <= FEW {
            return Self::Few(by_nalgebra::Factors::of(n, a, rows, None));
        }
        let earlier = match earlier {
            Some(Self::Many(factors)) => Some(factors),
            Some(Self::Few(_)) | None => None,
        };
        Self::Many(by_faer::Factors::of(n, a, rows, earlier))
    }

    /// Entry of U on the diagonal.
    pub(super) fn pivot(&self, i: usize) -> f64 {
        match self {
            Self::Few(factors) => factors.pivot(i),
            Self::Many(factors) => factors.pivot(i),
        }
    }

    /// Solves `L U x = b` in place.
    pub(super) fn solve(&self, b: &mut [f64]) {
        match self {
            Self::Few(factors) => factors.solve(b),
            Self::Many(factors) => factors.solve(b),
        }
    }

    /// Solves `(L U)ᵀ x = b` in place.
    pub(super) fn solve_transposed(&self, b: &mut [f64]) {
        match self {
            Self::Few(factors) => factors.solve_transposed(b),
            Self::Many(factors) => factors.solve_transposed(b),
        }
    }
}
