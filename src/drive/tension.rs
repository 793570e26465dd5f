//! Where along a belt it is pulled least.

use solver::Solution;

use super::belt::BeltProblem;
use super::region::RegionId;
use crate::model::State;

/// Compression over the largest tension beyond which it is more than the solution's tolerance.
pub(crate) const COMPRESSION: f64 = 1e-6;

/// A belt that is pushed somewhere, but for what its own inertia adds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Compressed {
    /// Where its tractive tension is least.
    pub region: RegionId,
    /// That tension, N: a negative one.
    pub tension: f64,
}

impl Compressed {
    /// Of a solution, by the tractive tensions at the nodes of all regions; nothing if the belt is pulled everywhere.
    pub fn of(belt: &BeltProblem, solution: &Solution) -> Option<Self> {
        let tensions = RegionId::ALL.into_iter().filter_map(|region| {
            let state = if region.is_contact() { State::Tension } else { State::SpanTension };
            let values = solution.regions().get(region.index())?.state(belt.kernel(region).state(state)?);
            let extremes = [f64::min, f64::max].map(|extreme| values.iter().copied().reduce(extreme));
            Some((region, extremes[0]?, extremes[1]?))
        });
        let least_and_largest = |(one, largest): (Self, f64), (other, most): (Self, f64)| {
            (if other.tension < one.tension { other } else { one }, largest.max(most))
        };
        let (least, largest) =
            tensions.map(|(region, tension, most)| (Self { region, tension }, most)).reduce(least_and_largest)?;
        (least.tension < -COMPRESSION * largest.max(0.0)).then_some(least)
    }
}
