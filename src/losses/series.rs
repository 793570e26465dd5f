//! Sums over the harmonics of a field that runs around with the belt.
//!
//! A field a is periodic in u = S/L_0, the unstretched coordinate over the loop's unstretched length. On each interval
//! of the solution's own meshes it is the cubic that has the field's values and slopes at both nodes: the interpolant
//! of the solution itself, of the solution's order. What is summed is
//!
//! ```text
//! P = Σ_n w_n |B_n|²/n,      B_n = ∮ (da/du) exp(−2πi n u) du
//! ```
//!
//! B_n is integrated exactly: by parts three times, until the cubics' derivatives are used up, which leaves what they
//! jump by at the nodes. Where an interval is short against the wave length that loses digits, and Gauss quadrature is
//! exact to rounding: the first few harmonics are integrated so. The share of a region is Re(B̄_n B_n^r), its own part
//! of B_n put in: that is the power of the stress that leads the strain by a quarter of a cycle over the rate of strain
//! in this region (`docs/losses.md`).

use std::f64::consts::TAU;

/// Harmonics at most: a field whose sum has not ended there has jumps, and its sum diverges.
pub const MAX_HARMONICS: usize = 1 << 14;
/// Harmonics before the end of the sum is looked for.
const FIRST: usize = 32;
/// An octave over the one before it, above which the rest of a sum is not estimated.
const SLOWEST: f64 = 0.9;
/// Phase, rad, over the longest interval, up to which Gauss quadrature with [`GAUSS`] is exact to 1e-10.
const GAUSS_PHASE: f64 = 1.0;
/// Harmonics between which phases are multiplied up before they are computed anew.
const BLOCK: usize = 64;
/// Gauss points and weights on [0, 1].
pub(super) const GAUSS: [(f64, f64); 4] = [
    (0.069_431_844_202_973_71, 0.173_927_422_568_726_93),
    (0.330_009_478_207_571_87, 0.326_072_577_431_273_07),
    (0.669_990_521_792_428_1, 0.326_072_577_431_273_07),
    (0.930_568_155_797_026_3, 0.173_927_422_568_726_93),
];
const LANES: usize = 8;

/// A complex number: real and imaginary part.
pub(super) type Complex = (f64, f64);

/// A field on one region: u, values, and slopes da/du at the nodes; none where the field vanishes throughout.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Track {
    /// Unstretched coordinate over the loop's length, increasing.
    pub u: Vec<f64>,
    /// Values.
    pub value: Vec<f64>,
    /// Slopes.
    pub slope: Vec<f64>,
}

/// One interval of a track.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cubic {
    pub u: f64,
    pub h: f64,
    /// Mean slope.
    pub mean: f64,
    /// Slopes at both ends.
    pub slope: [f64; 2],
}

impl Cubic {
    /// Second derivatives at both ends, and the third.
    pub fn bends(&self) -> (f64, f64, f64) {
        let (h, mean, [s0, s1]) = (self.h, self.mean, self.slope);
        (
            (6.0 * mean - 4.0 * s0 - 2.0 * s1) / h,
            (-6.0 * mean + 2.0 * s0 + 4.0 * s1) / h,
            (6.0 * (s0 + s1) - 12.0 * mean) / (h * h),
        )
    }

    /// What multiplies mean slope and both ends' in the slope at `t` in `[0, 1]`.
    pub fn basis(t: f64) -> [f64; 3] {
        [6.0 * t - 6.0 * t * t, 1.0 - 4.0 * t + 3.0 * t * t, 3.0 * t * t - 2.0 * t]
    }

    /// The slope at `t` in `[0, 1]`.
    pub fn slope_at(&self, t: f64) -> f64 {
        let [m, a, b] = Self::basis(t);
        m * self.mean + a * self.slope[0] + b * self.slope[1]
    }
}

impl Track {
    /// The intervals.
    pub(super) fn cubics(&self) -> impl Iterator<Item = Cubic> + '_ {
        let ends = self.u.windows(2).zip(self.value.windows(2)).zip(self.slope.windows(2));
        ends.map(|((u, a), s)| {
            let h = u[1] - u[0];
            Cubic { u: u[0], h, mean: (a[1] - a[0]) / h, slope: [s[0], s[1]] }
        })
    }

    /// Length of the longest interval.
    fn longest(&self) -> f64 {
        self.u.windows(2).map(|u| u[1] - u[0]).fold(0.0, f64::max)
    }
}

/// What a track's derivatives jump by at its nodes, to the right less to the left, and nothing outside of it; padded to
/// whole lanes.
#[derive(Debug, Clone)]
pub(super) struct Jumps {
    pub u: Vec<f64>,
    pub second: Vec<f64>,
    pub third: Vec<f64>,
    /// Nodes and jumps of the slope at both ends; the slope is continuous between.
    pub ends: Vec<(usize, f64)>,
}

impl Jumps {
    pub fn of(track: &Track) -> Self {
        let padded = track.u.len().next_multiple_of(LANES);
        let mut u = track.u.clone();
        u.resize(padded, 0.0);
        let (mut second, mut third) = (vec![0.0; padded], vec![0.0; padded]);
        for (j, cubic) in track.cubics().enumerate() {
            let (left, right, bend) = cubic.bends();
            second[j] += left;
            second[j + 1] -= right;
            third[j] += bend;
            third[j + 1] -= bend;
        }
        let first = track.slope.first().map(|slope| (0, *slope));
        let last = track.slope.last().map(|slope| (track.slope.len() - 1, -slope));
        Self { u, second, third, ends: first.into_iter().chain(last).collect() }
    }
}

/// exp(−2πi n u), n u taken to a whole number's distance first.
pub(super) fn phase(n: usize, u: f64) -> Complex {
    let turns = n as f64 * u;
    let (sin, cos) = libm::sincos(TAU * (turns - turns.round()));
    (cos, -sin)
}

/// Phases of a region's nodes, harmonic after harmonic.
#[derive(Debug)]
pub(super) struct Phases {
    cos: Vec<f64>,
    sin: Vec<f64>,
    step_cos: Vec<f64>,
    step_sin: Vec<f64>,
    /// The harmonic at which they stand.
    n: usize,
}

impl Phases {
    /// At the first harmonic that will be asked for.
    pub fn new(u: &[f64], n: usize) -> Self {
        let steps = u.iter().map(|u| phase(1, *u));
        let (step_cos, step_sin): (Vec<f64>, Vec<f64>) = steps.unzip();
        let mut phases = Self { cos: step_cos.clone(), sin: step_sin.clone(), step_cos, step_sin, n };
        if n != 1 {
            phases.restart(u);
        }
        phases
    }

    fn restart(&mut self, u: &[f64]) {
        for ((u, cos), sin) in u.iter().zip(&mut self.cos).zip(&mut self.sin) {
            (*cos, *sin) = phase(self.n, *u);
        }
    }

    /// cos and −sin of 2π n u at the present harmonic.
    pub fn here(&self) -> (&[f64], &[f64]) {
        (&self.cos, &self.sin)
    }

    /// On to the next harmonic.
    pub fn advance(&mut self, u: &[f64]) {
        self.n += 1;
        if self.n.is_multiple_of(BLOCK) {
            return self.restart(u);
        }
        let steps = self.step_cos.iter().zip(&self.step_sin);
        for ((cos, sin), (c, s)) in self.cos.iter_mut().zip(&mut self.sin).zip(steps) {
            (*cos, *sin) = (*cos * c - *sin * s, *cos * s + *sin * c);
        }
    }
}

/// Σ x cos and Σ x sin for both jumps.
fn sums(cos: &[f64], sin: &[f64], second: &[f64], third: &[f64]) -> [f64; 4] {
    let mut sums = [[0.0; LANES]; 4];
    let lanes = cos.as_chunks::<LANES>().0.iter().zip(sin.as_chunks::<LANES>().0);
    let jumps = second.as_chunks::<LANES>().0.iter().zip(third.as_chunks::<LANES>().0);
    for ((cos, sin), (second, third)) in lanes.zip(jumps) {
        for lane in 0..LANES {
            sums[0][lane] += cos[lane] * second[lane];
            sums[1][lane] += sin[lane] * second[lane];
            sums[2][lane] += cos[lane] * third[lane];
            sums[3][lane] += sin[lane] * third[lane];
        }
    }
    sums.map(|lanes| lanes.iter().sum())
}

/// How far a harmonic is integrated by Gauss quadrature over all tracks.
pub(super) fn gauss_harmonics(tracks: &[Track]) -> usize {
    let longest = tracks.iter().map(Track::longest).fold(0.0, f64::max);
    ((GAUSS_PHASE / (TAU * longest)) as usize).clamp(1, FIRST)
}

/// The integrals of a field, region by region, harmonic after harmonic.
#[derive(Debug)]
pub(super) struct Integrals {
    regions: Vec<(Jumps, Phases)>,
    n: usize,
}

impl Integrals {
    /// Those of the first few harmonics by quadrature, and all further ones from the jumps.
    pub fn new(tracks: &[Track]) -> (Vec<Vec<Complex>>, Self) {
        let few = gauss_harmonics(tracks);
        let mut quadratures: Vec<Quadrature> = tracks.iter().map(Quadrature::new).collect();
        let first = (1..=few).map(|_| quadratures.iter_mut().map(Quadrature::next).collect()).collect();
        let regions = tracks.iter().map(|track| {
            let jumps = Jumps::of(track);
            let phases = Phases::new(&jumps.u, few + 1);
            (jumps, phases)
        });
        (first, Self { regions: regions.collect(), n: few + 1 })
    }

    /// Of the next harmonic.
    pub fn next(&mut self) -> Vec<Complex> {
        let omega = TAU * self.n as f64;
        let region = |(jumps, phases): &mut (Jumps, Phases)| {
            let (cos, sin) = phases.here();
            let [c2, s2, c3, s3] = sums(cos, sin, &jumps.second, &jumps.third);
            let (mut re, mut im) = (0.0, 0.0);
            for &(node, jump) in &jumps.ends {
                (re, im) = (re + jump * cos[node], im + jump * sin[node]);
            }
            phases.advance(&jumps.u);
            // J_1/(iω) + J_2/(iω)² + J_3/(iω)³
            let (square, cube) = (omega * omega, omega * omega * omega);
            (im / omega - c2 / square - s3 / cube, -re / omega - s2 / square + c3 / cube)
        };
        self.n += 1;
        self.regions.iter_mut().map(region).collect()
    }
}

/// ∫ (da/du) exp(−2πi n u) du by Gauss quadrature, harmonic after harmonic.
struct Quadrature {
    u: Vec<f64>,
    /// Weights times slopes.
    slopes: Vec<f64>,
    phases: Phases,
}

impl Quadrature {
    /// Beginning with the first harmonic.
    fn new(track: &Track) -> Self {
        let points = track
            .cubics()
            .flat_map(|cubic| GAUSS.map(|(t, weight)| (cubic.u + t * cubic.h, weight * cubic.h * cubic.slope_at(t))));
        let (u, slopes): (Vec<f64>, Vec<f64>) = points.unzip();
        let phases = Phases::new(&u, 1);
        Self { u, slopes, phases }
    }

    /// Of the next harmonic.
    fn next(&mut self) -> Complex {
        let (cos, sin) = self.phases.here();
        let phases = cos.iter().zip(sin);
        let sum = self
            .slopes
            .iter()
            .zip(phases)
            .fold((0.0, 0.0), |(re, im), (slope, (cos, sin))| (re + slope * cos, im + slope * sin));
        self.phases.advance(&self.u);
        sum
    }
}

/// A sum over harmonics.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// The sum.
    pub total: f64,
    /// What each region contributes.
    pub regions: Vec<f64>,
    /// How many harmonics were summed.
    pub harmonics: usize,
    /// What is estimated to be missing.
    pub rest: f64,
    /// B_n of the whole loop.
    pub(super) integrals: Vec<Complex>,
}

impl Series {
    /// Of what loses nothing.
    pub(super) fn nothing(regions: usize) -> Self {
        Self { total: 0.0, regions: vec![0.0; regions], harmonics: 0, rest: 0.0, integrals: Vec::new() }
    }
}

/// Σ_n weight(n) |B_n|²/n for a field that is given region by region around the loop, until what is missing is below
/// `tolerance`, absolute. `None` if it does not end within [`MAX_HARMONICS`], as that of a field with jumps does not.
pub fn series(tracks: &[Track], weight: impl Fn(usize) -> f64, tolerance: f64) -> Option<Series> {
    let (first, mut further) = Integrals::new(tracks);
    let mut first = first.into_iter();
    let mut sum = Series {
        total: 0.0,
        regions: vec![0.0; tracks.len()],
        harmonics: 0,
        rest: f64::INFINITY,
        integrals: Vec::with_capacity(8 * FIRST),
    };
    let (mut octave, mut last_octave, mut end) = (0.0, 0.0, FIRST / 4);
    for n in 1..=MAX_HARMONICS {
        let parts = first.next().unwrap_or_else(|| further.next());
        let whole = parts.iter().fold((0.0, 0.0), |sum, part| (sum.0 + part.0, sum.1 + part.1));
        let weight = weight(n) / n as f64;
        for (region, part) in sum.regions.iter_mut().zip(&parts) {
            *region += weight * (whole.0 * part.0 + whole.1 * part.1);
        }
        let term = weight * (whole.0 * whole.0 + whole.1 * whole.1);
        sum.total += term;
        octave += term;
        sum.integrals.push(whole);
        if n < end {
            continue;
        }
        // The octaves of a sum whose terms fall as a power of n fall geometrically.
        let ratio = if octave > 0.0 { octave / last_octave } else { 0.0 };
        sum.rest = if ratio < SLOWEST { octave * ratio / (1.0 - ratio) } else { f64::INFINITY };
        sum.harmonics = n;
        if n >= FIRST && sum.rest <= tolerance {
            return Some(sum);
        }
        (last_octave, octave, end) = (octave, 0.0, 2 * end);
    }
    None
}
