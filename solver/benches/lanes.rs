//! What several problems side by side in the lanes of one register would gain over one problem at a time: the same
//! elimination, once as the crate runs it, four stretches of one chain in AVX2 registers and then the stretches one
//! after another, and once with eight chains of eight problems in AVX-512 registers.
//! `cargo bench -p sheave-solver --bench lanes`.
//!
//! The sizes are those of a region of five states, three unknown constants and four integrals, and of one of four, one
//! and three; the meshes those of problems with some hundred intervals.

// The crate's own elimination, which is not public.
#[allow(dead_code, unused_imports, unused_macros)]
#[path = "../src/linear/mod.rs"]
mod linear;

#[cfg(target_arch = "x86_64")]
fn main() {
    if !(std::arch::is_x86_feature_detected!("avx512f") && std::arch::is_x86_feature_detected!("avx512dq")) {
        println!("This processor does not have AVX-512.");
        return;
    }
    println!("states  intervals  one problem, ns an interval  eight, ns an interval and problem  ratio");
    wide::compare(linear::reflect::Fixed::<5>, linear::chain::Sizes { n: 5, p: 3, k: 4 });
    wide::compare(linear::reflect::Fixed::<4>, linear::chain::Sizes { n: 4, p: 1, k: 3 });
}

#[cfg(not(target_arch = "x86_64"))]
fn main() {
    println!("Eight problems side by side are measured on x86-64 alone.");
}

#[cfg(target_arch = "x86_64")]
mod wide {
    use std::arch::x86_64::*;
    use std::hint::black_box;
    use std::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};
    use std::time::Instant;

    use super::linear::chain::{Block, Chain, Intervals, Reduced, Sizes};
    use super::linear::memory::Kept;
    use super::linear::reflect::Rows;
    use super::linear::scalar::{Lane, Scalar, W};

    /// Chains side by side.
    const WIDE: usize = 8;

    /// One number of each of eight chains. Made and used only where AVX-512 was asked for first.
    #[derive(Clone, Copy)]
    #[repr(transparent)]
    struct Eight(__m512d);

    impl Eight {
        const fn of(values: [f64; WIDE]) -> Self {
            // SAFETY: both are 64 bytes of plain numbers.
            Self(unsafe { std::mem::transmute::<[f64; WIDE], __m512d>(values) })
        }
    }

    // SAFETY: some numbers are, in a line.
    unsafe impl Kept for Eight {}

    impl Scalar for Eight {
        const ZERO: Self = Self::of([0.0; WIDE]);
        const ONE: Self = Self::of([1.0; WIDE]);

        #[inline(always)]
        fn map(self, f: impl Fn(f64) -> f64) -> Self {
            // SAFETY: both are 64 bytes of plain numbers.
            Self::of(unsafe { std::mem::transmute::<__m512d, [f64; WIDE]>(self.0) }.map(f))
        }

        #[inline(always)]
        fn copysign(self, sign: Self) -> Self {
            // SAFETY: see the type.
            unsafe {
                let bit = _mm512_set1_pd(-0.0);
                Self(_mm512_or_pd(_mm512_andnot_pd(bit, self.0), _mm512_and_pd(bit, sign.0)))
            }
        }

        #[inline(always)]
        fn sqrt(self) -> Self {
            // SAFETY: see the type.
            Self(unsafe { _mm512_sqrt_pd(self.0) })
        }

        #[inline(always)]
        fn recip(self) -> Self {
            // SAFETY: see the type.
            Self(unsafe { _mm512_div_pd(_mm512_set1_pd(1.0), self.0) })
        }

        #[inline(always)]
        fn abs(self) -> Self {
            // SAFETY: see the type.
            Self(unsafe { _mm512_abs_pd(self.0) })
        }
    }

    macro_rules! lanewise {
        ($($trait:ident $method:ident $operation:ident;)*) => {$(
            impl $trait for Eight {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: Self) -> Self {
                    // SAFETY: see the type.
                    Self(unsafe { $operation(self.0, other.0) })
                }
            }
        )*};
    }
    lanewise! { Add add _mm512_add_pd; Sub sub _mm512_sub_pd; Mul mul _mm512_mul_pd; }

    impl Neg for Eight {
        type Output = Self;
        #[inline(always)]
        fn neg(self) -> Self {
            // SAFETY: see the type.
            Self(unsafe { _mm512_xor_pd(_mm512_set1_pd(-0.0), self.0) })
        }
    }

    impl AddAssign for Eight {
        #[inline(always)]
        fn add_assign(&mut self, other: Self) {
            *self = *self + other;
        }
    }

    impl SubAssign for Eight {
        #[inline(always)]
        fn sub_assign(&mut self, other: Self) {
            *self = *self - other;
        }
    }

    /// Coefficients that stand in memory.
    struct Stored<'a, T: Kept>(&'a [Block<Vec<T>>]);

    impl<T: Kept> Intervals<T> for Stored<'_, T> {
        #[inline(always)]
        fn fill<R: Rows>(&mut self, _: R, t: usize, to: &mut Block<&mut [T]>) {
            let Some(from) = self.0.get(t) else { return };
            to.a.copy_from_slice(&from.a);
            to.b.copy_from_slice(&from.b);
            to.c.copy_from_slice(&from.c);
            to.fa.copy_from_slice(&from.fa);
            to.fb.copy_from_slice(&from.fb);
            to.fc.copy_from_slice(&from.fc);
        }
    }

    /// Blocks of a chain near -I, I.
    fn blocks<T: Kept>(sizes: Sizes, count: usize) -> Vec<Block<Vec<T>>> {
        let mut seed = 1_u64;
        let mut random = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 33) as f64 / (1_u64 << 31) as f64 - 0.5
        };
        let mut block = || {
            let Sizes { n, p, k } = sizes;
            let [a, b, c, fa, fb, fc] = [n * n, n * n, n * p, k * n, k * n, k * p].map(|count| vec![T::ZERO; count]);
            let mut block = Block { a, b, c, fa, fb, fc };
            for (matrix, sign) in [(&mut block.a, -1.0), (&mut block.b, 1.0)] {
                for (at, value) in matrix.iter_mut().enumerate() {
                    let number = 0.05 * random() + if at % (n + 1) == 0 { sign } else { 0.0 };
                    *value = T::ONE.times(number);
                }
            }
            for matrix in [&mut block.c, &mut block.fa, &mut block.fb, &mut block.fc] {
                for value in matrix.iter_mut() {
                    *value = T::ONE.times(0.1 * random());
                }
            }
            block
        };
        (0..count).map(|_| block()).collect()
    }

    /// As the crate eliminates a region.
    #[target_feature(enable = "avx2")]
    fn one<R: Rows>(rows: R, stretches: &mut Chain<Lane>, whole: &mut Chain<f64>, blocks: &[Block<Vec<Lane>>]) {
        stretches.factor(rows, Stored(blocks));
        whole.factor(rows, Reduced(stretches.end()));
    }

    #[target_feature(enable = "avx512f,avx512vl,avx512dq")]
    fn eight<R: Rows>(rows: R, chains: &mut Chain<Eight>, blocks: &[Block<Vec<Eight>>]) {
        chains.factor(rows, Stored(blocks));
    }

    /// Shortest of several runs, in nanoseconds.
    fn shortest(intervals: usize, mut run: impl FnMut()) -> f64 {
        let each = 20_000 / intervals + 1;
        let mut least = f64::INFINITY;
        for _ in 0..15 {
            let start = Instant::now();
            (0..each).for_each(|_| run());
            least = least.min(start.elapsed().as_secs_f64() / each as f64);
        }
        1e9 * least
    }

    pub fn compare<R: Rows>(rows: R, sizes: Sizes) {
        for intervals in [12, 24, 48, 96, 120, 192] {
            let steps = intervals / W;
            let (narrow, wide) = (blocks::<Lane>(sizes, steps), blocks::<Eight>(sizes, intervals));
            let (mut stretches, mut whole) = (Chain::new(sizes, steps), Chain::new(sizes, W));
            let mut chains = Chain::new(sizes, intervals);
            // SAFETY: the processor has AVX-512, and so AVX2, as `main` has asked.
            let alone = shortest(intervals, || unsafe { one(rows, &mut stretches, &mut whole, black_box(&narrow)) });
            // SAFETY: as before.
            let together = shortest(intervals, || unsafe { eight(rows, &mut chains, black_box(&wide)) });
            let (alone, together) = (alone / intervals as f64, together / (WIDE * intervals) as f64);
            let n = sizes.n;
            println!("{n:6}  {intervals:9}  {alone:27.0}  {together:33.0}  {:5.2}", alone / together);
        }
    }
}
