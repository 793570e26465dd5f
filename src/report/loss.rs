//! Where friction takes the power: by pulley, by zone of the contact, by direction of sliding.

use crate::drive::RegionId;
use crate::model::{Field, InternalError, State};
use crate::result::{Outcome, Sampled};

/// Points inside each mesh interval, besides its nodes.
const INNER: usize = 3;

/// Power lost in one contact, W.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Mechanisms {
    /// From the belt's entry to the first maximum of its penetration.
    pub entry: f64,
    /// Between the first and the last maximum.
    pub seated: f64,
    /// From the last maximum of its penetration to the belt's exit.
    pub exit: f64,
    /// To sliding up and down the sheaves.
    pub radial: f64,
    /// To sliding around the pulley.
    pub tangential: f64,
}

/// Power lost in both contacts.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LossSplit {
    /// The primary's.
    pub primary: Mechanisms,
    /// The secondary's.
    pub secondary: Mechanisms,
}

/// Splits the friction loss of a solution; each pulley's parts add up to its loss in the result.
///
/// # Errors
/// None, unless this program is broken.
pub fn losses(outcome: &Outcome) -> Result<LossSplit, InternalError> {
    let result = &outcome.result;
    Ok(LossSplit {
        primary: contact(outcome, RegionId::Primary, result.primary.friction_loss)?,
        secondary: contact(outcome, RegionId::Secondary, result.secondary.friction_loss)?,
    })
}

/// The shares of what the samples show, of the `total` that the integral gives.
fn contact(outcome: &Outcome, region: RegionId, total: f64) -> Result<Mechanisms, InternalError> {
    let belt = &outcome.solved.belt;
    let sampled = Sampled::new(belt, &outcome.solved.solution, region, INNER);
    let x = sampled.state(State::Penetration)?;
    let peaks: Vec<usize> = (1..x.len().saturating_sub(1)).filter(|i| x[*i] > x[i - 1] && x[*i] >= x[i + 1]).collect();
    let (first, last) = (peaks.first().copied().unwrap_or(0), peaks.last().copied().unwrap_or(x.len()));
    let s = &sampled.s;
    // The shares are of samples' trapezoids; lengths are as good as even in s.
    let over = |values: &[f64], from: usize, to: usize| -> f64 {
        let pairs = values.windows(2).zip(s.windows(2)).enumerate().filter(|(i, _)| (from..to).contains(i));
        pairs.map(|(_, (v, s))| 0.5 * (v[0] + v[1]) * (s[1] - s[0])).sum()
    };
    let (loss, radial) = (sampled.field(Field::LossPerLength)?, sampled.field(Field::RadialLossPerLength)?);
    let whole = over(loss, 0, usize::MAX);
    let share = |part: f64| if whole > 0.0 { total * part / whole } else { 0.0 };
    let radial = share(over(radial, 0, usize::MAX));
    Ok(Mechanisms {
        entry: share(over(loss, 0, first)),
        seated: share(over(loss, first, last)),
        exit: share(over(loss, last, usize::MAX)),
        radial,
        tangential: total - radial,
    })
}
