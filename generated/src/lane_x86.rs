//! Vectors of x86-64: four numbers with AVX2, eight with AVX-512.
//!
//! Values of these types are made only inside functions that the dispatcher calls after it has found the instructions
//! on this machine; that is why the intrinsics here are safe to call.

use std::arch::x86_64::*;
use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::lane::Lane;

/// Four numbers (AVX2).
#[derive(Clone, Copy)]
pub(crate) struct F64x4(__m256d);

/// Eight numbers (AVX-512 F).
#[derive(Clone, Copy)]
pub(crate) struct F64x8(__m512d);

macro_rules! operator {
    ($lane:ident, $trait:ident, $method:ident, $intrinsic:ident) => {
        impl $trait for $lane {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                // SAFETY: the instructions exist here, see the module's head.
                unsafe { Self($intrinsic(self.0, other.0)) }
            }
        }
    };
}

operator!(F64x4, Add, add, _mm256_add_pd);
operator!(F64x4, Sub, sub, _mm256_sub_pd);
operator!(F64x4, Mul, mul, _mm256_mul_pd);
operator!(F64x4, Div, div, _mm256_div_pd);
operator!(F64x8, Add, add, _mm512_add_pd);
operator!(F64x8, Sub, sub, _mm512_sub_pd);
operator!(F64x8, Mul, mul, _mm512_mul_pd);
operator!(F64x8, Div, div, _mm512_div_pd);

impl Neg for F64x4 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.xor(Self::splat(-0.0))
    }
}

impl Neg for F64x8 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.xor(Self::splat(-0.0))
    }
}

// SAFETY of all blocks below: the instructions exist here, see the module's head; pointers are the caller's.
impl Lane for F64x4 {
    const WIDTH: usize = 4;

    #[inline(always)]
    fn splat(value: f64) -> Self {
        unsafe { Self(_mm256_set1_pd(value)) }
    }

    #[inline(always)]
    unsafe fn load(from: *const f64) -> Self {
        unsafe { Self(_mm256_loadu_pd(from)) }
    }

    #[inline(always)]
    unsafe fn store(self, to: *mut f64) {
        unsafe { _mm256_storeu_pd(to, self.0) }
    }

    #[inline(always)]
    fn root(self) -> Self {
        unsafe { Self(_mm256_sqrt_pd(self.0)) }
    }

    #[inline(always)]
    fn where_at_least(self, bound: Self, a: Self, b: Self) -> Self {
        unsafe { Self(_mm256_blendv_pd(b.0, a.0, _mm256_cmp_pd::<_CMP_GE_OQ>(self.0, bound.0))) }
    }

    #[inline(always)]
    fn where_sign(self, a: Self, b: Self) -> Self {
        unsafe { Self(_mm256_blendv_pd(b.0, a.0, self.0)) }
    }

    #[inline(always)]
    fn shift_bits<const BY: i32>(self) -> Self {
        unsafe { Self(_mm256_castsi256_pd(_mm256_slli_epi64::<BY>(_mm256_castpd_si256(self.0)))) }
    }

    #[inline(always)]
    fn and(self, other: Self) -> Self {
        unsafe { Self(_mm256_and_pd(self.0, other.0)) }
    }

    #[inline(always)]
    fn xor(self, other: Self) -> Self {
        unsafe { Self(_mm256_xor_pd(self.0, other.0)) }
    }

    #[inline(always)]
    fn add_bits(self, other: Self) -> Self {
        unsafe {
            let sum = _mm256_add_epi64(_mm256_castpd_si256(self.0), _mm256_castpd_si256(other.0));
            Self(_mm256_castsi256_pd(sum))
        }
    }

    #[inline(always)]
    fn all_within(self, bound: f64) -> bool {
        unsafe {
            let size = _mm256_andnot_pd(_mm256_set1_pd(-0.0), self.0);
            _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_LE_OQ>(size, _mm256_set1_pd(bound))) == 0b1111
        }
    }

    #[inline(always)]
    fn map(self, function: impl Fn(f64) -> f64) -> Self {
        let mut elements = [0.0; 4];
        unsafe {
            self.store(elements.as_mut_ptr());
            Self::load(elements.map(function).as_ptr())
        }
    }
}

impl Lane for F64x8 {
    const WIDTH: usize = 8;

    #[inline(always)]
    fn splat(value: f64) -> Self {
        unsafe { Self(_mm512_set1_pd(value)) }
    }

    #[inline(always)]
    unsafe fn load(from: *const f64) -> Self {
        unsafe { Self(_mm512_loadu_pd(from)) }
    }

    #[inline(always)]
    unsafe fn store(self, to: *mut f64) {
        unsafe { _mm512_storeu_pd(to, self.0) }
    }

    #[inline(always)]
    fn root(self) -> Self {
        unsafe { Self(_mm512_sqrt_pd(self.0)) }
    }

    #[inline(always)]
    fn where_at_least(self, bound: Self, a: Self, b: Self) -> Self {
        unsafe { Self(_mm512_mask_blend_pd(_mm512_cmp_pd_mask::<_CMP_GE_OQ>(self.0, bound.0), b.0, a.0)) }
    }

    #[inline(always)]
    fn where_sign(self, a: Self, b: Self) -> Self {
        unsafe {
            let negative = _mm512_cmplt_epi64_mask(_mm512_castpd_si512(self.0), _mm512_setzero_si512());
            Self(_mm512_mask_blend_pd(negative, b.0, a.0))
        }
    }

    #[inline(always)]
    fn shift_bits<const BY: i32>(self) -> Self {
        // The intrinsic wants its count unsigned.
        unsafe {
            let count = _mm_cvtsi32_si128(BY);
            Self(_mm512_castsi512_pd(_mm512_sll_epi64(_mm512_castpd_si512(self.0), count)))
        }
    }

    #[inline(always)]
    fn and(self, other: Self) -> Self {
        unsafe {
            let bits = _mm512_and_si512(_mm512_castpd_si512(self.0), _mm512_castpd_si512(other.0));
            Self(_mm512_castsi512_pd(bits))
        }
    }

    #[inline(always)]
    fn xor(self, other: Self) -> Self {
        unsafe {
            let bits = _mm512_xor_si512(_mm512_castpd_si512(self.0), _mm512_castpd_si512(other.0));
            Self(_mm512_castsi512_pd(bits))
        }
    }

    #[inline(always)]
    fn add_bits(self, other: Self) -> Self {
        unsafe {
            let sum = _mm512_add_epi64(_mm512_castpd_si512(self.0), _mm512_castpd_si512(other.0));
            Self(_mm512_castsi512_pd(sum))
        }
    }

    #[inline(always)]
    fn all_within(self, bound: f64) -> bool {
        unsafe {
            let size = _mm512_abs_pd(self.0);
            _mm512_cmp_pd_mask::<_CMP_LE_OQ>(size, _mm512_set1_pd(bound)) == 0xff
        }
    }

    #[inline(always)]
    fn map(self, function: impl Fn(f64) -> f64) -> Self {
        let mut elements = [0.0; 8];
        unsafe {
            self.store(elements.as_mut_ptr());
            Self::load(elements.map(function).as_ptr())
        }
    }
}
