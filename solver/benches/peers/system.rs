//! The cases as systems of first order.

use super::cases::{Case, Condition, Equations, STATES};
use solver::bvp::{Bvp, Formulas};

/// A case with what is given at its ends, as this crate takes it.
pub struct System(&'static Case, Vec<Condition>);

impl Formulas for System {
    fn rhs(&self, x: f64, y: &[f64], _: &[f64], f: &mut [f64]) {
        system_values(self.0, x, y, f);
    }
    fn rhs_derivatives(&self, x: f64, y: &[f64], _: &[f64], f: &mut [f64], columns: &mut [f64]) {
        system_derivatives(self.0, x, y, columns, Some(f));
    }
    fn boundary(&self, a: &[f64], b: &[f64], _: &[f64], g: &mut [f64]) {
        for (g, condition) in g.iter_mut().zip(&self.1) {
            *g = (if condition.on_the_right { b } else { a })[condition.state] - condition.value;
        }
    }
    fn boundary_derivatives(&self, a: &[f64], b: &[f64], p: &[f64], g: &mut [f64], columns: &mut [f64]) {
        self.boundary(a, b, p, g);
        columns.fill(0.0);
        let states = a.len();
        for (i, condition) in self.1.iter().enumerate() {
            let of = if condition.on_the_right { states + condition.state } else { condition.state };
            columns[of * states + i] = 1.0;
        }
    }
}

/// The right-hand side of the system of first order.
#[inline]
pub fn system_values(case: &Case, x: f64, z: &[f64], f: &mut [f64]) {
    if let (Equations::One(formula, _) | Equations::Open(formula, ..), [first, second], [u, slope]) =
        (&case.equations, &mut *f, z)
    {
        return (*first, *second) = (*slope, formula(x, *u, *slope)[0]);
    }
    let mut values = [0.0; STATES];
    case.values(x, z, &mut values[..case.equations()]);
    slopes(case, z, &values, f);
}

/// What the system makes of the highest derivatives.
#[inline]
fn slopes(case: &Case, z: &[f64], values: &[f64], f: &mut [f64]) {
    let mut last = 0;
    for (order, value) in case.orders().iter().zip(values) {
        for _ in 1..*order {
            f[last] = z[last + 1];
            last += 1;
        }
        f[last] = *value;
        last += 1;
    }
}

/// Derivatives of the system of first order, by columns.
#[inline]
pub fn system_derivatives(case: &Case, x: f64, z: &[f64], columns: &mut [f64], f: Option<&mut [f64]>) {
    if let Equations::One(formula, _) | Equations::Open(formula, ..) = case.equations {
        let [value, by_u, by_slope] = formula(x, z[0], z[1]);
        columns[..4].copy_from_slice(&[0.0, by_u, 1.0, by_slope]);
        if let Some(f) = f {
            (f[0], f[1]) = (z[1], value);
        }
        return;
    }
    let states = z.len();
    let (mut values, mut rows) = ([0.0; STATES], [0.0; STATES * STATES]);
    case.derivatives(x, z, &mut values[..case.equations()], &mut rows[..case.equations() * states]);
    columns.fill(0.0);
    let mut last = 0;
    for (order, row) in case.orders().iter().zip(rows.chunks_exact(states)) {
        for _ in 1..*order {
            columns[(last + 1) * states + last] = 1.0;
            last += 1;
        }
        for (column, by) in columns.chunks_exact_mut(states).zip(row) {
            column[last] = *by;
        }
        last += 1;
    }
    if let Some(f) = f {
        slopes(case, z, &values, f);
    }
}

/// Names of the states.
const NAMES: [&str; STATES] = ["z1", "z2", "z3", "z4", "z5", "z6", "z7", "z8"];

/// A case, with what is given at its ends, from its guess on so many equal intervals.
pub fn stated(case: &'static Case, conditions: Vec<Condition>, intervals: usize) -> Bvp<System> {
    let names = &NAMES[..case.states()];
    Bvp::with(names, case.interval, System(case, conditions)).guess(intervals, |x, y| case.guess(x, y))
}
