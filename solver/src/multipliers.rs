//! Floquet's multipliers: what a periodic solution's neighbours are multiplied by in each period.

use crate::error::{NewtonError, SolveError};
use crate::guess::Guess;
use crate::linearisation::Linearisation;
use crate::mesh::halved;
use crate::options::positive;
use crate::problem::Problem;
use crate::solution::Solution;
use crate::stats::Stats;
use nalgebra::{Complex, DMatrix, Schur};

/// Meshes are halved so often at most.
const HALVINGS: usize = 6;
/// Intervals beyond which they are not.
const MOST_INTERVALS: usize = 100_000;
/// Where on the unit circle the transformation may be centred: halves of it, for eigenvalues come in conjugate pairs,
/// and away from 1 and -1, near which multipliers are wherever a branch of orbits has a fold or a period doubles.
const CENTRES: [f64; 5] = [0.4, 1.0, 1.6, 2.2, 2.8];
/// Imaginary parts smaller than this, relative to the modulus or to 1, are rounding.
const REAL: f64 = 1e-12;
/// Relative error by rounding with which a multiplier has no digit left that its sign could be taken from.
const BLURRED: f64 = 0.03;
/// How far that which is to be 1 may lie from it.
const ASTRAY: f64 = 0.1;
/// Most sweeps of the decomposition.
const SWEEPS: usize = 10_000;

/// One of them, a complex number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Multiplier {
    /// Real part.
    pub re: f64,
    /// Imaginary part.
    pub im: f64,
}

impl Multiplier {
    /// By how much a small deviation has grown after a period.
    pub fn modulus(self) -> f64 {
        libm::hypot(self.re, self.im)
    }

    /// By how much it has turned, from -π to π.
    pub fn angle(self) -> f64 {
        libm::atan2(self.im, self.re)
    }

    fn conjugate(self) -> Self {
        Self { im: -self.im, ..self }
    }

    fn distance(self, other: Self) -> f64 {
        libm::hypot(self.re - other.re, self.im - other.im)
    }

    fn times(self, other: Self) -> Self {
        Self { re: self.re * other.re - self.im * other.im, im: self.re * other.im + self.im * other.re }
    }

    /// `(1 + μ)/(1 + |μ|)`.
    fn plus_one(self) -> Self {
        let size = 1.0 + self.modulus();
        if size.is_finite() { Self { re: (1.0 + self.re) / size, im: self.im / size } } else { ONE }
    }
}

/// Whether time may be begun anywhere.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Orbit {
    /// The right-hand side does not depend on time, and the period is among the unknown constants: the orbit may be
    /// begun anywhere, so that one multiplier is 1.
    Autonomous,
    /// It does, and the period is given.
    Forced,
}

/// The multipliers of one region: the eigenvalues of what the equations, linearised at a solution, with all constants
/// held, make of a deviation from its left end to its right end. Where the solution is periodic and the region its
/// period, they are Floquet's: the orbit is stable if all of them are less than 1 in modulus, but for that which is 1
/// where the problem is autonomous. How near to 1 that comes out tells how well all of them are known. Those that are 1
/// whatever the solution ([`Problem::conserved`]) are left out: as many as there are, of those nearest to 1.
///
/// Along a branch of orbits one leaves the unit circle at 1 at a fold or branch point, at -1 where the period doubles,
/// and a pair of them elsewhere where a torus is born: the zeros of [`doubling`](Self::doubling) and
/// [`torus`](Self::torus), which [`trace`](crate::continuation::trace) locates as events.
///
/// With `u_1` and `u_0` the deviations at the ends, elimination has left `P u_0 + Q u_1 = 0`, by reflections, so that
/// neither growth nor decay of whatever size has spoiled it. The pencil's eigenvalues are taken from
/// `(P - σQ)⁻¹ (P + σQ)`, whose κ are bounded for a suitable σ on the unit circle: `μ = σ (1 + κ)/(1 - κ)` is known to
/// rounding near that circle whatever the others are. One of size m beyond it is known to m ε relative to itself, one
/// within it to ε (other methods, and why products of matrices will not do: T. F. Fairgrieve and A. D. Jepson, SIAM J.
/// Numer. Anal. 28 (1991) 1446-1462; the transformation is Cayley's).
#[derive(Debug, Clone, PartialEq)]
pub struct Multipliers {
    /// Without those that are to be 1.
    values: Vec<Multiplier>,
    /// Those that are to be 1, the nearest to it first.
    ones: Vec<Multiplier>,
    orbit: Orbit,
    change: f64,
    stats: Stats,
}

impl Multipliers {
    /// Those of a region of a solution, on its own mesh and on that mesh halved, until no multiplier changes by more
    /// than `tolerance` (relative to its modulus, or to 1 if that is less), six times at most: deviations may vary
    /// where the orbit does not. What the solution's own error does to them is not seen by that.
    ///
    /// ```
    /// use solver::bvp::Bvp;
    /// use solver::{Multipliers, Options, Orbit, Order};
    ///
    /// // Van der Pol's equation, whose period T is unknown: time is in units of it.
    /// let orbit = Bvp::new(
    ///     &["u", "slope"],
    ///     (0.0, 1.0),
    ///     |_, y, p, f| (f[0], f[1]) = (p[0] * y[1], p[0] * ((-y[0] * y[0] + 1.0) * y[1] - y[0])),
    ///     |a, b, _, g| (g[0], g[1], g[2]) = (a[1], b[0] - a[0], b[1] - a[1]),
    /// )
    /// .unknown("T", 6.5)
    /// .guess(20, |x, y| (y[0], y[1]) = (2.0 * (6.28 * x).cos(), -2.0 * (6.28 * x).sin()));
    /// let solution = orbit.solve(&Options { order: Order::Six, tolerance: 1e-8, ..Options::default() })?;
    /// let multipliers = Multipliers::new(&orbit, &solution, 0, Orbit::Autonomous, 1e-6)?;
    /// assert!(multipliers.is_stable() && (multipliers.largest() - 8.598e-4).abs() < 1e-6);
    /// assert!(multipliers.trivial().is_some_and(|trivial| (trivial.re - 1.0).abs() < 1e-6));
    /// # Ok::<(), solver::SolveError>(())
    /// ```
    ///
    /// # Errors
    /// The solution is not one of this problem's, there is no such region, the tolerance is not positive, or the
    /// equations are undefined between the nodes of the solution's mesh. [`SolveError::PartOfOrbit`] if the orbit goes
    /// on in another region: if the region has not as many boundary equations as states that tie its right end to its
    /// left end and to nothing else, and one that ties it to another region.
    pub fn new<P: Problem + ?Sized>(
        problem: &P,
        solution: &Solution,
        region: usize,
        orbit: Orbit,
        tolerance: f64,
    ) -> Result<Self, SolveError> {
        positive([("tolerance", tolerance)])?;
        let regions = solution.regions().len();
        let Some(known) = solution.regions().get(region) else {
            return Err(SolveError::Region { index: region, regions });
        };
        let (mut at, mut stats) = (Guess::from(solution), Stats::default());
        let mut values = on_mesh(problem, solution, &at, region, &mut stats)?;
        is_whole(problem, solution, region)?;
        let mut change = f64::INFINITY;
        for _ in 0..HALVINGS {
            let guess = &mut at.regions[region];
            let count = guess.mesh.len() - 1;
            if change <= tolerance || 2 * count > MOST_INTERVALS {
                break;
            }
            guess.mesh = halved(&guess.mesh);
            guess.states = (0..known.states()).map(|state| known.eval_state(state, &guess.mesh)).collect();
            let finer = on_mesh(problem, solution, &at, region, &mut stats)?;
            change = largest_change(&values, &finer);
            values = finer;
        }
        let count = problem.conserved(region) + usize::from(orbit == Orbit::Autonomous);
        let ones = (0..count).map_while(|_| take_trivial(&mut values)).collect();
        Ok(Self { values, ones, orbit, change, stats })
    }

    /// Those that decide on stability: all, but for the trivial one of an autonomous problem and those that are 1
    /// whatever the solution; by decreasing modulus.
    pub fn values(&self) -> &[Multiplier] {
        &self.values
    }

    /// That nearest to 1, where the problem is autonomous; after those that are 1 whatever the solution.
    pub fn trivial(&self) -> Option<Multiplier> {
        self.ones.last().copied().filter(|_| self.orbit == Orbit::Autonomous)
    }

    /// The largest modulus of those that decide; 0 if there are none.
    pub fn largest(&self) -> f64 {
        self.values.first().map_or(0.0, |value| value.modulus())
    }

    /// Whether deviations die out.
    pub fn is_stable(&self) -> bool {
        self.largest() < 1.0
    }

    /// The product of `(1 + μ)/(1 + |μ|)`: changes its sign where the period doubles. NaN, which is no zero, where
    /// rounding leaves no digit of a multiplier, or that which is to be 1 is not.
    pub fn doubling(&self) -> f64 {
        if !self.are_known() {
            return f64::NAN;
        }
        self.values.iter().map(|value| value.plus_one()).fold(ONE, Multiplier::times).re
    }

    /// The product of `(1 - μ ν)/(1 + |μ ν|)` over all pairs; 1 if there is none. It changes its sign where a pair of
    /// complex ones crosses the unit circle, and also where a real one passes the reciprocal of another. NaN as
    /// [`doubling`](Self::doubling) is.
    pub fn torus(&self) -> f64 {
        if !self.are_known() {
            return f64::NAN;
        }
        let pairs = self.values.iter().enumerate().flat_map(|(i, a)| self.values[i + 1..].iter().map(move |b| (a, b)));
        let factors = pairs.map(|(a, b)| {
            let Multiplier { re, im } = a.times(*b);
            Multiplier { re: -re, im: -im }.plus_one()
        });
        factors.fold(ONE, Multiplier::times).re
    }

    /// Whether signs of what is made of them mean anything: one of size m is known to m ε relative to itself.
    fn are_known(&self) -> bool {
        let near = |trivial: Multiplier| trivial.distance(ONE) <= ASTRAY;
        self.ones.iter().copied().all(near) && self.largest() * f64::EPSILON <= BLURRED
    }

    /// What the last halving of the mesh has changed them by.
    pub fn change(&self) -> f64 {
        self.change
    }

    /// What finding them has cost.
    pub fn stats(&self) -> &Stats {
        &self.stats
    }
}

/// What one boundary equation depends on, as its derivatives say.
#[derive(Debug, Clone, Copy, Default)]
struct Tie {
    /// On the left and on the right end of the region in question.
    ends: [bool; 2],
    /// On an end of another region.
    other: Option<usize>,
}

/// # Errors
/// The orbit goes on in another region.
fn is_whole<P: Problem + ?Sized>(problem: &P, solution: &Solution, region: usize) -> Result<(), SolveError> {
    let (layout, regions) = (problem.layout(), solution.regions());
    let value = |at: Option<&f64>| at.copied().unwrap_or(f64::NAN);
    let ends: Vec<f64> = regions
        .iter()
        .flat_map(|region| {
            let states = || (0..region.states()).map(|index| region.state(index));
            states().map(move |y| value(y.first())).chain(states().map(move |y| value(y.last())))
        })
        .collect();
    let integrals: Vec<f64> = regions.iter().flat_map(|region| region.integrals().iter().copied()).collect();
    let (mut g, mut dz) = (vec![0.0; layout.equations.len()], vec![0.0; layout.boundary_pattern.len()]);
    problem.boundary_jacobian(&ends, &integrals, solution.constants(), &mut g, &mut dz);
    // Region of each end, and whether it is the right one.
    let places = layout.regions.iter().enumerate().flat_map(|(index, region)| {
        [0, 1].into_iter().flat_map(move |side| std::iter::repeat_n((index, side), region.states.len()))
    });
    let places: Vec<(usize, usize)> = places.collect();
    let mut ties = vec![Tie::default(); layout.equations.len()];
    for (&(equation, input), derivative) in layout.boundary_pattern.iter().zip(&dz) {
        match (ties.get_mut(equation), places.get(input)) {
            (Some(tie), Some(&(of, side))) if *derivative != 0.0 && of == region => tie.ends[side] = true,
            (Some(tie), Some(&(of, _))) if *derivative != 0.0 => tie.other = Some(of),
            _ => {}
        }
    }
    let closing = ties.iter().filter(|tie| tie.ends == [true; 2] && tie.other.is_none()).count();
    let shared = ties.iter().zip(&layout.equations).find_map(|(tie, equation)| {
        let other = tie.other.filter(|_| tie.ends.contains(&true))?;
        Some((equation, other))
    });
    match shared {
        Some((equation, other)) if closing + problem.conserved(region) < layout.regions[region].states.len() => {
            Err(SolveError::PartOfOrbit {
                region: layout.regions[region].name.clone(),
                equation: equation.clone(),
                other: layout.regions[other].name.clone(),
            })
        }
        _ => Ok(()),
    }
}

const ONE: Multiplier = Multiplier { re: 1.0, im: 0.0 };

/// On the mesh of `at`.
fn on_mesh<P: Problem + ?Sized>(
    problem: &P,
    solution: &Solution,
    at: &Guess,
    region: usize,
    stats: &mut Stats,
) -> Result<Vec<Multiplier>, SolveError> {
    let found = Linearisation::perhaps_singular_at(problem, at, solution.unknowns(), solution.order())?;
    *stats += *found.stats();
    let n = found.system.plan.regions[region].n;
    let end = found.factorisation.regions[region].top.end();
    let complex = |values: &[f64]| DMatrix::from_iterator(n, n, values[..n * n].iter().map(|v| Complex::new(*v, 0.0)));
    let overflow = || SolveError::Newton { error: NewtonError::Overflow, intervals: at.intervals() };
    eigenvalues(&complex(end.a), &complex(end.b)).ok_or_else(overflow)
}

/// The μ for which `P + μ Q` is singular, by decreasing modulus: see [`Multipliers`]. None where P or Q is not finite.
fn eigenvalues(p: &DMatrix<Complex<f64>>, q: &DMatrix<Complex<f64>>) -> Option<Vec<Multiplier>> {
    let transformed = |angle: &f64| {
        let (sine, cosine) = libm::sincos(*angle);
        let centre = Complex::new(cosine, sine);
        let matrix = (p - q * centre).lu().solve(&(p + q * centre))?;
        matrix.iter().all(|x| x.re.is_finite() && x.im.is_finite()).then_some((centre, matrix))
    };
    let candidates = CENTRES.iter().filter_map(transformed);
    let best = candidates.min_by(|(_, a), (_, b)| a.norm_squared().total_cmp(&b.norm_squared()));
    let (centre, matrix) = best?;
    let (_, triangle) = Schur::try_new(matrix, f64::EPSILON, SWEEPS)?.unpack();
    let one = Complex::new(1.0, 0.0);
    let mut values: Vec<Multiplier> =
        triangle.diagonal().iter().map(|k| real(centre * (one + k) / (one - k))).collect();
    pair(&mut values);
    values.sort_by(|a, b| b.modulus().total_cmp(&a.modulus()).then(b.im.total_cmp(&a.im)));
    Some(values)
}

/// Those of a real problem that are not real come in conjugate pairs: here to the last digit. What has nothing near its
/// conjugate is real, whatever rounding has added: the more it has, the larger the others are.
fn pair(values: &mut [Multiplier]) {
    let mut paired = vec![false; values.len()];
    for i in 0..values.len() {
        if paired[i] || values[i].im == 0.0 {
            continue;
        }
        let conjugate = values[i].conjugate();
        let others = (i + 1..values.len()).filter(|j| !paired[*j]).map(|j| (j, values[j].distance(conjugate)));
        let nearest = others.min_by(|(_, a), (_, b)| a.total_cmp(b));
        match nearest.filter(|(_, distance)| *distance < 2.0 * values[i].im.abs()) {
            Some((j, _)) => {
                let Multiplier { re, im } = values[j].conjugate();
                let mean = Multiplier { re: 0.5 * (values[i].re + re), im: 0.5 * (values[i].im + im) };
                (values[i], values[j]) = (mean, mean.conjugate());
                paired[j] = true;
            }
            None => values[i].im = 0.0,
        }
    }
}

/// Takes out that nearest to 1, which is real; so is then what rounding has made its conjugate, where both are 1.
fn take_trivial(values: &mut Vec<Multiplier>) -> Option<Multiplier> {
    let distances = values.iter().map(|value| value.distance(ONE)).enumerate();
    let (nearest, _) = distances.min_by(|(_, a), (_, b)| a.total_cmp(b))?;
    let trivial = values.remove(nearest);
    if let Some(partner) = values.iter_mut().find(|value| trivial.im != 0.0 && **value == trivial.conjugate()) {
        partner.im = 0.0;
    }
    Some(Multiplier { im: 0.0, ..trivial })
}

/// Without an imaginary part that is rounding. What is divided by zero is infinite.
fn real(value: Complex<f64>) -> Multiplier {
    let Complex { re, im } = value;
    if !(re.is_finite() && im.is_finite()) {
        return Multiplier { re: f64::INFINITY, im: 0.0 };
    }
    Multiplier { re, im: if im.abs() <= REAL * libm::hypot(re, im).max(1.0) { 0.0 } else { im } }
}

/// The largest distance of those found last from the nearest found before, relative to their moduli or to 1.
fn largest_change(before: &[Multiplier], now: &[Multiplier]) -> f64 {
    let mut left = before.to_vec();
    now.iter().fold(0.0, |largest: f64, value| {
        let distances = left.iter().map(|other| value.distance(*other)).enumerate();
        let Some((index, distance)) = distances.min_by(|(_, a), (_, b)| a.total_cmp(b)) else { return f64::INFINITY };
        left.swap_remove(index);
        largest.max(distance / value.modulus().max(1.0))
    })
}
