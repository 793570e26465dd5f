//! A generated function over a batch of points, with the widest vectors that this machine has.

use std::marker::PhantomData;
use std::sync::atomic::{AtomicU8, Ordering};

use crate::lane::Lane;
use crate::types::RegionOut;

/// Which instructions compute a batch. All of them give the same bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Simd {
    /// One point at a time.
    Scalar,
    /// Two points at a time with WebAssembly's simd128.
    Simd128,
    /// Four points at a time with AVX2.
    Avx2,
    /// Eight points at a time with AVX-512.
    Avx512,
}

static LIMIT: AtomicU8 = AtomicU8::new(Simd::Avx512 as u8);

impl Simd {
    /// What this machine can do, narrowest first.
    pub fn available() -> Vec<Simd> {
        [Simd::Scalar, Simd::Simd128, Simd::Avx2, Simd::Avx512].into_iter().filter(|simd| simd.exists()).collect()
    }

    /// What batches are computed with: the widest that exists and is not beyond the limit.
    pub fn current() -> Simd {
        let limit = LIMIT.load(Ordering::Relaxed);
        let allowed = |simd: &Simd| *simd as u8 <= limit && simd.exists();
        [Simd::Avx512, Simd::Avx2, Simd::Simd128].into_iter().find(allowed).unwrap_or(Simd::Scalar)
    }

    /// Makes the whole process use vectors no wider than these: for comparisons; results do not change.
    pub fn limit(widest: Simd) {
        LIMIT.store(widest as u8, Ordering::Relaxed);
    }

    #[cfg(target_arch = "x86_64")]
    fn exists(self) -> bool {
        match self {
            Simd::Scalar => true,
            Simd::Simd128 => false,
            Simd::Avx2 => is_x86_feature_detected!("avx2"),
            Simd::Avx512 => is_x86_feature_detected!("avx512f"),
        }
    }

    #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
    fn exists(self) -> bool {
        matches!(self, Simd::Scalar | Simd::Simd128)
    }

    #[cfg(not(any(target_arch = "x86_64", all(target_arch = "wasm32", target_feature = "simd128"))))]
    fn exists(self) -> bool {
        self == Simd::Scalar
    }
}

/// One generated function.
pub(crate) trait Sweep {
    /// States per point.
    const STATES: usize;
    /// Constants of the kernel.
    const CONSTANTS: usize;
    /// Rows of `f` written.
    const F: usize;
    /// Rows of `dy` written.
    const DY: usize;
    /// Rows of `dc` written.
    const DC: usize;
    /// Rows of `fields` written.
    const FIELDS: usize;
    /// Whether eight points at a time are worth the time to compile them: not for what runs once a solution.
    #[cfg_attr(not(target_arch = "x86_64"), expect(dead_code, reason = "there are no wider lanes there"))]
    const WIDE: bool;
    /// What all points share.
    type Uniforms;
    /// Computes what all points share; `constants` holds `CONSTANTS` values.
    fn uniforms(constants: &[f64]) -> Self::Uniforms;
    /// Computes `Real::WIDTH` points.
    fn chunk<Real: Lane>(uniforms: &Self::Uniforms, at: Chunk<'_>);
}

/// `Real::WIDTH` points of a batch: reads and writes rows.
///
/// Made by [`sweep`] only, after it has checked that every row of the function's sizes holds the chunk; the row numbers
/// are the generator's, which derives the sizes from them.
#[derive(Clone, Copy)]
pub(crate) struct Chunk<'a> {
    stride: usize,
    s: *const f64,
    y: *const f64,
    f: *mut f64,
    dy: *mut f64,
    dc: *mut f64,
    fields: *mut f64,
    batch: PhantomData<&'a mut f64>,
}

impl Chunk<'_> {
    /// The independent variable.
    #[inline(always)]
    pub(crate) fn position<Real: Lane>(self) -> Real {
        // SAFETY: see the type.
        unsafe { Real::load(self.s) }
    }

    /// A state.
    #[inline(always)]
    pub(crate) fn state<Real: Lane>(self, row: usize) -> Real {
        // SAFETY: see the type.
        unsafe { Real::load(self.y.add(row * self.stride)) }
    }

    /// A row of the right-hand side or an integrand.
    #[inline(always)]
    pub(crate) fn write_f<Real: Lane>(self, row: usize, value: Real) {
        // SAFETY: see the type.
        unsafe { value.store(self.f.add(row * self.stride)) }
    }

    /// A derivative with respect to a state.
    #[inline(always)]
    pub(crate) fn write_dy<Real: Lane>(self, row: usize, value: Real) {
        // SAFETY: see the type.
        unsafe { value.store(self.dy.add(row * self.stride)) }
    }

    /// A derivative with respect to a constant.
    #[inline(always)]
    pub(crate) fn write_dc<Real: Lane>(self, row: usize, value: Real) {
        // SAFETY: see the type.
        unsafe { value.store(self.dc.add(row * self.stride)) }
    }

    /// A derived field.
    #[inline(always)]
    pub(crate) fn write_field<Real: Lane>(self, row: usize, value: Real) {
        // SAFETY: see the type.
        unsafe { value.store(self.fields.add(row * self.stride)) }
    }

    /// The chunk that starts `points` further on.
    #[inline(always)]
    fn advance(self, points: usize) -> Self {
        // Wrapping: rows that the function does not use may be empty.
        Self {
            s: self.s.wrapping_add(points),
            y: self.y.wrapping_add(points),
            f: self.f.wrapping_add(points),
            dy: self.dy.wrapping_add(points),
            dc: self.dc.wrapping_add(points),
            fields: self.fields.wrapping_add(points),
            ..self
        }
    }
}

/// Runs a generated function over a batch; see [`crate::RegionFn`].
pub(crate) fn sweep<Function: Sweep>(
    m: usize,
    stride: usize,
    s: &[f64],
    y: &[f64],
    constants: &[f64],
    out: &mut RegionOut<'_>,
) {
    assert!(m <= stride, "stride: {m} points do not fit into {stride}");
    assert!(s.len() >= m, "s: {} values for {m} points", s.len());
    assert!(constants.len() >= Function::CONSTANTS, "constants: {} of {}", constants.len(), Function::CONSTANTS);
    // The last row need not be filled up to the stride.
    let needs = |rows: usize| rows.checked_sub(1).map_or(0, |before| before * stride + m);
    assert!(y.len() >= needs(Function::STATES), "y: too few values");
    assert!(out.f.len() >= needs(Function::F), "f: too few values");
    assert!(out.dy.len() >= needs(Function::DY), "dy: too few values");
    assert!(out.dc.len() >= needs(Function::DC), "dc: too few values");
    assert!(out.fields.len() >= needs(Function::FIELDS), "fields: too few values");
    if m == 0 {
        return;
    }
    let uniforms = Function::uniforms(constants);
    let start = Chunk {
        stride,
        s: s.as_ptr(),
        y: y.as_ptr(),
        f: out.f.as_mut_ptr(),
        dy: out.dy.as_mut_ptr(),
        dc: out.dc.as_mut_ptr(),
        fields: out.fields.as_mut_ptr(),
        batch: PhantomData,
    };
    dispatch::<Function>(&uniforms, start, m);
}

#[cfg(target_arch = "x86_64")]
fn dispatch<Function: Sweep>(uniforms: &Function::Uniforms, start: Chunk<'_>, m: usize) {
    match Simd::current() {
        // SAFETY: `current` returns only what the machine has.
        Simd::Avx512 if Function::WIDE && m >= 8 => unsafe { avx512::<Function>(uniforms, start, m) },
        // SAFETY: AVX-512 machines have AVX2 too.
        Simd::Avx512 | Simd::Avx2 if m >= 4 => unsafe { avx2::<Function>(uniforms, start, m) },
        _ => chunks::<Function, f64>(uniforms, start, m),
    }
}

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
fn dispatch<Function: Sweep>(uniforms: &Function::Uniforms, start: Chunk<'_>, m: usize) {
    match Simd::current() {
        Simd::Simd128 if m >= 2 => chunks::<Function, crate::lane_wasm::F64x2>(uniforms, start, m),
        _ => chunks::<Function, f64>(uniforms, start, m),
    }
}

#[cfg(not(any(target_arch = "x86_64", all(target_arch = "wasm32", target_feature = "simd128"))))]
fn dispatch<Function: Sweep>(uniforms: &Function::Uniforms, start: Chunk<'_>, m: usize) {
    chunks::<Function, f64>(uniforms, start, m);
}

/// # Safety
/// The machine must have AVX-512 F.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f")]
unsafe fn avx512<Function: Sweep>(uniforms: &Function::Uniforms, start: Chunk<'_>, m: usize) {
    chunks::<Function, crate::lane_x86::F64x8>(uniforms, start, m);
}

/// # Safety
/// The machine must have AVX2.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
unsafe fn avx2<Function: Sweep>(uniforms: &Function::Uniforms, start: Chunk<'_>, m: usize) {
    chunks::<Function, crate::lane_x86::F64x4>(uniforms, start, m);
}

/// All chunks of `m >= WIDTH` points. The last one is moved back to end with the batch: it computes some points again,
/// to the same bits.
#[inline(always)]
fn chunks<Function: Sweep, Real: Lane>(uniforms: &Function::Uniforms, start: Chunk<'_>, m: usize) {
    let mut point = 0;
    while point < m {
        let first = point.min(m - Real::WIDTH);
        Function::chunk::<Real>(uniforms, start.advance(first));
        point += Real::WIDTH;
    }
}
