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

use generated::{Job, Simd, sines_and_cosines};

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
    pub second: Vec<f64>,
    pub third: Vec<f64>,
    /// Nodes and jumps of the slope at both ends; the slope is continuous between.
    pub ends: Vec<(usize, f64)>,
}

impl Jumps {
    pub fn of(track: &Track) -> Self {
        let padded = track.u.len().next_multiple_of(LANES);
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
        Self { second, third, ends: first.into_iter().chain(last).collect() }
    }

    /// ∫ (da/du) exp(−iωu) du, from the phases at the nodes.
    fn integral(&self, omega: f64, cos: &[f64], sin: &[f64]) -> Complex {
        let [(c2, s2), (c3, s3)] = Simd::run(Sums { phases: (cos, sin), of: [&self.second, &self.third] });
        let (mut re, mut im) = (0.0, 0.0);
        for &(node, jump) in &self.ends {
            (re, im) = (re + jump * cos[node], im + jump * sin[node]);
        }
        // J_1/(iω) + J_2/(iω)² + J_3/(iω)³
        let (square, cube) = (omega * omega, omega * omega * omega);
        (im / omega - c2 / square - s3 / cube, -re / omega - s2 / square + c3 / cube)
    }
}

/// Values, and zeros up to whole lanes.
pub(super) fn padded(mut values: Vec<f64>) -> Vec<f64> {
    values.resize(values.len().next_multiple_of(LANES), 0.0);
    values
}

/// cos and −sin of 2π n u, n u taken to a whole number's distance first.
fn turned(n: usize, u: &[f64]) -> [Vec<f64>; 2] {
    let mut angles = vec![0.0; u.len()];
    Simd::run(Angles { n: n as f64, u, out: &mut angles });
    let [sines, cosines] = sines_and_cosines(&angles);
    [cosines, sines]
}

/// −2π n u.
struct Angles<'a> {
    n: f64,
    u: &'a [f64],
    out: &'a mut [f64],
}

impl Job for Angles<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        for (angle, u) in self.out.iter_mut().zip(self.u) {
            let turns = self.n * u;
            *angle = -TAU * (turns - turns.round_ties_even());
        }
    }
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
        let [step_cos, step_sin] = turned(1, u);
        let [cos, sin] = if n == 1 { [step_cos.clone(), step_sin.clone()] } else { turned(n, u) };
        Self { cos, sin, step_cos, step_sin, n }
    }

    /// cos and −sin of 2π n u at the present harmonic.
    pub fn here(&self) -> (&[f64], &[f64]) {
        (&self.cos, &self.sin)
    }

    /// On to the next harmonic.
    pub fn advance(&mut self, u: &[f64]) {
        self.n += 1;
        if self.n.is_multiple_of(BLOCK) {
            [self.cos, self.sin] = turned(self.n, u);
            return;
        }
        Simd::run(Turn { phases: (&mut self.cos, &mut self.sin), by: (&self.step_cos, &self.step_sin) });
    }
}

/// Phases turned on by one harmonic.
struct Turn<'a> {
    phases: (&'a mut [f64], &'a mut [f64]),
    by: (&'a [f64], &'a [f64]),
}

impl Job for Turn<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let phases = self.phases.0.iter_mut().zip(self.phases.1);
        for ((cos, sin), (c, s)) in phases.zip(self.by.0.iter().zip(self.by.1)) {
            (*cos, *sin) = (*cos * c - *sin * s, *cos * s + *sin * c);
        }
    }
}

/// Σ x cos and Σ x sin of what is given at as many places as there are phases, for each of `K` such x.
struct Sums<'a, const K: usize> {
    phases: (&'a [f64], &'a [f64]),
    of: [&'a [f64]; K],
}

impl<const K: usize> Job for Sums<'_, K> {
    type Output = [Complex; K];

    #[inline(always)]
    fn run(self) -> [Complex; K] {
        let mut sums = [[[0.0; LANES]; 2]; K];
        let phases = self.phases.0.as_chunks::<LANES>().0.iter().zip(self.phases.1.as_chunks::<LANES>().0);
        let of = self.of.map(|of| &of.as_chunks::<LANES>().0[..phases.len()]);
        for (place, (cos, sin)) in phases.enumerate() {
            for (sums, of) in sums.iter_mut().zip(of) {
                for lane in 0..LANES {
                    sums[0][lane] += cos[lane] * of[place][lane];
                    sums[1][lane] += sin[lane] * of[place][lane];
                }
            }
        }
        sums.map(|[re, im]| (re.iter().sum(), im.iter().sum()))
    }
}

/// How far a harmonic is integrated by Gauss quadrature over all tracks.
pub(super) fn gauss_harmonics<'a>(tracks: impl IntoIterator<Item = &'a Track>) -> usize {
    let longest = tracks.into_iter().map(Track::longest).fold(0.0, f64::max);
    ((GAUSS_PHASE / (TAU * longest)) as usize).clamp(1, FIRST)
}

/// Tracks of several fields on the same nodes of a region: phases are those of all of them.
#[derive(Debug)]
struct Group<T> {
    region: usize,
    /// Where phases are needed.
    u: Vec<f64>,
    phases: Phases,
    /// Which field, and what is summed of it.
    fields: Vec<(usize, T)>,
}

impl<T> Group<T> {
    /// Puts `sum` of each field that is still wanted into its place among `parts`, field by field and region by region,
    /// and goes on to the next harmonic.
    fn next(&mut self, wanted: &[bool], parts: &mut [Vec<Complex>], sum: impl Fn(&T, (&[f64], &[f64])) -> Complex) {
        let mut any = false;
        for (field, of) in self.fields.iter().filter(|(field, _)| wanted[*field]) {
            parts[*field][self.region] = sum(of, self.phases.here());
            any = true;
        }
        if any {
            self.phases.advance(&self.u);
        }
    }
}

/// Fields and tracks by what nodes they share: region, nodes, and the fields that have a track there.
fn shared<'a>(fields: &[&'a [Track]]) -> Vec<(usize, Vec<(usize, &'a Track)>)> {
    let mut groups: Vec<(usize, Vec<(usize, &Track)>)> = Vec::new();
    for (field, tracks) in fields.iter().enumerate() {
        for (region, track) in tracks.iter().enumerate().filter(|(_, track)| !track.u.is_empty()) {
            let same = |(other, tracks): &&mut (usize, Vec<(usize, &Track)>)| {
                *other == region && tracks.iter().all(|(_, other)| other.u == track.u)
            };
            match groups.iter_mut().find(same) {
                Some((_, tracks)) => tracks.push((field, track)),
                None => groups.push((region, vec![(field, track)])),
            }
        }
    }
    groups
}

/// The integrals of several fields, region by region, harmonic after harmonic.
#[derive(Debug)]
pub(super) struct Integrals {
    /// What the first few harmonics are made of: slopes at Gauss points, times weights.
    slopes: Vec<Group<Vec<f64>>>,
    /// What further ones are made of.
    jumps: Vec<Group<Jumps>>,
    /// The last of the first few.
    few: usize,
    n: usize,
}

impl Integrals {
    /// Those of the first few harmonics by quadrature, and all further ones from the jumps.
    pub fn new(fields: &[&[Track]]) -> Self {
        let few = gauss_harmonics(fields.iter().copied().flatten());
        let groups = shared(fields);
        let slopes = groups.iter().map(|(region, tracks)| {
            let u = tracks.first().map(|(_, track)| gauss_places(track)).unwrap_or_default();
            let fields = tracks.iter().map(|(field, track)| (*field, weighted_slopes(track))).collect();
            Group { region: *region, phases: Phases::new(&u, 1), u, fields }
        });
        let jumps = groups.iter().map(|(region, tracks)| {
            let u = tracks.first().map(|(_, track)| padded(track.u.clone())).unwrap_or_default();
            let fields = tracks.iter().map(|(field, track)| (*field, Jumps::of(track))).collect();
            Group { region: *region, phases: Phases::new(&u, few + 1), u, fields }
        });
        Self { slopes: slopes.collect(), jumps: jumps.collect(), few, n: 1 }
    }

    /// Those of the next harmonic, into `parts`, field by field and region by region, for the fields that are still
    /// `wanted`: none that was not wanted once may be wanted again.
    pub fn next(&mut self, wanted: &[bool], parts: &mut [Vec<Complex>]) {
        if self.n <= self.few {
            let sum = |slopes: &Vec<f64>, phases: (&[f64], &[f64])| {
                let [sum] = Simd::run(Sums { phases, of: [slopes] });
                sum
            };
            self.slopes.iter_mut().for_each(|group| group.next(wanted, parts, sum));
        } else {
            let omega = TAU * self.n as f64;
            let sum = |jumps: &Jumps, (cos, sin): (&[f64], &[f64])| jumps.integral(omega, cos, sin);
            self.jumps.iter_mut().for_each(|group| group.next(wanted, parts, sum));
        }
        self.n += 1;
    }
}

/// The Gauss points of all intervals, padded.
pub(super) fn gauss_places(track: &Track) -> Vec<f64> {
    padded(track.cubics().flat_map(|cubic| GAUSS.map(|(t, _)| cubic.u + t * cubic.h)).collect())
}

/// Slopes at the Gauss points of all intervals, times weights and lengths, padded.
fn weighted_slopes(track: &Track) -> Vec<f64> {
    let slopes = track.cubics().flat_map(|cubic| GAUSS.map(|(t, weight)| weight * cubic.h * cubic.slope_at(t)));
    padded(slopes.collect())
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

/// A field to be summed over its harmonics.
#[derive(Clone, Copy)]
pub(super) struct Summand<'a> {
    /// The field, region by region around the loop.
    pub tracks: &'a [Track],
    /// What multiplies |B_n|²/n.
    pub weight: &'a dyn Fn(usize) -> f64,
    /// What may be missing where the sum ends, absolute.
    pub tolerance: f64,
    /// What may be missing after [`MAX_HARMONICS`].
    pub most: f64,
}

/// A sum as far as it has come.
struct Running {
    sum: Series,
    octave: f64,
    last_octave: f64,
    /// Where the present octave ends.
    end: usize,
}

impl Running {
    fn new(regions: usize) -> Self {
        let sum = Series {
            total: 0.0,
            regions: vec![0.0; regions],
            harmonics: 0,
            rest: f64::INFINITY,
            integrals: Vec::with_capacity(8 * FIRST),
        };
        Self { sum, octave: 0.0, last_octave: 0.0, end: FIRST / 4 }
    }

    /// Adds the next harmonic, `n`; whether what is missing is small enough now.
    fn add(&mut self, n: usize, parts: &[Complex], of: &Summand<'_>) -> bool {
        let Self { sum, octave, last_octave, end } = self;
        let whole = parts.iter().fold((0.0, 0.0), |sum, part| (sum.0 + part.0, sum.1 + part.1));
        let weight = (of.weight)(n) / n as f64;
        for (region, part) in sum.regions.iter_mut().zip(parts) {
            *region += weight * (whole.0 * part.0 + whole.1 * part.1);
        }
        let term = weight * (whole.0 * whole.0 + whole.1 * whole.1);
        sum.total += term;
        *octave += term;
        sum.integrals.push(whole);
        if n < *end {
            return false;
        }
        // The octaves of a sum whose terms fall as a power of n fall geometrically.
        let ratio = if *octave > 0.0 { *octave / *last_octave } else { 0.0 };
        sum.rest = if ratio < SLOWEST { *octave * ratio / (1.0 - ratio) } else { f64::INFINITY };
        sum.harmonics = n;
        (*last_octave, *octave, *end) = (*octave, 0.0, 2 * *end);
        n >= FIRST && sum.rest <= of.tolerance
    }
}

/// Σ_n weight(n) |B_n|²/n for a field that is given region by region around the loop, until what is missing is below
/// `tolerance`, absolute. `None` if it does not end within [`MAX_HARMONICS`], as that of a field with jumps does not.
pub fn series(tracks: &[Track], weight: impl Fn(usize) -> f64, tolerance: f64) -> Option<Series> {
    side_by_side(&[Summand { tracks, weight: &weight, tolerance, most: tolerance }]).pop().flatten()
}

/// [`series`] of several fields, so that those on the same nodes share what they can.
pub(super) fn side_by_side(fields: &[Summand<'_>]) -> Vec<Option<Series>> {
    let tracks: Vec<&[Track]> = fields.iter().map(|field| field.tracks).collect();
    let mut integrals = Integrals::new(&tracks);
    let mut parts: Vec<Vec<Complex>> = tracks.iter().map(|tracks| vec![(0.0, 0.0); tracks.len()]).collect();
    let mut sums: Vec<Running> = tracks.iter().map(|tracks| Running::new(tracks.len())).collect();
    let mut wanted = vec![true; fields.len()];
    for n in 1..=MAX_HARMONICS {
        if !wanted.contains(&true) {
            break;
        }
        integrals.next(&wanted, &mut parts);
        let each = sums.iter_mut().zip(&parts).zip(fields).zip(&mut wanted);
        for (((sum, parts), field), wanted) in each.filter(|(_, wanted)| **wanted) {
            *wanted = !sum.add(n, parts, field);
        }
    }
    let ended = sums.into_iter().map(|running| running.sum).zip(fields);
    ended.map(|(sum, field)| (sum.rest <= field.most.max(field.tolerance)).then_some(sum)).collect()
}
