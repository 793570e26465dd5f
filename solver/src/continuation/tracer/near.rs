//! Points known of a branch, from which others are predicted.

use crate::continuation::arclength::Reference;
use crate::guess::{Guess, RegionGuess};

/// Where a point is predicted from.
#[derive(Clone, Copy)]
pub(super) struct Near<'r> {
    pub point: &'r Reference,
    /// Its distance.
    pub at: f64,
    /// How fast it moves along its direction as the distance grows.
    pub speed: f64,
}

impl Near<'_> {
    /// The point at a place between two, by the cubic that has their values and directions; none if their meshes are
    /// not the same.
    pub(super) fn between(&self, other: &Near<'_>, at: f64) -> Option<Guess> {
        let length = other.at - self.at;
        let sigma = (at - self.at) / length;
        let (tau, square) = (1.0 - sigma, sigma * sigma);
        let [rise, leaving, arriving] = [
            square * (3.0 - 2.0 * sigma),
            sigma * tau * tau * length * self.speed,
            -square * tau * length * other.speed,
        ];
        let cubic =
            |((a, from), (b, to)): ((&f64, &f64), (&f64, &f64))| a + rise * (b - a) + leaving * from + arriving * to;
        let [one, two] = [self.point, other.point];
        let mut regions = Vec::new();
        for (index, (a, b)) in one.solution.regions().iter().zip(two.solution.regions()).enumerate() {
            if a.mesh() != b.mesh() {
                return None;
            }
            let mut region = RegionGuess::from(a);
            let rates = one.direction.states[index].iter().zip(&two.direction.states[index]).enumerate();
            for (values, (i, (from, to))) in region.states.iter_mut().zip(rates) {
                *values = values.iter().zip(from).zip(b.state(i).iter().zip(to)).map(cubic).collect();
            }
            regions.push(region);
        }
        let [a, b] = [one, two].map(|point| point.solution.constants().iter().zip(&point.direction.constants));
        Some(Guess { regions, constants: a.zip(b).map(cubic).collect() })
    }
}
