//! Runs a loop with the widest vectors the processor has.

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
