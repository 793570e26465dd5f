//! The share of the friction at hand that each pulley uses, signed, with its derivatives.

use super::compute::{INNER, Sampled};
use crate::drive::{RegionId, Solved};
use crate::model::{Constant, Constants, InternalError};
use solver::Tangent;

/// Both contacts, each with the sign of the friction along its rim where the primary drives.
const CONTACTS: [(RegionId, f64); 2] = [(RegionId::Primary, 1.0), (RegionId::Secondary, -1.0)];

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

/// Rates of [`utilizations`] along a tangent of the solution: differences over steps of length `h` both ways along the
/// exact tangent, in what the mesh's nodes say.
///
/// # Errors
/// None, unless this program is broken.
pub fn utilization_rates(solved: &Solved, tangent: &Tangent, h: f64) -> Result<[f64; 2], InternalError> {
    let coefficient = Constant::FrictionCoefficient.index();
    let constants = Constants::try_from(solved.solution.constants())?;
    let rate = tangent.constants.get(coefficient).copied().unwrap_or(0.0);
    let mut rates = [0.0; 2];
    for (rates, (region, sign)) in rates.iter_mut().zip(CONTACTS) {
        let at = |h: f64| -> Result<f64, InternalError> {
            let sampled = Sampled::moved(&solved.belt, &solved.solution, region, tangent, h);
            Ok(sign * sampled.rim_friction()? / (constants[Constant::FrictionCoefficient] + h * rate))
        };
        *rates = (at(h)? - at(-h)?) / (2.0 * h);
    }
    Ok(rates)
}
