//! The cases as systems of first order: states are each u and then its u'.

use super::cases::{Case, Equations};
use solver::bvp::{Bvp, Formulas};

/// u at the left end, then at the right one.
pub fn ends(case: &Case) -> [f64; 4] {
    let ([a1, a2], [b1, b2]) = (case.exact(case.interval.0), case.exact(case.interval.1));
    if case.equations() == 1 { [a1, b1, 0.0, 0.0] } else { [a1, a2, b1, b2] }
}

/// A case with its values at the ends, as this crate takes it.
pub struct System(&'static Case, [f64; 4]);

impl Formulas for System {
    fn rhs(&self, x: f64, y: &[f64], _: &[f64], f: &mut [f64]) {
        let mut values = [0.0; 2];
        self.0.values(x, y, &mut values);
        if let ([first, second], [_, slope]) = (&mut *f, y) {
            return (*first, *second) = (*slope, values[0]);
        }
        for i in 0..self.0.equations() {
            (f[2 * i], f[2 * i + 1]) = (y[2 * i + 1], values[i]);
        }
    }
    fn rhs_derivatives(&self, x: f64, y: &[f64], _: &[f64], f: &mut [f64], columns: &mut [f64]) {
        system_derivatives(self.0, x, y, columns, Some(f));
    }
    fn boundary(&self, a: &[f64], b: &[f64], _: &[f64], g: &mut [f64]) {
        let count = self.0.equations();
        for i in 0..count {
            (g[i], g[count + i]) = (a[2 * i] - self.1[i], b[2 * i] - self.1[count + i]);
        }
    }
    fn boundary_derivatives(&self, a: &[f64], b: &[f64], p: &[f64], g: &mut [f64], columns: &mut [f64]) {
        self.boundary(a, b, p, g);
        let count = self.0.equations();
        columns.fill(0.0);
        for i in 0..count {
            columns[2 * i * g.len() + i] = 1.0;
            columns[(2 * count + 2 * i) * g.len() + count + i] = 1.0;
        }
    }
}

/// Derivatives of the system of first order, by columns.
#[inline]
pub fn system_derivatives(case: &Case, x: f64, z: &[f64], columns: &mut [f64], f: Option<&mut [f64]>) {
    if let Equations::One(formula, _) = case.equations {
        let [value, by_u, by_slope] = formula(x, z[0], z[1]);
        columns[..4].copy_from_slice(&[0.0, by_u, 1.0, by_slope]);
        if let Some(f) = f {
            (f[0], f[1]) = (z[1], value);
        }
        return;
    }
    let (count, states) = (case.equations(), 2 * case.equations());
    let (mut values, mut rows) = ([0.0; 2], [0.0; 8]);
    case.derivatives(x, z, &mut values, &mut rows);
    columns.fill(0.0);
    for i in 0..count {
        columns[(2 * i + 1) * states + 2 * i] = 1.0;
        for j in 0..states {
            columns[j * states + 2 * i + 1] = rows[i * states + j];
        }
    }
    if let Some(f) = f {
        for i in 0..count {
            (f[2 * i], f[2 * i + 1]) = (z[2 * i + 1], values[i]);
        }
    }
}

/// A case by the states' names, from a guess of zero on so many equal intervals.
pub fn stated(case: &'static Case, ends: [f64; 4], intervals: usize) -> Bvp<System> {
    let names: &[&str] = if case.equations() == 1 { &["u", "u'"] } else { &["u1", "u1'", "u2", "u2'"] };
    Bvp::with(names, case.interval, System(case, ends)).guess(intervals, |_, y| y.fill(0.0))
}
