//! What the outputs of a solution are worth: the error that its defects leave in each.

use solver::{Guess, Linearisation, Options, solve_observed};

use super::budget::Budget;
use super::failure::Failure;
use super::inputs::inputs;
use super::options::SolveOptions;
use super::power::PowerFlow;
use super::solved::Solved;
use crate::model::Output;

/// Solutions to a tighter tolerance that are tried until the outputs hold.
const ROUNDS: usize = 3;
/// Share of the tolerance that a finer solution aims at, and the least factor on its defects' tolerance.
const AIM: f64 = 0.3;
const LEAST_FACTOR: f64 = 1e-3;
/// Tolerance of defects that is never gone below: rounding is near.
const LEAST: f64 = 1e-10;
/// Outputs that are held to the tolerance, relative to their values.
const HELD: [Output; 7] = [
    Output::EfficiencyOverall,
    Output::EfficiencySpeed,
    Output::EfficiencyTorque,
    Output::PrimaryAxialForce,
    Output::SecondaryAxialForce,
    Output::PrimaryTorque,
    Output::SecondaryTorque,
];

/// Estimated errors of outputs; nothing where the equations are singular.
pub type OutputErrors = Option<Vec<(Output, f64)>>;

/// Estimated error of every output, SI, in order: found less true, to first order. The defects and boundary residuals
/// of the solution are carried through the linearised equations to its ends, integrals and constants, and from there by
/// the outputs' gradients; that costs one factorisation and one linear solve for all outputs. What is left out by that,
/// of the square of the solution's estimated error, is added.
///
/// # Errors
/// [`Failure::Sensitivities`] if the equations are singular at the solution, as at a limit; [`Failure::Internal`].
pub fn output_errors(solved: &Solved) -> Result<Vec<(Output, f64)>, Failure> {
    let (_, gradients) = solved.belt.output_gradients(&solved.solution)?;
    let linearisation = Linearisation::new(&solved.belt, &solved.solution).map_err(Failure::Sensitivities)?;
    let error = linearisation.error().map_err(Failure::Sensitivities)?.inputs();
    let (ends, integrals) = inputs(&solved.solution);
    let values: Vec<f64> =
        ends.into_iter().chain(integrals).chain(solved.solution.constants().iter().copied()).collect();
    // What the linearised equations leave out is of the square of the error.
    let square = solved.solution.error_estimate().powi(2);
    let along = |gradient: &[f64]| {
        let first: f64 = gradient.iter().zip(&error).map(|(partial, error)| partial * error).sum();
        let terms: f64 = gradient.iter().zip(&values).map(|(partial, value)| (partial * value).abs()).sum();
        first + (square * terms).copysign(first)
    };
    Ok(gradients.iter().map(|(output, gradient)| (output, along(gradient))).collect())
}

/// The solution, on finer meshes if need be, with the estimated errors of its outputs: efficiencies, axial forces and
/// torques hold to the tolerance, relative to their values, or as well as rounding and the work limit permit.
///
/// # Errors
/// [`Failure::Internal`]. At a solution where the equations are singular there are no errors to tell.
pub fn refined(mut solved: Solved, options: &SolveOptions) -> Result<(Solved, OutputErrors), Failure> {
    let mut errors = match output_errors(&solved) {
        Ok(errors) => errors,
        Err(Failure::Sensitivities(_)) => return Ok((solved, None)),
        Err(failure) => return Err(failure),
    };
    let mut budget = Budget::new(options.work_limit);
    let mut tolerance = options.tolerance;
    for _ in 0..ROUNDS {
        let excess = excess(&solved, &errors)? / options.tolerance;
        if excess.is_nan() || excess <= 1.0 || tolerance <= LEAST {
            break;
        }
        tolerance = (tolerance * (AIM / excess).max(LEAST_FACTOR)).max(LEAST);
        let finer = Options { tolerance, ..options.solver() };
        let guess = Guess::from(&solved.solution);
        // What cannot be refined stays as it is, with the error that it has.
        let unknowns = solved.solution.unknowns().to_vec();
        let Ok(solution) = solve_observed(&solved.belt, &guess, &unknowns, &finer, &mut budget) else { break };
        tracing::info!("outputs were off by {excess:.1} tolerances: refined to defects of {tolerance:.1e}");
        solved.stats += *solution.stats();
        solved.solution = solution;
        errors = match output_errors(&solved) {
            Ok(errors) => errors,
            Err(Failure::Sensitivities(_)) => return Ok((solved, None)),
            Err(failure) => return Err(failure),
        };
    }
    Ok((solved, Some(errors)))
}

/// The largest error of the outputs that are held to the tolerance, relative to their values. Efficiencies are ratios
/// of torques that may be zero.
fn excess(solved: &Solved, errors: &[(Output, f64)]) -> Result<f64, Failure> {
    let values = solved.belt.output_values(&solved.solution)?;
    let flow = PowerFlow::of(values.get(Output::EnergyPowerIn)?, values.get(Output::EnergyPowerOut)?);
    let mut worst = 0.0_f64;
    for (output, error) in errors.iter().filter(|(output, _)| HELD.contains(output)) {
        let is_force = matches!(output, Output::PrimaryAxialForce | Output::SecondaryAxialForce);
        if is_force || flow.is_through() {
            worst = worst.max((error / values.get(*output)?).abs());
        }
    }
    Ok(worst)
}
