//! LU with partial pivoting by nalgebra, for builds without the feature `faer`.

use nalgebra::{DMatrix, DVector, DVectorViewMut, Dyn, LU};

/// `P A = L U` of a square matrix: L below the diagonal (unit diagonal not stored), U above.
#[derive(Debug, Clone)]
pub(super) struct Factors(LU<f64, Dyn, Dyn>);

impl Factors {
    /// Factors `a` (by rows, `n * n`) and says in `rows` which of its rows stands where.
    pub(super) fn of(n: usize, a: &[f64], rows: &mut Vec<usize>, _earlier: Option<Self>) -> Self {
        let lu = DMatrix::from_row_slice(n, n, a).lu();
        let mut order = DVector::from_iterator(n, 0..n);
        lu.p().permute_rows(&mut order);
        rows.clear();
        rows.extend(order.iter());
        Self(lu)
    }

    /// Entry of U on the diagonal.
    pub(super) fn pivot(&self, i: usize) -> f64 {
        self.0.lu_internal()[(i, i)]
    }

    /// Solves `L U x = b` in place. A pivot that is zero leaves `b` as it stands there; it is seen in the rank.
    pub(super) fn solve(&self, b: &mut [f64]) {
        let n = b.len();
        let mut column = DVectorViewMut::from_slice(b, n);
        self.0.lu_internal().solve_lower_triangular_with_diag_mut(&mut column, 1.0);
        self.0.lu_internal().solve_upper_triangular_mut(&mut column);
    }

    /// Solves `(L U)ᵀ x = b` in place.
    pub(super) fn solve_transposed(&self, b: &mut [f64]) {
        let n = b.len();
        let factors = self.0.lu_internal();
        let mut column = DVectorViewMut::from_slice(b, n);
        factors.tr_solve_upper_triangular_mut(&mut column);
        // nalgebra's substitution with L would divide by the diagonal, which is U's: L has ones there.
        for i in (0..n).rev() {
            let below: f64 = (i + 1..n).map(|row| factors[(row, i)] * column[row]).sum();
            column[i] -= below;
        }
    }
}
