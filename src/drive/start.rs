//! The start: a belt of constant tension on two tangent lines, from nothing but the drive's constants.

use std::f64::consts::{FRAC_PI_2, PI};

use solver::{Guess, Problem};

use super::belt::BeltProblem;
use super::region::RegionId;
use super::tuning::{DEEPEST_GUESS, INTERVALS, PENETRATION_SHARE, RISE};
use crate::model::{Constant, Constants, State};

/// Fills the unknown constants of the drive with those of a tight, inextensible belt on tangent lines.
pub(super) fn constants(given: &Constants) -> Constants {
    let mut start = given.clone();
    let (primary, secondary, center) =
        (given[Constant::PrimaryRadius], given[Constant::SecondaryRadius], given[Constant::CenterDistance]);
    let slope = libm::asin(((secondary - primary) / center).clamp(-1.0, 1.0));
    start[Constant::SpeedRatio] = primary / secondary;
    start[Constant::Flow] = 1.0;
    start[Constant::PrimaryWrap] = PI - 2.0 * slope;
    start[Constant::SecondaryWrap] = PI + 2.0 * slope;
    start[Constant::PrimaryOrientation] = FRAC_PI_2 + slope;
    start[Constant::SecondaryOrientation] = FRAC_PI_2 - slope;
    start[Constant::TightLength] = center * libm::cos(slope);
    start[Constant::SlackLength] = center * libm::cos(slope);
    start
}

/// As [`constants`], for a belt that is stretched by its tension and by its own inertia, and sinks into its grooves: it
/// runs with the rims where it has sunk to.
///
/// A belt of speed V and tractive tension T carries the force T + m_o V² that stretches it; from (3.11) its mass flow
/// is g = v (1 − ε_c)/(1 + T/EA) with v = V/(R_P ω_P) and ε_c the share of EA that inertia takes, to first order.
pub(super) fn stretched(given: &Constants) -> Constants {
    let mut start = constants(given);
    let [primary, secondary] = [Constant::PrimaryRadius, Constant::SecondaryRadius].map(|radius| {
        let sunk = depth(given, radius) / given[radius];
        1.0 - sunk
    });
    start[Constant::SpeedRatio] *= primary / secondary;
    start[Constant::Flow] = flow(given, primary);
    start
}

/// Mass flow g of a belt whose speed is `v` R_P ω_P, at the slack tension: the root of V = G (T + EA)/(EA m_o − G²) for
/// which the belt runs forward under tension.
fn flow(given: &Constants, v: f64) -> f64 {
    // With G = m_o U g: v = g (1 + T/EA)/(1 − c g²), c = m_o U²/EA.
    flow_at(v, inertia(given), 1.0 + given[Constant::SlackTension] / given[Constant::LongitudinalStiffness])
}

/// Inertia of a belt that runs with the primary's pitch line over its stiffness, c = m_o (R_P ω_P)²/EA.
pub(super) fn inertia(given: &Constants) -> f64 {
    let rim = given[Constant::PrimaryRadius] * given[Constant::PrimarySpeed];
    given[Constant::MassPerLength] * rim * rim / given[Constant::LongitudinalStiffness]
}

/// The positive root g of c v g² + (1 + T/EA) g − v = 0, with `inertia` c = m_o (R_P ω_P)²/EA and `stretch` 1 + T/EA.
pub(super) fn flow_at(v: f64, inertia: f64, stretch: f64) -> f64 {
    // In the form that does not cancel.
    2.0 * v / (stretch + (stretch * stretch + 4.0 * inertia * v * v).sqrt())
}

/// How far the start's belt sinks into a groove, m.
fn depth(given: &Constants, radius: Constant) -> f64 {
    let depth = PENETRATION_SHARE * given[Constant::SlackTension]
        / (given[Constant::RadialStiffness] * given[radius] * libm::tan(given[Constant::HalfAngle]));
    depth.min(DEEPEST_GUESS * given[radius])
}

/// The straight belt as a guess.
pub(super) fn guess(belt: &BeltProblem, constants: &Constants) -> Guess {
    Guess::uniform(belt.layout(), INTERVALS, &constants.0, |region, s, y| {
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
    let penetration = |radius: Constant| depth(constants, radius) * (s.min(1.0 - s) / RISE).min(1.0);
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
