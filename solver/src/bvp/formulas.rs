//! Closures, and where their derivatives come from.

use super::buffer;
use super::groups::Groups;
use super::number::{Number, WIDTH};

/// Right-hand side `f(x, y, p)` and boundary residuals `g(y(a), y(b), p)`, with the derivatives of both.
///
/// Derivatives are written by columns: those of all rows with respect to the first input, then to the next.
pub trait Formulas {
    /// Whether derivatives are exact but for rounding, so that [`Bvp::linear`](super::Bvp::linear) can rely on them.
    const EXACT: bool = true;

    /// `f(x, y, p)`.
    fn rhs(&self, x: f64, y: &[f64], p: &[f64], f: &mut [f64]);

    /// `f`, and its derivatives with respect to `y`, then `p`.
    fn rhs_derivatives(&self, x: f64, y: &[f64], p: &[f64], f: &mut [f64], columns: &mut [f64]);

    /// `g(a, b, p)`.
    fn boundary(&self, a: &[f64], b: &[f64], p: &[f64], g: &mut [f64]);

    /// `g`, and its derivatives with respect to `a`, then `b`, then `p`.
    fn boundary_derivatives(&self, a: &[f64], b: &[f64], p: &[f64], g: &mut [f64], columns: &mut [f64]);

    /// Takes in the typical magnitudes of all states and all parameters, 1 where none is stated. Derivatives that are
    /// differences need them for their steps; exact ones do not.
    fn take_magnitudes(&mut self, _states: &[f64], _parameters: &[f64]) {}
}

/// Closures of [`Number`]s: derivatives are exact.
#[derive(Debug, Clone)]
pub struct Exact<F, B> {
    f: F,
    bc: B,
    groups: Option<Groups>,
}

/// Closures of `f64`s: derivatives by forward differences, good for some eight digits, which Newton's iteration is
/// content with. Each input is moved by half the digits of its value, or of its typical magnitude if that is larger;
/// and by more where that is lost in the rounding of what comes out, as 1e-8 is beside 1e10.
#[derive(Debug, Clone)]
pub struct Differenced<F, B> {
    f: F,
    bc: B,
    groups: Option<Groups>,
    magnitudes: Magnitudes,
}

/// Typical magnitudes; 1 of what has none.
#[derive(Debug, Clone, Default)]
struct Magnitudes {
    states: Vec<f64>,
    parameters: Vec<f64>,
}

/// Formulas whose derivatives come from evaluations: from fewer of them where it is known what depends on what, see
/// [`Bvp::sparse`](super::Bvp::sparse).
pub trait Evaluated: Formulas {
    /// How many values f writes, of so many states.
    fn values(&self, states: usize) -> usize;

    /// With states in groups.
    #[must_use]
    fn grouped(self, groups: Groups) -> Self;
}

impl<F, B> Exact<F, B> {
    /// Of `f(x, y, p, out)` and `g(y(a), y(b), p, out)`.
    pub fn new(f: F, bc: B) -> Self {
        Self { f, bc, groups: None }
    }
}

impl<F, B> Differenced<F, B> {
    /// Of `f(x, y, p, out)` and `g(y(a), y(b), p, out)`.
    pub fn new(f: F, bc: B) -> Self {
        Self { f, bc, groups: None, magnitudes: Magnitudes::default() }
    }
}

/// What both kinds of closures share.
macro_rules! of_closures {
    ($($kind:ident),+) => {$(
        impl<F, B> Evaluated for $kind<F, B>
        where
            Self: Formulas,
        {
            fn values(&self, states: usize) -> usize {
                states
            }

            fn grouped(self, groups: Groups) -> Self {
                Self { groups: Some(groups), ..self }
            }
        }
    )+};
}

of_closures!(Exact, Differenced);

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
        let evaluate = |inputs: &[Number], out: &mut [Number]| {
            let (y, p) = inputs.split_at(y.len());
            (self.f)(x, y, p, out);
        };
        match &self.groups {
            Some(groups) => differentiate_groups(groups, [y, p], f, columns, evaluate),
            None => differentiate(&[y, p], f, columns, evaluate),
        }
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

/// Numbers of one evaluation, inputs and results, that need no memory of their own: closures are called so often that
/// asking for memory would take as long as they do.
const ROOM: usize = 16;

#[inline]
fn values<const PARTS: usize>(inputs: &[&[f64]; PARTS], out: &mut [f64], evaluate: impl Fn(&[Number], &mut [Number])) {
    let count: usize = inputs.iter().map(|part| part.len()).sum();
    let (mut room, mut more) = ([Number::constant(0.0); ROOM], Vec::new());
    let (lifted, results) = buffer(&mut room, &mut more, count + out.len()).split_at_mut(count);
    lift(inputs, lifted);
    evaluate(lifted, results);
    out.iter_mut().zip(results).for_each(|(out, number)| *out = number.value());
}

#[inline]
fn lift<const PARTS: usize>(inputs: &[&[f64]; PARTS], lifted: &mut [Number]) {
    let values = inputs.iter().flat_map(|part| part.iter());
    lifted.iter_mut().zip(values).for_each(|(number, &value)| *number = Number::constant(value));
}

/// As many inputs at a time as a number carries derivatives.
#[inline]
fn differentiate<const PARTS: usize>(
    inputs: &[&[f64]; PARTS],
    out: &mut [f64],
    columns: &mut [f64],
    evaluate: impl Fn(&[Number], &mut [Number]),
) {
    let rows = out.len();
    let count: usize = inputs.iter().map(|part| part.len()).sum();
    let (mut room, mut more) = ([Number::constant(0.0); ROOM], Vec::new());
    let (seeded, results) = buffer(&mut room, &mut more, count + rows).split_at_mut(count);
    for (first, chunk) in columns.chunks_mut(WIDTH * rows).enumerate() {
        lift(inputs, seeded);
        for (direction, number) in seeded.iter_mut().skip(first * WIDTH).take(WIDTH).enumerate() {
            *number = Number::input(number.value(), direction);
        }
        results.fill(Number::constant(0.0));
        evaluate(seeded, results);
        for (direction, column) in chunk.chunks_mut(rows).enumerate() {
            column.iter_mut().zip(&*results).for_each(|(out, number)| *out = number.derivative(direction));
        }
        out.iter_mut().zip(&*results).for_each(|(out, number)| *out = number.value());
    }
}

/// All states of a group in one direction, each parameter in one of its own.
fn differentiate_groups(
    groups: &Groups,
    [y, p]: [&[f64]; 2],
    out: &mut [f64],
    columns: &mut [f64],
    evaluate: impl Fn(&[Number], &mut [Number]),
) {
    let (rows, shifts) = (out.len(), vec![0.0; groups.count()]);
    let (by_states, by_parameters) = columns.split_at_mut(y.len() * rows);
    let mut found = vec![0.0; shifts.len() * rows + by_parameters.len()];
    differentiate(&[&shifts, p], out, &mut found, |inputs, out| {
        let (shifts, p) = inputs.split_at(shifts.len());
        let states = y.iter().zip(groups.of()).map(|(y, group)| shifts[*group] + *y);
        let inputs: Vec<Number> = states.chain(p.iter().copied()).collect();
        evaluate(&inputs, out);
    });
    let (by_groups, of_parameters) = found.split_at(shifts.len() * rows);
    by_parameters.copy_from_slice(of_parameters);
    by_states.fill(0.0);
    for (group, found) in by_groups.chunks_exact(rows).enumerate() {
        groups.entries(group).iter().for_each(|&(row, state)| by_states[state * rows + row] = found[row]);
    }
}

impl<F, B> Formulas for Differenced<F, B>
where
    F: Fn(f64, &[f64], &[f64], &mut [f64]),
    B: Fn(&[f64], &[f64], &[f64], &mut [f64]),
{
    const EXACT: bool = false;

    fn rhs(&self, x: f64, y: &[f64], p: &[f64], f: &mut [f64]) {
        (self.f)(x, y, p, f);
    }

    fn rhs_derivatives(&self, x: f64, y: &[f64], p: &[f64], f: &mut [f64], columns: &mut [f64]) {
        let evaluate = |inputs: &[f64], out: &mut [f64]| {
            let (y, p) = inputs.split_at(y.len());
            (self.f)(x, y, p, out);
        };
        let Magnitudes { states, parameters } = &self.magnitudes;
        let parts = [(y, &states[..]), (p, &parameters[..])];
        match &self.groups {
            Some(groups) => difference_groups(groups, parts, f, columns, evaluate),
            None => difference(&parts, f, columns, evaluate),
        }
    }

    fn boundary(&self, a: &[f64], b: &[f64], p: &[f64], g: &mut [f64]) {
        (self.bc)(a, b, p, g);
    }

    fn boundary_derivatives(&self, a: &[f64], b: &[f64], p: &[f64], g: &mut [f64], columns: &mut [f64]) {
        let Magnitudes { states, parameters } = &self.magnitudes;
        difference(&[(a, states), (b, states), (p, parameters)], g, columns, |inputs, out| {
            let (a, rest) = inputs.split_at(a.len());
            let (b, p) = rest.split_at(b.len());
            (self.bc)(a, b, p, out);
        });
    }

    fn take_magnitudes(&mut self, states: &[f64], parameters: &[f64]) {
        self.magnitudes = Magnitudes { states: states.to_vec(), parameters: parameters.to_vec() };
    }
}

/// Values, and the typical magnitudes of the first of them: those of the others are 1.
type Part<'a> = (&'a [f64], &'a [f64]);

/// Forward differences, with steps of half the digits of the input, at least of its typical magnitude.
fn difference(parts: &[Part<'_>], out: &mut [f64], columns: &mut [f64], evaluate: impl Fn(&[f64], &mut [f64])) {
    let (mut room, mut more) = ([0.0; super::ROOM], Vec::new());
    let inputs = buffer(&mut room, &mut more, parts.iter().map(|(part, _)| part.len()).sum());
    let values = parts.iter().flat_map(|(values, _)| values.iter());
    inputs.iter_mut().zip(values).for_each(|(input, &value)| *input = value);
    evaluate(inputs, out);
    let magnitudes =
        parts.iter().flat_map(|(values, magnitudes)| (0..values.len()).map(move |i| magnitude(magnitudes, i)));
    for ((input, magnitude), column) in magnitudes.enumerate().zip(columns.chunks_exact_mut(out.len())) {
        let value = inputs[input];
        inputs[input] = stepped(value, magnitude);
        let step = inputs[input] - value;
        evaluate(inputs, column);
        let lost = lost(column.iter().zip(out.iter()).map(|(moved, here)| (*moved, *here, step)));
        column.iter_mut().zip(out.iter()).for_each(|(moved, here)| *moved = (*moved - here) / step);
        retaken(lost, |rows, length| {
            let mut again = vec![0.0; out.len()];
            inputs[input] = value + length.copysign(value);
            evaluate(inputs, &mut again);
            let step = inputs[input] - value;
            rows.retain(|&row| {
                let told = is_told(again[row], out[row]);
                if told {
                    column[row] = (again[row] - out[row]) / step;
                }
                !told
            });
        });
        inputs[input] = value;
    }
}

/// A change of no more units in the last place than this is rounding.
const ROUNDED: f64 = 16.0 * f64::EPSILON;
/// Steps that are tried where the first is lost in a value's rounding, as parts of that value: the shorter leaves five
/// digits of a derivative about 1, the longer half of all digits.
const LONGER: [f64; 2] = [65_536.0 * f64::EPSILON, 67_108_864.0 * f64::EPSILON];

/// Of differences, each with what a value is after the step, what it is before, and the step: those in which the step
/// is lost in the rounding of the value, and the largest value that does that. None if none is.
fn lost(differences: impl Iterator<Item = (f64, f64, f64)>) -> Option<(Vec<usize>, f64)> {
    let (mut all, mut size) = (Vec::new(), 0.0_f64);
    for (index, (moved, here, step)) in differences.enumerate() {
        // Where the step is longer than that, a derivative that is lost is far below 1, and of no account.
        if here.is_finite() && ROUNDED * here.abs() > step.abs() && !is_told(moved, here) && moved.is_finite() {
            all.push(index);
            size = size.max(here.abs());
        }
    }
    (!all.is_empty()).then_some((all, size))
}

/// Takes differences that are lost again, in steps of the lengths that [`LONGER`] makes of the largest value, until
/// `take` has left none.
fn retaken(lost: Option<(Vec<usize>, f64)>, mut take: impl FnMut(&mut Vec<usize>, f64)) {
    let Some((mut left, size)) = lost else { return };
    for longer in LONGER {
        take(&mut left, longer * size);
        if left.is_empty() {
            return;
        }
    }
}

/// Whether a value has changed, by more than rounding.
fn is_told(moved: f64, here: f64) -> bool {
    let change = (moved - here).abs();
    change.is_finite() && change > ROUNDED * here.abs()
}

fn magnitude(magnitudes: &[f64], index: usize) -> f64 {
    magnitudes.get(index).copied().unwrap_or(1.0)
}

fn stepped(value: f64, magnitude: f64) -> f64 {
    value + f64::EPSILON.sqrt() * value.abs().max(magnitude).copysign(value)
}

/// All states of a group at once, each parameter by itself.
fn difference_groups(
    groups: &Groups,
    [(y, magnitudes), (p, of_parameters)]: [Part<'_>; 2],
    out: &mut [f64],
    columns: &mut [f64],
    evaluate: impl Fn(&[f64], &mut [f64]),
) {
    let (n, rows) = (y.len(), out.len());
    let (by_states, by_parameters) = columns.split_at_mut(n * rows);
    let mut inputs = [y, p].concat();
    difference(&[(p, of_parameters)], out, by_parameters, |p, out| evaluate(&[y, p].concat(), out));
    by_states.fill(0.0);
    let mut moved = vec![0.0; rows];
    for group in 0..groups.count() {
        let members = || groups.of().iter().enumerate().filter(|(_, of)| **of == group).map(|(state, _)| state);
        members().for_each(|state| inputs[state] = stepped(y[state], magnitude(magnitudes, state)));
        evaluate(&inputs, &mut moved);
        let entries = groups.entries(group);
        for &(row, state) in entries {
            by_states[state * rows + row] = (moved[row] - out[row]) / (inputs[state] - y[state]);
        }
        let steps = entries.iter().map(|&(row, state)| (moved[row], out[row], inputs[state] - y[state]));
        retaken(lost(steps), |left, length| {
            members().for_each(|state| inputs[state] = y[state] + length.copysign(y[state]));
            evaluate(&inputs, &mut moved);
            left.retain(|&entry| {
                let (row, state) = entries[entry];
                let told = is_told(moved[row], out[row]);
                if told {
                    by_states[state * rows + row] = (moved[row] - out[row]) / (inputs[state] - y[state]);
                }
                !told
            });
        });
        members().for_each(|state| inputs[state] = y[state]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Few states need no memory, many do: both are told the same of every input.
    #[test]
    fn few_and_many_states_have_exact_derivatives() {
        for n in [1, 3, 4, 7, 8, 9, 40] {
            let f = |x: f64, y: &[Number], p: &[Number], f: &mut [Number]| {
                let sum: Number = y.iter().copied().sum();
                for (i, f) in f.iter_mut().enumerate() {
                    *f = y[i] * y[i] * x + sum * p[0];
                }
            };
            let bc = |a: &[Number], b: &[Number], p: &[Number], g: &mut [Number]| {
                for (i, g) in g.iter_mut().enumerate() {
                    *g = a[i] * b[n - 1 - i] - p[0];
                }
            };
            let exact = Exact::new(f, bc);
            let y: Vec<f64> = (0..n).map(|i| 0.5 + i as f64).collect();
            let b: Vec<f64> = y.iter().map(|y| 3.0 * y).collect();
            let (x, p, sum) = (1.5, [0.25], y.iter().sum::<f64>());
            let (mut plain, mut out, mut columns) = (vec![0.0; n], vec![0.0; n], vec![f64::NAN; n * (n + 1)]);
            exact.rhs(x, &y, &p, &mut plain);
            exact.rhs_derivatives(x, &y, &p, &mut out, &mut columns);
            assert_eq!(plain, out);
            for i in 0..n {
                assert_eq!(out[i], y[i] * y[i] * x + sum * p[0]);
                for j in 0..n {
                    let own = if i == j { 2.0 * y[i] * x } else { 0.0 };
                    assert_eq!(columns[j * n + i], own + p[0], "{n}: {i} by {j}");
                }
                assert_eq!(columns[n * n + i], sum, "{n}: {i} by the parameter");
            }
            let mut columns = vec![f64::NAN; n * (2 * n + 1)];
            exact.boundary(&y, &b, &p, &mut plain);
            exact.boundary_derivatives(&y, &b, &p, &mut out, &mut columns);
            assert_eq!(plain, out);
            for i in 0..n {
                let mirrored = n - 1 - i;
                assert_eq!(out[i], y[i] * b[mirrored] - p[0]);
                for j in 0..n {
                    assert_eq!(columns[j * n + i], if j == i { b[mirrored] } else { 0.0 });
                    assert_eq!(columns[(n + j) * n + i], if j == mirrored { y[i] } else { 0.0 });
                }
                assert_eq!(columns[2 * n * n + i], -1.0);
            }
        }
    }
}
