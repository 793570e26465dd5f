//! Forward-mode dual numbers, and what the slow twins ask of a number. Not every test uses all of it.
#![allow(dead_code)]

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number that the twins compute with.
pub trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    fn number(value: f64) -> Self;
    fn power(self, exponent: i32) -> Self;
    fn sin(self) -> Self;
    fn cos(self) -> Self;
    fn tan(self) -> Self;
    fn sqrt(self) -> Self;
    fn tanh(self) -> Self;
    fn exp(self) -> Self;
    fn ln(self) -> Self;
    /// min(1, ·)
    fn saturate(self) -> Self;
    /// The angle of (self, other).
    fn angle(self, other: Self) -> Self;
    /// To [0, 2π).
    fn turn(self) -> Self;
}

/// a + b ε with ε² = 0.
#[derive(Debug, Clone, Copy)]
pub struct Dual(pub f64, pub f64);

impl Dual {
    fn chain(self, value: f64, slope: f64) -> Self {
        Self(value, slope * self.1)
    }
}

impl Number for Dual {
    fn number(value: f64) -> Self {
        Self(value, 0.0)
    }
    fn power(self, exponent: i32) -> Self {
        self.chain(self.0.powi(exponent), f64::from(exponent) * self.0.powi(exponent - 1))
    }
    fn sin(self) -> Self {
        self.chain(self.0.sin(), self.0.cos())
    }
    fn cos(self) -> Self {
        self.chain(self.0.cos(), -self.0.sin())
    }
    fn tan(self) -> Self {
        self.chain(self.0.tan(), self.0.cos().powi(-2))
    }
    fn sqrt(self) -> Self {
        self.chain(self.0.sqrt(), 0.5 / self.0.sqrt())
    }
    fn tanh(self) -> Self {
        self.chain(self.0.tanh(), 1.0 - self.0.tanh().powi(2))
    }
    fn exp(self) -> Self {
        self.chain(self.0.exp(), self.0.exp())
    }
    fn ln(self) -> Self {
        self.chain(self.0.ln(), 1.0 / self.0)
    }
    fn saturate(self) -> Self {
        if self.0 < 1.0 { self } else { Self(1.0, 0.0) }
    }
    fn angle(self, other: Self) -> Self {
        let square = self.0 * self.0 + other.0 * other.0;
        Self(other.0.atan2(self.0), (self.0 * other.1 - other.0 * self.1) / square)
    }
    fn turn(self) -> Self {
        self.chain(self.0.rem_euclid(2.0 * std::f64::consts::PI), 1.0)
    }
}

impl Add for Dual {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0, self.1 + other.1)
    }
}

impl Sub for Dual {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0, self.1 - other.1)
    }
}

impl Mul for Dual {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0, self.1 * other.0 + self.0 * other.1)
    }
}

impl Div for Dual {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let quotient = self.0 / other.0;
        Self(quotient, (self.1 - quotient * other.1) / other.0)
    }
}

impl Neg for Dual {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}
