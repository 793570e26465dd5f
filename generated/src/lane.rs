//! One number or a vector of them: the arithmetic that generated code is written in.
//!
//! All lanes compute the same bits: every operation here is a single correctly rounded IEEE 754 operation on each
//! element, products and sums are never contracted, and the functions built on them (see [`crate::function`]) run the
//! same steps in every lane type.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A vector of `WIDTH` numbers.
pub(crate) trait Lane:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// How many numbers.
    const WIDTH: usize;

    /// The same number everywhere.
    fn splat(value: f64) -> Self;

    /// Reads `WIDTH` numbers.
    ///
    /// # Safety
    /// `from` must be valid for reading `WIDTH` numbers.
    unsafe fn load(from: *const f64) -> Self;

    /// Writes `WIDTH` numbers.
    ///
    /// # Safety
    /// `to` must be valid for writing `WIDTH` numbers.
    unsafe fn store(self, to: *mut f64);

    /// √a
    fn root(self) -> Self;

    /// `a` where `self >= bound`, else `b`; `b` where either is NaN.
    fn where_at_least(self, bound: Self, a: Self, b: Self) -> Self;

    /// `a` where the sign bit of `self` is set, else `b`.
    fn where_sign(self, a: Self, b: Self) -> Self;

    /// The bits, shifted up; zeros follow.
    fn shift_bits<const BY: i32>(self) -> Self;

    /// Bitwise and.
    fn and(self, other: Self) -> Self;

    /// Bitwise exclusive or.
    fn xor(self, other: Self) -> Self;

    /// Bits added as 64-bit integers.
    fn add_bits(self, other: Self) -> Self;

    /// Whether every |element| is at most `bound`; NaN is not.
    fn all_within(self, bound: f64) -> bool;

    /// Element by element.
    fn map(self, function: impl Fn(f64) -> f64) -> Self;
}

impl Lane for f64 {
    const WIDTH: usize = 1;

    #[inline(always)]
    fn splat(value: f64) -> Self {
        value
    }

    #[inline(always)]
    unsafe fn load(from: *const f64) -> Self {
        // SAFETY: the caller's.
        unsafe { from.read() }
    }

    #[inline(always)]
    unsafe fn store(self, to: *mut f64) {
        // SAFETY: the caller's.
        unsafe { to.write(self) }
    }

    #[inline(always)]
    fn root(self) -> Self {
        self.sqrt()
    }

    #[inline(always)]
    fn where_at_least(self, bound: Self, a: Self, b: Self) -> Self {
        if self >= bound { a } else { b }
    }

    #[inline(always)]
    fn where_sign(self, a: Self, b: Self) -> Self {
        if self.is_sign_negative() { a } else { b }
    }

    #[inline(always)]
    fn shift_bits<const BY: i32>(self) -> Self {
        f64::from_bits(self.to_bits() << BY)
    }

    #[inline(always)]
    fn and(self, other: Self) -> Self {
        f64::from_bits(self.to_bits() & other.to_bits())
    }

    #[inline(always)]
    fn xor(self, other: Self) -> Self {
        f64::from_bits(self.to_bits() ^ other.to_bits())
    }

    #[inline(always)]
    fn add_bits(self, other: Self) -> Self {
        f64::from_bits(self.to_bits().wrapping_add(other.to_bits()))
    }

    #[inline(always)]
    fn all_within(self, bound: f64) -> bool {
        self.abs() <= bound
    }

    #[inline(always)]
    fn map(self, function: impl Fn(f64) -> f64) -> Self {
        function(self)
    }
}
