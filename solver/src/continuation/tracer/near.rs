//! Points known of a branch, from which others are predicted.

use super::Advanced;
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

/// A step, and what is known of its ends.
#[derive(Clone, Copy)]
pub(super) struct Span<'r> {
    /// Where it begins: the point that distances are taken from.
    pub here: &'r Reference,
    /// The same point, perhaps on another mesh.
    pub first: Near<'r>,
    pub step: f64,
    /// Where it ends, perhaps on another mesh than that on which it was found.
    pub next: &'r Advanced,
}

impl<'r> Span<'r> {
    pub(super) fn new(here: &'r Reference, step: f64, next: &'r Advanced) -> Self {
        Self { here, first: Near { point: here, at: 0.0, speed: 1.0 }, step, next }
    }

    /// The same with what its first point is on another mesh.
    pub(super) fn from(self, first: &'r Advanced) -> Self {
        Self { first: first.near(0.0), ..self }
    }

    /// The same with what its last point is on another mesh.
    pub(super) fn to(self, next: &'r Advanced) -> Self {
        Self { next, ..self }
    }

    /// Whether both its ends are on the same mesh, and what is found between is, too.
    pub(super) fn has_one_mesh(&self) -> bool {
        are_alike(self.first.point, &self.next.point)
    }

    /// Of the ends of a step and what has been seen between: that nearest to a place, and the nearest on its other
    /// side.
    pub(super) fn around(&self, seen: &'r [(f64, Advanced)], place: f64) -> (Near<'r>, Option<Near<'r>>) {
        let (first, last) = (self.first, self.next.near(self.step));
        let all = || [first, last].into_iter().chain(seen.iter().map(|(at, found)| found.near(*at)));
        let nearer = |best: Near<'r>, other: Near<'r>| {
            if (other.at - place).abs() < (best.at - place).abs() { other } else { best }
        };
        let below = all().filter(|near| near.at <= place).reduce(nearer);
        let above = all().filter(|near| near.at > place).reduce(nearer);
        match (below, above) {
            (Some(below), Some(above)) if (above.at - place) < (place - below.at) => (above, Some(below)),
            (Some(near), other) | (other, Some(near)) => (near, other),
            (None, None) => (first, None),
        }
    }
}

/// Whether two points are on the same mesh. What the determinant is there can be compared only if they are, where the
/// mesh does not resolve what bifurcates.
pub(super) fn are_alike(a: &Reference, b: &Reference) -> bool {
    let [a, b] = [a, b].map(|point| point.solution.regions());
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.mesh() == b.mesh())
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
