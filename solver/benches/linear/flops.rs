//! Arithmetic of the elimination, counted by running it on numbers that count.

use crate::linear::chain::{Block, Chain, Intervals, Sizes};
use crate::linear::memory::Kept;
use crate::linear::reflect::{Rows, with_rows};
use crate::linear::scalar::Scalar;
use std::cell::Cell;
use std::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

thread_local! {
    static COUNT: Cell<u64> = const { Cell::new(0) };
}

/// A number; each operation on it is one, whatever it costs.
#[derive(Clone, Copy, Debug)]
struct Counted(f64);

fn counted(value: f64) -> Counted {
    COUNT.set(COUNT.get() + 1);
    Counted(value)
}

impl Scalar for Counted {
    const ZERO: Self = Self(0.0);
    const ONE: Self = Self(1.0);

    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        counted(f(self.0))
    }

    /// A bit moved is no arithmetic.
    fn copysign(self, sign: Self) -> Self {
        Self(self.0.copysign(sign.0))
    }
}

// SAFETY: it is a number.
unsafe impl Kept for Counted {}

macro_rules! counting {
    ($($trait:ident $method:ident $op:tt;)*) => {$(
        impl $trait for Counted {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                counted(self.0 $op other.0)
            }
        }
    )*};
}
counting! { Add add +; Sub sub -; Mul mul *; }

impl Neg for Counted {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl AddAssign for Counted {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Counted {
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

/// Intervals that differ little from unit steps.
struct Plain;

impl Intervals<Counted> for Plain {
    fn fill<R: Rows>(&mut self, rows: R, _: usize, block: &mut Block<&mut [Counted]>) {
        let n = rows.n();
        for i in 0..n {
            block.a[i * n + i] = Counted(-1.0);
            block.b[i * n + i] = Counted(1.0);
        }
    }
}

/// Operations an interval: of the factorisation, and of one solve.
pub fn an_interval(shape: Sizes) -> (f64, f64) {
    const STEPS: usize = 64;
    let (mut rhs, mut u) = (vec![Counted(1.0); STEPS * shape.n], vec![Counted(1.0); (STEPS + 1) * shape.n]);
    let (mut functionals, constants) = (vec![Counted(0.0); shape.k], vec![Counted(1.0); shape.p]);
    let mut chain = Chain::<Counted>::new(shape, STEPS);
    let before = COUNT.get();
    with_rows!(shape.n, rows => chain.factor(rows, Plain));
    let factored = COUNT.get();
    with_rows!(shape.n, rows => {
        chain.forward(rows, &mut rhs, &mut functionals);
        chain.backward(rows, &rhs, &constants, &mut u);
    });
    let each = |operations: u64| operations as f64 / (STEPS - 1) as f64;
    (each(factored - before), each(COUNT.get() - factored))
}
