//! Equations of higher order, stated as they stand.

use super::formulas::{Evaluated, Exact, Formulas};
use super::groups::Groups;
use super::{Bvp, Number, ROOM, buffer};
use crate::problem::LayoutError;

/// Formulas whose right-hand side writes each function's highest derivative only: `f(x, z, p, out)` with z all
/// functions and their lower derivatives, function by function, and one value in `out` for each function. That
/// `u' = u'` below the highest needs no saying. Derivatives are those of the values it writes, by columns of as many.
#[derive(Debug, Clone)]
pub struct HigherOrder<M> {
    formulas: M,
    /// Of each function.
    orders: Vec<usize>,
}

impl<M> HigherOrder<M> {
    /// Index of each function's last state, whose derivative is its highest.
    fn last(&self) -> impl Iterator<Item = usize> {
        self.orders.iter().scan(0, |end, order| {
            *end += order;
            Some(*end - 1)
        })
    }

    /// Index of each state that is followed by its derivative.
    fn followed(&self) -> impl Iterator<Item = usize> {
        let before = self.last().scan(0, |first, last| {
            let range = *first..last;
            *first = last + 1;
            Some(range)
        });
        before.flatten()
    }
}

impl<M: Formulas> Formulas for HigherOrder<M> {
    const EXACT: bool = M::EXACT;

    fn rhs(&self, x: f64, y: &[f64], p: &[f64], f: &mut [f64]) {
        let (mut room, mut more) = ([0.0; ROOM], Vec::new());
        let highest = buffer(&mut room, &mut more, self.orders.len());
        self.formulas.rhs(x, y, p, highest);
        self.followed().for_each(|i| f[i] = y[i + 1]);
        self.last().zip(highest).for_each(|(last, value)| f[last] = *value);
    }

    fn rhs_derivatives(&self, x: f64, y: &[f64], p: &[f64], f: &mut [f64], columns: &mut [f64]) {
        let (n, functions) = (y.len(), self.orders.len());
        let (mut room, mut more) = ([0.0; ROOM], Vec::new());
        let all = buffer(&mut room, &mut more, functions * (1 + n + p.len()));
        let (highest, own) = all.split_at_mut(functions);
        self.formulas.rhs_derivatives(x, y, p, highest, own);
        columns.fill(0.0);
        for i in self.followed() {
            f[i] = y[i + 1];
            columns[(i + 1) * n + i] = 1.0;
        }
        for (function, last) in self.last().enumerate() {
            f[last] = highest[function];
            for (column, own) in columns.chunks_exact_mut(n).zip(own.chunks_exact(functions)) {
                column[last] = own[function];
            }
        }
    }

    fn boundary(&self, a: &[f64], b: &[f64], p: &[f64], g: &mut [f64]) {
        self.formulas.boundary(a, b, p, g);
    }

    fn boundary_derivatives(&self, a: &[f64], b: &[f64], p: &[f64], g: &mut [f64], columns: &mut [f64]) {
        self.formulas.boundary_derivatives(a, b, p, g, columns);
    }

    fn take_magnitudes(&mut self, states: &[f64], parameters: &[f64]) {
        self.formulas.take_magnitudes(states, parameters);
    }
}

impl<M: Evaluated> Evaluated for HigherOrder<M> {
    fn values(&self, _states: usize) -> usize {
        self.orders.len()
    }

    fn grouped(self, groups: Groups) -> Self {
        Self { formulas: self.formulas.grouped(groups), ..self }
    }
}

impl<F, B> Bvp<HigherOrder<Exact<F, B>>>
where
    F: Fn(f64, &[Number], &[Number], &mut [Number]),
    B: Fn(&[Number], &[Number], &[Number], &mut [Number]),
{
    /// Equations of any order as they stand, as COLSYS and COLNEW take them: the functions by name and order, and each
    /// one's highest derivative by `f(x, z, p, out)`, with z = u, u', ..., w, w', ... below the highest. The states are
    /// called so, too. Derivatives are exact.
    ///
    /// A beam under a load that follows it, `w'''' = 1 - w w''`, clamped at both ends:
    ///
    /// ```
    /// use solver::{Options, bvp::Bvp};
    ///
    /// let beam = Bvp::of_higher_order(
    ///     &[("w", 4)],
    ///     (0.0, 1.0),
    ///     |_x, z, _p, highest| highest[0] = 1.0 - z[0] * z[2],
    ///     |a, b, _p, g| g.copy_from_slice(&[a[0], a[1], b[0], b[1]]),
    /// )?;
    /// let solution = beam.solve(&Options::default())?;
    /// assert!((solution.regions()[0].eval(0.5)[0] - 1.0 / 384.0).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// A function of order 0.
    pub fn of_higher_order(
        functions: &[(&str, usize)],
        interval: (f64, f64),
        f: F,
        bc: B,
    ) -> Result<Self, LayoutError> {
        Self::of_higher_order_with(functions, interval, Exact::new(f, bc))
    }
}

impl<M: Formulas> Bvp<HigherOrder<M>> {
    /// As [`of_higher_order`](Bvp::of_higher_order), with formulas that bring their own derivatives: of the functions'
    /// highest derivatives, as [`HigherOrder`] says.
    ///
    /// # Errors
    /// A function of order 0.
    pub fn of_higher_order_with(
        functions: &[(&str, usize)],
        interval: (f64, f64),
        formulas: M,
    ) -> Result<Self, LayoutError> {
        if let Some((name, _)) = functions.iter().find(|(_, order)| *order == 0) {
            return Err(LayoutError::Order { function: (*name).to_owned() });
        }
        let derivatives = functions.iter().flat_map(|&(name, order)| (0..order).map(move |k| (name, k)));
        let names: Vec<String> = derivatives.map(|(name, k)| format!("{name}{}", "'".repeat(k))).collect();
        let states: Vec<&str> = names.iter().map(String::as_str).collect();
        let orders = functions.iter().map(|(_, order)| *order).collect();
        Ok(Self::with(&states, interval, HigherOrder { formulas, orders }))
    }
}
