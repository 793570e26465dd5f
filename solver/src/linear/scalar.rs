//! Numbers the elimination runs on: one `f64`, or a lane of several chains in lock step.

use std::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

/// Chains that are eliminated side by side; one AVX register of doubles.
pub(crate) const W: usize = 4;

/// What the elimination needs of a number. No fused multiply-add: chains are eliminated alike on every machine.
pub(crate) trait Scalar:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self> + AddAssign + SubAssign
{
    const ZERO: Self;
    const ONE: Self;
    fn map(self, f: impl Fn(f64) -> f64) -> Self;
    fn copysign(self, sign: Self) -> Self;

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.map(f64::sqrt)
    }

    #[inline(always)]
    fn recip(self) -> Self {
        self.map(|x| 1.0 / x)
    }

    #[inline(always)]
    fn abs(self) -> Self {
        self.map(f64::abs)
    }

    #[inline(always)]
    fn times(self, factor: f64) -> Self {
        self.map(|x| x * factor)
    }
}

impl Scalar for f64 {
    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;

    #[inline(always)]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        f(self)
    }

    #[inline(always)]
    fn copysign(self, sign: Self) -> Self {
        f64::copysign(self, sign)
    }
}

/// `W` numbers, one of each chain.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub(crate) struct Lane(pub [f64; W]);

impl Lane {
    #[inline(always)]
    pub(crate) fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let mut out = self.0;
        for (a, b) in out.iter_mut().zip(other.0) {
            *a = f(*a, b);
        }
        Self(out)
    }

    /// The larger number of each lane; this one's where the other's is NaN. One instruction, where `f64::max` is
    /// several.
    #[inline(always)]
    pub(crate) fn or_larger(self, other: Self) -> Self {
        self.zip(other, |most, x| if x > most { x } else { most })
    }
}

impl Scalar for Lane {
    const ZERO: Self = Self([0.0; W]);
    const ONE: Self = Self([1.0; W]);

    #[inline(always)]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        let mut out = self.0;
        for a in &mut out {
            *a = f(*a);
        }
        Self(out)
    }

    #[inline(always)]
    fn copysign(self, sign: Self) -> Self {
        self.zip(sign, f64::copysign)
    }
}

macro_rules! lanewise {
    ($($trait:ident $method:ident $op:tt;)*) => {$(
        impl $trait for Lane {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.zip(other, |a, b| a $op b)
            }
        }
    )*};
}
lanewise! { Add add +; Sub sub -; Mul mul *; }

impl Neg for Lane {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(|x| -x)
    }
}

impl AddAssign for Lane {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Lane {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}
