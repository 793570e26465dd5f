//! Derivatives of the outputs with respect to what is given, from the factorisation at the solution.

use std::collections::BTreeMap;

use solver::Condensation;

use crate::case::{Resolved, constant_label, output_label};
use crate::drive::{Failure, OutputValues, PowerFlow, SolveOptions, Solved, is_efficiency};
use crate::losses::{LossOutput, LossValues, NoDerivatives, NoLosses, gradients};
use crate::model::{Constant, InternalError, Output};

/// d(output)/d(what is given), SI over SI: output by its key with dots, then the case file's key.
pub type Sensitivities = BTreeMap<String, BTreeMap<String, f64>>;

/// Differentiates every output that is a smooth function of the solution's ends, integrals and constants: one
/// elimination for all given constants and prescribed outputs. Extremes along a contact or a span are left out.
///
/// # Errors
/// [`Failure::Sensitivities`] if the equations are singular at the solution, as at a limit; [`Failure::Internal`].
pub fn sensitivities(solved: &Solved) -> Result<Sensitivities, Failure> {
    let (values, gradients) = solved.belt.output_gradients(&solved.solution)?;
    let condensation = Condensation::new(&solved.belt, &solved.solution).map_err(Failure::Sensitivities)?;
    let told = Told::of(&values)?;
    let given: Vec<(&[f64], Given)> =
        given(solved, &told)?.into_iter().filter_map(|given| Some((condensation.rates(given.at)?, given))).collect();
    let rows = gradients.iter().map(|(output, gradient)| {
        // An output depends on few of its inputs.
        let partials: Vec<(usize, f64)> =
            gradient.iter().copied().enumerate().filter(|(_, partial)| *partial != 0.0).collect();
        let of = told.rate(output)?;
        let derivative = |rates: &[f64]| partials.iter().map(|&(input, partial)| partial * rates[input]).sum::<f64>();
        let row = given.iter().map(|(rates, given)| (given.name.clone(), of * given.rate * derivative(rates)));
        Ok((output.name().to_owned(), row.collect()))
    });
    rows.collect()
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
    let values = solved.belt.output_values(&solved.solution)?;
    let given = given(solved, &Told::of(&values)?)?;
    for output in LossOutput::ALL {
        let gradient = &gradients.by_constant[output];
        let value = |given: &Given| given.rate * gradient.get(given.at).copied().unwrap_or(f64::NAN);
        let by_constants = given.iter().map(|given| (given.name.clone(), value(given)));
        let by_losses = gradients.by_given.iter().map(|(key, values)| (key.path().to_owned(), values[output]));
        to.insert(output.name().to_owned(), by_constants.chain(by_losses).collect());
    }
    Ok(Some(gradients.by_temperature))
}

/// What is given: its place among the problem's constants, its name, and the derivative of that constant by it.
struct Given {
    at: usize,
    name: String,
    rate: f64,
}

fn given(solved: &Solved, told: &Told<'_>) -> Result<Vec<Given>, InternalError> {
    let unknowns = solved.question.unknowns();
    let constants = Constant::ALL.into_iter().filter(|constant| !unknowns.contains(constant));
    let targets = solved.belt.prescribed().enumerate();
    let constants = constants
        .map(|constant| Ok(Given { at: constant.index(), name: constant_label(constant).to_owned(), rate: 1.0 }));
    let targets = targets.map(|(at, output)| {
        let (at, name) = (Constant::ALL.len() + at, output_label(output).to_owned());
        Ok(Given { at, name, rate: 1.0 / told.rate(output)? })
    });
    constants.chain(targets).collect()
}

/// What outputs are told as: where the secondary drives, efficiencies as their reciprocals.
struct Told<'a> {
    values: &'a OutputValues,
    braking: bool,
}

impl<'a> Told<'a> {
    fn of(values: &'a OutputValues) -> Result<Self, InternalError> {
        let flow = PowerFlow::of(values.get(Output::EnergyPowerIn)?, values.get(Output::EnergyPowerOut)?);
        Ok(Self { values, braking: flow == PowerFlow::FromSecondary })
    }

    /// Derivative of what is told by the output.
    fn rate(&self, output: Output) -> Result<f64, InternalError> {
        if !(self.braking && is_efficiency(output)) {
            return Ok(1.0);
        }
        let value = self.values.get(output)?;
        Ok(-1.0 / (value * value))
    }
}
