//! The cold start: a belt of constant tension on two tangent lines, from nothing but the case.

use std::f64::consts::{FRAC_PI_2, PI};

use super::constants::{Constant, Constants};
use super::region::RegionId;

/// Torque, N·m, at which the straight belt is a good enough guess for Newton's method.
pub(super) const START_TORQUE: f64 = 0.5;
/// Slip threshold, m/s, at which friction is still linear almost everywhere.
pub(super) const START_SLIP_THRESHOLD: f64 = 1.0;
/// Mesh intervals of each region at the start.
pub(super) const START_INTERVALS: usize = 40;

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

/// The start's states in a region at `s` in `[0, 1]`, in the order of the kernel's list.
pub(super) fn states(region: RegionId, s: f64, constants: &Constants) -> Vec<f64> {
    let tension = constants[Constant::SlackTension];
    let slope = constants[Constant::PrimaryOrientation] - FRAC_PI_2;
    let contact = |radius: f64| {
        let penetration = PENETRATION_SHARE * tension
            / (constants[Constant::RadialStiffness] * radius * constants[Constant::HalfAngle].tan());
        vec![tension, 0.0, 0.0, 0.0, penetration * (s.min(1.0 - s) / RISE).min(1.0)]
    };
    match region {
        RegionId::Primary => contact(constants[Constant::PrimaryRadius]),
        RegionId::Secondary => contact(constants[Constant::SecondaryRadius]),
        RegionId::SlackSpan => vec![tension, -slope, 0.0, 0.0],
        RegionId::TightSpan => vec![tension, PI + slope, 0.0, 0.0],
    }
}
