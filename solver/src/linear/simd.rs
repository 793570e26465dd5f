//! Runs a loop with the widest vectors the processor has.

#[cfg(target_arch = "x86_64")]
use super::reflect::Dynamic;
use super::reflect::{Rows, with_rows};
use super::scalar::{Lane, Scalar, W};

/// A computation that is inlined into a caller compiled for more vector instructions than the crate's baseline.
pub(crate) trait Job {
    type Output;
    /// Must be `#[inline(always)]`, down to its inner loops.
    fn run(self) -> Self::Output;
}

/// Runs `job`, with AVX2 where the processor has it. Vectors only widen: results are bitwise the same.
#[inline]
pub(crate) fn vectorised<J: Job>(job: J) -> J::Output {
    #[cfg(target_arch = "x86_64")]
    if std::arch::is_x86_feature_detected!("avx2") {
        // SAFETY: the processor has AVX2, as was just asked.
        return unsafe { with_avx2(job) };
    }
    job.run()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn with_avx2<J: Job>(job: J) -> J::Output {
    job.run()
}

/// A computation that profits from knowing how many rows its blocks have when it is compiled.
pub(crate) trait RowsJob: Sized {
    type Output;
    /// As [`Job::run`].
    fn run<R: Rows>(self, rows: R) -> Self::Output;
}

/// Runs `job` for `n` rows with the widest vectors the processor has. There is a function for every small number of
/// rows: one for all of them takes the compiler minutes. Processors of x86-64 without AVX2 have become rare, so that
/// theirs is the one for any number; results are bitwise the same.
#[inline(always)]
pub(crate) fn vectorised_rows<J: RowsJob>(n: usize, job: J) -> J::Output {
    #[cfg(target_arch = "x86_64")]
    if std::arch::is_x86_feature_detected!("avx2") {
        // SAFETY: the processor has AVX2, as was just asked.
        with_rows!(n, rows => unsafe { with_avx2(OfRows { rows, job }) })
    } else {
        OfRows { rows: Dynamic(n), job }.run()
    }
    #[cfg(not(target_arch = "x86_64"))]
    with_rows!(n, rows => OfRows { rows, job }.run())
}

struct OfRows<R, J> {
    rows: R,
    job: J,
}

impl<R: Rows, J: RowsJob> Job for OfRows<R, J> {
    type Output = J::Output;

    #[inline(always)]
    fn run(self) -> J::Output {
        self.job.run(self.rows)
    }
}

/// `out[p] = f(out[p], [x[p], ...])`, with the widest vectors the processor has. The inputs are at least as long as
/// `out`.
#[inline(always)]
pub(crate) fn elementwise<const K: usize>(out: &mut [f64], inputs: [&[f64]; K], f: impl Fn(f64, [f64; K]) -> f64) {
    vectorised(Elementwise { out, inputs, f });
}

struct Elementwise<'a, const K: usize, F> {
    out: &'a mut [f64],
    inputs: [&'a [f64]; K],
    f: F,
}

impl<const K: usize, F: Fn(f64, [f64; K]) -> f64> Job for Elementwise<'_, K, F> {
    type Output = ();

    /// A vector at a time: what is read of it is read before anything is written, so that it need not be asked whether
    /// inputs and output overlap.
    #[inline(always)]
    fn run(self) {
        let Self { out, inputs, f } = self;
        let len = out.len();
        let mut rest = inputs;
        for rest in &mut rest {
            *rest = &rest[..len];
        }
        let (chunks, last) = out.as_chunks_mut::<W>();
        for (q, out) in chunks.iter_mut().enumerate() {
            let mut x = [[0.0; W]; K];
            for k in 0..K {
                x[k].copy_from_slice(&rest[k][q * W..(q + 1) * W]);
            }
            let mut sum = *out;
            for l in 0..W {
                let mut values = [0.0; K];
                for k in 0..K {
                    values[k] = x[k][l];
                }
                sum[l] = f(sum[l], values);
            }
            *out = sum;
        }
        let done = len - last.len();
        for (p, out) in last.iter_mut().enumerate() {
            let mut values = [0.0; K];
            for k in 0..K {
                values[k] = rest[k][done + p];
            }
            *out = f(*out, values);
        }
    }
}

/// `out[i * steps + t] = f(i, t)` for components `i` and vectors `t`, `steps` of them a component, with the widest
/// vectors the processor has.
#[inline(always)]
pub(crate) fn by_components(out: &mut [f64], steps: usize, f: impl Fn(usize, usize) -> Lane) {
    vectorised(ByComponents { out, steps, f });
}

struct ByComponents<'a, F> {
    out: &'a mut [f64],
    steps: usize,
    f: F,
}

impl<F: Fn(usize, usize) -> Lane> Job for ByComponents<'_, F> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let (out, _) = self.out.as_chunks_mut::<W>();
        for (i, out) in out.chunks_exact_mut(self.steps).enumerate() {
            for (t, out) in out.iter_mut().enumerate() {
                *out = (self.f)(i, t).0;
            }
        }
    }
}

/// Largest magnitude; NaN if any value is NaN or infinite.
pub(crate) fn largest<'a>(lanes: impl Iterator<Item = &'a [Lane]>, rest: &[f64]) -> f64 {
    let found = lanes.map(|lanes| vectorised(Largest { lanes: lanes.iter().copied() }));
    found.chain(rest.iter().map(|x| x.abs() + x * 0.0)).fold(0.0, larger)
}

/// Of numbers, as many as are a multiple of `W`.
pub(crate) fn largest_number(values: &[f64]) -> f64 {
    vectorised(Largest { lanes: values.as_chunks::<W>().0.iter().map(|lane| Lane(*lane)) })
}

/// NaN if either is.
#[inline(always)]
fn larger(a: f64, b: f64) -> f64 {
    if b > a || b.is_nan() { b } else { a }
}

struct Largest<I> {
    lanes: I,
}

impl<I: Iterator<Item = Lane>> Job for Largest<I> {
    type Output = f64;

    #[inline(always)]
    fn run(self) -> f64 {
        let (mut most, mut sums) = (Lane::ZERO, Lane::ZERO);
        for lane in self.lanes {
            most = most.or_larger(lane.abs());
            // x * 0 is 0 for a finite x and NaN otherwise.
            sums += lane.times(0.0);
        }
        most.0.iter().zip(sums.0).fold(0.0, |max, (most, sum)| larger(max, most + sum))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_magnitude_is_found_wherever_it_stands_and_what_is_not_finite_shows() {
        for len in 0..20 {
            let mut values: Vec<f64> = (0..len).map(|i| -0.5 + i as f64 / 100.0).collect();
            let found = |values: &[f64]| {
                let (lanes, rest) = values.as_chunks::<W>();
                let lanes: Vec<Lane> = lanes.iter().map(|x| Lane(*x)).collect();
                let found = largest(lanes.chunks(2), rest);
                if rest.is_empty() {
                    assert_eq!(largest_number(values).to_bits(), found.to_bits());
                }
                found
            };
            assert_eq!(found(&values), values.iter().fold(0.0, |max: f64, x| max.max(x.abs())));
            for at in 0..len {
                values[at] = -7.0;
                assert_eq!(found(&values), 7.0);
                for undefined in [f64::NAN, f64::INFINITY] {
                    values[at] = undefined;
                    assert!(found(&values).is_nan());
                }
                values[at] = 0.0;
            }
        }
    }
}
