//! Other loops than the generated ones, with the widest vectors that this machine has.

use crate::sweep::Simd;

/// A computation that is compiled anew for wider vectors.
pub trait Job {
    /// What it gives.
    type Output;
    /// Must be `#[inline(always)]`, down to its inner loops: what is not inlined keeps the narrow vectors.
    fn run(self) -> Self::Output;
}

impl Simd {
    /// Runs a computation with AVX2 where batches may be computed with it. Vectors only widen, nothing is contracted:
    /// results are the same bits.
    #[inline]
    pub fn run<J: Job>(job: J) -> J::Output {
        #[cfg(target_arch = "x86_64")]
        if Self::current() >= Self::Avx2 {
            // SAFETY: `current` returns only what the machine has, and AVX-512 machines have AVX2 too.
            return unsafe { with_avx2(job) };
        }
        job.run()
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn with_avx2<J: Job>(job: J) -> J::Output {
    job.run()
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Sum<'a>(&'a [f64]);

    impl Job for Sum<'_> {
        type Output = f64;

        #[inline(always)]
        fn run(self) -> f64 {
            self.0.iter().map(|x| x * 0.1).sum()
        }
    }

    #[test]
    fn every_width_gives_the_same_bits() {
        let values: Vec<f64> = (0..37).map(|i| f64::from(i).sqrt()).collect();
        let found: Vec<u64> = Simd::available()
            .into_iter()
            .map(|simd| {
                Simd::limit(simd);
                Simd::run(Sum(&values)).to_bits()
            })
            .collect();
        Simd::limit(Simd::Avx512);
        assert!(found.iter().all(|bits| *bits == Sum(&values).run().to_bits()));
    }
}
