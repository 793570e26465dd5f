//! A term `S y/(x - a)` that is singular at the left end, as bvp4c's `SingularTerm`.
//!
//! Problems of this kind come from symmetry about an axis or a centre. Their solutions are smooth where `S y(a) = 0`,
//! and then `y'(a) = (I - S)⁻¹ f(a, y(a))`, by de l'Hôpital's rule; collocation keeps its order (F. de Hoog and R.
//! Weiss, SIAM J. Numer. Anal. 13 (1976) 775-813).

use nalgebra::DMatrix;
use thiserror::Error;

/// Why a matrix cannot stand in a singular term.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum SingularTermError {
    /// It has not as many rows and columns as there are states.
    #[error("the matrix of the singular term must have {states} rows and columns, one for each state")]
    Shape {
        /// States of the problem.
        states: usize,
    },
    /// A number of it is NaN or infinite.
    #[error("the matrix of the singular term holds a number that is not finite")]
    NotFinite,
    /// It has the eigenvalue 1: the slope at the singular end is not determined.
    #[error(
        "the matrix of the singular term has the eigenvalue 1, so that nothing determines the slope at the singular \
         end: solutions are not smooth there, or another variable suits the problem better"
    )]
    EigenvalueOne,
}

/// `S` and `(I - S)⁻¹`, by rows.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct SingularTerm {
    n: usize,
    matrix: Vec<f64>,
    limit: Vec<f64>,
}

impl SingularTerm {
    pub(super) fn new(n: usize, rows: &[&[f64]]) -> Result<Self, SingularTermError> {
        if rows.len() != n || rows.iter().any(|row| row.len() != n) {
            return Err(SingularTermError::Shape { states: n });
        }
        let matrix = rows.concat();
        if matrix.iter().any(|value| !value.is_finite()) {
            return Err(SingularTermError::NotFinite);
        }
        let rest = DMatrix::identity(n, n) - DMatrix::from_row_slice(n, n, &matrix);
        let size = rest.amax().max(1.0);
        let inverse = rest.try_inverse().filter(|inverse| inverse.amax() * size < 1e13);
        let limit = inverse.ok_or(SingularTermError::EigenvalueOne)?.transpose().as_slice().to_vec();
        Ok(Self { n, matrix, limit })
    }

    /// Makes of `f(x, y)` the whole right-hand side, at a distance from the singular end.
    pub(super) fn complete(&self, distance: f64, y: &[f64], f: &mut [f64]) {
        if distance == 0.0 {
            self.to_limit(f);
            return;
        }
        for (f, row) in f.iter_mut().zip(self.matrix.chunks_exact(self.n)) {
            *f += row.iter().zip(y).map(|(s, y)| s * y).sum::<f64>() / distance;
        }
    }

    /// The same for the derivatives, by columns: `states` of them first, then those of the parameters.
    pub(super) fn complete_derivatives(&self, distance: f64, columns: &mut [f64]) {
        for (column, values) in columns.chunks_exact_mut(self.n).enumerate() {
            if distance == 0.0 {
                self.to_limit(values);
            } else if column < self.n {
                let entries = self.matrix.iter().skip(column).step_by(self.n);
                values.iter_mut().zip(entries).for_each(|(value, s)| *value += s / distance);
            }
        }
    }

    fn to_limit(&self, values: &mut [f64]) {
        let product = |row: &[f64]| row.iter().zip(values.iter()).map(|(a, b)| a * b).sum::<f64>();
        let limit: Vec<f64> = self.limit.chunks_exact(self.n).map(product).collect();
        values.copy_from_slice(&limit);
    }
}
