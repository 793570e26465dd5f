//! A problem deformed so that the guess solves it: the global homotopy.
//!
//! ```text
//! y' = f(s, y, c) + (1 - t) [S₀'(s) - f(s, S₀(s), c₀)],      g(ends, I, c) = (1 - t) g(ends₀, I₀, c₀)
//! ```
//!
//! For t = 0 the guess S₀ is a solution, for t = 1 the problem is the given one; the branch in between is traced by
//! arclength, since t need not grow all the way. S. Smale, J. Math. Econ. 3 (1976) 107-120; H. B. Keller (1977).

use std::cell::Cell;

use crate::budget::Budget;
use crate::guess::Guess;
use crate::mesh::slope;
use crate::problem::{Constant, Layout, Points, Problem, Scope};
use crate::stats::Stats;

/// See the module's head. `t` is the last of the constants.
pub(crate) struct Homotopy<'p, P: Problem + ?Sized> {
    problem: &'p P,
    guess: &'p Guess,
    /// What evaluations at the guess are charged to: those at the states are counted by who asks for them.
    budget: &'p Budget,
    /// Points at which the right-hand side was evaluated at the guess.
    points: Cell<usize>,
    layout: Layout,
    /// Slopes of the guess at its nodes.
    slopes: Vec<Vec<Vec<f64>>>,
    /// Boundary residuals of the guess.
    g: Vec<f64>,
}

impl<'p, P: Problem + ?Sized> Homotopy<'p, P> {
    pub(crate) fn new(problem: &'p P, guess: &'p Guess, budget: &'p Budget) -> Self {
        let inner = problem.layout();
        let mut layout = inner.clone();
        let t = inner.constants.len();
        layout.constants.push(Constant { name: "homotopy from the guess".to_owned(), scale: Some(1.0) });
        for region in &mut layout.regions {
            region.constant_pattern.extend((0..region.states.len()).map(|row| (row, t)));
        }
        let last = inner.inputs();
        layout.boundary_pattern.extend((0..inner.equations.len()).map(|row| (row, last)));
        let slopes = guess.regions.iter().map(|region| {
            let along = |values: &Vec<f64>| (0..values.len()).map(|j| slope(&region.mesh, values, j)).collect();
            region.states.iter().map(along).collect()
        });
        let (slopes, points) = (slopes.collect(), Cell::new(0));
        let mut homotopy = Self { problem, guess, budget, points, layout, slopes, g: Vec::new() };
        homotopy.g = homotopy.boundary_of_guess();
        homotopy
    }

    /// Points at which the right-hand side was evaluated at the guess, beside those that its user counts.
    pub(crate) fn points(&self) -> usize {
        self.points.get()
    }

    /// Its integrals are taken by the midpoint rule: equations and integrands may be undefined at the ends of a region,
    /// and what they come to need only be finite.
    fn boundary_of_guess(&self) -> Vec<f64> {
        let inner = self.problem.layout();
        let (mut ends, mut integrals) = (Vec::new(), Vec::new());
        for (index, (guess, region)) in self.guess.regions.iter().zip(&inner.regions).enumerate() {
            ends.extend(guess.states.iter().filter_map(|y| y.first()));
            ends.extend(guess.states.iter().filter_map(|y| y.last()));
            if region.integrals.is_empty() {
                continue;
            }
            let s: Vec<f64> = guess.mesh.windows(2).map(|nodes| 0.5 * (nodes[0] + nodes[1])).collect();
            let (y, _) = self.between_nodes(index, &s, s.len());
            let f = self.at_guess(index, &Points { len: s.len(), stride: s.len(), s: &s, y: &y });
            let lengths = || guess.mesh.windows(2).map(|nodes| nodes[1] - nodes[0]);
            let integral = |q: &[f64]| lengths().zip(q).map(|(h, q)| h * q).sum::<f64>();
            integrals.extend(f.chunks_exact(s.len()).skip(region.states.len()).map(integral));
        }
        let mut g = vec![0.0; inner.equations.len()];
        self.problem.boundary(&ends, &integrals, &self.guess.constants, &mut g);
        g
    }

    /// The guess at some points, by cubics between its nodes, and its slope: `n * stride` each.
    fn between_nodes(&self, region: usize, s: &[f64], stride: usize) -> (Vec<f64>, Vec<f64>) {
        let (guess, slopes) = (&self.guess.regions[region], &self.slopes[region]);
        let n = guess.states.len();
        let (mut y, mut slope) = (vec![0.0; n * stride], vec![0.0; n * stride]);
        for (p, &s) in s.iter().enumerate() {
            let j = guess.mesh.partition_point(|&node| node <= s).saturating_sub(1).min(guess.mesh.len() - 2);
            let h = guess.mesh[j + 1] - guess.mesh[j];
            let (x, z) = ((s - guess.mesh[j]) / h, 1.0 - (s - guess.mesh[j]) / h);
            for i in 0..n {
                let (left, rise) = (guess.states[i][j], guess.states[i][j + 1] - guess.states[i][j]);
                let (f0, f1) = (h * slopes[i][j], h * slopes[i][j + 1]);
                y[i * stride + p] = left + rise * x * x * (3.0 - 2.0 * x) + f0 * x * z * z - f1 * x * x * z;
                let derivative = rise * 6.0 * x * z + f0 * z * (1.0 - 3.0 * x) - f1 * x * (2.0 - 3.0 * x);
                slope[i * stride + p] = derivative / h;
            }
        }
        (y, slope)
    }

    /// Right-hand side and integrands where the states are the guess's: `rows * stride`.
    fn at_guess(&self, region: usize, at: &Points<'_>) -> Vec<f64> {
        let mut f = vec![0.0; self.problem.layout().regions[region].rows() * at.stride];
        self.problem.rhs(region, at, &self.guess.constants, &mut f);
        self.points.set(self.points.get() + at.len);
        self.budget.charge(&Stats { rhs_points: at.len, ..Stats::default() });
        f
    }

    /// `S₀' - f(S₀)` at the points: `n * stride`.
    fn defect(&self, region: usize, at: &Points<'_>) -> Vec<f64> {
        let (y, mut slope) = self.between_nodes(region, &at.s[..at.len], at.stride);
        let f = self.at_guess(region, &Points { y: &y, ..*at });
        slope.iter_mut().zip(&f).for_each(|(slope, f)| *slope -= f);
        slope
    }

    fn split<'c>(&self, constants: &'c [f64]) -> (&'c [f64], f64) {
        constants.split_last().map_or((&[], 0.0), |(t, rest)| (rest, 1.0 - t))
    }
}

impl<P: Problem + ?Sized> Problem for Homotopy<'_, P> {
    fn layout(&self) -> &Layout {
        &self.layout
    }

    fn rhs(&self, region: usize, at: &Points<'_>, constants: &[f64], f: &mut [f64]) {
        let (inner, rest) = self.split(constants);
        self.problem.rhs(region, at, inner, f);
        for (f, defect) in f.iter_mut().zip(self.defect(region, at)) {
            *f += rest * defect;
        }
    }

    fn rhs_jacobian(
        &self,
        region: usize,
        at: &Points<'_>,
        constants: &[f64],
        _: Scope,
        f: &mut [f64],
        dy: &mut [f64],
        dc: &mut [f64],
    ) {
        let (inner, rest) = self.split(constants);
        let entries = self.problem.layout().regions[region].constant_pattern.len();
        let (inner_dc, added) = dc.split_at_mut(entries * at.stride);
        self.problem.rhs_jacobian(region, at, inner, Scope::All, f, dy, inner_dc);
        let defect = self.defect(region, at);
        for ((f, added), defect) in f.iter_mut().zip(added).zip(defect) {
            *f += rest * defect;
            *added = -defect;
        }
    }

    fn boundary(&self, ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]) {
        let (inner, rest) = self.split(constants);
        self.problem.boundary(ends, integrals, inner, g);
        g.iter_mut().zip(&self.g).for_each(|(g, first)| *g -= rest * first);
    }

    fn boundary_jacobian(&self, ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64], dz: &mut [f64]) {
        let (inner, rest) = self.split(constants);
        let (inner_dz, added) = dz.split_at_mut(self.problem.layout().boundary_pattern.len());
        self.problem.boundary_jacobian(ends, integrals, inner, g, inner_dz);
        g.iter_mut().zip(&self.g).for_each(|(g, first)| *g -= rest * first);
        added.copy_from_slice(&self.g);
    }
}
