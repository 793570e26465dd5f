//! Derivatives of the outputs with respect to what is given, from the factorisation at the solution.

use std::collections::BTreeMap;

use solver::{Condensation, SolveError};

use crate::case::Resolved;
use crate::drive::{Constant, Failure, Known, Output, SolveOptions, Solved, inputs};
use crate::losses::{NoDerivatives, gradients};

/// d(output)/d(what is given), SI over SI: output by its key with dots, then the case file's key.
pub type Sensitivities = BTreeMap<String, BTreeMap<String, f64>>;

/// Differentiates every output that is a smooth function of the solution's ends, integrals and constants: one elimination
/// for all given constants and prescribed outputs. Extremes along a contact or a span are left out.
///
/// # Errors
/// What the solver says if the equations are singular at the solution, as at a limit.
pub fn sensitivities(solved: &Solved) -> Result<Sensitivities, SolveError> {
    let (ends, integrals) = inputs(&solved.solution);
    let (_, gradients) = solved.belt.output_gradients(&ends, &integrals, solved.solution.constants());
    let condensation = Condensation::new(&solved.belt, &solved.solution)?;
    let given: Vec<(&[f64], String)> =
        given(solved).into_iter().filter_map(|(constant, name)| Some((condensation.rates(constant)?, name))).collect();
    let rows = Output::all().zip(&gradients).map(|(output, gradient)| {
        // An output depends on few of its inputs.
        let partials: Vec<(usize, f64)> =
            gradient.iter().copied().enumerate().filter(|(_, partial)| *partial != 0.0).collect();
        let derivative = |rates: &[f64]| partials.iter().map(|&(input, partial)| partial * rates[input]).sum();
        (output.path(), given.iter().map(|(rates, name)| (name.clone(), derivative(rates))).collect())
    });
    Ok(rows.collect())
}

/// Adds the derivatives of the losses besides friction; nothing where there are none to tell.
///
/// # Errors
/// [`Failure::Sensitivities`].
pub fn add_losses(
    to: &mut Sensitivities,
    case: &Resolved,
    options: &SolveOptions,
    temperature: f64,
    solved: &Solved,
) -> Result<(), Failure> {
    let gradients = match gradients(case, solved, temperature, options.tolerance) {
        Ok(gradients) => gradients,
        Err(NoDerivatives::Losses(_)) => return Ok(()),
        Err(NoDerivatives::Solve(error)) => return Err(Failure::Sensitivities(error)),
    };
    let given = given(solved);
    for (name, gradient) in gradients.by_constant {
        let value = |at: usize| gradient.get(at).copied().unwrap_or(f64::NAN);
        to.insert(name.to_owned(), given.iter().map(|(at, name)| (name.clone(), value(*at))).collect());
    }
    Ok(())
}

/// Places of what is given among the problem's constants, with their names.
fn given(solved: &Solved) -> Vec<(usize, String)> {
    let unknowns = solved.question.unknowns();
    let constants = Constant::ALL.into_iter().filter(|constant| !unknowns.contains(constant));
    let targets = solved.belt.prescribed().iter().enumerate();
    let constants = constants.map(|constant| (constant.index(), constant.label()));
    let targets = targets.map(|(at, output)| (Constant::ALL.len() + at, Known::Output(*output).name()));
    constants.chain(targets).collect()
}
