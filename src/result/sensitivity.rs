//! Derivatives of the outputs with respect to what is given, from the factorisation at the solution.

use std::collections::BTreeMap;

use solver::{Linearisation, SolveError};

use crate::drive::{Constant, Known, Output, Solved, inputs};

/// d(output)/d(what is given), SI over SI: output by its key with dots, then the case file's key.
pub type Sensitivities = BTreeMap<String, BTreeMap<String, f64>>;

/// Differentiates every output that is a smooth function of the solution's ends, integrals and constants: one
/// factorisation, and one linear solve for each given constant and each prescribed output. Extremes along a contact or a
/// span are left out.
///
/// # Errors
/// What the solver says if the equations are singular at the solution, as at a limit.
pub fn sensitivities(solved: &Solved) -> Result<Sensitivities, SolveError> {
    let (ends, integrals) = inputs(&solved.solution);
    let (_, gradients) = solved.belt.output_gradients(&ends, &integrals, solved.solution.constants());
    let linearisation = Linearisation::new(&solved.belt, &solved.solution)?;
    let mut all = Sensitivities::new();
    for (constant, name) in given(solved) {
        let rates = linearisation.sensitivity(constant).inputs();
        for (output, gradient) in Output::all().zip(&gradients) {
            let derivative = gradient.iter().zip(&rates).map(|(partial, rate)| partial * rate).sum();
            all.entry(output.path()).or_default().insert(name.clone(), derivative);
        }
    }
    Ok(all)
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
