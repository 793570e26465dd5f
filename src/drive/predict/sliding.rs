//! Where the belt adheres, its sliding speed is the tiny difference of two large ones, and friction hangs on it: so the
//! tangential sliding speed is what is predicted, and the penetration is what gives that.

use solver::Guess;

use crate::drive::belt::BeltProblem;
use crate::drive::region::RegionId;
use crate::model::{Field, State};

/// Difference quotients in x, m.
const DEPTH: f64 = 1e-6;

/// Tangential sliding speeds at the nodes of a contact, m/s; nothing for a kernel that has none.
pub(super) fn speeds(belt: &BeltProblem, region: RegionId, constants: &[f64], states: &[Vec<f64>]) -> Option<Vec<f64>> {
    belt.field(region, Field::TangentialSlidingSpeed, &states.concat(), constants)
}

/// Moves the belt into or out of a groove until it slides as `wanted` says. A kernel without sliding speed has nothing
/// to lose: its guess stays as it is.
pub(super) fn slide(belt: &BeltProblem, region: RegionId, guess: &mut Guess, wanted: &[f64]) -> Option<()> {
    let x = belt.kernel(region).state(State::Penetration)?;
    let Guess { regions, constants } = guess;
    let states = &mut regions.get_mut(region.index())?.states;
    let found = speeds(belt, region, constants, states)?;
    states.get_mut(x)?.iter_mut().for_each(|x| *x += DEPTH);
    let deeper = speeds(belt, region, constants, states)?;
    for (((x, wanted), found), deeper) in states.get_mut(x)?.iter_mut().zip(wanted).zip(&found).zip(&deeper) {
        *x += DEPTH * ((wanted - found) / (deeper - found) - 1.0);
    }
    Some(())
}
