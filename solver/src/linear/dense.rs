//! A small dense system by Gaussian elimination with complete pivoting: the pivots reveal the rank.

/// `P S A Q = L U` of a square matrix, `S` the row scaling that makes each row's largest entry 1.
#[derive(Debug, Clone, Default)]
pub(crate) struct Lu {
    n: usize,
    /// L below the diagonal (unit diagonal not stored), U above, by rows.
    a: Vec<f64>,
    /// Scaling of the rows, in the original order.
    scale: Vec<f64>,
    rows: Vec<usize>,
    columns: Vec<usize>,
    rank: usize,
}

/// Pivots smaller than this times the largest count as zero.
const RANK: f64 = 4.0 * f64::EPSILON;

impl Lu {
    /// Factors `a` (by rows, `n * n`); reuses the memory of an earlier factorisation.
    pub(crate) fn factor(&mut self, n: usize, a: &[f64]) {
        self.n = n;
        self.a.clear();
        self.a.extend_from_slice(&a[..n * n]);
        self.rows = (0..n).collect();
        self.columns = (0..n).collect();
        self.scale.clear();
        for row in self.a.chunks_exact_mut(n.max(1)) {
            let largest = row.iter().fold(0.0_f64, |max, x| max.max(x.abs()));
            let factor = if largest > 0.0 && largest.is_finite() { 1.0 / largest } else { 1.0 };
            row.iter_mut().for_each(|x| *x *= factor);
            self.scale.push(factor);
        }
        self.rank = n;
        let mut first = 0.0;
        for step in 0..n {
            let (row, column, pivot) = self.largest_from(step);
            if step == 0 {
                first = pivot;
            }
            // Written so that a NaN too counts as rank loss.
            if !(pivot > RANK * first && pivot.is_finite()) {
                self.rank = step;
                return;
            }
            self.swap(step, row, column);
            self.eliminate(step);
        }
    }

    fn largest_from(&self, step: usize) -> (usize, usize, f64) {
        let n = self.n;
        let mut best = (step, step, 0.0);
        for row in step..n {
            let entries = &self.a[row * n + step..(row + 1) * n];
            let largest = entries.iter().fold(0.0_f64, |max, x| max.max(x.abs()));
            if largest > best.2 {
                best = (row, step, largest);
            }
        }
        let entries = &self.a[best.0 * n + step..(best.0 + 1) * n];
        best.1 += entries.iter().position(|x| x.abs() == best.2).unwrap_or(0);
        best
    }

    fn swap(&mut self, step: usize, row: usize, column: usize) {
        let n = self.n;
        if row != step {
            let (upper, lower) = self.a.split_at_mut(row * n);
            upper[step * n..(step + 1) * n].swap_with_slice(&mut lower[..n]);
            self.rows.swap(step, row);
        }
        if column != step {
            self.a.chunks_exact_mut(n).for_each(|entries| entries.swap(step, column));
            self.columns.swap(step, column);
        }
    }

    fn eliminate(&mut self, step: usize) {
        let n = self.n;
        let (upper, lower) = self.a.split_at_mut((step + 1) * n);
        let pivot_row = &upper[step * n..];
        let inverse = 1.0 / pivot_row[step];
        for row in lower.chunks_exact_mut(n) {
            let factor = row[step] * inverse;
            row[step] = factor;
            if factor != 0.0 {
                for (x, &above) in row[step + 1..].iter_mut().zip(&pivot_row[step + 1..]) {
                    *x -= factor * above;
                }
            }
        }
    }

    /// Number of pivots that are not zero.
    pub(crate) fn rank(&self) -> usize {
        self.rank
    }

    /// Row scaling of the matrix last factored: reciprocals of the rows' largest entries.
    pub(crate) fn row_scale(&self) -> &[f64] {
        &self.scale
    }

    /// Solves in place. Meaningful only at full rank.
    pub(crate) fn solve(&self, b: &mut [f64], scratch: &mut Vec<f64>) {
        let n = self.n;
        scratch.clear();
        scratch.extend(self.rows.iter().map(|&row| b[row] * self.scale[row]));
        for i in 0..n {
            let sum: f64 = self.a[i * n..i * n + i].iter().zip(&scratch[..i]).map(|(a, x)| a * x).sum();
            scratch[i] -= sum;
        }
        for i in (0..n).rev() {
            let row = &self.a[i * n..(i + 1) * n];
            let sum: f64 = row[i + 1..].iter().zip(&scratch[i + 1..]).map(|(a, x)| a * x).sum();
            scratch[i] = (scratch[i] - sum) / row[i];
        }
        for (&column, &x) in self.columns.iter().zip(scratch.iter()) {
            b[column] = x;
        }
    }

    /// Solves the transposed system in place. Meaningful only at full rank.
    pub(crate) fn solve_transposed(&self, b: &mut [f64], scratch: &mut Vec<f64>) {
        let n = self.n;
        scratch.clear();
        scratch.extend(self.columns.iter().map(|&column| b[column]));
        for i in 0..n {
            scratch[i] /= self.a[i * n + i];
            for l in i + 1..n {
                scratch[l] -= self.a[i * n + l] * scratch[i];
            }
        }
        for i in (0..n).rev() {
            for l in 0..i {
                scratch[l] -= self.a[i * n + l] * scratch[i];
            }
        }
        for (&row, &x) in self.rows.iter().zip(scratch.iter()) {
            b[row] = x * self.scale[row];
        }
    }

    /// A vector that the rank-deficient matrix maps to (nearly) zero, largest component 1.
    pub(crate) fn null_vector(&self) -> Vec<f64> {
        let (n, rank) = (self.n, self.rank);
        let mut x = vec![0.0; n];
        if rank >= n {
            return x;
        }
        let mut z = vec![0.0; n];
        z[rank] = 1.0;
        for i in (0..rank).rev() {
            let row = &self.a[i * n..(i + 1) * n];
            let sum: f64 = row[i + 1..=rank].iter().zip(&z[i + 1..=rank]).map(|(a, x)| a * x).sum();
            z[i] = -sum / row[i];
        }
        let largest = z.iter().fold(0.0_f64, |max, x| max.max(x.abs()));
        for (&column, &value) in self.columns.iter().zip(&z) {
            x[column] = value / largest;
        }
        x
    }
}
