//! Vectors of WebAssembly: two numbers with simd128.
//!
//! A module that uses these instructions does not load where they are missing: they are chosen when the module is
//! compiled (`-C target-feature=+simd128`), not while it runs.

use std::arch::wasm32::*;
use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::lane::Lane;

/// Two numbers (simd128).
#[derive(Clone, Copy)]
pub(crate) struct F64x2(v128);

macro_rules! operator {
    ($trait:ident, $method:ident, $intrinsic:ident) => {
        impl $trait for F64x2 {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self($intrinsic(self.0, other.0))
            }
        }
    };
}

operator!(Add, add, f64x2_add);
operator!(Sub, sub, f64x2_sub);
operator!(Mul, mul, f64x2_mul);
operator!(Div, div, f64x2_div);

impl Neg for F64x2 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(f64x2_neg(self.0))
    }
}

impl F64x2 {
    #[inline(always)]
    fn elements(self) -> [f64; 2] {
        [f64x2_extract_lane::<0>(self.0), f64x2_extract_lane::<1>(self.0)]
    }
}

impl Lane for F64x2 {
    const WIDTH: usize = 2;

    #[inline(always)]
    fn splat(value: f64) -> Self {
        Self(f64x2_splat(value))
    }

    #[inline(always)]
    unsafe fn load(from: *const f64) -> Self {
        // SAFETY: the caller's; the instruction asks for no alignment.
        unsafe { Self(v128_load(from.cast())) }
    }

    #[inline(always)]
    unsafe fn store(self, to: *mut f64) {
        // SAFETY: the caller's; the instruction asks for no alignment.
        unsafe { v128_store(to.cast(), self.0) }
    }

    #[inline(always)]
    fn root(self) -> Self {
        Self(f64x2_sqrt(self.0))
    }

    #[inline(always)]
    fn where_at_least(self, bound: Self, a: Self, b: Self) -> Self {
        Self(v128_bitselect(a.0, b.0, f64x2_ge(self.0, bound.0)))
    }

    #[inline(always)]
    fn where_sign(self, a: Self, b: Self) -> Self {
        Self(v128_bitselect(a.0, b.0, i64x2_shr(self.0, 63)))
    }

    #[inline(always)]
    fn shift_bits<const BY: i32>(self) -> Self {
        Self(i64x2_shl(self.0, BY.unsigned_abs()))
    }

    #[inline(always)]
    fn and(self, other: Self) -> Self {
        Self(v128_and(self.0, other.0))
    }

    #[inline(always)]
    fn xor(self, other: Self) -> Self {
        Self(v128_xor(self.0, other.0))
    }

    #[inline(always)]
    fn add_bits(self, other: Self) -> Self {
        Self(i64x2_add(self.0, other.0))
    }

    #[inline(always)]
    fn all_within(self, bound: f64) -> bool {
        i64x2_all_true(f64x2_le(f64x2_abs(self.0), f64x2_splat(bound)))
    }

    #[inline(always)]
    fn map(self, function: impl Fn(f64) -> f64) -> Self {
        let [a, b] = self.elements();
        Self(f64x2(function(a), function(b)))
    }
}
