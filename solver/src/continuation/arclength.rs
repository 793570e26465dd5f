//! A problem whose parameter is unknown, with one more equation: the solution lies at a given distance from a
//! reference solution along its tangent (pseudo-arclength; H. B. Keller, in "Applications of Bifurcation Theory",
//! Academic Press 1977, 359-384).
//!
//! ```text
//! Σ_r 1/ℓ_r ∫ Σ_i τ_i (y_i - ȳ_i)/Y_i² ds + Σ_c τ_c (c - c̄)/C² = step
//! ```
//!
//! with the tangent τ of unit length in this inner product. The sum over nodes is stated as one more integral of each
//! region, so that the solver needs no other equation than those it has, and folds are regular points. What the
//! method's quadrature makes of the integral is the distance, by definition: no mesh is refined for it, and that τ is
//! linear between the nodes is no error.

use crate::by_region::ByRegion;
use crate::guess::{Guess, RegionGuess};
use crate::linear::memory::Numbers;
use crate::orientation::Determinant;
use crate::problem::{Constant, Layout, Points, Problem, Scope};
use crate::solution::Solution;
use std::cell::RefCell;
use std::rc::Rc;

/// The direction in which a branch leaves one of its points: rates of change, of unit length in the inner product of
/// pseudo-arclength.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Direction {
    /// Of the states, by region, state and node.
    pub states: Vec<Vec<Vec<f64>>>,
    /// Of all constants; zero for those that are given and stay.
    pub constants: Vec<f64>,
}

/// A point of a branch, and the direction in which the branch leaves it.
#[derive(Debug, Clone)]
pub(crate) struct Reference {
    pub solution: Solution,
    pub direction: Direction,
    /// Of the problem that arclength extends; unknown where that was not solved.
    pub determinant: Determinant,
    /// Whether two branches cross here, and the direction is at right angles to one of them: it is not the tangent of
    /// the other.
    pub is_crossing: bool,
    /// Whether the place of a branch point here is as exact as was asked for.
    pub is_settled: bool,
    /// The solution at the inner stages of its mesh, as an [`Iterate`](crate::collocation::Iterate) has it; empty where
    /// it is not known.
    pub inner: ByRegion<Numbers>,
    samples: RefCell<Samples>,
}

/// The reference at batches of points: the solver asks for the same ones again and again.
type Samples = Vec<Rc<Sampled>>;

/// So many batches are kept: those of several meshes.
const KEPT: usize = 48;

/// A reference solution and its direction at one batch of points, state by state.
#[derive(Debug)]
struct Sampled {
    region: usize,
    s: Vec<f64>,
    /// ȳ.
    y: Vec<f64>,
    /// τ/(ℓ Y²).
    weights: Vec<f64>,
}

impl Reference {
    pub(crate) fn new(solution: Solution, direction: Direction, determinant: Determinant) -> Self {
        let (inner, samples) = (ByRegion::default(), RefCell::default());
        Self { solution, direction, determinant, is_crossing: false, is_settled: false, inner, samples }
    }

    /// `ȳ` and the weighted `τ` of one region at a batch of points, the weights of the states being `of_states`.
    fn sampled(&self, region: usize, s: &[f64], of_states: &[f64]) -> Rc<Sampled> {
        let mut samples = self.samples.borrow_mut();
        if let Some(known) = samples.iter().find(|known| known.region == region && known.s == s) {
            return known.clone();
        }
        let solution = &self.solution.regions()[region];
        let places = solution.places(s);
        let mut weights = Vec::with_capacity(of_states.len() * s.len());
        for (weight, values) in of_states.iter().zip(&self.direction.states[region]) {
            weights.extend(places.iter().map(|place| {
                let (left, right) = (values[place.interval], values[place.interval + 1]);
                weight * (left + place.sigma.clamp(0.0, 1.0) * (right - left))
            }));
        }
        let new = Rc::new(Sampled { region, s: s.to_vec(), y: solution.at_places(&places), weights });
        if samples.len() >= KEPT {
            samples.clear();
        }
        samples.push(new.clone());
        new
    }
}

impl Direction {
    pub(crate) fn fits(&self, guess: &Guess) -> bool {
        let fits = |(rates, region): (&Vec<Vec<f64>>, &RegionGuess)| {
            rates.len() == region.states.len() && rates.iter().all(|rates| rates.len() == region.mesh.len())
        };
        let regions = self.states.len() == guess.regions.len() && self.states.iter().zip(&guess.regions).all(fits);
        regions && self.constants.len() == guess.constants.len()
    }
}

/// See the module's head. The step is the last of the constants.
pub(crate) struct Arclength<'p, P: Problem + ?Sized> {
    problem: &'p P,
    reference: &'p Reference,
    layout: Layout,
    /// 1/(ℓ Y²) of each state.
    state_weights: Vec<Vec<f64>>,
    /// τ/C² of each constant.
    constant_weights: Vec<f64>,
}

impl<'p, P: Problem + ?Sized> Arclength<'p, P> {
    pub(crate) fn new(problem: &'p P, reference: &'p Reference) -> Self {
        let inner = problem.layout();
        let state_weights = state_weights(inner, &reference.solution);
        let squares = constant_squares(inner, &reference.solution);
        let constant_weights =
            reference.direction.constants.iter().zip(squares).map(|(rate, square)| rate / square).collect();
        Self {
            problem,
            reference,
            layout: extended(inner, &reference.direction.constants),
            state_weights,
            constant_weights,
        }
    }

    /// Index of the step among the constants.
    pub(crate) fn step(&self) -> usize {
        self.layout.constants.len() - 1
    }

    /// The added integrand, and its derivatives if there is room for them.
    fn distance(&self, region: usize, at: &Points<'_>, f: &mut [f64], dy: &mut [f64]) {
        let Points { len, stride, s, y } = *at;
        let sampled = self.reference.sampled(region, &s[..len], &self.state_weights[region]);
        let f = &mut f[..len];
        f.fill(0.0);
        for (i, (weights, old)) in sampled.weights.chunks_exact(len).zip(sampled.y.chunks_exact(len)).enumerate() {
            let y = &y[i * stride..][..len];
            for (((f, weight), y), old) in f.iter_mut().zip(weights).zip(y).zip(old) {
                *f += weight * (y - old);
            }
            if let Some(entries) = dy.get_mut(i * stride..i * stride + len) {
                entries.copy_from_slice(weights);
            }
        }
    }

    /// Integrals of the inner problem, and the sum of the added ones.
    fn split(&self, integrals: &[f64]) -> (Vec<f64>, f64) {
        let (mut inner, mut sum, mut first) = (Vec::new(), 0.0, 0);
        for region in &self.layout.regions {
            let k = region.integrals.len();
            inner.extend_from_slice(&integrals[first..first + k - 1]);
            sum += integrals[first + k - 1];
            first += k;
        }
        (inner, sum)
    }

    fn residual(&self, distance: f64, constants: &[f64]) -> f64 {
        let reference = self.reference.solution.constants();
        let moved = self.constant_weights.iter().zip(constants.iter().zip(reference));
        distance + moved.map(|(weight, (c, old))| weight * (c - old)).sum::<f64>() - constants[self.step()]
    }
}

impl<P: Problem + ?Sized> Problem for Arclength<'_, P> {
    fn layout(&self) -> &Layout {
        &self.layout
    }

    fn rhs(&self, region: usize, at: &Points<'_>, constants: &[f64], f: &mut [f64]) {
        let (inner, added) = f.split_at_mut((self.layout.regions[region].rows() - 1) * at.stride);
        self.problem.rhs(region, at, &constants[..self.step()], inner);
        self.distance(region, at, added, &mut []);
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
        let layout = &self.layout.regions[region];
        let (inner, added) = f.split_at_mut((layout.rows() - 1) * at.stride);
        let entries = layout.state_pattern.len() - layout.states.len();
        let (inner_dy, added_dy) = dy.split_at_mut(entries * at.stride);
        self.problem.rhs_jacobian(region, at, &constants[..self.step()], scope, inner, inner_dy, dc);
        self.distance(region, at, added, added_dy);
    }

    fn boundary(&self, ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]) {
        let (inner, distance) = self.split(integrals);
        if let Some((last, rest)) = g.split_last_mut() {
            self.problem.boundary(ends, &inner, &constants[..self.step()], rest);
            *last = self.residual(distance, constants);
        }
    }

    fn boundary_jacobian(&self, ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64], dz: &mut [f64]) {
        let (inner, distance) = self.split(integrals);
        let entries = self.problem.layout().boundary_pattern.len();
        let (inner_dz, added) = dz.split_at_mut(entries);
        if let Some((last, rest)) = g.split_last_mut() {
            self.problem.boundary_jacobian(ends, &inner, &constants[..self.step()], rest, inner_dz);
            *last = self.residual(distance, constants);
        }
        let moving = self.constant_weights.iter().filter(|&&weight| weight != 0.0).copied();
        let ones = self.layout.regions.iter().map(|_| 1.0);
        let values = ones.chain(moving).chain(std::iter::once(-1.0));
        added.iter_mut().zip(values).for_each(|(entry, value)| *entry = value);
    }
}

/// The inner layout with one more integral a region, one more constant and one more equation.
fn extended(inner: &Layout, rates: &[f64]) -> Layout {
    let mut layout = inner.clone();
    for region in &mut layout.regions {
        let rows = region.rows();
        region.state_pattern.extend((0..region.states.len()).map(|i| (rows, i)));
        region.integrals.push("distance along the branch".to_owned());
    }
    layout.constants.push(Constant { name: "step along the branch".to_owned(), scale: None });
    layout.equations.push("distance along the branch".to_owned());
    // Where the inner integrals go, and where the added ones stand.
    let ends = inner.ends();
    let (mut map, mut added, mut next) = (Vec::new(), Vec::new(), ends);
    for region in &inner.regions {
        map.extend(next..next + region.integrals.len());
        next += region.integrals.len();
        added.push(next);
        next += 1;
    }
    let first = ends + inner.integrals();
    let shifted = |input: usize| match input {
        _ if input < ends => input,
        _ if input < first => map[input - ends],
        _ => input + added.len(),
    };
    layout.boundary_pattern = inner.boundary_pattern.iter().map(|&(row, input)| (row, shifted(input))).collect();
    let row = inner.equations.len();
    let moving = rates.iter().enumerate().filter(|(_, rate)| **rate != 0.0).map(|(c, _)| shifted(first + c));
    let step = shifted(first + inner.constants.len());
    let inputs: Vec<usize> = added.iter().copied().chain(moving).chain(std::iter::once(step)).collect();
    layout.boundary_pattern.extend(inputs.into_iter().map(|input| (row, input)));
    layout
}

fn state_weights(layout: &Layout, solution: &Solution) -> Vec<Vec<f64>> {
    let regions = layout.regions.iter().zip(solution.regions());
    let weights = regions.map(|(region, solved)| {
        let length = region.interval.1 - region.interval.0;
        let states = region.states.iter().enumerate();
        let weight = |(i, state): (usize, &crate::problem::State)| {
            let found = solved.state(i).iter().fold(0.0_f64, |max, y| max.max(y.abs()));
            1.0 / (length * found.max(state.scale.unwrap_or(1.0)).powi(2))
        };
        states.map(weight).collect()
    });
    weights.collect()
}

pub(super) fn constant_squares(layout: &Layout, solution: &Solution) -> Vec<f64> {
    let constants = layout.constants.iter().zip(solution.constants());
    constants.map(|(constant, c)| c.abs().max(constant.scale.unwrap_or(1.0)).powi(2)).collect()
}

/// Makes the direction one of unit length in the inner product of its solution; its length before.
pub(crate) fn normalise(layout: &Layout, reference: &mut Reference) -> f64 {
    let weights = state_weights(layout, &reference.solution);
    let squares = constant_squares(layout, &reference.solution);
    let Reference { solution, direction: Direction { states, constants }, .. } = reference;
    let mut sum: f64 = constants.iter().zip(squares).map(|(rate, square)| rate * rate / square).sum();
    for (region, (direction, weights)) in states.iter().zip(&weights).enumerate() {
        let mesh = solution.regions()[region].mesh();
        for (values, weight) in direction.iter().zip(weights) {
            let pairs = mesh.windows(2).zip(values.windows(2));
            sum += weight * pairs.map(|(s, v)| (s[1] - s[0]) * 0.5 * (v[0] * v[0] + v[1] * v[1])).sum::<f64>();
        }
    }
    let length = if sum > 0.0 { sum.sqrt() } else { 1.0 };
    let factor = 1.0 / length;
    constants.iter_mut().chain(states.iter_mut().flatten().flatten()).for_each(|rate| *rate *= factor);
    length
}
