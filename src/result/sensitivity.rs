//! Derivatives of the outputs with respect to the given constants, from the factorisation at the solution.

use std::collections::BTreeMap;

use generated::OUTPUTS;
use solver::{Linearisation, SolveError};

use super::compute::{SEPARATOR, inputs};
use crate::case::Key;
use crate::drive::{Constant, Solved};

/// d(output)/d(given constant), SI over SI: output by its key with dots, then the case file's key.
pub type Sensitivities = BTreeMap<String, BTreeMap<&'static str, f64>>;

/// The key of the case file that gives a constant; `None` for those that are solved for.
fn key(constant: Constant) -> Option<Key> {
    match constant {
        Constant::LongitudinalStiffness => Some(Key::LongitudinalStiffness),
        Constant::BendingStiffness => Some(Key::BendingStiffness),
        Constant::RadialStiffness => Some(Key::RadialStiffness),
        Constant::MassPerLength => Some(Key::MassPerLength),
        Constant::PrimaryRadius => Some(Key::PrimaryRadius),
        Constant::SecondaryRadius => Some(Key::SecondaryRadius),
        Constant::CenterDistance => Some(Key::CenterDistance),
        Constant::HalfAngle => Some(Key::HalfAngle),
        Constant::FrictionCoefficient => Some(Key::FrictionCoefficient),
        Constant::SlipThreshold => Some(Key::SlipThreshold),
        Constant::PrimarySpeed => Some(Key::PrimarySpeed),
        Constant::PrimaryTorque => Some(Key::PrimaryTorque),
        Constant::SlackTension => Some(Key::SlackTension),
        Constant::SpeedRatio
        | Constant::Flow
        | Constant::PrimaryWrap
        | Constant::SecondaryWrap
        | Constant::PrimaryOrientation
        | Constant::SecondaryOrientation
        | Constant::TightLength
        | Constant::SlackLength => None,
    }
}

/// Differentiates every output that is a smooth function of the solution's ends, integrals and constants: one
/// factorisation, and one linear solve for each given constant. Extremes along a contact or a span are left out.
///
/// # Errors
/// What the solver says if the equations are singular at the solution, as at a limit.
pub fn sensitivities(solved: &Solved) -> Result<Sensitivities, SolveError> {
    let (ends, integrals) = inputs(&solved.solution);
    let mut values = vec![0.0; OUTPUTS.equations.len()];
    let mut partials = vec![0.0; OUTPUTS.pattern.len()];
    (OUTPUTS.jacobian)(&ends, &integrals, solved.solution.constants(), &mut values, &mut partials);
    let linearisation = Linearisation::new(&solved.belt, &solved.solution)?;
    let mut all = Sensitivities::new();
    for (constant, key) in Constant::ALL.into_iter().filter_map(|constant| Some((constant, key(constant)?))) {
        let rates = linearisation.sensitivity(constant.index()).inputs();
        let mut derivatives = vec![0.0; OUTPUTS.equations.len()];
        for (&(output, input), partial) in OUTPUTS.pattern.iter().zip(&partials) {
            derivatives[output] += partial * rates.get(input).copied().unwrap_or(f64::NAN);
        }
        for (output, derivative) in OUTPUTS.equations.iter().zip(derivatives) {
            all.entry(output.name.replace(SEPARATOR, ".")).or_default().insert(key.path(), derivative);
        }
    }
    Ok(all)
}
