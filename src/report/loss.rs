//! Where friction takes the power: by pulley, by zone of the contact, by direction of sliding.

use crate::drive::RegionId;
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
pub fn losses(outcome: &Outcome) -> LossSplit {
    let result = &outcome.result;
    LossSplit {
        primary: contact(outcome, RegionId::Primary, result.primary.friction_loss),
        secondary: contact(outcome, RegionId::Secondary, result.secondary.friction_loss),
    }
}

/// The shares of what the samples show, of the `total` that the integral gives.
fn contact(outcome: &Outcome, region: RegionId, total: f64) -> Mechanisms {
    let belt = &outcome.solved.belt;
    let kernel = belt.kernel(region);
    let sampled = Sampled::new(belt, &outcome.solved.solution, region, INNER);
    let field = |name: &str| {
        let at = kernel.fields.iter().position(|symbol| symbol.name == name);
        at.and_then(|at| sampled.fields.get(at)).map_or(&[][..], Vec::as_slice)
    };
    let at = kernel.states.iter().position(|symbol| symbol.name == "x");
    let x = at.and_then(|at| sampled.states.get(at)).map_or(&[][..], Vec::as_slice);
    let peaks: Vec<usize> = (1..x.len().saturating_sub(1)).filter(|i| x[*i] > x[i - 1] && x[*i] >= x[i + 1]).collect();
    let (first, last) = (peaks.first().copied().unwrap_or(0), peaks.last().copied().unwrap_or(x.len()));
    let s = &sampled.s;
    // The shares are of samples' trapezoids; lengths are as good as even in s.
    let over = |values: &[f64], from: usize, to: usize| -> f64 {
        let pairs = values.windows(2).zip(s.windows(2)).enumerate().filter(|(i, _)| (from..to).contains(i));
        pairs.map(|(_, (v, s))| 0.5 * (v[0] + v[1]) * (s[1] - s[0])).sum()
    };
    let (loss, radial) = (field("loss"), field("loss_radial"));
    let whole = over(loss, 0, usize::MAX);
    let share = |part: f64| if whole > 0.0 { total * part / whole } else { 0.0 };
    let radial = share(over(radial, 0, usize::MAX));
    Mechanisms {
        entry: share(over(loss, 0, first)),
        seated: share(over(loss, first, last)),
        exit: share(over(loss, last, usize::MAX)),
        radial,
        tangential: total - radial,
    }
}
