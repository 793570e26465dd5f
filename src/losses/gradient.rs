//! Derivatives of a sum over harmonics by what it is made of: coordinates, values and slopes at all nodes, and its
//! weights.

use std::f64::consts::TAU;

use super::series::{Complex, Cubic, GAUSS, Jumps, Phases, Series, Track, gauss_harmonics, gauss_places, padded};

/// Derivatives of a sum by a track's coordinates, values and slopes, node by node.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TrackGradient {
    /// By u.
    pub u: Vec<f64>,
    /// By the values.
    pub value: Vec<f64>,
    /// By the slopes da/du.
    pub slope: Vec<f64>,
}

/// By what makes an interval: length, mean slope, slopes at both ends.
#[derive(Debug, Clone, Copy, Default)]
struct CubicGradient {
    h: f64,
    mean: f64,
    slope: [f64; 2],
}

impl Series {
    /// Derivatives of the sum by the tracks that it was made of, with the same weights.
    pub fn gradient(&self, tracks: &[Track], weight: impl Fn(usize) -> f64) -> Vec<TrackGradient> {
        // dP = Σ_n Re(conj(c_n) dB_n)
        let adjoint = |(n, &(re, im)): (usize, &Complex)| {
            let factor = 2.0 * weight(n) / n as f64;
            (factor * re, -factor * im)
        };
        let numbered = (1..).zip(&self.integrals);
        let adjoints: Vec<Complex> = numbered.map(adjoint).collect();
        let few = gauss_harmonics(tracks).min(adjoints.len());
        let (first, further) = adjoints.split_at(few);
        let of = |track: &Track| {
            let mut gradient = TrackGradient {
                u: vec![0.0; track.u.len()],
                value: vec![0.0; track.u.len()],
                slope: vec![0.0; track.u.len()],
            };
            by_quadrature(track, first, &mut gradient);
            by_jumps(track, few + 1, further, &mut gradient);
            gradient
        };
        tracks.iter().map(of).collect()
    }

    /// Derivative of the sum when the weight of each harmonic changes at a rate.
    pub fn by_weight(&self, rate: impl Fn(usize) -> f64) -> f64 {
        let term = |(n, (re, im)): (usize, &Complex)| rate(n) / n as f64 * (re * re + im * im);
        (1..).zip(&self.integrals).map(term).sum()
    }
}

/// Adds what an interval's gradient means for its two nodes.
fn spread(cubic: &Cubic, by: CubicGradient, j: usize, gradient: &mut TrackGradient) {
    let mean = by.mean / cubic.h;
    let length = by.h - mean * cubic.mean;
    gradient.value[j] -= mean;
    gradient.value[j + 1] += mean;
    gradient.u[j] -= length;
    gradient.u[j + 1] += length;
    gradient.slope[j] += by.slope[0];
    gradient.slope[j + 1] += by.slope[1];
}

/// The harmonics that are integrated by quadrature.
fn by_quadrature(track: &Track, adjoints: &[Complex], gradient: &mut TrackGradient) {
    let places = gauss_places(track);
    let mut phases = Phases::new(&places, 1);
    // Σ of p and of ωq at each place, p + iq being conj(c_n) exp(−iωu).
    let mut sums = vec![(0.0, 0.0); places.len()];
    for (n, adjoint) in (1..).zip(adjoints) {
        let omega = TAU * n as f64;
        let (cos, sin) = phases.here();
        for (((value, place), c), s) in sums.iter_mut().zip(cos).zip(sin) {
            let (p, q) = (adjoint.0 * c - adjoint.1 * s, adjoint.0 * s + adjoint.1 * c);
            *value += p;
            *place += omega * q;
        }
        phases.advance(&places);
    }
    for ((j, cubic), sums) in track.cubics().enumerate().zip(sums.chunks_exact(GAUSS.len())) {
        let mut by = CubicGradient::default();
        for ((t, weight), (value, place)) in GAUSS.into_iter().zip(sums) {
            let slope = weight * cubic.slope_at(t);
            let place = place * slope * cubic.h;
            let [m, a, b] = Cubic::basis(t);
            let scaled = weight * cubic.h * value;
            by.h += slope * value + t * place;
            by.mean += m * scaled;
            by.slope[0] += a * scaled;
            by.slope[1] += b * scaled;
            gradient.u[j] += place;
        }
        spread(&cubic, by, j, gradient);
    }
}

/// The harmonics from `first` on, which are integrated by parts.
fn by_jumps(track: &Track, first: usize, adjoints: &[Complex], gradient: &mut TrackGradient) {
    let (jumps, places) = (Jumps::of(track), padded(track.u.clone()));
    let mut phases = Phases::new(&places, first);
    // Σ of p, q/ω, p/ω², q/ω³ at each node, p + iq being conj(c_n) exp(−iωu).
    let mut sums = vec![[0.0; 4]; places.len()];
    for (n, adjoint) in (first..).zip(adjoints) {
        let over = 1.0 / (TAU * n as f64);
        let (square, cube) = (over * over, over * over * over);
        let (cos, sin) = phases.here();
        for ((sums, c), s) in sums.iter_mut().zip(cos).zip(sin) {
            let (p, q) = (adjoint.0 * c - adjoint.1 * s, adjoint.0 * s + adjoint.1 * c);
            sums[0] += p;
            sums[1] += q * over;
            sums[2] += p * square;
            sums[3] += q * cube;
        }
        phases.advance(&places);
    }
    for (j, cubic) in track.cubics().enumerate() {
        let (here, next) = (sums[j], sums[j + 1]);
        // By the second derivatives at both ends and the third, which jump by them here and by less them at the next
        // node.
        let (left, right, bend) = (-here[2], next[2], next[3] - here[3]);
        let (h, slope) = (cubic.h, 6.0 * bend / (cubic.h * cubic.h));
        let (at_left, at_right, third) = cubic.bends();
        let by = CubicGradient {
            h: -(at_left * left + at_right * right + 2.0 * third * bend) / h,
            mean: 6.0 * (left - right) / h - 2.0 * slope,
            slope: [(2.0 * right - 4.0 * left) / h + slope, (4.0 * right - 2.0 * left) / h + slope],
        };
        spread(&cubic, by, j, gradient);
    }
    let nodes = sums.iter().zip(&jumps.second).zip(&jumps.third);
    for (by, ((sums, second), third)) in gradient.u.iter_mut().zip(nodes) {
        *by += sums[2] * third - sums[1] * second;
    }
    for (&(j, jump), sign) in jumps.ends.iter().zip([1.0, -1.0]) {
        gradient.slope[j] += sign * sums[j][1];
        gradient.u[j] -= jump * sums[j][0];
    }
}
