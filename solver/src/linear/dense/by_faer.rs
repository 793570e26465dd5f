//! LU with partial pivoting by faer, in one thread.

use faer::linalg::lu::partial_pivoting::factor::{lu_in_place, lu_in_place_scratch};
use faer::linalg::triangular_solve as triangular;
use faer::{Mat, MatMut, MatRef, Par, Spec};

/// `P A = L U` of a square matrix: L below the diagonal (unit diagonal not stored), U above.
#[derive(Debug, Clone)]
pub(super) struct Factors(Mat<f64>);

impl Factors {
    /// Factors `a` (by rows, `n * n`) and says in `rows` which of its rows stands where; reuses earlier factors'
    /// memory.
    pub(super) fn of(n: usize, a: &[f64], rows: &mut Vec<usize>, earlier: Option<Self>) -> Self {
        let mut factors =
            earlier.map(|Self(old)| old).filter(|old| old.nrows() == n).unwrap_or_else(|| Mat::zeros(n, n));
        factors.copy_from(MatRef::from_row_major_slice(a, n, n));
        rows.resize(n, 0);
        let mut inverse = vec![0; n];
        let mut memory =
            faer::dyn_stack::MemBuffer::new(lu_in_place_scratch::<usize, f64>(n, n, Par::Seq, Spec::default()));
        let stack = faer::dyn_stack::MemStack::new(&mut memory);
        lu_in_place(factors.as_mut(), rows, &mut inverse, Par::Seq, stack, Spec::default());
        Self(factors)
    }

    /// Entry of U on the diagonal.
    pub(super) fn pivot(&self, i: usize) -> f64 {
        self.0[(i, i)]
    }

    /// Solves `L U x = b` in place.
    pub(super) fn solve(&self, b: &mut [f64]) {
        let n = b.len();
        let mut column = MatMut::from_column_major_slice_mut(b, n, 1);
        triangular::solve_unit_lower_triangular_in_place(self.0.as_ref(), column.as_mut(), Par::Seq);
        triangular::solve_upper_triangular_in_place(self.0.as_ref(), column, Par::Seq);
    }

    /// Solves `(L U)ᵀ x = b` in place.
    pub(super) fn solve_transposed(&self, b: &mut [f64]) {
        let n = b.len();
        let mut column = MatMut::from_column_major_slice_mut(b, n, 1);
        let transposed = self.0.as_ref().transpose();
        triangular::solve_lower_triangular_in_place(transposed, column.as_mut(), Par::Seq);
        triangular::solve_unit_upper_triangular_in_place(transposed, column, Par::Seq);
    }
}
