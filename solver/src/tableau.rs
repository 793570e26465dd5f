//! Coefficients of the Runge-Kutta methods, with their provenance.
//!
//! A method of `s` stages advances `y_0` to `y_1` over a step `h` by
//!
//! ```text
//! K_r = f(t + c_r h, (1 - v_r) y_0 + v_r y_1 + h Σ_j x_rj K_j),      y_1 - y_0 = h Σ_r b_r K_r
//! ```
//!
//! The first two stages of every method here are the node values, shared by neighbouring intervals. In a mono-implicit
//! method the sum goes over the stages before (`j < r`), so that the stages are functions of the nodes: J. R. Cash and
//! A. Singhal, IMA J. Numer. Anal. 2 (1982) 167-182; the notation is that of W. H. Enright and P. H. Muir, SIAM J. Sci.
//! Comput. 17 (1996) 479-497. Where it goes over all stages, the values at the inner ones are unknowns of their
//! interval.

use crate::basis::{Basis, PARTS};
use std::sync::OnceLock;

/// Inner stages of the methods whose inner stages are coupled.
pub(crate) const COUPLED: usize = 3;
/// Places of an interval at which the right-hand side is evaluated at once, at most.
pub(crate) const MOST_PLACES: usize = 6;

/// A Runge-Kutta method whose first two stages are the nodes.
#[derive(Debug)]
pub(crate) struct Tableau {
    /// Order of the node values, of the integrals and of the dense output.
    pub order: usize,
    pub c: &'static [f64],
    pub v: &'static [f64],
    /// `x[r]` has `r` entries; if the inner stages are coupled, one for each stage.
    pub x: &'static [&'static [f64]],
    pub b: &'static [f64],
    /// How many inner stages at a time depend on none of each other, or are unknowns: their points are one batch.
    pub batches: &'static [usize],
    /// Whether the inner stages depend on each other, so that their values are unknowns.
    pub coupled: bool,
    /// Exponent of the step in the defect of the dense output.
    pub defect_order: f64,
    /// Where in the interval the defect is sampled, and the weight of each sample in its mean square.
    pub samples: &'static [(f64, f64)],
    /// How many of them tell where a mesh is rough, and say well enough where.
    pub first_samples: usize,
    /// See [`differences`](Self::differences).
    pub differences: OnceLock<Differences>,
    /// Lagrange's weights of the stages at the points where the continuous extension is corrected, where inner stages
    /// are coupled.
    pub at_points: OnceLock<[[f64; COUPLED + 2]; 4]>,
    /// See [`at_samples`](Self::at_samples).
    pub at_samples: OnceLock<[[f64; COUPLED + 2]; MOST_PLACES]>,
}

/// Weights of what the difference `D = S - S̃` of the continuous extension and of what its slopes integrate to,
/// `S̃ = y_0 + h ∫_0^σ f(S)`, is made of.
#[derive(Debug, Clone)]
pub(crate) struct Difference {
    /// Of what S is made of: as [`Basis::weights`].
    pub parts: [f64; PARTS],
    /// Of `h f(S)` at 0, 1 and the samples; 0 where there are fewer.
    pub slopes: [f64; 2 + MOST_PLACES],
}

/// Sums of differences.
#[derive(Debug)]
pub(crate) struct Differences {
    /// D at each inner stage,
    pub inside: Vec<Difference>,
    /// and at the right node.
    pub right: Difference,
    /// One for each stage, with L Lagrange's polynomial of it, c its place and b its weight: what quadrature by the
    /// samples finds of `∫_0^1 L(σ) D(σ) dσ` beyond the method's `b D(c)`.
    pub remainders: Vec<Difference>,
}

impl Difference {
    /// The weighted sum of D at several places: σ and weight.
    fn at(samples: &[(f64, f64)], places: impl Iterator<Item = (f64, f64)>) -> Self {
        let mut sum = Self { parts: [0.0; PARTS], slopes: [0.0; 2 + MOST_PLACES] };
        for (x, weight) in places {
            let add = |sum: &mut f64, part: f64| *sum += weight * part;
            sum.parts.iter_mut().zip(Basis::value(x).weights()).for_each(|(sum, part)| add(sum, part));
            sum.slopes.iter_mut().zip(partial_integrals(samples, x)).for_each(|(sum, part)| add(sum, -part));
        }
        sum
    }
}

impl Tableau {
    /// Whether states whose derivative is another state are treated as [`ODD`] says.
    pub(crate) fn has_odd_parts(&self) -> bool {
        self.order == 6 && !self.coupled
    }

    /// Whether the right-hand side may be undefined at a region's ends: see
    /// [`open_ends`](crate::collocation::open_ends).
    pub(crate) fn forgives_ends(&self) -> bool {
        self.coupled
    }

    /// Weights of the slopes at all stages of an interval in those at its nodes, where inner stages are coupled: at an
    /// open end what the polynomial through the others that have a weight says.
    pub(crate) fn slopes_at_nodes(&self, open: [bool; 2]) -> [[f64; COUPLED + 2]; 2] {
        let has_weight = |stage: usize| self.b[stage] != 0.0 && open.get(stage) != Some(&true);
        let known: Vec<usize> = (0..self.stages()).filter(|stage| has_weight(*stage)).collect();
        let places: Vec<f64> = known.iter().map(|stage| self.c[*stage]).collect();
        std::array::from_fn(|side| {
            let mut weights = [0.0; COUPLED + 2];
            if open[side] {
                let at = self.c[side];
                known.iter().enumerate().for_each(|(k, stage)| weights[*stage] = lagrange(&places, k, at));
            } else {
                weights[side] = 1.0;
            }
            weights
        })
    }

    /// The factor on the odd part that is added at a stage, if any: see [`ODD`].
    pub(crate) fn odd_part(&self, stage: usize) -> Option<f64> {
        match stage {
            2 if self.has_odd_parts() => Some(-ODD),
            3 if self.has_odd_parts() => Some(ODD),
            _ => None,
        }
    }

    /// Weights of `h² K_r` in the interval equation of such a state: see [`ODD`].
    pub(crate) fn twice_integrated(&self, stage: usize) -> f64 {
        self.b[stage] * (0.5 - self.c[stage])
    }

    /// Number of stages.
    pub(crate) fn stages(&self) -> usize {
        self.c.len()
    }

    /// Stages between the nodes whose values are unknowns.
    pub(crate) fn unknown_stages(&self) -> usize {
        if self.coupled { COUPLED } else { 0 }
    }

    /// At each of the samples, Lagrange's weights of the values at all stages: what the polynomial through these is
    /// there. 0 where there are fewer of either. Computed once.
    pub(crate) fn at_samples(&self) -> &[[f64; COUPLED + 2]; MOST_PLACES] {
        self.at_samples.get_or_init(|| {
            let mut weights = [[0.0; COUPLED + 2]; MOST_PLACES];
            for (weights, (sigma, _)) in weights.iter_mut().zip(self.samples) {
                let of_stages = weights.iter_mut().enumerate().take(self.stages());
                of_stages.for_each(|(stage, weight)| *weight = lagrange(self.c, stage, *sigma));
            }
            weights
        })
    }

    /// Computed once.
    pub(crate) fn differences(&self) -> &Differences {
        self.differences.get_or_init(|| {
            let (samples, stages) = (self.samples, 0..self.stages());
            let quadrature = |stage: usize| samples.iter().map(move |&(x, b)| (x, b * lagrange(self.c, stage, x)));
            let missed = |stage: usize| quadrature(stage).chain([(self.c[stage], -self.b[stage])]);
            Differences {
                inside: self.c[2..].iter().map(|&c| Difference::at(samples, [(c, 1.0)].into_iter())).collect(),
                right: Difference::at(samples, [(1.0, 1.0)].into_iter()),
                remainders: stages.map(|stage| Difference::at(samples, missed(stage))).collect(),
            }
        })
    }
}

/// Weights that integrate from 0 to `end` the polynomial through 0, 1 and the samples, in this order.
/// The samples are the points of a Gauss rule, which is exact for these integrals.
fn partial_integrals(samples: &[(f64, f64)], end: f64) -> Vec<f64> {
    let places = samples.iter().map(|sample| sample.0);
    let nodes: Vec<f64> = std::iter::once(0.0).chain(places).chain(std::iter::once(1.0)).collect();
    let integral = |k: usize| samples.iter().map(|(x, weight)| end * weight * lagrange(&nodes, k, end * x)).sum();
    let last = nodes.len() - 1;
    [0, last].into_iter().chain(1..last).map(integral).collect()
}

/// Lagrange's polynomial that is 1 at node `k` and 0 at the others.
pub(crate) fn lagrange(nodes: &[f64], k: usize, x: f64) -> f64 {
    let others = nodes.iter().enumerate().filter(|&(i, _)| i != k);
    others.map(|(_, node)| (x - node) / (nodes[k] - node)).product()
}

/// Three-stage Lobatto IIIA, order 4: Simpson's rule with a Hermite midpoint. A. Axelsson, BIT 4 (1964) 69;
/// as collocation with cubics: R. D. Russell and L. F. Shampine, Numer. Math. 19 (1972) 1-28.
pub(crate) static ORDER_4: Tableau = Tableau {
    order: 4,
    c: &[0.0, 1.0, 0.5],
    v: &[0.0, 1.0, 0.5],
    x: &[&[], &[0.0], &[0.125, -0.125]],
    b: &[1.0 / 6.0, 1.0 / 6.0, 2.0 / 3.0],
    batches: &[1],
    coupled: false,
    defect_order: 4.0,
    // Gauss points of order 6 on [0, 1]: 1/2, 1/2 ± sqrt(15)/10.
    samples: &[(0.112_701_665_379_258_3, 5.0 / 18.0), (0.5, 4.0 / 9.0), (0.887_298_334_620_741_7, 5.0 / 18.0)],
    first_samples: 3,
    differences: OnceLock::new(),
    at_points: OnceLock::new(),
    at_samples: OnceLock::new(),
};

/// Five stages, order 6, symmetric: Cash and Singhal (1982); in MIRKDC: Enright and Muir (1996).
pub(crate) static ORDER_6: Tableau = Tableau {
    order: 6,
    c: &[0.0, 1.0, 0.25, 0.75, 0.5],
    v: &[0.0, 1.0, 5.0 / 32.0, 27.0 / 32.0, 0.5],
    x: &[
        &[],
        &[0.0],
        &[9.0 / 64.0, -3.0 / 64.0],
        &[3.0 / 64.0, -9.0 / 64.0, 0.0],
        &[-5.0 / 24.0, 5.0 / 24.0, 2.0 / 3.0, -2.0 / 3.0],
    ],
    b: &[7.0 / 90.0, 7.0 / 90.0, 16.0 / 45.0, 16.0 / 45.0, 2.0 / 15.0],
    batches: &[2, 1],
    coupled: false,
    defect_order: 5.0,
    // Gauss points of order 8 on [0, 1]: 1/2 ± sqrt(525 ± 70 sqrt(30))/70, the inner two first.
    samples: &[
        (0.330_009_478_207_571_87, 0.326_072_577_431_273_07),
        (0.669_990_521_792_428_1, 0.326_072_577_431_273_07),
        (0.069_431_844_202_973_71, 0.173_927_422_568_726_93),
        (0.930_568_155_797_026_3, 0.173_927_422_568_726_93),
    ],
    first_samples: 2,
    differences: OnceLock::new(),
    at_points: OnceLock::new(),
    at_samples: OnceLock::new(),
};

/// Five-stage Lobatto IIIA, order 8: collocation by polynomials of degree 5 at the Lobatto points 0, 1, 1/2 ∓ √21/14
/// and 1/2. E. Hairer and G. Wanner, "Solving Ordinary Differential Equations II", Springer 1996, section IV.5. The
/// stages stand in a form that treats both ends alike, with `v_r = c_r`: of Lobatto's coefficients `a_rj` those of
/// `c_r (y_1 - y_0 - h Σ_j b_j K_j) = 0` are taken off, `x_rj = a_rj - c_r b_j`.
pub(crate) static ORDER_8: Tableau = Tableau {
    order: 8,
    c: &[0.0, 1.0, 0.5 - LOBATTO_OFFSET, 0.5 + LOBATTO_OFFSET, 0.5],
    v: &[0.0, 1.0, 0.5 - LOBATTO_OFFSET, 0.5 + LOBATTO_OFFSET, 0.5],
    x: &[
        &[],
        &[0.0],
        &[
            0.059_094_773_953_856_33,
            -0.012_333_797_474_715_1,
            0.072_739_296_745_330_79,
            -0.036_369_648_372_665_4,
            -0.083_130_624_851_806_6,
        ],
        &[
            0.012_333_797_474_715_1,
            -0.059_094_773_953_856_33,
            0.036_369_648_372_665_4,
            -0.072_739_296_745_330_79,
            0.083_130_624_851_806_6,
        ],
        &[1.0 / 64.0, -1.0 / 64.0, 0.167_073_072_211_931_67, -0.167_073_072_211_931_67, 0.0],
    ],
    b: &[0.05, 0.05, 49.0 / 180.0, 49.0 / 180.0, 16.0 / 45.0],
    batches: &[COUPLED],
    coupled: true,
    defect_order: 7.0,
    // Gauss points of order 12 on [0, 1]: zeros of the Legendre polynomial of degree 6.
    samples: &[
        (0.033_765_242_898_423_99, 0.085_662_246_189_585_17),
        (0.169_395_306_766_867_74, 0.180_380_786_524_069_3),
        (0.380_690_406_958_401_55, 0.233_956_967_286_345_52),
        (0.619_309_593_041_598_5, 0.233_956_967_286_345_52),
        (0.830_604_693_233_132_3, 0.180_380_786_524_069_3),
        (0.966_234_757_101_576, 0.085_662_246_189_585_17),
    ],
    first_samples: 6,
    differences: OnceLock::new(),
    at_points: OnceLock::new(),
    at_samples: OnceLock::new(),
};

/// Collocation at three Gauss points, order 6, by polynomials of degree 3 between the nodes: R. D. Russell and L. F.
/// Shampine, Numer. Math. 19 (1972) 1-28; superconvergence at the nodes: C. de Boor and B. Swartz, SIAM J. Numer. Anal.
/// 10 (1973) 582-606. The form is that of [`ORDER_8`]; slopes at the nodes have no weight.
pub(crate) static GAUSS_6: Tableau = Tableau {
    order: 6,
    c: &[0.0, 1.0, 0.5 - GAUSS_OFFSET, 0.5 + GAUSS_OFFSET, 0.5],
    v: &[0.0, 1.0, 0.5 - GAUSS_OFFSET, 0.5 + GAUSS_OFFSET, 0.5],
    x: &[
        &[],
        &[0.0],
        &[0.0, 0.0, 0.107_582_870_727_983_81, -0.021_516_574_145_596_76, -0.086_066_296_582_387_04],
        &[0.0, 0.0, 0.021_516_574_145_596_76, -0.107_582_870_727_983_81, 0.086_066_296_582_387_04],
        &[0.0, 0.0, 0.161_374_306_091_975_7, -0.161_374_306_091_975_7, 0.0],
    ],
    b: &[0.0, 0.0, 5.0 / 18.0, 5.0 / 18.0, 4.0 / 9.0],
    batches: &[COUPLED],
    coupled: true,
    defect_order: 6.0,
    samples: ORDER_8.samples,
    first_samples: 6,
    differences: OnceLock::new(),
    at_points: OnceLock::new(),
    at_samples: OnceLock::new(),
};

/// Where a state u has another, v, for derivative, with slopes K, order 6 takes
///
/// ```text
/// u_1 - u_0 = h (v_0 + v_1)/2 + h² Σ_r b_r (1/2 - c_r) K_r
/// ```
///
/// and adds this times `12 (u_1 - u_0) - 6 h (v_0 + v_1) + h² (K_1 - K_0)` to u at 3/4, and takes it off at 1/4, which
/// makes quintics of the cubics there in what is odd about the middle.
pub(crate) const ODD: f64 = 9.0 / 2048.0;

/// `√21/14`: how far the inner Lobatto points are from the middle.
pub(crate) const LOBATTO_OFFSET: f64 = 0.327_326_835_353_988_57;

/// `√15/10`: how far the outer two of three Gauss points are from the middle.
pub(crate) const GAUSS_OFFSET: f64 = 0.387_298_334_620_741_7;

/// Offset from the middle of the two points whose slopes turn the cubic of order 4 into a quartic: `√3/6`,
/// where the derivative of the quartic's extra term `σ²(1-σ)²` is largest. There it is `±1/(3√3)`.
pub(crate) const QUARTIC_OFFSET: f64 = 0.288_675_134_594_812_9;
/// `1/(3√3)`.
pub(crate) const QUARTIC_SLOPE: f64 = 0.192_450_089_729_875_25;

#[cfg(test)]
mod tests {
    use super::*;

    /// Stage `r` and the quadrature integrate polynomials exactly as far as the order conditions say.
    #[test]
    fn tableaux_meet_their_quadrature_and_stage_conditions() {
        for tableau in [&ORDER_4, &ORDER_6, &ORDER_8, &GAUSS_6] {
            for power in 0..tableau.order as i32 {
                let sum: f64 = tableau.b.iter().zip(tableau.c).map(|(b, c)| b * c.powi(power)).sum();
                assert!((sum - 1.0 / f64::from(power + 1)).abs() < 1e-15, "order {} power {power}", tableau.order);
            }
            assert!(!tableau.coupled || tableau.stages() == COUPLED + 2);
            assert_eq!(tableau.batches.iter().sum::<usize>() + 2, tableau.stages());
            for r in 0..tableau.stages() {
                // y = s^q is reproduced for q <= 3 (MIRK stage conditions), by collocation of degree 5 for q <= 5.
                for q in 1..=if tableau.order == 8 { 5_i32 } else { 3 } {
                    let slopes: f64 =
                        tableau.x[r].iter().zip(tableau.c).map(|(x, c)| x * f64::from(q) * c.powi(q - 1)).sum();
                    let value = tableau.v[r] + slopes;
                    assert!((value - tableau.c[r].powi(q)).abs() < 1e-15, "stage {r} power {q}");
                }
            }
            let weights: f64 = tableau.samples.iter().map(|&(_, weight)| weight).sum();
            assert!((weights - 1.0).abs() < 1e-15);
        }
    }

    /// With `u' = v`, `K = v'`: u is exact up to degree 6 at the right node, and at 3/4 what is odd about the middle up
    /// to degree 5.
    #[test]
    fn states_with_a_derivative_among_the_states_are_integrated_twice() {
        let tableau = &ORDER_6;
        for q in 1..=6_i32 {
            let curvatures = tableau.c.iter().enumerate().map(|(stage, c)| {
                let curvature = if q > 1 { f64::from(q * (q - 1)) * c.powi(q - 2) } else { 0.0 };
                tableau.twice_integrated(stage) * curvature
            });
            let ends = if q == 1 { 1.0 } else { 0.5 * f64::from(q) };
            assert!((ends + curvatures.sum::<f64>() - 1.0).abs() < 1e-14, "power {q}");
        }
        for q in [1_i32, 3, 5] {
            // u = t^q, t = s - 1/2.
            let (u, v) = (0.5_f64.powi(q), f64::from(q) * 0.5_f64.powi(q - 1));
            let k = if q > 1 { f64::from(q * (q - 1)) * 0.5_f64.powi(q - 2) } else { 0.0 };
            let cubic = (2.0 * tableau.v[3] - 1.0) * u + (tableau.x[3][0] + tableau.x[3][1]) * v;
            let odd = tableau.odd_part(3).unwrap() * (24.0 * u - 12.0 * v + 2.0 * k);
            assert!((cubic + odd - 0.25_f64.powi(q)).abs() < 1e-15, "power {q}");
        }
    }
}
