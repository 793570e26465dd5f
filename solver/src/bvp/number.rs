//! The number that closures are evaluated with.

use crate::model::{Scalar, power};
use num_dual::{DualNum, DualSVec64};
use std::iter::Sum;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// Derivatives that one evaluation carries.
pub(super) const WIDTH: usize = 4;

/// A number that carries derivatives: plain arithmetic, with an `f64` on either side, and the elementary functions.
///
/// Comparisons compare values. The type is this crate's own, whatever carries the derivatives inside.
#[derive(Debug, Clone, Copy)]
pub struct Number(DualSVec64<WIDTH>);

impl Number {
    /// A number that depends on nothing.
    pub fn constant(value: f64) -> Self {
        Self(DualSVec64::from_re(value))
    }

    /// The value, without derivatives.
    pub fn value(self) -> f64 {
        self.0.re
    }

    /// An input: its derivative in `direction` is 1.
    pub(super) fn input(value: f64, direction: usize) -> Self {
        Self(DualSVec64::from_re(value).derivative(direction))
    }

    pub(super) fn derivative(&self, direction: usize) -> f64 {
        self.0.eps.0.as_ref().map_or(0.0, |values| values[direction])
    }

    /// A function of `self` by its value and its slope there.
    fn chained(self, value: f64, slope: f64) -> Self {
        let mut image = self.0 * slope;
        image.re = value;
        Self(image)
    }

    /// `self` to a whole power.
    #[must_use]
    pub fn powi(self, exponent: i32) -> Self {
        // Of num-dual's own, those below 3 are not a number at 0.
        let slope = if exponent == 0 { 0.0 } else { f64::from(exponent) * self.value().powi(exponent - 1) };
        self.chained(self.value().powi(exponent), slope)
    }

    /// `self` to a constant power.
    #[must_use]
    pub fn powf(self, exponent: f64) -> Self {
        let [value, slope] = power(self.value(), exponent);
        self.chained(value, slope)
    }

    /// Hyperbolic tangent.
    #[must_use]
    pub fn tanh(self) -> Self {
        Self(self.0.hyperbolic_tangent())
    }

    /// The magnitude; its derivative at 0 is 0.
    #[must_use]
    pub fn abs(self) -> Self {
        match self.value() {
            value if value < 0.0 => -self,
            value if value > 0.0 => self,
            value => Self::constant(value.abs()),
        }
    }

    /// The larger of two; of two that are alike the first.
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        if other.value() > self.value() { other } else { self }
    }

    /// The smaller of two; of two that are alike the first.
    #[must_use]
    pub fn min(self, other: Self) -> Self {
        if other.value() < self.value() { other } else { self }
    }
}

macro_rules! functions {
    ($($name:ident $what:literal;)*) => {
        impl Number {$(
            #[doc = $what]
            #[must_use]
            pub fn $name(self) -> Self {
                Self(self.0.$name())
            }
        )*}
    };
}
functions! {
    sqrt "Square root.";
    cbrt "Cube root.";
    recip "Reciprocal.";
    exp "Exponential.";
    ln "Natural logarithm.";
    sin "Sine.";
    cos "Cosine.";
    tan "Tangent.";
    asin "Arc sine.";
    acos "Arc cosine.";
    atan "Arc tangent.";
    sinh "Hyperbolic sine.";
    cosh "Hyperbolic cosine.";
}

macro_rules! operators {
    ($($trait:ident $method:ident $assign:ident $assign_method:ident $op:tt;)*) => {$(
        impl $trait for Number {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self(self.0 $op other.0)
            }
        }
        impl $trait<f64> for Number {
            type Output = Self;
            fn $method(self, other: f64) -> Self {
                Self(self.0 $op other)
            }
        }
        impl $trait<Number> for f64 {
            type Output = Number;
            fn $method(self, other: Number) -> Number {
                Number::constant(self) $op other
            }
        }
        impl $assign for Number {
            fn $assign_method(&mut self, other: Self) {
                *self = *self $op other;
            }
        }
        impl $assign<f64> for Number {
            fn $assign_method(&mut self, other: f64) {
                *self = *self $op other;
            }
        }
    )*};
}
operators! {
    Add add AddAssign add_assign +;
    Sub sub SubAssign sub_assign -;
    Mul mul MulAssign mul_assign *;
    Div div DivAssign div_assign /;
}

impl Neg for Number {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl From<f64> for Number {
    fn from(value: f64) -> Self {
        Self::constant(value)
    }
}

impl Sum for Number {
    fn sum<I: Iterator<Item = Self>>(numbers: I) -> Self {
        numbers.fold(Self::constant(0.0), |sum, number| sum + number)
    }
}

impl PartialEq for Number {
    fn eq(&self, other: &Self) -> bool {
        self.value() == other.value()
    }
}

impl PartialEq<f64> for Number {
    fn eq(&self, other: &f64) -> bool {
        self.value() == *other
    }
}

impl PartialOrd for Number {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        self.value().partial_cmp(&other.value())
    }
}

impl PartialOrd<f64> for Number {
    fn partial_cmp(&self, other: &f64) -> Option<std::cmp::Ordering> {
        self.value().partial_cmp(other)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_function_has_the_derivative_of_its_values() {
        type Function = (&'static str, fn(Number) -> Number);
        let functions: [Function; 24] = [
            ("sqrt", Number::sqrt),
            ("cbrt", Number::cbrt),
            ("recip", Number::recip),
            ("exp", Number::exp),
            ("ln", Number::ln),
            ("sin", Number::sin),
            ("cos", Number::cos),
            ("tan", Number::tan),
            ("asin", Number::asin),
            ("acos", Number::acos),
            ("atan", Number::atan),
            ("sinh", Number::sinh),
            ("cosh", Number::cosh),
            ("tanh", Number::tanh),
            ("abs", |x| (x - 1.0).abs()),
            ("powi", |x| x.powi(3)),
            ("powf", |x| x.powf(1.7)),
            ("max", |x| (x * 2.0).max(x + 5.0)),
            ("min", |x| (x * 2.0).min(x + 5.0)),
            ("f64 - x", |x| 2.0 - x),
            ("f64 / x", |x| 2.0 / x),
            ("x - f64", |x| x - 2.0),
            ("x / f64", |x| x / 2.0),
            ("assignments", |x| {
                let mut y = x;
                y += x;
                y *= x;
                y -= 0.5;
                y /= x;
                y
            }),
        ];
        let (x, h) = (0.37, 1e-6);
        for (name, f) in functions {
            let value = |x: f64| f(Number::constant(x)).value();
            let difference = (value(x + h) - value(x - h)) / (2.0 * h);
            let exact = f(Number::input(x, 2));
            assert!((exact.derivative(2) - difference).abs() < 1e-8 * (1.0 + difference.abs()), "{name}");
            assert_eq!((exact.value(), exact.derivative(1)), (value(x), 0.0), "{name}");
        }
        // Where powers and quotients of what overflows or vanishes would be none.
        let at =
            |x: f64, f: fn(Number) -> Number| (f(Number::input(x, 0)).value(), f(Number::input(x, 0)).derivative(0));
        assert_eq!(at(0.0, |x| x.powf(1.5)), (0.0, 0.0));
        assert_eq!(at(0.0, |x| x.powf(1.0)), (0.0, 1.0));
        assert_eq!(at(-2.0, |x| x.powf(3.0)), (-8.0, 12.0));
        assert_eq!(at(0.0, |x| x.powf(0.0)), (1.0, 0.0));
        assert_eq!(at(1e-210, |x| x.powf(1.5)).1, 1.5 * 1e-105);
        assert_eq!(at(0.0, |x| x.powi(2)), (0.0, 0.0));
        assert_eq!(at(0.0, |x| x.powi(0)), (1.0, 0.0));
        assert_eq!(at(2.0, |x| x.powi(-1)), (0.5, -0.25));
        assert_eq!(at(0.0, |x| x.powi(-1)).0, f64::INFINITY);
        assert_eq!(at(800.0, Number::tanh), (1.0, 0.0));
        assert_eq!(at(-800.0, Number::tanh), (-1.0, 0.0));
        assert!(Number::constant(1.0) < 2.0 && Number::constant(1.0) == 1.0);
        assert_eq!([1.0, 2.0].map(Number::constant).into_iter().sum::<Number>(), 3.0);
        assert_eq!(Number::input(0.0, 0).abs().derivative(0), 0.0);
    }
}
