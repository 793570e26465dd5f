//! The cold start: a belt of constant tension on two tangent lines, from nothing but the case.

use std::f64::consts::{FRAC_PI_2, PI};

use solver::{Guess, Problem};

use super::belt::Belt;
use super::region::RegionId;
use crate::model::{Constant, Constants, State};

/// Torque, N·m, at which the straight belt is a good enough guess for Newton's method.
const START_TORQUE: f64 = 0.5;
/// Slip threshold, m/s, at which friction is still linear almost everywhere.
const START_SLIP_THRESHOLD: f64 = 1.0;
/// Mesh intervals of each region at the start.
const START_INTERVALS: usize = 40;

/// Slack tension of the start, N, if the case's is higher: a tighter belt sinks too deep for the straight guess.
const HIGHEST_TENSION: f64 = 150.0;
/// Slack tension of the start over EI/R² of the smaller pulley, if the case's is lower: a looser belt does not wrap.
const LOWEST_TENSION: f64 = 1.7;
/// Factors on the start's tension, tried in turn.
const ATTEMPTS: [f64; 4] = [1.0, 2.0, 0.5, 4.0];

/// Share of the tension that the groove's elasticity carries, against friction, in the start's penetration.
const PENETRATION_SHARE: f64 = 0.8;
/// Share of the wrap over which the start's penetration rises from zero.
const RISE: f64 = 0.1;

/// Fills the unknown constants of the drive with those of a tight, inextensible belt on tangent lines.
pub(super) fn constants(given: &Constants) -> Constants {
    let mut start = given.clone();
    let (primary, secondary, center) =
        (given[Constant::PrimaryRadius], given[Constant::SecondaryRadius], given[Constant::CenterDistance]);
    let slope = ((secondary - primary) / center).clamp(-1.0, 1.0).asin();
    start[Constant::SpeedRatio] = primary / secondary;
    start[Constant::Flow] = 1.0;
    start[Constant::PrimaryWrap] = PI - 2.0 * slope;
    start[Constant::SecondaryWrap] = PI + 2.0 * slope;
    start[Constant::PrimaryOrientation] = FRAC_PI_2 + slope;
    start[Constant::SecondaryOrientation] = FRAC_PI_2 - slope;
    start[Constant::TightLength] = center * slope.cos();
    start[Constant::SlackLength] = center * slope.cos();
    start
}

/// Slack tensions to start from, the most promising first.
pub(super) fn tensions(target: &Constants) -> impl Iterator<Item = f64> {
    let radius = target[Constant::PrimaryRadius].min(target[Constant::SecondaryRadius]);
    let lowest = LOWEST_TENSION * target[Constant::BendingStiffness] / radius.powi(2);
    let first = target[Constant::SlackTension].clamp(lowest.min(HIGHEST_TENSION), HIGHEST_TENSION).max(lowest);
    ATTEMPTS.into_iter().map(move |factor| first * factor)
}

/// The case's drive at a small torque and that slack tension, with friction that is linear in the sliding speed.
pub(super) fn easy(target: &Constants, tension: f64) -> Constants {
    let mut easy = target.clone();
    easy[Constant::PrimaryTorque] = target[Constant::PrimaryTorque].min(START_TORQUE);
    easy[Constant::SlipThreshold] = target[Constant::SlipThreshold].max(START_SLIP_THRESHOLD);
    easy[Constant::SlackTension] = tension;
    easy
}

/// The straight belt as a guess.
pub(super) fn guess(belt: &Belt, constants: &Constants) -> Guess {
    Guess::uniform(belt.layout(), START_INTERVALS, &constants.0, |region, s, y| {
        if let Some(region) = RegionId::ALL.get(region) {
            let kernel = belt.kernel(*region);
            for (value, of) in y.iter_mut().zip(kernel.states) {
                *value = state(*region, *of, s, constants);
            }
        }
    })
}

/// The start's value of a state in a region at `s` in `[0, 1]`; derivatives of angles vanish.
fn state(region: RegionId, state: State, s: f64, constants: &Constants) -> f64 {
    let tension = constants[Constant::SlackTension];
    let slope = constants[Constant::PrimaryOrientation] - FRAC_PI_2;
    let penetration = |radius: Constant| {
        let depth = PENETRATION_SHARE * tension
            / (constants[Constant::RadialStiffness] * constants[radius] * constants[Constant::HalfAngle].tan());
        depth * (s.min(1.0 - s) / RISE).min(1.0)
    };
    match (state, region) {
        (State::Tension | State::SpanTension, _) => tension,
        (State::Penetration, RegionId::Primary) => penetration(Constant::PrimaryRadius),
        (State::Penetration, _) => penetration(Constant::SecondaryRadius),
        (State::Direction, RegionId::SlackSpan) => -slope,
        (State::Direction, _) => PI + slope,
        (
            State::Inclination
            | State::InclinationDerivative
            | State::InclinationSecondDerivative
            | State::DirectionDerivative
            | State::DirectionSecondDerivative,
            _,
        ) => 0.0,
    }
}
