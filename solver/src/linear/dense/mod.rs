//! The small dense system that is left for ends and constants: LU with partial pivoting, in one thread, by faer, or by
//! nalgebra where the feature `faer` is off or the unknowns are few.
//!
//! Elimination with complete pivoting would reveal the rank at once, but takes 9, 25 and 57 µs for 30, 44 and 60
//! unknowns where partial pivoting, as called here, takes 5, 16 and 20 µs (x86-64 with AVX2; a substitution 1 to 3 µs
//! either way). A pivot that is small beside the others raises a suspicion; singular values (some 300 µs) then tell.

#[cfg(feature = "faer")]
mod by_either;
#[cfg(feature = "faer")]
mod by_faer;
mod by_nalgebra;

#[cfg(feature = "faer")]
use by_either::Factors;
#[cfg(not(feature = "faer"))]
use by_nalgebra::Factors;
use nalgebra::{DMatrix, Dyn, SVD};

/// `P S A = L U` of a square matrix, `S` the row scaling that makes each row's largest entry 1.
#[derive(Debug, Clone, Default)]
pub(crate) struct Lu {
    /// S A by rows.
    scaled: Vec<f64>,
    /// Scaling of the rows, in the original order.
    scale: Vec<f64>,
    /// L and U.
    factors: Option<Factors>,
    /// Which row stands where.
    rows: Vec<usize>,
    rank: usize,
}

/// A pivot smaller than this times the largest asks for singular values.
const SUSPICIOUS: f64 = 1e-11;
/// Singular values smaller than this times the largest count as zero.
const RANK: f64 = 4.0 * f64::EPSILON;
/// A row has vanished whose largest entry is smaller than this part of the median of those of all rows.
const VANISHED: f64 = 1e-4;
/// Most sweeps of the singular value decomposition.
const SWEEPS: usize = 1000;

impl Lu {
    /// Factors `a` (by rows, `n * n`); reuses the memory of an earlier factorisation.
    pub(crate) fn factor(&mut self, n: usize, a: &[f64]) {
        self.scaled.clear();
        self.scaled.extend_from_slice(&a[..n * n]);
        self.scale.clear();
        for row in self.scaled.chunks_exact_mut(n.max(1)) {
            let largest = row.iter().fold(0.0_f64, |max, x| max.max(x.abs()));
            let factor = if largest > 0.0 && largest.is_finite() { 1.0 / largest } else { 1.0 };
            row.iter_mut().for_each(|x| *x *= factor);
            self.scale.push(factor);
        }
        let factors = Factors::of(n, &self.scaled, &mut self.rows, self.factors.take());
        let pivots = (0..n).map(|i| factors.pivot(i).abs());
        let largest = pivots.clone().fold(0.0, f64::max);
        // Written so that a NaN too is suspicious.
        let sound = pivots.clone().all(|pivot| pivot > SUSPICIOUS * largest && pivot.is_finite());
        self.factors = Some(factors);
        self.rank = if sound { n } else { self.rank_to(RANK) };
    }

    /// Singular values, decreasing, and if wanted the transposed right singular vectors; `None` for a matrix that is
    /// not finite. By nalgebra: faer's decomposition takes half a minute to compile, and this is for diagnosis only.
    fn svd(&self, scaled: &[f64], vectors: bool) -> Option<SVD<f64, Dyn, Dyn>> {
        let n = self.scale.len();
        if n == 0 || scaled.iter().any(|x| !x.is_finite()) {
            return None;
        }
        SVD::try_new(DMatrix::from_row_slice(n, n, scaled), false, vectors, f64::EPSILON, SWEEPS)
    }

    /// The scaled matrix, in which rows that have vanished beside the others stay small: an equation that is a product
    /// vanishes with both factors, and then says nothing, however much its row is scaled.
    fn without_vanished(&self) -> Vec<f64> {
        let mut largest: Vec<f64> = self.scale.iter().map(|scale| 1.0 / scale).collect();
        let mut sorted = largest.clone();
        sorted.sort_by(f64::total_cmp);
        let least = VANISHED * sorted.get(sorted.len() / 2).copied().unwrap_or(0.0);
        largest.iter_mut().for_each(|largest| *largest = if *largest < least { *largest / least } else { 1.0 });
        let rows = self.scaled.chunks_exact(self.size().max(1)).zip(largest);
        rows.flat_map(|(row, share)| row.iter().map(move |x| share * x)).collect()
    }

    /// Number of singular values that are larger than `least` times the largest; 0 for a matrix that is not finite.
    pub(crate) fn rank_to(&self, least: f64) -> usize {
        let Some(svd) = self.svd(&self.scaled, false) else { return 0 };
        let largest = svd.singular_values.max();
        svd.singular_values.iter().filter(|&&value| value > least * largest).count()
    }

    /// Number of singular values that are not zero.
    pub(crate) fn rank(&self) -> usize {
        self.rank
    }

    /// Sign of the determinant of the matrix: 1 or -1; 0 if the rank is deficient.
    pub(crate) fn determinant_sign(&self) -> f64 {
        let Some(factors) = self.factors.as_ref().filter(|_| self.rank == self.size()) else { return 0.0 };
        let pivots: f64 = (0..self.size()).map(|i| factors.pivot(i).signum()).product();
        pivots * permutation_sign(&self.rows)
    }

    /// Logarithm of the determinant's magnitude; of no meaning if the rank is deficient.
    pub(crate) fn determinant_logarithm(&self) -> f64 {
        let Some(factors) = &self.factors else { return f64::NEG_INFINITY };
        let logarithms = self.scale.iter().enumerate().map(|(i, scale)| libm::log(factors.pivot(i).abs() / scale));
        logarithms.sum()
    }

    /// Number of unknowns.
    pub(crate) fn size(&self) -> usize {
        self.scale.len()
    }

    /// Solves in place. Meaningful only at full rank.
    pub(crate) fn solve(&self, b: &mut [f64]) {
        let Some(factors) = &self.factors else { return };
        let mut x: Vec<f64> = self.rows.iter().map(|&row| b[row] * self.scale[row]).collect();
        factors.solve(&mut x);
        b.copy_from_slice(&x);
    }

    /// Solves the transposed system in place. Meaningful only at full rank.
    pub(crate) fn solve_transposed(&self, b: &mut [f64]) {
        let Some(factors) = &self.factors else { return };
        factors.solve_transposed(b);
        let x = b.to_vec();
        for (&row, x) in self.rows.iter().zip(x) {
            b[row] = x * self.scale[row];
        }
    }

    /// The direction that the matrix maps closest to zero, its rows scaled but for those that have vanished: the right
    /// singular vector of the smallest singular value, largest component 1. Zero for a matrix that is not finite.
    pub(crate) fn null_vector(&self) -> Vec<f64> {
        let n = self.scale.len();
        let Some(svd) = self.svd(&self.without_vanished(), true) else { return vec![0.0; n] };
        let (smallest, _) = svd.singular_values.argmin();
        let Some(vectors) = svd.v_t else { return vec![0.0; n] };
        let v: Vec<f64> = vectors.row(smallest).iter().copied().collect();
        let largest = v.iter().fold(0.0, |max: f64, &x| if x.abs() > max.abs() { x } else { max });
        v.iter().map(|x| x / largest).collect()
    }
}

/// 1 for an even permutation, -1 for an odd one: by counting what stands in the wrong order.
fn permutation_sign(rows: &[usize]) -> f64 {
    let inversions = |(place, row): (usize, &usize)| rows[place + 1..].iter().filter(|later| *later < row).count();
    let all: usize = rows.iter().enumerate().map(inversions).sum();
    if all.is_multiple_of(2) { 1.0 } else { -1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_determinant_has_its_sign() {
        let mut lu = Lu::default();
        for (matrix, sign) in [
            ([2.0, 0.0, 0.0, 0.0, 3.0, 0.0, 0.0, 0.0, 4.0], 1.0),
            ([0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0], -1.0),
            ([0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0], 1.0),
            ([1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 10.0], -1.0),
            (DEFICIENT, 0.0),
        ] {
            lu.factor(3, &matrix);
            assert_eq!(lu.determinant_sign(), sign, "{matrix:?}");
        }
        lu.factor(3, &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 10.0]);
        assert!((lu.determinant_logarithm() - 3.0_f64.ln()).abs() < 1e-13);
    }

    /// Rows 0 and 2 are multiples of each other.
    const DEFICIENT: [f64; 9] = [1.0, 2.0, 3.0, 0.0, 1.0, -1.0, 1e5, 2e5, 3e5];

    #[test]
    fn rank_loss_is_seen_and_its_direction() {
        let mut lu = Lu::default();
        lu.factor(3, &DEFICIENT);
        assert_eq!((lu.rank(), lu.size()), (2, 3));
        // (-5, 1, 1) spans the null space.
        for (x, expected) in lu.null_vector().iter().zip([1.0, -0.2, -0.2]) {
            assert!((x - expected).abs() < 1e-12);
        }
        lu.factor(2, &[f64::NAN, 1.0, 1.0, 0.0]);
        assert_eq!((lu.rank(), lu.null_vector()), (0, vec![0.0, 0.0]));
        lu.factor(0, &[]);
        assert_eq!((lu.rank(), lu.null_vector()), (0, vec![]));
        lu.factor(2, &[0.0; 4]);
        assert_eq!(lu.rank(), 0);
    }

    #[test]
    fn a_row_that_has_vanished_leaves_its_direction_open() {
        let mut lu = Lu::default();
        lu.factor(3, &[1.0, 2.0, 0.0, 2.0, 1.0, 0.0, 0.0, 1e-9, 1e-9]);
        assert!(lu.null_vector().iter().zip([0.0, 0.0, 1.0]).all(|(x, expected)| (x - expected).abs() < 1e-4));
        // One of small units says what it says.
        lu.factor(3, &[1.0, 2.0, 3.0, 2.0, 4.0, 6.0, 0.0, 1e-9, -1e-9]);
        assert!(lu.null_vector().iter().zip([1.0, -0.2, -0.2]).all(|(x, expected)| (x - expected).abs() < 1e-4));
    }

    #[test]
    fn an_ill_conditioned_matrix_is_not_called_singular() {
        let mut lu = Lu::default();
        lu.factor(2, &[1.0, 1.0, 1.0, 1.0 + 1e-13]);
        assert_eq!(lu.rank(), 2);
    }

    #[test]
    fn solutions_and_transposed_solutions() {
        let a = [1e-6, 2e-6, 0.5e-6, 3.0, 1.0, -4.0, 200.0, 0.0, 100.0];
        let mut lu = Lu::default();
        lu.factor(3, &a);
        let x = [1.0, -2.0, 3.0];
        let product = |f: &dyn Fn(usize, usize) -> f64| -> Vec<f64> {
            (0..3).map(|i| (0..3).map(|j| f(i, j) * x[j]).sum()).collect()
        };
        let mut b = product(&|i, j| a[3 * i + j]);
        lu.solve(&mut b);
        let mut c = product(&|i, j| a[3 * j + i]);
        lu.solve_transposed(&mut c);
        for i in 0..3 {
            assert!((b[i] - x[i]).abs() < 1e-12);
            // Rows of small entries determine little of the transposed system's solution.
            let largest = a[3 * i..3 * i + 3].iter().fold(0.0, |max: f64, a| max.max(a.abs()));
            assert!((c[i] - x[i]).abs() * largest < 1e-10);
        }
    }

    #[cfg(feature = "faer")]
    #[test]
    fn both_libraries_choose_the_same_pivots_and_find_the_same_solutions() {
        // Columns of very different size, and a different pivot order than that of the rows.
        let n = 23;
        let entry =
            |i: usize, j: usize| ((7 * i * i + 3 * i * j + 5 * j) as f64).sin() * 10_f64.powi((j % 5) as i32 - 2);
        let a: Vec<f64> = (0..n * n).map(|at| entry(at / n, at % n)).collect();
        let (mut ours, mut theirs) = (Vec::new(), Vec::new());
        let by_faer = by_faer::Factors::of(n, &a, &mut ours, None);
        let by_nalgebra = by_nalgebra::Factors::of(n, &a, &mut theirs, None);
        assert_eq!(ours, theirs);
        for i in 0..n {
            let (ours, theirs) = (by_faer.pivot(i), by_nalgebra.pivot(i));
            assert!((ours - theirs).abs() < 1e-10 * ours.abs(), "{i}: {ours} {theirs}");
        }
        assert!(ours.iter().enumerate().any(|(place, row)| place != *row));
        let right: Vec<f64> = (0..n).map(|i| (i as f64).cos()).collect();
        for solve in [
            (
                by_faer::Factors::solve as fn(&by_faer::Factors, &mut [f64]),
                by_nalgebra::Factors::solve as fn(&_, &mut [f64]),
            ),
            (by_faer::Factors::solve_transposed, by_nalgebra::Factors::solve_transposed),
        ] {
            let (mut x, mut y) = (right.clone(), right.clone());
            solve.0(&by_faer, &mut x);
            solve.1(&by_nalgebra, &mut y);
            let largest = x.iter().fold(0.0_f64, |max, x| max.max(x.abs()));
            assert!(x.iter().zip(&y).all(|(x, y)| (x - y).abs() < 1e-10 * largest), "{x:?} {y:?}");
        }
    }
}
