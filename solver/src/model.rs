//! A problem stated by its formulas alone; derivatives follow by forward-mode dual numbers.
//!
//! Bratu's problem `u'' = -λ exp(u)`, `u(0) = u(1) = 0`:
//!
//! ```
//! use solver::model::{Differentiated, Model, Scalar};
//! use solver::{Layout, Region};
//!
//! struct Bratu;
//!
//! impl Model for Bratu {
//!     fn layout(&self) -> Layout {
//!         let string = Region::dense("string", (0.0, 1.0), &["u", "slope"], &[], 1);
//!         Layout::dense(vec![string], &["lambda"], &["left end", "right end"])
//!     }
//!     fn rhs<S: Scalar>(&self, _region: usize, _s: S, y: &[S], c: &[S], f: &mut [S]) {
//!         f[0] = y[1];
//!         f[1] = -c[0] * y[0].exp();
//!     }
//!     fn boundary<S: Scalar>(&self, ends: &[S], _integrals: &[S], _c: &[S], g: &mut [S]) {
//!         (g[0], g[1]) = (ends[0], ends[2]);
//!     }
//! }
//!
//! let problem = Differentiated::new(Bratu)?;
//! # let _ = problem;
//! # Ok::<(), solver::LayoutError>(())
//! ```
//!
//! What to write in which place:
//! - **constants** `c` hold parameters and unknowns alike, in the layout's order; which are unknown is said when
//!   solving.
//! - **ends** hold, region by region, all entry values and then all exit values: for one region of two states
//!   `[y0(a), y1(a), y0(b), y1(b)]`. Interface and multi-point conditions are equations between ends of different
//!   regions, periodic ones between the two ends of one.
//! - **integrands** follow the right-hand side in `f`; their integrals over the region come to `boundary` as
//!   `integrals`.
//! - a **number** beside a `Scalar` stands on the right (`y[0] * 2.0`), or is made one: `S::from(2.0)`.
//! - an **unknown length** is a constant: write the region on `(0, 1)` and multiply the right-hand side by the length.

use crate::problem::{Layout, LayoutError, Points, Problem, Scope};
use num_dual::{DualNum, DualSVec64};

/// Derivatives that one pass carries: each width compiles every model once more, so there are two.
const WIDE: usize = 4;
/// For two states and no unknown constant.
const NARROW: usize = 2;

/// A number that a model is evaluated with: `f64` itself, or one that carries derivatives.
///
/// Arithmetic, comparison with `f64`, and the elementary functions come from [`DualNum`]. Two of these have derivatives
/// that are not a number where they exist: `powf` at 0 for exponents below 3, and `tanh` from 355 on;
/// [`power`](Self::power) and [`hyperbolic_tangent`](Self::hyperbolic_tangent) stand in for them.
pub trait Scalar: DualNum<Primitive = f64> + Copy {
    /// `self` to a constant power, with its derivatives; at 0 with the first alone.
    #[must_use]
    fn power(self, exponent: f64) -> Self {
        if Self::NDERIV > 1 && self.re() != 0.0 {
            return self.powf(exponent);
        }
        chained(self, power(self.re(), exponent))
    }

    /// Hyperbolic tangent, with its derivatives.
    #[must_use]
    fn hyperbolic_tangent(self) -> Self {
        /// From here on it is 1 to the last digit, and its slope less than that.
        const SATURATED: f64 = 20.0;
        if Self::NDERIV > 1 && self.re().abs() < SATURATED {
            return self.tanh();
        }
        let value = libm::tanh(self.re());
        chained(self, [value, 1.0 - value * value])
    }
}

/// x to a constant power, and the slope there.
pub(crate) fn power(x: f64, exponent: f64) -> [f64; 2] {
    let slope = if exponent == 0.0 { 0.0 } else { exponent * libm::pow(x, exponent - 1.0) };
    [libm::pow(x, exponent), slope]
}

/// A function of `x` by its value and its slope there.
fn chained<S: Scalar>(x: S, [value, slope]: [f64; 2]) -> S {
    (x - x.re()) * slope + value
}

impl<S: DualNum<Primitive = f64> + Copy> Scalar for S {}

/// A boundary value problem by its formulas: see the [module's head](self).
pub trait Model {
    /// Names and sizes. Patterns may be dense; narrower ones save work. Asked for once.
    fn layout(&self) -> Layout;

    /// Right-hand side and then integrands at `s`: `f` has one entry for each state and each integral of the region.
    fn rhs<S: Scalar>(&self, region: usize, s: S, y: &[S], c: &[S], f: &mut [S]);

    /// Boundary residuals: `g` has one entry for each equation of the layout.
    fn boundary<S: Scalar>(&self, ends: &[S], integrals: &[S], c: &[S], g: &mut [S]);

    /// See [`Problem::is_linear`].
    fn is_linear(&self, _unknowns: &[usize]) -> bool {
        false
    }

    /// See [`Problem::conserved`].
    fn conserved(&self, _region: usize) -> usize {
        0
    }
}

/// A [`Model`] made a [`Problem`], its derivatives exact to rounding.
#[derive(Debug, Clone)]
pub struct Differentiated<M> {
    model: M,
    layout: Layout,
    /// For each region, its inputs in the order in which passes take them: states, default unknowns, other constants.
    regions: Vec<Vec<Column>>,
    boundary: Vec<Column>,
}

/// One input and the pattern entries in its column.
#[derive(Debug, Clone)]
struct Column {
    input: Input,
    /// `(row, entry)`.
    entries: Vec<(usize, usize)>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Input {
    State(usize),
    Constant(usize),
    Boundary(usize),
}

impl<M: Model> Differentiated<M> {
    /// The model as a problem, with the patterns its layout states.
    ///
    /// # Errors
    /// A layout that contradicts itself.
    pub fn new(model: M) -> Result<Self, LayoutError> {
        let layout = model.layout();
        Self::assemble(model, layout)
    }

    /// As [`new`](Self::new), with the names of the default unknowns, the constants that are unknown in most questions:
    /// the others' derivatives are then computed only for sensitivities and tangents. Unknown names are ignored.
    ///
    /// # Errors
    /// A layout that contradicts itself.
    pub fn with_default_unknowns(model: M, names: &[&str]) -> Result<Self, LayoutError> {
        let mut layout = model.layout();
        let default: Vec<bool> = layout.constants.iter().map(|c| names.contains(&c.name.as_str())).collect();
        let is_default = |&(_, constant): &(usize, usize)| default.get(constant).copied().unwrap_or(false);
        for region in &mut layout.regions {
            let (first, rest): (Vec<_>, Vec<_>) = region.constant_pattern.iter().partition(|entry| is_default(entry));
            region.default_entries = first.len();
            region.constant_pattern = [first, rest].concat();
        }
        Self::assemble(model, layout)
    }

    /// Narrows the patterns to the derivatives that are nonzero at one or more of `samples` scattered points.
    ///
    /// Exact for formulas without branches, where an accidental zero at every sample has no probability. A model that
    /// branches must state its pattern instead.
    ///
    /// # Errors
    /// None for a layout that was consistent.
    pub fn narrowed(self, samples: usize) -> Result<Self, LayoutError> {
        let mut layout = self.layout.clone();
        for (index, region) in layout.regions.iter_mut().enumerate() {
            let (seen_state, seen_constant) = self.probe_region(index, samples);
            retain(&mut region.state_pattern, &seen_state);
            let default = seen_constant.iter().take(region.default_entries).filter(|&&seen| seen).count();
            retain(&mut region.constant_pattern, &seen_constant);
            region.default_entries = default;
        }
        let seen = self.probe_boundary(samples);
        retain(&mut layout.boundary_pattern, &seen);
        Self::assemble(self.model, layout)
    }

    /// The model.
    pub fn model(&self) -> &M {
        &self.model
    }

    fn assemble(model: M, layout: Layout) -> Result<Self, LayoutError> {
        layout.check()?;
        let regions = layout
            .regions
            .iter()
            .map(|region| {
                let mut columns = columns(&region.state_pattern, Input::State);
                let (default, rest) = region.constant_pattern.split_at(region.default_entries);
                columns.extend(self::columns(default, Input::Constant));
                let first = default.len();
                columns.extend(self::columns(rest, Input::Constant).into_iter().map(|mut column| {
                    column.entries.iter_mut().for_each(|(_, entry)| *entry += first);
                    column
                }));
                columns
            })
            .collect();
        let boundary = columns(&layout.boundary_pattern, Input::Boundary);
        Ok(Self { model, layout, regions, boundary })
    }

    fn probe_region(&self, index: usize, samples: usize) -> (Vec<bool>, Vec<bool>) {
        let region = &self.layout.regions[index];
        let (n, rows) = (region.states.len(), region.rows());
        let (states, constants) = (region.state_pattern.len(), region.constant_pattern.len());
        let mut seen = (vec![false; states], vec![false; constants]);
        let mut scatter = Scatter::default();
        let (a, b) = region.interval;
        for _ in 0..samples {
            let s = [a + (b - a) * scatter.next()];
            let y = scatter.fill(n);
            let c = scatter.fill(self.layout.constants.len());
            let (mut f, mut dy, mut dc) = (vec![0.0; rows], vec![0.0; states], vec![0.0; constants]);
            let at = Points { len: 1, stride: 1, s: &s, y: &y };
            self.rhs_jacobian(index, &at, &c, Scope::All, &mut f, &mut dy, &mut dc);
            note(&mut seen.0, &dy);
            note(&mut seen.1, &dc);
        }
        seen
    }

    fn probe_boundary(&self, samples: usize) -> Vec<bool> {
        let layout = &self.layout;
        let mut seen = vec![false; layout.boundary_pattern.len()];
        let mut scatter = Scatter::default();
        for _ in 0..samples {
            let ends = scatter.fill(layout.ends());
            let integrals = scatter.fill(layout.integrals());
            let c = scatter.fill(layout.constants.len());
            let (mut g, mut dz) = (vec![0.0; layout.equations.len()], vec![0.0; seen.len()]);
            self.boundary_jacobian(&ends, &integrals, &c, &mut g, &mut dz);
            note(&mut seen, &dz);
        }
        seen
    }

    /// Values at every point, and derivatives along the inputs of `columns`, at most `W`.
    fn rhs_pass<const W: usize>(
        &self,
        region: usize,
        at: &Points<'_>,
        constants: &[f64],
        columns: &[Column],
        f: &mut [f64],
        dy: &mut [f64],
        dc: &mut [f64],
    ) {
        let (n, rows) = (self.layout.regions[region].states.len(), self.layout.regions[region].rows());
        let mut c = lift::<W>(constants);
        let mut y = vec![DualSVec64::<W>::from_re(0.0); n];
        let mut out = vec![DualSVec64::<W>::from_re(0.0); rows];
        for (k, column) in columns.iter().enumerate() {
            if let Input::Constant(i) = column.input {
                c[i] = c[i].derivative(k);
            }
        }
        for j in 0..at.len {
            for (i, y) in y.iter_mut().enumerate() {
                *y = DualSVec64::from_re(at.at(i, j));
            }
            for (k, column) in columns.iter().enumerate() {
                if let Input::State(i) = column.input {
                    y[i] = y[i].derivative(k);
                }
            }
            self.model.rhs(region, DualSVec64::from_re(at.s[j]), &y, &c, &mut out);
            for (row, value) in out.iter().enumerate() {
                f[row * at.stride + j] = value.re;
            }
            for (k, column) in columns.iter().enumerate() {
                let target = if matches!(column.input, Input::State(_)) { &mut *dy } else { &mut *dc };
                for &(row, entry) in &column.entries {
                    target[entry * at.stride + j] = part(&out[row], k);
                }
            }
        }
    }

    /// Values, and derivatives along the inputs of `columns`, at most `WIDE`.
    fn boundary_pass(
        &self,
        ends: &[f64],
        integrals: &[f64],
        constants: &[f64],
        columns: &[Column],
        g: &mut [f64],
        dz: &mut [f64],
    ) {
        let mut inputs = lift::<WIDE>(ends);
        inputs.extend(lift::<WIDE>(integrals));
        inputs.extend(lift::<WIDE>(constants));
        for (k, column) in columns.iter().enumerate() {
            if let Input::Boundary(i) = column.input {
                inputs[i] = inputs[i].derivative(k);
            }
        }
        let mut out = vec![DualSVec64::<WIDE>::from_re(0.0); self.layout.equations.len()];
        let (ends, rest) = inputs.split_at(ends.len());
        let (integrals, constants) = rest.split_at(integrals.len());
        self.model.boundary(ends, integrals, constants, &mut out);
        for (g, value) in g.iter_mut().zip(&out) {
            *g = value.re;
        }
        for (k, column) in columns.iter().enumerate() {
            for &(row, entry) in &column.entries {
                dz[entry] = part(&out[row], k);
            }
        }
    }
}

impl<M: Model> Problem for Differentiated<M> {
    fn layout(&self) -> &Layout {
        &self.layout
    }

    fn is_linear(&self, unknowns: &[usize]) -> bool {
        self.model.is_linear(unknowns)
    }

    fn conserved(&self, region: usize) -> usize {
        self.model.conserved(region)
    }

    fn rhs(&self, region: usize, at: &Points<'_>, constants: &[f64], f: &mut [f64]) {
        let (n, rows) = (self.layout.regions[region].states.len(), self.layout.regions[region].rows());
        let (mut y, mut out) = (vec![0.0; n], vec![0.0; rows]);
        for j in 0..at.len {
            for (i, y) in y.iter_mut().enumerate() {
                *y = at.at(i, j);
            }
            self.model.rhs(region, at.s[j], &y, constants, &mut out);
            for (row, &value) in out.iter().enumerate() {
                f[row * at.stride + j] = value;
            }
        }
    }

    fn rhs_jacobian(
        &self,
        region: usize,
        at: &Points<'_>,
        constants: &[f64],
        scope: Scope,
        f: &mut [f64],
        dy: &mut [f64],
        dc: &mut [f64],
    ) {
        let default = self.layout.regions[region].default_entries;
        let wanted = |column: &Column| {
            scope == Scope::All
                || matches!(column.input, Input::State(_))
                || column.entries.first().is_some_and(|&(_, entry)| entry < default)
        };
        let columns = &self.regions[region];
        let count = columns.iter().take_while(|column| wanted(column)).count();
        if count == 0 {
            self.rhs(region, at, constants, f);
        }
        let mut rest = &columns[..count];
        while !rest.is_empty() {
            let (now, later) = rest.split_at(rest.len().min(WIDE));
            if now.len() <= NARROW {
                self.rhs_pass::<NARROW>(region, at, constants, now, f, dy, dc);
            } else {
                self.rhs_pass::<WIDE>(region, at, constants, now, f, dy, dc);
            }
            rest = later;
        }
    }

    fn boundary(&self, ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]) {
        self.model.boundary(ends, integrals, constants, g);
    }

    fn boundary_jacobian(&self, ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64], dz: &mut [f64]) {
        if self.boundary.is_empty() {
            self.boundary(ends, integrals, constants, g);
        }
        for columns in self.boundary.chunks(WIDE) {
            self.boundary_pass(ends, integrals, constants, columns, g, dz);
        }
    }
}

/// The pattern's entries by column, columns in ascending order.
fn columns(pattern: &[(usize, usize)], input: fn(usize) -> Input) -> Vec<Column> {
    let mut sorted: Vec<_> =
        pattern.iter().enumerate().map(|(entry, &(row, column))| (input(column), row, entry)).collect();
    sorted.sort_unstable();
    sorted
        .chunk_by(|a, b| a.0 == b.0)
        .map(|same| Column { input: same[0].0, entries: same.iter().map(|&(_, row, entry)| (row, entry)).collect() })
        .collect()
}

fn lift<const W: usize>(values: &[f64]) -> Vec<DualSVec64<W>> {
    values.iter().map(|&value| DualSVec64::from_re(value)).collect()
}

fn part<const W: usize>(value: &DualSVec64<W>, k: usize) -> f64 {
    value.eps.0.as_ref().map_or(0.0, |values| values[k])
}

fn note(seen: &mut [bool], derivatives: &[f64]) {
    for (seen, &derivative) in seen.iter_mut().zip(derivatives) {
        *seen |= derivative != 0.0;
    }
}

fn retain(pattern: &mut Vec<(usize, usize)>, seen: &[bool]) {
    let mut kept = seen.iter();
    pattern.retain(|_| kept.next().copied().unwrap_or(true));
}

/// Scattered, reproducible numbers: a Weyl sequence of the golden ratio.
#[derive(Default)]
struct Scatter(f64);

impl Scatter {
    /// The next number in `(0, 1)`.
    fn next(&mut self) -> f64 {
        const GOLDEN: f64 = 0.618_033_988_749_894_9;
        self.0 = (self.0 + GOLDEN).fract();
        self.0
    }

    /// Numbers in `(0.1, 1.6)`: where logarithms and roots are defined.
    fn fill(&mut self, count: usize) -> Vec<f64> {
        (0..count).map(|_| 0.1 + 1.5 * self.next()).collect()
    }
}
