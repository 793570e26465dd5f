//! Problems stated by two closures.
//!
//! Bratu's problem `u'' = -exp(u)`, `u(0) = u(1) = 0`:
//!
//! ```
//! use solver::{Options, bvp::Bvp};
//!
//! let string = Bvp::new(
//!     &["u", "slope"],
//!     (0.0, 1.0),
//!     |_x, y, _p, f| (f[0], f[1]) = (y[1], -y[0].exp()),
//!     |a, b, _p, g| (g[0], g[1]) = (a[0], b[0]),
//! );
//! let solution = string.solve(&Options::default())?;
//! assert!((solution.regions()[0].eval(0.5)[0] - 0.14053921).abs() < 1e-6);
//! # Ok::<(), solver::SolveError>(())
//! ```
//!
//! One region, no integrals: for more there are [`Model`](crate::model::Model) and [`Problem`]. A [`Bvp`] is a
//! [`Problem`] itself, so that all of the library is open to it: continuation, sensitivities, conditioning.

mod formulas;
mod groups;
mod higher;
mod number;
mod singular;

pub use formulas::{Differenced, Evaluated, Exact, Formulas};
pub use groups::Groups;
pub use higher::HigherOrder;
pub use number::Number;
pub use singular::SingularTermError;

use crate::error::SolveError;
use crate::guess::Guess;
use crate::options::Options;
use crate::problem::{Constant, Layout, LayoutError, Points, Problem, Region, Scope, State, is_scale, unrepeated};
use crate::solution::Solution;
use crate::solve::solve;
use singular::SingularTerm;

/// Intervals of a guess of which no number is said.
const INTERVALS: usize = 10;
/// Name of the one region.
const REGION: &str = "interval";

/// `y' = f(x, y, p)` on an interval, with as many conditions `g(y(a), y(b), p) = 0` as states and unknown parameters.
#[derive(Debug, Clone)]
pub struct Bvp<M> {
    formulas: M,
    layout: Layout,
    /// Values of the parameters: given, or guessed.
    parameters: Vec<f64>,
    unknowns: Vec<usize>,
    /// As it was stated, with the parameters' values.
    guess: Option<Guess>,
    singular: Option<SingularTerm>,
    linear: bool,
}

impl<F, B> Bvp<Exact<F, B>>
where
    F: Fn(f64, &[Number], &[Number], &mut [Number]),
    B: Fn(&[Number], &[Number], &[Number], &mut [Number]),
{
    /// States by name, the interval, `f(x, y, p, out)` and `g(y(a), y(b), p, out)`. Derivatives are exact.
    pub fn new(states: &[&str], interval: (f64, f64), f: F, bc: B) -> Self {
        Self::with(states, interval, Exact::new(f, bc))
    }
}

impl<F, B> Bvp<Differenced<F, B>>
where
    F: Fn(f64, &[f64], &[f64], &mut [f64]),
    B: Fn(&[f64], &[f64], &[f64], &mut [f64]),
{
    /// As [`new`](Bvp::new), for closures of plain numbers, as where they call foreign code. Derivatives are forward
    /// differences.
    pub fn by_differences(states: &[&str], interval: (f64, f64), f: F, bc: B) -> Self {
        Self::with(states, interval, Differenced::new(f, bc))
    }
}

impl<M: Evaluated> Bvp<M> {
    /// Says which states each value that `f` writes depends on, by their indices, so that derivatives take fewer
    /// evaluations: those by all states of which no value depends on two come from one. Of many states with few
    /// neighbours each, as rods cut into pieces have, it is a few in place of as many as there are states.
    ///
    /// Derivatives that are not stated are taken to be zero: where that is wrong, Newton's iteration is slow or fails,
    /// and a problem that says that it is [`linear`](Self::linear) is told that it is not.
    ///
    /// Heat in a row of ten pieces, along which it is carried, and lost from one to the next:
    ///
    /// ```
    /// use solver::{Options, bvp::Bvp};
    ///
    /// let names: Vec<String> = (0..10).map(|i| format!("T{i}")).collect();
    /// let names: Vec<&str> = names.iter().map(String::as_str).collect();
    /// let neighbours: Vec<Vec<usize>> = (0..10_usize).map(|i| (i.max(1) - 1..(i + 2).min(10)).collect()).collect();
    /// let neighbours: Vec<&[usize]> = neighbours.iter().map(Vec::as_slice).collect();
    /// let row = Bvp::by_differences(
    ///     &names,
    ///     (0.0, 1.0),
    ///     |_, t, _, f| {
    ///         for i in 0..10 {
    ///             let (before, after) = (t[i.max(1) - 1], t[(i + 1).min(9)]);
    ///             f[i] = before - 2.0 * t[i] + after;
    ///         }
    ///     },
    ///     |a, _, _, g| (0..10).for_each(|i| g[i] = a[i] - i as f64),
    /// )
    /// .sparse(&neighbours)?;
    /// let solution = row.solve(&Options::default())?;
    /// assert!((solution.regions()[0].eval(1.0)[4] - 4.0).abs() < 1e-2);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// Not one list for each value that `f` writes, or a state that there is not.
    pub fn sparse(mut self, states_of_each: &[&[usize]]) -> Result<Self, LayoutError> {
        let states = self.layout.regions[0].states.len();
        let groups = Groups::new(states, self.formulas.values(states), states_of_each)?;
        self.formulas = self.formulas.grouped(groups);
        Ok(self)
    }
}

impl<M: Formulas> Bvp<M> {
    /// With formulas that bring their own derivatives.
    pub fn with(states: &[&str], interval: (f64, f64), formulas: M) -> Self {
        let (layout, parameters, unknowns) = (layout(states, interval, &[], 0), Vec::new(), Vec::new());
        Self { formulas, layout, parameters, unknowns, guess: None, singular: None, linear: false }
    }

    /// One more parameter, of a given value.
    #[must_use]
    pub fn given(self, name: &str, value: f64) -> Self {
        self.parameter(name, value, false)
    }

    /// One more parameter that is to be found, near a value. It takes one more boundary condition.
    #[must_use]
    pub fn unknown(self, name: &str, near: f64) -> Self {
        self.parameter(name, near, true)
    }

    fn parameter(mut self, name: &str, value: f64, unknown: bool) -> Self {
        if unknown {
            self.unknowns.push(self.parameters.len());
        }
        self.parameters.push(value);
        if let Some(guess) = &mut self.guess {
            guess.constants.push(value);
        }
        let mut names: Vec<&str> = self.layout.constants.iter().map(|constant| constant.name.as_str()).collect();
        names.push(name);
        let region = &self.layout.regions[0];
        let states: Vec<&str> = region.states.iter().map(|state| state.name.as_str()).collect();
        let with_it = layout(&states, region.interval, &names, self.unknowns.len());
        let before = std::mem::replace(&mut self.layout, with_it);
        let states = before.regions.into_iter().flat_map(|region| region.states);
        self.layout.regions[0].states.iter_mut().zip(states).for_each(|(new, state)| *new = state);
        self.layout.constants.iter_mut().zip(before.constants).for_each(|(new, constant)| *new = constant);
        self
    }

    /// States the typical magnitude of a state or parameter, by its name: what is smaller counts as zero, within the
    /// tolerance. It is 1 where none is stated, and the larger of both where larger values are found. Along a branch,
    /// steps are measured in it too: a parameter that goes from 1e-9 to 1e-7 is to have one of 1e-7. So are those of
    /// derivatives by differences.
    ///
    /// # Errors
    /// [`LayoutError::Unnamed`] if nothing has that name, [`LayoutError::Repeated`] if more than one thing has, and
    /// [`LayoutError::Scale`] if the magnitude is not positive.
    pub fn typical(mut self, name: &str, magnitude: f64) -> Result<Self, LayoutError> {
        if !is_scale(magnitude) {
            return Err(LayoutError::Scale { of: name.to_owned(), scale: magnitude });
        }
        let states = self.layout.regions[0].states.iter().map(|state| &state.name);
        let all = states.chain(self.layout.constants.iter().map(|constant| &constant.name));
        unrepeated(all.filter(|known| *known == name), "states and parameters")?;
        let states = self.layout.regions[0].states.iter_mut().map(|state| (&state.name, &mut state.scale));
        let constants = self.layout.constants.iter_mut().map(|constant| (&constant.name, &mut constant.scale));
        let mut all = states.chain(constants);
        let Some((_, scale)) = all.find(|(known, _)| *known == name) else {
            return Err(LayoutError::Unnamed { name: name.to_owned() });
        };
        *scale = Some(magnitude);
        let of = |scale: Option<f64>| scale.unwrap_or(1.0);
        let states: Vec<f64> = self.layout.regions[0].states.iter().map(|state| of(state.scale)).collect();
        let parameters: Vec<f64> = self.layout.constants.iter().map(|constant| of(constant.scale)).collect();
        self.formulas.take_magnitudes(&states, &parameters);
        Ok(self)
    }

    /// Adds `S y/(x - a)` to the right-hand side, with `S` by rows: a term that is singular at the left end a, as
    /// symmetry about an axis or a centre brings it. Among the boundary conditions there must be those of `S y(a) = 0`.
    /// Other terms that are undefined at an end need [`Order::Eight`](crate::Order::Eight).
    ///
    /// Emden's equation `u'' + 2 u'/x + u⁵ = 0`, `u'(0) = 0`, `u(1) = √3/2`:
    ///
    /// ```
    /// use solver::{Options, bvp::Bvp};
    ///
    /// let star = Bvp::new(
    ///     &["u", "slope"],
    ///     (0.0, 1.0),
    ///     |_, y, _, f| (f[0], f[1]) = (y[1], -y[0].powi(5)),
    ///     |a, b, _, g| (g[0], g[1]) = (a[1], b[0] - 0.75_f64.sqrt()),
    /// )
    /// .singular_term(&[&[0.0, 0.0], &[0.0, -2.0]])?
    /// .guess(5, |_, y| (y[0], y[1]) = (0.75_f64.sqrt(), 1e-4));
    /// let solution = star.solve(&Options::default())?;
    /// assert!((solution.regions()[0].eval(0.0)[0] - 1.0).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// The matrix does not suit: see [`SingularTermError`].
    pub fn singular_term(mut self, matrix: &[&[f64]]) -> Result<Self, SingularTermError> {
        self.singular = Some(SingularTerm::new(self.layout.regions[0].states.len(), matrix)?);
        Ok(self)
    }

    /// Says that `f` is linear in the states and, together with them, in the unknown parameters: it is evaluated less
    /// often then, see [`Problem::is_linear`]. Where derivatives are differences, nothing is gained by it.
    ///
    /// `ε u'' = u' - 1`, `u(0) = u(1) = 0`:
    ///
    /// ```
    /// use solver::{Options, bvp::Bvp};
    ///
    /// let eps = 0.01;
    /// let layer = Bvp::new(
    ///     &["u", "slope"],
    ///     (0.0, 1.0),
    ///     |_, y, _, f| (f[0], f[1]) = (y[1], (y[1] - 1.0) / eps),
    ///     |a, b, _, g| (g[0], g[1]) = (a[0], b[0]),
    /// )
    /// .linear();
    /// let solution = layer.solve(&Options::default())?;
    /// assert!((solution.regions()[0].eval(0.5)[0] - 0.5).abs() < 1e-6);
    /// # Ok::<(), solver::SolveError>(())
    /// ```
    #[must_use]
    pub fn linear(mut self) -> Self {
        self.linear = M::EXACT;
        self
    }

    /// The guess `y(x)`, on so many equal intervals. Without one all states are guessed to be zero.
    #[must_use]
    pub fn guess(mut self, intervals: usize, y: impl Fn(f64, &mut [f64])) -> Self {
        self.guess = Some(Guess::uniform(&self.layout, intervals, &self.parameters, |_, x, out| y(x, out)));
        self
    }

    /// The guess as the library's other functions take it.
    pub fn start(&self) -> Guess {
        self.guess.clone().unwrap_or_else(|| self.zero())
    }

    /// The guess of none.
    fn zero(&self) -> Guess {
        Guess::uniform(&self.layout, INTERVALS, &self.parameters, |_, _, y| y.fill(0.0))
    }

    /// What it is stated by.
    pub fn formulas(&self) -> &M {
        &self.formulas
    }

    /// Indices of the unknown parameters among all.
    pub fn unknowns(&self) -> &[usize] {
        &self.unknowns
    }

    /// Solves from the guess.
    ///
    /// # Errors
    /// As [`solve`](crate::solve()).
    pub fn solve(&self, options: &Options) -> Result<Solution, SolveError> {
        match &self.guess {
            Some(guess) => solve(self, guess, &self.unknowns, options),
            None => solve(self, &self.zero(), &self.unknowns, options),
        }
    }
}

/// Values of one point that need no memory of their own.
const ROOM: usize = 64;

/// So many values: of `room`, which is not empty, or where that is too small of `more`.
#[inline(always)]
fn buffer<'a, T: Copy, const N: usize>(room: &'a mut [T; N], more: &'a mut Vec<T>, len: usize) -> &'a mut [T] {
    if len <= N {
        return &mut room[..len];
    }
    more.resize(len, room[0]);
    more
}

fn layout(states: &[&str], interval: (f64, f64), parameters: &[&str], unknowns: usize) -> Layout {
    let (n, count) = (states.len(), states.len() + unknowns);
    // By columns, as the formulas write them.
    let by_columns = |rows: usize, columns: usize| -> Vec<(usize, usize)> {
        let mut all = Vec::with_capacity(rows * columns);
        (0..columns).for_each(|column| all.extend((0..rows).map(|row| (row, column))));
        all
    };
    let region = Region {
        name: REGION.to_owned(),
        interval,
        states: states.iter().map(|&name| State { name: name.to_owned(), scale: None }).collect(),
        integrals: Vec::new(),
        state_pattern: by_columns(n, n),
        constant_pattern: by_columns(n, parameters.len()),
        default_entries: n * parameters.len(),
    };
    Layout {
        regions: vec![region],
        constants: parameters.iter().map(|&name| Constant { name: name.to_owned(), scale: None }).collect(),
        equations: (1..=count).map(|number| format!("condition {number}")).collect(),
        boundary_pattern: by_columns(count, 2 * n + parameters.len()),
    }
}

/// The values of point `j`, one a row.
#[inline(always)]
fn scatter(values: &[f64], out: &mut [f64], stride: usize, j: usize) {
    for (i, value) in values.iter().enumerate() {
        out[i * stride + j] = *value;
    }
}

impl<M: Formulas> Bvp<M> {
    /// f at all points, `n` states.
    #[inline(always)]
    fn values(&self, n: usize, at: &Points<'_>, constants: &[f64], f: &mut [f64]) {
        let start = self.layout.regions[0].interval.0;
        let (mut room, mut more) = ([0.0; ROOM], Vec::new());
        let (y, out) = buffer(&mut room, &mut more, 2 * n).split_at_mut(n);
        for (j, &s) in at.s[..at.len].iter().enumerate() {
            for (i, y) in y.iter_mut().enumerate() {
                *y = at.at(i, j);
            }
            self.formulas.rhs(s, y, constants, out);
            if let Some(term) = &self.singular {
                term.complete(s - start, y, out);
            }
            scatter(out, f, at.stride, j);
        }
    }

    /// The same with derivatives, by states and by parameters.
    #[inline(always)]
    fn derivatives(
        &self,
        n: usize,
        at: &Points<'_>,
        constants: &[f64],
        (f, dy, dc): (&mut [f64], &mut [f64], &mut [f64]),
    ) {
        let start = self.layout.regions[0].interval.0;
        let (mut room, mut more) = ([0.0; ROOM], Vec::new());
        let (y, rest) = buffer(&mut room, &mut more, n * (n + 2 + constants.len())).split_at_mut(n);
        let (out, columns) = rest.split_at_mut(n);
        for (j, &s) in at.s[..at.len].iter().enumerate() {
            for (i, y) in y.iter_mut().enumerate() {
                *y = at.at(i, j);
            }
            self.formulas.rhs_derivatives(s, y, constants, out, columns);
            if let Some(term) = &self.singular {
                term.complete(s - start, y, out);
                term.complete_derivatives(s - start, columns);
            }
            scatter(out, f, at.stride, j);
            let (states, parameters) = columns.split_at(n * n);
            scatter(states, dy, at.stride, j);
            scatter(parameters, dc, at.stride, j);
        }
    }
}

impl<M: Formulas> Problem for Bvp<M> {
    fn layout(&self) -> &Layout {
        &self.layout
    }

    fn is_linear(&self, unknowns: &[usize]) -> bool {
        self.linear && unknowns.iter().all(|unknown| self.unknowns.contains(unknown))
    }

    fn rhs(&self, _region: usize, at: &Points<'_>, constants: &[f64], f: &mut [f64]) {
        // Compiled once more each where the states are those of one or two equations of second order.
        match self.layout.regions[0].states.len() {
            2 => self.values(2, at, constants, f),
            4 => self.values(4, at, constants, f),
            n => self.values(n, at, constants, f),
        }
    }

    fn rhs_jacobian(
        &self,
        _region: usize,
        at: &Points<'_>,
        constants: &[f64],
        _scope: Scope,
        f: &mut [f64],
        dy: &mut [f64],
        dc: &mut [f64],
    ) {
        match self.layout.regions[0].states.len() {
            2 => self.derivatives(2, at, constants, (f, dy, dc)),
            4 => self.derivatives(4, at, constants, (f, dy, dc)),
            n => self.derivatives(n, at, constants, (f, dy, dc)),
        }
    }

    fn boundary(&self, ends: &[f64], _integrals: &[f64], constants: &[f64], g: &mut [f64]) {
        let (a, b) = ends.split_at(ends.len() / 2);
        self.formulas.boundary(a, b, constants, g);
    }

    fn boundary_jacobian(&self, ends: &[f64], _integrals: &[f64], constants: &[f64], g: &mut [f64], dz: &mut [f64]) {
        let (a, b) = ends.split_at(ends.len() / 2);
        self.formulas.boundary_derivatives(a, b, constants, g, dz);
    }
}
