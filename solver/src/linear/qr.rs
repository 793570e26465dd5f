//! Small dense systems by Householder reflections: no pivots are chosen, so that several are factored side by side.

use super::scalar::Scalar;

/// Values that [`factor`] needs room for, for `m` unknowns.
pub(crate) const fn room(m: usize) -> usize {
    2 * m * m + m
}

/// `Q R = A`: reflectors, R by columns, reciprocals of R's diagonal.
struct Parts<S> {
    reflectors: S,
    r: S,
    inverse: S,
}

#[inline(always)]
fn parts<T>(m: usize, data: &[T]) -> Parts<&[T]> {
    let (reflectors, rest) = data.split_at(m * m);
    let (r, inverse) = rest.split_at(m * m);
    Parts { reflectors, r, inverse }
}

/// Where the matrix is to be written, by columns, for [`factor`].
#[inline(always)]
pub(crate) fn matrix<T>(m: usize, data: &mut [T]) -> &mut [T] {
    &mut data[m * m..2 * m * m]
}

/// Factors what [`matrix`] holds.
#[inline(always)]
pub(crate) fn factor<T: Scalar>(m: usize, data: &mut [T]) {
    let (reflectors, rest) = data.split_at_mut(m * m);
    let (r, inverse) = rest.split_at_mut(m * m);
    for j in 0..m {
        let v = &mut reflectors[j * m..(j + 1) * m];
        let column = &mut r[j * m..(j + 1) * m];
        let mut square = T::ZERO.map(|_| f64::MIN_POSITIVE);
        for &x in &column[j..] {
            square += x * x;
        }
        let norm = square.sqrt();
        let diagonal = -norm.copysign(column[j]);
        // v = (x - diagonal e_j) / sqrt(‖x‖ (‖x‖ + |x_j|)), so that v·v = 2.
        let factor = (norm * (norm + column[j].abs())).sqrt().recip();
        v[..j].fill(T::ZERO);
        for i in j + 1..m {
            v[i] = column[i] * factor;
        }
        v[j] = (column[j] - diagonal) * factor;
        column[j] = diagonal;
        inverse[j] = diagonal.recip();
        for column in r[(j + 1) * m..].chunks_exact_mut(m) {
            reflect(v, j, column);
        }
    }
}

/// Solves `A x = b` in place.
#[inline(always)]
pub(crate) fn solve<T: Scalar>(m: usize, data: &[T], x: &mut [T]) {
    let Parts { reflectors, r, inverse } = parts(m, data);
    for (j, v) in reflectors.chunks_exact(m).enumerate() {
        reflect(v, j, x);
    }
    for j in (0..m).rev() {
        x[j] = x[j] * inverse[j];
        let known = x[j];
        for i in 0..j {
            x[i] -= r[j * m + i] * known;
        }
    }
}

/// Solves `Aᵀ x = b` in place.
#[inline(always)]
pub(crate) fn solve_transposed<T: Scalar>(m: usize, data: &[T], x: &mut [T]) {
    let Parts { reflectors, r, inverse } = parts(m, data);
    for j in 0..m {
        let mut value = x[j];
        for i in 0..j {
            value -= r[j * m + i] * x[i];
        }
        x[j] = value * inverse[j];
    }
    for (j, v) in reflectors.chunks_exact(m).enumerate().rev() {
        reflect(v, j, x);
    }
}

#[inline(always)]
fn reflect<T: Scalar>(v: &[T], first: usize, x: &mut [T]) {
    let mut dot = T::ZERO;
    for i in first..v.len() {
        dot += v[i] * x[i];
    }
    for i in first..v.len() {
        x[i] -= dot * v[i];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solutions_and_transposed_solutions() {
        for m in 1..9 {
            let entry = |i: usize, j: usize| ((7 * i * i + 3 * i * j + 5 * j + 1) as f64).sin();
            let mut data = vec![0.0; room(m)];
            for (at, out) in matrix(m, &mut data).iter_mut().enumerate() {
                *out = entry(at % m, at / m);
            }
            factor(m, &mut data);
            let x: Vec<f64> = (0..m).map(|i| 1.0 + i as f64).collect();
            let product = |f: &dyn Fn(usize, usize) -> f64| -> Vec<f64> {
                (0..m).map(|i| (0..m).map(|j| f(i, j) * x[j]).sum()).collect()
            };
            let mut b = product(&entry);
            solve(m, &data, &mut b);
            let mut c = product(&|i, j| entry(j, i));
            solve_transposed(m, &data, &mut c);
            for i in 0..m {
                assert!((b[i] - x[i]).abs() < 1e-9 && (c[i] - x[i]).abs() < 1e-9, "{m}: {b:?} {c:?}");
            }
        }
    }
}
