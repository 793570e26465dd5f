//! Whether what is prescribed depends at all on what is made unknown for it.
//!
//! A belt's weight changes its speed and its tensions, and neither its path nor what sheaves take of it: inertia adds
//! the same to the tension everywhere. So no weight leads to a wrap angle that is asked for. [`Question::check`] does
//! not see that, for which the differential equations have to be known; a solution nearby tells it.

use solver::{Condensation, Problem};

use super::failure::Failure;
use super::question::{Known, Question};
use super::solved::Solved;
use crate::case::constant_label;
use crate::model::{Constant, IllPosed};

/// Relative change of an output over that of a constant, below which the output does not depend on it. Rounding leaves
/// 3e-11 at most of what it should; the weakest influence found is 2e-9, of the centre distance on the speed ratio.
const NO_INFLUENCE: f64 = 1e-10;

/// Refuses a question that prescribes an output which depends on none of the constants that are to be found, as a
/// solution tells whose given constants are those of the question.
///
/// # Errors
/// [`IllPosed::NoInfluence`]; [`Failure::Internal`].
pub(super) fn check_influence(near: &Solved, question: &Question) -> Result<(), Failure> {
    let (values, gradients) = near.belt.output_gradients(&near.solution)?;
    // Where the equations are singular, nothing is known of it.
    let Ok(condensation) = Condensation::new(&near.belt, &near.solution) else { return Ok(()) };
    let swapped = question.swaps.iter().map(|swap| swap.free);
    let free: Vec<Constant> = swapped.chain(question.closings.iter().map(|closing| closing.free)).collect();
    let Some(rates) = free.iter().map(|free| condensation.rates(free.index())).collect::<Option<Vec<_>>>() else {
        return Ok(());
    };
    let inputs = near.belt.layout().inputs();
    let first_constant = inputs - near.belt.layout().constants.len();
    for swap in &question.swaps {
        let (value, gradient) = match swap.known {
            Known::Output(output) => (values.get(output)?, gradients.get(output)?.to_vec()),
            Known::Constant(constant) => {
                let unit = |input: usize| f64::from(u8::from(input == first_constant + constant.index()));
                (near.constant(constant), (0..inputs).map(unit).collect())
            }
        };
        let has_influence = |(free, rates): (&Constant, &&[f64])| {
            let rate: f64 = gradient.iter().zip(*rates).map(|(partial, rate)| partial * rate).sum();
            let constant = near.constant(*free);
            // Of a constant that is zero, or an output, a relative change says nothing.
            let relative = rate.abs() * constant.abs() / value.abs();
            constant == 0.0 || !relative.is_finite() || relative > NO_INFLUENCE
        };
        if !free.iter().zip(&rates).any(has_influence) {
            let free = free.iter().map(|free| constant_label(*free).to_owned()).collect();
            return Err(IllPosed::NoInfluence { name: swap.known.name(), free }.into());
        }
    }
    Ok(())
}
