//! The share of the friction at hand that each pulley uses, signed.

use super::compute::{INNER, Sampled};
use crate::drive::{RegionId, Solved};
use crate::model::{Constant, Constants, InternalError};

/// Both contacts, each with the sign of the friction along its rim where the primary drives.
const CONTACTS: [(RegionId, f64); 2] = [(RegionId::Primary, -1.0), (RegionId::Secondary, 1.0)];

/// As [`Pulley::friction_utilization`](super::Pulley::friction_utilization) of the primary and of the secondary, but
/// positive where the primary drives and negative where the secondary does: smooth where the torque changes its sign.
///
/// # Errors
/// None, unless this program is broken.
pub fn utilizations(solved: &Solved) -> Result<[f64; 2], InternalError> {
    let coefficient = Constants::try_from(solved.solution.constants())?[Constant::FrictionCoefficient];
    let mut used = [0.0; 2];
    for (used, (region, sign)) in used.iter_mut().zip(CONTACTS) {
        let sampled = Sampled::new(&solved.belt, &solved.solution, region, INNER);
        *used = sign * sampled.rim_friction()? / coefficient;
    }
    Ok(used)
}

/// Share of the friction at hand that is left over on the pulley that has less.
///
/// # Errors
/// None, unless this program is broken.
pub fn slip_reserve(solved: &Solved) -> Result<f64, InternalError> {
    utilizations(solved).map(|[primary, secondary]| 1.0 - primary.abs().max(secondary.abs()))
}
