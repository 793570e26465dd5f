//! Derivatives of the outputs with respect to what is given, from the factorisation at the solution.

use std::collections::BTreeMap;

use solver::Condensation;

use crate::case::{Resolved, constant_label, output_label};
use crate::drive::{Failure, SolveOptions, Solved};
use crate::losses::{LossOutput, LossValues, NoDerivatives, NoLosses, gradients};
use crate::model::Constant;

/// d(output)/d(what is given), SI over SI: output by its key with dots, then the case file's key.
pub type Sensitivities = BTreeMap<String, BTreeMap<String, f64>>;

/// Differentiates every output that is a smooth function of the solution's ends, integrals and constants: one
/// elimination for all given constants and prescribed outputs. Extremes along a contact or a span are left out.
///
/// # Errors
/// [`Failure::Sensitivities`] if the equations are singular at the solution, as at a limit; [`Failure::Internal`].
pub fn sensitivities(solved: &Solved) -> Result<Sensitivities, Failure> {
    let (_, gradients) = solved.belt.output_gradients(&solved.solution)?;
    let condensation = Condensation::new(&solved.belt, &solved.solution).map_err(Failure::Sensitivities)?;
    let given: Vec<(&[f64], String)> =
        given(solved).into_iter().filter_map(|(constant, name)| Some((condensation.rates(constant)?, name))).collect();
    let rows = gradients.iter().map(|(output, gradient)| {
        // An output depends on few of its inputs.
        let partials: Vec<(usize, f64)> =
            gradient.iter().copied().enumerate().filter(|(_, partial)| *partial != 0.0).collect();
        let derivative = |rates: &[f64]| partials.iter().map(|&(input, partial)| partial * rates[input]).sum();
        (output.name().to_owned(), given.iter().map(|(rates, name)| (name.clone(), derivative(rates))).collect())
    });
    Ok(rows.collect())
}

/// Adds the derivatives of the losses besides friction, and gives those by the temperature at which loss tangents are
/// taken; nothing where there are no losses to tell.
///
/// # Errors
/// [`Failure::Sensitivities`].
pub fn add_losses(
    to: &mut Sensitivities,
    case: &Resolved,
    options: &SolveOptions,
    temperature: f64,
    solved: &Solved,
) -> Result<Option<LossValues<f64>>, Failure> {
    let gradients = match gradients(case, solved, temperature, options.tolerance) {
        Ok(gradients) => gradients,
        Err(NoDerivatives::Internal(error) | NoDerivatives::Losses(NoLosses::Internal(error))) => {
            return Err(error.into());
        }
        Err(NoDerivatives::Losses(NoLosses::String | NoLosses::Endless { .. })) => return Ok(None),
        Err(NoDerivatives::Solve(error)) => return Err(Failure::Sensitivities(error)),
    };
    let given = given(solved);
    for output in LossOutput::ALL {
        let gradient = &gradients.by_constant[output];
        let value = |at: usize| gradient.get(at).copied().unwrap_or(f64::NAN);
        let by_constants = given.iter().map(|(at, name)| (name.clone(), value(*at)));
        let by_losses = gradients.by_given.iter().map(|(key, values)| (key.path().to_owned(), values[output]));
        to.insert(output.name().to_owned(), by_constants.chain(by_losses).collect());
    }
    Ok(Some(gradients.by_temperature))
}

/// Places of what is given among the problem's constants, with their names.
fn given(solved: &Solved) -> Vec<(usize, String)> {
    let unknowns = solved.question.unknowns();
    let constants = Constant::ALL.into_iter().filter(|constant| !unknowns.contains(constant));
    let targets = solved.belt.prescribed().enumerate();
    let constants = constants.map(|constant| (constant.index(), constant_label(constant).to_owned()));
    let targets = targets.map(|(at, output)| (Constant::ALL.len() + at, output_label(output).to_owned()));
    constants.chain(targets).collect()
}
