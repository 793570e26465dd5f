//! Closures, and where their derivatives come from.

use super::number::{Number, WIDTH};

/// Right-hand side `f(x, y, p)` and boundary residuals `g(y(a), y(b), p)`, with the derivatives of both.
///
/// Derivatives are written by columns: those of all rows with respect to the first input, then to the next.
pub trait Formulas {
    /// `f(x, y, p)`.
    fn rhs(&self, x: f64, y: &[f64], p: &[f64], f: &mut [f64]);

    /// `f`, and its derivatives with respect to `y`, then `p`.
    fn rhs_derivatives(&self, x: f64, y: &[f64], p: &[f64], f: &mut [f64], columns: &mut [f64]);

    /// `g(a, b, p)`.
    fn boundary(&self, a: &[f64], b: &[f64], p: &[f64], g: &mut [f64]);

    /// `g`, and its derivatives with respect to `a`, then `b`, then `p`.
    fn boundary_derivatives(&self, a: &[f64], b: &[f64], p: &[f64], g: &mut [f64], columns: &mut [f64]);
}

/// Closures of [`Number`]s: derivatives are exact.
#[derive(Debug, Clone)]
pub struct Exact<F, B> {
    pub(super) f: F,
    pub(super) bc: B,
}

/// Closures of `f64`s: derivatives by forward differences, good for some eight digits, which Newton's iteration is
/// content with.
#[derive(Debug, Clone)]
pub struct Differenced<F, B> {
    pub(super) f: F,
    pub(super) bc: B,
}

impl<F, B> Formulas for Exact<F, B>
where
    F: Fn(f64, &[Number], &[Number], &mut [Number]),
    B: Fn(&[Number], &[Number], &[Number], &mut [Number]),
{
    fn rhs(&self, x: f64, y: &[f64], p: &[f64], f: &mut [f64]) {
        values(&[y, p], f, |inputs, out| {
            let (y, p) = inputs.split_at(y.len());
            (self.f)(x, y, p, out);
        });
    }

    fn rhs_derivatives(&self, x: f64, y: &[f64], p: &[f64], f: &mut [f64], columns: &mut [f64]) {
        differentiate(&[y, p], f, columns, |inputs, out| {
            let (y, p) = inputs.split_at(y.len());
            (self.f)(x, y, p, out);
        });
    }

    fn boundary(&self, a: &[f64], b: &[f64], p: &[f64], g: &mut [f64]) {
        values(&[a, b, p], g, |inputs, out| {
            let (a, rest) = inputs.split_at(a.len());
            let (b, p) = rest.split_at(b.len());
            (self.bc)(a, b, p, out);
        });
    }

    fn boundary_derivatives(&self, a: &[f64], b: &[f64], p: &[f64], g: &mut [f64], columns: &mut [f64]) {
        differentiate(&[a, b, p], g, columns, |inputs, out| {
            let (a, rest) = inputs.split_at(a.len());
            let (b, p) = rest.split_at(b.len());
            (self.bc)(a, b, p, out);
        });
    }
}

fn lifted(inputs: &[&[f64]]) -> Vec<Number> {
    inputs.iter().flat_map(|part| part.iter().map(|&value| Number::constant(value))).collect()
}

fn values(inputs: &[&[f64]], out: &mut [f64], evaluate: impl Fn(&[Number], &mut [Number])) {
    let mut numbers = vec![Number::constant(0.0); out.len()];
    evaluate(&lifted(inputs), &mut numbers);
    out.iter_mut().zip(numbers).for_each(|(out, number)| *out = number.value());
}

/// As many inputs at a time as a number carries derivatives.
fn differentiate(inputs: &[&[f64]], out: &mut [f64], columns: &mut [f64], evaluate: impl Fn(&[Number], &mut [Number])) {
    let plain = lifted(inputs);
    let rows = out.len();
    for (first, chunk) in columns.chunks_mut(WIDTH * rows).enumerate() {
        let mut seeded = plain.clone();
        let mut numbers = vec![Number::constant(0.0); rows];
        for (direction, number) in seeded.iter_mut().skip(first * WIDTH).take(WIDTH).enumerate() {
            *number = Number::input(number.value(), direction);
        }
        evaluate(&seeded, &mut numbers);
        for (direction, column) in chunk.chunks_mut(rows).enumerate() {
            column.iter_mut().zip(&numbers).for_each(|(out, number)| *out = number.derivative(direction));
        }
        out.iter_mut().zip(&numbers).for_each(|(out, number)| *out = number.value());
    }
}

impl<F, B> Formulas for Differenced<F, B>
where
    F: Fn(f64, &[f64], &[f64], &mut [f64]),
    B: Fn(&[f64], &[f64], &[f64], &mut [f64]),
{
    fn rhs(&self, x: f64, y: &[f64], p: &[f64], f: &mut [f64]) {
        (self.f)(x, y, p, f);
    }

    fn rhs_derivatives(&self, x: f64, y: &[f64], p: &[f64], f: &mut [f64], columns: &mut [f64]) {
        difference(&[y, p], f, columns, |inputs, out| {
            let (y, p) = inputs.split_at(y.len());
            (self.f)(x, y, p, out);
        });
    }

    fn boundary(&self, a: &[f64], b: &[f64], p: &[f64], g: &mut [f64]) {
        (self.bc)(a, b, p, g);
    }

    fn boundary_derivatives(&self, a: &[f64], b: &[f64], p: &[f64], g: &mut [f64], columns: &mut [f64]) {
        difference(&[a, b, p], g, columns, |inputs, out| {
            let (a, rest) = inputs.split_at(a.len());
            let (b, p) = rest.split_at(b.len());
            (self.bc)(a, b, p, out);
        });
    }
}

/// Forward differences, with steps of half the digits of the input, at least of 1.
fn difference(inputs: &[&[f64]], out: &mut [f64], columns: &mut [f64], evaluate: impl Fn(&[f64], &mut [f64])) {
    let mut inputs = inputs.concat();
    evaluate(&inputs, out);
    for (input, column) in columns.chunks_exact_mut(out.len()).enumerate() {
        let value = inputs[input];
        inputs[input] = value + f64::EPSILON.sqrt() * value.abs().max(1.0).copysign(value);
        let step = inputs[input] - value;
        evaluate(&inputs, column);
        column.iter_mut().zip(out.iter()).for_each(|(moved, here)| *moved = (*moved - here) / step);
        inputs[input] = value;
    }
}
