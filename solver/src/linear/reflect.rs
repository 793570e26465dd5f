//! Householder reflections of two stacked blocks of `n` rows, for a fixed `n` or any.

use super::scalar::Scalar;

/// How many rows a block has, and the two inner loops that profit from knowing it when compiled.
///
/// Reflector `j` of a set is `H = I - v vᵀ` with `‖v‖ = √2`; its `v` is stored at `[j * 2n, (j + 1) * 2n)`: `n`
/// entries for the upper block (zero above row `j`), `n` for the lower.
pub(crate) trait Rows: Copy {
    fn n(self) -> usize;

    /// Does what is to be done for so many rows.
    fn choose<J: BySize>(self, job: J) -> J::Output;

    /// Applies the first `count` reflectors to the column `[top; bottom]`.
    fn apply<T: Scalar>(self, reflectors: &[T], count: usize, top: &mut [T], bottom: &mut [T]);

    /// Applies them in reverse order: the transpose of [`apply`](Self::apply).
    #[inline(always)]
    fn apply_transposed<T: Scalar>(self, reflectors: &[T], top: &mut [T], bottom: &mut [T]) {
        let n = self.n();
        for j in (0..n).rev() {
            reflect(&reflectors[j * 2 * n..(j + 1) * 2 * n], j, &mut top[..n], &mut bottom[..n]);
        }
    }
}

/// What is done in another way for a number of rows that is known when compiled than for any.
pub(crate) trait BySize {
    type Output;
    /// Must be `#[inline(always)]`, as the other.
    fn fixed<const N: usize>(self) -> Self::Output;
    fn any(self, n: usize) -> Self::Output;
}

/// Makes the reflector that annihilates `[top; bottom]` below row `j`; answers the diagonal entry of R.
#[inline(always)]
pub(crate) fn make_reflector<T: Scalar>(j: usize, top: &[T], bottom: &[T], out: &mut [T]) -> T {
    let n = top.len();
    let mut square = T::ZERO.map(|_| f64::MIN_POSITIVE);
    for &x in top[j..].iter().chain(bottom) {
        square += x * x;
    }
    let norm = square.sqrt();
    let diagonal = -norm.copysign(top[j]);
    // v = (x - diagonal e_j) / sqrt(‖x‖ (‖x‖ + |x_j|)), so that v·v = 2.
    let factor = (norm * (norm + top[j].abs())).sqrt().recip();
    for i in 0..n {
        out[i] = if i < j { T::ZERO } else { top[i] * factor };
        out[n + i] = bottom[i] * factor;
    }
    out[j] = (top[j] - diagonal) * factor;
    diagonal
}

#[inline(always)]
fn reflect<T: Scalar>(v: &[T], j: usize, top: &mut [T], bottom: &mut [T]) {
    let n = top.len();
    let (mut a, mut b) = (T::ZERO, T::ZERO);
    for i in j..n {
        a += v[i] * top[i];
    }
    for i in 0..n {
        b += v[n + i] * bottom[i];
    }
    let dot = a + b;
    for i in j..n {
        top[i] -= dot * v[i];
    }
    for i in 0..n {
        bottom[i] -= dot * v[n + i];
    }
}

/// `N` rows, known when compiled: the column stays in registers.
#[derive(Clone, Copy)]
pub(crate) struct Fixed<const N: usize>;

impl<const N: usize> Fixed<N> {
    /// Applies reflector `J`, if it is among those given. As `J` is known when compiled, all loops are unrolled.
    #[inline(always)]
    fn reflect<const J: usize, T: Scalar>(reflectors: &[T], [top, bottom]: &mut [[T; N]; 2]) {
        if J < N
            && let Some(v) = reflectors.get(J * 2 * N..(J + 1) * 2 * N)
        {
            reflect(v, J, top, bottom);
        }
    }
}

impl<const N: usize> Rows for Fixed<N> {
    #[inline(always)]
    fn n(self) -> usize {
        N
    }

    #[inline(always)]
    fn choose<J: BySize>(self, job: J) -> J::Output {
        job.fixed::<N>()
    }

    #[inline(always)]
    fn apply<T: Scalar>(self, reflectors: &[T], count: usize, top: &mut [T], bottom: &mut [T]) {
        let reflectors = &reflectors[..count * 2 * N];
        let mut column = [[T::ZERO; N]; 2];
        column[0].copy_from_slice(&top[..N]);
        column[1].copy_from_slice(&bottom[..N]);
        Self::reflect::<0, T>(reflectors, &mut column);
        Self::reflect::<1, T>(reflectors, &mut column);
        Self::reflect::<2, T>(reflectors, &mut column);
        Self::reflect::<3, T>(reflectors, &mut column);
        Self::reflect::<4, T>(reflectors, &mut column);
        Self::reflect::<5, T>(reflectors, &mut column);
        top[..N].copy_from_slice(&column[0]);
        bottom[..N].copy_from_slice(&column[1]);
    }
}

/// Any number of rows.
#[derive(Clone, Copy)]
pub(crate) struct Dynamic(pub usize);

impl Rows for Dynamic {
    #[inline(always)]
    fn n(self) -> usize {
        self.0
    }

    #[inline(always)]
    fn choose<J: BySize>(self, job: J) -> J::Output {
        job.any(self.0)
    }

    #[inline(always)]
    fn apply<T: Scalar>(self, reflectors: &[T], count: usize, top: &mut [T], bottom: &mut [T]) {
        let n = self.0;
        for (j, v) in reflectors.chunks_exact(2 * n).take(count).enumerate() {
            reflect(v, j, &mut top[..n], &mut bottom[..n]);
        }
    }
}

/// Runs `$body` with `$rows` bound to the [`Rows`] of `$n`.
macro_rules! with_rows {
    ($n:expr, $rows:ident => $body:expr) => {
        match $n {
            1 => {
                let $rows = $crate::linear::reflect::Fixed::<1>;
                $body
            }
            2 => {
                let $rows = $crate::linear::reflect::Fixed::<2>;
                $body
            }
            3 => {
                let $rows = $crate::linear::reflect::Fixed::<3>;
                $body
            }
            4 => {
                let $rows = $crate::linear::reflect::Fixed::<4>;
                $body
            }
            5 => {
                let $rows = $crate::linear::reflect::Fixed::<5>;
                $body
            }
            6 => {
                let $rows = $crate::linear::reflect::Fixed::<6>;
                $body
            }
            n => {
                let $rows = $crate::linear::reflect::Dynamic(n);
                $body
            }
        }
    };
}
pub(crate) use with_rows;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::linear::scalar::{Lane, W};

    /// Processors without wide vectors use the one for any number.
    #[test]
    fn a_number_of_rows_known_when_compiled_gives_the_same_bits_as_any() {
        let value = |i: usize| Lane(std::array::from_fn(|l| libm::sin((1 + i) as f64 * (1.0 + 0.3 * l as f64))));
        for n in 1..=8 {
            let column = |from: usize| (from..from + n).map(value).collect::<Vec<Lane>>();
            let mut reflectors = vec![Lane::ZERO; 2 * n * n];
            for (j, out) in reflectors.chunks_exact_mut(2 * n).enumerate() {
                make_reflector(j, &column(7 * j), &column(100 + 5 * j), out);
            }
            for count in 0..=n {
                let (mut fixed, mut any) = ([column(200), column(300)], [column(200), column(300)]);
                let [top, bottom] = &mut fixed;
                with_rows!(n, rows => rows.apply(&reflectors, count, top, bottom));
                let [top, bottom] = &mut any;
                Dynamic(n).apply(&reflectors, count, top, bottom);
                let bits = |lanes: &[Vec<Lane>; 2]| -> Vec<[u64; W]> {
                    lanes.iter().flatten().map(|lane| lane.0.map(f64::to_bits)).collect()
                };
                assert_eq!(bits(&fixed), bits(&any), "{count} of {n}");
            }
        }
    }
}
