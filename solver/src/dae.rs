//! Semi-explicit differential-algebraic equations of index 1, `y' = f(x, y, z, c)` and `0 = g(x, y, z, c)`, stated by
//! their formulas and solved as differential equations.
//!
//! Index 1 means that the matrix ∂g/∂z has an inverse wherever the solution goes. Then g = 0 is the same as g = 0 at
//! one end and dg/dx = 0 along the way, which is an equation for z' (U. M. Ascher and L. R. Petzold, "Computer Methods
//! for Ordinary Differential Equations and Differential-Algebraic Equations", SIAM 1998, section 9.2):
//!
//! ```text
//! z' = -(∂g/∂z)⁻¹ (∂g/∂x + ∂g/∂y f),     g = 0 at the region's start
//! ```
//!
//! [`Reduced`] forms both from f and g, with dual numbers of dual numbers, so that Newton's matrices too are exact. A
//! circle by its angle's speed, and by x² + z² = 1:
//!
//! ```
//! use solver::dae::{Dae, Reduced};
//! use solver::model::{Differentiated, Scalar};
//! use solver::{Guess, Layout, Options, Problem, Region, solve};
//!
//! struct Circle;
//!
//! impl Dae for Circle {
//!     fn layout(&self) -> Layout {
//!         let arc = Region::dense("arc", (0.0, 1.0), &["x", "z"], &[], 0);
//!         Layout::dense(vec![arc], &[], &["start"])
//!     }
//!     fn algebraic(&self, _region: usize) -> usize {
//!         1
//!     }
//!     fn rhs<S: Scalar>(&self, _region: usize, _s: S, y: &[S], _c: &[S], f: &mut [S]) {
//!         f[0] = y[1]; // x' = z
//!         f[1] = y[0] * y[0] + y[1] * y[1] - 1.0; // 0 = x² + z² - 1
//!     }
//!     fn boundary<S: Scalar>(&self, ends: &[S], _integrals: &[S], _c: &[S], g: &mut [S]) {
//!         g[0] = ends[0];
//!     }
//! }
//!
//! let problem = Differentiated::new(Reduced::new(Circle)?)?;
//! let guess = Guess::uniform(problem.layout(), 10, &[], |_, s, y| (y[0], y[1]) = (s, 1.0));
//! let solution = solve(&problem, &guess, &[], &Options::default())?;
//! assert!((solution.regions()[0].eval(1.0)[0] - 1_f64.sin()).abs() < 1e-6);
//! assert!(problem.model().remainder(&solution) < 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! - **Boundary conditions** are as many as there are y and unknown constants. Those on z are said by g; a condition on
//!   z at an end is one on y there.
//! - **g along the way** is not zero to the last digit: it is an error like any other, and is held to the tolerance
//!   with the solution. [`Reduced::remainder`] measures it.
//! - **Of a higher index**, or where ∂g/∂z is singular on the way, z' is not finite: the solver's error names z and the
//!   place.
//! - **Which root**: where g has several roots z, the guess chooses.
//! - **Multipliers** of a periodic solution are those of y. A deviation from g = 0 stays as it is in the differentiated
//!   equations, with a multiplier 1 for each algebraic equation: [`Multipliers`](crate::Multipliers) leave them out.

use crate::linear::simd::largest;
use crate::model::{Model, Scalar};
use crate::problem::{Layout, LayoutError, Region};
use crate::solution::{RegionSolution, Solution};
use num_dual::Dual;

/// A semi-explicit differential-algebraic problem by its formulas: see the [module's head](self).
pub trait Dae {
    /// Names and sizes: in each region the states y, and behind them the states z; equations for y and the unknown
    /// constants. Patterns may be dense; those of an algebraic row are of g. Asked for once.
    fn layout(&self) -> Layout;

    /// How many states of a region are z: the last so many. Asked for once.
    fn algebraic(&self, region: usize) -> usize;

    /// `f`, one entry for each y; then `g`, one for each z, in whatever order; then the integrands. `y` holds all
    /// states at `s`.
    fn rhs<S: Scalar>(&self, region: usize, s: S, y: &[S], c: &[S], f: &mut [S]);

    /// Boundary residuals: `g` has one entry for each equation of the layout.
    fn boundary<S: Scalar>(&self, ends: &[S], integrals: &[S], c: &[S], g: &mut [S]);

    /// See [`Problem::is_linear`](crate::Problem::is_linear); of f and g.
    fn is_linear(&self, _unknowns: &[usize]) -> bool {
        false
    }
}

/// A [`Dae`] made a [`Model`]: a differential equation for each z, and a boundary equation for each g, behind those of
/// the problem, region by region.
#[derive(Debug, Clone)]
pub struct Reduced<D> {
    dae: D,
    /// As the problem states it.
    layout: Layout,
    /// Of each region, how many states are z.
    algebraic: Vec<usize>,
}

impl<D: Dae> Reduced<D> {
    /// Takes a problem.
    ///
    /// # Errors
    /// [`LayoutError::Algebraic`]: more algebraic equations than states; or a layout that contradicts itself.
    pub fn new(dae: D) -> Result<Self, LayoutError> {
        let layout = dae.layout();
        layout.check()?;
        let algebraic: Vec<usize> = (0..layout.regions.len()).map(|region| dae.algebraic(region)).collect();
        for (region, &algebraic) in layout.regions.iter().zip(&algebraic) {
            let states = region.states.len();
            if algebraic > states {
                return Err(LayoutError::Algebraic { region: region.name.clone(), algebraic, states });
            }
        }
        Ok(Self { dae, layout, algebraic })
    }

    /// The problem as it was stated.
    pub fn dae(&self) -> &D {
        &self.dae
    }

    /// By how much a solution misses its algebraic equations: the largest |g| at nodes and half-way between them. NaN
    /// where g is not finite, and for a solution of another problem.
    pub fn remainder(&self, solution: &Solution) -> f64 {
        let parts = solution.regions();
        let states = |(region, part): (&Region, &RegionSolution)| region.states.len() == part.states();
        if parts.len() != self.layout.regions.len() || !self.layout.regions.iter().zip(parts).all(states) {
            return f64::NAN;
        }
        let mut misses = Vec::new();
        for (index, (region, part)) in self.layout.regions.iter().zip(parts).enumerate() {
            let mut f = vec![0.0; region.rows()];
            let halves = part.mesh().windows(2).map(|ends| 0.5 * (ends[0] + ends[1]));
            for s in part.mesh().iter().copied().chain(halves) {
                self.dae.rhs(index, s, &part.eval(s), solution.constants(), &mut f);
                misses.extend_from_slice(&f[self.differential(index)..region.states.len()]);
            }
        }
        largest(std::iter::empty(), &misses)
    }

    /// How many states of a region are y.
    fn differential(&self, region: usize) -> usize {
        self.layout.regions[region].states.len() - self.algebraic[region]
    }
}

impl<D: Dae> Model for Reduced<D> {
    fn layout(&self) -> Layout {
        let mut layout = self.layout.clone();
        let first_constant = layout.ends() + layout.integrals();
        for (index, region) in self.layout.regions.iter().enumerate() {
            let (rows, n) = (self.differential(index)..region.states.len(), region.states.len());
            // g at the region's start: as the patterns of its rows say.
            for row in rows.clone() {
                let equation = layout.equations.len();
                layout.equations.push(format!("0 = g of {} at the start of {}", region.states[row].name, region.name));
                let states = region.state_pattern.iter().filter(|(of, _)| *of == row);
                let states = states.map(|(_, state)| layout.end(index, *state, false));
                let constants = region.constant_pattern.iter().filter(|(of, _)| *of == row);
                let inputs: Vec<usize> =
                    states.chain(constants.map(|(_, constant)| first_constant + constant)).collect();
                layout.boundary_pattern.extend(inputs.into_iter().map(|input| (equation, input)));
            }
            // z' depends on all states, and on the constants of f and g.
            let widened = |pattern: &[(usize, usize)], columns: Vec<usize>| -> Vec<(usize, usize)> {
                let kept = pattern.iter().copied().filter(|(row, _)| !rows.contains(row));
                let all = rows.clone().flat_map(|row| columns.iter().map(move |&column| (row, column)));
                kept.chain(all).collect()
            };
            let constants = |pattern: &[(usize, usize)]| -> Vec<usize> {
                let mut all: Vec<usize> = pattern.iter().filter(|(row, _)| *row < n).map(|(_, c)| *c).collect();
                all.sort_unstable();
                all.dedup();
                all
            };
            let (default, others) = region.constant_pattern.split_at(region.default_entries);
            let (default, others) = (widened(default, constants(default)), widened(others, constants(others)));
            let target = &mut layout.regions[index];
            target.state_pattern = widened(&region.state_pattern, (0..n).collect());
            target.default_entries = default.len();
            target.constant_pattern = [default, others].concat();
        }
        layout
    }

    fn rhs<S: Scalar>(&self, region: usize, s: S, y: &[S], c: &[S], f: &mut [S]) {
        let (n, d) = (y.len(), self.differential(region));
        if n == d {
            return self.dae.rhs(region, s, y, c, f);
        }
        let (zero, one) = (S::from(0.0), S::from(1.0));
        let mut moved: Vec<Dual<S>> = y.iter().map(|&y| Dual::new(y, zero)).collect();
        let constants: Vec<Dual<S>> = c.iter().map(|&c| Dual::new(c, zero)).collect();
        let mut out = vec![Dual::new(zero, zero); f.len()];
        let mut by_z = vec![zero; (n - d) * (n - d)];
        for z in d..n {
            moved[z].eps = one;
            self.dae.rhs(region, Dual::new(s, zero), &moved, &constants, &mut out);
            moved[z].eps = zero;
            for (row, out) in by_z.chunks_exact_mut(n - d).zip(&out[d..n]) {
                row[z - d] = out.eps;
            }
        }
        for (f, out) in f.iter_mut().zip(&out) {
            *f = out.re;
        }
        // How g changes where y follows f and z stays.
        for (moved, f) in moved.iter_mut().zip(&f[..d]) {
            moved.eps = *f;
        }
        self.dae.rhs(region, Dual::new(s, one), &moved, &constants, &mut out);
        for (slope, out) in f[d..n].iter_mut().zip(&out[d..n]) {
            *slope = -out.eps;
        }
        solve(&mut by_z, &mut f[d..n]);
    }

    fn boundary<S: Scalar>(&self, ends: &[S], integrals: &[S], c: &[S], g: &mut [S]) {
        let (own, mut rest) = g.split_at_mut(self.layout.equations.len());
        self.dae.boundary(ends, integrals, c, own);
        for (index, region) in self.layout.regions.iter().enumerate() {
            let (n, d) = (region.states.len(), self.differential(index));
            let first = self.layout.end(index, 0, false);
            let mut f = vec![S::from(0.0); region.rows()];
            self.dae.rhs(index, S::from(region.interval.0), &ends[first..first + n], c, &mut f);
            let here;
            (here, rest) = rest.split_at_mut(n - d);
            here.copy_from_slice(&f[d..n]);
        }
    }

    fn is_linear(&self, unknowns: &[usize]) -> bool {
        self.dae.is_linear(unknowns)
    }

    fn conserved(&self, region: usize) -> usize {
        self.algebraic.get(region).copied().unwrap_or(0)
    }
}

/// Solves `a x = b` in place, `a` by rows: elimination with the largest pivot of each column. A matrix without an
/// inverse leaves what is not finite.
fn solve<S: Scalar>(a: &mut [S], b: &mut [S]) {
    let m = b.len();
    for k in 0..m {
        let size = |row: &usize| a[row * m + k].re().abs();
        let pivot = (k..m).max_by(|i, j| size(i).total_cmp(&size(j))).unwrap_or(k);
        if pivot != k {
            for column in 0..m {
                a.swap(k * m + column, pivot * m + column);
            }
            b.swap(k, pivot);
        }
        let inverse = a[k * m + k].recip();
        for row in k + 1..m {
            let factor = a[row * m + k] * inverse;
            for column in k..m {
                let above = a[k * m + column];
                a[row * m + column] -= factor * above;
            }
            let above = b[k];
            b[row] -= factor * above;
        }
        b[k] *= inverse;
        for column in k..m {
            a[k * m + column] *= inverse;
        }
    }
    for k in (0..m).rev() {
        for row in 0..k {
            let known = b[k];
            b[row] -= a[row * m + k] * known;
        }
    }
}
