//! What a problem says of its derivatives, beside differences of its values.

use crate::error::SolveError;
use crate::guess::{Guess, RegionGuess};
use crate::problem::{Layout, Points, Problem, Region, Scope};
use std::fmt;

/// Nodes of each region at which derivatives are compared, at most.
const PLACES: usize = 16;
/// How far the second set of states lies from the guess, over their magnitudes: where a state is zero a wrong
/// derivative may be right.
const AWAY: f64 = 0.1;
/// Step of a difference, over the magnitude of what is changed: the cube root of the rounding unit, about.
const STEP: f64 = 6e-6;
/// Relative deviation beyond which a derivative is wrong; and over the error of the difference.
const WRONG: f64 = 1e-5;
const DOUBT: f64 = 8.0;
/// Rounding of a value, in units of its last digit.
const ROUNDING: f64 = 64.0 * f64::EPSILON;
/// Relative deviation of values that are stated twice.
const VALUES: f64 = 1e-12;

/// A derivative that is not that of the values, where it deviates most.
#[derive(Debug, Clone, PartialEq)]
pub struct WrongDerivative {
    /// What is differentiated: `"u'"`, `"integrand area"`, `"equation left end"`.
    pub of: String,
    /// By what: `"u"`, `"constant lambda"`, `"u at the exit of string"`; nothing where the derivatives come with
    /// another value than the problem gives without them.
    pub by: Option<String>,
    /// Region and independent variable; nothing for boundary equations.
    pub place: Option<(String, f64)>,
    /// What the problem states; 0 for an entry that its pattern does not have.
    pub stated: f64,
    /// What differences of its values say, or the value without derivatives.
    pub found: f64,
}

impl fmt::Display for WrongDerivative {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { of, by, place, stated, found } = self;
        match by {
            Some(by) => write!(f, "the derivative of {of} by {by}")?,
            None => write!(f, "the value of {of} beside its derivatives")?,
        }
        if let Some((region, s)) = place {
            write!(f, " at {s} of {region}")?;
        }
        let source = if by.is_some() { "by differences" } else { "without them" };
        write!(f, " is stated as {stated:e}, and is {found:e} {source}")
    }
}

/// Compares the derivatives that a problem states with central differences of its values, at nodes of a guess and at
/// states beside them: for those who write derivatives by hand, whose mistakes are the usual reason why Newton's
/// iteration stalls. Best told the states of a solution, or of a guess that is not zero.
///
/// What deviates by more than some 1e-5, and by more than the difference may be wrong, is told, the largest relative
/// deviation first and each derivative once; that includes entries that are not in the patterns of the layout, and
/// values that are others where derivatives are asked for. At a kink either side will do. Places at which values are
/// not finite are passed over.
///
/// ```
/// use solver::bvp::{Bvp, Formulas};
/// use solver::check_derivatives;
///
/// struct Bratu;
///
/// impl Formulas for Bratu {
///     fn rhs(&self, _: f64, y: &[f64], p: &[f64], f: &mut [f64]) {
///         (f[0], f[1]) = (y[1], -p[0] * y[0].exp());
///     }
///     fn rhs_derivatives(&self, x: f64, y: &[f64], p: &[f64], f: &mut [f64], columns: &mut [f64]) {
///         self.rhs(x, y, p, f);
///         // By u, slope and lambda; the sign of the second one is wrong.
///         columns.copy_from_slice(&[0.0, p[0] * y[0].exp(), 1.0, 0.0, 0.0, -y[0].exp()]);
///     }
///     fn boundary(&self, a: &[f64], b: &[f64], _: &[f64], g: &mut [f64]) {
///         (g[0], g[1]) = (a[0], b[0]);
///     }
///     fn boundary_derivatives(&self, a: &[f64], b: &[f64], p: &[f64], g: &mut [f64], columns: &mut [f64]) {
///         self.boundary(a, b, p, g);
///         columns.copy_from_slice(&[1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0]);
///     }
/// }
///
/// let bratu = Bvp::with(&["u", "slope"], (0.0, 1.0), Bratu).given("lambda", 1.0);
/// let wrong = check_derivatives(&bratu, &bratu.start())?;
/// assert_eq!(wrong.len(), 1);
/// assert!(wrong[0].to_string().starts_with("the derivative of slope' by u at"), "{}", wrong[0]);
/// # Ok::<(), solver::SolveError>(())
/// ```
///
/// # Errors
/// [`SolveError::Layout`] and [`SolveError::Guess`] for what does not fit together.
pub fn check_derivatives<P: Problem + ?Sized>(problem: &P, at: &Guess) -> Result<Vec<WrongDerivative>, SolveError> {
    check(&problem, at)
}

fn check(problem: &dyn Problem, at: &Guess) -> Result<Vec<WrongDerivative>, SolveError> {
    let layout = problem.layout();
    layout.check()?;
    at.check(layout)?;
    let mut worst = Worst::default();
    let mut integrals = Vec::with_capacity(layout.integrals());
    for (index, (region, guess)) in layout.regions.iter().zip(&at.regions).enumerate() {
        let batch = Batch::new(region, guess);
        InRegion { problem, layout, region: index, batch: &batch, constants: &at.constants }.compare(&mut worst);
        integrals.extend(trapezoidal(problem, index, guess, &at.constants));
    }
    AtEnds { problem, layout, constants: &at.constants }.compare(&ends(at), &integrals, &mut worst);
    Ok(worst.into_sorted())
}

/// The largest deviation of each derivative so far.
#[derive(Default)]
struct Worst(Vec<(f64, WrongDerivative)>);

impl Worst {
    fn tell(&mut self, deviation: f64, wrong: WrongDerivative) {
        let same = |(_, known): &&mut (f64, WrongDerivative)| known.of == wrong.of && known.by == wrong.by;
        match self.0.iter_mut().find(same) {
            Some(known) if known.0 >= deviation => {}
            Some(known) => *known = (deviation, wrong),
            None => self.0.push((deviation, wrong)),
        }
    }

    fn into_sorted(mut self) -> Vec<WrongDerivative> {
        self.0.sort_by(|(a, _), (b, _)| b.total_cmp(a));
        self.0.into_iter().map(|(_, wrong)| wrong).collect()
    }
}

/// Values at a place, and at one and two half steps to either side of it.
#[derive(Clone, Copy)]
struct Sampled {
    here: f64,
    /// A whole step below and above.
    whole: [f64; 2],
    /// Half a step below and above.
    half: [f64; 2],
    /// The whole step.
    step: f64,
}

impl Sampled {
    /// By how much a derivative deviates, relatively, and what it is by differences; nothing if it is right, or if
    /// nothing can be said.
    fn deviation(&self, stated: f64) -> Option<(f64, f64)> {
        let Self { here, whole: [below, above], half: [lower, upper], step } = *self;
        let (coarse, fine) = ((above - below) / (2.0 * step), (upper - lower) / step);
        let central = fine + (fine - coarse) / 3.0;
        let sides = [(upper - here) / (0.5 * step), (here - lower) / (0.5 * step)];
        if !(central.is_finite() && sides.iter().all(|side| side.is_finite())) {
            return None;
        }
        let largest =
            [here, below, above, lower, upper].into_iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        let error = DOUBT * (fine - coarse).abs() + ROUNDING * largest / step;
        let is = |value: f64, error: f64| (stated - value).abs() <= WRONG * (stated.abs() + value.abs()) + error;
        // Beside a kink the sides differ, and what is stated may be that of either.
        let parted = (sides[0] - sides[1]).abs();
        if is(central, error) || sides.into_iter().any(|side| is(side, ROUNDING * largest / step + 0.01 * parted)) {
            return None;
        }
        let deviation = (stated - central).abs() / stated.abs().max(central.abs());
        Some((if deviation.is_nan() { f64::INFINITY } else { deviation }, central))
    }
}

/// By how much a value that is stated beside derivatives differs from the one without them, relatively; nothing if they
/// are the same, or if that is not finite.
fn difference(stated: f64, found: f64) -> Option<f64> {
    let apart = (stated - found).abs() / stated.abs().max(found.abs()).max(f64::MIN_POSITIVE);
    let differ = found.is_finite() && !(apart <= VALUES);
    differ.then_some(if apart.is_nan() { f64::INFINITY } else { apart })
}

/// States of a region at which derivatives are compared: at nodes, and beside them.
struct Batch {
    s: Vec<f64>,
    /// State by state.
    y: Vec<Vec<f64>>,
    /// Of each state.
    magnitudes: Vec<f64>,
}

impl Batch {
    fn new(region: &Region, guess: &RegionGuess) -> Self {
        let nodes = guess.mesh.len();
        let count = nodes.min(PLACES);
        let places: Vec<usize> = (0..count).map(|k| k * (nodes - 1) / (count - 1).max(1)).collect();
        let twice = |values: &[f64], shift: &dyn Fn(usize) -> f64| -> Vec<f64> {
            let at_nodes = places.iter().map(|&node| values[node]);
            at_nodes.clone().chain(at_nodes.enumerate().map(|(k, value)| value + shift(k))).collect()
        };
        let magnitudes: Vec<f64> = guess
            .states
            .iter()
            .zip(&region.states)
            .map(|(values, state)| magnitude(values.iter().copied(), state.scale))
            .collect();
        let beside = |(i, values): (usize, &Vec<f64>)| {
            // No two states are shifted alike.
            twice(values, &|k| AWAY * magnitudes[i] * libm::cos(1.0 + 2.4 * k as f64 + 1.7 * i as f64))
        };
        Self { s: twice(&guess.mesh, &|_| 0.0), y: guess.states.iter().enumerate().map(beside).collect(), magnitudes }
    }

    fn len(&self) -> usize {
        self.s.len()
    }
}

/// The largest of some values, or their typical magnitude where that is stated; 1 where nothing is known.
fn magnitude(values: impl Iterator<Item = f64>, scale: Option<f64>) -> f64 {
    let largest = values.fold(scale.unwrap_or(0.0), |most: f64, value| most.max(value.abs()));
    if largest > 0.0 { largest } else { 1.0 }
}

/// Places in a pattern of the entries of a column, row by row; none of those that it does not have.
fn entries(pattern: &[(usize, usize)], column: usize, rows: usize) -> Vec<Option<usize>> {
    let mut entries = vec![None; rows];
    for (entry, &(row, _)) in pattern.iter().enumerate().filter(|(_, (_, of))| *of == column) {
        entries[row] = Some(entry);
    }
    entries
}

/// Places that are changed by one step or half of it, either way.
const SIDES: [f64; 4] = [-1.0, 1.0, -0.5, 0.5];

/// Right-hand side and integrands of a region.
struct InRegion<'a> {
    problem: &'a dyn Problem,
    layout: &'a Layout,
    region: usize,
    batch: &'a Batch,
    constants: &'a [f64],
}

impl InRegion<'_> {
    fn compare(&self, worst: &mut Worst) {
        let region = &self.layout.regions[self.region];
        let (rows, stride) = (region.rows(), self.batch.len());
        let y = self.batch.y.concat();
        let at = Points { len: stride, stride, s: &self.batch.s, y: &y };
        let mut stated = vec![f64::NAN; rows * stride];
        let mut dy = vec![f64::NAN; region.state_pattern.len() * stride];
        let mut dc = vec![f64::NAN; region.constant_pattern.len() * stride];
        let constants = self.constants;
        self.problem.rhs_jacobian(self.region, &at, constants, Scope::All, &mut stated, &mut dy, &mut dc);
        let here = self.values(&y, constants);
        for (at, (stated, found)) in stated.iter().zip(&here).enumerate() {
            if let Some(deviation) = difference(*stated, *found) {
                worst.tell(deviation, self.wrong(at, None, *stated, *found));
            }
        }
        for state in 0..region.states.len() {
            let step = STEP * self.batch.magnitudes[state];
            let sampled = SIDES.map(|side| {
                let mut moved = y.clone();
                moved[state * stride..(state + 1) * stride].iter_mut().for_each(|value| *value += side * step);
                self.values(&moved, constants)
            });
            let entries = entries(&region.state_pattern, state, rows);
            self.column(worst, &here, &sampled, step, &region.states[state].name, &|row, j| {
                entries[row].map_or(0.0, |entry| dy[entry * stride + j])
            });
        }
        for (index, constant) in self.layout.constants.iter().enumerate() {
            let step = STEP * magnitude([constants[index]].into_iter(), constant.scale);
            let sampled = SIDES.map(|side| {
                let mut moved = constants.to_vec();
                moved[index] += side * step;
                self.values(&y, &moved)
            });
            let entries = entries(&region.constant_pattern, index, rows);
            self.column(worst, &here, &sampled, step, &format!("constant {}", constant.name), &|row, j| {
                entries[row].map_or(0.0, |entry| dc[entry * stride + j])
            });
        }
    }

    /// Derivatives of all rows by one state or constant.
    fn column(
        &self,
        worst: &mut Worst,
        here: &[f64],
        [below, above, lower, upper]: &[Vec<f64>; 4],
        step: f64,
        by: &str,
        stated: &dyn Fn(usize, usize) -> f64,
    ) {
        let stride = self.batch.len();
        for (at, &here) in here.iter().enumerate() {
            let sampled = Sampled { here, whole: [below[at], above[at]], half: [lower[at], upper[at]], step };
            let stated = stated(at / stride, at % stride);
            if let Some((deviation, found)) = sampled.deviation(stated) {
                worst.tell(deviation, self.wrong(at, Some(by.to_owned()), stated, found));
            }
        }
    }

    fn wrong(&self, at: usize, by: Option<String>, stated: f64, found: f64) -> WrongDerivative {
        let region = &self.layout.regions[self.region];
        let (row, j) = (at / self.batch.len(), at % self.batch.len());
        let of = match region.states.get(row) {
            Some(state) => format!("{}'", state.name),
            None => format!("integrand {}", region.integrals[row - region.states.len()]),
        };
        WrongDerivative { of, by, place: Some((region.name.clone(), self.batch.s[j])), stated, found }
    }

    fn values(&self, y: &[f64], constants: &[f64]) -> Vec<f64> {
        let stride = self.batch.len();
        let mut f = vec![f64::NAN; self.layout.regions[self.region].rows() * stride];
        self.problem.rhs(self.region, &Points { len: stride, stride, s: &self.batch.s, y }, constants, &mut f);
        f
    }
}

/// Integrals of a region along a guess, by the trapezoidal rule: as good as any values for what is compared.
fn trapezoidal(problem: &dyn Problem, index: usize, guess: &RegionGuess, constants: &[f64]) -> Vec<f64> {
    let region = &problem.layout().regions[index];
    let (nodes, y) = (guess.mesh.len(), guess.states.concat());
    let mut f = vec![f64::NAN; region.rows() * nodes];
    problem.rhs(index, &Points { len: nodes, stride: nodes, s: &guess.mesh, y: &y }, constants, &mut f);
    let integral = |values: &[f64]| -> f64 {
        let pairs = guess.mesh.windows(2).zip(values.windows(2));
        pairs.map(|(s, f)| 0.5 * (s[1] - s[0]) * (f[0] + f[1])).sum()
    };
    let found = f.chunks_exact(nodes).skip(region.states.len()).map(integral);
    found.map(|value| if value.is_finite() { value } else { 1.0 }).collect()
}

/// Entry and exit states of a guess, region by region.
fn ends(at: &Guess) -> Vec<f64> {
    let of = |region: &RegionGuess| -> Vec<f64> {
        let last = region.mesh.len() - 1;
        [0, last].into_iter().flat_map(|node| region.states.iter().map(move |values| values[node])).collect()
    };
    at.regions.iter().flat_map(of).collect()
}

/// The boundary equations.
struct AtEnds<'a> {
    problem: &'a dyn Problem,
    layout: &'a Layout,
    constants: &'a [f64],
}

impl AtEnds<'_> {
    /// At the ends of a guess, and beside them.
    fn compare(&self, ends: &[f64], integrals: &[f64], worst: &mut Worst) {
        let magnitudes: Vec<f64> =
            self.scales().zip(ends).map(|(scale, end)| magnitude([*end].into_iter(), scale)).collect();
        let beside = |(i, (end, size)): (usize, (&f64, &f64))| end + AWAY * size * libm::cos(1.0 + 1.7 * i as f64);
        let moved: Vec<f64> = ends.iter().zip(&magnitudes).enumerate().map(beside).collect();
        let known = integrals.iter().map(|value| magnitude([*value].into_iter(), None));
        let constants = self.layout.constants.iter().zip(self.constants);
        let constants = constants.map(|(constant, value)| magnitude([*value].into_iter(), constant.scale));
        let magnitudes: Vec<f64> = magnitudes.iter().copied().chain(known).chain(constants).collect();
        for ends in [ends, &moved] {
            let inputs = [ends, integrals, self.constants].concat();
            self.at(&inputs, &magnitudes, worst);
        }
    }

    /// Stated magnitudes of the states at all ends.
    fn scales(&self) -> impl Iterator<Item = Option<f64>> + '_ {
        self.layout
            .regions
            .iter()
            .flat_map(|region| region.states.iter().chain(&region.states).map(|state| state.scale))
    }

    fn at(&self, inputs: &[f64], magnitudes: &[f64], worst: &mut Worst) {
        let layout = self.layout;
        let (ends, rest) = inputs.split_at(layout.ends());
        let (integrals, constants) = rest.split_at(layout.integrals());
        let mut stated = vec![f64::NAN; layout.equations.len()];
        let mut dz = vec![f64::NAN; layout.boundary_pattern.len()];
        self.problem.boundary_jacobian(ends, integrals, constants, &mut stated, &mut dz);
        let here = self.values(inputs);
        let wrong = |row: usize, by: Option<String>, stated: f64, found: f64| WrongDerivative {
            of: format!("equation {}", layout.equations[row]),
            by,
            place: None,
            stated,
            found,
        };
        for (row, (stated, found)) in stated.iter().zip(&here).enumerate() {
            if let Some(deviation) = difference(*stated, *found) {
                worst.tell(deviation, wrong(row, None, *stated, *found));
            }
        }
        for (input, size) in magnitudes.iter().enumerate() {
            let step = STEP * size;
            let [below, above, lower, upper] = SIDES.map(|side| {
                let mut moved = inputs.to_vec();
                moved[input] += side * step;
                self.values(&moved)
            });
            let entries = entries(&layout.boundary_pattern, input, here.len());
            for (row, &here) in here.iter().enumerate() {
                let sampled = Sampled { here, whole: [below[row], above[row]], half: [lower[row], upper[row]], step };
                let stated = entries[row].map_or(0.0, |entry| dz[entry]);
                if let Some((deviation, found)) = sampled.deviation(stated) {
                    worst.tell(deviation, wrong(row, Some(layout.input_name(input)), stated, found));
                }
            }
        }
    }

    fn values(&self, inputs: &[f64]) -> Vec<f64> {
        let (ends, rest) = inputs.split_at(self.layout.ends());
        let (integrals, constants) = rest.split_at(self.layout.integrals());
        let mut g = vec![f64::NAN; self.layout.equations.len()];
        self.problem.boundary(ends, integrals, constants, &mut g);
        g
    }
}
