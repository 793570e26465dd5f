//! Power series in one variable, to the third power.

use std::ops::{Add, Div, Mul, Sub};

/// c_0 + c_1 φ + c_2 φ² + c_3 φ³
#[derive(Debug, Clone, Copy)]
pub struct Series(pub [f64; 4]);

impl Series {
    pub fn constant(value: f64) -> Self {
        Self([value, 0.0, 0.0, 0.0])
    }

    /// Loses the highest power, which is set to zero.
    pub fn derivative(self) -> Self {
        let [_, b, c, d] = self.0;
        Self([b, 2.0 * c, 3.0 * d, 0.0])
    }

    pub fn sin(self) -> Self {
        self.sine_and_cosine().0
    }

    pub fn cos(self) -> Self {
        self.sine_and_cosine().1
    }

    /// s' = a' c and c' = −a' s, power by power.
    fn sine_and_cosine(self) -> (Self, Self) {
        let (mut s, mut c) = (Self::constant(self.0[0].sin()), Self::constant(self.0[0].cos()));
        let slope = self.derivative();
        for power in 0..3 {
            let next = (power + 1) as f64;
            let (rise, fall) = ((slope * c).0[power] / next, (slope * s).0[power] / next);
            s.0[power + 1] = rise;
            c.0[power + 1] = -fall;
        }
        (s, c)
    }
}

impl Add for Series {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] + other.0[i]))
    }
}

impl Sub for Series {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] - other.0[i]))
    }
}

impl Mul for Series {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| (0..=i).map(|j| self.0[j] * other.0[i - j]).sum()))
    }
}

impl Div for Series {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let mut quotient = [0.0; 4];
        for i in 0..4 {
            let known: f64 = (0..i).map(|j| quotient[j] * other.0[i - j]).sum();
            quotient[i] = (self.0[i] - known) / other.0[0];
        }
        Self(quotient)
    }
}
